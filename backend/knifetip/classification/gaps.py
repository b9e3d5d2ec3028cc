"""gaps: loose ends that stop just short of what they were meant to meet."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.classification.cutting import WORTH, Partings
from knifetip.classification.grid import Grid, cell_of
from knifetip.classification.places import Places, placed, roomy
from knifetip.classification.segment import BULGE, chord, crossing, leaves, near, point_at
from knifetip.geometry.capacity import double_f64, double_f64_2, double_i32, double_i32_2
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.cores import each, runs
from knifetip.kernels import (
    F64_1,
    F64_2,
    F64_3,
    I32_1,
    I32_2,
    I64_1,
    Bool_1,
    OutBool_1,
    OutF64_1,
    OutI32_1,
    OutI32_2,
    kernel,
)

#: Both ends of a crease may stop so short of what they were meant to meet (mm).
_SHORT: Final = 2.5


def tied(
    ends: F64,
    bulge: F64,
    touch: float,
    unit: float,
    node: I32,
    twin: I32,
    loose: Bool,
    gap_of: F64,
    spots: Places,
    grid: Grid,
) -> tuple[Partings, I32, Places]:
    """Tie loose ends to the nearest line that they look at, within ``gap_of`` each end, (2n,).

    Rules for creases end before those that cut, at both ends: what lies straight ahead is meant.

    Returns
    -------
    partings
        Of the lines that are met between their ends.
    ties : (t, 2)
        Places.
    places
        With the new ones.
    """
    ahead = _SHORT * unit
    partner, where = np.full(len(gap_of), -1, np.int32), np.empty(len(gap_of))

    def looked(run: tuple[int, int]) -> None:
        _look(ends, bulge, node, twin, loose, ahead, gap_of, grid, partner, where, *run)

    each(looked, runs(len(bulge), WORTH))
    met = np.flatnonzero(partner >= 0).astype(np.int32)
    spots = roomy(spots, len(met))
    row, share, cut, tie, count = _tie(ends, bulge, touch, node, met, partner, where, spots)
    return Partings(row, share, cut), tie, spots._replace(known=count)


@kernel(allocates=False)
def _look(
    ends: F64_3,
    bulge: F64_1,
    node: I32_1,
    twin: I32_1,
    loose: Bool_1,
    ahead: float,
    gap_of: F64_1,
    grid: Grid,
    partner: OutI32_1,
    where: OutF64_1,
    begin: int,
    end: int,
) -> None:
    """Write what the loose ends of some edges look at, and where on it."""
    low, size, side, first, listed = grid
    for i in range(begin, end):
        if twin[i] != i or not (loose[node[2 * i]] or loose[node[2 * i + 1]]):
            continue
        # Both ends stop short, and both look at something.
        both = loose[node[2 * i]] and loose[node[2 * i + 1]] and abs(bulge[i]) <= BULGE
        both = both and chord(ends, i) >= 4.0 * ahead
        for half in range(2 * i, 2 * i + 2):
            both = both and _meets(ends, bulge, half, ahead, grid)
        for half in range(2 * i, 2 * i + 2):
            if not loose[node[half]]:
                continue
            x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
            best = max(gap_of[half], ahead) if both else gap_of[half]
            c0 = cell_of(x - best, low[0], size[0], side)
            c1 = cell_of(x + best, low[0], size[0], side)
            r0 = cell_of(y - best, low[1], size[1], side)
            r1 = cell_of(y + best, low[1], size[1], side)
            for c in range(c0, c1 + 1):
                for r in range(r0, r1 + 1):
                    for k in range(first[r * side + c], first[r * side + c + 1]):
                        j = listed[k]
                        if j == i:
                            continue
                        away, part = near(ends, bulge, j, x, y, best)
                        if away < best and twin[j] != i:
                            px, py = point_at(ends, bulge, j, part)
                            ux, uy = leaves(ends, bulge, half)
                            if (px - x) * ux + (py - y) * uy >= 0.5 * away:
                                best = away
                                partner[half], where[half] = j, part


@kernel
def _tie(
    ends: F64_3,
    bulge: F64_1,
    touch: float,
    node: I32_1,
    met: I32_1,
    partner: I32_1,
    where: F64_1,
    spots: Places,
) -> Any:
    """Return row, share and place of partings, ties, and how many places there are."""
    count = spots.known
    row = np.empty(len(met), np.int32)
    share = np.empty(len(met))
    cut = np.empty(len(met), np.int32)
    tie = np.empty((len(met), 2), np.int32)
    cuts = ties = 0
    for half in met:
        j, part = partner[half], where[half]
        long = chord(ends, j)
        if part * long <= touch:
            at = node[2 * j]
        elif (1.0 - part) * long <= touch:
            at = node[2 * j + 1]
        else:
            px, py = point_at(ends, bulge, j, part)
            at = placed(px, py, touch, spots.point, count, spots.head, spots.onward)
            if at == count:
                count += 1
            row[cuts], share[cuts], cut[cuts] = j, part, at
            cuts += 1
        if at != node[half]:
            tie[ties, 0] = node[half]
            tie[ties, 1] = at
            ties += 1
    return row[:cuts], share[:cuts], cut[:cuts], tie[:ties], count


def crossed(
    ends: F64, bulge: F64, touch: float, twin: I32, tie: I32, spots: Places, grid: Grid
) -> tuple[Partings, I32, Places]:
    """Part ties by the lines that run through the gaps which they close; return as ``tied``."""
    is_crossed = np.zeros(len(tie), np.bool_)

    def looked(run: tuple[int, int]) -> None:
        _look_through(ends, bulge, touch, twin, tie, spots.point, grid, is_crossed, *run)

    each(looked, runs(len(tie), WORTH))
    row, share, cut, tie, point, onward, count = _cross(
        ends, bulge, touch, twin, tie, np.flatnonzero(is_crossed), spots, grid
    )
    return Partings(row, share, cut), tie, Places(point, count, onward, spots.head)


@kernel(allocates=False)
def _look_through(
    ends: F64_3,
    bulge: F64_1,
    touch: float,
    twin: I32_1,
    tie: I32_2,
    point: F64_2,
    grid: Grid,
    is_crossed: OutBool_1,
    begin: int,
    end: int,
) -> None:
    """Write of some ties whether a line runs through them."""
    for k in range(begin, end):
        is_crossed[k] = _first_through(ends, bulge, touch, twin, tie, point, grid, k)[0] >= 0


@kernel(allocates=False)
def _first_through(
    ends: F64_3,
    bulge: F64_1,
    touch: float,
    twin: I32_1,
    tie: I32_2,
    point: F64_2,
    grid: Grid,
    k: int,
) -> tuple[int, float, float, float]:
    """Return the first line that runs through a tie, -1 for none, its share there, and where."""
    low, size, side, first, listed = grid
    ax, ay = point[tie[k, 0], 0], point[tie[k, 0], 1]
    ux, uy = point[tie[k, 1], 0] - ax, point[tie[k, 1], 1] - ay
    long = math.sqrt(ux * ux + uy * uy)
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
                s, t = crossing(ax, ay, ux, uy, ends, j)
                if not 0.0 < s < least or min(s, 1.0 - s) * long <= touch:
                    continue
                if min(t, 1.0 - t) * chord(ends, j) > touch:
                    least, through, where = s, j, t
    return through, where, ax + least * ux, ay + least * uy


@kernel
def _cross(
    ends: F64_3,
    bulge: F64_1,
    touch: float,
    twin: I32_1,
    tie: OutI32_2,
    wanted: I64_1,
    spots: Places,
    grid: Grid,
) -> Any:
    """Part the wanted ties, and what is left of them."""
    point, places, onward, head = spots
    row = np.empty(16, np.int32)
    share = np.empty(16)
    cut = np.empty(16, np.int32)
    cuts = 0
    old = ties = len(tie)
    turn = 0
    while turn < len(wanted) + ties - old:
        k = wanted[turn] if turn < len(wanted) else old + turn - len(wanted)
        through, where, x, y = _first_through(ends, bulge, touch, twin, tie, point, grid, k)
        if through >= 0:
            if places + 1 >= len(point):
                point, onward = double_f64_2(point), double_i32(onward)
            at = placed(x, y, touch, point, places, head, onward)
            if at == places:
                places += 1
            if cuts == len(row):
                row, share, cut = double_i32(row), double_f64(share), double_i32(cut)
            row[cuts], share[cuts], cut[cuts] = through, where, at
            cuts += 1
            if at != tie[k, 0] and at != tie[k, 1]:
                if ties == len(tie):
                    tie = double_i32_2(tie)
                tie[ties, 0], tie[ties, 1] = at, tie[k, 1]
                tie[k, 1] = at
                ties += 1
        turn += 1
    return row[:cuts], share[:cuts], cut[:cuts], tie[:ties], point, onward, places


@kernel(allocates=False)
def _meets(ends: F64_3, bulge: F64_1, half: int, far: float, grid: Grid) -> bool:
    """Whether another line lies straight ahead of an end, no farther than ``far``."""
    low, size, side, first, listed = grid
    i = half // 2
    x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
    ux, uy = leaves(ends, bulge, half)
    c0, c1 = cell_of(x - far, low[0], size[0], side), cell_of(x + far, low[0], size[0], side)
    r0, r1 = cell_of(y - far, low[1], size[1], side), cell_of(y + far, low[1], size[1], side)
    for c in range(c0, c1 + 1):
        for r in range(r0, r1 + 1):
            for k in range(first[r * side + c], first[r * side + c + 1]):
                j = listed[k]
                if j == i:
                    continue
                away, part = near(ends, bulge, j, x, y, far)
                if away <= far:
                    px, py = point_at(ends, bulge, j, part)
                    if (px - x) * ux + (py - y) * uy >= 0.9 * away:
                        return True
    return False
