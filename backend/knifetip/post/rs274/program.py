"""program: write the RS274/NGC program of a toolpath.

A program has a header, a tool change and moves for each station, and a footer.  X, Y and C are
the position and heading of the head, Z is the height of the tip.  The controller's tool table adds
the datum of the station; if there is no tool table, the program's numbers include the datum.  The
same input gives the same bytes: a program contains no dates or host names.

A cancelled job may have left a station lowered, its tool in the board and the spindle on.  Every
program therefore starts and ends with these steps: lift straight up, wait until the head is at
rest, release all outputs, stop the spindle.  The lift comes first, while the spindle still runs: a
tool that is released or stopped in the board tears it.  If the machine has several carriages, the
header then parks all of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final

import numpy as np

from knifetip.errors import ProgramError
from knifetip.geometry.columns import F64, I32
from knifetip.model.machine import Machine, Station
from knifetip.model.program import Program
from knifetip.model.toolpath import Toolpath
from knifetip.post.check import station_at
from knifetip.post.rs274 import gcode
from knifetip.post.rs274.beam import switch_beam
from knifetip.post.rs274.controller import Dialect

#: Modes of a program: mm, absolute positions, arc centres relative to the start, XY plane, no tool
#: compensation, feeds in mm/min, work coordinates, and no shift of them by an earlier G92.
HEADER: Final = "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1"
#: A dwell of zero seconds, which waits until the machine is at rest.
WAIT_FOR_REST: Final = "G4 P0"
#: Largest tolerance from which the permitted blending is computed (mm).
MAX_BLENDING: Final = 0.01
#: Part of the tolerance that the controller may use to round corners.  A larger part hardly saves
#: time, and the fit of curves needs the rest (``tolerance.FIT``).
_BLENDING_SHARE: Final = 0.05
#: Smallest P and Q that a program states (mm): LinuxCNC reads P0 as no limit.
_MIN_BLENDING: Final = 0.0001
#: Smallest tolerance of a program (mm).
_MIN_TOLERANCE: Final = 0.001


def write_program(
    toolpath: Toolpath,
    machine: Machine,
    *,
    dialect: Dialect,
    tolerance: float = 0.01,
    notes: Sequence[str] = (),
) -> Program:
    """Return the RS274/NGC program that moves the head along a toolpath.

    Parameters
    ----------
    toolpath : Toolpath
        One chain of moves; the first move of each station is a rapid.
    machine : Machine
        Contains the datums and outputs of the stations, and the travel height.
    dialect : Dialect
        Dialect of RS274/NGC that the controller reads.
    tolerance : float, mm
        Greatest deviation of the tip from the path; blending by the controller may use a
        twentieth of it.
    notes : sequence of str
        Comments at the top.  One of them is ``placement X… Y…``, the shift of the drawing on the
        table.

    Raises
    ------
    ProgramError
        The machine lacks a station, a station does not start with a rapid, or a cutter has no
        spindle speed.
    """
    texts: list[bytes] = []
    sources: list[I32] = []

    def append_lines(lines: Iterator[str]) -> None:
        new_lines = list(lines)
        texts.append("".join(f"{line}\n" for line in new_lines).encode("ascii"))
        sources.append(np.full(len(new_lines), -1, np.int32))

    blending = _blending_deviation(tolerance)
    append_lines(_header(machine, dialect, blending, notes))
    changes = np.flatnonzero(np.diff(toolpath.tool)) + 1
    edges = [0, *changes.tolist(), len(toolpath)]
    previous: Station | None = None
    for first, last in pairwise(edges):
        station = station_at(toolpath, machine, first)
        carriage = machine.carriage_of(station)
        append_lines(_station_change(previous, station, machine, dialect))
        text, source = gcode.format_lines(
            toolpath,
            first,
            last,
            _datum(station, dialect),
            carriage,
            dialect,
            blending,
            chords=machine.arcs == "chords",
        )
        if station.is_beam:
            height, letter = _datum(station, dialect)[2], carriage.letters[2]
            text, source = switch_beam(text, source, toolpath, station.tool, height, letter)
        texts.append(text)
        sources.append(source)
        previous = station
    assert previous is not None
    append_lines(_footer(previous, machine, dialect))
    return Program(b"".join(texts), dialect.name, np.concatenate(sources))


def _blending_deviation(tolerance: float) -> float:
    """Return the deviation that the controller may cause by rounding corners (mm).

    ``tolerance`` is the greatest deviation of the tip from the path (mm).

    Raises ``ProgramError``: the tolerance is too small for the controller.
    """
    if not tolerance >= _MIN_TOLERANCE:
        raise ProgramError("program.bad-tolerance", tolerance=tolerance)
    return max(_BLENDING_SHARE * min(tolerance, MAX_BLENDING), _MIN_BLENDING)


def _header(
    machine: Machine, dialect: Dialect, blending: float, notes: Sequence[str]
) -> Iterator[str]:
    """Yield the program lines before the first station: notes, modes, and the steps to a safe
    state.

    ``blending`` is the deviation that the controller may cause by rounding corners (mm); ``notes``
    are comments.
    """
    for note in notes:
        if comment := gcode.format_comment(note):
            yield comment
    yield HEADER
    if dialect.blending:
        yield f"G64 P{blending:.4f} Q{blending:.4f}"
    if machine.has_beam:
        # A beam that was left on would burn the board during the lift.
        yield "M5"
    yield f"G0 {_highest_lift(machine)}"
    yield from _release_outputs(machine, dialect)
    if machine.gantry:
        # The stations rise before the heads travel; a machine with a beam dwells only to pierce.
        if machine.settle > 0.0 and not machine.has_beam:
            yield gcode.dwell_line(machine.settle)
        # All carriages at once: each moves to its own end, so that they do not approach each other.
        parks = (
            f"{carriage.letters[1]}{gcode.format_number(carriage.park)}"
            for carriage in machine.carriages
        )
        yield f"G0 {' '.join(parks)}"
        if dialect.eager_outputs:
            yield WAIT_FOR_REST


def _highest_lift(machine: Machine) -> str:
    """Return the words that lift all heads high enough for each of their stations.

    It is unknown which station is still lowered.
    """
    datum: dict[str, list[float]] = {one.letters[2]: [] for one in machine.carriages}
    for station in machine.stations:
        datum[machine.carriage_of(station).letters[2]].append(station.z)
    words = []
    for letter, offsets in datum.items():
        lift = min(machine.travel_z + max(offsets, default=0.0), machine.axes[letter].high)
        words.append(f"{letter}{gcode.format_number(lift)}")
    return " ".join(words)


def _release_outputs(machine: Machine, dialect: Dialect) -> Iterator[str]:
    """Yield the program lines that release all outputs of the machine and stop the spindle.

    The head has lifted before these lines.
    """
    if dialect.eager_outputs:
        yield WAIT_FOR_REST
    for output in machine.outputs:
        yield f"M65 P{output}"
    yield "M5"


def _station_change(
    previous: Station | None, station: Station, machine: Machine, dialect: Dialect
) -> Iterator[str]:
    """Yield the program lines that release the previous station, if any, and select the new one."""
    if dialect.comments:
        yield gcode.format_comment(f"station {station.number} {station.name}")
    if previous is not None:
        if dialect.eager_outputs:
            yield WAIT_FOR_REST
        if previous.output >= 0:
            yield f"M65 P{previous.output}"
        for output in previous.tool.outputs:
            yield f"M65 P{output}"
        if previous.speed and not previous.is_beam:
            yield "M5"
    if dialect.tool_table:
        yield f"T{station.number} M6 G43"
    # The piston comes last: the gateway takes the last output that is on as the station in use.
    for output in station.tool.outputs:
        yield f"M64 P{output}"
    if station.output >= 0:
        yield f"M64 P{station.output}"
    if station.speed and not station.is_beam:
        yield f"{station.spindle} S{station.speed}"
    if (pause := station.tool.settle(machine.settle)) > 0:
        yield gcode.dwell_line(pause)


def _footer(station: Station, machine: Machine, dialect: Dialect) -> Iterator[str]:
    """Yield the program lines after the last station: lift, release all outputs, and end the
    program.

    ``station`` is the last station.
    """
    up = machine.travel_z + _datum(station, dialect)[2]
    yield f"G0 {machine.carriage_of(station).letters[2]}{gcode.format_number(up)}"
    yield from _release_outputs(machine, dialect)
    yield "G49"
    yield dialect.end


def _datum(station: Station, dialect: Dialect) -> F64:
    """Return the offset that the program adds to its positions for a station, (4,) mm and degrees.

    It is the datum of the station, or zero if the controller's tool table contains the datum.
    """
    datum = (station.x, station.y, station.z, station.c)
    return np.zeros(4) if dialect.tool_table else np.array(datum)
