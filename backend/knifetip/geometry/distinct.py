"""distinct: equal rows of a table of whole numbers, found in one pass.

    (n, k) whole numbers -> the first row of each kind, the kind of each row

A sheet of 100,000 edges has a few dozen kinds of them; sorting it to find out would take longer
than to read it.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from knifetip.geometry.columns import I64
from knifetip.kernels import I64_1, I64_2, kernel

#: Where the table of kinds begins: most columns have no more.
_SLOTS: Final = 1024


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
    wide = [np.asarray(column, np.int64) for column in columns]
    alone = len(wide) == 1 and wide[0].ndim == 1
    table = wide[0].reshape(-1, 1) if alone else np.column_stack(wide)
    first, kind = _kinds(np.ascontiguousarray(table))
    return first, kind


@kernel
def _kinds(table: I64_2) -> Any:
    rows = len(table)
    first = np.empty(rows, np.int64)
    kind = np.empty(rows, np.int64)
    slots = np.full(_SLOTS, -1, np.int64)
    found = 0
    for row in range(rows):
        if row > 0 and _same(table, row, row - 1):
            kind[row] = kind[row - 1]
            continue
        slot = _slot(table, row, slots)
        while slots[slot] >= 0 and not _same(table, row, first[slots[slot]]):
            slot = (slot + 1) & (len(slots) - 1)
        if slots[slot] < 0:
            slots[slot] = found
            first[found] = row
            found += 1
        kind[row] = slots[slot]
        if 2 * found > len(slots):
            slots = np.full(4 * len(slots), -1, np.int64)
            for number in range(found):
                slot = _slot(table, first[number], slots)
                while slots[slot] >= 0:
                    slot = (slot + 1) & (len(slots) - 1)
                slots[slot] = number
    return first[:found].copy(), kind


@kernel
def _same(table: I64_2, row: int, other: int) -> bool:
    same = True
    for column in range(table.shape[1]):
        same &= table[row, column] == table[other, column]
    return same


@kernel
def _slot(table: I64_2, row: int, slots: I64_1) -> Any:
    """Return where a row is looked for first."""
    key = np.uint64(0)
    for column in range(table.shape[1]):
        key = (key ^ np.uint64(table[row, column])) * np.uint64(0x9E3779B97F4A7C15)
        key = key ^ (key >> np.uint64(29))
    return np.int64(key & np.uint64(len(slots) - 1))
