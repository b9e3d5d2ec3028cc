"""Coverage: all work against all edges, trade by trade and station by station.

    CheckContext, TipPaths -> deviation, overcut, uncut and setback of every edge, and the findings

Every stretch of work must lie on an edge of the right line type, between the places where the
tip may begin and stop there; every edge must be worked between those places.
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
from knifetip.verification.checks.milling_check import CentrePaths, check_milling
from knifetip.verification.columns import I64
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import Edges, without_duplicates
from knifetip.verification.expectation.expected_work import WORKED_TYPES
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind, expected_tool


def check_edges(bench: CheckContext, work: TipPaths) -> None:
    """Compare all work with all edges, trade by trade and station by station."""
    held = {expected_tool(station.tool).through for station in bench.machine.stations}
    knives, cutters = OperationKind.CUT in held, OperationKind.MILL in held
    for trade, kinds in WORKED_TYPES.items():
        edges = bench.edges.of(*kinds)
        if trade == OperationKind.CUT and cutters and not knives:
            edges = bench.edges.of(*(kind for kind in kinds if kind != LineType.CUT))
        elif trade == OperationKind.MILL and (knives or not cutters):
            # Where there is a knife, nothing is left for a cutter.
            edges = bench.edges.of()
        edges, twin, first = without_duplicates(edges)
        rows = np.flatnonzero(work.trade == trade)
        owner = _edge_stations(work, rows, edges, bench.tolerance)
        for station in np.unique(work.station[rows]) if len(rows) else (-1,):
            mine = rows[work.station[rows] == station]
            _CHECKS[trade](
                bench, work, mine, trade, edges.taken(np.flatnonzero(owner == station))
            ).run()
        # What is drawn twice is worked once, and the figures are those of both.
        bench.figures.copied(first, twin)


def _edge_stations(work: TipPaths, rows: I64, edges: Edges, tolerance: float) -> I64:
    """Return the station that works most of each edge, (n,): the first where none does."""
    stations = np.unique(work.station[rows])
    if len(stations) < 2:
        return np.full(len(edges), stations[0] if len(stations) else -1, np.int64)
    near = find_overlaps(
        work.curve[rows], edges.curve, np.zeros(len(edges)), edges.curve[:, 5], tolerance
    )
    # A wheel that presses one place goes over no length of it.
    size = np.abs(near.place[:, 1] - near.place[:, 0]) + 1e-6
    column = np.searchsorted(stations, work.station[rows][near.curve])
    total = np.zeros((len(edges), len(stations)))
    np.add.at(total, (near.edge, column), size)
    result: I64 = stations[total.argmax(axis=1)].astype(np.int64)
    return result


class _MillingStationCheck(StationCheck):
    """The work of a cutter that removes a disc."""

    def judge(self) -> None:
        held = self.bench.machine.stations[int(self.station[0])] if len(self.station) else None
        if held is None or expected_tool(held.tool).disc is None:
            self.uncut(self.matched(), np.arange(len(self.edges)))
            return
        ways = CentrePaths(self.curve, self.z, self.track, self.line, self.blend)
        check_milling(self.bench, self.edges, ways, held, self.slack)


_CHECKS: Final[dict[OperationKind, type[StationCheck]]] = {
    OperationKind.CUT: KnifeCheck,
    OperationKind.HALF_CUT: KnifeCheck,
    OperationKind.CREASE: CreaseCheck,
    OperationKind.GROOVE: GrooveCheck,
    OperationKind.MILL: _MillingStationCheck,
}
