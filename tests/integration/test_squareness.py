"""Programs for machines whose axes are not square, in each controller language.

The positions in the programs are read, put on a leaning table and compared with the drawing here,
without the code of the program.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from shapely import LineString, MultiLineString, Point, box, points

from knifetip import compensate, plan, process, sequence
from knifetip.errors import TravelExceeded
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine, Zone
from knifetip.model.toolpath import Toolpath
from knifetip.model.verdict import Verdict
from knifetip.sequencing.duration import durations
from knifetip.verification.verify import verify
from tests.support.shapes import dieline, edges

QUARTER = math.tan(math.pi / 8)
DEGREES = 89.9
#: Machine and language; the tip of the station that cuts is on the axis of the head.
MACHINES = [
    ("laser-table", "grblhal"),
    ("laser-table", "linuxcnc"),
    ("demo-table", "grblhal"),
    ("demo-table", "linuxcnc"),
    ("fine-router-table", "linuxcnc"),
    ("v-groove-table", "mcx314"),
    ("flat-cutter-hpgl", "hpgl"),
    ("drag-knife-hpgl", "hpgl"),
    ("drag-knife-table", "grblhal"),
]
#: Tools whose head follows the drawn line.
ON_LINE = [MACHINES[2], MACHINES[3], MACHINES[5], MACHINES[6]]


def circle(x: float, y: float, r: float) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    corners = [(x + r, y), (x, y + r), (x - r, y), (x, y - r)]
    return list(zip(corners, [*corners[1:], corners[0]], strict=True))


#: A blank with rounded corners of 20 mm and circles of 40, 12 and 5 mm; folds on it.
CORNERS = [
    *(((70, 50), (530, 50)), ((530, 50), (550, 70)), ((550, 70), (550, 330))),
    *(((550, 330), (530, 350)), ((530, 350), (70, 350)), ((70, 350), (50, 330))),
    *(((50, 330), (50, 70)), ((50, 70), (70, 50))),
]
CUTS = edges(*CORNERS, *circle(150, 200, 40), *circle(400, 150, 12), *circle(480, 300, 5))
BENT = dict.fromkeys([1, 3, 5, 7, *range(8, 20)], QUARTER)
FOLDS = edges(((300, 50), (300, 350)), ((300, 200), (550, 200)))
CIRCLES = [((150, 200), 40.0), ((400, 150), 12.0), ((480, 300), 5.0)]
DRAWN = [
    *(Point(centre).buffer(radius, quad_segs=300).exterior for centre, radius in CIRCLES),
    box(70, 70, 530, 330).buffer(20.0, quad_segs=300).exterior,
]


def table(name: str, language: str, degrees: float = DEGREES, **changes: Any) -> Machine:
    machine = replace(load.machine(name), squareness=degrees, **changes)
    return machine if language == machine.dialect else replace(machine, dialect=language)


def board_of(machine: Machine) -> Board:
    return load.board(
        "fbb-0.4" if "drag" in machine.name or "hpgl" in machine.name else "solid-1.0"
    )


def carton(machine: Machine) -> Dieline:
    folds = [(LineType.CREASE, FOLDS)] if machine.station_for(LineType.CREASE) else []
    return dieline((LineType.CUT, CUTS), *folds, bulge=BENT)


def planned(machine: Machine) -> Toolpath:
    made = [compensate(one) for one in plan(carton(machine), machine, board_of(machine))]
    return sequence(made, machine)


def judged(text: bytes, machine: Machine) -> Verdict:
    return verify(text, carton(machine), (0.0, 0.0), machine, board_of(machine))


@pytest.mark.parametrize("degrees", [DEGREES, 90.2, 89.2])
@pytest.mark.parametrize(("name", "language"), MACHINES)
def test_a_carton_with_curves_is_accepted(name: str, language: str, degrees: float) -> None:
    machine = table(name, language, degrees)
    found = judged(process(planned(machine), machine).text, machine)
    assert found.accepted, [one.text for one in found.findings if one.refuses]
    square = table(name, language, 90.0)
    usual = judged(process(planned(square), square).text, square)
    # Division of arcs and ellipse take less than a tenth of the tolerance; rounded points of a
    # plotter, other ones, are up to 0.018 mm beside their path.
    more = 0.003 if language == "hpgl" else 0.001
    assert found.deviation.max() < usual.deviation.max() + more


@pytest.mark.parametrize(("name", "language"), MACHINES)
@pytest.mark.parametrize("corrected", [90.0, 180.0 - DEGREES])
def test_a_program_without_the_correction_or_with_the_wrong_sign_is_refused(
    name: str, language: str, corrected: float
) -> None:
    machine = table(name, language)
    text = process(planned(machine), replace(machine, squareness=corrected)).text
    found = judged(text, machine)
    assert not found.accepted
    # 350 mm above the origin, the tip is 350 cos 89.9° = 0.61 mm beside its line, or twice that.
    assert "verify.beside-line" in {one.message.code for one in found.findings}


def test_the_judge_does_not_use_the_conversion_of_the_program(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    machine = table("laser-table", "grblhal")
    right = Machine.to_axes, Machine.to_sheet
    assert judged(process(planned(machine), machine).text, machine).accepted
    # Both directions with the wrong sign, so that they agree.
    for name, function in zip(("to_axes", "to_sheet"), right, strict=True):
        monkeypatch.setattr(
            Machine,
            name,
            lambda self, x, y, made=function: made(
                replace(self, squareness=180.0 - self.squareness), x, y
            ),
        )
    assert not judged(process(planned(machine), machine).text, machine).accepted


def test_an_angle_that_does_not_matter_needs_no_correction() -> None:
    machine = table("laser-table", "grblhal", 89.9999)
    text = process(planned(machine), replace(machine, squareness=90.0)).text
    # 350 cos 89.9999° = 0.0006 mm
    assert judged(text, machine).accepted


# -- positions in programs ------------------------------------------------------------------------


def gcode_paths(text: str, datum: tuple[float, float]) -> Iterator[tuple[float, F64]]:
    """Yield the height of the tip and points of each feed move, (k, 2); arcs in steps."""
    at: dict[str, float] = {}
    for line in text.splitlines():
        words = {word[0]: float(word[1:]) for word in re.findall(r"[A-Z]-?[\d.]+", line)}
        code = re.search(r"\bG([0-3])\b", line)
        if code is None or line.startswith("("):
            continue
        before = dict(at)
        at |= {letter: words[letter] for letter in "XYZ" if letter in words}
        if code[1] == "0" or "X" not in before:
            continue
        start = np.array([before["X"], before["Y"]])
        end = np.array([at["X"], at["Y"]])
        if code[1] == "1":
            path = np.linspace(start, end, 2)
        else:
            centre = start + np.array([words["I"], words["J"]])
            first, last = (math.atan2(*(one - centre)[::-1]) for one in (start, end))
            side = 1.0 if code[1] == "3" else -1.0
            turn = side * (side * (last - first) % math.tau)
            angle = first + turn * np.linspace(0.0, 1.0, 40)
            path = centre + math.dist(start, centre) * np.column_stack(
                [np.cos(angle), np.sin(angle)]
            )
        yield at["Z"], path - datum


def pulse_paths(text: str) -> Iterator[tuple[float, F64]]:
    """The same for the segments of an MCX314, whose program has no arcs along which C turns."""
    at = np.zeros(4)
    for line in text.splitlines():
        words = dict(re.findall(r"\b([XYZC])(-?\d+)", line))
        moved = np.array([float(words.get(letter, 0)) for letter in "XYZC"])
        assert not line.startswith(("CW", "CCW"))
        if line.startswith("GO"):
            at = np.where([letter in words for letter in "XYZC"], moved, at)
        elif line.startswith("LINE"):
            before, at = at, at + moved
            yield at[2] / 400.0, np.stack([before[:2], at[:2]]) / 200.0


def plotter_paths(text: str, machine: Machine) -> Iterator[tuple[float, F64]]:
    device: Any = machine.controller
    at = np.zeros(2)
    for name, x, y in re.findall(r"(PU|PD)(-?\d+),(-?\d+);", text):
        before, at = at, np.array([int(x), int(y)]) / device.device.units + device.device.zero
        if name == "PD":
            yield 0.0, np.stack([before, at])


def paths_of(text: bytes, machine: Machine) -> Iterator[tuple[float, F64]]:
    if machine.dialect == "mcx314":
        return pulse_paths(text.decode())
    if machine.dialect == "hpgl":
        return plotter_paths(text.decode(), machine)
    return gcode_paths(text.decode(), (0.0, 0.0))


@pytest.mark.parametrize(("name", "language"), ON_LINE)
def test_positions_on_a_leaning_table_lie_on_the_drawing(name: str, language: str) -> None:
    machine = table(name, language)
    cuts = dieline((LineType.CUT, CUTS), bulge=BENT)
    board = board_of(machine)
    path = sequence([compensate(one) for one in plan(cuts, machine, board)], machine)
    text = process(path, machine).text
    assert verify(text, cuts, (0.0, 0.0), machine, board).accepted
    lean = np.array(
        [[1.0, 0.0], [math.cos(math.radians(DEGREES)), math.sin(math.radians(DEGREES))]]
    )
    lines = [
        one @ lean
        for z, one in paths_of(text, machine)
        if z < 0.1 and np.ptp(one, axis=0).max() > 1e-3
    ]
    # A point of HPGL is up to half a unit of 0.025 mm off in X and in Y.
    rounding = 0.018 if language == "hpgl" else 0.0
    drawn = MultiLineString(DRAWN)
    made = np.concatenate(lines)
    assert drawn.distance(points(made)).max() < 0.01 + rounding
    assert drawn.distance(points(made @ np.linalg.inv(lean))).max() > 0.3
    # And everything that is drawn is made.
    reached = MultiLineString([LineString(one) for one in lines])
    along = [one.interpolate(np.linspace(0.0, 1.0, 100), normalized=True) for one in DRAWN]
    assert reached.distance(np.concatenate(along)).max() < 0.01 + rounding


# -- limits, zones, times -------------------------------------------------------------------------


def test_limits_are_those_of_the_axes() -> None:
    machine = table("laser-table", "grblhal", 90.1)
    machine = replace(machine, stations=machine.stations[1:])
    # The right side, at x = 550, ends at y = 330: X goes to 550 - 330 cot 90.1° = 550.576, and the
    # beam, of 0.2 mm, on the outside of the blank to 550.676.
    near, beyond = (replace(machine, x=replace(machine.x, high=high)) for high in (550.7, 550.6))
    text = process(planned(near), near).text
    assert judged(text, near).accepted
    past = [one for one in judged(text, beyond).findings if one.refuses]
    assert {one.message.code for one in past} >= {"verify.beyond-travel"}
    with pytest.raises(TravelExceeded, match=r"0\.08 mm beyond the upper end of .*X"):
        planned(beyond)


def test_the_head_parks_where_its_axes_can_be() -> None:
    low = replace(load.machine("laser-table").x, low=0.0)
    machine = table("laser-table", "grblhal", x=low, y=low)
    stations = tuple(replace(one, y=-30.0) for one in machine.stations)
    machine = replace(machine, stations=stations)
    # Y is at 0 when the beam is 30 mm above the origin; X would be at -0.05 if x were 0.
    angle = math.radians(DEGREES)
    parked = planned(machine).pose[-1, :2]
    assert parked == pytest.approx((30.0 * math.cos(angle), 30.0 * math.sin(angle)))


@pytest.mark.parametrize(("gap", "is_met"), [(1.0, False), (-1.0, True)])
def test_zones_lie_on_the_sheet(gap: float, is_met: bool) -> None:
    machine = table("laser-table", "grblhal", 89.0)
    stations = tuple(replace(one, envelope=10.0) for one in machine.stations)
    # Beside the upper left of the blank, where X is at 50 - 330 cot 89° = 44.24.
    zone = Zone("clamp", 0.0, 300.0, 40.0 - gap, 20.0, 5.0)
    text = process(planned(machine), machine).text
    found = judged(text, replace(machine, stations=stations, zones=(zone,)))
    assert ("verify.in-zone" in {one.message.code for one in found.findings}) == is_met


def test_times_have_the_rows_of_the_toolpath() -> None:
    machine, square = table("demo-table", "grblhal", 89.2), table("demo-table", "grblhal", 90.0)
    path = planned(square)
    leaning, usual = durations(path, machine), durations(path, square)
    assert len(leaning) == len(path)
    # Along the diagonals, axes travel up to cos 89.2° / 2 = 0.7 % farther.
    assert leaning.sum() == pytest.approx(usual.sum(), rel=0.02)


def test_program_lines_name_rows_of_the_toolpath() -> None:
    machine = table("laser-table", "grblhal")
    path = planned(machine)
    program = process(path, machine)
    made = np.unique(program.source[program.source >= 0])
    assert made.max() < len(path)
    assert set(np.flatnonzero(path.bulge)) <= set(made.tolist())
    counts = np.bincount(program.source[program.source >= 0])
    # The quarters of 40 mm are several arcs, each with its own line.
    assert counts[np.flatnonzero(path.bulge)].max() >= 3
