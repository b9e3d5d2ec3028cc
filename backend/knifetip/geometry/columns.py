"""columns: array types of the columns of records, and a function that freezes columns.

A record owns its arrays: writable input is copied, and the result is read-only.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

F64: TypeAlias = NDArray[np.float64]
I8: TypeAlias = NDArray[np.int8]
I32: TypeAlias = NDArray[np.int32]
I64: TypeAlias = NDArray[np.int64]
U8: TypeAlias = NDArray[np.uint8]
Bool: TypeAlias = NDArray[np.bool_]


def freeze(values: ArrayLike, dtype: DTypeLike, *shape: int) -> NDArray[Any]:
    """Return values as a contiguous read-only array of the given type and shape.

    The arguments after ``dtype`` are the shape; -1 matches any length.  An empty input gets the
    length 0 for -1.

    Raises
    ------
    ValueError
        The values do not have the shape.
    """
    array = np.ascontiguousarray(values, dtype=dtype)
    if array.size == 0:
        array = array.reshape([max(side, 0) for side in shape])
    if array.shape != shape and (
        array.ndim != len(shape)
        or any(one not in (-1, actual) for one, actual in zip(shape, array.shape, strict=True))
    ):
        raise ValueError(f"shape {array.shape} instead of {shape}")
    if array.flags.writeable:
        # A conversion of another array has made a new one.
        if not isinstance(values, np.ndarray) or np.may_share_memory(array, values):
            array = array.copy()
        array.flags.writeable = False
    return array


def hand_over(array: NDArray[Any]) -> NDArray[Any]:
    """Return a new array after making it read-only, so that a record takes it without a copy."""
    array.flags.writeable = False
    return array
