"""scan: the text of a plain DXF in one compiled pass, as columns of what is written there.

    bytes -> Scan: rows of entities, blocks and layers, vertices, and names by number

Plain is what every program writes that draws dielines: lines, arcs, circles, polylines and INSERTs,
each tag once and in its place, flat on the sheet.  Nothing is repaired or guessed here.  At the
first thing that is not plain the pass stops, and ``read`` leaves the file to ezdxf.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numba import njit

from knifetip.dxf.decimals import EXACT, UNSURE, number
from knifetip.geometry.columns import F64, I32, I64

# Kinds of entities whose tags are read; of all others only handle, layer and space are.
OTHER, LINE, ARC, CIRCLE, LWPOLYLINE, POLYLINE, INSERT = range(7)

# Columns of ``Scan.entity``.
(
    KIND,  # one of the above
    WORD,  # name: the kind as it is written
    BLOCK,  # row of the block that it stands in, -1 for the sheet
    HANDLE,  # byte where the handle begins
    HANDLE_SIZE,
    LAYER,  # name
    LINETYPE,  # name, -1 where it is silent
    COLOUR,  # 256 where it is silent
    TRUE_COLOUR,  # 0xRRGGBB, -1 where it is silent
    PAPER,  # stands in paper space
    FLAGS,  # group 70
    REFERENCE,  # name of the block that an INSERT places
    COLUMNS,
    ROWS,
    FIRST,  # first vertex; of words the byte where they begin
    COUNT,  # vertices; of words the bytes
    MIRROR,  # extrusion -Z
    MARKS,  # subclass markers seen
) = range(18)
_WIDTH: Final = 18

# Columns of ``Scan.block``.
NAME, BLOCK_HANDLE, BLOCK_HANDLE_SIZE, BLOCK_LAYER, EXTERNAL = range(5)

# Columns of ``Scan.layer``; -1 where the table is silent of a name or a true colour.
LAYER_NAME, LAYER_COLOUR, LAYER_TRUE, LAYER_FLAGS, LAYER_LINETYPE, LAYER_PLOT = range(6)

# Columns of ``Scan.value``: groups 10, 20, 11, 21, 40, 50, 51, 41, 42, 44, 45.
X, Y, X2, Y2, RADIUS, ANGLE, ANGLE2, SCALE_X, SCALE_Y, SPACE_X, SPACE_Y = range(11)
#: Those of ``inscriptions.LENGTHS``.
LENGTHS: Final = [X, Y, X2, Y2, RADIUS, SCALE_Y]
_VALUES: Final = 11

#: More names than this are no layers.
_MOST_NAMES: Final = 20_000
_SLOTS: Final = 1 << 16
#: Numbers of more digits than the pass can read are read afterwards, so many of them.
_MOST_LEFT: Final = 100_000
#: No entity is shorter than this (bytes), on average.
_SHORTEST: Final = 16
#: Heights up to this are on the ground (file units), as for ``entities``.
_FLAT: Final = 1e-6

_WORDS: Final = (
    b"SECTION", b"ENDSEC", b"EOF", b"HEADER", b"TABLES", b"BLOCKS", b"ENTITIES", b"BLOCK",
    b"ENDBLK", b"LAYER", b"VERTEX", b"SEQEND", b"LINE", b"ARC", b"CIRCLE", b"LWPOLYLINE",
    b"POLYLINE", b"INSERT", b"MTEXT", b"AcDbEntity", b"AcDbLine", b"AcDbCircle", b"AcDbArc",
    b"AcDbPolyline", b"AcDb2dPolyline", b"AcDbVertex", b"AcDb2dVertex",
    b"AcDbBlockReference", b"Model", b"TEXT", b"ATTRIB", b"DIMENSION",
)  # fmt: skip
(
    _SECTION, _ENDSEC, _EOF, _HEADER, _TABLES, _BLOCKS, _ENTITIES, _BLOCK, _ENDBLK, _LAYER,
    _VERTEX, _SEQEND, _LINE, _ARC, _CIRCLE, _LWPOLYLINE, _POLYLINE, _INSERT, _MTEXT, _DB_ENTITY,
    _DB_LINE, _DB_CIRCLE, _DB_ARC, _DB_LWPOLYLINE, _DB_POLYLINE, _DB_VERTEX, _DB_2D_VERTEX,
    _DB_INSERT, _MODEL, _TEXT, _ATTRIB, _DIMENSION,
) = range(len(_WORDS))  # fmt: skip

#: Which kind a word is; VERTEX and the rest are dealt with apart.
_KIND_OF: Final = np.zeros(len(_WORDS), np.int32)
_KIND_OF[[_LINE, _ARC, _CIRCLE, _LWPOLYLINE, _POLYLINE, _INSERT]] = range(1, 7)
#: The second and the third subclass marker of each kind; the first is AcDbEntity.
_SECOND: Final = np.array(
    [-1, _DB_LINE, _DB_CIRCLE, _DB_CIRCLE, _DB_LWPOLYLINE, _DB_POLYLINE, _DB_INSERT]
)
_THIRD: Final = np.array([-1, -1, _DB_ARC, -1, -1, -1, -1])

# What has been seen of an entity, as bits.
_B_HANDLE, _B_LAYER, _B_LINETYPE, _B_COLOUR, _B_TRUE, _B_FLAGS, _B_NAME = range(7)
_B_VALUE: Final = 7  # and as many more as there are values
_B_COLUMNS: Final = _B_VALUE + _VALUES
_B_ROWS: Final = _B_COLUMNS + 1
_B_PAPER: Final = _B_ROWS + 1

#: The values that each kind cannot do without.
_NEEDED: Final = np.array(
    [
        0,
        *(
            sum(1 << (_B_VALUE + value) for value in values)
            for values in ((X, Y, X2, Y2), (X, Y, RADIUS, ANGLE, ANGLE2), (X, Y, RADIUS))
        ),
        0,
        0,
        sum(1 << (_B_VALUE + value) for value in (X, Y)) | 1 << _B_NAME,
    ]
)


@dataclass(frozen=True, eq=False, slots=True)
class Scan:
    """What is written in a plain DXF, in the order of the file."""

    data: bytes
    entity: I32  #: (e, 18) columns ``KIND`` … ``MARKS``
    value: F64  #: (e, 11) columns ``X`` … ``SPACE_Y``, file units and degrees; NaN where silent
    vertex: F64  #: (v, 3) x, y, bulge
    block: I32  #: (b, 5)
    base: F64  #: (b, 2) base points
    layer: I32  #: (l, 6)
    names: tuple[bytes, ...]  #: what the numbers of names stand for
    header: tuple[int, int]  #: the bytes of section HEADER, (0, 0) without one
    markers: bool  #: entities have subclass markers


def scan(data: bytes) -> Scan | None:
    """Return what is written in a plain text DXF, None where it is not plain.

    Parameters
    ----------
    data
        The file without byte order mark and leading blanks.
    """
    text = np.frombuffer(data, np.uint8)
    most = len(data) // _SHORTEST + 64
    # Pages of these that nothing is written to cost no memory.
    entity = np.empty((most, _WIDTH), np.int32)
    value = np.empty((most, _VALUES))
    vertex = np.empty((most, 3))
    block = np.empty((most // 4, 5), np.int32)
    base = np.empty((most // 4, 2))
    layer = np.empty((_MOST_NAMES, 6), np.int32)
    spans = np.empty((_MOST_NAMES, 2), np.int64)
    left = np.empty((_MOST_LEFT, 5), np.int64)
    counts = np.zeros(8, np.int64)
    plain = _pass(
        text,
        _WORD_BYTES,
        _WORD_ENDS,
        entity,
        value,
        vertex,
        block,
        base,
        layer,
        spans,
        left,
        counts,
    )
    if not plain:
        return None
    entities, vertices, blocks, layers, names, unsure, first, last = counts.tolist()
    tables = (value, vertex, base)
    for which, row, column, start, end in left[:unsure].tolist():
        read = float(data[start:end])
        if not np.isfinite(read):
            return None
        tables[which][row, column] = read
    return Scan(
        data,
        entity[:entities],
        value[:entities],
        vertex[:vertices],
        block[:blocks],
        base[:blocks],
        layer[:layers],
        tuple(data[start:end] for start, end in spans[:names].tolist()),
        (first, last),
        bool((entity[:entities, MARKS] > 0).any()),
    )


def _words() -> tuple[Any, I64]:
    return np.frombuffer(b"".join(_WORDS), np.uint8), np.cumsum([0, *map(len, _WORDS)])


_WORD_BYTES, _WORD_ENDS = _words()


@njit(cache=True, error_model="numpy", inline="always")
def _is(data: Any, low: int, high: int, words: Any, ends: Any, word: int) -> bool:
    first = ends[word]
    if high - low != ends[word + 1] - first:
        return False
    for i in range(high - low):  # noqa: SIM110 -- compiled code has no generators
        if data[low + i] != words[first + i]:
            return False
    return True


@njit(cache=True, error_model="numpy")
def _word(data: Any, low: int, high: int, words: Any, ends: Any, first: int, last: int) -> Any:
    """Return which of the words from ``first`` to ``last`` stands there, -1 for none."""
    for word in range(first, last + 1):
        if _is(data, low, high, words, ends, word):
            return word
    return -1


@njit(cache=True, error_model="numpy")
def _named(data: Any, low: int, high: int, spans: Any, slots: Any, counts: Any) -> Any:
    """Return the number of a name, -1 where it is not plain or there are too many."""
    if high > low and (data[low] <= 32 or data[high - 1] <= 32):
        return -1
    key = np.uint64(14695981039346656037)
    for at in range(low, high):
        key = (key ^ np.uint64(data[at])) * np.uint64(1099511628211)
    slot = np.int64(key & np.uint64(_SLOTS - 1))
    while slots[slot] >= 0:
        found = slots[slot]
        first = spans[found, 0]
        if spans[found, 1] - first == high - low:
            same = True
            for i in range(high - low):
                if data[first + i] != data[low + i]:
                    same = False
                    break
            if same:
                return found
        slot = (slot + 1) & (_SLOTS - 1)
    made = counts[4]
    if made == _MOST_NAMES:
        return -1
    spans[made, 0], spans[made, 1] = low, high
    slots[slot] = made
    counts[4] = made + 1
    return made


@njit(cache=True, error_model="numpy")
def _whole(data: Any, low: int, high: int) -> int:
    """Return a whole number of up to nine digits, -999,999,999 where there is none."""
    while low < high and data[low] == 32:
        low += 1
    while low < high and data[high - 1] == 32:
        high -= 1
    negative = low < high and data[low] == 45
    if negative:
        low += 1
    if low == high or high - low > 9:
        return _NONE
    result = 0
    for at in range(low, high):
        if not 48 <= data[at] <= 57:
            return _NONE
        result = result * 10 + int(data[at]) - 48
    return -result if negative else result


_NONE: Final = -999_999_999

# Groups by their meaning, for codes up to 255: the column of the value, or -1.
_COLUMN_OF: Final = np.full(256, -1)
for _code, _column in (
    (10, X), (20, Y), (11, X2), (21, Y2), (40, RADIUS), (50, ANGLE), (51, ANGLE2), (41, SCALE_X),
    (42, SCALE_Y), (44, SPACE_X), (45, SPACE_Y),
):  # fmt: skip
    _COLUMN_OF[_code] = _column
#: Which values each kind has; other numbers are skipped.
_HAS: Final = np.zeros((7, _VALUES), np.bool_)
for _kind, _columns in (
    (LINE, (X, Y, X2, Y2)),
    (ARC, (X, Y, RADIUS, ANGLE, ANGLE2)),
    (CIRCLE, (X, Y, RADIUS)),
    (INSERT, (X, Y, SCALE_X, SCALE_Y, ANGLE, SPACE_X, SPACE_Y)),
):
    _HAS[_kind, list(_columns)] = True


#: The columns that words have.
_IS_LENGTH: Final = np.zeros(_VALUES, np.bool_)
_IS_LENGTH[LENGTHS] = True


@njit(cache=True, error_model="numpy")
def _pass(
    data: Any,
    words: Any,
    ends: Any,
    entity: Any,
    value: Any,
    vertex: Any,
    block: Any,
    base: Any,
    layer: Any,
    spans: Any,
    left: Any,
    counts: Any,
) -> bool:
    """Fill the tables; return whether the file is plain to its end mark."""
    size = len(data)
    slots = np.full(_SLOTS, -1, np.int32)
    section = -1
    in_group = is_mtext = has_words = False
    row = -1  # of the entity that is open
    inside = -1  # the block that is open
    in_layer = False
    in_block_head = False
    in_vertex = False
    polyline = -1
    kind = OTHER
    seen = 0
    marks = 0
    before = -1
    at = 0
    entities = vertices = blocks = layers = unsure = 0
    done = False
    while at < size and not done:
        # The group code, alone on its line.
        while at < size and data[at] == 32:
            at += 1
        code = 0
        first = at
        while at < size and 48 <= data[at] <= 57:
            code = code * 10 + int(data[at]) - 48
            at += 1
        if at == first or at - first > 4:
            return False
        while at < size and data[at] == 32:
            at += 1
        if at < size and data[at] == 13:
            at += 1
        if at >= size or data[at] != 10:
            return False
        at += 1
        low = at
        # A point has its y right behind its x.
        if (before == 10 and code != 20) or (before == 11 and code != 21):
            if row >= 0 and kind != OTHER:
                return False
        elif (
            row >= 0
            and kind != OTHER
            and ((code == 20 and before != 10) or (code == 21 and before != 11))
        ):
            return False
        before = code

        wanted = -1
        if row >= 0 and not in_group and code < 256:
            if in_vertex:
                if code == 10 or code == 20 or code == 42 or code == 30:
                    wanted = code
            elif kind == LWPOLYLINE:
                if code == 10 or code == 20 or code == 42 or code == 38:
                    wanted = code
            elif kind == POLYLINE:
                if code == 30:
                    wanted = code
            elif has_words:
                column = _COLUMN_OF[code]
                if column >= 0 and _IS_LENGTH[column] and not seen & (1 << (_B_VALUE + column)):
                    wanted = code
            elif kind != OTHER:
                column = _COLUMN_OF[code]
                if (column >= 0 and _HAS[kind, column]) or code == 30 or code == 31:
                    wanted = code
            if kind != OTHER and 210 <= code <= 230:
                wanted = code
        elif in_block_head and (code == 10 or code == 20):
            wanted = code

        if wanted >= 0:
            read, at, sure = number(data, at, size)
            if sure > UNSURE:
                return False
            high = at
            table, line, column = -1, 0, 0
            if in_block_head:
                table, line, column = 2, inside, 0 if code == 10 else 1
                base[inside, column] = read
            elif code == 30 or code == 31 or code == 38:
                if not abs(read) <= _FLAT or sure != EXACT:
                    return False
            elif 210 <= code <= 230:
                if sure != EXACT:
                    return False
                if code == 230:
                    if abs(read) != 1.0:
                        return False
                    if not in_vertex:
                        entity[row, MIRROR] = 1 if read < 0.0 else 0
                elif read != 0.0:
                    return False
            elif in_vertex or kind == LWPOLYLINE:
                if code == 10 and not in_vertex:
                    if vertices == len(vertex):
                        return False
                    vertex[vertices, 2] = 0.0
                    vertices += 1
                    entity[row, COUNT] += 1
                elif entity[row if not in_vertex else polyline, COUNT] == 0:
                    return False
                elif in_vertex:
                    bit = 1 << (_B_VALUE + (0 if code == 10 else 1 if code == 20 else 2))
                    if seen & bit:
                        return False
                    seen |= bit
                column = 0 if code == 10 else 1 if code == 20 else 2
                table, line = 1, vertices - 1
                vertex[line, column] = read
            else:
                column = _COLUMN_OF[code]
                bit = 1 << (_B_VALUE + column)
                if seen & bit:
                    return False
                seen |= bit
                table, line = 0, row
                value[row, column] = read
            if kind != OTHER and marks > 0 and not in_block_head and code < 210:
                # Groups stand behind the markers of the subclass that they belong to.
                behind = 3 if in_vertex or (kind == ARC and code >= 50) else 2
                if marks != behind:
                    return False
            if sure == UNSURE and table >= 0:
                if unsure == len(left):
                    return False
                left[unsure, 0], left[unsure, 1], left[unsure, 2] = table, line, column
                left[unsure, 3], left[unsure, 4] = low, high
                unsure += 1
            if at < size and data[at] == 13:
                at += 1
            if at >= size or data[at] != 10:
                return False
            at += 1
            continue

        while at < size and data[at] != 10 and data[at] != 13:
            at += 1
        high = at
        if at < size and data[at] == 13:
            at += 1
        if at >= size:
            # The last line may end with the file.
            done = True
        elif data[at] != 10:
            return False
        at += 1

        if code == 0:
            in_group = False
            # What came before is complete, or it is not plain.
            if (
                row >= 0
                and not in_vertex
                and (
                    (seen & _NEEDED[kind]) != _NEEDED[kind]
                    or (marks > 0 and kind != OTHER and marks != (3 if kind == ARC else 2))
                )
            ):
                return False
            if in_vertex and (seen & (3 << _B_VALUE)) != (3 << _B_VALUE):
                return False
            if row >= 0 and not in_vertex:
                entity[row, MARKS] = marks
            in_layer = in_block_head = in_vertex = False
            row = -1
            kind = OTHER
            is_mtext = has_words = False
            seen = marks = 0
            word = _word(data, low, high, words, ends, _SECTION, _EOF)
            if word == _SECTION:
                if section >= 0 or inside >= 0:
                    return False
                section = _SECTION
                polyline = -1
                continue
            if word == _ENDSEC:
                if section < 0 or inside >= 0:
                    return False
                if section == _HEADER:
                    counts[7] = low
                section = -1
                polyline = -1
                continue
            if word == _EOF:
                counts[0], counts[1], counts[2] = entities, vertices, blocks
                counts[3], counts[5] = layers, unsure
                return section < 0
            if section < 0:
                return False
            if section == _TABLES:
                if _is(data, low, high, words, ends, _LAYER):
                    if layers == len(layer):
                        return False
                    layer[layers, :] = -1
                    layer[layers, LAYER_COLOUR] = 7
                    layer[layers, LAYER_FLAGS] = 0
                    layer[layers, LAYER_PLOT] = 1
                    layers += 1
                    in_layer = True
                continue
            if section != _BLOCKS and section != _ENTITIES:
                continue
            if section == _BLOCKS:
                if _is(data, low, high, words, ends, _BLOCK):
                    if inside >= 0 or blocks == len(block):
                        return False
                    inside = blocks
                    block[blocks, NAME] = -1
                    block[blocks, BLOCK_HANDLE] = block[blocks, BLOCK_HANDLE_SIZE] = 0
                    block[blocks, BLOCK_LAYER] = -1
                    block[blocks, EXTERNAL] = 0
                    base[blocks, 0] = base[blocks, 1] = 0.0
                    blocks += 1
                    in_block_head = True
                    polyline = -1
                    continue
                if _is(data, low, high, words, ends, _ENDBLK):
                    if inside < 0:
                        return False
                    inside = -1
                    polyline = -1
                    continue
                if inside < 0:
                    return False
            word = _word(data, low, high, words, ends, _VERTEX, _INSERT)
            if word == _VERTEX:
                if polyline < 0 or vertices == len(vertex):
                    return False
                vertex[vertices, 2] = 0.0
                vertices += 1
                entity[polyline, COUNT] += 1
                row = polyline
                kind = POLYLINE
                in_vertex = True
                continue
            polyline = -1
            if word == _SEQEND:
                continue
            if entities == len(entity):
                return False
            row = entities
            entities += 1
            kind = _KIND_OF[word] if word >= 0 else OTHER
            is_mtext = _is(data, low, high, words, ends, _MTEXT)
            has_words = is_mtext or _word(data, low, high, words, ends, _TEXT, _DIMENSION) >= 0
            entity[row, KIND] = kind
            name = _named(data, low, high, spans, slots, counts)
            if name < 0:
                return False
            entity[row, WORD] = name
            entity[row, BLOCK] = inside
            entity[row, HANDLE] = entity[row, HANDLE_SIZE] = 0
            entity[row, LAYER] = -1
            entity[row, LINETYPE] = -1
            entity[row, COLOUR] = 256
            entity[row, TRUE_COLOUR] = -1
            entity[row, PAPER] = entity[row, FLAGS] = 0
            entity[row, REFERENCE] = -1
            entity[row, COLUMNS] = entity[row, ROWS] = 1
            entity[row, FIRST] = vertices
            entity[row, COUNT] = entity[row, MIRROR] = entity[row, MARKS] = 0
            value[row, :] = np.nan
            if kind == POLYLINE:
                polyline = row
            continue

        if section == _SECTION:
            if code != 2:
                return False
            section = _word(data, low, high, words, ends, _HEADER, _ENTITIES)
            if section < 0:
                section = _MODEL  # one that is skipped
            elif section == _HEADER:
                if counts[6] > 0:
                    return False
                counts[6] = at
            continue
        if code == 102:
            in_group = high > low and data[low] == 123
            if in_group and kind == INSERT:
                return False
            continue
        if code >= 1000 and is_mtext:
            # ezdxf makes one of a text in columns and its frame.
            return False
        if in_group or code >= 999:
            continue

        if in_layer:
            if code == 2:
                if layer[layers - 1, LAYER_NAME] >= 0:
                    return False
                name = _named(data, low, high, spans, slots, counts)
                if name < 0:
                    return False
                layer[layers - 1, LAYER_NAME] = name
            elif code == 6:
                name = _named(data, low, high, spans, slots, counts)
                if name < 0:
                    return False
                layer[layers - 1, LAYER_LINETYPE] = name
            elif code == 62 or code == 70 or code == 290 or code == 420:
                whole = _whole(data, low, high)
                if whole == _NONE:
                    return False
                column = LAYER_FLAGS
                if code == 62:
                    column = LAYER_COLOUR
                    if whole == 0 or abs(whole) > 255:
                        # Nothing that the table may say: 7, which is what silence means too.
                        whole = 7 if whole >= 0 else -7
                elif code == 290:
                    column = LAYER_PLOT
                elif code == 420:
                    column = LAYER_TRUE
                    whole &= 0xFFFFFF
                layer[layers - 1, column] = whole
            continue
        if in_block_head:
            if code == 5 and block[inside, BLOCK_HANDLE_SIZE] == 0:
                block[inside, BLOCK_HANDLE], block[inside, BLOCK_HANDLE_SIZE] = low, high - low
            elif code == 8 or code == 2:
                name = _named(data, low, high, spans, slots, counts)
                if name < 0:
                    return False
                if code == 8:
                    block[inside, BLOCK_LAYER] = name
                elif block[inside, NAME] < 0:
                    block[inside, NAME] = name
            elif (code == 1 and high > low) or (code == 70 and _whole(data, low, high) & 60):
                block[inside, EXTERNAL] = 1
            continue
        if row < 0:
            continue

        if code == 100:
            marks += 1
            if kind != OTHER:
                expected = -1
                if marks == 1:
                    expected = _DB_ENTITY
                elif in_vertex:
                    expected = _DB_VERTEX if marks == 2 else _DB_2D_VERTEX if marks == 3 else -1
                elif marks == 2:
                    expected = _SECOND[kind]
                elif marks == 3:
                    expected = _THIRD[kind]
                if expected < 0 or not _is(data, low, high, words, ends, expected):
                    return False
            continue
        if in_vertex:
            if code == 70 and _whole(data, low, high) & 16:
                return False
            continue
        if code == 5:
            if not seen & (1 << _B_HANDLE):
                entity[row, HANDLE], entity[row, HANDLE_SIZE] = low, high - low
            elif kind != OTHER:
                return False
            seen |= 1 << _B_HANDLE
        elif code == 8:
            if kind != OTHER and (seen & (1 << _B_LAYER) or marks > 1):
                return False
            name = _named(data, low, high, spans, slots, counts)
            if name < 0:
                return False
            entity[row, LAYER] = name
            seen |= 1 << _B_LAYER
        elif code == 67:
            entity[row, PAPER] = _whole(data, low, high)
            if entity[row, PAPER] != 0 and entity[row, PAPER] != 1:
                return False
            if kind != OTHER and (seen & (1 << _B_PAPER) or marks > 1):
                return False
            seen |= 1 << _B_PAPER
        elif has_words:
            if code == 101:
                has_words = False
            elif code == 3 and is_mtext:
                return False
            elif code == 1 and not seen & (1 << _B_NAME):
                entity[row, FIRST], entity[row, COUNT] = low, high - low
                seen |= 1 << _B_NAME
            elif code == 70 and not seen & (1 << _B_FLAGS):
                entity[row, FLAGS] = _whole(data, low, high)
                if entity[row, FLAGS] == _NONE:
                    return False
                seen |= 1 << _B_FLAGS
        elif kind == OTHER:
            continue
        elif code == 6:
            if seen & (1 << _B_LINETYPE) or marks > 1:
                return False
            name = _named(data, low, high, spans, slots, counts)
            if name < 0:
                return False
            entity[row, LINETYPE] = name
            seen |= 1 << _B_LINETYPE
        elif code == 62 or code == 420:
            bit = 1 << (_B_COLOUR if code == 62 else _B_TRUE)
            whole = _whole(data, low, high)
            if seen & bit or marks > 1 or whole < 0 or (code == 62 and whole > 256):
                return False
            seen |= bit
            if code == 62:
                entity[row, COLOUR] = whole
            else:
                entity[row, TRUE_COLOUR] = whole & 0xFFFFFF
        elif code == 60:
            if _whole(data, low, high) != 0:
                return False
        elif code == 70 or code == 71:
            whole = _whole(data, low, high)
            if whole == _NONE:
                return False
            if kind == INSERT:
                bit = 1 << (_B_COLUMNS if code == 70 else _B_ROWS)
                if seen & bit:
                    return False
                seen |= bit
                entity[row, COLUMNS if code == 70 else ROWS] = whole
            elif code == 70:
                if seen & (1 << _B_FLAGS) or (kind == POLYLINE and whole & 88):
                    return False
                seen |= 1 << _B_FLAGS
                entity[row, FLAGS] = whole
        elif code == 2 and kind == INSERT:
            if seen & (1 << _B_NAME):
                return False
            name = _named(data, low, high, spans, slots, counts)
            if name < 0:
                return False
            entity[row, REFERENCE] = name
            seen |= 1 << _B_NAME
        elif code == 410:
            if not _is(data, low, high, words, ends, _MODEL):
                return False
        elif code == 101:
            return False
    return False
