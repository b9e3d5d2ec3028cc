"""compensate: the table from tool to engine.

Operation -> Toolpath
"""

from __future__ import annotations

from collections.abc import Callable

from knifetip.compensation.crease import crease
from knifetip.compensation.knife import knife
from knifetip.compensation.radius import radius
from knifetip.compensation.vgroove import vgroove
from knifetip.errors import NoToolForLineType
from knifetip.model.operation import Operation
from knifetip.model.tool import CreaseWheel, Cutter, Knife, Tool, VCutter
from knifetip.model.toolpath import Toolpath

ENGINES: dict[type[Tool], Callable[[Operation], Toolpath]] = {
    Knife: knife,
    CreaseWheel: crease,
    VCutter: vgroove,
    Cutter: radius,
}


def compensate(operation: Operation) -> Toolpath:
    """Return where the head goes so that the tool's tip follows the paths of the operation.

    Raises
    ------
    CompensationError
        The engine refuses an edge; the error names it.
    NoToolForLineType
        There is no engine for this tool.
    """
    engine = ENGINES.get(type(operation.tool))
    if engine is None:
        raise NoToolForLineType(
            f"There is no engine for a {type(operation.tool).__name__}.",
            "Give the edges a line type that the machine's other tools make.",
        )
    return engine(operation)
