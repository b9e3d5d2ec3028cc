"""The V-groove engine: points 1 to 4, plunge and lift, and refusals."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip.compensation.vgroove import groove_section, head_offset, vgroove_toolpath
from knifetip.errors import CurvedGroove, EdgeTooShort, GrooveTooDeep
from knifetip.geometry.columns import F64
from knifetip.model.dieline import LineType
from knifetip.model.operation import End
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.planning.plan import plan
from tests.support.shapes import BOARD, CUTTER, MACHINE, dieline, edges

EAST = edges(((0, 0), (100, 0)))


def grooved(ends: F64, **changes: Any) -> Toolpath:
    operation = plan(dieline((LineType.V_GROOVE, ends)), MACHINE, BOARD)[0]
    return vgroove_toolpath(replace(operation, **changes))


def test_offset_due_east_is_right_and_ahead() -> None:
    # The example of the docstring: d 4 to the right of travel (south), r 1.5 ahead (east).
    offset = head_offset(np.array([[0.0, 0.0]]), np.array([[100.0, 0.0]]), CUTTER)
    np.testing.assert_array_equal(offset, [[1.5, -4.0]])


def test_the_four_points_of_the_paper() -> None:
    # A (0, 0), B (100, 0), Δ (1.5, -4): 1 = A + Δ, 2 = B + Δ, 3 = B - Δ, 4 = A - Δ.
    path = grooved(EAST)
    fed = np.flatnonzero(path.motion == Motion.FEED)
    np.testing.assert_allclose(path.pose[fed[0], :2], [1.5, -4.0])
    np.testing.assert_allclose(path.pose[fed[0] + 1, :2], [101.5, -4.0])
    np.testing.assert_allclose(path.pose[fed[1], :2], [98.5, 4.0])
    np.testing.assert_allclose(path.pose[fed[1] + 1, :2], [-1.5, 4.0])
    np.testing.assert_allclose(path.pose[fed, 3], [0.0, 180.0])
    # The board is 2 thick and the groove 1 deep.
    np.testing.assert_allclose(path.pose[fed, 2], 1.0)


def test_the_blade_plunges_and_lifts_along_its_tilt() -> None:
    path = grooved(EAST)
    down = np.flatnonzero(path.motion == Motion.PLUNGE)[0]
    way = path.pose[down + 1] - path.pose[down]
    # From 2 above the board to 1 below its face is 3 down; the tilt is 45°, so also 3 to the left.
    np.testing.assert_allclose(way, [0.0, 3.0, -3.0, 0.0], atol=1e-12)
    up = np.flatnonzero(path.motion == Motion.LIFT)[0]
    np.testing.assert_allclose(path.pose[up + 1] - path.pose[up], [0, -3, 3, 0], atol=1e-12)


def test_the_turn_between_the_passes_is_made_above_the_board() -> None:
    path = grooved(EAST)
    turn = np.flatnonzero(path.motion == Motion.RAPID)
    assert len(turn) == 1
    np.testing.assert_allclose(path.pose[turn[0] : turn[0] + 2, 2], 4.0)


def test_deeper_passes_follow_each_other() -> None:
    path = grooved(EAST, depth=np.array([[0.5, 1.0]]))
    fed = np.flatnonzero(path.motion == Motion.FEED)
    np.testing.assert_allclose(path.pose[fed, 2], [1.5, 1.5, 1.0, 1.0])
    np.testing.assert_allclose(path.pose[fed, 3], [0.0, 180.0, 0.0, 180.0])


def test_a_groove_is_extended_by_the_run_out_of_the_operation() -> None:
    path = grooved(EAST, run_out=np.array([[1.0, 2.5]]), start=[End.MEETS], finish=[End.MEETS])
    fed = np.flatnonzero(path.motion == Motion.FEED)
    # The tip goes from -1 to 102.5 and back; Δ = (1.5, -4).
    np.testing.assert_allclose(path.pose[fed, :2], [[0.5, -4.0], [101.0, 4.0]])
    np.testing.assert_allclose(path.pose[fed + 1, :2], [[104.0, -4.0], [-2.5, 4.0]])


def test_only_ends_inside_the_board_are_checked_for_overcut() -> None:
    assert len(grooved(EAST, overcut=2.9, start=[End.MEETS], finish=[End.MEETS]))
    with pytest.raises(GrooveTooDeep, match="inside the board"):
        grooved(EAST, overcut=2.9, start=[End.MEETS], finish=[End.FREE])


def test_a_groove_of_two_edges_around_due_east_keeps_its_heading() -> None:
    # 0.001° below and above the x axis: azimuths 359.999 and 0.001.
    rise = 50 * np.tan(np.radians(0.001))
    path = grooved(edges(((0, rise), (50, 0)), ((50, 0), (100, rise))))
    fed = np.flatnonzero(path.motion == Motion.FEED)
    np.testing.assert_allclose(path.pose[fed, 3], [359.999, 360.001, 540.001, 539.999], atol=1e-6)


def test_the_section_of_a_groove_has_its_angle_width_and_web() -> None:
    # 1.3 deep in 2.0 at 30°: 2 · 1.3 · tan 30° = 1.5011 wide.
    cut = groove_section(1.3, 2.0, replace(CUTTER, tilt=30.0))
    assert (cut.included, cut.web) == (60.0, 0.7)
    assert cut.width == pytest.approx(1.50111, abs=1e-5)


def test_a_groove_of_two_edges_is_cut_without_lifting() -> None:
    path = grooved(edges(((0, 0), (40, 0)), ((40, 0), (100, 0))))
    fed = path.motion == Motion.FEED
    assert path.source[fed].tolist() == [0, 1, 1, 0]
    assert (path.motion == Motion.PLUNGE).sum() == 2


def test_an_arc_is_refused() -> None:
    line = dieline((LineType.V_GROOVE, EAST), bulge={0: 0.1})
    with pytest.raises(CurvedGroove, match="1 V-groove is an arc"):
        vgroove_toolpath(plan(line, MACHINE, BOARD)[0])


def test_a_groove_shorter_than_the_blade_is_left_out() -> None:
    assert len(grooved(edges(((0, 0), (2.9, 0))))) == 0
    path = grooved(edges(((0, 0), (2.9, 0)), ((0, 5), (20, 5))))
    assert set(path.source[path.motion == Motion.FEED].tolist()) == {1}


def test_grooves_that_are_together_shorter_than_the_blade_are_refused() -> None:
    with pytest.raises(EdgeTooShort, match=r"2\.90 mm long, but the blade is 3\.00 mm"):
        grooved(edges(((0, 0), (1.5, 0)), ((1.5, 0), (2.9, 0))))


def test_a_groove_through_the_board_is_refused() -> None:
    with pytest.raises(GrooveTooDeep, match=r"2\.00 mm deep"):
        grooved(EAST, depth=np.array([[2.0]]))


def test_a_blade_that_overruns_the_ends_by_more_than_allowed_is_refused() -> None:
    with pytest.raises(GrooveTooDeep, match=r"cuts 3\.00 mm too far at each end"):
        grooved(EAST, overcut=2.9)
