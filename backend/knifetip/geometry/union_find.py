"""union_find: disjoint sets of indices (union-find).

``parent`` has the parent of each index, (n,); the root of a set is its least index.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.kernels import OutI64_1, kernel


@kernel(allocates=False)
def find(parent: OutI64_1, i: int) -> int:
    """Return the root of the set that contains index ``i``.

    ``parent`` has the parent of each index.  The function changes it: it shortens the path from
    ``i`` to the root, so that later calls are faster.
    """
    while parent[i] != i:
        parent[i] = parent[parent[i]]
        i = parent[i]
    return i


@kernel(allocates=False)
def union(parent: OutI64_1, i: int, j: int) -> None:
    """Merge the set that contains index ``i`` with the set that contains index ``j``.

    Writes to ``parent``, the parent of each index.
    """
    one, other = find(parent, i), find(parent, j)
    parent[max(one, other)] = min(one, other)


@kernel(allocates=False)
def flatten(parent: OutI64_1) -> None:
    """Replace the parent of each index by the root of the set that contains the index.

    ``parent`` has the parent of each index.
    """
    for i in range(len(parent)):
        # The root is the least index of a set, so it is final already.
        parent[i] = parent[parent[i]]


@kernel
def component_roots(node: OutI64_1, count: int) -> Any:
    """Return the number of the root of each of ``count`` graph nodes, shape (count,).

    Each graph edge connects two nodes: edge i connects ``node[2 i]`` with ``node[2 i + 1]``.  Nodes
    that are connected by a series of edges have the same root.
    """
    root = np.arange(count)
    for edge in range(len(node) // 2):
        union(root, node[2 * edge], node[2 * edge + 1])
    flatten(root)
    return root
