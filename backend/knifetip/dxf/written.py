"""written: the ledger of a plain drawing, in columns, and the words on its sheet.

rows of a Scan, INSERTs, what was walked through -> ReportRows
texts and dimensions -> inscriptions
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from typing import NamedTuple

import numpy as np

from knifetip.drawing_builder.report import ReportRows, ReportWriter, SharedOutcome
from knifetip.dxf import fields as f
from knifetip.dxf.handles import paths_of
from knifetip.dxf.inscriptions import inscription, is_coded, of_lines, uncoded
from knifetip.dxf.location_boxes import around_each, through
from knifetip.dxf.tables import Tables
from knifetip.dxf.walk import IN_PAPER_SPACE, not_read, places
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.cores import both
from knifetip.geometry.distinct import distinct
from knifetip.model.drawing import Inscription, LocationBoxes
from knifetip.model.words import Repeated


class Variant(NamedTuple):
    """A block as INSERTs of one style place it: what all of those have in common."""

    layers: list[str]  #: of its entities
    said: dict[
        int, tuple[str, tuple[str, ...]]
    ]  #: by the number of the entity, as in ``SharedOutcome``
    first: int  #: where the styles of its segments begin


class Inserts(NamedTuple):
    """k INSERTs on the sheet that are drawn in columns."""

    spot: I64  #: (k,) which of the entities of the sheet
    block: I64  #: (k,)
    variant: I64  #: (k,) which of the variants
    variants: list[Variant]
    move: F64  #: (k, 2, 3) linear map and shift, from the block to the sheet


class Order(NamedTuple):
    """Where n entities of the sheet stand in a ledger of m rows."""

    rows: I64  #: (n,) of the Scan
    ledger: I64  #: (n,)
    drawn: Bool  #: (n,) they are lines that are drawn in columns
    walked: I64  #: (w,) rows of the ledger for those of what was walked through


def left_out(tables: Tables, row: int) -> str:
    """Return why a plain entity is left out, empty for what is drawn."""
    line = tables.found.entity[row].tolist()
    if line[f.PAPER]:
        return IN_PAPER_SPACE
    kind = line[f.KIND]
    if kind == f.OTHER:
        return not_read(tables.words[line[f.WORD]])
    if kind in (f.LWPOLYLINE, f.POLYLINE) and line[f.COUNT] < 2:
        return f"it has {line[f.COUNT]} vertices: no line between them"
    return ""


def written(tables: Tables, order: Order, inserts: Inserts, walk: ReportWriter) -> ReportRows:
    """Return the ledger of a sheet, of what its INSERTs place, and of what was walked through."""
    entity, span = tables.found.entity, tables.span
    numbers = {name: number for number, name in enumerate(tables.names)}
    silent = numbers.setdefault("0", len(numbers))
    low, size = (
        np.array([span.get(block, (0, 0)) for block in range(len(tables.found.block))], np.int64)
        .reshape(-1, 2)[inserts.block]
        .T
    )
    # Of what the INSERTs place: its row, its entity, and its INSERT.
    step = np.arange(size.sum()) - np.repeat(np.cumsum(size) - size, size)
    under = np.repeat(order.ledger[inserts.spot] + 1, size) + step
    inserted = np.repeat(low, size) + step
    # What was walked through has the row of its entity, and rows of its own behind it.
    total = 1 + int(max(column.max(initial=-1) for column in (order.ledger, under, order.walked)))
    own, insert = np.empty(total, np.int64), np.full(total, -1, np.int64)
    own[order.ledger], own[under] = order.rows, inserted
    insert[under] = np.repeat(order.rows[inserts.spot], size)
    kind, layer = np.empty(total, np.int32), np.empty(total, np.int32)
    kind[order.ledger], kind[under] = entity[order.rows, f.WORD], entity[inserted, f.WORD]
    layer[order.ledger] = entity[order.rows, f.LAYER]
    layer[layer < 0] = silent
    layers = [[numbers[name] for name in variant.layers] for variant in inserts.variants]
    begin = np.cumsum([0, *map(len, layers)])[inserts.variant]
    layer[under] = np.array(list(chain.from_iterable(layers)), np.int32)[
        np.repeat(begin, size) + step
    ]
    # These come last: an entity that was walked through has its row from there.
    own[order.walked] = len(entity) + np.arange(len(order.walked))
    for column, words in ((kind, walk.kind), (layer, walk.layer)):
        column[order.walked] = [numbers.setdefault(word, len(numbers)) for word in words]
    there = order.walked.tolist()
    left = ~order.drawn
    left[inserts.spot] = False
    left[np.isin(order.ledger, order.walked)] = False
    spots = np.flatnonzero(left)
    handles, (alike, standing) = both(
        lambda: paths_of(tables.handles, walk.handle, own, insert),
        lambda: (
            [*_of_sheet(tables, order, inserts, spots), *_of_blocks(order, inserts)],
            [*_on_sheet(tables, order, spots), *_in_blocks(tables, order, inserts)],
        ),
    )
    walked = [
        LocationBoxes(order.walked[one.rows].astype(np.int32), one.box)
        for one in walk.location_boxes
    ]
    return ReportRows(
        handles,
        Repeated(tuple(numbers), kind),
        Repeated(tuple(numbers), layer),
        {there[row]: why for row, why in walk.dropped.items()},
        {there[row]: notes for row, notes in walk.notes.items()},
        alike,
        walked + standing,
    )


def _of_sheet(
    tables: Tables, order: Order, inserts: Inserts, spots: I64
) -> Iterator[SharedOutcome]:
    """Say what is said of the entities of the sheet itself.

    Parameters
    ----------
    spots
        Those that are left out.
    """
    entity, rows = tables.found.entity, order.rows
    paper, sort, word, count = (
        entity[rows[spots], column] for column in (f.PAPER, f.KIND, f.WORD, f.COUNT)
    )
    # How many bytes a text has is no reason.
    first, kind = distinct(paper, sort, word, np.where(sort == f.OTHER, 0, count))
    for spot, same in zip(first.tolist(), _grouped(kind, len(first)), strict=True):
        yield SharedOutcome(order.ledger[spots[same]], left_out(tables, int(rows[spots[spot]])))
    of_layer = {
        layer: notes
        for layer in np.flatnonzero(np.bincount(entity[rows, f.LAYER] + 1)).tolist()
        if (notes := tables.styles.notes(tables.names[layer - 1] if layer else "0"))
    }
    for layer, notes in of_layer.items():
        there = order.drawn & (entity[rows, f.LAYER] == layer - 1)
        yield SharedOutcome(order.ledger[there], "", notes)
    layer = entity[rows[inserts.spot], f.LAYER]
    first, kind = distinct(layer, inserts.block)
    for one, same in zip(first.tolist(), _grouped(kind, len(first)), strict=True):
        said = places(tables.block_name(int(inserts.block[one])))
        notes = of_layer.get(int(layer[one]) + 1, ())
        yield SharedOutcome(order.ledger[inserts.spot[same]], "", (said, *notes))


def _of_blocks(order: Order, inserts: Inserts) -> Iterator[SharedOutcome]:
    """Say what is said of the entities that INSERTs place."""
    of_variant = _grouped(inserts.variant, len(inserts.variants))
    for variant, same in zip(inserts.variants, of_variant, strict=True):
        first = order.ledger[inserts.spot[same]] + 1
        for number, (dropped, notes) in variant.said.items():
            yield SharedOutcome(first + number, dropped, notes)


def boxes(tables: Tables, rows: I64) -> F64:
    """Return the boxes around entities in their own coordinates, (n, 4), as ``standing`` says."""
    entity = tables.found.entity
    words, kind = np.unique(entity[rows, f.WORD], return_inverse=True)
    kinds = [tables.words[word] for word in words.tolist()]
    spans = np.column_stack([entity[rows, f.START], entity[rows, f.END]]).astype(np.int64)
    return around_each(tables.found.data, kinds, kind, spans)


def _on_sheet(tables: Tables, order: Order, spots: I64) -> Iterator[LocationBoxes]:
    """Say where those entities of the sheet stand that are left out."""
    spots = spots[tables.found.entity[order.rows[spots], f.PAPER] == 0]
    if len(spots):
        yield LocationBoxes(order.ledger[spots].astype(np.int32), boxes(tables, order.rows[spots]))


def _in_blocks(tables: Tables, order: Order, inserts: Inserts) -> Iterator[LocationBoxes]:
    """Say where that stands which INSERTs place and is left out."""
    of_variant = _grouped(inserts.variant, len(inserts.variants))
    for variant, same in zip(inserts.variants, of_variant, strict=True):
        numbers = np.array([number for number, (why, _) in variant.said.items() if why], np.int64)
        rows = tables.span.get(int(inserts.block[same[0]]), (0, 0))[0] + numbers
        on_model = tables.found.entity[rows, f.PAPER] == 0
        numbers, rows = numbers[on_model], rows[on_model]
        if not len(rows):
            continue
        first = np.repeat(order.ledger[inserts.spot[same]] + 1, len(rows))
        move = np.repeat(inserts.move[same], len(rows), axis=0)
        box = np.tile(boxes(tables, rows), (len(same), 1))
        yield LocationBoxes(
            (first + np.tile(numbers, len(same))).astype(np.int32),
            through(box, move[:, :, :2], move[:, :, 2]),
        )


def _grouped(kind: I64, kinds: int) -> list[I64]:
    """Return the rows of each kind."""
    order = np.argsort(kind, kind="stable")
    return np.split(order, np.cumsum(np.bincount(kind, minlength=kinds))[:-1])[:kinds]


def inscriptions(tables: Tables, rows: I64) -> tuple[Inscription, ...]:
    """Return the words on the sheet: those of the texts and dimensions among its entities."""
    entity, data = tables.found.entity, tables.found.data
    rows = rows[entity[rows, f.PAPER] == 0]
    # By columns: a list to each row would be as much work again.
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
    found = uncoded(kinds, layers, texts, lengths)
    pairs = zip(kinds, texts, strict=True)
    for at in [at for at, (kind, text) in enumerate(pairs) if is_coded(kind, text)]:
        flags = int(entity[rows[at], f.FLAGS])
        found[at] = inscription(kinds[at], layers[at], texts[at], lengths[at].tolist(), flags)
    for at in np.flatnonzero(entity[rows, f.ODD]).tolist():
        lines = data[slice(*entity[rows[at], [f.START, f.END]].tolist())]
        found[at] = of_lines(kinds[at], layers[at], lines, tables.encoding)
    return tuple(found)
