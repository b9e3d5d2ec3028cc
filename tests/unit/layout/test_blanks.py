"""Blanks of drawings whose areas are known."""

from __future__ import annotations

from math import pi

import pytest
from shapely import Polygon

from knifetip.geometry.columns import F64
from knifetip.layout.blanks import find_blanks
from knifetip.model.dieline import LineType
from knifetip.pipeline import clean
from tests.support.shapes import closed, dieline, edges

SQUARE = closed((0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0))


def blanks_of(*rows: tuple[LineType, F64]) -> list[Polygon]:
    return find_blanks(clean(dieline(*rows)).dieline)


def areas_of(*rows: tuple[LineType, F64]) -> list[float]:
    return [round(blank.area, 6) for blank in blanks_of(*rows)]


def test_a_blank_has_the_area_within_its_outline_without_its_holes() -> None:
    hole = closed((20.0, 20.0), (30.0, 20.0), (30.0, 40.0), (20.0, 40.0))
    fold = edges(((50.0, 0.0), (50.0, 80.0)))
    (blank,) = blanks_of((LineType.CUT, SQUARE), (LineType.CUT, hole), (LineType.CREASE, fold))
    assert blank.area == pytest.approx(100.0 * 80.0 - 10.0 * 20.0)
    assert len(blank.interiors) == 1
    assert blank.bounds == (0.0, 0.0, 100.0, 80.0)


def test_a_slit_from_the_outline_does_not_divide_a_blank() -> None:
    slit = edges(((50.0, 0.0), (50.0, 60.0)))
    assert areas_of((LineType.CUT, SQUARE), (LineType.CUT, slit)) == [8000.0]


def test_a_cut_from_side_to_side_divides_a_board_into_two_blanks() -> None:
    across = edges(((30.0, 0.0), (30.0, 80.0)))
    assert areas_of((LineType.CUT, SQUARE), (LineType.CUT, across)) == [5600.0, 2400.0]


def test_blanks_with_one_cut_between_them_are_two() -> None:
    neighbour = edges(
        ((100.0, 0.0), (150.0, 0.0)), ((150.0, 0.0), (150.0, 80.0)), ((150.0, 80.0), (100.0, 80.0))
    )
    assert areas_of((LineType.CUT, SQUARE), (LineType.CUT, neighbour)) == [8000.0, 4000.0]


def test_a_part_within_a_hole_is_a_blank_of_its_own() -> None:
    hole = closed((20.0, 20.0), (60.0, 20.0), (60.0, 60.0), (20.0, 60.0))
    inner = closed((30.0, 30.0), (50.0, 30.0), (50.0, 50.0), (30.0, 50.0))
    assert areas_of(*((LineType.CUT, shape) for shape in (SQUARE, hole, inner))) == [6400.0, 400.0]


def test_the_polygon_of_a_disc_is_within_its_circle_by_the_deviation() -> None:
    halves = edges(((-50.0, 0.0), (50.0, 0.0)), ((50.0, 0.0), (-50.0, 0.0)))
    disc = dieline((LineType.CUT, halves), bulge={0: 1.0, 1: 1.0})
    (blank,) = find_blanks(clean(disc).dieline)
    # A strip of at most 0.02 mm along the circle is missing, 2/3 of it on average.
    missing = pi * 50.0**2 - blank.area
    assert 0.0 < missing < 2.0 * pi * 50.0 * 0.02


def test_a_turned_outline_has_the_same_area() -> None:
    turned = closed((0.0, 0.0), (80.0, 60.0), (32.0, 124.0), (-48.0, 64.0))  # by 3-4-5
    (blank,) = blanks_of((LineType.CUT, turned))
    assert blank.area == pytest.approx(100.0 * 80.0, rel=1e-5)


def test_open_cuts_enclose_no_blank() -> None:
    assert areas_of((LineType.CUT, edges(((0.0, 0.0), (50.0, 0.0))))) == []
    assert areas_of((LineType.CREASE, SQUARE)) == []


def test_a_crumb_between_two_lines_is_no_blank() -> None:
    crumb = edges(((0.0, 10.0), (0.4, 12.0)), ((0.4, 12.0), (0.0, 14.0)))  # 0.8 mm²
    assert areas_of((LineType.CUT, SQUARE), (LineType.CUT, crumb)) == [7999.2]
