"""The turning paper: its sections and equations, with examples computed by hand.

"A new method of turning processing in multi axis linkage NC machining": 1 the end of a track,
2 the turn, 3 interference and its correction (eqs 1 and 2).
"""

from __future__ import annotations

from math import acos, cos, degrees, radians, sin, sqrt, tan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.compensation.vgroove import sideways_move
from knifetip.errors import CompensationError
from knifetip.geometry.run_out import corner_run_outs
from knifetip.model.tool import TipCircle, VCutter
from knifetip.sequencing.air_moves import (
    interference,
    interpolate_turn,
    lift_clear,
    tool_axis,
)
from tests.support.examples import examples


def test_1_a_track_square_to_the_edge_needs_no_more_way() -> None:
    # Both corners of the tool cross the edge at the same time.
    assert (
        corner_run_outs(np.array([[1.0, 0.0]]), np.array([[1.0, 0.0]]), np.array([6.0])).max()
        == 0.0
    )


def test_1_at_45_degrees_the_later_corner_is_half_the_width_behind() -> None:
    # W = 6, n · m = sin 45°, u · m = cos 45°: 3 mm.
    u = np.array([[sqrt(0.5), sqrt(0.5)]])
    assert corner_run_outs(u, np.array([[1.0, 0.0]]), np.array([6.0])).max() == pytest.approx(3.0)


def test_1_at_60_degrees_from_square_it_is_tan_60_times_half_the_width() -> None:
    u = np.array([[0.5, -sqrt(0.75)]])
    assert corner_run_outs(u, np.array([[1.0, 0.0]]), np.array([2.0])).max() == pytest.approx(
        1.7320508
    )


def test_1_along_the_edge_there_is_no_answer() -> None:
    with pytest.raises(CompensationError, match=r"deviates by 90\.00° from the perpendicular"):
        corner_run_outs(np.array([[0.0, 1.0]]), np.array([[1.0, 0.0]]), np.array([6.0]))


@examples(500)
@given(st.floats(-85.0, 85.0), st.floats(0.0, 360.0), st.floats(0.1, 20.0))
def test_1_then_both_corners_are_out_and_a_little_earlier_one_is_not(
    off: float, edge: float, width: float
) -> None:
    m = np.array([cos(radians(edge)), sin(radians(edge))])
    u = np.array([cos(radians(edge + off)), sin(radians(edge + off))])
    n = np.array([-u[1], u[0]])
    extra = corner_run_outs(u[None], m[None], np.array([width])).max()
    # The edge runs through the origin, where the middle of the tool crosses it.
    corners = [(extra * u + side * width / 2.0 * n) @ m for side in (-1, 1)]
    assert min(corners) == pytest.approx(0.0, abs=1e-9)
    assert max(corners) == pytest.approx(width * abs(sin(radians(off))), abs=1e-9)


def test_2_centres_go_straight_and_the_axis_turns_in_as_many_steps() -> None:
    # ΔC 60 by 10 makes 6, 25 mm by 5 makes 5: N = 6, each 10° and 25/6 mm.
    poses = interpolate_turn(np.array([0.0, 0, 4, 30]), np.array([15.0, 20, 4, 90]), 10.0, 5.0)
    assert len(poses) == 7
    np.testing.assert_allclose(np.diff(poses, axis=0), [[2.5, 20 / 6, 0, 10]] * 6, atol=1e-12)


def test_2_where_the_way_is_longer_it_counts_the_steps() -> None:
    poses = interpolate_turn(np.zeros(4), np.array([30.0, 40.0, 0.0, 20.0]), 10.0, 5.0)
    assert len(poses) == 11


def test_3_interference_of_an_upright_tool_is_how_far_its_tip_is_below_the_face() -> None:
    pose = np.array([[0.0, 0.0, 1.2, 0.0], [0.0, 0.0, 2.5, 77.0]])
    depth = interference(pose, TipCircle(3.0, 0.0, 0.0), 2.0)
    np.testing.assert_allclose(depth, [0.8, 0.0])


def test_3_interference_of_a_leaning_tool_counts_the_lowest_point_of_its_circle() -> None:
    # Radius 1.5 leaning by 30°: 0.75 mm below its centre, which is 0.5 below the face.
    pose = np.array([[0.0, 0.0, 1.5, 0.0]])
    assert interference(pose, TipCircle(1.5, 6.0, 30.0), 2.0)[0] == pytest.approx(1.25)


def test_3_the_axis_leans_to_the_right_of_travel() -> None:
    # b = 30°: heading east it leans south by sin 30°, heading north east by as much.
    circle = TipCircle(1.0, 0.0, 30.0)
    expected = [[0.0, -0.5, sqrt(0.75)], [0.5, 0.0, sqrt(0.75)]]
    np.testing.assert_allclose(tool_axis(np.array([0.0, 90.0]), circle), expected, atol=1e-12)


def test_3_eq_1_the_lift_is_d_over_cos_b() -> None:
    # D = 1 at b = 60°: d' = 2, of which 1 is up and √3 aside.
    up = lift_clear(np.zeros((1, 4)), np.ones(1), TipCircle(1.0, 0.0, 60.0))
    assert np.linalg.norm(up[0, :3]) == pytest.approx(2.0)
    np.testing.assert_allclose(up[0], [0.0, -sqrt(3.0), 1.0, 0.0], atol=1e-12)
    normal = np.array([0.0, 0.0, 1.0])
    b = degrees(acos(normal @ up[0, :3] / np.linalg.norm(up[0, :3])))
    assert b == pytest.approx(60.0)


def test_3_eq_2_goes_out_of_the_board_and_keeps_the_axis() -> None:
    # The paper omits this sign; without it the tool would go deeper.
    pose = np.array([[10.0, 20.0, 1.0, 135.0]])
    up = lift_clear(pose, np.array([0.5]), TipCircle(1.5, 6.0, 45.0))
    assert up[0, 2] == pytest.approx(1.5)
    assert up[0, 3] == 135.0
    # Heading 135° the right hand is (√½, √½); 0.5 up is 0.5 tan 45° aside.
    np.testing.assert_allclose(up[0, :2] - pose[0, :2], [0.3535534, 0.3535534], atol=1e-7)


@given(st.floats(0.0, 360.0), st.floats(1.0, 60.0), st.floats(0.0, 5.0))
def test_3_lifting_a_v_cutter_along_itself_is_the_oblique_lift_of_the_samplemaker_paper(
    c: float, tilt: float, d: float
) -> None:
    cutter = VCutter(6.0, 1.5, tilt)
    pose = np.array([[0.0, 0.0, 0.0, c]])
    up = lift_clear(pose, np.array([d]), cutter.tip_circle(d))
    ahead = np.array([[cos(radians(c)), sin(radians(c))]])
    np.testing.assert_allclose(
        up[:, :2], sideways_move(np.zeros((1, 2)), ahead, cutter, np.array([d])), atol=1e-9
    )
    assert np.hypot(*up[0, :2]) == pytest.approx(d * tan(radians(tilt)), abs=1e-9)


def test_3_after_the_correction_nothing_interferes() -> None:
    circle = TipCircle(1.5, 6.0, 45.0)
    pose = np.array([[0.0, 0.0, z, 40.0] for z in (-1.0, 0.0, 1.0, 2.0, 3.0, 4.0)])
    up = lift_clear(pose, interference(pose, circle, 2.0), circle)
    np.testing.assert_allclose(interference(up, circle, 2.0), 0.0, atol=1e-12)
    # 1.5 sin 45° = 1.0607: the tip at 3.0 had 0.0607 to go, the one at 4.0 nothing.
    np.testing.assert_allclose(up[4:, 2], [3.0606602, 4.0])
