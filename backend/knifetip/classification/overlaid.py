"""overlaid: edges that lie wholly on others.

    Net -> of each edge one that it lies on

A crease drawn on a cut needs nobody's answer: the board ends there whatever it was meant to be.
"""

from __future__ import annotations

import numpy as np

from knifetip.classification.net import Net
from knifetip.geometry.columns import F64, I32
from knifetip.kernels import F64_1, I32_1, OutI32_1, kernel


def overlaid(net: Net, length: F64) -> I32:
    """Return of each of n edges the one that most of it lies on, -1 where some lies on none, (n,).

    Parameters
    ----------
    length
        (p,) of each piece.
    """
    on = np.full(len(net.first) - 1, -1, np.int32)
    _overlaid(net.edge, net.first, net.same, length, on)
    return on


@kernel
def _overlaid(edge: I32_1, first: I32_1, same: I32_1, length: F64_1, on: OutI32_1) -> None:
    # Of each piece that others lie on, an edge that one of them is of.
    mate = np.full(len(edge), -1, np.int32)
    for p in range(len(edge)):
        if edge[p] != edge[same[p]] and edge[p] >= 0:
            mate[same[p]] = edge[p]
    for i in range(len(on)):
        longest = 0.0
        for p in range(first[i], first[i + 1]):
            lead = edge[same[p]]
            other = lead if lead >= 0 and lead != i else mate[same[p]]
            if other < 0 or other == i:
                on[i] = -1
                break
            if length[p] > longest:
                longest = length[p]
                on[i] = other
