"""Direction and speed of the spindles of stations, as the machine states them."""

from __future__ import annotations

from dataclasses import replace

import pytest

from knifetip.model.machine import Machine
from knifetip.verification.verify import verify
from tests.support.programs.handwritten import (
    BOARD,
    DIELINE,
    GRBLHAL,
    LINUXCNC,
    MACHINE,
    PLACEMENT,
    changed,
)

BOTH = pytest.mark.parametrize("program", [LINUXCNC, GRBLHAL], ids=["linuxcnc", "grblhal"])
KNIFE = next(station for station in MACHINE.stations if station.number == 1)
TURNED = replace(KNIFE, spindle="M4", spindle_speed=12000.0)
#: The demo table with a knife whose oscillation needs M4 and a number of strokes.
REVERSED = replace(
    MACHINE, stations=tuple(TURNED if one is KNIFE else one for one in MACHINE.stations)
)


def codes(program: bytes, machine: Machine = REVERSED) -> list[str]:
    return [
        one.message.code for one in verify(program, DIELINE, PLACEMENT, machine, BOARD).findings
    ]


def reverse(program: bytes, words: str = "M4 S12000") -> bytes:
    return changed(program, "M3 S1\n", f"{words}\n" if words else "")


@BOTH
def test_the_direction_and_the_speed_of_the_station_are_accepted(program: bytes) -> None:
    assert codes(program, MACHINE) == []
    assert codes(reverse(program)) == []


@BOTH
@pytest.mark.parametrize(
    ("words", "code"),
    [
        ("M3 S12000", "rs274.wrong-direction"),
        ("M4 S1", "rs274.wrong-speed"),
        ("M4", "rs274.wrong-speed"),
        ("", "verify.knife-at-rest"),
        ("S12000", "rs274.speed-without-m3"),
        ("M5 S12000", "rs274.speed-without-m3"),
    ],
)
def test_another_direction_or_speed_is_refused(program: bytes, words: str, code: str) -> None:
    assert code in codes(reverse(program, words))


@BOTH
def test_m4_is_refused_where_the_machine_states_m3(program: bytes) -> None:
    assert codes(reverse(program, "M4 S1"), MACHINE) == ["rs274.wrong-direction"]


@BOTH
def test_a_spindle_that_is_left_on_at_the_end_is_refused(program: bytes) -> None:
    turned = reverse(program)
    end = turned.rindex(b"M5\n")
    assert "rs274.ends-oscillating" in codes(turned[:end] + turned[end + 3 :])


@BOTH
def test_a_spindle_that_is_left_on_for_the_next_station_is_refused(program: bytes) -> None:
    """The crease wheel has no spindle; another cutter would turn with the wrong speed."""
    wheel = "T2 M6 G43\n" if program == LINUXCNC else "M64 P1\n"
    left_on = changed(program, wheel, f"M4 S12000\n{wheel}")
    assert "verify.oscillation-on" in codes(reverse(left_on))


def test_the_spindle_of_another_station_is_refused_although_both_turn() -> None:
    """Two knives: the second would oscillate with the direction and the speed of the first."""
    second = replace(KNIFE, number=3, name="Other knife", output=2, spindle="M4")
    stations = (KNIFE, MACHINE.stations[1], second)
    machine = replace(MACHINE, stations=stations)
    lines = LINUXCNC.decode().split("\n")
    first, last = lines.index("M3 S1"), len(lines) - 1 - lines[::-1].index("G0 Z20.0000")
    change = ["G0 Z20.0000", "M65 P0", "T3 M6 G43", "M64 P2", "G4 P0.15", "G0 X300 Y300 Z20 C0"]
    program = "\n".join([*lines[:last], *change, *lines[last:]]).encode()
    assert first < last
    assert "rs274.spindle-of-other-station" in codes(program, machine)
    stopped = program.replace(b"T3 M6 G43\n", b"M5\nT3 M6 G43\n")
    assert "rs274.spindle-of-other-station" not in codes(stopped, machine)
