"""scan: the text of a plain DXF in one compiled pass, as columns of what is written there.

    bytes -> Scan: rows of entities, blocks and layers, vertices, and names by number

Plain is what every program writes that draws dielines: lines, arcs, circles, polylines and INSERTs,
each tag once and in its place, flat on the sheet.  Nothing is repaired or guessed here.  Where the
file as a whole is not plain, there is no Scan, and ``read`` leaves it to ezdxf; entities that are
not plain are marked as such, and ``single`` leaves them to ezdxf one by one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.dxf import tagging as t
from knifetip.geometry.columns import F64, I32, I64

#: Numbers of more digits than the pass can read are read afterwards, so many of them.
_MOST_LEFT: Final = 100_000
#: No entity is shorter than this (bytes), on average.
_SHORTEST: Final = 16


@dataclass(frozen=True, eq=False, slots=True)
class Scan:
    """What is written in a plain DXF, in the order of the file."""

    data: bytes
    entity: I32  #: (e, 21) columns ``KIND`` … ``ODD``
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
    most = len(data) // _SHORTEST + 64
    # Pages of these that nothing is written to cost no memory.
    entity = np.empty((most, t.WIDTH), np.int32)
    value = np.empty((most, t.VALUES))
    vertex = np.empty((most, 3))
    block = np.empty((most // 4, 5), np.int32)
    base = np.empty((most // 4, 2))
    layer = np.empty((t.MOST_NAMES, 6), np.int32)
    spans = np.empty((t.MOST_NAMES, 2), np.int64)
    slots = np.full(1 << 16, -1, np.int32)
    left = np.empty((_MOST_LEFT, 5), np.int64)
    state = np.zeros(t.STATES, np.int64)
    tables = (entity, value, vertex, block, base, layer, spans, slots, left)
    if not t.scan_tags(np.frombuffer(data, np.uint8), tables, state):
        return None
    if not _finish(data, (value, vertex, base), left[: state[t.UNSURES]]):
        return None
    entities = entity[: state[t.ENTITIES]]
    return Scan(
        data,
        entities,
        value[: state[t.ENTITIES]],
        vertex[: state[t.VERTICES]],
        block[: state[t.BLOCKS]],
        base[: state[t.BLOCKS]],
        layer[: state[t.LAYERS]],
        tuple(data[start:end] for start, end in spans[: state[t.NAMES]].tolist()),
        (int(state[t.HEADER_FIRST]), int(state[t.HEADER_LAST])),
        bool((entities[:, t.MARKS] > 0).any()),
    )


def _finish(data: bytes, tables: tuple[F64, F64, F64], left: I64) -> bool:
    """Read the numbers that the pass left over; return whether all are finite."""
    for which, row, column, start, end in left.tolist():
        read = float(data[start:end])
        if not np.isfinite(read):
            return False
        tables[which][row, column] = read
    return True
