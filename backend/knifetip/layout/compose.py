"""compose: put the edges of several drawings together on one sheet.

A copy of a drawing is its edges after they were mirrored at the Y axis, turned and moved.  The
result is a drawing in which the lower left corner of the sheet is the origin.  It contains, copy by
copy, all edges that are made, or whose line type is not known yet, in the order of their drawing.
Ignored edges are left out.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.errors import DrawingTooLarge
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import KEPT, Drawing, ImportOutcome, ImportReport, extents
from knifetip.model.layout import Layout, Position
from knifetip.model.words import RepeatedValues

#: Most edges of all copies on a sheet.
MOST_EDGES: Final = 1_000_000
#: Decimals to which a copy is moved (mm), so that two copies side by side meet exactly.
_DECIMALS: Final = 6


@dataclass(frozen=True, eq=False, slots=True)
class Source:
    """A drawing that is placed, with the line types of its edges."""

    drawing: Drawing
    dieline: Dieline


@dataclass(frozen=True, eq=False, slots=True)
class Copy:
    """One copy of a drawing on the sheet."""

    source: int  #: index of its drawing in the list of the sources
    placed: int  #: index of its entry in ``Layout.placed``
    position: Position
    shift: F64  #: (2,) movement of the mirrored and turned drawing (mm)
    box: F64  #: (4,) x min, y min, x max, y max on the sheet (mm)


@dataclass(frozen=True, eq=False, slots=True)
class ComposedSheet:
    """The edges of all copies on a sheet, as one drawing of n edges."""

    drawing: Drawing
    dieline: Dieline
    copies: tuple[Copy, ...]
    copy: I32  #: (n,) index into ``copies``
    row: I32  #: (n,) row of the edge in its own drawing


@dataclass(frozen=True, eq=False, slots=True)
class _Columns:
    """The edges of a drawing that are copied, at the origin."""

    ends: F64
    bulge: F64
    rows: I64


def compose(layout: Layout, sources: Sequence[Source], source_of: Sequence[int]) -> ComposedSheet:
    """Return the drawing of a whole sheet.

    Parameters
    ----------
    layout
        The sheet and what is placed on it.
    sources
        The drawings, each once.
    source_of
        Index into ``sources`` for each entry of ``layout.placed``.

    Raises
    ------
    DrawingTooLarge
        All copies together have more than ``MOST_EDGES`` edges.
    """
    worked = [np.flatnonzero(one.dieline.line_type != LineType.IGNORED) for one in sources]
    copies: list[Copy] = []
    ends: list[F64] = []
    bulge: list[F64] = []
    total = 0
    for index, (placed, number) in enumerate(zip(layout.placed, source_of, strict=True)):
        rows = worked[number]
        total += placed.count * len(rows)
        if total > MOST_EDGES:
            raise DrawingTooLarge("layout.too-many-edges", limit=MOST_EDGES)
        dieline = sources[number].dieline
        turned = dieline.ends[rows] @ placement_matrix(placed.turn, mirror=placed.mirror)
        bow = -dieline.bulge[rows] if placed.mirror else dieline.bulge[rows]
        box = extents(turned, bow)
        for corner in placed.corners(box[2] - box[0], box[3] - box[1]):
            shift = np.round(np.array(corner) - box[:2], _DECIMALS)
            position = Position(corner, placed.turn, placed.mirror)
            copies.append(Copy(number, index, position, shift, box + np.tile(shift, 2)))
            ends.append(turned + shift)
            bulge.append(bow)
    counts = np.array([len(one) for one in bulge], np.int64)
    copy = np.repeat(np.arange(len(copies), dtype=np.int32), counts)
    row = np.concatenate([worked[one.source] for one in copies]).astype(np.int32)
    source = np.array([one.source for one in copies])[copy]
    joined = _Columns(np.concatenate(ends), np.concatenate(bulge), row.astype(np.int64))
    mirrored = np.array([one.position.mirror for one in copies])[copy]
    drawing = _drawing(sources, source, joined, copy)
    dieline = _dieline(sources, source, joined, copy, mirrored, drawing.fit_error)
    return ComposedSheet(drawing, dieline, tuple(copies), copy, row)


def placement_matrix(turn: float, *, mirror: bool) -> F64:
    """Return the matrix by which points, as rows, are multiplied to mirror and turn them, (2, 2).

    The points are mirrored at the Y axis first.  Quarter turns are exact.

    Parameters
    ----------
    turn : °
        Angle of the turn, counter-clockwise.
    mirror
        Whether the points are mirrored.
    """
    quarters, rest = divmod(turn, 90.0)
    if rest == 0.0:
        cosine, sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarters) % 4]
    else:
        cosine, sine = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    turned = np.array([[cosine, sine], [-sine, cosine]])
    return turned * np.array([[-1.0], [1.0]]) if mirror else turned


def _drawing(sources: Sequence[Source], source: I64, edges: _Columns, copy: I32) -> Drawing:
    """Return the drawing of all copies.

    ``source``, ``copy`` (n,): index of drawing and copy of each edge.  ``edges.rows``: row of each
    edge in its drawing.
    """
    layers = _merge([one.drawing.layers for one in sources])
    linetypes = _merge([one.drawing.linetypes for one in sources])

    def gather(name: str, indices: Sequence[I32] | None = None) -> I32:
        result = np.zeros(len(source), np.int32)
        for number, one in enumerate(sources):
            mine = source == number
            values = getattr(one.drawing, name)[edges.rows[mine]]
            result[mine] = values if indices is None else indices[number][values]
        return result

    fit_error = np.zeros(len(source))
    handles = np.zeros(len(source), object)
    for number, one in enumerate(sources):
        mine = source == number
        fit_error[mine] = one.drawing.fit_error[edges.rows[mine]]
        handles[mine] = np.array(one.drawing.handles, object)[edges.rows[mine]]
    row = np.arange(len(source), dtype=np.int32)
    layer = gather("layer", layers[1])
    report = ImportReport(
        handle=[f"{1 + one}:{handle}" for one, handle in zip(copy.tolist(), handles, strict=True)],
        kind=RepeatedValues(("",), np.zeros(len(row), np.int32)),
        layer=RepeatedValues(layers[0], layer),
        outcome=np.full(len(row), ImportOutcome.KEPT, np.uint8),
        reason=RepeatedValues((KEPT,), np.zeros(len(row), np.int32)),
        length=np.zeros(len(row)),
    )
    return Drawing(
        ends=edges.ends,
        bulge=edges.bulge,
        entity=row,
        layer=layer,
        colour=gather("colour"),
        true_colour=gather("true_colour"),
        linetype=gather("linetype", linetypes[1]),
        layers=layers[0],
        linetypes=linetypes[0],
        import_report=report,
        unit="mm",
        evidence=Message("unit.of-layout"),
        fit_error=fit_error,
        line_width=gather("line_width"),
    )


def _dieline(
    sources: Sequence[Source],
    source: I64,
    edges: _Columns,
    copy: I32,
    mirrored: Bool,
    fit_error: F64,
) -> Dieline:
    """Return the dieline of all copies, with the reasons for their line types."""
    count = len(source)
    line_type, rule = np.zeros(count, np.uint8), np.zeros(count, np.int32)
    confidence = np.zeros(count)
    face, part = np.zeros((count, 2), np.int32), np.zeros(count, np.int32)
    rules: list[Message] = []
    alternatives: list[tuple[LineType, ...]] = []
    for number, one in enumerate(sources):
        mine, dieline = source == number, one.dieline
        rows = edges.rows[mine]
        line_type[mine] = dieline.line_type[rows]
        confidence[mine] = dieline.confidence[rows]
        rule[mine] = np.where(dieline.rule[rows] < 0, -1, dieline.rule[rows] + len(rules))
        face[mine], part[mine] = dieline.face[rows], dieline.part[rows]
        rules += dieline.rules
        alternatives += dieline.alternatives
    # Left and right change places in a mirror; faces and parts of each copy have own numbers.
    face[mirrored] = face[mirrored][:, ::-1]
    for column in (face, part):
        wide = copy[:, None] if column.ndim == 2 else copy
        column[...] = np.where(column < 0, -1, column + wide * (1 + column.max(initial=0)))
    return Dieline(
        edges.ends,
        edges.bulge,
        line_type,
        np.arange(count, dtype=np.int32),
        rule,
        confidence,
        tuple(rules),
        tuple(alternatives),
        face,
        part,
        fit_error,
    )


def _merge(lists: Sequence[tuple[str, ...]]) -> tuple[tuple[str, ...], list[I32]]:
    """Return the distinct names of several lists, and the new index of each name of each list."""
    index: dict[str, int] = {}
    indices = [
        np.array([index.setdefault(name, len(index)) for name in names], np.int32)
        for names in lists
    ]
    return tuple(index), indices
