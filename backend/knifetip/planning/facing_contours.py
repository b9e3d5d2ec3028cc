"""facing_contours: mill contours together between which the cutter does not fit.

Contours of different layers have separate offsets, which keep the cutter out of the contours of
the same layer only.  A part that lies in a hole is cut before the hole; slits and necks divide the
layers further.  Where two contours face each other across the same waste and are nearer than the
cutter's diameter, both offsets would lead the cutter into the other contour.  Such contours get the
same layer: they have one offset, which leaves out the places where the cutter does not fit.

Slits beside a contour are made before it.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.path import Paths, select_paths
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.union_find import flatten, union
from knifetip.kernels import I64_1, kernel
from knifetip.topology.exact_nesting import find_enclosing_faces


def merge_facing_layers(paths: Paths, layer: I64, milled: Bool, diameter: float) -> I64:
    """Return the layer of each of p paths, (p,), after contours that face each other are merged.

    Contours in the same waste that are nearer to each other than the diameter of the cutter get the
    lowest layer of them, and so do contours that are as near to these.

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
    rows = np.flatnonzero(milled).astype(np.int32)
    result = layer.copy()
    if len(rows) == 0 or (layer[rows] == layer[rows[0]]).all():
        return result
    contours, _ = select_paths(paths, rows)
    waste = _surrounding_waste(contours)
    one, other, _ = _near_pairs(contours, waste, _has_layers(waste, layer[rows]), diameter)
    result[rows] = _lowest_of_sets(one, other, layer[rows])
    return result


def facing_pairs(paths: Paths, milled: Bool, distance: float) -> tuple[I64, I64, F64]:
    """Return the pairs of paths in the same waste that are nearer to each other than a distance.

    A pair is returned once for each pair of its segments that are so near: the indices of both
    paths, (k,) and (k,), and how far apart the segments are, (k,) mm.

    ``paths``, ``milled``: see ``merge_facing_layers``.
    """
    rows = np.flatnonzero(milled).astype(np.int32)
    contours, _ = select_paths(paths, rows)
    every = np.ones(len(rows), np.bool_)
    one, other, apart = _near_pairs(contours, _surrounding_waste(contours), every, distance)
    return rows[one].astype(np.int64), rows[other].astype(np.int64), apart


def slit_layers(paths: Paths, layer: I64, milled: Bool, slit: Bool, radius: float) -> I64:
    """Return the layer of each of p paths, (p,), after slits are raised to that of the contours
    beside which they lie.

    The disc that mills a contour removes the board beside it, so a slit nearer to the contour than
    the radius is made before it, even if the slit lies in the waste.  In each layer slits are made
    before contours.

    Parameters
    ----------
    paths, layer, milled
        See ``merge_facing_layers``.
    slit : (p,)
        Mask of the paths that are cut on their line.
    radius : mm
        Radius of the cutter.
    """
    result = layer.copy()
    if not milled.any() or (layer == layer[0]).all():
        return result
    owner = paths.path_of
    boxes = arc.bounding_boxes(paths.start, paths.end, paths.bulge)
    rows, others = np.flatnonzero(slit[owner]), np.flatnonzero(milled[owner])
    i, j = box_pairs(boxes[rows], boxes[others], radius)
    i, j = rows[i], others[j]
    later = layer[owner[i]] < layer[owner[j]]
    i, j = i[later], j[later]
    near = np.minimum(_distances(paths, i, j), _distances(paths, j, i)) < radius
    np.maximum.at(result, owner[i[near]], layer[owner[j[near]]])
    return result


def _surrounding_waste(contours: Paths) -> I64:
    """Return the number of the waste beside each of p contours, (p,).

    It is the index of the contour that encloses the waste, so the contour itself for a hole, plus
    1; it is 0 for the waste round all contours.
    """
    count = len(contours)
    is_hole = contours.areas > 0.0
    # Each contour has two faces: inside and outside.
    inside = 2 * np.arange(count)
    left = np.where(is_hole, inside, inside + 1)
    right = np.where(is_hole, inside + 1, inside)
    owner = contours.path_of
    enclosing, _ = find_enclosing_faces(
        contours.start,
        contours.end,
        contours.bulge,
        np.stack([left, right], axis=1)[owner].astype(np.int32),
        np.arange(2 * count) % 2 == 1,
        owner.astype(np.int32),
    )
    around = np.where(enclosing < 0, 0, enclosing // 2 + 1)
    waste: I64 = np.where(is_hole, np.arange(count) + 1, around)
    return waste


def _has_layers(waste: I64, layer: I64) -> Bool:
    """Return the mask of the contours beside whose waste are contours of several layers, (p,).

    ``waste`` and ``layer``, (p,), are the waste beside each contour, and the contour's layer.
    """
    lowest = np.full(len(waste) + 1, layer.max())
    highest = np.full(len(waste) + 1, layer.min())
    np.minimum.at(lowest, waste, layer)
    np.maximum.at(highest, waste, layer)
    several: Bool = (lowest < highest)[waste]
    return several


def _near_pairs(
    contours: Paths, waste: I64, selected: Bool, distance: float
) -> tuple[I64, I64, F64]:
    """Return the pairs of contours beside the same waste that are nearer to each other than a
    distance, and how far apart they are.

    A pair is returned once for each pair of its segments that are so near.

    ``contours``: p contours, which must not cross each other.
    ``waste``, ``selected`` (p,): number of the waste beside each contour, and mask of the contours
    that are compared.
    ``distance`` mm: the distance.
    """
    owner = contours.path_of
    rows = np.flatnonzero(selected[owner])
    boxes = arc.bounding_boxes(contours.start[rows], contours.end[rows], contours.bulge[rows])
    i, j = box_pairs(boxes, boxes, distance)
    i, j = rows[i], rows[j]
    kept = (owner[i] < owner[j]) & (waste[owner[i]] == waste[owner[j]])
    i, j = i[kept], j[kept]
    apart = np.minimum(_distances(contours, i, j), _distances(contours, j, i))
    near = apart < distance
    return owner[i[near]].astype(np.int64), owner[j[near]].astype(np.int64), apart[near]


@kernel
def _lowest_of_sets(contour_a: I64_1, contour_b: I64_1, layer: I64_1) -> Any:
    """Return the lowest layer in the set of each of p contours, (p,).

    Contours of a pair belong to the same set.

    ``contour_a``, ``contour_b`` (k,): indices of the contours of each pair.
    ``layer`` (p,): layer of each contour.
    """
    parent = np.arange(len(layer))
    for pair in range(len(contour_a)):
        union(parent, contour_a[pair], contour_b[pair])
    flatten(parent)
    lowest = layer.copy()
    for contour in range(len(layer)):
        root = parent[contour]
        lowest[root] = min(lowest[root], layer[contour])
    for contour in range(len(layer)):
        lowest[contour] = lowest[parent[contour]]
    return lowest


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
