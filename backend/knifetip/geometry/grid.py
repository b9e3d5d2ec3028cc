"""grid: test whether points are on segments, with a uniform grid of cells."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_1, F64_1A, F64_2, F64_2A, I32_1, I64_2, kernel


def points_on_segments(points: F64, own: I32, start: F64, end: F64, bulge: F64, gap: float) -> Bool:
    """Return the mask of points that are on a segment other than their own, (m,).

    Parameters
    ----------
    points : (m, 2) mm
    own : (m,)
        Segment that each point belongs to and that is ignored; -1 for none.
    start, end, bulge : (n, 2), (n, 2) mm and (n,)
        The segments, lines and arcs.
    gap : mm
        Largest distance of a point that counts as on a segment.
    """
    if len(points) == 0 or len(bulge) == 0:
        return np.zeros(len(points), np.bool_)
    boxes = arc.bounding_boxes(start, end, bulge) + np.array([-gap, -gap, gap, gap])
    low = boxes[:, :2].min(axis=0)
    high = boxes[:, 2:].max(axis=0)
    side = max(1, math.isqrt(len(bulge)))
    size = np.maximum((high - low) / side, gap)
    cells = np.clip(((boxes - np.tile(low, 2)) / np.tile(size, 2)).astype(np.int64), 0, side - 1)
    places = np.floor((points - low) / size).astype(np.int64)
    middle = arc.centre(start, end, bulge)
    radius = arc.radius(start, end, bulge)
    first = np.arctan2(*(start - middle).T[::-1])
    hit: Bool = _points_on_segments(
        points, own, places, cells, side, start, end, middle, radius, first, arc.sweep(bulge), gap
    )
    return hit


@kernel
def _points_on_segments(
    points: F64_2,
    own: I32_1,
    places: I64_2,
    cells: I64_2,
    side: int,
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
    points, own, start, end, gap
        As for ``points_on_segments``.
    places : (m, 2)
        Column and row of the cell of each point.
    cells : (n, 4)
        First column and row, last column and row of the cells of each segment.
    side
        Number of columns, and of rows, of the grid.
    middle, radius, first, sweep
        Centre, radius (mm), angle of the start and sweep (radians) of each arc.
    """
    count = np.zeros(side * side + 1, np.int64)
    for i in range(len(cells)):
        for x in range(cells[i, 0], cells[i, 2] + 1):
            for y in range(cells[i, 1], cells[i, 3] + 1):
                count[x * side + y + 1] += 1
    count = np.cumsum(count)
    listed = np.empty(count[-1], np.int64)
    filled = count[:-1].copy()
    for i in range(len(cells)):
        for x in range(cells[i, 0], cells[i, 2] + 1):
            for y in range(cells[i, 1], cells[i, 3] + 1):
                listed[filled[x * side + y]] = i
                filled[x * side + y] += 1
    hit = np.zeros(len(points), np.bool_)
    for k in range(len(points)):
        x = places[k, 0]
        y = places[k, 1]
        if x < 0 or y < 0 or x > side or y > side:
            continue
        cell = min(x, side - 1) * side + min(y, side - 1)
        for place in range(count[cell], count[cell + 1]):
            i = listed[place]
            if (
                i != own[k]
                and _distance(points[k], start[i], end[i], middle[i], radius[i], first[i], sweep[i])
                <= gap
            ):
                hit[k] = True
                break
    return hit


@kernel(checks_division=True)
def _distance(
    point: F64_1,
    start: F64_1A,
    end: F64_1A,
    middle: F64_1,
    radius: float,
    first: float,
    sweep: float,
) -> float:
    """Return the distance of a point from a line or an arc (mm)."""
    if abs(sweep) >= 4.0 * BULGE:
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
