"""Find the pairs of points that are near each other, with a hash table of square cells."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from knifetip.kernels import F64_2, I32_1, I64_1, OutI64_1, OutU8_1, inline_kernel, kernel

#: Most cells per axis that a cell may be wider than the distance of a pair.  In wider cells, fewer
#: points have their neighbours in other cells.
_WIDEST = 16.0


class PointGrid(NamedTuple):
    """Points in a hash table of square cells."""

    points: F64_2  #: (m, 2) mm
    first: I32_1  #: first point of each bucket, -1 for none; their number is a power of two
    following: I32_1  #: (m,) next point of the same bucket, -1 for none
    low_x: float  #: mm, lower left corner of the cells
    low_y: float
    distance: float  #: mm, greatest distance of a pair
    width: float  #: mm, width of the cells


@inline_kernel
def _bucket(column: int, row: int, mask: int) -> int:
    mixed = (column * 73856093) ^ (row * 19349663)
    mixed = (mixed ^ (mixed >> 15)) * 0x2C1B3C6D
    mixed = (mixed ^ (mixed >> 12)) * 0x297A2D39
    return (mixed ^ (mixed >> 15)) & mask


@kernel
def pair_distances(points: F64_2, one: I64_1, others: F64_2, other: I64_1) -> Any:
    """Return the distances between the points of k pairs, (k,) mm.

    ``one`` and ``other`` are the indices of the two points in ``points``, (n, 2) mm, and in
    ``others``, (m, 2) mm, (k,) each.
    """
    distance = np.empty(len(one))
    for k in range(len(one)):
        x = points[one[k], 0] - others[other[k], 0]
        y = points[one[k], 1] - others[other[k], 1]
        distance[k] = math.hypot(x, y)
    return distance


@kernel
def list_points(points: F64_2, distance: float) -> Any:
    """Return a ``PointGrid`` of m points, (m, 2) mm, for pairs at most ``distance`` mm apart.

    There is at least one point.
    """
    low_x, low_y = math.inf, math.inf
    high_x, high_y = -math.inf, -math.inf
    for j in range(len(points)):
        low_x, low_y = min(low_x, points[j, 0]), min(low_y, points[j, 1])
        high_x, high_y = max(high_x, points[j, 0]), max(high_y, points[j, 1])
    spacing = 0.5 * math.sqrt((high_x - low_x) * (high_y - low_y) / len(points))
    width = max(distance, min(_WIDEST * distance, spacing))
    low_x -= distance
    low_y -= distance
    buckets = 64
    while buckets < len(points):
        buckets *= 2
    first = np.full(buckets, -1, np.int32)
    following = np.empty(len(points), np.int32)
    # The last point first, so that each bucket lists its points in ascending order.
    for j in range(len(points) - 1, -1, -1):
        column = math.floor((points[j, 0] - low_x) / width)
        row = math.floor((points[j, 1] - low_y) / width)
        bucket = _bucket(column, row, buckets - 1)
        following[j] = first[bucket]
        first[bucket] = j
    return PointGrid(points, first, following, low_x, low_y, distance, width)


@kernel
def near_points(points: F64_2, grid: PointGrid, most: int) -> Any:
    """Return the pairs of a point of ``points`` and a point of a grid near each other.

    Parameters
    ----------
    points : (n, 2) mm
        The first points of the pairs.
    grid
        The second points, and the greatest distance between the two points of a pair.
    most
        Number of comparisons of two points after which the search is given up.

    Returns
    -------
    The indices into ``points`` and into the points of the grid, (k,) each, and whether the search
    was complete.  The pairs are sorted by the column in which the second point lies, relative to
    the column of the first one, then by first point, row and second point.  Columns and rows are
    those of a grid of square cells as wide as the greatest distance.
    """
    room = len(points) + len(grid.points)
    while True:
        one, other = np.empty(room, np.int64), np.empty(room, np.int64)
        rank = np.empty(room, np.uint8)
        used, complete = _search(points, grid, most, one, other, rank)
        if used <= room:
            break
        room = used
    if not complete:
        return one[:0], other[:0], False
    # The pairs of the column to the left come first, then those of the same column.
    place = np.zeros(3, np.int64)
    for k in range(used):
        if rank[k] < 6:
            place[rank[k] // 3 + 1] += 1
    if place[1] == 0 and place[2] == used:
        return one[:used].copy(), other[:used].copy(), True
    place[2] += place[1]
    sorted_one, sorted_other = np.empty(used, np.int64), np.empty(used, np.int64)
    for k in range(used):
        slot = place[rank[k] // 3]
        sorted_one[slot], sorted_other[slot] = one[k], other[k]
        place[rank[k] // 3] += 1
    return sorted_one, sorted_other, True


@kernel(allocates=False)
def _search(
    points: F64_2, grid: PointGrid, most: int, pair_a: OutI64_1, pair_b: OutI64_1, rank: OutU8_1
) -> Any:
    """Write the near pairs to ``pair_a`` and ``pair_b``, and the cell of the second point of each,
    relative to the first one, to ``rank``.

    The cells are numbered by columns, from 0 at the lower left to 8 at the upper right.  Returns
    the number of pairs, and whether at most ``most`` points were compared.  If there are more pairs
    than the arrays have entries, the others are counted only.
    """
    distance, width = grid.distance, grid.width
    low_x, low_y, mask = grid.low_x, grid.low_y, len(grid.first) - 1
    used, compared = 0, 0
    for i in range(len(points)):
        x, y = points[i, 0], points[i, 1]
        begin = used
        column_0 = math.floor((x - distance - low_x) / width)
        column_1 = math.floor((x + distance - low_x) / width)
        row_0 = math.floor((y - distance - low_y) / width)
        row_1 = math.floor((y + distance - low_y) / width)
        own_column, own_row = math.floor((x - low_x) / width), math.floor((y - low_y) / width)
        for column in range(column_0, column_1 + 1):
            for row in range(row_0, row_1 + 1):
                at_home = column == own_column and row == own_row
                j = grid.first[_bucket(column, row, mask)]
                while j >= 0:
                    compared += 1
                    here = _cell_beside(grid, x, y, column, row, at_home, j)
                    if here >= 0:
                        if used < len(pair_a):
                            slot = used
                            while slot > begin and (
                                rank[slot - 1] > here
                                or (rank[slot - 1] == here and pair_b[slot - 1] > j)
                            ):
                                rank[slot], pair_b[slot] = rank[slot - 1], pair_b[slot - 1]
                                slot -= 1
                            rank[slot], pair_b[slot] = here, j
                            pair_a[used] = i
                        used += 1
                    j = grid.following[j]
        if compared > most:
            return 0, False
    return used, True


@inline_kernel
def _cell_beside(
    grid: PointGrid, x: float, y: float, column: int, row: int, at_home: bool, j: int
) -> int:
    """Return the number of the cell of point j relative to that of the point (x, y), 0 … 8.

    ``at_home`` is whether the point (x, y) is in the wide cell ``column``, ``row``.  Returns -1 if
    the points are farther apart than the greatest distance of a pair, or if point j is not in the
    wide cell, because another cell may share the bucket.
    """
    other_x, other_y = grid.points[j, 0], grid.points[j, 1]
    dx, dy = x - other_x, y - other_y
    if abs(dx) > grid.distance or abs(dy) > grid.distance:
        return -1
    if dx == 0.0 and dy == 0.0:
        return 4 if at_home else -1
    if math.hypot(dx, dy) > grid.distance:
        return -1
    right, above = other_x - grid.low_x, other_y - grid.low_y
    if math.floor(right / grid.width) != column or math.floor(above / grid.width) != row:
        return -1
    across = math.floor(right / grid.distance) - math.floor((x - grid.low_x) / grid.distance)
    up = math.floor(above / grid.distance) - math.floor((y - grid.low_y) / grid.distance)
    return 3 * across + up + 4 if abs(across) <= 1 and abs(up) <= 1 else -1
