"""Dry programs: the path of the job in X, Y and C above the board, with nothing switched on."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from knifetip.errors import ControllerError
from knifetip.gateway.dry_program import (
    check_dry_program,
    dry_height,
    dry_program,
    frame_program,
    station_starts,
    travel_program,
    work_box,
)
from knifetip.gateway.interpreter import Interpreter, tool_offsets
from knifetip.gateway.motion import Pose
from knifetip.gateway.program_blocks import lines_of
from knifetip.library import load

MACHINE = load.machine("demo-table")
GOLDEN = Path(__file__).parents[2] / "golden"
PROGRAMS = {
    name: (GOLDEN / f"{name}.ngc").read_bytes()
    for name in ("small-job-grblhal", "small-job-linuxcnc", "laser-job-grblhal")
}
START: Pose = (0.0, 0.0, 20.0, 0.0)
LIFT = b"G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\nG0 Z20\n"


def poses(text: bytes) -> list[Pose]:
    """Return the poses at the ends of the moves of a program for grblHAL, read from their words."""
    at, found = list(START), []
    for line in lines_of(text):
        words = dict(re.findall(rb"([XYZC])([-\d.]+)", re.sub(rb"\(.*\)", b"", line)))
        for axis, letter in enumerate((b"X", b"Y", b"Z", b"C")):
            at[axis] = float(words.get(letter, at[axis]))
        if words:
            found.append((at[0], at[1], at[2], at[3]))
    return found


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_dry_program_has_the_path_of_the_program_and_stays_above_the_board(name: str) -> None:
    program = PROGRAMS[name]
    dry = dry_program(program, MACHINE, 0.5)
    assert dry.count(b"\n") == program.count(b"\n")
    check_dry_program(dry, program, MACHINE, START, tool_offsets(MACHINE))
    assert {pose[2] for pose in poses(dry)} == {dry_height(MACHINE)} == {20.0}
    assert not re.search(rb"M0?[345]\b|M6[2-5]|S\d", dry)
    flat = [(x, y, c) for x, y, _, c in poses(program)]
    assert {(x, y, c) for x, y, _, c in poses(dry)} == set(flat)


def test_feeds_are_a_share_of_those_of_the_program_and_rapids_are_slow_too() -> None:
    program = LIFT + b"G0 X100 Y50\nG1 Z-0.3 F6000\nG1 X200 F24000\nY80\nG93 G1 C90 F800\n"
    program += b"G94 G3 X210 Y90 I0 J10 F12000\nM2\n"
    lines = dry_program(program, MACHINE, 0.25).split(b"\n")
    assert lines[1:] == [
        b"G0 Z20.0000",
        b"G94 G1 X100.0000 Y50.0000 F22500",
        b"",
        b"G94 G1 X200.0000 F6000",
        b"G94 G1 Y80.0000 F6000",
        b"G93 G1 C90.0000 F200",
        b"G94 G3 X210.0000 Y90.0000 I0.0000 J10.0000 F3000",
        b"M2",
        b"",
    ]


def test_the_height_clears_the_board_for_the_longest_tool() -> None:
    low = replace(MACHINE.stations[0], z=12.0)
    machine = replace(MACHINE, stations=(low, *MACHINE.stations[1:]))
    assert dry_height(machine) == 32.0
    assert dry_height(replace(machine, z=replace(machine.z, high=25.0))) == 25.0


@pytest.mark.parametrize(
    "line",
    [
        b"G20",
        b"G91",
        b"G53 G0 Z5",
        b"G92 Z30",
        b"G10 L20 P1 Z0",
        b"G28",
        b"M98 P100",
        b"O100 sub",
        b"#1=5",
        b"G38.2 Z-5 F100",
        b"G81 X1 Y1 Z-3 R2",
        b"G1 X10 M64 P1 F100",
        b"M64 P1 G0 X5",
        b"G1 X5 A3 F100",
        b"M0",
        b"!",
        b"G43 H2",
    ],
)
def test_a_line_that_might_lower_or_switch_something_is_refused(line: bytes) -> None:
    with pytest.raises(ControllerError) as refused:
        dry_program(LIFT + line + b"\nM2\n", MACHINE, 1.0)
    assert refused.value.message.code == "dry-run.unknown-line"
    assert refused.value.message.arguments["line"] == 3


def test_a_program_that_moves_before_its_lift_is_refused() -> None:
    with pytest.raises(ControllerError):
        dry_program(b"G21 G90\nG0 X10 Y10\nG0 Z20\nM2\n", MACHINE, 1.0)


@pytest.mark.parametrize(
    ("changed", "code"),
    [
        ((b"G0 Z20.0000", b"G0 Z19.0000"), "dry-run.no-lift"),
        ((b"X560.0000 F", b"X560.0000 Z2 F"), "dry-run.too-low"),
        ((b"X560.0000 F", b"X561.0000 F"), "dry-run.other-path"),
        ((b"G94 G1 X560.0000 F30000", b""), "dry-run.other-path"),
        ((b"\n\nG4 P0\n", b"\nM64 P1\nG4 P0\n"), "dry-run.switches"),
        ((b"\n\nG4 P0\n", b"\nM4 S100\nG4 P0\n"), "dry-run.switches"),
        ((b"M30\n", b""), "dry-run.other-path"),
    ],
)
def test_the_check_notices_a_wrong_dry_program(changed: tuple[bytes, bytes], code: str) -> None:
    """The check reads both programs with another parser than the one that makes the dry program."""
    from tests.unit.gateway.test_claim import PROGRAM

    dry = dry_program(PROGRAM, MACHINE, 1.0)
    check_dry_program(dry, PROGRAM, MACHINE, START)
    broken = dry.replace(*changed, 1)
    assert broken != dry
    with pytest.raises(ControllerError) as refused:
        check_dry_program(broken, PROGRAM, MACHINE, START)
    assert refused.value.message.code == code


@pytest.mark.parametrize("name", ["small-job-grblhal", "small-job-linuxcnc"])
def test_the_stations_and_the_box_of_the_work(name: str) -> None:
    program = PROGRAMS[name]
    assert [one.number for _, one in station_starts(program, MACHINE)] == [2, 3, 1]
    # The half circle at the left reaches X 90.
    assert work_box(program, MACHINE, START, tool_offsets(MACHINE)) == pytest.approx(
        (90.0, 70.0, 220.0, 130.0), abs=1e-3
    )
    assert work_box(LIFT + b"M2\n", MACHINE, START) is None


def test_a_frame_goes_round_the_box_with_the_axis_of_the_station() -> None:
    program = frame_program((20.0, 30.0, 420.0, 330.0), MACHINE.stations[1], MACHINE, 0.5)
    interpreter = Interpreter((5.0, 5.0, 3.0, 90.0))
    ends = [b.move.end for b in map(interpreter.read, lines_of(program)) if b.move is not None]
    corners = [(80, 30), (480, 30), (480, 330), (80, 330), (80, 30)]
    assert ends == [(5.0, 5.0, 20.0, 90.0), *((x, y, 20.0, 90.0) for x, y in corners)]
    with pytest.raises(ControllerError) as refused:
        travel_program([(1800.0, 0.0)], MACHINE, 1.0)
    assert refused.value.message.code == "operation.beyond-travel"
