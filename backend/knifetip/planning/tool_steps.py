"""Whether a machine has the tools that make a line type."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine, Station

#: Line types that are made as other line types, each with its own tool.
_STEPS: Final[Mapping[LineType, tuple[LineType, ...]]] = {
    LineType.UNCLASSIFIED: (),
    LineType.IGNORED: (),
    LineType.COMBI: (LineType.CREASE, LineType.PERFORATION),
}


def steps_of(line_type: LineType) -> tuple[LineType, ...]:
    """Return the line types as which a line type is made; empty if it is not made."""
    return _STEPS.get(line_type, (line_type,))


def makers(machine: Machine, line_type: LineType) -> tuple[Station, ...]:
    """Return the stations that may be chosen for a line type: those with the kind of tool that
    makes it, or a part of it, on this machine.
    """
    usual = [machine.station_for(step) for step in steps_of(line_type)]
    return tuple(
        station for one in usual if one is not None for station in machine.stations_like(one)
    )


def lacks_tool(machine: Machine, line_type: LineType) -> bool:
    """Return whether no station of a machine has a tool that makes a line type."""
    return any(machine.station_for(step) is None for step in steps_of(line_type))
