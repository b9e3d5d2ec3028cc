"""The executed line is estimated from reports of the controller, and never too far ahead."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from knifetip.gateway.controller import State, Status
from knifetip.gateway.interpreter import Interpreter
from knifetip.gateway.program_blocks import read_blocks
from knifetip.gateway.program_follower import ProgramFollower

# Along X with C at 0, a half turn in place, and back over the same points with C at 180.
GROOVE = b"""G21 G90 G94
M64 P2
G4 P0.15
G0 X0 Y0 Z1
G1 X100 F6000
G1 C180
G1 X0
G1 Z20
M30
"""


def at(
    x: float = 0.0,
    y: float = 0.0,
    z: float = 0.0,
    c: float = 0.0,
    *,
    number: int = 0,
    free: int | None = None,
) -> Status:
    return Status(State.RUN, (x, y, z, c), 0, False, number, free)


def followed(
    text: bytes = GROOVE, seconds: Sequence[float] | None = None, ahead: int = 1
) -> ProgramFollower:
    durations = [0.0] * text.count(b"\n") if seconds is None else seconds
    return ProgramFollower(read_blocks(text, Interpreter()), durations, ahead)


def test_nothing_is_executed_before_it_is_answered() -> None:
    assert followed().update(at(50.0, z=1.0), 0, None) == 0


def test_a_dwell_that_was_answered_settles_all_before_it() -> None:
    follower = followed(b"M64 P2\nG1 X10 F600\nG4 P0.15\nG1 X20\n")
    assert follower.update(at(y=500.0), 2, None) == 1
    assert follower.output == 2
    assert follower.update(at(y=500.0), 3, None) == 3


def test_c_distinguishes_the_way_out_from_the_way_back() -> None:
    follower = followed()
    assert follower.update(at(50.0, z=1.0, c=0.0), 8, None) == 4
    assert follower.update(at(100.0, z=1.0, c=90.0), 8, None) == 5
    assert follower.update(at(50.0, z=1.0, c=180.0), 8, None) == 6


def test_the_executed_line_never_goes_back() -> None:
    follower = followed()
    follower.update(at(50.0, z=1.0, c=180.0), 8, None)
    assert follower.update(at(50.0, z=1.0, c=0.0), 8, None) == 6


def test_a_position_off_the_path_is_no_evidence() -> None:
    follower = followed()
    follower.update(at(50.0, z=1.0), 8, None)
    assert follower.update(at(50.0, y=3.0, z=1.0), 8, None) == 4


def test_just_after_a_joint_it_is_the_next_line() -> None:
    # 0.03 mm of the return done: nearer to the return than to the end of the half turn.
    follower = followed()
    follower.update(at(100.0, z=1.0, c=90.0), 8, None)
    assert follower.update(at(99.97, z=1.0, c=180.0), 8, None) == 6


def test_the_rounding_of_a_report_does_not_move_it_on() -> None:
    # The second line is nearer to the reported position by 0.0005 mm.
    text = b"G1 X100 F600\nG1 X0 Y0.001\n"
    assert followed(text).update(at(50.0, 0.0005), 2, None) == 0


def test_a_later_crossing_of_the_same_point_does_not_count() -> None:
    text = b"G1 X100 F600\nG1 X100 Y10\nG1 X50\nG1 Y-10\n"
    assert followed(text).update(at(50.0, 0.001), 4, None) == 0


def test_blocks_free_in_the_planner_say_how_much_must_be_done() -> None:
    # Five moves answered, 14 of 15 blocks free: one is planned, one more may be executing.
    follower = followed()
    assert follower.update(at(y=500.0, free=14), 8, 15) == 6


def test_moves_whose_steps_are_prepared_do_not_count_as_executed() -> None:
    # 21 moves, all answered; the planner holds 10 blocks, of which none is free.  The position is
    # no evidence, since it is off the path.
    text = b"G90\n" + b"".join(b"G1 X%d F900\n" % x for x in range(1, 22))
    follower = followed(text, ahead=9)
    assert follower.update(at(y=500.0, free=0), 22, 10) == 22 - 10 - 9


def test_a_line_number_that_is_reported_names_the_line() -> None:
    text = b"N10 G1 X10 F600\nN20 G1 X20\nN30 G1 X30\n"
    assert followed(text).update(at(y=500.0, number=30), 3, None) == 2


def test_seconds_count_the_part_of_the_current_line() -> None:
    follower = followed(seconds=[0.0, 0.0, 0.15, 0.06, 1.0, 2.0, 3.0, 4.0, 0.0])
    follower.update(at(25.0, z=1.0), 8, None)
    assert follower.seconds_done == pytest.approx(0.15 + 0.06 + 0.25)


def test_at_the_end_everything_is_executed() -> None:
    assert followed().finish(9) == 9


def test_memory_does_not_grow_with_the_program() -> None:
    text = b"G21 G90\n" + b"".join(b"G1 X%d F600\n" % (row % 2) for row in range(5000))
    follower = followed(text)
    most = 0
    for answered in range(20, 5001, 20):
        follower.update(at(y=500.0, free=0), answered, 15)
        most = max(most, len(follower._window))
    assert most <= 17
    assert follower.lines > 4900
