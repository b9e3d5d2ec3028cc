"""places: points that are one point, and lines that lie on each other between two of them.

A point is of the nearest place within reach, and makes one where there is none.  Places made later
may be nearer to it: two lines that end at one point must not end at two places for that, so each
point stays with the place that it was of first.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I32
from knifetip.kernels import (
    F64_1,
    F64_2,
    F64_3,
    I32_1,
    OutBool_1,
    OutF64_2,
    OutI32_1,
    inline_kernel,
    kernel,
)

#: Places are looked for in cells so many times as wide as what touches.
_CELL: Final = 16.0
#: What ``_nearest`` says beside numbers of places.
_NONE: Final = -1
_SEVERAL: Final = -2
#: Points are one point that differ by less than this part of what touches.
_FINE: Final = 1000.0


class Places(NamedTuple):
    """q places, found again by where they are."""

    point: OutF64_2  #: (≥ q, 2)
    known: int  #: q
    onward: OutI32_1  #: (≥ q,) the next place whose cell has the same number
    head: OutI32_1  #: (2^k,) of each number the last place


def placed_ends(ends: F64, touch: float) -> tuple[Places, I32]:
    """Return the places of the ends of n edges, (n, 2, 2), and the number of each, (2n,)."""
    count = len(ends)
    size = 1 << (4 * count + 15).bit_length()
    spots = Places(
        np.empty((2 * count, 2)), 0, np.empty(2 * count, np.int32), np.full(size, -1, np.int32)
    )
    node = np.empty(2 * count, np.int32)
    several = np.zeros(2 * count, np.bool_)
    found, near = _place(ends, touch, spots, node, several)
    if near:
        _settle(ends, touch, np.flatnonzero(several).astype(np.int32), node)
    return spots._replace(known=found), node


def roomy(spots: Places, more: int) -> Places:
    """Return the same places with room for so many more."""
    point, onward = np.empty((spots.known + more, 2)), np.empty(spots.known + more, np.int32)
    point[: spots.known] = spots.point[: spots.known]
    onward[: spots.known] = spots.onward[: spots.known]
    return Places(point, spots.known, onward, spots.head)


@kernel(allocates=False)
def _place(ends: F64_3, touch: float, spots: Places, node: OutI32_1, several: OutBool_1) -> Any:
    """Write the place of each end, and whether it had several near; return how many there are."""
    count = near = 0
    for half in range(len(node)):
        x, y = ends[half // 2, half % 2, 0], ends[half // 2, half % 2, 1]
        at = _nearest(x, y, touch, spots.point, spots.head, spots.onward)
        if at == _NONE:
            at = count
            _add(x, y, touch, spots.point, count, spots.head, spots.onward)
            count += 1
        elif at < 0:
            at = _SEVERAL - at
            several[half] = True
            near += 1
        node[half] = at
    return count, near


@kernel
def _slot(ends: F64_3, half: int, fine: float, known: I32_1) -> Any:
    """Return where an end at the point of this one is kept, or may be."""
    mask = len(known) - 1
    x, y = _rounded(ends, half, fine)
    slot = _hashed(x, y, mask)
    while known[slot] >= 0 and _rounded(ends, known[slot], fine) != (x, y):
        slot = (slot + 1) & mask
    return slot


@kernel
def _rounded(ends: F64_3, half: int, fine: float) -> Any:
    return (
        np.int64(np.rint(ends[half // 2, half % 2, 0] * fine)),
        np.int64(np.rint(ends[half // 2, half % 2, 1] * fine)),
    )


@kernel(allocates=False)
def _hashed(cx: int, cy: int, mask: int) -> Any:
    key = np.uint64(cx) * np.uint64(0x9E3779B97F4A7C15) ^ np.uint64(cy) * np.uint64(
        0xC2B2AE3D27D4EB4F
    )
    return np.int64((key ^ (key >> np.uint64(31))) & np.uint64(mask))


@inline_kernel
def placed(
    x: float, y: float, touch: float, point: OutF64_2, count: int, head: OutI32_1, onward: OutI32_1
) -> int:
    """The number of the place at a point: one that is known, or ``count`` for a new one."""
    at = _nearest(x, y, touch, point, head, onward)
    if at == _NONE:
        _add(x, y, touch, point, count, head, onward)
        return count
    return at if at >= 0 else _SEVERAL - at


@inline_kernel
def _nearest(x: float, y: float, touch: float, point: F64_2, head: I32_1, onward: I32_1) -> int:
    """Return the nearest place that touches a point, as one number: a second takes time.

    ``_NONE`` where there is none; ``_SEVERAL`` less the nearest where several do, and none of them
    is at the very point.
    """
    mask = len(head) - 1
    fx, fy = x / (_CELL * touch), y / (_CELL * touch)
    cx, cy = math.floor(fx), math.floor(fy)
    x0 = -1 if fx - cx <= 1.0 / _CELL else 0
    x1 = 1 if fx - cx >= 1.0 - 1.0 / _CELL else 0
    y0 = -1 if fy - cy <= 1.0 / _CELL else 0
    y1 = 1 if fy - cy >= 1.0 - 1.0 / _CELL else 0
    nearest, best, many, exact = _NONE, touch * touch, False, False
    for dx in range(x0, x1 + 1):
        for dy in range(y0, y1 + 1):
            at = head[_hashed(cx + dx, cy + dy, mask)]
            while at >= 0:
                ox = point[at, 0] - x
                oy = point[at, 1] - y
                away = ox * ox + oy * oy
                if away <= touch * touch:
                    many = many or nearest != _NONE
                    if away <= best:
                        nearest, best = at, away
                    if away == 0.0:
                        exact = True
                        break
                at = onward[at]
            if exact:
                break
        if exact:
            break
    return _SEVERAL - nearest if many and not exact else nearest


@inline_kernel
def _add(
    x: float, y: float, touch: float, point: OutF64_2, number: int, head: OutI32_1, onward: OutI32_1
) -> None:
    """Keep a new place."""
    fx, fy = x / (_CELL * touch), y / (_CELL * touch)
    own = _hashed(math.floor(fx), math.floor(fy), len(head) - 1)
    point[number, 0], point[number, 1] = x, y
    onward[number] = head[own]
    head[own] = number


@kernel
def alike(start: I32_1, end: I32_1, bent: F64_1, point: F64_2, touch: float) -> Any:
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


# With its types said: it is needed by few drawings, and nobody shall wait for it then.
@kernel
def _settle(ends: F64_3, touch: float, several: I32_1, node: OutI32_1) -> None:
    """Give all ends at one point, of those that had several places near, the place of the first."""
    mask = 1
    while mask < 4 * len(several):
        mask *= 2
    mask -= 1
    # What is rounded otherwise is still one point.
    fine = _FINE / touch
    known = np.full(mask + 1, -1, np.int32)
    place = np.full(mask + 1, -1, np.int32)
    for half in several:
        known[_slot(ends, half, fine, known)] = half
    for half in range(len(node)):
        slot = _slot(ends, half, fine, known)
        if known[slot] < 0:
            continue
        if place[slot] < 0:
            place[slot] = node[half]
        node[half] = place[slot]
