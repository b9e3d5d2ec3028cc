"""Compiled functions: one decorator, one declared signature for each.  Nothing else uses numba.

A *kernel* is a function that numba compiles to machine code.  Its annotations declare the types
of its arguments, from this vocabulary:

========================  ==========================================================================
annotation                argument
========================  ==========================================================================
``float, int, bool``      float64, int64, boolean; ``I32``, ``U8``, ``U64`` for other widths
``F64_2``                 C-contiguous array of that type and number of dimensions, read-only: the
                          kernel cannot write to it; callers may pass writable arrays too
``OutF64_2``              such an array that the kernel writes to
``F64_2A``, ``F64_2F``    an array with any strides; with columns contiguous (Fortran order)
``tuple[F64_1, int]``     a tuple
a ``NamedTuple`` class    a group of tables, or scratch arrays: its fields are annotated like
                          arguments.  A field that is never written to is declared read-only
========================  ==========================================================================

How to convert a function::

    @njit(cache=True, error_model="numpy")              @kernel
    def scale(point: Any, by: Any, out: Any) -> int:    def scale(point: F64_2, by: float,
                                                                  out: OutF64_2) -> int:

1. Replace the decorator: ``@kernel``; ``@kernel(allocates=False)`` for what was ``whole`` (it makes
   no array and keeps none); ``@inline_kernel`` for what was ``part``; ``checks_division=True``
   where it was compiled without ``error_model="numpy"`` and divides.
2. Give each argument exactly one type.  Where callers passed several (int32 and int64 rows), choose
   one, and convert in the others.  An integer literal may be passed for ``int`` and ``float``.
   A float is never cast to ``int``, nor an ``int`` to ``I32``: both raise an error that names the
   argument.
3. Put arrays that belong together in a ``NamedTuple`` at the top of the module.
4. No default values: callers pass every argument.

The annotation of the result is for readers and mypy; numba infers it.
"""

from knifetip.kernels.dispatch import Kernel, inline_kernel, kernel
from knifetip.kernels.vocabulary import (
    F64_1,
    F64_1A,
    F64_2,
    F64_2A,
    F64_2F,
    F64_3,
    F64_4,
    F64_4A,
    I32,
    I32_1,
    I32_2,
    I32_2A,
    I32_2F,
    I64_1,
    I64_2,
    U8,
    U8_1,
    U8_2,
    U64,
    U64_1,
    Bool_1,
    Bool_2,
    OutBool_1,
    OutBool_2,
    OutF64_1,
    OutF64_1A,
    OutF64_2,
    OutF64_2A,
    OutF64_2F,
    OutF64_3,
    OutI32_1,
    OutI32_2,
    OutI32_2A,
    OutI32_2F,
    OutI64_1,
    OutI64_2,
    OutU8_1,
    OutU64_1,
)

__all__ = [
    "F64_1",
    "F64_1A",
    "F64_2",
    "F64_2A",
    "F64_2F",
    "F64_3",
    "F64_4",
    "F64_4A",
    "I32",
    "I32_1",
    "I32_2",
    "I32_2A",
    "I32_2F",
    "I64_1",
    "I64_2",
    "U8",
    "U8_1",
    "U8_2",
    "U64",
    "U64_1",
    "Bool_1",
    "Bool_2",
    "Kernel",
    "OutBool_1",
    "OutBool_2",
    "OutF64_1",
    "OutF64_1A",
    "OutF64_2",
    "OutF64_2A",
    "OutF64_2F",
    "OutF64_3",
    "OutI32_1",
    "OutI32_2",
    "OutI32_2A",
    "OutI32_2F",
    "OutI64_1",
    "OutI64_2",
    "OutU8_1",
    "OutU64_1",
    "inline_kernel",
    "kernel",
]
