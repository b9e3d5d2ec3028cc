"""tool_table: write the stations of a machine as LinuxCNC's file tool.tbl.

The words ``Tn M6 G43`` of a program select row n of the table.  While G43 is active, LinuxCNC adds
X Y Z C of this row to the programmed position: joint = programmed + datum.
"""

from __future__ import annotations

from knifetip.model.machine import Machine
from knifetip.post.rs274 import gcode


def tool_table(machine: Machine) -> str:
    """Return the text of LinuxCNC's tool table for a machine, one line per station (mm and
    degrees).
    """
    # D is for the operator only: programs never use cutter compensation of LinuxCNC.
    return "".join(
        f"T{station.number} P{station.number}"
        f" X{gcode.format_number(station.x)} Y{gcode.format_number(station.y)}"
        f" Z{gcode.format_number(station.z)}"
        f" C{gcode.format_number(station.c)} D{gcode.format_number(station.tool.diameter)}"
        f" ;{gcode.format_comment(station.name)[1:-1]}\n"
        for station in machine.stations
    )
