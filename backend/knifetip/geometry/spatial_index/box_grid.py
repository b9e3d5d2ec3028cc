"""box_grid: lists of bounding boxes by the cells of a uniform grid, for boxes of similar size.

Such boxes lie in few cells, and a cell contains few boxes.  A search then reads one or two short
lists, where a tree visits all its levels.  For boxes that differ too much, or that lie too close
together, no grid is made; ``box_tree`` serves them at any size and density.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry.spatial_index.cells import cell_of, group_by_cell
from knifetip.kernels import F64_2, I32_1, kernel

#: Largest number of cells in which a box lies, on average.
_CELLS_PER_BOX: Final = 6
#: Largest number of pairs of boxes with a common cell, per box.
_PAIRS_PER_BOX: Final = 100
#: A grid of few boxes may exceed both limits by this number.
_FREE: Final = 1000


class BoxGrid(NamedTuple):
    """A grid of square cells over n bounding boxes, and the boxes in each cell.

    The boxes in the cell of column c and row r are ``listed[first[k] : first[k + 1]]`` with
    k = c * ``tall`` + r, in ascending order.
    """

    low_x: float  #: least x and y of the grid, mm
    low_y: float
    size: float  #: width of a cell, mm
    wide: int  #: number of columns
    tall: int  #: number of rows
    first: I32_1  #: (wide * tall + 1,)
    listed: I32_1  #: rows of the boxes, cell by cell


@kernel
def build_grid(boxes: F64_2) -> Any:
    """Return whether a grid suits n ≥ 1 bounding boxes, and that grid.

    If it does not, the grid that is returned is empty.  ``boxes`` (n, 4) are x min, y min, x max
    and y max.
    """
    low_x = low_y = np.inf
    high_x = high_y = -np.inf
    for i in range(len(boxes)):
        low_x, low_y = min(low_x, boxes[i, 0]), min(low_y, boxes[i, 1])
        high_x, high_y = max(high_x, boxes[i, 2]), max(high_y, boxes[i, 3])
    width, height = high_x - low_x, high_y - low_y
    if not (width < np.inf and height < np.inf):
        return False, _no_grid()
    # About one cell for each box.
    size = max(math.sqrt(width * height / len(boxes)), max(width, height) / len(boxes), 1e-6)
    wide = min(int(width / size), len(boxes)) + 1
    tall = min(int(height / size), len(boxes)) + 1
    limit = _CELLS_PER_BOX * len(boxes) + _FREE
    cell, entry = np.empty(limit, np.int32), np.empty(limit, np.int32)
    used = 0
    for i in range(len(boxes)):
        c0 = cell_of(boxes[i, 0], low_x, size, wide)
        c1 = cell_of(boxes[i, 2], low_x, size, wide)
        r0 = cell_of(boxes[i, 1], low_y, size, tall)
        r1 = cell_of(boxes[i, 3], low_y, size, tall)
        if used + (c1 - c0 + 1) * (r1 - r0 + 1) > limit:
            return False, _no_grid()
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                cell[used] = c * tall + r
                entry[used] = i
                used += 1
    first, listed = group_by_cell(cell[:used], wide * tall, entry[:used])
    pairs = 0
    for k in range(wide * tall):
        pairs += (first[k + 1] - first[k]) ** 2
    suits = pairs <= _PAIRS_PER_BOX * len(boxes) + _FREE
    return suits, BoxGrid(low_x, low_y, size, wide, tall, first, listed)


@kernel
def _no_grid() -> Any:
    """Return an empty grid, which is not searched."""
    return BoxGrid(0.0, 0.0, 1.0, 0, 0, np.zeros(1, np.int32), np.empty(0, np.int32))
