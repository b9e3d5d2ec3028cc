"""open_flaps: find lines of an outline beside which a flap seems to be open.

Where the corners of a flap are missing, its sides are two equal lines that begin at the ends of its
fold and lead nowhere.  The fold then lies on the outline, and its shape is that of a cut.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, U8, Bool
from knifetip.topology.planar_graph import PlanarGraph

#: Greatest difference between the lengths of the two sides, as a fraction.
_TOLERANCE: Final = 0.02
#: Greatest length of a side, as a fraction of the length of the fold.
_MAX_SIDE: Final = 0.25


def find_open_flaps(graph: PlanarGraph, role: U8, length: F64, edge_role: U8) -> Bool:
    """Return the mask of edges of an outline that may close an open flap, (n,).  A line of the same
    length begins at each end of such an edge.

    The lines begin at the ends of the edge, lie outside the blank, and lead nowhere.

    Parameters
    ----------
    graph
        Planar graph of n edges, with p pieces.
    role, length : (p,) each
        Role and length of each piece.
    edge_role : (n,)
        Role of each edge.
    """
    outline, stray = role == Role.OUTLINE, role == Role.STRAY
    blank = np.zeros(len(graph.leftmost), np.bool_)
    blank[graph.component[outline]] = True
    side = np.flatnonzero(stray & blank[graph.component])
    if len(side) == 0:
        return np.zeros(len(edge_role), np.bool_)
    reach = np.zeros(len(graph.vertex))
    for end in (graph.start, graph.end):
        reach[end[side]] = length[side]
    at_ends = reach[graph.end_vertex.reshape(-1, 2)]
    least, most = at_ends.min(axis=1), at_ends.max(axis=1)
    edge = graph.edge
    whole = np.bincount(edge[edge >= 0], length[edge >= 0], len(edge_role))
    equal = (least > 0.0) & (most - least <= _TOLERANCE * most)
    mask: Bool = (edge_role == Role.OUTLINE) & equal & (most <= _MAX_SIDE * whole)
    return mask
