"""Decorators and annotations for functions that numba compiles; no other package imports numba.

A *kernel* is a function that numba compiles to machine code.  Its annotations declare the types
of its arguments, with this vocabulary:

========================  ==========================================================================
annotation                argument
========================  ==========================================================================
``float, int, bool``      float64, int64, boolean; ``I32``, ``U8``, ``U64`` for other widths
``F64_2``                 read-only C-contiguous array of float64 with 2 dimensions; callers may
                          pass writable arrays too
``OutF64_2``              writable C-contiguous array of float64 with 2 dimensions
``F64_2A``, ``F64_2F``    array with any strides; array with contiguous columns (Fortran order)
``tuple[F64_1, int]``     tuple of an array and an integer
a ``NamedTuple`` class    several arrays and numbers, such as scratch arrays.  The fields are
                          annotated like arguments; fields that are never written to are read-only
========================  ==========================================================================

How to write a kernel::

    @kernel
    def scale(point: F64_2, factor: float, out: OutF64_2) -> int:

1. Choose the decorator: ``@kernel``; ``@kernel(allocates=False)`` for a function that creates and
   returns no array, which makes its call faster; ``@inline_kernel`` for a short function that is
   compiled into each kernel that calls it; ``checks_division=True`` to raise at divisions by zero.
2. Give each argument exactly one type, and convert other types in the callers.  An integer literal
   may be passed for ``int`` and ``float``.  A float is never cast to ``int``, nor an ``int`` to
   ``I32``: each of these raises an error that names the argument.
3. Combine arrays that belong together in a ``NamedTuple`` at the top of the module; a function has
   at most eight arguments.  Unpack it once at the top of the kernel, outside loops.
4. Use no default values: callers pass every argument.

The annotation of the return value is for readers and mypy; numba infers the type.
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
