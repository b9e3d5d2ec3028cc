"""fold_slots: find slots that lie at a fold, into which a tab or the edge of another panel fits.

A slot inside a panel is a component of its own.  A slot at a fold is a face between panels, and the
fold may be one of its sides.  It is narrow, lies inside the blank, and has corners at which exactly
two lines meet.  A fold cannot turn such a corner, since only a straight line folds, so the sides
that meet there are cut.  The side on the fold may be a part of the fold, and stays a divider.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, U8, Bool
from knifetip.kernels import F64_1, F64_2, I32_1, U8_1, OutBool_1, kernel
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph

#: Greatest mean width of a slot (mm).
_WIDTH: Final = 8.0
#: Greatest area of a slot, as a fraction of the largest face of the drawing.
_MAX_SHARE: Final = 0.02
#: Cosine of the least angle by which the lines at a corner deviate from one straight line.
_CORNER: Final = math.cos(math.radians(45.0))
#: Least number of corners of a slot.
_FEWEST_CORNERS: Final = 2
_DIVIDER: Final = int(Role.DIVIDER)


def mark_fold_slots(graph: PlanarGraph, faces: Faces, length: F64, role: U8, unit: float) -> Bool:
    """Give the role of a slot to the dividers that are sides of a slot at a fold.

    Returns the mask of the faces that may be such slots, (f,).

    Parameters
    ----------
    graph, faces
        Planar graph of a drawing, with p pieces of edges, and its faces.
    length, role : (p,) each
        Length and Role of each piece.  The function writes to ``role``.
    unit
        Number of drawing units in a millimetre.
    """
    is_slot: Bool = _find_narrow(
        faces.left, faces.right, length, role, faces.area, _WIDTH * unit, _MAX_SHARE
    )
    if is_slot.any():
        pieces = graph.start, graph.end, graph.bulge, graph.twin_piece
        role[_find_sides(graph.vertex, *pieces, faces.left, faces.right, is_slot)] = Role.SLOT
    return is_slot


@kernel
def _find_narrow(
    left: I32_1, right: I32_1, length: F64_1, role: U8_1, area: F64_1, width: float, share: float
) -> Any:
    """Return the mask of narrow faces that only dividers bound, (f,).

    ``left``, ``right``, ``length``, ``role`` (p,) each: faces on the left and right of each piece,
    its length and its Role.
    ``area`` (f,): signed area of each face.
    ``width``: limit of the mean width of a narrow face.
    ``share``: limit of its area, as a fraction of the area of the largest face.
    """
    perimeter = np.zeros(len(area))
    for p in range(len(left)):
        own = length[p] if role[p] == _DIVIDER else np.inf
        perimeter[left[p]] += own
        perimeter[right[p]] += own
    largest = 0.0
    for f in range(len(area)):
        largest = max(largest, area[f])
    narrow = np.zeros(len(area), np.bool_)
    for f in range(len(area)):
        if 0.0 < area[f] <= share * largest and perimeter[f] < np.inf:
            narrow[f] = 2.0 * area[f] < width * perimeter[f]
    return narrow


@kernel
def _find_sides(
    vertex: F64_2,
    start: I32_1,
    end: I32_1,
    bulge: F64_1,
    twin: I32_1,
    left: I32_1,
    right: I32_1,
    narrow: OutBool_1,
) -> Any:
    """Return the mask of the pieces that meet at corners of slots, (p,), and update ``narrow``.

    ``vertex`` (q, 2): position of each vertex.
    ``start``, ``end``, ``bulge``, ``twin`` (p,) each: start vertex, end vertex and bulge of each
    piece, and the first piece that coincides with it.
    ``left``, ``right`` (p,) each: faces on the left and on the right of each piece.
    ``narrow`` (f,): whether each face is narrow enough for a slot; set to False for faces without
    corners.
    """
    degree = np.zeros(len(vertex), np.int32)
    piece = np.full((len(vertex), 2), -1, np.int32)
    for p in range(len(start)):
        if twin[p] != p:
            continue
        for v in (start[p], end[p]):
            if degree[v] < 2:
                piece[v, degree[v]] = p
            degree[v] += 1
    corners = np.zeros(len(narrow), np.int32)
    is_corner = np.zeros(len(vertex), np.bool_)
    for v in range(len(vertex)):
        if degree[v] != 2:
            continue
        one, two = piece[v, 0], piece[v, 1]
        if bulge[one] != 0.0 or bulge[two] != 0.0:
            continue
        face = left[one] if narrow[left[one]] else right[one]
        if not narrow[face] or (left[two] != face and right[two] != face):
            continue
        far_one, far_two = start[one] + end[one] - v, start[two] + end[two] - v
        x, y = vertex[far_one, 0] - vertex[v, 0], vertex[far_one, 1] - vertex[v, 1]
        u, w = vertex[far_two, 0] - vertex[v, 0], vertex[far_two, 1] - vertex[v, 1]
        if abs(x * u + y * w) <= _CORNER * math.sqrt((x * x + y * y) * (u * u + w * w)):
            is_corner[v] = True
            corners[face] += 1
    for f in range(len(narrow)):
        narrow[f] = narrow[f] and corners[f] >= _FEWEST_CORNERS
    side = np.zeros(len(start), np.bool_)
    for p in range(len(start)):
        if is_corner[start[p]] or is_corner[end[p]]:
            side[p] = narrow[left[p]] or narrow[right[p]]
    return side
