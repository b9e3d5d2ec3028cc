"""sets: which things hang together, when they are joined two at a time.

``parent`` holds for each thing another of its set, or itself for the one that stands for the set:
always the least of them.
"""

from __future__ import annotations

from knifetip.kernels import OutI64_1, kernel


@kernel(allocates=False)
def root(parent: OutI64_1, i: int) -> int:
    """The one that stands for the set that i is in."""
    while parent[i] != i:
        parent[i] = parent[parent[i]]
        i = parent[i]
    return i


@kernel(allocates=False)
def unite(parent: OutI64_1, i: int, j: int) -> None:
    """Make one set of those that i and j are in."""
    one, other = root(parent, i), root(parent, j)
    parent[max(one, other)] = min(one, other)


@kernel(allocates=False)
def settle(parent: OutI64_1) -> None:
    """Write for each thing the one that stands for its set."""
    for i in range(len(parent)):
        # What stands for a set comes before the others.
        parent[i] = parent[parent[i]]
