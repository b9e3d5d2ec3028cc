"""reader: read a DXF file that uses only supported features.

The drawing equals the drawing that the ezdxf reader returns, bit by bit, and is read in about a
hundredth of the time.  Entities in model space, and blocks that INSERTs move, rotate and scale
equally in x and y, are processed in columns: all of them at once, by compiled kernels.  All other
entities are expanded one by one: curves that must be approximated, blocks that are nested, repeated
or unequally scaled, and entities that the scan does not support, which are read with ezdxf.
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
from knifetip.dxf.ezdxf_reader.entities import Drawn, Lines, Undrawable
from knifetip.dxf.ezdxf_reader.place import columns, refuse_after, refuse_beyond, styled
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
    """An entity of a Scan that implements the interface ``block_expansion.SourceEntity``."""

    hidden = False

    def __init__(self, reader: FastReader, row: int) -> None:
        self._reader = reader
        self._row = row

    def style(self, styles: Styles, insert_style: Style | None) -> Style:  # noqa: ARG002
        # ``tables`` contains its own ``Styles`` of this file, equal to the argument.
        return self._reader.tables.style(self._row, insert_style)

    def drawn(self) -> Drawn:
        if why := drop_reason(self._reader.tables, self._row):
            raise Undrawable(why)
        low, high = self._reader.first[self._row : self._row + 2]
        return Drawn(Lines(self._reader.ends[low:high], self._reader.bulge[low:high]))

    def reference(self) -> Reference:
        return self._reader.reference(self._row)

    def repeats(self) -> tuple[str, int]:
        insert = self._reader.reference(self._row)
        return insert.block.lower(), insert.cells[0] * insert.cells[1]


def _segments(found: Scan) -> tuple[I64, I64, F64, F64]:
    """Return the segments of all e entities of a Scan, in the coordinates of each entity.

    Returns
    -------
    count : (e,)
        Number of segments of each entity.
    first : (e + 1,)
        Index of the first segment of each entity, and the total number n of segments.
    ends : (n, 2, 2)
        Start and end point of each segment (file units).
    bulge : (n,)
        Bulge of each segment.
    """
    count: I64 = counts(found.entity, found.value, found.vertex)
    first: I64 = np.concatenate([[0], np.cumsum(count)])
    ends, bulge = np.empty((first[-1], 2, 2)), np.empty(first[-1])
    draw(found.entity, found.value, found.vertex, first, ends, bulge)
    return count, first, ends, bulge


class FastReader:
    """Reads one DXF file.

    Raises
    ------
    Unsupported
        The file uses features that only the ezdxf reader supports.
    """

    def __init__(self, data: bytes, limits: Limits) -> None:
        found = scan(data)
        if found is None or len(found.entity) > limits.entities:
            raise Unsupported
        self.found = found
        self.limits = limits
        self.entity = found.entity
        # In the coordinates of model space, or of the entity's block.
        self.count: I64
        self.first: I64
        self.ends: F64
        self.bulge: F64
        (self.count, self.first, self.ends, self.bulge), self.tables = parallel_pair(
            lambda: _segments(found), lambda: Tables(found)
        )
        # First entity and number of entities of each block.
        spans = [self.tables.span.get(number, (0, 0)) for number in range(len(found.block))]
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

        The keys of the dictionary are the rows of the entities in the Scan.
        """
        is_unsupported = (self.entity[:, f.UNSUPPORTED] != 0) & ~self._is_word[
            self.entity[:, f.WORD]
        ]
        if not is_unsupported.any():
            return {}
        from knifetip.dxf.ezdxf_reader.ezdxf_entity import EntityReader  # imports ezdxf: slow

        singles = EntityReader(self.tables.version, self.tables.encoding)
        until = time.monotonic() + self.limits.seconds
        unsupported = {}
        for row in np.flatnonzero(is_unsupported).tolist():
            refuse_after(until, self.limits)
            low, high = self.entity[row, [f.START, f.END]].tolist()
            try:
                unsupported[row] = singles.read(self.found.data[low:high])
            except Exception as damage:
                raise Unsupported from damage
        return unsupported

    def _simple_blocks(self) -> dict[int, bool]:
        """Return for each block that can be processed in columns whether it contains arcs.

        The keys of the dictionary are the rows of the blocks in the Scan.
        """
        entity = self.entity
        special = (entity[:, f.KIND] == f.INSERT) | (entity[:, f.UNSUPPORTED] != 0)
        special &= entity[:, f.PAPER] == 0
        simple = {}
        for block in self.tables.blocks.values():
            low, size = self.tables.span.get(block, (0, 0))
            if not special[low : low + size].any() and not self.found.block[block, f.EXTERNAL]:
                bulge = self.bulge[self.first[low] : self.first[low + size]]
                simple[block] = bool((np.abs(bulge) >= BULGE).any())
        return simple

    def _all_blocks(self) -> dict[str, Block]:
        """Return all blocks, by name in lower case, for expansion of their entities one by one."""
        blocks = {}
        inserts = np.flatnonzero(self.entity[:, f.KIND] == f.INSERT)
        for key, number in self.tables.blocks.items():
            low, size = self.tables.span.get(number, (0, 0))
            nested = inserts[np.searchsorted(inserts, low) : np.searchsorted(inserts, low + size)]
            blocks[key] = Block(
                self.tables.block_name(number),
                self.found.base[number],
                bool(self.found.block[number, f.EXTERNAL]),
                size,
                [self._found(row).repeats() for row in nested.tolist()],
                partial(self._entries, range(low, low + size)),
            )
        return blocks

    def _found(self, row: int) -> EzdxfEntity | _ScannedEntity:
        return self._unsupported.get(row) or _ScannedEntity(self, row)

    def _entries(self, rows: Iterable[int]) -> list[Entry]:
        return list(map(self._entry, rows))

    def _entry(self, row: int) -> Entry:
        """Return the entity in row ``row`` of the Scan, for expansion one by one."""
        line = self.entity[row]
        kind, handle = self.tables.words[int(line[f.WORD])], self.tables.handles[row]
        box = None if line[f.PAPER] else boxes(self.tables, np.array([row]))[0]
        layer, paper = self.tables.layer(row), bool(line[f.PAPER])
        counted = PrescannedEntity(kind, handle, layer, paper, box=box)
        return Entry(counted, handle, self._found(row))

    def reference(self, row: int) -> Reference:
        """Return the block placement of the INSERT in row ``row`` of the Scan."""
        line, value = self.entity[row].tolist(), self.found.value[row].tolist()

        def given(column: int, silent: float) -> float:
            number: float = value[column]
            return silent if np.isnan(number) else number

        return Reference(
            self.tables.names[line[f.REFERENCE]],
            line[f.MIRROR] != 0,
            (value[f.X], value[f.Y], 0.0),
            (given(f.SCALE_X, 1.0), given(f.SCALE_Y, 1.0)),
            given(f.ANGLE, 0.0),
            (max(line[f.COLUMNS], 1), max(line[f.ROWS], 1)),
            (given(f.SPACE_X, 0.0), given(f.SPACE_Y, 0.0)),
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
        alone = self._alone(rows, reach)
        position, block, given = self._inserts(rows, alone)
        expansion = BlockExpansion(
            self._all_blocks(),
            self._references(rows, alone, block),
            self.tables.styles,
            self.limits,
        )
        shown = np.where(alone, 0, self.count[rows])
        refuse_beyond(int(shown.sum()), self.limits)

        children = np.zeros(len(rows), np.int64)
        children[position] = self._size[block]
        segments = shown.copy()
        low = self._low[block]
        segments[position] = self.first[low + self._size[block]] - self.first[low]
        # First report row of each expanded entity.
        expanded = np.flatnonzero(alone)
        begin = np.zeros(len(expanded), np.int64)
        for number, one in enumerate(expanded.tolist()):
            begin[number] = len(expansion.sheet.handle)
            expansion.sheet_entity(self._entry(int(rows[one])))
        children[expanded] = np.diff(begin, append=len(expansion.sheet.handle)) - 1
        refuse_beyond(int(segments.sum()), self.limits)

        report_row = np.cumsum(children + 1) - children - 1
        before = np.cumsum(segments) - segments
        there = np.arange(len(expansion.sheet.handle)) + np.repeat(
            report_row[expanded] - begin, children[expanded] + 1
        )
        move = np.empty((len(given), 2, 3))
        inserts(given, self.found.base[block], move)
        placed = Inserts(position, block, *self._variants(rows[position], block), move)
        texts = rows[self._is_word[self.entity[rows, f.WORD]]]
        styles = self._entity_styles(rows)
        sheet = SheetRows(rows, report_row, before, shown)
        done, words = parallel_pair(
            lambda: self._placed(sheet, styles, int(segments.sum()), placed),
            lambda: read_annotations(self.tables, texts),
        )
        # An arc lies within half a chord length of its chord.
        farthest = np.maximum(done.ends.max(initial=0.0), -done.ends.min(initial=0.0))
        if not 3.0 * float(farthest) <= reach:
            raise Unsupported
        if len(expanded):
            done = self._with_expanded(done, expansion, before[expanded], begin, there, scale)
        self._report_unused_blocks(
            expansion.sheet, {*expansion.used, *map(self._key, np.unique(block).tolist())}
        )
        last = len(rows) + int(children.sum())
        unused_rows = np.arange(last, last + len(expansion.sheet.handle) - len(there))
        order = Order(rows, report_row, shown > 0, np.concatenate([there, unused_rows]))
        done, known = styled(done, list(self._numbers))
        return FastReading(
            report_rows(self.tables, order, placed, expansion.sheet), done, known, words
        )

    def _alone(self, rows: I64, reach: float) -> Bool:
        """Return the mask of the entities in ``rows`` that are expanded one by one.

        These are entities that the scan does not support, and entities with a coordinate beyond a
        third of ``reach``.
        """
        alone: Bool = (self.entity[:, f.UNSUPPORTED] != 0) & ~self._is_word[self.entity[:, f.WORD]]
        alone &= self.entity[:, f.PAPER] == 0
        alone |= distant(self.ends, self.first, reach / 3.0)
        return alone[rows]

    def _inserts(self, rows: I64, alone: Bool) -> tuple[I64, I64, F64]:
        """Return the k INSERTs in model space whose blocks are processed in columns.

        All other INSERTs are marked in the mask ``alone`` of the entities to expand one by one.
        ``rows`` are the rows in the Scan of the entities of model space.

        Returns
        -------
        position : (k,)
            Index of each INSERT into ``rows``.
        block : (k,)
            Row of the block of each INSERT.
        given : (k, 5)
            Position x and y, scale in x and in y, and rotation in degrees of each INSERT.
        """
        inserts = (self.entity[:, f.KIND] == f.INSERT) & (self.entity[:, f.PAPER] == 0)
        position = np.flatnonzero(inserts[rows])
        at = rows[position]
        mirror, wide, high, reference = (
            self.entity[at, column] for column in (f.MIRROR, f.COLUMNS, f.ROWS, f.REFERENCE)
        )
        wanted = (f.X, f.Y, f.SCALE_X, f.SCALE_Y, f.ANGLE)
        given = np.column_stack([self.found.value[at, column] for column in wanted])
        for column, silent in ((2, 1.0), (3, 1.0), (4, 0.0)):
            given[np.isnan(given[:, column]), column] = silent
        # Row of the block with each name; whether each block is simple, and whether it has no arcs.
        known = [self.tables.blocks.get(name.lower(), -1) for name in self.tables.names]
        block = np.array([*known, -1], np.int64)[reference]
        simple = np.zeros(len(self.found.block) + 1, np.bool_)
        straight = simple.copy()
        for number, arcs in self._simple.items():
            simple[number], straight[number] = True, not arcs
        scale = given[:, 2:4]
        columnar = (
            ~alone[position]
            & simple[block]
            & (mirror == 0)
            & (np.maximum(wide, high) <= 1)
            & (scale != 0.0).all(axis=1)
            & (straight[block] | (np.abs(scale[:, 0]) == np.abs(scale[:, 1])))
        )
        alone[position[~columnar]] = True
        return position[columnar], block[columnar], given[columnar]

    def _references(self, rows: I64, alone: Bool, block: I64) -> list[tuple[str, int]]:
        """Return names of blocks that INSERTs in model space place, in lower case, and how often.

        Parameters
        ----------
        rows, alone
            Rows in the Scan of the entities of model space, and the mask of those that are
            expanded one by one.
        block
            Row of the block of each INSERT that is processed in columns.
        """
        numbers, times = np.unique(block, return_counts=True)
        found = list(zip(map(self._key, numbers.tolist()), times.tolist(), strict=True))
        others = rows[alone]
        others = others[self.entity[others, f.KIND] == f.INSERT]
        return found + [self._found(row).repeats() for row in others.tolist()]

    def _placed(self, sheet: SheetRows, styles: I32, total: int, placed: Inserts) -> Columns:
        """Return the segments of all entities that are processed in columns.

        Parameters
        ----------
        sheet
            The entities of model space.
        styles : (e,)
            Style index of each entity of the Scan; -1 unless it is in model space with segments.
        total
            Number of segments to return.
        placed
            The INSERTs that are processed in columns.
        """
        done = Columns(
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
            SheetSegments(done.ends, done.bulge, done.row, done.style),
        )
        return done

    def _with_expanded(
        self,
        done: Columns,
        expansion: BlockExpansion,
        before: I64,
        begin: I64,
        there: I64,
        scale: float,
    ) -> Columns:
        """Return the segments ``done`` and the segments of expanded entities, in file order.

        Parameters
        ----------
        done
            Segments of the entities that are processed in columns.
        expansion
            Import report and shapes of the entities that were expanded one by one.
        before, begin
            For each expanded entity: number of segments in ``done`` before it, and index of its
            first row in ``there``.
        there
            Row in the whole import report of each row of the report of ``expansion``.
        scale
            Millimetres per file unit, 0 while the unit is unknown.
        """
        more = columns(expansion.sheet, expansion.placed, scale, self.limits, done.ends)
        where = before[np.searchsorted(begin, more.row, side="right") - 1]
        styles = np.array(
            [self._numbers.setdefault(one.style, len(self._numbers)) for one in expansion.placed],
            np.int32,
        )
        return Columns(
            np.insert(done.ends, where, more.ends, axis=0),
            np.insert(done.bulge, where, more.bulge),
            np.insert(done.row, where, there[more.row]),
            np.insert(done.style, where, styles[more.style]),
        )

    def _entity_styles(self, rows: I64) -> I32:
        """Return the style index of each of the e entities of the Scan, (e,).

        -1 for an entity that is not in ``rows``, the entities of model space, or has no segments.
        """
        drawn, key = style_keys(self.entity, rows, self.count)
        first, kind = unique_rows(key)
        numbers = [
            self._numbers.setdefault(self.tables.style(row), len(self._numbers))
            for row in drawn[first].tolist()
        ]
        styles = np.full(len(self.entity), -1, np.int32)
        styles[drawn] = np.array(numbers, np.int32)[kind]
        return styles

    def _variants(self, rows: I64, block: I64) -> tuple[I64, list[Variant]]:
        """Return for each of k INSERTs the index of its variant, (k,), and the list of variants.

        A variant is a block with the style of its INSERT.  ``rows`` and ``block``, (k,), are the
        rows of the INSERTs and of their blocks in the Scan.
        """
        first, kind = unique_rows(*(self.entity[rows, column] for column in _STYLE), block)
        return kind, [
            self._variant(int(block[one]), self.tables.style(int(rows[one]))) for one in first
        ]

    def _variant(self, block: int, insert_style: Style) -> Variant:
        low, size = self.tables.span.get(block, (0, 0))
        layers: list[str] = []
        given: dict[int, tuple[Message | None, tuple[Message, ...]]] = {}
        styles = np.zeros(size, np.int32)
        for number, row in enumerate(range(low, low + size)):
            if why := drop_reason(self.tables, row):
                given[number] = why, ()
                layers.append(self.tables.layer(row))
                continue
            style = self.tables.style(row, insert_style)
            styles[number] = self._numbers.setdefault(style, len(self._numbers))
            layers.append(style.layer)
            if notes := self.tables.styles.notes(style.layer):
                given[number] = None, notes
        variant = Variant(layers, given, sum(map(len, self._variant_styles)))
        self._variant_styles.append(np.repeat(styles, self.count[low : low + size]))
        return variant

    def _key(self, block: int) -> str:
        return self.tables.block_name(block).lower()

    def _report_unused_blocks(self, sheet: ReportWriter, used: set[str]) -> None:
        """Add a row to the import report ``sheet`` for each block that no INSERT places.

        ``used`` contains the names, in lower case, of the other blocks.
        """
        for key, number in self.tables.blocks.items():
            if key in used or number not in self.tables.span:
                continue
            line = self.found.block[number].tolist()
            low, size = line[f.BLOCK_HANDLE], line[f.BLOCK_HANDLE_SIZE]
            name = self.tables.block_name(number)
            layer = self.tables.names[line[f.BLOCK_LAYER]] if line[f.BLOCK_LAYER] >= 0 else "0"
            handle = self.found.data[low : low + size].decode("ascii", "replace").strip().upper()
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
        found = reader.read(known.scale)
    except Unsupported:
        return None
    # The scan takes more memory than the drawing: free it before the drawing is assembled.
    del reader
    return assemble(found.sheet, found.columns, found.styles, found.annotations, known)
