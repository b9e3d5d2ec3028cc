"""Programs for two carriages, through LinuxCNC's interpreter, compared with the drawing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip import compensate, pipeline, plan, process, sequence
from knifetip.library import load
from knifetip.model.dieline import LineType
from tests.controllers.linuxcnc_rs274 import (
    ABSENT,
    RS274,
    TipTool,
    read_program,
    verify_by_interpreter,
)
from tests.support.shapes import closed, dieline, edges
from tests.support.truth.named import SAMPLES, Named

pytestmark = [
    pytest.mark.controller,
    pytest.mark.skipif(RS274 is None, reason=ABSENT),
]
MACHINE = load.machine("two-carriage-table")
TAN_10 = 0.17632698
#: V, the axis of carriage 2 along the gantry, is written as B for rs274.
SECOND = "XBZA"


def tools(caliper: float, deepest_crease: float, groove: float) -> dict[int, TipTool]:
    contact = (deepest_crease * (30.0 - deepest_crease)) ** 0.5
    lead = TAN_10 * (caliper + 0.3)
    return {
        1: TipTool("knife", caliper, output=0, oscillating=True, overrun=lead, reach=lead),
        2: TipTool(
            "wheel", caliper, datum=(45.0, 0.0, -1.5, 0.0), output=1, reach=contact + 0.3,
            letters=SECOND,
        ),
        3: TipTool(
            "v-cutter", caliper, datum=(-45.0, 5.0, 0.0, 90.0), output=2, back=6.0,
            half_width=1.5, tilt=45.0, overrun=groove, letters=SECOND,
        ),
    }  # fmt: skip


@pytest.mark.parametrize("named", SAMPLES, ids=str)
def test_the_tips_of_both_carriages_follow_the_lines(named: Named) -> None:
    drawing, dieline, board = named.classified(None)
    made = pipeline.compile(drawing, dieline, MACHINE, board)
    assert made.verdict.accepted, made.verdict.findings[:3]
    deepest = max(board.crease_along, board.crease_across)
    held = tools(board.caliper, deepest, board.groove_depth)
    worked = pipeline.clean(dieline).dieline
    report = verify_by_interpreter(
        made.program.text, worked.ends, worked.bulge, worked.line_type, made.placement, held
    )
    assert report.accepted, report.stderr
    assert report.problems == []
    assert report.worst_deviation <= 0.01
    assert report.worst_gap <= 0.01
    assert report.worked > 500.0

    # The joints of both carriages along the gantry, from the move that parks both.
    moves = read_program(made.program.text, held).moves
    along = moves.joints[:, [1, 4]]
    parked = np.flatnonzero((along == [-220.0, 1420.0]).all(axis=1))[0]
    assert np.diff(along[parked:], axis=1).min() >= 200.0
    used = {1} | ({2} if (worked.line_type == LineType.CREASE).any() else set())
    assert set(moves.station.tolist()) >= used


def test_arcs_of_the_second_carriage_are_chords_on_the_arc() -> None:
    board = load.board("greyboard-2.0")
    curved = dieline(
        (LineType.CREASE, edges(((150, 150), (250, 150)))),
        (LineType.CUT, closed((100, 100), (300, 100), (300, 300), (100, 300))),
        bulge={0: 0.3, 1: 0.1},
    )
    toolpath = sequence([compensate(one) for one in plan(curved, MACHINE, board)], MACHINE)
    program = process(toolpath, MACHINE).text
    held = tools(board.caliper, max(board.crease_along, board.crease_across), 0.0)
    report = verify_by_interpreter(
        program, curved.ends, curved.bulge, curved.line_type, (0.0, 0.0), held
    )
    assert report.problems == []
    assert report.worst_deviation <= 0.0015
    moves = read_program(program, held).moves
    assert np.count_nonzero(moves.station == 2) > 30


def test_a_wrong_datum_of_the_second_carriage_is_detected() -> None:
    # A test of the second verifier: the tip of a V-cutter whose tip is 0.05 mm farther back.
    drawing, dieline, board = SAMPLES[2].classified(None)
    made = pipeline.compile(drawing, dieline, MACHINE, board)
    held = tools(board.caliper, 0.9, board.groove_depth)
    held[3] = replace(held[3], back=6.05)
    report = verify_by_interpreter(
        made.program.text,
        dieline.ends,
        dieline.bulge,
        dieline.line_type,
        made.placement,
        held,
    )
    assert report.worst_deviation == pytest.approx(0.05, abs=0.005)
