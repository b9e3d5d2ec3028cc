"""contour_crossings: refuse contours that cross each other between their vertices.

A cutter with a radius needs to know on which side of each contour the part lies.  Where two
contours cross, or one contour crosses itself, that side changes between two vertices.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I8, I32, I64, Bool
from knifetip.geometry.vertices import number_vertices
from knifetip.planning.cut_sides import cut_sides
from knifetip.topology.noding import split_at_crossings

#: Contours that meet at a smaller angle touch (degrees).
_LEAST_ANGLE: Final = 5.0


def check_contour_crossings(ends: F64, bulge: F64, removed: I8, source: I32) -> None:
    """Raise ``PlanError`` if contours cross between the ends of their edges.

    Contours that only touch are permitted, and so are slits that cross anything.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of cuts, which touch no end of another between their ends.
    removed : (n,)
        Side of each cut without board if the cuts cross nowhere, 0 for a cut on no contour.
    source : (n,)
        Index in the dieline of the edge of each cut.

    Raises
    ------
    PlanError
        Contours cross.  The error gives an edge and a crossing.
    """
    contour = np.flatnonzero(removed)
    pieces, bent, row = split_at_crossings(ends[contour], bulge[contour])
    if len(row) == len(contour):
        return
    changed = cut_sides(pieces, bent).removed != removed[contour][row]
    piece, side = np.nonzero(changed[:, None] & _at_crossings(pieces, bent, row))
    if len(piece):
        x, y = pieces[piece[0], side[0]]
        edges = np.unique(source[contour[row[piece]]])
        raise PlanError(
            "milling.contours-cross",
            edge=source[contour[row[piece[0]]]],
            x=x,
            y=y,
            at_edges=edges,
        )


def _at_crossings(ends: F64, bulge: F64, row: I64) -> Bool:
    """Return the mask of the ends of m pieces at which edges cross between their ends, (m, 2).

    Edges that meet at less than ``_LEAST_ANGLE`` do not cross.  ``ends`` and ``bulge`` are the
    pieces, (m, 2, 2) mm and (m,), in order along each edge; ``row`` is the edge of each, (m,).
    """
    inner = np.zeros((len(row), 2), np.bool_)
    inner[1:, 0] = inner[:-1, 1] = row[1:] == row[:-1]
    vertex = number_vertices(ends.reshape(-1, 2))
    tangent = [arc.tangent_at(ends[:, 0], ends[:, 1], bulge, np.full(len(row), f)) for f in (0, 1)]
    x, y = np.stack(tangent, axis=1).reshape(-1, 2).T
    direction = np.degrees(np.arctan2(y, x))
    # Of the directions at a vertex, any one is the reference for the others.
    reference = np.zeros(int(vertex.max()) + 1)
    reference[vertex] = direction
    angle = np.abs((direction - reference[vertex] + 90.0) % 180.0 - 90.0)
    widest = np.zeros(len(reference))
    np.maximum.at(widest, vertex, angle)
    result: Bool = inner & (widest[vertex] > _LEAST_ANGLE).reshape(-1, 2)
    return result
