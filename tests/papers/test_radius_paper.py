"""Radius paper, part 1, "tool radius compensation": equations 1 to 5, with examples by hand.

A curve s = [f(t), g(t)] is an ellipse with half axes 40 and 20, an arc, or a line.  Expected values
are computed as in the paper; "the upper sign" corresponds to a side, σ = +1 left of travel.
"""

from __future__ import annotations

from math import cos, radians, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.compensation.deflection import programmed_centre
from knifetip.errors import CompensationError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import azimuth, left_normal, unit_vectors
from knifetip.geometry.ellipse import Ellipse
from knifetip.geometry.path import Paths, path_through
from knifetip.offset.offset_paths import offset_paths

QUARTER = np.tan(np.pi / 8)
ELLIPSE = Ellipse(np.zeros(2), np.array([40.0, 0.0]), np.array([0.0, 20.0]), 0.0, 2 * np.pi)


def paper_5(x: float, y: float, df: float, dg: float, r: float, sign: int) -> tuple[float, float]:
    """Return the offset point of equation 5.

    xe = x ∓ r g′ / S, ye = y ± r f′ / S, S = √(f′² + g′²); ``sign`` +1 selects the upper signs.
    """
    s = sqrt(df * df + dg * dg)
    return x - sign * r * dg / s, y + sign * r * df / s


def test_1_the_slope_of_the_tangent() -> None:
    # f′ 3, g′ 4: tan a = 4/3, a = 53.1301°.
    assert azimuth(np.array([[3.0, 4.0]]))[0] == pytest.approx(53.13010235)


def test_1_keeps_the_quadrant_that_tan_a_forgets() -> None:
    # f′ −3, g′ −4 has the same tan a in the opposite direction.
    assert azimuth(np.array([[-3.0, -4.0]]))[0] == pytest.approx(233.13010235)


@pytest.mark.parametrize(("df", "dg"), [(3.0, 4.0), (-3.0, 4.0), (-3.0, -4.0), (3.0, -4.0)])
def test_2_cosine_and_sine_have_the_signs_of_the_derivative(df: float, dg: float) -> None:
    # The paper's 1 / √(1 + tan² a) would be +0.6 in all four.
    np.testing.assert_allclose(unit_vectors(np.array([[df, dg]])), [[df / 5, dg / 5]], atol=1e-15)


def test_3_the_normal_is_minus_sine_and_cosine() -> None:
    np.testing.assert_allclose(left_normal(np.array([0.6, 0.8])), [-0.8, 0.6], atol=1e-15)


def test_4_the_centre_is_r_along_the_normal() -> None:
    # From (10, 20) with n = (−0.8, 0.6) and r 5: (6, 23), and (14, 17) on the other side.
    point, tangent = np.array([[10.0, 20.0]]), np.array([[3.0, 4.0]])
    np.testing.assert_allclose(
        programmed_centre(point, tangent, 1, 5.0, 0, 0), [[6, 23]], atol=1e-12
    )
    np.testing.assert_allclose(
        programmed_centre(point, tangent, -1, 5.0, 0, 0), [[14, 17]], atol=1e-12
    )


@given(t=st.floats(0.0, 6.28), r=st.floats(0.1, 8.0), side=st.sampled_from([1, -1]))
def test_5_on_an_ellipse_by_its_true_derivative(t: float, r: float, side: int) -> None:
    x, y, df, dg = 40 * cos(t), 20 * sin(t), -40 * sin(t), 20 * cos(t)
    got = programmed_centre(np.array([[x, y]]), np.array([[df, dg]]), side, r, 0.0, 0.0)
    np.testing.assert_allclose(got, [paper_5(x, y, df, dg, r, side)], atol=1e-12)


def test_5_at_three_points_of_the_ellipse_by_hand() -> None:
    # t 0: (40, 0) going up, left is −x. t 90°: (0, 20) going left, left is down. At t 45° the
    # tangent is (−40, 20)/√2, so n = (−1, −2)/√5: (28.2843 − 1.3416, 14.1421 − 2.6833).
    t = np.radians([0.0, 90.0, 45.0])
    points = np.stack([40.0 * np.cos(t), 20.0 * np.sin(t)], axis=1)
    tangents = np.stack([-40.0 * np.sin(t), 20.0 * np.cos(t)], axis=1)
    got = programmed_centre(points, tangents, 1, 3.0, 0.0, 0.0)
    np.testing.assert_allclose(got, [[37.0, 0.0], [0.0, 17.0], [26.942630, 11.458854]], atol=1e-6)


@pytest.mark.parametrize("side", [1, -1])
def test_5_a_line_is_shifted(side: int) -> None:
    paths = path_through(np.array([[0.0, 0.0], [30.0, 40.0]]), np.zeros(1))
    beside = offset_paths(paths, 5.0, side).paths
    np.testing.assert_allclose(beside.start, [[-4.0 * side, 3.0 * side]], atol=1e-12)
    np.testing.assert_allclose(beside.end, [[30 - 4.0 * side, 40 + 3.0 * side]], atol=1e-12)


@pytest.mark.parametrize(("side", "size"), [(1, 7.0), (-1, 13.0)])
def test_5_an_arc_keeps_its_centre_and_gains_or_loses_r(side: int, size: float) -> None:
    # A quarter turn to the left about (0, 10), whose centre is on the left.
    paths = path_through(np.array([[0.0, 0.0], [10.0, 10.0]]), np.array([QUARTER]))
    beside = offset_paths(paths, 3.0, side).paths
    np.testing.assert_allclose(arc.radius(beside.start, beside.end, beside.bulge), size)
    np.testing.assert_allclose(
        arc.centre(beside.start, beside.end, beside.bulge), [[0, 10]], atol=1e-9
    )
    np.testing.assert_allclose(beside.bulge, [QUARTER])


@pytest.mark.parametrize("side", [1, -1])
def test_5_a_fitted_ellipse_offset_as_arcs_lies_on_the_paper_s_curve(side: int) -> None:
    # Fitted within 0.001 mm, then moved by r: no farther from (5) than the fit, in the normal.
    start, end, bulge, _ = ELLIPSE.to_segments(0.001)
    paths = Paths(start, end, bulge, np.array([0, len(bulge)]))
    beside = offset_paths(paths, 3.0, side).paths
    points = arc.points_along(beside.start, beside.end, beside.bulge, 9).reshape(-1, 2)
    t = np.linspace(0.0, 2 * np.pi, 20_001)
    x, y, df, dg = 40 * np.cos(t), 20 * np.sin(t), -40 * np.sin(t), 20 * np.cos(t)
    s = np.hypot(df, dg)
    curve = np.column_stack([x - side * 3.0 * dg / s, y + side * 3.0 * df / s])
    nearest = np.array([np.argmin(((curve - point) ** 2).sum(axis=1)) for point in points])
    away = points - curve[nearest]
    worst = np.abs((away[:, 0] * dg[nearest] - away[:, 1] * df[nearest]) / s[nearest]).max()
    assert worst < 0.0012


def test_5_is_regular_only_while_one_minus_sigma_r_kappa_is_positive() -> None:
    # An inside arc of 10 mm takes a cutter of 9.9 and no cutter of 10.1.
    circle = Paths(
        np.array([[10.0, 0.0], [-10.0, 0.0]]), np.array([[-10.0, 0.0], [10.0, 0.0]]),
        np.ones(2), np.array([0, 2]),
    )  # fmt: skip
    small = offset_paths(circle, 9.9, 1).paths
    np.testing.assert_allclose(arc.radius(small.start, small.end, small.bulge), 0.1, rtol=1e-9)
    assert len(offset_paths(circle, 10.1, 1).paths) == 0
    with pytest.raises(CompensationError):
        offset_paths(circle, 10.1, 1, interference="refuse")


@pytest.mark.parametrize("degrees", [30.0, 60.0, 90.0, 120.0])
def test_inside_corners_are_shortened_to_where_the_equidistants_meet(degrees: float) -> None:
    # East for 40, then left by φ, tool on the left: r tan(φ/2) is lost before the corner.
    a = radians(degrees)
    xy = np.array([[0.0, 0.0], [40.0, 0.0], [40 + 40 * cos(a), 40 * sin(a)]])
    beside = offset_paths(path_through(xy, np.zeros(2)), 3.0, 1).paths
    np.testing.assert_allclose(beside.end[0], [40 - 3 * np.tan(a / 2), 3.0], atol=1e-9)
