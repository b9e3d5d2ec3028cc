"""The D-type patent of Dalian Jiaotong University: its claims, and the table of lengths.

A cutter of r = 2 mm goes east to the corner A = (10, 0), with the board on its left, and turns
left by φ; all coordinates are computed by hand.
"""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.compensation.corner import corner_lengths, d_type_shape
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.offset.transition import Corner, transitions
from tests.support.examples import examples

A = np.array([[10.0, 0.0]])
EAST = np.array([[1.0, 0.0]])
ROOT3 = 3.0**0.5


def way(kind: Corner, degrees: float, k: float = 0.5, radius: float = 2.0) -> Paths:
    turned = np.radians(degrees)
    out = np.array([[np.cos(turned), np.sin(turned)]])
    return transitions([kind], EAST, out, A, [radius], [-1], [k])


def angles_between(paths: Paths) -> F64:
    """Return the angle of the change of direction between consecutive segments (radians)."""
    first, last = arc.tangents(paths.start, paths.end, paths.bulge)
    first = first / np.hypot(*first.T)[:, None]
    last = last / np.hypot(*last.T)[:, None]
    cross = last[:-1, 0] * first[1:, 1] - last[:-1, 1] * first[1:, 0]
    angle: F64 = np.abs(np.arctan2(cross, (last[:-1] * first[1:]).sum(axis=1)))
    return angle


# L_B, L_C, L_D at k = ½, l and r′, each for r = 1.
TABLE = [
    (60.0, 1.0472, 1.1547, 1.1009, 0.2887, 0.5000),
    (90.0, 1.5708, 2.0000, 1.7854, 0.5000, 0.5000),
    (120.0, 2.0944, 2.7321, 2.4132, 0.4032, 0.7672),
    (180.0, 3.1416, 4.0000, 3.5708, 0.2146, 1.0000),
]


@pytest.mark.parametrize(("degrees", "b", "c", "d", "straight", "bend"), TABLE)
@pytest.mark.parametrize("radius", [1.0, 3.0])
def test_the_table_of_lengths(
    degrees: float, b: float, c: float, d: float, straight: float, bend: float, radius: float
) -> None:
    turn, k = np.radians([degrees]), np.array([0.5])
    np.testing.assert_allclose(
        corner_lengths(turn, radius, k), radius * np.array([[b, c, d]]), atol=6e-5 * radius
    )
    got = d_type_shape(turn, radius, k)
    np.testing.assert_allclose(
        np.ravel(got), radius * np.array([straight, bend]), atol=6e-5 * radius
    )


@pytest.mark.parametrize(("degrees", "b", "c", "d"), [row[:4] for row in TABLE])
def test_the_ways_themselves_have_the_lengths_of_the_table(
    degrees: float, b: float, c: float, d: float
) -> None:
    for kind, length in zip(Corner, (b, c, d), strict=True):
        assert way(kind, degrees).lengths[0] == pytest.approx(2.0 * length, abs=1.3e-4)


def test_b_at_90_degrees_is_an_arc_about_the_corner() -> None:
    path = way(Corner.B, 90.0)
    np.testing.assert_allclose([path.start[0], path.end[-1]], [[10, -2], [12, 0]], atol=1e-12)
    np.testing.assert_allclose(arc.centre(path.start, path.end, path.bulge), A, atol=1e-12)


def test_c_at_90_degrees_is_a_square_and_at_120_is_cut_off() -> None:
    np.testing.assert_allclose(way(Corner.C, 90.0).end, [[12, -2], [12, 0]], atol=1e-12)
    # B₀ (10, −2), G 2 mm on, E₀ = (10 + √3, 1), H 2 mm before it.
    path = way(Corner.C, 120.0)
    expected = [[10, -2], [12, -2], [11 + ROOT3, 1 - ROOT3], [10 + ROOT3, 1]]
    corners = np.concatenate([path.start, path.end[-1:]])
    np.testing.assert_allclose(corners, np.array(expected, float), atol=1e-12)


def test_d_at_90_degrees_is_line_arc_line() -> None:
    # l = ½ · 2 · tan 45° = 1, r′ = 1 about (11, −1).
    path = way(Corner.D, 90.0)
    expected = [[10, -2], [11, -2], [12, -1], [12, 0]]
    corners = np.concatenate([path.start, path.end[-1:]])
    np.testing.assert_allclose(corners, np.array(expected, float), atol=1e-12)
    np.testing.assert_allclose(path.bulge, [0.0, np.tan(np.pi / 8), 0.0], atol=1e-12)


def test_d_at_120_degrees_worked_by_hand() -> None:
    # L_B 4.188790, L_C 5.464102: ½ of the difference is 0.637656; over 0.790800 that is l.
    path = way(Corner.D, 120.0)
    straight = 0.806343
    np.testing.assert_allclose(path.end[0], [10 + straight, -2], atol=2e-6)
    np.testing.assert_allclose(
        path.end[1], [10 + ROOT3 + straight / 2, 1 - straight * ROOT3 / 2], atol=2e-6
    )
    radius = arc.radius(path.start[1:2], path.end[1:2], path.bulge[1:2])[0]
    assert radius == pytest.approx(2.0 - straight / ROOT3, abs=2e-6)


turns = st.floats(5.0, 178.0)
k_values = st.floats(0.05, 0.95)
many = examples(1000)


@many
@given(degrees=turns, k=k_values, radius=st.floats(0.1, 20.0))
def test_claim_d_is_longer_than_b_and_shorter_than_c(
    degrees: float, k: float, radius: float
) -> None:
    b, c, d = (way(kind, degrees, k, radius).lengths[0] for kind in Corner)
    assert b < d < c
    assert d == pytest.approx((1.0 - k) * b + k * c, rel=1e-9)
    np.testing.assert_allclose(
        corner_lengths(np.radians([degrees]), radius, np.array([k])), [[b, c, d]], rtol=1e-9
    )


@many
@given(degrees=turns, k=k_values)
def test_claim_the_centres_way_is_smooth_in_d_and_not_in_c(degrees: float, k: float) -> None:
    def joined(kind: Corner) -> Paths:
        path = way(kind, degrees, k)
        ends = np.array([[9.0, -2.0]]), path.end[-1:]
        turned = np.radians(degrees)
        out = ends[1] + [[np.cos(turned), np.sin(turned)]]
        return type(path)(
            np.concatenate([ends[0], path.start, ends[1]]),
            np.concatenate([path.start[:1], path.end, out]),
            np.concatenate([[0.0], path.bulge, [0.0]]),
            np.array([0, len(path.bulge) + 2]),
        )

    assert angles_between(joined(Corner.D)).max() < 1e-6
    assert angles_between(joined(Corner.C)).max() == pytest.approx(
        np.radians(degrees if degrees <= 90.0 else degrees / 2.0), abs=1e-6
    )


@many
@given(degrees=turns, k=k_values)
def test_claim_d_leaves_the_corner_at_once_and_b_touches_it_all_the_way(
    degrees: float, k: float
) -> None:
    b = way(Corner.B, degrees, k)
    points = arc.points_along(b.start, b.end, b.bulge, 33).reshape(-1, 2)
    np.testing.assert_allclose(np.hypot(*(points - A).T), 2.0, atol=1e-9)
    d = way(Corner.D, degrees, k)
    points = arc.points_along(d.start, d.end, d.bulge, 33)
    away = np.hypot(points[..., 0] - 10.0, points[..., 1])
    straight = np.hypot(*(d.end[0] - d.start[0]))
    # Touching at B₀ and E₀ alone; on the arc never nearer than √(r² + l²).
    assert (away[0, 0], away[-1, -1]) == pytest.approx((2.0, 2.0))
    assert (away[0, 1:] > 2.0).all()
    assert (away[-1, :-1] > 2.0).all()
    if len(d.bulge) == 3:
        assert away[1].min() >= np.hypot(2.0, straight) - 1e-9


def test_k_leads_from_b_to_c() -> None:
    b, c = way(Corner.B, 70.0), way(Corner.C, 70.0)
    assert way(Corner.D, 70.0, 0.0).lengths[0] == pytest.approx(b.lengths[0])
    assert way(Corner.D, 70.0, 1.0).lengths[0] == pytest.approx(c.lengths[0])
