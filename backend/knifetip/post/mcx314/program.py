"""program: write the program of a toolpath for a board with the motion chip MCX314.

A program is a text with one instruction on each line (docs/mcx314-programs.md)::

    MCX314 1                                 format and version
    PULSES X200 Y200 Z400 C100               pulses per mm, and per degree of C
    GO Z8000                                 air move to a position (pulses)
    OUT 0 ON                                 switch an output
    OSC ON                                   switch the oscillation or the spindle
    DWELL 150                                milliseconds
    LINE X4000 Y-12 V80000                   line by pulses at a drive speed (pulses/s)
    CCW X300 Y300 I0 J300 V80000 JOIN        arc that begins without a stop
    END

Numbers include the datum of the station.  Head and foot are those of every program: the head lifts
straight up, all outputs are released, and the oscillation stops (ADR 17).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final

import numpy as np

from knifetip.errors import ProgramError
from knifetip.geometry.columns import F64, I64
from knifetip.languages.mcx314 import figures
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.model.machine import Machine, Station
from knifetip.model.program import Program
from knifetip.model.toolpath import Toolpath
from knifetip.post.check import station_at
from knifetip.post.mcx314.segments import Segments, encode

#: Greatest length of a comment (characters).
MAX_COMMENT: Final = 66
_AXES: Final = "XYZC"


def emit(
    toolpath: Toolpath, machine: Machine, *, tolerance: float, notes: Sequence[str]
) -> Program:
    """Return the program of a toolpath for a board with an MCX314.

    Parameters
    ----------
    tolerance : float, mm
        Greatest deviation of the tip from the path; the rounding to pulses comes in addition.
    notes
        Comments at the top.

    Raises
    ------
    ProgramError
        The machine's file does not describe an MCX314, or the chip cannot execute a move.
    """
    wiring = machine.controller
    if not isinstance(wiring, Wiring):
        raise ProgramError("mcx314.no-wiring", machine=machine.title)
    writer = _Writer(machine, wiring)
    writer.add_header(notes)
    changes = np.flatnonzero(np.diff(toolpath.tool)) + 1
    previous: Station | None = None
    for first, last in pairwise([0, *changes.tolist(), len(toolpath)]):
        station = station_at(toolpath, machine, first)
        writer.add_station_change(previous, station)
        datum = np.array([station.x, station.y, station.z, station.c])
        writer.add_segments(
            encode(toolpath, first, last, datum, machine, wiring, tolerance),
            toolpath.pose[first] + datum,
        )
        previous = station
    writer.add_footer()
    return Program(
        "".join(f"{line}\n" for line in writer.lines).encode("ascii"),
        "mcx314",
        np.array(writer.rows, np.int32),
    )


class _Writer:
    """Collects the lines of a program, and the toolpath row of each line.

    Parameters
    ----------
    machine, wiring
        The machine, and how it is connected to its chip.
    """

    def __init__(self, machine: Machine, wiring: Wiring) -> None:
        self._machine = machine
        self._wiring = wiring
        self._at: list[int | None] = [None] * 4  # last position of each axis (pulses)
        self.lines: list[str] = []
        self.rows: list[int] = []

    def _add(self, lines: Iterator[str] | Sequence[str], row: int = -1) -> None:
        for line in lines:
            self.lines.append(line)
            self.rows.append(row)

    def add_header(self, notes: Sequence[str]) -> None:
        """Add the lines before the first station."""
        pulses = (
            f"{letter}{_decimal(scale)}"
            for letter, scale in zip(_AXES, self._wiring.pulses, strict=True)
        )
        self._add([f"MCX314 {figures.FORMAT}", *filter(None, map(_comment, notes))])
        self._add([f"PULSES {' '.join(pulses)}"])
        self._add_lift()
        self._add(self._release(self._machine.outputs))

    def add_footer(self) -> None:
        """Add the lines after the last station."""
        self._add_lift()
        self._add(self._release(self._machine.outputs))
        self._add(["END"])

    def _add_lift(self) -> None:
        """Add a lift to the height at which every station clears the board."""
        highest = self._machine.travel_z + max(held.z for held in self._machine.stations)
        lift = min(highest, self._machine.z.high)
        self._go([2], np.array([0, 0, round(lift * self._wiring.pulses[2]), 0]), -1)

    @staticmethod
    def _release(outputs: Sequence[int]) -> list[str]:
        return [*(f"OUT {output} OFF" for output in outputs), "OSC OFF"]

    def add_station_change(self, previous: Station | None, station: Station) -> None:
        """Add the lines that release the previous station, if any, and select the new one."""
        self._add(filter(None, [_comment(f"station {station.number} {station.name}")]))
        if previous is not None:
            self._add(self._release([previous.output] if previous.output >= 0 else []))
        if station.output >= 0:
            self._add([f"OUT {station.output} ON"])
        if station.speed:
            self._add(["OSC ON"])
        if (pause := station.tool.settle(self._machine.settle)) > 0:
            self._add([f"DWELL {round(pause * 1e3)}"])

    def add_segments(self, segments: Segments, start: F64) -> None:
        """Add the segments of one station; its first move begins at the joints ``start``, (4,)."""
        before: I64 = np.rint(start * self._wiring.pulses).astype(np.int64)
        if self._at[2] is not None and before[2] != self._at[2]:
            # The height of the head at which the new station is at its travel height.
            self._go([2], before, -1)
        words = [
            segments.way.tolist(),
            segments.centre.tolist(),
            segments.side.tolist(),
            segments.speed.tolist(),
            segments.joined.tolist(),
            segments.row.tolist(),
        ]
        rapid = segments.rapid.tolist()
        for place, (way, centre, side, speed, joined, row) in enumerate(zip(*words, strict=True)):
            target = segments.target[place]
            if rapid[place]:
                self._add_rapid(target, row)
                continue
            moved = " ".join(
                f"{letter}{pulses}" for letter, pulses in zip(_AXES, way, strict=True) if pulses
            )
            name = ("LINE", "CCW", "CW")[side]
            if side:
                moved = f"X{way[0]} Y{way[1]} I{centre[0]} J{centre[1]}"
            self._add([f"{name} {moved} V{speed}{' JOIN' if joined else ''}"], row)
            self._at = target.tolist()

    def _add_rapid(self, target: I64, row: int) -> None:
        """Add the lines of a rapid: Z by itself, first if it rises and last if it falls."""
        height = self._at[2]
        if height is not None and target[2] > height:
            self._go([2], target, row)
        self._go([0, 1, 3], target, row)
        self._go([2], target, row)

    def _go(self, axes: Sequence[int], target: I64, row: int) -> None:
        """Add an air move of those of some axes that are not at the target."""
        moved = [axis for axis in axes if self._at[axis] != target[axis]]
        if moved:
            self._add(["GO " + " ".join(f"{_AXES[axis]}{target[axis]}" for axis in moved)], row)
        for axis in moved:
            self._at[axis] = int(target[axis])


def _decimal(value: float) -> str:
    """Return a positive number with at most six decimals."""
    return f"{value:.6f}".rstrip("0").rstrip(".")


def _comment(note: str) -> str:
    """Return a note as a comment line; "" if no characters remain."""
    clean = " ".join(re.sub(r"[^ -~]|;", " ", note).split())[:MAX_COMMENT].rstrip()
    return f"; {clean}" if clean else ""
