"""Transitions of types B, C and D: lengths of the patent's table, and properties of D."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.errors import CompensationError, ZeroLengthEdge
from knifetip.geometry import arc
from knifetip.geometry.path import Paths
from knifetip.offset.transition import Corner, transitions
from tests.support.shapes import rotation

#: φ in degrees, and L_B, L_C, L_D, l, r′ for r = 1 and k = ½.
TABLE = [
    (60.0, 1.0472, 1.1547, 1.1009, 0.2887, 0.5000),
    (90.0, 1.5708, 2.0000, 1.7854, 0.5000, 0.5000),
    (120.0, 2.0944, 2.7321, 2.4132, 0.4032, 0.7672),
    (180.0, 3.1416, 4.0000, 3.5708, 0.2146, 1.0000),
]

angles = st.floats(0.1, 180.0)
k_values = st.floats(0.01, 0.99)
radii = st.floats(0.01, 100.0)


def round_corner(
    kind: Corner, degrees: float, radius: float = 1.0, side: int = 1, k: float = 0.5
) -> Paths:
    """Return the transition at a corner between a line due east and one turned by an angle."""
    out = rotation(-side * degrees) @ [1.0, 0.0]
    return transitions(kind, np.array([[1.0, 0.0]]), out[None], np.zeros((1, 2)), radius, side, k)


@pytest.mark.parametrize("row", TABLE, ids=lambda row: f"{row[0]:g}°")
def test_lengths_of_the_table(row: tuple[float, float, float, float, float, float]) -> None:
    degrees, b, c, d, straight, small = row
    assert round_corner(Corner.B, degrees).lengths[0] == pytest.approx(b, abs=5e-5)
    assert round_corner(Corner.C, degrees).lengths[0] == pytest.approx(c, abs=5e-5)
    path = round_corner(Corner.D, degrees)
    assert path.lengths[0] == pytest.approx(d, abs=5e-5)
    assert np.hypot(*(path.end - path.start)[0]) == pytest.approx(straight, abs=5e-5)
    assert arc.radius(path.start, path.end, path.bulge)[1] == pytest.approx(small, abs=5e-5)


def test_b_is_one_arc_about_the_vertex() -> None:
    path = round_corner(Corner.B, 90.0, radius=2.0)
    np.testing.assert_allclose(path.start, [[0.0, 2.0]], atol=1e-15)
    np.testing.assert_allclose(path.end, [[2.0, 0.0]], atol=1e-15)
    np.testing.assert_allclose(arc.centre(path.start, path.end, path.bulge), [[0, 0]], atol=1e-15)
    assert path.bulge[0] < 0.0


def test_c_at_a_right_angle_passes_the_outer_corner_of_the_square() -> None:
    path = round_corner(Corner.C, 90.0, radius=2.0)
    np.testing.assert_allclose(path.end, [[2.0, 2.0], [2.0, 0.0]], atol=1e-15)


def test_c_beyond_a_right_angle_is_cut_off() -> None:
    path = round_corner(Corner.C, 180.0, radius=2.0)
    np.testing.assert_allclose(path.end, [[2.0, 2.0], [2.0, -2.0], [0.0, -2.0]], atol=1e-14)


@given(degrees=angles, radius=radii, k=k_values, side=st.sampled_from([-1, 1]))
def test_the_length_of_d_is_interpolated_between_b_and_c_by_k(
    degrees: float, radius: float, k: float, side: int
) -> None:
    b, c, d = (round_corner(kind, degrees, radius, side, k).lengths[0] for kind in Corner)
    assert d == pytest.approx((1.0 - k) * b + k * c, rel=1e-6, abs=1e-6)
    assert b <= c * (1.0 + 1e-12)


@given(
    degrees=st.floats(1.0, 180.0),
    radius=st.floats(0.1, 100.0),
    k=k_values,
    side=st.sampled_from([-1, 1]),
)
def test_d_is_smooth_and_touches_the_vertex_only_at_its_ends(
    degrees: float, radius: float, k: float, side: int
) -> None:
    path = round_corner(Corner.D, degrees, radius, side, k)
    if len(path.bulge) < 3:
        return
    before, after = arc.tangents(path.start, path.end, path.bulge)
    unit_in = after[:-1] / np.hypot(*after[:-1].T)[:, None]
    unit_out = before[1:] / np.hypot(*before[1:].T)[:, None]
    np.testing.assert_allclose(unit_in, unit_out, atol=1e-6)
    np.testing.assert_allclose(before[0] / np.hypot(*before[0]), [1.0, 0.0], atol=1e-9)
    points = arc.points_along(path.start, path.end, path.bulge, 21).reshape(-1, 2)
    away = np.hypot(*points.T)
    assert away[0] == pytest.approx(radius)
    assert away[-1] == pytest.approx(radius)
    assert (away[1:-1] > radius).all()
    straight = np.hypot(*(path.end - path.start)[0])
    assert away[21:42].min() >= np.hypot(radius, straight) * (1.0 - 1e-9)


def test_k_of_0_is_b_and_k_of_1_up_to_a_right_angle_is_c() -> None:
    assert round_corner(Corner.D, 70.0, k=0.0).lengths == round_corner(Corner.B, 70.0).lengths
    np.testing.assert_allclose(
        round_corner(Corner.D, 70.0, k=1.0).end, round_corner(Corner.C, 70.0).end, atol=1e-12
    )


@given(degrees=angles, turn=st.floats(-180.0, 180.0), kind=st.sampled_from(Corner))
def test_transitions_rotate_with_the_board_and_mirror_with_the_side(
    degrees: float, turn: float, kind: Corner
) -> None:
    plain = round_corner(kind, degrees)
    out = rotation(-degrees) @ [1.0, 0.0]
    spin = rotation(turn)
    turned = transitions(
        kind, (spin @ [1.0, 0.0])[None], (spin @ out)[None], np.zeros((1, 2)), 1.0, 1, 0.5
    )
    np.testing.assert_allclose(turned.start, plain.start @ spin.T, atol=1e-6)
    mirrored = round_corner(kind, degrees, side=-1)
    np.testing.assert_allclose(mirrored.end, plain.end * [1.0, -1.0], atol=1e-12)
    np.testing.assert_allclose(mirrored.bulge, -plain.bulge)


def test_a_corner_that_is_concave_for_the_tool_has_no_transition() -> None:
    east, north = np.array([[1.0, 0.0]]), np.array([[0.0, 1.0]])
    both = transitions(
        Corner.B,
        np.concatenate([east, east]),
        np.concatenate([north, north]),
        np.zeros((2, 2)),
        1.0,
        [1, -1],
        0.5,
    )
    assert both.first.tolist() == [0, 0, 1]


@pytest.mark.parametrize(
    ("kind", "radius", "k", "words"),
    [
        (Corner.D, 1.0, np.nan, "type D with the parameter k = nan"),
        (Corner.D, 1.0, 1.5, "type D with the parameter k = 1.5"),
        (3, 1.0, 0.5, "type 3"),
        (
            Corner.B,
            np.nan,
            0.5,
            "tool radius for a corner of a contour is negative or not a number",
        ),
        (Corner.B, -1.0, 0.5, "tool radius for a corner of a contour is negative or not a number"),
    ],
)
def test_invalid_arguments_are_refused(kind: Any, radius: float, k: float, words: str) -> None:
    with pytest.raises(CompensationError, match=words):
        round_corner(kind, 90.0, radius, 1, k)


def test_a_corner_without_direction_is_refused() -> None:
    with pytest.raises(ZeroLengthEdge):
        transitions(0, np.zeros((1, 2)), np.ones((1, 2)), np.zeros((1, 2)), 1.0, 1, 0.5)
