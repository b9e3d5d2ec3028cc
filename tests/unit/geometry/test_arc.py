"""Arcs with bulges, compared with circles computed by hand and with sampled points."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from knifetip.geometry import arc

#: Quarter of a circle of radius 10 around the origin, from (10, 0) to (0, 10).
QUARTER = (np.array([[10.0, 0.0]]), np.array([[0.0, 10.0]]), np.tan([np.pi / 8]))
#: Half of that circle, from (10, 0) through (0, 10) to (-10, 0).
HALF = (np.array([[10.0, 0.0]]), np.array([[-10.0, 0.0]]), np.array([1.0]))
LINE = (np.array([[1.0, 2.0]]), np.array([[4.0, 6.0]]), np.array([0.0]))

places = st.floats(-1000.0, 1000.0)
bulges = st.floats(-1.0, 1.0)


def test_quarter_turn_has_its_centre_at_the_origin_and_radius_10() -> None:
    assert_allclose(arc.centre(*QUARTER), [[0.0, 0.0]], atol=1e-14)
    assert_allclose(arc.radius(*QUARTER), [10.0])
    assert_allclose(arc.sweep(QUARTER[2]), [np.pi / 2])
    assert_allclose(arc.length(*QUARTER), [5.0 * np.pi])


def test_half_turn_is_as_long_as_pi_times_its_radius() -> None:
    assert_allclose(arc.length(*HALF), [10.0 * np.pi])
    assert_allclose(arc.centre(*HALF), [[0.0, 0.0]], atol=1e-14)


def test_line_has_its_chord_for_length_no_centre_and_no_radius() -> None:
    assert_array_equal(arc.length(*LINE), [5.0])
    assert np.isnan(arc.centre(*LINE)).all()
    assert_array_equal(arc.radius(*LINE), [np.inf])


def test_negative_bulge_turns_right() -> None:
    start, end, bulge = QUARTER
    assert_allclose(arc.centre(start, end, -bulge), [[10.0, 10.0]], atol=1e-14)
    assert arc.sweep(-bulge)[0] < 0.0


def test_tangents_of_a_quarter_turn_are_north_then_west() -> None:
    at_start, at_end = arc.tangents(*QUARTER)
    assert_allclose(at_start / np.hypot(*at_start.T), [[0.0, 1.0]], atol=1e-14)
    assert_allclose(at_end / np.hypot(*at_end.T), [[-1.0, 0.0]], atol=1e-14)


def test_middle_of_a_half_turn_is_its_top() -> None:
    assert_allclose(arc.point_at(*HALF, np.array([0.5])), [[0.0, 10.0]], atol=1e-14)


def test_part_of_a_half_turn_is_on_the_same_circle() -> None:
    start, end, bulge = arc.sub_arc(*HALF, np.array([0.25]), np.array([0.75]))
    root = 10.0 * np.sqrt(0.5)
    assert_allclose(start, [[root, root]], atol=1e-13)
    assert_allclose(end, [[-root, root]], atol=1e-13)
    assert_allclose(arc.sweep(bulge), [np.pi / 2])
    assert_allclose(arc.centre(start, end, bulge), [[0.0, 0.0]], atol=1e-13)


def test_part_of_more_than_half_a_turn_halves_it() -> None:
    # Three quarters of a circle of radius 10: bulge tan(67.5°).
    start, end, bulge = (
        np.array([[10.0, 0.0]]),
        np.array([[0.0, -10.0]]),
        np.tan([np.radians(67.5)]),
    )
    top = arc.point_at(start, end, bulge, np.array([0.5]))
    assert_allclose(top, [[-np.sqrt(50.0), np.sqrt(50.0)]], atol=1e-13)


def test_box_of_a_half_turn_contains_its_middle() -> None:
    assert_allclose(arc.bounding_boxes(*HALF), [[-10.0, 0.0, 10.0, 10.0]], atol=1e-13)


def test_box_of_a_half_turn_to_the_right_is_below_the_chord() -> None:
    start, end, bulge = HALF
    assert_allclose(arc.bounding_boxes(start, end, -bulge), [[-10.0, -10.0, 10.0, 0.0]], atol=1e-13)


def test_lines_and_arcs_may_be_mixed() -> None:
    start, end, bulge = (np.concatenate(pair) for pair in zip(QUARTER, LINE, strict=True))
    assert_allclose(arc.length(start, end, bulge), [5.0 * np.pi, 5.0])
    assert_allclose(
        arc.bounding_boxes(start, end, bulge), [[0, 0, 10, 10], [1, 2, 4, 6]], atol=1e-13
    )


def test_no_segments_give_empty_results() -> None:
    nothing = (np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0))
    assert arc.length(*nothing).shape == (0,)
    assert arc.bounding_boxes(*nothing).shape == (0, 4)
    assert arc.centre(*nothing).shape == (0, 2)


@given(places, places, places, places, bulges)
def test_points_along_an_arc_are_in_its_box_and_add_up_to_its_length(
    x1: float, y1: float, x2: float, y2: float, bulge: float
) -> None:
    start, end, b = np.array([[x1, y1]]), np.array([[x2, y2]]), np.array([bulge])
    walk = np.concatenate(
        [arc.point_at(start, end, b, np.array([f])) for f in np.linspace(0.0, 1.0, 201)]
    )
    low_x, low_y, high_x, high_y = arc.bounding_boxes(start, end, b)[0]
    assert (walk >= [low_x - 1e-6, low_y - 1e-6]).all()
    assert (walk <= [high_x + 1e-6, high_y + 1e-6]).all()
    # The box is tight: some point is near each side.
    slack = 1e-3 * arc.length(start, end, b)[0] + 1e-6
    assert_allclose(walk.min(axis=0), [low_x, low_y], atol=slack)
    assert_allclose(walk.max(axis=0), [high_x, high_y], atol=slack)
    stretch = np.hypot(*np.diff(walk, axis=0).T).sum()
    assert stretch == pytest.approx(arc.length(start, end, b)[0], rel=1e-4, abs=1e-9)


@given(places, places, places, places, bulges)
def test_a_reversed_arc_has_the_same_points(
    x1: float, y1: float, x2: float, y2: float, bulge: float
) -> None:
    start, end, b = np.array([[x1, y1]]), np.array([[x2, y2]]), np.array([bulge])
    third = np.array([1.0 / 3.0])
    assert_allclose(
        arc.point_at(start, end, b, third), arc.point_at(end, start, -b, 1.0 - third), atol=1e-9
    )
    assert_allclose(
        arc.bounding_boxes(start, end, b), arc.bounding_boxes(end, start, -b), atol=1e-6
    )
