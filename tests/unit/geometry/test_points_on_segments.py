"""Points on segments, compared with shapely and values computed by hand."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely import LineString, Point

from knifetip.geometry.points_on_segments import find_points_on_segments
from tests.support.shapes import edges

NONE = np.array([-1], np.int32)


def test_a_point_in_the_middle_of_an_arc_is_on_it() -> None:
    half = edges(((0, 0), (20, 0)))
    on, off = np.array([[10.0, -10.02]]), np.array([[10.0, 10.0]])
    for points, expected in ((on, True), (off, False)):
        assert find_points_on_segments(
            points, NONE, half[:, 0], half[:, 1], np.ones(1), 0.05
        ).tolist() == [expected]


def test_the_own_segment_of_a_point_is_ignored() -> None:
    line = edges(((0, 0), (20, 0)))
    args = (line[:, 0], line[:, 1], np.zeros(1), 0.05)
    assert not find_points_on_segments(np.zeros((1, 2)), np.array([0], np.int32), *args)[0]
    assert find_points_on_segments(np.zeros((1, 2)), NONE, *args)[0]


@pytest.mark.parametrize(("count", "gap"), [(30, 2.0), (250, 0.1)])
@given(seed=st.integers(0, 1000))
def test_shapely_agrees_about_lines(count: int, gap: float, seed: int) -> None:
    # So many lines across each other are searched with a tree instead of a grid.
    random = np.random.default_rng(seed)
    ends = random.uniform(0, 100, (count, 2, 2))
    points = random.uniform(-10, 110, (20, 2))
    found = find_points_on_segments(
        points, np.full(20, -1, np.int32), ends[:, 0], ends[:, 1], np.zeros(count), gap
    )
    expected = [min(LineString(e).distance(Point(p)) for e in ends) <= gap for p in points]
    assert found.tolist() == expected
