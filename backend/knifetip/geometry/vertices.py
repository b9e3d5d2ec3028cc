"""vertices: number the vertices at which points lie, and sort points by vertex."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I32, I64
from knifetip.geometry.spatial_index.cells import group_by_cell
from knifetip.geometry.tolerance import JOIN
from knifetip.geometry.union_find import flatten, union
from knifetip.kernels import F64_2, inline_kernel, kernel

#: Most times that a cell is wider than the gap.  In wider cells, fewer points have their neighbours
#: in other cells.
_WIDEST: Final = 16.0


def number_vertices(points: F64, gap: float = JOIN) -> I32:
    """Return the vertex number of each point, (n,), counted from 0, for points (n, 2) mm.

    Points nearer than ``gap`` mm belong to the same vertex.  So do points that are farther apart
    but connected by a series of points in which neighbours are nearer than ``gap``.  The vertices
    are numbered in the order of their first points.
    """
    if len(points) == 0:
        return np.zeros(0, np.int32)
    vertex: I32 = _number_clusters(np.ascontiguousarray(points), gap)
    return vertex


def sort_by_vertex(vertex: I32) -> tuple[I64, I64]:
    """Return points sorted by their vertices, and where the points of each vertex begin.

    Parameters
    ----------
    vertex : (n,)
        Vertex number of each of n ≥ 1 points.

    Returns
    -------
    by_vertex : (n,)
        The points, vertex by vertex; those of one vertex are in ascending order.
    bounds : (v + 1,)
        Index in ``by_vertex`` of the first point of each of v vertices; the last entry is n.
    """
    bounds, by_vertex = group_by_cell(
        vertex, int(vertex.max()) + 1, np.arange(len(vertex), dtype=np.int32)
    )
    return by_vertex.astype(np.int64), bounds.astype(np.int64)


@inline_kernel
def _bucket(column: int, row: int, mask: int) -> int:
    """Return the bucket of a hash table, 0 … ``mask``, in which the points of a cell are."""
    key = column * 0x9E3779B1 ^ row * 0x85EBCA77
    return (key ^ (key >> 15) ^ (key >> 31)) & mask


@kernel
def _number_clusters(points: F64_2, gap: float) -> Any:
    """Return the number of the cluster of each point, (n,); see ``number_vertices``.

    Near points are merged by union-find.  They are found in a hash table of square cells, to which
    each point is added after it was compared with the points before it.
    """
    count = len(points)
    low_x = low_y = math.inf
    high_x = high_y = -math.inf
    for i in range(count):
        low_x, low_y = min(low_x, points[i, 0]), min(low_y, points[i, 1])
        high_x, high_y = max(high_x, points[i, 0]), max(high_y, points[i, 1])
    # Crowded points get smaller cells, so that few of them are compared.
    spacing = 0.5 * math.sqrt((high_x - low_x) * (high_y - low_y) / count)
    width = max(gap, min(_WIDEST * gap, spacing))
    low_x, low_y = low_x - gap, low_y - gap
    buckets = 64
    while buckets < count:
        buckets *= 2
    first, following = np.full(buckets, -1, np.int32), np.empty(count, np.int32)
    parent = np.arange(count)
    for i in range(count):
        x, y = points[i, 0], points[i, 1]
        c0, c1 = int((x - gap - low_x) / width), int((x + gap - low_x) / width)
        r0, r1 = int((y - gap - low_y) / width), int((y + gap - low_y) / width)
        for column in range(c0, c1 + 1):
            for row in range(r0, r1 + 1):
                j = first[_bucket(column, row, buckets - 1)]
                while j >= 0:
                    dx, dy = x - points[j, 0], y - points[j, 1]
                    if dx * dx + dy * dy <= gap * gap:
                        union(parent, i, j)
                    j = following[j]
        home = _bucket(int((x - low_x) / width), int((y - low_y) / width), buckets - 1)
        following[i] = first[home]
        first[home] = i
    flatten(parent)
    number, used = np.empty(count, np.int32), 0
    for i in range(count):
        # The root of a cluster is its least index.
        if parent[i] == i:
            number[i] = used
            used += 1
        else:
            number[i] = number[parent[i]]
    return number
