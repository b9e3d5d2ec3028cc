"""V-grooves that leave no ridge between them, compared with the areas of shapely."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import cos, radians, sin, tan
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from shapely import LineString

from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.verdict import Finding, Severity
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.lines.groove_flanks import check_groove_flanks
from knifetip.verification.expectation.edges import place_edges
from knifetip.verification.findings import Findings
from tests.support.shapes import dieline

MACHINE, BOARD = load.machine("demo-table"), load.board("greyboard-2.0")
#: half-width in the top face: 1.3 mm deep at 45°
HALF = 1.3
TIP = (100.0, 150.0)
Point = tuple[float, float]


def findings(*grooves: tuple[Point, Point], bulge: dict[int, float] | None = None) -> list[Finding]:
    drawn = dieline((LineType.V_GROOVE, np.array(grooves)), bulge=bulge)
    found = Findings()
    context = SimpleNamespace(
        edges=place_edges(drawn, (0.0, 0.0)), machine=MACHINE, board=BOARD, findings=found
    )
    check_groove_flanks(cast(CheckContext, context))
    return list(found.sorted())


def away(degrees: float, length: float = 80.0, start: Point = TIP) -> Point:
    return (
        start[0] + length * cos(radians(degrees)),
        start[1] + length * sin(radians(degrees)),
    )


def strip(start: Point, end: Point) -> Any:
    return LineString([start, end]).buffer(HALF, cap_style="flat")


def ridge_free_length(one: tuple[Point, Point], other: tuple[Point, Point]) -> float:
    """Return the length of the flank beside ``one`` that lies in the strip of ``other``."""
    flanks = [LineString(one).parallel_offset(HALF, side) for side in ("left", "right")]
    return max(float(flank.intersection(strip(*other)).length) for flank in flanks)


def said(finding: Finding) -> dict[str, Any]:
    return dict(finding.message.arguments)


@pytest.mark.parametrize("first", [0.0, 37.0])
@pytest.mark.parametrize("degrees", [1.2, 5.0, 9.8, 15.0, 30.0, 42.9])
def test_grooves_with_a_common_end_leave_no_ridge_at_an_acute_angle(
    degrees: float, first: float
) -> None:
    one, other = (TIP, away(first, 150.0)), (TIP, away(first + degrees, 150.0))
    [found] = findings(one, other)
    assert (found.message.code, found.severity) == (
        "verify.grooves-at-angle",
        Severity.SHORTFALL,
    )
    values = said(found)
    assert values["angle"] == pytest.approx(degrees)
    assert (values["x"], values["y"]) == pytest.approx(TIP)
    assert values["length"] == pytest.approx(ridge_free_length(one, other), rel=1e-4)
    assert values["length"] == pytest.approx(HALF / tan(radians(degrees / 2)), rel=1e-4)
    # The top face between the lines is gone as far as this length, and no farther.
    gone = strip(*one).union(strip(*other))
    inner = values["length"] / cos(radians(degrees / 2))
    for size, is_gone in ((0.999 * inner, True), (1.001 * inner, False)):
        middle = LineString([TIP, away(first + degrees / 2, size)])
        assert (middle.difference(gone).length < 1e-9) == is_gone


@pytest.mark.parametrize(
    ("degrees", "count"),
    [(43.2, 1), (45.0, 1), (60.0, 1), (79.0, 1), (80.0, 0), (90.0, 0), (120.0, 0), (179.0, 0)],
)
def test_grooves_at_a_greater_angle_lose_little_more_than_a_corner(
    degrees: float, count: int
) -> None:
    one, other = (TIP, away(0.0)), (TIP, away(degrees))
    found = findings(one, other)
    assert [note.severity for note in found] == [Severity.NOTE] * count
    corner = ridge_free_length((TIP, away(0.0)), (TIP, away(90.0)))
    assert ridge_free_length(one, other) <= corner + BOARD.caliper


@pytest.mark.parametrize(
    ("degrees", "count"), [(5.0, 1), (20.0, 1), (42.0, 1), (45.0, 1), (90.0, 0)]
)
@pytest.mark.parametrize("back", [0.0, 40.0, 1.0])
def test_grooves_that_cross_or_end_on_another_are_as_those_with_a_common_end(
    degrees: float, count: int, back: float
) -> None:
    whole = ((20.0, 150.0), (220.0, 150.0))
    start = away(degrees + 180.0, back)
    found = findings(whole, (start, away(degrees, 90.0)))
    assert len(found) == count
    for one in found:
        assert said(one)["length"] == pytest.approx(HALF / tan(radians(degrees / 2)), rel=0.01)
        assert said(one)["angle"] == pytest.approx(degrees)


@pytest.mark.parametrize(("gap", "count"), [(0.5, 1), (2.4, 1), (2.7, 0)])
def test_parallel_grooves_are_a_finding_if_they_are_nearer_than_wide(
    gap: float, count: int
) -> None:
    one, other = ((0.0, 0.0), (200.0, 0.0)), ((50.0, gap), (90.0, gap))
    found = findings(one, other)
    assert len(found) == count
    for finding in found:
        assert finding.message.code == "verify.grooves-meet"
        values = said(finding)
        assert values["distance"] == pytest.approx(gap)
        assert values["length"] == pytest.approx(ridge_free_length(one, other))
        assert values["width"] == pytest.approx(2.0 * HALF)


def test_grooves_side_by_side_for_a_short_length_are_no_finding() -> None:
    short = HALF + BOARD.caliper
    assert findings(((0.0, 0.0), (50.0, 0.0)), ((40.0, 1.0), (40.0 + short - 0.01, 1.0))) == []
    assert findings(((0.0, 0.0), (50.0, 0.0)), ((40.0, 1.0), (40.0 + short + 0.01, 1.0))) != []


def test_grooves_that_stop_before_they_meet_are_found() -> None:
    [found] = findings((away(0.0, 3.0), away(0.0)), (away(15.0, 3.0), away(15.0)))
    assert said(found)["angle"] == pytest.approx(15.0)
    assert said(found)["length"] == pytest.approx(HALF / tan(radians(7.5)) - 3.0, abs=0.2)


def test_every_pair_of_a_star_is_found() -> None:
    found = findings(*((TIP, away(25.0 * k)) for k in range(7)))
    angles = {
        severity: [said(one)["angle"] for one in found if one.severity == severity]
        for severity in (Severity.SHORTFALL, Severity.NOTE)
    }
    assert angles[Severity.SHORTFALL] == pytest.approx([25.0] * 6)
    assert sorted(angles[Severity.NOTE]) == pytest.approx([50.0] * 5 + [75.0] * 4)


def circle_chords(radius: float, first: float, last: float) -> list[Point]:
    """Return points on a circle about (0, radius), from angles (degrees) from its lowest point."""
    turn = np.radians(np.linspace(first, last, 2000))
    return [(radius * sin(t), radius - radius * cos(t)) for t in turn]


@pytest.mark.parametrize("radius", [40.0, 150.0])
@pytest.mark.parametrize("pieces", [1, 3, 12])
def test_an_arc_that_leaves_a_line_is_found_however_many_pieces_it_has(
    radius: float, pieces: int
) -> None:
    ends = [circle_chords(radius, 0.0, 60.0 * k / pieces)[-1] for k in range(pieces + 1)]
    arcs = list(pairwise(ends))
    bulge = {1 + k: tan(radians(60.0 / pieces) / 4.0) for k in range(pieces)}
    found = findings(((0.0, 0.0), (100.0, 0.0)), *arcs, bulge=bulge)
    assert len(found) == 1
    curve = LineString(circle_chords(radius, 0.0, 60.0)).buffer(HALF, cap_style="flat")
    flank = LineString([(0.0, HALF), (100.0, HALF)])
    # Where the two touch, the flank enters the strip very gradually.
    assert said(found[0])["length"] == pytest.approx(flank.intersection(curve).length, abs=0.2)


def test_an_arc_that_continues_a_line_is_one_groove() -> None:
    end = circle_chords(5.0, 0.0, 90.0)[-1]
    bent = {1: tan(radians(90.0) / 4.0)}
    drawn = ((-50.0, 0.0), (0.0, 0.0)), ((0.0, 0.0), end), (end, (5.0, 60.0))
    assert findings(*drawn, bulge=bent) == []


def chains(*corners: Sequence[Point]) -> list[tuple[Point, Point]]:
    return [pair for ring in corners for pair in zip(ring, [*ring[1:], ring[0]], strict=True)]


@pytest.mark.parametrize(("sides", "notes"), [(3, 3), (4, 0), (6, 0), (8, 0)])
def test_the_corners_of_trays_are_notes_at_most(sides: int, notes: int) -> None:
    ring = [away(360.0 * k / sides, 60.0) for k in range(sides)]
    found = findings(*chains(ring))
    assert [one.severity for one in found] == [Severity.NOTE] * notes


def test_the_creases_of_a_tray_that_cross_at_its_corners_are_no_finding() -> None:
    lines = [((0.0, y), (200.0, y)) for y in (50.0, 100.0)]
    assert findings(*lines, *(((x, 0.0), (x, 150.0)) for x in (50.0, 150.0))) == []
