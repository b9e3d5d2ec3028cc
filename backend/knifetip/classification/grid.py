"""grid: which lines pass through which cell, so that neighbours are found without a search.

ends, bulge -> Grid, or None where lines are so crowded that it would not help
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np
from numba import njit

from knifetip.classification.segment import BULGE
from knifetip.geometry.columns import F64, I32

#: At so many pairs of lines in one cell, as a multiple of the edges, a drawing is too tangled.
_WORK: Final = 400
#: Where most of the edges are is told by so many of them.
_SAMPLE: Final = 10_000


class Grid(NamedTuple):
    """Which edges pass through which cell."""

    low: F64  #: (2,)
    size: F64  #: (2,) of a cell
    side: int  #: cells in each direction
    first: I32  #: (side² + 1,)
    listed: I32  #: edges, cell by cell


def gridded(ends: F64, bulge: F64, touch: float, reach: float) -> Grid | None:
    """Return the cells of n edges, (n, 2, 2) and (n,); n is not 0.

    Parameters
    ----------
    touch
        Edges nearer than this to a cell are in it.
    reach
        How far beyond the edges somebody may ask.
    """
    count = len(bulge)
    boxes = np.empty((count, 4))
    bounds = np.array([np.inf, np.inf, -np.inf, -np.inf])
    _boxes(ends, bulge, boxes, bounds)
    low, high = bounds[:2] - 2.0 * reach, bounds[2:] + 2.0 * reach
    # A speck far away must not put all the rest into one cell: what lies outside counts to the rim.
    near, far = np.percentile(boxes[:: count // _SAMPLE + 1, :2], (2.0, 98.0), axis=0)
    near, far = near - (far - near), far + (far - near)
    low, high = np.maximum(low, near), np.maximum(np.minimum(high, far), low)
    side = max(1, math.isqrt(count))
    while True:
        size = np.maximum((high - low) / side, 4.0 * touch)
        cells, total = _counted(ends, bulge, boxes, low, size, side, touch, 8 * count + 4096)
        if total >= 0:
            break
        if side == 1:
            return None
        side = max(1, side // 2)
    grid = Grid(low, size, side, *_filled(ends, bulge, boxes, low, size, side, touch, cells))
    if (np.diff(grid.first).astype(np.int64) ** 2).sum() > _WORK * count + 1_000_000:
        return None
    return grid


@njit(cache=True, error_model="numpy")
def _boxes(ends: Any, bulge: Any, boxes: Any, bounds: Any) -> None:
    """Write the box of each edge, and of all."""
    for i in range(len(bulge)):
        ax, ay, bx, by = ends[i, 0, 0], ends[i, 0, 1], ends[i, 1, 0], ends[i, 1, 1]
        boxes[i, 0], boxes[i, 2] = min(ax, bx), max(ax, bx)
        boxes[i, 1], boxes[i, 3] = min(ay, by), max(ay, by)
        b = bulge[i]
        if abs(b) > BULGE:
            # The box of the chord and its sagitta on either side holds the arc, up to half a turn.
            sagitta = 0.5 * abs(b) * math.hypot(bx - ax, by - ay)
            boxes[i, 0] -= sagitta
            boxes[i, 1] -= sagitta
            boxes[i, 2] += sagitta
            boxes[i, 3] += sagitta
        for axis in range(2):
            bounds[axis] = min(bounds[axis], boxes[i, axis])
            bounds[axis + 2] = max(bounds[axis + 2], boxes[i, axis + 2])


@njit(cache=True, error_model="numpy")
def cell_of(value: float, low: float, size: float, side: int) -> int:
    """The row or column of cells that a coordinate is in; what lies outside counts to the rim."""
    return min(max(int((value - low) / size), 0), side - 1)


@njit(cache=True, error_model="numpy")
def _rows(
    ends: Any, bulge: Any, boxes: Any, i: int, left: float, right: float, pad: float
) -> tuple[float, float]:
    """Between which y a segment runs in a column of cells."""
    if abs(bulge[i]) > BULGE:
        return boxes[i, 1] - pad, boxes[i, 3] + pad
    ax, ay, bx, by = ends[i, 0, 0], ends[i, 0, 1], ends[i, 1, 0], ends[i, 1, 1]
    if ax > bx:
        ax, ay, bx, by = bx, by, ax, ay
    if bx - ax <= right - left:
        return min(ay, by) - pad, max(ay, by) + pad
    slope = (by - ay) / (bx - ax)
    y0 = ay + slope * (max(ax, left - pad) - ax)
    y1 = ay + slope * (min(bx, right + pad) - ax)
    return min(y0, y1) - pad, max(y0, y1) + pad


@njit(cache=True, error_model="numpy")
def _counted(
    ends: Any, bulge: Any, boxes: Any, low: Any, size: Any, side: int, pad: float, most: int
) -> Any:
    count = np.zeros(side * side + 1, np.int32)
    total = 0
    for i in range(len(bulge)):
        c0 = cell_of(boxes[i, 0] - pad, low[0], size[0], side)
        c1 = cell_of(boxes[i, 2] + pad, low[0], size[0], side)
        for c in range(c0, c1 + 1):
            left = low[0] + c * size[0]
            y0, y1 = _rows(ends, bulge, boxes, i, left, left + size[0], pad)
            r0 = cell_of(y0, low[1], size[1], side)
            r1 = cell_of(y1, low[1], size[1], side)
            for r in range(r0, r1 + 1):
                count[r * side + c + 1] += 1
            total += r1 - r0 + 1
        if total > most:
            return count, -1
    return count, total


@njit(cache=True, error_model="numpy")
def _filled(
    ends: Any, bulge: Any, boxes: Any, low: Any, size: Any, side: int, pad: float, count: Any
) -> Any:
    first = np.cumsum(count).astype(np.int32)
    listed = np.empty(first[-1], np.int32)
    put = first[:-1].copy()
    for i in range(len(bulge)):
        c0 = cell_of(boxes[i, 0] - pad, low[0], size[0], side)
        c1 = cell_of(boxes[i, 2] + pad, low[0], size[0], side)
        for c in range(c0, c1 + 1):
            left = low[0] + c * size[0]
            y0, y1 = _rows(ends, bulge, boxes, i, left, left + size[0], pad)
            r0 = cell_of(y0, low[1], size[1], side)
            r1 = cell_of(y1, low[1], size[1], side)
            for r in range(r0, r1 + 1):
                listed[put[r * side + c]] = i
                put[r * side + c] += 1
    return first, listed
