"""edge_sums: features of edges, summed from the pieces of each edge.

The vertices of the planar graph of a drawing divide each edge into pieces.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I32, I64
from knifetip.kernels import (
    F64_1,
    I32_1,
    U8_1,
    Bool_1,
    OutBool_1,
    OutF64_1,
    OutI32_1,
    OutI32_2,
    OutU8_1,
    kernel,
)
from knifetip.topology.planar_graph import PlanarGraph


class Pieces(NamedTuple):
    """Component, length, role and adjacent faces of each of the p pieces of a planar graph.

    A piece is the part of an edge between two neighbouring vertices.
    """

    component: I32_1  #: (p,) connected component
    length: F64_1  #: (p,)
    role: U8_1  #: (p,) Role
    left: I32_1  #: (p,) face on the left
    right: I32_1  #: (p,) face on the right


class EdgeSums(NamedTuple):
    """Role, length, component and other features of each of n edges.

    They are computed from the pieces into which the vertices of a planar graph divide the edge.
    """

    role: OutU8_1  #: (n,) Role of the greatest part of the length
    fraction: OutF64_1  #: (n,) fraction of the length that has this role
    second_role: OutU8_1  #: (n,) Role of most of the rest of the length, ``role`` if there is none
    length: OutF64_1  #: (n,) length of all pieces; 0 for edges without pieces
    paired: OutBool_1  #: (n,) whether most of the edge has a narrow face on exactly one side
    component: OutI32_1  #: (n,) connected component, -1 for edges without pieces
    faces: OutI32_2  #: (n, 2) faces on both sides of the longest piece

    @classmethod
    def allocate(cls, count: int) -> EdgeSums:
        """Return a record with uninitialised columns for ``count`` edges."""
        return cls(
            np.empty(count, np.uint8),
            np.empty(count),
            np.empty(count, np.uint8),
            np.empty(count),
            np.empty(count, np.bool_),
            np.empty(count, np.int32),
            np.empty((count, 2), np.int32),
        )


def fill_short_edges(
    edges: EdgeSums, graph: PlanarGraph, ends: F64, length: F64, tolerance: float
) -> None:
    """Give each edge that is too short for the planar graph the role and component of a neighbour.

    An edge shorter than ``tolerance`` is not in the graph.  The neighbour is an edge in the graph
    that touches the start of the short edge: the preceding edge in the file, or else the longest
    one.  If there is no neighbour, the features of the short edge do not change.

    Parameters
    ----------
    edges
        Features of the n edges, to which the function writes.
    graph
        Planar graph of the edges; its vertices divide the edges into p pieces.
    ends : (n, 2, 2)
        Start and end points of the n edges.
    length : (p,)
        Length of each piece.
    tolerance
        Largest distance between ends of edges that became one vertex (drawing units).
    """
    short_edges = np.flatnonzero(edges.length == 0.0)
    with_pieces = np.where(edges.length > 0.0, np.arange(len(edges.length)), 0)
    previous = np.maximum.accumulate(with_pieces)[short_edges]
    gap = np.hypot(*(ends[previous, 1] - ends[short_edges, 0]).T)
    # If the edge before in the file does not end there: the edge of the longest piece that does.
    model = np.where(
        (edges.length[previous] > 0.0) & (gap <= 4.0 * tolerance),
        previous,
        _longest_neighbours(graph, length, short_edges),
    )
    short_edges, model = short_edges[model >= 0], model[model >= 0]
    edges.role[short_edges], edges.fraction[short_edges] = edges.role[model], edges.fraction[model]
    edges.second_role[short_edges] = edges.second_role[model]
    edges.component[short_edges] = edges.component[model]
    edges.length[short_edges] = tolerance


@kernel
def find_narrow_faces(left: I32_1, right: I32_1, length: F64_1, area: F64_1, width: float) -> Any:
    """Return the mask of the faces of a planar graph that are long and narrow, (f,).

    A face is narrow if its mean width is less than ``width``.  The p pieces are the parts of edges
    between neighbouring vertices.

    Parameters
    ----------
    left, right : (p,)
        Index of the face on the left and of the face on the right of each piece.
    length : (p,)
        Length of each piece.
    area : (f,)
        Signed area of each face.
    width
        Limit of the mean width, in the unit of the lengths.
    """
    left_length, right_length = np.zeros(len(area)), np.zeros(len(area))
    for p in range(len(length)):
        left_length[left[p]] += length[p]
        right_length[right[p]] += length[p]
    result = np.empty(len(area), np.bool_)
    for f in range(len(area)):
        perimeter = left_length[f] + right_length[f]
        long = perimeter > 5.0 * width
        result[f] = area[f] > 0.0 and long and 2.0 * area[f] < width * perimeter
    return result


@kernel
def sum_pieces(
    first: I32_1, pieces: Pieces, narrow: Bool_1, edges: EdgeSums, begin: int, end: int
) -> None:
    """Compute the features of edges ``begin`` … ``end`` - 1 from the pieces of each edge.

    The vertices of the planar graph divide each edge into pieces.

    Parameters
    ----------
    first : (n + 1,)
        Index of the first piece of each edge.
    pieces
        Length, role, component and adjacent faces of each piece.
    narrow : (f,)
        Whether each face is narrow.
    edges
        Features of the n edges, to which the function writes.
    """
    component, length, role, left, right = pieces
    by_role = np.zeros(256)
    for i in range(begin, end):
        edges.component[i] = component[first[i]] if first[i] < first[i + 1] else -1
        longest = total = paired = 0.0
        best = 0
        edges.faces[i, 0] = edges.faces[i, 1] = 0
        for p in range(first[i], first[i + 1]):
            by_role[role[p]] += length[p]
            total += length[p]
            if narrow[left[p]] != narrow[right[p]]:
                paired += length[p]
            if length[p] > longest:
                longest = length[p]
                edges.faces[i, 0], edges.faces[i, 1] = left[p], right[p]
        for p in range(first[i], first[i + 1]):
            kind = role[p]
            if by_role[kind] > by_role[best] or (by_role[kind] == by_role[best] and kind < best):
                best = kind
        second = best
        if by_role[best] < total:
            rest = 0.0
            for p in range(first[i], first[i + 1]):
                kind = role[p]
                if kind != best and by_role[kind] > rest:
                    second, rest = kind, by_role[kind]
        edges.role[i], edges.second_role[i] = best, second
        edges.fraction[i] = by_role[best] / total if total > 0.0 else 0.0
        edges.length[i], edges.paired[i] = total, paired > 0.5 * total
        for p in range(first[i], first[i + 1]):
            by_role[role[p]] = 0.0


def _longest_neighbours(graph: PlanarGraph, length: F64, short_edges: I64) -> I32:
    """Return for each of k short edges the neighbour that has the longest piece at its start, (k,).

    The short edges are so short that they are not in the planar graph.  A neighbour is an edge with
    a piece that starts or ends at the start vertex of the short edge; the entry is its index, or -1
    if there is no neighbour.  A piece is the part of an edge between two neighbouring vertices.

    ``graph``: planar graph of all edges, with p pieces.
    ``length`` (p,): length of each piece.
    ``short_edges`` (k,): indices of the short edges.
    """
    found = np.full(len(graph.vertex), -1, np.int32)
    if len(short_edges) == 0:
        return found[:0]
    wanted = np.zeros(len(graph.vertex), np.bool_)
    wanted[graph.end_vertex[2 * short_edges]] = True
    vertex = np.concatenate([graph.start, graph.end])
    edge = np.tile(graph.edge, 2)
    piece = np.flatnonzero(wanted[vertex] & (edge >= 0))
    piece = piece[np.argsort(np.tile(length, 2)[piece], kind="stable")]
    # Pieces are assigned by length, so that the longest one at a vertex remains.
    found[vertex[piece]] = edge[piece]
    return found[graph.end_vertex[2 * short_edges]]
