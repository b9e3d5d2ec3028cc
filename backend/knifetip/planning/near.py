"""Near: which segments of one set may touch which of another, found by their boxes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from knifetip.geometry.columns import F64, I64


def near(boxes: F64, others: F64, gap: float) -> tuple[I64, I64]:
    """Return the pairs of boxes that overlap, or lie within ``gap`` mm of each other.

    Parameters
    ----------
    boxes, others : (n, 4) and (m, 4) mm
        x min, y min, x max, y max.
    """
    if len(boxes) == 0 or len(others) == 0:
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    order = np.argsort(others[:, 0], kind="stable")
    widest = float((others[:, 2] - others[:, 0]).max())
    low = np.searchsorted(others[order, 0], boxes[:, 0] - widest - gap)
    high = np.searchsorted(others[order, 0], boxes[:, 2] + gap, side="right")
    one, other = _near(boxes, others[order], low, high, gap)
    return one, order[other]


@njit(cache=True)
def _near(boxes: Any, others: Any, low: Any, high: Any, gap: float) -> Any:
    count = 0
    one = np.empty(16, np.int64)
    other = np.empty(16, np.int64)
    for i in range(len(boxes)):
        for j in range(low[i], high[i]):
            if (
                others[j, 2] >= boxes[i, 0] - gap
                and others[j, 1] <= boxes[i, 3] + gap
                and others[j, 3] >= boxes[i, 1] - gap
            ):
                if count == len(one):
                    one = np.concatenate((one, np.empty_like(one)))
                    other = np.concatenate((other, np.empty_like(other)))
                one[count] = i
                other[count] = j
                count += 1
    return one[:count].copy(), other[:count].copy()
