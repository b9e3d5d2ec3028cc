"""divided_contours: join the outlines of parts that cuts divide to one contour.

Cuts between two parts end on the outline of both.  Beside it the cutter runs on an offset, and only
a closed contour has an offset that keeps the cutter out of other contours.  So the outline round
all the parts is one contour, as far as its pieces have one layer.  Pieces of different layers stay
separate, open paths, in the order in which no piece of board is cut that is already loose.  They
are joined too where the cutter would run into another contour, and round a hole, whose pieces are
waste; such a contour has the lowest of the layers.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.columns import F64, I8, I64, Bool
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import SAME
from knifetip.geometry.union_find import flatten, union
from knifetip.geometry.vertices import number_vertices

#: Positions on each piece at which the distance of the cutter from other contours is measured.
_PLACES: Final = np.linspace(0.05, 0.95, 13)


def join_contours(
    ends: F64, bulge: F64, waste: I8, removed: I8, part: I64, layer: I64, radius: float
) -> tuple[I64, I64]:
    """Return the contour to which each of q pieces of cuts belongs, (q,), -1 for none, and the
    layer of each piece, (q,), which is that of its contour.

    Parameters
    ----------
    ends, bulge : (q, 2, 2) mm and (q,)
        Start and end points, and bulges, of the pieces.
    waste, removed : (q,)
        Side of the waste round a part, and side without board round a part or in a hole: +1 left,
        -1 right, 0 none.
    part : (q,)
        Number of the part or hole that each piece bounds, -1 for none.
    layer : (q,)
        Layer of each piece from ``layers.cut_layers``.
    radius : mm
        Radius of the cutter.
    """
    rows = np.flatnonzero(part >= 0)
    one, other = _neighbours(ends[rows])
    one, other = rows[one], rows[other]
    count = int(part.max(initial=-1)) + 1
    whole = _connect_numbers(part[one], part[other], count)
    same = layer[one] == layer[other]
    joined = _connect_numbers(part[one[same]], part[other[same]], count)
    is_open = np.zeros(count, np.bool_)
    is_open[whole[joined != whole]] = True
    if is_open.any():
        beside = rows[is_open[whole[part[rows]]]]
        near = _runs_into_others(ends, bulge, removed, beside, rows, radius)
        crowded = np.zeros(count, np.bool_)
        crowded[whole[part[beside[near | (waste[beside] == 0)]]]] = True
        joined = np.where(crowded[whole], whole, joined)
    lowest = np.full(count, layer.max(initial=0))
    np.minimum.at(lowest, joined[part[rows]], layer[rows])
    contour = np.append(joined, -1)[part]
    return contour, np.where(contour < 0, layer, np.append(lowest, 0)[contour])


def _neighbours(ends: F64) -> tuple[I64, I64]:
    """Return the pairs of n pieces that meet at a point at which no other piece ends."""
    vertex = number_vertices(ends.reshape(-1, 2))
    order = np.argsort(vertex, kind="stable")
    first = np.flatnonzero(np.append(True, np.diff(vertex[order]) != 0)[: len(order)])
    first = first[np.diff(np.append(first, len(order))) == 2]
    return order[first] // 2, order[first + 1] // 2


def _connect_numbers(number_a: I64, number_b: I64, count: int) -> I64:
    """Return the lowest number of those connected with each of ``count`` numbers, (count,)."""
    parent = np.arange(count)
    for a, b in zip(number_a.tolist(), number_b.tolist(), strict=True):
        union(parent, a, b)
    flatten(parent)
    return parent


def _runs_into_others(
    ends: F64, bulge: F64, removed: I8, rows: I64, others: I64, radius: float
) -> Bool:
    """Return the mask of the pieces ``rows`` beside which the disc would run into ``others``.

    The other parameters are those of ``join_contours``.
    """
    boxes = arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge)
    i, j = box_pairs(boxes[rows], boxes[others], 2.0 * radius)
    own, j = rows[i], others[j]
    keep = own != j
    i, own, j = i[keep], own[keep], j[keep]
    result = np.zeros(len(rows), np.bool_)
    curve = ends[own, 0], ends[own, 1], bulge[own]
    facing = ends[j, 0], ends[j, 1], bulge[j]
    for place in _PLACES:
        fraction = np.full(len(own), place)
        normal = left_normal(unit_vectors(arc.tangent_at(*curve, fraction)))
        centre = arc.point_at(*curve, fraction) + radius * removed[own][:, None] * normal
        nearest = arc.point_at(*facing, arc.nearest_fraction(*facing, centre))
        result[i[np.hypot(*(nearest - centre).T) < radius - SAME]] = True
    return result
