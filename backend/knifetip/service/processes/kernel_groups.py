"""Find and compile the kernels (compiled functions) that have no machine code on disk.

A kernel declares the types of its arguments, so it can be compiled before it is used.
``GROUPS`` divides the kernels by purpose, such as "drawings", in the order in which a server needs
them.  Each kernel belongs to one group; a function that a kernel calls is compiled with the kernel,
whatever its own group.

Compiling all kernels takes minutes of processor time, and loading their machine code takes seconds.
Checking that none is missing takes one second.  ``service.processes.warm_up`` compiles them in
several processes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Final, NamedTuple

#: The packages and modules of each group.
GROUPS: Final[Mapping[str, tuple[str, ...]]] = {
    # Read, classify and clean a drawing.
    "drawings": (
        "knifetip.dxf",
        "knifetip.topology",
        "knifetip.classification",
        "knifetip.cleaning",
        "knifetip.drawing_builder",
        "knifetip.svg",
        "knifetip.units",
        "knifetip.geometry.arc",
        "knifetip.geometry.biarcs",
        "knifetip.geometry.capacity",
        "knifetip.geometry.chain",
        "knifetip.geometry.curve",
        "knifetip.geometry.spatial_index",
        "knifetip.geometry.spline",
        "knifetip.geometry.unique_rows",
        "knifetip.geometry.union_find",
        "knifetip.geometry.vertices",
    ),
    # Compile the drawing for a machine with knives, crease wheels and V-cutters, and verify it.
    "jobs": (
        "knifetip.planning",
        "knifetip.compensation",
        "knifetip.sequencing",
        "knifetip.post",
        "knifetip.verification",
        "knifetip.geometry.points_on_segments",
        "knifetip.geometry.intersect",
    ),
    # Offset contours by the radius of a cutter.
    "offsets": ("knifetip.offset",),
}


#: Groups that were found to be complete.
_COMPILED: Final[set[str]] = set()


class Part(NamedTuple):
    """A module with kernels that have no machine code on disk, and the number of these kernels."""

    group: str  #: name of the group
    module: str  #: full name of the module
    kernels: int  #: number of kernels without machine code


def missing_parts(*groups: str) -> list[Part]:
    """Return the modules whose kernels must be compiled, in the order in which they are needed.

    The function loads no machine code.

    Parameters
    ----------
    groups
        Names from ``GROUPS``; without names all groups are searched.

    Raises
    ------
    KeyError
        There is no group with one of the names.
    """
    from knifetip.kernels.walk import kernels_of  # imports numba, which ``GROUPS`` does not need

    parts = []
    for group in groups or tuple(GROUPS):
        missing: dict[str, int] = {}
        for kernel in kernels_of(*GROUPS[group]):
            if not kernel.is_cached:
                module = kernel.py_func.__module__
                missing[module] = missing.get(module, 0) + 1
        parts += [Part(group, module, count) for module, count in missing.items()]
    return parts


def is_compiled(group: str) -> bool:
    """Return whether all kernels of a group have machine code on disk.

    Once they have, they are not searched again, which takes a tenth of a second.
    """
    if group not in _COMPILED and not missing_parts(group):
        _COMPILED.add(group)
    return group in _COMPILED


def compile_module(module: str) -> Iterator[float]:
    """Compile the kernels of a module that have no machine code on disk, one after the other.

    Yields
    ------
    float
        After each kernel, the fraction of these kernels that is compiled, 0 … 1.
    """
    from knifetip.kernels.walk import kernels_of

    missing = [kernel for kernel in kernels_of(module) if not kernel.is_cached]
    for done, kernel in enumerate(missing, 1):
        # A kernel that was compiled with one of its callers is not compiled again.
        kernel.compile()
        yield done / len(missing)
