"""Operations of a cutter: side, direction, depth and number of passes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.errors import NoRoomForBridges, NoToolForLineType, PlanError
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths, select_paths
from knifetip.model.board import Deflection
from knifetip.model.dieline import LineType
from knifetip.model.machine import Station
from knifetip.model.operation import End
from knifetip.model.tool import Cutter
from knifetip.planning.plan import plan
from knifetip.planning.tool_steps import lacks_tool
from tests.support.shapes import BOARD, MACHINE, closed, dieline, edges

ROUTER = Cutter(radius=3.0, feed=9000.0, plunge=1500.0, speed=18000.0)
HELD = Station(4, "Router", ROUTER, 0.0, 0.0, 0.0, 0.0, 3)
ROUTED = replace(MACHINE, stations=(*MACHINE.stations[1:], HELD))
BLANK = closed((0, 0), (200, 0), (200, 100), (0, 100))
HOLE = closed((20, 20), (40, 20), (40, 40), (20, 40))


def area(paths: Paths) -> float:
    a, b = paths.start, paths.end
    return float((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2)


@pytest.mark.parametrize("blank", [BLANK, BLANK[::-1, ::-1]], ids=["left", "right"])
@pytest.mark.parametrize("hole", [HOLE, HOLE[::-1, ::-1]], ids=["left", "right"])
def test_the_tool_is_in_the_waste_on_the_left_of_travel(blank: F64, hole: F64) -> None:
    line = dieline((LineType.CUT, blank), (LineType.CUT, hole))
    inner, outer = plan(line, ROUTED, BOARD)
    assert (inner.side, outer.side) == (1, 1)
    # A hole counter-clockwise, the blank clockwise.
    assert area(inner.paths) == pytest.approx(400.0)
    assert area(outer.paths) == pytest.approx(-20000.0)
    assert (inner.start[0], outer.finish[0]) == (End.CLOSED, End.CLOSED)


@pytest.mark.parametrize("turned", range(16))
def test_the_side_does_not_depend_on_the_direction_of_edges(turned: int) -> None:
    mixed = BLANK.copy()
    for edge in range(4):
        if turned >> edge & 1:
            mixed[edge] = mixed[edge, ::-1].copy()
    (operation,) = plan(dieline((LineType.CUT, mixed)), ROUTED, BOARD)
    assert operation.side == 1
    assert area(operation.paths) == pytest.approx(-20000.0)


@pytest.mark.parametrize("turned", range(16))
def test_the_side_does_not_depend_on_the_first_edge_of_an_open_contour(
    turned: int,
) -> None:
    # A slit starts halfway between two ends 0.003 apart, which form one vertex only with it.
    loose = BLANK.copy()
    loose[3, 1] = (-0.003, 0.0)
    for edge in range(4):
        if turned >> edge & 1:
            loose[edge] = loose[edge, ::-1].copy()
    slit = edges(((-0.0015, 0.0), (50.0, 50.0)))
    operations = plan(dieline((LineType.CUT, loose), (LineType.CUT, slit)), ROUTED, BOARD)
    round_it = operations[-1]
    assert (round_it.side, len(round_it.paths), len(round_it.source)) == (1, 1, 4)
    assert area(round_it.paths) == pytest.approx(-20000.0, rel=1e-4)


TOUCHING = (
    closed((0, 0), (50, 0), (50, 50), (0, 50)),
    closed((50, 50), (90, 50), (90, 90), (50, 90)),
)


@pytest.mark.parametrize("turned", range(4))
def test_blanks_that_touch_in_a_point_are_each_milled_from_outside(turned: int) -> None:
    # Their sides cross at the point where they touch.
    one, other = (
        blank[::-1, ::-1] if turned >> place & 1 else blank for place, blank in enumerate(TOUCHING)
    )
    (operation,) = plan(dieline((LineType.CUT, one), (LineType.CUT, other)), ROUTED, BOARD)
    assert (len(operation.paths), bool(operation.paths.closed.all()), operation.side) == (
        2,
        True,
        1,
    )
    # Both are clockwise: 50² and 40².
    assert [area(select_paths(operation.paths, np.array([path]))[0]) for path in range(2)] == [
        -2500,
        -1600,
    ]


def test_blanks_with_waste_between_two_points_where_they_touch_are_each_milled_whole() -> None:
    # Neither blank can be cut completely before the other one.  They overlap by the digits of a
    # drawing.
    low = np.add(closed((0, 0), (100, 0), (100, 40), (50, 40), (0, 40)), (0.0, 1e-6))
    high = closed((0, 52), (50, 52), (100, 52), (100, 90), (0, 90))
    bent = {2: 0.24, 3: 0.24, 5: 0.24, 6: 0.24}
    line = dieline((LineType.CUT, low), (LineType.CUT, high), bulge=bent)
    (operation,) = plan(line, ROUTED, BOARD)
    assert operation.paths.closed.tolist() == [True, True]
    assert len(operation.source) == 10


def test_holes_that_touch_in_a_point_are_each_milled_from_inside() -> None:
    sheet = closed((-50, -50), (150, -50), (150, 150), (-50, 150))
    line = dieline(*((LineType.CUT, ends) for ends in (sheet, *TOUCHING)))
    inner, outer = plan(line, ROUTED, BOARD)
    assert (len(inner.paths), bool(inner.paths.closed.all()), inner.side) == (2, True, 1)
    assert area(inner.paths) == pytest.approx(2500.0 + 1600.0)
    assert area(outer.paths) == pytest.approx(-40000.0)


def test_a_slit_has_no_side_and_comes_before_the_holes() -> None:
    line = dieline(
        (LineType.CUT, BLANK), (LineType.CUT, HOLE), (LineType.CUT, edges(((60, 50), (150, 50))))
    )
    slit, hole, blank = plan(line, ROUTED, BOARD)
    assert (slit.side, hole.side, blank.side) == (0, 1, 1)
    assert slit.source.tolist() == [8]
    assert sorted(blank.source.tolist()) == [0, 1, 2, 3]


def test_an_edge_that_two_blanks_share_is_cut_on_its_line_before_the_outline() -> None:
    shared = dieline((LineType.CUT, BLANK), (LineType.CUT, edges(((100, 0), (100, 100)))))
    slit, outline = plan(shared, ROUTED, BOARD)
    assert (slit.source.tolist(), slit.side) == ([4], 0)
    assert (set(outline.source.tolist()), outline.side) == ({0, 1, 2, 3}, 1)


def test_the_outline_of_a_blank_that_cuts_divide_is_one_closed_path() -> None:
    across = edges(((50, 0), (50, 100)), ((150, 0), (150, 100)))
    line = dieline((LineType.CUT, BLANK), (LineType.CUT, across))
    inner, outer = plan(line, ROUTED, BOARD)
    assert (inner.side, len(inner.paths)) == (0, 2)
    assert (outer.side, outer.paths.closed.tolist()) == (1, [True])
    assert area(outer.paths) == pytest.approx(-20000.0)


def test_a_contour_that_separates_two_parts_is_cut_on_its_line() -> None:
    # A square in a blank whose corners touch cuts from the outline: parts on both its sides.
    inner = closed((50, 50), (150, 50), (150, 80), (50, 80))
    tie = edges(((0, 50), (50, 50)), ((150, 50), (200, 50)))
    parts = dieline((LineType.CUT, BLANK), (LineType.CUT, inner), (LineType.CUT, tie))
    sides = {one.side: set(one.source.tolist()) for one in plan(parts, ROUTED, BOARD)}
    assert sides == {0: {4, 5, 6, 7, 8, 9}, 1: {0, 1, 2, 3}}


def test_an_outline_that_goes_on_in_the_line_of_a_shared_edge_is_refused() -> None:
    # A pocket hangs on the middle of the lower side of the blank.
    pocket = edges(((50, 0), (50, -40)), ((50, -40), (150, -40)), ((150, -40), (150, 0)))
    with pytest.raises(PlanError, match="share edge 0"):
        plan(dieline((LineType.CUT, BLANK), (LineType.CUT, pocket)), ROUTED, BOARD)


def test_one_gap_between_two_blanks_is_enough() -> None:
    apart = dieline(
        (LineType.CUT, closed((0, 0), (97, 0), (97, 100), (0, 100))),
        (LineType.CUT, closed((103, 0), (200, 0), (200, 100), (103, 100))),
    )
    (operation,) = plan(apart, ROUTED, BOARD)
    assert (len(operation.paths), operation.side) == (2, 1)


@pytest.mark.parametrize(
    "other",
    [
        closed((150, 20), (250, 20), (250, 60), (150, 60)),
        closed((20, 20), (70, 70), (70, 20), (20, 45)),
    ],
    ids=["another contour", "itself"],
)
def test_contours_that_cross_between_their_vertices_are_refused(other: F64) -> None:
    line = dieline((LineType.CUT, BLANK), (LineType.CUT, other))
    with pytest.raises(PlanError, match=r"crosses another contour or itself at X") as refused:
        plan(line, ROUTED, BOARD)
    x, y = (refused.value.message.arguments[axis] for axis in "xy")
    crossings = [(200.0, 20.0), (200.0, 60.0), (110.0 / 3.0, 110.0 / 3.0)]
    assert any((x, y) == pytest.approx(crossing) for crossing in crossings)


def test_contours_that_touch_and_slits_that_cross_are_milled() -> None:
    # Two arcs touch at their apexes, with an overlap by rounding.
    left = dieline((LineType.CUT, closed((0, 0), (100, 0), (100, 100), (0, 100))))
    right = dieline((LineType.CUT, closed((300, 0), (200, 0), (200, 100), (300, 100))))
    ends = np.concatenate([left.ends, right.ends])
    bulge = np.zeros(8)
    for edge, way in ((1, 1.0), (5, -1.0)):
        bulge[edge] = way
    for overlap in (0.0, 0.0005):
        moved = ends.copy()
        moved[4:, :, 0] -= overlap
        line = replace(dieline((LineType.CUT, moved)), bulge=bulge)
        assert sum(len(one.paths) for one in plan(line, ROUTED, BOARD)) == 2
    slits = edges(((50, 50), (150, 50)), ((100, 20), (100, 80)), ((190, 40), (210, 60)))
    crossed = dieline((LineType.CUT, BLANK), (LineType.CUT, slits))
    assert {one.side for one in plan(crossed, ROUTED, BOARD)} == {0, 1}


def test_a_slit_from_the_outline_is_no_shared_edge() -> None:
    line = dieline((LineType.CUT, BLANK), (LineType.CUT, edges(((200, 50), (150, 50)))))
    # First the outline has no vertex at the start of the slit, then it has one.
    assert [one.side for one in plan(line, ROUTED, BOARD)] == [0, 1]
    broken = closed((0, 0), (200, 0), (200, 50), (200, 100), (0, 100))
    line = dieline((LineType.CUT, broken), (LineType.CUT, edges(((200, 50), (150, 50)))))
    assert [one.side for one in plan(line, ROUTED, BOARD)] == [0, 1]


def test_a_contour_with_gaps_within_the_tolerance_is_closed_exactly() -> None:
    loose = BLANK.copy()
    loose[1, 0] += [0.0008, -0.0009]
    loose[3, 1] += [0.0005, 0.0005]
    (operation,) = plan(dieline((LineType.CUT, loose)), ROUTED, BOARD)
    assert bool(operation.paths.closed.all())
    np.testing.assert_array_equal(operation.paths.end, np.roll(operation.paths.start, -1, axis=0))


def test_passes_are_even_and_none_is_deeper_than_the_step() -> None:
    stepping = replace(HELD, tool=replace(ROUTER, step=1.0))
    (operation,) = plan(
        dieline((LineType.CUT, BLANK)), replace(ROUTED, stations=(stepping,)), BOARD
    )
    # 2.0 of board and 0.3 into the mat.
    np.testing.assert_allclose(operation.depth[0], [2.3 / 3, 4.6 / 3, 2.3])
    (operation,) = plan(dieline((LineType.CUT, BLANK)), ROUTED, BOARD)
    np.testing.assert_allclose(operation.depth[0], [2.3])


def test_the_operation_has_the_acceleration_and_the_deflection() -> None:
    measured = replace(
        BOARD, deflection=(Deflection("Other", 9, 9), Deflection("Router", 0.1, 0.2))
    )
    (operation,) = plan(dieline((LineType.CUT, BLANK)), ROUTED, measured)
    assert operation.deflection == (0.1, 0.2)
    assert (operation.acceleration, operation.corner) == (8000.0, "auto")
    (operation,) = plan(dieline((LineType.CUT, BLANK)), ROUTED, BOARD)
    assert operation.deflection == (0.0, 0.0)


def test_a_knife_is_preferred_to_a_cutter() -> None:
    both = replace(MACHINE, stations=(HELD, *MACHINE.stations))
    (operation,) = plan(dieline((LineType.CUT, BLANK)), both, BOARD)
    assert operation.station == 1


def test_a_cutter_makes_only_cuts() -> None:
    assert not lacks_tool(ROUTED, LineType.CUT)
    for kind in (LineType.PERFORATION, LineType.HALF_CUT, LineType.COMBI):
        assert lacks_tool(ROUTED, kind)
    with pytest.raises(NoToolForLineType, match="half-cut"):
        plan(dieline((LineType.HALF_CUT, edges(((0, 0), (50, 0))))), ROUTED, BOARD)


def test_a_cutter_leaves_bridges_on_blanks_and_none_on_holes() -> None:
    held = replace(BOARD, bridge_width=0.8, bridge_spacing=150.0)
    hole, blank = plan(dieline((LineType.CUT, BLANK), (LineType.CUT, HOLE)), ROUTED, held)
    assert (len(hole.bridges), len(blank.bridges), blank.bridges[0, 2]) == (0, 4, 0.8)
    segment, along = blank.bridges[:, 0].astype(int), blank.bridges[:, 1]
    length = np.hypot(*(blank.paths.end - blank.paths.start).T)[segment]
    # The disc of 3 mm stops 3.4 mm before the middle, and keeps 5 mm off the corner.
    assert np.minimum(along, length - along).min() >= 5.0 + 3.4
    assert plan(dieline((LineType.CUT, BLANK)), ROUTED, BOARD)[0].bridges.shape == (0, 3)


def test_there_is_no_bridge_where_the_disc_does_not_reach() -> None:
    # In a corner of 30° a disc of radius 3 mm stays 3 / tan 15° = 11.2 mm away from the vertex.
    deep = 30.0 / np.tan(np.radians(15.0))
    notched = closed(
        (0, 0), (200, 0), (200, 150), (130, 150), (100, 150 - deep), (70, 150), (0, 150)
    )
    for spacing in np.linspace(60.0, 200.0, 15):
        held = replace(BOARD, bridge_width=0.8, bridge_spacing=float(spacing))
        (blank,) = plan(dieline((LineType.CUT, notched)), ROUTED, held)
        segment, along = blank.bridges[:, 0].astype(int), blank.bridges[:, 1]
        ahead = blank.paths.end[segment] - blank.paths.start[segment]
        place = blank.paths.start[segment] + along[:, None] * ahead / np.hypot(*ahead.T)[:, None]
        assert np.hypot(*(place - [100, 150 - deep]).T).min() >= 11.19 + 3.4


@pytest.mark.parametrize(("slot", "inside"), [(8.0, False), (11.9, False), (12.1, True)])
def test_a_slot_holds_bridges_only_where_two_discs_pass_each_other(
    slot: float, inside: bool
) -> None:
    left, right = 100.0 - slot / 2.0, 100.0 + slot / 2.0
    slotted = closed(
        (0, 0), (200, 0), (200, 150), (right, 150), (right, 70), (left, 70), (left, 150), (0, 150)
    )
    held = replace(BOARD, bridge_width=0.8, bridge_spacing=60.0 if inside else 250.0)
    (blank,) = plan(dieline((LineType.CUT, slotted)), ROUTED, held)
    segment, along = blank.bridges[:, 0].astype(int), blank.bridges[:, 1]
    ahead = blank.paths.end[segment] - blank.paths.start[segment]
    place = blank.paths.start[segment] + along[:, None] * ahead / np.hypot(*ahead.T)[:, None]
    in_slot = (np.abs(place[:, 0] - 100.0) <= slot) & (place[:, 1] < 149.0) & (place[:, 1] > 1.0)
    assert in_slot.any() == inside


def test_where_only_slots_are_left_for_bridges_the_job_is_refused_with_a_hint() -> None:
    slotted = closed(
        (0, 0), (200, 0), (200, 150), (104, 150), (104, 20), (96, 20), (96, 150), (0, 150)
    )
    held = replace(BOARD, bridge_width=0.8, bridge_spacing=120.0)
    with pytest.raises(NoRoomForBridges, match="narrow slots") as caught:
        plan(dieline((LineType.CUT, slotted)), ROUTED, held)
    assert "a larger spacing" in caught.value.hint


@pytest.mark.parametrize(("spacing", "enough"), [(60.0, True), (200.0, False)])
def test_each_part_of_a_blank_that_a_cut_divides_is_held(spacing: float, enough: bool) -> None:
    across = edges(((170, 0), (170, 100)))
    line = dieline((LineType.CUT, BLANK), (LineType.CUT, across))
    board = replace(BOARD, bridge_width=0.8, bridge_spacing=spacing)
    if enough:
        assert len(plan(line, ROUTED, board)[-1].bridges) >= 10
    else:
        with pytest.raises(NoRoomForBridges, match="cuts divide its blank"):
            plan(line, ROUTED, board)
