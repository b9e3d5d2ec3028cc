"""The tool path of a compiled job as arrays for the page, and the stations that it uses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from knifetip.geometry.columns import I32
from knifetip.model.machine import Machine
from knifetip.model.tool import kind_of
from knifetip.presentation.columns import pack_columns

if TYPE_CHECKING:
    from knifetip.pipeline import Compiled


def used_stations(compiled: Compiled, machine: Machine) -> list[dict[str, Any]]:
    """Return number, name and tool kind of each station that a program uses, ordered by number."""
    used = set(np.unique(compiled.toolpath.tool).tolist())
    return [
        {"station": station.number, "name": station.name, "kind": kind_of(station.tool).name}
        for station in sorted(machine.stations, key=lambda station: station.number)
        if station.number in used
    ]


def program_lines(compiled: Compiled) -> I32:
    """Return for each of the n moves of a tool path the number of its program line, (n,), from 1.

    It is the last line that makes the move, if there are several: the move is complete when this
    line has been executed.  The number is -1 for moves without a program line.
    """
    source = compiled.program.source
    line = np.full(len(compiled.toolpath), -1, np.int32)
    numbers = np.arange(1, len(source) + 1, dtype=np.int32)
    moving = source >= 0
    np.maximum.at(line, source[moving], numbers[moving])
    return line


def pack_toolpath(compiled: Compiled, machine: Machine) -> bytes:
    """Return the tool path as a block of bytes, with the stations of the machine as metadata.

    The array ``line`` is the result of ``program_lines``.
    """
    path = compiled.toolpath
    return pack_columns(
        {
            "pose": path.pose,
            "bulge": path.bulge,
            "motion": path.motion,
            "feed": path.feed,
            "source": path.source,
            "tool": path.tool,
            "line": program_lines(compiled),
        },
        {
            "placement": [float(shift) for shift in compiled.placement],
            "dialect": compiled.program.dialect,
            "stations": [
                {
                    "number": station.number,
                    "name": station.name,
                    "kind": kind_of(station.tool).name,
                    "datum": {"x": station.x, "y": station.y, "z": station.z, "c": station.c},
                }
                for station in machine.stations
            ],
        },
    )
