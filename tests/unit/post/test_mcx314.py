"""Programs for an MCX314: lines written by hand, and what the chip cannot execute."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, cast

import numpy as np
import pytest

from knifetip import process
from knifetip.errors import ProgramError
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.library import load
from knifetip.model.machine import Machine
from knifetip.model.program import Program
from knifetip.model.toolpath import Motion, Toolpath

TABLE = load.machine("v-groove-table")
WIRING = cast(Wiring, TABLE.controller)
#: tan(sweep / 4) of a quarter circle
QUARTER = math.tan(math.pi / 8.0)

Pose = tuple[float, float, float, float]
Row = tuple[Pose, float, Motion]

HEAD = """MCX314 1
PULSES X200 Y200 Z400 C100
GO Z8000
OUT 0 OFF
OUT 1 OFF
OUT 2 OFF
OSC OFF
"""
FOOT = "OUT 0 OFF\nOUT 1 OFF\nOUT 2 OFF\nOSC OFF\nEND\n"


def path(start: Pose, *rows: Row, feed: float = 24000.0, tool: int = 1) -> Toolpath:
    count = len(rows)
    return Toolpath(
        pose=np.array([start, *(row[0] for row in rows)]),
        bulge=np.array([row[1] for row in rows]),
        motion=np.array([row[2] for row in rows], np.uint8),
        feed=np.array([0.0 if row[2] == Motion.RAPID else feed for row in rows]),
        source=np.full(count, 7, np.int32),
        tool=np.full(count, tool, np.uint8),
        track=np.zeros(count, np.int32),
    )


def program(toolpath: Toolpath, machine: Machine = TABLE, tolerance: float = 0.01) -> Program:
    return process(toolpath, machine, tolerance=tolerance)


def with_wiring(**changes: Any) -> Machine:
    return replace(TABLE, controller=replace(WIRING, **changes))


#: Air move, plunge, edge, edge around a corner, lift, air move.
CUT = path(
    (0.0, 0.0, 20.0, 0.0),
    ((10.0, 20.0, 5.0, 0.0), 0.0, Motion.RAPID),
    ((10.0, 20.0, -0.3, 0.0), 0.0, Motion.PLUNGE),
    ((60.0, 20.0, -0.3, 0.0), 0.0, Motion.FEED),
    ((60.0, 20.0, 5.0, 0.0), 0.0, Motion.LIFT),
    ((0.0, 0.0, 20.0, 0.0), 0.0, Motion.RAPID),
)


def test_a_cut_is_written_as_expected_by_hand() -> None:
    made = program(CUT)
    body = """; station 1 Oscillating knife
OUT 0 ON
OSC ON
DWELL 150
GO X2000 Y4000 C0
GO Z2000
LINE Z-2120 V160000
LINE X10000 V80000
LINE Z2120 V160000
GO Z8000
GO X0 Y0
"""
    assert made.text.decode() == HEAD + body + FOOT
    rows = made.source.tolist()
    assert rows[11:18] == [0, 0, 1, 2, 3, 4, 4]
    assert set(rows[:11] + rows[18:]) == {-1}


def test_the_datum_of_the_station_is_part_of_the_numbers() -> None:
    wheel = path(
        (0.0, 0.0, 20.0, 0.0),
        ((10.0, 20.0, 20.0, 90.0), 0.0, Motion.RAPID),
        ((10.0, 20.0, 1.0, 90.0), 0.0, Motion.PLUNGE),
        tool=2,
    )
    lines = program(wheel).text.decode().splitlines()
    # 60 mm along X and -1.5 mm along Z; the wheel does not oscillate.
    assert lines[8:14] == [
        "OUT 1 ON",
        "DWELL 150",
        "GO Z7400",
        "GO X14000 Y4000 C9000",
        "LINE Z-7600 V160000",
        "GO Z8000",
    ]


def test_an_arc_without_heading_is_one_segment_that_joins() -> None:
    half = path(
        (0.0, 0.0, 20.0, 0.0),
        ((10.0, 50.0, 20.0, 0.0), 0.0, Motion.RAPID),
        ((50.0, 50.0, 20.0, 0.0), 1.0, Motion.FEED),
        ((10.0, 50.0, 20.0, 0.0), 1.0, Motion.FEED),
        ((20.0, 50.0, 20.0, 0.0), -QUARTER, Motion.FEED),
    )
    lines = program(half).text.decode().splitlines()
    assert lines[12:14] == [
        "CCW X8000 Y0 I4000 J0 V80000",
        "CCW X-8000 Y0 I-4000 J0 V80000 JOIN",
    ]
    # A quarter circle begins at 45 degrees to its chord: not a joint.
    assert lines[14] == "CW X2000 Y0 I1000 J-1000 V80000"


def test_an_arc_with_heading_becomes_chords_within_the_tolerance() -> None:
    turning = path(
        (0.0, 0.0, 20.0, 0.0),
        ((60.0, 20.0, 20.0, 0.0), 0.0, Motion.RAPID),
        ((90.0, 50.0, 20.0, 90.0), QUARTER, Motion.FEED),
    )
    lines = program(turning).text.decode().splitlines()
    chords = [line for line in lines if line.startswith("LINE")]
    ways = np.array([[int(word[1:]) for word in line.split()[1:4]] for line in chords], np.float64)
    assert [line.endswith("JOIN") for line in chords] == [False] + [True] * (len(chords) - 1)
    points = np.vstack([np.zeros(3), np.cumsum(ways, axis=0)])
    assert points[-1].tolist() == [6000.0, 6000.0, 9000.0]
    middles = (points[1:] + points[:-1]) / 2.0 / (200.0, 200.0, 100.0)
    radius = np.hypot(middles[:, 0], middles[:, 1] - 30.0)
    # 0.001 mm, and half the diagonal of a pulse.
    assert np.abs(radius - 30.0).max() < 0.001 + 0.0036
    heading = np.degrees(np.arctan2(middles[:, 1] - 30.0, middles[:, 0])) + 90.0
    assert np.abs(heading - middles[:, 2]).max() < 0.05
    # 0.49 mm each.
    assert 90 < len(chords) < 100


def test_rounding_errors_do_not_add_up() -> None:
    rows: list[Row] = [
        ((0.3333 * n, 0.1667 * n, 1.0, 0.0), 0.0, Motion.FEED) for n in range(1, 901)
    ]
    long = path((0.0, 0.0, 1.0, 0.0), ((0.0, 0.0, 1.0, 0.0), 0.0, Motion.RAPID), *rows)
    lines = [line.split() for line in program(long).text.decode().splitlines()]
    ways = [[int(word[1:]) for word in line[1:3]] for line in lines if line[0] == "LINE"]
    assert len(ways) == 900
    assert np.sum(ways, axis=0).tolist() == [round(0.3333 * 900 * 200), round(0.1667 * 900 * 200)]


def test_short_lines_are_merged_if_they_are_straight() -> None:
    rows: list[Row] = [((0.08 * n, 0.0, 1.0, 0.0), 0.0, Motion.FEED) for n in range(1, 101)]
    lines = program(path((0.0, 0.0, 1.0, 0.0), ((0.0, 0.0, 1.0, 0.0), 0.0, Motion.RAPID), *rows))
    ways = [line.split() for line in lines.text.decode().splitlines() if line[:4] == "LINE"]
    # 0.08 mm at 400 mm/s last 0.2 ms; three of them last longer than 0.5 ms.
    assert len(ways) == 34
    assert sum(int(way[1][1:]) for way in ways) == 1600
    assert all(int(way[1][1:]) / int(way[2][1:]) >= WIRING.refill for way in ways[:-1])


def test_a_short_line_that_turns_is_slower_than_its_feed() -> None:
    bent = path(
        (0.0, 0.0, 1.0, 0.0),
        ((0.0, 0.0, 1.0, 0.0), 0.0, Motion.RAPID),
        ((0.15, 0.0, 1.0, 0.0), 0.0, Motion.FEED),
        ((0.8, 0.4, 1.0, 0.0), 0.0, Motion.FEED),
    )
    lines = program(bent, with_wiring(corner=60.0)).text.decode().splitlines()
    short, after = [line.split() for line in lines if line.startswith("LINE")]
    assert after[-1] == "JOIN"
    # 30 pulses would take 0.375 ms at 80,000 pulses/s.
    seconds = 30 / int(short[2][1:])
    assert short[1] == "X30"
    assert WIRING.refill <= seconds <= 1.1 * WIRING.refill
    # With a stop between them there is no deadline.
    assert b"LINE X30 V80000\n" in program(bent).text


def test_a_move_of_less_than_a_pulse_is_made_by_the_next_one() -> None:
    tiny = path(
        (0.0, 0.0, 1.0, 0.0),
        ((0.0, 0.0, 1.0, 0.0), 0.0, Motion.RAPID),
        ((0.002, 0.0, 1.0, 0.0), 0.0, Motion.FEED),
        ((5.002, 0.0, 1.0, 0.0), 0.0, Motion.FEED),
    )
    assert b"LINE X1000 V80000\n" in program(tiny).text
    assert program(tiny).text.count(b"LINE") == 1


def test_the_tool_is_not_lowered_for_less_than_a_pulse() -> None:
    def passes(x: float) -> int:
        made = path(
            (0.0, 0.0, 3.0, 0.0),
            ((0.0, 0.0, 3.0, 0.0), 0.0, Motion.RAPID),
            ((0.0, 0.0, 1.0, 0.0), 0.0, Motion.PLUNGE),
            ((x, 0.0, 1.0, 0.0), 0.0, Motion.FEED),
            ((x, 0.0, 3.0, 0.0), 0.0, Motion.LIFT),
        )
        return program(made).text.count(b"LINE Z")

    assert passes(0.002) == 0
    assert passes(0.004) == 2
    # A crease press has no move by design.
    press = path(
        (0.0, 0.0, 3.0, 0.0),
        ((0.0, 0.0, 3.0, 0.0), 0.0, Motion.RAPID),
        ((0.0, 0.0, 1.0, 0.0), 0.0, Motion.PLUNGE),
        ((0.0, 0.0, 3.0, 0.0), 0.0, Motion.LIFT),
    )
    assert program(press).text.count(b"LINE Z") == 2


def test_c_limits_the_speed() -> None:
    turning = path(
        (0.0, 0.0, 1.0, 0.0),
        ((0.0, 0.0, 1.0, 0.0), 0.0, Motion.RAPID),
        ((1.0, 0.0, 1.0, 90.0), 0.0, Motion.FEED),
    )
    # 1 mm takes 2.5 ms at the feed, and 90 degrees take 25 ms.
    assert b"LINE X200 C9000 V360000\n" in program(turning).text


@pytest.mark.parametrize(
    ("end", "feed", "words"),
    [
        ((5e4, 0.0, 1.0, 0.0), 24000.0, "needs 10,000,000 pulses, but .* at most 8,388,607"),
        ((10.0, 5.0, -2.0, 30.0), 24000.0, "moves four axes"),
        ((10.0, 0.0, 1.0, 0.0), 240000.0, "needs 800,000 pulses per second"),
        ((10.0, 0.0, 1.0, 0.0), 3.0, "needs 10 pulses per second"),
    ],
)
def test_what_the_chip_cannot_do_is_refused_with_its_place(
    end: Pose, feed: float, words: str
) -> None:
    cut = path(
        (0.0, 0.0, 1.0, 0.0),
        ((0.0, 0.0, 1.0, 0.0), 0.0, Motion.RAPID),
        (end, 0.0, Motion.FEED),
        feed=feed,
    )
    with pytest.raises(ProgramError, match=words) as refused:
        program(cut)
    assert "edge 7" in refused.value.text
    assert refused.value.hint


def test_a_machine_without_an_mcx314_is_refused() -> None:
    with pytest.raises(ProgramError, match="does not state how the axes are connected"):
        program(CUT, replace(TABLE, controller=None))


def test_comments_cannot_contain_an_instruction() -> None:
    text = process(CUT, TABLE, notes=["a\nEND; b", "", "x" * 90]).text.decode()
    assert text.splitlines()[1:3] == ["; a END b", "; " + "x" * 66]
