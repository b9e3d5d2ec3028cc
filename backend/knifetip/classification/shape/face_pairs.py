"""face_pairs: pairs of neighbouring faces, and those that alone connect two parts of a blank."""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.geometry.columns import I64, Bool
from knifetip.kernels import I64_1, I64_2, kernel


def face_pairs(left: Any, right: Any) -> tuple[I64, I64]:
    """Return the k pairs of neighbouring faces, (k, 2), and the pair of each piece, (d,).

    A piece is the part of an edge between two neighbouring vertices; its pair is the two faces on
    its sides.  The second array contains indices of pairs, 0 … k - 1.  ``left`` and ``right``,
    (d,), are the faces on the two sides of each of d pieces.
    """
    low, high = np.minimum(left, right).astype(np.int64), np.maximum(left, right).astype(np.int64)
    key = low * (int(high.max()) + 1) + high
    known, number = np.unique(key, return_inverse=True)
    return np.column_stack(np.divmod(known, int(high.max()) + 1)), number


def find_bridges(pair: I64, faces: int) -> Bool:
    """Return the mask of the k pairs of neighbouring faces that are bridges, (k,).

    The faces are the nodes of a graph, and each pair of neighbouring faces is an edge of that
    graph.  A pair is a bridge if its two faces would not be connected in the graph without it.
    ``pair`` (k, 2) are the two faces of each pair, and ``faces`` is the number of faces.
    """
    ends = np.concatenate([pair[:, 0], pair[:, 1]])
    order = np.argsort(ends, kind="stable")
    first = np.searchsorted(ends[order], np.arange(faces + 1))
    bridge: Bool = _mark_bridges(pair, first, order % len(pair), faces)
    return bridge


@kernel
def _mark_bridges(pair: I64_2, first: I64_1, incident: I64_1, faces: int) -> Any:
    """Return the mask of the k pairs of neighbouring faces that are bridges, (k,).

    The faces are the nodes of a graph, and each pair of neighbouring faces is an edge of that
    graph.  A pair is a bridge if its two faces would not be connected in the graph without it.  The
    bridges are found by depth-first search (Tarjan 1974).

    ``pair`` (k, 2): the two faces of each pair.
    ``first``, ``incident`` (faces + 1,) and (2k,): the pairs with face f are ``incident[first[f] :
    first[f + 1]]``.
    """
    bridge = np.zeros(len(pair), np.bool_)
    entered = np.full(faces, -1, np.int64)
    lowest = np.zeros(faces, np.int64)
    parent_pair = np.full(faces, -1, np.int64)
    position = first[:-1].copy()
    stack = np.empty(faces, np.int64)
    time = 0
    for root in range(faces):
        if entered[root] >= 0 or first[root] == first[root + 1]:
            continue
        depth = 0
        stack[0] = root
        entered[root] = lowest[root] = time
        time += 1
        while depth >= 0:
            face = stack[depth]
            if position[face] < first[face + 1]:
                k = incident[position[face]]
                position[face] += 1
                if k == parent_pair[face]:
                    continue
                other = pair[k, 1] if pair[k, 0] == face else pair[k, 0]
                if entered[other] >= 0:
                    lowest[face] = min(lowest[face], entered[other])
                    continue
                parent_pair[other] = k
                entered[other] = lowest[other] = time
                time += 1
                depth += 1
                stack[depth] = other
                continue
            depth -= 1
            if depth >= 0:
                parent = stack[depth]
                lowest[parent] = min(lowest[parent], lowest[face])
                if lowest[face] > entered[parent]:
                    bridge[parent_pair[face]] = True
    return bridge
