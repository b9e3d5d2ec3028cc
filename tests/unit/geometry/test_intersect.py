"""Common points of lines and arcs, computed by hand and checked to be on both segments."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.geometry.intersect import intersect_pairs
from tests.support.examples import examples

#: Half circle from (10, 0) through (0, 10) to (-10, 0).
HALF = ((10.0, 0.0), (-10.0, 0.0), 1.0)


def shared(
    one: tuple[tuple[float, float], tuple[float, float], float],
    two: tuple[tuple[float, float], tuple[float, float], float],
) -> F64:
    """Return the common points of two segments (start, end, bulge), sorted.

    Each row has x, y and the parameters of the point on both segments.
    """
    columns = [np.array([value]) for value in (*one, *two)]
    a, b, bend, c, d, turn = columns
    found = intersect_pairs(a, b, bend, c, d, turn)
    count = found.count[0]
    rows = np.column_stack([found.points[0], found.first[0], found.second[0]])[:count]
    return rows[np.lexsort(rows.T[::-1])]


@pytest.mark.parametrize(
    ("one", "two", "points"),
    [
        (((0, 0), (10, 0), 0), ((4, -5), (4, 5), 0), [[4, 0, 0.4, 0.5]]),
        (((0, 0), (10, 0), 0), ((4, 1), (4, 5), 0), []),
        (((0, 0), (10, 0), 0), ((10, 0), (10, 5), 0), [[10, 0, 1, 0]]),
        (((0, 0), (10, 0), 0), ((0, 1), (10, 1), 0), []),
        (((0, 0), (10, 0), 0), ((4, 0), (14, 0), 0), [[4, 0, 0.4, 0], [10, 0, 1, 0.6]]),
        (((0, 0), (10, 0), 0), ((8, 0), (2, 0), 0), [[2, 0, 0.2, 1], [8, 0, 0.8, 0]]),
        (((0, 0), (0, 20), 0), HALF, [[0, 10, 0.5, 0.5]]),
        (((0, 0), (0, -20), 0), HALF, []),
        (((-20, 10), (20, 10), 0), HALF, [[0, 10, 0.5, 0.5]]),
        (((-20, 10.001), (20, 10.001), 0), HALF, []),
        (HALF, ((0, 0), (0, 20), 0), [[0, 10, 0.5, 0.5]]),
        (HALF, ((10, 20), (-10, 20), -1), [[0, 10, 0.5, 0.5]]),
        (
            HALF,
            ((10, 15), (-10, 15), -1),
            [[-6.6143783, 7.5, None, None], [6.6143783, 7.5, None, None]],
        ),
        (HALF, ((0, 10), (0, -10), 1), [[-10, 0, 1, 0.5], [0, 10, 0.5, 0]]),
        (HALF, ((5, 0), (-5, 0), 1), []),
    ],
    ids=[
        "cross",
        "short of it",
        "corner",
        "parallel",
        "overlap",
        "inside",
        "line and arc",
        "the other half",
        "tangent",
        "just beside",
        "arc and line",
        "arcs touch",
        "arcs cross",
        "one circle",
        "one in the other",
    ],
)
def test_common_points_equal_those_computed_by_hand(
    one: tuple[tuple[float, float], tuple[float, float], float],
    two: tuple[tuple[float, float], tuple[float, float], float],
    points: list[list[float | None]],
) -> None:
    found = shared(one, two)
    assert len(found) == len(points)
    for have, want in zip(found, points, strict=True):
        for value, expected in zip(have, want, strict=True):
            if expected is not None:
                assert value == pytest.approx(expected, abs=1e-7)


def test_two_arcs_of_one_circle_may_overlap_twice() -> None:
    # Three quarters of a circle each, starting at opposite points.
    three = np.tan(np.radians(67.5))
    assert len(shared(((10, 0), (0, -10), three), ((-10, 0), (0, 10), three))) == 4


places = st.floats(-50.0, 50.0)
bulges = st.one_of(st.just(0.0), st.floats(-2.0, 2.0).filter(lambda b: abs(b) > 1e-3))


@examples(1000)
@given(st.tuples(*[places] * 8), bulges, bulges)
# Two arcs that end where they touch.
@example((-4.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0), 0.1875, 0.1875)
def test_common_points_are_on_both_segments_and_none_is_missed(
    places: tuple[float, float, float, float, float, float, float, float], b1: float, b2: float
) -> None:
    ends = np.array(places).reshape(4, 1, 2)
    if min(np.hypot(*(ends[1] - ends[0])[0]), np.hypot(*(ends[3] - ends[2])[0])) < 1.0:
        return
    one, two = (ends[0], ends[1], np.array([b1])), (ends[2], ends[3], np.array([b2]))
    found = intersect_pairs(*one, *two)
    count = found.count[0]
    for i in range(count):
        for segment, share in ((one, found.first), (two, found.second)):
            on = arc.point_at(*segment, share[:, i])[0]
            np.testing.assert_allclose(on, found.points[0, i], atol=1e-5)
    # Exchanging the segments gives the same points.
    again = intersect_pairs(*two, *one)
    assert again.count[0] == count
    # Wherever the first segment changes sides of the second, there must be a common point.
    fine = arc.points_along(*one, 400)[0]
    if b2 == 0.0:
        a, d = ends[2, 0], ends[3, 0] - ends[2, 0]
        value = (fine - a)[:, 0] * d[1] - (fine - a)[:, 1] * d[0]
        along = ((fine - a) @ d) / (d @ d)
        inside = (along > 0.01) & (along < 0.99)
    else:
        centre, radius = arc.centre(*two)[0], arc.radius(*two)[0]
        value = np.hypot(*(fine - centre).T) - radius
        middle = arc.point_at(*two, np.array([0.5]))[0] - centre
        sweep = abs(arc.sweep(np.array([b2]))[0])
        out = (fine - centre) / np.maximum(np.hypot(*(fine - centre).T), 1e-9)[:, None]
        inside = np.arccos(np.clip(out @ middle / radius, -1, 1)) < 0.49 * sweep - 0.02
    if np.abs(value).max() < 1e-6:
        return
    flips = (np.sign(value[1:]) != np.sign(value[:-1])) & inside[1:] & inside[:-1]
    step = np.hypot(*(fine[1] - fine[0]))
    for at in fine[:-1][flips]:
        assert count > 0
        assert np.hypot(*(found.points[0, :count] - at).T).min() < 3.0 * step + 1e-6


def test_many_pairs_are_intersected_in_one_call() -> None:
    rows = 1000
    x = np.arange(rows, dtype=float)
    found = intersect_pairs(
        np.column_stack([x, np.zeros(rows)]),
        np.column_stack([x, np.full(rows, 10.0)]),
        np.zeros(rows),
        np.tile([[-1.0, 5.0]], (rows, 1)),
        np.tile([[2000.0, 5.0]], (rows, 1)),
        np.zeros(rows),
    )
    assert (found.count == 1).all()
    np.testing.assert_allclose(found.points[:, 0], np.column_stack([x, np.full(rows, 5.0)]))
    assert np.isnan(found.points[:, 1:]).all()
