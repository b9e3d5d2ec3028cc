"""distinct: equal rows of a table of whole numbers, found in one pass.

    (n, k) whole numbers -> the first row of each kind, the kind of each row

A sheet of 100,000 edges has a few dozen kinds of them; sorting it to find out would take longer
than to read it.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import ArrayLike

from knifetip.geometry.columns import I64


def distinct(*columns: ArrayLike) -> tuple[I64, I64]:
    """Return which rows are equal.

    Parameters
    ----------
    columns : (n,) or (n, k) whole numbers each

    Returns
    -------
    first : (d,)
        The first row of each kind, in order.
    kind : (n,)
        Which kind each row is.
    """
    table = np.ascontiguousarray(
        np.column_stack([np.asarray(column, np.int64) for column in columns])
    )
    slots = np.full(1 << max(4, (2 * len(table)).bit_length()), -1, np.int32)
    first, kind = _kinds(table, slots)
    return first, kind


@njit(cache=True, error_model="numpy")
def _kinds(table: Any, slots: Any) -> Any:
    rows, width = table.shape
    first = np.empty(rows, np.int64)
    kind = np.empty(rows, np.int64)
    found = 0
    mask = np.uint64(len(slots) - 1)
    for row in range(rows):
        key = np.uint64(0)
        for column in range(width):
            key = (key ^ np.uint64(table[row, column])) * np.uint64(0x9E3779B97F4A7C15)
            key = key ^ (key >> np.uint64(29))
        slot = key & mask
        while True:
            known = slots[slot]
            if known < 0:
                slots[slot] = found
                first[found] = row
                kind[row] = found
                found += 1
                break
            same = True
            for column in range(width):
                if table[first[known], column] != table[row, column]:
                    same = False
                    break
            if same:
                kind[row] = known
                break
            slot = (slot + np.uint64(1)) & mask
    return first[:found].copy(), kind
