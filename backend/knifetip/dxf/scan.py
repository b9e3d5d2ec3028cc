"""scan: the text of a plain DXF in one compiled pass, as columns of what is written there.

    bytes -> Scan: rows of entities, blocks and layers, vertices, and names by number

Plain is what every program writes that draws dielines: lines, arcs, circles, polylines and INSERTs,
each tag once and in its place, flat on the sheet.  Nothing is repaired or guessed here.  Where the
file as a whole is not plain, there is no Scan, and ``read`` leaves it to ezdxf; entities that are
not plain are marked as such, and ``single`` leaves them to ezdxf one by one.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.dxf import fields as f
from knifetip.dxf import state as s
from knifetip.dxf.tagging import scan_tags
from knifetip.dxf.values import MOST_NAMES
from knifetip.geometry.columns import F64, I32, I64

#: Numbers of more digits than the pass can read are read afterwards, so many of them.
_MOST_LEFT: Final = 100_000
#: No entity, and no vertex, is shorter than this (bytes), on average.
_SHORTEST: Final = 16
#: How much of a file is looked at for how long its entities are (bytes).
_SAMPLE: Final = 1 << 16
#: The group of the layer, which every entity has.
_LAYER: Final = re.compile(rb"\n *8\r?\n")


@dataclass(frozen=True, eq=False, slots=True)
class Scan:
    """What is written in a plain DXF, in the order of the file."""

    data: bytes
    entity: I32  #: (e, 21) columns ``KIND`` … ``ODD``, each in one piece
    value: F64  #: (e, 11) columns ``X`` … ``SPACE_Y``, file units and degrees; NaN where silent
    vertex: F64  #: (v, 3) x, y, bulge
    block: I32  #: (b, 5)
    base: F64  #: (b, 2) base points
    layer: I32  #: (l, 6)
    others: I64  #: handles of all that is no entity, by value
    names: tuple[bytes, ...]  #: what the numbers of names stand for
    header: tuple[int, int]  #: the bytes of section HEADER, (0, 0) without one
    markers: bool  #: entities have subclass markers


def scan(data: bytes) -> Scan | None:
    """Return what is written in a plain text DXF, None where it is not plain.

    Parameters
    ----------
    data
        The file without byte order mark and leading blank lines.
    """
    most = len(data) // _SHORTEST + 64
    expected = min(most, _expected(data))
    state = np.zeros(s.STATES, np.int64)
    found = _filled(data, expected, most, state)
    if found is None and state[s.ENTITIES] == expected < most:
        found = _filled(data, most, most, np.zeros_like(state))
    return found


def _expected(data: bytes) -> int:
    """Return how many entities a file hardly has more of, by a sample from its middle."""
    sample = data[len(data) // 2 :][:_SAMPLE]
    found = len(_LAYER.findall(sample)) + 8
    return 4096 + found * len(data) * 5 // (4 * len(sample) or 1)


def _filled(data: bytes, entities: int, most: int, state: I64) -> Scan | None:
    """Return what is written in a file of at most so many entities, and of ``most`` vertices."""
    # Pages of these that nothing is written to cost no memory.  Later whole columns are asked for.
    entity = np.empty((entities, f.WIDTH), np.int32, order="F")
    value = np.empty((entities, f.VALUES), order="F")
    vertex = np.empty((most, 3))
    block = np.empty((most // 4, 5), np.int32)
    base = np.empty((most // 4, 2))
    layer = np.empty((MOST_NAMES, 6), np.int32)
    spans = np.empty((MOST_NAMES, 2), np.int64)
    slots = np.full(1 << 16, -1, np.int32)
    left = np.empty((_MOST_LEFT, 5), np.int64)
    others = np.empty(most, np.int64)
    tables = (entity, value, vertex, block, base, layer, spans, slots, left, others)
    if not scan_tags(np.frombuffer(data, np.uint8), tables, state):
        return None
    if not _finish(data, (value, vertex, base), left[: state[s.UNSURES]]):
        return None
    entity = entity[: state[s.ENTITIES]]
    return Scan(
        data,
        entity,
        value[: state[s.ENTITIES]],
        vertex[: state[s.VERTICES]],
        block[: state[s.BLOCKS]],
        base[: state[s.BLOCKS]],
        layer[: state[s.LAYERS]],
        others[: state[s.OTHERS]],
        tuple(data[start:end] for start, end in spans[: state[s.NAMES]].tolist()),
        (int(state[s.HEADER_FIRST]), int(state[s.HEADER_LAST])),
        bool((entity[:, f.MARKS] > 0).any()),
    )


def _finish(data: bytes, tables: tuple[F64, F64, F64], left: I64) -> bool:
    """Read the numbers that the pass left over; return whether all are finite."""
    for which, row, column, start, end in left.tolist():
        read = float(data[start:end])
        if not np.isfinite(read):
            return False
        tables[which][row, column] = read
    return True
