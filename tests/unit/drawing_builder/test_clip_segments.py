"""Lines and arcs clipped at rectangles, polygons, circles and shapes with holes."""

from __future__ import annotations

import math
import time

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from knifetip.drawing_builder.clip import UNCLIPPED, Clip, Region, union
from knifetip.drawing_builder.clip_segments import ClippedSegments, clip_segments
from knifetip.drawing_builder.filled_region import filled_region
from knifetip.geometry import arc
from knifetip.geometry.affine import IDENTITY, Matrix
from knifetip.svg.path_data import scan_paths

MARGIN = 0.02


def region(data: str, matrix: Matrix = IDENTITY, *, even_odd: bool = False) -> Region:
    table = scan_paths([data], 10_000)
    assert table is not None
    return filled_region(table, matrix, even_odd=even_odd)


def clipped(
    clip: Clip, *lines: tuple[float, float, float, float], bulge: float = 0.0
) -> list[list[float]]:
    pieces = pieces_of(clip, *lines, bulge=bulge)
    return [[round(float(one), 6) for one in ends] for ends in pieces.ends.reshape(-1, 4)]


def pieces_of(
    clip: Clip, *lines: tuple[float, float, float, float], bulge: float
) -> ClippedSegments:
    ends = np.array(lines, np.float64).reshape(-1, 2, 2)
    count = len(ends)
    return clip_segments(ends, np.full(count, bulge), np.zeros(count, np.int64), [clip], MARGIN)


SQUARE = UNCLIPPED.intersect_box((0.0, 0.0, 10.0, 10.0))
TRIANGLE = UNCLIPPED.intersect(region("M0 0H10L0 10Z"))
RING = UNCLIPPED.intersect(region("M0 0H30V30H0ZM10 10H20V20H10Z", even_odd=True))


def test_a_line_is_cut_at_a_rectangle() -> None:
    assert clipped(SQUARE, (-5, 5, 15, 5)) == [[0, 5, 10, 5]]


def test_lines_on_the_border_are_kept_and_lines_beyond_it_are_removed() -> None:
    assert clipped(SQUARE, (0, 0, 10, 0), (10.01, 1, 10.01, 9)) == [
        [0, 0, 10, 0],
        [10.01, 1, 10.01, 9],
    ]
    assert clipped(SQUARE, (10.1, 1, 10.1, 9)) == []


def test_a_line_along_the_border_ends_where_the_border_ends() -> None:
    assert clipped(TRIANGLE, (-5, 0, 15, 0)) == [[0, 0, 10, 0]]


def test_a_line_is_cut_at_a_polygon_and_at_the_hole_of_a_ring() -> None:
    assert clipped(TRIANGLE, (-5, 5, 15, 5)) == [[0, 5, 5, 5]]
    assert clipped(RING, (-5, 15, 35, 15)) == [[0, 15, 10, 15], [20, 15, 30, 15]]


def test_a_path_filled_by_the_nonzero_rule_has_no_hole() -> None:
    full = UNCLIPPED.intersect(region("M0 0H30V30H0ZM10 10H20V20H10Z"))
    assert clipped(full, (-5, 15, 35, 15)) == [[0, 15, 30, 15]]


def test_an_open_path_is_closed() -> None:
    assert clipped(UNCLIPPED.intersect(region("M0 0L10 0L0 10")), (-5, 5, 15, 5)) == [[0, 5, 5, 5]]


def test_overlapping_shapes_are_united_and_nested_clips_are_intersected() -> None:
    two = union([region("M0 0H10L0 10Z"), region("M8 0H20L8 12Z", even_odd=True)])
    assert clipped(UNCLIPPED.intersect(two), (-5, 1, 35, 1)) == [[0, 1, 19, 1]]
    assert clipped(TRIANGLE.intersect(region("M2 0H20V20H2Z")), (-5, 5, 15, 5)) == [[2, 5, 5, 5]]


def test_a_clip_path_without_shapes_shows_nothing() -> None:
    assert clipped(UNCLIPPED.intersect(union([])), (0, 0, 10, 0)) == []


def test_a_turned_rectangle_is_no_box() -> None:
    quarter = (0.0, 1.0, -1.0, 0.0, 0.0, 0.0)
    assert region("M0 0H10V5H0Z", quarter).is_rectangle
    assert not region("M0 0H10V5H0Z", (0.6, 0.8, -0.8, 0.6, 0.0, 0.0)).is_rectangle
    assert not region("M0 0L10 5L10 0L0 5Z").is_rectangle


def test_an_arc_is_cut_where_it_leaves_the_region() -> None:
    # A half circle with radius 10 around (0, 0), above the line y = 5 only.
    above = UNCLIPPED.intersect_box((-20.0, 5.0, 20.0, 20.0))
    pieces = pieces_of(above, (10, 0, -10, 0), bulge=1.0)
    assert_allclose(pieces.ends.reshape(-1), [75**0.5, 5, -(75**0.5), 5], atol=1e-9)
    assert_allclose(arc.sweep(pieces.bulge), [math.radians(120.0)])


def test_a_line_is_cut_at_a_circle_within_a_hundredth() -> None:
    circle = UNCLIPPED.intersect(region("M50 0A50 50 0 0 1 -50 0A50 50 0 0 1 50 0"))
    pieces = pieces_of(circle, (-99, 30, 99, 30), bulge=0.0)
    assert_allclose(pieces.ends.reshape(-1), [-40, 30, 40, 30], atol=0.02)


@given(
    st.lists(st.tuples(*[st.floats(-20.0, 20.0)] * 4), min_size=1, max_size=20),
    st.sampled_from([0.0, 0.3, -0.8, 1.0]),
    st.sampled_from([SQUARE, TRIANGLE, RING]),
)
def test_pieces_lie_on_their_segments_and_inside_the_region(
    lines: list[tuple[float, float, float, float]], bulge: float, clip: Clip
) -> None:
    lines = [line for line in lines if math.dist(line[:2], line[2:]) > 1e-3]
    pieces = pieces_of(clip, *lines, bulge=bulge)
    start, end = pieces.ends[:, 0], pieces.ends[:, 1]
    middle = arc.point_at(start, end, pieces.bulge, np.full(len(start), 0.5))
    low_x, low_y, high_x, high_y = clip.box
    slack = 3.0 * MARGIN
    assert (middle >= [low_x - slack, low_y - slack]).all()
    assert (middle <= [high_x + slack, high_y + slack]).all()
    whole = np.array(lines).reshape(-1, 2, 2)[pieces.source]
    turns = np.full(len(whole), bulge)
    share = arc.nearest_fraction(whole[:, 0], whole[:, 1], turns, middle)
    on = arc.point_at(whole[:, 0], whole[:, 1], turns, share)
    assert_allclose(on, middle, atol=1e-6)


@pytest.mark.parametrize("edges", [4_000, 16_000])
def test_clipping_takes_time_in_proportion_to_the_size_of_the_drawing(edges: int) -> None:
    turn = np.linspace(0.0, 2.0 * np.pi, edges + 1)
    radius = 40.0 + 5.0 * np.sin(edges / 40.0 * turn)
    points = np.stack([50.0 + radius * np.cos(turn), 50.0 + radius * np.sin(turn)], axis=1)
    star = Region(
        np.stack([points[:-1], points[1:]], axis=1), np.zeros(edges, np.int64), np.array([False])
    )
    start = np.random.default_rng(1).random((edges, 2)) * 100.0
    ends = np.stack([start, start + 1.0], axis=1)
    began = time.process_time()
    pieces = clip_segments(
        ends, np.zeros(edges), np.zeros(edges, np.int64), [UNCLIPPED.intersect(star)], MARGIN
    )
    assert not pieces.unlimited.any()
    assert time.process_time() - began < 5.0


def test_clipping_that_takes_too_long_is_left_out_and_reported() -> None:
    # Every edge crosses the whole height, so strips separate nothing.
    x = np.linspace(0.0, 100.0, 20_001)
    y = np.tile([0.0, 100.0], 10_001)[:20_001]
    points = np.stack([x, y], axis=1)
    comb = Region(
        np.stack([points[:-1], points[1:]], axis=1), np.zeros(20_000, np.int64), np.array([True])
    )
    ends = np.tile([[10.0, 50.0], [90.0, 50.5]], (20_000, 1, 1))
    clip = UNCLIPPED.intersect(comb)
    pieces = clip_segments(ends, np.zeros(20_000), np.zeros(20_000, np.int64), [clip], MARGIN)
    assert pieces.unlimited.all()
    assert_allclose(pieces.ends, ends)
