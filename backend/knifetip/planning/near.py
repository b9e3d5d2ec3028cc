"""Near: which segments of one set may touch which of another, found by their boxes."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.boxes import STACK, next_near, tree, tree_size
from knifetip.geometry.columns import F64, I64
from knifetip.kernels import F64_2, kernel

#: Boxes are put in order along a Z-curve through a grid of so many bits a side.
_BITS: Final = 16
#: Masks and shifts that spread 16 bits to every second place of 32.
_SPREAD: Final = ((8, 0x00FF00FF), (4, 0x0F0F0F0F), (2, 0x33333333), (1, 0x55555555))


def near(boxes: F64, others: F64, gap: float) -> tuple[I64, I64]:
    """Return the pairs of boxes that overlap, or lie within ``gap`` mm of each other.

    Parameters
    ----------
    boxes, others : (n, 4) and (m, 4) mm
        x min, y min, x max, y max.

    Returns
    -------
    Rows of ``boxes``, ascending, and for each the rows of ``others``, by their x min.

    Notes
    -----
    A tree over the boxes along a Z-curve: n log m, and the pairs that are found.
    """
    if len(boxes) == 0 or len(others) == 0:
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    order = np.argsort(_z_curve(others), kind="stable")
    one, other = _near(boxes, others[order], gap)
    other = order[other]
    rank = np.empty(len(others), np.int64)
    rank[np.argsort(others[:, 0], kind="stable")] = np.arange(len(others))
    by_place = np.argsort(one * len(others) + rank[other], kind="stable")
    return one[by_place], other[by_place]


def _z_curve(boxes: F64) -> I64:
    """Return the place of each box's middle along a Z-curve, (n,)."""
    middle = boxes[:, :2] + boxes[:, 2:]
    low = middle.min(axis=0)
    size = np.maximum(middle.max(axis=0) - low, 1e-9)
    cell = ((middle - low) / size * ((1 << _BITS) - 1)).astype(np.int64)
    for shift, mask in _SPREAD:
        cell = (cell | (cell << shift)) & mask
    curve: I64 = cell[:, 0] | (cell[:, 1] << 1)
    return curve


@kernel
def _near(boxes: F64_2, others: F64_2, gap: float) -> Any:
    count = len(others)
    nodes = np.empty((tree_size(count), 4))
    nodes[:count] = others
    level = np.empty(24, np.int64)
    height = tree(nodes, count, level)
    stack = np.empty((STACK, 2), np.int64)
    found = 0
    one = np.empty(max(16, len(boxes)), np.int64)
    other = np.empty_like(one)
    for i in range(len(boxes)):
        x0, y0 = boxes[i, 0] - gap, boxes[i, 1] - gap
        x1, y1 = boxes[i, 2] + gap, boxes[i, 3] + gap
        stack[0, 0] = height
        stack[0, 1] = 0
        depth = 1
        while True:
            j, depth = next_near(nodes, level, stack, depth, x0, y0, x1, y1, -1)
            if j < 0:
                break
            if found == len(one):
                one = np.concatenate((one, np.empty_like(one)))
                other = np.concatenate((other, np.empty_like(other)))
            one[found] = i
            other[found] = j
            found += 1
    return one[:found].copy(), other[:found].copy()
