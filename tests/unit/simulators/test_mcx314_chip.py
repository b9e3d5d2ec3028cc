"""The registers of the simulated chip MCX314, and the pulses that it emits."""

from __future__ import annotations

import math

import numpy as np
import pytest

from knifetip.languages.mcx314 import figures
from knifetip.simulators.mcx314.chip import Chip, ChipRefused


def write(chip: Chip, command: int, axis: int, value: int) -> None:
    chip.write(figures.WR6, value & 0xFFFF)
    chip.write(figures.WR7, value >> 16 & 0xFFFF)
    chip.write(figures.WR0, 1 << (8 + axis) | command)


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


def ramping(pulses: int, *, start: int = 100, speed: int = 1000) -> Chip:
    """Return a chip that drives a line from a start speed (10/s), with 12,500 pulses/s²."""
    chip = Chip(10)
    for axis in range(figures.AXES):
        write(chip, figures.SET_START, axis, start)
        write(chip, figures.SET_ACCELERATION, axis, 10)
    write(chip, figures.SET_SPEED, 0, speed)
    write(chip, figures.SET_FINISH, 0, pulses)
    chip.write(figures.WR5, 1 << 2)
    chip.write(figures.WR0, figures.LINE_2)
    return chip


def test_a_drive_ramps_from_the_start_speed_to_the_drive_speed() -> None:
    chip = ramping(20_000)
    # (10000 - 1000) / 12500 s at 5500 pulses/s on average, then at 10000 pulses/s.
    chip.advance(0.72)
    assert chip.position(0) == pytest.approx(0.72 * 5500, abs=2)
    chip.advance(0.5)
    assert chip.position(0) == pytest.approx(0.72 * 5500 + 5000, abs=2)


def test_a_drive_that_ends_without_a_ramp_down_is_refused() -> None:
    chip = ramping(10_000)
    with pytest.raises(ChipRefused, match="stops at 10000 pulses/s"):
        chip.advance(2.0)


def test_the_next_segment_continues_at_the_speed_and_ramps_down() -> None:
    chip = ramping(10_000)
    chip.advance(0.8)
    # (10000² - 1000²) / 2 / 12500 pulses are needed to ramp down.
    write(chip, figures.SET_SPEED, 0, 100)
    write(chip, figures.SET_FINISH, 0, 3961)
    chip.write(figures.WR0, figures.LINE_2)
    chip.advance(10.0)
    assert (chip.position(0), chip.stops) == (13_961, 1)


def test_a_segment_that_is_too_short_to_ramp_down_is_refused() -> None:
    chip = ramping(10_000)
    chip.advance(0.8)
    write(chip, figures.SET_SPEED, 0, 100)
    write(chip, figures.SET_FINISH, 0, 3900)
    chip.write(figures.WR0, figures.LINE_2)
    with pytest.raises(ChipRefused, match="stops at 15"):
        chip.advance(10.0)


def arc(chip: Chip, code: int, finish: tuple[int, int], centre: tuple[int, int]) -> None:
    write(chip, figures.SET_SPEED, 0, 8000)
    for axis in range(2):
        write(chip, figures.SET_FINISH, axis, finish[axis])
        write(chip, figures.SET_CENTRE, axis, centre[axis])
    chip.write(figures.WR5, 1 << 2 | figures.CONSTANT_2)
    chip.write(figures.WR0, code)


@pytest.mark.parametrize("side", [1, -1])
def test_an_arc_stays_on_its_circle_at_constant_speed(side: int) -> None:
    chip = Chip(1)
    code = figures.COUNTER_CLOCKWISE if side > 0 else figures.CLOCKWISE
    arc(chip, code, (4000, 0), (2000, 0))
    places = []
    while chip.read(figures.RR0) & figures.DRIVING:
        chip.advance(0.01)
        places.append((chip.position(0), chip.position(1)))
    column = np.array(places, np.float64)
    assert np.abs(np.hypot(column[:, 0] - 2000.0, column[:, 1]) - 2000.0).max() <= 1.0
    # Counter-clockwise from the left end runs below the centre.
    assert np.sign(column[len(column) // 2, 1]) == -side
    assert places[-1] == (4000, 0)
    # The speed is that of straight and diagonal steps, which are 1.0548 times as long.
    assert chip.time == pytest.approx(2000.0 * math.pi * 1.0548 / 8000.0, abs=0.02)


def test_an_arc_that_misses_its_end_is_refused() -> None:
    with pytest.raises(ChipRefused, match="not on its circle"):
        arc(Chip(1), figures.CLOCKWISE, (4000, 10), (2100, 0))


def test_every_figure_of_the_chip_has_a_source() -> None:
    names = [figure.name for figure in figures.FIGURES]
    assert len(set(names)) == len(names)
    sources = {figures.NOTES, figures.MEMORY, figures.SISTER, figures.ASSUMED}
    assert {figure.source for figure in figures.FIGURES} == sources
    values = {name for name, value in vars(figures).items() if isinstance(value, int)}
    assert len(values - {"FORMAT"}) == len(names)
