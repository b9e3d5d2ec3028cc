"""graph_nesting: find the face of a drawing's planar graph that contains each connected component.

A horizontal ray runs to the left from the leftmost vertex of a component.  The first piece of
another component that the ray meets bounds the face that contains the first component, or belongs
to a component that is in the same face.  A piece is the part of an edge between two neighbouring
vertices.

The ends of pieces at one vertex are equal only within a tolerance.  A ray at exactly the height of
a vertex could pass between them, so each ray starts a fraction of the tolerance above its vertex.

``exact_nesting`` does the same for edges that meet exactly at their ends.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I32
from knifetip.geometry.parallel import chunks, parallel_map
from knifetip.geometry.spatial_index.cells import cell_of
from knifetip.kernels import F64_1, F64_2, F64_3, I32_1, OutBool_1, OutI32_1, inline_kernel, kernel
from knifetip.topology.edge_grid import EdgeGrid
from knifetip.topology.intersections import MIN_CHUNK
from knifetip.topology.planar_graph import PlanarGraph
from knifetip.topology.segment import BULGE


class LeftNeighbours(NamedTuple):
    """For each of c components of a planar graph, its left neighbour.

    A ray runs to the left from the leftmost vertex of the component; the first piece of another
    component that it meets is the left neighbour.  A piece is the part of an edge between two
    neighbouring vertices.
    """

    piece: OutI32_1  #: (c,) first piece to the left of each component, -1 for none
    upward: OutBool_1  #: (c,) whether that piece runs upwards where the ray meets it


class _Pieces(NamedTuple):
    """The p pieces of n edges: the parts of edges between neighbouring vertices."""

    first: I32_1  #: (n + 1,) edge i has the pieces first[i] … first[i + 1] - 1
    parameter: F64_1  #: (p,) parameter on its edge at which each piece starts, 0 … 1
    component: I32_1  #: (p,) component of each piece


def find_left_neighbours(
    graph: PlanarGraph, ends: F64, bulge: F64, tolerance: float
) -> LeftNeighbours:
    """Return the left neighbour of each connected component of a planar graph, if it has one.

    A ray runs to the left from the leftmost vertex of the component; the first piece of another
    component that it meets is the left neighbour.  A piece is the part of an edge between two
    neighbouring vertices.

    Parameters
    ----------
    graph
        Planar graph of n edges.
    ends, bulge : (n, 2, 2) and (n,)
        Start and end points and bulges of the edges.
    tolerance
        Largest distance between ends that became one vertex of the graph.
    """
    count = len(graph.leftmost)
    left_neighbours = LeftNeighbours(np.full(count, -1, np.int32), np.zeros(count, np.bool_))
    pieces = _Pieces(graph.first, graph.parameter, graph.component)
    origin = graph.vertex[graph.leftmost] + (0.0, 0.317 * tolerance)

    def find(run: tuple[int, int]) -> None:
        _find_left(ends, bulge, graph.grid, pieces, origin, left_neighbours, *run)

    parallel_map(find, chunks(count, MIN_CHUNK))
    return left_neighbours


def enclosing_faces(
    left_neighbours: LeftNeighbours, left: I32, right: I32, outside: I32, owner: I32
) -> I32:
    """Return the bounded face that contains each of c components, (c,), -1 if there is none.

    A piece is the part of an edge between two neighbouring vertices of the graph.

    Parameters
    ----------
    left_neighbours
        First piece of another component to the left of each component.
    left, right : (p,)
        Faces on the left and on the right of each piece.
    outside : (c,)
        Outer face of each component.
    owner : (f,)
        Component of each face.
    """
    met = np.where(
        left_neighbours.upward, right[left_neighbours.piece], left[left_neighbours.piece]
    )
    within: I32 = _containing_faces(
        np.where(left_neighbours.piece < 0, np.int32(-1), met), outside, owner
    )
    return within


@kernel(allocates=False)
def _find_left(
    ends: F64_3,
    bulge: F64_1,
    grid: EdgeGrid,
    pieces: _Pieces,
    origin: F64_2,
    left_neighbours: LeftNeighbours,
    begin: int,
    end: int,
) -> None:
    """Find the left neighbours of the components ``begin`` … ``end`` - 1 of a planar graph.

    ``ends``, ``bulge`` (n, 2, 2) and (n,): start and end points and bulges of the edges.
    ``grid``: grid that lists the edges in each cell.
    ``origin`` (c, 2): point at which the ray of each component starts.
    ``left_neighbours``: receives the result; unchanged for a component without a left neighbour.
    """
    first_piece, parameter, component = pieces
    piece, upward = left_neighbours
    low, size, side, first, listed = grid
    for c in range(begin, end):
        x, y = origin[c, 0], origin[c, 1]
        line = cell_of(y, low[1], size[1], side)
        column = cell_of(x, low[0], size[0], side)
        best, found = -np.inf, -1
        while column >= 0:
            cell = line * side + column
            for k in range(first[cell], first[cell + 1]):
                i = listed[k]
                if (ends[i, 0, 0] > x and ends[i, 1, 0] > x) and abs(bulge[i]) <= BULGE:
                    continue
                for root in range(1 if abs(bulge[i]) <= BULGE else 2):
                    at, up = _x_at(ends, bulge, i, y, root)
                    if best < at < x:
                        if first_piece[i] == first_piece[i + 1] or component[first_piece[i]] == c:
                            continue
                        best, found, upward[c] = at, i, up
            if found >= 0 and best >= low[0] + column * size[0]:
                break
            column -= 1
        if found >= 0:
            p = first_piece[found]
            where = _parameter_at(ends, bulge, found, best, y)
            while p + 1 < first_piece[found + 1] and parameter[p + 1] <= where:
                p += 1
            piece[c] = p


@kernel
def _containing_faces(hit: I32_1, outside: I32_1, owner: I32_1) -> Any:
    """Return the bounded face that contains each of c components, (c,), -1 if there is none.

    A ray runs to the left from each component, until it meets an edge of another component.

    ``hit`` (c,): face between each component and the edge that its ray meets, -1 if the ray meets
    no edge. If this face is the outer face of the other component, both components are in one face,
    and the face that contains the other component is returned.
    ``outside`` (c,): outer face of each component.
    ``owner`` (f,): component of each face.
    """
    component_count = len(hit)
    within = np.full(component_count, -1, np.int32)
    known = np.zeros(component_count, np.bool_)
    visited = np.empty(component_count, np.int32)
    for c in range(component_count):
        waiting = 0
        on, f = c, -1
        while not known[on]:
            visited[waiting] = on
            waiting += 1
            known[on] = True
            f = hit[on]
            if f < 0 or f != outside[owner[f]]:
                break
            on = owner[f]
            f = within[on]
        for k in range(waiting):
            within[visited[k]] = f
    return within


@inline_kernel
def _x_at(ends: F64_3, bulge: F64_1, i: int, y: float, root: int) -> tuple[float, bool]:
    """Return the x coordinate of edge ``i`` at height ``y``, and whether the edge rises there.

    The x coordinate is NaN if the edge does not reach that height.  The edge rises there if it runs
    upwards at that point, in the direction from its start to its end.  ``root`` is 0 for the left
    half and 1 for the right half of the circle of an arc; it has no effect on lines.  ``ends`` (n,
    2, 2) and ``bulge`` (n,) are the end points and bulges of the edges.
    """
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    bx, by = ends[i, 1, 0], ends[i, 1, 1]
    b = bulge[i]
    if abs(b) <= BULGE:
        if (ay > y) == (by > y):
            return np.nan, False
        return ax + (y - ay) * (bx - ax) / (by - ay), by > ay
    off = y - 0.5 * (ay + by)
    if 4.0 * off * off > 1.000001 * ((bx - ax) * (bx - ax) + (by - ay) * (by - ay)):
        return np.nan, False
    up = (1.0 - b * b) / (4.0 * b)
    cx = 0.5 * (ax + bx) - up * (by - ay)
    cy = 0.5 * (ay + by) + up * (bx - ax)
    square = (ax - cx) ** 2 + (ay - cy) ** 2 - (y - cy) ** 2
    if square <= 0.0:
        return np.nan, False
    half = math.sqrt(square) if root == 1 else -math.sqrt(square)
    # The circle is on both sides of the chord; an arc that turns left is on the right of its chord.
    if ((bx - ax) * (y - ay) - (by - ay) * (cx + half - ax)) * b > 0.0:
        return np.nan, False
    return cx + half, (half > 0.0) == (b > 0.0)


@kernel(allocates=False)
def _parameter_at(ends: F64_3, bulge: F64_1, i: int, x: float, y: float) -> float:
    """Return the parameter, 0 (start) … 1 (end), of the point (``x``, ``y``) on edge ``i``.

    ``ends`` (n, 2, 2) and ``bulge`` (n,) are the end points and bulges of the edges.
    """
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    dx, dy = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay
    b = bulge[i]
    if abs(b) <= BULGE:
        along: float = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)
        return along
    up = (1.0 - b * b) / (4.0 * b)
    cx = ax + 0.5 * dx - up * dy
    cy = ay + 0.5 * dy + up * dx
    turn = math.atan2(y - cy, x - cx) - math.atan2(ay - cy, ax - cx)
    if b < 0.0:
        turn = -turn
    return (turn % (2.0 * math.pi)) / (4.0 * abs(math.atan(b)))
