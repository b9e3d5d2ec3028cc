"""Compare the paths of the tools' tips with all edges, for each kind of operation and each station.

Each tip path must lie on an edge of a line type that the operation makes, between the points at
which the tip may start and must stop.  Each edge must be cut, creased or grooved between these
points.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.model.dieline import LineType
from knifetip.model.job_options import CutDepth
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.common.followed_edges import edge_stations
from knifetip.verification.checks.crease.check import CreaseCheck
from knifetip.verification.checks.groove.check import GrooveCheck
from knifetip.verification.checks.knife.check import KnifeCheck
from knifetip.verification.checks.milling.check import check_milling
from knifetip.verification.checks.milling.work import MilledCuts, MilledPaths
from knifetip.verification.columns import I64, Bool
from knifetip.verification.expectation.edges import Edges, without_duplicates
from knifetip.verification.expectation.expected_work import WORKED_TYPES
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind, expected_tool


def check_edges(context: CheckContext, work: TipPaths) -> None:
    """Compare the tip paths ``work`` with all edges of the dieline.

    Findings, and the measured figures of each edge, are added to ``context``.
    """
    cutting_kinds = {
        expected_tool(station.tool).through_kind for station in context.machine.stations
    }
    knives, cutters = OperationKind.CUT in cutting_kinds, OperationKind.MILL in cutting_kinds
    for operation, kinds in WORKED_TYPES.items():
        edges = context.edges.with_types(*kinds)
        if operation == OperationKind.CUT and cutters and not knives:
            edges = context.edges.with_types(*(kind for kind in kinds if kind != LineType.CUT))
        elif operation == OperationKind.MILL and (knives or not cutters):
            # A machine with a knife cuts with the knife, so its cutter has no edges.
            edges = context.edges.with_types()
        edges, twin, first = without_duplicates(edges)
        rows = np.flatnonzero(work.operation == operation)
        owner = edge_stations(context, work, rows, edges)
        for station in np.unique(work.station[rows]) if len(rows) else (-1,):
            station_rows = rows[work.station[rows] == station]
            if operation == OperationKind.MILL:
                # The disc of one cutter must not enter the contours of the others.
                milling = _MillingStationCheck(context, work, station_rows, operation, edges)
                milling.owned = owner == station
                milling.run()
                continue
            station_edges = edges.select(np.flatnonzero(owner == station))
            for part in _split_by_depth(context, work, station_rows, operation, station_edges):
                _CHECKS[operation](context, work, part[0], operation, part[1]).run()
        # An edge that is drawn twice is cut or creased once; both rows get its figures.
        context.figures.copy_rows(first, twin)


def _split_by_depth(
    context: CheckContext, work: TipPaths, rows: I64, operation: OperationKind, edges: Edges
) -> list[tuple[I64, Edges]]:
    """Return the tip paths and edges of one station in groups of equal chosen passes and depth.

    A group is checked by itself, since ends and overruns depend on the depth.  A track belongs to
    the group whose edges it follows for the greatest length.

    ``work``, ``rows``: tip paths of the program, and the indices of those of the station.
    """
    is_knife = operation in (OperationKind.CUT, OperationKind.HALF_CUT)
    if CutDepth not in context.chosen or not is_knife or len(edges) == 0:
        return [(rows, edges)]
    numbers, group = np.unique(context.chosen[CutDepth].index[edges.row], return_inverse=True)
    if len(numbers) == 1:
        return [(rows, edges)]
    near = edges.find_overlaps(work.curve[rows], context.tolerance)
    tracks, track = np.unique(work.track[rows], return_inverse=True)
    total = np.zeros((len(tracks), len(numbers)))
    size = np.where(near.best, np.diff(near.along)[:, 0], 0.0)
    np.add.at(total, (track[near.curve], group[near.edge]), size)
    owner = total.argmax(axis=1)[track] if len(rows) else np.zeros(0, np.int64)
    return [
        (rows[owner == number], edges.select(np.flatnonzero(group == number)))
        for number in range(len(numbers))
    ]


class _MillingStationCheck(StationCheck):
    """Check that compares the edges with the cuts of a router bit or a laser.

    Unlike a knife, a router bit or laser removes board, in a strip as wide as the bit or the beam.
    """

    owned: Bool  #: (n,) mask of the edges that the station must make

    def check(self) -> None:
        station = self.context.machine.stations[int(self.station[0])] if len(self.station) else None
        if station is None or expected_tool(station.tool).disc is None:
            self.check_uncut(self.match_edges(), np.flatnonzero(self.owned))
            return
        centres = MilledPaths(self.curve, self.z, self.track, self.line, self.blend)
        cuts = MilledCuts(self.edges, self.owned)
        check_milling(self.context, cuts, centres, station, self.slack)


_CHECKS: Final[dict[OperationKind, type[StationCheck]]] = {
    OperationKind.CUT: KnifeCheck,
    OperationKind.HALF_CUT: KnifeCheck,
    OperationKind.CREASE: CreaseCheck,
    OperationKind.GROOVE: GrooveCheck,
}
