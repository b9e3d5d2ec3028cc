"""program: the RS274/NGC program of a toolpath.

    Toolpath, Machine, Dialect -> Program

Header, then station by station its change and its moves, then the end.  Numbers are the head's
X Y C and the tip's Z; the station's datum comes from the controller's tool table, or is in the
numbers where there is none.  The same input gives the same bytes: no dates, no names of hosts.

A job that was cancelled may have left a station lowered, its tool in the board and the spindle on.
Every program therefore begins and ends alike: lift straight up, wait until the head is at rest,
release all outputs, stop the spindle.  The lift comes first, while the spindle still runs: a tool
that is released or stopped in the board tears it.
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
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.post.check import place_of
from knifetip.post.rs274 import gcode
from knifetip.post.rs274.beam import switched_beam
from knifetip.post.rs274.controller import Dialect

#: mm, absolute, arc centres from the start, XY plane, no compensation in the controller, mm/min.
HEADER: Final = "G21 G90 G91.1 G17 G40 G49 G94 G54"
#: Wait until the machine stands still: a dwell of nothing.
STILL: Final = "G4 P0"
#: The controller may round corners by half the tolerance, and never by more than half of this (mm).
BLENDED: Final = 0.01


def write_program(
    toolpath: Toolpath,
    machine: Machine,
    *,
    dialect: Dialect,
    tolerance: float = 0.01,
    notes: Sequence[str] = (),
) -> Program:
    """Return the program that moves the head along the toolpath.

    Parameters
    ----------
    toolpath : Toolpath
        One chain of moves; each station's first move is a rapid.
    machine : Machine
        Its stations' datums and outputs, and the height for rapids.
    dialect : Dialect
        What the controller reads.
    tolerance : float, mm
        How far the tip may be from the line; half of it is left to the controller's blending.
    notes : sequence of str
        Comments at the top.  One of them is ``placement X… Y…``: what was added to the drawing's
        coordinates to place it on the sheet.

    Raises
    ------
    ProgramError
        A station that the machine lacks, or that begins in the middle of its work, or a cutter
        without a speed.
    """
    texts: list[bytes] = []
    sources: list[I32] = []

    def say(lines: Iterator[str]) -> None:
        spoken = list(lines)
        texts.append("".join(f"{line}\n" for line in spoken).encode("ascii"))
        sources.append(np.full(len(spoken), -1, np.int32))

    blending = _blending(tolerance)
    say(_header(machine, dialect, blending, notes))
    changes = np.flatnonzero(np.diff(toolpath.tool)) + 1
    edges = [0, *changes.tolist(), len(toolpath)]
    previous: Station | None = None
    for first, last in pairwise(edges):
        station = _station(toolpath, machine, first)
        say(_change(previous, station, machine, dialect))
        text, source = gcode.lines(
            toolpath, first, last, _added(station, dialect), machine, dialect, blending
        )
        if station.beams:
            height = _added(station, dialect)[2]
            text, source = switched_beam(text, source, toolpath, station.tool, height)
        texts.append(text)
        sources.append(source)
        previous = station
    assert previous is not None
    say(_footer(previous, machine, dialect))
    return Program(b"".join(texts), dialect.name, np.concatenate(sources))


def _blending(tolerance: float) -> float:
    """Return how far the controller may be from the path by itself (mm)."""
    half = min(tolerance, BLENDED) / 2.0
    # LinuxCNC reads P0 as no limit at all.
    if not half >= 0.5e-3:
        raise ProgramError("program.bad-tolerance", tolerance=tolerance)
    return half


def _header(
    machine: Machine, dialect: Dialect, blending: float, notes: Sequence[str]
) -> Iterator[str]:
    for note in notes:
        if comment := gcode.comment(note):
            yield comment
    yield HEADER
    if dialect.blending:
        yield f"G64 P{blending:.4f} Q{blending:.4f}"
    if machine.has_beam:
        # A beam that was left on would burn along the lift.
        yield "M5"
    # The station that is still lowered, if any, is not known: lift high enough for each of them.
    highest = machine.travel_z + max(station.z for station in machine.stations)
    yield f"G0 Z{gcode.plain(min(highest, machine.z.high))}"
    yield from _all_off(machine, dialect)


def _all_off(machine: Machine, dialect: Dialect) -> Iterator[str]:
    """Release every output of the machine and stop the spindle; the head has been lifted."""
    if dialect.eager_outputs:
        yield STILL
    for output in machine.outputs:
        yield f"M65 P{output}"
    yield "M5"


def _change(
    previous: Station | None, station: Station, machine: Machine, dialect: Dialect
) -> Iterator[str]:
    if dialect.comments:
        yield gcode.comment(f"station {station.number} {station.name}")
    if previous is not None:
        if dialect.eager_outputs:
            yield STILL
        if previous.output >= 0:
            yield f"M65 P{previous.output}"
        for output in previous.tool.outputs:
            yield f"M65 P{output}"
        if previous.tool.spindle and not previous.beams:
            yield "M5"
    if dialect.tool_table:
        yield f"T{station.number} M6 G43"
    # The piston last: the gateway takes the output last switched on for the station in use.
    for output in station.tool.outputs:
        yield f"M64 P{output}"
    if station.output >= 0:
        yield f"M64 P{station.output}"
    if (speed := station.tool.spindle) and not station.beams:
        yield f"M3 S{speed}"
    if (pause := station.tool.settle(machine.settle)) > 0:
        yield gcode.dwell(pause)


def _footer(station: Station, machine: Machine, dialect: Dialect) -> Iterator[str]:
    up = machine.travel_z + _added(station, dialect)[2]
    yield f"G0 Z{gcode.plain(up)}"
    yield from _all_off(machine, dialect)
    yield "G49"
    yield dialect.end


def _added(station: Station, dialect: Dialect) -> F64:
    datum = (station.x, station.y, station.z, station.c)
    return np.zeros(4) if dialect.tool_table else np.array(datum)


def _station(toolpath: Toolpath, machine: Machine, first: int) -> Station:
    number = int(toolpath.tool[first])
    try:
        station = machine.station(number)
    except KeyError:
        known = [str(station.number) for station in machine.stations]
        raise ProgramError(
            "toolpath.unknown-station",
            place=place_of(toolpath, first),
            station=number,
            machine=machine.name,
            known=known,
        ) from None
    if reason := station.tool.spindle_missing:
        raise ProgramError(
            "tool.cannot-work",
            station=number,
            name=station.name,
            machine=machine.name,
            reason=reason,
        )
    if toolpath.motion[first] != Motion.RAPID:
        raise ProgramError("toolpath.no-approach", place=place_of(toolpath, first), station=number)
    return station
