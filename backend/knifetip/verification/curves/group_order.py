"""Sort rows by group, and in each group by two keys."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_1, I64_1, inline_kernel, kernel
from knifetip.verification.columns import F64, I32, I64

#: Larger groups are sorted by merge sort, smaller ones by insertion.
_INSERTION_LIMIT: Final = 32


def order_in_groups(group: I32 | I64, first: F64, second: F64) -> I64:
    """Return the indices of n rows sorted by group, then by a first and a second key, (n,).

    Rows that are equal in all three keep their order, and NaN is greater than every number, as in
    ``np.lexsort((second, first, group))``.  This function is faster for many small groups.

    Parameters
    ----------
    group : (n,)
        Group of each row, not negative.
    first, second : (n,)
        Sort keys: the rows of a group are sorted by ``first``, and those of them that are equal in
        ``first`` by ``second``.
    """
    result: I64 = _order_in_groups(
        np.ascontiguousarray(group, np.int64),
        np.ascontiguousarray(first),
        np.ascontiguousarray(second),
        int(group.max(initial=-1)) + 1,
    )
    return result


@kernel
def _order_in_groups(group: I64_1, first: F64_1, second: F64_1, count: int) -> Any:
    """Return the result of ``order_in_groups`` for ``count`` groups."""
    begin = np.zeros(count + 1, np.int64)
    for row in range(len(group)):
        begin[group[row] + 1] += 1
    for k in range(count):
        begin[k + 1] += begin[k]
    order = np.empty(len(group), np.int64)
    place = begin[:count].copy()
    for row in range(len(group)):
        order[place[group[row]]] = row
        place[group[row]] += 1
    for k in range(count):
        low, high = begin[k], begin[k + 1]
        if high - low > _INSERTION_LIMIT:
            rows = order[low:high].copy()
            rows = rows[np.argsort(second[rows], kind="mergesort")]
            order[low:high] = rows[np.argsort(first[rows], kind="mergesort")]
            continue
        for at in range(low + 1, high):
            row, slot = order[at], at
            while slot > low and _comes_after(first, second, order[slot - 1], row):
                order[slot] = order[slot - 1]
                slot -= 1
            order[slot] = row
    return order


@inline_kernel
def _comes_after(first: F64_1, second: F64_1, row_a: int, row_b: int) -> bool:
    """Return whether row ``row_a`` has a greater key than row ``row_b``, in the order of
    ``order_in_groups``.
    """
    a, b = first[row_a], first[row_b]
    if a == b or (math.isnan(a) and math.isnan(b)):
        a, b = second[row_a], second[row_b]
    return a > b or (math.isnan(a) and not math.isnan(b))
