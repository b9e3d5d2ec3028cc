"""points_on_segments: test whether points are on segments, with a tree of bounding boxes."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.intersect import write_box
from knifetip.geometry.spatial_index.box_tree import (
    BoxTree,
    build_tree,
    new_stack,
    next_overlap,
    start_query,
)
from knifetip.geometry.spatial_index.morton import order_boxes
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import (
    F64_1,
    F64_1A,
    F64_2,
    F64_2A,
    I32_1,
    I64_1,
    OutBool_1,
    OutI64_2,
    kernel,
)

#: Smallest sweep of an arc; a segment with a smaller one is a line (radians).
_LEAST_SWEEP: Final = 4.0 * BULGE
#: Fraction of the largest coordinate by which boxes are enlarged, for rounding.
_ROUNDING: Final = 1e-12


def find_points_on_segments(
    points: F64, owner: I32, start: F64, end: F64, bulge: F64, gap: float
) -> Bool:
    """Return the mask of points that are on a segment other than their own, (m,).

    Parameters
    ----------
    points : (m, 2) mm
        The points.
    owner : (m,)
        Number of each point's own segment, which is not searched for this point; -1 if the point
        belongs to no segment.
    start, end, bulge : (n, 2), (n, 2) mm and (n,)
        Ends and bulges of n segments.
    gap : mm
        Largest distance of a point that counts as on a segment.
    """
    if len(points) == 0 or len(bulge) == 0:
        return np.zeros(len(points), np.bool_)
    boxes = _boxes(np.column_stack([start, end, bulge]))
    sweep = arc.sweep(bulge)
    bent = np.flatnonzero(np.abs(sweep) >= _LEAST_SWEEP)
    middle, radius, first = np.zeros((len(bulge), 2)), np.zeros(len(bulge)), np.zeros(len(bulge))
    arcs = start[bent], end[bent], bulge[bent]
    middle[bent], radius[bent] = arc.centre(*arcs), arc.radius(*arcs)
    first[bent] = np.arctan2(*(start[bent] - middle[bent]).T[::-1])
    order = order_boxes(boxes)
    # Enlarged for rounding.
    reach = gap + _ROUNDING * max(float(boxes.max()), -float(boxes.min()))
    hit: Bool = _find_points(
        points, owner, order, boxes[order], reach, start, end, middle, radius, first, sweep, gap
    )
    return hit


@kernel
def _boxes(rows: F64_2) -> Any:
    """Return a box around each segment, (n, 4): x min, y min, x max, y max.

    ``rows`` (n, 5) are the segments: x0, y0, x1, y1, bulge.  The box of an arc may be larger than
    necessary.
    """
    boxes = np.empty((len(rows), 4))
    for i in range(len(rows)):
        write_box(rows, i, boxes, i)
    return boxes


@kernel
def _find_points(
    points: F64_2,
    owner: I32_1,
    order: I64_1,
    boxes: F64_2,
    reach: float,
    start: F64_2A,
    end: F64_2A,
    middle: F64_2,
    radius: F64_1,
    first: F64_1,
    sweep: F64_1,
    gap: float,
) -> Any:
    """Return the mask of points that are on a segment other than their own, (m,).

    Parameters
    ----------
    points : (m, 2) mm
        The points.
    owner : (m,)
        Number of the segment that each point belongs to, -1 for none.
    order, boxes : (n,) and (n, 4)
        Segments in Morton order, and their bounding boxes.
    reach : mm
        Distance from a point within which bounding boxes are searched.
    start, end : (n, 2) mm
        Start and end points of the segments.
    middle, radius, first, sweep : (n, 2), (n,), (n,), (n,)
        Centre and radius (mm), angle of the start and sweep (radians) of each arc.
    gap : mm
        Largest distance of a point that counts as on a segment.
    """
    hit = np.zeros(len(points), np.bool_)
    segments = _Segments(order, start, end, middle, radius, first, sweep)
    _mark_points(points, owner, segments, build_tree(boxes), new_stack(), reach, gap, hit)
    return hit


class _Segments(NamedTuple):
    """The segments that ``_find_points`` compares with points; it describes the fields."""

    order: I64_1
    start: F64_2A
    end: F64_2A
    middle: F64_2
    radius: F64_1
    first: F64_1
    sweep: F64_1


@kernel(allocates=False)
def _mark_points(
    points: F64_2,
    owner: I32_1,
    segments: _Segments,
    tree: BoxTree,
    stack: OutI64_2,
    reach: float,
    gap: float,
    hit: OutBool_1,
) -> None:
    """Set the entries of ``hit``, (m,), of the points that are on a segment other than their own.

    ``_find_points`` describes the arguments.
    """
    for k in range(len(points)):
        x, y = points[k, 0], points[k, 1]
        depth = start_query(tree, stack)
        while not hit[k]:
            at, depth = next_overlap(
                tree.boxes, tree.level, stack, depth, x - reach, y - reach, x + reach, y + reach, -1
            )
            if at < 0:
                break
            i = segments.order[at]
            hit[k] = (
                i != owner[k]
                and _distance(
                    points[k],
                    segments.start[i],
                    segments.end[i],
                    segments.middle[i],
                    segments.radius[i],
                    segments.first[i],
                    segments.sweep[i],
                )
                <= gap
            )


@kernel(allocates=False, checks_division=True)
def _distance(
    point: F64_1,
    start: F64_1A,
    end: F64_1A,
    middle: F64_1,
    radius: float,
    first: float,
    sweep: float,
) -> float:
    """Return the distance of a point from a line or an arc (mm).

    The line or arc goes from ``start`` to ``end``; it is a line if ``sweep`` is almost 0.  An arc
    has its centre at ``middle`` and the ``radius`` (mm); it starts at the angle ``first`` and turns
    by the angle ``sweep`` (radians).
    """
    if abs(sweep) >= _LEAST_SWEEP:
        angle = math.atan2(point[1] - middle[1], point[0] - middle[0]) - first
        if sweep < 0:
            angle = -angle
        if angle % (2.0 * math.pi) <= abs(sweep):
            return abs(math.hypot(point[0] - middle[0], point[1] - middle[1]) - radius)
        return min(
            math.hypot(point[0] - start[0], point[1] - start[1]),
            math.hypot(point[0] - end[0], point[1] - end[1]),
        )
    x = end[0] - start[0]
    y = end[1] - start[1]
    square = x * x + y * y
    along = 0.0
    if square > 0.0:
        along = ((point[0] - start[0]) * x + (point[1] - start[1]) * y) / square
        along = min(max(along, 0.0), 1.0)
    return math.hypot(point[0] - start[0] - along * x, point[1] - start[1] - along * y)
