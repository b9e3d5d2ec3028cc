"""Areas that a disc cannot reach, computed by hand and compared with shapely."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely

from knifetip import compensate, plan, process, sequence
from knifetip.compensation.centre_paths import centre_paths
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.board import Board, Deflection
from knifetip.model.dieline import LineType
from knifetip.model.operation import Operation
from knifetip.model.verdict import Verdict
from knifetip.verification.verify import verify
from tests.support.shapes import closed, dieline
from tests.support.verdicts import has_faults

ROUTER = load.machine("router-table")
BOARD = load.board("greyboard-3.0")
R = 3.0
#: What a disc leaves in a right-angled corner: r² (tan 45° - π/4).
SQUARE = R**2 * (1.0 - math.pi / 4.0)
HOLE = closed((150, 150), (200, 150), (200, 190), (150, 190))
BLANK = closed((100, 100), (300, 100), (300, 250), (100, 250))


def verdict_of(
    *shapes: F64,
    bulge: dict[int, float] | None = None,
    board: Board = BOARD,
    at: tuple[float, float] = (0.0, 0.0),
) -> tuple[Verdict, list[Operation]]:
    line = dieline(*((LineType.CUT, shape) for shape in shapes), bulge=bulge or {})
    placed = replace(line, ends=line.ends + np.array(at))
    work = plan(placed, ROUTER, board)
    text = process(sequence([compensate(one) for one in work], ROUTER), ROUTER, "linuxcnc").text
    return verify(text, line, at, ROUTER, board), work


def by_engine(work: list[Operation]) -> float:
    return sum(float(centre_paths(one).unreached.sum()) for one in work if one.side != 0)


def by_shapely(*waste: shapely.Polygon) -> float:
    """Return the area that morphological opening with the disc removes."""
    total: float = sum(
        shape.area - shape.buffer(-R, quad_segs=400).buffer(R, quad_segs=400).area
        for shape in waste
    )
    return total


def test_a_square_hole_has_four_unreached_corners() -> None:
    verdict, work = verdict_of(HOLE, BLANK)
    assert not has_faults(verdict)
    np.testing.assert_allclose(verdict.areas.area, [SQUARE] * 4, atol=0.02)
    assert by_engine(work) == pytest.approx(4 * SQUARE, abs=1e-9)


def test_each_loop_goes_from_the_disc_to_the_corner_and_back_along_the_disc() -> None:
    areas = verdict_of(HOLE, BLANK)[0].areas
    assert list(np.diff(areas.first)) == [3, 3, 3, 3]
    loop = next(
        slice(a, b)
        for a, b in zip(areas.first[:-1], areas.first[1:], strict=True)
        if (areas.ends[a:b] == (150, 150)).all(axis=2).any()
    )
    ends, bulge = areas.ends[loop], areas.bulge[loop]
    # Down the left side to the corner, along the bottom, and back on a quarter of the disc.
    np.testing.assert_allclose(
        sorted(map(tuple, ends[:, 0])), [(150, 150), (150, 153), (153, 150)], atol=0.02
    )
    assert sorted(bulge)[1:] == [0.0, 0.0]
    assert min(bulge) == pytest.approx(-math.tan(math.pi / 8), abs=0.005)


def test_areas_are_in_drawing_coordinates() -> None:
    areas = verdict_of(HOLE, BLANK, at=(50.0, 20.0))[0].areas
    assert areas.ends.min(axis=(0, 1)) == pytest.approx((150.0, 150.0), abs=1e-9)


def test_convex_corners_have_no_unreached_area() -> None:
    verdict, _ = verdict_of(BLANK)
    assert len(verdict.areas) == 0


@pytest.mark.parametrize("wide", [2.0, 4.0, 5.9])
def test_a_slot_too_narrow_for_the_cutter_is_unreached_except_for_the_rim_of_the_disc(
    wide: float,
) -> None:
    low, high = 200 - wide / 2, 200 + wide / 2
    notched = closed(
        (100, 100), (300, 100), (300, 250), (high, 250), (high, 220), (low, 220), (low, 250),
        (100, 250),
    )  # fmt: skip
    verdict, _ = verdict_of(notched)
    assert not has_faults(verdict)
    # The disc hangs on both corners of the mouth: its segment reaches into the slot.
    half = math.asin(wide / 2 / R)
    segment = R**2 * (half - math.sin(half) * math.cos(half))
    (area,) = verdict.areas.area
    assert area == pytest.approx(30 * wide - segment, rel=2e-3)


def test_a_neck_is_unreached_on_both_sides() -> None:
    # Two chambers joined by a neck of 4 mm: no disc of 6 mm goes through.
    hole = closed(
        (130, 130), (160, 130), (160, 148), (180, 148), (180, 130), (210, 130), (210, 170),
        (180, 170), (180, 152), (160, 152), (160, 170), (130, 170),
    )  # fmt: skip
    verdict, _ = verdict_of(hole, BLANK)
    assert not has_faults(verdict)
    want = by_shapely(shapely.Polygon(hole[:, 0]))
    # A corner each, four to a chamber, and the neck between two discs.
    assert len(verdict.areas) == 9
    assert verdict.areas.area.sum() == pytest.approx(want, rel=5e-3)


@pytest.mark.parametrize("turn", [30, 60, 120, 150])
def test_the_area_in_a_corner_equals_the_formula(turn: int) -> None:
    phi = math.radians(turn)
    # A triangle whose corner at (150, 150) turns the disc by φ.
    inner = math.pi - phi
    hole = closed((150, 150), (210, 150), (150 + 60 * math.cos(inner), 150 + 60 * math.sin(inner)))
    verdict, work = verdict_of(hole + 10.0, closed((60, 60), (400, 60), (400, 400), (60, 400)))
    assert not has_faults(verdict)
    want = by_shapely(shapely.Polygon(hole[:, 0]))
    assert verdict.areas.area.sum() == pytest.approx(want, rel=0.02)
    corner = R**2 * (math.tan(phi / 2) - phi / 2)
    assert np.abs(verdict.areas.area - corner).min() < 0.02 * corner + 0.01
    assert by_engine(work) == pytest.approx(want, rel=5e-3)


def test_the_area_between_a_line_and_an_arc() -> None:
    # A half disc of 20 mm radius, standing on its diameter.
    hole = closed((150, 150), (190, 150))
    verdict, work = verdict_of(hole, BLANK, bulge={1: 1.0})
    assert not has_faults(verdict)
    full = shapely.Point(170, 150).buffer(20, quad_segs=400)
    want = by_shapely(shapely.intersection(full, shapely.box(140, 150, 200, 180)))
    assert len(verdict.areas) == 2
    assert verdict.areas.area.sum() == pytest.approx(want, rel=0.02)
    assert by_engine(work) == pytest.approx(want, rel=0.01)


def test_two_corners_on_a_short_edge_have_the_areas_of_both() -> None:
    # The bevel between two panels: 45° twice, 3.11 mm apart.
    bevelled = closed(
        (100, 100), (300, 100), (300, 200), (202.2, 200), (200, 202.2), (200, 250), (100, 250)
    )
    verdict, work = verdict_of(bevelled)
    assert not has_faults(verdict)
    corner = R**2 * (math.tan(math.pi / 8) - math.pi / 8)
    np.testing.assert_allclose(verdict.areas.area, [corner] * 2, rtol=0.05)
    assert by_engine(work) == pytest.approx(2 * corner, rel=1e-6)


def test_deflection_does_not_change_the_unreached_area() -> None:
    board = replace(BOARD, deflection=(Deflection("Router", 0.08, 0.05),))
    verdict, _ = verdict_of(HOLE, BLANK, board=board)
    assert not has_faults(verdict)
    np.testing.assert_allclose(verdict.areas.area, [SQUARE] * 4, rtol=0.06)
