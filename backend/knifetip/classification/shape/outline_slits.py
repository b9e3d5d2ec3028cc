"""outline_slits: find slits whose lines also close the outline of a blank.

The side of a panel is often one line, of which a part lies between the panel and a flap beside it.
An edge has one line type, so it is cut along the flap too.  The part is a slit only if the panels
that it separates remain attached to the blank by other lines.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.classification.shape.face_pairs import face_pairs, find_bridges
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, U8, Bool
from knifetip.topology.connected_faces import label_connected_faces
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph

#: Least fraction of the length of an edge on the outline, for an edge that is cut as a whole.
_MIN_OUTLINE: Final = 0.5
#: Least area of a panel beside a slit, as a fraction of the square of the length of the slit.
_MIN_PANEL: Final = 0.1


def mark_outline_slits(
    graph: PlanarGraph, faces: Faces, is_splinter: Bool, length: F64, role: U8, count: int
) -> None:
    """Give the role of an outline to dividers that are parts of edges on the outline.

    Lines that coincide with such a part get the role too.

    Parameters
    ----------
    graph, faces
        Planar graph of a drawing, with p pieces of edges, and its f faces.
    is_splinter : (f,)
        Whether each face is a splinter.
    length, role : (p,) each
        Length and Role of each piece.  The function writes to ``role``.
    count
        Number of edges.
    """
    divider = np.flatnonzero((role == Role.DIVIDER) & (graph.edge >= 0))
    if len(divider) == 0:
        return
    on_outline = np.flatnonzero((role == Role.OUTLINE) & (graph.edge >= 0))
    edge = graph.edge[divider]
    inside = np.bincount(edge, length[divider], count)
    outside = np.bincount(graph.edge[on_outline], length[on_outline], count)
    slit = (inside > 0.0) & (outside >= _MIN_OUTLINE * (inside + outside))
    if not slit.any():
        return
    rows = np.flatnonzero(role == Role.DIVIDER)
    pair, number = face_pairs(faces.left[rows], faces.right[rows])
    bridge = np.zeros(len(role), np.bool_)
    bridge[rows] = find_bridges(pair, len(faces.area))[number]
    area = np.minimum(faces.area[faces.left], faces.area[faces.right])
    small = (area < _MIN_PANEL * length * length) & ~(
        is_splinter[faces.left] | is_splinter[faces.right]
    )
    slit &= np.bincount(edge, (bridge | small)[divider], count) == 0
    if not slit.any():
        return
    cut = np.zeros(len(role), np.bool_)
    cut[graph.twin_piece[divider[slit[edge]]]] = True
    cut = cut[graph.twin_piece] & (role == Role.DIVIDER)
    sides = np.column_stack([faces.left, faces.right])
    before = label_connected_faces(len(faces.area), sides[rows])
    after = label_connected_faces(len(faces.area), sides[rows[~cut[rows]]])
    falls_apart = np.zeros(len(faces.area), np.bool_)
    falls_apart[before[before != after]] = True
    role[cut & ~falls_apart[before[faces.left]]] = Role.OUTLINE
