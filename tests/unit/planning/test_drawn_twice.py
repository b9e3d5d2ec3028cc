"""Cuts that are drawn twice, which a cutter cannot make: the answer is to ignore the copies."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import PlanError
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.planning.drawn_twice import find_copies
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

OUTLINE = closed((0, 0), (300, 0), (300, 200), (0, 200))
CIRCLE = edges(((130, 100), (170, 100)), ((170, 100), (130, 100)))


def polygon(count: int, radius: float = 20.0, turn: float = 0.0) -> F64:
    angles = [turn + 2.0 * math.pi * k / count for k in range(count)]
    return closed(*((150 + radius * math.cos(a), 100 + radius * math.sin(a)) for a in angles))


def lines_of(*cuts: F64) -> Dieline:
    """Return cuts, of which a pair of edges between the ends of ``CIRCLE`` is the circle."""
    lines = dieline(*((LineType.CUT, cut) for cut in cuts))
    round_edges = [
        row
        for row, ends in enumerate(lines.ends)
        if any(np.array_equal(ends, one) for one in CIRCLE)
    ]
    return dieline(*((LineType.CUT, cut) for cut in cuts), bulge=dict.fromkeys(round_edges, 1.0))


def compile_cuts(lines: Dieline, ignored: list[int]) -> bool:
    """Return whether a router accepts cuts of which some are ignored."""
    line_type = lines.line_type.copy()
    line_type[ignored] = LineType.IGNORED
    drawn = drawing(lines.ends, [("0", 7, "CONTINUOUS")] * len(lines), bulge=lines.bulge)
    typed = replace(lines, line_type=line_type)
    made = pipeline.compile(drawn, typed, load.machine("router-table"), load.board("greyboard-2.0"))
    return made.verdict.accepted


@pytest.mark.parametrize(
    "cuts",
    [
        (OUTLINE, CIRCLE, polygon(24)),  # in a hole, touching it at the corners
        (OUTLINE, polygon(12), CIRCLE),  # drawn before the circle
        (CIRCLE, polygon(24)),  # in a disc
        (OUTLINE, CIRCLE, polygon(24, 20.04)),  # across the circle
        (OUTLINE, OUTLINE + 0.05),  # an outline twice, a little apart
        (OUTLINE, OUTLINE + 0.5),
    ],
)
def test_who_ignores_the_copies_has_an_accepted_program(cuts: tuple[F64, ...]) -> None:
    lines = lines_of(*cuts)
    with pytest.raises(PlanError) as caught:
        compile_cuts(lines, [])
    message = caught.value.message
    assert message.code == "error.at-edge"
    assert message.arguments["error"].code == "milling.drawn-twice"
    handles = [f"{row:X}" for row in range(len(lines))]
    copies = [handles.index(handle) for handle in caught.value.source]
    assert len(copies) == message.arguments["error"].arguments["count"]
    assert not set(copies) & {row for row in range(len(lines)) if lines.bulge[row]}
    assert compile_cuts(lines, copies)


def test_parts_that_share_an_edge_are_not_drawn_twice() -> None:
    inside = closed((100, 60), (200, 60), (200, 140), (100, 140))
    with pytest.raises(PlanError) as caught:
        # Farther from the outline than the board is thick.
        compile_cuts(lines_of(OUTLINE, OUTLINE + 2.5, inside), [])
    assert caught.value.message.arguments["error"].code == "milling.contours-cross"


def test_a_side_without_which_a_contour_is_open_is_no_copy() -> None:
    # Between two parts with a common side there is a recess, 0.5 mm wide.
    left = closed((0, 0), (100, 0), (100, 100), (0, 100))
    right = closed((100, 0), (200, 0), (200, 100), (110, 100), (100.5, 80), (100.5, 60), (100, 60))
    with pytest.raises(PlanError) as caught:
        compile_cuts(lines_of(left, right), [])
    assert caught.value.message.arguments["error"].code == "milling.shared-edge"


def test_the_shorter_line_is_the_copy_and_of_equal_lines_the_later_one() -> None:
    ends = edges(
        ((0, 0), (100, 0)), ((10, 0.3), (60, 0.3)), ((0, 5), (100, 5)), ((0, 5.1), (100, 5.1))
    )
    copies = find_copies(ends, np.zeros(4), 1.0)
    assert copies.row.tolist() == [1, 3]
    assert copies.beside.tolist() == [0, 2]
    assert copies.distance.tolist() == pytest.approx([0.3, 0.1])


def test_lines_that_cross_lie_not_beside_each_other() -> None:
    ends = edges(((0, 0), (1, 0)), ((0.5, -0.4), (0.5, 0.4)))
    assert len(find_copies(ends, np.zeros(2), 2.0).row) == 0
