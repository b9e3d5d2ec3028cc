"""compensate: select the compensation engine for the tool of an operation."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Final

from knifetip.compensation.crease import crease_toolpath
from knifetip.compensation.knife import knife_toolpath
from knifetip.compensation.radius import radius_toolpath
from knifetip.compensation.vgroove import vgroove_toolpath
from knifetip.model.operation import Operation
from knifetip.model.tool import Engine, kind_of
from knifetip.model.toolpath import Toolpath

_ENGINES: Final[Mapping[Engine, Callable[[Operation], Toolpath]]] = {
    Engine.KNIFE: knife_toolpath,
    Engine.CREASE: crease_toolpath,
    Engine.V_GROOVE: vgroove_toolpath,
    Engine.RADIUS: radius_toolpath,
}


def compensate(operation: Operation) -> Toolpath:
    """Return the head's toolpath with which the tip of the tool follows the paths of an operation.

    Raises
    ------
    CompensationError
        The tool cannot follow an edge; the error names the edge.
    """
    toolpath = _ENGINES[kind_of(operation.tool).engine](operation)
    return replace(toolpath, one_way=True) if operation.one_way else toolpath
