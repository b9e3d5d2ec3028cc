"""When each piece of a cut is begun and complete."""

from __future__ import annotations

import math

import numpy as np
import pytest

from knifetip.verification.checks.order.cut_faces import CutFaces, find_cut_faces
from knifetip.verification.checks.order.worked_spans import (
    WorkedSpans,
    completing_lines,
    first_lines,
    new_spans,
)
from knifetip.verification.expectation.edges import place_edges
from tests.support.programs.handwritten import CUT, dieline

#: A square that a cut at X10 divides; pieces 0 and 1 are those of its first side.
SQUARE = dieline(
    (CUT, 0, 0, 40, 0, 0.0), (CUT, 40, 0, 40, 40, 0.0), (CUT, 40, 40, 0, 40, 0.0),
    (CUT, 0, 40, 0, 0, 0.0), (CUT, 10, -10, 10, 50, 0.0),
)  # fmt: skip
#: Start and end of a stretch of the first side (mm), its program line, and whether it goes through
#: the board.
Span = tuple[float, float, int, bool]


def faces_of_square() -> CutFaces:
    faces = find_cut_faces(place_edges(SQUARE, (0.0, 0.0)))
    assert faces.edge[:2].tolist() == [0, 0]
    assert faces.begin[:2].tolist() == [0.0, 10.0]
    return faces


def spans_of(*spans: Span, reach: float = 0.0) -> WorkedSpans:
    low, high, line, through = zip(*spans, strict=True)
    rows = np.arange(len(spans))
    return WorkedSpans(
        np.zeros(len(spans), np.int64), np.array(low, np.float64), np.array(high, np.float64),
        np.array(line), np.array(through), np.array(high, np.float64) - low, rows, reach,
    )  # fmt: skip


def completed(*spans: Span, reach: float = 0.0, rest: float = 0.3) -> tuple[float, float]:
    """Return the program lines that complete the two pieces of the first side."""
    lines = completing_lines(faces_of_square(), spans_of(*spans, reach=reach), 5, rest)
    return float(lines[0]), float(lines[1])


def begun(*spans: Span) -> tuple[float, float]:
    """Return the program lines that begin the two pieces of the first side."""
    lines = first_lines(faces_of_square(), spans_of(*spans), 5)
    return float(lines[0]), float(lines[1])


def test_a_piece_is_complete_when_no_long_rest_is_left() -> None:
    assert completed((0, 40, 7, True)) == (7, 7)
    assert completed((0, 9.8, 7, True), (10.4, 40, 8, True)) == (7, math.inf)
    assert completed((0, 4, 5, True), (4.2, 9.8, 6, True), (10.2, 40, 8, True)) == (6, 8)
    # Two rests of 0.29 mm each are short.
    assert completed((0.29, 9.71, 5, True)) == (5, math.inf)


def test_a_rest_of_half_a_short_piece_holds_the_part() -> None:
    assert completed((0, 4, 5, True), rest=30.0) == (math.inf, math.inf)
    assert completed((0, 5, 5, True), (11, 40, 6, True), rest=30.0) == (5, 6)


def test_a_cut_that_does_not_go_through_the_board_completes_nothing() -> None:
    assert completed((0, 40, 5, False)) == (math.inf, math.inf)
    assert completed((0, 40, 5, False), (0, 40, 9, True)) == (9, 9)


def test_a_cutter_leaves_corners_and_cuts_out_of_its_reach() -> None:
    # 4 radii of 2 mm beside a corner stay untouched, and so do cuts that it does not reach at all.
    assert completed((7.9, 10, 5, True), reach=2.0) == (5, 0)
    assert completed((8.1, 10, 5, True), reach=2.0) == (math.inf, 0)
    assert completed((7.9, 10, 5, True)) == (math.inf, math.inf)


@pytest.mark.parametrize(("end", "second"), [(10.35, math.inf), (12.0, 5)])
def test_the_overrun_of_a_knife_begins_no_cut(end: float, second: float) -> None:
    assert begun((0, end, 5, True)) == (5, second)


def test_a_repetition_covers_at_least_half_of_what_was_cut_before() -> None:
    assert is_new((0, 10, 1, True), (0, 10, 2, True), (5, 15, 3, True), (9, 19, 4, True)) == [
        True, False, True, False,
    ]  # fmt: skip


def test_a_cut_that_is_not_through_the_board_is_made_again_by_the_next_pass() -> None:
    assert is_new((0, 10, 1, False), (0, 10, 2, True)) == [True, True]
    assert is_new((0, 10, 1, True), (0, 10, 2, False), (4, 20, 3, True)) == [True, False, True]


def is_new(*spans: Span) -> list[bool]:
    made = spans_of(*spans)
    fresh: list[bool] = new_spans(made.edge, made.low, made.high, made.through).tolist()
    return fresh
