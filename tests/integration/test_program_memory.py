"""A controller that stores whole programs refuses those that are larger than its memory."""

from __future__ import annotations

from dataclasses import replace

from knifetip import pipeline
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.verdict import Verdict
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline

OUTLINE = dieline((LineType.CUT, closed((0, 0), (80, 0), (80, 50), (0, 50))))
TABLE, BOARD = load.machine("demo-table"), load.board("fbb-0.4")


def test_a_program_is_refused_if_it_is_larger_than_the_memory() -> None:
    lines = drawing(OUTLINE.ends, [("0", 7, "CONTINUOUS")] * len(OUTLINE))
    made = pipeline.compile(lines, OUTLINE, TABLE, BOARD)
    size = len(made.program.text)

    def verdict(memory: int) -> Verdict:
        machine = replace(TABLE, program_memory=memory)
        return pipeline.verify(made.program.text, OUTLINE, made.placement, machine, BOARD)

    # The limit itself is permitted, and 0 is none.
    assert verdict(0).accepted
    assert verdict(size).accepted
    (found,) = verdict(size - 1).findings
    assert (found.message.code, found.measure) == ("verify.program-too-large", 1.0)
    assert found.refuses
    assert f"{size - 1:,}" in found.text


def test_the_compile_of_a_job_is_refused_as_well() -> None:
    lines = drawing(OUTLINE.ends, [("0", 7, "CONTINUOUS")] * len(OUTLINE))
    made = pipeline.compile(lines, OUTLINE, replace(TABLE, program_memory=100), BOARD)
    assert not made.verdict.accepted
