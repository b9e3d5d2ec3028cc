"""feeder: writes the segments of a toolpath to the registers of an MCX314."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

from knifetip.errors import ControllerError
from knifetip.gateway.mcx314 import figures
from knifetip.gateway.mcx314.segments import Segment


class Bus(Protocol):
    """Interface of the bus to a chip."""

    def write(self, register: int, word: int) -> None:
        """Write a word to a register."""
        ...

    def read(self, register: int) -> int:
        """Return the word in a register."""
        ...


def feed(segments: Sequence[Segment], bus: Bus, wait: Callable[[], None]) -> None:
    """Write segments to a chip as it executes them; return when the last one is executed.

    Parameters
    ----------
    segments
        The segments.
    bus
        Bus to the chip.
    wait
        Function that lets a short time pass; it is called between two reads of the status.

    Raises
    ------
    ControllerError
        The chip has come to rest before a segment that continues the one before it.
    """
    for number, segment in enumerate(segments, 1):
        while True:
            status = bus.read(figures.RR0)
            driving = bool(status & figures.DRIVING)
            _check_joint(segment, number, driving)
            if (segment.joined and status & figures.NEXT) or not driving:
                break
            wait()
        _write(segment, bus)
        # The drive may have ended meanwhile.
        _check_joint(segment, number, bool(bus.read(figures.RR0) & figures.DRIVING))
        bus.write(figures.WR0, segment.command)
    while bus.read(figures.RR0) & figures.DRIVING:
        wait()


def _write(segment: Segment, bus: Bus) -> None:
    """Write the data of a segment; its command then begins it or puts it next."""
    _set(bus, figures.SET_SPEED, segment.axes[0], segment.speed)
    for axis, finish in zip(segment.axes, segment.finish, strict=True):
        _set(bus, figures.SET_FINISH, axis, finish)
    mode = sum(axis << 2 * place for place, axis in enumerate(segment.axes))
    if segment.centre is not None:
        mode |= figures.CONSTANT_2
        for axis, centre in zip(segment.axes, segment.centre, strict=True):
            _set(bus, figures.SET_CENTRE, axis, centre)
    bus.write(figures.WR5, mode)


def _check_joint(segment: Segment, number: int, driving: bool) -> None:
    """Raise ``ControllerError`` if a segment is joined to one that has ended already."""
    if segment.joined and not driving:
        raise ControllerError("mcx314.underrun", segment=number)


def _set(bus: Bus, command: int, axis: int, value: int) -> None:
    bus.write(figures.WR6, value & 0xFFFF)
    bus.write(figures.WR7, value >> 16 & 0xFFFF)
    bus.write(figures.WR0, 1 << (8 + axis) | command)
