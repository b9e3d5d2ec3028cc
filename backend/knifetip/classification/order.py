"""order: edges so numbered that neighbours follow each other.

    ends -> the order in which to look at edges, where their own is no help

All that is looked up about an edge is near what is looked up about its neighbours.  Programs draw
line by line along a carton, and most files are so ordered; what lies in them by chance takes twice
as long to look at.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.kernels import F64_3, kernel

#: Fewer edges than this lie near each other in any order.
_MANY: Final = 20_000
#: The next edge is far away beyond this share of the drawing's size …
_FAR: Final = 1.0 / 16.0
#: … and so many of all may be.
_LEAPS: Final = 0.2
#: Cells along each side of the drawing, a power of two.
_CELLS: Final = 256


def neighbourly(ends: F64) -> I64 | None:
    """Return an order of n edges, (n, 2, 2), by where they begin; None where theirs is as good."""
    if len(ends) < _MANY:
        return None
    left, low, size = _frame(ends)
    if _leaps(ends, _FAR * size) <= _LEAPS * len(ends):
        return None
    order: I64 = _by_cell(ends, left, low, _CELLS / size)
    return order


@kernel
def _spread(number: int) -> int:
    """Return a number of eight bits with a 0 between any two of them."""
    number = (number | number << 4) & 0x0F0F
    number = (number | number << 2) & 0x3333
    return (number | number << 1) & 0x5555


@kernel
def _frame(ends: F64_3) -> Any:
    """Return the least x and the least y of beginnings, and how far they reach."""
    left = right = ends[0, 0, 0]
    low = high = ends[0, 0, 1]
    for i in range(len(ends)):
        x, y = ends[i, 0, 0], ends[i, 0, 1]
        left, right = min(left, x), max(right, x)
        low, high = min(low, y), max(high, y)
    return np.array([left, low, max(right - left, high - low)])


@kernel
def _leaps(ends: F64_3, far: float) -> int:
    """Return how many edges are far from the one before."""
    leaps = 0
    for i in range(1, len(ends)):
        across, along = ends[i, 0, 0] - ends[i - 1, 0, 0], ends[i, 0, 1] - ends[i - 1, 0, 1]
        leaps += abs(across) > far or abs(along) > far
    return leaps


@kernel
def _by_cell(ends: F64_3, left: float, low: float, scale: float) -> Any:
    """Return the edges in the order of their cells, and the cells in that of Morton."""
    count = len(ends)
    cell = np.empty(count, np.int64)
    first = np.zeros(_CELLS * _CELLS + 1, np.int64)
    for i in range(count):
        column = min(int((ends[i, 0, 0] - left) * scale), _CELLS - 1)
        row = min(int((ends[i, 0, 1] - low) * scale), _CELLS - 1)
        cell[i] = _spread(column) | _spread(row) << 1
        first[cell[i] + 1] += 1
    first = np.cumsum(first)
    order = np.empty(count, np.int64)
    for i in range(count):
        order[first[cell[i]]] = i
        first[cell[i]] += 1
    return order
