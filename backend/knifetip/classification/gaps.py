"""gaps: loose ends that stop just short of what they were meant to meet."""

from __future__ import annotations

import math
from typing import Any, Final

from numba import njit

from knifetip.classification.grid import cell_of
from knifetip.classification.places import longer, placed
from knifetip.classification.segment import BULGE, leaves, near, point_at

#: Both ends of a crease may stop so short of what they were meant to meet (mm).
_SHORT: Final = 2.5


@njit(cache=True, error_model="numpy")
def tied(
    ends: Any, bulge: Any, touch: float, unit: float, node: Any, twin: Any, loose: Any, gap_of: Any,
    row: Any, share: Any, cut: Any, cuts: int, tie: Any, ties: int,
    place: Any, places: int, head: Any, onward: Any, mask: int,
    low: Any, size: Any, side: int, first: Any, listed: Any,
) -> Any:  # fmt: skip
    """Tie loose ends to the nearest line that they look at, within ``gap_of`` each end, (2n,).

    Return partings, ties and places with the new ones.
    """
    n = len(bulge)
    # Rules for creases end before those that cut, at both ends: what lies straight ahead is meant.
    ahead = _SHORT * unit
    for i in range(n):
        if not (loose[node[2 * i]] and loose[node[2 * i + 1]]) or twin[i] != i:
            continue
        if math.hypot(ends[i, 1, 0] - ends[i, 0, 0], ends[i, 1, 1] - ends[i, 0, 1]) < 4.0 * ahead:
            continue
        if abs(bulge[i]) > BULGE:
            continue
        both = True
        for half in range(2 * i, 2 * i + 2):
            x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
            ux, uy = leaves(ends, bulge, half)
            both = both and _meets(
                ends, bulge, i, x, y, ux, uy, ahead, low, size, side, first, listed
            )
        if both:
            gap_of[2 * i] = max(gap_of[2 * i], ahead)
            gap_of[2 * i + 1] = max(gap_of[2 * i + 1], ahead)
    for half in range(2 * n):
        i = half // 2
        if not loose[node[half]] or twin[i] != i:
            continue
        x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
        ux, uy = leaves(ends, bulge, half)
        far = gap_of[half]
        c0, c1 = cell_of(x - far, low[0], size[0], side), cell_of(x + far, low[0], size[0], side)
        r0, r1 = cell_of(y - far, low[1], size[1], side), cell_of(y + far, low[1], size[1], side)
        best, partner, where = far, -1, 0.0
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                for k in range(first[r * side + c], first[r * side + c + 1]):
                    j = listed[k]
                    if twin[j] == i:
                        continue
                    away, part = near(ends, bulge, j, x, y)
                    if away < best:
                        px, py = point_at(ends, bulge, j, part)
                        if (px - x) * ux + (py - y) * uy >= 0.5 * away:
                            best, partner, where = away, j, part
        if partner < 0:
            continue
        long = math.hypot(
            ends[partner, 1, 0] - ends[partner, 0, 0], ends[partner, 1, 1] - ends[partner, 0, 1]
        )
        if where * long <= touch:
            at = node[2 * partner]
        elif (1.0 - where) * long <= touch:
            at = node[2 * partner + 1]
        else:
            px, py = point_at(ends, bulge, partner, where)
            if places + 1 >= len(place):
                place, onward = longer(place), longer(onward)
            at = placed(px, py, touch, place, places, head, onward, mask)
            if at == places:
                places += 1
            if cuts == len(row):
                row, share, cut = longer(row), longer(share), longer(cut)
            row[cuts], share[cuts], cut[cuts] = partner, where, at
            cuts += 1
        if at != node[half]:
            if ties == len(tie):
                tie = longer(tie)
            tie[ties, 0] = node[half]
            tie[ties, 1] = at
            ties += 1
    return row, share, cut, cuts, tie, ties, place, places, onward


@njit(cache=True, error_model="numpy")
def crossed(
    ends: Any, bulge: Any, touch: float, twin: Any,
    row: Any, share: Any, cut: Any, cuts: int, tie: Any, ties: int,
    place: Any, places: int, head: Any, onward: Any, mask: int,
    low: Any, size: Any, side: int, first: Any, listed: Any,
) -> Any:  # fmt: skip
    """Part ties by the lines that run through the gaps which they close; return as ``tied``."""
    k = 0
    while k < ties:
        ax, ay = place[tie[k, 0], 0], place[tie[k, 0], 1]
        ux, uy = place[tie[k, 1], 0] - ax, place[tie[k, 1], 1] - ay
        c0 = cell_of(min(ax, ax + ux), low[0], size[0], side)
        c1 = cell_of(max(ax, ax + ux), low[0], size[0], side)
        r0 = cell_of(min(ay, ay + uy), low[1], size[1], side)
        r1 = cell_of(max(ay, ay + uy), low[1], size[1], side)
        least, through, where = 1.0, -1, 0.0
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                for m in range(first[r * side + c], first[r * side + c + 1]):
                    j = listed[m]
                    if abs(bulge[j]) > BULGE or twin[j] != j:
                        continue
                    vx, vy = ends[j, 1, 0] - ends[j, 0, 0], ends[j, 1, 1] - ends[j, 0, 1]
                    cross = ux * vy - uy * vx
                    if cross == 0.0:
                        continue
                    ox, oy = ends[j, 0, 0] - ax, ends[j, 0, 1] - ay
                    s = (ox * vy - oy * vx) / cross
                    t = (ox * uy - oy * ux) / cross
                    if not (0.0 < s < least and 0.0 < t < 1.0):
                        continue
                    long = math.hypot(vx, vy)
                    if min(s, 1.0 - s) * math.hypot(ux, uy) <= touch:
                        continue
                    if min(t, 1.0 - t) * long > touch:
                        least, through, where = s, j, t
        if through >= 0:
            if places + 1 >= len(place):
                place, onward = longer(place), longer(onward)
            at = placed(ax + least * ux, ay + least * uy, touch, place, places, head, onward, mask)
            if at == places:
                places += 1
            if cuts == len(row):
                row, share, cut = longer(row), longer(share), longer(cut)
            row[cuts], share[cuts], cut[cuts] = through, where, at
            cuts += 1
            if at != tie[k, 0] and at != tie[k, 1]:
                if ties == len(tie):
                    tie = longer(tie)
                tie[ties, 0], tie[ties, 1] = at, tie[k, 1]
                tie[k, 1] = at
                ties += 1
        k += 1
    return row, share, cut, cuts, tie, ties, place, places, onward


@njit(cache=True, error_model="numpy")
def _meets(
    ends: Any, bulge: Any, i: int, x: float, y: float, ux: float, uy: float, far: float,
    low: Any, size: Any, side: int, first: Any, listed: Any,
) -> bool:  # fmt: skip
    """Whether another line lies straight ahead of an end, no farther than ``far``."""
    c0, c1 = cell_of(x - far, low[0], size[0], side), cell_of(x + far, low[0], size[0], side)
    r0, r1 = cell_of(y - far, low[1], size[1], side), cell_of(y + far, low[1], size[1], side)
    for c in range(c0, c1 + 1):
        for r in range(r0, r1 + 1):
            for k in range(first[r * side + c], first[r * side + c + 1]):
                j = listed[k]
                if j == i:
                    continue
                away, part = near(ends, bulge, j, x, y)
                if away <= far:
                    px, py = point_at(ends, bulge, j, part)
                    if (px - x) * ux + (py - y) * uy >= 0.9 * away:
                        return True
    return False
