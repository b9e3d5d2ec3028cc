"""The knife engine: ends, corners, closed contours, and the drag knife."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip.compensation.knife import knife_toolpath
from knifetip.errors import EdgeTooShort
from knifetip.geometry.columns import F64
from knifetip.model.dieline import LineType
from knifetip.model.operation import End, Operation
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.planning.plan import plan
from tests.support.shapes import BOARD, KNIFE, MACHINE, closed, dieline, edges

QUARTER = np.tan(np.pi / 8)


def planned(
    ends: F64, bulge: dict[int, float] | None = None, kind: LineType = LineType.CUT
) -> Operation:
    return plan(dieline((kind, ends), bulge=bulge), MACHINE, BOARD)[-1]


def test_a_cut_that_ends_inside_a_panel_stops_earlier_by_the_lead() -> None:
    # 45° over 2.3 mm: the top face is cut 2.3 mm ahead of the tip.
    path = knife_toolpath(planned(edges(((0, 0), (50, 0)))))
    np.testing.assert_allclose(path.pose[1], [0, 0, -0.3, 0])
    np.testing.assert_allclose(path.pose[2], [47.7, 0, -0.3, 0])


def test_an_end_that_meets_another_cut_is_extended() -> None:
    operation = replace(planned(edges(((0, 0), (50, 0)))), finish=np.array([End.MEETS]))
    path = knife_toolpath(operation)
    # The bottom face ends 2.0 tan 45° behind the top.
    np.testing.assert_allclose(path.pose[-2, :2], [52.0, 0.0])


def test_the_tip_stops_on_a_slit_with_a_panel_behind_it() -> None:
    operation = replace(planned(edges(((0, 0), (50, 0)))), finish=np.array([End.JUNCTION]))
    path = knife_toolpath(operation)
    np.testing.assert_allclose(path.pose[1, :2], [0.0, 0.0])
    np.testing.assert_allclose(path.pose[-2, :2], [50.0, 0.0])


def test_a_contour_shorter_than_the_overrun_is_cut_twice() -> None:
    """A circle of 1 mm diameter is 3.1 mm long; a blade of 60° runs on by 2.0 tan 60° = 3.5 mm."""
    operation = planned(closed((0, 0), (1, 0)), {0: 1.0, 1: 1.0})
    operation = replace(operation, tool=replace(KNIFE, blade_angle=60.0))
    path = knife_toolpath(operation)
    fed = path.motion == Motion.FEED
    assert path.source[fed].tolist() == [0, 1, 0, 0, 1, 0]
    assert path.pose[-2, 3] - path.pose[1, 3] == pytest.approx(720.0)
    np.testing.assert_allclose(path.pose[-2, :2], path.pose[1, :2], atol=1e-12)


def test_a_contour_without_a_sharp_corner_runs_past_its_start() -> None:
    # A line of 100 mm, a half circle, a line back and a half circle.
    outline = closed((0, 0), (100, 0), (100, 50), (0, 50))
    path = knife_toolpath(planned(outline, {1: 1.0, 3: 1.0}))
    np.testing.assert_allclose(path.pose[1, :2], [50, 0])
    np.testing.assert_allclose(path.pose[-2, :2], [52, 0])
    fed = path.motion == Motion.FEED
    assert path.source[fed].tolist() == [0, 1, 2, 3, 0, 0]
    assert (path.motion == Motion.PLUNGE).sum() == 1


def test_a_contour_with_sharp_corners_starts_and_ends_at_one_of_them() -> None:
    operation = planned(closed((0, 0), (100, 0), (100, 50), (0, 50)))
    for begin in range(4):
        path = knife_toolpath(replace(operation, begin=np.array([begin])))
        corner = operation.paths.start[begin]
        np.testing.assert_array_equal(path.pose[1, :2], corner)
        np.testing.assert_array_equal(path.pose[-2, :2], corner)
        fed = path.motion == Motion.FEED
        assert path.source[fed].tolist() == np.roll(operation.source, -begin).tolist()
        assert (path.motion == Motion.PLUNGE).sum() == 4


def test_a_half_cut_is_shallow_and_ends_early_by_its_own_depth() -> None:
    path = knife_toolpath(planned(edges(((0, 0), (50, 0))), kind=LineType.HALF_CUT))
    np.testing.assert_allclose(path.pose[2, :3], [49.2, 0, 1.2])


def test_the_blade_turns_above_the_board_at_sharp_corners_only() -> None:
    sharp = knife_toolpath(planned(edges(((0, 0), (50, 0)), ((50, 0), (50, 50)))))
    assert sharp.motion.tolist() == [
        Motion.PLUNGE, Motion.FEED, Motion.LIFT, Motion.RAPID, Motion.PLUNGE, Motion.FEED,
        Motion.LIFT,
    ]  # fmt: skip
    np.testing.assert_allclose(sharp.pose[3:5, 2], 4.0)
    np.testing.assert_allclose(sharp.pose[3:5, 3], [0.0, 90.0])
    gentle = knife_toolpath(planned(edges(((0, 0), (50, 0)), ((50, 0), (100, 10)))))
    assert gentle.motion.tolist() == [
        Motion.PLUNGE, Motion.FEED, Motion.SWIVEL, Motion.FEED, Motion.LIFT,
    ]  # fmt: skip


def test_c_follows_an_arc_without_a_jump() -> None:
    # A corner of radius 10: a line due east, the arc, a line due north.
    ends = edges(((0, 0), (50, 0)), ((50, 0), (60, 10)), ((60, 10), (60, 50)))
    path = knife_toolpath(planned(ends, bulge={1: QUARTER}))
    np.testing.assert_allclose(path.pose[:, 3], [0, 0, 0, 90, 90, 90])
    assert path.bulge[2] == QUARTER


def test_c_has_no_jump_around_a_circle() -> None:
    path = knife_toolpath(
        planned(edges(((0, 0), (20, 0)), ((20, 0), (0, 0))), bulge={0: 1.0, 1: 1.0})
    )
    fed = np.flatnonzero(path.motion == Motion.FEED)
    turned = path.pose[fed[-1] + 1, 3] - path.pose[fed[0], 3]
    # One full turn, and past the start by 2 mm at radius 10.
    assert turned == pytest.approx(360 + np.degrees(2.0 / 10.0))


def test_a_cut_shorter_than_the_lead_is_left_out() -> None:
    assert len(knife_toolpath(planned(edges(((0, 0), (2.2, 0)))))) == 0
    path = knife_toolpath(planned(edges(((0, 0), (2.2, 0)), ((0, 5), (20, 5)))))
    assert set(path.source.tolist()) == {1}


def test_a_cut_shorter_than_the_lead_that_ends_at_a_bridge_is_refused() -> None:
    operation = planned(edges(((0, 0), (2.2, 0))))
    bridged = replace(operation, finish=np.array([End.BRIDGE], np.uint8))
    with pytest.raises(EdgeTooShort, match=r"2\.30 mm"):
        knife_toolpath(bridged)


def test_a_dash_of_a_perforation_shorter_than_the_lead_is_refused() -> None:
    with pytest.raises(EdgeTooShort, match=r"2\.30 mm"):
        knife_toolpath(planned(edges(((0, 0), (2.2, 0))), kind=LineType.PERFORATION))


def led(ends: F64, **leads: Any) -> Toolpath:
    blade = replace(KNIFE, **leads)
    machine = replace(MACHINE, stations=(replace(MACHINE.stations[0], tool=blade),))
    return knife_toolpath(plan(dieline((LineType.CUT, ends)), machine, BOARD)[-1])


@pytest.mark.parametrize("backwards", [False, True])
def test_a_knife_enters_and_leaves_an_outline_on_a_quarter_circle(backwards: bool) -> None:
    outline = closed((0, 0), (100, 0), (90, 50), (10, 50))
    path = led(outline[:, ::-1] if backwards else outline, lead_in=np.pi, lead_out=np.pi)
    assert path.motion[1] == Motion.LEAD_IN
    assert path.motion[-2] == Motion.LEAD_OUT
    # Clockwise, so that the waste is on the left: due west along the edge y = 0, begun at (50, 0).
    # A quarter circle of length π mm has a radius of 2 mm; it starts at (52, -2), due north.
    np.testing.assert_allclose(path.pose[1, :2], [52, -2], atol=1e-9)
    np.testing.assert_allclose(path.pose[2, :2], [50, 0], atol=1e-9)
    np.testing.assert_allclose(path.pose[1:3, 3] % 360, [90, 180], atol=1e-9)
    # Past its start by 2 mm, then into the waste, due south.
    np.testing.assert_allclose(path.pose[-3, :2], [48, 0], atol=1e-9)
    np.testing.assert_allclose(path.pose[-2, :2], [46, -2], atol=1e-9)
    assert path.pose[-2, 3] % 360 == pytest.approx(270)


def test_holes_and_slits_have_no_leads() -> None:
    hole = closed((20, 20), (40, 20), (40, 40), (20, 40))
    blade = replace(KNIFE, lead_in=3.0, lead_out=3.0)
    machine = replace(MACHINE, stations=(replace(MACHINE.stations[0], tool=blade),))
    outline = closed((0, 0), (100, 0), (100, 50), (0, 50))
    inner, outer = plan(dieline((LineType.CUT, outline), (LineType.CUT, hole)), machine, BOARD)
    assert Motion.LEAD_IN not in knife_toolpath(inner).motion
    assert Motion.LEAD_IN in knife_toolpath(outer).motion


def test_a_drag_knife_trails_its_head_and_swings_around_its_tip() -> None:
    drag = replace(KNIFE, blade_angle=0.0, trail=2.0)
    ends = edges(((0, 0), (50, 0)), ((50, 0), (50 + 40, 10)))
    operation = replace(planned(ends), tool=drag)
    path = knife_toolpath(operation)
    assert path.motion.tolist() == [
        Motion.PLUNGE, Motion.FEED, Motion.SWIVEL, Motion.FEED, Motion.LIFT,
    ]  # fmt: skip
    ahead = np.column_stack(
        [np.cos(np.radians(path.pose[:, 3])), np.sin(np.radians(path.pose[:, 3]))]
    )
    tip = path.pose[:, :2] - 2.0 * ahead
    np.testing.assert_allclose(tip[1:5], [[0, 0], [50, 0], [50, 0], [90, 10]], atol=1e-12)
    # The head swings about the tip, radius 2, by the angle of the corner.
    assert 4 * np.arctan(path.bulge[2]) == pytest.approx(np.arctan2(10, 40))
