"""What a cutter is told: which side, which way round, how deep in how many passes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.errors import NoToolForLineType, PlanError
from knifetip.model.board import Deflection
from knifetip.model.dieline import LineType
from knifetip.model.machine import Station
from knifetip.model.operation import End
from knifetip.model.tool import Cutter
from knifetip.planning.plan import missing, plan
from shapes import BOARD, MACHINE, closed, dieline, edges

ROUTER = Cutter(radius=3.0, feed=9000.0, plunge=1500.0, speed=18000.0)
HELD = Station(4, "Router", ROUTER, 0.0, 0.0, 0.0, 0.0, 3)
ROUTED = replace(MACHINE, stations=(*MACHINE.stations[1:], HELD))
BLANK = closed((0, 0), (200, 0), (200, 100), (0, 100))
HOLE = closed((20, 20), (40, 20), (40, 40), (20, 40))


def area(operation):
    a, b = operation.paths.start, operation.paths.end
    return float((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2)


@pytest.mark.parametrize("blank", [BLANK, BLANK[::-1, ::-1]], ids=["left", "right"])
@pytest.mark.parametrize("hole", [HOLE, HOLE[::-1, ::-1]], ids=["left", "right"])
def test_the_tool_is_left_of_travel_in_the_waste_however_it_was_drawn(blank, hole):
    line = dieline((LineType.CUT, blank), (LineType.CUT, hole))
    inner, outer = plan(line, ROUTED, BOARD)
    assert (inner.side, outer.side) == (1, 1)
    # A hole counter-clockwise, the blank clockwise.
    assert area(inner) == pytest.approx(400.0)
    assert area(outer) == pytest.approx(-20000.0)
    assert (inner.start[0], outer.finish[0]) == (End.CLOSED, End.CLOSED)


@pytest.mark.parametrize("turned", range(16))
def test_the_side_is_right_whichever_edges_were_drawn_the_other_way(turned):
    mixed = BLANK.copy()
    for edge in range(4):
        if turned >> edge & 1:
            mixed[edge] = mixed[edge, ::-1].copy()
    (operation,) = plan(dieline((LineType.CUT, mixed)), ROUTED, BOARD)
    assert operation.side == 1
    assert area(operation) == pytest.approx(-20000.0)


def test_two_blanks_that_touch_in_a_point_are_refused():
    one = closed((0, 0), (50, 0), (50, 50), (0, 50))
    other = closed((50, 50), (90, 50), (90, 90), (50, 90))
    with pytest.raises(PlanError, match=r"touch near \(50\.00, 50\.00\)"):
        plan(dieline((LineType.CUT, one), (LineType.CUT, other)), ROUTED, BOARD)


def test_a_slit_has_no_side_and_comes_before_the_holes():
    line = dieline(
        (LineType.CUT, BLANK), (LineType.CUT, HOLE), (LineType.CUT, edges(((60, 50), (150, 50))))
    )
    slit, hole, blank = plan(line, ROUTED, BOARD)
    assert (slit.side, hole.side, blank.side) == (0, 1, 1)
    assert slit.source.tolist() == [8]
    assert sorted(blank.source.tolist()) == [0, 1, 2, 3]


def test_an_edge_that_two_blanks_share_is_cut_on_the_line():
    one = edges(((100, 0), (100, 100)))
    line = dieline((LineType.CUT, BLANK), (LineType.CUT, one))
    shared, round_both = plan(line, ROUTED, BOARD)
    assert (shared.side, round_both.side) == (0, 1)
    assert shared.source.tolist() == [4]


def test_a_contour_drawn_with_gaps_within_the_joining_is_closed_to_the_bit():
    loose = BLANK.copy()
    loose[1, 0] += [0.0008, -0.0009]
    loose[3, 1] += [0.0005, 0.0005]
    (operation,) = plan(dieline((LineType.CUT, loose)), ROUTED, BOARD)
    assert operation.paths.closed.all()
    np.testing.assert_array_equal(operation.paths.end, np.roll(operation.paths.start, -1, axis=0))


def test_passes_are_even_and_none_is_deeper_than_the_step():
    stepping = replace(HELD, tool=replace(ROUTER, step=1.0))
    (operation,) = plan(
        dieline((LineType.CUT, BLANK)), replace(ROUTED, stations=(stepping,)), BOARD
    )
    # 2.0 of board and 0.3 into the mat.
    np.testing.assert_allclose(operation.depth[0], [2.3 / 3, 4.6 / 3, 2.3])
    (operation,) = plan(dieline((LineType.CUT, BLANK)), ROUTED, BOARD)
    np.testing.assert_allclose(operation.depth[0], [2.3])


def test_the_operation_knows_the_machines_acceleration_and_the_boards_deflection():
    measured = replace(
        BOARD, deflection=(Deflection("Other", 9, 9), Deflection("Router", 0.1, 0.2))
    )
    (operation,) = plan(dieline((LineType.CUT, BLANK)), ROUTED, measured)
    assert operation.deflection == (0.1, 0.2)
    assert (operation.acceleration, operation.corner) == (8000.0, "auto")
    (operation,) = plan(dieline((LineType.CUT, BLANK)), ROUTED, BOARD)
    assert operation.deflection == (0.0, 0.0)


def test_a_knife_comes_first_where_there_are_both():
    both = replace(MACHINE, stations=(HELD, *MACHINE.stations))
    (operation,) = plan(dieline((LineType.CUT, BLANK)), both, BOARD)
    assert operation.station == 1


def test_a_cutter_makes_cuts_and_nothing_else_of_a_knifes_work():
    assert not missing(LineType.CUT, ROUTED)
    for kind in (LineType.PERFORATION, LineType.HALF_CUT, LineType.COMBI):
        assert missing(kind, ROUTED)
    with pytest.raises(NoToolForLineType, match="half-cut"):
        plan(dieline((LineType.HALF_CUT, edges(((0, 0), (50, 0))))), ROUTED, BOARD)
