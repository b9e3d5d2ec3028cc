"""facing_contours: mill contours together between which the cutter does not fit.

A part that lies in a hole of another part is cut before the hole, so they are in different layers.
Each has its own offset, which keeps the cutter out of the contours of the same layer only.  Where
the part is nearer to the hole than the cutter's diameter, both offsets would lead the cutter into
the other contour.  Such a part and its hole get the same layer: they have one offset, which leaves
out the places where the cutter does not fit.
"""

from __future__ import annotations

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.spatial_index.box_pairs import box_pairs


def merge_facing_layers(paths: Paths, layer: I64, milled: Bool, diameter: float) -> I64:
    """Return the layer of each of p paths, (p,), after parts and holes that face each other are
    merged.

    A part that is nearer to the hole in which it lies than the diameter of the cutter gets the
    layer of the hole, and so do the parts that are as near to this part.

    Parameters
    ----------
    paths
        Paths with the cutter on their left: anticlockwise round holes, and clockwise round parts.
    layer : (p,)
        Layer of each path; higher layers are milled first.
    milled : (p,)
        Mask of the closed paths that separate a part from waste.
    diameter : mm
        Diameter of the cutter.
    """
    result = layer.copy()
    boxes = _path_boxes(paths)
    holes = np.flatnonzero(milled & (paths.areas > 0.0))
    parts = np.flatnonzero(milled & (paths.areas < 0.0))
    parts = parts[layer[parts] > layer[holes].min(initial=layer.max(initial=0))]
    # From the outermost hole inwards, so that a part takes over the layer that its hole has by now.
    for hole in holes[np.argsort(layer[holes], kind="stable")] if len(parts) else ():
        inside = (boxes[parts, :2] >= boxes[hole, :2]).all(axis=1)
        inside &= (boxes[parts, 2:] <= boxes[hole, 2:]).all(axis=1)
        # A part that lies directly in the hole is one layer higher.
        inside &= layer[parts] == layer[hole] + 1
        remaining, reached = parts[inside], hole[None]
        while len(remaining) and len(reached):
            reached = _paths_near(paths, reached, remaining, diameter)
            remaining = np.setdiff1d(remaining, reached)
            result[reached] = np.minimum(result[reached], result[hole])
    return result


def _path_boxes(paths: Paths) -> F64:
    """Return the bounding box of each of p paths, (p, 4) mm: x min, y min, x max, y max."""
    boxes = arc.bounding_boxes(paths.start, paths.end, paths.bulge)
    first = paths.first[:-1]
    low = np.minimum.reduceat(boxes[:, :2], first, axis=0)
    return np.hstack([low, np.maximum.reduceat(boxes[:, 2:], first, axis=0)])


def _paths_near(paths: Paths, ones: I64, others: I64, distance: float) -> I64:
    """Return those of the paths ``others`` that are nearer to one of the paths ``ones`` than a
    distance (mm).

    The paths must not cross each other.
    """
    own = np.flatnonzero(np.isin(paths.path_of, ones))
    rows = np.flatnonzero(np.isin(paths.path_of, others))
    boxes = arc.bounding_boxes(paths.start, paths.end, paths.bulge)
    i, j = box_pairs(boxes[own], boxes[rows], distance)
    i, j = own[i], rows[j]
    apart = np.minimum(_distances(paths, i, j), _distances(paths, j, i))
    return np.unique(paths.path_of[j[apart < distance]])


def _distances(paths: Paths, i: I64, j: I64) -> F64:
    """Return the least of some distances between k pairs of segments, (k,) mm.

    Measured are both ends of the first segment, and the point of the second segment that is nearest
    to the centre of the first one, if that is an arc.  The least distance of two segments that do
    not cross is one of these or, with the segments exchanged, one of those.
    """
    one = paths.start[i], paths.end[i], paths.bulge[i]
    other = paths.start[j], paths.end[j], paths.bulge[j]
    result = np.minimum(_distances_to(other, one[0]), _distances_to(other, one[1]))
    rows = np.flatnonzero(one[2])
    bent = one[0][rows], one[1][rows], one[2][rows]
    facing = other[0][rows], other[1][rows], other[2][rows]
    foot = arc.point_at(*facing, arc.nearest_fraction(*facing, arc.centre(*bent)))
    result[rows] = np.minimum(result[rows], _distances_to(bent, foot))
    return result


def _distances_to(segments: tuple[F64, F64, F64], points: F64) -> F64:
    """Return the distance of each of k segments from the point given for it, (k,) mm.

    ``segments`` are starts (k, 2), ends (k, 2) and bulges (k,), and ``points`` (k, 2).
    """
    nearest = arc.point_at(*segments, arc.nearest_fraction(*segments, points))
    result: F64 = np.hypot(*(nearest - points).T)
    return result
