"""Positions along moves equal those computed by hand, and the planner respects the axes' limits."""

from __future__ import annotations

import math

import pytest

from knifetip.gateway.motion import Limits, Move, Planner

LIMITS = Limits(
    velocity=(1000.0, 1000.0, 100.0, 360.0),
    acceleration=(1000.0, 1000.0, 1000.0, 1000.0),
    low=(-math.inf,) * 4,
    high=(math.inf,) * 4,
)
HOME = (0.0, 0.0, 0.0, 0.0)


def quarter(**more: float) -> Move:
    """Return a counter-clockwise arc about the origin from (10, 0) to (0, 10), C from 90 to 180."""
    return Move(
        (10.0, 0.0, 0.0, 90.0),
        (0.0, 10.0, 0.0, 180.0),
        centre=(0.0, 0.0),
        sweep=math.pi / 2.0,
        **more,
    )


def travelled(planner: Planner, step: float = math.inf) -> float:
    """Run all moves of a planner in time steps of ``step``; return the total time (s)."""
    time = 0.0
    while planner.moving:
        time += planner.advance(step)
    return time


def test_half_of_a_quarter_circle_is_at_45_degrees_with_half_the_turn_of_c() -> None:
    r = 10.0 / math.sqrt(2.0)
    assert quarter().at(0.5) == pytest.approx((r, r, 0.0, 135.0))


def test_heading_of_an_arc_is_its_tangent() -> None:
    x, y, _, _ = quarter().heading(0.0)
    assert x == pytest.approx(0.0)
    assert y > 0.0


def test_a_pose_on_an_arc_is_found_at_its_fraction() -> None:
    arc = quarter()
    distance, fraction = arc.nearest(arc.at(0.3))
    assert distance == pytest.approx(0.0, abs=1e-9)
    assert fraction == pytest.approx(0.3)


def test_a_pose_past_either_end_of_an_arc_is_nearest_to_that_end() -> None:
    assert quarter().nearest((10.0, -1.0, 0.0, 90.0))[1] == 0.0
    assert quarter().nearest((-1.0, 10.0, 0.0, 180.0))[1] == 1.0


def test_a_pose_two_millimetres_beside_a_line_is_two_millimetres_off() -> None:
    line = Move(HOME, (100.0, 0.0, 0.0, 0.0), rate=600.0)
    assert line.nearest((25.0, 2.0, 0.0, 0.0)) == (2.0, 0.25)


def test_the_box_of_a_half_circle_holds_its_belly() -> None:
    half = Move((10.0, 0.0, 0.0, 0.0), (-10.0, 0.0, 0.0, 180.0), centre=(0.0, 0.0), sweep=-math.pi)
    low, high = half.bounds()
    assert low[:2] == pytest.approx((-10.0, -10.0))
    assert high[:2] == pytest.approx((10.0, 0.0))


def seconds_at_pace(move: Move) -> float:
    """Return the time of a move at its greatest velocity throughout (s)."""
    return move.length / move.pace(LIMITS)[0]


def test_inverse_time_takes_its_time() -> None:
    # 0.01 min for 100 mm: 166.7 mm/s, less than the axis permits.
    assert seconds_at_pace(Move(HOME, (100.0, 0.0, 0.0, 0.0), minutes=0.01)) == pytest.approx(0.6)


def test_an_axis_never_goes_faster_than_it_can() -> None:
    # C limits the speed: 720 degrees at 360 per second, although a shorter time is programmed.
    assert seconds_at_pace(Move(HOME, (1.0, 0.0, 0.0, 720.0), minutes=1e-6)) == pytest.approx(2.0)


def test_an_arc_keeps_its_centripetal_acceleration_within_the_axes() -> None:
    arc = Move(
        (10.0, 0.0, 0.0, 0.0),
        (-10.0, 0.0, 0.0, 0.0),
        centre=(0.0, 0.0),
        sweep=math.pi,
        rate=60_000.0,
    )
    # v² / r = a: 100 mm/s on r = 10 mm at 1,000 mm/s².
    assert arc.pace(LIMITS)[0] == pytest.approx(100.0)


def test_a_line_of_100_mm_at_100_mm_a_second_takes_its_ramps_too() -> None:
    planner = Planner(LIMITS, 15, HOME)
    planner.append(Move(HOME, (100.0, 0.0, 0.0, 0.0), rate=6000.0))
    # 100 mm / 100 mm/s, plus 0.1 s: both ramps of 0.1 s have half the speed on average.
    assert travelled(planner) == pytest.approx(1.1)
    assert planner.position == (100.0, 0.0, 0.0, 0.0)


def test_many_short_steps_meet_one_long_step() -> None:
    poses = []
    for steps in (1, 70):
        planner = Planner(LIMITS, 15, HOME)
        planner.append(Move(HOME, (100.0, 0.0, 0.0, 0.0), rate=6000.0))
        for _ in range(steps):
            planner.advance(0.7 / steps)
        poses.append(planner.position)
    # 5 mm on the ramp, then 0.6 s at 100 mm/s.
    assert poses[0] == pytest.approx((65.0, 0.0, 0.0, 0.0))
    assert poses[1] == pytest.approx(poses[0])


def test_a_straight_joint_is_passed_at_full_speed_and_a_corner_is_not() -> None:
    def time(corner: tuple[float, float, float, float]) -> float:
        planner = Planner(LIMITS, 15, HOME)
        planner.append(Move(HOME, (50.0, 0.0, 0.0, 0.0), rate=6000.0))
        planner.append(Move((50.0, 0.0, 0.0, 0.0), corner, rate=6000.0))
        return travelled(planner)

    assert time((100.0, 0.0, 0.0, 0.0)) == pytest.approx(1.1)
    # Down to 2 mm/s (JOLT × 1,000 mm/s²) and up again: almost the time of a stop, 1.2 s.
    assert 1.19 < time((50.0, 50.0, 0.0, 0.0)) < 1.2


def test_a_tangent_arc_is_joined_without_slowing_down() -> None:
    planner = Planner(LIMITS, 15, (10.0, -50.0, 0.0, 0.0))
    planner.append(Move((10.0, -50.0, 0.0, 0.0), (10.0, 0.0, 0.0, 0.0), rate=3000.0))
    arc = Move(
        (10.0, 0.0, 0.0, 0.0),
        (0.0, 10.0, 0.0, 0.0),
        centre=(0.0, 0.0),
        sweep=math.pi / 2.0,
        rate=3000.0,
    )
    planner.append(arc)
    assert travelled(planner) == pytest.approx((50.0 + 5.0 * math.pi) / 50.0 + 0.05)


def test_a_hold_in_mid_arc_takes_its_braking_distance_and_stays_on_the_arc() -> None:
    planner = Planner(LIMITS, 15, (10.0, 0.0, 0.0, 90.0))
    planner.append(quarter(minutes=0.1))  # 91.4 of length in 6 s: 15.2 a second
    planner.advance(3.0)
    before, speed = planner.fraction, planner.speed
    planner.holding = True
    braking = 0
    while planner.moving:
        planner.advance(0.001)
        braking += 1
    assert braking > 0
    length = math.hypot(5.0 * math.pi, 90.0)
    hardest = 1000.0 * length / 90.0  # C has the lowest deceleration
    assert planner.halted
    assert (planner.fraction - before) * length == pytest.approx(speed**2 / 2.0 / hardest, rel=1e-6)
    assert math.hypot(*planner.position[:2]) == pytest.approx(10.0)
    assert planner.advance(1.0) == 0.0
    planner.holding = False
    travelled(planner)
    assert planner.position == (0.0, 10.0, 0.0, 180.0)


def test_a_hold_just_before_a_joint_comes_to_rest_in_the_next_move() -> None:
    planner = Planner(LIMITS, 15, HOME)
    planner.append(Move(HOME, (50.0, 0.0, 0.0, 0.0), rate=6000.0))
    planner.append(Move((50.0, 0.0, 0.0, 0.0), (100.0, 0.0, 0.0, 0.0), rate=6000.0))
    planner.advance(0.54)  # 5 mm of ramp and 44 mm: 1 mm before the joint, 5 mm to brake
    planner.holding = True
    while planner.moving:
        planner.advance(1.0)
    assert planner.position[0] == pytest.approx(54.0)


def test_moves_of_no_length_are_not_queued() -> None:
    planner = Planner(LIMITS, 15, HOME)
    planner.append(Move(HOME, HOME, rate=600.0))
    assert len(planner) == 0
