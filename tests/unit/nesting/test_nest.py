"""Blanks that are placed on sheets: shapely confirms gaps, margins and turns."""

from __future__ import annotations

import itertools
import random
from collections.abc import Generator, Sequence

import numpy as np
import pytest
import shapely
from shapely import Polygon, affinity

from knifetip.errors import PlanError
from knifetip.model.dieline import LineType
from knifetip.nesting import fit
from knifetip.nesting.arrangement import (
    Arrangement,
    Board,
    FilledSheet,
    Place,
    is_free_of_collisions,
)
from knifetip.nesting.engine import PlacedShape, Shape, Strip, StripFilling, fill_strip
from knifetip.nesting.parts import Part, make_part
from knifetip.nesting.problem import Problem
from knifetip.nesting.search import Found, nest
from tests.support.shapes import dieline

HALF = (0.0, 180.0)
QUARTERS = (0.0, 90.0, 180.0, 270.0)
SHEET = Board(600.0, 400.0, (10.0, 15.0, 595.0, 390.0), None)


def part(shape: Polygon, turns: Sequence[float] = QUARTERS, quantity: int = 1) -> Part:
    """A part whose cuts are the outline and the holes of a polygon."""
    rings = [np.array(ring.coords) for ring in (shape.exterior, *shape.interiors)]
    ends = np.concatenate([np.stack((ring[:-1], ring[1:]), axis=1) for ring in rings])
    return make_part(dieline((LineType.CUT, ends)), [shape], turns, quantity=quantity)


def random_polygon(numbers: random.Random) -> Polygon:
    """A star-shaped polygon of 3 to 12 corners, some with a hole."""
    angles = sorted(numbers.uniform(0.0, 2.0 * np.pi) for _ in range(numbers.randint(3, 12)))
    radius = numbers.uniform(20.0, 60.0)
    corners = [
        (radius * f * np.cos(a), radius * f * np.sin(a))
        for a, f in ((a, numbers.uniform(0.4, 1.0)) for a in angles)
    ]
    shape = Polygon(corners).buffer(0.0)
    if shape.geom_type != "Polygon" or shape.area < 100.0:
        shape = shapely.box(0.0, 0.0, radius, radius)
    hole = shape.representative_point().buffer(2.0, quad_segs=2)
    return Polygon(shape.exterior, [hole.exterior]) if shape.contains(hole) else shape


def placed_shapes(sheet: FilledSheet, shapes: Sequence[Polygon]) -> list[Polygon]:
    """The polygons on a sheet, by shapely alone: turned, then moved to the corner of their box."""
    found = []
    for place in sheet.places:
        turned = affinity.rotate(shapes[place.part], place.turn, origin=(0.0, 0.0))
        low_x, low_y, *_ = turned.bounds
        found.append(affinity.translate(turned, place.x - low_x, place.y - low_y))
    return found


def check(
    arrangement: Arrangement, parts: Sequence[Part], shapes: Sequence[Polygon], gap: float
) -> None:
    counts = [0] * len(parts)
    for sheet in arrangement.sheets:
        window = shapely.box(*sheet.board.window)
        placed = placed_shapes(sheet, shapes)
        for one in placed:
            assert shapely.covers(window.buffer(0.05), one)
        for one, other in itertools.combinations(placed, 2):
            assert shapely.distance(one, other) >= gap - 0.006
            assert shapely.intersection(one, other).area <= 1.0
        for place in sheet.places:
            counts[place.part] += 1
            assert place.turn in {turn for turn, _ in parts[place.part].boxes}
    assert counts == [one.quantity for one in parts]


@pytest.mark.parametrize("seed", range(20))
def test_random_polygons_keep_the_gap_the_margins_and_their_turns(seed: int) -> None:
    numbers = random.Random(seed)
    shapes = [random_polygon(numbers) for _ in range(numbers.randint(1, 5))]
    gap = numbers.choice([0.0, 1.0, 5.0])
    parts = [
        part(shape, numbers.choice([HALF, QUARTERS, tuple(range(0, 360, 15))]), 1 + seed % 4)
        for shape in shapes
    ]
    reported: list[Found] = []
    found = nest(Problem(parts, [SHEET], gap, 0.6, seed), reported.append)
    for one in reported:
        check(one.arrangement, parts, shapes, gap)
    assert found is reported[-1]
    uses = [one.use for one in reported]
    assert uses == sorted(uses)
    assert found.use >= found.columns_use


def test_true_shapes_take_less_board_than_rectangles() -> None:
    triangle = Polygon([(0.0, 0.0), (180.0, 0.0), (0.0, 180.0)])
    parts = [part(triangle, HALF, 4)]
    reported: list[Found] = []

    def is_good() -> bool:
        return bool(reported) and reported[-1].use > 1.2 * reported[-1].columns_use

    found = nest(Problem(parts, [SHEET], 2.0, 120.0), reported.append, is_good)
    check(found.arrangement, parts, [triangle], 2.0)
    assert is_good()


def test_copies_that_need_several_sheets_use_left_over_sheets_first() -> None:
    square = shapely.box(0.0, 0.0, 90.0, 90.0)
    tiny = Board(80.0, 80.0, (0.0, 0.0, 80.0, 80.0), 5)
    left_over = Board(220.0, 110.0, (0.0, 0.0, 220.0, 110.0), 2)
    parts = [part(square, HALF, 40)]
    found = nest(Problem(parts, [tiny, left_over, SHEET], 5.0, 1.0), lambda _: None)
    check(found.arrangement, parts, [square], 5.0)
    boards = [sheet.board.width for sheet in found.arrangement.sheets]
    assert boards == [220.0, 220.0, 600.0, 600.0]
    assert [len(sheet.places) for sheet in found.arrangement.sheets] == [2, 2, 24, 12]


def test_rectangles_without_a_gap_have_common_sides() -> None:
    parts = [part(shapely.box(0.0, 0.0, 100.0, 75.0), HALF, 25)]
    board = Board(500.0, 375.0, (0.0, 0.0, 500.0, 375.0), None)
    found = nest(Problem(parts, [board], 0.0, 1.0), lambda _: None)
    (sheet,) = found.arrangement.sheets
    assert found.use == pytest.approx(100.0)
    assert {place.x for place in sheet.places} == {0.0, 100.0, 200.0, 300.0, 400.0}


def test_stop_keeps_the_best_arrangement_so_far() -> None:
    triangle = Polygon([(0.0, 0.0), (180.0, 0.0), (0.0, 180.0)])
    parts = [part(triangle, HALF, 4)]
    reported: list[Found] = []
    found = nest(Problem(parts, [SHEET], 2.0, 600.0), reported.append, lambda: len(reported) > 1)
    assert found is reported[-1]
    assert len(reported) >= 2
    check(found.arrangement, parts, [triangle], 2.0)


def test_an_arrangement_of_the_engine_that_collides_is_not_kept(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    parts = [part(shapely.box(0.0, 0.0, 90.0, 90.0), HALF, 5)]

    def colliding(_strip: Strip, _stopped: object) -> Generator[StripFilling]:
        yield StripFilling(90.0, [PlacedShape(0, 0.0, 0.0, 50.0 * n) for n in range(5)])

    monkeypatch.setattr(fit, "fill_strip", colliding)
    found = nest(Problem(parts, [SHEET], 5.0, 1.0), lambda _: None)
    assert found.use == found.columns_use


@pytest.mark.parametrize(
    ("x", "y", "free"),
    [(105.0, 15.0, True), (104.99, 15.0, False), (105.0, 14.9, False), (506.0, 15.0, False)],
)
def test_collisions_are_found_by_gap_and_window(x: float, y: float, free: bool) -> None:
    parts = [part(shapely.box(0.0, 0.0, 90.0, 90.0), HALF, 2)]
    sheet = FilledSheet(SHEET, (Place(0, 0.0, 10.0, 15.0), Place(0, 0.0, x, y)))
    assert is_free_of_collisions(sheet, parts, 5.0) is free


def test_a_part_larger_than_all_sheets_is_refused_with_its_size() -> None:
    parts = [part(shapely.box(0.0, 0.0, 390.0, 30.0)), part(shapely.box(0.0, 0.0, 590.0, 376.0))]
    with pytest.raises(PlanError, match="part 2 of 590 × 376 mm fits on no sheet") as caught:
        nest(Problem(parts, [SHEET], 0.0, 1.0), lambda _: None)
    assert caught.value.message.code == "nesting.too-large"


def test_too_many_sheets_are_refused() -> None:
    parts = [part(shapely.box(0.0, 0.0, 500.0, 300.0), HALF, 101)]
    with pytest.raises(PlanError, match="more than 100 sheets"):
        nest(Problem(parts, [SHEET], 0.0, 1.0), lambda _: None)


def test_two_thousand_parts_are_placed_in_columns_at_once() -> None:
    parts = [part(shapely.box(0.0, 0.0, 20.0, 10.0), HALF, 2000)]
    reported: list[Found] = []
    found = nest(Problem(parts, [SHEET], 1.0, 60.0), reported.append, lambda: bool(reported))
    assert sum(len(sheet.places) for sheet in found.arrangement.sheets) == 2000


@pytest.mark.parametrize(
    "corners",
    [
        [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)],
        [(0.0, 0.0), (1.0, 0.0)],
        [(0.0, 0.0), (1.0, 0.0), (1.0, 900.0)],
    ],
)
def test_a_shape_on_which_the_engine_fails_gives_no_arrangement(
    corners: list[tuple[float, float]],
) -> None:
    strip = Strip(100.0, 0.0, [Shape(corners, 1, (0.0,))], 0.5, 0)
    assert list(fill_strip(strip, lambda: False)) == []


def test_outlines_that_touch_themselves_and_several_blanks_are_placed_as_one() -> None:
    touching = Polygon([(0, 0), (100, 0), (50, 50), (100, 100), (0, 100), (50, 50)]).buffer(0.0)
    ends = np.array([[[0.0, 0.0], [100.0, 0.0]], [[100.0, 0.0], [0.0, 100.0]]])
    two = make_part(
        dieline((LineType.CUT, ends)), list(shapely.get_parts(touching)), HALF, quantity=3
    )
    assert two.outline.covers(touching)
    found = nest(Problem([two], [SHEET], 2.0, 0.6), lambda _: None)
    assert sum(len(sheet.places) for sheet in found.arrangement.sheets) == 3


def test_the_outline_of_a_curve_contains_it_with_few_corners() -> None:
    disc = shapely.Point(0.0, 0.0).buffer(100.0, quad_segs=64)
    found = part(disc)
    assert len(found.outline.exterior.coords) <= 129
    assert found.outline.covers(disc)
    assert found.outline.difference(disc.buffer(0.21)).is_empty
