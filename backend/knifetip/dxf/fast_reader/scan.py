"""scan: read all entities of a DXF file into arrays, in one compiled pass over its bytes.

Supported are lines, arcs, circles, polylines and INSERTs in the XY plane, with each tag once and in
its usual position; nothing is repaired or guessed.  For a file with an unsupported structure
``scan`` returns None, and ``dxf.read`` uses the ezdxf reader.  Unsupported entities in a supported
file are marked in the column ``UNSUPPORTED``; the fast reader then reads them with ezdxf.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import numpy as np

from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader import group_codes as g
from knifetip.dxf.fast_reader import keywords as w
from knifetip.dxf.fast_reader import state as s
from knifetip.dxf.fast_reader.tagging import scan_tags
from knifetip.dxf.scan_tables import ScanTables
from knifetip.geometry.columns import F64, I32, I64
from knifetip.geometry.parallel import core_count, parallel_map
from knifetip.kernels import I32_1, OutF64_2F, OutI32_2F, kernel

#: A part of a file may have one name for so many bytes, and at least so many names.
_BYTES_PER_NAME: Final = 24
_FEWEST_NAMES: Final = 20_000
#: Largest number of decimals that are left to ``float``.
_MOST_LEFT: Final = 100_000
#: Least average size of an entity or a vertex (bytes).
_SHORTEST: Final = 16
#: Size of the sample for the average size of entities (bytes).
_SAMPLE: Final = 1 << 16
#: Least size of a part (bytes).
_PART: Final = 1 << 21
#: Start of an entity with its group code; no value of a tag has this form.
_ENTITY: Final = re.compile(rb"(?<=\n) *0\r?\n(?:LINE|ARC|CIRCLE|LWPOLYLINE|POLYLINE|INSERT)\r?\n")
#: Group code of the layer; every entity has one.
_LAYER: Final = re.compile(rb"\n *8\r?\n")


@dataclass(frozen=True, eq=False, slots=True)
class Scan:
    """The content of a DXF file in arrays: entities, blocks, layers and names, in file order."""

    data: bytes
    entity: I32  #: (e, 22) columns ``KIND`` … ``UNSUPPORTED``, each contiguous
    value: F64  #: (e, 11) columns ``X`` … ``SPACE_Y``, file units and degrees; NaN if not given
    vertex: F64  #: (v, 3) x, y, bulge
    block: I32  #: (b, 5)
    base: F64  #: (b, 2) base points
    layer: I32  #: (l, 7)
    others: I64  #: values of the handles of objects that are not entities
    names: tuple[bytes, ...]  #: names by index
    header: tuple[int, int]  #: span of section HEADER, (0, 0) without one
    markers: bool  #: whether an entity has subclass markers


def scan(data: bytes) -> Scan | None:
    """Return the content of an ASCII DXF file in arrays; None if the file is not supported.

    A large file is split into one part per core, and the parts are scanned in parallel.

    Parameters
    ----------
    data
        Content of the file without byte order mark and leading blank lines.
    """
    largest = len(data) // _SHORTEST + 64
    expected = min(largest, _estimate_entity_count(data))
    if cuts := _split_positions(data):
        merged = _merge_parts(data, _scan_parts(data, [0, *cuts, len(data)], expected))
        if merged is not None:
            return merged
    # Scan the file as one part, and again if it has more entities than estimated.
    parts = _scan_parts(data, [0, len(data)], expected)
    if not parts.supported and parts.state[0, s.ENTITIES] == expected < largest:
        parts = _scan_parts(data, [0, len(data)], largest)
    return _merge_parts(data, parts)


def _estimate_entity_count(data: bytes) -> int:
    """Return an estimate of the number of entities of the file, from a sample of its bytes.

    The estimate is rarely too low.
    """
    sample = data[len(data) // 2 :][:_SAMPLE]
    entities = len(_LAYER.findall(sample)) + 8
    return 4096 + entities * len(data) * 5 // (4 * len(sample) or 1)


def _split_positions(data: bytes) -> list[int]:
    """Return the positions at which a large file is split, each at the start of an entity.

    The list is empty if the file is not split.
    """
    cores = min(core_count(), len(data) // _PART)
    first = data.find(b"ENTITIES")
    if cores < 2 or first < 0:
        return []
    even = [first + (len(data) - first) * core // cores for core in range(1, cores)]
    matches = [_ENTITY.search(data, at, at + _SAMPLE) for at in even]
    return sorted({one.start() for one in matches if one is not None})


@dataclass(frozen=True, eq=False, slots=True)
class _PartScans:
    """The content of k parts of a file that were scanned in parallel.

    Each part has its own range of rows in the arrays.
    """

    supported: bool  #: whether all parts are supported
    state: I64  #: (k, STATES) state at the end of each part
    entity: I32
    value: F64
    vertex: F64
    others: I64
    block: I32
    base: F64
    layer: I32
    spans: list[I64]  #: spans of the names in each part
    left: list[I64]
    first: list[tuple[int, int, int]]  #: first rows of each part in entity, vertex and others


def _scan_parts(data: bytes, bounds: list[int], entities: int) -> _PartScans:
    """Scan the parts of a file in parallel, and return their content.

    ``bounds``: positions at which the parts begin, and the end of the last part.
    ``entities``: number of entities for which memory is reserved, in all parts together.  The
    number is divided among the parts by their lengths; a part with more entities is not supported.
    """
    parts = list(pairwise(bounds))
    rows = [entities * (end - begin) // max(len(data), 1) for begin, end in parts]
    points = [(end - begin) // _SHORTEST + 64 for begin, end in parts]
    row, point = np.cumsum([0, *rows]).tolist(), np.cumsum([0, *points]).tolist()
    state = np.zeros((len(parts), s.STATES), np.int64)
    state[:, [s.SECTION, s.INSIDE, s.ROW, s.CHAIN, s.TABLE]] = -1
    state[1:, s.SECTION] = w.ENTITIES
    state[1:, s.SECTIONS] = 1 << w.ENTITIES
    state[:, s.CONTEXT] = g.ELSEWHERE
    state[:, s.ENTITIES], state[:, s.MOST_ENTITIES] = row[:-1], row[1:]
    for begin, end in ((s.VERTICES, s.MOST_VERTICES), (s.OTHERS, s.MOST_OTHERS)):
        state[:, begin], state[:, end] = point[:-1], point[1:]
    # Unused rows cost no memory.  Columns are contiguous because a column is read as a whole.
    # At least two rows: arrays of one row or none are C-contiguous too, another type for numba.
    capacity = max(row[-1], 2)
    entity = np.empty((capacity, f.WIDTH), np.int32, order="F")
    value = np.empty((capacity, f.VALUES), order="F")
    vertex, other_handles = np.empty((point[-1], 3)), np.empty(point[-1], np.int64)
    block, base = np.empty((points[0] // 4, 5), np.int32), np.empty((points[0] // 4, 2))
    names = [(end - begin) // _BYTES_PER_NAME + _FEWEST_NAMES for begin, end in parts]
    layer = np.empty((names[0], f.LAYER_WIDTH), np.int32)
    spans = [np.empty((count, 2), np.int64) for count in names]
    unsure = [np.empty((_MOST_LEFT, 5), np.int64) for _ in parts]
    text = np.frombuffer(data, np.uint8)

    def scan_part(part: int) -> bool:
        # Only the first part has blocks and layers.
        size = None if part == 0 else 0
        # At most half of the slots are used, so that few names share one.
        slots = np.full(1 << (2 * names[part] - 1).bit_length(), -1, np.int32)
        tables = ScanTables(
            entity,
            value,
            vertex,
            block[:size],
            base[:size],
            layer[:size],
            spans[part],
            slots,
            unsure[part],
            other_handles,
        )
        return bool(scan_tags(text, *parts[part], tables, state[part]))

    supported = all(parallel_map(scan_part, range(len(parts))))
    tables = (value, vertex, base)
    supported = supported and all(
        _finish(data, tables, unsure_of_part[: end[s.UNSURES]])
        for unsure_of_part, end in zip(unsure, state, strict=True)
    )
    spans = [
        unsure_of_part[: end[s.NAMES]] for unsure_of_part, end in zip(spans, state, strict=True)
    ]
    first = list(zip(row, point, point, strict=False))[: len(parts)]
    return _PartScans(
        supported,
        state,
        entity,
        value,
        vertex,
        other_handles,
        block,
        base,
        layer,
        spans,
        unsure,
        first,
    )


def _merge_parts(data: bytes, parts: _PartScans) -> Scan | None:
    """Return the content of a file whose parts were scanned separately.

    The result is None if a part of the file is not supported.
    """
    sections = parts.state[:, s.SECTIONS].copy()
    sections[1:] &= ~(1 << w.ENTITIES)
    if not parts.supported or (np.cumsum(sections) != np.bitwise_or.accumulate(sections)).any():
        return None
    number_of: dict[bytes, int] = {}
    rows = points = handles = 0
    for state, spans, (row, point, other) in zip(
        parts.state, parts.spans, parts.first, strict=True
    ):
        names = [data[begin:end] for begin, end in spans.tolist()]
        numbers = [number_of.setdefault(name, len(number_of)) for name in names]
        added = int(state[s.ENTITIES]) - row
        if row:
            # Move the rows of this part behind the rows of the parts before.
            new_numbers = np.array([*numbers, -1], np.int32)
            _move_up(parts.entity, parts.value, row, rows, added, new_numbers, point - points)
        corners, named = int(state[s.VERTICES]) - point, int(state[s.OTHERS]) - other
        parts.vertex[points : points + corners] = parts.vertex[point : point + corners]
        parts.others[handles : handles + named] = parts.others[other : other + named]
        rows, points, handles = rows + added, points + corners, handles + named
    entity = parts.entity[:rows]
    state = parts.state[0]
    return Scan(
        data,
        entity,
        parts.value[:rows],
        parts.vertex[:points],
        parts.block[: state[s.BLOCKS]],
        parts.base[: state[s.BLOCKS]],
        parts.layer[: state[s.LAYERS]],
        parts.others[:handles],
        tuple(number_of),
        (int(state[s.HEADER_FIRST]), int(state[s.HEADER_LAST])),
        bool((entity[:, f.MARKS] > 0).any()),
    )


@kernel
def _move_up(
    entity: OutI32_2F, value: OutF64_2F, row: int, to: int, count: int, numbers: I32_1, gap: int
) -> None:
    """Move the rows of one part of a file directly after the rows of the parts before it.

    ``entity``, ``value``: arrays in which the rows are moved.
    ``row``, ``to``, ``count``: the ``count`` rows from index ``row`` on are moved to the lower
    index ``to``.
    ``numbers``: new index of each name; the names in the moved rows are renumbered.
    ``gap``: subtracted from the indices of vertices in the moved rows.
    """
    for column in range(f.WIDTH):
        named = column in (f.WORD, f.LAYER, f.LINETYPE, f.REFERENCE)
        for i in range(count):
            one = entity[row + i, column]
            entity[to + i, column] = numbers[one] if named else one
    for column in range(f.VALUES):
        for i in range(count):
            value[to + i, column] = value[row + i, column]
    for i in range(to, to + count):
        if entity[i, f.KIND] == f.LWPOLYLINE or entity[i, f.KIND] == f.POLYLINE:
            entity[i, f.FIRST] -= gap


def _finish(data: bytes, tables: tuple[F64, F64, F64], unsure: I64) -> bool:
    """Parse with ``float`` the decimal numbers that the scan could not round with certainty.

    The numbers are written into ``tables`` (values, vertices, base points).  Each row of ``unsure``
    contains the index of the table, row, column, and the start and end of the number in ``data``.
    Returns whether all these numbers are finite.
    """
    for table, row, column, start, end in unsure.tolist():
        read = float(data[start:end])
        if not np.isfinite(read):
            return False
        tables[table][row, column] = read
    return True
