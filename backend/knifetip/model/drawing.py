"""Records of a drawing: its edges in millimetres, its annotations and its import report."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from typing import Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, U8, freeze
from knifetip.messages import Message
from knifetip.model.unit import UnitHint


class ImportOutcome(IntEnum):
    """The outcome of import for an entity of the file, or of cleaning for an edge.

    The entity or edge was kept, was merged into others, or was dropped.
    """

    KEPT = 0
    MERGED = 1
    DROPPED = 2


class LocationBoxes(NamedTuple):
    """Bounding boxes of k entities without edges, which show where the entities are in the drawing.

    Each box has the row of its entity in the import report.
    """

    rows: I32  #: (k,) row of each entity in the import report, ascending
    box: F64  #: (k, 4) x min, y min, x max, y max (mm; file units while the unit is unknown)


NO_BOXES: Final = LocationBoxes(
    freeze(np.zeros(0, np.int32), np.int32, 0), freeze(np.zeros((0, 4)), np.float64, 0, 4)
)


#: Line width of edges for which the file states none.
NO_LINE_WIDTH: Final = -1

#: Reason for entities that were kept unchanged.
KEPT: Final = Message("import.kept")


@dataclass(frozen=True, eq=False, slots=True)
class ImportReport:
    """The import report of a file: outcome and reason for each of m entities.

    An entity in a block has one row for each INSERT of the block.  Such a row contains the kind of
    the entity, and a handle that consists of the handle of the INSERT, a slash and the handle of
    the entity.
    """

    handle: Sequence[str]  #: (m,) handle in the file, or ``#17`` for the 17th entity
    kind: Sequence[str]  #: (m,) LINE, ARC, INSERT …
    layer: Sequence[str]  #: (m,) layer name as in the file
    outcome: U8  #: (m,) ImportOutcome
    reason: Sequence[Message]  #: (m,) reason for the outcome
    length: F64  #: (m,) length of the edges of the entity (mm; file units if the unit is unknown)
    block: Sequence[
        str
    ] = ()  #: (m,) name of the block that contains the entity, "" for none; () if unknown
    location_boxes: LocationBoxes = NO_BOXES  #: boxes of entities without edges

    def __post_init__(self) -> None:
        rows = len(self.handle)
        object.__setattr__(self, "outcome", freeze(self.outcome, np.uint8, rows))
        object.__setattr__(self, "length", freeze(self.length, np.float64, rows))
        same = len(self.kind) == len(self.layer) == len(self.reason) == rows
        if not same or len(self.block) not in (0, rows):
            raise ValueError("import report columns differ in length")
        box_rows, box = self.location_boxes
        box = freeze(box, np.float64, len(box_rows), 4)
        object.__setattr__(
            self, "location_boxes", LocationBoxes(freeze(box_rows, np.int32, len(box)), box)
        )

    def __len__(self) -> int:
        return len(self.handle)


class Annotation(NamedTuple):
    """A text or a dimension of the drawing; annotations are never machined."""

    text: str  #: without format codes; for a dimension its text override
    x: float  #: insertion point (mm; file units if the unit is unknown)
    y: float
    height: float  #: height of the letters, 0 if the file does not state it
    measure: float  #: length that a dimension measures; NaN for other kinds
    kind: str  #: TEXT, MTEXT, ATTRIB, DIMENSION …
    layer: str

    def scaled(self, divisor: float, factor: float) -> Annotation:
        """Return the annotation with its position and lengths converted to a different unit.

        They are divided by ``divisor`` and multiplied by ``factor``.  The field ``measure`` is NaN
        for texts and stays NaN.
        """
        if divisor == factor == 1.0:
            return self
        return Annotation(
            self.text,
            self.x / divisor * factor,
            self.y / divisor * factor,
            self.height / divisor * factor,
            self.measure / divisor * factor,
            self.kind,
            self.layer,
        )


@dataclass(frozen=True, eq=False, slots=True)
class Drawing:
    """A drawing of n edges in the order of the file: lines, and arcs of at most 180°."""

    ends: F64  #: (n, 2, 2) mm; in file units while ``unit`` is empty
    bulge: F64  #: (n,) tan(sweep / 4), |bulge| ≤ 1
    entity: I32  #: (n,) row of the entity of each edge in ``import_report``
    layer: I32  #: (n,) index into ``layers``
    colour: I32  #: (n,) AutoCAD colour index 1 … 255, BYLAYER and BYBLOCK resolved
    true_colour: I32  #: (n,) 0xRRGGBB, -1 if the entity has none
    linetype: I32  #: (n,) index into ``linetypes``, BYLAYER resolved
    layers: tuple[str, ...]
    linetypes: tuple[str, ...]
    import_report: ImportReport
    unit: str  #: "mm", "cm", "m", "in", "ft"; empty if unknown
    evidence: Message  #: source of the unit, or the reason why it is unknown
    stated: str = ""  #: unit in the header of the file, used or not
    annotations: tuple[Annotation, ...] = ()  #: annotations of model space, in file order
    hints: tuple[UnitHint, ...] = ()  #: further header entries about the unit
    #: (n,) greatest distance of each edge from the curve of the file that it approximates (mm; file
    #: units while the unit is unknown); 0 for an edge that the file contains; infinite if a
    #: version that did not measure it stored the drawing; default 0
    fit_error: F64 = field(default_factory=lambda: np.zeros(0))
    #: (n,) width with which the file draws each edge (1/100 mm; while the unit is unknown, a width
    #: in file units counts as one in mm), 0 for the thinnest line; NO_LINE_WIDTH if the file states
    #: none; default NO_LINE_WIDTH
    line_width: I32 = field(default_factory=lambda: np.zeros(0, np.int32))

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "ends", freeze(self.ends, np.float64, -1, 2, 2))
        rows = len(self.ends)
        put(self, "bulge", freeze(self.bulge, np.float64, rows))
        fit_error = self.fit_error if len(self.fit_error) else np.zeros(rows)
        put(self, "fit_error", freeze(fit_error, np.float64, rows))
        if len(self.line_width) == 0:
            put(self, "line_width", np.full(rows, NO_LINE_WIDTH, np.int32))
        for name in ("entity", "layer", "colour", "true_colour", "linetype", "line_width"):
            put(self, name, freeze(getattr(self, name), np.int32, rows))

    def __len__(self) -> int:
        return len(self.ends)

    @property
    def handles(self) -> list[str]:
        """Handle of the entity to which each of the n edges belongs: a list of n strings."""
        every = list(self.import_report.handle)
        return [every[row] for row in self.entity.tolist()]

    @property
    def lengths(self) -> F64:
        """Length of each edge, shape (n,) (mm)."""
        return arc.length(self.ends[:, 0], self.ends[:, 1], self.bulge)

    @property
    def bounds(self) -> F64:
        """Bounding box of all edges, (4,): x min, y min, x max, y max (mm).

        All four values are 0 if there are no edges.
        """
        return extents(self.ends, self.bulge)


def extents(ends: F64, bulge: F64) -> F64:
    """Return the bounding box of n edges, (4,): x min, y min, x max, y max (mm).

    All four values are 0 if there are no edges.

    Parameters
    ----------
    ends : (n, 2, 2)
        Start and end point of each edge (mm).
    bulge : (n,)
        tan(sweep / 4) of each edge.
    """
    if len(ends) == 0:
        return np.zeros(4)
    boxes = arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge)
    # By column, since reductions of rows of two numbers are slow.
    low, high = boxes[:, :2].T, boxes[:, 2:].T
    return np.array([low[0].min(), low[1].min(), high[0].max(), high[1].max()])
