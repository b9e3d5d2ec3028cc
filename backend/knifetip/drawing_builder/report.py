"""Rows of the import report, one per entity of a file, which a format reader writes.

``assemble`` makes the ``ImportReport`` of a ``Drawing`` from them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.messages import Message
from knifetip.model.drawing import LocationBoxes


class SharedOutcome(NamedTuple):
    """One outcome for many entities: the report rows of the entities, and a reason or notes.

    If the entities are dropped, ``dropped`` is the reason; otherwise ``notes`` are the changes that
    were made to each entity.
    """

    rows: I64
    dropped: Message | None  #: reason for dropping the rows; None if they are drawn
    notes: Sequence[Message] = ()  #: changes made to the entities


@dataclass(slots=True)
class ReportRows:
    """Columns with one row per entity of a file, and reasons and notes for some of the rows.

    The items of ``shared`` apply to several rows each.  A row may have notes of its own as well;
    these follow the notes of the item.
    """

    handle: Sequence[str] = field(default_factory=list)
    kind: Sequence[str] = field(default_factory=list)
    layer: Sequence[str] = field(default_factory=list)
    dropped: dict[int, Message] = field(default_factory=dict)  #: reason for dropping, by row
    #: changes made to the entity, by row
    notes: dict[int, list[Message]] = field(default_factory=dict)
    shared: list[SharedOutcome] = field(default_factory=list)  #: each row is in at most one item
    #: boxes of entities without edges in file units, NaN if the location is unknown
    location_boxes: list[LocationBoxes] = field(default_factory=list)


@dataclass(slots=True)
class ReportWriter(ReportRows):
    """Rows of the import report of a file, to which a format reader adds one row per entity."""

    handle: list[str] = field(default_factory=list)
    kind: list[str] = field(default_factory=list)
    layer: list[str] = field(default_factory=list)

    def row(
        self,
        handle: str,
        kind: str,
        layer: str,
        dropped: Message | None = None,
        notes: Iterable[Message] = (),
    ) -> int:
        """Add the row of an entity to the report and return the index of the row.

        Parameters
        ----------
        handle, kind, layer
            Handle and kind of the entity, and name of its layer.
        dropped
            Reason for dropping the entity; None if the entity is kept.
        notes
            Changes made to the entity.
        """
        self.handle.append(handle)
        self.kind.append(kind)
        self.layer.append(layer)
        number = len(self.handle) - 1
        if dropped:
            self.dropped[number] = dropped
        if changes := list(notes):
            self.notes[number] = changes
        return number

    def set_location(self, row: int, box: Sequence[float] | F64) -> None:
        """Record the bounding box of an entity without segments.

        Parameters
        ----------
        row
            Index of the entity's row in the report.
        box : (4,)
            x min, y min, x max, y max (file units).
        """
        boxes = np.array([box], np.float64)
        self.location_boxes.append(LocationBoxes(np.array([row], np.int32), boxes))


def too_far(coordinate: float, limit: float) -> Message:
    """Return the reason for dropping an entity that has a coordinate beyond the limit.

    ``coordinate`` and ``limit`` are in file units; the coordinate may be NaN or infinite.
    """
    if not np.isfinite(coordinate):
        return Message("import.coordinate-not-a-number")
    return Message("import.too-far", coordinate=coordinate, limit=limit)


def curves_fitted(pieces: int, tolerance: float, *, relative: bool) -> Message:
    """Return the note in the import report for curves that were approximated by lines and arcs.

    Parameters
    ----------
    pieces
        Number of lines and arcs.
    tolerance
        Tolerance of the approximation in file units.
    relative
        Whether the tolerance depends on the size of the drawing, because its unit is unknown.
    """
    code = "import.curves-fitted-relative" if relative else "import.curves-fitted"
    return Message(code, pieces=pieces, tolerance=tolerance)
