"""Tool, depth and order of operations, and the kinds of their ends."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.errors import NoToolForLineType
from knifetip.model.dieline import LineType
from knifetip.model.operation import End, Operation
from knifetip.planning.plan import plan
from knifetip.planning.tool_steps import lacks_tool
from tests.support.shapes import BOARD, MACHINE, closed, dieline, edges

OUTLINE = closed((0, 0), (200, 0), (200, 100), (0, 100))
HOLE = closed((20, 20), (40, 20), (40, 40), (20, 40))


def only(operations: list[Operation]) -> Operation:
    assert len(operations) == 1
    return operations[0]


def test_creases_come_first_and_the_outline_last() -> None:
    line = dieline(
        (LineType.CUT, OUTLINE),
        (LineType.CUT, HOLE),
        (LineType.HALF_CUT, edges(((50, 10), (50, 90)))),
        (LineType.V_GROOVE, edges(((80, 0), (80, 100)))),
        (LineType.CREASE, edges(((120, 0), (120, 100)))),
    )
    operations = plan(line, MACHINE, BOARD)
    assert [operation.line_type for operation in operations] == [
        LineType.CREASE, LineType.V_GROOVE, LineType.HALF_CUT, LineType.CUT, LineType.CUT,
    ]  # fmt: skip
    assert sorted(set(operations[3].source.tolist())) == [4, 5, 6, 7]
    assert sorted(set(operations[4].source.tolist())) == [0, 1, 2, 3]


def test_depths_come_from_the_board() -> None:
    line = dieline(
        (LineType.CUT, OUTLINE),
        (LineType.HALF_CUT, edges(((50, 10), (50, 90)))),
        (LineType.V_GROOVE, edges(((80, 0), (80, 100)))),
    )
    groove, half, cut = plan(line, MACHINE, BOARD)
    assert set(groove.depth.ravel()) == {1.0}
    assert set(half.depth.ravel()) == {0.8}
    assert set(cut.depth.ravel()) == {2.3}  # caliper 2.0 and 0.3 into the mat


def test_a_groove_goes_down_in_equal_passes_none_deeper_than_the_board_allows() -> None:
    line = dieline((LineType.V_GROOVE, edges(((80, 10), (80, 90)))))
    assert only(plan(line, MACHINE, BOARD)).depth.tolist() == [[1.0]]
    three = only(plan(line, MACHINE, replace(BOARD, groove_pass=0.4)))
    np.testing.assert_allclose(three.depth, [[1 / 3, 2 / 3, 1.0]])
    two = only(plan(line, MACHINE, replace(BOARD, groove_pass=0.5)))
    np.testing.assert_allclose(two.depth, [[0.5, 1.0]])


def test_a_groove_runs_out_where_it_meets_the_outline_and_only_there() -> None:
    # 2 mm wide; from the left edge at 45° to the middle of the board.
    line = dieline((LineType.CUT, OUTLINE), (LineType.V_GROOVE, edges(((0, 20), (50, 70)))))
    groove = plan(line, MACHINE, BOARD)[0]
    np.testing.assert_allclose(groove.run_out, [[1.0, 0.0]])
    assert (groove.start[0], groove.finish[0]) == (End.MEETS, End.FREE)


def test_a_groove_that_ends_on_a_hole_or_on_a_slit_does_not_run_out() -> None:
    slit = (LineType.CUT, edges(((120, 10), (120, 90))))
    groove = (LineType.V_GROOVE, edges(((40, 30), (120, 50))))
    line = dieline((LineType.CUT, OUTLINE), (LineType.CUT, HOLE), slit, groove)
    assert not plan(line, MACHINE, BOARD)[0].run_out.any()


def test_a_groove_at_ten_degrees_to_the_edge_runs_out() -> None:
    reach = 30.0 / np.tan(np.radians(10.0))
    line = dieline(
        (LineType.CUT, OUTLINE), (LineType.V_GROOVE, edges(((10, 70), (10 + reach, 100))))
    )
    # cot 10° = 5.6713
    assert plan(line, MACHINE, BOARD)[0].run_out[0, 1] == pytest.approx(5.67128, abs=1e-5)


def test_a_repeated_cut_is_cut_once() -> None:
    line = dieline((LineType.CUT, OUTLINE), (LineType.CUT, OUTLINE[:2, ::-1]))
    operation = only(plan(line, MACHINE, BOARD))
    assert sorted(set(operation.source.tolist())) == [0, 1, 2, 3]
    assert operation.start.tolist() == [End.CLOSED]


@pytest.mark.parametrize(("end", "depth"), [((0, 50), 0.4), ((50, 0), 0.6), ((50, 50), 0.5)])
def test_the_depth_of_a_crease_depends_on_its_angle_to_the_grain(
    end: tuple[int, int], depth: float
) -> None:
    operation = only(plan(dieline((LineType.CREASE, edges(((0, 0), end)))), MACHINE, BOARD))
    assert operation.depth[0, 0] == pytest.approx(depth)


def test_a_slit_from_the_outline_is_cut_from_its_free_end() -> None:
    line = dieline((LineType.CUT, OUTLINE), (LineType.CUT, edges(((200, 50), (150, 50)))))
    slit, _ = plan(line, MACHINE, BOARD)
    np.testing.assert_array_equal(slit.paths.start, [[150.0, 50.0]])
    assert (slit.start[0], slit.finish[0]) == (End.FREE, End.MEETS)


def test_a_slit_that_ends_on_the_middle_of_an_edge_meets_it() -> None:
    line = dieline((LineType.CUT, OUTLINE), (LineType.CUT, edges(((100, 0.03), (100, 60)))))
    slit, _ = plan(line, MACHINE, BOARD)
    assert slit.finish[0] == End.MEETS


def test_a_crease_that_another_continues_is_not_free_there() -> None:
    # Three edges meet at (100, 50), two of them collinear with the first: no two are connected.
    line = dieline(
        (
            LineType.CREASE,
            edges(((0, 50), (100, 50)), ((100, 50), (200, 50)), ((100, 50), (200, 50.5))),
        )
    )
    operation = only(plan(line, MACHINE, BOARD))
    assert operation.start.tolist() == [End.FREE, End.CONTINUED, End.CONTINUED]
    assert operation.finish.tolist() == [End.CONTINUED, End.FREE, End.FREE]


def test_a_perforation_begins_and_ends_with_a_cut() -> None:
    operation = only(
        plan(dieline((LineType.PERFORATION, edges(((0, 0), (23, 0))))), MACHINE, BOARD)
    )
    # Cuts of 3 and gaps of 2: five of them fill 23 mm exactly.
    np.testing.assert_allclose(operation.paths.start[:, 0], [0, 5, 10, 15, 20])
    np.testing.assert_allclose(operation.paths.end[:, 0], [3, 8, 13, 18, 23])


def test_a_combi_edge_is_creased_and_perforated() -> None:
    operations = plan(dieline((LineType.COMBI, edges(((0, 0), (23, 0))))), MACHINE, BOARD)
    assert [operation.station for operation in operations] == [2, 1]


def test_ignored_and_unclassified_edges_are_skipped() -> None:
    line = dieline(
        (LineType.IGNORED, edges(((0, 0), (23, 0)))),
        (LineType.UNCLASSIFIED, edges(((0, 10), (23, 10)))),
    )
    assert plan(line, MACHINE, BOARD) == []


def test_a_machine_without_the_tool_refuses() -> None:
    knife_only = replace(MACHINE, stations=MACHINE.stations[:1])
    assert lacks_tool(knife_only, LineType.CREASE)
    assert not lacks_tool(knife_only, LineType.CUT)
    with pytest.raises(NoToolForLineType, match=r"no tool for .* of type crease"):
        plan(dieline((LineType.CREASE, edges(((0, 0), (50, 0))))), knife_only, BOARD)


#: A slit inside the panel, on which other slits end.
THROUGH = edges(((50, 50), (150, 50)))


@pytest.mark.parametrize(
    ("slit", "kinds"),
    [
        (((100, 80), (100, 50)), (End.FREE, End.JUNCTION)),
        (((100, 50), (100, 80)), (End.FREE, End.JUNCTION)),
        (((100, 50), (100, 100)), (End.JUNCTION, End.MEETS)),  # it runs out over the outline
        (((100, 100), (100, 50)), (End.JUNCTION, End.MEETS)),
        (((30, 60), (30, 40)), (End.FREE, End.MEETS)),  # it runs out into the hole
        (((100, -30), (100, 0)), (End.FREE, End.JUNCTION)),  # a cut in the waste
        (((170, 70), (200, 100)), (End.FREE, End.MEETS)),  # at an outer corner
    ],
)
def test_the_kind_of_an_end_on_a_cut_depends_on_what_is_ahead(
    slit: tuple[tuple[int, int], tuple[int, int]], kinds: tuple[End, End]
) -> None:
    line = dieline(
        (LineType.CUT, OUTLINE), (LineType.CUT, HOLE), (LineType.CUT, THROUGH),
        (LineType.CUT, edges(slit)),
    )  # fmt: skip
    row = len(line) - 1
    found = []
    for operation in plan(line, MACHINE, BOARD):
        for path in range(len(operation.paths)):
            segments = slice(operation.paths.first[path], operation.paths.first[path + 1])
            if operation.source[segments].tolist() == [row]:
                found.append((operation.start[path], operation.finish[path]))
    assert found == [kinds]


def test_a_half_cut_that_ends_on_a_slit_stops_there() -> None:
    line = dieline(
        (LineType.CUT, OUTLINE), (LineType.CUT, THROUGH),
        (LineType.HALF_CUT, edges(((100, 50), (100, 80)), ((20, 60), (0, 60)))),
    )  # fmt: skip
    half = plan(line, MACHINE, BOARD)[0]
    assert half.start.tolist() == [End.FREE, End.FREE]
    assert half.finish.tolist() == [End.JUNCTION, End.MEETS]


def test_slits_that_cross_are_cut_straight_through() -> None:
    line = dieline(
        (LineType.CUT, OUTLINE),
        (LineType.CUT, THROUGH),
        (LineType.CUT, edges(((100, 20), (100, 80)))),
    )
    crossing, _ = plan(line, MACHINE, BOARD)
    assert set(crossing.start.tolist()) | set(crossing.finish.tolist()) == {End.FREE}
