"""Machines whose controllers cannot follow arcs: ``arcs = "chords"``."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.model.program import Program
from knifetip.model.tool import Knife
from knifetip.model.toolpath import Toolpath
from knifetip.sequencing.duration import duration, durations
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.verify import trace_program, verify
from tests.support.shapes import dieline, edges
from tests.support.verdicts import has_faults

BOARD = load.board("greyboard-2.0")
QUARTER = float(np.tan(np.pi / 8))
RADIUS = 30.0
#: A circle about (200, 200), and a crease of a quarter turn about (300, 300).
LINE = dieline(
    (LineType.CUT, edges(((230, 200), (200, 230)), ((200, 230), (170, 200)))),
    (LineType.CUT, edges(((170, 200), (200, 170)), ((200, 170), (230, 200)))),
    (LineType.CREASE, edges(((400, 300), (300, 400)))),
    bulge=dict.fromkeys(range(5), QUARTER),
)


def table(dialect: str, arcs: str = "chords", trail: float = 0.0) -> Machine:
    machine = load.machine("demo-table")
    held = machine.stations[0]
    assert isinstance(held.tool, Knife)
    knife = replace(held, tool=replace(held.tool, trail=trail, blade_width=1.0, blade_angle=0.0))
    stations = (knife, *machine.stations[1:])
    return replace(machine, dialect=dialect, arcs=arcs, stations=stations)


def made(machine: Machine) -> tuple[Toolpath, Program]:
    toolpath = sequence([compensate(one) for one in plan(LINE, machine, BOARD)], machine)
    return toolpath, process(toolpath, machine)


def knife_paths(machine: Machine, text: bytes) -> TipPaths:
    return trace_program(text, machine, BOARD)[2]


@pytest.mark.parametrize("trail", [0.0, 0.75])
@pytest.mark.parametrize("dialect", ["grblhal", "linuxcnc"])
def test_the_program_has_chords_that_are_accepted(dialect: str, trail: float) -> None:
    machine = table(dialect, trail=trail)
    text = made(machine)[1].text
    assert not re.search(rb"\bG[23]\b", text)
    verdict = verify(text, LINE, (0.0, 0.0), machine, BOARD)
    assert not has_faults(verdict)
    assert 0.0015 < verdict.path_deviation.max() < 0.0022
    paths = knife_paths(machine, text)
    cut = np.flatnonzero(paths.station == 0)
    start, end = paths.ends()
    middle = (start[cut] + end[cut]) / 2.0 - 200.0
    beside = RADIUS - np.hypot(*middle.T)
    assert beside.min() >= 0.0
    assert beside.max() < 0.0022
    # C is the heading of the arc at both ends of every chord.
    tangent = np.degrees(np.arctan2(start[cut, 0] - 200.0, 200.0 - start[cut, 1]))
    error = (paths.heading[cut, 0] - tangent + 90.0) % 180.0 - 90.0
    assert np.abs(error).max() < 0.02


def test_arcs_are_refused_with_their_lines() -> None:
    text = made(table("grblhal", "arcs"))[1].text
    lines = [number for number, line in enumerate(text.split(b"\n"), 1) if b"G3" in line]
    assert lines
    found = verify(text, LINE, (0.0, 0.0), table("grblhal"), BOARD).findings
    refused = [one for one in found if one.message.code == "rs274.arc-on-chord-machine"]
    assert [one.line for one in refused] == lines
    assert not has_faults(verify(text, LINE, (0.0, 0.0), table("grblhal", "arcs"), BOARD))


@pytest.mark.parametrize("dialect", ["grblhal", "linuxcnc"])
def test_the_stated_time_is_that_of_the_chords(dialect: str) -> None:
    machine, curved = table(dialect), table(dialect, "arcs")
    toolpath = made(machine)[0]
    times = durations(toolpath, machine)
    assert times.shape == (len(toolpath),)
    assert duration(toolpath, machine) == pytest.approx(times.sum())
    usual = durations(toolpath, curved)
    arcs = toolpath.bulge != 0.0
    assert times[~arcs].sum() == pytest.approx(usual[~arcs].sum(), rel=0.01)
    if dialect == "linuxcnc":
        # It slows down at each joint of two moves in which C turns.
        assert times[arcs].sum() > 1.3 * usual[arcs].sum()
    else:
        # Speeds may jump a little where chords meet; on an arc the acceleration is limited.
        assert times[arcs].sum() == pytest.approx(usual[arcs].sum(), rel=0.1)
        assert times[arcs].sum() != pytest.approx(usual[arcs].sum(), rel=0.01)
