"""Tools that the user has chosen for edges: programs, verdicts, and tools that cannot do it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import PlanError
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import CutDepth, EdgeTool, JobOptions
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import VCutter
from knifetip.model.verdict import Verdict
from knifetip.pipeline import Compiled
from knifetip.verification.verify import trace_program
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

#: A blank (edges 0 to 3), a hole (4 to 7), a half-cut (8), two perforations (9, 10), two creases
#: (11, 12), and a combi line (13).
LINE = dieline(
    (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
    (LineType.CUT, closed((150, 150), (200, 150), (200, 200), (150, 200))),
    (LineType.HALF_CUT, edges(((120, 220), (280, 220)))),
    (LineType.PERFORATION, edges(((120, 110), (280, 110)), ((120, 115), (280, 115)))),
    (LineType.CREASE, edges(((220, 120), (220, 200)), ((240, 120), (240, 200)))),
    (LineType.COMBI, edges(((260, 120), (260, 200)))),
)
#: Two blanks (edges 0 to 3, 4 to 7) 20 mm apart.
MILLED = dieline(
    (LineType.CUT, closed((100, 100), (200, 100), (200, 200), (100, 200))),
    (LineType.CUT, closed((220, 100), (320, 100), (320, 200), (220, 200))),
)
#: Two blanks 2.5 mm apart.
NEAR = dieline(
    (LineType.CUT, closed((100, 100), (200, 100), (200, 200), (100, 200))),
    (LineType.CUT, closed((202.5, 100), (302.5, 100), (302.5, 200), (202.5, 200))),
)


def with_second_knife() -> Machine:
    """Return the demo table with a second knife, of which a pass is 1 mm deep, and V-cutter."""
    machine = load.machine("demo-table")
    knife, _, cutter = machine.stations
    thin: Any = knife.tool
    return replace(
        machine,
        stations=(
            *machine.stations,
            replace(
                knife,
                number=4,
                name="Second knife",
                tool=replace(thin, step=1.0),
                x=knife.x + 30.0,
                output=5,
            ),
            replace(cutter, number=5, name="Second V-cutter", x=cutter.x - 30.0, output=6),
        ),
    )


KNIVES = with_second_knife(), load.board("greyboard-2.0")
WHEELS = load.machine("sample-table"), load.board("b-flute")
CUTTERS = load.machine("fine-router-table"), load.board("greyboard-3.0")
Target = tuple[Machine, Board]


def tool(station: int, *rows: int, **fields: Any) -> EdgeTool:
    return EdgeTool(edges=rows, station=station, **fields)


def compiled(
    target: Target, *tools: EdgeTool, line: Dieline = LINE, depths: tuple[CutDepth, ...] = ()
) -> Compiled:
    drawn = drawing(line.ends, [("CUT", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    options = JobOptions(edge_tools=tools, cut_depths=depths)
    return pipeline.compile(drawn, line, *target, options=options)


def verdict(
    text: bytes, made: Compiled, target: Target, *tools: EdgeTool, line: Dieline = LINE
) -> Verdict:
    options = JobOptions(edge_tools=tools)
    return pipeline.verify(text, line, made.placement, *target, options=options)


def stations_by_edge(made: Compiled, target: Target, line: Dieline) -> list[set[int]]:
    """Return the numbers of the stations whose tools work beside the middle of each edge."""
    machine, board = target
    paths = trace_program(made.program.text, machine.for_board(board), board)[2]
    start, end = paths.ends()
    found = []
    for ends in line.ends + made.placement:
        middle, way = ends.mean(axis=0), np.subtract(*ends[::-1])
        way = way / np.hypot(*way)
        parallel = np.abs((end - start) @ way) > 0.99 * np.hypot(*(end - start).T)
        away = np.abs((start - middle) @ np.array([-way[1], way[0]]))
        low = np.minimum((start - middle) @ way, (end - middle) @ way)
        high = np.maximum((start - middle) @ way, (end - middle) @ way)
        own = parallel & (away < 2.5) & (low < 3.0) & (high > -3.0)
        numbers = [machine.for_board(board).stations[k].number for k in paths.station[own]]
        found.append(set(numbers))
    return found


def codes(found: Verdict) -> set[str]:
    return {one.message.code for one in found.findings if one.refuses}


def test_edges_and_line_types_are_cut_by_the_chosen_knife() -> None:
    chosen = (tool(4, 4, 5, 6, 7, 10), EdgeTool(line_type="half-cut", station=4))
    made = compiled(KNIVES, *chosen)
    assert made.verdict.accepted, codes(made.verdict)
    by_edge = stations_by_edge(made, KNIVES, LINE)
    assert by_edge[:4] == [{1}] * 4
    assert by_edge[4:10] == [{4}] * 5 + [{1}]
    assert by_edge[10] == {4}
    # The hole is cut before the blank, whatever the numbers of the stations.
    path = made.toolpath
    assert np.flatnonzero(path.source == 4).max() < np.flatnonzero(path.source == 0).min()


def test_a_contour_of_two_knives_is_cut_by_both() -> None:
    made = compiled(KNIVES, tool(4, 1, 2))
    assert made.verdict.accepted, codes(made.verdict)
    assert stations_by_edge(made, KNIVES, LINE)[:4] == [{1}, {4}, {4}, {1}]


def test_a_combi_line_has_the_chosen_wheel_and_the_usual_knife() -> None:
    made = compiled(WHEELS, tool(4, 11, 13), line=LINE)
    assert made.verdict.accepted, codes(made.verdict)
    by_edge = stations_by_edge(made, WHEELS, LINE)
    usual = by_edge[12]
    assert usual != {4}
    assert (by_edge[11], by_edge[13]) == ({4}, {1, 4})


def test_each_contour_is_milled_by_its_cutter() -> None:
    made = compiled(CUTTERS, tool(4, 0, 1, 2, 3), tool(6, 4, 5, 6, 7), line=MILLED)
    assert made.verdict.accepted, codes(made.verdict)
    assert stations_by_edge(made, CUTTERS, MILLED) == [{4}] * 4 + [{6}] * 4
    # The planner chooses the thickest cutter for the other contour.
    made = compiled(CUTTERS, tool(6, 4, 5, 6, 7), line=MILLED)
    assert made.verdict.accepted, codes(made.verdict)
    assert stations_by_edge(made, CUTTERS, MILLED) == [{5}] * 4 + [{6}] * 4
    # A contour is milled as a whole.
    one_edge = compiled(CUTTERS, tool(6, 5), line=MILLED)
    assert one_edge.program.text == made.program.text


def test_v_grooves_are_cut_by_the_chosen_cutter() -> None:
    line = dieline(
        (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
        (LineType.V_GROOVE, edges(((150, 120), (150, 200)), ((250, 120), (250, 200)))),
    )
    made = compiled(KNIVES, tool(5, 5), line=line)
    assert isinstance(KNIVES[0].station(5).tool, VCutter)
    assert made.verdict.accepted, codes(made.verdict)
    assert set(made.toolpath.tool[made.toolpath.source == 5].tolist()) == {5}
    assert set(made.toolpath.tool[made.toolpath.source == 4].tolist()) == {3}


@pytest.mark.parametrize(
    ("target", "line", "chosen"),
    [
        (KNIVES, LINE, tool(4, 4, 5, 6, 7)),
        (KNIVES, LINE, EdgeTool(line_type="half-cut", station=4)),
        (KNIVES, LINE, EdgeTool(line_type="perforation", station=4)),
        (WHEELS, LINE, tool(4, 11)),
        (CUTTERS, MILLED, tool(6, 4, 5, 6, 7)),
    ],
)
def test_a_program_of_another_tool_is_refused(
    target: Target, line: Dieline, chosen: EdgeTool
) -> None:
    usual, made = compiled(target, line=line), compiled(target, chosen, line=line)
    assert made.verdict.accepted
    found = verdict(usual.program.text, usual, target, chosen, line=line)
    assert codes(found) == {"verify.other-tool"}
    wrong = {one.edge for one in found.findings if one.message.code == "verify.other-tool"}
    rows = (
        chosen.edges
        or np.flatnonzero(line.line_type == LineType.from_word(chosen.line_type or "")).tolist()
    )
    assert wrong == set(rows)
    # Without the choice, both tools may make it.
    assert verdict(made.program.text, made, target, line=line).accepted


def test_chosen_passes_are_those_of_the_chosen_knife() -> None:
    hole, depths = tool(4, 4, 5, 6, 7), (CutDepth(edges=(4, 5, 6, 7), passes=2),)
    # Cuts are 2.3 mm deep, and a pass of the second knife is at most 1 mm deep.
    assert compiled(KNIVES, depths=depths).verdict.accepted
    with pytest.raises(PlanError, match="needs 3"):
        compiled(KNIVES, hole, depths=depths)


@pytest.mark.parametrize(
    ("target", "line", "chosen", "text"),
    [
        (KNIVES, LINE, tool(9, 0), "has no such station"),
        (KNIVES, LINE, tool(2, 0), "another kind of tool makes this line type"),
        (KNIVES, LINE, tool(3, 13), "another kind of tool"),
        (KNIVES, LINE, tool(4, 14), "the drawing has 14 edges"),
    ],
)
def test_tools_that_cannot_do_it_are_refused(
    target: Target, line: Dieline, chosen: EdgeTool, text: str
) -> None:
    with pytest.raises(PlanError, match=text):
        compiled(target, chosen, line=line)


@pytest.mark.parametrize(
    ("line", "chosen", "text"),
    [
        (MILLED, (tool(4, 0), tool(6, 1)), "Choose the same tool for all edges of the contour"),
        (
            NEAR,
            (tool(5, 0, 1, 2, 3), tool(4, 4, 5, 6, 7)),
            "Choose the same tool for both contours",
        ),
    ],
)
def test_cutters_that_are_in_each_others_way_are_refused(
    line: Dieline, chosen: tuple[EdgeTool, ...], text: str
) -> None:
    with pytest.raises(PlanError, match=text):
        compiled(CUTTERS, *chosen, line=line)


def test_creases_that_continue_each_other_need_one_wheel() -> None:
    row = dieline((LineType.CREASE, edges(((120, 120), (200, 120)), ((200, 120), (280, 120)))))
    assert compiled(WHEELS, EdgeTool(line_type="crease", station=4), line=row).verdict.accepted
    with pytest.raises(PlanError, match="Choose the same for both"):
        compiled(WHEELS, tool(4, 1), line=row)


def test_a_choice_of_the_usual_tool_changes_nothing() -> None:
    station: Station | None = KNIVES[0].station_for(LineType.CUT)
    assert station is not None
    one, other = compiled(KNIVES), compiled(KNIVES, EdgeTool(line_type="cut", station=1))
    assert one.program.text == other.program.text
