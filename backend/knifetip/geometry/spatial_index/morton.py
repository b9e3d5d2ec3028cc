"""morton: Morton codes, positions on a Z-order curve on which near points follow one another."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.kernels import F64_2, kernel

#: Largest column or row number of a cell.
_LAST_CELL: Final = (1 << 16) - 1


@kernel(allocates=False)
def morton_code(column: int, row: int) -> int:
    """Return the Morton code of a grid cell: the bits of its column and row alternate.

    Parameters
    ----------
    column, row
        Cell numbers of up to 16 bits.
    """
    return _spread_bits(column) | _spread_bits(row) << 1


@kernel(allocates=False)
def _spread_bits(number: int) -> int:
    """Return a number of up to 16 bits with a zero bit inserted above each bit."""
    number = (number | number << 8) & 0x00FF00FF
    number = (number | number << 4) & 0x0F0F0F0F
    number = (number | number << 2) & 0x33333333
    return (number | number << 1) & 0x55555555


def order_boxes(boxes: F64) -> I64:
    """Return the indices of n boxes, sorted by the Morton codes of their middles, (n,).

    Parameters
    ----------
    boxes : (n, 4)
        x min, y min, x max, y max of each box.
    """
    order: I64 = np.argsort(_codes_of_boxes(boxes), kind="stable")
    return order


@kernel
def _codes_of_boxes(boxes: F64_2) -> Any:
    """Return the Morton code of the middle of each box, (n,), in a grid over all middles.

    ``boxes`` (n, 4) are x min, y min, x max, y max of each box.
    """
    low_x = low_y = np.inf
    high_x = high_y = -np.inf
    for i in range(len(boxes)):
        x, y = boxes[i, 0] + boxes[i, 2], boxes[i, 1] + boxes[i, 3]
        low_x, low_y = min(low_x, x), min(low_y, y)
        high_x, high_y = max(high_x, x), max(high_y, y)
    width, height = max(high_x - low_x, 1e-9), max(high_y - low_y, 1e-9)
    codes = np.empty(len(boxes), np.int64)
    for i in range(len(boxes)):
        x, y = boxes[i, 0] + boxes[i, 2], boxes[i, 1] + boxes[i, 3]
        codes[i] = morton_code(
            int((x - low_x) / width * _LAST_CELL), int((y - low_y) / height * _LAST_CELL)
        )
    return codes
