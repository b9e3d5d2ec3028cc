"""warming: which kernels have no machine code on disk yet, and compiling them.

    groups of kernels -> parts that are missing -> machine code beside the source

A kernel declares its signature, so no drawing has to reach it.  The groups are in the order in
which a server needs them.  Each kernel belongs to one of them; what it calls is compiled with it,
whichever group that is in.  Compiling all takes minutes of processor time, loading them seconds,
finding that none is missing one second.  ``jobs.warm_up`` does it in several processes.
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
        "knifetip.geometry.capacity",
        "knifetip.geometry.chain",
        "knifetip.geometry.spatial_index",
        "knifetip.geometry.unique_rows",
        "knifetip.geometry.union_find",
    ),
    # Make a program of it for a table with knives, wheels and V-cutters, and verify it.
    "jobs": (
        "knifetip.planning",
        "knifetip.compensation",
        "knifetip.sequencing",
        "knifetip.verification",
        "knifetip.geometry.points_on_segments",
        "knifetip.geometry.intersect",
    ),
    # Offset contours by the radius of a router bit.
    "offsets": ("knifetip.offset",),
}


class Part(NamedTuple):
    """A module with kernels that have no machine code on disk."""

    group: str  #: name of its group
    module: str  #: full name
    kernels: int  #: number of kernels without machine code


def missing_parts(*groups: str) -> list[Part]:
    """Return what must be compiled, in the order in which it is needed.

    No machine code is loaded.

    Parameters
    ----------
    groups
        Names from ``GROUPS``; all in their order if none is given.

    Raises
    ------
    KeyError
        There is no group of that name.
    """
    from knifetip.kernels.walk import kernels_of  # numba: callers may only want the groups

    parts = []
    for group in groups or tuple(GROUPS):
        missing: dict[str, int] = {}
        for kernel in kernels_of(*GROUPS[group]):
            if not kernel.is_cached:
                module = kernel.py_func.__module__
                missing[module] = missing.get(module, 0) + 1
        parts += [Part(group, module, count) for module, count in missing.items()]
    return parts


def compile_module(module: str) -> Iterator[float]:
    """Compile the kernels of a module that have no machine code on disk.

    Yields
    ------
    float
        Share of them that is compiled, after each.
    """
    from knifetip.kernels.walk import kernels_of

    missing = [kernel for kernel in kernels_of(module) if not kernel.is_cached]
    for done, kernel in enumerate(missing, 1):
        # It may have been compiled with one that calls it.
        kernel.compile()
        yield done / len(missing)
