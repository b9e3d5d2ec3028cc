"""Whether a machine has the tools that make a line type."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine

#: Line types that are made as other line types, each with its own tool.
_STEPS: Final[Mapping[LineType, tuple[LineType, ...]]] = {
    LineType.UNCLASSIFIED: (),
    LineType.IGNORED: (),
    LineType.COMBI: (LineType.CREASE, LineType.PERFORATION),
}


def lacks_tool(machine: Machine, line_type: LineType) -> bool:
    """Return whether no station of a machine has a tool that makes a line type."""
    return any(machine.station_for(step) is None for step in _STEPS.get(line_type, (line_type,)))
