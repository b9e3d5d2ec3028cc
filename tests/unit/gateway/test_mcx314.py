"""Segments for an MCX314, and the registers of the simulated chip."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from knifetip.errors import ControllerError, ProgramError
from knifetip.gateway.mcx314 import figures
from knifetip.gateway.mcx314.chip import Chip, ChipRefused
from knifetip.gateway.mcx314.feeder import feed
from knifetip.gateway.mcx314.segments import Segment, Wiring, encode
from knifetip.gateway.motion import Limits
from knifetip.library import load
from knifetip.model.toolpath import Motion, Toolpath

LIMITS = Limits.of(load.machine("demo-table"))
WIRING = Wiring((100.0, 100.0, 100.0, 10.0), multiple=10, refill=0.001, corner=5.0)
TOLERANCE = 0.01
#: tan(sweep / 4) of a quarter circle
QUARTER = math.tan(math.pi / 8.0)

Row = tuple[tuple[float, float, float, float], float, Motion]


def path(start: tuple[float, float, float, float], *rows: Row, feed: float = 6000.0) -> Toolpath:
    count = len(rows)
    return Toolpath(
        pose=np.array([start, *(row[0] for row in rows)]),
        bulge=np.array([row[1] for row in rows]),
        motion=np.array([row[2] for row in rows], np.uint8),
        feed=np.array([0.0 if row[2] == Motion.RAPID else feed for row in rows]),
        source=np.zeros(count, np.int32),
        tool=np.ones(count, np.uint8),
        track=np.zeros(count, np.int32),
    )


#: Air move, plunge, edge, quarter circle with C along it, edge, lift.
CUT = path(
    (0.0, 0.0, 20.0, 0.0),
    ((10.005, 20.0, 5.0, 0.0), 0.0, Motion.RAPID),
    ((10.005, 20.0, -0.3, 0.0), 0.0, Motion.PLUNGE),
    ((60.0, 20.0, -0.3, 0.0), 0.0, Motion.FEED),
    ((90.0, 50.0, -0.3, 90.0), QUARTER, Motion.FEED),
    ((90.0, 80.0, -0.3, 90.0), 0.0, Motion.FEED),
    ((90.0, 80.0, 20.0, 90.0), 0.0, Motion.LIFT),
)


class SlowBus:
    """A bus to a chip on which each write takes time."""

    def __init__(self, chip: Chip, seconds: float) -> None:
        self.chip = chip
        self.seconds = seconds
        self.trace: list[tuple[float, ...]] = []

    def write(self, register: int, word: int) -> None:
        self.chip.advance(self.seconds)
        self.chip.write(register, word)

    def read(self, register: int) -> int:
        return self.chip.read(register)

    def wait(self) -> None:
        self.chip.advance(0.0002)
        self.trace.append((self.chip.time, *(float(self.chip.position(axis)) for axis in range(4))))


def run(segments: Sequence[Segment], start: Sequence[float], seconds: float = 1e-5) -> SlowBus:
    chip = Chip(WIRING.multiple)
    for axis, (position, scale) in enumerate(zip(start, WIRING.pulses, strict=True)):
        write(chip, figures.SET_POSITION, axis, round(position * scale))
    bus = SlowBus(chip, seconds)
    feed(segments, bus, bus.wait)
    return bus


def write(chip: Chip, command: int, axis: int, value: int) -> None:
    chip.write(figures.WR6, value & 0xFFFF)
    chip.write(figures.WR7, value >> 16 & 0xFFFF)
    chip.write(figures.WR0, 1 << (8 + axis) | command)


def test_a_cut_with_a_tangential_arc_runs_along_its_path_without_a_stop() -> None:
    segments = encode(CUT, WIRING, LIMITS, tolerance=TOLERANCE)
    bus = run(segments, CUT.pose[0])
    end = [bus.chip.position(axis) / scale for axis, scale in enumerate(WIRING.pulses)]
    assert end == pytest.approx([90.0, 80.0, 20.0, 90.0], abs=1e-9)
    # Two lines of the rapid, plunge, cut and lift: each ends with a stop.
    assert bus.chip.stops == 5
    trace = np.array(bus.trace)[:, 1:] / WIRING.pulses
    cut = trace[trace[:, 2] == -0.3]
    on_arc = cut[(cut[:, 0] > 60.0) & (cut[:, 1] < 50.0)]
    assert len(on_arc) > 100
    radius = np.hypot(on_arc[:, 0] - 60.0, on_arc[:, 1] - 50.0)
    # Chords within the tolerance, and less than a pulse of rounding along each axis.
    assert np.abs(radius - 30.0).max() < TOLERANCE + 0.015
    heading = np.degrees(np.arctan2(on_arc[:, 1] - 50.0, on_arc[:, 0] - 60.0)) + 90.0
    assert np.abs(heading - on_arc[:, 3]).max() < 0.3
    lengths = 49.995 + math.pi / 2.0 * 30.0 + 30.0
    times = np.array(bus.trace)[trace[:, 2] == -0.3, 0]
    assert times[-1] - times[0] == pytest.approx(lengths / 100.0, rel=0.01)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_an_arc_without_heading_is_one_segment_and_keeps_its_speed(side: float) -> None:
    half = path(
        (10.0, 50.0, -1.0, 0.0),
        ((50.0, 50.0, -1.0, 0.0), side, Motion.FEED),
        ((10.0, 50.0, -1.0, 0.0), side, Motion.FEED),
    )
    segments = encode(half, WIRING, LIMITS, tolerance=TOLERANCE)
    assert [segment.command for segment in segments] == [0x33 if side > 0 else 0x32] * 2
    assert [segment.joined for segment in segments] == [False, True]
    bus = run(segments, half.pose[0])
    trace = np.array(bus.trace)
    radius = np.hypot(trace[:, 1] - 3000.0, trace[:, 2] - 5000.0)
    assert np.abs(radius - 2000.0).max() <= 1.0
    assert trace[:, 2].min() < 3100.0
    assert trace[:, 2].max() > 6900.0
    # A counter-clockwise half circle from the left runs below the centre.
    assert (trace[len(trace) // 4, 2] < 5000.0) == (side > 0)
    assert trace[-1, 0] == pytest.approx(2.0 * math.pi * 20.0 / 100.0, rel=0.01)
    assert bus.chip.stops == 1
    assert (bus.chip.position(0), bus.chip.position(1)) == (1000, 5000)


def test_rounding_errors_do_not_add_up() -> None:
    rows: list[Row] = [
        ((0.3333 * n, 0.1667 * n, -1.0, 0.0), 0.0, Motion.FEED) for n in range(1, 1001)
    ]
    long = path((0.0, 0.0, -1.0, 0.0), *rows)
    segments = encode(long, WIRING, LIMITS, tolerance=TOLERANCE)
    assert len(segments) == 1000
    assert sum(segment.finish[0] for segment in segments) == 33330
    assert sum(segment.finish[1] for segment in segments) == 16670
    bus = run(segments, long.pose[0])
    assert bus.chip.position(0) == 33330
    assert bus.chip.stops == 1


def test_a_line_deviates_by_at_most_half_a_pulse() -> None:
    chip = Chip(1)
    write(chip, figures.SET_SPEED, 0, 1000)
    for axis, finish in ((0, 700), (1, -333), (3, 41)):
        write(chip, figures.SET_FINISH, axis, finish)
    chip.write(figures.WR5, 0 | 1 << 2 | 3 << 4)
    chip.write(figures.WR0, figures.LINE_3)
    for step in range(1, 701):
        chip.advance(0.001)
        assert chip.position(0) in (step - 1, step)
        for axis, finish in ((1, -333), (3, 41)):
            assert abs(chip.position(axis) - finish * chip.position(0) / 700) <= 0.5
    chip.advance(0.01)
    assert not chip.read(figures.RR0) & figures.DRIVING
    assert [chip.position(axis) for axis in range(4)] == [700, -333, 0, 41]
    chip.write(figures.WR0, 1 << 9 | figures.GET_POSITION)
    assert chip.read(figures.RR6) | chip.read(figures.RR7) << 16 == -333 & 0xFFFFFFFF


def started(pulses: int = 100) -> Chip:
    """Return a chip that drives a line of ``pulses`` milliseconds."""
    chip = Chip(1)
    write(chip, figures.SET_SPEED, 0, 1000)
    write(chip, figures.SET_FINISH, 0, pulses)
    chip.write(figures.WR5, 1 << 2)
    chip.write(figures.WR0, figures.LINE_2)
    return chip


def test_a_segment_that_is_written_in_time_follows_without_a_stop() -> None:
    chip = started()
    chip.advance(0.05)
    assert chip.read(figures.RR0) & figures.NEXT
    write(chip, figures.SET_FINISH, 0, 50)
    chip.write(figures.WR0, figures.LINE_2)
    assert not chip.read(figures.RR0) & figures.NEXT
    with pytest.raises(ChipRefused, match="written already"):
        chip.write(figures.WR0, figures.LINE_2)
    with pytest.raises(ChipRefused, match="overwritten"):
        write(chip, figures.SET_FINISH, 0, 50)
    chip.advance(0.0505)
    assert chip.read(figures.RR0) & figures.NEXT
    chip.advance(0.0505)
    assert (chip.position(0), chip.stops) == (150, 1)


def test_a_segment_that_is_written_too_late_is_refused_until_it_is_cleared() -> None:
    chip = started()
    chip.advance(0.09)
    write(chip, figures.SET_FINISH, 0, 50)
    chip.advance(0.02)
    with pytest.raises(ChipRefused, match="after the drive had ended"):
        chip.write(figures.WR0, figures.LINE_2)
    assert chip.position(0) == 100
    chip.write(figures.WR0, figures.CLEAR)
    chip.write(figures.WR0, figures.LINE_2)
    chip.advance(1.0)
    assert chip.position(0) == 150


def test_a_bus_that_is_too_slow_ends_in_an_error_and_not_in_a_stop_in_the_cut() -> None:
    segments = encode(CUT, WIRING, LIMITS, tolerance=TOLERANCE)
    shortest = min(2.0 / 100.0, WIRING.refill)
    with pytest.raises((ControllerError, ChipRefused), match=r"before segment|had ended"):
        run(segments, CUT.pose[0], seconds=20.0 * shortest)


def test_short_lines_are_merged_if_they_are_straight_and_refused_otherwise() -> None:
    rows: list[Row] = [((0.04 * n, 0.0, -1.0, 0.0), 0.0, Motion.FEED) for n in range(1, 101)]
    segments = encode(path((0.0, 0.0, -1.0, 0.0), *rows), WIRING, LIMITS, tolerance=TOLERANCE)
    # 0.04 mm at 100 mm/s last 0.4 ms; three of them last longer than 1 ms.
    assert len(segments) == 34
    assert sum(segment.finish[0] for segment in segments) == 400
    bent = [((0.09, 0.0, -1.0, 0.0), 0.0, Motion.FEED), ((5.0, 3.0, -1.0, 0.0), 0.0, Motion.FEED)]
    turning = replace(WIRING, corner=60.0)
    with pytest.raises(ProgramError, match=r"takes 0\.9 ms"):
        encode(path((0.0, 0.0, -1.0, 0.0), *bent), turning, LIMITS, tolerance=TOLERANCE)
    # With a stop between them there is no deadline.
    assert len(encode(path((0.0, 0.0, -1.0, 0.0), *bent), WIRING, LIMITS, tolerance=TOLERANCE)) == 2


@pytest.mark.parametrize(
    ("end", "feed_rate", "words"),
    [
        ((9e4, 0.0, -1.0, 0.0), 6000.0, "counts at most 8388607"),
        ((10.0, 5.0, -2.0, 30.0), 6000.0, "moves four axes"),
        ((10.0, 0.0, -1.0, 0.0), 60000.0, "needs 100000 pulses per second"),
        ((10.0, 0.0, -1.0, 0.0), 1.0, "needs 2 pulses per second"),
    ],
)
def test_what_the_chip_cannot_do_is_refused(
    end: tuple[float, float, float, float], feed_rate: float, words: str
) -> None:
    cut = path((0.0, 0.0, -1.0, 0.0), (end, 0.0, Motion.FEED), feed=feed_rate)
    with pytest.raises(ProgramError, match=words):
        encode(cut, WIRING, LIMITS, tolerance=TOLERANCE)


def test_a_rapid_rises_first_and_falls_last() -> None:
    rapids = path(
        (0.0, 0.0, 0.0, 0.0),
        ((10.0, 10.0, 20.0, 90.0), 0.0, Motion.RAPID),
        ((0.0, 0.0, 5.0, 0.0), 0.0, Motion.RAPID),
    )
    segments = encode(rapids, WIRING, LIMITS, tolerance=TOLERANCE)
    upright = [2 in segment.axes and 0 not in segment.axes[:1] for segment in segments]
    assert upright == [True, False, False, True]


def push(chip: Chip, plus: tuple[int, int], minus: tuple[int, int]) -> None:
    chip.write(figures.WR0, figures.BITS_OPEN)
    for place in range(2):
        chip.write(figures.BITS_PLUS + 2 * place, plus[place])
        chip.write(figures.BITS_PLUS + 2 * place + 1, minus[place])
    chip.write(figures.WR0, figures.BITS_PUSH)
    chip.write(figures.WR0, figures.BITS_CLOSE)


def test_bit_patterns_emit_their_pulses_while_the_stack_is_filled_in_time() -> None:
    chip = Chip(1)
    write(chip, figures.SET_SPEED, 0, 1000)
    chip.write(figures.WR5, 1 << 2)
    for _ in range(figures.DEPTH):
        push(chip, (0xFFFF, 0x00FF), (0, 0xFF00))
    with pytest.raises(ChipRefused, match="full"):
        push(chip, (1, 0), (0, 0))
    chip.write(figures.WR0, figures.BITS_2)
    assert chip.read(figures.RR0) >> figures.STACK & 3 == 2
    chip.advance(0.0085)
    assert (chip.position(0), chip.position(1)) == (8, 8)
    push(chip, (0, 0), (0xFFFF, 0))
    chip.advance(0.2)
    assert (chip.position(0), chip.position(1)) == (32, 0)
    assert chip.stops == 1
    with pytest.raises(ChipRefused, match="no bit pattern"):
        chip.write(figures.WR0, figures.BITS_2)


def test_every_figure_of_the_chip_has_a_source() -> None:
    names = [figure.name for figure in figures.FIGURES]
    assert len(set(names)) == len(names)
    assert {figure.source for figure in figures.FIGURES} == {figures.NOTES, figures.MEMORY}
    values = {name for name, value in vars(figures).items() if isinstance(value, int)}
    assert len(values) == len(names)
