"""plain: what a plain DXF draws, from its bytes, in columns from end to end.

    bytes -> Scan -> entities drawn, INSERTs placed -> Sheet, Columns and Styles

The same as by way of ezdxf (``expand`` and ``place``), to the bit and to the word, for most files
and in a hundredth of the time.  None for all that asks for more than this module promises: curves
to be fitted, nested or repeated blocks, heights, names with escapes, anything damaged or unusual.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

import numpy as np
from numba import njit

from knifetip.dxf import scan as s
from knifetip.dxf.attributes import BYLAYER, Layer, Styles, layer_of
from knifetip.dxf.census import header_of
from knifetip.dxf.encoding import encoding_of, spelled
from knifetip.dxf.expand import IN_PAPER_SPACE, idle, not_read, places
from knifetip.dxf.inscriptions import WORDS, inscription
from knifetip.dxf.shapes import (
    chain_count,
    chain_rows,
    mirror_rows,
    round_count,
    round_rows,
    swept,
    turning,
)
from knifetip.geometry.columns import F64, I32, I64
from knifetip.geometry.distinct import distinct
from knifetip.geometry.tolerance import BULGE
from knifetip.intake.columns import Columns, Style
from knifetip.intake.limits import Limits
from knifetip.intake.sheet import Sheet
from knifetip.model.drawing import Inscription

#: Signs that the format does not allow in names; what ezdxf makes of them is its own affair.
_NOT_IN_NAMES: Final = frozenset('<>/\\":;?*=`|,\ufffd')
#: Handles of more digits are no handles.
_DIGITS: Final = 15
#: Versions without subclass markers, and those that have them.
_OLD: Final = ("", "AC1002", "AC1003", "AC1004", "AC1006", "AC1009")
_NEW: Final = ("AC1012", "AC1014", "AC1015", "AC1018", "AC1021", "AC1024", "AC1027", "AC1032")


class Plain(NamedTuple):
    """What a plain DXF holds."""

    variables: dict[str, str]  #: of the header
    sheet: Sheet
    columns: Columns  #: file units
    styles: list[Style]  #: of the columns
    inscriptions: tuple[Inscription, ...]


class _NotPlainError(Exception):
    """The file is ezdxf's.  Never leaves the module."""


@dataclass(frozen=True, eq=False, slots=True)
class _Variant:
    """A block as INSERTs of one style place it: what all of those have in common."""

    kinds: list[str]
    layers: list[str]
    dropped: dict[int, str]  #: by the number of the child
    notes: dict[int, list[str]]
    first: int  #: where the styles of its segments begin


def plain(data: bytes, limits: Limits) -> Plain | None:
    """Return what a DXF holds, None where it is not plain.

    Parameters
    ----------
    data
        The file without byte order mark and leading blanks.
    """
    found = s.scan(data)
    if found is None or len(found.entity) > limits.entities:
        return None
    try:
        return _Reader(found, limits).read()
    except _NotPlainError:
        return None


class _Reader:
    """One file on its way from what is written to what is drawn."""

    def __init__(self, found: s.Scan, limits: Limits) -> None:
        self.found = found
        self.limits = limits
        self.entity = found.entity
        low, high = found.header
        self.variables = header_of(found.data[low:high])
        if self.variables.get("$ACADVER", "") not in (_NEW if found.markers else (*_OLD, *_NEW)):
            raise _NotPlainError
        self.encoding = encoding_of(found.data, self.variables)
        self.names = [name.decode(self.encoding, "replace") for name in found.names]
        self.words = self._words()
        self._check_names()
        self.layers = Styles(self._layers())
        self.handles = self._handles()
        # First row and number of rows of each block; -1 is the sheet.
        blocks, first, size = np.unique(
            self.entity[:, s.BLOCK], return_index=True, return_counts=True
        )
        self.span: dict[int, tuple[int, int]] = {
            block: (low, rows)
            for block, low, rows in zip(blocks.tolist(), first.tolist(), size.tolist(), strict=True)
        }
        self.blocks = self._blocks()
        # Each entity in its own coordinates: those of the sheet, or of its block.
        self.count = _counts(self.entity, found.value, found.vertex)
        if (self.count < 0).any():
            raise _NotPlainError
        self.first = np.concatenate([[0], np.cumsum(self.count)])
        self.ends, self.bulge = np.empty((self.first[-1], 2, 2)), np.empty(self.first[-1])
        _draw(self.entity, found.value, found.vertex, self.first, self.ends, self.bulge)
        self.sheet = Sheet()
        self.numbers: dict[Style, int] = {}
        self.variants: dict[tuple[int, Style], _Variant] = {}
        self.variant_styles: list[I32] = []

    def _words(self) -> dict[int, str]:
        """Return the kinds of entities as they are written, by the numbers of their names."""
        column = self.entity[:, s.WORD]
        words = {
            number: self.names[number] for number in np.flatnonzero(np.bincount(column)).tolist()
        }
        if any(word != word.upper() or not word.isascii() for word in words.values()):
            raise _NotPlainError
        fitted = [number for number, word in words.items() if word in ("ELLIPSE", "SPLINE")]
        if (np.isin(column, fitted) & (self.entity[:, s.PAPER] == 0)).any():
            raise _NotPlainError
        return words

    def _check_names(self) -> None:
        entity, layer = self.entity, self.found.layer
        for column in (
            entity[:, s.LAYER],
            entity[:, s.LINETYPE],
            layer[:, s.LAYER_NAME],
            layer[:, s.LAYER_LINETYPE],
            self.found.block[:, s.BLOCK_LAYER],
        ):
            for number in np.flatnonzero(np.bincount(column + 1)[1:]).tolist():
                name = self.names[number]
                if not name or not _NOT_IN_NAMES.isdisjoint(name) or spelled(name) != name:
                    raise _NotPlainError

    def _layers(self) -> dict[str, Layer]:
        table: dict[str, Layer] = {}
        for row in self.found.layer.tolist():
            name = self.names[row[s.LAYER_NAME]].lower() if row[s.LAYER_NAME] >= 0 else ""
            if not name or name in table:
                raise _NotPlainError
            linetype, true = row[s.LAYER_LINETYPE], row[s.LAYER_TRUE]
            table[name] = layer_of(
                row[s.LAYER_COLOUR],
                true if true >= 0 else None,
                self.names[linetype] if linetype >= 0 else "Continuous",
                row[s.LAYER_FLAGS],
                row[s.LAYER_PLOT],
            )
        return table

    def _handles(self) -> list[str]:
        """Return the handle of each entity, empty where it has none; no handle is there twice."""
        entity = self.entity
        text = np.zeros((len(entity), _DIGITS + 1), np.uint8)
        number = np.zeros(len(entity), np.int64)
        data = np.frombuffer(self.found.data, np.uint8)
        if not _upper(data, entity[:, s.HANDLE], entity[:, s.HANDLE_SIZE], text, number):
            raise _NotPlainError
        number = np.sort(number[number > 0])
        if (number[1:] == number[:-1]).any():
            raise _NotPlainError
        handles: list[str] = text.view(f"S{text.shape[1]}")[:, 0].astype(str).tolist()
        return handles

    def _blocks(self) -> dict[str, int]:
        """Return the rows of the blocks by their names in lower case."""
        blocks: dict[str, int] = {}
        for number, name in enumerate(self.found.block[:, s.NAME].tolist()):
            key = self.names[name].lower() if name >= 0 else ""
            if not key or key in blocks or "\\" in key or "\ufffd" in key:
                raise _NotPlainError
            blocks[key] = number
            if key.startswith(("*model_space", "*paper_space")) and number in self.span:
                raise _NotPlainError
        return blocks

    def read(self) -> Plain:
        """Return the ledger and the columns, in the order of the file."""
        rows = np.flatnonzero(self.entity[:, s.BLOCK] < 0)
        sheet = self.entity[rows]
        spots = np.flatnonzero((sheet[:, s.KIND] == s.INSERT) & (sheet[:, s.PAPER] == 0))
        children = np.zeros(len(rows), np.int64)
        segments = self.count[rows]
        # Of each INSERT the block's first entity and segment, and where the styles begin.
        source = np.zeros((len(spots), 3), np.int64)
        move = np.zeros((len(spots), 2, 3))
        variants: list[_Variant] = []
        for number, spot in enumerate(spots.tolist()):
            row = int(rows[spot])
            block = self._placed(row, move[number])
            low, size = self.span.get(block, (0, 0))
            variant = self._variant(block, self._style(row))
            variants.append(variant)
            children[spot] = size
            segments[spot] = self.first[low + size] - self.first[low]
            source[number] = low, self.first[low], variant.first
        after = np.cumsum(segments)
        total = int(segments.sum())
        if int(children.sum()) > self.limits.expanded or total > self.limits.segments:
            raise _NotPlainError
        self._write_ledger(rows, spots.tolist(), variants)
        self._write_idle_blocks(rows[spots])
        columns = Columns(
            np.empty((total, 2, 2)),
            np.empty(total),
            np.empty(total, np.int32),
            np.empty(total, np.int32),
        )
        _place(
            (rows, np.cumsum(children) - children + np.arange(len(rows)), after - segments),
            (self.ends, self.bulge, self.first, self.count, self._entity_styles(rows)),
            (
                spots,
                source,
                children[spots],
                move,
                np.concatenate([np.zeros(0, np.int32), *self.variant_styles]),
            ),
            (columns.ends, columns.bulge, columns.row, columns.style),
        )
        style, styles = self._numbered(columns.style)
        return Plain(
            self.variables,
            self.sheet,
            Columns(columns.ends, columns.bulge, columns.row, style),
            styles,
            self._inscriptions(rows),
        )

    def _inscriptions(self, rows: I64) -> tuple[Inscription, ...]:
        """Return the words among entities of the sheet."""
        of_words = [number for number, word in self.words.items() if word in WORDS]
        line = self.entity[rows]
        rows = rows[np.isin(line[:, s.WORD], of_words) & (line[:, s.PAPER] == 0)]
        found = []
        for row, lengths in zip(
            rows.tolist(), self.found.value[rows][:, s.LENGTHS].tolist(), strict=True
        ):
            one = self.entity[row].tolist()
            low, size = one[s.FIRST], one[s.COUNT]
            text = self.found.data[low : low + size].decode(self.encoding, "replace")
            kind = self.words[one[s.WORD]]
            found.append(inscription(kind, self._layer(row), text, lengths, one[s.FLAGS]))
        return tuple(found)

    def _numbered(self, style: I32) -> tuple[I32, list[Style]]:
        """Return the styles in the order in which the columns first have them."""
        first, number = distinct(style)
        known = list(self.numbers)
        return number.astype(np.int32), [known[style[row]] for row in first.tolist()]

    def _style(self, row: int, around: Style | None = None) -> Style:
        """Return what an entity is drawn with."""
        line = self.entity[row].tolist()
        true, linetype = line[s.TRUE_COLOUR], line[s.LINETYPE]
        return self.layers.style(
            self._layer(row),
            line[s.COLOUR],
            true if true >= 0 else None,
            self.names[linetype] if linetype >= 0 else BYLAYER,
            around,
        )

    def _layer(self, row: int) -> str:
        number = self.entity[row, s.LAYER]
        return self.names[number] if number >= 0 else "0"

    def _entity_styles(self, rows: I64) -> I32:
        """Return the number of the style of each entity that is drawn on the sheet, (e,)."""
        drawn = rows[self.count[rows] > 0]
        line = self.entity[drawn]
        columns = [s.LAYER, s.LINETYPE, s.COLOUR, s.TRUE_COLOUR]
        first, kind = distinct(line[:, columns])
        numbers = [
            self.numbers.setdefault(self._style(row), len(self.numbers))
            for row in drawn[first].tolist()
        ]
        styles = np.full(len(self.entity), -1, np.int32)
        styles[drawn] = np.array(numbers, np.int32)[kind]
        return styles

    def _placed(self, row: int, move: F64) -> int:
        """Return the block that an INSERT places, and how, (2, 3): linear map and shift."""
        line, value = self.entity[row].tolist(), self.found.value[row]
        block = self.blocks.get(self.names[line[s.REFERENCE]].lower(), -1)
        scale = np.where(
            np.isnan(value[[s.SCALE_X, s.SCALE_Y]]), 1.0, value[[s.SCALE_X, s.SCALE_Y]]
        )
        rotation = 0.0 if np.isnan(value[s.ANGLE]) else float(value[s.ANGLE])
        if (
            block < 0
            or self.found.block[block, s.EXTERNAL]
            or line[s.MIRROR]
            or line[s.COLUMNS] > 1
            or line[s.ROWS] > 1
            or (scale == 0.0).any()
        ):
            raise _NotPlainError
        low, size = self.span.get(block, (0, 0))
        inner = self.entity[low : low + size]
        if (inner[:, s.KIND] == s.INSERT).any():
            raise _NotPlainError
        if abs(scale[0]) != abs(scale[1]):
            bulge = self.bulge[self.first[low] : self.first[low + size]]
            if (np.abs(bulge) >= BULGE).any():
                raise _NotPlainError
        _insert(value[s.X], value[s.Y], scale, rotation, self.found.base[block], move)
        return block

    def _variant(self, block: int, around: Style) -> _Variant:
        known = self.variants.get((block, around))
        if known is not None:
            return known
        low, size = self.span.get(block, (0, 0))
        layers: list[str] = []
        dropped: dict[int, str] = {}
        notes: dict[int, list[str]] = {}
        styles = np.zeros(size, np.int32)
        for number, row in enumerate(range(low, low + size)):
            if why := self._dropped(row):
                dropped[number] = why
                layers.append(self._layer(row))
                continue
            style = self._style(row, around)
            styles[number] = self.numbers.setdefault(style, len(self.numbers))
            layers.append(style.layer)
            if said := self.layers.notes(style.layer):
                notes[number] = list(said)
        variant = _Variant(
            [self.words[word] for word in self.entity[low : low + size, s.WORD].tolist()],
            layers,
            dropped,
            notes,
            sum(map(len, self.variant_styles)),
        )
        self.variant_styles.append(np.repeat(styles, self.count[low : low + size]))
        self.variants[block, around] = variant
        return variant

    def _dropped(self, row: int) -> str:
        """Return why an entity is left out, empty for what is drawn."""
        line = self.entity[row]
        if line[s.PAPER]:
            return IN_PAPER_SPACE
        kind = line[s.KIND]
        if kind == s.OTHER:
            return not_read(self.words[line[s.WORD]])
        if kind in (s.LWPOLYLINE, s.POLYLINE) and line[s.COUNT] < 2:
            return f"it has {line[s.COUNT]} vertices: no line between them"
        return ""

    def _named(self, rows: Iterable[int]) -> list[str]:
        """Return the handles of one list of entities; who has none has its number there."""
        return [self.handles[row] or f"#{number + 1}" for number, row in enumerate(rows)]

    def _write_ledger(self, rows: I64, spots: list[int], variants: list[_Variant]) -> None:
        sheet, entity = self.sheet, self.entity
        handles = self._named(rows.tolist())
        kinds = [self.words[word] for word in entity[rows, s.WORD].tolist()]
        layers = [
            self.names[number] if number >= 0 else "0" for number in entity[rows, s.LAYER].tolist()
        ]
        self._write_odd(rows, spots, variants)
        if not spots:
            sheet.handle, sheet.kind, sheet.layer = handles, kinds, layers
            return
        inner: dict[int, list[str]] = {}
        columns = ((sheet.handle, handles), (sheet.kind, kinds), (sheet.layer, layers))
        done = 0
        for spot, variant in zip(spots, variants, strict=True):
            for column, own in (
                (sheet.handle, handles),
                (sheet.kind, kinds),
                (sheet.layer, layers),
            ):
                column.extend(own[done : spot + 1])
            done = spot + 1
            block = self._block_of(int(rows[spot]))
            if block not in inner:
                low, size = self.span.get(block, (0, 0))
                inner[block] = self._named(range(low, low + size))
            base, path = len(sheet.handle), f"{handles[spot]}/"
            sheet.handle.extend([path + handle for handle in inner[block]])
            sheet.kind.extend(variant.kinds)
            sheet.layer.extend(variant.layers)
            for child, why in variant.dropped.items():
                sheet.dropped[base + child] = why
            for child, said in variant.notes.items():
                sheet.notes[base + child] = said
        for column, own in columns:
            column.extend(own[done:])

    def _write_odd(self, rows: I64, spots: list[int], variants: list[_Variant]) -> None:
        """Write what was dropped of the sheet's own entities, and what is said of the rest."""
        entity, sheet = self.entity[rows], self.sheet
        shift = np.zeros(len(rows), np.int64)
        shift[spots] = [len(variant.kinds) for variant in variants]
        at = (np.cumsum(shift) - shift + np.arange(len(rows))).tolist()
        out = (self.count[rows] == 0) & (
            (entity[:, s.KIND] != s.INSERT) | (entity[:, s.PAPER] != 0)
        )
        for number in np.flatnonzero(out).tolist():
            sheet.dropped[at[number]] = self._dropped(int(rows[number]))
        for spot in spots:
            name = self.names[self.found.block[self._block_of(int(rows[spot])), s.NAME]]
            sheet.notes[at[spot]] = [places(name)]
        for layer in np.flatnonzero(np.bincount(entity[:, s.LAYER] + 1)).tolist():
            if said := self.layers.notes(self.names[layer - 1] if layer else "0"):
                for number in np.flatnonzero(~out & (entity[:, s.LAYER] == layer - 1)).tolist():
                    sheet.notes.setdefault(at[number], []).extend(said)

    def _block_of(self, row: int) -> int:
        return self.blocks[self.names[self.entity[row, s.REFERENCE]].lower()]

    def _write_idle_blocks(self, placed: I64) -> None:
        used = {self._block_of(row) for row in placed.tolist()}
        data = self.found.data
        for number in self.blocks.values():
            if number in used or number not in self.span:
                continue
            line = self.found.block[number].tolist()
            low, size = line[s.BLOCK_HANDLE], line[s.BLOCK_HANDLE_SIZE]
            name = self.names[line[s.NAME]]
            layer = self.names[line[s.BLOCK_LAYER]] if line[s.BLOCK_LAYER] >= 0 else "0"
            handle = data[low : low + size].decode("ascii", "replace").strip().upper()
            self.sheet.row(handle or name, "BLOCK", layer, idle(name, self.span[number][1]))


@njit(cache=True, error_model="numpy")
def _upper(data: Any, start: Any, size: Any, text: Any, number: Any) -> bool:
    """Write handles in capitals, and as numbers; return whether all are hexadecimal."""
    for row in range(len(start)):
        if size[row] > text.shape[1] - 1:
            return False
        value = 0
        for place in range(size[row]):
            sign = data[start[row] + place]
            if 97 <= sign <= 102:
                sign -= 32
            if 48 <= sign <= 57:
                value = value * 16 + int(sign) - 48
            elif 65 <= sign <= 70:
                value = value * 16 + int(sign) - 55
            else:
                return False
            text[row, place] = sign
        if size[row] > 0 and value == 0:
            return False
        number[row] = value
    return True


@njit(cache=True, error_model="numpy")
def _counts(entity: Any, value: Any, vertex: Any) -> Any:
    """Return the rows that each entity takes, 0 for what is not drawn, -1 for what is damaged."""
    count = np.zeros(len(entity), np.int64)
    for row in range(len(entity)):
        kind = entity[row, s.KIND]
        if entity[row, s.PAPER] != 0:
            continue
        if kind == s.LINE:
            count[row] = 1
        elif kind == s.ARC or kind == s.CIRCLE:
            if not value[row, s.RADIUS] > 0.0:
                count[row] = -1
            elif kind == s.CIRCLE:
                count[row] = round_count(360.0)
            elif value[row, s.ANGLE] == value[row, s.ANGLE2]:
                count[row] = -1
            else:
                count[row] = round_count(swept(value[row, s.ANGLE], value[row, s.ANGLE2]))
        elif (kind == s.LWPOLYLINE or kind == s.POLYLINE) and entity[row, s.COUNT] >= 2:
            low = entity[row, s.FIRST]
            closed = entity[row, s.FLAGS] & 1 == 1
            count[row] = chain_count(vertex, low, low + entity[row, s.COUNT], closed)
    return count


@njit(cache=True, error_model="numpy")
def _draw(entity: Any, value: Any, vertex: Any, first: Any, ends: Any, bulge: Any) -> None:
    """Write the rows of every entity, in its own coordinates."""
    for row in range(len(entity)):
        at = first[row]
        if first[row + 1] == at:
            continue
        kind = entity[row, s.KIND]
        x, y = value[row, s.X], value[row, s.Y]
        if kind == s.LINE:
            ends[at, 0, 0], ends[at, 0, 1] = x, y
            ends[at, 1, 0], ends[at, 1, 1] = value[row, s.X2], value[row, s.Y2]
            bulge[at] = 0.0
            continue
        if kind == s.CIRCLE:
            round_rows(x, y, value[row, s.RADIUS], 0.0, 360.0, ends, bulge, at)
        elif kind == s.ARC:
            start = value[row, s.ANGLE]
            sweep = swept(start, value[row, s.ANGLE2])
            round_rows(x, y, value[row, s.RADIUS], start, sweep, ends, bulge, at)
        else:
            low = entity[row, s.FIRST]
            closed = entity[row, s.FLAGS] & 1 == 1
            chain_rows(vertex, low, low + entity[row, s.COUNT], closed, ends, bulge, at)
        if entity[row, s.MIRROR] != 0:
            mirror_rows(ends, bulge, at, first[row + 1])


@njit(cache=True, error_model="numpy")
def _insert(x: float, y: float, scale: Any, rotation: float, base: Any, move: Any) -> None:
    """Write linear map and shift of an INSERT, (2, 3)."""
    cos, sin = turning(rotation)
    move[0, 0], move[0, 1] = cos * scale[0], -sin * scale[1]
    move[1, 0], move[1, 1] = sin * scale[0], cos * scale[1]
    move[0, 2] = x - (move[0, 0] * base[0] + move[0, 1] * base[1])
    move[1, 2] = y - (move[1, 0] * base[0] + move[1, 1] * base[1])


@njit(cache=True, error_model="numpy")
def _place(sheet: Any, drawn: Any, inserts: Any, out: Any) -> None:
    """Write all segments of the sheet, those of its INSERTs where they stand in the file."""
    rows, ledger, first_out = sheet
    ends, bulge, first, count, style_of = drawn
    spots, source, children, move, styles = inserts
    out_ends, out_bulge, out_row, out_style = out
    for number in range(len(rows)):
        row = rows[number]
        at = first_out[number]
        for i in range(first[row], first[row] + count[row]):
            out_ends[at] = ends[i]
            out_bulge[at] = bulge[i]
            out_row[at] = ledger[number]
            out_style[at] = style_of[row]
            at += 1
    for number in range(len(spots)):
        at = first_out[spots[number]]
        low, start, style = source[number]
        m = move[number]
        turn = np.sign(m[0, 0] * m[1, 1] - m[0, 1] * m[1, 0])
        for child in range(children[number]):
            for i in range(first[low + child], first[low + child + 1]):
                for end in range(2):
                    x, y = ends[i, end, 0], ends[i, end, 1]
                    out_ends[at, end, 0] = m[0, 0] * x + m[0, 1] * y + m[0, 2]
                    out_ends[at, end, 1] = m[1, 0] * x + m[1, 1] * y + m[1, 2]
                out_bulge[at] = turn * bulge[i]
                out_row[at] = ledger[spots[number]] + 1 + child
                out_style[at] = styles[style + i - start]
                at += 1
