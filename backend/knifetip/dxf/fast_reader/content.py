"""content: kernels that store the tags of an entity and detect tags that are not supported."""

from __future__ import annotations

from knifetip.dxf.decimals import EXACT, UNSURE
from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader import group_codes as g
from knifetip.dxf.fast_reader import keywords as w
from knifetip.dxf.fast_reader import state as s
from knifetip.dxf.fast_reader.group_values import name_at, whole_at
from knifetip.dxf.fast_reader.keywords import is_word
from knifetip.dxf.fast_reader.structure import mark_unsupported
from knifetip.dxf.scan_tables import ScanTables
from knifetip.kernels import (
    U8_1,
    OutI32_1,
    OutI32_2F,
    OutI64_1,
    OutI64_2,
    inline_kernel,
)


@inline_kernel
def take_decimal(
    code: int,
    before: int,
    read: float,
    sure: int,
    low: int,
    high: int,
    tables: ScanTables,
    state: OutI64_1,
) -> int:
    """Store a decimal number of the open entity, or mark the entity as unsupported.

    Returns ON, or REFUSED if the fast reader cannot read the file.

    Parameters
    ----------
    code, before
        Group codes of the number and of the preceding tag.
    read, sure
        The number and its certainty, as returned by ``decimals.number``.
    low, high
        Positions of the number in the file: first byte, and byte after the last.
    tables, state
        Arrays into which the scan writes, and state of the scan.
    """
    entity, value, vertex, left = tables.entity, tables.value, tables.vertex, tables.left
    mode, kind, row = state[s.MODE], state[s.OPEN_KIND], state[s.ROW]
    table, line, column = 0, row, 0
    if mode == s.IN_BLOCK:
        table, line, column = 2, state[s.INSIDE], 0 if code == 10 else 1
        tables.base[line, column] = read
    elif kind == g.OF_WORDS:
        column = g.COLUMN_OF[code]
        bit = 1 << (g.B_VALUE + column)
        if state[s.SEEN] & bit:
            return s.ON
        state[s.SEEN] |= bit
        value[row, column] = read
    elif code == 30 or code == 31 or code == 38:
        if not abs(read) <= g.FLAT or sure != EXACT:
            mark_unsupported(entity, state)
        return s.ON
    elif code >= 210:
        alone = code > 210 and before != code - 10
        if alone or sure != EXACT or (abs(read) != 1.0 if code == 230 else read != 0.0):
            mark_unsupported(entity, state)
        elif code == 230 and mode == s.IN_ENTITY:
            entity[row, f.MIRROR] = 1 if read < 0.0 else 0
        return s.ON
    else:
        # Group codes follow the marker of their subclass, x before y.
        marks = state[s.OPEN_MARKS]
        behind = 3 if mode == s.IN_VERTEX or (kind == f.ARC and code >= 50) else 2
        if (
            (marks > 0 and marks != behind)
            or (code == 20 and before != 10)
            or (code == 21 and before != 11)
        ):
            mark_unsupported(entity, state)
            return s.ON
        if mode == s.IN_VERTEX or kind == f.LWPOLYLINE:
            column = 0 if code == 10 else 1 if code == 20 else 2
            if mode == s.IN_VERTEX:
                bit = 1 << (g.B_VALUE + column)
                if state[s.SEEN] & bit:
                    mark_unsupported(entity, state)
                    return s.ON
                state[s.SEEN] |= bit
            elif code == 10:
                if state[s.VERTICES] == state[s.MOST_VERTICES]:
                    return s.REFUSED
                vertex[state[s.VERTICES], 2] = 0.0
                state[s.VERTICES] += 1
                entity[row, f.COUNT] += 1
            elif entity[row, f.COUNT] == 0:
                mark_unsupported(entity, state)
                return s.ON
            table, line = 1, state[s.VERTICES] - 1
            vertex[line, column] = read
        else:
            column = g.COLUMN_OF[code]
            bit = 1 << (g.B_VALUE + column)
            if state[s.SEEN] & bit:
                mark_unsupported(entity, state)
                return s.ON
            state[s.SEEN] |= bit
            value[row, column] = read
    if sure == UNSURE:
        number_ = state[s.UNSURES]
        if number_ == len(left):
            return s.REFUSED
        left[number_, 0], left[number_, 1], left[number_, 2] = table, line, column
        left[number_, 3], left[number_, 4] = low, high
        state[s.UNSURES] = number_ + 1
    return s.ON


@inline_kernel
def take_tag(
    code: int,
    data: U8_1,
    low: int,
    high: int,
    entity: OutI32_2F,
    spans: OutI64_2,
    slots: OutI32_1,
    state: OutI64_1,
) -> int:
    """Store a tag of the open entity whose value is not a decimal number.

    ``code`` is the group code of the tag and ``data[low:high]`` its value.  Returns ON, or REFUSED
    if the fast reader cannot read the file.
    """
    row, kind, seen, marks = state[s.ROW], state[s.OPEN_KIND], state[s.SEEN], state[s.OPEN_MARKS]
    plain = kind != f.OTHER and kind != g.OF_WORDS
    if code == 100:
        _take_marker(data, low, high, entity, state)
        return s.ON
    if state[s.MODE] == s.IN_VERTEX:
        if code == 70 and plain and whole_at(data, low, high) & 16:
            mark_unsupported(entity, state)
        return s.ON
    if code == 5:
        if high == low or (marks < 2 and seen & (1 << g.B_HANDLE)):
            return s.REFUSED
        if not seen & (1 << g.B_HANDLE):
            entity[row, f.HANDLE], entity[row, f.HANDLE_SIZE] = low, high - low
        elif plain:
            mark_unsupported(entity, state)
        state[s.SEEN] |= 1 << g.B_HANDLE
    elif code == 8:
        name = name_at(data, low, high, spans, slots, state)
        if name < 0:
            return s.REFUSED
        if plain and (seen & (1 << g.B_LAYER) or marks > 1):
            mark_unsupported(entity, state)
        entity[row, f.LAYER] = name
        state[s.SEEN] |= 1 << g.B_LAYER
    elif code == 67:
        whole = whole_at(data, low, high)
        if whole != 0 and whole != 1:
            return s.REFUSED
        if plain and (seen & (1 << g.B_PAPER) or marks > 1):
            mark_unsupported(entity, state)
        entity[row, f.PAPER] = whole
        state[s.SEEN] |= 1 << g.B_PAPER
    elif code == 66:
        if entity[row, f.KIND] == f.INSERT:
            state[s.FOLLOWED] = 1 if whole_at(data, low, high) != 0 else 0
    elif kind == g.OF_WORDS:
        _of_words(code, data, low, high, entity, state)
    elif plain:
        return _of_plain(code, data, low, high, entity, spans, slots, state)
    return s.ON


@inline_kernel
def _take_marker(data: U8_1, low: int, high: int, entity: OutI32_2F, state: OutI64_1) -> None:
    """Check the subclass marker ``data[low:high]`` of the open entity.

    The entity is marked as unsupported if it should have another marker at this position.
    """
    kind = state[s.OPEN_KIND]
    state[s.OPEN_MARKS] += 1
    marks = state[s.OPEN_MARKS]
    if kind in (f.OTHER, g.OF_WORDS):
        return
    expected = -1
    if marks == 1:
        expected = w.DB_ENTITY
    elif state[s.MODE] == s.IN_VERTEX:
        expected = w.DB_VERTEX if marks == 2 else w.DB_2D_VERTEX if marks == 3 else -1
    elif marks == 2:
        expected = g.SECOND[kind]
    elif marks == 3:
        expected = g.THIRD[kind]
    if expected < 0 or not is_word(data, low, high, expected):
        mark_unsupported(entity, state)


@inline_kernel
def _of_words(
    code: int, data: U8_1, low: int, high: int, entity: OutI32_2F, state: OutI64_1
) -> None:
    """Store a tag of a text or dimension: group code ``code``, value ``data[low:high]``."""
    row, seen = state[s.ROW], state[s.SEEN]
    if code == 101:
        # The embedded object that follows repeats the text, divided into columns.
        state[s.OPEN_KIND] = f.OTHER
        state[s.CONTEXT] = g.UNREAD
    elif code == 3 and state[s.IS_MTEXT] != 0:
        mark_unsupported(entity, state)
    elif code == 1 and not seen & (1 << g.B_NAME):
        entity[row, f.FIRST], entity[row, f.COUNT] = low, high - low
        state[s.SEEN] |= 1 << g.B_NAME
    elif code == 70 and not seen & (1 << g.B_FLAGS):
        entity[row, f.FLAGS] = whole_at(data, low, high) & 0xFFFF
        state[s.SEEN] |= 1 << g.B_FLAGS


@inline_kernel
def _of_plain(
    code: int,
    data: U8_1,
    low: int,
    high: int,
    entity: OutI32_2F,
    spans: OutI64_2,
    slots: OutI32_1,
    state: OutI64_1,
) -> int:
    """Store an attribute, a flag or the block name of a line, arc, polyline or INSERT.

    ``code`` is the group code of the tag and ``data[low:high]`` its value.  Returns ON, or REFUSED
    if the fast reader cannot read the file.
    """
    row, kind, seen, marks = state[s.ROW], state[s.OPEN_KIND], state[s.SEEN], state[s.OPEN_MARKS]
    column, bit = -1, 0
    if code == 6 or (code == 2 and kind == f.INSERT):
        name = name_at(data, low, high, spans, slots, state)
        if name < 0:
            return s.REFUSED
        column, bit = (f.LINETYPE, 1 << g.B_LINETYPE) if code == 6 else (f.REFERENCE, 1 << g.B_NAME)
        if seen & bit or marks != (min(marks, 1) if code == 6 else 2 * min(marks, 1)):
            mark_unsupported(entity, state)
            return s.ON
        entity[row, column] = name
        state[s.SEEN] |= bit
    elif code == 62 or code == 420:
        column, bit = (f.COLOUR, 1 << g.B_COLOUR) if code == 62 else (f.TRUE_COLOUR, 1 << g.B_TRUE)
        whole = whole_at(data, low, high)
        if seen & bit or marks > 1 or whole < 0 or (code == 62 and whole > 256):
            mark_unsupported(entity, state)
            return s.ON
        entity[row, column] = whole & 0xFFFFFF
        state[s.SEEN] |= bit
    elif code == 70 or (code == 71 and kind == f.INSERT):
        whole = whole_at(data, low, high)
        column, bit = f.FLAGS, 1 << g.B_FLAGS
        if kind == f.INSERT:
            column = f.COLUMNS if code == 70 else f.ROWS
            bit = 1 << (g.B_COLUMNS if code == 70 else g.B_ROWS)
        if (
            seen & bit
            or abs(whole) >= 1 << 31
            or (marks != 0 and marks != 2)
            or (kind == f.POLYLINE and whole & 88)
        ):
            mark_unsupported(entity, state)
            return s.ON
        entity[row, column] = whole
        state[s.SEEN] |= bit
    elif (
        (code == 60 and whole_at(data, low, high) != 0)
        or (code == 410 and not is_word(data, low, high, w.MODEL))
        or code == 101
    ):
        mark_unsupported(entity, state)
    return s.ON
