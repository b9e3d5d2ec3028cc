"""Warnings about what import left out of a drawing or changed, for everyone who uses the drawing.

The import report gives the outcome of each entity.  Most entities that are left out, such as texts
and dimensions, are never cut, and nobody needs to be warned.  A warning is for geometry that the
author may have meant, or that a reader could not read.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Sequence
from typing import Final

import numpy as np

from knifetip.geometry.columns import I64
from knifetip.messages import Message, printable
from knifetip.model.drawing import Drawing, ImportOutcome
from knifetip.model.words import RepeatedValues

#: Reasons for leaving out an entity because its author does not see it.
NOT_SEEN: Final = frozenset(
    {
        "import.clipped-away",
        "import.hidden",
        "import.hidden-layer",
        "import.invisible",
        "import.layer-frozen",
        "import.layer-never-plotted",
        "import.layer-not-plotted",
        "import.layer-off",
        "import.no-paint",
        "import.no-pen",
        "import.no-stroke-width",
        "import.not-visible",
        "import.other-language",
        "import.outside-page",
        "import.white-line",
    }
)
#: Reasons for leaving out an entity although its author sees it.
NOT_READ: Final = frozenset(
    {
        "import.angles-not-numbers",
        "import.bad-operands",
        "import.bad-path-data",
        "import.bad-place",
        "import.bad-points",
        "import.bad-primitive",
        "import.bad-radius",
        "import.bad-size",
        "import.bad-transform",
        "import.bad-window",
        "import.block-external",
        "import.block-in-itself",
        "import.block-missing",
        "import.coordinate-not-a-number",
        "import.damaged",
        "import.damaged-or-frame",
        "import.extrusion-not-a-number",
        "import.filled-area",
        "import.filled-area-beside-strokes",
        "import.filled-area-on-page",
        "import.font-shape",
        "import.hatch",
        "import.height-not-a-number",
        "import.height-too-far",
        "import.incomplete",
        "import.interrupted-path",
        "import.lightburn-shape",
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
        "import.nothing-named",
        "import.odd-points",
        "import.other-file",
        "import.other-sheet",
        "import.page-ends-early",
        "import.paper-space",
        "import.parameters-not-numbers",
        "import.place-not-a-number",
        "import.placement-not-a-number",
        "import.proxy",
        "import.region",
        "import.short-path-data",
        "import.solid",
        "import.subroutine-in-itself",
        "import.tilted",
        "import.tilted-axis",
        "import.too-far",
        "import.too-many-fit-points",
        "import.uneven-height",
        "import.unknown-instruction",
        "import.unknown-position",
        "import.unknown-record",
        "import.wrong-field-count",
    }
)
#: Notes of entities that are imported with a change which their author may not expect.
CHANGED: Final = frozenset(
    {
        "import.all-outside-page",
        "import.clipped",
        "import.not-clipped",
        "import.partly-outside-page",
    }
)
#: Reasons that are about the file and not about one entity.
OF_FILE: Final = frozenset(
    {
        "import.no-end-mark",
        "import.turned-page",
        "unit.cf2-scale-invalid",
        "unit.cf2-scale-undecided",
    }
)
#: Reasons about the file that are sentences, and so warnings themselves.
SENTENCES: Final = frozenset(
    {
        "import.aspect-ratio",
        "import.conversion-doubtful",
        "import.other-pages",
        "import.other-pages-lines",
    }
)
_WARNED: Final = NOT_SEEN | NOT_READ | OF_FILE | SENTENCES
#: Reasons of entities that were kept or merged.
_OTHER_OUTCOMES: Final = ("import.kept", "import.drawn-twice", "import.drawn-twice-often")
#: Number of warnings about entities; the rest is counted.
_LONGEST: Final = 8


def import_warnings(drawing: Drawing) -> list[Message]:
    """Return the warnings about a file, and one for each layer and reason for other entities.

    The warnings about entities are for those that were left out or changed.  The warning for the
    most entities comes first.  If there are many, the last one counts the rest.
    """
    report = drawing.import_report
    # Of a drawing without edges everything that was left out may have been meant.
    empty = len(drawing) == 0
    causes = {
        reason: found
        for reason in _distinct(report.reason)
        if (found := _causes(reason, or_any=empty))
    }
    if not causes:
        return []
    rows = _rows_of(report.reason, causes)
    reasons, layers = (
        np.asarray(column, object)[rows].tolist() for column in (report.reason, report.layer)
    )
    dropped = (report.outcome[rows] == ImportOutcome.DROPPED).tolist()
    of_file: dict[Message, None] = {}
    groups: Counter[tuple[Message, str, bool]] = Counter()
    for (reason, layer, is_dropped), objects in Counter(
        zip(reasons, layers, dropped, strict=True)
    ).items():
        for cause in causes[reason]:
            if cause.code in SENTENCES:
                of_file[cause] = None
            elif cause.code in OF_FILE:
                of_file[Message("import.check-drawing", reason=cause)] = None
            else:
                groups[cause, layer, is_dropped] += objects
    largest = groups.most_common(_LONGEST)
    warnings = [
        _warning(cause, layer, objects, dropped=is_dropped)
        for (cause, layer, is_dropped), objects in largest
    ]
    if rest := groups.total() - sum(objects for _, objects in largest):
        warnings.append(Message("import.left-out-further", objects=rest))
    return [*of_file, *warnings]


def _distinct(column: Sequence[Message]) -> Sequence[Message]:
    """Return the different messages of a column."""
    return column.names if isinstance(column, RepeatedValues) else list(dict.fromkeys(column))


def _rows_of(column: Sequence[Message], wanted: Container[Message]) -> I64:
    """Return the rows of a column that contain one of some messages, ascending."""
    if isinstance(column, RepeatedValues):
        numbers = [number for number, name in enumerate(column.names) if name in wanted]
        return np.flatnonzero(np.isin(column.number % len(column.names), numbers))
    return np.array([row for row, reason in enumerate(column) if reason in wanted], np.int64)


def _causes(reason: Message, *, or_any: bool) -> tuple[Message, ...]:
    """Return the parts of the reason of an entity of which the user must be warned.

    ``or_any`` is whether every reason for leaving out an entity is one of them.
    """
    if reason.code == "import.kept-changed":
        return tuple(note for note in reason.arguments["notes"] if note.code in CHANGED)
    left_out = reason.code not in _OTHER_OUTCOMES
    return (reason,) if reason.code in _WARNED or (or_any and left_out) else ()


def _warning(cause: Message, layer: str, objects: int, *, dropped: bool) -> Message:
    """Return the warning about the entities of a layer that were left out, or were changed."""
    if not layer:
        code = "import.left-out" if dropped else "import.changed"
        return Message(code, objects=objects, reason=cause)
    code = "import.left-out-on-layer" if dropped else "import.changed-on-layer"
    return Message(code, objects=objects, reason=cause, layer=printable(layer))
