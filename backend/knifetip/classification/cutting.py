"""cutting: where edges are parted, by others that end on them and by others that cross them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numba import njit

from knifetip.classification.grid import cell_of
from knifetip.classification.places import longer, placed
from knifetip.classification.segment import BULGE, near


@njit(cache=True, error_model="numpy")
def parted(
    ends: Any, bulge: Any, touch: float, node: Any, twin: Any, most: int,
    place: Any, places: int, head: Any, onward: Any, mask: int,
    low: Any, size: Any, side: int, first: Any, listed: Any,
) -> Any:  # fmt: skip
    """Return row, share and place of each parting, how many there are, and the places.

    Of more partings than ``most`` there are -1.  Together with the places it is told how many lines
    begin at each.
    """
    n = len(bulge)
    row = np.empty(n + 16, np.int32)
    share = np.empty(n + 16)
    cut = np.empty(n + 16, np.int32)
    cuts = 0
    degree = np.zeros(len(place), np.int32)
    for half in range(2 * n):
        if twin[half // 2] == half // 2:
            degree[node[half]] += 1
    for at in range(places):
        x, y = place[at, 0], place[at, 1]
        cell = cell_of(y, low[1], size[1], side) * side + cell_of(x, low[0], size[0], side)
        for k in range(first[cell], first[cell + 1]):
            i = listed[k]
            if node[2 * i] == at or node[2 * i + 1] == at:
                continue
            away, part = near(ends, bulge, i, x, y)
            if away <= touch and 0.0 < part < 1.0:
                if cuts == len(row):
                    row, share, cut = longer(row), longer(share), longer(cut)
                row[cuts], share[cuts], cut[cuts] = i, part, at
                cuts += 1
                degree[at] += 2
    # Lines that cross each other between their ends.
    for cell in range(side * side):
        left = low[0] + (cell % side) * size[0]
        floor = low[1] + (cell // side) * size[1]
        for k in range(first[cell], first[cell + 1]):
            i = listed[k]
            if abs(bulge[i]) > BULGE:
                continue
            ax, ay = ends[i, 0, 0], ends[i, 0, 1]
            ux, uy = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay
            for m in range(k + 1, first[cell + 1]):
                j = listed[m]
                if abs(bulge[j]) > BULGE:
                    continue
                vx, vy = ends[j, 1, 0] - ends[j, 0, 0], ends[j, 1, 1] - ends[j, 0, 1]
                cross = ux * vy - uy * vx
                if cross == 0.0:
                    continue
                ox, oy = ends[j, 0, 0] - ax, ends[j, 0, 1] - ay
                s = (ox * vy - oy * vx) / cross
                t = (ox * uy - oy * ux) / cross
                if not (0.0 < s < 1.0 and 0.0 < t < 1.0):
                    continue
                a, b = math.hypot(ux, uy), math.hypot(vx, vy)
                if min(s, 1.0 - s) * a <= touch or min(t, 1.0 - t) * b <= touch:
                    continue
                x, y = ax + s * ux, ay + s * uy
                if not (left <= x < left + size[0] and floor <= y < floor + size[1]):
                    continue
                if places + 1 >= len(place):
                    place, onward = longer(place), longer(onward)
                    wider = np.zeros(len(place), np.int32)
                    wider[: len(degree)] = degree
                    degree = wider
                at = placed(x, y, touch, place, places, head, onward, mask)
                if at == places:
                    places += 1
                for which in range(2):
                    if cuts == len(row):
                        row, share, cut = longer(row), longer(share), longer(cut)
                    row[cuts] = i if which == 0 else j
                    share[cuts] = s if which == 0 else t
                    cut[cuts] = at
                    cuts += 1
                degree[at] += 4
        if cuts > most:
            return row, share, cut, -1, place, onward, degree, places
    return row, share, cut, cuts, place, onward, degree, places
