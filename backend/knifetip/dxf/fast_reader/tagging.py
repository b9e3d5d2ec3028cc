"""tagging: the kernel that scans a DXF file tag by tag, from the first byte to EOF.

A tag is a line with a group code and a line with a value.  The tags fill arrays of entities,
values, vertices, blocks and layers; the array ``state`` contains the state of the scan.  A file
with an unsupported structure is refused.  An unsupported entity is marked in the column
``UNSUPPORTED``, and the scan continues.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.drawing_builder.line_widths import GREATEST
from knifetip.dxf.byte_scan import ONE, code_at, end_of_line
from knifetip.dxf.decimals import WRONG, number
from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader import group_codes as g
from knifetip.dxf.fast_reader import keywords as w
from knifetip.dxf.fast_reader import state as s
from knifetip.dxf.fast_reader.content import take_decimal, take_tag
from knifetip.dxf.fast_reader.group_values import integer_at, name_at, valid
from knifetip.dxf.fast_reader.handle_set import take_handle
from knifetip.dxf.fast_reader.keywords import is_word, word_at
from knifetip.dxf.fast_reader.structure import begin, context, pause
from knifetip.dxf.scan_tables import ScanTables
from knifetip.dxf.value_types import LAST_CODE, TEXT_VALUE, TYPE
from knifetip.kernels import (
    I32_2F,
    I64_1,
    U8_1,
    OutI32_1,
    OutI32_2,
    OutI64_1,
    OutI64_2,
    inline_kernel,
    kernel,
)


@inline_kernel
def _header_tag_valid(code: int, previous_code: int, data: U8_1, low: int, high: int) -> bool:
    """Return whether a tag may follow its preceding tag in the section HEADER.

    In this section a tag with the name of a variable is followed by one value or one point.

    ``data``, ``low``, ``high``: bytes of the file; the value of the tag is ``data[low:high]``.
    """
    if code == 9:
        return previous_code != 9 and high > low and data[low] == 36
    return (
        previous_code == 9
        or (code == 20 and previous_code == 10)
        or (code == 30 and previous_code == 20)
    )


@inline_kernel
def _store_layer_tag(
    code: int,
    data: U8_1,
    low: int,
    high: int,
    layer: OutI32_2,
    spans: OutI64_2,
    slots: OutI32_1,
    state: OutI64_1,
) -> int:
    """Store a tag of the layer that is being read, in the last used row of the array ``layer``.

    Returns ``ON`` if the scan continues, ``REFUSED`` if the fast reader cannot read the file.

    ``code``, ``data``, ``low``, ``high``: group code of the tag, bytes of the file, and the range
    of the value: ``data[low:high]``.
    ``spans``, ``slots``: positions of the names in the file, and hash table of names; a new name is
    added.
    """
    row = state[s.LAYERS] - 1
    if code == 2 or code == 6:
        name = name_at(data, low, high, spans, slots, state)
        column = f.LAYER_NAME if code == 2 else f.LAYER_LINETYPE
        if name < 0 or layer[row, column] >= 0:
            return s.REFUSED
        layer[row, column] = name
        state[s.NAMED] |= code == 2
    elif code == 62 or code == 70 or code == 290 or code == 370 or code == 420:
        integer = integer_at(data, low, high)
        if abs(integer) >= 1 << 31:
            return s.REFUSED
        column = f.LAYER_FLAGS
        if code == 62:
            column = f.LAYER_COLOUR
            if integer == 0 or abs(integer) > 255:
                # Not allowed in the table; 7 is the default.
                integer = 7 if integer >= 0 else -7
        elif code == 290:
            column = f.LAYER_PLOT
        elif code == 370:
            column = f.LAYER_LINE_WIDTH
            integer = min(integer, GREATEST)
        elif code == 420:
            column = f.LAYER_TRUE
            integer &= 0xFFFFFF
        layer[row, column] = integer
    elif code in (8, 60, 67):
        # Only entities have these group codes.
        return s.REFUSED
    return s.ON


@inline_kernel
def _store_block_tag(
    code: int,
    data: U8_1,
    low: int,
    high: int,
    block: OutI32_2,
    spans: OutI64_2,
    slots: OutI32_1,
    state: OutI64_1,
) -> int:
    """Store a tag of the header of the block definition that is being read, in ``block``.

    Returns ``ON`` if the scan continues, ``REFUSED`` if the fast reader cannot read the file.

    ``code``, ``data``, ``low``, ``high``: group code of the tag, bytes of the file, and the range
    of the value: ``data[low:high]``.
    ``spans``, ``slots``: positions of the names in the file, and hash table of names; a new name is
    added.
    """
    row = state[s.INSIDE]
    if code == 5:
        block[row, f.BLOCK_HANDLE], block[row, f.BLOCK_HANDLE_SIZE] = low, high - low
    elif code == 8 or code == 2:
        name = name_at(data, low, high, spans, slots, state)
        if name < 0:
            return s.REFUSED
        if code == 8:
            block[row, f.BLOCK_LAYER] = name
        elif block[row, f.NAME] < 0:
            block[row, f.NAME] = name
    elif (code == 1 and high > low) or (code == 70 and integer_at(data, low, high) & 60):
        block[row, f.EXTERNAL] = 1
    return s.ON


@inline_kernel
def _skip_group_tag(
    code: int, data: U8_1, low: int, high: int, entity: I32_2F, state: OutI64_1
) -> int:
    """Check a tag that the scan does not store because another program wrote it for its own use.

    Such tags are in groups between the values "{…" and "}" of group code 102, or are extension data
    with group codes from 1000 on.  ``code`` is the group code of the tag and ``data[low:high]`` its
    value.  Returns ``ON`` if the scan continues, ``REFUSED`` if the fast reader cannot read the
    file.
    """
    if code == 102:
        opens = high > low and data[low] == 123
        if state[s.GROUP] == 2 or opens == (state[s.GROUP] == 1):
            return s.REFUSED
        if not opens and not is_word(data, low, high, w.GROUP_END):
            return s.REFUSED
        if (
            opens
            and state[s.MODE] == s.IN_ENTITY
            and entity[state[s.ROW], f.KIND] == f.INSERT
            and is_word(data, low, high, w.XDICTIONARY)
        ):
            # The dictionary may contain a clipping boundary.
            return s.REFUSED
        state[s.GROUP] = 1 if opens else 0
    elif code >= 1000:
        if state[s.GROUP] == 1 or (state[s.GROUP] == 0 and code != 1001):
            return s.REFUSED
        size = w.ENDS[w.OF_COLUMNS + 1] - w.ENDS[w.OF_COLUMNS]
        if state[s.IS_MTEXT] != 0 and is_word(data, low, min(high, low + size), w.OF_COLUMNS):
            # ezdxf merges a text in columns with its frame.
            return s.REFUSED
        state[s.GROUP] = 2
    elif state[s.GROUP] == 2:
        return s.REFUSED
    return s.ON


@inline_kernel
def _is_handle(code: int, state: I64_1) -> bool:
    """Return whether a tag contains the handle of an object that is not an entity.

    Such handles are collected, because each handle may occur only once in a file.  ``code`` is the
    group code of the tag, and ``state`` the state of the scan.
    """
    named = 105 if state[s.MODE] == s.IN_STYLE else 5
    # After a subclass marker the code has another meaning.
    if code != named or state[s.GROUP] != 0 or state[s.OPEN_MARKS] > 0:
        return False
    return bool(w.TABLES <= state[s.SECTION] <= w.OBJECTS)


@inline_kernel
def _store_structure_tag(
    code: int, data: U8_1, low: int, high: int, next_tag: int, tables: ScanTables, state: OutI64_1
) -> int:
    """Store a tag of the section, table, block or entity that is being read.

    Returns ``ON`` if the scan continues, ``REFUSED`` if the fast reader cannot read the file.

    ``data``, ``low``, ``high``: bytes of the file; the value of the tag is ``data[low:high]``.
    ``next_tag``: position of the next tag.  If the tag is the name of the section HEADER, this
    position is stored as the start of the section.
    ``tables``, ``state``: the arrays into which the scan writes, and the state of the scan; both
    are updated.
    """
    spans, slots = tables.spans, tables.slots
    mode = state[s.MODE]
    if mode >= s.IN_ENTITY:
        return take_tag(code, data, low, high, tables.entity, spans, slots, state)
    if mode == s.IN_SECTION:
        if code != 2:
            return s.REFUSED
        section = word_at(data, low, high, w.HEADER, w.ACDSDATA)
        # ezdxf reads the last of two sections with one name, and no unknown ones.
        if section < 0 or state[s.SECTIONS] & (1 << section):
            return s.REFUSED
        state[s.SECTIONS] |= 1 << section
        state[s.SECTION] = section
        state[s.MODE] = s.IN_OBJECTS if section == w.OBJECTS else s.NOTHING
        if section == w.HEADER:
            state[s.HEADER_FIRST] = next_tag
    elif mode == s.IN_TABLE:
        if code == 100 and state[s.TABLE] == 0:
            return s.REFUSED
        if code == 2 and state[s.TABLE] == 0:
            state[s.NAMED] = 1
            state[s.TABLE] = word_at(data, low, high, w.VPORT, w.BLOCK_RECORD)
            # A record that ezdxf does not accept.
            return s.ON if state[s.TABLE] > 0 else s.REFUSED
    elif mode == s.IN_ROW or mode == s.IN_STYLE:
        state[s.NAMED] |= code == 2
    elif mode == s.IN_LAYER:
        return _store_layer_tag(code, data, low, high, tables.layer, spans, slots, state)
    elif mode == s.IN_BLOCK:
        return _store_block_tag(code, data, low, high, tables.block, spans, slots, state)
    return s.ON


@kernel(allocates=False)
def scan_tags(data: U8_1, begins: int, ends: int, tables: ScanTables, state: OutI64_1) -> bool:
    """Write the content of a part of a file into ``tables``; return whether the part is supported.

    Parameters
    ----------
    data : (m,) uint8
        Bytes of the file.
    begins, ends
        The part is ``data[begins:ends]``; it begins with a group code.
    tables
        Arrays for entities, vertices, blocks, layers and names.
    state : (``STATES``,) int64
        Initial state of the scan; on return, it contains the numbers of rows that were written.
    """
    entity, block = tables.entity, tables.block
    spans, slots, other_handles = tables.spans, tables.slots, tables.others
    size: Any = np.uint64(len(data))
    stop: Any = np.uint64(ends)
    at: Any = np.uint64(begins)
    last = -1
    while at < size:
        if at >= stop:
            # A part of a file must end between two tags.
            group_start: Any = np.int64(at)
            return bool(at == stop and pause(group_start, last, entity, state))
        # The line of the group code.
        start: Any = np.int64(at)
        code, at = code_at(data, at, size)
        if code < 0 or code > LAST_CODE:
            return False
        previous_code = last
        if code != 999:
            if previous_code >= 0 and g.IS_POINT[previous_code] and code != previous_code + 10:
                return False
            last = code
        low: Any = np.int64(at)
        value_type = TYPE[code]
        action = g.ACTION[state[s.CONTEXT], code]
        read, sure = 0.0, WRONG
        if action == g.NUMBER or (state[s.MODE] == s.IN_BLOCK and (code == 10 or code == 20)):
            read, at, sure = number(data, at, size)
        if sure == WRONG:
            at = end_of_line(data, np.uint64(low), size)
        high: Any = np.int64(at)
        if at < size and data[at] == 13:
            at += ONE
        if at < size and data[at] != 10:
            return False
        at += ONE
        if action == g.SKIPPED or code == 999:
            continue
        verdict = s.ON
        if code == 100 and state[s.MODE] < s.IN_ENTITY:
            state[s.OPEN_MARKS] += 1
        if sure != WRONG:
            verdict = take_decimal(code, previous_code, read, sure, low, high, tables, state)
        elif code == 0:
            if previous_code == 9 and state[s.SECTION] == w.HEADER:
                return False
            verdict = begin(data, start, low, high, tables, state)
            if verdict == s.DONE:
                return True
            state[s.CONTEXT] = context(state)
        elif action == g.BY_PLACE and _is_handle(code, state):
            verdict = take_handle(data, low, high, other_handles, state)
            if state[s.MODE] == s.IN_BLOCK and verdict == s.ON:
                verdict = _store_block_tag(code, data, low, high, block, spans, slots, state)
        elif action == g.TAKEN:
            verdict = take_tag(code, data, low, high, entity, spans, slots, state)
        elif (value_type != TEXT_VALUE and not valid(data, low, high, value_type)) or (
            state[s.SECTION] == w.HEADER
            and not _header_tag_valid(code, previous_code, data, low, high)
        ):
            return False
        elif (
            code < 1000
            and not g.MEANS[code]
            and code != 102
            and state[s.GROUP] != 2
            and state[s.MODE] != s.IN_LAYER
            and state[s.MODE] != s.IN_SECTION
        ) or state[s.SECTION] > w.ENTITIES:
            # Unused tags, and tags in other sections.
            continue
        elif code == 102 or code >= 1000 or state[s.GROUP] != 0:
            verdict = _skip_group_tag(code, data, low, high, entity, state)
            state[s.CONTEXT] = context(state)
        else:
            next_tag: Any = np.int64(at)
            verdict = _store_structure_tag(code, data, low, high, next_tag, tables, state)
        if verdict != s.ON:
            return False
    return False
