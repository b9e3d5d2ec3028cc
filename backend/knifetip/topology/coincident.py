"""coincident: find edges that other edges cover along their whole length.

The edges are divided into pieces at the vertices of a planar graph.  Two pieces are coincident if
they connect the same vertices along the same line or arc.
"""

from __future__ import annotations

import numpy as np

from knifetip.geometry.columns import F64, I32
from knifetip.kernels import F64_1, I32_1, OutI32_1, kernel
from knifetip.topology.planar_graph import PlanarGraph


def coincident_edges(graph: PlanarGraph, length: F64) -> I32:
    """Return for each of n edges another edge that covers it, (n,), or -1.

    An edge has an entry other than -1 only if other edges cover its whole length.  If several edges
    cover it together, the entry is the index of the edge on its longest piece.  A piece is the part
    of an edge between two neighbouring vertices of the planar graph.

    Parameters
    ----------
    graph
        Planar graph of the n edges, with p pieces.
    length : (p,)
        Length of each piece of the graph.
    """
    cover = np.full(len(graph.first) - 1, -1, np.int32)
    _are_overlaid(graph.edge, graph.first, graph.twin_piece, length, cover)
    return cover


@kernel
def _are_overlaid(edge: I32_1, first: I32_1, twin: I32_1, length: F64_1, cover: OutI32_1) -> None:
    # For each piece with coincident pieces: the edge of one of these pieces.
    mate = np.full(len(edge), -1, np.int32)
    for p in range(len(edge)):
        if edge[p] != edge[twin[p]] and edge[p] >= 0:
            mate[twin[p]] = edge[p]
    for i in range(len(cover)):
        longest = 0.0
        for p in range(first[i], first[i + 1]):
            lead = edge[twin[p]]
            other = lead if lead >= 0 and lead != i else mate[twin[p]]
            if other < 0 or other == i:
                cover[i] = -1
                break
            if length[p] > longest:
                longest = length[p]
                cover[i] = other
