"""The azimuth of Yang et al., 4.1, unit vectors, normals and turns."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.errors import ZeroLengthEdge
from knifetip.geometry.azimuth import (
    azimuth,
    left_normal,
    right_normal,
    turn_angle,
    unit_vectors,
    unwrap,
)


def test_just_below_due_east_is_zero_and_not_a_full_turn() -> None:
    assert azimuth(np.array([[1.0, -1e-18]]))[0] == 0.0


def test_unit_vectors_have_length_one() -> None:
    np.testing.assert_allclose(unit_vectors(np.array([[3.0, 4.0]])), [[0.6, 0.8]])


@pytest.mark.parametrize("length", [0.0, 1e-7, np.nan])
def test_an_edge_without_length_has_no_direction(length: float) -> None:
    with pytest.raises(ZeroLengthEdge, match="length of 0, so they have no direction: edge 1"):
        unit_vectors(np.array([[1.0, 0.0], [length, 0.0]]))


def test_right_of_north_is_east_and_left_is_west() -> None:
    north = np.array([[0.0, 1.0]])
    np.testing.assert_array_equal(right_normal(north), [[1.0, 0.0]])
    np.testing.assert_array_equal(left_normal(north), [[-1.0, 0.0]])


@pytest.mark.parametrize(
    ("before", "after", "expected"),
    [(350.0, 10.0, 20.0), (10.0, 350.0, -20.0), (0.0, 180.0, 180.0), (90.0, 90.0, 0.0)],
)
def test_the_turn_is_the_smaller_angle(before: float, after: float, expected: float) -> None:
    assert turn_angle(np.array([before]), np.array([after]))[0] == expected


def test_unwrapped_azimuths_have_no_jumps() -> None:
    np.testing.assert_allclose(unwrap(np.array([350.0, 10.0, 30.0])), [350.0, 370.0, 390.0])
