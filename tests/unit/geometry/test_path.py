"""Paths trimmed, reversed and started elsewhere."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.geometry.path import (
    Paths,
    longest_segments,
    path_through,
    point_along,
    reverse_paths,
    select_paths,
    start_at,
    start_in_middle,
    trim_ends,
)

QUARTER = np.tan(np.pi / 8)
#: 30 mm east, a quarter turn to the left of radius 10, 40 mm north.
HOOK = path_through(
    np.array([[0.0, 0.0], [30.0, 0.0], [40.0, 10.0], [40.0, 50.0]]),
    np.array([0.0, QUARTER, 0.0]),
)


def test_the_length_counts_arcs_along_the_arc() -> None:
    assert HOOK.lengths[0] == pytest.approx(70.0 + 5.0 * np.pi)


def test_a_trimmed_path_ends_inside_its_arc() -> None:
    short, rows = trim_ends(HOOK, np.array([0.0]), np.array([40.0 + 2.5 * np.pi]))
    assert rows.tolist() == [0, 1]
    eighth = 10.0 * np.sin(np.pi / 4)
    np.testing.assert_allclose(short.end[-1], [30.0 + eighth, 10.0 - eighth])
    assert short.bulge[-1] == pytest.approx(np.tan(np.pi / 16))


@given(a=st.floats(0, 40), b=st.floats(0, 40))
def test_the_trimmed_lengths_are_missing(a: float, b: float) -> None:
    short, _ = trim_ends(HOOK, np.array([a]), np.array([b]))
    assert short.lengths[0] == pytest.approx(HOOK.lengths[0] - a - b, abs=1e-5)


def test_trimming_by_zero_returns_equal_segments_bit_for_bit() -> None:
    same, _ = trim_ends(HOOK, np.zeros(1), np.zeros(1))
    np.testing.assert_array_equal(same.end, HOOK.end)
    np.testing.assert_array_equal(same.bulge, HOOK.bulge)


def test_a_reversed_path_bends_the_other_way() -> None:
    back, rows = reverse_paths(HOOK, np.array([True]))
    assert rows.tolist() == [2, 1, 0]
    np.testing.assert_array_equal(back.start[0], [40.0, 50.0])
    assert back.bulge[1] == -QUARTER


def test_a_closed_path_starts_in_the_middle_of_its_longest_line() -> None:
    corners = np.array([[0, 0], [10, 0], [10, 40], [0, 40], [0, 0]], float)
    both = Paths(
        np.concatenate([corners[:-1], HOOK.start]),
        np.concatenate([corners[1:], HOOK.end]),
        np.concatenate([np.zeros(4), HOOK.bulge]),
        np.array([0, 4, 7]),
    )
    moved, rows = start_in_middle(both, both.closed, longest_segments(both))
    np.testing.assert_array_equal(moved.start[0], [10.0, 20.0])
    np.testing.assert_array_equal(moved.end[4], [10.0, 20.0])
    assert rows.tolist() == [1, 2, 3, 0, 1, 4, 5, 6]
    np.testing.assert_allclose(moved.lengths, both.lengths)


def test_a_circle_starts_in_the_middle_of_an_arc() -> None:
    circle = path_through(np.array([[0.0, 0.0], [20.0, 0.0], [0.0, 0.0]]), np.ones(2))
    moved, _ = start_in_middle(circle, circle.closed, longest_segments(circle))
    np.testing.assert_allclose(moved.start[0], [10.0, -10.0], atol=1e-12)
    np.testing.assert_allclose(moved.bulge, [QUARTER, 1.0, QUARTER])


def test_point_along_returns_point_azimuth_and_segment() -> None:
    xy, heading, row = point_along(HOOK, np.array([30.0 + 2.5 * np.pi]))
    eighth = 10.0 * np.sin(np.pi / 4)
    np.testing.assert_allclose(xy, [[30.0 + eighth, 10.0 - eighth]])
    assert heading[0] == pytest.approx(45.0)
    assert row.tolist() == [1]


def test_a_path_may_be_selected_twice() -> None:
    twice, rows = select_paths(HOOK, np.array([0, 0], np.int32))
    assert len(twice) == 2
    assert rows.tolist() == [0, 1, 2, 0, 1, 2]


def test_closed_paths_start_at_any_segment() -> None:
    square = np.array([[0, 0], [4, 0], [4, 4], [0, 4]], float)
    paths = Paths(
        np.concatenate([square, square + 10.0]),
        np.concatenate([np.roll(square, -1, axis=0), np.roll(square, -1, axis=0) + 10.0]),
        np.arange(8) / 10.0,
        np.array([0, 4, 8]),
    )
    turned, rows = start_at(paths, np.array([0, 6], np.int32))
    assert rows.tolist() == [0, 1, 2, 3, 6, 7, 4, 5]
    np.testing.assert_array_equal(turned.start[4], [14, 14])
    np.testing.assert_array_equal(turned.bulge, paths.bulge[rows])
