"""The note of an order at the head of its program."""

from __future__ import annotations

import pytest

from knifetip import pipeline
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.job_options import JobOptions
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline

LINE = dieline((LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))))


def head(note: str, dialect: str = "") -> list[bytes]:
    """Return the first 12 lines of a program with a note."""
    made = pipeline.compile(
        drawing(LINE.ends, [("CUT", 7, "CONTINUOUS")] * len(LINE)),
        LINE,
        load.machine("demo-table"),
        load.board("fbb-0.4"),
        options=JobOptions(program_note=note),
        dialect=dialect,
    )
    assert made.verdict.accepted
    return list(made.program.lines()[:12])


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_the_note_is_a_comment_of_the_program(dialect: str) -> None:
    assert any(
        b"(Grain up - order 4711)" in line for line in head("Grain up - order 4711", dialect)
    )


def test_a_controller_cannot_execute_a_note() -> None:
    lines = head("(PY,import os) M3 ~!")
    assert any(b"(PY import os M3)" in line for line in lines)
    assert not any(b"PY," in line or b"~" in line for line in lines)


def test_without_a_note_the_program_has_none() -> None:
    assert sum(b"(x)" in line for line in head("x")) == 1
    assert not any(b"(x)" in line or b"()" in line for line in head(""))
