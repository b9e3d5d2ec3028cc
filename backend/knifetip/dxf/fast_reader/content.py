"""content: kernels that store the tags of an entity and detect tags that are not supported."""

from __future__ import annotations

from typing import Final

from knifetip.drawing_builder.line_widths import GREATEST
from knifetip.dxf.decimals import EXACT, UNSURE
from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader import group_codes as g
from knifetip.dxf.fast_reader import keywords as w
from knifetip.dxf.fast_reader import state as s
from knifetip.dxf.fast_reader.group_values import NONE, integer_at, name_at
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

#: Bits of ``state.SEEN`` for the widths of a vertex.
_WIDTHS: Final = 1 << (g.B_VALUE + f.START_WIDTH) | 1 << (g.B_VALUE + f.END_WIDTH)


@inline_kernel
def take_decimal(
    code: int,
    previous_code: int,
    read: float,
    sure: int,
    low: int,
    high: int,
    tables: ScanTables,
    state: OutI64_1,
) -> int:
    """Store a decimal number of the entity or block that is being read.

    The entity is marked as unsupported if the fast reader does not support the number.  Returns
    ``ON`` if the scan continues, ``REFUSED`` if the fast reader cannot read the file.

    Parameters
    ----------
    code, previous_code
        Group codes of the number and of the preceding tag.
    read, sure
        The number and its certainty, as returned by ``decimals.number``.
    low, high
        Positions of the number in the file: first byte, and byte after the last.
    tables, state
        Arrays into which the scan writes, and state of the scan.
    """
    entity, value, vertex, unsure = tables.entity, tables.value, tables.vertex, tables.left
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
    elif 40 <= code <= 43 and code != 42 and (kind == f.LWPOLYLINE or kind == f.POLYLINE):
        _take_width(code, read, tables, state)
        return s.ON
    elif code == 30 or code == 31 or code == 38:
        if not abs(read) <= g.FLAT or sure != EXACT:
            mark_unsupported(entity, state)
        return s.ON
    elif code >= 210:
        incomplete = code > 210 and previous_code != code - 10
        if incomplete or sure != EXACT or (abs(read) != 1.0 if code == 230 else read != 0.0):
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
            or (code == 20 and previous_code != 10)
            or (code == 21 and previous_code != 11)
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
                state[s.SEEN] &= ~_WIDTHS
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
        if number_ == len(unsure):
            return s.REFUSED
        unsure[number_, 0], unsure[number_, 1], unsure[number_, 2] = table, line, column
        unsure[number_, 3], unsure[number_, 4] = low, high
        state[s.UNSURES] = number_ + 1
    return s.ON


@inline_kernel
def _take_width(code: int, read: float, tables: ScanTables, state: OutI64_1) -> None:
    """Store a width of the polyline or of the vertex that is being read.

    The least and the greatest width of all vertices are stored, and the numbers of vertices with a
    width at their start and at their end.  ``code`` is the group code of the width ``read`` (file
    units).  A width that precedes the vertices of an LWPOLYLINE has no meaning, except that of the
    whole polyline.
    """
    row, kind, marks = state[s.ROW], state[s.OPEN_KIND], state[s.OPEN_MARKS]
    value, is_vertex = tables.value, state[s.MODE] == s.IN_VERTEX
    bit = 1 << (g.B_VALUE + (f.END_WIDTH if code == 41 else f.START_WIDTH))
    if code == 43:
        bit = 1 << (g.B_VALUE + f.ANGLE)
    if state[s.SEEN] & bit or (marks > 0 and marks != (3 if is_vertex else 2)):
        mark_unsupported(tables.entity, state)
        return
    if kind == f.LWPOLYLINE and code != 43 and tables.entity[row, f.COUNT] == 0:
        return
    state[s.SEEN] |= bit
    if code == 43 or (kind == f.POLYLINE and not is_vertex):
        value[row, f.END_WIDTH if code == 41 else f.START_WIDTH] = read
        return
    # The comparisons are false for NaN, the value of a column that is not given.
    if not value[row, f.LEAST_WIDTH] <= read:
        value[row, f.LEAST_WIDTH] = read
    if not value[row, f.MOST_WIDTH] >= read:
        value[row, f.MOST_WIDTH] = read
    column = f.STARTS if code == 40 else f.ENDS
    count = value[row, column]
    value[row, column] = count + 1.0 if count > 0.0 else 1.0


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
    """Store a tag whose value is not a decimal number, for the entity that is being read.

    Returns ``ON`` if the scan continues, ``REFUSED`` if the fast reader cannot read the file.

    Parameters
    ----------
    code, data, low, high
        Group code of the tag, bytes of the file, and the range of the value: ``data[low:high]``.
    entity, spans, slots, state
        The entities, the positions of the names in the file, the hash table of names, and the
        state of the scan; all are updated.
    """
    row, kind, seen_tags, marks = (
        state[s.ROW],
        state[s.OPEN_KIND],
        state[s.SEEN],
        state[s.OPEN_MARKS],
    )
    plain = kind != f.OTHER and kind != g.OF_WORDS
    if code == 100:
        _take_marker(data, low, high, entity, state)
        return s.ON
    if state[s.MODE] == s.IN_VERTEX:
        if code == 70 and plain and integer_at(data, low, high) & 16:
            mark_unsupported(entity, state)
        return s.ON
    if code == 5:
        if high == low or (marks < 2 and seen_tags & (1 << g.B_HANDLE)):
            return s.REFUSED
        if not seen_tags & (1 << g.B_HANDLE):
            entity[row, f.HANDLE], entity[row, f.HANDLE_SIZE] = low, high - low
        elif plain:
            mark_unsupported(entity, state)
        state[s.SEEN] |= 1 << g.B_HANDLE
    elif code == 8:
        name = name_at(data, low, high, spans, slots, state)
        if name < 0:
            return s.REFUSED
        if plain and (seen_tags & (1 << g.B_LAYER) or marks > 1):
            mark_unsupported(entity, state)
        entity[row, f.LAYER] = name
        state[s.SEEN] |= 1 << g.B_LAYER
    elif code == 67:
        integer = integer_at(data, low, high)
        if integer != 0 and integer != 1:
            return s.REFUSED
        if plain and (seen_tags & (1 << g.B_PAPER) or marks > 1):
            mark_unsupported(entity, state)
        entity[row, f.PAPER] = integer
        state[s.SEEN] |= 1 << g.B_PAPER
    elif code == 66:
        if entity[row, f.KIND] == f.INSERT:
            state[s.FOLLOWED] = 1 if integer_at(data, low, high) != 0 else 0
    elif kind == g.OF_WORDS:
        _store_text_tag(code, data, low, high, entity, state)
    elif plain:
        return _store_geometry_tag(code, data, low, high, entity, spans, slots, state)
    return s.ON


@inline_kernel
def _take_marker(data: U8_1, low: int, high: int, entity: OutI32_2F, state: OutI64_1) -> None:
    """Check the subclass marker ``data[low:high]`` of the entity that is being read.

    The entity is marked as unsupported in ``entity`` if it should have a different marker at this
    position.
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
def _store_text_tag(
    code: int, data: U8_1, low: int, high: int, entity: OutI32_2F, state: OutI64_1
) -> None:
    """Store a tag of a text or dimension in ``entity``.

    ``code`` is the group code of the tag and ``data[low:high]`` its value.
    """
    row, seen_tags = state[s.ROW], state[s.SEEN]
    if code == 101:
        # The embedded object that follows repeats the text, divided into columns.
        state[s.OPEN_KIND] = f.OTHER
        state[s.CONTEXT] = g.UNREAD
    elif code == 3 and state[s.IS_MTEXT] != 0:
        mark_unsupported(entity, state)
    elif code == 1 and not seen_tags & (1 << g.B_NAME):
        entity[row, f.FIRST], entity[row, f.COUNT] = low, high - low
        state[s.SEEN] |= 1 << g.B_NAME
    elif code == 70 and not seen_tags & (1 << g.B_FLAGS):
        entity[row, f.FLAGS] = integer_at(data, low, high) & 0xFFFF
        state[s.SEEN] |= 1 << g.B_FLAGS


@inline_kernel
def _store_geometry_tag(
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

    Returns ``ON`` if the scan continues, ``REFUSED`` if the fast reader cannot read the file.

    ``code``, ``data``, ``low``, ``high``: group code of the tag, bytes of the file, and the range
    of the value: ``data[low:high]``.
    ``entity``, ``spans``, ``slots``, ``state``: the entities, the positions of the names in the
    file, the hash table of names, and the state of the scan; all are updated.
    """
    row, kind, seen_tags, marks = (
        state[s.ROW],
        state[s.OPEN_KIND],
        state[s.SEEN],
        state[s.OPEN_MARKS],
    )
    column, bit = -1, 0
    if code == 6 or (code == 2 and kind == f.INSERT):
        name = name_at(data, low, high, spans, slots, state)
        if name < 0:
            return s.REFUSED
        column, bit = (f.LINETYPE, 1 << g.B_LINETYPE) if code == 6 else (f.REFERENCE, 1 << g.B_NAME)
        if seen_tags & bit or marks != (min(marks, 1) if code == 6 else 2 * min(marks, 1)):
            mark_unsupported(entity, state)
            return s.ON
        entity[row, column] = name
        state[s.SEEN] |= bit
    elif code == 62 or code == 420:
        column, bit = (f.COLOUR, 1 << g.B_COLOUR) if code == 62 else (f.TRUE_COLOUR, 1 << g.B_TRUE)
        integer = integer_at(data, low, high)
        if seen_tags & bit or marks > 1 or integer < 0 or (code == 62 and integer > 256):
            mark_unsupported(entity, state)
            return s.ON
        entity[row, column] = integer & 0xFFFFFF
        state[s.SEEN] |= bit
    elif code == 370:
        integer = integer_at(data, low, high)
        if integer == NONE:
            return s.REFUSED
        if seen_tags & (1 << g.B_LINE_WIDTH):
            mark_unsupported(entity, state)
            return s.ON
        entity[row, f.LINE_WIDTH] = max(min(integer, GREATEST), -4)
        state[s.SEEN] |= 1 << g.B_LINE_WIDTH
    elif code == 70 or (code == 71 and kind == f.INSERT):
        integer = integer_at(data, low, high)
        column, bit = f.FLAGS, 1 << g.B_FLAGS
        if kind == f.INSERT:
            column = f.COLUMNS if code == 70 else f.ROWS
            bit = 1 << (g.B_COLUMNS if code == 70 else g.B_ROWS)
        if (
            seen_tags & bit
            or abs(integer) >= 1 << 31
            or (marks != 0 and marks != 2)
            or (kind == f.POLYLINE and integer & 88)
        ):
            mark_unsupported(entity, state)
            return s.ON
        entity[row, column] = integer
        state[s.SEEN] |= bit
    elif (
        (code == 60 and integer_at(data, low, high) != 0)
        or (code == 410 and not is_word(data, low, high, w.MODEL))
        or code == 101
    ):
        mark_unsupported(entity, state)
    return s.ON
