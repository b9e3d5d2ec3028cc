"""Depths that the user has chosen for creases: programs, their verdicts, and wrong depths."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import PlanError
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import CreaseDepth, JobOptions
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

#: A blank (edges 0 to 3), two creases along X (4, 5), one along Y (6), and a short one (7).
LINE = dieline(
    (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
    (
        LineType.CREASE,
        edges(
            ((120, 120), (200, 120)),
            ((120, 140), (200, 140)),
            ((250, 120), (250, 200)),
            ((120, 160), (124, 160)),
        ),
    ),
)
#: Two creases that continue each other.
ROW = dieline((LineType.CREASE, edges(((120, 120), (200, 120)), ((200, 120), (280, 120)))))
CHOSEN = (CreaseDepth(edges=(5,), depth=0.3), CreaseDepth(edges=(6, 7), depth=0.12))


def compiled(*choices: CreaseDepth, line: Dieline = LINE, machine: str = "demo-table") -> Compiled:
    drawn = drawing(line.ends, [("CUT", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    options = JobOptions(crease_depths=choices)
    target = load.machine(machine), load.board("fbb-0.4")
    return pipeline.compile(drawn, line, *target, options=options)


def deepest(made: Compiled, edge: int) -> float:
    """Return the depth of an edge below the top face of board of 0.4 mm (mm)."""
    path = made.toolpath
    return round(float(0.4 - path.pose[1:][path.source == edge, 2].min()), 6)


def test_creases_have_their_chosen_depths_and_the_others_that_of_the_board() -> None:
    made, usual = compiled(*CHOSEN), compiled()
    assert made.verdict.accepted
    assert usual.verdict.accepted
    assert (deepest(made, 5), deepest(made, 6)) == (0.3, 0.12)
    assert deepest(made, 4) == deepest(usual, 4) != 0.3
    # The wheel of radius 15 mm stops at half its contact length, √(δ(2R − δ)), before each end.
    back = np.sqrt(0.3 * 29.7) + load.board("fbb-0.4").end_clearance
    own = made.toolpath.pose[1:][made.toolpath.source == 5]
    own = own[own[:, 2] < 0.4 - 1e-6]
    assert own[:, 0].max() - own[:, 0].min() == pytest.approx(80.0 - 2.0 * back, abs=1e-6)


@pytest.mark.parametrize("choices", [CHOSEN, CHOSEN[:1], CHOSEN[1:]])
def test_a_program_of_other_depths_is_refused(choices: tuple[CreaseDepth, ...]) -> None:
    usual, made = compiled(), compiled(*choices)
    for text, expected in ((usual.program.text, choices), (made.program.text, ())):
        verdict = pipeline.verify(
            text,
            LINE,
            usual.placement,
            load.machine("demo-table"),
            load.board("fbb-0.4"),
            options=JobOptions(crease_depths=expected),
        )
        assert not verdict.accepted
        edges_found = {one.edge for one in verdict.findings if one.refuses and one.edge is not None}
        assert edges_found <= {5, 6, 7}


@pytest.mark.parametrize(
    ("choice", "machine", "text"),
    [
        (CreaseDepth(edges=(4,), depth=0.4), "demo-table", "board is 0.4 mm thick"),
        (CreaseDepth(edges=(0,), depth=0.2), "demo-table", "line type cut"),
        (CreaseDepth(edges=(4,), depth=0.2), "flat-cutter-hpgl", "do not set the depth"),
        (CreaseDepth(edges=(8,), depth=0.2), "demo-table", "the drawing has 8 edges"),
    ],
)
def test_depths_that_cannot_be_made_are_refused(
    choice: CreaseDepth, machine: str, text: str
) -> None:
    with pytest.raises(PlanError, match=text):
        compiled(choice, machine=machine)


def test_creases_that_continue_each_other_need_one_depth() -> None:
    both = CreaseDepth(line_type="crease", depth=0.3)
    assert compiled(both, line=ROW).verdict.accepted
    with pytest.raises(PlanError, match="Choose the same for both"):
        compiled(CreaseDepth(edges=(1,), depth=0.3), line=ROW)
