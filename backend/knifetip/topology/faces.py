"""faces: trace the faces of a planar graph, and find the faces on the two sides of every piece.

A piece is the part of an edge between two neighbouring vertices of the graph.  A face is traced by
taking the sharpest left turn at every vertex, so that the face is on the left of the path.  The
boundary of a bounded face runs counter-clockwise.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I32
from knifetip.geometry.parallel import parallel_pair
from knifetip.kernels import F64_1, F64_2, I32_1, kernel
from knifetip.topology.graph_nesting import enclosing_faces, find_left_neighbours
from knifetip.topology.planar_graph import PlanarGraph
from knifetip.topology.segment import BULGE

#: Number of directions in a right angle that are distinguished.
_FINE: Final = 10_000_000


@dataclass(frozen=True, eq=False, slots=True)
class Faces:
    """The f faces of a planar graph: their areas, their components and the faces beside each piece.

    The graph has c connected components and p pieces; a piece is the part of an edge between two
    neighbouring vertices.
    """

    left: I32  #: (p,) face on the left of each piece
    right: I32  #: (p,) face on the right of each piece
    area: F64  #: (f,) signed area; ≤ 0 for the outer face of a component
    component: I32  #: (f,) component of each face
    outer_face: I32  #: (c,) outer face of each component
    enclosing: I32  #: (c,) bounded face that contains each component, -1 for none


class PieceSides(NamedTuple):
    """The components of p pieces of a planar graph, and the faces beside each piece."""

    component: I32_1  #: (p,) component of each piece
    left: I32_1  #: (p,) face on the left of each piece
    right: I32_1  #: (p,) face on the right of each piece
    outer_face: I32_1  #: (c,) outer face of each component


def piece_sides(graph: PlanarGraph, faces: Faces) -> PieceSides:
    """Return the component of each piece of a graph, and the faces beside the piece."""
    return PieceSides(graph.component, faces.left, faces.right, faces.outer_face)


def trace_faces(graph: PlanarGraph, ends: F64, bulge: F64, tolerance: float) -> Faces:
    """Return the faces of the planar graph of n edges.

    Parameters
    ----------
    graph
        Graph of the edges.
    ends, bulge : (n, 2, 2) and (n,)
        Start and end points and bulges of the edges.
    tolerance
        Largest distance between ends that became one vertex of the graph.
    """
    lines = (graph.vertex, graph.start, graph.end, graph.bulge, graph.twin_piece)
    beside, (left, right, area) = parallel_pair(
        lambda: find_left_neighbours(graph, ends, bulge, tolerance),
        lambda: trace_sides(*lines),
    )
    outside, component_of_face = _outer_faces(
        len(graph.leftmost), graph.component, left, right, area
    )
    within = enclosing_faces(beside, left, right, outside, component_of_face)
    return Faces(left, right, area, component_of_face, outside, within)


def trace_sides(vertex: F64, start: I32, end: I32, bulge: F64, twin: I32) -> tuple[I32, I32, F64]:
    """Return the faces left and right of p pieces between q vertices, and the area of each face.

    A piece is the part of an edge between two neighbouring vertices of the graph.

    Parameters
    ----------
    vertex : (q, 2)
        Position of each vertex.
    start, end, bulge : (p,)
        Start vertex, end vertex and bulge of each piece.
    twin : (p,)
        First piece that coincides with each piece, the piece itself if there is none.  Of
        coincident pieces only the first one divides the plane.

    Returns
    -------
    left, right : (p,) and (p,)
        Face on the left and on the right of each piece.
    area : (f,)
        Signed area of each of f faces; zero or negative for outer faces.
    """
    lines = (vertex, start, end, bulge, twin)
    left, right, area = _trace(*lines, *_half_edges_by_vertex(*lines))
    return left, right, area


@kernel(allocates=False)
def _angle_code(x: float, y: float) -> int:
    """Return an integer that grows with the angle of the direction (``x``, ``y``), 0 … 4e7 - 1.

    The constant ``_FINE`` is 1e7, the number of steps in a quarter turn.  Directions that differ
    only by rounding get equal integers.
    """
    across = abs(x) + abs(y)
    along = y / across if across > 0.0 else 0.0
    quarters = 2.0 - along if x < 0.0 else along + 4.0 if y < 0.0 else along
    return int(quarters * _FINE + 0.5) % (4 * _FINE)


@kernel
def _half_edges_by_vertex(
    position: F64_2, start: I32_1, end: I32_1, bulge: F64_1, twin: I32_1
) -> Any:
    """Return the half-edges that leave each of q vertices, in counter-clockwise order.

    Half-edge 2 i leaves the start of piece i, half-edge 2 i + 1 leaves the end of piece i.  Of
    coincident pieces only the first one has half-edges.  A piece is the part of an edge between two
    neighbouring vertices of the graph.

    ``position`` (q, 2): position of each vertex.
    ``start``, ``end``, ``bulge`` (p,): start vertex, end vertex and bulge of each piece.
    ``twin`` (p,): first piece that coincides with each piece, the piece itself if there is none.
    Returns ``half_edges, begins`` (h,) and (q + 1,): the half-edges at vertex v are
    ``half_edges[begins[v] : begins[v + 1]]``.
    """
    pieces, vertex_count = len(start), len(position)
    begins = np.zeros(vertex_count + 1, np.int32)
    for p in range(pieces):
        if twin[p] == p:
            begins[start[p] + 1] += 1
            begins[end[p] + 1] += 1
    begins = np.cumsum(begins).astype(np.int32)
    angle = np.empty(2 * pieces, np.int64)
    half_edges = np.empty(begins[-1], np.int32)
    put = begins[:-1].copy()
    for p in range(pieces):
        if twin[p] != p:
            continue
        for half in range(2 * p, 2 * p + 2):
            at = start[p] if half % 2 == 0 else end[p]
            k = put[at]
            put[at] += 1
            # One or two half-edges need no order.
            if begins[at + 1] - begins[at] > 2:
                angle[half] = _direction(position, start, end, bulge, half)
                while k > begins[at]:
                    other = half_edges[k - 1]
                    if angle[other] < angle[half] or (
                        angle[other] == angle[half]
                        and _curvature_rank(position, start, end, bulge, other)
                        <= _curvature_rank(position, start, end, bulge, half)
                    ):
                        break
                    half_edges[k] = other
                    k -= 1
            half_edges[k] = half
    return half_edges, begins


@kernel(allocates=False)
def _direction(position: F64_2, start: I32_1, end: I32_1, bulge: F64_1, half: int) -> int:
    """Return the direction in which half-edge ``half`` leaves its vertex, as an integer.

    The integer is a result of ``_angle_code`` and grows with the angle.  Half-edge 2 i leaves the
    start of piece i, half-edge 2 i + 1 leaves its end.  ``position`` (q, 2) are the positions of
    the vertices; ``start``, ``end`` and ``bulge`` (p,) are start vertex, end vertex and bulge of
    each piece.  A piece is the part of an edge between two neighbouring vertices of the graph.
    """
    p = half // 2
    a, b, bend = start[p], end[p], bulge[p]
    dx, dy = position[b, 0] - position[a, 0], position[b, 1] - position[a, 1]
    if bend == 0.0:
        return _angle_code(dx, dy) if half % 2 == 0 else _angle_code(-dx, -dy)
    # The direction of the chord, turned by half the sweep.
    square = bend * bend
    c, s = (1.0 - square) / (1.0 + square), 2.0 * bend / (1.0 + square)
    if half % 2 == 0:
        return _angle_code(c * dx + s * dy, c * dy - s * dx)
    return _angle_code(s * dy - c * dx, -c * dy - s * dx)


@kernel(allocates=False)
def _curvature_rank(position: F64_2, start: I32_1, end: I32_1, bulge: F64_1, half: int) -> float:
    """Return a number that grows with the curvature of half-edge ``half``.

    The number is positive if the half-edge bends to the left, negative if it bends to the right,
    and 0 if it is straight.  It sorts half-edges that leave a vertex in the same direction.
    Half-edge 2 i leaves the start of piece i, half-edge 2 i + 1 leaves its end.  ``position`` (q,
    2) are the positions of the vertices; ``start``, ``end`` and ``bulge`` (p,) are start vertex,
    end vertex and bulge of each piece.  A piece is the part of an edge between two neighbouring
    vertices of the graph.
    """
    p = half // 2
    a, b = start[p], end[p]
    dx, dy = position[b, 0] - position[a, 0], position[b, 1] - position[a, 1]
    curve: float = bulge[p] / max(math.sqrt(dx * dx + dy * dy), 1e-300)
    return curve if half % 2 == 0 else -curve


@kernel
def _trace(
    position: F64_2,
    start: I32_1,
    end: I32_1,
    bulge: F64_1,
    twin: I32_1,
    half_edges: I32_1,
    begins: I32_1,
) -> Any:
    """Return the faces left and right of each piece, (p,) each, and the area of each face, (f,).

    The area is signed: zero or negative for outer faces.  A piece is the part of an edge between
    two neighbouring vertices of the graph.

    ``position`` (q, 2): position of each vertex.
    ``start``, ``end``, ``bulge`` (p,): start vertex, end vertex and bulge of each piece.
    ``twin`` (p,): first piece that coincides with each piece, the piece itself if there is none.
    ``half_edges``, ``begins`` (h,) and (q + 1,): the half-edges that leave vertex v,
    counter-clockwise, are ``half_edges[begins[v] : begins[v + 1]]``.
    """
    pieces = len(start)
    rank = np.empty(2 * pieces, np.int32)
    for k in range(len(half_edges)):
        rank[half_edges[k]] = k
    face = np.full(2 * pieces, -1, np.int32)
    area = np.empty(2 * pieces)
    count = 0
    for p in range(pieces):
        if twin[p] != p:
            continue
        for half in range(2 * p, 2 * p + 2):
            if face[half] >= 0:
                continue
            walked = half
            twice = 0.0
            x0, y0 = position[start[p], 0], position[start[p], 1]
            while face[walked] < 0:
                face[walked] = count
                q = walked // 2
                a, b = start[q], end[q]
                bend = bulge[q]
                if walked % 2 == 1:
                    a, b, bend = b, a, -bend
                ax, ay = position[a, 0] - x0, position[a, 1] - y0
                bx, by = position[b, 0] - x0, position[b, 1] - y0
                twice += ax * by - ay * bx
                if abs(bend) > BULGE:
                    whole = 1.0 + bend * bend
                    sine = 4.0 * bend * (1.0 - bend * bend) / (whole * whole)
                    chord = (bx - ax) * (bx - ax) + (by - ay) * (by - ay)
                    square = chord * whole * whole / (16.0 * bend * bend)
                    twice += square * (4.0 * math.atan(bend) - sine)
                k = rank[walked ^ 1]
                k = k - 1 if k > begins[b] else begins[b + 1] - 1
                walked = half_edges[k]
            area[count] = 0.5 * twice
            count += 1
    left = np.empty(pieces, np.int32)
    right = np.empty(pieces, np.int32)
    for p in range(pieces):
        q = twin[p]
        turned = start[p] != start[q] or (start[p] == end[p] and bulge[p] != bulge[q])
        left[p] = face[2 * q + 1] if turned else face[2 * q]
        right[p] = face[2 * q] if turned else face[2 * q + 1]
    return left, right, area[:count]


@kernel
def _outer_faces(
    component_count: int, component: I32_1, left: I32_1, right: I32_1, area: F64_1
) -> Any:
    """Return the outer face of each of c components, (c,), and the component of each face, (f,).

    The outer face of a component is its face with the least signed area.  A piece is the part of an
    edge between two neighbouring vertices of the graph.

    ``component_count``: number of components, c.
    ``component``, ``left``, ``right`` (p,): component of each piece, and the faces on its left and
    on its right.
    ``area`` (f,): signed area of each face.
    """
    outside = np.full(component_count, -1, np.int32)
    component_of_face = np.empty(len(area), np.int32)
    for p in range(len(component)):
        for f in (left[p], right[p]):
            component_of_face[f] = component[p]
            known = outside[component[p]]
            if known < 0 or area[f] < area[known]:
                outside[component[p]] = f
    return outside, component_of_face
