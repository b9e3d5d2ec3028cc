"""import_report_writer: compute the import report and the annotations of a scanned DXF file.

All entities are processed together in NumPy arrays.
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
    insert_note,
    no_geometry_reason,
    paper_space_reason,
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
from knifetip.model.words import RepeatedValues


class Variant(NamedTuple):
    """Layers, styles and dropped entities of one block, for INSERTs of one style.

    Layers, styles and outcomes depend on the style of the INSERT, because entities may have
    attributes BYBLOCK, and because entities on layer 0 lie on the layer of the INSERT.
    """

    layers: list[str]  #: layer of each entity
    dropped: dict[int, Message]  #: reason for dropping, by index of the entity in the block
    first: int  #: index of the first style of its segments
    segments: int  #: number of segments of its visible entities


class Inserts(NamedTuple):
    """The k INSERTs in model space whose blocks are placed all together, by array operations.

    All other INSERTs are expanded entity by entity by ``BlockExpansion``.
    """

    position: I64  #: (k,) index of each INSERT among the entities of model space
    block: I64  #: (k,) row of the block of each INSERT
    variant: I64  #: (k,) index of the variant of each INSERT
    variants: list[Variant]
    move: F64  #: (k, 2, 3) linear map and translation, from block to model space


class Order(NamedTuple):
    """The n entities of model space, and their rows in the import report."""

    rows: I64  #: (n,) row of each entity in the Scan
    report_row: I64  #: (n,) row of each entity in the import report
    in_columns: Bool  #: (n,) whether the segments of the entity are computed in columns
    expanded: I64  #: (w,) row in the import report of each row of the expansion


def drop_reason(tables: Tables, row: int, layer: str) -> Message | None:
    """Return the reason for dropping an entity, None if the entity is visible and has geometry.

    ``row`` is the row of the entity in ``Scan.entity``, and ``layer`` the name of its layer, which
    for an entity on layer 0 of a block is the layer of the INSERT.
    """
    line = tables.scan.entity[row].tolist()
    word = tables.words[line[f.WORD]]
    if line[f.PAPER]:
        return paper_space_reason(word)
    kind = line[f.KIND]
    if kind == f.OTHER:
        return no_geometry_reason(word)
    if kind != f.INSERT and (reason := tables.styles.hidden(layer)):
        return reason
    return few_vertices_reason(tables, row)


def few_vertices_reason(tables: Tables, row: int) -> Message | None:
    """Return the reason for dropping a polyline with fewer than two vertices, otherwise None.

    ``row`` is the row of the entity in ``Scan.entity``.
    """
    kind, count = tables.scan.entity[row, [f.KIND, f.COUNT]].tolist()
    if kind in (f.LWPOLYLINE, f.POLYLINE) and count < 2:
        return Message("import.few-vertices", vertices=count)
    return None


def report_rows(
    tables: Tables, order: Order, inserts: Inserts, expansion: ReportWriter
) -> ReportRows:
    """Return all rows of the import report of a file.

    They are the rows of the entities of model space, of the entities of blocks for each INSERT, and
    of the entities that ``BlockExpansion`` expanded.

    Parameters
    ----------
    tables
        The content of the file.
    order
        The entities of model space, and their rows in the import report.
    inserts
        The INSERTs whose blocks are placed by array operations, without ``BlockExpansion``.
    expansion
        The rows of the entities that ``BlockExpansion`` expanded.
    """
    entity, span = tables.scan.entity, tables.span
    numbers = {name: number for number, name in enumerate(tables.names)}
    silent = numbers.setdefault("0", len(numbers))
    low, size = (
        np.array([span.get(block, (0, 0)) for block in range(len(tables.scan.block))], np.int64)
        .reshape(-1, 2)[inserts.block]
        .T
    )
    # For entities in blocks: row, entity and INSERT.
    step = np.arange(size.sum()) - np.repeat(np.cumsum(size) - size, size)
    block_row = np.repeat(order.report_row[inserts.position] + 1, size) + step
    inserted = np.repeat(low, size) + step
    # An expanded entity has its own row, followed by the rows of its block.
    total = 1 + int(
        max(column.max(initial=-1) for column in (order.report_row, block_row, order.expanded))
    )
    own, insert = np.empty(total, np.int64), np.full(total, -1, np.int64)
    own[order.report_row], own[block_row] = order.rows, inserted
    insert[block_row] = np.repeat(order.rows[inserts.position], size)
    kind, layer = np.empty(total, np.int32), np.empty(total, np.int32)
    kind[order.report_row], kind[block_row] = entity[order.rows, f.WORD], entity[inserted, f.WORD]
    layer[order.report_row] = entity[order.rows, f.LAYER]
    layer[layer < 0] = silent
    layers = [[numbers[name] for name in variant.layers] for variant in inserts.variants]
    begin = np.cumsum([0, *map(len, layers)])[inserts.variant]
    layer[block_row] = np.array(list(chain.from_iterable(layers)), np.int32)[
        np.repeat(begin, size) + step
    ]
    # Last, because these rows replace those of the entity.
    own[order.expanded] = len(entity) + np.arange(len(order.expanded))
    for column, words in ((kind, expansion.kind), (layer, expansion.layer)):
        column[order.expanded] = [numbers.setdefault(word, len(numbers)) for word in words]
    expanded_row = order.expanded.tolist()
    undrawn = ~order.in_columns
    undrawn[inserts.position] = False
    undrawn[np.isin(order.report_row, order.expanded)] = False
    dropped = np.flatnonzero(undrawn)
    handles, (shared_outcomes, boxes_of_dropped) = parallel_pair(
        lambda: paths_of(tables.handles, expansion.handle, own, insert),
        lambda: (
            [*_sheet_outcomes(tables, order, inserts, dropped), *_block_outcomes(order, inserts)],
            [*_sheet_boxes(tables, order, dropped), *_block_boxes(tables, order, inserts)],
        ),
    )
    expanded = [
        LocationBoxes(order.expanded[one.rows].astype(np.int32), one.box)
        for one in expansion.location_boxes
    ]
    return ReportRows(
        handles,
        RepeatedValues(tuple(numbers), kind),
        RepeatedValues(tuple(numbers), layer),
        {expanded_row[row]: reason for row, reason in expansion.dropped.items()},
        {expanded_row[row]: notes for row, notes in expansion.notes.items()},
        shared_outcomes,
        expanded + boxes_of_dropped,
    )


def _sheet_outcomes(
    tables: Tables, order: Order, inserts: Inserts, dropped: I64
) -> Iterator[SharedOutcome]:
    """Yield the import outcomes of the entities in model space.

    An import outcome consists of the reason for dropping an entity (None if the entity is kept) and
    of the notes on the entity.  Entities with the same reason and notes are yielded together.
    ``dropped`` contains the indices, among the entities of model space, of the dropped entities.
    """
    entity, rows = tables.scan.entity, order.rows
    paper, sort, word, count, layer = (
        entity[rows[dropped], column] for column in (f.PAPER, f.KIND, f.WORD, f.COUNT, f.LAYER)
    )
    # For texts, which have the kind OTHER, the column COUNT is the length, which is irrelevant.
    first, kind = unique_rows(
        paper, sort, word, np.where(sort == f.OTHER, 0, count), tables.hidden[layer]
    )
    for position, same in zip(first.tolist(), _group_indices(kind, len(first)), strict=True):
        row = int(rows[dropped[position]])
        yield SharedOutcome(
            order.report_row[dropped[same]], drop_reason(tables, row, tables.layer(row))
        )
    first, kind = unique_rows(inserts.block)
    for one, same in zip(first.tolist(), _group_indices(kind, len(first)), strict=True):
        note = insert_note(tables.block_name(int(inserts.block[one])))
        yield SharedOutcome(order.report_row[inserts.position[same]], None, (note,))


def _block_outcomes(order: Order, inserts: Inserts) -> Iterator[SharedOutcome]:
    """Yield the import outcomes of the dropped entities in blocks.

    An outcome is yielded once for all copies of the entity that are placed by INSERTs of the same
    style.
    """
    of_variant = _group_indices(inserts.variant, len(inserts.variants))
    for variant, same in zip(inserts.variants, of_variant, strict=True):
        first = order.report_row[inserts.position[same]] + 1
        for number, reason in variant.dropped.items():
            yield SharedOutcome(first + number, reason)


def boxes(tables: Tables, rows: I64) -> F64:
    """Return the bounding boxes of n entities, which show where dropped entities are located.

    The shape is (n, 4): min x, min y, max x, max y (file units); NaN for an entity without points.
    ``rows`` are the rows of the entities in ``Scan.entity``.  A box is in the coordinates of model
    space, or of the block that contains its entity.
    """
    entity = tables.scan.entity
    words, kind = np.unique(entity[rows, f.WORD], return_inverse=True)
    kinds = [tables.words[word] for word in words.tolist()]
    spans = np.column_stack([entity[rows, f.START], entity[rows, f.END]]).astype(np.int64)
    return boxes_of_entities(tables.scan.data, kinds, kind, spans)


def _sheet_boxes(tables: Tables, order: Order, dropped: I64) -> Iterator[LocationBoxes]:
    """Yield the bounding boxes of the dropped entities in model space.

    ``dropped`` contains the indices of these entities among the entities of model space.
    """
    dropped = dropped[tables.scan.entity[order.rows[dropped], f.PAPER] == 0]
    if len(dropped):
        yield LocationBoxes(
            order.report_row[dropped].astype(np.int32), boxes(tables, order.rows[dropped])
        )


def _block_boxes(tables: Tables, order: Order, inserts: Inserts) -> Iterator[LocationBoxes]:
    """Yield the bounding boxes of dropped entities in the blocks that INSERTs place.

    The boxes are in the coordinates of model space.
    """
    of_variant = _group_indices(inserts.variant, len(inserts.variants))
    for variant, same in zip(inserts.variants, of_variant, strict=True):
        numbers = np.array(list(variant.dropped), np.int64)
        rows = tables.span.get(int(inserts.block[same[0]]), (0, 0))[0] + numbers
        on_model = tables.scan.entity[rows, f.PAPER] == 0
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


def _group_indices(kind: I64, kinds: int) -> list[I64]:
    """Return one array of indices for each value 0 … ``kinds`` - 1.

    Array i contains the indices at which ``kind`` is equal to i.
    """
    order = np.argsort(kind, kind="stable")
    return np.split(order, np.cumsum(np.bincount(kind, minlength=kinds))[:-1])[:kinds]


def read_annotations(tables: Tables, rows: I64) -> tuple[Annotation, ...]:
    """Return the annotations of the texts and dimensions in model space.

    ``rows`` are the rows in ``Scan.entity`` of all texts and dimensions outside blocks; those in
    paper space are left out.
    """
    entity, data = tables.scan.entity, tables.scan.data
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
    lengths = tables.scan.value[rows][:, f.LENGTHS]
    annotations = plain_annotations(kinds, layers, texts, lengths)
    pairs = zip(kinds, texts, strict=True)
    for index in [index for index, (kind, text) in enumerate(pairs) if has_formatting(kind, text)]:
        flags = int(entity[rows[index], f.FLAGS])
        annotations[index] = annotation(
            kinds[index], layers[index], texts[index], lengths[index].tolist(), flags
        )
    for index in np.flatnonzero(entity[rows, f.UNSUPPORTED]).tolist():
        lines = data[slice(*entity[rows[index], [f.START, f.END]].tolist())]
        annotations[index] = annotation_of_lines(
            kinds[index], layers[index], lines, tables.encoding
        )
    return tuple(annotations)
