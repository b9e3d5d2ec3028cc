"""digits: format numbers as rows of characters in a matrix.

The lines of a program are rows of a matrix of characters, so that all lines are formatted at once.
Unused positions of a row contain the byte 0.  The text of the program is the bytes of the matrix
in row order, without the zero bytes.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from knifetip.geometry.columns import I64

Characters: TypeAlias = NDArray[np.uint8]


def digit_columns(values: I64, decimals: int, *, brief: bool) -> Characters:
    """Return n numbers with a fixed number of decimals as characters, (n, k) bytes.

    Each row contains the characters of one number; unused positions contain the byte 0.

    Parameters
    ----------
    values : (n,) int64
        Numbers in units of their last decimal place.
    decimals
        Number of decimals.
    brief
        Whether to leave out zeros at the end of the decimals.
    """
    rest = np.abs(values)
    integer_digits = max(1, len(str(int(rest.max(initial=0)))) - decimals)
    field = np.zeros((len(values), 2 + integer_digits + decimals), np.uint8)
    field[:, 0] = np.where(values < 0, ord("-"), 0)
    shown = np.full(len(values), not brief)
    for column in range(integer_digits + decimals + 1, integer_digits + 1, -1):
        tenth = rest // 10
        digit = rest - 10 * tenth
        shown = shown | (digit != 0)
        field[:, column] = np.where(shown, digit + ord("0"), 0)
        rest = tenth
    field[:, integer_digits + 1] = np.where(shown, ord("."), 0)
    for column in range(integer_digits, 0, -1):
        tenth = rest // 10
        digit = rest - 10 * tenth
        field[:, column] = np.where((rest > 0) | (column == integer_digits), digit + ord("0"), 0)
        rest = tenth
    return field
