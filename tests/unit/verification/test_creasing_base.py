"""The base on which the wheels press: how deep they may go, and boards for another base."""

from __future__ import annotations

from dataclasses import replace
from math import sqrt

import numpy as np
import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.errors import PlanError
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.model.tool import CreaseWheel
from knifetip.model.verdict import Finding, Severity
from knifetip.verification.tools import OperationKind
from knifetip.verification.verify import trace_program, verify
from tests.support.shapes import closed, dieline, edges

RIGID = load.machine("demo-table")
SOFT = replace(RIGID, creasing_base="soft", base_yield=0.5)
FLUTE = replace(load.board("b-flute"), crease_base="soft", crease_along=3.4, crease_across=3.4)
DRAWING = dieline(
    (LineType.CUT, closed((0, 0), (400, 0), (400, 300), (0, 300))),
    (LineType.CREASE, edges(((100, 50), (100, 250)))),
)


def program(machine: Machine, board: Board) -> str:
    toolpath = sequence([compensate(one) for one in plan(DRAWING, machine, board)], machine)
    return process(toolpath, machine, "grblhal").text.decode()


def findings(text: str, machine: Machine, board: Board) -> tuple[Finding, ...]:
    return verify(text.encode(), DRAWING, (0.0, 0.0), machine, board).findings


def codes(text: str, machine: Machine, board: Board) -> set[str]:
    return {one.message.code for one in findings(text, machine, board)}


def test_a_soft_base_permits_creases_deeper_than_the_board() -> None:
    text = program(SOFT, FLUTE)
    verdict = verify(text.encode(), DRAWING, (0.0, 0.0), SOFT, FLUTE)
    assert verdict.accepted
    # 3.4 mm into 3 mm of board: 0.4 mm below the surface of the mat, as 0.5 mm are permitted.
    _, _, paths = trace_program(text.encode(), SOFT, FLUTE)
    rolled = paths.operation == OperationKind.CREASE
    assert paths.z[rolled].tolist() == pytest.approx([-0.4] * int(rolled.sum()))
    assert rolled.any()


def test_the_contact_contains_the_part_in_the_mat() -> None:
    [wheel] = {one.tool.radius for one in SOFT.stations if isinstance(one.tool, CreaseWheel)}
    verdict = verify(program(SOFT, FLUTE).encode(), DRAWING, (0.0, 0.0), SOFT, FLUTE)
    setback = 2.0 * (sqrt(3.4 * (2.0 * wheel - 3.4)) + FLUTE.end_clearance)
    assert verdict.setback[4] == pytest.approx(setback, abs=0.02)


@pytest.mark.parametrize(
    ("machine", "most"),
    [
        (RIGID, 3.0),
        (replace(SOFT, base_yield=0.3), 3.3),
        # A rigid base does not yield, whatever its entry states.
        (replace(SOFT, creasing_base="rigid"), 3.0),
    ],
)
def test_creases_deeper_than_the_base_yields_are_refused(machine: Machine, most: float) -> None:
    with pytest.raises(PlanError) as refused:
        program(machine, FLUTE)
    said = refused.value.message
    assert said.code == "crease.below-base"
    figures = dict(said.arguments)
    assert (figures["count"], figures["depth"]) == (1, pytest.approx(3.4))
    assert figures["most"] == pytest.approx(most)


def test_the_verifier_finds_a_wheel_that_is_pressed_into_a_rigid_base() -> None:
    found = findings(program(SOFT, FLUTE), RIGID, FLUTE)
    [fault] = [one for one in found if one.message.code == "verify.wheel-below-base"]
    assert (fault.severity, fault.kind) == (Severity.FAULT, "depth")
    assert fault.measure == pytest.approx(0.4, abs=1e-3)
    assert fault.line > 0


def test_the_base_counts_and_not_what_the_board_states() -> None:
    text = program(SOFT, FLUTE)
    less = replace(SOFT, base_yield=0.3)
    [fault] = [one for one in findings(text, less, FLUTE) if one.kind == "depth"]
    assert fault.measure == pytest.approx(0.1, abs=1e-3)


@pytest.mark.parametrize(
    ("base", "machine", "noted"),
    [
        ("", RIGID, set()),
        ("", SOFT, set()),
        ("rigid", RIGID, set()),
        ("soft", SOFT, set()),
        ("rigid", SOFT, {"verify.base-not-rigid"}),
        ("soft", RIGID, {"verify.base-not-soft"}),
    ],
)
def test_a_board_for_another_base_has_one_note(
    base: str, machine: Machine, noted: set[str]
) -> None:
    board = replace(load.board("greyboard-2.0"), crease_base=base)
    found = findings(program(machine, board), machine, board)
    notes = [one for one in found if one.message.code.startswith("verify.base-not")]
    assert {one.message.code for one in notes} == noted
    assert len(notes) == len(noted)
    for note in notes:
        deepest = max(board.crease_along, board.crease_across)
        assert note.severity is Severity.NOTE
        assert note.measure == pytest.approx(deepest, abs=1e-3) or np.isclose(
            note.measure, min(board.crease_along, board.crease_across), atol=1e-3
        )


def test_a_drawing_without_creases_has_no_note() -> None:
    board = replace(load.board("greyboard-2.0"), crease_base="soft")
    cuts = dieline((LineType.CUT, closed((0, 0), (400, 0), (400, 300), (0, 300))))
    toolpath = sequence([compensate(one) for one in plan(cuts, RIGID, board)], RIGID)
    text = process(toolpath, RIGID, "grblhal").text
    found = verify(text, cuts, (0.0, 0.0), RIGID, board).findings
    assert not [one for one in found if one.message.code.startswith("verify.base")]


def test_boxboard_of_the_library_is_for_a_rigid_base() -> None:
    board = load.board("fbb-0.4")
    assert "verify.base-not-rigid" in codes(program(SOFT, board), SOFT, board)
    assert "verify.base-not-rigid" not in codes(program(RIGID, board), RIGID, board)
