"""Yang, Du, Shu & Qian, "Study on tool compensation of NC carton samplemaker": every equation.

Expected values are computed as in the paper, case by case, and share no code with knifetip.
"""

from __future__ import annotations

from math import atan, cos, degrees, radians, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.compensation.vgroove import head_offset, sideways_move
from knifetip.errors import ZeroLengthEdge
from knifetip.geometry.azimuth import azimuth
from knifetip.model.tool import VCutter
from tests.benchmarks.vgroove_listing import AZIMUTHS, PAGE, largest_errors, listing_azimuth, page

coordinates = st.floats(-1000.0, 1000.0).map(lambda value: round(value, 3))


def paper_azimuth(dx: float, dy: float) -> float:
    """Return the azimuth of (dx, dy) by the five cases of section 4.1 (degrees)."""
    if dx > 0 and dy >= 0:
        return degrees(atan(dy / dx))
    if dx == 0 and dy > 0:
        return 90.0
    if dx < 0:
        return 180.0 + degrees(atan(dy / dx))
    if dx == 0 and dy < 0:
        return 270.0
    return degrees(atan(dy / dx)) + 360.0


@pytest.mark.parametrize(
    ("dx", "dy", "expected"),
    [(1, 1, 45.0), (0, 2, 90.0), (-1, 1, 135.0), (-1, -1, 225.0), (0, -2, 270.0), (1, -1, 315.0)],
)
def test_4_1_each_case(dx: int, dy: int, expected: float) -> None:
    assert azimuth(np.array([[dx, dy]], float))[0] == pytest.approx(expected)


@given(dx=coordinates, dy=coordinates)
def test_4_1_is_one_arctan2(dx: float, dy: float) -> None:
    if dx or dy:
        engine = azimuth(np.array([[dx, dy]]))[0]
        assert abs((engine - paper_azimuth(dx, dy) + 180) % 360 - 180) < 1e-9


@given(dx=coordinates, dy=coordinates, d=st.floats(0.5, 20.0), r=st.floats(0.1, 5.0))
def test_4_2_offset_of_point_1(dx: float, dy: float, d: float, r: float) -> None:
    if abs(dx) + abs(dy) < 0.01:
        return
    beta = radians(paper_azimuth(dx, dy))
    expected = [d * sin(beta) + r * cos(beta), -d * cos(beta) + r * sin(beta)]
    engine = head_offset(np.zeros((1, 2)), np.array([[dx, dy]]), VCutter(d, r, 45.0))
    np.testing.assert_allclose(engine, [expected], atol=1e-9)


def test_4_2_worked_by_hand_at_three_azimuths() -> None:
    # d 6, r 1.5: due north Δ = (6, 1.5); at 45° (7.5, -4.5)/√2; due west (-1.5, 6).
    cutter = VCutter(6.0, 1.5, 45.0)
    ends = np.array([[0.0, 10.0], [10.0, 10.0], [-10.0, 0.0]])
    expected = [[6.0, 1.5], [7.5 / 2**0.5, -4.5 / 2**0.5], [-1.5, 6.0]]
    np.testing.assert_allclose(head_offset(np.zeros((3, 2)), ends, cutter), expected, atol=1e-12)


def test_blade_of_length_l_is_offset_by_l_sin_theta() -> None:
    cutter = VCutter(back=12.0 * sin(radians(30.0)), half_width=1.5, tilt=30.0)
    assert cutter.length == pytest.approx(12.0)


def test_section_3_oblique_interpolation_lifts_to_the_right_and_plunges_to_the_left() -> None:
    # Travel due east, blade at 30°: 3 mm up is 3 tan 30° = 1.732 mm south.
    cutter = VCutter(back=6.0, half_width=1.5, tilt=30.0)
    start, end = np.zeros((2, 2)), np.array([[10.0, 0.0]] * 2)
    moved = sideways_move(start, end, cutter, np.array([3.0, -3.0]))
    np.testing.assert_allclose(moved, [[0.0, -1.7320508], [0.0, 1.7320508]], atol=1e-7)


@pytest.mark.parametrize(("length", "degrees"), [(10.0, 0.057), (1.0, 0.573), (0.1, 5.739)])
def test_4_3_the_listing_is_off_by_what_we_say_it_is_and_we_are_not(
    length: float, degrees: float
) -> None:
    # An edge that leaves its axis by just less than 0.01 mm is taken for the axis: asin(0.01 / L).
    turn = np.radians(AZIMUTHS)
    ends = length * np.column_stack([np.cos(turn), np.sin(turn)])
    error = np.abs((listing_azimuth(*ends.T) - AZIMUTHS + 180) % 360 - 180).max()
    assert error == pytest.approx(degrees, abs=1.5e-3)
    engine = np.abs((azimuth(ends) - AZIMUTHS + 180) % 360 - 180).max()
    assert engine < 1e-10


@pytest.mark.parametrize(("length", "d", "off"), [(0.1, 10.0, 1.012), (1.0, 6.0, 0.0618)])
def test_4_3_so_the_listings_tip_is_off_by_the_arm_times_that(
    length: float, d: float, off: float
) -> None:
    # √(d² + r²) · 2 sin(error / 2): √102.25 · 0.1001 and √38.25 · 0.0100.
    listing, engine = largest_errors(length, d)
    assert listing == pytest.approx(off, rel=2e-3)
    assert engine < 1e-14


def test_4_3_the_table_in_the_docs_is_what_comes_out() -> None:
    assert PAGE.read_text(encoding="utf-8") == page()


def test_4_3_the_listing_sends_an_edge_without_length_due_south() -> None:
    assert listing_azimuth(np.zeros(1), np.zeros(1))[0] == pytest.approx(270.0, abs=1e-3)
    with pytest.raises(ZeroLengthEdge):
        head_offset(np.zeros((1, 2)), np.zeros((1, 2)), VCutter(4.0, 1.5, 45.0))


def test_point_2_and_4_are_mirrors_of_3_and_1() -> None:
    # "point 1 and point 4 are symmetrical about A point, and point 2 and point 3 about B".
    a, b = np.array([[3.0, 4.0]]), np.array([[33.0, 44.0]])
    out = head_offset(a, b, VCutter(4.0, 1.5, 45.0))
    back = head_offset(b, a, VCutter(4.0, 1.5, 45.0))
    np.testing.assert_allclose(out, -back)
    # β = 53.13°: sin 0.8, cos 0.6, so Δ = (4·0.8 + 1.5·0.6, -4·0.6 + 1.5·0.8).
    np.testing.assert_allclose(out, [[4.1, -1.2]])
    assert cos(radians(53.130102)) == pytest.approx(0.6)
