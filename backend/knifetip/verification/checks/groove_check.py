"""Grooving: V-grooves against the board's depth, their flanks, passes and run-outs.

StationCheck of a V-cutter -> deviation, overcut, uncut, width, web and flank of every groove
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import VCutter
from knifetip.verification.checks.check_base import StationCheck
from knifetip.verification.checks.check_context import DEPTH_TOLERANCE
from knifetip.verification.checks.groove_flanks import damaged_cuts
from knifetip.verification.checks.pass_depth import too_deep_spans
from knifetip.verification.checks.stray_work import check_stray_work
from knifetip.verification.columns import F64, Bool
from knifetip.verification.curves.curve import left_distance
from knifetip.verification.curves.intervals import SHORT, Overlaps, within_limits
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.expectation.expected_work import groove_continues
from knifetip.verification.expectation.run_outs import run_outs
from knifetip.verification.findings import MAX_FINDINGS


class GrooveCheck(StationCheck):
    """The work of a V-cutter, in one pass or more each way."""

    def judge(self) -> None:
        self.depth[:] = self.bench.board.groove_depth
        blade = self.tool(VCutter)
        leaves = self.bench.board.groove_curve
        curved = self.edges.curve[:, 0] != 0.0
        for edge in np.flatnonzero(curved)[:MAX_FINDINGS] if leaves <= 0.0 else ():
            self.finding("deviation", edge, Message("verify.groove-arc"), 0.0)
        drawn = self.edges
        boundary = self._run_out(blade) if blade else np.zeros((len(self.edges), 2), np.bool_)
        rows = self.matched()
        wide = np.full(len(self.edges), self.tolerance)
        if leaves > 0.0 and curved.any():
            # A groove of chords leaves its arc by as much as the board allows.
            wide[curved] = leaves + self.tolerance
            wider = find_overlaps(self.curve, self.edges.curve, self.low, self.high, leaves)
            rows = within_limits(wider, wide, self.curve)
        final = self._passes(rows)
        self._stepped()
        self.placed(rows, final, wide)
        off_board = 0.0
        if blade and curved.any():
            # Chords leave the board in their own direction.
            off_board = 2.0 * (blade.half_width + self.bench.board.groove_depth * blade.slope)
        check_stray_work(self, rows, self.curve[:, 5], off_board)
        # What it may run out further is not asked for.
        self.low, self.high = self.low + self.spare[:, 0], self.high - self.spare[:, 1]
        for forward in (True, False):
            way = rows.place[:, 1] > rows.place[:, 0]
            self.uncut(rows, np.arange(len(self.edges)), (way == forward) & final, forward)
        if blade is None:
            return
        self.headed(rows, np.full(len(self.z), 2.0 * blade.half_width), 360.0, curved)
        self._flanks(rows, final, blade, wide)
        self._beside_cuts(drawn, blade)
        worked = np.zeros(len(self.edges), np.bool_)
        worked[rows.edge[rows.best]] = True
        inside = ~(boundary | groove_continues(self.edges).reshape(-1, 2)).all(axis=1)
        past: F64 = np.where(worked & inside, 2.0 * blade.half_width, 0.0)
        self.overcut(np.arange(len(self.edges)), past)
        limit = self.bench.board.groove_overcut
        for edge in np.flatnonzero(past > limit + self.tolerance)[:MAX_FINDINGS]:
            self.finding(
                "overcut",
                edge,
                Message("verify.groove-past-ends", length=past[edge], most=limit),
                past[edge],
            )

    def _run_out(self, blade: VCutter) -> Bool:
        """Lengthen grooves that leave the board; return which ends do, (n, 2).

        The tip goes no farther than it must: there is no board, but who knows what is.
        """
        half = self.bench.board.groove_depth * blade.slope
        asked = run_outs(self.edges, self.bench.edges.of(LineType.CUT), half)
        boundary = asked.boundary.reshape(-1, 2)
        least = asked.least.reshape(-1, 2)
        # Chords leave the board in their own direction, and their last one says how far.
        straight_on = self.edges.curve[:, 0] == 0.0
        boundary &= straight_on[:, None]
        self.spare = np.where(boundary, self.tolerance, 0.0)
        more = least + self.spare
        curve = self.edges.curve.copy()
        # Of a straight edge the row is its start, its direction and its length.
        straight = curve[:, 0] == 0.0
        curve[straight, 1:3] -= more[straight, :1] * curve[straight, 3:5]
        curve[straight, 5] += more[straight].sum(axis=1)
        self.edges = replace(self.edges, curve=curve)
        self.size = curve[:, 5]
        self.high = self.size.copy()
        self.before = more[:, 0]
        return boundary

    def _passes(self, rows: Overlaps) -> Bool:
        """Return which stretches are of the deepest pass over their edge in their direction.

        Those before it may be shallower, each no deeper than the next.
        """
        deep = (self.bench.board.caliper - self.z)[rows.curve]
        way = 2 * rows.edge.astype(np.int64) + (rows.place[:, 1] > rows.place[:, 0])
        deepest = np.zeros(2 * len(self.edges))
        np.maximum.at(deepest, way[rows.best], deep[rows.best])
        final: Bool = deep >= deepest[way] - DEPTH_TOLERANCE
        order = np.flatnonzero(rows.best & (np.abs(np.diff(rows.place)[:, 0]) > SHORT))
        order = order[np.lexsort((rows.curve[order], way[order]))]
        same = way[order[1:]] == way[order[:-1]]
        back = same & (deep[order[1:]] < deep[order[:-1]] - DEPTH_TOLERANCE)
        for k in np.flatnonzero(back)[:MAX_FINDINGS]:
            row = order[k + 1]
            self.finding(
                "depth",
                int(rows.edge[row]),
                Message("verify.groove-shallower", depth=deep[row], before=deep[order[k]]),
                float(deep[order[k]] - deep[row]),
                int(rows.curve[row]),
            )
        return final

    def _stepped(self) -> None:
        """Judge whether no pass goes deeper at once than the board allows."""
        step = self.bench.board.groove_pass
        if step <= 0.0:
            return
        deep = self.bench.board.caliper - self.z
        which, spans = too_deep_spans(self.curve, deep, step, self.tolerance, one_way=True)
        size = np.diff(spans)[:, 0]
        for k in np.flatnonzero(size > self.slack)[:MAX_FINDINGS]:
            row = int(which[k])
            self.finding(
                "depth",
                -1,
                Message(
                    "verify.pass-too-deep",
                    tool=self.trade.tool,
                    depth=deep[row],
                    length=size[k],
                    step=step,
                ),
                float(deep[row] - step),
                row,
            )

    def _flanks(self, rows: Overlaps, final: Bool, blade: VCutter, limit: F64) -> None:
        """Judge where the flanks come out at the top face, h tan θ beside the line.

        On each pass the blade leans to the right of travel, and cuts the flank on that side.
        """
        size = np.abs(np.diff(rows.place)[:, 0])
        which = np.flatnonzero(rows.best & final & (size > SHORT))
        work, edge = rows.curve[which], rows.edge[which]
        forward = rows.place[which, 1] > rows.place[which, 0]
        deep = self.bench.board.caliper - self.z[work]
        lean = (deep - self.depth[edge]) * blade.slope
        error = np.zeros(len(which))
        for side in range(2):
            left = left_distance(self.curve[work], rows.along[which, side], self.edges.curve[edge])
            right = np.where(forward, -left, left) + lean
            error = np.where(np.abs(right) > np.abs(error), right, error)
        row = self.edges.row[edge]
        np.maximum.at(self.figures.flank, row, np.abs(error))
        wide = np.zeros((len(self.figures.width), 2))
        np.maximum.at(wide, (row, forward.astype(np.int64)), self.depth[edge] * blade.slope + error)
        np.maximum(self.figures.width, wide.sum(axis=1), out=self.figures.width)
        web = np.full(len(self.figures.web), np.inf)
        np.minimum.at(web, row, self.bench.board.caliper - deep)
        self.figures.web[np.isfinite(web)] = web[np.isfinite(web)]
        for k in np.flatnonzero(np.abs(error) > limit[edge] + 1e-9)[:MAX_FINDINGS]:
            self.finding(
                "deviation",
                int(edge[k]),
                Message(
                    "verify.flank-outside" if error[k] > 0.0 else "verify.flank-inside",
                    distance=abs(error[k]),
                    tolerance=limit[edge[k]],
                ),
                float(abs(error[k])),
                int(work[k]),
            )

    def _beside_cuts(self, drawn: Edges, blade: VCutter) -> None:
        """Judge whether a flank goes through the edge of a cut beside the groove."""
        cuts = self.bench.edges.of(LineType.CUT)
        reach = self.bench.board.groove_depth * blade.slope
        out = self.before[:, None] - self.spare
        out[:, 1] = self.size - drawn.curve[:, 5] - self.before - self.spare[:, 1]
        torn = damaged_cuts(drawn, cuts, reach, out)
        through = reach - torn.nearest
        for k in np.flatnonzero(through > self.tolerance)[:MAX_FINDINGS]:
            self.finding(
                "overcut",
                int(torn.groove[k]),
                Message(
                    "verify.flank-through-cut",
                    depth=through[k],
                    edge=cuts.row[torn.cut[k]],
                    distance=torn.nearest[k],
                    place=torn.place[k],
                ),
                float(through[k]),
            )
