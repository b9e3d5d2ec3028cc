"""edge_grid: a uniform grid that lists the edges in each cell, to find edges near a point."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.geometry.spatial_index.cells import cell_of, group_by_cell
from knifetip.kernels import F64_1, F64_2, F64_3, I32_1, OutF64_1, OutF64_2, kernel
from knifetip.topology.segment import BULGE

#: Largest number of pairs of edges in one cell, per edge of the drawing; beyond it no grid is made.
_WORK: Final = 400
#: Number of edges that are sampled to estimate the main area of a drawing.
_SAMPLE: Final = 10_000


class EdgeGrid(NamedTuple):
    """A grid of side × side cells, with the edges that are in or near each cell.

    The edges in cell c are ``listed[first[c] : first[c + 1]]``.
    """

    low: F64_1  #: (2,) x and y of the lower left corner of the grid
    size: F64_1  #: (2,) width and height of a cell
    side: int  #: number of rows and of columns of cells
    first: I32_1  #: (side² + 1,) index in ``listed`` of the first edge of each cell
    listed: I32_1  #: edges in each cell, cell by cell


def build_grid(ends: F64, bulge: F64, tolerance: float, reach: float) -> EdgeGrid | None:
    """Return a grid that lists n ≥ 1 edges by cell.

    Returns None if the edges are too crowded for a grid: so many of them are in each cell that
    searches would be slow.  Lengths are in drawing units.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) and (n,)
        Start and end points and bulges of the edges.
    tolerance
        An edge that is nearer to a cell than this is listed in the cell.
    reach
        Largest distance from an edge at which the grid will be searched.
    """
    count = len(bulge)
    boxes = np.empty((count, 4))
    bounds = np.array([np.inf, np.inf, -np.inf, -np.inf])
    _measure_boxes(ends, bulge, boxes, bounds)
    low, high = bounds[:2] - 2.0 * reach, bounds[2:] + 2.0 * reach
    # One edge far away must not put all others into one cell: border cells take outliers.
    near, far = np.percentile(boxes[:: count // _SAMPLE + 1, :2], (2.0, 98.0), axis=0)
    near, far = near - (far - near), far + (far - near)
    low, high = np.maximum(low, near), np.maximum(np.minimum(high, far), low)
    side = max(1, math.isqrt(count))
    while True:
        size = np.maximum((high - low) / side, 4.0 * tolerance)
        cell, edge = _cells_of_edges(
            ends, bulge, boxes, low, size, side, tolerance, 8 * count + 4096
        )
        if len(cell) > 0:
            break
        if side == 1:
            return None
        side = max(1, side // 2)
    grid = EdgeGrid(low, size, side, *group_by_cell(cell, side * side, edge))
    if (np.diff(grid.first).astype(np.int64) ** 2).sum() > _WORK * count + 1_000_000:
        return None
    return grid


@kernel(allocates=False)
def _measure_boxes(ends: F64_3, bulge: F64_1, boxes: OutF64_2, bounds: OutF64_1) -> None:
    """Write the bounding box of each of n edges to ``boxes``, and enlarge ``bounds`` around them.

    ``boxes`` (n, 4) and ``bounds`` (4,) contain x min, y min, x max and y max.  ``ends`` (n, 2, 2)
    and ``bulge`` (n,) are the end points and bulges of the edges.
    """
    for i in range(len(bulge)):
        ax, ay, bx, by = ends[i, 0, 0], ends[i, 0, 1], ends[i, 1, 0], ends[i, 1, 1]
        boxes[i, 0], boxes[i, 2] = min(ax, bx), max(ax, bx)
        boxes[i, 1], boxes[i, 3] = min(ay, by), max(ay, by)
        b = bulge[i]
        if abs(b) > BULGE:
            # An arc of up to half a turn is in the box of its chord, enlarged by its sagitta.
            sagitta = 0.5 * abs(b) * math.hypot(bx - ax, by - ay)
            boxes[i, 0] -= sagitta
            boxes[i, 1] -= sagitta
            boxes[i, 2] += sagitta
            boxes[i, 3] += sagitta
        for axis in range(2):
            bounds[axis] = min(bounds[axis], boxes[i, axis])
            bounds[axis + 2] = max(bounds[axis + 2], boxes[i, axis + 2])


@kernel
def _y_range(
    ends: F64_3, bulge: F64_1, boxes: F64_2, i: int, left: float, right: float, pad: float
) -> tuple[float, float]:
    """Return the least and the greatest y of edge ``i`` between x = ``left`` and x = ``right``.

    The range is enlarged by ``pad`` at both ends.  ``ends`` (n, 2, 2), ``bulge`` (n,) and ``boxes``
    (n, 4) are the end points, bulges and bounding boxes of the edges.
    """
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


@kernel
def _cells_of_edges(
    ends: F64_3,
    bulge: F64_1,
    boxes: F64_2,
    low: F64_1,
    size: F64_1,
    side: int,
    pad: float,
    limit: int,
) -> Any:
    """Return all pairs of a grid cell and an edge in it, as cell numbers, (k,), and edges, (k,).

    The arrays are empty if there are more than ``limit`` pairs.

    ``ends``, ``bulge`` (n, 2, 2) and (n,): start and end points and bulges of the edges.
    ``boxes`` (n, 4): bounding box of each edge.
    ``low``, ``size`` (2,) and (2,): least x and y of the grid, and width and height of a cell.
    ``side``: number of columns and of rows of the grid.
    ``pad``: an edge counts as in a cell if it is nearer to the cell than this.
    """
    cell, edge = np.empty(limit, np.int32), np.empty(limit, np.int32)
    total = 0
    for i in range(len(bulge)):
        c0 = cell_of(boxes[i, 0] - pad, low[0], size[0], side)
        c1 = cell_of(boxes[i, 2] + pad, low[0], size[0], side)
        for c in range(c0, c1 + 1):
            left = low[0] + c * size[0]
            y0, y1 = _y_range(ends, bulge, boxes, i, left, left + size[0], pad)
            r0 = cell_of(y0, low[1], size[1], side)
            r1 = cell_of(y1, low[1], size[1], side)
            if total + r1 - r0 >= limit:
                return cell[:0], edge[:0]
            for r in range(r0, r1 + 1):
                cell[total], edge[total] = r * side + c, i
                total += 1
    return cell[:total], edge[:total]
