"""Arcs and polylines as segments of at most half a turn."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from knifetip.dxf.shapes import (
    arc_segment_count,
    map_points,
    mirror_segments,
    polyline_segment_count,
    sweep_angle,
    write_arc,
    write_polyline,
)


@pytest.mark.parametrize(
    ("first", "last", "sweep"),
    [(0, 90, 90), (350, 10, 20), (90, 0, 270), (0, 360, 360), (45, 45, 0), (-90, 630, 360)],
)
def test_arc_turns_anticlockwise_to_its_end(first: float, last: float, sweep: float) -> None:
    assert sweep_angle(float(first), float(last)) == sweep


@pytest.mark.parametrize(("sweep", "rows"), [(90.0, 1), (180.0, 1), (181.0, 2), (360.0, 2)])
def test_no_row_turns_by_more_than_half_a_turn(sweep: float, rows: int) -> None:
    assert arc_segment_count(sweep) == rows


def test_circle_is_two_halves_that_meet_to_the_bit() -> None:
    ends, bulge = np.empty((2, 2, 2)), np.empty(2)
    assert write_arc(10.0, 20.0, 5.0, 0.0, 360.0, ends, bulge, 0) == 2
    assert_allclose(bulge, [1.0, 1.0])
    assert_array_equal(ends[0, 0], [15.0, 20.0])
    assert_array_equal(ends[1, 1], ends[0, 0])
    assert_array_equal(ends[0, 1], ends[1, 0])


def test_quarter_arc_has_the_bulge_of_22_and_a_half_degrees() -> None:
    ends, bulge = np.empty((1, 2, 2)), np.empty(1)
    write_arc(0.0, 0.0, 10.0, 0.0, 90.0, ends, bulge, 0)
    assert_allclose(ends, [[[10, 0], [0, 10]]], atol=1e-14)
    assert_allclose(bulge, [0.41421356237309503])


def test_bulge_of_three_quarters_of_a_turn_becomes_two_equal_arcs() -> None:
    # tan(270°/4): from (1, 0) anticlockwise by 270° to (0, -1), about the origin.
    vertex = np.array([[1.0, 0.0, 2.414213562373095], [0.0, -1.0, 0.0]])
    assert polyline_segment_count(vertex, 0, 2, closed=False) == 2
    ends, bulge = np.empty((2, 2, 2)), np.empty(2)
    assert write_polyline(vertex, 0, 2, False, ends, bulge, 0) == 2
    assert_allclose(ends[0, 1], [-np.sqrt(0.5), np.sqrt(0.5)], atol=1e-15)
    assert_allclose(bulge, [0.6681786379192989] * 2)


def test_closed_chain_ends_where_it_began() -> None:
    vertex = np.array([[0.0, 0.0, 0.0], [5.0, 0.0, 0.0], [5.0, 3.0, 0.0]])
    ends, bulge = np.empty((3, 2, 2)), np.empty(3)
    write_polyline(vertex, 0, 3, True, ends, bulge, 0)
    assert_array_equal(ends, [[[0, 0], [5, 0]], [[5, 0], [5, 3]], [[5, 3], [0, 0]]])


def test_mirrored_rows_count_x_to_the_left_and_turn_the_other_way() -> None:
    ends, bulge = np.array([[[1.0, 2.0], [3.0, 4.0]]]), np.array([0.5])
    mirror_segments(ends, bulge, 0, 1)
    assert_array_equal(ends, [[[-1, 2], [-3, 4]]])
    assert_array_equal(bulge, [-0.5])


def test_points_are_turned_and_shifted() -> None:
    quarter = np.array([[0.0, -1.0], [1.0, 0.0]])
    assert_array_equal(map_points(quarter, np.array([10.0, 0.0]), np.array([2.0, 3.0])), [7.0, 2.0])
