"""Distances to lines and arcs, and crossings of lines, compared with shapely and sampled points."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import assume, given
from hypothesis import strategies as st

from knifetip.topology.segment import crossing_parameters, distance_to, point_at

_NUMBER = st.floats(-100.0, 100.0)
_POINT = st.tuples(_NUMBER, _NUMBER)
_BULGE = st.one_of(st.just(0.0), st.floats(-1.0, 1.0))


def _nearest(ends: np.ndarray, bulge: np.ndarray, x: float, y: float) -> float:
    """Return the distance from (x, y) to the nearest of many points along a segment."""
    points = [point_at(ends, bulge, 0, share) for share in np.linspace(0.0, 1.0, 2001)]
    return float(np.hypot(*(np.array(points) - (x, y)).T).min())


@given(_POINT, _POINT, _BULGE, _POINT, st.floats(0.01, 300.0))
def test_what_is_near_is_as_far_as_the_nearest_of_its_points(
    a: tuple[float, float],
    b: tuple[float, float],
    bend: float,
    point: tuple[float, float],
    far: float,
) -> None:
    chord = math.dist(a, b)
    assume(chord > 0.1 and (bend == 0.0 or abs(bend) > 1e-3))
    ends, bulge = np.array([[a, b]]), np.array([bend])
    away, share = distance_to(ends, bulge, 0, *point, far)
    expected = _nearest(ends, bulge, *point)
    step = chord * math.pi / 2 / 2000
    if away <= far:
        assert away - 1e-6 <= expected <= away + step
        assert math.isclose(math.dist(point_at(ends, bulge, 0, share), point), away, abs_tol=1e-5)
    else:
        # Only points far away may have an infinite distance.
        assert expected > far - 1e-6


@given(_POINT, _POINT, _POINT, _POINT)
def test_lines_cross_at_the_points_that_shapely_returns(
    a: tuple[float, float], b: tuple[float, float], c: tuple[float, float], d: tuple[float, float]
) -> None:
    assume(math.dist(a, b) > 0.1 and math.dist(c, d) > 0.1)
    one, other = shapely.LineString([a, b]), shapely.LineString([c, d])
    s, t = crossing_parameters(*a, b[0] - a[0], b[1] - a[1], np.array([[c, d]]), 0)
    if math.isnan(s):
        assert math.isnan(t)
        # The lines may touch at an end or overlap.
        touching = min(one.distance(shapely.Point(p)) for p in (c, d))
        touching = min(touching, *(other.distance(shapely.Point(p)) for p in (a, b)))
        assert not one.intersects(other) or touching < 1e-6
        return
    assert 0.0 <= s <= 1.0
    assert 0.0 <= t <= 1.0
    here = np.add(a, s * np.subtract(b, a))
    assert one.distance(other) < 1e-9
    assert math.dist(here, np.add(c, t * np.subtract(d, c))) < 1e-6 * (
        1.0 + 1.0 / max(abs(math.sin(_between(a, b, c, d))), 1e-12)
    )


@pytest.mark.parametrize("angle", range(0, 180, 17))
def test_lines_that_continue_each_other_do_not_cross(angle: int) -> None:
    """Turned coordinates are rounded, so the lines are not exactly parallel."""
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    for x in np.arange(164.5, 170.0, 0.01):
        a, b, c = np.array([[x, -212.0], [189.5, -212.0], [321.5, -212.0]]) @ turn
        assert math.isnan(
            crossing_parameters(a[0], a[1], b[0] - a[0], b[1] - a[1], np.array([[c, b]]), 0)[0]
        )


def _between(
    a: tuple[float, float],
    b: tuple[float, float],
    c: tuple[float, float],
    d: tuple[float, float],
) -> float:
    return math.atan2(b[1] - a[1], b[0] - a[0]) - math.atan2(d[1] - c[1], d[0] - c[0])
