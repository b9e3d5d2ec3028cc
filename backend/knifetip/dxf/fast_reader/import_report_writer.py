"""import_report_writer: compute the import report and the annotations of a scanned DXF file.

They are computed with NumPy for all entities at once.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from typing import NamedTuple

import numpy as np

from knifetip.drawing_builder.report import ReportRows, ReportWriter, SharedOutcome
from knifetip.dxf.annotations import (
    annotation,
    annotation_of_lines,
    has_formatting,
    plain_annotations,
)
from knifetip.dxf.ezdxf_reader.block_expansion import (
    IN_PAPER_SPACE,
    insert_note,
    no_geometry_reason,
)
from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader.handle_set import paths_of
from knifetip.dxf.fast_reader.tables import Tables
from knifetip.dxf.location_boxes import boxes_of_entities, transformed_box
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.parallel import parallel_pair
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.drawing import Annotation, LocationBoxes
from knifetip.model.words import Repeated


class Variant(NamedTuple):
    """Layers, outcomes and style of the entities of one block, for INSERTs of one style."""

    layers: list[str]  #: layer of each entity
    outcomes: dict[
        int, tuple[Message | None, tuple[Message, ...]]
    ]  #: reason for dropping and notes, by index of the entity in the block
    first: int  #: index of the first style of its segments


class Inserts(NamedTuple):
    """The k INSERTs in model space whose blocks are processed in columns, not one by one."""

    position: I64  #: (k,) index of each INSERT among the entities of model space
    block: I64  #: (k,) row of the block of each INSERT
    variant: I64  #: (k,) index of the variant of each INSERT
    variants: list[Variant]
    move: F64  #: (k, 2, 3) linear map and translation, from block to model space


class Order(NamedTuple):
    """The n entities of model space, and their rows in the import report."""

    rows: I64  #: (n,) row of each entity in the Scan
    report_row: I64  #: (n,) row of each entity in the import report
    drawn: Bool  #: (n,) whether the segments of the entity are computed in columns
    expanded: I64  #: (w,) row in the import report of each row of the expansion


def drop_reason(tables: Tables, row: int) -> Message | None:
    """Return the reason for dropping an entity, None if the entity has geometry.

    ``row`` is the row of the entity in the Scan.
    """
    line = tables.found.entity[row].tolist()
    if line[f.PAPER]:
        return IN_PAPER_SPACE
    kind = line[f.KIND]
    if kind == f.OTHER:
        return no_geometry_reason(tables.words[line[f.WORD]])
    if kind in (f.LWPOLYLINE, f.POLYLINE) and line[f.COUNT] < 2:
        return Message("import.few-vertices", vertices=line[f.COUNT])
    return None


def report_rows(
    tables: Tables, order: Order, inserts: Inserts, expansion: ReportWriter
) -> ReportRows:
    """Return all rows of the import report of a file.

    They are the rows of the entities of model space, of the entities of blocks for each INSERT, and
    of the entities that were expanded one by one; ``expansion`` contains the last.
    """
    entity, span = tables.found.entity, tables.span
    numbers = {name: number for number, name in enumerate(tables.names)}
    silent = numbers.setdefault("0", len(numbers))
    low, size = (
        np.array([span.get(block, (0, 0)) for block in range(len(tables.found.block))], np.int64)
        .reshape(-1, 2)[inserts.block]
        .T
    )
    # For entities in blocks: row, entity and INSERT.
    step = np.arange(size.sum()) - np.repeat(np.cumsum(size) - size, size)
    under = np.repeat(order.report_row[inserts.position] + 1, size) + step
    inserted = np.repeat(low, size) + step
    # An expanded entity has its own row, followed by the rows of its block.
    total = 1 + int(
        max(column.max(initial=-1) for column in (order.report_row, under, order.expanded))
    )
    own, insert = np.empty(total, np.int64), np.full(total, -1, np.int64)
    own[order.report_row], own[under] = order.rows, inserted
    insert[under] = np.repeat(order.rows[inserts.position], size)
    kind, layer = np.empty(total, np.int32), np.empty(total, np.int32)
    kind[order.report_row], kind[under] = entity[order.rows, f.WORD], entity[inserted, f.WORD]
    layer[order.report_row] = entity[order.rows, f.LAYER]
    layer[layer < 0] = silent
    layers = [[numbers[name] for name in variant.layers] for variant in inserts.variants]
    begin = np.cumsum([0, *map(len, layers)])[inserts.variant]
    layer[under] = np.array(list(chain.from_iterable(layers)), np.int32)[
        np.repeat(begin, size) + step
    ]
    # Last, because these rows replace those of the entity.
    own[order.expanded] = len(entity) + np.arange(len(order.expanded))
    for column, words in ((kind, expansion.kind), (layer, expansion.layer)):
        column[order.expanded] = [numbers.setdefault(word, len(numbers)) for word in words]
    there = order.expanded.tolist()
    left = ~order.drawn
    left[inserts.position] = False
    left[np.isin(order.report_row, order.expanded)] = False
    dropped = np.flatnonzero(left)
    handles, (alike, standing) = parallel_pair(
        lambda: paths_of(tables.handles, expansion.handle, own, insert),
        lambda: (
            [*_of_sheet(tables, order, inserts, dropped), *_of_blocks(order, inserts)],
            [*_on_sheet(tables, order, dropped), *_in_blocks(tables, order, inserts)],
        ),
    )
    expanded = [
        LocationBoxes(order.expanded[one.rows].astype(np.int32), one.box)
        for one in expansion.location_boxes
    ]
    return ReportRows(
        handles,
        Repeated(tuple(numbers), kind),
        Repeated(tuple(numbers), layer),
        {there[row]: why for row, why in expansion.dropped.items()},
        {there[row]: notes for row, notes in expansion.notes.items()},
        alike,
        expanded + standing,
    )


def _of_sheet(
    tables: Tables, order: Order, inserts: Inserts, dropped: I64
) -> Iterator[SharedOutcome]:
    """Yield outcomes of the entities in model space; each outcome applies to several entities.

    Parameters
    ----------
    dropped
        Indices, among the entities of model space, of the entities that are dropped.
    """
    entity, rows = tables.found.entity, order.rows
    paper, sort, word, count = (
        entity[rows[dropped], column] for column in (f.PAPER, f.KIND, f.WORD, f.COUNT)
    )
    # For texts, which have the kind OTHER, the column COUNT is the length, which is irrelevant.
    first, kind = unique_rows(paper, sort, word, np.where(sort == f.OTHER, 0, count))
    for position, same in zip(first.tolist(), _grouped(kind, len(first)), strict=True):
        yield SharedOutcome(
            order.report_row[dropped[same]], drop_reason(tables, int(rows[dropped[position]]))
        )
    of_layer = {
        layer: notes
        for layer in np.flatnonzero(np.bincount(entity[rows, f.LAYER] + 1)).tolist()
        if (notes := tables.styles.notes(tables.names[layer - 1] if layer else "0"))
    }
    for layer, notes in of_layer.items():
        there = order.drawn & (entity[rows, f.LAYER] == layer - 1)
        yield SharedOutcome(order.report_row[there], None, notes)
    layer = entity[rows[inserts.position], f.LAYER]
    first, kind = unique_rows(layer, inserts.block)
    for one, same in zip(first.tolist(), _grouped(kind, len(first)), strict=True):
        note = insert_note(tables.block_name(int(inserts.block[one])))
        notes = of_layer.get(int(layer[one]) + 1, ())
        yield SharedOutcome(order.report_row[inserts.position[same]], None, (note, *notes))


def _of_blocks(order: Order, inserts: Inserts) -> Iterator[SharedOutcome]:
    """Yield outcomes of entities in blocks; each outcome applies to several INSERTs of a block."""
    of_variant = _grouped(inserts.variant, len(inserts.variants))
    for variant, same in zip(inserts.variants, of_variant, strict=True):
        first = order.report_row[inserts.position[same]] + 1
        for number, (dropped, notes) in variant.outcomes.items():
            yield SharedOutcome(first + number, dropped, notes)


def boxes(tables: Tables, rows: I64) -> F64:
    """Return bounding boxes that show where n entities are, (n, 4), in their own coordinates.

    ``rows`` are the rows of the entities in the Scan.
    """
    entity = tables.found.entity
    words, kind = np.unique(entity[rows, f.WORD], return_inverse=True)
    kinds = [tables.words[word] for word in words.tolist()]
    spans = np.column_stack([entity[rows, f.START], entity[rows, f.END]]).astype(np.int64)
    return boxes_of_entities(tables.found.data, kinds, kind, spans)


def _on_sheet(tables: Tables, order: Order, dropped: I64) -> Iterator[LocationBoxes]:
    """Yield the bounding boxes of the dropped entities in model space.

    ``dropped`` contains the indices of these entities among the entities of model space.
    """
    dropped = dropped[tables.found.entity[order.rows[dropped], f.PAPER] == 0]
    if len(dropped):
        yield LocationBoxes(
            order.report_row[dropped].astype(np.int32), boxes(tables, order.rows[dropped])
        )


def _in_blocks(tables: Tables, order: Order, inserts: Inserts) -> Iterator[LocationBoxes]:
    """Yield the bounding boxes of dropped entities in the blocks that INSERTs place.

    The boxes are in the coordinates of model space.
    """
    of_variant = _grouped(inserts.variant, len(inserts.variants))
    for variant, same in zip(inserts.variants, of_variant, strict=True):
        numbers = np.array(
            [number for number, (why, _) in variant.outcomes.items() if why], np.int64
        )
        rows = tables.span.get(int(inserts.block[same[0]]), (0, 0))[0] + numbers
        on_model = tables.found.entity[rows, f.PAPER] == 0
        numbers, rows = numbers[on_model], rows[on_model]
        if not len(rows):
            continue
        first = np.repeat(order.report_row[inserts.position[same]] + 1, len(rows))
        move = np.repeat(inserts.move[same], len(rows), axis=0)
        box = np.tile(boxes(tables, rows), (len(same), 1))
        yield LocationBoxes(
            (first + np.tile(numbers, len(same))).astype(np.int32),
            transformed_box(box, move[:, :, :2], move[:, :, 2]),
        )


def _grouped(kind: I64, kinds: int) -> list[I64]:
    """Return ``kinds`` arrays; array i contains the indices at which ``kind`` is equal to i."""
    order = np.argsort(kind, kind="stable")
    return np.split(order, np.cumsum(np.bincount(kind, minlength=kinds))[:-1])[:kinds]


def read_annotations(tables: Tables, rows: I64) -> tuple[Annotation, ...]:
    """Return the annotations of the texts and dimensions in model space.

    ``rows`` are the rows in the Scan of all texts and dimensions that are in no block; those that
    are in paper space are left out.
    """
    entity, data = tables.found.entity, tables.found.data
    rows = rows[entity[rows, f.PAPER] == 0]
    # Column by column: creating a list for each row would double the time.
    words, layers, first, count = (
        entity[rows, column].tolist() for column in (f.WORD, f.LAYER, f.FIRST, f.COUNT)
    )
    kinds = [tables.words[word] for word in words]
    names = [*tables.names, "0"]
    layers = [names[layer] for layer in layers]
    texts = [
        data[low : low + size].decode(tables.encoding, "replace")
        for low, size in zip(first, count, strict=True)
    ]
    lengths = tables.found.value[rows][:, f.LENGTHS]
    found = plain_annotations(kinds, layers, texts, lengths)
    pairs = zip(kinds, texts, strict=True)
    for at in [at for at, (kind, text) in enumerate(pairs) if has_formatting(kind, text)]:
        flags = int(entity[rows[at], f.FLAGS])
        found[at] = annotation(kinds[at], layers[at], texts[at], lengths[at].tolist(), flags)
    for at in np.flatnonzero(entity[rows, f.UNSUPPORTED]).tolist():
        lines = data[slice(*entity[rows[at], [f.START, f.END]].tolist())]
        found[at] = annotation_of_lines(kinds[at], layers[at], lines, tables.encoding)
    return tuple(found)
