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
from knifetip.model.drawing import Drawing, ImportOutcome, ImportReport
from knifetip.model.words import Repeated

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
        "import.angles-not-numbers",
        "import.bad-radius",
        "import.block-external",
        "import.block-in-itself",
        "import.block-missing",
        "import.coordinate-not-a-number",
        "import.damaged",
        "import.damaged-or-frame",
        "import.extrusion-not-a-number",
        "import.filled-area",
        "import.font-shape",
        "import.hatch",
        "import.height-not-a-number",
        "import.height-too-far",
        "import.incomplete",
        "import.line-not-numbers",
        "import.lone-vertex",
        "import.mesh",
        "import.missing-id",
        "import.missing-subroutine",
        "import.multiple-line",
        "import.no-major-axis",
        "import.no-parameter-range",
        "import.no-scale",
        "import.no-sweep",
        "import.not-a-line",
        "import.not-flat",
        "import.not-numbers",
        "import.paper-space",
        "import.parameters-not-numbers",
        "import.place-not-a-number",
        "import.placement-not-a-number",
        "import.proxy",
        "import.region",
        "import.solid",
        "import.subroutine-in-itself",
        "import.tilted",
        "import.tilted-axis",
        "import.too-far",
        "import.too-many-fit-points",
        "import.uneven-height",
        "import.unknown-record",
        "import.wrong-field-count",
    }
)
#: Reasons that concern the whole file, not one entity of it.
ABOUT_FILE: Final = frozenset(
    {
        "import.no-end-mark",
        "unit.cf2-scale-invalid",
        "unit.cf2-scale-undecided",
    }
)
#: Notes on entities that are cut in a way that their author may not see.
READ_DIFFERENTLY: Final = frozenset(
    {
        "import.not-clipped",
    }
)
_WARNED: Final = NOT_SEEN | NOT_READ
#: Number of warnings of a drawing; the rest is counted.
_LONGEST: Final = 8


def import_warnings(drawing: Drawing) -> list[Message]:
    """Return one warning for each layer and reason for which entities were left out.

    The warning for the most entities comes first; if there are many, the last one counts the rest.
    Warnings about the file, and about entities that were read differently, precede them.
    """
    report = drawing.import_report
    dropped = report.outcome == ImportOutcome.DROPPED
    reasons, layers = (
        np.asarray(column, object)[dropped].tolist() for column in (report.reason, report.layer)
    )
    left_out = Counter(zip(reasons, layers, strict=True))
    warnings = [
        Message("import.check-drawing", reason=reason)
        for reason, _ in left_out
        if reason.code in ABOUT_FILE
    ]
    warnings += [
        Message("import.check-objects", objects=objects, reason=note)
        for note, objects in _notes_to_check(report).items()
    ]
    # Of a drawing without edges everything that was left out may have been meant.
    groups = Counter(
        {
            (reason, layer): objects
            for (reason, layer), objects in left_out.items()
            if reason.code in _WARNED or (not len(drawing) and reason.code not in ABOUT_FILE)
        }
    )
    warnings += [
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


def _notes_to_check(report: ImportReport) -> Counter[Message]:
    """Return the notes on entities that were read differently, with the numbers of entities."""
    column = report.reason
    names = column.names if isinstance(column, Repeated) else set(column)
    notes = {
        reason: [note for note in reason.arguments["notes"] if note.code in READ_DIFFERENTLY]
        for reason in names
        if reason.code == "import.kept-changed"
    }
    if not any(notes.values()):
        return Counter()
    return Counter(note for reason in column for note in notes.get(reason, ()))
