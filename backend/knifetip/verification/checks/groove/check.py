"""Check V-grooves: position, depth, flanks, passes, and run-outs past the board's edge.

The figures recorded for each groove are deviation, overcut, uncut length, width, web (the thickness
of the board that remains below the groove) and flank error.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import VCutter
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.checks.common.context import DEPTH_TOLERANCE
from knifetip.verification.checks.common.pass_depth import Passes, report_deep_passes
from knifetip.verification.checks.common.stray_work import check_stray_work
from knifetip.verification.checks.groove.flanks import clearing_shifts, damaged_cuts
from knifetip.verification.columns import F64, Bool
from knifetip.verification.curves.curve import left_distance
from knifetip.verification.curves.intervals import SHORT, Overlaps, within_limits
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import LIMIT_SLACK, Edges
from knifetip.verification.expectation.expected_work import groove_continues
from knifetip.verification.expectation.run_outs import run_outs
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.tools import ANGLE_TOLERANCE


class GrooveCheck(StationCheck):
    """Check that compares the V-grooves of a V-cutter with the edges.

    The V-cutter makes a groove in one or more passes in each direction.
    """

    def check(self) -> None:
        self.depth[:] = self.context.board.groove_depth
        blade = self.tool(VCutter)
        leaves = self.context.board.groove_curve
        curved = self.edges.curve[:, 0] != 0.0
        for edge in np.flatnonzero(curved)[:MAX_FINDINGS] if leaves <= 0.0 else ():
            self.add_finding("deviation", edge, Message("verify.groove-arc"), 0.0)
        if blade:
            self._shift_grooves(blade)
        drawn = self.edges
        boundary = self._add_run_outs(blade) if blade else np.zeros((len(self.edges), 2), np.bool_)
        overlaps = self.match_edges()
        wide = np.full(len(self.edges), self.tolerance)
        if leaves > 0.0 and curved.any():
            # An arc is grooved in chords, which deviate from it by up to the board's limit.
            wide[curved] = leaves + self.tolerance
            wider = find_overlaps(self.curve, self.edges.curve, self.low, self.high, leaves)
            overlaps = within_limits(wider, wide, self.curve)
        final = self._deepest_passes(overlaps)
        board = self.context.board
        passes = Passes(self.curve, board.caliper - self.z, self.line)
        report_deep_passes(
            self.context, self.operation.tool, passes, board.groove_pass, self.slack, one_way=True
        )
        self.check_plunges()
        self.check_position(overlaps, final, wide)
        off_board = 0.0
        if blade and curved.any():
            # Chords run out past the board's edge in their own direction.
            off_board = 2.0 * (blade.half_width + self.context.board.groove_depth * blade.slope)
        check_stray_work(self, overlaps, self.curve[:, 5], off_board)
        # The allowed extra run-out is not required.
        self.low, self.high = self.low + self.spare[:, 0], self.high - self.spare[:, 1]
        left_out = self._report_short_grooves(overlaps, drawn, blade)
        for forward in (True, False):
            counted = (overlaps.is_forward == forward) & final
            self.check_uncut(overlaps, np.flatnonzero(~left_out), counted, forward)
        if blade is None:
            return
        self.check_heading(overlaps, np.full(len(self.z), 2.0 * blade.half_width), 360.0, curved)
        self._check_flanks(overlaps, final, blade, wide)
        self._check_fold(overlaps, blade)
        self._check_cuts_beside(drawn, blade)
        is_grooved = np.zeros(len(self.edges), np.bool_)
        is_grooved[overlaps.edge[overlaps.best]] = True
        inside = ~(boundary | groove_continues(self.edges).reshape(-1, 2)).all(axis=1)
        past: F64 = np.where(is_grooved & inside, 2.0 * blade.half_width, 0.0)
        self.record_overcut(np.arange(len(self.edges)), past)
        limit = self.context.board.groove_overcut
        for edge in np.flatnonzero(past > limit + self.tolerance)[:MAX_FINDINGS]:
            self.add_finding(
                "overcut",
                edge,
                Message("verify.groove-past-ends", length=past[edge], most=limit),
                past[edge],
            )

    def _report_short_grooves(
        self, overlaps: Overlaps, drawn: Edges, blade: VCutter | None
    ) -> Bool:
        """Report straight grooves that are shorter than the blade and are not made, as shortfalls.

        Returns the mask of these n grooves, (n,).  A groove that another one continues is never
        among them.

        ``overlaps``: overlaps of the tip paths with the edges.
        ``drawn``: the n grooves without run-outs.
        ``blade``: the V-cutter; without it no groove is reported.
        """
        if blade is None:
            return np.zeros(len(drawn), np.bool_)
        wide = 2.0 * blade.half_width
        short: Bool = (drawn.curve[:, 0] == 0.0) & (drawn.curve[:, 5] < wide + LIMIT_SLACK)
        short &= ~groove_continues(drawn).reshape(-1, 2).any(axis=1)
        along = overlaps.best & (np.abs(np.diff(overlaps.place)[:, 0]) > SHORT)
        short[overlaps.edge[along]] = False
        for edge in np.flatnonzero(short)[:MAX_FINDINGS]:
            length = float(drawn.curve[edge, 5])
            message = Message("verify.groove-too-short", length=length, blade=wide)
            self.add_finding("uncut", edge, message, length, severity=Severity.SHORTFALL)
        np.add.at(self.figures.uncut, self.edges.row[short], drawn.curve[short, 5])
        return short

    def _shift_grooves(self, blade: VCutter) -> None:
        """Shift the expected grooves away from cuts that their flanks would damage, and add notes.

        A groove is shifted only if it is straight and no other groove continues it, and no further
        than the board allows.  ``blade`` is the V-cutter.
        """
        cuts = self.context.edges.with_types(LineType.CUT)
        reach = self.context.board.groove_depth * blade.slope
        least = run_outs(self.edges, cuts, reach).least.reshape(-1, 2)
        damaged = damaged_cuts(self.edges, cuts, reach, least)
        shift = clearing_shifts(damaged, len(self.edges), reach, self.context.board.groove_shift)
        shift[self.edges.curve[:, 0] != 0.0] = 0.0
        shift[groove_continues(self.edges).reshape(-1, 2).any(axis=1)] = 0.0
        if not shift.any():
            return
        curve = self.edges.curve.copy()
        # A row of a straight edge contains its start, direction and length.
        moved = np.stack([-curve[:, 4], curve[:, 3]], axis=1) * shift[:, None]
        moved[shift == 0.0] = 0.0
        curve[:, 1:3] += moved
        self.edges = replace(
            self.edges, curve=curve, ends=self.edges.ends + np.repeat(moved, 2, axis=0)
        )
        for edge in np.flatnonzero(shift)[:MAX_FINDINGS]:
            message = Message("verify.groove-shifted", distance=abs(shift[edge]))
            size = float(abs(shift[edge]))
            self.add_finding("planned", edge, message, size, severity=Severity.NOTE)

    def _add_run_outs(self, blade: VCutter) -> Bool:
        """Lengthen the grooves of this check past the board's edge, in place, by their required
        run-outs and the tolerance.

        The V-cutter must cut the required run-out.  It must not go past the lengthened groove,
        because there may be an obstacle beside the board.  On the edge of a sheet that was cut to
        size it may continue until the blade can turn beside the sheet.  Returns the mask of the
        ends at which a groove leaves the board, (n, 2): the start and the end of each of n grooves.
        ``blade`` is the V-cutter.
        """
        half = self.context.board.groove_depth * blade.slope
        required = run_outs(self.edges, self.context.edges.with_types(LineType.CUT), half)
        boundary = required.boundary.reshape(-1, 2)
        least = required.least.reshape(-1, 2)
        # Chords run out in their own direction, so arcs are not lengthened here.
        straight_on = self.edges.curve[:, 0] == 0.0
        boundary &= straight_on[:, None]
        self.spare = np.where(boundary, self.tolerance, 0.0)
        if self.context.sheet is not None and len(self.context.sheet.start):
            leaves = self.context.sheet.touches(self.edges.ends).reshape(-1, 2) & boundary
            # At 30° to the edge the blade is off the sheet after twice its extent and clearance.
            extent = 2.0 * blade.half_width + half + self.context.machine.clearance
            self.spare += np.where(leaves, 2.0 * extent, 0.0)
        more = least + self.spare
        curve = self.edges.curve.copy()
        # A row of a straight edge contains its start, direction and length.
        straight = curve[:, 0] == 0.0
        curve[straight, 1:3] -= more[straight, :1] * curve[straight, 3:5]
        curve[straight, 5] += more[straight].sum(axis=1)
        self.edges = replace(self.edges, curve=curve)
        self.size = curve[:, 5]
        self.high = self.size.copy()
        self.before = more[:, 0]
        return boundary

    def _deepest_passes(self, overlaps: Overlaps) -> Bool:
        """Return the mask of the overlaps that belong to the deepest pass over an edge.

        Each edge has one deepest pass in each direction of travel.  ``overlaps`` are the overlaps
        of the tip paths with the edges.  Adds a finding for each pass that is shallower than the
        pass before it on the same edge in the same direction.
        """
        deep = (self.context.board.caliper - self.z)[overlaps.curve]
        pass_key = 2 * overlaps.edge.astype(np.int64) + overlaps.is_forward
        deepest = np.zeros(2 * len(self.edges))
        np.maximum.at(deepest, pass_key[overlaps.best], deep[overlaps.best])
        final: Bool = deep >= deepest[pass_key] - DEPTH_TOLERANCE
        order = np.flatnonzero(overlaps.best & (np.abs(np.diff(overlaps.place)[:, 0]) > SHORT))
        order = order[np.lexsort((overlaps.curve[order], pass_key[order]))]
        same = pass_key[order[1:]] == pass_key[order[:-1]]
        back = same & (deep[order[1:]] < deep[order[:-1]] - DEPTH_TOLERANCE)
        for k in np.flatnonzero(back)[:MAX_FINDINGS]:
            row = order[k + 1]
            self.add_finding(
                "depth",
                int(overlaps.edge[row]),
                Message("verify.groove-shallower", depth=deep[row], before=deep[order[k]]),
                float(deep[order[k]] - deep[row]),
                int(overlaps.curve[row]),
            )
        return final

    def _check_flanks(self, overlaps: Overlaps, final: Bool, blade: VCutter, limit: F64) -> None:
        """Check the distance from the edge at which each flank of a groove reaches the top face;
        add findings.

        The distance should be depth × tan(tilt), with the tilt of the V-cutter.  In each pass the
        blade leans to the right of its direction of travel, and cuts the flank on that side.

        ``overlaps``: overlaps of the tip paths with the n edges.
        ``final``: mask of the overlaps of the deepest passes.
        ``limit`` (n,) mm: greatest permitted error of the distance, for each edge.
        """
        size = np.abs(np.diff(overlaps.place)[:, 0])
        rows = np.flatnonzero(overlaps.best & final & (size > SHORT))
        work, edge = overlaps.curve[rows], overlaps.edge[rows]
        forward = overlaps.place[rows, 1] > overlaps.place[rows, 0]
        deep = self.context.board.caliper - self.z[work]
        lean = (deep - self.depth[edge]) * blade.slope
        error = np.zeros(len(rows))
        for side in range(2):
            left = left_distance(
                self.curve[work], overlaps.along[rows, side], self.edges.curve[edge]
            )
            right = np.where(forward, -left, left) + lean
            error = np.where(np.abs(right) > np.abs(error), right, error)
        row = self.edges.row[edge]
        np.maximum.at(self.figures.flank, row, np.abs(error))
        wide = np.zeros((len(self.figures.width), 2))
        np.maximum.at(wide, (row, forward.astype(np.int64)), self.depth[edge] * blade.slope + error)
        np.maximum(self.figures.width, wide.sum(axis=1), out=self.figures.width)
        web = np.full(len(self.figures.web), np.inf)
        np.minimum.at(web, row, self.context.board.caliper - deep)
        self.figures.web[np.isfinite(web)] = web[np.isfinite(web)]
        for k in np.flatnonzero(np.abs(error) > limit[edge] + 1e-9)[:MAX_FINDINGS]:
            self.add_finding(
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

    def _check_fold(self, overlaps: Overlaps, blade: VCutter) -> None:
        """Add a shortfall for each groove that does not let the board fold by the required angle.

        The flanks of a groove enclose twice the tilt of the blade.  They meet when the board has
        folded by that angle.

        ``overlaps``: overlaps of the tip paths with the edges.
        """
        required = self.context.board.fold_angle
        angle = 2.0 * math.degrees(math.atan(blade.slope))
        if angle >= required - ANGLE_TOLERANCE:
            return
        for edge in np.unique(overlaps.edge[overlaps.best])[:MAX_FINDINGS]:
            self.add_finding(
                "fold",
                int(edge),
                Message("verify.fold-angle", angle=angle, required=required),
                required - angle,
                severity=Severity.SHORTFALL,
            )

    def _check_cuts_beside(self, drawn: Edges, blade: VCutter) -> None:
        """Add a finding for each cut that lies beside a groove and is damaged by a flank of the
        groove.

        ``drawn`` are the edges of the grooves without run-outs; ``blade`` is the V-cutter.
        """
        cuts = self.context.edges.with_types(LineType.CUT)
        reach = self.context.board.groove_depth * blade.slope
        run_out = self.before[:, None] - self.spare
        run_out[:, 1] = self.size - drawn.curve[:, 5] - self.before - self.spare[:, 1]
        damaged = damaged_cuts(drawn, cuts, reach, run_out)
        excess = reach - damaged.nearest
        for k in np.flatnonzero(excess > self.tolerance)[:MAX_FINDINGS]:
            self.add_finding(
                "overcut",
                int(damaged.groove[k]),
                Message(
                    "verify.flank-through-cut",
                    depth=excess[k],
                    edge=cuts.row[damaged.cut[k]],
                    distance=damaged.nearest[k],
                    place=damaged.place[k],
                ),
                float(excess[k]),
            )
