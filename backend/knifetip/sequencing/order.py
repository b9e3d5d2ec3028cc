"""order: which track comes next.

Nearest neighbour: from where the last track ended to the nearest start of those that are left.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numba import njit

from knifetip.geometry.columns import F64, I32


def nearest_neighbour(start: F64, end: F64, origin: F64) -> I32:
    """Return the order of tracks, (t,), beginning with the one nearest to ``origin``.

    Parameters
    ----------
    start, end : (t, 2) mm
        Where the head begins and ends each track.
    origin : (2,) mm
    """
    if len(start) == 0:
        return np.zeros(0, np.int32)
    low = start.min(axis=0)
    extent = np.maximum(start.max(axis=0) - low, 1e-3)
    side = max(1, math.isqrt(len(start) // 2))
    size = extent / side
    cell = np.minimum(((start - low) / size).astype(np.int64), side - 1)
    key = cell[:, 0] * side + cell[:, 1]
    listed = np.argsort(key, kind="stable")
    first = np.searchsorted(key[listed], np.arange(side * side + 1))
    order: I32 = _walked(start, end, origin, low, size, side, listed, first)
    return order


@njit(cache=True)
def unwound(
    start: Any, end: Any, least: Any, most: Any, here: float, low: float, high: float, period: float
) -> Any:
    """Return what to add to the headings of each run of moves, in order, so that C turns little.

    Parameters
    ----------
    start, end, least, most : (t,) degrees
        Headings where each run begins and ends, and its extremes.
    here : degrees
        Heading before the first run.
    low, high : degrees
        Travel of C; a run that cannot stay within it is left where it is nearest.
    period : degrees
        After which the tool is the same again: 360, or 180 for one that is symmetric.
    """
    shift = np.empty(len(start))
    for run in range(len(start)):
        turns = np.round((here - start[run]) / period)
        turns = max(turns, np.ceil((low - least[run]) / period))
        turns = min(turns, np.floor((high - most[run]) / period))
        shift[run] = turns * period
        here = end[run] + shift[run]
    return shift


@njit(cache=True)
def _walked(
    start: Any, end: Any, origin: Any, low: Any, size: Any, side: int, listed: Any, first: Any
) -> Any:
    """Search the grid in growing rings; a found track is struck from its cell."""
    count = len(start)
    left = first[1:] - first[:-1]
    order = np.empty(count, np.int32)
    x = origin[0]
    y = origin[1]
    least = min(size[0], size[1])
    for step in range(count):
        column = min(max(int((x - low[0]) / size[0]), 0), side - 1)
        row = min(max(int((y - low[1]) / size[1]), 0), side - 1)
        best = -1
        reach = np.inf
        ring = 0
        while ring < side and (best < 0 or (ring - 1) * least <= reach):
            for i in range(max(column - ring, 0), min(column + ring, side - 1) + 1):
                edge = abs(i - column) == ring
                j = row - ring
                while j <= row + ring:
                    if 0 <= j < side:
                        cell = i * side + j
                        for place in range(first[cell], first[cell] + left[cell]):
                            track = listed[place]
                            distance = math.hypot(start[track, 0] - x, start[track, 1] - y)
                            if distance < reach or (distance == reach and track < best):
                                reach = distance
                                best = track
                    j += 1 if edge or ring == 0 else 2 * ring
            ring += 1
        order[step] = best
        column = min(int((start[best, 0] - low[0]) / size[0]), side - 1)
        row = min(int((start[best, 1] - low[1]) / size[1]), side - 1)
        cell = column * side + row
        for place in range(first[cell], first[cell] + left[cell]):
            if listed[place] == best:
                left[cell] -= 1
                listed[place] = listed[first[cell] + left[cell]]
                break
        x = end[best, 0]
        y = end[best, 1]
    return order
