"""Find the pairs of points that are near each other, with a hash table of square cells."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from knifetip.kernels import F64_2, OutI64_1, inline_kernel, kernel

#: Most cells per axis that a cell may be wider than the distance of a pair.  In wider cells, fewer
#: points have their neighbours in other cells.
_WIDEST = 16.0


@inline_kernel
def _bucket(column: int, row: int, mask: int) -> int:
    mixed = column * 0x9E3779B1 + row * 0x85EBCA77
    return (mixed ^ (mixed >> 17)) & mask


@kernel
def _lengthened(values: OutI64_1, used: int) -> Any:
    longer = np.empty(2 * len(values), np.int64)
    for k in range(used):
        longer[k] = values[k]
    return longer


@kernel
def near_points(points: F64_2, others: F64_2, distance: float, most: int) -> Any:
    """Return the pairs of a point of ``points`` and a point of ``others`` near each other.

    Parameters
    ----------
    points, others : (n, 2) and (m, 2) mm
        The points of which pairs are formed; n and m are greater than 0.
    distance : mm
        Greatest distance between the two points of a pair.
    most
        Number of comparisons of two points after which the search is given up.

    Returns
    -------
    The indices into ``points`` and into ``others``, (k,) each, and whether the search was complete.
    The pairs are sorted by the column in which the second point lies, relative to the column of the
    first one, then by first point, row and second point.  Columns and rows are those of a grid of
    square cells as wide as ``distance``.
    """
    low_x, low_y = math.inf, math.inf
    high_x, high_y = -math.inf, -math.inf
    for j in range(len(others)):
        low_x, low_y = min(low_x, others[j, 0]), min(low_y, others[j, 1])
        high_x, high_y = max(high_x, others[j, 0]), max(high_y, others[j, 1])
    spacing = 0.5 * math.sqrt((high_x - low_x) * (high_y - low_y) / len(others))
    width = max(distance, min(_WIDEST * distance, spacing))
    for i in range(len(points)):
        low_x, low_y = min(low_x, points[i, 0]), min(low_y, points[i, 1])
    low_x -= distance
    low_y -= distance
    buckets = 64
    while buckets < len(others):
        buckets *= 2
    first = np.full(buckets, -1, np.int32)
    following = np.empty(len(others), np.int32)
    # The last point first, so that each bucket lists its points in ascending order.
    for j in range(len(others) - 1, -1, -1):
        column = math.floor((others[j, 0] - low_x) / width)
        row = math.floor((others[j, 1] - low_y) / width)
        bucket = _bucket(column, row, buckets - 1)
        following[j] = first[bucket]
        first[bucket] = j

    one, other = np.empty(len(points) + 64, np.int64), np.empty(len(points) + 64, np.int64)
    rank = np.empty(len(points) + 64, np.int64)
    used, compared = 0, 0
    for i in range(len(points)):
        x, y = points[i, 0], points[i, 1]
        own_column = math.floor((x - low_x) / distance)
        own_row = math.floor((y - low_y) / distance)
        begin = used
        column_0 = math.floor((x - distance - low_x) / width)
        column_1 = math.floor((x + distance - low_x) / width)
        row_0 = math.floor((y - distance - low_y) / width)
        row_1 = math.floor((y + distance - low_y) / width)
        for column in range(column_0, column_1 + 1):
            for row in range(row_0, row_1 + 1):
                j = first[_bucket(column, row, buckets - 1)]
                while j >= 0:
                    compared += 1
                    dx, dy = x - others[j, 0], y - others[j, 1]
                    if (
                        abs(dx) <= distance
                        and abs(dy) <= distance
                        and math.hypot(dx, dy) <= distance
                        # Another cell may share the bucket.
                        and math.floor((others[j, 0] - low_x) / width) == column
                        and math.floor((others[j, 1] - low_y) / width) == row
                    ):
                        across = math.floor((others[j, 0] - low_x) / distance) - own_column
                        up = math.floor((others[j, 1] - low_y) / distance) - own_row
                        if abs(across) <= 1 and abs(up) <= 1:
                            if used == len(one):
                                one = _lengthened(one, used)
                                other = _lengthened(other, used)
                                rank = _lengthened(rank, used)
                            here = 3 * across + up + 4
                            slot = used
                            while slot > begin and (
                                rank[slot - 1] > here
                                or (rank[slot - 1] == here and other[slot - 1] > j)
                            ):
                                rank[slot], other[slot] = rank[slot - 1], other[slot - 1]
                                slot -= 1
                            rank[slot], other[slot] = here, j
                            one[used] = i
                            used += 1
                    j = following[j]
        if compared > most:
            return one[:0], other[:0], False
    # The pairs of the column to the left come first, then those of the same column.
    place = np.zeros(3, np.int64)
    for k in range(used):
        if rank[k] < 6:
            place[rank[k] // 3 + 1] += 1
    place[2] += place[1]
    sorted_one, sorted_other = np.empty(used, np.int64), np.empty(used, np.int64)
    for k in range(used):
        slot = place[rank[k] // 3]
        sorted_one[slot], sorted_other[slot] = one[k], other[k]
        place[rank[k] // 3] += 1
    return sorted_one, sorted_other, True
