"""compensate: run the engine for an operation's kind of tool.

Operation -> Toolpath
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from knifetip.compensation.crease import crease
from knifetip.compensation.knife import knife
from knifetip.compensation.radius import radius
from knifetip.compensation.vgroove import vgroove
from knifetip.model.operation import Operation
from knifetip.model.tool import Engine, kind_of
from knifetip.model.toolpath import Toolpath

_ENGINES: Final[Mapping[Engine, Callable[[Operation], Toolpath]]] = {
    Engine.KNIFE: knife,
    Engine.CREASE: crease,
    Engine.V_GROOVE: vgroove,
    Engine.RADIUS: radius,
}


def compensate(operation: Operation) -> Toolpath:
    """Return the head path with which the tool's tip follows the paths of an operation.

    Raises
    ------
    CompensationError
        The engine refuses an edge; the error names it.
    """
    return _ENGINES[kind_of(operation.tool).engine](operation)
