"""missing_pieces: find short pieces that are missing in an outline, such as arcs of its corners.

Generators and converters leave out small arcs.  The lines on both sides then end facing each other:
a line that touches both at equal angles closes the outline again.  Such lines only serve to find
faces; they do not become edges of the drawing.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.topology.planar_graph import PlanarGraph

#: Largest number of free ends of lines in an outline that is examined.
_MOST_ENDS: Final = 64
#: Largest difference of the sines and cosines of both angles between lines and missing piece.
_EQUAL: Final = 0.02
#: Least cosine of these angles: the corner of an equilateral triangle is the sharpest.
_LEAST_COSINE: Final = 0.49


def find_missing_pieces(graph: PlanarGraph, ends: F64, bulge: F64) -> F64:
    """Return chords of pieces that are missing between free ends of straight lines, (k, 2, 2).

    A piece is not longer than the lines that it connects.  No piece is returned if a free end may
    belong to several pieces, or if the free ends are many.

    Parameters
    ----------
    graph
        Planar graph of n edges.
    ends, bulge : (n, 2, 2) and (n,)
        Ends and bulges of the edges.
    """
    none = np.empty((0, 2, 2))
    degree = np.bincount(np.concatenate([graph.start, graph.end]), minlength=len(graph.vertex))
    edge, side = np.divmod(np.arange(len(graph.end_vertex)), 2)
    vertex = graph.end_vertex
    is_free = (vertex >= 0) & (degree[vertex] == 1) & (bulge[edge] == 0.0)
    edge, side = edge[is_free], side[is_free]
    if not 2 <= len(edge) <= _MOST_ENDS:
        return none
    point = ends[edge, side]
    along = point - ends[edge, 1 - side]
    length = np.hypot(*along.T)
    along /= np.maximum(length, 1e-12)[:, None]
    across = point[None] - point[:, None]
    gap = np.hypot(across[..., 0], across[..., 1])
    towards = across / np.maximum(gap, 1e-12)[..., None]
    cosine = (along[:, None] * towards).sum(axis=2)
    sine = towards[..., 0] * along[:, None, 1] - towards[..., 1] * along[:, None, 0]
    faces = (np.abs(cosine - cosine.T) <= _EQUAL) & (np.abs(sine + sine.T) <= _EQUAL)
    faces &= (cosine >= _LEAST_COSINE) & (edge[:, None] != edge) & (gap > 0.0)
    faces &= gap <= np.minimum(length[:, None], length)
    if (faces.sum(axis=1) > 1).any():
        return none
    first, second = np.nonzero(np.triu(faces))
    return np.stack([point[first], point[second]], axis=1)
