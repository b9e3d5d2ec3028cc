"""places: points that are one point, and lines that lie on each other between two of them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numba import njit


@njit(cache=True, error_model="numpy")
def _hashed(cx: int, cy: int, mask: int) -> Any:
    key = np.uint64(cx) * np.uint64(0x9E3779B97F4A7C15) ^ np.uint64(cy) * np.uint64(
        0xC2B2AE3D27D4EB4F
    )
    return np.int64((key ^ (key >> np.uint64(31))) & np.uint64(mask))


@njit(cache=True, error_model="numpy")
def placed(
    x: float, y: float, touch: float, place: Any, count: int, head: Any, onward: Any, mask: int
) -> int:
    """The number of the place at a point: one that is known, or ``count`` for a new one."""
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
                ox = place[at, 0] - x
                oy = place[at, 1] - y
                if ox * ox + oy * oy <= touch * touch:
                    known: int = at
                    return known
                at = onward[at]
    own = _hashed(cx, cy, mask)
    place[count, 0] = x
    place[count, 1] = y
    onward[count] = head[own]
    head[own] = count
    return count


@njit(cache=True, error_model="numpy")
def longer(column: Any) -> Any:
    """Return a column with room for twice as many rows."""
    more = np.empty((2 * len(column) + 16, *column.shape[1:]), column.dtype)
    more[: len(column)] = column
    return more


@njit(cache=True, error_model="numpy")
def alike(start: Any, end: Any, bent: Any, place: Any, touch: float, mask: int) -> Any:
    """The first of the lines between two places that each line lies on."""
    count = len(start)
    same = np.empty(count, np.int32)
    heads = np.full(mask + 1, -1, np.int32)
    behind = np.empty(count, np.int32)
    for p in range(count):
        a, b, bend = start[p], end[p], bent[p]
        if a > b:
            a, b, bend = b, a, -bend
        slot = _hashed(a, b, mask)
        at = heads[slot]
        same[p] = p
        chord = math.hypot(place[a, 0] - place[b, 0], place[a, 1] - place[b, 1])
        while at >= 0:
            other = bent[at] if start[at] == a else -bent[at]
            both = (start[at] == a and end[at] == b) or (start[at] == b and end[at] == a)
            if both and 0.5 * abs(other - bend) * chord <= 2.0 * touch:
                same[p] = at
                break
            at = behind[at]
        if same[p] == p:
            behind[p] = heads[slot]
            heads[slot] = p
    return same
