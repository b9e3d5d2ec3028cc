"""meeting: which ends of edges stand on one place, and which stand near another one.

    ends -> the place of each, and the pairs of ends that are near but not on one place

A table of cells as large as the nearness; ends that are the same number for number, nearly all of
them, are compared once.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.geometry.sets import root, settle, unite
from knifetip.geometry.tolerance import JOIN
from knifetip.kernels import F64_2, U64, kernel

#: A point is compared with so many others in a cell at most: where there are more, nobody can say
#: what was meant to meet, and a drawing must not take forever.
CROWD: Final = 64


@dataclass(frozen=True, eq=False, slots=True)
class Meetings:
    """Where the 2k ends of k edges meet; end 2i is where edge i begins, 2i + 1 where it ends."""

    of: F64  #: (k, 2, 2) the ends that this is about (mm)
    place: (
        I64  #: (2k,) the place of each end: those within ``JOIN``, one after the other, share one
    )
    near: I64  #: (q, 2) pairs of ends on different places that are within the nearness


def meetings(ends: F64, near: float) -> Meetings:
    """Return where the ends of edges, (k, 2, 2) mm, meet, or are within ``near`` mm."""
    points = ends.reshape(-1, 2)
    if len(points) == 0:
        return Meetings(ends, np.zeros(0, np.int64), np.zeros((0, 2), np.int64))
    place, pairs = _meetings(points - points.min(axis=0), near, JOIN)
    return Meetings(ends, place, pairs)


@kernel
def _slot(x: int, y: int, mask: U64) -> Any:
    key = np.uint64(x) * np.uint64(0x9E3779B97F4A7C15)
    key = key ^ (key >> np.uint64(29)) ^ (np.uint64(y) * np.uint64(0xBF58476D1CE4E5B9))
    key = key ^ (key >> np.uint64(31))
    return key & mask


@kernel
def _meetings(points: F64_2, near: float, join: float) -> Any:
    count = len(points)
    size = 16
    while size < 2 * count:
        size *= 2
    mask = np.uint64(size - 1)
    head = np.full(size, -1, np.int64)
    cell = np.empty((count, 2), np.int64)
    after = np.full(count, -1, np.int64)
    parent = np.arange(count)
    pair = np.empty((64, 2), np.int64)
    pairs = 0
    for i in range(count):
        cx = int(points[i, 0] / near)
        cy = int(points[i, 1] / near)
        cell[i, 0] = cx
        cell[i, 1] = cy
        alike = False
        slot = _slot(cx, cy, mask)
        j = head[slot]
        seen = 0
        while j >= 0 and seen < CROWD:
            seen += 1
            if points[j, 0] == points[i, 0] and points[j, 1] == points[i, 1]:
                parent[i] = root(parent, j)
                alike = True
                break
            j = after[j]
        if alike:
            continue
        beside = 0
        for dx in range(-1, 2):
            for dy in range(-1, 2):
                j = head[_slot(cx + dx, cy + dy, mask)]
                seen = 0
                while j >= 0 and seen < CROWD:
                    seen += 1
                    if cell[j, 0] == cx + dx and cell[j, 1] == cy + dy:
                        x = points[i, 0] - points[j, 0]
                        y = points[i, 1] - points[j, 1]
                        apart = x * x + y * y
                        if apart <= join * join:
                            unite(parent, i, j)
                        elif apart <= near * near and beside < CROWD:
                            beside += 1
                            if pairs == len(pair):
                                more = np.empty((2 * pairs, 2), np.int64)
                                more[:pairs] = pair
                                pair = more
                            pair[pairs, 0] = j
                            pair[pairs, 1] = i
                            pairs += 1
                    j = after[j]
        after[i] = head[slot]
        head[slot] = i
    settle(parent)
    # Points that turned out to be on one place are no pair; of two places the nearest points are.
    kept = 0
    for k in range(pairs):
        if parent[pair[k, 0]] != parent[pair[k, 1]]:
            pair[kept] = pair[k]
            kept += 1
    return parent, pair[:kept].copy()
