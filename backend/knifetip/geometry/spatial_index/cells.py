"""cells: group numbered entries, such as edges, by the cells of a uniform grid."""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.kernels import I32_1, kernel


@kernel(allocates=False)
def cell_of(value: float, low: float, size: float, side: int) -> int:
    """Return the number, 0 … ``side`` - 1, of the grid column or row that contains a coordinate.

    Parameters
    ----------
    value
        The x or y coordinate; outside the grid it belongs to the nearest column or row.
    low, size
        Least coordinate of the grid, and width or height of one cell.
    side
        Number of columns or rows.
    """
    return min(max(int((value - low) / size), 0), side - 1)


@kernel
def group_by_cell(cell: I32_1, cell_count: int, entries: I32_1) -> Any:
    """Return n entries grouped by their cells, in their order within each cell.

    Parameters
    ----------
    cell : (n,)
        Cell of each entry; entries with cell -1 are left out.
    cell_count
        Number of cells.
    entries : (n,)
        The entries, which are integers such as edge numbers.

    Returns
    -------
    first, grouped : (cell_count + 1,) int32 and (at most n,) int32
        The entries of cell c are ``grouped[first[c] : first[c + 1]]``.
    """
    first = np.zeros(cell_count + 1, np.int32)
    for one in cell:
        first[one + 1] += one >= 0
    first = np.cumsum(first).astype(np.int32)
    grouped = np.empty(first[-1], np.int32)
    free = first[:-1].copy()
    for k in range(len(cell)):
        if cell[k] >= 0:
            grouped[free[cell[k]]] = entries[k]
            free[cell[k]] += 1
    return first, grouped
