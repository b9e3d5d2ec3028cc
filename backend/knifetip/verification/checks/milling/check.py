"""Check the cuts of a router bit or a laser, which removes the board within a disc of radius r.

The disc must touch each edge from the waste side without cutting into the part.  Its centre must
follow the offset of the edge by r, except where the offset is nearer than r to another edge.  That
is the case in a concave corner or a narrow slot; the length of the edge that the disc cannot touch
there is recorded as ``unreached``.  Convex corners may be rounded or square.

A cutter that deflects by δx along X and δy along Y under load is moved that much nearer to the
edge.  Its centre is at P + ((r - δx) n_x, (r - δy) n_y), with the point P on the edge and the unit
normal n towards the waste.  Round a convex corner the centre moves on an ellipse.

Source: "Tool radius compensation", equations 1-9.  The reach into corners was derived for knifetip.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import chain
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.machine import Station
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.bridges import check_bridges, order_bridges
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.common.hand_bridges import check_hand_bridges, find_hand_bridges
from knifetip.verification.checks.common.pass_depth import (
    Passes,
    report_deep_passes,
    unfinished_spans,
)
from knifetip.verification.checks.milling.chosen_leads import longest_chosen_lead
from knifetip.verification.checks.milling.geometry import spans_near_points
from knifetip.verification.checks.milling.paths import check_centre_paths, open_cut_mask
from knifetip.verification.checks.milling.shortfalls import (
    distance_from_disc,
    report_unreached,
    report_wide_slits,
)
from knifetip.verification.checks.milling.unreached_areas import unreached_areas
from knifetip.verification.checks.milling.work import MilledCuts, MilledPaths, MillingWork
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, left_distance, line_curves, point_at
from knifetip.verification.curves.intervals import (
    EPSILON,
    Overlaps,
    uncovered_edges,
)
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.cutter_paths import CutterPaths, cutter_paths, disc_reach
from knifetip.verification.expectation.edges import JOIN_DISTANCE, pairs_within
from knifetip.verification.expectation.expected_work import knife_ends
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.tools import expected_tool

#: Greatest depth by which the disc may cut into a corner that it goes round (mm).
_CORNER_ERROR: Final = 5e-4
#: Longest stretch between two unreachable ones that counts as unreachable, too (mm).  In a slot as
#: wide as the disc, hundredths decide whether the disc reaches the middle of the bottom.
_NARROW_LENGTH: Final = 0.05
#: Greatest lengths by which the radius of an arc is smaller and larger than that of the disc, if
#: they count as equal (mm): that of a hole whose circle was drawn with three digits, and the
#: smallest radius with which a program has arcs of the centre.
_SMALLER_ARC: Final = 0.0011
_LARGER_ARC: Final = 0.0021


def check_milling(
    context: CheckContext, cuts: MilledCuts, centres: MilledPaths, station: Station, slack: float
) -> None:
    """Check that a cutter removes the board on the waste side of its cuts, and nowhere else.

    Parameters
    ----------
    context
        Inputs and results of the verification; findings and figures are added to it.
    cuts
        All cuts, and which of them the cutter must make.
    centres
        Paths of the cutter's centre.
    station
        Station in which the cutter is mounted.
    slack : mm
        An uncut stretch, a path past the end of an open cut, a stray path, or an error of a bridge
        gives no finding if its length is at most ``slack``.
    """
    tool = expected_tool(station.tool)
    assert tool.disc is not None
    planned = tool.through_depth(context.board.caliper, context.machine.into_mat)
    reach = disc_reach(context.board, station)
    entry = max(tool.disc.entry_length, longest_chosen_lead(context))
    disc = replace(tool.disc, entry_length=entry)
    _MillingCheck(context, cuts, centres, disc, reach, slack).run(planned)


class _MillingCheck(MillingWork):
    """Check that compares the paths of one cutter's centre with all cuts that the cutter must
    make.
    """

    def run(self, planned_depth: float) -> None:
        """Run the check; ``planned_depth`` is the planned depth of the tip below the board's top
        face (mm).
        """
        deep = self.context.board.caliper - self.centres.z
        wrong = deep - planned_depth
        if self.tool.step == 0.0 and not self.context.has_passes:
            wrong = np.abs(wrong)
        for row in np.flatnonzero(wrong > self.context.depth_tolerance)[:MAX_FINDINGS]:
            self.add_finding(
                "depth",
                -1,
                Message(
                    "verify.wrong-depth", tool="cutter", depth=deep[row], planned=planned_depth
                ),
                float(wrong[row]),
                row,
            )
        passes = Passes(self.centres.curve, deep, self.centres.line)
        report_deep_passes(self.context, "cutter", passes, self.tool.step, self.slack)
        is_through = deep >= planned_depth - self.context.depth_tolerance
        self._check_unfinished(deep, is_through)
        pieces = cutter_paths(self.bounds, self.reach)
        gap_edge, begin, end = self._untouched_stretches(pieces, is_through)
        own = self.owned[gap_edge]
        gap_edge, begin, end = gap_edge[own], begin[own], end[own]
        through = self.centres.curve[is_through]
        unreached = self._record_untouched(pieces, gap_edge, begin, end, through)
        report_unreached(self.context, self.bounds, unreached, through, self.reach)
        on_cut = open_cut_mask(self)
        on_slit = self.centres.curve[is_through & on_cut]
        slits = np.flatnonzero(~self.bounds.closing & self.owned)
        report_wide_slits(self.context, self.edges, slits, on_slit, 2.0 * self.tool.radius)
        check_centre_paths(self, on_cut)

    def _check_unfinished(self, deep: F64, is_through: Bool) -> None:
        """Add a finding for each stretch that only shallow passes mill, such as a bridge.

        A cutter that mills in a single pass has no shallow passes.

        ``deep`` is the depth of the tip below the board's top face in each of the n paths of the
        cutter's centre, (n,) mm, and ``is_through`` the mask of the paths through the board, (n,).
        """
        if self.tool.step == 0.0 and not self.context.has_passes:
            return
        path_rows, spans = unfinished_spans(self.centres.curve, is_through, self.tolerance)
        size = np.diff(spans)[:, 0]
        for k in np.flatnonzero(size > self.slack)[:MAX_FINDINGS]:
            row = int(path_rows[k])
            message = Message("verify.pass-alone", length=size[k], depth=deep[row])
            self.add_finding("stray", -1, message, float(size[k]), row)

    def _untouched_stretches(self, pieces: CutterPaths, is_through: Bool) -> tuple[I64, F64, F64]:
        """Return the k stretches of edges that the disc touches on none of its paths through the
        board.

        Also records the deviations of the centre from its expected paths.

        ``is_through`` (n,): mask of the centre's n actual paths on which the disc goes through the
        board.
        Returns three arrays, (k,) each: index of the edge of each stretch, and the start and the
        end of the stretch along that edge (mm).
        """
        centres = self.centres.select(is_through)
        rounds = centres.blend
        length = pieces.curve[:, 5]
        overlaps = find_overlaps(
            centres.curve, pieces.curve, np.zeros(len(length)), length, self.tolerance
        )
        edge = pieces.edge[overlaps.edge]
        fit_error = self.context.fit_error[self.edges.row[edge]]
        figure = overlaps.distance + rounds[overlaps.curve] + fit_error
        # A path that crosses the tolerance band leads in or out.
        runs = overlaps.best & (overlaps.distance < 0.99 * self.tolerance)
        # Round the corner of one edge the centre may pass the path beside another edge.  Such an
        # arc, or the line before or after it, does not count for the other edge.
        passes = runs & (figure > self.tolerance)
        passes &= self._goes_round_corner(centres.curve, overlaps.curve[passes])[overlaps.curve]
        runs &= ~passes
        beside = np.flatnonzero(runs & (figure > self.tolerance))
        beside = beside[self._runs_past_ends(centres.curve, pieces, overlaps, beside)]
        passes[beside], runs[beside] = True, False
        low, high = pieces.edge_intervals(overlaps.edge, overlaps.place)
        # A lead-in may lie beside a slit that another path makes.
        again = np.flatnonzero(runs & (figure > self.tolerance))
        exact = np.flatnonzero(runs & (figure <= self.tolerance))
        again = again[_are_covered(edge, low, high, again, exact)]
        passes[again], runs[again] = True, False
        self.context.figures.record_deviation(
            self.edges.row[edge[runs]],
            overlaps.distance[runs],
            rounds[overlaps.curve[runs]],
            fit_error[runs],
        )
        first, last = (
            pieces.edge_intervals(overlaps.edge, overlaps.place[:, [0, 0]])[0],
            overlaps.place[:, [1, 1]],
        )
        for side, position in ((0, first), (1, pieces.edge_intervals(overlaps.edge, last)[0])):
            offset = left_distance(
                centres.curve[overlaps.curve], overlaps.along[:, side], pieces.curve[overlaps.edge]
            )
            self.context.samples.append(
                (
                    self.edges.row[edge[runs]],
                    ((self.begin[edge] + position) / self.size_of_edge[edge])[runs],
                    offset[runs],
                )
            )
        along = np.abs(np.diff(overlaps.place)[:, 0]) > self.tolerance
        for row in np.flatnonzero(runs & along & (figure > self.tolerance + 1e-9))[:MAX_FINDINGS]:
            rounding = rounds[overlaps.curve[row]]
            parts = {
                "distance": overlaps.distance[row],
                "rounding": rounding,
                "tolerance": self.tolerance,
            }
            message, severity = Message("verify.centre-off-path", **parts), Severity.FAULT
            if overlaps.distance[row] + rounding <= self.tolerance:
                message = Message("verify.off-curve", fit=fit_error[row], **parts)
                severity = Severity.SHORTFALL
            self.context.findings.add(
                "deviation",
                message,
                float(figure[row]) if np.isfinite(figure[row]) else float(overlaps.distance[row]),
                edge=int(self.edges.row[edge[row]]),
                line=int(centres.line[overlaps.curve[row]]),
                severity=severity,
            )
        filled = self._filled_arcs(centres.curve)
        return uncovered_edges(
            np.concatenate([edge[~passes], filled]),
            np.concatenate([low[~passes], np.zeros(len(filled))]),
            np.concatenate([high[~passes], self.size[filled]]),
            self.size,
        )

    def _goes_round_corner(self, centres: F64, rows: I32) -> Bool:
        """Return the mask of those of n paths of the disc's centre that are arcs round an end of an
        edge, (n,).

        On such an arc the disc touches the end of the edge, or passes it by up to half the
        tolerance, as the arc of a type D corner does where a curve is drawn as chords.  It is less
        if rounding by the controller and the fit of the edge leave less of the tolerance.

        ``centres`` (n, 6) are lines and arcs.  Only those with the indices ``rows`` are examined.
        """
        result = np.zeros(len(centres), np.bool_)
        if not self.disc_is_round:
            return result
        arcs = np.unique(rows[centres[rows, 0] != 0.0])
        middle = point_at(centres[arcs], 0.5 * centres[arcs, 5])
        closing = np.repeat(self.bounds.closing, 2)
        corners = self.edges.ends[closing]
        farthest = self.reach[0] + self._passing_distance(np.flatnonzero(closing) // 2)
        arc, corner = pairs_within(middle, corners, self.reach[0] + 0.5 * self.tolerance)
        curve = centres[arcs[arc]]
        touches = np.ones(len(arc), np.bool_)
        for fraction in (0.0, 0.5, 1.0):
            away = np.hypot(*(point_at(curve, fraction * curve[:, 5]) - corners[corner]).T)
            touches &= (away >= self.reach[0] - _CORNER_ERROR) & (away <= farthest[corner])
        result[arcs[arc[touches]]] = True
        return result

    def _passing_distance(self, edges: I64) -> F64:
        """Return the distance by which the disc may pass each of n edges, (n,) mm.

        It is half the tolerance, or what the controller and the fit of the edge leave of it.
        """
        used = self.rounds.max(initial=0.0) + self.context.fit_error[self.edges.row[edges]]
        left: F64 = np.clip(self.tolerance - used, 0.0, 0.5 * self.tolerance)
        return left

    def _runs_past_ends(
        self, centres: F64, pieces: CutterPaths, overlaps: Overlaps, rows: I64
    ) -> Bool:
        """Return the mask of those of k overlaps in which the disc's centre only continues its path
        beside another edge straight past the end of that edge, (k,).

        Round a corner the centre may go on by up to the disc's radius before it turns.

        ``centres`` (n, 6): paths of the disc's centre.
        ``pieces``, ``overlaps``, ``rows``: expected paths of the centre, its overlaps with them,
        and the indices of the k overlaps.
        """
        if len(rows) == 0 or not self.disc_is_round:
            return np.zeros(len(rows), np.bool_)
        curve = pieces.curve
        ends = [point_at(curve, np.zeros(len(curve))), point_at(curve, curve[:, 5])]
        outward = np.radians(
            [azimuth_at(curve, np.zeros(len(curve))) + 180.0, azimuth_at(curve, curve[:, 5])]
        )
        ahead = [
            line_curves(end, end + self.reach[0] * np.stack([np.cos(angle), np.sin(angle)], axis=1))
            for end, angle in zip(ends, outward, strict=True)
        ]
        wanted = np.concatenate([curve, *ahead])
        work, number = np.unique(overlaps.curve[rows], return_inverse=True)
        nothing = np.zeros(len(wanted))
        found = find_overlaps(centres[work], wanted, nothing, wanted[:, 5], self.tolerance)
        key = found.curve.astype(np.int64) * len(wanted) + found.edge
        result: Bool = ~np.isin(number * len(wanted) + overlaps.edge[rows], key[found.best])
        return result

    def _filled_arcs(self, centres: F64) -> I64:
        """Return the indices of the arcs that are as wide as the disc, and along which it lies.

        Beside such an arc the centre stays at one point, or crosses from side to side on a line, so
        it has no path to follow.  The disc lies along the arc if no point of the arc is farther
        from it than ``_passing_distance``.

        ``centres`` are the paths of the disc's centre through the board, (n, 6).
        """
        curve = self.edges.curve
        is_bent = (curve[:, 0] != 0.0) & self.bounds.closing
        is_inside = (curve[:, 0] > 0.0) != self.bounds.board_left
        excess = curve[:, 3] - self.reach[0]
        as_wide = (excess >= -_SMALLER_ARC) & (excess <= _LARGER_ARC)
        arcs = np.flatnonzero(is_bent & is_inside & as_wide)
        if len(arcs) == 0 or len(centres) == 0 or not self.disc_is_round:
            return np.zeros(0, np.int64)
        points = [
            point_at(curve[arcs], fraction * curve[arcs, 5])
            for fraction in np.linspace(0.0, 1.0, 9)
        ]
        distance = distance_from_disc(np.concatenate(points), centres, self.reach)
        farthest = distance.reshape(len(points), -1).max(axis=0)
        result: I64 = arcs[farthest <= self._passing_distance(arcs)]
        return result

    def _blocked_beyond_ends(self, edge: I64, low: F64, high: F64) -> Bool:
        """Return the mask of the 2n ends of n edges at which another edge is blocked, (2n,).

        ``edge``, ``low`` and ``high`` are the edge, the start and the end of each of k blocked
        stretches, (k,) and (k,) mm along the edge.
        """
        blocked = np.zeros(2 * len(self.size), np.bool_)
        blocked[2 * edge[low < EPSILON]] = True
        at_end = high > self.size[edge] - EPSILON
        blocked[2 * edge[at_end] + 1] = True
        one, other = self.edges.near_ends(JOIN_DISTANCE)
        result = np.zeros(len(blocked), np.bool_)
        result[one[blocked[other] & (one // 2 != other // 2)]] = True
        return result

    def _record_untouched(
        self, pieces: CutterPaths, edge: I64, begin: F64, end: F64, through: F64
    ) -> tuple[I64, F64, F64]:
        """Divide untouched stretches of edges into unreachable stretches, bridges and uncut
        stretches.

        Records their lengths as figures of the edges, and adds a finding for each uncut stretch.
        Returns the u unreachable stretches on edges without uncut stretches as three arrays, (u,)
        each: index of the edge, and the start and the end of the stretch along that edge (mm).

        ``pieces``: expected paths of the centre.
        ``edge``, ``begin``, ``end`` (k,): index of the edge of each untouched stretch, and the
        start and the end of the stretch along that edge (mm).
        ``through``: paths of the disc's centre through the board, (m, 6).
        """
        blocked_edge, low, high = self._blocked_stretches(pieces)
        # Gaps that remain after the blocked stretches are subtracted.
        touched_edge, first, last = uncovered_edges(edge, begin, end, self.size)
        left_edge, left_begin, left_end = uncovered_edges(
            np.concatenate([blocked_edge, touched_edge]),
            np.concatenate([low, first]),
            np.concatenate([high, last]),
            self.size,
        )
        missed = left_end - left_begin
        figures, row = self.context.figures, self.edges.row
        np.add.at(figures.unreached, row[edge], end - begin)
        np.subtract.at(figures.unreached, row[left_edge], missed)
        bare = missed > self.slack
        # Length that the disc touches within the tolerance beside a blocked stretch.
        beside = float(np.sqrt(2.0 * self.reach.max() * self.tolerance))
        beyond = self._blocked_beyond_ends(blocked_edge, low, high)
        for k in np.flatnonzero(bare & (missed <= beside)):
            own = left_edge[k]
            same_edge = blocked_edge == own
            before = (np.abs(high[same_edge] - left_begin[k]) < EPSILON).any()
            after = (np.abs(low[same_edge] - left_end[k]) < EPSILON).any()
            before |= left_begin[k] < EPSILON and beyond[2 * own]
            after |= left_end[k] > self.size[own] - EPSILON and beyond[2 * own + 1]
            bare[k] = before == after and not (before and missed[k] <= _NARROW_LENGTH)
            if bare[k] and self.bounds.closing[own]:
                bare[k] = self._is_far(own, left_begin[k], left_end[k], through)
        reached = ~np.isin(edge, left_edge[bare])
        self.context.unreached.append(
            unreached_areas(self.bounds, edge[reached], begin[reached], end[reached], self.reach)
        )
        bare &= ~self._check_bridge_gaps(left_edge, left_begin, left_end)
        np.add.at(figures.uncut, row[left_edge[bare]], missed[bare])
        for k in np.flatnonzero(bare)[:MAX_FINDINGS]:
            self.add_finding(
                "uncut",
                int(left_edge[k]),
                Message(
                    "verify.not-worked",
                    length=missed[k],
                    work=Message("verify.work-cut"),
                    where=Message(
                        "verify.where-from-start",
                        place=self.begin[left_edge[k]] + left_begin[k],
                    ),
                ),
                float(missed[k]),
            )
        unreached = uncovered_edges(
            np.concatenate([touched_edge, left_edge]),
            np.concatenate([first, left_begin]),
            np.concatenate([last, left_end]),
            self.size,
        )
        is_complete = ~np.isin(unreached[0], left_edge[bare])
        return unreached[0][is_complete], unreached[1][is_complete], unreached[2][is_complete]

    def _is_far(self, edge: int, begin: float, end: float, through: F64) -> bool:
        """Return whether part of a stretch of an edge is farther than the tolerance from the board
        that the disc removes.

        In a curve that was drawn with few decimals, the disc cannot reach every stretch, and it
        comes near others without a path of its own there.

        ``begin`` and ``end`` are positions along the edge (mm); ``through`` are the paths of the
        disc's centre through the board, (m, 6).
        """
        if len(through) == 0:
            return True
        spots = np.linspace(begin, end, 5)
        points = point_at(np.repeat(self.edges.curve[edge : edge + 1], len(spots), axis=0), spots)
        return bool((distance_from_disc(points, through, self.reach) > self.tolerance).any())

    def _check_bridge_gaps(self, edge: I64, begin: F64, end: F64) -> Bool:
        """Check the bridges among k untouched stretches of edges; return the mask of the stretches
        that are bridges, shape (k,).

        ``edge``, ``begin`` and ``end`` are the index of the edge of each stretch, and the start and
        the end of the stretch along that edge (mm).  The width of a bridge is the length of the gap
        in the centre's path less the disc's diameter.
        """
        board = self.context.board
        by_board = board.bridge_width > 0.0 and board.bridge_spacing > 0.0
        if not by_board and not self.context.bridges:
            return np.zeros(len(edge), np.bool_)
        curve = self.edges.curve[edge]
        bent = curve[:, 0] != 0.0
        waste = np.where(self.bounds.board_left[edge], -1.0, 1.0)
        # The offset of an arc is longer or shorter than the arc.
        grows = np.where(bent, -curve[:, 0] * waste, 0.0) * self.tool.radius
        scale = 1.0 + grows / np.where(bent, curve[:, 3], 1.0)
        width = (end - begin) * scale - 2.0 * self.tool.radius
        paths = knife_ends(self.edges, self.edges, 0.0, 0.0, self.bounds.outer).paths
        rounds = paths.first < 0
        rounds[paths.path[~(self.bounds.outer & self.owned)]] = False
        hand = find_hand_bridges(self.context, self.edges, paths).on_edges(self.owned)
        on_hand = hand.paths(len(rounds))
        if not by_board:
            rounds &= on_hand
        is_bridge = rounds[paths.path[edge]] & (width > 0.0)
        edge, width = edge[is_bridge], width[is_bridge]
        begin, end = begin[is_bridge], end[is_bridge]

        path, position, bare = paths.path[edge], 0.5 * (begin + end), end - begin
        middle = paths.begin[edge] + np.where(
            paths.flipped[edge], self.size[edge] - position, position
        )
        np.add.at(self.context.figures.setback, self.edges.row[edge], bare)
        bridges = order_bridges(path, middle, width, bare, bare, paths.length)
        automatic = bridges.on_paths(~on_hand)
        for kind, edge_row, message, measure in chain(
            check_bridges(automatic, paths, self.edges, rounds & ~on_hand, board, self.slack),
            check_hand_bridges(bridges, hand, paths, self.edges, self.slack),
        ):
            self.add_finding(kind, edge_row, message, measure)
        return is_bridge

    def _blocked_stretches(self, pieces: CutterPaths) -> tuple[I64, F64, F64]:
        """Return the stretches of edges that the disc cannot touch without cutting another edge or
        corner.

        ``pieces`` are the expected paths of the centre.  Returns three arrays, (k,) each: index of
        the edge of each stretch, and the start and the end of the stretch along that edge (mm).
        """
        closing = np.flatnonzero(self.bounds.closing)
        curve = self.edges.curve[closing]
        near = float(self.reach.min())
        # With different deflections along X and Y the smaller reach blocks a corner.
        wide = float(self.reach.max()) + self.tolerance
        overlaps = find_overlaps(pieces.curve, curve, np.zeros(len(curve)), curve[:, 5], wide)
        own = pieces.edge[overlaps.curve]
        other = own != closing[overlaps.edge]
        low, high = pieces.edge_intervals(overlaps.curve[other], overlaps.along[other])
        edge = [own[other]]
        lows, highs = [low], [high]
        # Convex corners block the disc too.
        corner = self.edges.ends[np.repeat(self.bounds.closing, 2)]
        met = find_overlaps(
            line_curves(corner, corner),
            pieces.curve,
            np.zeros(len(pieces.curve)),
            pieces.curve[:, 5],
            near,
        )
        begin, end = spans_near_points(
            pieces.curve[met.edge], corner[met.curve], near - 0.5 * self.tolerance
        )
        nonempty = end > begin
        low, high = pieces.edge_intervals(
            met.edge[nonempty], np.stack([begin[nonempty], end[nonempty]], axis=1)
        )
        edge.append(pieces.edge[met.edge[nonempty]])
        lows.append(low)
        highs.append(high)
        # An edge without an offset cannot be touched.
        missing = np.setdiff1d(np.arange(len(self.edges)), pieces.edge)
        edge.append(missing)
        lows.append(np.zeros(len(missing)))
        highs.append(self.size[missing])
        return np.concatenate(edge), np.concatenate(lows), np.concatenate(highs)


def _are_covered(edge: I64, low: F64, high: F64, rows: I64, exact: I64) -> Bool:
    """Return the mask of those of some stretches of edges that lie in one other stretch, (k,).

    Parameters
    ----------
    edge, low, high : (n,), (n,) mm and (n,) mm
        The edge of each stretch, and its start and end along the edge.
    rows, exact : (k,) and (m,)
        Indices of the stretches in question, and of those in which they may lie.
    """
    result = np.zeros(len(rows), np.bool_)
    for k, row in enumerate(rows):
        same = exact[edge[exact] == edge[row]]
        inside = (low[same] <= low[row] + EPSILON) & (high[same] >= high[row] - EPSILON)
        result[k] = inside.any()
    return result
