"""Orders of the work that the user has chosen: programs, their verdicts, and broken rules."""

from __future__ import annotations

from bisect import bisect_right
from itertools import pairwise
from typing import Literal

import pytest

from knifetip import pipeline
from knifetip.errors import PlanError
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.job_options import ContourStart, JobOptions
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges


def hole(x: float, y: float) -> tuple[LineType, F64]:
    return LineType.CUT, closed((x, y), (x + 20, y), (x + 20, y + 20), (x, y + 20))


#: A blank (edges 0 to 3) with three holes (4 to 15) and three lines (16 to 18).
HOLES = [hole(140, 140), hole(440, 140), hole(140, 300)]
BLANK = (LineType.CUT, closed((100, 100), (500, 100), (500, 350), (100, 350)))
LINES = edges(*(((x, 120), (x, 330)) for x in (200, 300, 400)))
CARTON = dieline(BLANK, *HOLES, (LineType.CREASE, LINES))
TARGETS = [
    ("demo-table", "fbb-0.4", LineType.CREASE),
    ("demo-table", "greyboard-3.0", LineType.CREASE),  # in two passes
    ("router-table", "greyboard-3.0", LineType.CREASE),
    ("v-groove-table", "greyboard-2.0", LineType.V_GROOVE),
    ("laser-table", "fbb-0.4", LineType.CUT),
    ("drag-knife-hpgl", "fbb-0.4", LineType.HALF_CUT),
    ("demo-table", "fbb-0.4", LineType.PERFORATION),
    ("demo-table", "fbb-0.4", LineType.COMBI),
]


def compiled(
    machine: str,
    board: str,
    order: tuple[int, ...],
    lines: LineType,
    *starts: ContourStart,
) -> Compiled:
    line = dieline(BLANK, *HOLES, (lines, LINES))
    drawn = drawing(line.ends, [("CUT", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    options = JobOptions(work_order=order, contour_starts=starts)
    return pipeline.compile(drawn, line, load.machine(machine), load.board(board), options=options)


def begun(made: Compiled, *rows: int) -> list[int]:
    """Return the number of the first track along each edge."""
    path = made.toolpath
    return [int(path.track[path.source == row].min()) for row in rows]


def refused(
    made: Compiled, machine: str, board: str, order: tuple[int, ...], lines: LineType
) -> set[tuple[str, int]]:
    """Return the codes and edges of the findings that refuse a program for another order."""
    found = pipeline.verify(
        made.program.text,
        dieline(BLANK, *HOLES, (lines, LINES)),
        made.placement,
        load.machine(machine),
        load.board(board),
        options=JobOptions(work_order=order),
    )
    return {(one.message.code, one.edge) for one in found.findings if one.refuses}


@pytest.mark.parametrize(("machine", "board", "lines"), TARGETS)
def test_tracks_are_made_in_the_chosen_order(machine: str, board: str, lines: LineType) -> None:
    usual = compiled(machine, board, (), lines)
    for group in ((16, 17, 18), (4, 8, 12)):
        shortest = sorted(group, key=lambda row: begun(usual, row))
        order = (shortest[1], shortest[0], shortest[2])
        made = compiled(machine, board, order, lines)
        assert made.verdict.accepted
        assert all(one < other for one, other in pairwise(begun(made, *order)))
        # The checks find it in the program, and miss it in the shortest one.
        assert refused(made, machine, board, order, lines) == set()
        assert refused(usual, machine, board, order, lines) == {("verify.other-order", shortest[0])}


def test_the_shortest_order_is_not_changed_by_naming_it() -> None:
    usual = compiled("demo-table", "fbb-0.4", (), LineType.CREASE)
    order = tuple(sorted((0, 4, 8, 12, 16, 17, 18), key=lambda row: begun(usual, row)))
    made = compiled("demo-table", "fbb-0.4", order, LineType.CREASE)
    assert made.program.text == usual.program.text


def test_edges_without_a_place_keep_theirs() -> None:
    usual = compiled("demo-table", "fbb-0.4", (), LineType.CREASE)
    first, second, third = sorted((4, 8, 12), key=lambda row: begun(usual, row))
    made = compiled("demo-table", "fbb-0.4", (third, first), LineType.CREASE)
    assert begun(made, third, second, first) == begun(usual, first, second, third)


@pytest.mark.parametrize(
    ("order", "code", "edges_named"),
    [
        ((4, 16), "order.types", (4, 16)),
        ((16, 0, 17), "order.types", (0, 17)),
        ((0, 4), "order.enclosed", (0, 4)),
        ((4, 8, 5), "order.one-track", (8, 5)),
        ((19,), "edge-choice.no-edge", ()),
    ],
)
@pytest.mark.parametrize("machine", ["demo-table", "router-table"])
def test_an_order_that_breaks_a_rule_is_refused(
    machine: str, order: tuple[int, ...], code: str, edges_named: tuple[int, ...]
) -> None:
    with pytest.raises(PlanError) as caught:
        compiled(machine, "greyboard-3.0", order, LineType.CREASE)
    message = caught.value.message
    inner = message.arguments["error"] if message.code == "error.at-edge" else message
    assert inner.code == code
    assert caught.value.edges == edges_named


def test_an_edge_that_no_tool_makes_has_no_place() -> None:
    with pytest.raises(PlanError, match="no tool makes it"):
        compiled("demo-table", "fbb-0.4", (4, 16), LineType.IGNORED)


def test_a_chosen_direction_and_an_order_go_together() -> None:
    usual = compiled("demo-table", "fbb-0.4", (), LineType.CREASE)
    order = tuple(sorted((4, 8, 12), key=lambda row: begun(usual, row), reverse=True))
    directions: tuple[Literal["forward", "reverse"], ...] = ("forward", "reverse")
    for direction in directions:
        start = ContourStart(edges=(order[0],), at=0.5, direction=direction)
        made = compiled("demo-table", "fbb-0.4", order, LineType.CREASE, start)
        assert made.verdict.accepted
        assert begun(made, *order) == sorted(begun(made, *order))


#: Three blanks in a row with a hole and a crease each, a small blank in the hole of the second one,
#: and what belongs to each: outline, hole and crease, or the outline alone.
ROW = dieline(
    *(
        part
        for x in (100, 300, 500)
        for part in (
            (LineType.CUT, closed((x, 100), (x + 150, 100), (x + 150, 250), (x, 250))),
            (LineType.CUT, closed((x + 20, 120), (x + 80, 120), (x + 80, 180), (x + 20, 180))),
            (LineType.CREASE, edges(((x + 100, 110), (x + 100, 240)))),
        )
    ),
    (LineType.CUT, closed((335, 135), (365, 135), (365, 165), (335, 165))),
)
PARTS = ((0, 4, 8), (9, 13, 17), (18, 22, 26), (27,))


def row_compiled(order: tuple[int, ...]) -> Compiled:
    drawn = drawing(ROW.ends, [("CUT", 7, "CONTINUOUS")] * len(ROW), bulge=ROW.bulge)
    board = load.board("fbb-0.4")
    options = JobOptions(work_order=order)
    return pipeline.compile(drawn, ROW, load.machine("demo-table"), board, options=options)


def stages(made: Compiled, *rows: int) -> list[int]:
    """Return the operation of the first track along each edge."""
    return [bisect_right(made.toolpath.stages, one) for one in begun(made, *rows)]


@pytest.mark.parametrize("parts", [(2, 0, 1), (1, 2, 0), (0, 2, 1)])
def test_blanks_follow_each_other_in_each_layer(parts: tuple[int, ...]) -> None:
    usual = row_compiled(())
    assert stages(usual, 8, 27, 4, 0) == [1, 2, 3, 4]
    layers = [[PARTS[part][place] for part in parts] for place in (2, 1, 0)]
    order = (*layers[0], 27, *layers[1], *layers[2])
    made = row_compiled(order)
    assert made.verdict.accepted
    assert begun(made, *order) == sorted(begun(made, *order))
    assert [stages(made, *layer) for layer in layers] == [[1] * 3, [3] * 3, [4] * 3]

    def findings(program: Compiled) -> list[str]:
        found = pipeline.verify(
            program.program.text,
            ROW,
            program.placement,
            load.machine("demo-table"),
            load.board("fbb-0.4"),
            options=JobOptions(work_order=order),
        ).findings
        return [one.message.code for one in found if one.refuses]

    assert findings(made) == []
    for layer in layers:
        other = row_compiled(tuple(reversed(layer)))
        assert set(findings(other)) == {"verify.other-order"}


def test_a_blank_in_a_hole_is_cut_before_the_hole() -> None:
    with pytest.raises(PlanError) as caught:
        row_compiled((13, 27))
    assert caught.value.message.arguments["error"].code == "order.enclosed"
    # The edge of the hole is refused; the blank may come before holes and outlines of the others.
    assert row_compiled((27, 22, 4, 13, 18)).verdict.accepted
