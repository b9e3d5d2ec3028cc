"""Compare the paths of the tools' tips with all edges, for each kind of operation and each station.

Each tip path must lie on an edge of a line type that the operation makes, between the points at
which the tip may start and must stop.  Each edge must be cut, creased or grooved between these
points.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.model.dieline import LineType
from knifetip.verification.checks.check_base import StationCheck
from knifetip.verification.checks.check_context import CheckContext
from knifetip.verification.checks.crease_check import CreaseCheck
from knifetip.verification.checks.groove_check import GrooveCheck
from knifetip.verification.checks.knife_check import KnifeCheck
from knifetip.verification.checks.milling_check import check_milling
from knifetip.verification.checks.milling_work import MilledPaths
from knifetip.verification.columns import I64
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
        owner = _edge_stations(work, rows, edges, context.tolerance)
        for station in np.unique(work.station[rows]) if len(rows) else (-1,):
            station_rows = rows[work.station[rows] == station]
            _CHECKS[operation](
                context,
                work,
                station_rows,
                operation,
                edges.select(np.flatnonzero(owner == station)),
            ).run()
        # An edge that is drawn twice is cut or creased once; both rows get its figures.
        context.figures.copy_rows(first, twin)


def _edge_stations(work: TipPaths, rows: I64, edges: Edges, tolerance: float) -> I64:
    """Return the index of the station that covers the greatest length of each of n edges, (n,).

    A station covers the part of an edge that tip paths of its tool follow.  An edge without tip
    paths gets the first of the stations that have tip paths, or -1 if there are none.

    Parameters
    ----------
    work, rows
        Tip paths of the program, and the indices of the tip paths that are considered.
    edges
        The n edges.
    tolerance : mm
        Greatest distance at which a tip path covers an edge.
    """
    stations = np.unique(work.station[rows])
    if len(stations) < 2:
        return np.full(len(edges), stations[0] if len(stations) else -1, np.int64)
    near = edges.find_overlaps(work.curve[rows], tolerance)
    # A wheel that presses one point covers no length; count it with a small one.
    size = np.abs(near.place[:, 1] - near.place[:, 0]) + 1e-6
    column = np.searchsorted(stations, work.station[rows][near.curve])
    total = np.zeros((len(edges), len(stations)))
    np.add.at(total, (near.edge, column), size)
    result: I64 = stations[total.argmax(axis=1)].astype(np.int64)
    return result


class _MillingStationCheck(StationCheck):
    """Check that compares the edges with the cuts of a router bit or a laser.

    Unlike a knife, a router bit or laser removes board, in a strip as wide as the bit or the beam.
    """

    def check(self) -> None:
        station = self.context.machine.stations[int(self.station[0])] if len(self.station) else None
        if station is None or expected_tool(station.tool).disc is None:
            self.check_uncut(self.match_edges(), np.arange(len(self.edges)))
            return
        centres = MilledPaths(self.curve, self.z, self.track, self.line, self.blend)
        check_milling(self.context, self.edges, centres, station, self.slack)


_CHECKS: Final[dict[OperationKind, type[StationCheck]]] = {
    OperationKind.CUT: KnifeCheck,
    OperationKind.HALF_CUT: KnifeCheck,
    OperationKind.CREASE: CreaseCheck,
    OperationKind.GROOVE: GrooveCheck,
    OperationKind.MILL: _MillingStationCheck,
}
