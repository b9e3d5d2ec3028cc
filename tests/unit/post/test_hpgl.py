"""HPGL programs of small toolpaths, compared with programs written by hand (unit 0.025 mm)."""

from __future__ import annotations

import cmath
import itertools
import math
import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip.errors import ProgramError
from knifetip.geometry import arc
from knifetip.languages.hpgl.plotter import Plotter
from knifetip.library import load
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.post.emit import process
from tests.support.shapes import toolpath as toolpath_of

MACHINE = load.machine("flat-cutter-hpgl")
R, P, F, S, L = Motion.RAPID, Motion.PLUNGE, Motion.FEED, Motion.SWIVEL, Motion.LIFT
#: Knife and creasing tool (mm/min): 40 and 30 cm/s.
CUT, CREASE = 24000.0, 18000.0
#: Station, motion, x, y, z, bulge and feed of the end of a move.
Move = tuple[int, Motion, float, float, float, float, float]


def strokes(
    station: int,
    z: float,
    feed: float,
    *points: tuple[float, float],
    bulge: float = 0.0,
    above: float = 5.0,
) -> list[Move]:
    """Return the moves along the points at height ``z``, with a plunge before and a lift after."""
    moves: list[Move] = [(station, R, *points[0], 5, 0, 0), (station, P, *points[0], z, 0, 6000)]
    moves += [(station, F, *point, z, bulge, feed) for point in points[1:]]
    return [*moves, (station, L, *points[-1], above, 0, 6000)]


SQUARE = strokes(1, -0.3, CUT, (20, 20), (120, 20), above=2.4)


def toolpath(*moves: Move, start: tuple[float, float] = (0.0, 0.0)) -> Toolpath:
    pose = np.zeros((len(moves) + 1, 4))
    pose[0] = (*start, 5.0, 0.0)
    pose[1:, :3] = [move[2:5] for move in moves]
    rows = [(Motion(motion), feed, station) for station, motion, *_, feed in moves]
    return toolpath_of(pose, rows, bulge=[move[5] for move in moves])


def instructions(path: Toolpath, machine: Machine = MACHINE, **options: Any) -> list[str]:
    return process(path, machine, **options).text.decode("ascii").splitlines()


def with_device(**changes: Any) -> Machine:
    plotter = MACHINE.controller
    assert isinstance(plotter, Plotter)
    device = replace(plotter.device, **changes)
    pens = plotter.pens if device.force else tuple(replace(pen, force=0) for pen in plotter.pens)
    return replace(MACHINE, controller=Plotter(device, pens))


def test_a_cut_is_a_travel_a_plunge_and_a_work_move() -> None:
    assert instructions(toolpath(*SQUARE)) == [
        "IN;", "PA;", "PU;", "SP1;", "FS30;", "VS40;",
        "PU800,800;", "PD;", "PD4800,800;", "PU;",
        "PU;", "SP0;",
    ]  # fmt: skip


def test_each_line_has_the_row_of_its_move() -> None:
    program = process(toolpath(*SQUARE), MACHINE)
    assert program.source.tolist() == [-1] * 6 + [0, 1, 2, 3] + [-1, -1]
    assert program.dialect == "hpgl"


def test_each_kind_of_work_of_a_station_selects_its_pen() -> None:
    lines = instructions(
        toolpath(
            *strokes(2, 0.1, CREASE, (10, 10), (10, 50)),
            *strokes(1, 0.2, CUT, (30, 10), (30, 50), above=2.4),
            (1, R, 20, 20, 2.4, 0, 0),
            *SQUARE[1:],
        )
    )
    selected = [line for line in lines if line[:2] in ("SP", "FS", "VS")]
    assert selected == [
        "SP2;", "FS24;", "VS30;", "SP3;", "FS12;", "VS40;", "SP1;", "FS30;", "VS40;", "SP0;",
    ]  # fmt: skip
    # The tool is lifted and changed before the head travels to the next cut.
    at = lines.index("SP1;")
    assert lines[at - 2 : at] == ["PU;", "PU;"]
    assert lines[at + 3 : at + 5] == ["PU800,800;", "PD;"]


def test_positions_are_rounded_independently_and_moves_of_no_length_are_omitted() -> None:
    lines = instructions(toolpath(*strokes(1, -0.3, CUT, (20.013, 20), (20.02, 20), (40.03, 20))))
    assert lines[6:10] == ["PU801,800;", "PD;", "PD1601,800;", "PU;"]


def test_the_tool_is_not_lowered_for_a_pass_that_rounds_to_a_point() -> None:
    program = process(
        toolpath(
            *strokes(1, -0.3, CUT, (20.001, 20), (20.008, 20), (20.008, 20.005), above=2.4),
            *SQUARE,
        ),
        MACHINE,
    )
    assert program.text.decode("ascii").splitlines()[6:-2] == [
        "PU800,800;", "PD;", "PD4800,800;", "PU;",
    ]  # fmt: skip
    assert program.source.tolist()[6:-2] == [0, 6, 7, 8]


def test_an_arc_becomes_chords_within_half_the_tolerance() -> None:
    half = toolpath(*strokes(1, -0.3, CUT, (100, 100), (100, 140), bulge=1.0))
    lines = [line for line in instructions(half) if line.startswith("PD") and "," in line]
    points = np.array([[100.0, 100.0]] + [
        [float(number) / 40.0 for number in line[2:-1].split(",")] for line in lines
    ])  # fmt: skip
    # The centre is (100, 120); every point is within the rounding of the arc.
    radius = np.hypot(points[:, 0] - 100.0, points[:, 1] - 120.0)
    assert np.abs(radius - 20.0).max() <= 0.0177 + 1e-9
    middle = (points[1:] + points[:-1]) / 2.0
    sagitta = 20.0 - np.hypot(middle[:, 0] - 100.0, middle[:, 1] - 120.0)
    assert sagitta.max() <= 0.005 + 0.0177 + 1e-9
    # 0.005 mm on a radius of 20 mm: chords of about 2.6°, 71 in half a circle.
    assert 60 <= len(lines) <= 90


@pytest.mark.parametrize("radius", [6.1, 9.3, 11.07, 13.11, 18.53, 25.77])
@pytest.mark.parametrize("depths", [1, 7, 11, 16, 23, 31, 40, 47])
def test_the_creasing_tool_turns_by_little_where_two_chords_meet(
    radius: float, depths: int
) -> None:
    start, finish = np.array([100.0, 100.0]), np.array([100.0, 100.0 + radius])
    share = np.arange(depths + 1) / depths
    _, end, bulge = arc.sub_arc(
        np.tile(start, (depths, 1)),
        np.tile(finish, (depths, 1)),
        np.full(depths, math.sqrt(0.5)),
        share[:-1],
        share[1:],
    )
    height = 0.2 - 0.01 * np.arange(depths)
    rows: list[Move] = [(2, P, 100, 100, 0.2, 0, 6000)]
    for (x, y), bent, z in zip(end.tolist(), bulge.tolist(), height.tolist(), strict=True):
        rows += [(2, F, x, y, z, bent, CREASE), (2, P, x, y, z - 0.01, 0, 6000)]
    x, y = finish.tolist()
    lines = instructions(toolpath((2, R, 100, 100, 5, 0, 0), *rows[:-1], (2, L, x, y, 5, 0, 6000)))
    points = [(4000, 4000)] + [
        tuple(map(int, line[2:-1].split(","))) for line in lines if re.match("PD[0-9]", line)
    ]
    assert points[-1] == (round(40.0 * x), round(40.0 * y))
    steps = [complex(*end) - complex(*start) for start, end in itertools.pairwise(points)]
    for before, after in itertools.pairwise(steps):
        turn = abs(math.degrees(cmath.phase(after / before)))
        # The rounding of both ends of a chord turns it by up to one diagonal of the grid.
        unsure = sum(math.degrees(math.sqrt(2.0) / abs(step)) for step in (before, after))
        assert turn <= 1.0 + unsure


def test_only_instructions_that_the_device_supports_are_written() -> None:
    bare = instructions(toolpath(*SQUARE), with_device(speed=None, force=None))
    assert bare == [
        "IN;", "PA;", "PU;", "SP1;", "PU800,800;", "PD;", "PD4800,800;", "PU;", "PU;", "SP0;",
    ]  # fmt: skip
    notes = ['a "note"; with\nESC \x1b.R', "placement X20.0000 Y20.0000"]
    assert instructions(toolpath(*SQUARE), notes=notes) == instructions(toolpath(*SQUARE))
    lines = instructions(toolpath(*SQUARE), with_device(comments=True), notes=notes)
    assert lines[:4] == [
        "IN;", 'CO"a note with ESC .R";', 'CO"placement X20.0000 Y20.0000";', "PA;",
    ]  # fmt: skip


def test_positions_are_relative_to_the_origin_of_the_device() -> None:
    centred = with_device(zero=(650.0, 450.0), area=(-26000, -18000, 26000, 18000))
    lines = instructions(toolpath(*SQUARE), centred)
    assert lines[6:9] == ["PU-25200,-17200;", "PD;", "PD-21200,-17200;"]


def test_the_speed_is_written_when_it_changes() -> None:
    slower = [*SQUARE[:3], (1, F, 120, 60, -0.3, 0, 12000.0), (1, F, 60, 60, -0.3, 0, 12000.0)]
    lines = instructions(toolpath(*slower, (1, L, 60, 60, 2.4, 0, 6000)))
    assert lines[5:12] == [
        "VS40;", "PU800,800;", "PD;", "PD4800,800;", "VS20;", "PD4800,2400;", "PD2400,2400;",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("moves", "what"),
    [
        (
            [*SQUARE[:2], (1, F, 120, 20, -0.3, 0, 24100.0), SQUARE[3]],
            "multiples of 600 mm/min from 600 to 48,000 mm/min",
        ),
        (
            [*SQUARE[:2], (1, F, 120, 20, -0.2, 0, CUT), SQUARE[3]],
            "changes the depth of the tool during a cut",
        ),
        ([SQUARE[0], (1, P, 21, 20, -0.3, 0, 6000)], "along a slope"),
        (
            [*SQUARE[:2], (1, L, 20, 20, 5, 0, 6000)],
            "presses a crease that is too short to be rolled",
        ),
        ([*SQUARE[:3], (1, S, 121, 20, -0.3, 0, CUT)], "rotates the head"),
        (
            [*SQUARE, (2, P, 120, 20, 0.1, 0, 6000)],
            "no rapid move to the start of the cut precedes it",
        ),
        ([SQUARE[0]], "never lowers a tool"),
    ],
)
def test_a_move_that_hpgl_cannot_express_is_refused(moves: list[Move], what: str) -> None:
    with pytest.raises(ProgramError, match=what):
        process(toolpath(*moves), MACHINE)


def test_a_kind_of_work_without_a_pen_is_refused() -> None:
    plotter = MACHINE.controller
    assert isinstance(plotter, Plotter)
    bare = replace(MACHINE, controller=replace(plotter, pens=plotter.pens[1:]))
    with pytest.raises(ProgramError, match="no pen to the operation cut with station 1"):
        process(toolpath(*SQUARE), bare)
