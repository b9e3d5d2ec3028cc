"""vertices: merge points into the vertices of a graph, and find edges that coincide.

Points within a tolerance of each other become one vertex: a point gets the nearest existing vertex
within the tolerance, or a new vertex if there is none.  Points with equal coordinates always get
the same vertex: that of the first of these points, even if a vertex that is nearer to them was
added later.
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

#: Width of a hash cell, in multiples of the tolerance.
_CELL: Final = 16.0
#: Results of ``_nearest_vertex`` for no vertex, and for several.
_NONE: Final = -1
_SEVERAL: Final = -2
#: Points are equal if they round to the same multiples of the tolerance divided by this.
_FINE: Final = 1000.0


class VertexTable(NamedTuple):
    """The positions of q vertices, with a hash table that finds the vertices near a point."""

    point: OutF64_2  #: (≥ q, 2) position of each vertex
    vertex_count: int  #: q, the number of vertices
    next_vertex: OutI32_1  #: (≥ q,) next vertex in the same hash bucket, -1 for none
    head: OutI32_1  #: (2^k,) vertex that was added last to each hash bucket, -1 for none


def merge_ends(ends: F64, tolerance: float) -> tuple[VertexTable, I32]:
    """Return the vertices at the ends of n edges, and the vertex of each end, (2n,).

    An end gets the nearest vertex that is at most ``tolerance`` away, or a new vertex.  ``ends``
    (n, 2, 2) are the start and end points of the edges; edge i has the ends 2 i and 2 i + 1.
    """
    count = len(ends)
    size = 1 << (4 * count + 15).bit_length()
    vertices = VertexTable(
        np.empty((2 * count, 2)), 0, np.empty(2 * count, np.int32), np.full(size, -1, np.int32)
    )
    end_vertex = np.empty(2 * count, np.int32)
    ambiguous = np.zeros(2 * count, np.bool_)
    found, near = _merge_points(ends, tolerance, vertices, end_vertex, ambiguous)
    if near:
        _unify_equal_ends(ends, tolerance, np.flatnonzero(ambiguous).astype(np.int32), end_vertex)
    return vertices._replace(vertex_count=found), end_vertex


def with_capacity(vertices: VertexTable, more: int) -> VertexTable:
    """Return a table with the vertices of a given table and capacity for ``more`` further ones.

    Both tables share the hash buckets, column ``head``: the given table must not be used after a
    vertex has been added to the returned one.
    """
    point, next_vertex = (
        np.empty((vertices.vertex_count + more, 2)),
        np.empty(vertices.vertex_count + more, np.int32),
    )
    point[: vertices.vertex_count] = vertices.point[: vertices.vertex_count]
    next_vertex[: vertices.vertex_count] = vertices.next_vertex[: vertices.vertex_count]
    return VertexTable(point, vertices.vertex_count, next_vertex, vertices.head)


@kernel(allocates=False)
def _merge_points(
    ends: F64_3, tolerance: float, vertices: VertexTable, end_vertex: OutI32_1, ambiguous: OutBool_1
) -> Any:
    """Add the vertices at the ends of n edges to a table, and return two numbers.

    The numbers are the number of vertices in the table, and the number of ends with several
    vertices within the tolerance.

    ``ends`` (n, 2, 2): start and end points of the edges; edge i has the ends 2 i and 2 i + 1.
    ``tolerance``: largest distance of an end from its vertex.
    ``end_vertex`` (2n,): receives the vertex of each end.
    ``ambiguous`` (2n,): set to True for ends with several vertices within the tolerance.
    """
    count = near = 0
    for half in range(len(end_vertex)):
        x, y = ends[half // 2, half % 2, 0], ends[half // 2, half % 2, 1]
        at = _nearest_vertex(x, y, tolerance, vertices.point, vertices.head, vertices.next_vertex)
        if at == _NONE:
            at = count
            _add_vertex(x, y, tolerance, vertices.point, count, vertices.head, vertices.next_vertex)
            count += 1
        elif at < 0:
            at = _SEVERAL - at
            ambiguous[half] = True
            near += 1
        end_vertex[half] = at
    return count, near


@kernel
def _slot(ends: F64_3, half: int, fine: float, table: I32_1) -> Any:
    """Return the slot of the hash table ``table`` for the position of one end of an edge.

    The slot contains the number of an end at the same position, or a negative number if the table
    has no such end.  Positions are the same if they are equal after rounding to multiples of 1 /
    ``fine``.

    ``ends`` (n, 2, 2): start and end points of n edges.
    ``half``: number of the end: 2 i for the start of edge i and 2 i + 1 for its end.
    ``table``: hash table of numbers of ends; empty slots are negative.
    """
    mask = len(table) - 1
    x, y = _rounded_position(ends, half, fine)
    slot = _hash_bucket(x, y, mask)
    while table[slot] >= 0 and _rounded_position(ends, table[slot], fine) != (x, y):
        slot = (slot + 1) & mask
    return slot


@kernel
def _rounded_position(ends: F64_3, half: int, fine: float) -> Any:
    """Return x and y of an end of an edge, multiplied by ``fine`` and rounded to integers.

    ``half`` is the number of the end: 2 i for the start of edge i and 2 i + 1 for its end.
    ``ends`` (n, 2, 2) are the start and end points of n edges.
    """
    return (
        np.int64(np.rint(ends[half // 2, half % 2, 0] * fine)),
        np.int64(np.rint(ends[half // 2, half % 2, 1] * fine)),
    )


@kernel(allocates=False)
def _hash_bucket(cx: int, cy: int, mask: int) -> Any:
    """Return the hash bucket, 0 … ``mask``, of the pair of integers (``cx``, ``cy``).

    ``mask`` is the number of buckets, a power of two, minus 1.
    """
    key = np.uint64(cx) * np.uint64(0x9E3779B97F4A7C15) ^ np.uint64(cy) * np.uint64(
        0xC2B2AE3D27D4EB4F
    )
    return np.int64((key ^ (key >> np.uint64(31))) & np.uint64(mask))


@inline_kernel
def vertex_at(
    x: float,
    y: float,
    tolerance: float,
    point: OutF64_2,
    count: int,
    head: OutI32_1,
    next_vertex: OutI32_1,
) -> int:
    """Return the vertex within the tolerance of (``x``, ``y``); add one if there is none.

    Parameters
    ----------
    tolerance
        Largest distance of the point from the vertex.
    point, head, next_vertex
        Columns of a ``VertexTable``, to which an added vertex is written.
    count
        Number of vertices in the table, which is also the number of an added vertex.  The caller
        must increase it after an addition.
    """
    at = _nearest_vertex(x, y, tolerance, point, head, next_vertex)
    if at == _NONE:
        _add_vertex(x, y, tolerance, point, count, head, next_vertex)
        return count
    return at if at >= 0 else _SEVERAL - at


@inline_kernel
def _nearest_vertex(
    x: float, y: float, tolerance: float, point: F64_2, head: I32_1, next_vertex: I32_1
) -> int:
    """Return the index of the vertex nearest to (``x``, ``y``) within the tolerance.

    Two negative results are possible.  The result is -1 if no vertex is within the tolerance.  It
    is -2 minus the index of the nearest vertex if several vertices are within the tolerance and
    none of them is exactly at the point.  ``point``, ``head`` and ``next_vertex`` are columns of a
    ``VertexTable``.
    """
    mask = len(head) - 1
    fx, fy = x / (_CELL * tolerance), y / (_CELL * tolerance)
    cx, cy = math.floor(fx), math.floor(fy)
    x0 = -1 if fx - cx <= 1.0 / _CELL else 0
    x1 = 1 if fx - cx >= 1.0 - 1.0 / _CELL else 0
    y0 = -1 if fy - cy <= 1.0 / _CELL else 0
    y1 = 1 if fy - cy >= 1.0 - 1.0 / _CELL else 0
    nearest, best, many, exact = _NONE, tolerance * tolerance, False, False
    for dx in range(x0, x1 + 1):
        for dy in range(y0, y1 + 1):
            at = head[_hash_bucket(cx + dx, cy + dy, mask)]
            while at >= 0:
                ox = point[at, 0] - x
                oy = point[at, 1] - y
                away = ox * ox + oy * oy
                if away <= tolerance * tolerance:
                    many = many or nearest != _NONE
                    if away <= best:
                        nearest, best = at, away
                    if away == 0.0:
                        exact = True
                        break
                at = next_vertex[at]
            if exact:
                break
        if exact:
            break
    return _SEVERAL - nearest if many and not exact else nearest


@inline_kernel
def _add_vertex(
    x: float,
    y: float,
    tolerance: float,
    point: OutF64_2,
    number: int,
    head: OutI32_1,
    next_vertex: OutI32_1,
) -> None:
    """Add a vertex with the given number at (``x``, ``y``) to the columns of a ``VertexTable``.

    ``point``, ``head`` and ``next_vertex`` are the columns.  ``tolerance`` is the tolerance within
    which points become one vertex; it determines the size of the hash cells.
    """
    fx, fy = x / (_CELL * tolerance), y / (_CELL * tolerance)
    own = _hash_bucket(math.floor(fx), math.floor(fy), len(head) - 1)
    point[number, 0], point[number, 1] = x, y
    next_vertex[number] = head[own]
    head[own] = number


@kernel
def first_coincident(start: I32_1, end: I32_1, bulge: F64_1, point: F64_2, tolerance: float) -> Any:
    """Return for each of n edges the first edge that coincides with it, (n,).

    The entry is the edge itself if no earlier edge coincides with it.  Two edges coincide if they
    connect the same vertices along the same line or arc.

    Parameters
    ----------
    start, end, bulge : (n,)
        Start vertex, end vertex and bulge of each edge.
    point : (q, 2)
        Positions of the vertices.
    tolerance
        Half of the largest distance between the midpoints of coincident arcs.
    """
    count = len(start)
    twin = np.empty(count, np.int32)
    mask = 1
    while mask < 2 * count:
        mask *= 2
    heads = np.full(mask, -1, np.int32)
    mask -= 1
    behind = np.empty(count, np.int32)
    for p in range(count):
        a, b, bend = start[p], end[p], bulge[p]
        if a > b:
            a, b, bend = b, a, -bend
        slot = _hash_bucket(a, b, mask)
        at = heads[slot]
        twin[p] = p
        while at >= 0:
            if (start[at] == a and end[at] == b) or (start[at] == b and end[at] == a):
                other = bulge[at] if start[at] == a else -bulge[at]
                chord = math.hypot(point[a, 0] - point[b, 0], point[a, 1] - point[b, 1])
                if 0.5 * abs(other - bend) * chord <= 2.0 * tolerance:
                    twin[p] = at
                    break
            at = behind[at]
        if twin[p] == p:
            behind[p] = heads[slot]
            heads[slot] = p
    return twin


@kernel
def _unify_equal_ends(
    ends: F64_3, tolerance: float, ambiguous: I32_1, end_vertex: OutI32_1
) -> None:
    """Give all ends of edges at one position the vertex of the first of these ends.

    Only positions of ends that have several vertices within the tolerance are treated.

    ``ends`` (n, 2, 2): start and end points of n edges; edge i has the ends 2 i and 2 i + 1.
    ``tolerance``: largest distance of an end from its vertex.
    ``ambiguous``: numbers of the ends that have several vertices within the tolerance.
    ``end_vertex`` (2n,): vertex of each end; the entries of unified ends are overwritten.
    """
    mask = 1
    while mask < 4 * len(ambiguous):
        mask *= 2
    mask -= 1
    # Points that are rounded to different integers are still within the tolerance.
    fine = _FINE / tolerance
    table = np.full(mask + 1, -1, np.int32)
    vertex_of_slot = np.full(mask + 1, -1, np.int32)
    for half in ambiguous:
        table[_slot(ends, half, fine, table)] = half
    for half in range(len(end_vertex)):
        slot = _slot(ends, half, fine, table)
        if table[slot] < 0:
            continue
        if vertex_of_slot[slot] < 0:
            vertex_of_slot[slot] = end_vertex[half]
        end_vertex[half] = vertex_of_slot[slot]
