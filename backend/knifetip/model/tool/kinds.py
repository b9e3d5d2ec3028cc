"""The registry of tools: one row for each kind of tool.

A row names the line types that the tool makes, the planner for each line type (function that makes
operations from edges) and the engine (function that makes a tool path from an operation).  To add a
kind of tool, write its class, its row in this module, and its checks in
``knifetip.verification.tools``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from knifetip.model.dieline import LineType
from knifetip.model.tool.base import Switching, Tool
from knifetip.model.tool.crease_wheel import CreaseWheel
from knifetip.model.tool.cutter import Cutter
from knifetip.model.tool.knife import Knife
from knifetip.model.tool.laser import Laser
from knifetip.model.tool.v_cutter import VCutter


class Planner(StrEnum):
    """Key of a function of ``planning.plan`` that makes operations from edges of a line type."""

    CREASES = "creases"
    GROOVES = "grooves"
    HALF_CUTS = "half-cuts"
    PERFORATIONS = "perforations"
    BLADE_CUTS = "blade cuts"  #: cuts on the drawn line
    OFFSET_CUTS = "offset cuts"  #: cuts beside the drawn line, in the waste


class Engine(StrEnum):
    """Key of a function of ``compensation`` that makes a tool path from an operation."""

    KNIFE = "knife"
    CREASE = "crease"
    V_GROOVE = "v-groove"
    RADIUS = "radius"


@dataclass(frozen=True, slots=True)
class Kind:
    """One row of the registry of tools: a kind of tool with its class, name and line types.

    The row also names the planner for each line type (function that makes operations from edges)
    and the engine (function that makes a tool path from an operation).
    """

    name: str  #: name in files of machines and in REST
    tool: type[Tool]
    planners: Mapping[LineType, Planner]  #: line types that the tool makes, with their planners
    engine: Engine
    switching: Switching = Switching.STATION


#: If several tools of a machine make a line type, the first in this order is used.
KINDS: Final = (
    Kind(
        "knife",
        Knife,
        {
            LineType.CUT: Planner.BLADE_CUTS,
            LineType.PERFORATION: Planner.PERFORATIONS,
            LineType.HALF_CUT: Planner.HALF_CUTS,
        },
        Engine.KNIFE,
    ),
    Kind("crease-wheel", CreaseWheel, {LineType.CREASE: Planner.CREASES}, Engine.CREASE),
    Kind("v-cutter", VCutter, {LineType.V_GROOVE: Planner.GROOVES}, Engine.V_GROOVE),
    Kind("cutter", Cutter, {LineType.CUT: Planner.OFFSET_CUTS}, Engine.RADIUS),
    Kind("laser", Laser, {LineType.CUT: Planner.OFFSET_CUTS}, Engine.RADIUS, Switching.CUT),
)

_BY_TOOL: Final = {kind.tool: kind for kind in KINDS}


def kind_of(tool: Tool) -> Kind:
    """Return the row of the registry that belongs to the class of ``tool``."""
    return _BY_TOOL[type(tool)]
