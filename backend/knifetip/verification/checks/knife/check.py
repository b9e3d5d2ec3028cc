"""Check the cuts, half-cuts, perforations and bridges that a knife makes.

A slanted blade cuts the top face of the board ahead of its tip by the lead, depth × tan(slant).
The uncut length is therefore recorded in the bottom face, and the overcut in the top face.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import chain
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.job_options import CutDepth
from knifetip.model.tool import Knife
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.checks.common.bridges import check_bridges, find_bridges
from knifetip.verification.checks.common.hand_bridges import (
    check_hand_bridges,
    find_hand_bridges,
    planned_widths,
)
from knifetip.verification.checks.common.stray_work import check_stray_work
from knifetip.verification.checks.knife.blade_bends import check_blade_bends
from knifetip.verification.checks.knife.blade_swivels import check_blade_swivels
from knifetip.verification.checks.knife.perforations import check_perforations
from knifetip.verification.checks.knife.track_ends import check_track_ends, overrun_starts
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, line_curves, point_at
from knifetip.verification.curves.intervals import SHORT, Overlaps, mark_nearest, uncovered_edges
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edge_paths import EdgePaths, continues_straight
from knifetip.verification.expectation.edges import LIMIT_SLACK, Edges, angle_between
from knifetip.verification.expectation.expected_work import KnifeEnds, knife_ends
from knifetip.verification.expectation.outline import count_enclosing, find_outlines
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.tools import OperationKind

#: Tracks that meet may lie side by side for so many tolerances, as on edges of 0.06 mm in coarse
#: coordinates.
_BOTH_WAYS: Final = 4.0
#: Part of an edge that a free blade may seem to cut in both directions.
_FREE_BOTH_WAYS: Final = 0.25


class KnifeCheck(StationCheck):
    """Check that compares the cuts and half-cuts of a knife with the edges."""

    def check(self) -> None:
        if self.operation == OperationKind.CUT:
            self._check_cuts()
        else:
            self._check_half_cuts()

    def _check_cuts(self) -> None:
        caliper = self.context.board.caliper
        depth = self._chosen_depth(caliper + self.context.machine.into_mat)
        self.depth[:] = depth
        self._check_work(depth, min(depth, caliper))

    def _check_half_cuts(self) -> None:
        depth = self._chosen_depth(self.context.board.half_cut_depth)
        self.depth[:] = depth
        self._check_work(depth, depth)

    def _chosen_depth(self, usual: float) -> float:
        """Return the depth of the edges of this check, which are equally deep (mm).

        ``usual`` is the depth of edges for which none is chosen.
        """
        if CutDepth not in self.context.chosen or len(self.edges) == 0:
            return usual
        chosen = self.context.chosen[CutDepth].numbers("depth", usual)
        return float(chosen[self.edges.row[0]])

    def _check_work(self, lead_depth: float, overrun_depth: float) -> None:
        """Compare the knife's tip paths with the edges; add findings and figures.

        ``lead_depth`` mm: depth of the tip below the top face.  The lead, the length by which the
        blade cuts the top face ahead of its tip, is this depth times tan(slant).
        ``overrun_depth`` mm: depth that determines the overrun: at an end that meets a cut and has
        waste ahead, the tip should pass the end by this depth times tan(slant).
        """
        blade = self.tool(Knife)
        slant = math.tan(math.radians(blade.blade_angle)) if blade else 0.0
        cuts = self.context.edges.with_types(LineType.CUT)
        perforated = np.isin(self.edges.line_type, (LineType.PERFORATION, LineType.COMBI))
        solid_rows = np.flatnonzero(~perforated)
        solid_edges = self.edges.with_types(LineType.CUT, LineType.HALF_CUT)
        ring = find_outlines(solid_edges).outer if self._needs_bridges else None
        lengths = lead_depth * slant, overrun_depth * slant
        swivel = blade.swivel if blade else 180.0
        ends = knife_ends(solid_edges, cuts, *lengths, ring, swivel)
        if ring is not None and not self._board_has_bridges:
            # Only outlines on which the user has placed bridges count as one path.
            hand = find_hand_bridges(self.context, solid_edges, ends.paths)
            ring &= hand.paths(len(ends.paths.length))[ends.paths.path]
            ends = knife_ends(solid_edges, cuts, *lengths, ring, swivel)
        rounds = self._paths_with_bridges(solid_edges, ends.paths)
        has_bridges = np.zeros(len(self.edges), np.bool_)
        has_bridges[solid_rows[rounds[ends.paths.path]]] = True
        if blade and self.operation == OperationKind.CUT:
            self._remove_leads(blade)
        self.check_plunges()
        overlaps = self.match_edges()
        dashed = self._dashed_tracks(overlaps, perforated, overrun_depth * slant)
        dashed |= self._tracks_along(overlaps, has_bridges)
        over = check_track_ends(self, solid_edges, solid_rows, ends, dashed, overrun_depth * slant)
        # An overrun crosses other edges, but it does not cut along them.
        overrun_start = overrun_starts(self, over)
        overlaps = mark_nearest(overlaps, self.curve, overrun_start)
        self.check_position(overlaps)
        check_stray_work(self, overlaps, overrun_start)
        self._check_opposite_cuts(overlaps)
        left_out = np.zeros(len(self.edges), np.bool_)
        left_out[self._report_short_cuts(overlaps, solid_rows, ends, lead_depth * slant)] = True
        self.check_uncut(overlaps, np.flatnonzero(~perforated & ~has_bridges & ~left_out))
        if has_bridges.any():
            self._check_bridge_gaps(
                overlaps, solid_edges, solid_rows, ends.paths, rounds, lead_depth * slant
            )
        if perforated.any():
            check_perforations(
                self,
                overlaps,
                np.flatnonzero(perforated),
                dashed & ~self._tracks_along(overlaps, has_bridges),
                lead_depth * slant,
            )
        if blade:
            # The tip of a free blade moves along the blade, so its position determines its heading.
            if blade.free:
                check_blade_swivels(self, blade)
            else:
                self.check_heading(overlaps, np.full(len(self.z), blade.blade_width), 360.0)
            check_blade_bends(self, overlaps, blade, lead_depth * slant)
            self._record_faces(
                overlaps, over, lead_depth * slant, (lead_depth - overrun_depth) * slant
            )

    def _dashed_tracks(self, overlaps: Overlaps, perforated: Bool, overrun: float) -> Bool:
        """Return the mask of the tracks that are cuts of perforations, (t,).

        A cut that ends where a perforation begins may overrun along the perforation.

        ``overlaps``: overlaps of the tip paths with the n edges.
        ``perforated`` (n,): mask of the perforated edges.
        ``overrun`` mm: length of an overrun.
        """
        count = int(self.track.max(initial=-1)) + 1
        rows = np.flatnonzero(overlaps.best & perforated[overlaps.edge])
        track = self.track[overlaps.curve[rows]]
        along = np.bincount(track, np.diff(overlaps.along[rows])[:, 0], minlength=count)
        size = np.bincount(self.track, self.curve[:, 5], minlength=count)
        touches = np.bincount(track, minlength=count) > 0
        result: Bool = touches & (along >= np.minimum(overrun + self.slack, 0.5 * size))
        return result

    def _check_opposite_cuts(self, overlaps: Overlaps) -> None:
        """Add a finding for each edge that the knife cuts in both directions.

        A slanted blade that cuts an edge again in the opposite direction cuts the top face past the
        other end of the edge, too, where no such cut is planned.  An upright free blade cuts
        nothing past it, and at an acute corner rounded coordinates put its tip on the other edge.

        ``overlaps``: overlaps of the tip paths with the edges, without overruns.
        """
        blade = self.tool(Knife)
        if blade and blade.free and blade.blade_angle == 0.0:
            return
        met = _in_both_directions(overlaps.select(overlaps.best))
        low, high = met.place_range()
        edges, track = met.edge.astype(np.int64), self.track[met.curve]
        # Edges that meet at a flat angle lie side by side for a short length.  A track that only
        # passes an edge there does not cut it.
        pair = np.unique(edges * (1 + self.track.max(initial=0)) + track, return_inverse=True)[1]
        passed = np.bincount(pair, high - low)[pair]
        track_length = np.bincount(self.track, self.curve[:, 5])
        follows = passed >= 0.5 * np.minimum(self.size[edges], track_length[track])
        met = _in_both_directions(met.select(follows))
        if len(met) == 0:
            return
        low, high = met.place_range()
        edges, forward = met.edge.astype(np.int64), met.is_forward
        cut_length = np.zeros((3, len(self.edges)))
        for row, counted in enumerate((forward, ~forward, np.ones_like(forward))):
            edge, begin, end = uncovered_edges(
                edges[counted], low[counted], high[counted], self.size
            )
            cut_length[row] = self.size - np.bincount(edge, end - begin, minlength=len(self.edges))
        both = cut_length[0] + cut_length[1] - cut_length[2]
        limit = np.full(len(both), _BOTH_WAYS * self.tolerance)
        if blade and blade.free:
            # At an acute corner the tip of a free blade may be nearer to the other edge.
            limit = np.maximum(limit, _FREE_BOTH_WAYS * self.size)
        for row in np.flatnonzero(both > limit)[:MAX_FINDINGS]:
            message = Message("verify.cut-both-ways", length=both[row])
            self.add_finding("overcut", int(row), message, float(both[row]))

    def _report_short_cuts(
        self, overlaps: Overlaps, solid_rows: I64, ends: KnifeEnds, lead: float
    ) -> I64:
        """Report cuts and stubs that are too short for the blade and are not made, as shortfalls.

        Both ends of such a cut lie inside a panel, and the cut is not longer than ``lead`` (mm),
        the length by which the blade cuts the top face ahead of its tip.  A stub is the last part
        of a longer cut, behind a corner at which the knife is lifted; it is left out if a tip path
        stops at this corner.  A stub within the tolerance is not reported.

        ``overlaps``: overlaps of the tip paths with the edges.
        ``solid_rows``, ``ends``: indices of the cuts and half-cuts in the edges of this check, and
        their planned stops.
        Returns indices of the edges of the reported cuts.
        """
        paths = ends.paths
        is_short = (paths.first >= 0) & (paths.length <= lead + LIMIT_SLACK)
        is_short &= ends.free[paths.first] & ends.free[paths.last]
        is_made = np.zeros(len(self.edges), np.bool_)
        along = overlaps.best & (np.abs(np.diff(overlaps.place)[:, 0]) > SHORT)
        is_made[overlaps.edge[along]] = True
        is_short[paths.path[is_made[solid_rows]]] = False
        short = np.flatnonzero(is_short[paths.path])
        edges: I64 = solid_rows[short]
        np.add.at(self.figures.uncut, self.edges.row[edges], self.size[edges])
        for row in short[:MAX_FINDINGS]:
            edge, length = int(solid_rows[row]), float(paths.length[paths.path[row]])
            message = Message("verify.cut-too-short", length=length, lead=lead)
            size = float(self.size[edge])
            self.add_finding("uncut", edge, message, size, severity=Severity.SHORTFALL)
        return np.concatenate([edges, self._report_stubs(solid_rows, ends, lead)])

    def _report_stubs(self, solid_rows: I64, ends: KnifeEnds, lead: float) -> I64:
        """Report stubs that are left out, as shortfalls; return the indices of their edges.

        The parameters are those of ``_report_short_cuts``.
        """
        left_out = np.flatnonzero((ends.stub_end >= 0) & (self.high[solid_rows] < 0.0))
        edges: I64 = solid_rows[left_out]
        np.add.at(self.figures.uncut, self.edges.row[edges], self.size[edges])
        for end in np.unique(ends.stub_end[left_out])[:MAX_FINDINGS].tolist():
            length = float(ends.setback[end])
            if length <= self.slack:
                continue
            message = Message("verify.stub-too-short", length=length, lead=lead)
            edge = int(solid_rows[end // 2])
            self.add_finding("uncut", edge, message, length, severity=Severity.SHORTFALL)
        return edges

    def _record_faces(self, overlaps: Overlaps, over: F64, top: float, bottom: float) -> None:
        """Record the uncut length of each edge in the bottom face, and its overcut in the top face.

        ``overlaps``: overlaps of the tip paths with the edges.
        ``over`` (t,) mm: length by which each of t tracks runs past the end of its edge.  A track
        is a chain of tip paths between two lifts.
        ``top``, ``bottom`` mm: lengths by which the blade has cut ahead of its tip where a track
        ends: in the top face, and in the bottom face.
        """
        last = np.zeros(len(self.curve), np.bool_)
        last[np.searchsorted(self.track, np.arange(len(over)), side="right") - 1] = True
        work, edge = overlaps.curve, overlaps.edge
        low, high = overlaps.place_range()
        forward = overlaps.is_forward
        overrun_start = self.curve[work, 5] - over[self.track[work]]
        ends = overlaps.best & last[work] & (np.abs(overlaps.along[:, 1] - overrun_start) <= SHORT)
        ends &= np.diff(overlaps.along)[:, 0] > SHORT
        ahead = np.where(ends, bottom + over[self.track[work]], 0.0)
        size = self.size[edge]
        keep = overlaps.best
        uncovered = uncovered_edges(
            edge[keep].astype(np.int64),
            np.where(forward, low, low - ahead)[keep],
            np.where(forward, high + ahead, high)[keep],
            self.size,
        )
        np.add.at(
            self.figures.bottom_uncut, self.edges.row[uncovered[0]], uncovered[2] - uncovered[1]
        )
        short = np.where(forward, size - high, low)
        past = np.where(ends, top + over[self.track[work]] - short, 0.0)
        goes_on = continues_straight(self.edges)[2 * edge.astype(np.int64) + forward]
        past[goes_on] = 0.0
        np.maximum.at(
            self.figures.top_overcut, self.edges.row[edge], np.where(past > SHORT, past, 0.0)
        )

    @property
    def _needs_bridges(self) -> bool:
        """Return whether this check is for cuts through the board, and the board's record or the
        user requires bridges in such cuts.
        """
        wanted = self._board_has_bridges or len(self.context.bridges) > 0
        return self.operation == OperationKind.CUT and wanted

    @property
    def _board_has_bridges(self) -> bool:
        board = self.context.board
        return board.bridge_width > 0.0 and board.bridge_spacing > 0.0

    def _paths_with_bridges(self, solid_edges: Edges, paths: EdgePaths) -> Bool:
        """Return the mask of the paths that must have bridges, (c,).

        If this check needs bridges, these are the closed paths on outer contours; otherwise there
        are none.  ``paths`` are the c paths, and ``solid_edges`` are the edges that form them.
        """
        result = np.zeros(len(paths.length), np.bool_)
        if self._needs_bridges:
            result |= paths.first < 0
            inner = ~find_outlines(solid_edges).outer
            result[paths.path[inner]] = False
        if not self._board_has_bridges:
            hand = find_hand_bridges(self.context, solid_edges, paths)
            result &= hand.paths(len(result))
        return result

    def _tracks_along(self, overlaps: Overlaps, marked: Bool) -> Bool:
        """Return the mask of the t tracks that follow marked edges for more than half of their
        length, (t,).

        A track is a chain of tip paths between two lifts.  ``overlaps`` are the overlaps of the tip
        paths with all n edges; ``marked`` is the mask of the marked edges, (n,).
        """
        count = int(self.track.max(initial=-1)) + 1
        size = np.bincount(self.track, self.curve[:, 5], minlength=count)
        counted = overlaps.best & marked[overlaps.edge]
        along = np.diff(overlaps.along[counted])[:, 0]
        length_along = np.bincount(self.track[overlaps.curve[counted]], along, minlength=count)
        result: Bool = length_along > 0.5 * size
        return result

    def _check_bridge_gaps(
        self,
        overlaps: Overlaps,
        solid_edges: Edges,
        solid_rows: I64,
        paths: EdgePaths,
        required: Bool,
        lead: float,
    ) -> None:
        """Check the width, number and spacing of bridges, and their distance from corners; add
        findings.

        ``overlaps``: overlaps of the tip paths with all edges of this check.
        ``solid_edges``, ``solid_rows``: edges that may have bridges, and the index of each among
        all edges of this check.
        ``paths``: the c paths that the edges ``solid_edges`` form.
        ``required`` (c,): mask of the paths that must have bridges.
        ``lead`` mm: length by which the blade cuts the top face ahead of its tip.
        """
        board = self.context.board
        place = np.full(len(self.edges), -1, np.int32)
        place[solid_rows] = np.arange(len(solid_rows))
        bridges = find_bridges(
            replace(
                overlaps,
                edge=place[overlaps.edge],
                best=overlaps.best & (place[overlaps.edge] >= 0),
            ),
            paths,
            required,
            solid_edges,
            lead,
        )
        edge = paths.locate(bridges.path, bridges.middle, solid_edges.curve)[0]
        np.add.at(
            self.figures.setback,
            solid_edges.row[edge],
            np.minimum(bridges.bare, lead + bridges.width),
        )
        hand = find_hand_bridges(self.context, solid_edges, paths)
        by_board = ~hand.paths(len(required))
        wide = bridges.width - planned_widths(bridges, hand, paths, board)
        np.add.at(self.figures.uncut, solid_edges.row[edge], np.where(wide > self.slack, wide, 0.0))
        automatic = bridges.on_paths(by_board)
        for kind, edge_row, message, measure in chain(
            check_bridges(automatic, paths, solid_edges, required & by_board, board, self.slack),
            check_hand_bridges(bridges, hand, paths, solid_edges, self.slack),
        ):
            self.add_finding(kind, int(solid_rows[edge_row]), message, measure)

    def _remove_leads(self, blade: Knife) -> None:
        """Check the headings on lead-ins and lead-outs, and then remove their tip paths from this
        check.

        A lead-in or lead-out runs through waste, so it matches no edge.  ``blade`` is the knife,
        whose record contains the lengths of its lead-in and lead-out.
        """
        if (blade.lead_in <= 0.0 and blade.lead_out <= 0.0) or len(self.curve) == 0:
            return
        bounds = find_outlines(self.edges.with_types(LineType.CUT))
        cuts = bounds.edges.curve
        nothing, size = np.zeros(len(cuts)), cuts[:, 5]
        keep = np.ones(len(self.curve), np.bool_)
        length = self.curve[:, 5]
        for last, lead in ((False, blade.lead_in), (True, blade.lead_out)):
            order = np.arange(len(length))[:: -1 if last else 1]
            track = self.track[order]
            new = np.ones(len(order), np.bool_)
            new[1:] = track[1:] != track[:-1]
            total = np.cumsum(length[order])
            before = (total - length[order])[new][np.cumsum(new) - 1]
            track_length = total - before
            lead_rows = order[track_length <= lead + self.slack]
            # A lead starts in waste, away from every cut, and ends on an outer cut.
            ends = [point_at(self.curve[lead_rows], np.zeros(len(lead_rows)))]
            ends.append(point_at(self.curve[lead_rows], length[lead_rows]))
            far, near = (ends[1], ends[0]) if last else (ends[0], ends[1])
            on_cut = np.zeros(len(lead_rows), np.bool_)
            on_cut[
                find_overlaps(line_curves(far, far), cuts, nothing, size, self.tolerance).curve
            ] = True
            waste = ~on_cut & (count_enclosing(far, bounds) % 2 == 0)
            meets = np.zeros(len(lead_rows), np.bool_)
            touch = find_overlaps(line_curves(near, near), cuts, nothing, size, self.tolerance)
            meets[touch.curve[bounds.outer[touch.edge]]] = True
            has_full_length = (
                np.abs(track_length[track_length <= lead + self.slack] - lead) <= self.slack
            )
            complete = np.zeros(int(self.track.max()) + 1, np.bool_)
            complete[self.track[lead_rows[has_full_length & meets & waste]]] = True
            bad = np.zeros(len(complete), np.bool_)
            bad[self.track[lead_rows[~waste]]] = True
            led = (complete & ~bad)[self.track[lead_rows]]
            keep[lead_rows[led]] = False
        self._check_lead_headings(np.flatnonzero(~keep), blade)
        self.curve, self.z, self.heading = self.curve[keep], self.z[keep], self.heading[keep]
        self.station, self.line = self.station[keep], self.line[keep]
        self.blend = self.blend[keep]
        self.track = np.unique(self.track[keep], return_inverse=True)[1].astype(np.int64)

    def _check_lead_headings(self, path_rows: I64, blade: Knife) -> None:
        """Add a finding for each lead-in or lead-out on which the blade is not parallel to its
        path.

        A blade turned across its path tears the board.  ``path_rows`` are the indices of the tip
        paths of lead-ins and lead-outs.
        """
        error = np.zeros(len(path_rows))
        for side, along in enumerate((np.zeros(len(path_rows)), self.curve[path_rows, 5])):
            own = azimuth_at(self.curve[path_rows], along)
            error = np.maximum(error, angle_between(self.heading[path_rows, side], own))
        reach = np.full(len(path_rows), 0.0 if blade.free else blade.blade_width)
        self.check_swing(
            error, reach, np.zeros(len(path_rows)), path_rows, np.full(len(path_rows), -1)
        )


def _in_both_directions(overlaps: Overlaps) -> Overlaps:
    """Return those overlaps of tip paths with edges whose edge has overlaps in both directions."""
    ways = np.zeros((2, int(overlaps.edge.max(initial=-1)) + 1), np.bool_)
    ways[overlaps.is_forward.astype(np.int64), overlaps.edge] = True
    both = ways[0] & ways[1]
    return overlaps.select(both[overlaps.edge])
