"""box_pairs: pairs of bounding boxes, of two sets, that overlap or nearly do."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.boxes import STACK, next_near, tree, tree_size
from knifetip.geometry.columns import F64, I64
from knifetip.kernels import F64_2, kernel

#: Bits per coordinate of a Morton code.
_BITS: Final = 16
#: Shifts and masks that spread 16 bits over every second bit of 32.
_SPREAD: Final = ((8, 0x00FF00FF), (4, 0x0F0F0F0F), (2, 0x33333333), (1, 0x55555555))


def box_pairs(boxes: F64, others: F64, gap: float) -> tuple[I64, I64]:
    """Return the pairs of boxes of two sets that are at most ``gap`` mm apart in x and in y.

    Parameters
    ----------
    boxes, others : (n, 4) and (m, 4) mm
        x min, y min, x max, y max.

    Returns
    -------
    Rows of ``boxes``, ascending, and rows of ``others``, for each row of ``boxes`` by x min.

    Notes
    -----
    Searches a packed tree over ``others`` in Morton order: O(n log m + pairs).
    """
    if len(boxes) == 0 or len(others) == 0:
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    order = np.argsort(_morton_codes(others), kind="stable")
    one, other = _find_pairs(boxes, others[order], gap)
    other = order[other]
    rank = np.empty(len(others), np.int64)
    rank[np.argsort(others[:, 0], kind="stable")] = np.arange(len(others))
    by_rank = np.argsort(one * len(others) + rank[other], kind="stable")
    return one[by_rank], other[by_rank]


def _morton_codes(boxes: F64) -> I64:
    """Return the Morton code (position on a Z-curve) of the middle of each box, (n,)."""
    middle = boxes[:, :2] + boxes[:, 2:]
    low = middle.min(axis=0)
    size = np.maximum(middle.max(axis=0) - low, 1e-9)
    cell = ((middle - low) / size * ((1 << _BITS) - 1)).astype(np.int64)
    for shift, mask in _SPREAD:
        cell = (cell | (cell << shift)) & mask
    curve: I64 = cell[:, 0] | (cell[:, 1] << 1)
    return curve


@kernel
def _find_pairs(boxes: F64_2, others: F64_2, gap: float) -> Any:
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
