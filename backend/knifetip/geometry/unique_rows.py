"""unique_rows: find the distinct rows of integer columns, by hashing.

Drawings have few distinct rows, so hashing is much faster than sorting.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from knifetip.geometry.columns import I64
from knifetip.kernels import I32_1, I64_2, kernel


def unique_rows(*columns: ArrayLike) -> tuple[I64, I64]:
    """Return the distinct rows of integer columns, and which of them each row equals.

    Parameters
    ----------
    columns : (n,) or (n, k) integers each
        One or more arrays that form the rows together, side by side.

    Returns
    -------
    first : (d,)
        Number of the first row that is equal to each of the d distinct rows, ascending.
    kind : (n,)
        Number of the distinct row that each row equals, 0 … d - 1.
    """
    wide = [np.asarray(column, np.int64) for column in columns]
    alone = len(wide) == 1 and wide[0].ndim == 1
    table = wide[0].reshape(-1, 1) if alone else np.column_stack(wide)
    first, kind = _distinct_rows(np.ascontiguousarray(table))
    return first, kind


@kernel
def _distinct_rows(table: I64_2) -> Any:
    """Return the distinct rows of a table, and which of them each row of the table equals.

    ``table`` (n, k): rows of integers.
    Returns ``first`` (d,): number of the first row that is equal to each of the d distinct rows,
    ascending; ``kind`` (n,): number of the distinct row that each row equals, 0 … d - 1.
    """
    rows = len(table)
    first = np.empty(rows, np.int64)
    kind = np.empty(rows, np.int64)
    size = 2
    while size < 2 * rows:
        size *= 2
    slots = np.full(size, -1, np.int32)
    count = 0
    for row in range(rows):
        if row > 0 and _equal_rows(table, row, row - 1):
            kind[row] = kind[row - 1]
            continue
        slot = _slot(table, row, slots)
        while slots[slot] >= 0 and not _equal_rows(table, row, first[slots[slot]]):
            slot = (slot + 1) & (len(slots) - 1)
        if slots[slot] < 0:
            slots[slot] = count
            first[count] = row
            count += 1
        kind[row] = slots[slot]
    return first[:count].copy(), kind


@kernel
def _equal_rows(table: I64_2, row: int, other_row: int) -> bool:
    """Return whether the rows with the numbers ``row`` and ``other_row`` of a table are equal."""
    same = True
    for column in range(table.shape[1]):
        same &= table[row, column] == table[other_row, column]
    return same


@kernel
def _slot(table: I64_2, row: int, slots: I32_1) -> Any:
    """Return the slot of the hash table ``slots`` at which the search for a row begins.

    ``table`` contains rows of integers, and ``row`` is the number of the row to search for.
    """
    key = np.uint64(0)
    for column in range(table.shape[1]):
        key = key ^ np.uint64(table[row, column])
        # A product spreads bits upwards only, so that the high bits are first mixed into the low.
        key = (key ^ (key >> np.uint64(32))) * np.uint64(0x9E3779B97F4A7C15)
        key = key ^ (key >> np.uint64(29))
    return np.int64(key & np.uint64(len(slots) - 1))
