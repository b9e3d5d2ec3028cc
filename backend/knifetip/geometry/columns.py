"""Columns: the array types of every record, checked and frozen on the way in.

A record owns its arrays: what comes in writeable is copied, and nobody writes to it after.
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


def frozen(values: ArrayLike, dtype: DTypeLike, *shape: int) -> NDArray[Any]:
    """Return the values as a contiguous array of this type and shape that nobody can write to.

    A -1 in ``shape`` stands for any length.  An empty input takes the shape with 0 for -1.

    Raises
    ------
    ValueError
        The values do not fit the shape.
    """
    array = np.ascontiguousarray(values, dtype=dtype)
    if array.size == 0:
        array = array.reshape([max(side, 0) for side in shape])
    if array.ndim != len(shape) or any(
        want not in (-1, have) for want, have in zip(shape, array.shape, strict=True)
    ):
        raise ValueError(f"shape {array.shape} where {shape} is wanted")
    if array.flags.writeable:
        array = array.copy()
        array.flags.writeable = False
    return array
