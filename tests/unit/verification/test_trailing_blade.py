"""The verifier's model of a free blade, compared with closed forms and with a plain integration."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from knifetip.library import load
from knifetip.model.machine import Machine
from knifetip.model.tool import Knife
from knifetip.verification.columns import F64
from knifetip.verification.reading.moves import Moves
from knifetip.verification.reading.rs274.reader import READER
from knifetip.verification.trailing_blade import TrailingBlade, follow_blades

BOARD = load.board("fbb-0.4")
#: Trail of the knife of the table (mm).
E = 0.75


def table(park: float = 0.0) -> Machine:
    machine = load.machine("drag-knife-table")
    (held,) = machine.stations
    assert isinstance(held.tool, Knife)
    knife = replace(held.tool, trail=E, park_heading=park)
    return replace(machine, stations=(replace(held, tool=knife),))


def followed(path: str, park: float = 0.0) -> tuple[Moves, TrailingBlade]:
    text = f"G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\nG0 Z10\nG0 X50 Y50\n{path}\nM30\n"
    machine = table(park)
    moves, faults = READER.read(text.encode(), machine, BOARD)
    assert not faults
    blade = follow_blades(moves, machine, BOARD)
    assert blade is not None
    return moves, blade


def last_tip(moves: Moves, blade: TrailingBlade) -> F64:
    heading = math.radians(blade.end[-1])
    result: F64 = moves.end[-1, :2] - E * np.array([math.cos(heading), math.sin(heading)])
    return result


@pytest.mark.parametrize("turn", [0.0, 20.0, 90.0, 170.0, -45.0])
@pytest.mark.parametrize("length", [0.1, 1.0, 5.0])
def test_on_a_line_the_tip_follows_the_tractrix(turn: float, length: float) -> None:
    moves, blade = followed(f"G1 Z0.2 F1000\nG1 X{50 + length}", park=turn)
    angle = 2.0 * math.atan(math.tan(math.radians(turn) / 2.0) * math.exp(-length / E))
    assert blade.end[-1] == pytest.approx(math.degrees(angle), abs=1e-9)
    # The tractrix in parameters: x = s - e tanh(t / e), y = e / cosh(t / e).
    beside = E * math.sin(angle)
    assert last_tip(moves, blade)[1] == pytest.approx(50.0 - beside, abs=1e-9)
    assert blade.tip[-1, 2:] == pytest.approx(last_tip(moves, blade), abs=1e-9)


@pytest.mark.parametrize("turn", [30.0, 90.0, 180.0, -120.0])
def test_a_swing_about_the_tip_turns_the_blade_in_place(turn: float) -> None:
    end = 50.0 - E + E * np.array([math.cos(math.radians(turn)), 0.0])[0]
    side = 50.0 + E * math.sin(math.radians(turn))
    code = "G3" if turn > 0.0 else "G2"
    moves, blade = followed(f"G1 Z0.2 F1000\n{code} X{end:.6f} Y{side:.6f} I{-E} J0 F1000")
    assert blade.end[-1] == pytest.approx(turn, abs=0.01)
    assert blade.still[-1]
    assert last_tip(moves, blade) == pytest.approx((50.0 - E, 50.0), abs=1e-4)


def test_on_a_circle_the_tip_runs_within_it() -> None:
    """The head on √(r² + e²) drags the tip on r."""
    radius = 5.0
    head = math.hypot(radius, E)
    start = 50.0 + E, 50.0  # the tip at (50, 50), the centre at (50, 55)
    moves, blade = followed(
        f"G0 X{start[0]} Y{start[1]}\nG1 Z0.2 F1000\nG3 X50 Y{55 + head:.6f} I{-E} J{radius} F1000"
    )
    away = np.hypot(blade.tip[:, 2] - 50.0, blade.tip[:, 3] - 55.0)
    assert np.abs(away - radius).max() < 2e-4
    assert not blade.still[-1]
    heading = math.radians(blade.end[-1])
    tip = moves.end[-1, :2] - E * np.array([math.cos(heading), math.sin(heading)])
    assert math.hypot(*(tip - (50.0, 55.0))) == pytest.approx(radius, abs=2e-4)


def test_a_blade_that_is_pushed_back_is_marked() -> None:
    _, blade = followed("G1 Z0.2 F1000\nG1 X55\nG1 X53")
    assert blade.pushed == pytest.approx([0.0] * (len(blade.pushed) - 1) + [2.0])
    _, blade = followed("G1 Z0.2 F1000\nG1 X52 Y52", park=20.0)
    assert blade.pushed.max() == 0.0


def test_in_the_air_the_blade_keeps_its_heading() -> None:
    _, blade = followed(
        "G1 Z0.2 F1000\nG1 Y60\nG1 Z10\nG0 X80 Y20\nG1 Z0.2\nG1 X80.001 Y20", park=90.0
    )
    assert blade.start[-2] == pytest.approx(90.0, abs=1e-6)
    assert blade.end[-1] == pytest.approx(90.0, abs=0.2)


def integrated(points: F64, heading: float) -> tuple[F64, float]:
    """Drag a tip behind an axis by small steps: the tip moves towards the axis, to the distance E.

    This is the definition of the tractrix, and shares nothing with the closed form.
    """
    tip = points[0] - E * np.array([math.cos(heading), math.sin(heading)])
    for first, last in pairwise(points):
        count = max(1, math.ceil(math.hypot(*(last - first)) / 2e-5))
        for step in range(1, count + 1):
            axis = first + (last - first) * step / count
            away = axis - tip
            tip = axis - away * (E / math.hypot(*away))
    away = points[-1] - tip
    return tip, math.degrees(math.atan2(away[1], away[0]))


@pytest.mark.parametrize("seed", range(4))
def test_a_plain_integration_agrees(seed: int) -> None:
    random = np.random.default_rng(seed)
    points = [np.array([50.0, 50.0])]
    direction = random.uniform(0.0, 360.0)
    for _ in range(6):
        direction += random.uniform(-120.0, 120.0)
        step = random.uniform(0.2, 2.0)
        angle = math.radians(direction)
        points.append(np.round(points[-1] + step * np.array([math.cos(angle), math.sin(angle)]), 4))
    park = float(random.uniform(-90.0, 90.0))
    lines = "\n".join(f"G1 X{x:.4f} Y{y:.4f}" for x, y in points[1:])
    moves, blade = followed(f"G1 Z0.2 F1000\n{lines}", park)
    tip, heading = integrated(np.array(points), math.radians(park))
    assert last_tip(moves, blade) == pytest.approx(tip, abs=2e-4)
    assert (blade.end[-1] - heading + 180.0) % 360.0 - 180.0 == pytest.approx(0.0, abs=0.05)
