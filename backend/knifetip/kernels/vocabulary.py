"""vocabulary: annotations that declare the argument types of kernels.

mypy sees the NumPy type that callers pass; ``declare`` reads the numba type from the annotation.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class Scalar:
    """Annotation of an argument that is one number of a given NumPy dtype, such as "int32"."""

    dtype: str


@dataclass(frozen=True, slots=True)
class Array:
    """Annotation of an argument that is an array of a given dtype, dimension and memory order.

    Parameters
    ----------
    dtype, dimensions
        Name of the NumPy dtype, and number of dimensions.
    writable
        Whether the kernel may write to the array.
    order
        "C" for contiguous rows, "F" for contiguous columns, "A" for any strides.
    """

    dtype: str
    dimensions: int
    writable: bool = False
    order: Literal["C", "F", "A"] = "C"


I32: TypeAlias = Annotated[np.int32, Scalar("int32")]
U8: TypeAlias = Annotated[np.uint8, Scalar("uint8")]
U64: TypeAlias = Annotated[np.uint64, Scalar("uint64")]

F64_1: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 1)]
F64_1A: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 1, order="A")]
F64_2: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 2)]
F64_2A: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 2, order="A")]
F64_2F: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 2, order="F")]
F64_3: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 3)]
F64_4: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 4)]
F64_4A: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 4, order="A")]
I32_1: TypeAlias = Annotated[NDArray[np.int32], Array("int32", 1)]
I32_2: TypeAlias = Annotated[NDArray[np.int32], Array("int32", 2)]
I32_2A: TypeAlias = Annotated[NDArray[np.int32], Array("int32", 2, order="A")]
I32_2F: TypeAlias = Annotated[NDArray[np.int32], Array("int32", 2, order="F")]
I64_1: TypeAlias = Annotated[NDArray[np.int64], Array("int64", 1)]
I64_2: TypeAlias = Annotated[NDArray[np.int64], Array("int64", 2)]
U8_1: TypeAlias = Annotated[NDArray[np.uint8], Array("uint8", 1)]
U8_2: TypeAlias = Annotated[NDArray[np.uint8], Array("uint8", 2)]
U64_1: TypeAlias = Annotated[NDArray[np.uint64], Array("uint64", 1)]
Bool_1: TypeAlias = Annotated[NDArray[np.bool_], Array("bool", 1)]
Bool_2: TypeAlias = Annotated[NDArray[np.bool_], Array("bool", 2)]

OutF64_1: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 1, writable=True)]
OutF64_1A: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 1, writable=True, order="A")]
OutF64_2: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 2, writable=True)]
OutF64_2A: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 2, writable=True, order="A")]
OutF64_2F: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 2, writable=True, order="F")]
OutF64_3: TypeAlias = Annotated[NDArray[np.float64], Array("float64", 3, writable=True)]
OutI32_1: TypeAlias = Annotated[NDArray[np.int32], Array("int32", 1, writable=True)]
OutI32_2: TypeAlias = Annotated[NDArray[np.int32], Array("int32", 2, writable=True)]
OutI32_2A: TypeAlias = Annotated[NDArray[np.int32], Array("int32", 2, writable=True, order="A")]
OutI32_2F: TypeAlias = Annotated[NDArray[np.int32], Array("int32", 2, writable=True, order="F")]
OutI64_1: TypeAlias = Annotated[NDArray[np.int64], Array("int64", 1, writable=True)]
OutI64_2: TypeAlias = Annotated[NDArray[np.int64], Array("int64", 2, writable=True)]
OutU8_1: TypeAlias = Annotated[NDArray[np.uint8], Array("uint8", 1, writable=True)]
OutU64_1: TypeAlias = Annotated[NDArray[np.uint64], Array("uint64", 1, writable=True)]
OutBool_1: TypeAlias = Annotated[NDArray[np.bool_], Array("bool", 1, writable=True)]
OutBool_2: TypeAlias = Annotated[NDArray[np.bool_], Array("bool", 2, writable=True)]
