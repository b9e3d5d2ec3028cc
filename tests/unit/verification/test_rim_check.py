"""Rims of crease wheels that are narrow or wide for the board."""

from __future__ import annotations

from dataclasses import replace

import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.tool import CreaseWheel
from knifetip.model.verdict import Finding, Severity
from knifetip.verification.verify import verify
from tests.support.shapes import closed, dieline, edges

MACHINE = load.machine("demo-table")
OUTLINE = (LineType.CUT, closed((0, 0), (400, 0), (400, 300), (0, 300)))
CREASES = (LineType.CREASE, edges(((100, 0), (100, 300)), ((200, 0), (200, 300))))


def with_rim(width: float) -> Machine:
    stations = tuple(
        replace(one, tool=replace(one.tool, width=width))
        if isinstance(one.tool, CreaseWheel)
        else one
        for one in MACHINE.stations
    )
    return replace(MACHINE, stations=stations)


def narrow_rims(drawing: Dieline, machine: Machine, board: str) -> list[Finding]:
    return rims(drawing, machine, board, "verify.narrow-rim")


def rims(drawing: Dieline, machine: Machine, board: str, code: str) -> list[Finding]:
    used = load.board(board)
    toolpath = sequence([compensate(one) for one in plan(drawing, machine, used)], machine)
    text = process(toolpath, machine, "grblhal").text
    verdict = verify(text, drawing, (0.0, 0.0), machine, used)
    assert verdict.accepted
    return [one for one in verdict.findings if one.message.code == code]


def test_two_creases_with_a_narrow_rim_have_one_note() -> None:
    [note] = narrow_rims(dieline(OUTLINE, CREASES), MACHINE, "b-flute")
    assert (note.severity, note.edge) == (Severity.NOTE, -1)
    assert dict(note.message.arguments) == {"width": 0.7, "caliper": 3.0, "least": 1.0}
    assert "a rim of 0.7 mm, which is narrow for a board 3 mm thick" in note.text


@pytest.mark.parametrize(
    ("width", "board", "noted"),
    [
        (0.7, "e-flute", False),
        (0.7, "greyboard-2.0", False),
        (0.9, "b-flute", True),
        (1.0, "b-flute", False),
        (1.3, "c-flute", True),
        (1.4, "c-flute", False),
        (1.4, "bc-flute", True),
        (3.0, "bc-flute", False),
    ],
)
def test_a_rim_narrower_than_a_third_of_the_board_is_noted(
    width: float, board: str, noted: bool
) -> None:
    assert bool(narrow_rims(dieline(OUTLINE, CREASES), with_rim(width), board)) == noted


def test_the_least_rim_is_rounded_up() -> None:
    [note] = narrow_rims(dieline(OUTLINE, CREASES), MACHINE, "c-flute")
    assert dict(note.message.arguments)["least"] == 1.4  # 4 / 3 = 1.333…


@pytest.mark.parametrize(
    ("width", "board", "noted"),
    [
        (0.7, "fbb-0.3", False),
        (0.75, "fbb-0.5", False),
        (0.8, "fbb-0.5", True),
        (1.4, "fbb-0.6", False),
        (1.6, "greyboard-1.0", True),
        (3.0, "greyboard-1.5", False),
        (6.0, "e-flute", False),
        (6.0, "b-flute", False),
    ],
)
def test_a_rim_wider_than_the_rules_for_the_board_is_noted(
    width: float, board: str, noted: bool
) -> None:
    found = rims(dieline(OUTLINE, CREASES), with_rim(width), board, "verify.wide-rim")
    assert [(one.severity, one.edge) for one in found] == [(Severity.NOTE, -1)] * noted


def test_a_job_without_creases_has_no_note() -> None:
    assert narrow_rims(dieline(OUTLINE), MACHINE, "b-flute") == []
