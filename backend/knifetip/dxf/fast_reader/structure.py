"""structure: kernels for group code 0, which starts a section, block, layer or entity."""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader import group_codes as g
from knifetip.dxf.fast_reader import keywords as w
from knifetip.dxf.fast_reader import state as s
from knifetip.dxf.fast_reader.group_values import name_at
from knifetip.dxf.fast_reader.keywords import is_word, word_at
from knifetip.dxf.scan_tables import ScanTables
from knifetip.kernels import (
    I64_1,
    U8_1,
    OutI32_2,
    OutI32_2F,
    OutI64_1,
    inline_kernel,
)


@inline_kernel
def context(state: I64_1) -> Any:
    """Return the index of the row of the table ``group_codes.ACTION`` that applies to the next tag.

    The table determines how the scan processes a tag.  It has one column per group code and one row
    per context; the context is, for example, the kind of the entity that is being read.
    """
    mode, kind = state[s.MODE], state[s.OPEN_KIND]
    if state[s.GROUP] != 0 or mode < s.IN_ENTITY:
        return g.ELSEWHERE
    if mode == s.IN_VERTEX:
        return g.ELSEWHERE if kind == f.OTHER else g.VERTEX
    return g.UNREAD if kind == f.OTHER else kind


@inline_kernel
def mark_unsupported(entity: OutI32_2F, state: OutI64_1) -> None:
    """Mark the entity whose tags are being read as unsupported, in the column ``UNSUPPORTED``."""
    entity[state[s.ROW], f.UNSUPPORTED] = 1
    state[s.OPEN_KIND] = f.OTHER
    state[s.CONTEXT] = context(state)


@inline_kernel
def _close(start: int, entity: OutI32_2F, state: OutI64_1) -> None:
    """Complete the entity whose tags were read, or the polyline whose vertex was read.

    ``start`` is the position of the byte after the last tag; it is stored as the end of the entity.
    An entity with missing tags is marked as unsupported in ``entity``.
    """
    row, kind, seen_tags, marks = (
        state[s.ROW],
        state[s.OPEN_KIND],
        state[s.SEEN],
        state[s.OPEN_MARKS],
    )
    if row < 0:
        return
    entity[row, f.END] = start
    if state[s.MODE] == s.IN_VERTEX:
        if kind != f.OTHER and ((seen_tags & g.POINT) != g.POINT or (marks > 0 and marks != 3)):
            mark_unsupported(entity, state)
        return
    entity[row, f.MARKS] = marks
    if kind in (f.OTHER, g.OF_WORDS):
        return
    if (seen_tags & g.NEEDED[kind]) != g.NEEDED[kind] or (
        marks > 0 and marks != (3 if kind == f.ARC else 2)
    ):
        mark_unsupported(entity, state)


@inline_kernel
def begin(
    data: U8_1,
    start: int,
    low: int,
    high: int,
    tables: ScanTables,
    state: OutI64_1,
) -> int:
    """Handle a tag of group code 0: complete the current entity and start the next record.

    Returns ``ON`` if the scan continues, ``DONE`` at the end of the file, or ``REFUSED`` if the
    fast reader cannot read the file.

    Parameters
    ----------
    data
        Bytes of the file.
    start
        Position of the line with the group code.
    low, high
        The value of the tag is ``data[low:high]``.
    tables, state
        The arrays into which the scan writes, and the state of the scan; both are updated.
    """
    if state[s.GROUP] == 1:
        return s.REFUSED
    _close(start, tables.entity, state)
    state[s.GROUP] = state[s.SEEN] = state[s.OPEN_MARKS] = state[s.IS_MTEXT] = 0
    mode, named = state[s.MODE], state[s.NAMED] != 0
    state[s.MODE] = s.NOTHING
    state[s.NAMED] = 0
    state[s.ROW] = -1
    state[s.OPEN_KIND] = f.OTHER
    if mode == s.IN_SECTION or (s.IN_TABLE <= mode <= s.IN_ROW and not named):
        return s.REFUSED
    section = state[s.SECTION]
    word = -1
    if section in (w.ENTITIES, w.BLOCKS):
        word = word_at(data, low, high, w.VERTEX, w.MTEXT)
    if state[s.CHAIN] >= 0 and word != w.VERTEX and word != w.SEQEND:
        return s.REFUSED
    if state[s.FOLLOWED] != 0 and word != w.ATTRIB and word != w.SEQEND:
        return s.REFUSED
    if word < 0:
        frame = word_at(data, low, high, w.SECTION, w.EOF)
        if frame >= 0:
            return _section_record(low, frame, state)
        if section < 0 or section == w.HEADER:
            return s.REFUSED
        if mode == s.IN_OBJECTS and not is_word(data, low, high, w.DICTIONARY):
            # The first object is the root dictionary.
            return s.REFUSED
        if section == w.TABLES:
            return _table_record(data, low, high, tables.layer, state)
        if section == w.BLOCKS:
            if is_word(data, low, high, w.BLOCK):
                return _open_block(tables, state)
            if is_word(data, low, high, w.ENDBLK):
                if state[s.INSIDE] < 0:
                    return s.REFUSED
                state[s.INSIDE] = -1
                return s.ON
    if section != w.ENTITIES and section != w.BLOCKS:
        return s.ON
    if section == w.BLOCKS and state[s.INSIDE] < 0:
        return s.REFUSED
    if word == w.VERTEX:
        return _open_vertex(tables, state)
    if word == w.SEQEND:
        if state[s.CHAIN] < 0 and state[s.FOLLOWED] == 0:
            return s.REFUSED
        state[s.CHAIN] = -1
        state[s.FOLLOWED] = 0
        return s.ON
    name = name_at(data, low, high, tables.spans, tables.slots, state)
    return _open_entity(start, word, name, tables, state)


@inline_kernel
def _open_block(tables: ScanTables, state: OutI64_1) -> int:
    """Add a row for a new block definition, whose name and layer are not read yet.

    Returns ``ON`` if the scan continues, ``REFUSED`` if the fast reader cannot read the file.
    """
    row = state[s.BLOCKS]
    if state[s.INSIDE] >= 0 or row == len(tables.block):
        return s.REFUSED
    tables.block[row, :] = 0
    tables.block[row, f.NAME] = tables.block[row, f.BLOCK_LAYER] = -1
    tables.base[row, 0] = tables.base[row, 1] = 0.0
    state[s.INSIDE] = row
    state[s.BLOCKS] = row + 1
    state[s.MODE] = s.IN_BLOCK
    return s.ON


@inline_kernel
def _open_vertex(tables: ScanTables, state: OutI64_1) -> int:
    """Add a row for a vertex of the polyline that is being read.

    Returns ``ON`` if the scan continues, ``REFUSED`` if no polyline is being read or the array of
    vertices is full.
    """
    chain, row = state[s.CHAIN], state[s.VERTICES]
    if chain < 0 or row == state[s.MOST_VERTICES]:
        return s.REFUSED
    tables.vertex[row, 2] = 0.0
    state[s.VERTICES] = row + 1
    tables.entity[chain, f.COUNT] += 1
    state[s.ROW] = chain
    state[s.MODE] = s.IN_VERTEX
    state[s.OPEN_KIND] = f.OTHER if tables.entity[chain, f.UNSUPPORTED] else f.POLYLINE
    return s.ON


@inline_kernel
def _open_entity(start: int, word: int, name: int, tables: ScanTables, state: OutI64_1) -> int:
    """Add a row for a new entity with default attributes.

    Returns ``ON`` if the scan continues, ``REFUSED`` if the fast reader cannot read the file.

    ``start``: position of the first group code of the entity.
    ``word``: number of the keyword for the kind of the entity, -1 if the kind is not a keyword.
    ``name``: index of the kind in the table of names of the file, -1 if it cannot be stored.
    """
    entity, value, row = tables.entity, tables.value, state[s.ENTITIES]
    if row == state[s.MOST_ENTITIES] or name < 0:
        return s.REFUSED
    state[s.ENTITIES] = row + 1
    state[s.ROW] = row
    state[s.MODE] = s.IN_ENTITY
    kind = g.KIND_OF[word] if word >= 0 else f.OTHER
    state[s.OPEN_KIND] = g.OF_WORDS if word >= w.ATTRIB else kind
    state[s.IS_MTEXT] = 1 if word == w.MTEXT else 0
    entity[row, :] = 0
    entity[row, f.KIND] = kind
    entity[row, f.WORD] = name
    entity[row, f.BLOCK] = state[s.INSIDE]
    entity[row, f.LAYER] = entity[row, f.LINETYPE] = entity[row, f.REFERENCE] = -1
    entity[row, f.TRUE_COLOUR] = -1
    entity[row, f.COLOUR] = 256
    entity[row, f.LINE_WIDTH] = -1
    entity[row, f.COLUMNS] = entity[row, f.ROWS] = 1
    entity[row, f.START] = start
    # Curves are read with ezdxf, one by one.
    entity[row, f.UNSUPPORTED] = 1 if word in (w.ELLIPSE, w.SPLINE) else 0
    for column in range(f.VALUES):
        if g.HAS[state[s.OPEN_KIND], column]:
            value[row, column] = np.nan
    if kind in (f.LWPOLYLINE, f.POLYLINE):
        entity[row, f.FIRST] = state[s.VERTICES]
    if kind == f.POLYLINE:
        state[s.CHAIN] = row
    return s.ON


@inline_kernel
def pause(start: int, last: int, entity: OutI32_2F, state: OutI64_1) -> bool:
    """Complete the last entity of a part of a file, at the end of the part.

    The next part is scanned separately.  Returns whether the file may be split at this position,
    which is False inside a polyline, for example.

    Parameters
    ----------
    start
        Position of the first byte after the part.
    last
        Group code of the last tag of the part.
    entity, state
        The entities and the state of the scan; both are updated.
    """
    if state[s.GROUP] == 1 or state[s.SECTION] != w.ENTITIES or g.IS_POINT[last]:
        return False
    _close(start, entity, state)
    return bool(state[s.CHAIN] < 0 and state[s.FOLLOWED] == 0 and state[s.MODE] != s.IN_SECTION)


@inline_kernel
def _table_record(data: U8_1, low: int, high: int, layer: OutI32_2, state: OutI64_1) -> int:
    """Start or end a table, or add a row for a layer, depending on the keyword ``data[low:high]``.

    Returns ``ON`` if the scan continues, ``REFUSED`` if the fast reader cannot read the file.
    """
    is_table = is_word(data, low, high, w.TABLE)
    if is_table == (state[s.TABLE] >= 0):
        return s.REFUSED
    if is_table:
        state[s.TABLE] = 0
        state[s.MODE] = s.IN_TABLE
        return s.ON
    word = word_at(data, low, high, w.ENDTAB, w.BLOCK_RECORD)
    if word == w.ENDTAB:
        state[s.TABLE] = -1
        return s.ON
    if word != state[s.TABLE]:
        return s.REFUSED
    if word == w.LAYER:
        row = state[s.LAYERS]
        if row == len(layer):
            return s.REFUSED
        layer[row, :] = -1
        layer[row, f.LAYER_COLOUR] = 7
        layer[row, f.LAYER_FLAGS] = 0
        layer[row, f.LAYER_PLOT] = 1
        state[s.LAYERS] = row + 1
    state[s.MODE] = (
        s.IN_LAYER if word == w.LAYER else s.IN_STYLE if word == w.DIMSTYLE else s.IN_ROW
    )
    return s.ON


@inline_kernel
def _section_record(low: int, word: int, state: OutI64_1) -> int:
    """Start a section, or end a section or the file.

    Returns ``ON`` if the scan continues, ``DONE`` at the end of the file, or ``REFUSED`` if the
    fast reader cannot read the file.

    ``low``: position of the keyword in the file.  If the keyword ends the section HEADER, the
    position is stored as the end of this section.
    ``word``: number of the keyword: ``SECTION``, ``ENDSEC`` or ``EOF``.
    ``state``: state of the scan, which is updated.
    """
    if state[s.INSIDE] >= 0 or state[s.TABLE] >= 0:
        return s.REFUSED
    if word == w.EOF:
        # A file without entities has nothing that must be read fast.
        whole = state[s.SECTION] < 0 and state[s.SECTIONS] & (1 << w.ENTITIES) != 0
        return s.DONE if whole and state[s.ENTITIES] > 0 else s.REFUSED
    if word == w.SECTION and state[s.SECTION] < 0:
        state[s.SECTION] = w.SECTION
        state[s.MODE] = s.IN_SECTION
        return s.ON
    if word == w.ENDSEC and state[s.SECTION] >= 0:
        if state[s.SECTION] == w.HEADER:
            state[s.HEADER_LAST] = low
        state[s.SECTION] = -1
        return s.ON
    return s.REFUSED
