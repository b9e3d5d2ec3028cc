"""morton_order: an order of edges in which neighbours follow one another.

    ends -> permutation, or None if the order of the file is good enough

Lookups about an edge touch memory near that of its neighbours.  Most programs write a carton line
by line; for a file in random order the lookups take twice as long.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.geometry.spatial_index.morton import morton_code
from knifetip.kernels import F64_3, kernel

#: Fewer edges fit into the cache in any order.
_MANY: Final = 20_000
#: The next edge is far away beyond this fraction of the drawing's size …
_FAR: Final = 1.0 / 16.0
#: … and this fraction of all edges may be far from the one before.
_LEAPS: Final = 0.2
#: Cells along each side of the drawing, a power of two.
_CELLS: Final = 256


def spatial_order(ends: F64) -> I64 | None:
    """Return a spatial order of n edges, (n, 2, 2); None if their own is good enough."""
    if len(ends) < _MANY:
        return None
    left, low, size = _frame(ends)
    if _leaps(ends, _FAR * size) <= _LEAPS * len(ends):
        return None
    order: I64 = _by_cell(ends, left, low, _CELLS / size)
    return order


@kernel
def _frame(ends: F64_3) -> Any:
    """Return the least x and y of the starts, and the larger extent."""
    left = right = ends[0, 0, 0]
    low = high = ends[0, 0, 1]
    for i in range(len(ends)):
        x, y = ends[i, 0, 0], ends[i, 0, 1]
        left, right = min(left, x), max(right, x)
        low, high = min(low, y), max(high, y)
    return np.array([left, low, max(right - left, high - low)])


@kernel
def _leaps(ends: F64_3, far: float) -> int:
    """Return the number of edges that are far from the one before."""
    leaps = 0
    for i in range(1, len(ends)):
        across, along = ends[i, 0, 0] - ends[i - 1, 0, 0], ends[i, 0, 1] - ends[i - 1, 0, 1]
        leaps += abs(across) > far or abs(along) > far
    return leaps


@kernel
def _by_cell(ends: F64_3, left: float, low: float, scale: float) -> Any:
    """Return the edges sorted by the Morton code of their cells."""
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
