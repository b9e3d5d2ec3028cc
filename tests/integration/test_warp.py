"""Warped board: tools keep the height by which it rises, and the verifier requires it."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import PlanError
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.job_options import JobOptions
from knifetip.model.toolpath import Motion
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

OUTLINE = (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250)))
LINES = dieline(OUTLINE, (LineType.CREASE, edges(((120, 180), (280, 180)))), bulge={1: 0.3})
CUT = dieline(OUTLINE, bulge={1: 0.3})
BOARD = load.board("fbb-0.4")


def compiled(machine: str, options: JobOptions) -> Compiled:
    line = LINES if machine == "demo-table" else CUT
    drawn = drawing(line.ends, [("CUT", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    return pipeline.compile(drawn, line, load.machine(machine), BOARD, options=options)


@pytest.mark.parametrize("machine", ["demo-table", "router-table", "drag-knife-table"])
def test_tools_travel_turn_and_plunge_higher(machine: str) -> None:
    flat, warped = (compiled(machine, JobOptions(warp=warp)) for warp in (0.0, 5.0))
    assert warped.verdict.accepted
    assert warped.verdict.program.lowest_travel >= 5.0
    lowest = [
        made.toolpath.pose[1:, 2][made.toolpath.motion == Motion.RAPID].min()
        for made in (flat, warped)
    ]
    assert np.isclose(lowest[1] - lowest[0], 5.0)
    assert b"(warp 5)" in warped.program.text
    assert b"warp" not in flat.program.text


def test_a_laser_cuts_warped_board_at_its_focus() -> None:
    assert compiled("laser-table", JobOptions(warp=5.0)).verdict.accepted


def test_a_program_for_flat_board_is_refused_for_a_warped_one() -> None:
    made = compiled("demo-table", JobOptions())
    job = (LINES, made.placement, load.machine("demo-table"), BOARD)
    assert pipeline.verify(made.program.text, *job).accepted
    verdict = pipeline.verify(made.program.text, *job, options=JobOptions(warp=5.0))
    assert {one.message.code for one in verdict.findings if one.refuses} == {"verify.rapid-too-low"}


def test_a_warp_above_which_the_head_does_not_travel_is_refused() -> None:
    with pytest.raises(PlanError) as caught:
        compiled("flat-cutter-hpgl", JobOptions(warp=3.0))
    assert caught.value.message.code == "board.above-travel"


def test_the_least_lift_still_needs_the_height_of_turns_of_the_machine() -> None:
    with pytest.raises(PlanError) as caught:
        compiled("router-table", JobOptions(warp=5.0, lift="least"))
    assert caught.value.message.code == "lift.not-stated"
