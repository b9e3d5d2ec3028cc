"""Check the creases that a wheel makes.

A crease's planned start and end depend on the wheel's contact length, the board's end clearance
and the cuts that cross the crease.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.job_options import CreaseDepth
from knifetip.model.tool import CreaseWheel
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.checks.common.context import CURVED_DEPTH_TOLERANCE
from knifetip.verification.checks.common.stray_work import check_stray_work
from knifetip.verification.checks.crease.bends import check_bends
from knifetip.verification.columns import F64, I32, Bool
from knifetip.verification.curves.curve import azimuth_at
from knifetip.verification.curves.intervals import Overlaps, mark_nearest
from knifetip.verification.expectation.crease_depth import depth_range, with_chosen
from knifetip.verification.expectation.crease_lines import (
    concatenate_edges,
    creased_gaps,
    double_lines,
    split_at_cuts,
    split_ends,
)
from knifetip.verification.expectation.edges import (
    STRAIGHT_ANGLE,
    TOUCH_DISTANCE,
    Edges,
    angle_between,
    pairs_within,
)
from knifetip.verification.expectation.expected_work import (
    WORKED_TYPES,
    expected_creases,
    stop_distance,
)
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.tools import OperationKind

#: Paths that are shorter are points at which the wheel presses (mm).
_POINT: Final = 1e-6


class CreaseCheck(StationCheck):
    """Check that compares the paths of a crease wheel with the creases of the dieline."""

    def check(self) -> None:
        wheel = self.tool(CreaseWheel)
        if wheel is None:
            self.check_uncut(self.match_edges(), np.arange(len(self.edges)))
            return
        all_creases = self.context.edges.with_types(*WORKED_TYPES[OperationKind.CREASE])
        pair = self.context.board.double_crease
        between = creased_gaps(
            self.edges,
            self.context.edges.with_types(LineType.CUT),
            self.curve,
            0.5 * pair + self.tolerance,
            stop_distance(self.edges, self.context.board, wheel, self._chosen_depths(self.edges)),
        )
        single, crossings = split_at_cuts(
            concatenate_edges(self.edges, between), self.context.edges.with_types(LineType.CUT)
        )
        if all_creases is self.edges:
            all_creases = single
        else:
            all_creases, _ = split_at_cuts(
                concatenate_edges(all_creases, between), self.context.edges.with_types(LineType.CUT)
            )
        parts = split_ends(single, crossings)
        self._note_junctions(single, crossings.points)
        many = 2 if pair > 0.0 else 1
        if pair > 0.0:
            single, all_creases, parts = (
                double_lines(single, pair),
                double_lines(all_creases, pair),
                np.tile(parts, 2),
            )
        self.set_edges(single)
        chosen = self._chosen_depths(self.edges)
        expected = expected_creases(
            self.edges, self.context.board, wheel, all_creases, parts, chosen
        )
        self.low, self.high, self.depth = expected.low, expected.high, expected.press_depth
        curved = self.edges.curve[:, 0] != 0.0
        self.depth_tolerance[curved] = CURVED_DEPTH_TOLERANCE + self.context.height_resolution
        self._report_short_creases(expected.refused & ~self._are_overshoots(parts), wheel)
        self._note_stops(parts)
        overlaps = self._drop_crossings(self.match_edges(), expected.pressed)
        self.check_position(overlaps)
        check_stray_work(self, overlaps, self.curve[:, 5])
        planned = np.maximum(self.high - self.low, 0.0)
        np.add.at(self.figures.setback, self.edges.row, (self.size - planned) / many)
        self.check_uncut(overlaps, np.arange(len(self.edges)))
        depth = np.maximum(self.context.board.caliper - self.z, 0.0)
        contact = np.sqrt(np.maximum(depth * (2.0 * wheel.radius - depth), 0.0))
        self.check_heading(overlaps, contact, 180.0)
        check_bends(self, overlaps, all_creases, contact, wheel)

    def _chosen_depths(self, edges: Edges) -> F64:
        """Return the depths that the user has chosen for n creases, (n,) mm; NaN for none."""
        if CreaseDepth not in self.context.chosen:
            return np.full(len(edges), np.nan)
        return self.context.chosen[CreaseDepth].numbers("depth", np.nan)[edges.row]

    def _drop_crossings(self, overlaps: Overlaps, pressed: Bool) -> Overlaps:
        """Return the overlaps without those of presses that only cross another crease.

        The wheel presses a short crease at one point.  If other creases pass this point, the press
        makes the short crease in the direction of the wheel.

        ``overlaps``: overlaps of the tip paths with the n creases.
        ``pressed`` (n,): mask of the creases that are pressed at one point.
        """
        rows = np.flatnonzero(self.curve[overlaps.curve, 5] < _POINT)
        rows = rows[pressed[overlaps.edge[rows]]]
        if len(rows) == 0:
            return overlaps
        work, edge = overlaps.curve[rows], overlaps.edge[rows]
        turn = np.full(len(overlaps.curve), np.inf)
        turn[rows] = angle_between(
            self.heading[work, 0],
            azimuth_at(self.edges.curve[edge], overlaps.place[rows, 0]),
            180.0,
        )
        least = np.full(len(self.curve), np.inf)
        np.minimum.at(least, work, turn[rows])
        keep = np.isinf(least[overlaps.curve]) | (turn <= least[overlaps.curve] + STRAIGHT_ANGLE)
        return mark_nearest(overlaps.select(keep), self.curve, self.curve[:, 5].copy())

    def _report_short_creases(self, refused: Bool, wheel: CreaseWheel) -> None:
        """Report the creases that are too short for the wheel, ``refused`` (n,), as shortfalls."""
        for edge in np.flatnonzero(refused)[:MAX_FINDINGS]:
            message = Message(
                "verify.crease-too-short",
                length=self.size[edge],
                radius=wheel.radius,
                clearance=self.context.board.end_clearance,
            )
            size = float(self.size[edge])
            self.add_finding("uncut", edge, message, size, severity=Severity.SHORTFALL)

    def _are_overshoots(self, split_ends: Bool) -> Bool:
        """Return the mask of the n creases that end behind a cut, by no more than the board is
        thick.

        What the wheel leaves out there is less than what it leaves out before the cut, of which
        ``_note_stops`` adds a note.  ``split_ends`` (2n,) is the mask that it gets.
        """
        behind = split_ends[::2] | split_ends[1::2]
        return behind & (self.size <= self.context.board.caliper)

    def _note_stops(self, split_ends: Bool) -> None:
        """Add a note if the wheel stops at cuts that cross creases.

        ``split_ends`` is the mask of the ends at which a cut splits a crease, (2n,): end 2i is the
        start of edge i, and end 2i + 1 is its end.
        """
        ends = np.flatnonzero(split_ends)
        points = self.edges.ends[ends]
        one, other = (ends[pair] for pair in pairs_within(points, points, TOUCH_DISTANCE))
        outward = self.edges.outward
        # A crease that only ends on the cut has no counterpart beyond the cut.
        beyond = angle_between(outward[one], outward[other] + 180.0) <= STRAIGHT_ANGLE
        stopped = one[beyond & (one != other)]
        if len(stopped):
            edge, at_end = stopped // 2, stopped % 2 == 1
            distance = np.where(at_end, self.size[edge] - self.high[edge], self.low[edge])
            # An edge on which the wheel does no work is short over its whole length.
            distance = np.where(self.high[edge] < self.low[edge], self.size[edge], distance)
            most, count = float(distance.max()), len(np.unique(self.edges.row[edge]))
            message = Message("verify.crease-stops-at-cut", count=count, distance=most)
            self.findings.add("planned", message, most, severity=Severity.NOTE)

    def _note_junctions(self, creases: Edges, crossings: F64) -> None:
        """Add a note if cuts end on creases, between the ends of the crease and from one side.

        The wheel passes such an end.  ``creases`` are the drawn creases, split at the points
        ``crossings``, (k, 2) mm, at which cuts cross them.
        """
        points, size = self.context.edges.with_types(LineType.CUT).ends, creases.curve[:, 5]
        met = creases.touched_by_points(points, TOUCH_DISTANCE)
        place = met.place.mean(axis=1)
        inner = (place > TOUCH_DISTANCE) & (place < size[met.edge] - TOUCH_DISTANCE)
        inner[pairs_within(points[met.curve], crossings, 2.0 * TOUCH_DISTANCE)[0]] = False
        count = len(np.unique(creases.row[met.edge[inner]]))
        if count:
            message = Message("verify.crease-meets-cuts", count=count)
            self.findings.add("planned", message, 0.0, severity=Severity.NOTE)

    def planned_depths(self, edge: I32, place: F64) -> tuple[F64, F64]:
        """Return the least and the greatest planned depth of the wheel along k stretches, (k,) mm
        each.

        The depth changes with the direction of the tangent.  A crease that is pressed at one point
        has one depth; ``edge`` and ``place`` are as in the base class.
        """
        lowest, highest = depth_range(self.edges.curve[edge], place, self.context.board)
        chosen = self._chosen_depths(self.edges)[edge]
        lowest, highest = with_chosen(lowest, chosen), with_chosen(highest, chosen)
        press = self.depth[edge]
        is_pressed = np.isfinite(press)
        return np.where(is_pressed, press, lowest), np.where(is_pressed, press, highest)
