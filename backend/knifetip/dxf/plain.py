"""plain: what a plain DXF draws, from its bytes, in columns from end to end.

    bytes -> Scan -> entities drawn, INSERTs placed -> ReportRows, Columns, Styles and inscriptions

The same as by way of ezdxf (``expand`` and ``place``), to the bit and to the word, for most files
and in a hundredth of the time.  What stands on the sheet, and blocks that an INSERT only shifts,
turns and scales, are drawn in columns.  The rest is walked through one by one: curves that are
fitted, blocks that are nested, repeated or unevenly scaled, and all that is odd.  A file that is
unusual as a whole is ezdxf's.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from functools import partial
from typing import NamedTuple

import numpy as np

from knifetip.drawing_builder.columns import Columns, Style
from knifetip.drawing_builder.report import ReportRows, ReportWriter
from knifetip.dxf import fields as f
from knifetip.dxf.attributes import Styles
from knifetip.dxf.census import Counted
from knifetip.dxf.drawing import (
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
from knifetip.dxf.entities import Drawn, Lines, Undrawable
from knifetip.dxf.inscriptions import WORDS
from knifetip.dxf.place import columns, refuse_after, refuse_beyond, styled
from knifetip.dxf.scan import Scan, scan
from knifetip.dxf.single import ByEzdxf, Singles
from knifetip.dxf.tables import NotPlainError, Tables
from knifetip.dxf.walk import Block, Entry, Reference, Walk, idle
from knifetip.dxf.written import Inserts, Order, Variant, boxes, inscriptions, left_out, written
from knifetip.formats.limits import REACH, Limits
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.cores import both
from knifetip.geometry.distinct import distinct
from knifetip.geometry.tolerance import BULGE
from knifetip.model.drawing import Inscription

#: What an entity says of its style.
_STYLE = [f.LAYER, f.LINETYPE, f.COLOUR, f.TRUE_COLOUR]


class Plain(NamedTuple):
    """What a plain DXF holds."""

    sheet: ReportRows
    columns: Columns  #: file units
    styles: list[Style]  #: of the columns
    inscriptions: tuple[Inscription, ...]


class _AsWritten:
    """A plain entity as it is written: a ``walk.Found``."""

    hidden = False

    def __init__(self, reader: PlainReader, row: int) -> None:
        self._reader = reader
        self._row = row

    def style(self, styles: Styles, around: Style | None) -> Style:  # noqa: ARG002
        # The tables of the file have the same styles.
        return self._reader.tables.style(self._row, around)

    def drawn(self) -> Drawn:
        if why := left_out(self._reader.tables, self._row):
            raise Undrawable(why)
        low, high = self._reader.first[self._row : self._row + 2]
        return Drawn(Lines(self._reader.ends[low:high], self._reader.bulge[low:high]))

    def reference(self) -> Reference:
        return self._reader.reference(self._row)

    def repeats(self) -> tuple[str, int]:
        insert = self._reader.reference(self._row)
        return insert.block.lower(), insert.cells[0] * insert.cells[1]


def _drawn(found: Scan) -> tuple[I64, I64, F64, F64]:
    """Return how many segments each entity has, where they begin, their ends and bulges."""
    count: I64 = counts(found.entity, found.value, found.vertex)
    first: I64 = np.concatenate([[0], np.cumsum(count)])
    ends, bulge = np.empty((first[-1], 2, 2)), np.empty(first[-1])
    draw(found.entity, found.value, found.vertex, first, ends, bulge)
    return count, first, ends, bulge


class PlainReader:
    """One plain file on its way from what is written to what is drawn.

    Raises
    ------
    NotPlainError
        The file is ezdxf's.
    """

    def __init__(self, data: bytes, limits: Limits) -> None:
        found = scan(data)
        if found is None or len(found.entity) > limits.entities:
            raise NotPlainError
        self.found = found
        self.limits = limits
        self.entity = found.entity
        # Each entity in its own coordinates: those of the sheet, or of its block.
        self.count: I64
        self.first: I64
        self.ends: F64
        self.bulge: F64
        (self.count, self.first, self.ends, self.bulge), self.tables = both(
            lambda: _drawn(found), lambda: Tables(found)
        )
        # First entity of each block, and how many.
        spans = [self.tables.span.get(number, (0, 0)) for number in range(len(found.block))]
        self._low, self._size = np.array(spans, np.int64).reshape(-1, 2).T
        self._is_word = np.isin(
            np.arange(len(self.tables.names)),
            [number for number, word in self.tables.words.items() if word in WORDS],
        )
        self._odd = self._read_odd()
        self._simple = self._simple_blocks()
        self._numbers: dict[Style, int] = {}
        self._variant_styles: list[I32] = []

    def _read_odd(self) -> dict[int, ByEzdxf]:
        """Return what ezdxf reads of the entities that are not plain, by their rows."""
        singles = Singles(self.tables.version, self.tables.encoding)
        until = time.monotonic() + self.limits.seconds
        odd = {}
        for row in np.flatnonzero(self.entity[:, f.ODD]).tolist():
            if self._is_word[self.entity[row, f.WORD]]:
                continue
            refuse_after(until, self.limits)
            low, high = self.entity[row, [f.START, f.END]].tolist()
            try:
                odd[row] = singles.read(self.found.data[low:high])
            except Exception as damage:
                raise NotPlainError from damage
        return odd

    def _simple_blocks(self) -> dict[int, bool]:
        """Return of each block that can be drawn in columns whether it has arcs."""
        entity = self.entity
        special = (entity[:, f.KIND] == f.INSERT) | (entity[:, f.ODD] != 0)
        special &= entity[:, f.PAPER] == 0
        simple = {}
        for block in self.tables.blocks.values():
            low, size = self.tables.span.get(block, (0, 0))
            if not special[low : low + size].any() and not self.found.block[block, f.EXTERNAL]:
                bulge = self.bulge[self.first[low] : self.first[low + size]]
                simple[block] = bool((np.abs(bulge) >= BULGE).any())
        return simple

    def _all_blocks(self) -> dict[str, Block]:
        """Return the blocks to walk through."""
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

    def _found(self, row: int) -> ByEzdxf | _AsWritten:
        return self._odd.get(row) or _AsWritten(self, row)

    def _entries(self, rows: Iterable[int]) -> list[Entry]:
        return list(map(self._entry, rows))

    def _entry(self, row: int) -> Entry:
        """Return an entity to walk through."""
        line = self.entity[row]
        kind, handle = self.tables.words[int(line[f.WORD])], self.tables.handles[row]
        box = None if line[f.PAPER] else boxes(self.tables, np.array([row]))[0]
        counted = Counted(kind, handle, self.tables.layer(row), bool(line[f.PAPER]), box=box)
        return Entry(counted, handle, self._found(row))

    def reference(self, row: int) -> Reference:
        """Return what a plain INSERT places."""
        line, value = self.entity[row].tolist(), self.found.value[row].tolist()

        def said(column: int, silent: float) -> float:
            number: float = value[column]
            return silent if np.isnan(number) else number

        return Reference(
            self.tables.names[line[f.REFERENCE]],
            line[f.MIRROR] != 0,
            (value[f.X], value[f.Y], 0.0),
            (said(f.SCALE_X, 1.0), said(f.SCALE_Y, 1.0)),
            said(f.ANGLE, 0.0),
            (max(line[f.COLUMNS], 1), max(line[f.ROWS], 1)),
            (said(f.SPACE_X, 0.0), said(f.SPACE_Y, 0.0)),
            clipped=False,
        )

    def read(self, scale: float) -> Plain:
        """Return the ledger and the columns, in the order of the file.

        Parameters
        ----------
        scale
            Millimetres to a file unit, 0 while it is unknown.

        Raises
        ------
        DrawingTooLarge
            A limit is exceeded.
        NotPlainError
            Something that an INSERT places is too far away.
        """
        rows = np.flatnonzero(self.entity[:, f.BLOCK] < 0)
        reach = REACH / (scale or 1.0)
        alone = self._alone(rows, reach)
        spot, block, said = self._inserts(rows, alone)
        walk = Walk(
            self._all_blocks(),
            self._references(rows, alone, block),
            self.tables.styles,
            self.limits,
        )
        shown = np.where(alone, 0, self.count[rows])
        refuse_beyond(int(shown.sum()), self.limits)

        children = np.zeros(len(rows), np.int64)
        children[spot] = self._size[block]
        segments = shown.copy()
        low = self._low[block]
        segments[spot] = self.first[low + self._size[block]] - self.first[low]
        # What is walked through: where each begins in the ledger of the walk.
        walked = np.flatnonzero(alone)
        begin = np.zeros(len(walked), np.int64)
        for number, one in enumerate(walked.tolist()):
            begin[number] = len(walk.sheet.handle)
            walk.sheet_entity(self._entry(int(rows[one])))
        children[walked] = np.diff(begin, append=len(walk.sheet.handle)) - 1
        refuse_beyond(int(segments.sum()), self.limits)

        ledger = np.cumsum(children + 1) - children - 1
        before = np.cumsum(segments) - segments
        there = np.arange(len(walk.sheet.handle)) + np.repeat(
            ledger[walked] - begin, children[walked] + 1
        )
        move = np.empty((len(said), 2, 3))
        inserts(said, self.found.base[block], move)
        placed = Inserts(spot, block, *self._variants(rows[spot], block), move)
        texts = rows[self._is_word[self.entity[rows, f.WORD]]]
        styles = self._entity_styles(rows)
        sheet = SheetRows(rows, ledger, before, shown)
        done, words = both(
            lambda: self._placed(sheet, styles, int(segments.sum()), placed),
            lambda: inscriptions(self.tables, texts),
        )
        # An arc reaches no farther beyond its ends than half their distance.
        farthest = np.maximum(done.ends.max(initial=0.0), -done.ends.min(initial=0.0))
        if not 3.0 * float(farthest) <= reach:
            raise NotPlainError
        if len(walked):
            done = self._with_walked(done, walk, before[walked], begin, there, scale)
        self._name_idle_blocks(walk.sheet, {*walk.used, *map(self._key, np.unique(block).tolist())})
        last = len(rows) + int(children.sum())
        idle_ = np.arange(last, last + len(walk.sheet.handle) - len(there))
        order = Order(rows, ledger, shown > 0, np.concatenate([there, idle_]))
        done, known = styled(done, list(self._numbers))
        return Plain(written(self.tables, order, placed, walk.sheet), done, known, words)

    def _alone(self, rows: I64, reach: float) -> Bool:
        """Return what on the sheet is walked through for its own sake: odd, or far away."""
        alone: Bool = (self.entity[:, f.ODD] != 0) & ~self._is_word[self.entity[:, f.WORD]]
        alone &= self.entity[:, f.PAPER] == 0
        alone |= distant(self.ends, self.first, reach / 3.0)
        return alone[rows]

    def _inserts(self, rows: I64, alone: Bool) -> tuple[I64, I64, F64]:
        """Return the INSERTs on the sheet that are drawn in columns.

        The others are added to ``alone``.

        Returns
        -------
        spot : (k,)
            Which of ``rows`` they are.
        block : (k,)
            Rows of their blocks.
        said : (k, 5)
            x, y, scale in x and in y, rotation in degrees.
        """
        inserts = (self.entity[:, f.KIND] == f.INSERT) & (self.entity[:, f.PAPER] == 0)
        spot = np.flatnonzero(inserts[rows])
        at = rows[spot]
        mirror, wide, high, reference = (
            self.entity[at, column] for column in (f.MIRROR, f.COLUMNS, f.ROWS, f.REFERENCE)
        )
        says = (f.X, f.Y, f.SCALE_X, f.SCALE_Y, f.ANGLE)
        said = np.column_stack([self.found.value[at, column] for column in says])
        for column, silent in ((2, 1.0), (3, 1.0), (4, 0.0)):
            said[np.isnan(said[:, column]), column] = silent
        # Of each name the row of its block, of each block whether it is simple, and without arcs.
        known = [self.tables.blocks.get(name.lower(), -1) for name in self.tables.names]
        block = np.array([*known, -1], np.int64)[reference]
        simple = np.zeros(len(self.found.block) + 1, np.bool_)
        straight = simple.copy()
        for number, arcs in self._simple.items():
            simple[number], straight[number] = True, not arcs
        scale = said[:, 2:4]
        columnar = (
            ~alone[spot]
            & simple[block]
            & (mirror == 0)
            & (np.maximum(wide, high) <= 1)
            & (scale != 0.0).all(axis=1)
            & (straight[block] | (np.abs(scale[:, 0]) == np.abs(scale[:, 1])))
        )
        alone[spot[~columnar]] = True
        return spot[columnar], block[columnar], said[columnar]

    def _references(self, rows: I64, alone: Bool, block: I64) -> list[tuple[str, int]]:
        """Return the blocks that the sheet places, and how often."""
        numbers, times = np.unique(block, return_counts=True)
        found = list(zip(map(self._key, numbers.tolist()), times.tolist(), strict=True))
        others = rows[alone]
        others = others[self.entity[others, f.KIND] == f.INSERT]
        return found + [self._found(row).repeats() for row in others.tolist()]

    def _placed(self, sheet: SheetRows, styles: I32, total: int, placed: Inserts) -> Columns:
        """Return the segments of all that is drawn in columns.

        Parameters
        ----------
        sheet
            Of each entity its row, its row in the ledger, the segments before it, and its own.
        styles : (e,)
            The number of the style of each entity that is drawn on the sheet.
        total
            Segments of the drawing.
        """
        done = Columns(
            np.empty((total, 2, 2)),
            np.empty(total),
            np.empty(total, np.int32),
            np.empty(total, np.int32),
        )
        # Of each INSERT the block's first entity and segment, and where the styles begin.
        low = self._low[placed.block]
        begin = np.array([one.first for one in placed.variants], np.int64)[placed.variant]
        place(
            sheet,
            EntitySegments(self.ends, self.bulge, self.first, styles),
            PlacedBlocks(
                placed.spot,
                np.column_stack([low, self.first[low], begin]),
                self._size[placed.block],
                placed.move,
                np.concatenate([np.zeros(0, np.int32), *self._variant_styles]),
            ),
            SheetSegments(done.ends, done.bulge, done.row, done.style),
        )
        return done

    def _with_walked(
        self, done: Columns, walk: Walk, before: I64, begin: I64, there: I64, scale: float
    ) -> Columns:
        """Return the columns with what was walked through, where it stands in the file.

        Parameters
        ----------
        before, begin
            Of each entity the segments before it, and its row in the ledger of the walk.
        there
            Of each row of that ledger its row in the drawing's.
        """
        more = columns(walk.sheet, walk.placed, scale, self.limits, done.ends)
        where = before[np.searchsorted(begin, more.row, side="right") - 1]
        styles = np.array(
            [self._numbers.setdefault(one.style, len(self._numbers)) for one in walk.placed],
            np.int32,
        )
        return Columns(
            np.insert(done.ends, where, more.ends, axis=0),
            np.insert(done.bulge, where, more.bulge),
            np.insert(done.row, where, there[more.row]),
            np.insert(done.style, where, styles[more.style]),
        )

    def _entity_styles(self, rows: I64) -> I32:
        """Return the number of the style of each entity that is drawn on the sheet, (e,)."""
        drawn, key = style_keys(self.entity, rows, self.count)
        first, kind = distinct(key)
        numbers = [
            self._numbers.setdefault(self.tables.style(row), len(self._numbers))
            for row in drawn[first].tolist()
        ]
        styles = np.full(len(self.entity), -1, np.int32)
        styles[drawn] = np.array(numbers, np.int32)[kind]
        return styles

    def _variants(self, rows: I64, block: I64) -> tuple[I64, list[Variant]]:
        """Return of each INSERT what its block is when it is placed by such an INSERT."""
        first, kind = distinct(*(self.entity[rows, column] for column in _STYLE), block)
        return kind, [
            self._variant(int(block[one]), self.tables.style(int(rows[one]))) for one in first
        ]

    def _variant(self, block: int, around: Style) -> Variant:
        low, size = self.tables.span.get(block, (0, 0))
        layers: list[str] = []
        said: dict[int, tuple[str, tuple[str, ...]]] = {}
        styles = np.zeros(size, np.int32)
        for number, row in enumerate(range(low, low + size)):
            if why := left_out(self.tables, row):
                said[number] = why, ()
                layers.append(self.tables.layer(row))
                continue
            style = self.tables.style(row, around)
            styles[number] = self._numbers.setdefault(style, len(self._numbers))
            layers.append(style.layer)
            if notes := self.tables.styles.notes(style.layer):
                said[number] = "", notes
        variant = Variant(layers, said, sum(map(len, self._variant_styles)))
        self._variant_styles.append(np.repeat(styles, self.count[low : low + size]))
        return variant

    def _key(self, block: int) -> str:
        return self.tables.block_name(block).lower()

    def _name_idle_blocks(self, sheet: ReportWriter, used: set[str]) -> None:
        """Say of the blocks that nothing places that they hold lines and draw none."""
        for key, number in self.tables.blocks.items():
            if key in used or number not in self.tables.span:
                continue
            line = self.found.block[number].tolist()
            low, size = line[f.BLOCK_HANDLE], line[f.BLOCK_HANDLE_SIZE]
            name = self.tables.block_name(number)
            layer = self.tables.names[line[f.BLOCK_LAYER]] if line[f.BLOCK_LAYER] >= 0 else "0"
            handle = self.found.data[low : low + size].decode("ascii", "replace").strip().upper()
            sheet.row(handle or name, "BLOCK", layer, idle(name, self.tables.span[number][1]))
