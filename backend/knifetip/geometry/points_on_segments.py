"""points_on_segments: test whether points are on segments, with a grid of bounding boxes.

A tree takes the place of the grid for segments that no grid suits.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.intersect import write_box
from knifetip.geometry.spatial_index.box_grid import BoxGrid, build_grid
from knifetip.geometry.spatial_index.box_tree import (
    build_tree,
    new_stack,
    next_overlap,
    start_query,
)
from knifetip.geometry.spatial_index.cells import cell_of
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
    boxes = _boxes(start, end, bulge)
    sweep = arc.sweep(bulge)
    bent = np.flatnonzero(np.abs(sweep) >= _LEAST_SWEEP)
    middle, radius, first = np.zeros((len(bulge), 2)), np.zeros(len(bulge)), np.zeros(len(bulge))
    arcs = start[bent], end[bent], bulge[bent]
    middle[bent], radius[bent] = arc.centre(*arcs), arc.radius(*arcs)
    first[bent] = np.arctan2(*(start[bent] - middle[bent]).T[::-1])
    # Enlarged for rounding.
    reach = gap + _ROUNDING * max(float(boxes.max()), -float(boxes.min()))
    hit = np.zeros(len(points), np.bool_)
    shapes = start, end, middle, radius, first, sweep
    every = np.arange(len(bulge))
    if not _mark_by_grid(points, owner, _Segments(every, *shapes), boxes, reach, gap, hit):
        order = order_boxes(boxes)
        _mark_by_tree(points, owner, _Segments(order, *shapes), boxes[order], reach, gap, hit)
    return hit


@kernel
def _boxes(start: F64_2A, end: F64_2A, bulge: F64_1A) -> Any:
    """Return a box around each segment, (n, 4): x min, y min, x max, y max.

    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the segments.  The box of an arc may be
    larger than necessary.
    """
    boxes, segment = np.empty((len(bulge), 4)), np.empty((1, 5))
    for i in range(len(bulge)):
        for axis in range(2):
            segment[0, axis], segment[0, axis + 2] = start[i, axis], end[i, axis]
        segment[0, 4] = bulge[i]
        write_box(segment, 0, boxes, i)
    return boxes


class _Segments(NamedTuple):
    """n segments, and the order in which they are in an index of boxes."""

    order: I64_1  #: (n,) row of the segment of each box of the index
    start: F64_2A  #: (n, 2) mm
    end: F64_2A  #: (n, 2) mm
    middle: F64_2  #: (n, 2) mm, centre of each arc
    radius: F64_1  #: (n,) mm
    first: F64_1  #: (n,) radians, angle of the start of each arc
    sweep: F64_1  #: (n,) radians


@kernel
def _mark_by_grid(
    points: F64_2,
    owner: I32_1,
    segments: _Segments,
    boxes: F64_2,
    reach: float,
    gap: float,
    hit: OutBool_1,
) -> Any:
    """Set the entries of ``hit``, (m,), of the points that are on a segment other than their own.

    Returns False and sets nothing if no grid suits the segments.

    ``points`` (m, 2) mm: the points.
    ``owner`` (m,): number of the segment that each point belongs to, -1 for none.
    ``segments``, ``boxes`` (n,) and (n, 4): the segments, and their bounding boxes in the order of
    ``segments.order``.
    ``reach`` mm: distance from a point within which bounding boxes are searched.
    ``gap`` mm: largest distance of a point that counts as on a segment.
    """
    suits, grid = build_grid(boxes)
    if suits:
        for k in range(len(points)):
            hit[k] = _search_cells(points[k], owner[k], segments, boxes, grid, reach, gap)
    return suits


@kernel(allocates=False)
def _search_cells(
    point: F64_1,
    owner: int,
    segments: _Segments,
    boxes: F64_2,
    grid: BoxGrid,
    reach: float,
    gap: float,
) -> bool:
    """Return whether a point is on a segment other than ``owner``; see ``_mark_by_grid``."""
    x0, y0, x1, y1 = point[0] - reach, point[1] - reach, point[0] + reach, point[1] + reach
    r0 = cell_of(y0, grid.low_y, grid.size, grid.tall)
    r1 = cell_of(y1, grid.low_y, grid.size, grid.tall)
    for c in range(
        cell_of(x0, grid.low_x, grid.size, grid.wide),
        cell_of(x1, grid.low_x, grid.size, grid.wide) + 1,
    ):
        for r in range(r0, r1 + 1):
            cell = c * grid.tall + r
            for k in range(grid.first[cell], grid.first[cell + 1]):
                at = grid.listed[k]
                near = (boxes[at, 0] <= x1) & (boxes[at, 2] >= x0)
                near &= (boxes[at, 1] <= y1) & (boxes[at, 3] >= y0)
                if near and _is_on(point, segments, segments.order[at], owner, gap):
                    return True
    return False


@kernel
def _mark_by_tree(
    points: F64_2,
    owner: I32_1,
    segments: _Segments,
    boxes: F64_2,
    reach: float,
    gap: float,
    hit: OutBool_1,
) -> None:
    """Set the entries of ``hit``, (m,), of the points that are on a segment other than their own.

    The segments must be in Morton order.  ``_mark_by_grid`` describes the arguments.
    """
    tree, stack = build_tree(boxes), new_stack()
    for k in range(len(points)):
        x, y = points[k, 0], points[k, 1]
        depth = start_query(tree, stack)
        while not hit[k]:
            box = (x - reach, y - reach, x + reach, y + reach)
            at, depth = next_overlap(tree.boxes, tree.level, stack, depth, box, -1)
            if at < 0:
                break
            hit[k] = _is_on(points[k], segments, segments.order[at], owner[k], gap)


@kernel(allocates=False)
def _is_on(point: F64_1, segments: _Segments, row: int, owner: int, gap: float) -> bool:
    """Return whether a point is at most ``gap`` mm from a segment that is not its own."""
    return (
        row != owner
        and _distance(
            point,
            segments.start[row],
            segments.end[row],
            segments.middle[row],
            segments.radius[row],
            segments.first[row],
            segments.sweep[row],
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
