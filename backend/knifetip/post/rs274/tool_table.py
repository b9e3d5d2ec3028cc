"""tool_table: the stations of a machine as LinuxCNC's tool table.

    Machine -> text of tool.tbl, what ``Tn M6 G43`` looks up

LinuxCNC adds X Y Z C to the programmed position while G43 is in force: joint = programmed + datum.
"""

from __future__ import annotations

from knifetip.model.machine import Machine
from knifetip.post.rs274 import gcode


def tool_table(machine: Machine) -> str:
    """Return LinuxCNC's tool table of a machine, one line to a station (mm and degrees)."""
    # D is for the operator: programs never ask LinuxCNC for cutter compensation.
    return "".join(
        f"T{station.number} P{station.number}"
        f" X{gcode.plain(station.x)} Y{gcode.plain(station.y)} Z{gcode.plain(station.z)}"
        f" C{gcode.plain(station.c)} D{gcode.plain(station.tool.diameter)}"
        f" ;{gcode.comment(station.name)[1:-1]}\n"
        for station in machine.stations
    )
