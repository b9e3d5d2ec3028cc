"""letters: words that somebody turned into lines.

    boxes of parts, what is drawn of each -> which parts are letters

Letters are small, stand in a row at the distance of letters, and are not alike: five holes in a row
are, and no word has a hole's shape five times.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, I64, Bool
from knifetip.kernels import F64_2, I64_1, OutBool_1, kernel

#: Letters are no higher and no wider than this (mm).
_HIGH: Final = 25.0
#: So many different shapes in a row are a word.
_FEWEST: Final = 3
#: Rows are looked for among so many small parts.
_MOST: Final = 20_000


def lettering(box: F64, drawn: F64, pieces: I64, unit: float) -> Bool:
    """Return which of c parts are letters, (c,), by their boxes, (c, 4), and what is drawn of them.

    Parameters
    ----------
    drawn, pieces : (c,)
        The length of their pieces, and how many these are.
    """
    count = len(box)
    found = np.zeros(count, np.bool_)
    wide, high = box[:, 2] - box[:, 0], box[:, 3] - box[:, 1]
    size = np.maximum(wide, high)
    small = np.flatnonzero((size <= _HIGH * unit) & (size > 0.5 * unit))
    if not _FEWEST <= len(small) <= _MOST:
        return found
    shape = np.column_stack([np.minimum(wide, high), size, drawn, pieces])[small]
    word = np.zeros(len(small), np.bool_)
    for axis in range(2):
        order = np.argsort(box[small, axis], kind="stable")
        _rows(box[small], shape, order, axis, word)
    found[small[word]] = True
    return found


@kernel
def _rows(box: F64_2, shape: F64_2, order: I64_1, axis: int, word: OutBool_1) -> None:
    """Mark the parts that stand in a row along an axis with others of other shapes."""
    across = 1 - axis
    count = len(order)
    after = np.full(count, -1, np.int64)
    follows = np.zeros(count, np.bool_)
    for k in range(count):
        i = order[k]
        high = max(box[i, across + 2] - box[i, across], shape[i, 1])
        for m in range(k + 1, min(k + 40, count)):
            j = order[m]
            if box[j, axis] - box[i, axis + 2] > 1.0 * high:
                break
            shared = min(box[i, across + 2], box[j, across + 2]) - max(
                box[i, across], box[j, across]
            )
            alike = 0.4 * shape[i, 1] <= shape[j, 1] <= 2.5 * shape[i, 1]
            if shared >= 0.3 * shape[i, 1] and alike and box[j, axis] > box[i, axis]:
                after[i] = j
                follows[j] = True
                break
    for k in range(count):
        head = order[k]
        if follows[head]:
            continue
        kinds = 0
        i = head
        while i >= 0:
            new = True
            j = head
            while j != i:
                same = True
                for n in range(4):
                    if abs(shape[i, n] - shape[j, n]) > 0.02 * max(shape[i, n], shape[j, n]):
                        same = False
                if same:
                    new = False
                    break
                j = after[j]
            kinds += new
            i = after[i]
        i = head
        while i >= 0:
            if kinds >= _FEWEST:
                word[i] = True
            i = after[i]
