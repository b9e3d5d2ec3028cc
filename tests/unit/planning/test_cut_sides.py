"""Which cuts bound a part, and on which side the waste lies."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.planning.cut_sides import cut_sides
from tests.support.shapes import closed, edges, rotation

OUTLINE = edges(
    ((0, 0), (100, 0)), ((100, 0), (100, 50)), ((100, 50), (100, 100)),
    ((100, 100), (0, 100)), ((0, 100), (0, 0)),
)  # fmt: skip
SLIT = edges(((100, 50), (80, 50)))
HOLE = closed((20, 20), (20, 30), (30, 30), (30, 20))
NEIGHBOUR = closed((200, 0), (300, 0), (300, 100), (200, 100))
SHEET = np.concatenate([OUTLINE, SLIT, HOLE, NEIGHBOUR])
EXPECTED = np.array([True] * 5 + [False] * 5 + [True] * 4)


def test_only_outlines_bound_parts() -> None:
    np.testing.assert_array_equal(cut_sides(SHEET, np.zeros(len(SHEET))).waste != 0, EXPECTED)


@given(seed=st.integers(0, 1000), degrees=st.floats(0, 360))
def test_order_direction_and_turn_do_not_matter(seed: int, degrees: float) -> None:
    random = np.random.default_rng(seed)
    order = random.permutation(len(SHEET))
    turned = (SHEET @ rotation(degrees).T)[order]
    backwards = random.random(len(SHEET)) < 0.5
    turned[backwards] = turned[backwards][:, ::-1]
    np.testing.assert_array_equal(
        cut_sides(turned, np.zeros(len(SHEET))).waste != 0, EXPECTED[order]
    )


@given(degrees=st.floats(0, 360), backwards=st.booleans())
def test_the_waste_is_on_the_right_of_a_counter_clockwise_outline(
    degrees: float, backwards: bool
) -> None:
    turned = OUTLINE @ rotation(degrees).T
    side = cut_sides(turned[:, ::-1] if backwards else turned, np.zeros(5)).waste
    assert side.tolist() == [1 if backwards else -1] * 5


def test_only_the_outer_of_two_circles_bounds_a_part() -> None:
    circles = edges(((0, 0), (20, 0)), ((20, 0), (0, 0)), ((5, 0), (9, 0)), ((9, 0), (5, 0)))
    assert (cut_sides(circles, np.ones(4)).waste != 0).tolist() == [True, True, False, False]


@pytest.mark.parametrize("overlap", [0.0, 0.0003, 0.009, 0.04])
def test_round_parts_that_touch_are_not_inside_each_other(overlap: float) -> None:
    # The lowest point of the upper circle lies on the lower circle, or inside it by rounding.
    circles = edges(
        ((0, 0), (20, 0)), ((20, 0), (0, 0)),
        ((0, 20 - overlap), (20, 20 - overlap)), ((20, 20 - overlap), (0, 20 - overlap)),
    )  # fmt: skip
    assert (cut_sides(circles, np.ones(4)).waste != 0).all()


@pytest.mark.parametrize("distance", [0.0003, 0.01, 0.04])
def test_a_circle_above_the_lowest_point_of_another_is_inside_it(distance: float) -> None:
    y = distance - 5.0
    circles = edges(((0, 0), (20, 0)), ((20, 0), (0, 0)), ((5, y), (15, y)), ((15, y), (5, y)))
    assert (cut_sides(circles, np.ones(4)).waste != 0).tolist() == [True, True, False, False]


def test_a_slit_bounds_no_part() -> None:
    assert (cut_sides(SLIT, np.zeros(1)).waste != 0).tolist() == [False]


def test_a_line_between_two_parts_has_no_waste_side() -> None:
    cells = np.concatenate([OUTLINE, edges(((100, 50), (0, 100)))])
    assert (cut_sides(cells, np.zeros(6)).waste != 0).tolist() == [True] * 5 + [False]


def test_no_board_lies_around_a_part_and_in_a_hole() -> None:
    removed = cut_sides(SHEET, np.zeros(len(SHEET))).removed
    # The outlines run counter-clockwise, the hole clockwise: the board is on the left of each.
    assert removed.tolist() == [-1] * 5 + [0] + [-1] * 4 + [-1] * 4


@pytest.mark.parametrize("degrees", [0.0, 90.0, 180.0, 233.0])
def test_a_slit_that_reaches_into_another_part_does_not_move_its_own_part_inside(
    degrees: float,
) -> None:
    upper = closed((0, 10), (50, 10), (50, 40), (0, 40))
    tail = edges(((0, 10), (0, -0.1)))
    lower = closed((-5, -20), (60, -20), (60, 0), (-5, 0))
    cuts = np.concatenate([upper, tail, lower]) @ rotation(degrees).T
    waste = cut_sides(cuts, np.zeros(len(cuts))).waste != 0
    assert waste.tolist() == [True] * 4 + [False] + [True] * 4
