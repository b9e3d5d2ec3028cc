"""Lines too near to each other for the board, and lines of which only one is made."""

from __future__ import annotations

from dataclasses import replace
from math import pi, radians, tan
from typing import Any

import numpy as np
import pytest

from knifetip import clean, compensate, plan, process, sequence
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.verdict import Finding, Severity
from knifetip.verification.checks.lines.replaced_lines import note_replaced
from knifetip.verification.verify import verify
from tests.support.shapes import closed, dieline, edges

MACHINE, BOARD = load.machine("demo-table"), load.board("greyboard-3.0")
OUTLINE = (LineType.CUT, closed((0, 0), (400, 0), (400, 300), (0, 300)))
CUT, CREASE, GROOVE, HALF = LineType.CUT, LineType.CREASE, LineType.V_GROOVE, LineType.HALF_CUT
Ends = tuple[tuple[float, float], tuple[float, float]]


def near_findings(line: Dieline, machine: Machine = MACHINE, board: Board = BOARD) -> list[Finding]:
    toolpath = sequence([compensate(one) for one in plan(line, machine, board)], machine)
    verdict = verify(process(toolpath, machine, "grblhal").text, line, (0.0, 0.0), machine, board)
    return [finding for finding in verdict.findings if finding.kind == "near"]


def two(kind: LineType, other: LineType, distance: float, long: float = 200.0) -> Dieline:
    """Return an outline and two horizontal lines, edges 4 and 5."""
    first, second = (edges(((100, y), (100 + long, y))) for y in (150.0, 150.0 + distance))
    return dieline(OUTLINE, (kind, first), (other, second))


def said(finding: Finding) -> dict[str, Any]:
    return dict(finding.message.arguments)


@pytest.mark.parametrize("kind", [CUT, CREASE, HALF])
@pytest.mark.parametrize("distance", [0.06, 0.5, 2.9])
def test_two_equal_lines_side_by_side_may_be_one_drawn_twice(
    kind: LineType, distance: float
) -> None:
    [found] = near_findings(two(kind, kind, distance))
    assert (found.message.code, found.severity) == ("verify.drawn-twice", Severity.SHORTFALL)
    assert found.edge == 5
    assert said(found)["distance"] == pytest.approx(distance, abs=1e-3)
    assert said(found)["length"] == pytest.approx(200.0, abs=2.0)


@pytest.mark.parametrize("kind", [CUT, CREASE, HALF])
def test_lines_as_far_apart_as_the_board_is_thick_are_not_reported(kind: LineType) -> None:
    assert near_findings(two(kind, kind, 3.0)) == []


@pytest.mark.parametrize(("kind", "other"), [(CUT, CREASE), (CREASE, CUT), (CUT, HALF)])
def test_a_mark_beside_a_cut_is_a_note(kind: LineType, other: LineType) -> None:
    [found] = near_findings(two(kind, other, 1.4))
    assert (found.message.code, found.severity) == ("verify.narrow-lines", Severity.NOTE)
    assert near_findings(two(kind, other, 1.6)) == []


def windows(strip: float) -> Dieline:
    left = closed((50, 50), (100, 50), (100, 120), (50, 120))
    return dieline(OUTLINE, (CUT, left), (CUT, np.add(left, (50.0 + strip, 0.0))))


def test_a_narrow_strip_between_two_windows_is_a_note() -> None:
    [found] = near_findings(windows(0.5))
    assert (found.message.code, found.severity) == ("verify.narrow-cuts", Severity.NOTE)
    assert said(found)["length"] == pytest.approx(70.0, abs=2.0)
    assert near_findings(windows(3.1)) == []


def test_a_slot_narrower_than_the_board_is_a_note() -> None:
    slot = closed((50, 50), (110, 50), (110, 51), (50, 51))
    [found] = near_findings(dieline(OUTLINE, (CUT, slot)))
    assert (found.message.code, found.severity) == ("verify.narrow-cuts", Severity.NOTE)
    assert said(found)["distance"] == pytest.approx(1.0, abs=1e-3)
    assert said(found)["length"] == pytest.approx(60.0, abs=2.0)


def test_an_outline_and_its_copy_are_one_finding() -> None:
    copy = closed((0.3, 0.3), (399.7, 0.3), (399.7, 299.7), (0.3, 299.7))
    [found] = near_findings(dieline(OUTLINE, (CUT, copy)))
    assert found.message.code == "verify.drawn-twice"
    assert said(found)["length"] == pytest.approx(1398.0, rel=0.01)


def test_a_circle_and_a_polygon_on_it_are_one_finding() -> None:
    half = edges(((190, 150), (210, 150)), ((210, 150), (190, 150)))
    turn = np.radians(np.arange(7.5, 360.0, 15.0))
    ring = closed(*map(tuple, np.column_stack([200 + 10 * np.cos(turn), 150 + 10 * np.sin(turn)])))
    line = dieline(OUTLINE, (CUT, half), (CUT, ring), bulge={4: 1.0, 5: 1.0})
    assert "verify.drawn-twice" in {one.message.code for one in near_findings(line)}


@pytest.mark.parametrize("degrees", [5.0, 20.0, 45.0, 90.0])
def test_lines_that_meet_at_an_angle_are_not_side_by_side(degrees: float) -> None:
    tip = (150 + 100 * np.cos(radians(degrees)), 150 + 100 * np.sin(radians(degrees)))
    line = dieline(OUTLINE, (CREASE, edges(((150, 150), (250, 150)), ((150, 150), tip))))
    assert near_findings(line) == []


def test_the_round_corner_of_one_contour_is_no_second_line() -> None:
    bend = edges(((100, 100), (200, 100)), ((200, 100), (202, 102)), ((202, 102), (202, 200)))
    assert near_findings(dieline(OUTLINE, (CUT, bend), bulge={5: tan(pi / 8.0)})) == []


def test_grooves_nearer_than_they_are_wide_have_no_ridge() -> None:
    board = load.board("greyboard-2.0")
    # 1.3 mm deep at 45°: each groove is 2.6 mm wide in the top face.
    [found] = near_findings(two(GROOVE, GROOVE, 2.5), board=board)
    assert (found.message.code, found.severity) == ("verify.grooves-meet", Severity.SHORTFALL)
    assert said(found)["width"] == pytest.approx(2.6)
    assert near_findings(two(GROOVE, GROOVE, 2.7), board=board) == []


def test_grooves_that_meet_at_an_acute_angle_have_no_ridge() -> None:
    board = load.board("greyboard-2.0")
    tip = (200.0, 150.0 + 100.0 * tan(radians(2.9)))
    line = dieline(OUTLINE, (GROOVE, edges(((100, 150), (200, 150)), ((100, 150), tip))))
    [found] = near_findings(line, board=board)
    # The strips part where the lines are 2.6 mm apart: 2.6 / tan 2.9° = 51 mm from the tip.
    assert said(found)["length"] == pytest.approx(51.3, abs=2.0)


def test_a_thinner_board_holds_a_narrower_strip() -> None:
    assert len(near_findings(windows(1.0), board=replace(BOARD, caliper=1.2))) == 1
    assert near_findings(windows(1.3), board=replace(BOARD, caliper=1.2)) == []


@pytest.mark.parametrize(
    ("below", "above", "named"),
    [(CREASE, GROOVE, True), (HALF, GROOVE, True), (CREASE, HALF, True), (CREASE, CUT, False)],
)
def test_a_fold_under_another_fold_is_noted(below: LineType, above: LineType, named: bool) -> None:
    line = two(below, above, 0.0)
    notes = note_replaced(line, clean(line))
    assert [(one.edge, one.severity) for one in notes] == ([(4, Severity.NOTE)] if named else [])
    if named:
        assert said(notes[0]) == {
            "type": below.word, "other": above.word, "length": pytest.approx(200.0)
        }  # fmt: skip
