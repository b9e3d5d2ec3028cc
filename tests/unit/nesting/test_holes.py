"""Parts in holes of others: shapely confirms gaps and turns, and the program cuts them first."""

from __future__ import annotations

import random

import numpy as np
import pytest
import shapely
from shapely import Polygon, affinity

from knifetip.geometry.columns import F64
from knifetip.model.dieline import LineType
from knifetip.nesting.arrangement import Arrangement, FilledSheet, Place
from knifetip.nesting.holes import fill_holes
from knifetip.nesting.inner_fit import lowest_position
from knifetip.nesting.parts import make_part
from knifetip.nesting.problem import Problem
from knifetip.nesting.search import Found, nest
from tests.support.shapes import closed, dieline
from tests.unit.nesting.test_nest import HALF, QUARTERS, SHEET, check, part, placed_shapes

FRAME = Polygon(shapely.box(0, 0, 200, 150).exterior, [shapely.box(20, 20, 180, 130).exterior])
SMALL = shapely.box(0.0, 0.0, 40.0, 30.0)


def nested(problem: Problem) -> Found:
    """The first arrangement, which is that of boxes in columns."""
    reported: list[Found] = []
    return nest(problem, reported.append, lambda: bool(reported))


def test_small_parts_lie_in_the_hole_of_a_large_one() -> None:
    parts = [part(SMALL, HALF, 9), part(FRAME, HALF, 1)]
    found = nested(Problem(parts, [SHEET], 5.0, 60.0))
    check(found.arrangement, parts, [SMALL, FRAME], 5.0)
    # Three columns and three rows of 40 × 30 mm do not fit into 150 × 100 mm with gaps of 5 mm.
    assert found.in_holes == 6
    frame = placed_shapes(found.arrangement.sheets[0], [SMALL, FRAME])[0]
    hole = Polygon(frame.interiors[0])
    within = [
        hole.contains(one) for one in placed_shapes(found.arrangement.sheets[0], [SMALL, FRAME])
    ]
    assert sum(within) == 6
    without = nested(Problem(parts, [SHEET], 5.0, 60.0, in_holes=False))
    assert without.in_holes == 0
    assert found.use > without.use


@pytest.mark.parametrize("seed", range(12))
def test_random_parts_in_holes_keep_the_gap_and_their_turns(seed: int) -> None:
    numbers = random.Random(seed)
    turns = numbers.choice([HALF, QUARTERS, tuple(np.arange(0.0, 360.0, 30.0).tolist())])
    angles = np.sort([numbers.uniform(0.0, 2.0 * np.pi) for _ in range(8)])
    star = Polygon(
        [(100 + numbers.uniform(50, 90) * np.cos(a), 100 + 80 * np.sin(a)) for a in angles]
    )
    host = Polygon(shapely.box(0, 0, 200, 200).exterior, [star.convex_hull.exterior])
    ring = Polygon(
        shapely.Point(0, 0).buffer(25.0).exterior, [shapely.Point(0, 0).buffer(15.0).exterior]
    )
    notched = Polygon([(0, 0), (30, 0), (30, 10), (10, 10), (10, 20), (0, 20)])
    shapes = [host, ring, notched, shapely.box(0, 0, 8, 8)]
    parts = [part(shape, turns, n) for shape, n in zip(shapes, (2, 3, 5, 9), strict=True)]
    gap = numbers.choice([0.0, 2.0, 4.0])
    found = nested(Problem(parts, [SHEET], gap, 60.0, seed))
    check(found.arrangement, parts, shapes, gap)
    assert found.in_holes > 3


def test_holes_of_parts_in_holes_are_filled() -> None:
    inner = affinity.scale(FRAME, 0.5, 0.5, origin=(0.0, 0.0))
    tiny = shapely.box(0.0, 0.0, 30.0, 20.0)
    parts = [part(FRAME, (0.0,)), part(inner, (0.0,)), part(tiny, (0.0,))]
    filled = fill_holes(Problem(parts, [SHEET], 2.0, 60.0))
    assert [one.quantity for one in filled.problem.parts] == [1]
    found = nested(Problem(parts, [SHEET], 2.0, 60.0))
    check(found.arrangement, parts, [FRAME, inner, tiny], 2.0)
    assert found.in_holes == 2


def test_a_part_lies_in_a_hole_only_where_all_turns_of_the_host_permit_it() -> None:
    # The grain of the small part permits half turns; the frame may be turned by 90°.
    parts = [part(FRAME, QUARTERS), part(SMALL, HALF, 2)]
    assert nested(Problem(parts, [SHEET], 2.0, 60.0)).in_holes == 0
    mirrored = [
        make_part(one, [shape], HALF, mirror=True, quantity=2)
        for one, shape in (
            (
                dieline((LineType.CUT, closed((0, 0), (40, 0), (0, 30)))),
                Polygon([(0, 0), (40, 0), (0, 30)]),
            ),
        )
    ]
    found = nested(Problem([part(FRAME, HALF), *mirrored], [SHEET], 2.0, 60.0))
    assert found.in_holes == 2


@pytest.mark.parametrize("turn", QUARTERS)
@pytest.mark.parametrize("mirror", [False, True])
def test_parts_in_a_hole_turn_with_the_host(turn: float, mirror: bool) -> None:
    hole = shapely.box(20, 60, 180, 140)  # beside the middle
    shape = Polygon(shapely.box(0, 0, 200, 150).exterior, [hole.exterior])
    ends = np.concatenate(
        [np.stack((ring[:-1], ring[1:]), axis=1) for ring in map(_corners, (shape, hole))]
    )
    host = make_part(dieline((LineType.CUT, ends)), [shape], QUARTERS, mirror=mirror)
    parts = [host, part(SMALL, QUARTERS, 4)]
    filled = fill_holes(Problem(parts, [SHEET], 5.0, 60.0))
    sheet = FilledSheet(SHEET, (Place(0, turn, 30.0, 40.0),))
    (expanded,) = filled.expand(Arrangement((sheet,))).sheets
    shapes = [affinity.scale(shape, -1.0 if mirror else 1.0, origin=(0.0, 0.0)), SMALL]
    frame, *small = placed_shapes(expanded, shapes)
    assert frame.bounds[:2] == pytest.approx((30.0, 40.0))
    assert len(small) == 4
    inner = Polygon(frame.interiors[0])
    assert all(inner.buffer(-4.99).contains(one) for one in small)


def _corners(polygon: Polygon) -> F64:
    return np.array(polygon.exterior.coords)


def test_a_hole_with_lines_in_it_stays_empty() -> None:
    outline, hole = np.array(FRAME.exterior.coords), np.array(FRAME.interiors[0].coords)
    ends = [np.stack((ring[:-1], ring[1:]), axis=1) for ring in (outline, hole)]
    rule = np.array([[[100.0, 20.0], [100.0, 130.0]]])
    crossed = make_part(
        dieline((LineType.CUT, np.concatenate(ends)), (LineType.CREASE, rule)), [FRAME], HALF
    )
    assert crossed.holes == ()
    assert len(part(FRAME).holes) == 1


def test_equal_hosts_share_the_small_parts() -> None:
    parts = [part(FRAME, HALF, 3), part(SMALL, HALF, 14)]
    filled = fill_holes(Problem(parts, [SHEET], 5.0, 60.0))
    assert [(one.quantity, round(one.area.area)) for one in filled.problem.parts] == [
        (2, round(FRAME.area + 6 * SMALL.area)),
        (1, round(FRAME.area + 2 * SMALL.area)),
    ]


@pytest.mark.parametrize("seed", range(20))
def test_the_lowest_position_of_convex_shapes(seed: int) -> None:
    numbers = np.random.default_rng(seed)
    area = shapely.convex_hull(shapely.multipoints(numbers.uniform(0.0, 100.0, (12, 2))))
    shape = shapely.convex_hull(shapely.multipoints(numbers.uniform(0.0, 25.0, (6, 2))))
    corners = shapely.get_coordinates(shape)[:-1]
    shift = lowest_position(area, corners)
    assert shift is not None
    assert shapely.covers(area.buffer(1e-5), affinity.translate(shape, *shift))
    # No position is lower, by a search on a grid.
    grid = np.stack(np.meshgrid(np.arange(-30, 100, 2.0), np.arange(-30, 100, 2.0)), -1).reshape(
        -1, 2
    )
    moved = shapely.polygons(corners + grid[:, None])
    assert grid[shapely.covers(area, moved), 1].min() >= shift[1] - 1e-6


def test_a_shape_that_does_not_fit_has_no_position() -> None:
    assert lowest_position(shapely.box(0, 0, 10, 10), np.array([(0, 0), (11, 0), (0, 5)])) is None
    bent = Polygon([(0, 0), (30, 0), (30, 10), (10, 10), (10, 30), (0, 30)])
    assert lowest_position(bent, np.array([(0.0, 0), (12, 0), (12, 12), (0, 12)])) is None
