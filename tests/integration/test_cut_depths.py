"""Passes and depths of cuts that the user has chosen: programs and their verdicts."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import PlanError
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import CutDepth, JobOptions
from knifetip.model.verdict import Verdict
from knifetip.pipeline import Compiled
from knifetip.verification.verify import trace_program
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

#: A blank (edges 0 to 3), a hole (4 to 7), and a half-cut (8).
LINE = dieline(
    (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
    (LineType.CUT, closed((150, 150), (200, 150), (200, 200), (150, 200))),
    (LineType.HALF_CUT, edges(((120, 220), (280, 220)))),
)
CUTS = LINE.line_type == LineType.CUT
MILLED = dieline(
    (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
    (LineType.CUT, closed((150, 150), (200, 150), (200, 200), (150, 200))),
)
#: Board of 2 mm, half-cuts of 1 mm, cuts 0.3 mm into the mat.
KNIFE = ("demo-table", "greyboard-2.0")
ROUTER = ("router-table", "greyboard-3.0")
HOLE = (4, 5, 6, 7)


def choice(*rows: int, **fields: float | str) -> CutDepth:
    return CutDepth.model_validate({"edges": rows, **fields})


def compiled(target: tuple[str, str], *depths: CutDepth, line: Dieline = LINE) -> Compiled:
    drawn = drawing(line.ends, [("CUT", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    machine, board = load.machine(target[0]), load.board(target[1])
    options = JobOptions(cut_depths=depths)
    return pipeline.compile(drawn, line, machine, board, options=options)


def verdict(
    text: bytes, made: Compiled, target: tuple[str, str], *depths: CutDepth, line: Dieline = LINE
) -> Verdict:
    machine, board = load.machine(target[0]), load.board(target[1])
    options = JobOptions(cut_depths=depths)
    return pipeline.verify(text, line, made.placement, machine, board, options=options)


def codes(found: Verdict) -> set[str]:
    return {one.message.code for one in found.findings if one.refuses}


def depths_along(
    made: Compiled, target: tuple[str, str], low: tuple[float, float], high: tuple[float, float]
) -> list[float]:
    """Return the depths (mm) of tip paths whose middle is in a box of the drawing, ascending."""
    machine, board = load.machine(target[0]), load.board(target[1])
    paths = trace_program(made.program.text, machine, board)[2]
    start, end = paths.ends()
    middle = (start + end) / 2.0 - made.placement
    inside = ((middle >= low) & (middle <= high)).all(axis=1) & (paths.curve[:, 5] > 1.0)
    found: list[float] = np.unique(np.round(board.caliper - paths.z[inside], 3)).tolist()
    return found


def test_cuts_are_made_in_the_chosen_passes() -> None:
    made = compiled(KNIFE, choice(line_type="cut", passes=3), choice(8, passes=2))
    assert made.verdict.accepted
    # 2.3 mm in three passes, and 1 mm in two.
    assert depths_along(made, KNIFE, (140, 140), (210, 210)) == [0.767, 1.533, 2.3]
    assert depths_along(made, KNIFE, (130, 215), (270, 225)) == [0.5, 1.0]


def test_edges_of_one_contour_may_have_different_passes() -> None:
    made = compiled(KNIFE, choice(0, passes=2))
    assert made.verdict.accepted
    assert depths_along(made, KNIFE, (110, 95), (290, 105)) == [1.15, 2.3]
    assert depths_along(made, KNIFE, (110, 245), (290, 255)) == [2.3]


def test_a_cut_of_a_smaller_depth_is_a_half_cut() -> None:
    made = compiled(KNIFE, choice(*HOLE, depth=1.4, passes=2))
    assert made.verdict.accepted
    assert depths_along(made, KNIFE, (140, 140), (210, 210)) == [0.7, 1.4]
    assert depths_along(made, KNIFE, (110, 95), (290, 105)) == [2.3]


def test_a_half_cut_may_be_nearly_as_deep_as_a_cut() -> None:
    """1.8 mm is nearer to the 2.3 mm of a cut than to the 1 mm of a half-cut."""
    made = compiled(KNIFE, choice(*HOLE, depth=1.8))
    assert made.verdict.accepted
    assert depths_along(made, KNIFE, (140, 140), (210, 210)) == [1.8]


def test_a_half_cut_of_a_greater_depth_is_a_cut() -> None:
    made = compiled(KNIFE, choice(8, depth=2.1))
    assert made.verdict.accepted
    assert depths_along(made, KNIFE, (130, 215), (270, 225)) == [2.1]


def test_a_half_cut_where_a_cut_is_chosen_is_refused_and_vice_versa() -> None:
    plain, half, through = compiled(KNIFE), choice(*HOLE, depth=1.0), choice(8, depth=2.3)
    text = plain.program.text
    assert "verify.not-worked" in codes(verdict(text, plain, KNIFE, half))
    assert "verify.not-worked" in codes(verdict(text, plain, KNIFE, through))
    shallow, deep = compiled(KNIFE, half), compiled(KNIFE, through)
    assert shallow.verdict.accepted
    assert deep.verdict.accepted
    assert "verify.not-worked" in codes(verdict(shallow.program.text, shallow, KNIFE))
    assert "verify.not-worked" in codes(verdict(deep.program.text, deep, KNIFE))


def test_another_depth_is_refused() -> None:
    made = compiled(KNIFE, choice(8, depth=1.2))
    found = codes(verdict(made.program.text, made, KNIFE, choice(8, depth=1.25)))
    assert found >= {"verify.wrong-depth", "verify.other-passes"}


@pytest.mark.parametrize("missing", ["first", "second"])
def test_a_program_with_one_pass_less_is_refused(missing: str) -> None:
    """The lines of one pass are taken out of a program with three passes."""
    made = compiled(KNIFE, choice(8, passes=3))
    lines = made.program.text.split(b"\n")
    # 1 mm in three passes: the tip is at 1.6667 and 1.3333 mm above the table, then at 1 mm.
    height = {"first": b"G1 Z1.6667", "second": b"G1 Z1.3333"}[missing]
    down = next(row for row, one in enumerate(lines) if one.startswith(height))
    up = next(row for row in range(down, len(lines)) if re.match(rb"G[01] Z(4|2\d)\.", lines[row]))
    text = b"\n".join([*lines[:down], *lines[up + 1 :]])
    found = codes(verdict(text, made, KNIFE, choice(8, passes=3)))
    assert "verify.other-passes" in found
    assert verdict(made.program.text, made, KNIFE, choice(8, passes=3)).accepted


@pytest.mark.parametrize(("target", "line"), [(KNIFE, LINE), (ROUTER, MILLED)])
def test_other_passes_are_refused(target: tuple[str, str], line: Dieline) -> None:
    made = compiled(target, choice(*HOLE, passes=3), line=line)
    text = made.program.text
    assert verdict(text, made, target, choice(*HOLE, passes=3), line=line).accepted
    for passes in (1, 2, 4):
        found = codes(verdict(text, made, target, choice(*HOLE, passes=passes), line=line))
        assert "verify.other-passes" in found


def test_contours_of_a_router_may_have_different_passes() -> None:
    made = compiled(ROUTER, choice(*HOLE, passes=4), choice(0, 1, 2, 3, passes=2), line=MILLED)
    assert made.verdict.accepted
    # 3.3 mm in four passes, and in two.
    assert depths_along(made, ROUTER, (150, 150), (200, 200)) == [0.825, 1.65, 2.475, 3.3]
    assert depths_along(made, ROUTER, (110, 90), (290, 100)) == [1.65, 3.3]


@pytest.mark.parametrize(
    ("target", "depth", "code"),
    [
        (KNIFE, choice(0, depth=2.31), "depth.too-deep"),
        (ROUTER, choice(0, depth=1.0), "depth.of-cutter"),
        (ROUTER, choice(0, passes=2), "depth.several"),
        (("router-table", "foam-10.0"), choice(0, 1, 2, 3, passes=2), "depth.too-few-passes"),
        (("laser-table", "fbb-0.4"), choice(line_type="cut", passes=2), "depth.one-pass"),
        (("drag-knife-hpgl", "fbb-0.4"), choice(0, passes=2), "depth.not-set"),
    ],
)
def test_what_a_machine_cannot_make_is_refused_with_its_edge(
    target: tuple[str, str], depth: CutDepth, code: str
) -> None:
    with pytest.raises(PlanError) as caught:
        compiled(target, depth, line=MILLED)
    assert caught.value.message.arguments["error"].code == code
    assert set(depth.edges or range(8)) & set(caught.value.edges)


def test_passes_of_a_crease_are_refused() -> None:
    line = dieline(
        (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
        (LineType.CREASE, edges(((120, 180), (280, 180)))),
    )
    with pytest.raises(PlanError) as caught:
        compiled(KNIFE, choice(4, passes=2), line=line)
    assert caught.value.message.arguments["error"].code == "depth.other-type"


def test_joined_edges_need_one_choice() -> None:
    """Two collinear edges are made as one cut."""
    line = dieline((LineType.HALF_CUT, edges(((100, 100), (200, 100)), ((200, 100), (300, 100)))))
    assert compiled(KNIFE, choice(0, 1, passes=2), line=line).verdict.accepted
    with pytest.raises(PlanError) as caught:
        compiled(KNIFE, choice(0, passes=2), line=line)
    assert caught.value.message.arguments["error"].code == "edge-choice.joined"
    assert set(caught.value.edges) == {0, 1}


def test_a_choice_for_an_edge_precedes_one_for_its_line_type() -> None:
    made = compiled(KNIFE, choice(*HOLE, passes=2), choice(line_type="cut", passes=3))
    assert depths_along(made, KNIFE, (140, 140), (210, 210)) == [1.15, 2.3]
    assert depths_along(made, KNIFE, (110, 95), (290, 105)) == [0.767, 1.533, 2.3]


@pytest.mark.parametrize(
    "fields",
    [
        {"edges": [0], "passes": 0},
        {"edges": [0], "passes": 11},
        {"edges": [0], "depth": 0.0},
        {"passes": 2},
        {"edges": [0], "line_type": "cut", "passes": 2},
        {"line_type": "ignored", "passes": 2},
    ],
)
def test_invalid_choices_are_refused(fields: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"less|greater|field|must|Field"):
        JobOptions.model_validate({"cut_depths": [fields]})


def test_no_choice_leaves_the_program_as_it_is() -> None:
    assert compiled(KNIFE).program.text == compiled(KNIFE, choice(0)).program.text
