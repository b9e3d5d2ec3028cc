"""end_points: find ends of edges that share a point, and pairs of ends that are near each other.

Ends are hashed into square cells as wide as the search distance.  Most ends share their point with
other ends; each such point is compared only once.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.geometry.tolerance import MEET
from knifetip.geometry.union_find import find, flatten, union
from knifetip.kernels import F64_2, U64, kernel

#: Largest number of points in a cell that a point is compared with: it bounds the time for crowded
#: drawings.
CROWD: Final = 64


@dataclass(frozen=True, eq=False, slots=True)
class EndPoints:
    """The points at which ends of k edges meet, and pairs of ends that are near each other.

    Two ends meet, and share one point, if they are at most ``MEET`` (0.0019 mm) apart, or if a
    chain of other ends with such distances connects them.  The ends of a pair have different points
    and are within the distance for which the pairs were searched.  Edge i has the ends 2i (start)
    and 2i + 1 (end).
    """

    ends: F64  #: (k, 2, 2) ends of the edges (mm)
    place: I64  #: (2k,) point of each end; ends in a chain of distances within ``MEET`` share one
    pairs: I64  #: (q, 2) pairs of ends at different points within the search distance


def find_end_points(ends: F64, max_distance: float) -> EndPoints:
    """Return the points that the ends of k edges share, and pairs of ends near each other.

    Parameters
    ----------
    ends : (k, 2, 2)
        Start and end points of the edges (mm).
    max_distance
        Largest distance between the two ends of a pair (mm).
    """
    points = ends.reshape(-1, 2)
    if len(points) == 0:
        return EndPoints(ends, np.zeros(0, np.int64), np.zeros((0, 2), np.int64))
    place, pairs = _find(points - points.min(axis=0), max_distance, MEET)
    return EndPoints(ends, place, pairs)


@kernel
def _slot(x: int, y: int, mask: U64) -> Any:
    key = np.uint64(x) * np.uint64(0x9E3779B97F4A7C15)
    key = key ^ (key >> np.uint64(29)) ^ (np.uint64(y) * np.uint64(0xBF58476D1CE4E5B9))
    key = key ^ (key >> np.uint64(31))
    return key & mask


@kernel
def _find(points: F64_2, max_distance: float, join: float) -> Any:
    count = len(points)
    size = 16
    while size < 2 * count:
        size *= 2
    mask = np.uint64(size - 1)
    head = np.full(size, -1, np.int64)
    cell = np.empty((count, 2), np.int64)
    next_point = np.full(count, -1, np.int64)
    parent = np.arange(count)
    pair = np.empty((64, 2), np.int64)
    pairs = 0
    for i in range(count):
        cx = int(points[i, 0] / max_distance)
        cy = int(points[i, 1] / max_distance)
        cell[i, 0] = cx
        cell[i, 1] = cy
        alike = False
        slot = _slot(cx, cy, mask)
        j = head[slot]
        seen = 0
        while j >= 0 and seen < CROWD:
            seen += 1
            if points[j, 0] == points[i, 0] and points[j, 1] == points[i, 1]:
                parent[i] = find(parent, j)
                alike = True
                break
            j = next_point[j]
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
                            union(parent, i, j)
                        elif apart <= max_distance * max_distance and beside < CROWD:
                            beside += 1
                            if pairs == len(pair):
                                more = np.empty((2 * pairs, 2), np.int64)
                                more[:pairs] = pair
                                pair = more
                            pair[pairs, 0] = j
                            pair[pairs, 1] = i
                            pairs += 1
                    j = next_point[j]
        next_point[i] = head[slot]
        head[slot] = i
    flatten(parent)
    # Drop pairs whose ends are at one point after all.
    kept = 0
    for k in range(pairs):
        if parent[pair[k, 0]] != parent[pair[k, 1]]:
            pair[kept] = pair[k]
            kept += 1
    return parent, pair[:kept].copy()
