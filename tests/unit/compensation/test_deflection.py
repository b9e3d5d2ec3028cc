"""Deflection of paths: lines are shifted, arcs become elliptical, bends remain connected."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.compensation.deflection import fit_deflection, shift_centres
from knifetip.errors import CompensationError, ZeroLengthEdge
from knifetip.geometry import arc
from knifetip.geometry.path import Paths, path_through
from tests.support.examples import examples

QUARTER = np.tan(np.pi / 8)
angles = st.floats(0.0, 360.0)
given_way = st.floats(0.0, 0.3)


def square(size: float) -> Paths:
    corners = np.array([[0, 0], [size, 0], [size, size], [0, size], [0, 0]], float)
    return path_through(corners, np.zeros(4))


def rounded(size: float, radius: float) -> Paths:
    """Return a counter-clockwise square with round corners, like an offset of type B."""
    s, r = size, radius
    corners = [(r, 0), (s - r, 0), (s, r), (s, s - r), (s - r, s), (r, s), (0, s - r), (0, r)]
    return path_through(np.array([*corners, corners[0]], float), np.array([0, QUARTER] * 4))


def test_a_line_moves_into_the_board_by_the_deflection_across_it() -> None:
    # Eastward with the tool on the left, the board is below, so the line moves down by δy.
    path, rows = shift_centres(
        path_through(np.array([[0.0, 3.0], [50.0, 3.0]]), np.zeros(1)), 1, 0.1, 0.05
    )
    np.testing.assert_allclose([path.start[0], path.end[0]], [[0, 2.95], [50, 2.95]], atol=1e-12)
    assert rows.tolist() == [0]


def test_a_square_with_bends_keeps_its_bends() -> None:
    # Counter-clockwise with the tool outside (right), each side moves in by δx or δy.
    path, _ = shift_centres(square(100.0), -1, 0.1, 0.05)
    np.testing.assert_allclose(
        path.start, [[0.1, 0.05], [99.9, 0.05], [99.9, 99.95], [0.1, 99.95]], atol=1e-12
    )
    np.testing.assert_array_equal(path.end, np.roll(path.start, -1, axis=0))


def test_a_square_hole_grows() -> None:
    # Tool on the left, inside the square: the board is outside, so the sides move out.
    path, _ = shift_centres(square(100.0), 1, 0.1, 0.05)
    np.testing.assert_allclose(path.start[[0, 2]], [[-0.1, -0.05], [100.1, 100.05]], atol=1e-12)


@examples(200)
@given(x=given_way, y=given_way, radius=st.floats(1.0, 20.0))
def test_round_corners_become_elliptical_within_the_tolerance(
    x: float, y: float, radius: float
) -> None:
    paths = rounded(60.0, radius)
    path, rows = shift_centres(paths, -1, x, y)
    np.testing.assert_allclose(path.end, np.roll(path.start, -1, axis=0), atol=1e-9)
    # The corner about (60 − r, r), from due south to due east: half axes r − δx and r − δy.
    if x == y == 0.0:
        return
    corner = np.flatnonzero(rows == 1)
    points = arc.points_along(path.start[corner], path.end[corner], path.bulge[corner], 33)
    away = points.reshape(-1, 2) - [60.0 - radius, radius]
    level = np.hypot(away[:, 0] / (radius - x), away[:, 1] / (radius - y)) - 1.0
    assert np.abs(level).max() * radius < 0.0006
    np.testing.assert_allclose(path.start[corner[0]], [60 - radius, y], atol=1e-9)
    np.testing.assert_allclose(path.end[corner[-1]], [60 - x, radius], atol=1e-9)


def test_equal_deflections_keep_arcs_circular() -> None:
    path, rows = shift_centres(rounded(60.0, 5.0), -1, 0.2, 0.2)
    corner = rows == 1
    radius = arc.radius(path.start[corner], path.end[corner], path.bulge[corner])
    np.testing.assert_allclose(radius, 4.8, rtol=1e-9)


def test_no_deflection_is_the_identity_to_the_bit() -> None:
    paths = rounded(60.0, 5.0)
    path, rows = shift_centres(paths, -1, 0.0, 0.0)
    assert path is paths
    assert rows.tolist() == list(range(8))


@examples(200)
@given(x=given_way, y=given_way, bulge=st.floats(-0.9, 0.9).filter(lambda b: abs(b) > 0.05))
def test_a_line_and_an_arc_at_a_bend_remain_connected(x: float, y: float, bulge: float) -> None:
    paths = path_through(np.array([[0, 0], [40, 0], [40, 30], [0, 30], [0, 0]], float),
                    np.array([0.0, bulge, 0.0, 0.0]))  # fmt: skip
    path, rows = shift_centres(paths, -1, x, y)
    np.testing.assert_allclose(path.end, np.roll(path.start, -1, axis=0), atol=1e-9)
    assert sorted(set(rows.tolist())) == [0, 1, 2, 3]
    # The straight sides have moved by δy and δx exactly.
    south = rows == 0
    np.testing.assert_allclose(path.start[south][:, 1], y, atol=1e-9)


@examples(100)
@given(x=given_way, y=given_way, shift=st.integers(0, 7))
def test_direction_and_start_do_not_change_the_shifted_contour(
    x: float, y: float, shift: int
) -> None:
    paths = rounded(60.0, 4.0)
    there, _ = shift_centres(paths, -1, x, y)
    turned = Paths(paths.end[::-1], paths.start[::-1], -paths.bulge[::-1], paths.first)
    back, _ = shift_centres(turned, 1, x, y)
    np.testing.assert_allclose(back.end[::-1], there.start, atol=1e-9)
    start, end, bulge = (np.roll(c, shift, axis=0) for c in (paths.start, paths.end, paths.bulge))
    rolled = Paths(start, end, bulge,
                   paths.first)  # fmt: skip
    other, _ = shift_centres(rolled, -1, x, y)
    lengths = (there.lengths, other.lengths)
    assert lengths[0] == pytest.approx(lengths[1], abs=1e-9)


def test_the_ends_of_an_open_path_are_shifted_only() -> None:
    path, _ = shift_centres(
        path_through(np.array([[0.0, 0], [10, 0], [10, 10]]), np.zeros(2)), 1, 0.2, 0.1
    )
    np.testing.assert_allclose(path.start, [[0, -0.1], [10.2, -0.1]], atol=1e-12)
    np.testing.assert_allclose(path.end[-1], [10.2, 10], atol=1e-12)


def test_an_arc_with_a_radius_below_the_deflection_becomes_a_line() -> None:
    path, rows = shift_centres(rounded(60.0, 0.25), -1, 0.3, 0.1)
    assert rows.tolist() == list(range(8))
    assert (path.bulge == 0.0).all()
    np.testing.assert_allclose(path.end[0], [59.75, 0.1], atol=1e-12)
    np.testing.assert_allclose(path.end[1], [59.7, 0.25], atol=1e-12)


def test_a_step_that_the_shift_consumes_is_dropped() -> None:
    # A tooth 0.1 mm high in the middle of a side of 100 mm: its slopes move together or apart.
    xy = np.array([[0, 0], [50, 0], [50.1, 0.1], [50.2, 0], [100, 0], [100, 50], [0, 50], [0, 0]])
    path, rows = shift_centres(path_through(xy, np.zeros(7)), 1, 0.3, 0.3)
    assert rows.tolist() == [0, 3, 4, 5, 6]
    corners = [(-0.3, -0.3), (50.2, -0.3), (100.3, -0.3), (100.3, 50.3), (-0.3, 50.3)]
    np.testing.assert_allclose(path.start, corners, atol=1e-6)
    np.testing.assert_array_equal(path.end, np.roll(path.start, -1, axis=0))
    path, rows = shift_centres(path_through(xy, np.zeros(7)), -1, 0.3, 0.3)
    assert rows.tolist() == list(range(7))
    np.testing.assert_allclose(path.start[1:4, 1], [0.3, 0.524264, 0.3], atol=1e-6)


def test_a_path_that_the_shift_consumes_is_dropped() -> None:
    xy = np.array([[0, 0], [0.4, 0], [0.4, 0.4], [0, 0.4], [0, 0]])
    small = path_through(xy, np.zeros(4))
    large = square(100.0)
    both = Paths(
        np.concatenate([small.start, large.start]),
        np.concatenate([small.end, large.end]),
        np.zeros(8),
        np.array([0, 4, 8]),
    )
    path, rows = shift_centres(both, -1, 0.3, 0.3)
    assert rows.tolist() == [4, 5, 6, 7]
    assert len(path) == 1
    assert path.closed.all()


@given(side=st.sampled_from([1, -1]), x=given_way, y=given_way,
       azimuths=st.lists(st.floats(20.0, 70.0), min_size=1, max_size=5))  # fmt: skip
def test_calibration_returns_the_deflection_that_made_the_points(
    side: int, x: float, y: float, azimuths: list[float]
) -> None:
    a = np.radians(azimuths)
    tangents = np.column_stack([np.cos(a), np.sin(a)])
    measured = side * np.column_stack([-x * np.sin(a), y * np.cos(a)])
    assert fit_deflection(tangents, measured, side) == pytest.approx((x, y), abs=1e-12)


def test_a_deflection_into_the_board_is_refused_unless_it_is_noise() -> None:
    tangent = np.array([[1.0, 1.0]])
    with pytest.raises(CompensationError, match="a sign or the side is probably wrong"):
        fit_deflection(tangent, np.array([[0.05, 0.05]]), 1)
    assert fit_deflection(tangent, np.array([[0.001, 0.05]]), 1)[0] == 0.0


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_values_that_are_not_finite_are_refused(bad: float) -> None:
    with pytest.raises(CompensationError, match="finite number"):
        fit_deflection(np.array([[1.0, 1.0]]), np.array([[bad, 0.0]]), 1)
    with pytest.raises(CompensationError, match="0 measured points"):
        fit_deflection(np.zeros((0, 2)), np.zeros((0, 2)), 1)
    with pytest.raises(ZeroLengthEdge):
        fit_deflection(np.zeros((1, 2)), np.zeros((1, 2)), 1)
