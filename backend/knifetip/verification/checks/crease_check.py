"""Check the creases that a wheel makes.

A crease's planned start and end depend on the wheel's contact length, the board's end clearance
and the cuts that cross the crease.
"""

from __future__ import annotations

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import CreaseWheel
from knifetip.verification.checks.check_base import StationCheck
from knifetip.verification.checks.check_context import CURVED_DEPTH_TOLERANCE
from knifetip.verification.checks.stray_work import check_stray_work
from knifetip.verification.columns import F64, I32
from knifetip.verification.expectation.crease_depth import depth_range
from knifetip.verification.expectation.crease_lines import (
    concatenate_edges,
    creased_gaps,
    double_lines,
    ends_at,
    split_at_cuts,
)
from knifetip.verification.expectation.expected_work import WORKED_TYPES, expected_creases
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.tools import OperationKind


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
        )
        single, crossings = split_at_cuts(
            concatenate_edges(self.edges, between), self.context.edges.with_types(LineType.CUT)
        )
        all_creases, _ = split_at_cuts(
            concatenate_edges(all_creases, between), self.context.edges.with_types(LineType.CUT)
        )
        parts = ends_at(single, crossings)
        many = 2 if pair > 0.0 else 1
        if pair > 0.0:
            single, all_creases, parts = (
                double_lines(single, pair),
                double_lines(all_creases, pair),
                np.tile(parts, 2),
            )
        self.set_edges(single)
        expected = expected_creases(self.edges, self.context.board, wheel, all_creases, parts)
        self.low, self.high, self.depth = expected.low, expected.high, expected.press_depth
        self.depth_tolerance[self.edges.curve[:, 0] != 0.0] = CURVED_DEPTH_TOLERANCE
        for edge in np.flatnonzero(expected.refused)[:MAX_FINDINGS]:
            self.add_finding("uncut", edge, Message("verify.crease-too-short"), self.size[edge])
        overlaps = self.match_edges()
        self.check_position(overlaps)
        check_stray_work(self, overlaps, self.curve[:, 5])
        planned = np.maximum(self.high - self.low, 0.0)
        np.add.at(self.figures.setback, self.edges.row, (self.size - planned) / many)
        self.check_uncut(overlaps, np.arange(len(self.edges)))
        depth = np.maximum(self.context.board.caliper - self.z, 0.0)
        contact = np.sqrt(np.maximum(depth * (2.0 * wheel.radius - depth), 0.0))
        self.check_heading(overlaps, contact, 180.0)

    def planned_depths(self, edge: I32, place: F64) -> tuple[F64, F64]:
        """Return the least and the greatest planned depth of the wheel along k stretches, (k,) mm
        each.

        The depth changes with the direction of the tangent.  A crease that is pressed at one point
        has one depth; ``edge`` and ``place`` are as in the base class.
        """
        lowest, highest = depth_range(self.edges.curve[edge], place, self.context.board)
        press = self.depth[edge]
        is_pressed = np.isfinite(press)
        return np.where(is_pressed, press, lowest), np.where(is_pressed, press, highest)
