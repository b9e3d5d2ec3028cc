"""planar_graph: build the planar graph of a drawing: vertices, and pieces of edges between them.

Edges are split at the points at which other edges end on them or cross them.  Links close gaps: a
link is a piece that belongs to no edge and connects a dangling end with an edge ahead of it, or two
dashes of a row.

The graph of 100,000 edges is built in less than 0.1 s.  ``build_graph`` returns None for a drawing
with so many crossings that it would take long.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.parallel import parallel_pair
from knifetip.geometry.tolerance import GAP
from knifetip.geometry.union_find import flatten, union
from knifetip.kernels import F64_1, F64_2, I32_1, I32_2, kernel
from knifetip.topology.dash_rows import link_dashes
from knifetip.topology.edge_grid import EdgeGrid, build_grid
from knifetip.topology.gap_links import link_loose_ends, split_links
from knifetip.topology.intersections import Crossings, concatenate, find_crossings, find_splits
from knifetip.topology.lines import Lines
from knifetip.topology.segment import BULGE
from knifetip.topology.vertices import VertexTable, first_coincident, merge_ends


class GraphPieces(NamedTuple):
    """The p pieces between the q vertices of a planar graph.

    A piece is the part of an edge between two neighbouring vertices, or a link.
    """

    vertex: F64_2  #: (q, 2) position of each vertex
    start: I32_1  #: (p,) vertex at which each piece starts
    end: I32_1  #: (p,) vertex at which each piece ends
    bulge: F64_1  #: (p,) tan(sweep / 4) of each piece
    twin: I32_1  #: (p,) first piece that coincides with each piece; the piece itself if none does


@dataclass(frozen=True, eq=False, slots=True)
class PlanarGraph:
    """A planar graph of n edges, with p pieces, q vertices and c connected components.

    A piece is the part of an edge between two neighbouring vertices, or a link: a straight
    connection of two vertices that closes a gap and belongs to no edge.
    """

    grid: EdgeGrid
    vertex: F64  #: (q, 2) position of each vertex
    start: I32  #: (p,) vertex at which each piece starts
    end: I32  #: (p,) vertex at which each piece ends
    bulge: F64  #: (p,) tan(sweep / 4) of each piece
    edge: I32  #: (p,) edge of each piece, -1 for a link
    parameter: F64  #: (p,) parameter on its edge at which each piece starts, 0 … 1
    first: I32  #: (n + 1,) edge i has the pieces first[i] … first[i + 1] - 1
    end_vertex: I32  #: (2n,) vertices of the start and the end of each edge
    twin_piece: (
        I32  #: (p,) first piece that coincides with each piece; the piece itself if none does
    )
    component: I32  #: (p,) connected component of each piece
    leftmost: I32  #: (c,) leftmost vertex of each component
    dashed: Bool  #: (n,) whether each edge is a dash of a row

    @property
    def pieces(self) -> GraphPieces:
        """Return the pieces of the graph as a record for kernels."""
        return GraphPieces(self.vertex, self.start, self.end, self.bulge, self.twin_piece)

    def chords(self) -> F64:
        """Return the straight distance between the start and the end vertex of each piece, (p,).

        A piece is the part of an edge between two neighbouring vertices of the graph.
        """
        chord: F64 = _chords(self.vertex, self.start, self.end)
        return chord


@kernel
def _chords(position: F64_2, start: I32_1, end: I32_1) -> Any:
    result = np.empty(len(start))
    for p in range(len(start)):
        x = position[end[p], 0] - position[start[p], 0]
        y = position[end[p], 1] - position[start[p], 1]
        result[p] = math.sqrt(x * x + y * y)
    return result


def build_graph(ends: F64, bulge: F64, tolerance: float, reach: float) -> PlanarGraph | None:
    """Return the planar graph of n edges.

    Returns None if n is 0, if so many edges are in each cell of the search grid that searches would
    be slow, or if the edges must be split at too many points.  Lengths are in drawing units.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) and (n,)
        Start and end points and bulges of the edges.
    tolerance
        Ends of edges that are nearer to each other than this become one vertex.
    reach
        Largest distance from a dangling end to the edge that it is linked to.
    """
    count = len(bulge)
    if count == 0:
        return None
    limit = 64 * count + 4096
    found, (vertices, end_vertex, twin) = parallel_pair(
        lambda: _find_crossings(ends, bulge, tolerance, reach, limit),
        lambda: _merge_vertices(ends, bulge, tolerance),
    )
    if found is None:
        return None
    grid, pairs = found
    lines = Lines(ends, bulge, end_vertex, twin, grid, tolerance, tolerance / GAP)
    splits = find_splits(lines, vertices, pairs, limit)
    if splits is None:
        return None
    end_splits, crossing_splits, vertices = splits
    loose = _dangling_vertices(
        end_vertex, twin, end_splits.vertex, crossing_splits.vertex, vertices.vertex_count
    )
    dashed, dash_links, gap_of = link_dashes(lines, reach, loose)
    met, links, vertices = link_loose_ends(lines, loose, gap_of, vertices)
    links = np.concatenate([dash_links, links])
    through, links, vertices = split_links(lines, links, vertices)
    start, end, piece_bulge, edge, parameter, first = _split_into_pieces(
        bulge, end_vertex, *concatenate(end_splits, crossing_splits, met, through), links
    )
    point = vertices.point[: vertices.vertex_count]
    twin_piece, (component, leftmost) = parallel_pair(
        lambda: first_coincident(start, end, piece_bulge, point, tolerance),
        lambda: connected_components(point, start, end),
    )
    line = start, end, piece_bulge, edge, parameter, first, end_vertex
    return PlanarGraph(grid, point, *line, twin_piece, component, leftmost, dashed)


def _find_crossings(
    ends: F64, bulge: F64, tolerance: float, reach: float, limit: int
) -> tuple[EdgeGrid, Crossings] | None:
    """Return a grid of n edges and the crossings of the edges.

    Returns None if the edges are too crowded for a grid: so many of them are in each cell that
    searches would be slow.

    ``ends``, ``bulge`` (n, 2, 2) and (n,): start and end points and bulges of the edges.
    ``tolerance``: a crossing that is at most this far from an end of one of the edges is left out.
    ``reach``: largest distance from an edge at which the grid will be searched.
    ``limit``: number of crossings to search for.  The search ends soon after it has found this
    number, and further crossings are missing.
    """
    grid = build_grid(ends, bulge, tolerance, reach)
    return None if grid is None else (grid, find_crossings(ends, bulge, tolerance, grid, limit))


def _merge_vertices(ends: F64, bulge: F64, tolerance: float) -> tuple[VertexTable, I32, I32]:
    """Return the vertices, the vertex of each edge end, and the first coincident edge of each edge.

    ``ends``, ``bulge`` (n, 2, 2) and (n,): start and end points and bulges of the edges.
    ``tolerance``: ends that are nearer to each other than this get one vertex.
    Returns vertices: table of the vertices; ``end_vertex`` (2n,): vertex of the start and of the
    end of each edge; ``twin`` (n,): first edge that coincides with each edge, the edge itself if
    there is none.
    """
    vertices, end_vertex = merge_ends(ends, tolerance)
    return (
        vertices,
        end_vertex,
        first_coincident(
            end_vertex[::2].copy(), end_vertex[1::2].copy(), bulge, vertices.point, tolerance
        ),
    )


@kernel
def connected_components(position: F64_2, start: I32_1, end: I32_1) -> Any:
    """Return the component of each piece, (p,), and the leftmost vertex of each component, (c,).

    A piece is a line or arc that connects two vertices of a planar graph.  A component is a set of
    connected pieces.

    Parameters
    ----------
    position : (q, 2)
        Positions of the vertices.
    start, end : (p,)
        Start vertex and end vertex of each piece.
    """
    pieces, vertex_count = len(start), len(position)
    parent = np.arange(vertex_count)
    for p in range(pieces):
        union(parent, start[p], end[p])
    flatten(parent)
    number = np.full(vertex_count, -1, np.int32)
    component = np.empty(pieces, np.int32)
    component_count = 0
    leftmost = np.empty(vertex_count, np.int32)
    for p in range(pieces):
        root = parent[start[p]]
        if number[root] < 0:
            number[root] = component_count
            leftmost[component_count] = start[p]
            component_count += 1
        own = number[root]
        component[p] = own
        if position[start[p], 0] < position[leftmost[own], 0]:
            leftmost[own] = start[p]
        if position[end[p], 0] < position[leftmost[own], 0]:
            leftmost[own] = end[p]
    return component, leftmost[:component_count]


@kernel
def _dangling_vertices(
    end_vertex: I32_1, twin: I32_1, end_splits: I32_1, crossing_splits: I32_1, vertex_count: int
) -> Any:
    """Return the mask of vertices at which one edge ends and no edge is split, (vertex_count,).

    Coincident edges count as one edge.

    ``end_vertex`` (2n,): vertex of the start and of the end of each of n edges.
    ``twin`` (n,): first edge that coincides with each edge, the edge itself if there is none.
    ``end_splits``: vertices at which an edge is split because another edge ends on it.
    ``crossing_splits``: vertices at which edges are split because they cross.
    """
    degree = np.zeros(vertex_count, np.uint8)
    for half in range(len(end_vertex)):
        if twin[half // 2] == half // 2:
            degree[end_vertex[half]] = min(degree[end_vertex[half]] + 1, 2)
    for parting in (end_splits, crossing_splits):
        for at in parting:
            degree[at] = 2
    return degree == 1


@kernel
def _split_into_pieces(
    bulge: F64_1, end_vertex: I32_1, row: I32_1, parameter: F64_1, cut: I32_1, link: I32_2
) -> Any:
    """Return the pieces of n edges, split at the given vertices, followed by the links.

    ``bulge`` (n,): bulge of each edge.
    ``end_vertex`` (2n,): vertex of the start and the end of each edge.
    ``row``, ``parameter``, ``cut`` (c,): edge, parameter on the edge, and vertex of each split.
    ``link`` (t, 2): start vertex and end vertex of each link.
    Returns ``start, end, bulge, edge, parameter`` (p,): start vertex, end vertex and bulge of each
    piece, its edge (-1 for a link), and the parameter on the edge at which it starts; ``first`` (n
    + 1,): the pieces of edge i are ``first[i]`` … ``first[i + 1] - 1``.
    """
    n, cuts, links = len(bulge), len(row), len(link)
    begins = np.zeros(n + 1, np.int32)
    for k in range(cuts):
        begins[row[k] + 1] += 1
    begins = np.cumsum(begins).astype(np.int32)
    ordered = np.empty(cuts, np.int32)
    put = begins[:-1].copy()
    for k in range(cuts):
        at = put[row[k]]
        put[row[k]] += 1
        while at > begins[row[k]] and parameter[ordered[at - 1]] > parameter[k]:
            ordered[at] = ordered[at - 1]
            at -= 1
        ordered[at] = k
    total = n + cuts + links
    start = np.empty(total, np.int32)
    end = np.empty(total, np.int32)
    piece_bulge = np.empty(total)
    edge = np.empty(total, np.int32)
    begin = np.empty(total)
    first_piece = np.empty(n + 1, np.int32)
    pieces = 0
    for i in range(n):
        first_piece[i] = pieces
        here, last = end_vertex[2 * i], 0.0
        for k in range(begins[i], begins[i + 1] + 1):
            there, to = end_vertex[2 * i + 1], 1.0
            if k < begins[i + 1]:
                there, to = cut[ordered[k]], parameter[ordered[k]]
            # A piece with both ends at one vertex is dropped as debris unless it is a long arc.
            round_ = abs(bulge[i]) > BULGE and to - last > 0.5
            if there == here and not round_:
                continue
            start[pieces], end[pieces], edge[pieces], begin[pieces] = here, there, i, last
            piece_bulge[pieces] = bulge[i]
            if to - last < 1.0 and bulge[i] != 0.0:
                piece_bulge[pieces] = math.tan(math.atan(bulge[i]) * (to - last))
            pieces += 1
            here, last = there, to
    first_piece[n] = pieces
    for k in range(links):
        start[pieces], end[pieces], edge[pieces] = link[k, 0], link[k, 1], -1
        piece_bulge[pieces], begin[pieces] = 0.0, 0.0
        pieces += 1
    return (
        start[:pieces],
        end[:pieces],
        piece_bulge[:pieces],
        edge[:pieces],
        begin[:pieces],
        first_piece,
    )
