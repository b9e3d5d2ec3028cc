"""panels: measures of the faces of a planar graph, by which equal panels are found."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I64, Bool
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph


class Panels(NamedTuple):
    """Area, centre, bounding box and location (at the outline or not) of each of m faces."""

    area: F64  #: (m,) area of each panel
    centre: F64  #: (m, 2) mean of the contour
    box: F64  #: (m, 4) x min, y min, x max, y max
    at_rim: Bool  #: (m,) whether each panel is at the outline of a blank

    def take(self, rows: I64) -> Panels:
        """Return the record of the faces with the indices ``rows``, in the order of ``rows``."""
        area, centre, box, at_rim = self
        return Panels(area[rows], centre[rows], box[rows], at_rim[rows])


def measure_faces(
    graph: PlanarGraph, faces: Faces, length: F64, at_rim: Bool, components: I64 | None = None
) -> Panels:
    """Return the area, centre and bounding box of each of f faces, and whether it is at an outline.

    Parameters
    ----------
    graph, faces
        Planar graph with p pieces, which are parts of edges between neighbouring vertices, and its
        f faces.  Of coincident pieces only the first one is used.
    length : (p,)
        Length of each piece.
    at_rim : (f,)
        Whether each face is at the outline of a blank; copied to the result.
    components : (k,), optional
        Components whose faces are measured; None for all.  Other faces have no centre and box.
    """
    count = len(faces.area)
    is_own = graph.twin_piece == np.arange(len(graph.twin_piece))
    if components is not None:
        measured = np.zeros(len(faces.outer_face), np.bool_)
        measured[components] = True
        is_own &= measured[graph.component]
    own = np.flatnonzero(is_own)
    start, end, length = graph.vertex[graph.start[own]], graph.vertex[graph.end[own]], length[own]
    middle = 0.5 * (start + end)
    centre = np.zeros((count, 2))
    # One row per axis: ``ufunc.at`` is ten times as fast on contiguous rows.
    low, high = np.full((2, count), np.inf), np.full((2, count), -np.inf)
    lowest, highest = np.minimum(start, end).T.copy(), np.maximum(start, end).T.copy()
    weight = np.zeros(count)
    for side in (faces.left[own].astype(np.intp), faces.right[own].astype(np.intp)):
        weight += np.bincount(side, length, count)
        for axis in range(2):
            centre[:, axis] += np.bincount(side, length * middle[:, axis], count)
            np.minimum.at(low[axis], side, lowest[axis])
            np.maximum.at(high[axis], side, highest[axis])
    centre /= np.maximum(weight, 1e-12)[:, None]
    return Panels(faces.area, centre, np.concatenate([low, high]).T.copy(), at_rim)
