"""Which tool, how deep, in what order, and what the ends meet."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.errors import NoToolForLineType
from knifetip.model.dieline import LineType
from knifetip.model.operation import End
from knifetip.planning.plan import missing, plan
from shapes import BOARD, MACHINE, closed, dieline, edges

OUTLINE = closed((0, 0), (200, 0), (200, 100), (0, 100))
HOLE = closed((20, 20), (40, 20), (40, 40), (20, 40))


def only(operations):
    assert len(operations) == 1
    return operations[0]


def test_creases_come_first_and_the_outline_last():
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


def test_depths_are_the_boards():
    line = dieline(
        (LineType.CUT, OUTLINE),
        (LineType.HALF_CUT, edges(((50, 10), (50, 90)))),
        (LineType.V_GROOVE, edges(((80, 0), (80, 100)))),
    )
    groove, half, cut = plan(line, MACHINE, BOARD)
    assert set(groove.depth.ravel()) == {1.0}
    assert set(half.depth.ravel()) == {0.8}
    assert set(cut.depth.ravel()) == {2.3}  # caliper 2.0 and 0.3 into the mat


@pytest.mark.parametrize(("end", "depth"), [((0, 50), 0.4), ((50, 0), 0.6), ((50, 50), 0.5)])
def test_a_crease_is_as_deep_as_its_angle_to_the_grain_asks(end, depth):
    operation = only(plan(dieline((LineType.CREASE, edges(((0, 0), end)))), MACHINE, BOARD))
    assert operation.depth[0, 0] == pytest.approx(depth)


def test_a_slit_from_the_outline_is_cut_from_its_free_end():
    line = dieline((LineType.CUT, OUTLINE), (LineType.CUT, edges(((200, 50), (150, 50)))))
    slit, _ = plan(line, MACHINE, BOARD)
    np.testing.assert_array_equal(slit.paths.start, [[150.0, 50.0]])
    assert (slit.start[0], slit.finish[0]) == (End.FREE, End.MEETS)


def test_a_slit_that_ends_on_the_middle_of_an_edge_meets_it():
    line = dieline((LineType.CUT, OUTLINE), (LineType.CUT, edges(((100, 0.03), (100, 60)))))
    slit, _ = plan(line, MACHINE, BOARD)
    assert slit.finish[0] == End.MEETS


def test_a_crease_that_another_continues_is_not_free_there():
    # Three ways leave (100, 50): straight on there are two, so chaining has left them all open.
    line = dieline(
        (
            LineType.CREASE,
            edges(((0, 50), (100, 50)), ((100, 50), (200, 50)), ((100, 50), (200, 50.5))),
        )
    )
    operation = only(plan(line, MACHINE, BOARD))
    assert operation.start.tolist() == [End.FREE, End.CONTINUED, End.CONTINUED]
    assert operation.finish.tolist() == [End.CONTINUED, End.FREE, End.FREE]


def test_a_perforation_begins_and_ends_with_a_cut():
    operation = only(
        plan(dieline((LineType.PERFORATION, edges(((0, 0), (23, 0))))), MACHINE, BOARD)
    )
    # Cuts of 3 and gaps of 2: five of them fill 23 mm exactly.
    np.testing.assert_allclose(operation.paths.start[:, 0], [0, 5, 10, 15, 20])
    np.testing.assert_allclose(operation.paths.end[:, 0], [3, 8, 13, 18, 23])


def test_a_combi_edge_is_creased_and_perforated():
    operations = plan(dieline((LineType.COMBI, edges(((0, 0), (23, 0))))), MACHINE, BOARD)
    assert [operation.station for operation in operations] == [2, 1]


def test_ignored_and_unclassified_edges_are_left_alone():
    line = dieline(
        (LineType.IGNORED, edges(((0, 0), (23, 0)))),
        (LineType.UNCLASSIFIED, edges(((0, 10), (23, 10)))),
    )
    assert plan(line, MACHINE, BOARD) == []


def test_a_machine_without_the_tool_refuses():
    knife_only = replace(MACHINE, stations=MACHINE.stations[:1])
    assert missing(LineType.CREASE, knife_only)
    assert not missing(LineType.CUT, knife_only)
    with pytest.raises(NoToolForLineType, match="1 edges are crease"):
        plan(dieline((LineType.CREASE, edges(((0, 0), (50, 0))))), knife_only, BOARD)
