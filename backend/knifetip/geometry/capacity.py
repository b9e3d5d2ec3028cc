"""capacity: kernels that enlarge arrays to which other kernels append rows.

There is one kernel for each array type, since a kernel has one signature.
"""

from __future__ import annotations

import numpy as np

from knifetip.geometry.columns import F64, I32, I64
from knifetip.kernels import F64_1, F64_2, I32_1, I32_2, OutF64_2, OutI64_2, kernel


@kernel
def double_f64(column: F64_1) -> F64:
    """Return a copy of a float column of length n with capacity for 2 n + 16 numbers."""
    more = np.empty(2 * len(column) + 16)
    more[: len(column)] = column
    return more


@kernel
def double_i32(column: I32_1) -> I32:
    """Return a copy of an int32 column of length n with capacity for 2 n + 16 numbers."""
    more = np.empty(2 * len(column) + 16, np.int32)
    more[: len(column)] = column
    return more


@kernel
def double_f64_2(table: F64_2) -> F64:
    """Return a copy of a float table of n rows with capacity for 2 n + 16 rows."""
    more = np.empty((2 * len(table) + 16, table.shape[1]))
    more[: len(table)] = table
    return more


@kernel
def double_i32_2(table: I32_2) -> I32:
    """Return a copy of an int32 table of n rows with capacity for 2 n + 16 rows."""
    more = np.empty((2 * len(table) + 16, table.shape[1]), np.int32)
    more[: len(table)] = table
    return more


@kernel
def reserve_f64_2(table: OutF64_2, rows: int) -> F64:
    """Return a float table with capacity for at least ``rows`` rows.

    It is the given table if it has the capacity, otherwise a copy.
    """
    if rows <= len(table):
        return table
    more = np.empty((2 * rows, table.shape[1]))
    more[: len(table)] = table
    return more


@kernel
def reserve_i64_2(table: OutI64_2, rows: int) -> I64:
    """Return an int64 table with capacity for at least ``rows`` rows.

    It is the given table if it has the capacity, otherwise a copy.
    """
    if rows <= len(table):
        return table
    more = np.empty((2 * rows, table.shape[1]), np.int64)
    more[: len(table)] = table
    return more
