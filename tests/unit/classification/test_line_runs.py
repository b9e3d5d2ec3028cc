"""Lines in many pieces are examined as whole lines."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from knifetip.classification.shape.line_runs import join_runs
from knifetip.geometry.columns import F64, I64
from knifetip.model.drawing import Drawing
from tests.support.cartons.rewritings import in_pieces, mirrored, turned
from tests.support.classification import BLANK, Line, classified, drawing_of, style

#: 300 × 200 mm with two folds, a slot at the first, and a flap whose fold continues its side.
CARTON: list[Line] = [
    *BLANK, (100, 80, 103, 80), (103, 80, 103, 120), (103, 120, 100, 120),
    (0, 200, 0, 240), (0, 240, 100, 240), (100, 240, 100, 200),
]  # fmt: skip


def pieces(start: tuple[float, float], end: tuple[float, float], count: int) -> F64:
    points = np.linspace(start, end, count + 1)
    return np.stack([points[:-1], points[1:]], axis=1)


def rows(*runs: F64, styles: list[int] | None = None) -> list[int]:
    """Return the line of each piece; all pieces have one style if no styles are given."""
    ends = np.concatenate(runs)
    style: I64 = np.zeros(len(ends), np.int64) if styles is None else np.array(styles, np.int64)
    joined = join_runs(ends, np.zeros(len(ends)), style)
    return list(range(len(ends))) if joined is None else joined.row.tolist()


def test_equal_pieces_are_one_line() -> None:
    run = pieces((10, 5), (40, 25), 12)
    joined = join_runs(run, np.zeros(12), np.zeros(12, np.int64))
    assert joined is not None
    np.testing.assert_allclose(joined.ends, [[[10, 5], [40, 25]]])
    assert joined.row.tolist() == [0] * 12


def test_the_last_piece_may_be_shorter() -> None:
    rest = np.array([[[30.0, 0.0], [31.0, 0.0]]])
    assert rows(pieces((0, 0), (30, 0), 10), rest) == [0] * 11


def test_a_corner_a_gap_or_another_style_begins_a_new_line() -> None:
    one = pieces((0, 0), (30, 0), 10)
    assert rows(one, pieces((30, 0), (30, 30), 10)) == [0] * 10 + [1] * 10
    assert rows(one, pieces((31, 0), (61, 0), 10)) == [0] * 10 + [1] * 10
    onward = pieces((30, 0), (60, 0), 10)
    assert rows(one, onward, styles=[0] * 10 + [1] * 10) == [0] * 10 + [1] * 10


def test_a_line_that_ends_at_another_begins_a_new_line() -> None:
    """A fold that continues as the side of a flap, where a line across ends."""
    straight = pieces((0, 0), (60, 0), 20)
    across = pieces((30, 0), (30, 30), 10)
    assert rows(straight, across) == [0] * 10 + [1] * 10 + [2] * 10


def test_four_equal_lines_remain_four_lines() -> None:
    assert rows(pieces((0, 0), (400, 0), 4)) == [0, 1, 2, 3]


def test_pieces_of_an_arc_are_one_arc_and_those_of_a_polygon_remain_lines() -> None:
    angles = np.linspace(0.0, math.pi / 2, 11)
    points = 50.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    ends, style = np.stack([points[:-1], points[1:]], axis=1), np.zeros(10, np.int64)
    joined = join_runs(ends, np.full(10, math.tan(math.pi / 80)), style)
    assert joined is not None
    assert joined.bulge.tolist() == pytest.approx([math.tan(math.pi / 8)])
    assert join_runs(ends, np.zeros(10), style) is None


@pytest.mark.parametrize("colours", [False, True])
def test_a_carton_in_pieces_turned_or_mirrored_gets_the_same_line_types(colours: bool) -> None:
    sheet = drawing_of((CARTON, style()))
    if colours:
        colour = sheet.colour.copy()
        colour[4:6] = 1
        sheet = replace(sheet, colour=colour)
    expected = classified(sheet).line_type
    for rewritten, row in (in_pieces(sheet, 3.0), turned(sheet, 17.0), mirrored(sheet)):
        assert classified(rewritten).line_type.tolist() == expected[row].tolist()


def test_the_edges_in_pieces_remain_edges() -> None:
    sheet = drawing_of((CARTON, style()))
    rewritten: Drawing = in_pieces(sheet, 3.0)[0]
    assert len(classified(rewritten)) == len(rewritten) > 500
