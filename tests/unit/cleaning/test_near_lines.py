"""Lines that nearly coincide are merged, and nothing moves by more than the gap tolerance."""

from __future__ import annotations

import math

import numpy as np
import pytest

from knifetip.cleaning.clean import clean
from knifetip.cleaning.reattach import MergedLines, reattach
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.tolerance import GAP
from knifetip.messages import render
from knifetip.model.cleaned import Cleaned, CleaningReason
from knifetip.model.dieline import Dieline, LineType
from knifetip.verification.checks.cleaning.check import check_cleaning
from tests.support.shapes import closed, dieline, edges, rotation

CUT, CREASE = LineType.CUT, LineType.CREASE
PANEL = closed((0, 0), (160, 0), (160, 100), (0, 100))


def worked(made: Cleaned) -> I64:
    return np.flatnonzero(made.dieline.line_type != LineType.IGNORED)


def length(made: Cleaned) -> float:
    """Return the machined length (mm)."""
    line, rows = made.dieline, worked(made)
    return float(arc.length(line.ends[rows, 0], line.ends[rows, 1], line.bulge[rows]).sum())


def reasons(made: Cleaned) -> list[str]:
    return [CleaningReason(code).name for code in made.reason]


def assert_right(line: Dieline, made: Cleaned) -> None:
    """Assert that every drawn length has an outcome and nothing moves by more than ``GAP``."""
    assert check_cleaning(line, made) == []
    drawn = arc.length(line.ends[:, 0], line.ends[:, 1], line.bulge)
    np.testing.assert_allclose(made.kept + made.merged + made.dropped, drawn, atol=1e-6)
    assert made.moved.max() <= GAP + 1e-6
    assert made.off.max() <= GAP + 1e-6
    again = clean(made.dieline)
    np.testing.assert_array_equal(again.dieline.ends, made.dieline.ends)


@pytest.mark.parametrize("apart", [0.005, 0.01, 0.015, 0.02, 0.03, 0.04, 0.049])
@pytest.mark.parametrize("degrees", [0.0, 33.0, 90.0])
def test_an_outline_drawn_twice_is_one_outline(apart: float, degrees: float) -> None:
    turn = rotation(degrees)
    line = dieline((CUT, PANEL @ turn.T), (CUT, (PANEL + apart) @ turn.T))
    made = clean(line)
    # The first outline is machined as it was drawn.
    assert worked(made).tolist() == [0, 1, 2, 3]
    np.testing.assert_array_equal(made.dieline.ends[:4], line.ends[:4])
    assert made.merged[4:].sum() == pytest.approx(520.0, abs=4 * GAP)
    assert_right(line, made)


@pytest.mark.parametrize("bulge", [-0.236, 0.236])
@pytest.mark.parametrize("degrees", [0.0, 29.0, 117.0])
def test_an_arc_beside_a_much_larger_one_is_merged_with_it(bulge: float, degrees: float) -> None:
    """Chords of a circle of 1 mm, rounded to 0.01 mm, become arcs of other radii."""
    drawn = edges(((1.0, 0.0), (-1.0, 0.0)), ((0.87, 0.49), (0.85, 0.53))) @ rotation(degrees).T
    line = dieline((CUT, drawn), bulge={0: 1.0, 1: bulge})
    made = clean(line)
    assert worked(made).tolist() == [0]
    np.testing.assert_array_equal(made.dieline.ends[0], line.ends[0])
    assert_right(line, made)


@pytest.mark.parametrize("degrees", [0.0, 29.0, 60.0, 117.0])
def test_a_curl_drawn_twice_with_other_vertices_is_machined_once(degrees: float) -> None:
    """The directions of the chords, 0.06 mm long and 0.004 mm apart, differ by 1.2°."""
    turn = rotation(degrees)
    drawn = edges(
        ((0.0, 0.0), (0.054, -0.029)),
        ((0.054, -0.029), (0.081, -0.078)),
        ((0.0, 0.0), (0.051, -0.026)),
        ((0.051, -0.026), (0.081, -0.078)),
        ((0.0, 0.0), (-40.0, 0.0)),
        ((0.081, -0.078), (0.081, -40.0)),
    )
    line = dieline((CUT, drawn @ turn.T))
    made = clean(line)
    # Of each pair the longer chord stays.
    assert reasons(made)[1:3] == ["TWICE", "TWICE"]
    assert length(made) == pytest.approx(79.922 + 0.0613 + 0.06, abs=0.005)
    assert_right(line, made)


@pytest.mark.parametrize("apart", [0.003, 0.02, 0.04])
@pytest.mark.parametrize("radius", [0.3, 1.0])
def test_a_corner_drawn_twice_as_chords_with_other_vertices_is_one_arc(
    radius: float, apart: float
) -> None:
    """The joints of each copy are near those of the other one, but nothing ends there."""
    copies = []
    for size, chords in ((radius, 30), (radius + apart, 31)):
        turn = np.linspace(0.0, 0.5 * np.pi, chords + 1)
        corner = size * np.column_stack([np.cos(turn), np.sin(turn)])
        points = np.concatenate([[[size, -20.0]], corner, [[-20.0, size]]])
        copies.append(np.stack([points[:-1], points[1:]], axis=1))
    line = dieline((CUT, np.concatenate(copies)))
    made = clean(line)
    assert length(made) == pytest.approx(40.0 + radius * 0.5 * np.pi, abs=0.1)
    assert len(worked(made)) <= 4
    assert check_cleaning(line, made) == []


def polygon(count: int, radius: float, degrees: float = 0.0) -> F64:
    turn = np.radians(degrees) + 2.0 * np.pi * np.arange(count) / count
    return closed(*(radius * np.column_stack([np.cos(turn), np.sin(turn)])).tolist())


@pytest.mark.parametrize(
    ("radius", "count", "other", "degrees"),
    [
        (20.0, 70, 71, 0.0),  # one common vertex
        (20.0, 70, 70, 180.0 / 70.0),  # turned by half an edge
        (5.0, 35, 48, 11.0),
        (5.0, 35, 70, 0.0),  # every second vertex is common
        (1.0, 13, 18, 3.0),
        (50.0, 111, 111, 0.7),
    ],
)
@pytest.mark.parametrize("turned", [0.0, 33.0])
def test_a_circle_drawn_twice_as_coarse_polygons_is_one_polygon(
    radius: float, count: int, other: int, degrees: float, turned: float
) -> None:
    """The polygons are too coarse for an arc: at least 0.01 mm inside the circle."""
    assert radius * (1.0 - math.cos(math.pi / count)) > 0.01
    line = dieline(
        (CUT, polygon(count, radius, turned)), (CUT, polygon(other, radius, turned + degrees))
    )
    made = clean(line)
    assert len(worked(made)) == count
    assert length(made) == pytest.approx(2.0 * count * radius * math.sin(math.pi / count))
    assert made.merged.sum() == pytest.approx(2.0 * other * radius * math.sin(math.pi / other))
    assert set(reasons(made)[count:]) <= {"NEAR", "TWICE"}
    assert_right(line, made)


def test_a_rounded_panel_drawn_twice_with_other_corners_keeps_what_meets_the_copy() -> None:
    outlines = []
    for chords, size in ((8, 40.0), (11, 40.01)):
        corner = 5.0 * np.exp(1j * np.linspace(0.0, np.pi / 2.0, chords + 1)) + (size - 5.0) * (
            1 + 1j
        )
        points = np.concatenate([corner * 1j**k for k in range(4)])
        outlines.append(closed(*np.column_stack([points.real, points.imag]).tolist()))
    crease = edges(((-40.01, 0.0), (40.01, 0.0)))
    line = dieline((CUT, outlines[0]), (CUT, outlines[1]), (CREASE, crease))
    made = clean(line)
    cuts = worked(made)[made.dieline.line_type[worked(made)] == CUT]
    assert set(cuts.tolist()) <= set(range(36))
    (fold,) = np.flatnonzero(made.dieline.line_type == CREASE)
    np.testing.assert_allclose(np.abs(made.dieline.ends[fold, :, 0]), 40.0, atol=1e-6)
    assert_right(line, made)


@pytest.mark.parametrize("apart", [0.06, 0.3])
def test_polygons_of_circles_that_differ_by_more_stay_two(apart: float) -> None:
    line = dieline((CUT, polygon(70, 20.0)), (CUT, polygon(83, 20.0 + apart)))
    assert not clean(line).changed.any()


def test_short_lines_at_an_angle_of_more_than_20_degrees_stay_two() -> None:
    """Both ends of the second line are within 0.01 mm of the first one."""
    line = dieline((CUT, edges(((0.0, 0.0), (0.4, 0.0)), ((0.2, -0.0099), (0.25, 0.0099)))))
    assert length(clean(line)) == pytest.approx(0.4 + math.hypot(0.05, 0.0198))


def test_an_edge_with_both_ends_at_a_moved_point_keeps_its_length() -> None:
    ends = edges(((0.0, 0.0), (10.0, 0.0)), ((5.0, 0.02), (5.001, 0.021)))
    merged = MergedLines(
        np.array([[0.0, 0.02]]), np.array([[10.0, 0.02]]), np.zeros(1), np.zeros(1, np.int64)
    )
    moved = reattach(ends, np.zeros(2), np.array([0, 1, 2, 2]), merged)
    np.testing.assert_array_equal(moved, ends)


@pytest.mark.parametrize("apart", [0.05, 0.06, 0.1, 0.5])
def test_outlines_farther_apart_stay_two(apart: float) -> None:
    line = dieline((CUT, PANEL), (CUT, PANEL + apart))
    made = clean(line)
    assert not made.changed.any()
    assert length(made) == pytest.approx(1040.0)


@pytest.mark.parametrize("kind", [CUT, CREASE, LineType.HALF_CUT, LineType.PERFORATION])
@pytest.mark.parametrize("apart", [0.005, 0.02, 0.04, 0.06, 0.3])
def test_a_single_line_drawn_twice(kind: LineType, apart: float) -> None:
    line = dieline((kind, edges(((40, 50), (120, 50)), ((120, 50 + apart), (40, 50 + apart)))))
    made = clean(line)
    expected = 80.0 if apart < GAP else 160.0
    assert length(made) == pytest.approx(expected)
    assert reasons(made)[1] == ("AS_DRAWN" if apart > GAP else "NEAR" if apart > 0.01 else "TWICE")
    assert_right(line, made)


def test_a_merged_line_is_reported_with_its_distance() -> None:
    made = clean(dieline((CUT, edges(((0, 0), (80, 0)), ((0, 0.03), (80, 0.03))))))
    assert made.moved.tolist() == pytest.approx([0.0, 0.03])
    assert render(made.describe(1)) == (
        "the edge was drawn twice: it lies 0.03 mm beside edge 0 and was merged into it"
    )


@pytest.mark.parametrize("apart", [0.02, 0.04, 0.047])
def test_a_longer_copy_keeps_what_is_beyond_the_line(apart: float) -> None:
    line = dieline((CUT, edges(((0, 0), (80, 0)), ((40, apart), (120, apart)))))
    made = clean(line)
    assert length(made) == pytest.approx(120.0, abs=1e-4)
    # The rest of the copy starts at the end of the line.
    np.testing.assert_array_equal(made.dieline.ends[1], [[80, 0], [120, apart]])
    assert made.moved[1] == pytest.approx(apart)
    assert_right(line, made)


@pytest.mark.parametrize("apart", [0.02, 0.04, 0.047])
def test_one_long_line_over_three_short_ones(apart: float) -> None:
    line = dieline(
        (CUT, edges(((0, 0), (30, 0)), ((30, 0), (60, 0)), ((60, 0), (90, 0)))),
        (CUT, edges(((0, apart), (90, apart)))),
    )
    made = clean(line)
    assert length(made) == pytest.approx(90.0)
    assert_right(line, made)


@pytest.mark.parametrize("apart", [0.02, 0.04, 0.047])
def test_circles_and_panels_of_two_sizes(apart: float) -> None:
    ring = edges(((10, 0), (-10, 0)), ((-10, 0), (10, 0)))
    line = dieline(
        (CUT, ring), (CUT, ring * (1.0 + apart / 10.0)), bulge=dict.fromkeys(range(4), 1.0)
    )
    made = clean(line)
    assert len(worked(made)) == 2
    assert_right(line, made)
    larger = closed((-apart, -apart), (160 + apart, -apart), (160 + apart, 100 + apart))
    line = dieline((CUT, closed((0, 0), (160, 0), (160, 100))), (CUT, larger))
    made = clean(line)
    assert len(worked(made)) == 3
    assert_right(line, made)


@pytest.mark.parametrize("apart", [0.02, 0.04])
def test_the_common_cut_of_two_blanks_is_made_once(apart: float) -> None:
    one = closed((0, 0), (50, 0), (50, 40), (0, 40))
    other = closed((50 + apart, 0), (90, 0), (90, 40), (50 + apart, 40))
    line = dieline((CUT, one), (CUT, other))
    made = clean(line)
    assert length(made) == pytest.approx(180.0 + 120.0, abs=0.1)
    assert_right(line, made)


def test_a_crease_close_to_a_cut_is_cut() -> None:
    made = clean(dieline((CREASE, edges(((0, 0.03), (80, 0.03)))), (CUT, edges(((0, 0), (80, 0))))))
    assert worked(made).tolist() == [1]
    assert reasons(made) == ["NEAR", "AS_DRAWN"]


def curve(count: int, radius: float = 40.0) -> F64:
    turn = np.radians(np.linspace(0.0, 90.0, count))
    points = radius * np.column_stack([np.cos(turn), np.sin(turn)])
    return np.stack([points[:-1], points[1:]], axis=1)


def test_two_polylines_of_one_curve_with_other_vertices_are_one_arc() -> None:
    line = dieline((CUT, curve(91)), (CUT, curve(114, 40.03)))
    made = clean(line)
    assert len(worked(made)) == 1
    assert_right(line, made)


def test_lines_that_cross_or_touch_stay() -> None:
    crossing = edges(((0, 0), (100, 0)), ((0, -1), (100, 1)), ((50, 0), (50, 40)))
    line = dieline((CUT, crossing))
    assert not clean(line).changed.any()


@pytest.mark.parametrize("apart", [0.02, 0.04, 0.047])
@pytest.mark.parametrize("degrees", [0.0, 33.0, 90.0])
def test_ends_on_a_merged_line_follow_it(apart: float, degrees: float) -> None:
    copy = edges(((10, apart), (70, apart)))
    touching = edges(
        ((20, 20), (20, apart)),  # upright
        ((45, 20), (40, apart)),  # slanting, along its own line
        ((55, 20), (60, apart)), ((65, 20), (60, apart)),  # a corner on the line
        ((30, -20), (30, apart)),  # from the other side
    )  # fmt: skip
    turn = rotation(degrees)
    line = dieline(
        (CUT, edges(((0, 0), (80, 0))) @ turn.T), (CUT, copy @ turn.T), (CUT, touching @ turn.T)
    )
    made = clean(line)
    assert worked(made).tolist() == [0, 2, 3, 4, 5, 6]
    expected = (
        np.array([[20, 0], [40 - 5 * apart / (20 - apart), 0], [60, 0], [60, 0], [30, 0]]) @ turn.T
    )
    np.testing.assert_allclose(made.dieline.ends[2:, 1], expected, atol=1e-9)
    assert_right(line, made)


@pytest.mark.parametrize("first", ["circle", "polygon"])
@pytest.mark.parametrize(
    ("radius", "sides", "digits"),
    [
        *((5, 24, 3), (5, 72, 2), (20, 360, 2), (3, 360, 2), (1, 72, 2), (0.3, 24, 2)),
        *((10, 64, 2), (1, 360, 2), (0.3, 180, 2)),
    ],
)
def test_a_circle_over_its_polygon_is_one_circle(
    radius: float, sides: int, digits: int, first: str
) -> None:
    # Rounding to a few digits keeps the chords from becoming arcs.
    turn = 0.1 + np.arange(sides) * 2.0 * np.pi / sides
    corners = (radius * np.column_stack([np.cos(turn), np.sin(turn)])).round(digits)
    circle = edges(((radius, 0), (-radius, 0)), ((-radius, 0), (radius, 0)))
    parts = [(CUT, circle), (CUT, closed(*corners.tolist()))]
    begin = 0 if first == "circle" else sides
    line = dieline(*(parts if first == "circle" else parts[::-1]), bulge={begin: 1.0, begin + 1: 1})
    made = clean(line)
    assert worked(made).tolist() == [begin, begin + 1]
    assert length(made) == pytest.approx(2.0 * np.pi * radius)
    assert_right(line, made)


def test_a_polygon_farther_inside_its_circle_stays() -> None:
    turn = np.arange(24) * 2.0 * np.pi / 24
    corners = 30.0 * np.column_stack([np.cos(turn), np.sin(turn)])
    circle = edges(((30, 0), (-30, 0)), ((-30, 0), (30, 0)))
    line = dieline((CUT, circle), (CUT, closed(*corners.tolist())), bulge={0: 1.0, 1: 1.0})
    assert len(worked(clean(line))) == 26


@pytest.mark.parametrize("apart", [0.0, 0.03])
def test_a_chord_across_a_round_corner_stays(apart: float) -> None:
    # The chord is 0.1 mm from the middle of the arc.
    arc_ends = edges(((5, 0), (0, 5)))
    line = dieline(
        (CUT, arc_ends), (CUT, edges(((5 + apart, 0), (4, 3)))), bulge={0: 2.0**0.5 - 1.0}
    )
    assert len(worked(clean(line))) == 2


def test_a_short_edge_does_not_follow_a_merged_line_into_a_point() -> None:
    line = dieline(
        (CUT, edges(((0, 0), (80, 0)))),
        (CUT, edges(((10, 0.04), (70, 0.04)))),
        (CUT, edges(((30, 0.04), (30, 0.0)), ((30, 0.0), (30, -20)))),
    )
    made = clean(line)
    assert check_cleaning(line, made) == []
    ends = made.dieline.ends[worked(made)]
    assert np.hypot(*(ends[:, 1] - ends[:, 0]).T).min() > GAP
