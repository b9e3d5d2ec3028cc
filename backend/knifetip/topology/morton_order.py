"""morton_order: sort edges so that neighbours in the plane are neighbours in memory.

The order of a file is kept if most edges already follow a neighbour, as most programs write them.
For a file in random order, a search for neighbours takes twice as long without sorting.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.geometry.spatial_index.morton import morton_code
from knifetip.kernels import F64_3, kernel

#: Number of edges below which the order does not matter, because they fit into the cache.
_MANY: Final = 20_000
#: An edge is far from the preceding edge beyond this fraction of the drawing's size.
_FAR: Final = 1.0 / 16.0
#: Largest fraction of edges that may be far from the preceding edge in an order that is kept.
_LEAPS: Final = 0.2
#: Number of columns and of rows of cells, a power of two.
_CELLS: Final = 256


def spatial_order(ends: F64) -> I64 | None:
    """Return an order of n edges in which neighbours follow one another, (n,), or None.

    None means that sorting is not worthwhile, because there are few edges or because most edges
    already follow a neighbour.

    Parameters
    ----------
    ends : (n, 2, 2)
        Start and end point of each edge.
    """
    if len(ends) < _MANY:
        return None
    left, low, size = _start_extent(ends)
    if _count_leaps(ends, _FAR * size) <= _LEAPS * len(ends):
        return None
    order: I64 = _sort_by_cell(ends, left, low, _CELLS / size)
    return order


@kernel
def _start_extent(ends: F64_3) -> Any:
    """Return the extent of the start points of n edges: least x, least y, and size, (3,).

    The size is the larger of width and height of their bounding box.  ``ends`` (n, 2, 2) are the
    start and end points of the edges.
    """
    left = right = ends[0, 0, 0]
    low = high = ends[0, 0, 1]
    for i in range(len(ends)):
        x, y = ends[i, 0, 0], ends[i, 0, 1]
        left, right = min(left, x), max(right, x)
        low, high = min(low, y), max(high, y)
    return np.array([left, low, max(right - left, high - low)])


@kernel
def _count_leaps(ends: F64_3, max_step: float) -> int:
    """Return how many of n edges have a start far from the start of the preceding edge.

    Two starts are far from each other if they are more than ``max_step`` apart in x or in y.
    ``ends`` (n, 2, 2) are the start and end points of the edges.
    """
    leaps = 0
    for i in range(1, len(ends)):
        across, along = ends[i, 0, 0] - ends[i - 1, 0, 0], ends[i, 0, 1] - ends[i - 1, 0, 1]
        leaps += abs(across) > max_step or abs(along) > max_step
    return leaps


@kernel
def _sort_by_cell(ends: F64_3, left: float, low: float, scale: float) -> Any:
    """Return the indices of n edges in Morton order, (n,), which puts neighbours close together.

    The edges are sorted by the Morton code of a grid cell: the cell that contains the start point
    of the edge.

    ``ends`` (n, 2, 2): start and end points of the edges.
    ``left``, ``low``: least x and least y of the start points.
    ``scale``: number of grid cells per unit of length.
    """
    count = len(ends)
    cell = np.empty(count, np.int64)
    first = np.zeros(_CELLS * _CELLS + 1, np.int64)
    for i in range(count):
        column = min(int((ends[i, 0, 0] - left) * scale), _CELLS - 1)
        row = min(int((ends[i, 0, 1] - low) * scale), _CELLS - 1)
        cell[i] = morton_code(column, row)
        first[cell[i] + 1] += 1
    first = np.cumsum(first)
    order = np.empty(count, np.int64)
    for i in range(count):
        order[first[cell[i]]] = i
        first[cell[i]] += 1
    return order
