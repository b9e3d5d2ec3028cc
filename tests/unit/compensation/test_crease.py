"""The crease engine: setback at free ends, presses for short creases."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.compensation.crease import crease_toolpath, depth_at_contact, half_contact_length
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.operation import End, Operation
from knifetip.model.toolpath import Motion
from knifetip.planning.plan import plan
from tests.support.shapes import BOARD, MACHINE, WHEEL, dieline, edges

ALONG = edges(((0, 0), (0, 100)))


def planned(ends: F64, bulge: dict[int, float] | None = None, board: Board = BOARD) -> Operation:
    return plan(dieline((LineType.CREASE, ends), bulge=bulge), MACHINE, board)[0]


def test_the_wheel_touches_3_44_mm_at_radius_15_and_depth_0_4() -> None:
    # √(0.4 · 29.6) = √11.84
    assert half_contact_length(np.array([0.4]), WHEEL)[0] == pytest.approx(3.44093)


def test_depth_at_contact_inverts_half_contact_length() -> None:
    depth = np.array([0.05, 0.4, 1.2])
    np.testing.assert_allclose(depth_at_contact(half_contact_length(depth, WHEEL), WHEEL), depth)


def test_a_crease_is_set_back_at_both_free_ends() -> None:
    path = crease_toolpath(planned(ALONG))
    fed = np.flatnonzero(path.motion == Motion.FEED)
    back = np.sqrt(11.84) + 0.2
    np.testing.assert_allclose(path.pose[fed[0]], [0, back, 1.6, 90])
    np.testing.assert_allclose(path.pose[fed[0] + 1], [0, 100 - back, 1.6, 90])


def test_a_continued_end_is_not_set_back() -> None:
    operation = replace(planned(ALONG), start=np.array([End.CONTINUED]))
    path = crease_toolpath(operation)
    np.testing.assert_allclose(path.pose[1, :2], [0, 0])


def test_a_short_crease_is_pressed_in_its_middle_at_a_smaller_depth() -> None:
    path = crease_toolpath(planned(edges(((0, 0), (0, 4.4)))))
    # Half of 4.4 less 0.2 is 2.0; 15 - √(225 - 4) = 0.13393.
    assert path.motion.tolist() == [Motion.PLUNGE, Motion.LIFT]
    np.testing.assert_allclose(path.pose[1], [0, 2.2, 2 - 0.1339308, 90], atol=1e-6)
    assert path.source.tolist() == [0, 0]


def test_a_short_crease_with_a_continued_end_is_pressed_at_that_end() -> None:
    operation = replace(planned(edges(((0, 0), (0, 2.2)))), start=np.array([End.CONTINUED]))
    path = crease_toolpath(operation)
    np.testing.assert_allclose(path.pose[1], [0, 0, 2 - 0.1339308, 90], atol=1e-6)


def test_a_board_may_refuse_short_creases() -> None:
    creases = edges(((0, 0), (0, 4.4)), ((10, 0), (10, 50)))
    path = crease_toolpath(planned(creases, board=replace(BOARD, short_crease="refuse")))
    assert set(path.source.tolist()) == {1}


def test_a_crease_shorter_than_its_clearances_is_not_made() -> None:
    assert len(crease_toolpath(planned(edges(((0, 0), (0, 0.4)))))) == 0


@pytest.mark.parametrize(("length", "is_pressed"), [(1.4, False), (1.6, True)])
def test_a_wheel_is_pressed_by_at_least_a_hundredth(length: float, is_pressed: bool) -> None:
    # 0.01 mm deep, the wheel touches 2 √(0.01 · 29.99) = 1.095 mm, and 0.4 mm remain free.
    path = crease_toolpath(planned(edges(((0, 0), (0, length)))))
    assert bool(len(path)) is is_pressed


def test_the_wheel_turns_with_an_arc() -> None:
    # A quarter turn to the left of radius 100, from due east to due north.
    operation = planned(edges(((0, 0), (100, 100))), bulge={0: np.tan(np.pi / 8)})
    path = crease_toolpath(operation)
    # The crease is 0.6 deep where it begins across the grain, and 0.4 where it ends along it.
    begin, finish = np.degrees((np.sqrt([0.6 * 29.4, 0.4 * 29.6]) + 0.2) / 100)
    np.testing.assert_allclose(path.pose[[1, -2], 3], [begin, 90 - finish])
    turn = np.degrees(arc.sweep(path.bulge))
    np.testing.assert_allclose(np.diff(path.pose[:, 3]), turn, atol=1e-9)


def test_long_and_short_creases_keep_their_drawing_order() -> None:
    path = crease_toolpath(planned(edges(((0, 0), (0, 4)), ((9, 0), (9, 99)), ((20, 0), (20, 4)))))
    assert path.source[path.motion == Motion.LIFT].tolist() == [0, 1, 2]
    assert path.track[path.motion == Motion.LIFT].tolist() == [0, 1, 2]


def test_a_wheel_turns_at_the_smaller_depth_where_a_crease_bends_by_less_than_a_degree() -> None:
    # One half is 0.573° off the grain and deeper by 0.2 sin² of that angle.
    step = 0.2 * (0.5 / 50.0025) ** 2
    deeper = crease_toolpath(planned(edges(((0, 0), (0, 50)), ((0, 50), (0.5, 100)))))
    assert deeper.motion.tolist() == [
        Motion.PLUNGE, Motion.FEED, Motion.SWIVEL, Motion.PLUNGE, Motion.FEED, Motion.LIFT,
    ]  # fmt: skip
    assert np.diff(deeper.pose[2:5, 2]) == pytest.approx([0.0, -step], rel=1e-6)
    assert np.diff(deeper.pose[2:5, 3]) == pytest.approx([-0.57294, 0.0], abs=1e-5)
    shallower = crease_toolpath(planned(edges(((0.5, 100), (0, 50)), ((0, 50), (0, 0)))))
    assert shallower.motion.tolist() == [
        Motion.PLUNGE, Motion.FEED, Motion.PLUNGE, Motion.SWIVEL, Motion.FEED, Motion.LIFT,
    ]  # fmt: skip
    assert np.diff(shallower.pose[2:5, 2]) == pytest.approx([step, 0.0], rel=1e-6)
    assert np.diff(shallower.pose[2:5, 3]) == pytest.approx([0.0, 0.57294], abs=1e-5)
