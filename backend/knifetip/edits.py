"""Apply a user's edits to the geometry of a drawing: move ends, add lines, arcs and circles.

The edges of the file keep their rows, because line types and options of jobs refer to rows.  Added
edges follow them, on a layer of their own.  To remove an edge, give it the line type ``ignored``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final, NamedTuple

import numpy as np

from knifetip.errors import EditRefused
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, U8
from knifetip.geometry.tolerance import POINT
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.drawing import NO_LINE_WIDTH, Drawing, ImportOutcome, ImportReport
from knifetip.model.edit import AddedCircle, AddedLine, Edits, MovedEnd

#: Layer of added edges.
LAYER: Final = "Added by hand"
#: The place of an end in an edit may differ this much from the drawing (mm).
_SAME_PLACE: Final = 0.001
_BLACK: Final = 7  # AutoCAD colour index
_CONTINUOUS: Final = "CONTINUOUS"


class _Added(NamedTuple):
    """An edge that an edit adds."""

    ends: F64  # (2, 2) mm
    bulge: float
    handle: str


def apply_edits(drawing: Drawing, edits: Edits) -> Drawing:
    """Return a drawing of n edges with edits applied in order, which has m ≥ n edges.

    Rows in an edit may refer to edges that earlier edits have added.

    Raises
    ------
    EditRefused
        The drawing has no unit; an edge does not exist, its end is elsewhere, or it would have no
        length.
    """
    if not edits:
        return drawing
    if not drawing.unit:
        raise EditRefused("edit.no-unit")
    moved = drawing.ends.copy()
    added: list[_Added] = []
    for number, edit in enumerate(edits, start=1):
        match edit:
            case MovedEnd():
                _move_end(_ends_of(edit, moved, added, number), edit, number)
                continue
            case AddedLine():
                ends = np.array([edit.start, edit.end])
                new = [_Added(ends, edit.bulge, _handle(number, edit))]
            case AddedCircle():
                new = _semicircles(edit, number)
        for edge in new:
            _require_length(edge.ends, number)
        added += new
    return _with_added(drawing, moved, added)


def _ends_of(edit: MovedEnd, moved: F64, added: list[_Added], number: int) -> F64:
    """Return the ends of the edge that an edit moves, (2, 2) (mm), to be changed in place."""
    if edit.edge < len(moved):
        return np.asarray(moved[edit.edge])
    if edit.edge < len(moved) + len(added):
        return added[edit.edge - len(moved)].ends
    raise EditRefused(
        "edit.no-such-edge", number=number, edge=edit.edge, count=len(moved) + len(added)
    )


def _move_end(ends: F64, edit: MovedEnd, number: int) -> None:
    point = ends[0 if edit.end == "start" else 1]
    if math.dist(point, edit.before) > _SAME_PLACE:
        raise EditRefused(
            "edit.end-elsewhere", number=number, edge=edit.edge, x=point[0], y=point[1]
        )
    point[:] = edit.to
    _require_length(ends, number)


def _require_length(ends: F64, number: int) -> None:
    if math.dist(*ends) < POINT:
        raise EditRefused("edit.no-length", number=number)


def _semicircles(edit: AddedCircle, number: int) -> list[_Added]:
    x, y = edit.centre
    right, left = (x + edit.radius, y), (x - edit.radius, y)
    handle = _handle(number, edit)
    return [_Added(np.array(ends), 1.0, handle) for ends in ((right, left), (left, right))]


def _with_added(drawing: Drawing, moved: F64, added: list[_Added]) -> Drawing:
    """Return a drawing of n edges with new ends, (n, 2, 2) (mm), and with added edges."""
    if not added:
        return replace(drawing, ends=moved)
    count = len(added)
    report = drawing.import_report
    ends = np.array([edge.ends for edge in added])
    bulge = np.array([edge.bulge for edge in added])

    def extended(column: I32, values: I64 | int) -> I32:
        return np.concatenate([column, np.full(count, values)]).astype(np.int32)

    return replace(
        drawing,
        ends=np.concatenate([moved, ends]),
        bulge=np.concatenate([drawing.bulge, bulge]),
        entity=extended(drawing.entity, np.arange(len(report), len(report) + count)),
        layer=extended(drawing.layer, len(drawing.layers)),
        colour=extended(drawing.colour, _BLACK),
        true_colour=extended(drawing.true_colour, -1),
        linetype=extended(drawing.linetype, len(drawing.linetypes)),
        layers=(*drawing.layers, LAYER),
        linetypes=(*drawing.linetypes, _CONTINUOUS),
        import_report=ImportReport(
            handle=[*report.handle, *(edge.handle for edge in added)],
            kind=[*report.kind, *("ARC" if edge.bulge else "LINE" for edge in added)],
            layer=[*report.layer, *[LAYER] * count],
            outcome=np.concatenate([report.outcome, np.full(count, ImportOutcome.KEPT)]),
            reason=[*report.reason, *[Message("import.added-by-hand")] * count],
            length=np.concatenate([report.length, arc.length(ends[:, 0], ends[:, 1], bulge)]),
            block=[*report.block, *[""] * count] if report.block else (),
            location_boxes=report.location_boxes,
        ),
        fit_error=np.concatenate([drawing.fit_error, np.zeros(count)]),
        line_width=extended(drawing.line_width, NO_LINE_WIDTH),
    )


def with_types_of_added(
    overrides: U8, edits: Edits, handles: Sequence[str], known: Sequence[str]
) -> U8:
    """Return the overrides of m edges, with the line types of edges that edits have newly added.

    Parameters
    ----------
    overrides : (m,)
        For each edge the LineType that the user has set, or ``NO_OVERRIDE``.
    edits
        All edits of the drawing.
    handles : (m,)
        Handles of the edges.
    known
        Handles of the edges before the last change.  An edge that had been added before keeps its
        override, since the user may have changed it.
    """
    types = {_handle(number, edit): edit.type for number, edit in _numbered(edits)}
    before = set(known)
    after = overrides.copy()
    for row, handle in enumerate(handles):
        if handle in types and handle not in before:
            after[row] = LineType.from_word(types[handle])
    return after


def _numbered(edits: Edits) -> Iterator[tuple[int, AddedLine | AddedCircle]]:
    for number, edit in enumerate(edits, start=1):
        if not isinstance(edit, MovedEnd):
            yield number, edit


def _handle(number: int, edit: AddedLine | AddedCircle) -> str:
    """Return the handle of what an edit adds, by its number and its line type."""
    return f"edit-{number}-{edit.type}"
