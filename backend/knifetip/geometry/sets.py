"""sets: which things hang together, when they are joined two at a time.

``parent`` holds for each thing another of its set, or itself for the one that stands for the set:
always the least of them.
"""

from __future__ import annotations

from typing import Any

from knifetip.geometry.compiled import whole


@whole
def root(parent: Any, i: int) -> int:
    """The one that stands for the set that i is in."""
    while parent[i] != i:
        parent[i] = parent[parent[i]]
        i = parent[i]
    return i


@whole
def unite(parent: Any, i: int, j: int) -> None:
    """Make one set of those that i and j are in."""
    one, other = root(parent, i), root(parent, j)
    parent[max(one, other)] = min(one, other)


@whole
def settle(parent: Any) -> None:
    """Write for each thing the one that stands for its set."""
    for i in range(len(parent)):
        # What stands for a set comes before the others.
        parent[i] = parent[parent[i]]
