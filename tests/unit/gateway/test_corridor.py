"""The path of the lines that were sent: positions on it, and positions that stop the machine."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pytest

from knifetip.errors import ControllerError
from knifetip.gateway.controller import State, Status
from knifetip.gateway.corridor import REPORTS, Corridor, distance_to
from knifetip.gateway.interpreter import Block, Interpreter
from knifetip.gateway.motion import Move
from knifetip.gateway.program_blocks import read_blocks

PROGRAM = b"G21 G90\nG0 Z20\nG0 X100 Y100\nG1 Z-1 F600\nG1 X200\nG3 X200 Y120 J10 F900\nG1 X100\n"
START = Status(State.IDLE, (0.0, 0.0, 20.0, 0.0), 40, True, sent=40)


def report(
    x: float,
    y: float,
    z: float,
    *,
    sent: int = 7,
    answered: int = 7,
    state: State = State.RUN,
    located: bool = True,
    c: float = 0.0,
) -> Status:
    return Status(state, (x, y, z, c), 40 + answered, False, sent=40 + sent, located=located)


def verdict(corridor: Corridor, status: Status, reports: int = REPORTS) -> ControllerError | None:
    """Pass equal reports to a corridor; return the fault that the last one gives, None for none.

    ``reports`` is the number of reports, each with the position in ``status``.
    """
    for _ in range(reports - 1):
        assert corridor.observe(status) is None
    return corridor.observe(status)


def lines(program: bytes) -> Iterator[Block | None]:
    return read_blocks(program, Interpreter(START.position))


@pytest.mark.parametrize(
    "place",
    [(0, 0, 20), (50, 50, 20), (100, 100, 5), (150, 100.4, -1), (210, 110, -1), (150, 120, -1)],
)
def test_a_position_on_any_move_that_was_sent_is_right(place: tuple[int, float, int]) -> None:
    assert verdict(Corridor(lines(PROGRAM), START, 15), report(*place)) is None


@pytest.mark.parametrize("place", [(50, 51, 20), (150, 100.6, -1), (205, 105, -1), (150, 100, 0)])
def test_a_position_off_the_path_is_a_fault_if_a_second_report_confirms_it(
    place: tuple[int, float, int],
) -> None:
    error = verdict(Corridor(lines(PROGRAM), START, 15), report(*place))
    assert error is not None
    assert "away from the path of the program near program line" in error.text
    assert "home the machine" in error.hint


@pytest.mark.parametrize(("y", "error"), [(100.09, False), (100.12, True)])
def test_the_accuracy_of_the_controller_is_the_width_of_the_corridor(y: float, error: bool) -> None:
    corridor = Corridor(lines(PROGRAM), START, 15, off=0.1)
    assert (verdict(corridor, report(150.0, y, -1.0)) is not None) is error


def test_moves_whose_steps_are_prepared_belong_to_the_path() -> None:
    rows = b"".join(b"G1 X%d Y%d F900\n" % (100 * (row % 2), row) for row in range(200))
    # 150 lines are answered: 100 moves are in the planner, 9 more are prepared, 4 are a margin.
    corridors = [Corridor(lines(rows), START, 100, ahead=ahead) for ahead in (0, 9)]
    # As long as the machine was not seen on a later move, it may be slow.
    slow = Corridor(lines(rows), START, 100)
    assert verdict(slow, report(50, 19.5, 20, sent=150, answered=150)) is None
    for one in corridors:
        assert verdict(one, report(50, 148.5, 20, sent=150, answered=150)) is None
    late = [verdict(one, report(50, 150 - 107.5, 20, sent=150, answered=150)) for one in corridors]
    assert [error is None for error in late] == [False, True]


TURNING = (
    b"G21 G90\nG0 Z20\nG0 X100 Y100 C90\nG1 Z-1 F600\nG1 Y200\nG3 X80 Y220 I-20 C180 F900\n"
    b"G1 C360\nG1 X0 C360\n"
)


@pytest.mark.parametrize(
    "pose",
    [
        (100, 150, -1, 90.5),  # on the way along Y
        (100, 150, -1, 450.0),
        (100, 150, -1, -270.9),
        (94.142, 214.142, -1, 135.0),  # on the arc
        (80, 220, -1, 300.0),  # turning in place
        (40, 220, -1, 0.0),
    ],
)
def test_a_heading_of_the_program_is_right_modulo_a_turn(
    pose: tuple[float, float, float, float],
) -> None:
    x, y, z, c = pose
    assert (
        verdict(Corridor(lines(TURNING), START, 15), report(x, y, z, c=c, sent=8, answered=8))
        is None
    )


@pytest.mark.parametrize(
    ("pose", "line", "turn"),
    [((100, 150, -1, 80.0), 5, 10.0), ((90, 217.3, -1, 200.0), 6, 20.0), ((40, 220, -1, 3), 8, 3)],
)
def test_another_heading_is_a_fault(
    pose: tuple[float, float, float, float], line: int, turn: float
) -> None:
    x, y, z, c = pose
    error = verdict(Corridor(lines(TURNING), START, 15), report(x, y, z, c=c, sent=8, answered=8))
    assert error is not None
    assert f"{turn:.1f} degrees away from the program near program line {line}" in error.text


def test_at_rest_the_heading_is_that_of_the_last_line() -> None:
    corridor = Corridor(lines(TURNING), START, 15)
    corridor.check_rest(report(0, 220, -1, c=0.4, sent=8, answered=8))
    with pytest.raises(ControllerError, match="degrees away"):
        corridor.check_rest(report(0, 220, -1, c=340.0, sent=8, answered=8))


def test_a_single_wrong_report_is_borne_and_another_one_is_wanted_at_once() -> None:
    corridor = Corridor(lines(PROGRAM), START, 15)
    for _ in range(5):
        assert corridor.observe(report(900, 0, 20)) is None
        assert corridor.doubtful
        assert corridor.observe(report(150, 100, -1)) is None
        assert not corridor.doubtful


def test_a_move_that_was_not_sent_yet_is_off_the_path() -> None:
    assert verdict(Corridor(lines(PROGRAM), START, 15), report(150, 120, -1, sent=6, answered=6))
    assert verdict(Corridor(lines(PROGRAM), START, 15), report(150, 120, -1)) is None


def test_a_move_that_must_be_done_is_off_the_path() -> None:
    rows = b"".join(b"G1 X%d Y%d F900\n" % (100 * (row % 2), row) for row in range(200))
    corridor = Corridor(lines(rows), START, 4)
    # Of 150 answered lines, 4 can be in the planner; some more are kept for excess answers.
    on_row = [
        verdict(corridor, report(50, row - 0.5, 20, sent=155, answered=150)) is None
        for row in (152, 148, 138)
    ]
    assert on_row == [True, True, False]


@pytest.mark.parametrize(
    "program",
    [PROGRAM.replace(b"G1 Z-1", b"G53 G1 Z-1"), PROGRAM.replace(b"G1 Z-1", b"G43 H1\nG1 Z-1")],
    ids=["machine coordinates", "unknown word"],
)
def test_a_program_that_cannot_be_followed_is_not_checked(program: bytes) -> None:
    assert verdict(Corridor(lines(program), START, 15), report(900, 900, 20)) is None


def test_positions_without_a_known_work_offset_are_not_checked() -> None:
    corridor = Corridor(lines(PROGRAM), START, 15)
    assert verdict(corridor, report(900, 900, 20, located=False)) is None


@pytest.mark.parametrize("state", [State.CHECK, State.ALARM, State.JOG])
def test_only_a_machine_that_carries_out_the_program_is_checked(state: State) -> None:
    assert verdict(Corridor(lines(PROGRAM), START, 15), report(900, 900, 20, state=state)) is None


def test_at_rest_the_position_is_the_end_of_the_last_line() -> None:
    corridor = Corridor(lines(PROGRAM), START, 15)
    corridor.check_rest(report(100, 120, -1, state=State.IDLE))
    with pytest.raises(ControllerError, match=r"10\.0 mm away .* near program line 7"):
        corridor.check_rest(report(110, 120, -1, state=State.IDLE))


def test_the_distance_from_an_arc_is_that_from_its_circle_and_beyond_it_from_its_ends() -> None:
    arc = Move(
        (10.0, 0.0, 0.0, 0.0), (-10.0, 0.0, 2.0, 0.0), centre=(0.0, 0.0), sweep=math.pi, rate=1.0
    )
    assert distance_to(arc, (0.0, 11.0, 1.0, 0.0)) == pytest.approx(1.0)
    assert distance_to(arc, (0.0, 10.0, 3.0, 0.0)) == pytest.approx(2.0)
    assert distance_to(arc, (10.0, -3.0, 0.0, 0.0)) == pytest.approx(3.0)
