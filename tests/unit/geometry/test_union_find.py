"""Union-find, compared with a search of all indices connected to each index."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from knifetip.geometry.union_find import find, flatten, union

_PAIRS = st.lists(st.tuples(st.integers(0, 19), st.integers(0, 19)), max_size=30)


@given(_PAIRS)
def test_the_root_is_the_least_index_of_a_connected_set(pairs: list[tuple[int, int]]) -> None:
    parent = np.arange(20)
    beside: list[set[int]] = [{one} for one in range(20)]
    for one, other in pairs:
        union(parent, one, other)
        beside[one].add(other)
        beside[other].add(one)
    least = []
    for one in range(20):
        reached, waiting = {one}, [one]
        while waiting:
            fresh = beside[waiting.pop()] - reached
            reached |= fresh
            waiting.extend(fresh)
        least.append(min(reached))
    assert [find(parent, one) for one in range(20)] == least
    flatten(parent)
    assert parent.tolist() == least
