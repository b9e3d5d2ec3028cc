"""feeder: writes pieces of segments to the registers of an MCX314, and observes their execution."""

from __future__ import annotations

from collections import deque
from typing import Protocol

from knifetip.languages.mcx314 import figures
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.simulators.mcx314.planner import STAIRS, Piece


class Bus(Protocol):
    """Interface of the bus to a chip."""

    def write(self, register: int, word: int) -> None:
        """Write a word to a register."""
        ...

    def read(self, register: int) -> int:
        """Return the word in a register."""
        ...


class Feeder:
    """Writes pieces to a chip: one that it drives, and the next one.

    Parameters
    ----------
    bus
        Bus to the chip.
    wiring
        How the machine is connected to the chip.
    """

    def __init__(self, bus: Bus, wiring: Wiring) -> None:
        self._bus = bus
        self._wiring = wiring
        self._written: deque[Piece] = deque()

    def set_up(self) -> None:
        """Write the start speed and the ramp of all axes."""
        unit = self._wiring.multiple
        for axis in range(figures.AXES):
            self._set(figures.SET_START, axis, self._wiring.start // unit)
            steepness = self._wiring.acceleration // (unit * figures.RAMP_UNIT)
            self._set(figures.SET_ACCELERATION, axis, steepness)

    @property
    def driving(self) -> bool:
        """Whether the chip drives a piece."""
        return bool(self._bus.read(figures.RR0) & figures.DRIVING)

    @property
    def last(self) -> Piece | None:
        """The piece that was written last, None if the chip is at rest."""
        return self._written[-1] if self._written else None

    @property
    def current(self) -> Piece | None:
        """The piece that the chip drives, None if it is at rest."""
        return self._written[0] if self._written else None

    def completed(self) -> list[Piece]:
        """Return the pieces that have ended since the last call."""
        status = self._bus.read(figures.RR0)
        left = 2 - bool(status & figures.NEXT) if status & figures.DRIVING else 0
        ended = []
        while len(self._written) > left:
            ended.append(self._written.popleft())
        return ended

    def can_write(self) -> bool:
        """Return whether the chip takes another piece."""
        status = self._bus.read(figures.RR0)
        return not status & figures.DRIVING or bool(status & figures.NEXT)

    def write(self, piece: Piece) -> None:
        """Write a piece; the chip begins it at once, or after the piece that it drives."""
        stretch = piece.stretch
        before, after = stretch.position(piece.first), stretch.position(piece.last)
        way = [b - a for a, b in zip(before, after, strict=True)]
        if stretch.side:
            command = figures.COUNTER_CLOCKWISE if stretch.side > 0 else figures.CLOCKWISE
            axes = [0, 1]
        else:
            axes = [axis for axis in range(figures.AXES) if way[axis]]
            # The first axis sets the rate.
            axes.sort(key=lambda axis: -abs(way[axis]))
            if len(axes) == 1:
                axes.append((axes[0] + 1) % figures.AXES)
            command = figures.LINE_2 if len(axes) == 2 else figures.LINE_3
        self._set(figures.SET_SPEED, axes[0], round(piece.rate / self._wiring.multiple))
        mode = sum(axis << 2 * place for place, axis in enumerate(axes))
        for axis in axes:
            self._set(figures.SET_FINISH, axis, way[axis])
        if stretch.side:
            mode |= figures.CONSTANT_2
            for axis in axes:
                middle = stretch.start[axis] + stretch.centre[axis]
                self._set(figures.SET_CENTRE, axis, middle - before[axis])
        self._bus.write(figures.WR5, mode)
        self._bus.write(figures.WR0, command)
        self._written.append(piece)

    def position(self, axis: int) -> int:
        """Return the logical position of an axis (pulses)."""
        self._bus.write(figures.WR0, 1 << (8 + axis) | figures.GET_POSITION)
        value = self._bus.read(figures.RR6) | self._bus.read(figures.RR7) << 16
        return value - (1 << 32) if value >> 31 else value

    def set_position(self, axis: int, value: int) -> None:
        """Set the logical position of an axis (pulses)."""
        self._set(figures.SET_POSITION, axis, value)

    def stop(self) -> None:
        """Stop the chip at once."""
        self._bus.write(figures.WR0, figures.STOP)
        self._written.clear()

    def _set(self, command: int, axis: int, value: int) -> None:
        self._bus.write(figures.WR6, value & 0xFFFF)
        self._bus.write(figures.WR7, value >> 16 & 0xFFFF)
        self._bus.write(figures.WR0, 1 << (8 + axis) | command)


def rate_of_arc(speed: float) -> float:
    """Return the rate of steps at a speed along an arc (pulses/s)."""
    return speed * STAIRS
