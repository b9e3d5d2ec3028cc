"""Coverage: all work against all edges, trade by trade and station by station.

    Bench, Work -> deviation, overcut, uncut and setback of every edge, and the findings

Every stretch of work must lie on an edge of the right line type, between the places where the
tip may begin and stop there; every edge must be worked between those places.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.model.dieline import LineType
from knifetip.verification.bench import Bench
from knifetip.verification.columns import I64
from knifetip.verification.grooving import Grooving
from knifetip.verification.intent import WORKED, Edges, drawn_once
from knifetip.verification.kinematics import Work
from knifetip.verification.knifework import Knifework
from knifetip.verification.overlap import overlaps
from knifetip.verification.removal import Ways, judge_removal
from knifetip.verification.rolling import Rolling
from knifetip.verification.tools import Trade, expected
from knifetip.verification.trial import Trial


def compare(bench: Bench, work: Work) -> None:
    """Compare all work with all edges, trade by trade and station by station."""
    held = {expected(station.tool).through for station in bench.machine.stations}
    knives, cutters = Trade.CUT in held, Trade.MILL in held
    for trade, kinds in WORKED.items():
        edges = bench.edges.of(*kinds)
        if trade == Trade.CUT and cutters and not knives:
            edges = bench.edges.of(*(kind for kind in kinds if kind != LineType.CUT))
        elif trade == Trade.MILL and (knives or not cutters):
            # Where there is a knife, nothing is left for a cutter.
            edges = bench.edges.of()
        edges, twin, first = drawn_once(edges)
        rows = np.flatnonzero(work.trade == trade)
        owner = _owners(work, rows, edges, bench.tolerance)
        for station in np.unique(work.station[rows]) if len(rows) else (-1,):
            mine = rows[work.station[rows] == station]
            _TRIALS[trade](
                bench, work, mine, trade, edges.taken(np.flatnonzero(owner == station))
            ).run()
        # What is drawn twice is worked once, and the figures are those of both.
        bench.figures.copied(first, twin)


def _owners(work: Work, rows: I64, edges: Edges, tolerance: float) -> I64:
    """Return the station that works most of each edge, (n,): the first where none does."""
    stations = np.unique(work.station[rows])
    if len(stations) < 2:
        return np.full(len(edges), stations[0] if len(stations) else -1, np.int64)
    near = overlaps(
        work.curve[rows], edges.curve, np.zeros(len(edges)), edges.curve[:, 5], tolerance
    )
    # A wheel that presses one place goes over no length of it.
    size = np.abs(near.place[:, 1] - near.place[:, 0]) + 1e-6
    column = np.searchsorted(stations, work.station[rows][near.curve])
    total = np.zeros((len(edges), len(stations)))
    np.add.at(total, (near.edge, column), size)
    result: I64 = stations[total.argmax(axis=1)].astype(np.int64)
    return result


class _Milling(Trial):
    """The work of a cutter that removes a disc."""

    def judge(self) -> None:
        held = self.bench.machine.stations[int(self.station[0])] if len(self.station) else None
        if held is None or expected(held.tool).disc is None:
            self.uncut(self.matched(), np.arange(len(self.edges)))
            return
        ways = Ways(self.curve, self.z, self.track, self.line, self.blend)
        judge_removal(self.bench, self.edges, ways, held, self.slack)


_TRIALS: Final[dict[Trade, type[Trial]]] = {
    Trade.CUT: Knifework,
    Trade.HALF_CUT: Knifework,
    Trade.CREASE: Rolling,
    Trade.GROOVE: Grooving,
    Trade.MILL: _Milling,
}
