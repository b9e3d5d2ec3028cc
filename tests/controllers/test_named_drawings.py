"""Every named drawing, from its file through LinuxCNC's interpreter, compared with the drawing."""

from __future__ import annotations

from pathlib import Path

import pytest

from knifetip import pipeline
from knifetip.library import load
from knifetip.model.dieline import LineType
from tests.controllers.linuxcnc_rs274 import ABSENT, RS274, Report, TipTool, verify_by_interpreter
from tests.support.truth.named import NAMED, SAMPLES, Named

pytestmark = [
    pytest.mark.controller,
    pytest.mark.skipif(RS274 is None, reason=ABSENT),
]
# Dimensions of the shipped machine as literals: blade 10°, wheel 15 mm, blade of the
# V-cutter 6 mm back, 1.5 mm half width, 45°.
TAN_10 = 0.17632698


def tools(caliper: float, deepest_crease: float, groove: float) -> dict[int, TipTool]:
    contact = (deepest_crease * (30.0 - deepest_crease)) ** 0.5
    lead = TAN_10 * (caliper + 0.3)
    return {
        1: TipTool("knife", caliper, output=0, oscillating=True, overrun=lead, reach=lead),
        2: TipTool(
            "wheel", caliper, datum=(60.0, 0.0, -1.5, 0.0), output=1, reach=contact + 0.3
        ),
        3: TipTool(
            "v-cutter", caliper, datum=(-60.0, 0.0, 0.0, 0.0), output=2,
            back=6.0, half_width=1.5, tilt=45.0,
            # At an edge at 45° it runs out by half its width, which at 45° of tilt is its depth.
            overrun=groove,
        ),
    }  # fmt: skip


def verify_named(named: Named, corpus: Path | None) -> tuple[Report, float]:
    drawing, dieline, board = named.classified(corpus)
    made = pipeline.compile(drawing, dieline, load.machine("demo-table"), board, dialect="linuxcnc")
    assert made.verdict.accepted, made.verdict.findings[:3]
    deepest = max(board.crease_along, board.crease_across)
    # A crease under a cut is not made; ``checks.cleaning`` verifies that.
    worked = pipeline.clean(dieline).dieline
    report = verify_by_interpreter(
        made.program.text,
        worked.ends,
        worked.bulge,
        worked.line_type,
        made.placement,
        tools(board.caliper, deepest, board.groove_depth),
    )
    grooved = (dieline.line_type == LineType.V_GROOVE).any()
    return report, max(TAN_10 * board.caliper, board.groove_depth if grooved else 0.0)


def on_the_line(report: Report, over: float) -> None:
    assert report.accepted, report.stderr
    assert report.problems == []
    assert report.worst_deviation <= 0.01
    assert report.worst_gap <= 0.01
    # Where a cut meets another, it may overrun by the length that the blade leaves at the bottom; a
    # groove may run out over the board's edge.
    assert report.worst_overrun <= over + 0.01
    assert report.worked > 500.0


@pytest.mark.parametrize("named", SAMPLES, ids=str)
def test_linuxcnc_moves_the_tip_along_the_lines_of_our_samples(named: Named) -> None:
    on_the_line(*verify_named(named, None))


@pytest.mark.corpus
@pytest.mark.parametrize("named", NAMED, ids=str)
def test_linuxcnc_moves_the_tip_along_the_lines_of_drawings_by_other_authors(
    named: Named, corpus: Path
) -> None:
    on_the_line(*verify_named(named, corpus))


def test_a_wrong_offset_of_the_v_cutter_is_detected() -> None:
    # A test of the second verifier: if d is 0.05 mm too long, it must report a deviation.
    drawing, dieline, board = SAMPLES[2].classified(None)
    made = pipeline.compile(drawing, dieline, load.machine("demo-table"), board, dialect="linuxcnc")
    wrong = tools(board.caliper, 0.9, board.groove_depth)
    wrong[3] = TipTool(
        "v-cutter", board.caliper, datum=(-60.0, 0.0, 0.0, 0.0), output=2,
        back=6.05, half_width=1.5, tilt=45.0, overrun=board.groove_depth,
    )  # fmt: skip
    report = verify_by_interpreter(
        made.program.text, dieline.ends, dieline.bulge, dieline.line_type, made.placement, wrong
    )
    assert report.worst_deviation > 0.04
