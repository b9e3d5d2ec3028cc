"""reader: read a DXF file that uses only supported features.

The drawing equals the drawing that the ezdxf reader returns, bit by bit, and is read in about a
hundredth of the time.  Compiled kernels process most entities together, in arrays: entities in
model space, and blocks that INSERTs move, rotate and scale equally in x and y.  The other entities
are expanded one by one by ``BlockExpansion``: curves that must be approximated, blocks that are
nested, repeated or unequally scaled, and entities that the scan does not support, which are read
with ezdxf.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from knifetip.drawing_builder.assemble import assemble
from knifetip.drawing_builder.columns import Columns, Style
from knifetip.drawing_builder.report import ReportRows, ReportWriter
from knifetip.dxf.annotations import WORDS
from knifetip.dxf.attributes import Styles
from knifetip.dxf.ezdxf_reader.block_expansion import (
    Block,
    BlockExpansion,
    Entry,
    Reference,
    unused_block_reason,
)
from knifetip.dxf.ezdxf_reader.entities import EntityShape, Lines, Undrawable
from knifetip.dxf.ezdxf_reader.place import columns, refuse_after, refuse_beyond, renumber_styles
from knifetip.dxf.ezdxf_reader.prescan import PrescannedEntity
from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader.columns import (
    EntitySegments,
    PlacedBlocks,
    SheetRows,
    SheetSegments,
    counts,
    distant,
    draw,
    inserts,
    place,
    style_keys,
)
from knifetip.dxf.fast_reader.import_report_writer import (
    Inserts,
    Order,
    Variant,
    boxes,
    drop_reason,
    read_annotations,
    report_rows,
)
from knifetip.dxf.fast_reader.scan import Scan, scan
from knifetip.dxf.fast_reader.tables import Tables, Unsupported
from knifetip.dxf.units import known_unit
from knifetip.formats.limits import REACH, Limits
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.parallel import parallel_pair
from knifetip.geometry.tolerance import BULGE
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.drawing import Annotation, Drawing

if TYPE_CHECKING:
    from knifetip.dxf.ezdxf_reader.ezdxf_entity import EzdxfEntity

#: Columns of an entity's style.
_STYLE = [f.LAYER, f.LINETYPE, f.COLOUR, f.TRUE_COLOUR]


class FastReading(NamedTuple):
    """Rows of the import report, segments and annotations that were read from a DXF file."""

    sheet: ReportRows
    columns: Columns  #: file units
    styles: list[Style]  #: styles to which the column ``style`` refers
    annotations: tuple[Annotation, ...]


class _ScannedEntity:
    """An entity of a scanned file that implements the interface ``SourceEntity``."""

    hidden = False

    def __init__(self, reader: FastReader, row: int) -> None:
        self._reader = reader
        self._row = row

    def style(self, styles: Styles, insert_style: Style | None) -> Style:  # noqa: ARG002  # as SourceEntity.style
        # ``tables`` contains its own ``Styles`` of this file, equal to the argument.
        return self._reader.tables.style(self._row, insert_style)

    def shape(self) -> EntityShape:
        if reason := drop_reason(self._reader.tables, self._row):
            raise Undrawable(reason)
        low, high = self._reader.first[self._row : self._row + 2]
        return EntityShape(Lines(self._reader.ends[low:high], self._reader.bulge[low:high]))

    def reference(self) -> Reference:
        return self._reader.reference(self._row)

    def repeats(self) -> tuple[str, int]:
        insert = self._reader.reference(self._row)
        return insert.block.lower(), insert.cells[0] * insert.cells[1]


def _segments(scanned: Scan) -> tuple[I64, I64, F64, F64]:
    """Return the segments of all e entities of a scanned file.

    They are in the coordinates of model space, or of the block that contains the entity.

    Returns
    -------
    count : (e,)
        Number of segments of each entity.
    first : (e + 1,)
        Index of the first segment of each entity; the last element is the number n of segments.
    ends : (n, 2, 2)
        Start and end point of each segment (file units).
    bulge : (n,)
        Bulge of each segment.
    """
    count: I64 = counts(scanned.entity, scanned.value, scanned.vertex)
    first: I64 = np.concatenate([[0], np.cumsum(count)])
    ends, bulge = np.empty((first[-1], 2, 2)), np.empty(first[-1])
    draw(scanned.entity, scanned.value, scanned.vertex, first, ends, bulge)
    return count, first, ends, bulge


class FastReader:
    """Reads one DXF file.

    Raises
    ------
    Unsupported
        The file uses features that only the ezdxf reader supports.
    """

    def __init__(self, data: bytes, limits: Limits) -> None:
        scanned = scan(data)
        if scanned is None or len(scanned.entity) > limits.entities:
            raise Unsupported
        self.scan = scanned
        self.limits = limits
        self.entity = scanned.entity
        # In the coordinates of model space, or of the entity's block.
        self.count: I64
        self.first: I64
        self.ends: F64
        self.bulge: F64
        (self.count, self.first, self.ends, self.bulge), self.tables = parallel_pair(
            lambda: _segments(scanned), lambda: Tables(scanned)
        )
        # First entity and number of entities of each block.
        spans = [self.tables.span.get(number, (0, 0)) for number in range(len(scanned.block))]
        self._low, self._size = np.array(spans, np.int64).reshape(-1, 2).T
        self._is_word = np.isin(
            np.arange(len(self.tables.names)),
            [number for number, word in self.tables.words.items() if word in WORDS],
        )
        self._unsupported = self._read_unsupported()
        self._simple = self._simple_blocks()
        self._numbers: dict[Style, int] = {}
        self._variant_styles: list[I32] = []

    def _read_unsupported(self) -> dict[int, EzdxfEntity]:
        """Return the entities that the scan does not support, read with ezdxf.

        The keys of the dictionary are the rows of the entities in ``Scan.entity``.
        """
        is_unsupported = (self.entity[:, f.UNSUPPORTED] != 0) & ~self._is_word[
            self.entity[:, f.WORD]
        ]
        if not is_unsupported.any():
            return {}
        from knifetip.dxf.ezdxf_reader.ezdxf_entity import EntityReader  # imports ezdxf: slow

        singles = EntityReader(self.tables.version, self.tables.encoding)
        deadline = time.monotonic() + self.limits.seconds
        unsupported = {}
        for row in np.flatnonzero(is_unsupported).tolist():
            refuse_after(deadline, self.limits)
            low, high = self.entity[row, [f.START, f.END]].tolist()
            try:
                unsupported[row] = singles.read(self.scan.data[low:high])
            except Exception as damage:
                raise Unsupported from damage
        return unsupported

    def _simple_blocks(self) -> dict[int, bool]:
        """Return the blocks that array operations can place, and whether each block contains arcs.

        The keys of the dictionary are the rows of the blocks in ``Scan.block``.  The values are
        True for blocks with arcs: array operations cannot scale them unequally in x and y.
        """
        entity = self.entity
        special = (entity[:, f.KIND] == f.INSERT) | (entity[:, f.UNSUPPORTED] != 0)
        special &= entity[:, f.PAPER] == 0
        simple = {}
        for block in self.tables.blocks.values():
            low, size = self.tables.span.get(block, (0, 0))
            if not special[low : low + size].any() and not self.scan.block[block, f.EXTERNAL]:
                bulge = self.bulge[self.first[low] : self.first[low + size]]
                simple[block] = bool((np.abs(bulge) >= BULGE).any())
        return simple

    def _all_blocks(self) -> dict[str, Block]:
        """Return the block definitions for ``BlockExpansion``, by their names in lower case."""
        blocks = {}
        inserts = np.flatnonzero(self.entity[:, f.KIND] == f.INSERT)
        for key, number in self.tables.blocks.items():
            low, size = self.tables.span.get(number, (0, 0))
            nested = inserts[np.searchsorted(inserts, low) : np.searchsorted(inserts, low + size)]
            blocks[key] = Block(
                self.tables.block_name(number),
                self.scan.base[number],
                bool(self.scan.block[number, f.EXTERNAL]),
                size,
                [self._source_entity(row).repeats() for row in nested.tolist()],
                partial(self._entries, range(low, low + size)),
            )
        return blocks

    def _source_entity(self, row: int) -> EzdxfEntity | _ScannedEntity:
        return self._unsupported.get(row) or _ScannedEntity(self, row)

    def _entries(self, rows: Iterable[int]) -> list[Entry]:
        return list(map(self._entry, rows))

    def _entry(self, row: int) -> Entry:
        """Return the entity in row ``row`` of ``Scan.entity``, for ``BlockExpansion``."""
        line = self.entity[row]
        kind, handle = self.tables.words[int(line[f.WORD])], self.tables.handles[row]
        box = None if line[f.PAPER] else boxes(self.tables, np.array([row]))[0]
        layer, paper = self.tables.layer(row), bool(line[f.PAPER])
        counted = PrescannedEntity(kind, handle, layer, paper, box=box)
        return Entry(counted, handle, self._source_entity(row))

    def reference(self, row: int) -> Reference:
        """Return the block placement of the INSERT in row ``row`` of ``Scan.entity``."""
        line, value = self.entity[row].tolist(), self.scan.value[row].tolist()

        def value_or(column: int, default: float) -> float:
            number: float = value[column]
            return default if np.isnan(number) else number

        return Reference(
            self.tables.names[line[f.REFERENCE]],
            line[f.MIRROR] != 0,
            (value[f.X], value[f.Y], 0.0),
            (value_or(f.SCALE_X, 1.0), value_or(f.SCALE_Y, 1.0)),
            value_or(f.ANGLE, 0.0),
            (max(line[f.COLUMNS], 1), max(line[f.ROWS], 1)),
            (value_or(f.SPACE_X, 0.0), value_or(f.SPACE_Y, 0.0)),
            clipped=False,
        )

    def read(self, scale: float) -> FastReading:
        """Return the rows of the import report and the segments of the file, in file order.

        Parameters
        ----------
        scale
            Millimetres per file unit, 0 while the unit is unknown.

        Raises
        ------
        DrawingTooLarge
            A limit is exceeded.
        Unsupported
            A coordinate of an entity that an INSERT places is too large.
        """
        rows = np.flatnonzero(self.entity[:, f.BLOCK] < 0)
        reach = REACH / (scale or 1.0)
        one_by_one = self._one_by_one(rows, reach)
        position, block, placement = self._inserts(rows, one_by_one)
        expansion = BlockExpansion(
            self._all_blocks(),
            self._references(rows, one_by_one, block),
            self.tables.styles,
            self.limits,
        )
        shown = np.where(one_by_one, 0, self.count[rows])
        refuse_beyond(int(shown.sum()), self.limits)

        children = np.zeros(len(rows), np.int64)
        children[position] = self._size[block]
        segments = shown.copy()
        low = self._low[block]
        segments[position] = self.first[low + self._size[block]] - self.first[low]
        # First report row of each expanded entity.
        expanded = np.flatnonzero(one_by_one)
        begin = np.zeros(len(expanded), np.int64)
        for number, one in enumerate(expanded.tolist()):
            begin[number] = len(expansion.sheet.handle)
            expansion.sheet_entity(self._entry(int(rows[one])))
        children[expanded] = np.diff(begin, append=len(expansion.sheet.handle)) - 1
        refuse_beyond(int(segments.sum()), self.limits)

        report_row = np.cumsum(children + 1) - children - 1
        segments_before = np.cumsum(segments) - segments
        whole_row = np.arange(len(expansion.sheet.handle)) + np.repeat(
            report_row[expanded] - begin, children[expanded] + 1
        )
        move = np.empty((len(placement), 2, 3))
        inserts(placement, self.scan.base[block], move)
        placed = Inserts(position, block, *self._variants(rows[position], block), move)
        texts = rows[self._is_word[self.entity[rows, f.WORD]]]
        styles = self._entity_styles(rows)
        sheet = SheetRows(rows, report_row, segments_before, shown)
        segments_read, words = parallel_pair(
            lambda: self._column_segments(sheet, styles, int(segments.sum()), placed),
            lambda: read_annotations(self.tables, texts),
        )
        # An arc lies within half a chord length of its chord.
        farthest = np.maximum(
            segments_read.ends.max(initial=0.0), -segments_read.ends.min(initial=0.0)
        )
        if not 3.0 * float(farthest) <= reach:
            raise Unsupported
        if len(expanded):
            segments_read = self._with_expanded(
                segments_read, expansion, segments_before[expanded], begin, whole_row, scale
            )
        self._report_unused_blocks(
            expansion.sheet, {*expansion.used, *map(self._key, np.unique(block).tolist())}
        )
        last = len(rows) + int(children.sum())
        unused_rows = np.arange(last, last + len(expansion.sheet.handle) - len(whole_row))
        order = Order(rows, report_row, shown > 0, np.concatenate([whole_row, unused_rows]))
        segments_read, used_styles = renumber_styles(segments_read, list(self._numbers))
        return FastReading(
            report_rows(self.tables, order, placed, expansion.sheet),
            segments_read,
            used_styles,
            words,
        )

    def _one_by_one(self, rows: I64, reach: float) -> Bool:
        """Return the mask of the entities in ``rows`` that ``BlockExpansion`` expands one by one.

        They are the entities that the scan does not support, except texts, dimensions and entities
        in paper space, and the entities with a coordinate that may be too large.  Only the ends of
        the segments are examined, and an arc may extend beyond its ends: a coordinate of an end is
        therefore limited to a third of ``reach``.

        Parameters
        ----------
        rows
            Rows in ``Scan.entity`` of the entities that are not in a block.
        reach
            Largest permitted absolute value of a coordinate (file units).
        """
        one_by_one: Bool = (self.entity[:, f.UNSUPPORTED] != 0) & ~self._is_word[
            self.entity[:, f.WORD]
        ]
        one_by_one &= self.entity[:, f.PAPER] == 0
        one_by_one |= distant(self.ends, self.first, reach / 3.0)
        return one_by_one[rows]

    def _inserts(self, rows: I64, one_by_one: Bool) -> tuple[I64, I64, F64]:
        """Return the k INSERTs in model space whose blocks are placed by array operations.

        All other INSERTs are marked in ``one_by_one``, the mask of the entities that
        ``BlockExpansion`` expands.  ``rows`` are the rows in ``Scan.entity`` of the entities of
        model space.

        Returns
        -------
        position : (k,)
            Index of each INSERT into ``rows``.
        block : (k,)
            Row in ``Scan.block`` of the block of each INSERT.
        placement : (k, 5)
            Position x and y, scale in x and in y, and rotation in degrees of each INSERT.
        """
        inserts = (self.entity[:, f.KIND] == f.INSERT) & (self.entity[:, f.PAPER] == 0)
        position = np.flatnonzero(inserts[rows])
        insert_rows = rows[position]
        mirror, wide, high, reference = (
            self.entity[insert_rows, column]
            for column in (f.MIRROR, f.COLUMNS, f.ROWS, f.REFERENCE)
        )
        value_columns = (f.X, f.Y, f.SCALE_X, f.SCALE_Y, f.ANGLE)
        placement = np.column_stack(
            [self.scan.value[insert_rows, column] for column in value_columns]
        )
        for column, default in ((2, 1.0), (3, 1.0), (4, 0.0)):
            placement[np.isnan(placement[:, column]), column] = default
        # Row of the block with each name; whether each block is simple, and whether it has no arcs.
        block_of_name = [self.tables.blocks.get(name.lower(), -1) for name in self.tables.names]
        block = np.array([*block_of_name, -1], np.int64)[reference]
        simple = np.zeros(len(self.scan.block) + 1, np.bool_)
        straight = simple.copy()
        for number, arcs in self._simple.items():
            simple[number], straight[number] = True, not arcs
        scale = placement[:, 2:4]
        columnar = (
            ~one_by_one[position]
            & simple[block]
            & (mirror == 0)
            & (np.maximum(wide, high) <= 1)
            & (scale != 0.0).all(axis=1)
            & (straight[block] | (np.abs(scale[:, 0]) == np.abs(scale[:, 1])))
        )
        one_by_one[position[~columnar]] = True
        return position[columnar], block[columnar], placement[columnar]

    def _references(self, rows: I64, one_by_one: Bool, block: I64) -> list[tuple[str, int]]:
        """Return the lower-case names of the blocks that INSERTs place, with the numbers of copies.

        The INSERTs are those in model space.  A block may occur more than once in the list.

        Parameters
        ----------
        rows
            Rows in ``Scan.entity`` of the entities of model space.
        one_by_one
            Mask of the entities in ``rows`` that ``BlockExpansion`` expands.
        block
            Row in ``Scan.block`` of the block of each INSERT that array operations place.
        """
        numbers, times = np.unique(block, return_counts=True)
        references = list(zip(map(self._key, numbers.tolist()), times.tolist(), strict=True))
        other_inserts = rows[one_by_one]
        other_inserts = other_inserts[self.entity[other_inserts, f.KIND] == f.INSERT]
        return references + [self._source_entity(row).repeats() for row in other_inserts.tolist()]

    def _column_segments(
        self, sheet: SheetRows, styles: I32, total: int, placed: Inserts
    ) -> Columns:
        """Return the segments of all entities that are not expanded by ``BlockExpansion``.

        Array operations compute these segments for all entities together.

        Parameters
        ----------
        sheet
            The entities of model space.
        styles : (e,)
            Style index of each entity of the file; -1 if the entity is not in
            model space or has no segments.
        total
            Number of segments to return.
        placed
            The INSERTs whose blocks are placed by array operations.
        """
        segments = Columns(
            np.empty((total, 2, 2)),
            np.empty(total),
            np.empty(total, np.int32),
            np.empty(total, np.int32),
        )
        # For each INSERT: first entity and segment of its block, and first style.
        low = self._low[placed.block]
        begin = np.array([one.first for one in placed.variants], np.int64)[placed.variant]
        place(
            sheet,
            EntitySegments(self.ends, self.bulge, self.first, styles),
            PlacedBlocks(
                placed.position,
                np.column_stack([low, self.first[low], begin]),
                self._size[placed.block],
                placed.move,
                np.concatenate([np.zeros(0, np.int32), *self._variant_styles]),
            ),
            SheetSegments(segments.ends, segments.bulge, segments.row, segments.style),
        )
        return segments

    def _with_expanded(
        self,
        segments: Columns,
        expansion: BlockExpansion,
        segments_before: I64,
        first_row: I64,
        whole_row: I64,
        scale: float,
    ) -> Columns:
        """Return ``segments`` and the segments of the expanded entities together, in file order.

        Parameters
        ----------
        segments
            Segments of the entities that array operations process.
        expansion
            Import report and shapes of the entities that were expanded one by one.
        segments_before
            For each expanded entity, the number of ``segments`` that precede it in file order.
        first_row
            For each expanded entity, its first row in the import report of ``expansion``.
        whole_row
            For each row of the import report of ``expansion``, its row in the import report of the
            whole file.
        scale
            Millimetres per file unit, 0 while the unit is unknown.
        """
        expanded_segments = columns(
            expansion.sheet, expansion.placed, scale, self.limits, segments.ends
        )
        insert_at = segments_before[
            np.searchsorted(first_row, expanded_segments.row, side="right") - 1
        ]
        styles = np.array(
            [self._numbers.setdefault(one.style, len(self._numbers)) for one in expansion.placed],
            np.int32,
        )
        return Columns(
            np.insert(segments.ends, insert_at, expanded_segments.ends, axis=0),
            np.insert(segments.bulge, insert_at, expanded_segments.bulge),
            np.insert(segments.row, insert_at, whole_row[expanded_segments.row]),
            np.insert(segments.style, insert_at, styles[expanded_segments.style]),
            np.insert(segments.fit_error, insert_at, expanded_segments.fit_error),
        )

    def _entity_styles(self, rows: I64) -> I32:
        """Return the style index of each of the e entities of the file, (e,).

        The index is -1 for an entity that has no segments or is not in ``rows``, the rows in
        ``Scan.entity`` of the entities of model space.
        """
        with_segments, key = style_keys(self.entity, rows, self.count)
        first, kind = unique_rows(key)
        numbers = [
            self._numbers.setdefault(self.tables.style(row), len(self._numbers))
            for row in with_segments[first].tolist()
        ]
        styles = np.full(len(self.entity), -1, np.int32)
        styles[with_segments] = np.array(numbers, np.int32)[kind]
        return styles

    def _variants(self, rows: I64, block: I64) -> tuple[I64, list[Variant]]:
        """Return for each of k INSERTs the index of its variant, (k,), and the list of variants.

        A variant is a block with the style of its INSERT.  ``rows``, (k,), are the rows of the
        INSERTs in ``Scan.entity``, and ``block``, (k,), the rows of their blocks in ``Scan.block``.
        """
        first, kind = unique_rows(*(self.entity[rows, column] for column in _STYLE), block)
        return kind, [
            self._variant(int(block[one]), self.tables.style(int(rows[one]))) for one in first
        ]

    def _variant(self, block: int, insert_style: Style) -> Variant:
        low, size = self.tables.span.get(block, (0, 0))
        layers: list[str] = []
        outcomes: dict[int, tuple[Message | None, tuple[Message, ...]]] = {}
        styles = np.zeros(size, np.int32)
        for number, row in enumerate(range(low, low + size)):
            if reason := drop_reason(self.tables, row):
                outcomes[number] = reason, ()
                layers.append(self.tables.layer(row))
                continue
            style = self.tables.style(row, insert_style)
            styles[number] = self._numbers.setdefault(style, len(self._numbers))
            layers.append(style.layer)
            if notes := self.tables.styles.notes(style.layer):
                outcomes[number] = None, notes
        variant = Variant(layers, outcomes, sum(map(len, self._variant_styles)))
        self._variant_styles.append(np.repeat(styles, self.count[low : low + size]))
        return variant

    def _key(self, block: int) -> str:
        return self.tables.block_name(block).lower()

    def _report_unused_blocks(self, sheet: ReportWriter, used: set[str]) -> None:
        """Add a row to the import report ``sheet`` for each block that no INSERT places.

        ``used`` contains the names, in lower case, of the blocks that INSERTs place.
        """
        for key, number in self.tables.blocks.items():
            if key in used or number not in self.tables.span:
                continue
            line = self.scan.block[number].tolist()
            low, size = line[f.BLOCK_HANDLE], line[f.BLOCK_HANDLE_SIZE]
            name = self.tables.block_name(number)
            layer = self.tables.names[line[f.BLOCK_LAYER]] if line[f.BLOCK_LAYER] >= 0 else "0"
            handle = self.scan.data[low : low + size].decode("ascii", "replace").strip().upper()
            sheet.row(
                handle or name,
                "BLOCK",
                layer,
                unused_block_reason(name, self.tables.span[number][1]),
            )


def read_fast(data: bytes, unit: str, limits: Limits) -> Drawing | None:
    """Return the drawing in a DXF file; None if the file uses features that are not supported.

    ``unit`` replaces the unit of the file if it is not empty.
    """
    try:
        reader = FastReader(data, limits)
        known = known_unit(unit, reader.tables.variables)
        reading = reader.read(known.scale)
    except Unsupported:
        return None
    # The scan takes more memory than the drawing: free it before the drawing is assembled.
    del reader
    return assemble(reading.sheet, reading.columns, reading.styles, reading.annotations, known)
