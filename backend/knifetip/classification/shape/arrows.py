"""arrows: find the arrows of dimensions, which are annotations and are never cut or creased.

An arrowhead is two short edges of equal length that meet at the end of a third edge, the shaft.
The two short edges point back along the shaft at equal angles, and their other ends are free or
joined to each other.  A notch at the end of a crease points the other way, and its ends continue in
the outline.  ``facing_arrows`` finds heads that point the other way and have free ends.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

import numpy as np

from knifetip.classification.shape.facing_arrows import find_facing_arrows
from knifetip.geometry.columns import Bool
from knifetip.geometry.parallel import chunks, parallel_map
from knifetip.kernels import F64_1, F64_2, I32_1, Bool_1, OutBool_1, kernel
from knifetip.topology.intersections import MIN_CHUNK
from knifetip.topology.planar_graph import PlanarGraph

#: Greatest length of an arrowhead (mm).
_MAX_LENGTH: Final = 12.0
#: Greatest length of an arrowhead as a fraction of the length of its shaft.
_MAX_FRACTION: Final = 0.75
#: Least and greatest angle between an edge of the head and the shaft (radians).
_MIN_ANGLE: Final = math.radians(5.0)
_MAX_ANGLE: Final = math.radians(50.0)
#: Greatest difference between the angles of the two sides (radians).
_ANGLE_TOLERANCE: Final = math.radians(4.0)
#: Greatest difference between the lengths of the two sides, as a fraction.
_LENGTH_TOLERANCE: Final = 0.05
#: Greatest length of an extension line beyond the arrow's tip (mm).
_EXTENSION: Final = 8.0
#: Vertices with more pieces than this are not searched.
_MAX_DEGREE: Final = 24


class _Graph(NamedTuple):
    """The planar graph of n edges, reduced to the arrays that the search for arrows needs.

    The graph has q vertices and p pieces.  A piece is the part of an edge between two neighbouring
    vertices.
    """

    vertex: F64_2  #: (q, 2) position of each vertex
    start: I32_1  #: (p,) vertex at which each piece starts
    end: I32_1  #: (p,) vertex at which each piece ends
    edge: I32_1  #: (p,) edge that each piece is a part of, -1 for none
    first: I32_1  #: (n + 1,) index of the first piece of each edge


class _Incidence(NamedTuple):
    """For each vertex of a planar graph, the pieces that start or end at it.

    A piece is the part of an edge between two neighbouring vertices.  The indices of the pieces at
    vertex v are ``piece[first[v] : first[v + 1]]``.
    """

    first: I32_1  #: (q + 1,) index of the first entry of each vertex
    piece: I32_1  #: pieces that start or end at the vertex


class _Marks(NamedTuple):
    """What is found at the vertices and edges of a graph; the kernels set entries to True."""

    is_arrow: OutBool_1  #: (n,) edges of arrowheads and of their shafts
    tip: OutBool_1  #: (q,) vertices at the tip of an arrowhead
    #: (q,) vertices at which two such short edges with free ends point away from a third edge
    fork: OutBool_1


def find_arrow_edges(graph: PlanarGraph, count: int, unit: float) -> Bool:
    """Return the mask of edges that belong to arrows, (n,): heads, shafts and extension lines.

    Parameters
    ----------
    graph
        Planar graph of n edges.
    count
        Number of edges, n.
    unit
        Number of drawing units in a millimetre.
    """
    is_arrow, tip = np.zeros(count, np.bool_), np.zeros(len(graph.vertex), np.bool_)
    marks = _Marks(is_arrow, tip, np.zeros(len(graph.vertex), np.bool_))
    columns = _Graph(graph.vertex, graph.start, graph.end, graph.edge, graph.first)
    incidence = _pieces_by_vertex(columns, graph.twin_piece)

    def mark(chunk: tuple[int, int]) -> None:
        _mark_arrowheads(columns, graph.bulge, incidence, unit, marks, *chunk)

    parallel_map(mark, chunks(len(tip), MIN_CHUNK))
    is_arrow[find_facing_arrows(graph, np.flatnonzero(marks.fork), unit)] = True
    _mark_extension_lines(columns, incidence, unit, is_arrow, tip)
    if tip.any():
        _mark_coincident(columns, graph.twin_piece, is_arrow)
    return is_arrow


@kernel
def _pieces_by_vertex(graph: _Graph, twin: I32_1) -> _Incidence:
    """Return for each vertex of a graph the list of the pieces that start or end there.

    A piece is the part of an edge between two neighbouring vertices.  Of coincident pieces only the
    first one is listed.  Links, straight connections that close a gap and belong to no edge, are
    not listed.  ``twin`` (p,) is the first piece that coincides with each piece, the piece itself
    if there is none.
    """
    vertex, start, end, edge, _ = graph
    vertices, count = len(vertex), len(start)
    first = np.zeros(vertices + 1, np.int32)
    for p in range(count):
        if twin[p] == p and edge[p] >= 0:
            first[start[p] + 1] += 1
            first[end[p] + 1] += 1
    for v in range(vertices):
        first[v + 1] += first[v]
    position = first[:-1].copy()
    piece = np.empty(first[-1], np.int32)
    for p in range(count):
        if twin[p] == p and edge[p] >= 0:
            piece[position[start[p]]] = p
            position[start[p]] += 1
            piece[position[end[p]]] = p
            position[end[p]] += 1
    return _Incidence(first, piece)


@kernel
def _mark_arrowheads(
    graph: _Graph,
    bulge: F64_1,
    incidence: _Incidence,
    unit: float,
    marks: _Marks,
    begin: int,
    stop: int,
) -> None:
    """Mark the edges of arrowheads, and of their shafts, at vertices ``begin`` … ``stop`` - 1.

    ``bulge`` (p,): bulge of each piece.
    ``unit``: number of drawing units in a millimetre.
    """
    is_arrow, tip, fork = marks
    vertex, start, end, edge, first_piece = graph
    first, piece = incidence
    max_length = _MAX_LENGTH * unit
    side_edge = np.empty(_MAX_DEGREE, np.int32)
    far_end = np.empty(_MAX_DEGREE, np.int32)
    direction = np.empty(_MAX_DEGREE)
    length = np.empty(_MAX_DEGREE)
    for tip_vertex in range(begin, stop):
        degree = first[tip_vertex + 1] - first[tip_vertex]
        if degree < 3 or degree > _MAX_DEGREE:
            continue
        sides = 0
        for k in range(first[tip_vertex], first[tip_vertex + 1]):
            p = piece[k]
            i = edge[p]
            if i < 0 or bulge[p] != 0.0:
                continue
            # Other lines may cross the edge: its whole length counts, not that of a piece.
            far = _other_end(start, end, first_piece, i, tip_vertex)
            if far < 0:
                continue
            dx, dy = vertex[far, 0] - vertex[tip_vertex, 0], vertex[far, 1] - vertex[tip_vertex, 1]
            chord = math.hypot(dx, dy)
            # The far end is dangling, or is a corner of a closed arrowhead.
            if not 0.0 < chord <= max_length or first[far + 1] - first[far] > 2:
                continue
            side_edge[sides], far_end[sides] = i, far
            direction[sides], length[sides] = math.atan2(dy, dx), chord
            sides += 1
        if sides < 2:
            continue
        for a in range(sides):
            for b in range(a + 1, sides):
                if abs(length[a] - length[b]) > _LENGTH_TOLERANCE * length[a]:
                    continue
                one, two = far_end[a], far_end[b]
                loose = first[one + 1] - first[one] == 1 and first[two + 1] - first[two] == 1
                if not loose and not _are_ends_of_edge(graph, incidence, one, two):
                    continue
                for k in range(first[tip_vertex], first[tip_vertex + 1]):
                    shaft = piece[k]
                    i = edge[shaft]
                    if i < 0 or i in (side_edge[a], side_edge[b]) or bulge[shaft] != 0.0:
                        continue
                    to = end[shaft] if start[shaft] == tip_vertex else start[shaft]
                    dx, dy = (
                        vertex[to, 0] - vertex[tip_vertex, 0],
                        vertex[to, 1] - vertex[tip_vertex, 1],
                    )
                    if (
                        _chord_length(vertex, start, end, first_piece, i) * _MAX_FRACTION
                        < length[a]
                    ):
                        continue
                    along = math.atan2(dy, dx)
                    left, right = _turn(along, direction[a]), _turn(along, direction[b])
                    if left * right >= 0.0 or abs(abs(left) - abs(right)) > _ANGLE_TOLERANCE:
                        continue
                    if loose and abs(left) >= math.pi - _MAX_ANGLE:
                        fork[tip_vertex] = True
                    if not _MIN_ANGLE <= abs(left) <= _MAX_ANGLE:
                        continue
                    tip[tip_vertex] = True
                    is_arrow[side_edge[a]] = is_arrow[side_edge[b]] = is_arrow[i] = True
                    # Such sides are one side that was drawn twice with a small difference.
                    for c in range(sides):
                        turn = min(
                            abs(_turn(direction[c], direction[a])),
                            abs(_turn(direction[c], direction[b])),
                        )
                        if (
                            turn <= _ANGLE_TOLERANCE
                            and abs(length[c] - length[a]) <= _LENGTH_TOLERANCE * length[a]
                        ):
                            is_arrow[side_edge[c]] = True
                    if not loose:
                        for m in range(first[one], first[one + 1]):
                            if edge[piece[m]] >= 0:
                                is_arrow[edge[piece[m]]] = True


@kernel(allocates=False)
def _mark_extension_lines(
    graph: _Graph, incidence: _Incidence, unit: float, is_arrow: OutBool_1, tip: Bool_1
) -> None:
    """Mark the extension lines of dimensions: lines that end shortly beyond the tip of an arrow.

    ``graph``, ``incidence``: graph of n edges with q vertices, and the pieces of edges that end at
    each vertex.
    ``unit``: number of drawing units in a millimetre.
    ``is_arrow`` (n,): set to True for extension lines.
    ``tip`` (q,): whether each vertex is at the tip of an arrow.
    """
    vertex, start, end, edge, first_piece = graph
    first, piece = incidence
    for at in range(len(vertex)):
        if not tip[at]:
            continue
        for k in range(first[at], first[at + 1]):
            p = piece[k]
            if edge[p] < 0 or is_arrow[edge[p]]:
                continue
            i = edge[p]
            for side in range(2):
                last = first_piece[i] if side == 0 else first_piece[i + 1] - 1
                outer = start[last] if side == 0 else end[last]
                if first[outer + 1] - first[outer] == 1:
                    dx = vertex[outer, 0] - vertex[at, 0]
                    dy = vertex[outer, 1] - vertex[at, 1]
                    beyond = math.hypot(dx, dy)
                    whole = _chord_length(vertex, start, end, first_piece, i)
                    ends_here = start[p] == at or end[p] == at
                    if beyond <= _EXTENSION * unit or (ends_here and beyond >= whole):
                        is_arrow[i] = True


@kernel(allocates=False)
def _mark_coincident(graph: _Graph, twin: I32_1, is_arrow: OutBool_1) -> None:
    """Set ``is_arrow`` to True also for edges that are covered by edges of arrows.

    ``is_arrow`` (n,) is the mask of edges of arrows, and ``twin`` (p,) is the first piece that
    coincides with each piece, the piece itself if there is none.  A piece is the part of an edge
    between two neighbouring vertices of the graph.
    """
    for i in range(len(is_arrow)):
        if is_arrow[i] or graph.first[i] == graph.first[i + 1]:
            continue
        covered = True
        for p in range(graph.first[i], graph.first[i + 1]):
            other = graph.edge[twin[p]]
            covered = covered and other >= 0 and is_arrow[other]
        is_arrow[i] = covered


@kernel(allocates=False)
def _other_end(start: I32_1, end: I32_1, first_piece: I32_1, i: int, vertex: int) -> int:
    """Return the other end vertex of edge ``i`` if one end is vertex ``vertex``, otherwise -1.

    The edges are divided into p pieces at the vertices.

    ``start``, ``end`` (p,): start vertex and end vertex of each piece.
    ``first_piece`` (n + 1,): index of the first piece of each edge.
    """
    one, two = start[first_piece[i]], end[first_piece[i + 1] - 1]
    if one == vertex:
        far: int = two
        return far
    if two == vertex:
        near: int = one
        return near
    return -1


@kernel(allocates=False)
def _are_ends_of_edge(
    graph: _Graph, incidence: _Incidence, first_vertex: int, second_vertex: int
) -> bool:
    """Return whether ``first_vertex`` and ``second_vertex`` are the two ends of one edge.

    ``incidence`` lists the pieces of edges that end at each vertex.
    """
    for k in range(incidence.first[first_vertex], incidence.first[first_vertex + 1]):
        i = graph.edge[incidence.piece[k]]
        if (
            i >= 0
            and _other_end(graph.start, graph.end, graph.first, i, first_vertex) == second_vertex
        ):
            return True
    return False


@kernel(allocates=False)
def _chord_length(vertex: F64_2, start: I32_1, end: I32_1, first_piece: I32_1, i: int) -> float:
    """Return the distance between the two end vertices of edge ``i``.

    The vertices of a planar graph divide each of n edges into pieces, p in total.

    ``vertex`` (q, 2): position of each vertex.
    ``start``, ``end`` (p,): start vertex and end vertex of each piece.
    ``first_piece`` (n + 1,): index of the first piece of each edge.
    """
    a, b = start[first_piece[i]], end[first_piece[i + 1] - 1]
    return math.hypot(vertex[b, 0] - vertex[a, 0], vertex[b, 1] - vertex[a, 1])


@kernel(allocates=False)
def _turn(before: float, after: float) -> float:
    """Return the turn from direction ``before`` to direction ``after``, from -π to π.

    Directions and turn are angles in radians.
    """
    turn = (after - before) % (2.0 * math.pi)
    return turn - 2.0 * math.pi if turn > math.pi else turn
