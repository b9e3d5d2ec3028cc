"""The feed factor of a job: programs, their verdicts, and the wrong factor."""

from __future__ import annotations

import re

import pytest

from knifetip import pipeline
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import JobOptions
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

CUT = (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250)))
OUTLINE = dieline(CUT, bulge={1: 0.3})
LINE = dieline(
    CUT,
    (LineType.CREASE, edges(((120, 180), (280, 180)))),
    bulge={1: 0.3},
)


def compiled(machine: str, board: str, factor: float, line: Dieline = LINE) -> Compiled:
    styles = [("CUT", 7, "CONTINUOUS")] * len(line)
    table, options = load.machine(machine), JobOptions(feed_factor=factor)
    drawn = drawing(line.ends, styles, bulge=line.bulge)
    return pipeline.compile(drawn, line, table, load.board(board), options=options)


def feeds(made: Compiled) -> set[float]:
    """Return the feeds of the program (mm/min), without moves in inverse time."""
    lines = [line for line in made.program.lines() if not line.startswith(b"G93")]
    return {float(word) for line in lines for word in re.findall(rb" F([\d.]+)", line)}


@pytest.mark.parametrize(
    ("machine", "board", "cut"),
    [("demo-table", "fbb-0.4", LINE), ("laser-table", "fbb-0.4", OUTLINE)],
)
def test_all_feeds_in_the_board_are_multiplied(machine: str, board: str, cut: Dieline) -> None:
    full, half = (compiled(machine, board, factor, cut) for factor in (1.0, 0.5))
    assert half.verdict.accepted
    work = max(feeds(full))
    assert work not in feeds(half)
    assert 0.5 * work in feeds(half)
    assert b"(feed factor 0.5)" in half.program.text
    assert b"feed factor" not in full.program.text
    assert half.seconds > 1.2 * full.seconds


def test_a_program_of_another_factor_is_refused() -> None:
    made = compiled("demo-table", "fbb-0.4", 0.5)
    job = (LINE, made.placement, load.machine("demo-table"), load.board("fbb-0.4"))
    same = pipeline.verify(made.program.text, *job, options=JobOptions(feed_factor=0.5))
    assert same.accepted
    other = pipeline.verify(made.program.text, *job)
    found = {one.message.code for one in other.findings if one.refuses}
    assert found == {"verify.wrong-feed", "verify.wrong-time"}
