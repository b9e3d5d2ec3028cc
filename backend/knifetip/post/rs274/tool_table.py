"""tool_table: write the stations of a machine as LinuxCNC's file tool.tbl.

The words ``Tn M6 G43`` of a program select row n of the table.  While G43 is active, LinuxCNC adds
the offsets of this row to the programmed positions: joint = programmed + datum.  The offsets have
the letters of the axes of the station's carriage.
"""

from __future__ import annotations

from knifetip.model.machine import Carriage, Machine, Station
from knifetip.post.rs274 import gcode


def tool_table(machine: Machine) -> str:
    """Return the text of LinuxCNC's tool table for a machine, one line per station (mm and
    degrees).
    """
    # D is for the operator only: programs never use cutter compensation of LinuxCNC.
    return "".join(
        f"T{station.number} P{station.number}"
        f"{_offsets(station, machine.carriage_of(station))}"
        f" D{gcode.format_number(station.tool.diameter)}"
        f" ;{gcode.format_comment(station.name)[1:-1]}\n"
        for station in machine.stations
    )


def _offsets(station: Station, carriage: Carriage) -> str:
    """Return the words of a tool table with the offsets of a station, each after a blank."""
    datum = (station.x, station.y, station.z, station.c)
    return "".join(
        f" {letter}{gcode.format_number(offset)}"
        for letter, offset in zip(carriage.letters, datum, strict=False)
    )
