"""Contours are cut after those inside them: planned, verified, and refused in another order."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.model.verdict import Verdict
from knifetip.verification.verify import verify
from tests.support.cartons import nested_contours
from tests.support.cartons.nested_contours import Sheet
from tests.support.shapes import closed, dieline, edges

KNIFE, ROUTER = load.machine("demo-table"), load.machine("router-table")
LASER = load.machine("laser-table")
BOARD, THICK = load.board("greyboard-2.0"), load.board("greyboard-3.0")
CUT, CREASE = LineType.CUT, LineType.CREASE


def made(
    line: Dieline,
    machine: Machine = KNIFE,
    board: Board = BOARD,
    order: tuple[int, ...] | None = None,
) -> Toolpath:
    operations = plan(line, machine, board)
    if order is not None:
        operations = [operations[place] for place in order]
    return sequence([compensate(operation) for operation in operations], machine)


def verdict_of(
    line: Dieline, toolpath: Toolpath, machine: Machine = KNIFE, board: Board = BOARD
) -> Verdict:
    return verify(
        process(toolpath, machine, machine.dialect).text, line, (0.0, 0.0), machine, board
    )


def out_of_order(sheet: Sheet, toolpath: Toolpath) -> list[tuple[int, int]]:
    """Return the pairs (inner, outer) in which the inner contour is cut after the outer is
    complete.
    """
    rows = np.flatnonzero(toolpath.source >= 0)
    contour = sheet.contour[toolpath.source[rows]]
    last = {one: rows[contour == one].max() for one in np.unique(contour)}
    return [(inner, outer) for inner, outer in sheet.pairs if last[inner] > last[outer]]


def box(x: float, y: float, wide: float, high: float) -> F64:
    return closed((x, y), (x + wide, y), (x + wide, y + high), (x, y + high))


@pytest.mark.parametrize("gap", [0.0, 0.4, 1.4])
def test_a_knife_cuts_every_contour_after_what_lies_inside_it(gap: float) -> None:
    count = 0
    for seed in range(8):
        sheet = nested_contours.sheet(seed, clearance=6.0, min_side=15.0, gap=gap)
        toolpath = made(sheet.line)
        assert out_of_order(sheet, toolpath) == []
        verdict = verdict_of(sheet.line, toolpath)
        assert verdict.accepted, verdict.findings[:2]
        count += len(sheet.pairs)
    assert count >= 500


def test_a_router_mills_every_contour_after_what_lies_inside_it() -> None:
    count = 0
    for seed in range(14):
        sheet = nested_contours.sheet(seed, clearance=14.0, min_side=30.0)
        toolpath = made(sheet.line, ROUTER, THICK)
        assert out_of_order(sheet, toolpath) == []
        verdict = verdict_of(sheet.line, toolpath, ROUTER, THICK)
        assert verdict.accepted, verdict.findings[:2]
        count += len(sheet.pairs)
    assert count >= 250


NEST = dieline(
    *((CUT, box(*one)) for one in ((100, 100, 420, 320), (190, 160, 240, 200))),
    *((CUT, box(*one)) for one in ((220, 190, 180, 140), (270, 225, 70, 60))),
)
SWAPS = [(1, 0, 2, 3), (0, 2, 1, 3), (0, 1, 3, 2), (3, 2, 1, 0)]


@pytest.mark.parametrize(("machine", "board"), [(KNIFE, BOARD), (ROUTER, THICK)], ids=str)
def test_an_inner_contour_behind_its_outer_one_is_refused(machine: Machine, board: Board) -> None:
    assert verdict_of(NEST, made(NEST, machine, board), machine, board).accepted
    for order in SWAPS:
        verdict = verdict_of(NEST, made(NEST, machine, board, order), machine, board)
        kinds = {found.kind for found in verdict.findings if found.refuses}
        assert kinds == {"order"}, order
        first = verdict.findings[0]
        assert first.edge >= 0
        assert first.line > 0
        assert (
            "of the program has already cut out, so this part of the board may move" in first.text
        )


@pytest.mark.parametrize("gap", [0.05, 0.4, 1.4])
def test_a_blank_with_gaps_that_is_cut_before_what_lies_inside_it_is_refused(gap: float) -> None:
    g = gap
    blank = edges(
        ((100 + g, 100), (300, 100)), ((300, 100), (300, 150 - g / 2)),
        ((300, 150 + g / 2), (300, 300 - g)), ((300, 300), (100, 300)), ((100, 300), (100, 100)),
    )  # fmt: skip
    line = dieline(
        (CUT, blank), (CUT, box(130, 150, 20, 20)), (CREASE, edges(((200, 100), (200, 300))))
    )
    assert verdict_of(line, made(line)).accepted
    assert verdict_of(line, made(line, order=(1, 0, 2, 3))).accepted, (
        "a crease before the blank is legal"
    )
    hole = verdict_of(line, made(line, order=(0, 2, 3, 1)))
    assert {finding.edge for finding in hole.findings} == {5, 6, 7, 8}
    crease = verdict_of(line, made(line, order=(1, 2, 3, 0)))
    assert {finding.edge for finding in crease.findings} == {9}


@pytest.mark.parametrize("kind", [CREASE, LineType.HALF_CUT, LineType.PERFORATION])
def test_other_work_on_a_part_that_is_loose_is_refused(kind: LineType) -> None:
    line = dieline((CUT, box(100, 100, 200, 100)), (kind, edges(((150, 120), (150, 180)))))
    assert verdict_of(line, made(line)).accepted
    late = verdict_of(line, made(line, order=(1, 0)))
    assert {(finding.kind, finding.edge) for finding in late.findings} == {("order", 4)}
    waste = dieline((CUT, box(100, 100, 200, 100)), (kind, edges(((350, 120), (350, 180)))))
    assert verdict_of(waste, made(waste, order=(1, 0))).accepted


def test_parts_that_share_an_edge_and_a_ladder_are_cut_from_inside() -> None:
    rungs = edges(*(((100, y), (300, y)) for y in (140, 180, 220)))
    line = dieline(
        (CUT, box(100, 100, 200, 160)), (CUT, rungs), (CUT, box(150, 150, 20, 20)),
        (CUT, edges(((300, 120), (340, 120)), ((340, 120), (340, 200)), ((340, 200), (300, 200)))),
    )  # fmt: skip
    verdict = verdict_of(line, made(line))
    assert verdict.accepted, verdict.findings[:2]
    assert not verdict_of(line, made(line, order=(1, 0, *range(2, len(plan(line, KNIFE, BOARD)))))
                      ).accepted  # fmt: skip


def test_a_grid_of_lines_drawn_across_each_other_is_cut_in_an_order_that_holds() -> None:
    across = [((90, y), (230, y)) for y in (100, 140, 180, 220)]
    up = [((x, 90), (x, 230)) for x in (100, 140, 180, 220)]
    line = dieline((CUT, edges(*across, *up)))
    assert verdict_of(line, made(line)).accepted
    inner, outer = plan(line, KNIFE, BOARD)
    assert sorted(set(inner.source.tolist())) == [1, 2, 5, 6]
    assert sorted(set(outer.source.tolist())) == [0, 3, 4, 7]


def test_a_hole_that_touches_its_contour_in_a_vertex_comes_first() -> None:
    hole = closed((100, 100), (160, 120), (120, 160))
    line = dieline((CUT, box(100, 100, 200, 100)), (CUT, hole), (CUT, box(125, 125, 5, 5)))
    verdict = verdict_of(line, made(line))
    assert verdict.accepted, verdict.findings[:2]
    assert [sorted(set(one.source.tolist())) for one in plan(line, KNIFE, BOARD)] == [
        [7, 8, 9, 10], [4, 5, 6], [0, 1, 2, 3],
    ]  # fmt: skip


def test_bridges_hold_parts_at_every_depth() -> None:
    held = replace(BOARD, bridge_width=0.8, bridge_spacing=150.0)
    toolpath = made(NEST, board=held)
    verdict = verdict_of(NEST, toolpath, board=held)
    assert verdict.accepted, verdict.findings[:2]
    tracks = {
        edge // 4: len(np.unique(toolpath.track[toolpath.source // 4 == edge // 4]))
        for edge in (0, 4, 8, 12)
    }
    assert tracks[1] == tracks[3] == 1
    assert tracks[0] > 2
    assert tracks[2] > 2


def test_the_last_pass_of_a_hole_ends_where_its_waste_comes_loose() -> None:
    line = dieline((CUT, box(100, 100, 200, 100)), (CUT, box(130, 130, 60, 40)))
    toolpath = made(line, ROUTER, THICK)
    assert verdict_of(line, toolpath, ROUTER, THICK).accepted
    deepest = toolpath.pose[1:, 2] == toolpath.pose[:, 2].min()
    out = (toolpath.motion == Motion.LEAD_OUT) & (toolpath.source >= 4)
    assert out.any(), "the passes before come out of the waste"
    assert not (out & deepest).any()
    assert ((toolpath.motion == Motion.LEAD_OUT) & (toolpath.source < 4) & deepest).any()


def order_codes(verdict: Verdict) -> set[tuple[str, int]]:
    """Return the message codes and edges of the findings about the order."""
    return {(one.message.code, one.edge) for one in verdict.findings if one.kind == "order"}


def test_a_hole_in_a_piece_on_necks_is_cut_before_the_last_slit() -> None:
    # Slits round a square of 80 mm, with necks of 3 mm between them.
    slits = edges(
        ((200, 200), (277, 200)), ((280, 200), (280, 277)), ((280, 280), (203, 280)),
        ((200, 280), (200, 203)),
    )  # fmt: skip
    line = dieline((CUT, box(100, 100, 300, 300)), (CUT, slits), (CUT, box(230, 230, 20, 20)))
    assert [min(one.source.tolist()) for one in plan(line, KNIFE, BOARD)] == [8, 4, 0]
    assert order_codes(verdict_of(line, made(line))) == set()
    late = verdict_of(line, made(line, order=(1, 0, 2)))
    assert order_codes(late) == {("verify.hanging-piece", edge) for edge in range(8, 12)}


@pytest.mark.parametrize("gap", [3.0, 3.9])
def test_a_hole_in_a_blank_with_a_wide_gap_is_cut_before_the_blank(gap: float) -> None:
    blank = edges(
        ((100, 100), (300, 100)), ((300, 100), (300, 200 - gap / 2)),
        ((300, 200 + gap / 2), (300, 300)), ((300, 300), (100, 300)), ((100, 300), (100, 100)),
    )  # fmt: skip
    line = dieline((CUT, blank), (CUT, box(130, 150, 20, 20)))
    assert verdict_of(line, made(line)).accepted
    late = verdict_of(line, made(line, order=(1, 0)))
    assert order_codes(late) == {("verify.hanging-piece", edge) for edge in range(5, 9)}


def test_a_hole_in_a_part_on_wide_bridges_is_cut_before_the_part() -> None:
    line = dieline((CUT, box(100, 100, 200, 200)), (CUT, box(150, 150, 20, 20)))
    held = replace(BOARD, bridge_width=6.0, bridge_spacing=100.0)
    assert verdict_of(line, made(line, board=held), board=held).accepted
    late = verdict_of(line, made(line, board=held, order=(1, 0)), board=held)
    assert order_codes(late) == {("verify.hanging-piece", edge) for edge in range(4, 8)}


@pytest.mark.parametrize(
    ("left", "code"), [(1.5, "verify.loose-piece"), (3.0, "verify.hanging-piece")]
)
def test_a_short_length_that_a_knife_leaves_uncut_does_not_hold_the_part(
    left: float, code: str
) -> None:
    sides, hole = box(100, 100, 200, 100), box(150, 130, 20, 20)
    line = dieline((CUT, sides), (CUT, hole))
    outline = np.concatenate([sides[:3], edges(((100, 200), (100, 100 + left)))])
    parts = [dieline((CUT, outline)), dieline((CUT, hole))]
    operations = [one for part in parts for one in plan(part, KNIFE, BOARD)]
    late = verdict_of(line, sequence([compensate(one) for one in operations], KNIFE))
    assert order_codes(late) == {(code, edge) for edge in range(4, 8)}


@pytest.mark.parametrize("kind", [CREASE, LineType.HALF_CUT, LineType.PERFORATION])
def test_other_work_after_the_first_cut_of_the_outline_is_refused(kind: LineType) -> None:
    sides = box(100, 100, 200, 100)
    other = edges(((150, 120), (150, 180)))
    line = dieline((CUT, sides), (CUT, box(220, 120, 20, 20)), (kind, other))

    def verdict_in(*order: Dieline) -> Verdict:
        operations = [one for part in order for one in plan(part, KNIFE, BOARD)]
        return verdict_of(line, sequence([compensate(one) for one in operations], KNIFE))

    begun, rest = dieline((CUT, sides[:1])), dieline((CUT, sides[1:]))
    hole, work = dieline((CUT, box(220, 120, 20, 20))), dieline((kind, other))
    assert order_codes(verdict_in(hole, work, begun, rest)) == set()
    assert order_codes(verdict_in(hole, begun, work, rest)) == {("verify.outline-begun", 8)}


def test_a_beam_that_crosses_a_cut_at_a_small_angle_does_not_make_that_cut() -> None:
    # Both lines leave the panel, so either may be cut after it.
    lines = edges(((150, 90), (150, 310)), ((140, 85), (160, 305)))
    line = dieline((CUT, box(100, 100, 200, 200)), (CUT, lines[:1]), (CUT, lines[1:]))
    parts = [dieline((CUT, part)) for part in (box(100, 100, 200, 200), lines[:1], lines[1:])]
    operations = [one for part in parts for one in plan(part, LASER, BOARD)]
    toolpath = sequence([compensate(one) for one in operations], LASER)
    assert order_codes(verdict_of(line, toolpath, LASER)) == set()


@pytest.mark.parametrize("mirrored", [False, True])
def test_a_laser_may_cut_slits_that_continue_an_outline_one_after_the_other(mirrored: bool) -> None:
    # The first 0.2 mm of one line and the last 0.2 mm of the other belong to the outline.  As the
    # program is rounded, the first slit begins 0.00004 mm before the outline leaves its line.
    x = 59.99996
    outline = edges(
        ((0, 30), (0, 0)), ((0, 0), (x, 0)), ((x, 0), (x, 30)), ((60.2, 30), (60.2, 80)),
        ((60.2, 80), (-0.2, 80)), ((-0.2, 80), (-0.2, 30)),
    )  # fmt: skip
    slits = edges(((60.2, 30), (40, 30)), ((20, 30), (-0.2, 30)))
    if mirrored:
        mirror = np.array([-1.0, 1.0])
        outline, slits = ((60.0, 0.0) + mirror * ends for ends in (outline, slits))
    line = dieline((CUT, outline + 10.0), (CUT, slits + 10.0))
    verdict = verdict_of(line, made(line, LASER), LASER)
    assert [finding.text for finding in verdict.findings if finding.refuses] == []
