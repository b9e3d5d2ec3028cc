"""plain: what a plain DXF draws, from its bytes, in columns from end to end.

    bytes -> Scan -> entities drawn, INSERTs placed -> Sheet, Columns, Styles and inscriptions

The same as by way of ezdxf (``expand`` and ``place``), to the bit and to the word, for most files
and in a hundredth of the time.  What stands on the sheet, and blocks that an INSERT only shifts,
turns and scales, are drawn in columns.  The rest is walked through one by one: curves that are
fitted, blocks that are nested, repeated or unevenly scaled, and all that is odd.  A file that is
unusual as a whole is ezdxf's.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from knifetip.dxf import tagging as t
from knifetip.dxf.attributes import Styles
from knifetip.dxf.census import Counted
from knifetip.dxf.drawing import counts, draw, inserts, place
from knifetip.dxf.entities import Drawn, Lines, Undrawable
from knifetip.dxf.inscriptions import WORDS, inscription, of_lines
from knifetip.dxf.place import columns, refuse_after, refuse_beyond, styled
from knifetip.dxf.scan import scan
from knifetip.dxf.single import ByEzdxf, Singles
from knifetip.dxf.tables import NotPlainError, Tables
from knifetip.dxf.walk import IN_PAPER_SPACE, Block, Entry, Reference, Walk, idle, not_read, places
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.distinct import distinct
from knifetip.geometry.tolerance import BULGE
from knifetip.intake.columns import Columns, Style
from knifetip.intake.limits import REACH, Limits
from knifetip.intake.sheet import Sheet
from knifetip.model.drawing import Inscription


class Plain(NamedTuple):
    """What a plain DXF holds."""

    sheet: Sheet
    columns: Columns  #: file units
    styles: list[Style]  #: of the columns
    inscriptions: tuple[Inscription, ...]


@dataclass(frozen=True, eq=False, slots=True)
class _Variant:
    """A block as INSERTs of one style place it: what all of those have in common."""

    layers: list[str]
    dropped: dict[int, str]  #: by the number of the child
    notes: dict[int, list[str]]
    first: int  #: where the styles of its segments begin


class _Written:
    """A plain entity as it is written: a ``walk.Found``."""

    hidden = False

    def __init__(self, reader: PlainReader, row: int) -> None:
        self._reader = reader
        self._row = row

    def style(self, styles: Styles, around: Style | None) -> Style:  # noqa: ARG002
        return self._reader.tables.style(self._row, around)

    def drawn(self) -> Drawn:
        if why := self._reader.dropped(self._row):
            raise Undrawable(why)
        low, high = self._reader.first[self._row : self._row + 2]
        return Drawn(Lines(self._reader.ends[low:high], self._reader.bulge[low:high]))

    def reference(self) -> Reference:
        return self._reader.reference(self._row)

    def repeats(self) -> tuple[str, int]:
        insert = self._reader.reference(self._row)
        return insert.block.lower(), insert.cells[0] * insert.cells[1]


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
        self.tables = Tables(found)
        # Each entity in its own coordinates: those of the sheet, or of its block.
        self.count: I64 = counts(self.entity, found.value, found.vertex)
        self.first: I64 = np.concatenate([[0], np.cumsum(self.count)])
        self.ends, self.bulge = np.empty((self.first[-1], 2, 2)), np.empty(self.first[-1])
        draw(self.entity, found.value, found.vertex, self.first, self.ends, self.bulge)
        # First entity of each block, and how many.
        spans = [self.tables.span.get(number, (0, 0)) for number in range(len(found.block))]
        self._low, self._size = np.array(spans, np.int64).reshape(-1, 2).T
        self._odd = self._read_odd()
        self._simple = self._simple_blocks()
        self._sheet = Sheet()
        self._numbers: dict[Style, int] = {}
        self._variant_styles: list[I32] = []

    def _read_odd(self) -> dict[int, ByEzdxf]:
        """Return what ezdxf reads of the entities that are not plain, by their rows."""
        singles = Singles(self.tables.version, self.tables.encoding)
        until = time.monotonic() + self.limits.seconds
        odd = {}
        for row in np.flatnonzero(self.entity[:, t.ODD]).tolist():
            if self.tables.words[int(self.entity[row, t.WORD])] in WORDS:
                continue
            refuse_after(until, self.limits)
            try:
                odd[row] = singles.read(self._lines(row))
            except Exception as damage:
                raise NotPlainError from damage
        return odd

    def _lines(self, row: int) -> bytes:
        return self.found.data[self.entity[row, t.START] : self.entity[row, t.END]]

    def _simple_blocks(self) -> dict[int, bool]:
        """Return of each block that can be drawn in columns whether it has arcs."""
        entity = self.entity
        special = (entity[:, t.KIND] == t.INSERT) | (entity[:, t.ODD] != 0)
        special &= entity[:, t.PAPER] == 0
        simple = {}
        for block in self.tables.blocks.values():
            low, size = self.tables.span.get(block, (0, 0))
            if not special[low : low + size].any() and not self.found.block[block, t.EXTERNAL]:
                bulge = self.bulge[self.first[low] : self.first[low + size]]
                simple[block] = bool((np.abs(bulge) >= BULGE).any())
        return simple

    def _all_blocks(self) -> dict[str, Block]:
        """Return the blocks to walk through."""
        blocks = {}
        inserts = np.flatnonzero(self.entity[:, t.KIND] == t.INSERT)
        for key, number in self.tables.blocks.items():
            low, size = self.tables.span.get(number, (0, 0))
            nested = inserts[np.searchsorted(inserts, low) : np.searchsorted(inserts, low + size)]
            line = self.found.block[number].tolist()
            blocks[key] = Block(
                self.tables.names[line[t.NAME]],
                self.found.base[number],
                line[t.EXTERNAL] != 0,
                size,
                [self._found(row).repeats() for row in nested.tolist()],
                partial(self._entries, range(low, low + size)),
            )
        return blocks

    def _found(self, row: int) -> ByEzdxf | _Written:
        return self._odd.get(row) or _Written(self, row)

    def _entries(self, rows: Iterable[int]) -> list[Entry]:
        return [self._entry(row, number) for number, row in enumerate(rows)]

    def _entry(self, row: int, number: int) -> Entry:
        """Return an entity to walk through; who has no handle has its number in the list."""
        line = self.entity[row]
        kind, handle = self.tables.words[int(line[t.WORD])], self.tables.handles[row]
        counted = Counted(kind, handle, self.tables.layer(row), bool(line[t.PAPER]))
        return Entry(counted, handle or f"#{number + 1}", self._found(row))

    def reference(self, row: int) -> Reference:
        """Return what a plain INSERT places."""
        line, value = self.entity[row].tolist(), self.found.value[row].tolist()

        def said(column: int, silent: float) -> float:
            number: float = value[column]
            return silent if np.isnan(number) else number

        return Reference(
            self.tables.names[line[t.REFERENCE]],
            line[t.MIRROR] != 0,
            (value[t.X], value[t.Y], 0.0),
            (said(t.SCALE_X, 1.0), said(t.SCALE_Y, 1.0)),
            said(t.ANGLE, 0.0),
            (max(line[t.COLUMNS], 1), max(line[t.ROWS], 1)),
            (said(t.SPACE_X, 0.0), said(t.SPACE_Y, 0.0)),
            clipped=False,
        )

    def dropped(self, row: int) -> str:
        """Return why a plain entity is left out, empty for what is drawn."""
        line = self.entity[row]
        if line[t.PAPER]:
            return IN_PAPER_SPACE
        kind = line[t.KIND]
        if kind == t.OTHER:
            return not_read(self.tables.words[int(line[t.WORD])])
        if kind in (t.LWPOLYLINE, t.POLYLINE) and line[t.COUNT] < 2:
            return f"it has {line[t.COUNT]} vertices: no line between them"
        return ""

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
        rows = np.flatnonzero(self.entity[:, t.BLOCK] < 0)
        reach = REACH / (scale or 1.0)
        alone = self._alone(rows, reach)
        spots, block, said = self._inserts(rows, alone)
        walk = Walk(
            self._all_blocks(),
            self._references(rows, alone, block),
            self.tables.styles,
            self.limits,
        )
        refuse_beyond(int(self.count[rows].sum()), self.limits)

        children = np.zeros(len(rows), np.int64)
        segments = np.where(alone, 0, self.count[rows])
        variants = self._variants(rows[spots], block)
        # Of each INSERT the block's first entity and segment, and where the styles begin.
        first = self._low[block]
        source = np.column_stack([first, self.first[first], [one.first for one in variants]])
        children[spots] = self._size[block]
        segments[spots] = self.first[first + self._size[block]] - self.first[first]
        move = np.empty((len(spots), 2, 3))
        inserts(said, self.found.base[block], move)
        walked: dict[int, tuple[int, int]] = {}
        for spot in np.flatnonzero(alone).tolist():
            begin = len(walk.sheet.handle)
            walk.sheet_entity(self._entry(int(rows[spot]), spot))
            walked[spot] = begin, len(walk.sheet.handle)
            children[spot] = len(walk.sheet.handle) - begin - 1
        total = int(segments.sum())
        refuse_beyond(total, self.limits)

        ledger = np.cumsum(children) - children + np.arange(len(rows))
        before = np.cumsum(segments) - segments
        done = Columns(
            np.empty((total, 2, 2)),
            np.empty(total),
            np.empty(total, np.int32),
            np.empty(total, np.int32),
        )
        place(
            (rows, ledger, before, np.where(alone, 0, self.count[rows])),
            (self.ends, self.bulge, self.first, self._entity_styles(rows)),
            (
                spots,
                source.astype(np.int64),
                children[spots],
                move,
                np.concatenate([np.zeros(0, np.int32), *self._variant_styles]),
            ),
            (done.ends, done.bulge, done.row, done.style),
        )
        # An arc reaches no farther beyond its ends than half their distance.
        if not 3.0 * float(np.abs(done.ends).max(initial=0.0)) <= reach:
            raise NotPlainError
        if walked:
            done = self._with_walked(done, walk, walked, ledger, before, scale)
        placed = list(zip(spots.tolist(), block.tolist(), variants, strict=True))
        self._write_ledger(rows, ledger, spots, block, variants, walk.sheet, walked)
        self._write_odd(rows, placed, ledger, walk.sheet, walked)
        self._write_idle_blocks({*walk.used, *map(self._key, np.unique(block).tolist())})
        done, styles = styled(done, list(self._numbers))
        return Plain(self._sheet, done, styles, self._inscriptions(rows))

    def _alone(self, rows: I64, reach: float) -> Bool:
        """Return what on the sheet is walked through for its own sake: odd, or far away."""
        line = self.entity[rows]
        here = line[:, t.PAPER] == 0
        words = [number for number, word in self.tables.words.items() if word in WORDS]
        alone: Bool = (line[:, t.ODD] != 0) & here & ~np.isin(line[:, t.WORD], words)
        far = np.flatnonzero(~(3.0 * np.abs(self.ends).max(axis=(1, 2), initial=0.0) <= reach))
        if len(far):
            entities = np.unique(np.searchsorted(self.first, far, side="right") - 1)
            alone |= np.isin(rows, entities)
        return alone

    def _inserts(self, rows: I64, alone: Bool) -> tuple[I64, I64, F64]:
        """Return the INSERTs on the sheet that are drawn in columns.

        The others are added to ``alone``.

        Returns
        -------
        spots : (k,)
            Which of ``rows`` they are.
        block : (k,)
            Rows of their blocks.
        said : (k, 5)
            x, y, scale in x and in y, rotation in degrees.
        """
        line = self.entity[rows]
        spots = np.flatnonzero((line[:, t.KIND] == t.INSERT) & (line[:, t.PAPER] == 0))
        line = line[spots]
        said = self.found.value[rows[spots]][:, [t.X, t.Y, t.SCALE_X, t.SCALE_Y, t.ANGLE]]
        for column, silent in ((2, 1.0), (3, 1.0), (4, 0.0)):
            said[np.isnan(said[:, column]), column] = silent
        # Of each name the row of its block, of each block whether it is simple, and without arcs.
        known = [self.tables.blocks.get(name.lower(), -1) for name in self.tables.names]
        block = np.array([*known, -1], np.int64)[line[:, t.REFERENCE]]
        simple = np.zeros(len(self.found.block) + 1, np.bool_)
        straight = simple.copy()
        for number, arcs in self._simple.items():
            simple[number], straight[number] = True, not arcs
        scale = said[:, 2:4]
        columnar = (
            ~alone[spots]
            & simple[block]
            & (line[:, [t.MIRROR, t.COLUMNS, t.ROWS]] <= [0, 1, 1]).all(axis=1)
            & (scale != 0.0).all(axis=1)
            & (straight[block] | (np.abs(scale[:, 0]) == np.abs(scale[:, 1])))
        )
        alone[spots[~columnar]] = True
        return spots[columnar], block[columnar], said[columnar]

    def _references(self, rows: I64, alone: Bool, block: I64) -> list[tuple[str, int]]:
        """Return the blocks that the sheet places, and how often."""
        numbers, times = np.unique(block, return_counts=True)
        found = list(zip(map(self._key, numbers.tolist()), times.tolist(), strict=True))
        line = self.entity[rows]
        others = alone & (line[:, t.KIND] == t.INSERT)
        return found + [self._found(row).repeats() for row in rows[others].tolist()]

    def _with_walked(
        self,
        done: Columns,
        walk: Walk,
        walked: dict[int, tuple[int, int]],
        ledger: I64,
        before: I64,
        scale: float,
    ) -> Columns:
        """Return the columns with what was walked through, where it stands in the file."""
        more = columns(walk.sheet, walk.placed, scale, self.limits, done.ends)
        spot = np.array(list(walked), np.int64)
        begin = np.array([first for first, _ in walked.values()], np.int64)
        owner = np.searchsorted(begin, more.row, side="right") - 1
        where = before[spot[owner]]
        styles = np.array(
            [self._numbers.setdefault(one.style, len(self._numbers)) for one in walk.placed],
            np.int32,
        )
        row = ledger[spot[owner]] + more.row - begin[owner]
        return Columns(
            np.insert(done.ends, where, more.ends, axis=0),
            np.insert(done.bulge, where, more.bulge),
            np.insert(done.row, where, row),
            np.insert(done.style, where, styles[more.style]),
        )

    def _entity_styles(self, rows: I64) -> I32:
        """Return the number of the style of each entity that is drawn on the sheet, (e,)."""
        drawn = rows[self.count[rows] > 0]
        line = self.entity[drawn]
        first, kind = distinct(line[:, [t.LAYER, t.LINETYPE, t.COLOUR, t.TRUE_COLOUR]])
        numbers = [
            self._numbers.setdefault(self.tables.style(row), len(self._numbers))
            for row in drawn[first].tolist()
        ]
        styles = np.full(len(self.entity), -1, np.int32)
        styles[drawn] = np.array(numbers, np.int32)[kind]
        return styles

    def _variants(self, rows: I64, block: I64) -> list[_Variant]:
        """Return of each INSERT what its block is when it is placed by such an INSERT."""
        columns = self.entity[rows][:, [t.LAYER, t.LINETYPE, t.COLOUR, t.TRUE_COLOUR]]
        first, kind = distinct(np.column_stack([columns, block]))
        made = [self._variant(int(block[one]), self.tables.style(int(rows[one]))) for one in first]
        return [made[number] for number in kind.tolist()]

    def _variant(self, block: int, around: Style) -> _Variant:
        low, size = self.tables.span.get(block, (0, 0))
        layers: list[str] = []
        dropped: dict[int, str] = {}
        notes: dict[int, list[str]] = {}
        styles = np.zeros(size, np.int32)
        for number, row in enumerate(range(low, low + size)):
            if why := self.dropped(row):
                dropped[number] = why
                layers.append(self.tables.layer(row))
                continue
            style = self.tables.style(row, around)
            styles[number] = self._numbers.setdefault(style, len(self._numbers))
            layers.append(style.layer)
            if said := self.tables.styles.notes(style.layer):
                notes[number] = list(said)
        variant = _Variant(
            layers,
            dropped,
            notes,
            sum(map(len, self._variant_styles)),
        )
        self._variant_styles.append(np.repeat(styles, self.count[low : low + size]))
        return variant

    def _named(self, rows: Iterable[int]) -> list[str]:
        """Return the handles of one list of entities; who has none has its number there."""
        handles = self.tables.handles
        return [handles[row] or f"#{number + 1}" for number, row in enumerate(rows)]

    def _write_ledger(
        self,
        rows: I64,
        ledger: I64,
        spots: I64,
        block: I64,
        variants: list[_Variant],
        walk: Sheet,
        walked: dict[int, tuple[int, int]],
    ) -> None:
        """Write handles, kinds and layers: the sheet's, and in between what it places."""
        words = np.empty(len(self.tables.names), object)
        for number, word in self.tables.words.items():
            words[number] = word
        layers = np.array([*self.tables.names, "0"], object)
        handle, kind = self._named(rows.tolist()), words[self.entity[rows, t.WORD]]
        layer = layers[self.entity[rows, t.LAYER]]
        sheet = self._sheet
        if not len(spots) and not walked:
            sheet.handle, sheet.kind, sheet.layer = handle, kind.tolist(), layer.tolist()
            return
        inner = {one: self._named(self._inside(one)) for one in np.unique(block).tolist()}
        paths = [handle[spot] + "/" for spot in spots.tolist()]
        placed = list(zip(paths, block.tolist(), strict=True))
        # Rows of the ledger that INSERTs give, and the entities that stand there.
        size = self._size[block]
        step = np.arange(size.sum()) - np.repeat(np.cumsum(size) - size, size)
        under = np.repeat(ledger[spots] + 1, size) + step
        inserted = np.repeat(self._low[block], size) + step
        more = [high - low - 1 for low, high in walked.values()]
        total = len(rows) + len(under) + sum(more)
        columns = [np.empty(total, object) for _ in range(3)]
        for column, own in zip(columns, (handle, kind, layer), strict=True):
            column[ledger] = own
        columns[0][under] = [path + name for path, one in placed for name in inner[one]]
        columns[1][under] = words[self.entity[inserted, t.WORD]]
        columns[2][under] = [name for variant in variants for name in variant.layers]
        for spot, (low, high) in walked.items():
            there = slice(int(ledger[spot]), int(ledger[spot]) + high - low)
            for column, own in zip(columns, (walk.handle, walk.kind, walk.layer), strict=True):
                column[there] = own[low:high]
        sheet.handle, sheet.kind, sheet.layer = (column.tolist() for column in columns)

    def _inside(self, block: int) -> range:
        low, size = self.tables.span.get(block, (0, 0))
        return range(low, low + size)

    def _write_odd(
        self,
        rows: I64,
        placed: list[tuple[int, int, _Variant]],
        ledger: I64,
        walk: Sheet,
        walked: dict[int, tuple[int, int]],
    ) -> None:
        """Write what was dropped, and what is said of the rest."""
        entity, sheet = self.entity[rows], self._sheet
        at = ledger.tolist()
        own = np.ones(len(rows), np.bool_)
        own[list(walked)] = False
        on_sheet = (entity[:, t.KIND] == t.INSERT) & (entity[:, t.PAPER] == 0)
        out = own & (self.count[rows] == 0) & ~on_sheet
        for number in np.flatnonzero(out).tolist():
            sheet.dropped[at[number]] = self.dropped(int(rows[number]))
        said_of = {block: places(self._name(block)) for block in {one for _, one, _ in placed}}
        for spot, block, variant in placed:
            sheet.notes[at[spot]] = [said_of[block]]
            for child, why in variant.dropped.items():
                sheet.dropped[at[spot] + 1 + child] = why
            for child, said in variant.notes.items():
                sheet.notes[at[spot] + 1 + child] = list(said)
        for layer in np.flatnonzero(np.bincount(entity[:, t.LAYER] + 1)).tolist():
            if of_layer := self.tables.styles.notes(self.tables.names[layer - 1] if layer else "0"):
                there = own & ~out & (entity[:, t.LAYER] == layer - 1)
                for number in np.flatnonzero(there).tolist():
                    sheet.notes.setdefault(at[number], []).extend(of_layer)
        for spot, (low, high) in walked.items():
            for row in range(low, high):
                here = at[spot] + row - low
                if row in walk.dropped:
                    sheet.dropped[here] = walk.dropped[row]
                if row in walk.notes:
                    sheet.notes[here] = walk.notes[row]

    def _name(self, block: int) -> str:
        name: str = self.tables.names[self.found.block[block, t.NAME]]
        return name

    def _key(self, block: int) -> str:
        return self._name(block).lower()

    def _write_idle_blocks(self, used: set[str]) -> None:
        """Say of the blocks that nothing places that they hold lines and draw none."""
        for key, number in self.tables.blocks.items():
            if key in used or number not in self.tables.span:
                continue
            line = self.found.block[number].tolist()
            low, size = line[t.BLOCK_HANDLE], line[t.BLOCK_HANDLE_SIZE]
            name = self.tables.names[line[t.NAME]]
            layer = self.tables.names[line[t.BLOCK_LAYER]] if line[t.BLOCK_LAYER] >= 0 else "0"
            handle = self.found.data[low : low + size].decode("ascii", "replace").strip().upper()
            why = idle(name, self.tables.span[number][1])
            self._sheet.row(handle or name, "BLOCK", layer, why)

    def _inscriptions(self, rows: I64) -> tuple[Inscription, ...]:
        """Return the words among entities of the sheet."""
        of_words = [number for number, word in self.tables.words.items() if word in WORDS]
        line = self.entity[rows]
        rows = rows[np.isin(line[:, t.WORD], of_words) & (line[:, t.PAPER] == 0)]
        encoding, data = self.tables.encoding, self.found.data
        lengths = self.found.value[rows][:, t.LENGTHS].tolist()
        found = []
        for row, one, said in zip(rows.tolist(), self.entity[rows].tolist(), lengths, strict=True):
            kind, layer = self.tables.words[one[t.WORD]], self.tables.layer(row)
            if one[t.ODD]:
                found.append(of_lines(kind, layer, self._lines(row), encoding))
                continue
            text = data[one[t.FIRST] : one[t.FIRST] + one[t.COUNT]].decode(encoding, "replace")
            found.append(inscription(kind, layer, text, said, one[t.FLAGS]))
        return tuple(found)
