"""Turns: C takes the smaller angle, the tip circle clears the board, lifts are minimal."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.errors import CompensationError
from knifetip.geometry.columns import F64, Bool
from knifetip.geometry.path import Paths
from knifetip.model.tool import TipCircle
from knifetip.model.toolpath import Motion
from knifetip.sequencing.air_moves import (
    interference,
    interpolate_turn,
    lift_clear,
    turns_outside_board,
    unwind,
    with_full_retracts,
)
from tests.support.examples import examples
from tests.support.shapes import CUTTER, KNIFE, MACHINE, WHEEL, closed, rotation, toolpath


def outline(ends: F64, bulge: F64 | None = None) -> Paths:
    rows = len(ends)
    bulge = np.zeros(rows) if bulge is None else bulge
    return Paths(ends[:, 0], ends[:, 1], bulge, np.array([0, rows]))


#: 100 × 60 with its right side a half circle about (100, 30).
BOARD = outline(closed((0, 0), (100, 0), (100, 60), (0, 60)), np.array([0.0, 1.0, 0.0, 0.0]))
FACE = 2.0


def dots(pose: F64, circle: TipCircle, count: int = 48) -> F64:
    """Return points of the tip circle, from an orthogonal triad about the tilted axis."""
    c, b = math.radians(pose[3]), math.radians(circle.tilt)
    ahead = np.array([math.cos(c), math.sin(c), 0.0])
    right = np.array([math.sin(c), -math.cos(c), 0.0])
    up = np.array([0.0, 0.0, 1.0])
    across = right * math.cos(b) - up * math.sin(b)
    angle = np.linspace(0.0, 2.0 * math.pi, count, endpoint=False)[:, None]
    centre = pose[:3] - circle.aside * right
    found: F64 = centre + circle.radius * (np.cos(angle) * ahead + np.sin(angle) * across)
    return found


def over_board(xy: F64) -> Bool:
    """Return whether points are over BOARD: a rectangle and a half disc, (n,)."""
    x, y = xy.T
    inside = (x > 0) & (x < 100) & (y > 0) & (y < 60)
    over: Bool = inside | ((x >= 100) & (np.hypot(x - 100, y - 30) < 30))
    return over


def test_headings_take_the_nearest_equivalent_turn() -> None:
    start = np.array([350.0, 10.0, 350.0])
    shift = unwind(start, start, start, start, 0.0, -1080.0, 1080.0, 360.0)
    np.testing.assert_array_equal(start + shift, [-10.0, 10.0, -10.0])


def test_headings_come_back_before_the_limit() -> None:
    start, end = np.array([0.0, 0.0]), np.array([300.0, 300.0])
    shift = unwind(start, end, start, end, 0.0, -100.0, 400.0, 360.0)
    np.testing.assert_array_equal(shift, [0.0, 0.0])


@pytest.mark.parametrize(("here", "goes"), [(700.0, 520.0), (-700.0, -520.0)])
@pytest.mark.parametrize("off", [0.0, 1e-8, -1e-8])
def test_c_turns_away_from_its_limit_at_exactly_half_a_turn(
    here: float, goes: float, off: float
) -> None:
    start = np.array([160.0 if here > 0 else -160.0]) + off
    shift = unwind(start, start, start, start, here, -1080.0, 1080.0, 360.0)
    assert start[0] + shift[0] == pytest.approx(goes)


def test_a_wheel_is_the_same_after_half_a_turn() -> None:
    start = np.array([170.0])
    assert unwind(start, start, start, start, 0.0, -1080.0, 1080.0, 180.0)[0] == -180.0


def test_tip_circles_come_from_the_tools_drawings() -> None:
    assert CUTTER.tip_circle(1.0) == TipCircle(1.5, 4.0, 45.0)
    assert KNIFE.tip_circle(1.0) == TipCircle(3.0, 0.0, 0.0)
    # A wheel of 15 mm at 0.4 mm touches ± 3.4409 mm, and is 0.7 mm wide.
    assert WHEEL.tip_circle(0.4).radius == pytest.approx(math.hypot(3.4409, 0.35), abs=1e-4)


def test_the_board_ends_at_its_arcs() -> None:
    circle = TipCircle(1.0, 0.0, 0.0)
    # 28 mm from the arc's centre, at 45° 28 mm, 31.5 mm; a corner outside of the arc.
    xy = [(128, 30), (100 + 28 * 0.7071, 30 + 28 * 0.7071), (131.5, 30), (129, 59)]
    pose = np.array([(x, y, 1.25, 0.0) for x, y in xy])
    np.testing.assert_allclose(interference(pose, circle, FACE, BOARD), [0.75, 0.75, 0.0, 0.0])


def test_a_tool_beside_the_head_is_over_the_board_where_its_circle_is() -> None:
    # The head is 3 mm below the board; the middle of the circle is 6 mm to the left of the head.
    circle = TipCircle(1.5, 6.0, 0.0)
    pose = np.array([(50.0, -3.0, 1.0, 0.0), (50.0, -3.0, 1.0, 180.0), (-3.0, 30.0, 1.0, -90.0)])
    np.testing.assert_allclose(interference(pose, circle, FACE, BOARD), [1.0, 0.0, 1.0])


def test_a_point_on_the_chord_of_an_arc_is_on_the_board() -> None:
    # The chords of the four half circles around the square are its sides, in all directions.
    bulged = outline(closed((0, 0), (100, 0), (100, 100), (0, 100)), np.ones(4))
    on_chords = np.array([(50.0, 0.0), (100.0, 50.0), (50.0, 100.0), (0.0, 50.0)])
    pose = np.column_stack([on_chords, np.full(4, 1.0), np.zeros(4)])
    circle = TipCircle(5.0, 0.0, 0.0)
    np.testing.assert_allclose(interference(pose, circle, FACE, bulged), 1.0)
    back = Paths(bulged.end, bulged.start, -bulged.bulge, bulged.first)
    np.testing.assert_allclose(interference(pose, circle, FACE, back), 1.0)
    waisted = Paths(bulged.start, bulged.end, np.full(4, -0.5), bulged.first)
    np.testing.assert_allclose(interference(pose, circle, FACE, waisted), 0.0)


def test_a_tip_that_swings_over_the_board_is_detected() -> None:
    # The tip's circle is 10 mm to the left of a head at x = -8: at C 90 at x = -18, at 270 at 2.
    circle = TipCircle(1.0, 10.0, 0.0)
    here = np.array([[-8.0, 30.0, 1.0, 90.0]])
    turn = np.array([0.0, 0.0, 0.0, 360.0])
    round_, quarter = here + turn, here + turn / 8.0
    assert not turns_outside_board(here, round_, circle, BOARD)[0]
    assert turns_outside_board(here, quarter, circle, BOARD)[0]


def test_a_turn_across_the_board_is_not_free() -> None:
    circle = TipCircle(1.0, 0.0, 0.0)
    start = np.array([[-20.0, 30.0, 1.0, 0.0], [-20.0, -5.0, 1.0, 0.0], [-20.0, -5.0, 1.0, 0.0]])
    end = np.array([[150.0, 30.0, 1.0, 0.0], [150.0, -5.0, 1.0, 0.0], [150.0, 7.0, 1.0, 0.0]])
    assert turns_outside_board(start, end, circle, BOARD).tolist() == [False, True, False]


def test_a_hole_in_the_board_is_outside() -> None:
    ends = np.concatenate(
        [closed((0, 0), (90, 0), (90, 90), (0, 90)), closed((30, 30), (60, 30), (60, 60), (30, 60))]
    )
    holed = Paths(ends[:, 0], ends[:, 1], np.zeros(8), np.array([0, 4, 8]))
    pose = np.array([(45.0, 45.0, 1.0, 0.0), (45.0, 31.0, 1.0, 0.0), (15.0, 15.0, 1.0, 0.0)])
    circle = TipCircle(2.0, 0.0, 0.0)
    np.testing.assert_allclose(interference(pose, circle, FACE, holed), [0.0, 1.0, 1.0])


poses = st.tuples(
    st.floats(-60, 190), st.floats(-60, 120), st.floats(-1.0, 5.0), st.floats(-400.0, 400.0)
)
circles = st.builds(TipCircle, st.floats(0.1, 12.0), st.floats(0.0, 10.0), st.floats(0.0, 80.0))


@examples(3000)
@given(start=poses, end=poses, circle=circles, share=st.floats(0.0, 1.0))
def test_no_pose_of_a_corrected_turn_dips_the_tip_circle_below_the_face(
    start: tuple[float, float, float, float],
    end: tuple[float, float, float, float],
    circle: TipCircle,
    share: float,
) -> None:
    ends = np.array([start, end])
    if not turns_outside_board(ends[:1], ends[1:], circle, BOARD)[0]:
        ends = lift_clear(ends, interference(ends, circle, FACE), circle)
    pose = ends[0] + share * (ends[1] - ends[0])
    points = dots(pose, circle)
    over = points[over_board(points[:, :2])]
    assert over[:, 2].min(initial=FACE) >= FACE - 1e-9


@examples(1000)
@given(pose=poses, circle=circles)
def test_the_lift_is_the_least_that_clears(
    pose: tuple[float, float, float, float], circle: TipCircle
) -> None:
    ends = np.array([pose])
    depth = interference(ends, circle, FACE)
    up = lift_clear(ends, depth, circle)
    if depth[0] > 0.0:
        # The circle's lowest point now lies on the face; 4 × 12 dots meet it at a quarter.
        assert dots(up[0], circle)[:, 2].min() == pytest.approx(FACE, abs=1e-9)
    else:
        np.testing.assert_array_equal(up, ends)


@examples(300)
@given(start=poses, end=poses, circle=circles, angle=st.floats(0.0, 360.0))
def test_lifts_do_not_depend_on_the_direction_of_the_board(
    start: tuple[float, float, float, float],
    end: tuple[float, float, float, float],
    circle: TipCircle,
    angle: float,
) -> None:
    turn = rotation(angle)
    ends = np.array([start, end])
    moved = ends.copy()
    moved[:, :2] = ends[:, :2] @ turn.T
    moved[:, 3] += angle
    board = Paths(BOARD.start @ turn.T, BOARD.end @ turn.T, BOARD.bulge, BOARD.first)
    depth = interference(ends, circle, FACE)
    np.testing.assert_allclose(interference(moved, circle, FACE), depth, atol=1e-9)
    up, up_moved = lift_clear(ends, depth, circle), lift_clear(moved, depth, circle)
    np.testing.assert_allclose(up_moved[:, :2], up[:, :2] @ turn.T, atol=1e-8)
    np.testing.assert_allclose(up_moved[:, 2], up[:, 2], atol=1e-9)
    near = turns_outside_board(
        ends[:1], ends[1:], TipCircle(circle.radius + 0.02, *_rest(circle)), BOARD
    )
    far = turns_outside_board(moved[:1], moved[1:], circle, board)
    # A pose that is clear by 0.02 mm is clear at any rotation of the board.
    assert far[0] or not near[0]


def _rest(circle: TipCircle) -> tuple[float, float]:
    return circle.aside, circle.tilt


def test_a_nearly_flat_tool_cannot_be_lifted_along_its_axis() -> None:
    with pytest.raises(CompensationError, match=r"tilted by 89\.50°"):
        lift_clear(np.zeros((1, 4)), np.ones(1), TipCircle(1.0, 0.0, 89.5))


def test_steps_of_a_turn_are_within_their_limits() -> None:
    # 90° by 4° are 23 steps, 30 mm by 2 mm are 15: the same 23 for both.
    pose = interpolate_turn(np.zeros(4), np.array([30.0, 0.0, 0.0, 90.0]), 4.0, 2.0)
    assert len(pose) == 24
    np.testing.assert_allclose(pose[12], [30 * 12 / 23, 0, 0, 90 * 12 / 23])


def test_a_full_retract_goes_up_across_and_down() -> None:
    pose = np.array([[0, 0, 1, 0], [0, 0, 4, 0], [50, 0, 4, 90], [50, 0, 1, 90]], float)
    moves = [(Motion.LIFT, 6000.0, 1), (Motion.RAPID, 0.0, 1), (Motion.PLUNGE, 6000.0, 1)]
    path = toolpath(pose, moves, source=[0, -1, 1], track=[0, -1, 1])
    full = with_full_retracts(path, MACHINE)
    np.testing.assert_allclose(
        full.pose[1:],
        [[0, 0, 4, 0], [0, 0, 20, 0], [50, 0, 20, 90], [50, 0, 4, 90], [50, 0, 1, 90]],
    )
    assert full.motion.tolist() == [Motion.LIFT, *[Motion.RAPID] * 3, Motion.PLUNGE]
