"""The laser table: its programs are accepted, and programs that burn elsewhere are refused."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip.compensation import centre_paths
from knifetip.errors import ProgramError
from knifetip.geometry.path import Paths
from knifetip.model.machine import Machine
from knifetip.model.tool import Laser
from knifetip.model.verdict import Verdict
from knifetip.sequencing.duration import durations
from knifetip.verification.verify import verify
from tests.support.modules import original
from tests.support.programs.laser import BOARD, LASER, LINE, program, toolpath


def verdict_of(text: bytes, dialect: str = "grblhal", machine: Machine = LASER) -> Verdict:
    return verify(text, LINE, (0.0, 0.0), replace(machine, dialect=dialect), BOARD)


def findings(text: str) -> str:
    """Return the texts of all findings about a program in one string; the program must be
    refused.
    """
    verdict = verdict_of(text.encode())
    assert not verdict.accepted
    return "\n".join(finding.text for finding in verdict.findings)


def with_laser(**dimensions: Any) -> Machine:
    """Return the laser table with other dimensions of its laser."""
    stations = (
        replace(one, tool=replace(one.tool, **dimensions)) if isinstance(one.tool, Laser) else one
        for one in LASER.stations
    )
    return replace(LASER, stations=tuple(stations))


@pytest.fixture(scope="module")
def text() -> str:
    """Return the program of the laser job for grblHAL as text."""
    return program("grblhal").text.decode()


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
@pytest.mark.parametrize("corner", ["B", "C", "D", "auto"])
def test_programs_of_the_laser_are_accepted(dialect: str, corner: str) -> None:
    verdict = verdict_of(program(dialect, corner).text, dialect)
    assert verdict.accepted, verdict.findings[:3]
    assert verdict.uncut.max() == 0.0


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_the_beam_is_off_for_every_rapid_and_is_never_turned_up_or_down(dialect: str) -> None:
    on, cuts = True, 0  # until M5 the beam may be on from an earlier job
    for line in program(dialect).text.decode().splitlines():
        if re.match(r"M[35]\b", line):
            assert line in ("M5", "M3 S800")
            on = line != "M5"
        elif re.match(r"G0\b", line):
            assert not on, line
        elif on and re.match(r"G[123]\b", line):
            assert "Z" not in line
            cuts += 1
    assert not on
    assert cuts > 10


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_each_line_belongs_to_the_move_that_it_makes(dialect: str) -> None:
    made = program(dialect)
    lines = made.text.decode().splitlines()
    assert len(made.source) == len(lines)
    path = toolpath()
    # G0 lines are rapids, other motions are not; lines that switch outputs belong to no move.
    moves = [line[:2] == "G0" for line, row in zip(lines, made.source, strict=True) if row >= 0]
    rapid = path.motion[made.source[made.source >= 0]] == 0
    np.testing.assert_array_equal(moves, rapid)
    switches = [line for line, row in zip(lines, made.source, strict=True) if row < 0]
    assert sum(line == "M3 S800" for line in switches) == 3


def test_the_focus_stays_at_one_height_while_the_laser_is_in_use() -> None:
    path = toolpath()
    work = (path.tool == 5) & (path.track >= 0)
    np.testing.assert_allclose(path.pose[1:][work, 2], BOARD.caliper)
    deeper = with_laser(focus=-0.2)
    text = program("grblhal", machine=deeper).text
    assert not verdict_of(text, machine=deeper).accepted  # the program is planned for another focus


@pytest.mark.parametrize("factor", [0.85, 1.15])
def test_half_a_kerf_wrong_by_15_micrometres_is_refused(
    monkeypatch: pytest.MonkeyPatch, factor: float
) -> None:
    right = original(centre_paths, "offset_paths")

    def wrong(paths: Paths, distance: float, side: int, **more: object) -> object:
        return right(paths, distance * factor, side, **more)

    monkeypatch.setattr(centre_paths, "offset_paths", wrong)
    assert not verdict_of(program("grblhal").text).accepted


def test_a_kerf_on_the_wrong_side_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    right = original(centre_paths, "offset_paths")

    def wrong(paths: Paths, distance: float, side: int, **more: object) -> object:
        return right(paths, distance, -side, **more)

    monkeypatch.setattr(centre_paths, "offset_paths", wrong)
    assert not verdict_of(program("grblhal").text).accepted


FAULTS: dict[str, tuple[Callable[[str], str], str]] = {
    "on along a rapid": (lambda text: text.replace("M5\nG0 X", "G0 X", 1), "during a rapid move"),
    "on from the job before": (
        lambda text: text.replace("M5\nG0 Z", "G0 Z", 1),
        "so a laser beam may still be on",
    ),
    "on at the end": (
        lambda text: text.replace("M5\nG49", "M3 S800\nG49"), "while a tool oscillates"
    ),
    "no power": (lambda text: text.replace("M3 S800", "M3", 1), "differs from the speed"),
    "less power": (lambda text: text.replace("M3 S800", "M3 S700", 1), "differs from the speed"),
    "no pierce": (
        lambda text: text.replace("M3 S800\nG4 P0.2\n", "M3 S800\n", 1),
        "moves the head too soon",
    ),
    "short pierce": (lambda text: text.replace("G4 P0.2\n", "G4 P0.1\n", 1), "is shorter than"),
    "never on": (lambda text: text.replace("M3 S800\nG4 P0.2\n", ""), "left without a cut"),
    "once off": (lambda text: text.replace("M3 S800\nG4 P0.2\n", "", 1), "left without a cut"),
    "no air": (lambda text: text.replace("M64 P5\n", ""), "output 5 is off"),
    "air left on": (lambda text: "".join(text.rsplit("M65 P5\n", 1)), ""),
    "shutter closed": (lambda text: text.replace("M64 P4\n", ""), ""),
    "out of focus": (lambda text: text.replace("Z0.4000", "Z1.4000"), "instead of"),
    "focus moves": (
        lambda text: text.replace("G4 P0.2\nG1 ", "G4 P0.2\nG1 Z0.9000 ", 1),
        "while the head moves up or down",
    ),
    "too fast": (lambda text: text.replace("F9000", "F12000"), "a feed of 12,000"),
    "too slow": (lambda text: text.replace("F9000", "F6000"), "a feed of 6,000"),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS)
def test_a_program_with_a_fault_is_refused(text: str, fault: str) -> None:
    damage, expected = FAULTS[fault]
    wrong = damage(text)
    assert wrong != text
    assert expected in findings(wrong)


def test_a_laser_without_power_has_no_program() -> None:
    with pytest.raises(ProgramError, match="The power of the laser is 0"):
        program("grblhal", machine=with_laser(power=0.0))


def test_the_time_includes_piercing() -> None:
    slow = with_laser(pierce=1.2)
    path = toolpath()
    assert durations(path, slow).sum() - durations(path, LASER).sum() == pytest.approx(3 * 1.0)
