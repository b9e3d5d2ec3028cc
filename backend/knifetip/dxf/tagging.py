"""tagging: the compiled pass of ``scan``, tag by tag from the first byte to the end mark.

    bytes -> tables of entities, values, vertices, blocks and layers, as rows of numbers

A tag is a line with a group code and a line with its value.  What the pass has seen so far is its
``State``; each kind of tag is dealt with by a function of its own.  Where a file is not plain, the
pass refuses it as a whole.  Where only one entity is not plain, it marks that entity as ``ODD`` and
goes on.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from ezdxf.lldxf.types import BINARY_DATA, POINT_CODES, TYPE_TABLE
from numba import njit

from knifetip.dxf.decimals import EXACT, UNSURE, WRONG, number
from knifetip.geometry.columns import I64

# Kinds of entities whose tags are read; of all others only handle, layer and space are.
OTHER, LINE, ARC, CIRCLE, LWPOLYLINE, POLYLINE, INSERT = range(7)

# Columns of an entity.
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
    START,  # byte of its first group code
    END,  # byte behind its last line, those of its vertices included
    ODD,  # it is not plain: only word, handle, layer and space are to be trusted
) = range(21)
WIDTH: Final = 21

# Columns of a block.
NAME, BLOCK_HANDLE, BLOCK_HANDLE_SIZE, BLOCK_LAYER, EXTERNAL = range(5)

# Columns of a layer; -1 where the table is silent of a name or a true colour.
LAYER_NAME, LAYER_COLOUR, LAYER_TRUE, LAYER_FLAGS, LAYER_LINETYPE, LAYER_PLOT = range(6)

# Columns of the values: groups 10, 20, 11, 21, 40, 50, 51, 41, 42, 44, 45.
X, Y, X2, Y2, RADIUS, ANGLE, ANGLE2, SCALE_X, SCALE_Y, SPACE_X, SPACE_Y = range(11)
VALUES: Final = 11
#: Those of ``inscriptions.LENGTHS``.
LENGTHS: Final = [X, Y, X2, Y2, RADIUS, SCALE_Y]

#: More names than this are no layers; so many of them have place in the hash table.
MOST_NAMES: Final = 20_000
_SLOTS: Final = 1 << 16
#: Names that share a slot beyond this are meant to.
_MOST_STEPS: Final = 64
#: Heights up to this are on the ground (file units), as for ``entities``.
_FLAT: Final = 1e-6

_WORDS: Final = (
    b"SECTION", b"ENDSEC", b"EOF", b"HEADER", b"TABLES", b"BLOCKS", b"ENTITIES", b"BLOCK",
    b"ENDBLK", b"LAYER", b"VERTEX", b"SEQEND", b"LINE", b"ARC", b"CIRCLE", b"LWPOLYLINE",
    b"POLYLINE", b"INSERT", b"ELLIPSE", b"SPLINE", b"ATTRIB", b"TEXT", b"DIMENSION", b"MTEXT",
    b"AcDbEntity", b"AcDbLine", b"AcDbCircle", b"AcDbArc", b"AcDbPolyline", b"AcDb2dPolyline",
    b"AcDbVertex", b"AcDb2dVertex", b"AcDbBlockReference", b"Model", b"ACAD_MTEXT",
    b"{ACAD_XDICTIONARY", b"}", b"ENDTAB",
)  # fmt: skip
(
    _SECTION, _ENDSEC, _EOF, _HEADER, _TABLES, _BLOCKS, _ENTITIES, _BLOCK, _ENDBLK, _LAYER,
    _VERTEX, _SEQEND, _LINE, _ARC, _CIRCLE, _LWPOLYLINE, _POLYLINE, _INSERT, _ELLIPSE, _SPLINE,
    _ATTRIB, _TEXT, _DIMENSION, _MTEXT, _DB_ENTITY, _DB_LINE, _DB_CIRCLE, _DB_ARC, _DB_LWPOLYLINE,
    _DB_POLYLINE, _DB_VERTEX, _DB_2D_VERTEX, _DB_INSERT, _MODEL, _OF_COLUMNS, _XDICTIONARY,
    _GROUP_END, _ENDTAB,
) = range(len(_WORDS))  # fmt: skip
_WORD_BYTES: Final = np.frombuffer(b"".join(_WORDS), np.uint8)
_WORD_ENDS: Final[I64] = np.cumsum([0, *map(len, _WORDS)])

#: Which kind a word is; VERTEX and the rest are dealt with apart.
_KIND_OF: Final = np.zeros(len(_WORDS), np.int64)
_KIND_OF[[_LINE, _ARC, _CIRCLE, _LWPOLYLINE, _POLYLINE, _INSERT]] = range(1, 7)
#: The second and the third subclass marker of each kind; the first is AcDbEntity.
_SECOND: Final = np.array(
    [-1, _DB_LINE, _DB_CIRCLE, _DB_CIRCLE, _DB_LWPOLYLINE, _DB_POLYLINE, _DB_INSERT]
)
_THIRD: Final = np.array([-1, -1, _DB_ARC, -1, -1, -1, -1])

#: What the value behind a group code is.
_TEXT_VALUE, _DECIMAL, _INTEGER, _HEX = range(4)
_LAST_CODE: Final = 1071
_TYPE: Final = np.array(
    [
        _HEX if code in BINARY_DATA else {float: 1, int: 2}.get(TYPE_TABLE.get(code, str), 0)
        for code in range(_LAST_CODE + 1)
    ]
)
#: Codes of an x, right behind which its y stands.
_IS_POINT: Final = np.isin(np.arange(_LAST_CODE + 1), list(POINT_CODES))

#: Codes of an entity that mean something; the others are skipped.
_MEANS: Final = np.zeros(_LAST_CODE + 1, np.bool_)
_MEANS[[1, 2, 3, 5, 6, 8, 60, 62, 66, 67, 70, 71, 100, 101, 410, 420]] = True
#: Groups by their meaning, for codes up to 255: the column of the value, or -1.
_COLUMN_OF: Final = np.full(256, -1)
for _code, _column in (
    (10, X), (20, Y), (11, X2), (21, Y2), (40, RADIUS), (50, ANGLE), (51, ANGLE2), (41, SCALE_X),
    (42, SCALE_Y), (44, SPACE_X), (45, SPACE_Y),
):  # fmt: skip
    _COLUMN_OF[_code] = _column
#: Which values each kind has, words last; other numbers are skipped.
_OF_WORDS: Final = 7
_HAS: Final = np.zeros((8, VALUES), np.bool_)
for _kind, _columns in (
    (LINE, (X, Y, X2, Y2)),
    (ARC, (X, Y, RADIUS, ANGLE, ANGLE2)),
    (CIRCLE, (X, Y, RADIUS)),
    (INSERT, (X, Y, SCALE_X, SCALE_Y, ANGLE, SPACE_X, SPACE_Y)),
    (_OF_WORDS, LENGTHS),
):
    _HAS[_kind, list(_columns)] = True

# What has been seen of an entity, as bits.
_B_HANDLE, _B_LAYER, _B_LINETYPE, _B_COLOUR, _B_TRUE, _B_FLAGS, _B_NAME = range(7)
_B_VALUE: Final = 7  # and as many more as there are values
_B_COLUMNS: Final = _B_VALUE + VALUES
_B_ROWS: Final = _B_COLUMNS + 1
_B_PAPER: Final = _B_ROWS + 1
_POINT: Final = 3 << _B_VALUE

#: What each kind cannot do without.
_NEEDED: Final = np.array(
    [
        0,
        *(
            sum(1 << (_B_VALUE + value) for value in values)
            for values in ((X, Y, X2, Y2), (X, Y, RADIUS, ANGLE, ANGLE2), (X, Y, RADIUS))
        ),
        0,
        0,
        _POINT | 1 << _B_NAME,
        0,
    ]
)

# State: what is open, and how much there is of everything.
(
    SECTION,  # word, -1 outside of any
    INSIDE,  # row of the block that is open, or -1
    MODE,  # what the tags belong to
    ROW,  # of the entity that is open, -1 for none
    OPEN_KIND,  # its kind while it is plain, ``_OF_WORDS`` for words
    SEEN,
    OPEN_MARKS,
    CHAIN,  # row of the POLYLINE whose vertices follow, or -1
    FOLLOWED,  # ATTRIBs and a SEQEND follow
    GROUP,  # 1 within {…}, 2 in what other programs have added
    BEFORE,  # the group code before
    IS_MTEXT,
    NAMED,  # an entry of another table than that of layers
    ENTITIES,
    VERTICES,
    BLOCKS,
    LAYERS,
    NAMES,
    UNSURES,
    HEADER_FIRST,
    HEADER_LAST,
) = range(21)
STATES: Final = 21
# Modes.
_NOTHING, _IN_SECTION, _IN_LAYER, _IN_TABLE, _IN_BLOCK, _IN_ENTITY, _IN_VERTEX = range(7)
# What becomes of the pass.
_ON, _DONE, _REFUSED = range(3)

_NONE: Final = -(1 << 62)


@njit(cache=True, error_model="numpy", inline="always")
def _is(data: Any, low: int, high: int, word: int) -> bool:
    first = _WORD_ENDS[word]
    if high - low != _WORD_ENDS[word + 1] - first:
        return False
    for i in range(high - low):  # noqa: SIM110 -- compiled code has no generators
        if data[low + i] != _WORD_BYTES[first + i]:
            return False
    return True


@njit(cache=True, error_model="numpy")
def _word(data: Any, low: int, high: int, first: int, last: int) -> Any:
    """Return which of the words from ``first`` to ``last`` stands there, -1 for none."""
    for word in range(first, last + 1):
        if _is(data, low, high, word):
            return word
    return -1


@njit(cache=True, error_model="numpy")
def _named(data: Any, low: int, high: int, spans: Any, slots: Any, state: Any) -> Any:
    """Return the number of a name, -1 where it is not plain or there are too many."""
    if high > low and (data[low] <= 32 or data[high - 1] <= 32):
        return -1
    key = np.uint64(14695981039346656037)
    for at in range(low, high):
        key = (key ^ np.uint64(data[at])) * np.uint64(1099511628211)
    slot = np.int64(key & np.uint64(_SLOTS - 1))
    for _ in range(_MOST_STEPS):
        found = slots[slot]
        if found < 0:
            made = state[NAMES]
            if made == MOST_NAMES:
                return -1
            spans[made, 0], spans[made, 1] = low, high
            slots[slot] = made
            state[NAMES] = made + 1
            return made
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
    return -1


@njit(cache=True, error_model="numpy")
def _whole(data: Any, low: int, high: int) -> int:
    """Return a whole number of up to 18 digits, ``_NONE`` where there is none."""
    while low < high and data[low] == 32:
        low += 1
    while low < high and data[high - 1] == 32:
        high -= 1
    negative = low < high and data[low] == 45
    if negative:
        low += 1
    if low == high or high - low > 18:
        return _NONE
    result = 0
    for at in range(low, high):
        if not 48 <= data[at] <= 57:
            return _NONE
        result = result * 10 + int(data[at]) - 48
    return -result if negative else result


@njit(cache=True, error_model="numpy", inline="always")
def _valid(data: Any, low: int, high: int, what: int) -> bool:
    """Return whether a value that is not needed can be read."""
    if what == _DECIMAL:
        _, _, sure = number(data, low, high)
        return bool(sure != WRONG)
    if what == _INTEGER:
        return _whole(data, low, high) != _NONE
    if what == _HEX:
        for at in range(low, high):
            sign = data[at] | 32
            if not (48 <= data[at] <= 57 or 97 <= sign <= 102):
                return False
        return (high - low) % 2 == 0
    return True


@njit(cache=True, error_model="numpy", inline="always")
def _odd(entity: Any, state: Any) -> None:
    """Mark the open entity as one that is not plain."""
    entity[state[ROW], ODD] = 1
    state[OPEN_KIND] = OTHER


@njit(cache=True, error_model="numpy")
def _close(start: int, entity: Any, state: Any) -> None:
    """End the open entity: it is complete, or it is odd."""
    row, kind, seen, marks = state[ROW], state[OPEN_KIND], state[SEEN], state[OPEN_MARKS]
    if row < 0:
        return
    entity[row, END] = start
    if state[MODE] == _IN_VERTEX:
        if kind != OTHER and ((seen & _POINT) != _POINT or (marks > 0 and marks != 3)):
            _odd(entity, state)
        return
    entity[row, MARKS] = marks
    if kind in (OTHER, _OF_WORDS):
        return
    if (seen & _NEEDED[kind]) != _NEEDED[kind] or (
        marks > 0 and marks != (3 if kind == ARC else 2)
    ):
        _odd(entity, state)


@njit(cache=True, error_model="numpy")
def _structure(
    data: Any,
    start: int,
    low: int,
    high: int,
    entity: Any,
    value: Any,
    vertex: Any,
    block: Any,
    base: Any,
    layer: Any,
    spans: Any,
    slots: Any,
    state: Any,
) -> int:
    """Begin what group 0 begins."""
    if state[GROUP] == 1:
        return _REFUSED
    _close(start, entity, state)
    state[GROUP] = state[SEEN] = state[OPEN_MARKS] = state[IS_MTEXT] = 0
    mode, named = state[MODE], state[NAMED] != 0
    state[MODE] = _NOTHING
    state[NAMED] = 0
    state[ROW] = -1
    state[OPEN_KIND] = OTHER
    if mode == _IN_SECTION or (mode == _IN_TABLE and not named):
        return _REFUSED
    section = state[SECTION]
    word = -1
    if section in (_ENTITIES, _BLOCKS):
        word = _word(data, low, high, _VERTEX, _MTEXT)
    if state[CHAIN] >= 0 and word != _VERTEX and word != _SEQEND:
        return _REFUSED
    if state[FOLLOWED] != 0 and word != _ATTRIB and word != _SEQEND:
        return _REFUSED
    if word < 0:
        frame = _word(data, low, high, _SECTION, _EOF)
        if frame >= 0:
            return _frame(low, frame, state)
        if section < 0 or section == _HEADER:
            return _REFUSED
        if section == _TABLES:
            if _is(data, low, high, _LAYER):
                row = state[LAYERS]
                if row == len(layer):
                    return _REFUSED
                layer[row, :] = -1
                layer[row, LAYER_COLOUR] = 7
                layer[row, LAYER_FLAGS] = 0
                layer[row, LAYER_PLOT] = 1
                state[LAYERS] = row + 1
                state[MODE] = _IN_LAYER
            elif not _is(data, low, high, _ENDTAB):
                state[MODE] = _IN_TABLE
            return _ON
        if section == _BLOCKS:
            if _is(data, low, high, _BLOCK):
                row = state[BLOCKS]
                if state[INSIDE] >= 0 or row == len(block):
                    return _REFUSED
                block[row, :] = 0
                block[row, NAME] = block[row, BLOCK_LAYER] = -1
                base[row, 0] = base[row, 1] = 0.0
                state[INSIDE] = row
                state[BLOCKS] = row + 1
                state[MODE] = _IN_BLOCK
                return _ON
            if _is(data, low, high, _ENDBLK):
                if state[INSIDE] < 0:
                    return _REFUSED
                state[INSIDE] = -1
                return _ON
    if section != _ENTITIES and section != _BLOCKS:
        return _ON
    if section == _BLOCKS and state[INSIDE] < 0:
        return _REFUSED
    if word == _VERTEX:
        chain, row = state[CHAIN], state[VERTICES]
        if chain < 0 or row == len(vertex):
            return _REFUSED
        vertex[row, 2] = 0.0
        state[VERTICES] = row + 1
        entity[chain, COUNT] += 1
        state[ROW] = chain
        state[MODE] = _IN_VERTEX
        state[OPEN_KIND] = OTHER if entity[chain, ODD] else POLYLINE
        return _ON
    if word == _SEQEND:
        if state[CHAIN] < 0 and state[FOLLOWED] == 0:
            return _REFUSED
        state[CHAIN] = -1
        state[FOLLOWED] = 0
        return _ON
    row = state[ENTITIES]
    name = _named(data, low, high, spans, slots, state)
    if row == len(entity) or name < 0:
        return _REFUSED
    state[ENTITIES] = row + 1
    state[ROW] = row
    state[MODE] = _IN_ENTITY
    kind = _KIND_OF[word] if word >= 0 else OTHER
    state[OPEN_KIND] = _OF_WORDS if word >= _ATTRIB else kind
    state[IS_MTEXT] = 1 if word == _MTEXT else 0
    entity[row, :] = 0
    entity[row, KIND] = kind
    entity[row, WORD] = name
    entity[row, BLOCK] = state[INSIDE]
    entity[row, LAYER] = entity[row, LINETYPE] = entity[row, REFERENCE] = -1
    entity[row, TRUE_COLOUR] = -1
    entity[row, COLOUR] = 256
    entity[row, COLUMNS] = entity[row, ROWS] = 1
    entity[row, START] = start
    # Curves are left to ezdxf, one by one.
    entity[row, ODD] = 1 if word in (_ELLIPSE, _SPLINE) else 0
    value[row, :] = np.nan
    if kind in (LWPOLYLINE, POLYLINE):
        entity[row, FIRST] = state[VERTICES]
    if kind == POLYLINE:
        state[CHAIN] = row
    return _ON


@njit(cache=True, error_model="numpy")
def _frame(low: int, word: int, state: Any) -> int:
    """Open or close a section."""
    if state[INSIDE] >= 0:
        return _REFUSED
    if word == _EOF:
        # A file without entities has nothing that must be read quickly.
        return _DONE if state[SECTION] < 0 and state[ENTITIES] > 0 else _REFUSED
    if word == _SECTION and state[SECTION] < 0:
        state[SECTION] = _SECTION
        state[MODE] = _IN_SECTION
        return _ON
    if word == _ENDSEC and state[SECTION] >= 0:
        if state[SECTION] == _HEADER:
            state[HEADER_LAST] = low
        state[SECTION] = -1
        return _ON
    return _REFUSED


@njit(cache=True, error_model="numpy", inline="always")
def _wanted(code: int, state: Any) -> bool:
    """Return whether a decimal is one that is kept, or looked at."""
    mode, kind = state[MODE], state[OPEN_KIND]
    if mode == _IN_BLOCK:
        return code == 10 or code == 20
    if mode < _IN_ENTITY or kind == OTHER or state[GROUP] != 0 or code > 255:
        return False
    if mode == _IN_VERTEX:
        return code == 10 or code == 20 or code == 30 or code == 42 or code >= 210
    if kind == _OF_WORDS:
        column = _COLUMN_OF[code]
        return (
            column >= 0 and _HAS[_OF_WORDS, column] and not state[SEEN] & (1 << (_B_VALUE + column))
        )
    if 210 <= code <= 230:
        return True
    if kind == LWPOLYLINE:
        return code == 10 or code == 20 or code == 42 or code == 38
    if kind == POLYLINE:
        return code == 30
    column = _COLUMN_OF[code]
    return (column >= 0 and _HAS[kind, column]) or code == 30 or code == 31


@njit(cache=True, error_model="numpy", inline="always")
def _decimal(
    code: int,
    before: int,
    read: float,
    sure: int,
    low: int,
    high: int,
    entity: Any,
    value: Any,
    vertex: Any,
    base: Any,
    left: Any,
    state: Any,
) -> int:
    """Keep a decimal, or mark its entity as odd."""
    mode, kind, row = state[MODE], state[OPEN_KIND], state[ROW]
    table, line, column = 0, row, 0
    if mode == _IN_BLOCK:
        table, line, column = 2, state[INSIDE], 0 if code == 10 else 1
        base[line, column] = read
    elif kind == _OF_WORDS:
        column = _COLUMN_OF[code]
        state[SEEN] |= 1 << (_B_VALUE + column)
        value[row, column] = read
    elif code == 30 or code == 31 or code == 38:
        if not abs(read) <= _FLAT or sure != EXACT:
            _odd(entity, state)
        return _ON
    elif code >= 210:
        if sure != EXACT or (abs(read) != 1.0 if code == 230 else read != 0.0):
            _odd(entity, state)
        elif code == 230 and mode == _IN_ENTITY:
            entity[row, MIRROR] = 1 if read < 0.0 else 0
        return _ON
    else:
        # Groups stand behind the markers of the subclass that they belong to, x before y.
        marks = state[OPEN_MARKS]
        behind = 3 if mode == _IN_VERTEX or (kind == ARC and code >= 50) else 2
        if (
            (marks > 0 and marks != behind)
            or (code == 20 and before != 10)
            or (code == 21 and before != 11)
        ):
            _odd(entity, state)
            return _ON
        if mode == _IN_VERTEX or kind == LWPOLYLINE:
            column = 0 if code == 10 else 1 if code == 20 else 2
            if mode == _IN_VERTEX:
                bit = 1 << (_B_VALUE + column)
                if state[SEEN] & bit:
                    _odd(entity, state)
                    return _ON
                state[SEEN] |= bit
            elif code == 10:
                if state[VERTICES] == len(vertex):
                    return _REFUSED
                vertex[state[VERTICES], 2] = 0.0
                state[VERTICES] += 1
                entity[row, COUNT] += 1
            elif entity[row, COUNT] == 0:
                _odd(entity, state)
                return _ON
            table, line = 1, state[VERTICES] - 1
            vertex[line, column] = read
        else:
            column = _COLUMN_OF[code]
            bit = 1 << (_B_VALUE + column)
            if state[SEEN] & bit:
                _odd(entity, state)
                return _ON
            state[SEEN] |= bit
            value[row, column] = read
    if sure == UNSURE:
        number_ = state[UNSURES]
        if number_ == len(left):
            return _REFUSED
        left[number_, 0], left[number_, 1], left[number_, 2] = table, line, column
        left[number_, 3], left[number_, 4] = low, high
        state[UNSURES] = number_ + 1
    return _ON


@njit(cache=True, error_model="numpy")
def _of_header(code: int, before: int, data: Any, low: int, high: int) -> bool:
    """Return whether a tag stands where it may in the header: a name, and one value."""
    if code == 9:
        return before != 9 and high > low and data[low] == 36
    return before == 9 or (code == 20 and before == 10) or (code == 30 and before == 20)


@njit(cache=True, error_model="numpy")
def _of_layer(
    code: int, data: Any, low: int, high: int, layer: Any, spans: Any, slots: Any, state: Any
) -> int:
    """Take a tag of the layer table."""
    row = state[LAYERS] - 1
    if code == 2 or code == 6:
        name = _named(data, low, high, spans, slots, state)
        column = LAYER_NAME if code == 2 else LAYER_LINETYPE
        if name < 0 or layer[row, column] >= 0:
            return _REFUSED
        layer[row, column] = name
    elif code == 62 or code == 70 or code == 290 or code == 420:
        whole = _whole(data, low, high)
        if abs(whole) >= 1 << 31:
            return _REFUSED
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
        layer[row, column] = whole
    elif code in (8, 60, 67):
        # These belong to entities.
        return _REFUSED
    return _ON


@njit(cache=True, error_model="numpy")
def _of_block(
    code: int, data: Any, low: int, high: int, block: Any, spans: Any, slots: Any, state: Any
) -> int:
    """Take a tag of the head of a block."""
    row = state[INSIDE]
    if code == 5 and block[row, BLOCK_HANDLE_SIZE] == 0:
        block[row, BLOCK_HANDLE], block[row, BLOCK_HANDLE_SIZE] = low, high - low
    elif code == 8 or code == 2:
        name = _named(data, low, high, spans, slots, state)
        if name < 0:
            return _REFUSED
        if code == 8:
            block[row, BLOCK_LAYER] = name
        elif block[row, NAME] < 0:
            block[row, NAME] = name
    elif (code == 1 and high > low) or (code == 70 and _whole(data, low, high) & 60):
        block[row, EXTERNAL] = 1
    return _ON


@njit(cache=True, error_model="numpy", inline="always")
def _of_entity(
    code: int, data: Any, low: int, high: int, entity: Any, spans: Any, slots: Any, state: Any
) -> int:
    """Take a tag of an entity that is no decimal."""
    row, kind, seen, marks = state[ROW], state[OPEN_KIND], state[SEEN], state[OPEN_MARKS]
    plain = kind != OTHER and kind != _OF_WORDS
    if code == 100:
        _mark(data, low, high, entity, state)
        return _ON
    if state[MODE] == _IN_VERTEX:
        if code == 70 and plain and _whole(data, low, high) & 16:
            _odd(entity, state)
        return _ON
    if code == 5:
        if not seen & (1 << _B_HANDLE):
            entity[row, HANDLE], entity[row, HANDLE_SIZE] = low, high - low
        elif plain:
            _odd(entity, state)
        state[SEEN] |= 1 << _B_HANDLE
    elif code == 8:
        name = _named(data, low, high, spans, slots, state)
        if name < 0:
            return _REFUSED
        if plain and (seen & (1 << _B_LAYER) or marks > 1):
            _odd(entity, state)
        entity[row, LAYER] = name
        state[SEEN] |= 1 << _B_LAYER
    elif code == 67:
        whole = _whole(data, low, high)
        if whole != 0 and whole != 1:
            return _REFUSED
        if plain and (seen & (1 << _B_PAPER) or marks > 1):
            _odd(entity, state)
        entity[row, PAPER] = whole
        state[SEEN] |= 1 << _B_PAPER
    elif code == 66:
        if entity[row, KIND] == INSERT:
            state[FOLLOWED] = 1 if _whole(data, low, high) != 0 else 0
    elif kind == _OF_WORDS:
        _of_words(code, data, low, high, entity, state)
    elif plain:
        return _of_plain(code, data, low, high, entity, spans, slots, state)
    return _ON


@njit(cache=True, error_model="numpy")
def _mark(data: Any, low: int, high: int, entity: Any, state: Any) -> None:
    """Take a subclass marker."""
    kind = state[OPEN_KIND]
    state[OPEN_MARKS] += 1
    marks = state[OPEN_MARKS]
    if kind in (OTHER, _OF_WORDS):
        return
    expected = -1
    if marks == 1:
        expected = _DB_ENTITY
    elif state[MODE] == _IN_VERTEX:
        expected = _DB_VERTEX if marks == 2 else _DB_2D_VERTEX if marks == 3 else -1
    elif marks == 2:
        expected = _SECOND[kind]
    elif marks == 3:
        expected = _THIRD[kind]
    if expected < 0 or not _is(data, low, high, expected):
        _odd(entity, state)


@njit(cache=True, error_model="numpy")
def _of_words(code: int, data: Any, low: int, high: int, entity: Any, state: Any) -> None:
    """Take a tag of a text or a dimension."""
    row, seen = state[ROW], state[SEEN]
    if code == 101:
        # Text in columns repeats its own from here on.
        state[OPEN_KIND] = OTHER
    elif code == 3 and state[IS_MTEXT] != 0:
        _odd(entity, state)
    elif code == 1 and not seen & (1 << _B_NAME):
        entity[row, FIRST], entity[row, COUNT] = low, high - low
        state[SEEN] |= 1 << _B_NAME
    elif code == 70 and not seen & (1 << _B_FLAGS):
        entity[row, FLAGS] = _whole(data, low, high) & 0xFFFF
        state[SEEN] |= 1 << _B_FLAGS


@njit(cache=True, error_model="numpy")
def _of_plain(
    code: int, data: Any, low: int, high: int, entity: Any, spans: Any, slots: Any, state: Any
) -> int:
    """Take a tag of a line, an INSERT …: attributes, flags and references."""
    row, kind, seen, marks = state[ROW], state[OPEN_KIND], state[SEEN], state[OPEN_MARKS]
    column, bit = -1, 0
    if code == 6 or (code == 2 and kind == INSERT):
        name = _named(data, low, high, spans, slots, state)
        if name < 0:
            return _REFUSED
        column, bit = (LINETYPE, 1 << _B_LINETYPE) if code == 6 else (REFERENCE, 1 << _B_NAME)
        if seen & bit or marks != (min(marks, 1) if code == 6 else 2 * min(marks, 1)):
            _odd(entity, state)
            return _ON
        entity[row, column] = name
        state[SEEN] |= bit
    elif code == 62 or code == 420:
        column, bit = (COLOUR, 1 << _B_COLOUR) if code == 62 else (TRUE_COLOUR, 1 << _B_TRUE)
        whole = _whole(data, low, high)
        if seen & bit or marks > 1 or whole < 0 or (code == 62 and whole > 256):
            _odd(entity, state)
            return _ON
        entity[row, column] = whole & 0xFFFFFF
        state[SEEN] |= bit
    elif code == 70 or (code == 71 and kind == INSERT):
        whole = _whole(data, low, high)
        column, bit = FLAGS, 1 << _B_FLAGS
        if kind == INSERT:
            column = COLUMNS if code == 70 else ROWS
            bit = 1 << (_B_COLUMNS if code == 70 else _B_ROWS)
        if (
            seen & bit
            or abs(whole) >= 1 << 31
            or (marks != 0 and marks != 2)
            or (kind == POLYLINE and whole & 88)
        ):
            _odd(entity, state)
            return _ON
        entity[row, column] = whole
        state[SEEN] |= bit
    elif (
        (code == 60 and _whole(data, low, high) != 0)
        or (code == 410 and not _is(data, low, high, _MODEL))
        or code == 101
    ):
        _odd(entity, state)
    return _ON


@njit(cache=True, error_model="numpy", inline="always")
def _group(code: int, data: Any, low: int, high: int, entity: Any, state: Any) -> int:
    """Take a tag around {…}, or of what other programs have added: it is skipped."""
    if code == 102:
        opens = high > low and data[low] == 123
        if state[GROUP] == 2 or opens == (state[GROUP] == 1):
            return _REFUSED
        if not opens and not _is(data, low, high, _GROUP_END):
            return _REFUSED
        if (
            opens
            and state[MODE] == _IN_ENTITY
            and entity[state[ROW], KIND] == INSERT
            and _is(data, low, high, _XDICTIONARY)
        ):
            # Behind it may be what clips the block.
            return _REFUSED
        state[GROUP] = 1 if opens else 0
    elif code >= 1000:
        if state[GROUP] == 1 or (state[GROUP] == 0 and code != 1001):
            return _REFUSED
        size = _WORD_ENDS[_OF_COLUMNS + 1] - _WORD_ENDS[_OF_COLUMNS]
        if state[IS_MTEXT] != 0 and _is(data, low, min(high, low + size), _OF_COLUMNS):
            # ezdxf makes one of a text in columns and its frame.
            return _REFUSED
        state[GROUP] = 2
    elif state[GROUP] == 2:
        return _REFUSED
    return _ON


@njit(cache=True, error_model="numpy")
def scan_tags(data: Any, tables: Any, state: Any) -> bool:
    """Fill the tables; return whether the file is plain to its end mark.

    Parameters
    ----------
    data : (m,) uint8
    tables
        Entities, values, vertices, blocks, base points, layers, spans of names, their hash table,
        and places of numbers that are left to ``float``.
    state : (``STATES``,) int64
        Zeros; of use afterwards are the numbers from ``ENTITIES`` on.
    """
    size = len(data)
    entity, value, vertex, block, base, layer, spans, slots, left = tables
    state[SECTION] = state[INSIDE] = state[ROW] = state[CHAIN] = state[BEFORE] = -1
    at = 0
    while at < size:
        # The group code, alone on its line.
        start = at
        while at < size and data[at] == 32:
            at += 1
        code = 0
        first = at
        while at < size and 48 <= data[at] <= 57:
            code = code * 10 + int(data[at]) - 48
            at += 1
        if at == first or at - first > 4 or code > _LAST_CODE:
            return False
        while at < size and data[at] == 32:
            at += 1
        if at < size and data[at] == 13:
            at += 1
        if at >= size or data[at] != 10:
            return False
        at += 1
        before = state[BEFORE]
        if code != 999:
            if before >= 0 and _IS_POINT[before] and code != before + 10:
                return False
            state[BEFORE] = code
        low = at
        what = _TYPE[code]
        read, sure = 0.0, WRONG
        if what == _DECIMAL and _wanted(code, state):
            read, at, sure = number(data, at, size)
            if sure == WRONG:
                at = low
        while at < size and data[at] != 10 and data[at] != 13:
            at += 1
        high = at
        if at < size and data[at] == 13:
            at += 1
        if at < size and data[at] != 10:
            return False
        at += 1
        if code == 999:
            continue
        verdict = _ON
        if what == _DECIMAL and sure != WRONG:
            verdict = _decimal(
                code, before, read, sure, low, high, entity, value, vertex, base, left, state
            )
        elif code == 0:
            if before == 9 and state[SECTION] == _HEADER:
                return False
            verdict = _structure(
                data,
                start,
                low,
                high,
                entity,
                value,
                vertex,
                block,
                base,
                layer,
                spans,
                slots,
                state,
            )
            if verdict == _DONE:
                return True
        elif (what != _TEXT_VALUE and not _valid(data, low, high, what)) or (
            state[SECTION] == _HEADER and not _of_header(code, before, data, low, high)
        ):
            return False
        elif (
            code < 1000
            and not _MEANS[code]
            and code != 102
            and state[GROUP] != 2
            and state[MODE] != _IN_LAYER
            and state[MODE] != _IN_SECTION
        ) or state[SECTION] > _ENTITIES:
            # What nobody asks for, and what is in other sections.
            continue
        elif code == 102 or code >= 1000 or state[GROUP] != 0:
            verdict = _group(code, data, low, high, entity, state)
        else:
            mode = state[MODE]
            if mode >= _IN_ENTITY:
                verdict = _of_entity(code, data, low, high, entity, spans, slots, state)
            elif mode == _IN_SECTION:
                if code != 2:
                    return False
                section = _word(data, low, high, _HEADER, _ENTITIES)
                # One that is skipped is open all the same.
                state[SECTION] = section if section >= 0 else _MODEL
                state[MODE] = _NOTHING
                if section == _HEADER:
                    if state[HEADER_FIRST] > 0:
                        return False
                    state[HEADER_FIRST] = at
            elif mode == _IN_TABLE:
                state[NAMED] |= code == 2
            elif mode == _IN_LAYER:
                verdict = _of_layer(code, data, low, high, layer, spans, slots, state)
            elif mode == _IN_BLOCK:
                verdict = _of_block(code, data, low, high, block, spans, slots, state)
        if verdict != _ON:
            return False
    return False
