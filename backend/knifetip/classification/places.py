"""places: points that are one point, and lines that lie on each other between two of them."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numba import njit

from knifetip.geometry.columns import F64, I32


class Places(NamedTuple):
    """q places, found again by where they are."""

    point: F64  #: (≥ q, 2)
    known: int  #: q
    onward: I32  #: (≥ q,) the next place whose cell has the same number
    head: I32  #: (2^k,) of each number the last place


def placed_ends(ends: F64, touch: float) -> tuple[Places, I32]:
    """Return the places of the ends of n edges, (n, 2, 2), and the number of each, (2n,)."""
    count = len(ends)
    size = 1 << (4 * count + 15).bit_length()
    spots = Places(
        np.empty((2 * count, 2)), 0, np.empty(2 * count, np.int32), np.full(size, -1, np.int32)
    )
    node = np.empty(2 * count, np.int32)
    found = _place(ends, touch, spots, node)
    return spots._replace(known=found), node


def roomy(spots: Places, more: int) -> Places:
    """Return the same places with room for so many more."""
    point, onward = np.empty((spots.known + more, 2)), np.empty(spots.known + more, np.int32)
    point[: spots.known] = spots.point[: spots.known]
    onward[: spots.known] = spots.onward[: spots.known]
    return Places(point, spots.known, onward, spots.head)


@njit(cache=True, error_model="numpy", nogil=True)
def _place(ends: Any, touch: float, spots: Places, node: Any) -> int:
    count = 0
    for half in range(len(node)):
        x, y = ends[half // 2, half % 2, 0], ends[half // 2, half % 2, 1]
        at = placed(x, y, touch, spots.point, count, spots.head, spots.onward)
        node[half] = at
        if at == count:
            count += 1
    return count


@njit(cache=True, error_model="numpy")
def _hashed(cx: int, cy: int, mask: int) -> Any:
    key = np.uint64(cx) * np.uint64(0x9E3779B97F4A7C15) ^ np.uint64(cy) * np.uint64(
        0xC2B2AE3D27D4EB4F
    )
    return np.int64((key ^ (key >> np.uint64(31))) & np.uint64(mask))


@njit(cache=True, error_model="numpy", forceinline=True)
def placed(x: float, y: float, touch: float, point: Any, count: int, head: Any, onward: Any) -> int:
    """The number of the place at a point: one that is known, or ``count`` for a new one."""
    mask = len(head) - 1
    cell = 16.0 * touch
    fx, fy = x / cell, y / cell
    cx, cy = math.floor(fx), math.floor(fy)
    edge = 1.0 / 16.0
    x0 = -1 if fx - cx <= edge else 0
    x1 = 1 if fx - cx >= 1.0 - edge else 0
    y0 = -1 if fy - cy <= edge else 0
    y1 = 1 if fy - cy >= 1.0 - edge else 0
    for dx in range(x0, x1 + 1):
        for dy in range(y0, y1 + 1):
            at = head[_hashed(cx + dx, cy + dy, mask)]
            while at >= 0:
                ox = point[at, 0] - x
                oy = point[at, 1] - y
                if ox * ox + oy * oy <= touch * touch:
                    known: int = at
                    return known
                at = onward[at]
    own = _hashed(cx, cy, mask)
    point[count, 0] = x
    point[count, 1] = y
    onward[count] = head[own]
    head[own] = count
    return count


@njit(cache=True, error_model="numpy")
def longer(column: Any) -> Any:
    """Return a column with room for twice as many rows."""
    more = np.empty((2 * len(column) + 16, *column.shape[1:]), column.dtype)
    more[: len(column)] = column
    return more


@njit(cache=True, error_model="numpy", nogil=True)
def alike(start: Any, end: Any, bent: Any, point: Any, touch: float) -> Any:
    """The first of the lines between two places that each line lies on."""
    count = len(start)
    same = np.empty(count, np.int32)
    mask = 1
    while mask < 2 * count:
        mask *= 2
    heads = np.full(mask, -1, np.int32)
    mask -= 1
    behind = np.empty(count, np.int32)
    for p in range(count):
        a, b, bend = start[p], end[p], bent[p]
        if a > b:
            a, b, bend = b, a, -bend
        slot = _hashed(a, b, mask)
        at = heads[slot]
        same[p] = p
        while at >= 0:
            if (start[at] == a and end[at] == b) or (start[at] == b and end[at] == a):
                other = bent[at] if start[at] == a else -bent[at]
                chord = math.hypot(point[a, 0] - point[b, 0], point[a, 1] - point[b, 1])
                if 0.5 * abs(other - bend) * chord <= 2.0 * touch:
                    same[p] = at
                    break
            at = behind[at]
        if same[p] == p:
            behind[p] = heads[slot]
            heads[slot] = p
    return same
