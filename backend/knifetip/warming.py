"""warming: compile every kernel, so that no user waits for one.

    group of kernels -> machine code beside the source, with progress

    python -m knifetip.warming [GROUP …]

A kernel declares its signature, so no drawing has to reach it.  The groups are in the order in
which a server needs them.  Each kernel belongs to one of them; what it calls is compiled with it,
whichever group that is in.  Compiling all takes minutes of processor time, loading them seconds.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Mapping
from typing import Final, NamedTuple

from knifetip.kernels import Kernel
from knifetip.kernels.walk import kernels_of

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
        "knifetip.geometry.distinct",
        "knifetip.geometry.sets",
    ),
    # Make a program of it for a table with knives, wheels and V-cutters, and verify it.
    "jobs": (
        "knifetip.planning",
        "knifetip.compensation",
        "knifetip.sequencing",
        "knifetip.verification",
        "knifetip.geometry.boxes",
        "knifetip.geometry.grid",
        "knifetip.geometry.intersect",
    ),
    # Offset contours by the radius of a router bit.
    "offsets": (
        "knifetip.geometry.beside",
        "knifetip.geometry.clearance",
        "knifetip.geometry.groups",
        "knifetip.geometry.pieces",
        "knifetip.geometry.region",
        "knifetip.geometry.shortened",
        "knifetip.geometry.swept",
        "knifetip.geometry.transition",
        "knifetip.geometry.whole",
    ),
}


class Progress(NamedTuple):
    """One kernel has been compiled, or loaded."""

    group: str  #: name of its group
    name: str  #: such as ``dxf.tagging.scan_tags``
    done: int  #: number of kernels of all requested groups that are ready
    total: int  #: number of kernels of all requested groups


def compile_kernels(*groups: str) -> Iterator[Progress]:
    """Compile the kernels of some groups one after the other, or load those that are kept.

    Parameters
    ----------
    groups
        Names from ``GROUPS``; all in their order if none is given.

    Raises
    ------
    KeyError
        There is no group of that name.
    """
    chosen = groups or tuple(GROUPS)
    work = [(group, each) for group in chosen for each in kernels_of(*GROUPS[group])]
    for done, (group, each) in enumerate(work, 1):
        each.compile()
        yield Progress(group, _name(each), done, len(work))


def warm() -> None:
    """Compile or load all kernels."""
    for _ in compile_kernels():
        pass


def _name(each: Kernel) -> str:
    return f"{each.py_func.__module__}.{each.py_func.__name__}".removeprefix("knifetip.")


def main(groups: list[str]) -> int:
    """Compile the kernels of some groups, all if none is given, and print what it took."""
    if unknown := [group for group in groups if group not in GROUPS]:
        print(f"There is no group {unknown[0]!r}. Give some of: {', '.join(GROUPS)}.")
        return 2
    for group in groups or GROUPS:
        since = time.process_time()
        total = sum(1 for _ in compile_kernels(group))
        print(f"{group}: {total} kernels, {time.process_time() - since:.0f} s of processor time")
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
