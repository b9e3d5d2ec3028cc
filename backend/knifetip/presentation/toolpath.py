"""The tool path of a compiled job as arrays for the page, and the stations that it uses."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import F64, I32
from knifetip.model.machine import Machine
from knifetip.model.tool import kind_of
from knifetip.model.toolpath import Toolpath
from knifetip.presentation.columns import pack_columns, unpack_columns
from knifetip.sequencing.tracks import Tracks, find_tracks, first_row_lines, row_lines

if TYPE_CHECKING:
    from knifetip.pipeline import Compiled

#: The arrays of a packed tool path that are columns of ``Toolpath``.
_MOVES: Final = ("pose", "bulge", "motion", "feed", "source", "tool", "track")


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
    return row_lines(compiled.program, len(compiled.toolpath))


def pack_toolpath(compiled: Compiled, machine: Machine) -> bytes:
    """Return the tool path as a block of bytes, with the stations of the machine as metadata.

    The array ``line`` is the result of ``program_lines``; ``first_line``, ``seconds`` and
    ``made_as`` are described by the route ``get_toolpath``.
    """
    path = compiled.toolpath
    return pack_columns(
        {
            **{name: getattr(path, name) for name in _MOVES},
            "line": program_lines(compiled),
            "first_line": first_row_lines(compiled.program, len(path)),
            "seconds": compiled.row_seconds,
            "made_as": compiled.made_as,
        },
        {
            "placement": [float(shift) for shift in compiled.placement],
            # a, b, x, y of ``geometry.similarity``: from the drawing to the table.
            "similarity": None if compiled.similarity is None else list(compiled.similarity),
            "dialect": compiled.program.dialect,
            "stages": list(path.stages),
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


def unpack_seconds(block: bytes) -> F64 | None:
    """Return the machine time of each move of a packed tool path, (n,) s.

    None if an older version packed it.
    """
    columns, _ = unpack_columns(block)
    return columns.get("seconds")


def unpack_toolpath(block: bytes) -> tuple[Toolpath, Tracks]:
    """Return the tool path that ``pack_toolpath`` packed, without its notes, and its tracks.

    Raises
    ------
    PlanError
        An older version packed the tool path, without its tracks.
    """
    columns, metadata = unpack_columns(block)
    if "track" not in columns:
        raise PlanError("rest.old-program")
    path = Toolpath.from_new({name: columns[name] for name in _MOVES}, ())
    path = replace(path, stages=tuple(metadata.get("stages", ())))
    return path, find_tracks(path, columns["line"])
