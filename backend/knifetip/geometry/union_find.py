"""union_find: union-find on indices.

``parent`` holds the parent of each index; the root of a set is its least index.
"""

from __future__ import annotations

from knifetip.kernels import OutI64_1, kernel


@kernel(allocates=False)
def find(parent: OutI64_1, i: int) -> int:
    """Return the root of the set of i."""
    while parent[i] != i:
        parent[i] = parent[parent[i]]
        i = parent[i]
    return i


@kernel(allocates=False)
def union(parent: OutI64_1, i: int, j: int) -> None:
    """Merge the sets of i and j."""
    one, other = find(parent, i), find(parent, j)
    parent[max(one, other)] = min(one, other)


@kernel(allocates=False)
def flatten(parent: OutI64_1) -> None:
    """Replace each parent by the root of its set."""
    for i in range(len(parent)):
        # The root is the least index of a set, so it is final already.
        parent[i] = parent[parent[i]]
