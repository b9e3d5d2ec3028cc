"""Warnings about what import left out of a drawing or changed, for everyone who uses the drawing.

The import report gives the outcome of each entity.  Most entities that are left out, such as texts
and dimensions, are never cut, and nobody needs to be warned.  A warning is for geometry that the
author may have meant, or that a reader could not read.
"""

from __future__ import annotations

from collections import Counter
from typing import Final

import numpy as np

from knifetip.messages import Message, printable
from knifetip.model.drawing import Drawing, ImportOutcome

#: Reasons for leaving out an entity because its author does not see it.
NOT_SEEN: Final = frozenset(
    {
        "import.hidden",
        "import.hidden-layer",
        "import.invisible",
        "import.layer-frozen",
        "import.layer-never-plotted",
        "import.layer-not-plotted",
        "import.layer-off",
        "import.not-visible",
        "import.outside-page",
    }
)
#: Reasons for leaving out an entity although its author sees it.
NOT_READ: Final = frozenset(
    {
        "import.block-external",
        "import.block-missing",
        "import.missing-id",
        "import.missing-subroutine",
        "import.multiple-line",
        "import.paper-space",
    }
)
_WARNED: Final = NOT_SEEN | NOT_READ
#: Number of warnings of a drawing; the rest is counted.
_LONGEST: Final = 8


def import_warnings(drawing: Drawing) -> list[Message]:
    """Return one warning for each layer and reason for which entities were left out.

    The warning for the most entities comes first.  If there are many, the last one counts the rest.
    """
    report = drawing.import_report
    groups: Counter[tuple[Message, str]] = Counter()
    for row in np.flatnonzero(report.outcome == ImportOutcome.DROPPED).tolist():
        if (reason := report.reason[row]).code in _WARNED:
            groups[reason, report.layer[row]] += 1
    warnings = [
        Message(
            "import.left-out-on-layer" if layer else "import.left-out",
            objects=objects,
            reason=reason,
            **({"layer": printable(layer)} if layer else {}),
        )
        for (reason, layer), objects in groups.most_common(_LONGEST)
    ]
    rest = groups.total() - sum(objects for _, objects in groups.most_common(_LONGEST))
    return [*warnings, Message("import.left-out-further", objects=rest)] if rest else warnings
