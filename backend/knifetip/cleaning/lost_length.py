"""lost_length: measure how much of each drawn edge is lost if some of its stretches are dropped."""

from __future__ import annotations

import numpy as np

from knifetip.geometry.columns import F64, I64, Bool


def lost_length(row: I64, begin: F64, end: F64, is_lost: Bool, length: F64) -> F64:
    """Return how much of each of n drawn edges is lost, (n,) mm.

    An edge may lose a piece at both of its ends, where other edges nearly meet it.  Of the two
    pieces, the longer one counts, because they leave no gap together.

    Parameters
    ----------
    row : (q,)
        Drawn edge of each of q stretches.
    begin, end : (q,)
        Start and end of each stretch, as fractions of the drawn edge's length.
    is_lost : (q,)
        Which stretches are dropped.
    length : (n,)
        Lengths of the drawn edges (mm).
    """
    count = len(length)
    order = np.lexsort((begin, row))
    edge, lost = row[order], is_lost[order]
    size = np.where(lost, (end - begin)[order] * length[edge], 0.0)
    # Neighbouring stretches of an edge that are all lost, or all kept, are one run.
    is_first = np.append(True, (np.diff(edge) != 0) | (lost[1:] != lost[:-1]))[: len(edge)]
    run = np.cumsum(is_first) - 1
    owner, run_size = edge[is_first], np.bincount(run, size)
    opens = np.append(True, np.diff(owner) != 0)[: len(owner)]
    closes = np.append(opens[1:], True)[: len(owner)]
    at_start, at_end = np.zeros(count), np.zeros(count)
    at_start[owner[opens & ~closes]] = run_size[opens & ~closes]
    at_end[owner[closes & ~opens]] = run_size[closes & ~opens]
    return np.asarray(np.bincount(edge, size, count) - np.minimum(at_start, at_end), np.float64)
