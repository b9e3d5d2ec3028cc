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
from knifetip.kernels import F64_2, I64_1, U64, inline_kernel, kernel

#: Largest number of points in a cell that a point is compared with: it bounds the time for crowded
#: drawings.
CROWD: Final = 64
#: Binary logarithm of the number of cells, one above the other, that share a word of marks.
_RUN: Final = 6


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
    place, pairs = _find(np.ascontiguousarray(points), max_distance, MEET)
    return EndPoints(ends, place, pairs)


@kernel
def connected_edges(place: I64_1) -> Any:
    """Return the lowest of the edges with which each of k edges is connected, (k,).

    ``place`` (2k,) is the point of each end; edges are connected if ends of them share a point.
    """
    count = len(place) // 2
    edge_at = np.full(len(place), -1, np.int64)
    parent = np.arange(count)
    for end in range(len(place)):
        if edge_at[place[end]] < 0:
            edge_at[place[end]] = end // 2
        else:
            union(parent, edge_at[place[end]], end // 2)
    flatten(parent)
    return parent


@inline_kernel
def _slot(x: int, y: int, mask: U64) -> Any:
    """Return the slot of a hash table, 0 … ``mask``, for a column and a row of cells."""
    key = np.uint64(x) * np.uint64(0x9E3779B97F4A7C15)
    key = key ^ (key >> np.uint64(29)) ^ (np.uint64(y) * np.uint64(0xBF58476D1CE4E5B9))
    key = key ^ (key >> np.uint64(31))
    return key & mask


@inline_kernel
def _bit(y: int) -> Any:
    """Return the mask of the bit that marks a cell in row y; a word marks 64 cells of a column."""
    return np.uint64(1) << np.uint64(y & ((1 << _RUN) - 1))


@kernel
def _find(points: F64_2, max_distance: float, join: float) -> Any:
    """Return the point of each of n ends, (n,), and the pairs of ends near each other, (q, 2).

    ``points`` (n, 2) are the positions of the ends, ``max_distance`` is the largest distance of a
    pair, and ``join`` that of two ends that share a point (mm).
    """
    count = len(points)
    low_x, low_y = points[0, 0], points[0, 1]
    for i in range(1, count):
        low_x, low_y = min(low_x, points[i, 0]), min(low_y, points[i, 1])
    size = 64
    while size < 2 * count:
        size *= 2
    mask = np.uint64(size - 1)
    # A bit for each cell that has points.  Most cells have none, which costs no search then.
    marks, mark_mask = np.zeros(size // 8, np.uint64), np.uint64(size // 8 - 1)
    head = np.full(size, -1, np.int32)
    cell = np.empty((count, 2), np.int64)
    next_point = np.full(count, -1, np.int32)
    parent = np.arange(count)
    pair = np.empty((64, 2), np.int64)
    pairs = 0
    for i in range(count):
        cx = int((points[i, 0] - low_x) / max_distance)
        cy = int((points[i, 1] - low_y) / max_distance)
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
            run = (cy - 1) >> _RUN
            mark = marks[_slot(cx + dx, run, mark_mask)]
            for dy in range(-1, 2):
                if (cy + dy) >> _RUN != run:
                    run = (cy + dy) >> _RUN
                    mark = marks[_slot(cx + dx, run, mark_mask)]
                if mark & _bit(cy + dy) == 0:
                    continue
                j = head[_slot(cx + dx, cy + dy, mask)]
                seen = 0
                while j >= 0 and seen < CROWD:
                    seen += 1
                    if cell[j, 0] == cx + dx and cell[j, 1] == cy + dy:
                        x = (points[i, 0] - low_x) - (points[j, 0] - low_x)
                        y = (points[i, 1] - low_y) - (points[j, 1] - low_y)
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
        marks[_slot(cx, cy >> _RUN, mark_mask)] |= _bit(cy)
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
