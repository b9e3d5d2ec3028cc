"""dashes: rows of dashes, which are one line.

A dash looks across the gap at the next one, and that one looks back.  Three or more in a row with
equal gaps are one line, joined by ties between their ends.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from knifetip.classification.cutting import WORTH
from knifetip.classification.grid import Grid, by_cell, cell_of
from knifetip.classification.segment import BULGE, chord, leaves
from knifetip.geometry.capacity import double_i32_2
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.cores import each, runs
from knifetip.kernels import F64_1, F64_2, F64_3, I32_1, Bool_1, OutBool_1, OutI32_1, kernel


def rows_of_dashes(
    ends: F64, bulge: F64, touch: float, unit: float, reach: float, node: I32, twin: I32,
    loose: Bool, grid: Grid,
) -> tuple[Bool, I32, F64]:  # fmt: skip
    """Return which edges are dashes, (n,), the ties between them, and how far their ends reach.

    Parameters
    ----------
    loose : (q,)
        Whether one line only ends at a place.  Of places that are tied it is made False.
    """
    link = np.full(2 * len(bulge), -1, np.int32)

    cell = np.full(2 * len(bulge), -1, np.int32)
    each(
        lambda run: _tips(ends, bulge, node, twin, loose, grid, cell, *run),
        runs(len(bulge), WORTH),
    )
    # Few lines have such ends, and each is in one cell only.
    begins, tips = by_cell(cell, grid.side * grid.side, np.arange(len(cell), dtype=np.int32))
    place = ends.reshape(-1, 2).take(tips, axis=0)

    def linked(run: tuple[int, int]) -> None:
        _link(ends, bulge, touch, unit, grid, begins, tips, place, link, *run)

    each(linked, runs(len(tips), WORTH))
    dashed, tie, gap_of = _rows(ends, link, touch, reach, node, twin, loose)
    return dashed, tie, gap_of


@kernel
def _rows(
    ends: F64_3, link: I32_1, touch: float, reach: float, node: I32_1, twin: I32_1, loose: OutBool_1
) -> Any:
    n = len(twin)
    tie = np.empty((64, 2), np.int32)
    ties = 0
    gap_of = np.full(2 * n, reach)
    dashed = np.zeros(n, np.bool_)
    seen = np.zeros(n, np.bool_)
    chain = np.empty(n, np.int64)
    for half in range(2 * n):
        # A row begins with an edge that looks back at nothing.
        back = half ^ 1
        if seen[half // 2] or link[half] < 0 or link[link[half]] != half:
            continue
        if link[back] >= 0 and link[link[back]] == back:
            continue
        count = 0
        least, widest, shortest, longest = np.inf, 0.0, np.inf, 0.0
        tail = half
        while True:
            chain[count] = tail
            count += 1
            i = tail // 2
            seen[i] = True
            long = chord(ends, i)
            longest = max(longest, long)
            other = link[tail]
            if other < 0 or link[other] != tail or seen[other // 2]:
                break
            if count > 1:
                shortest = min(shortest, long)
            gap = math.hypot(
                ends[i, tail % 2, 0] - ends[other // 2, other % 2, 0],
                ends[i, tail % 2, 1] - ends[other // 2, other % 2, 1],
            )
            least, widest = min(least, gap), max(widest, gap)
            tail = other ^ 1
        if count < 3 or widest > 1.5 * least + 2.0 * touch or longest > 2.5 * shortest:
            continue
        for k in range(count):
            dashed[chain[k] // 2] = True
            if k:
                if ties == len(tie):
                    tie = double_i32_2(tie)
                tie[ties, 0] = node[chain[k - 1]]
                tie[ties, 1] = node[chain[k] ^ 1]
                ties += 1
                loose[node[chain[k - 1]]] = False
                loose[node[chain[k] ^ 1]] = False
        gap_of[chain[0] ^ 1] = max(reach, 1.25 * widest)
        gap_of[chain[count - 1]] = max(reach, 1.25 * widest)
    for i in range(n):
        dashed[i] = dashed[twin[i]]
    return dashed, tie[:ties], gap_of


@kernel(allocates=False)
def _tips(
    ends: F64_3, bulge: F64_1, node: I32_1, twin: I32_1, loose: Bool_1, grid: Grid, cell: OutI32_1,
    begin: int, end: int,
) -> None:  # fmt: skip
    """Write the cell of each loose end of lines that may be dashes; those of others stay."""
    low, size, side, _, _ = grid
    for i in range(begin, end):
        if abs(bulge[i]) > BULGE or twin[i] != i:
            continue
        for half in range(2 * i, 2 * i + 2):
            if loose[node[half]]:
                x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
                row = cell_of(y, low[1], size[1], side)
                cell[half] = row * side + cell_of(x, low[0], size[0], side)


@kernel(allocates=False)
def _link(
    ends: F64_3, bulge: F64_1, touch: float, unit: float, grid: Grid, begins: I32_1, tips: I32_1,
    place: F64_2, link: OutI32_1, begin: int, end: int,
) -> None:  # fmt: skip
    """Write which loose end each of some loose ends looks at across a gap."""
    low, size, side, _, _ = grid
    for number in range(begin, end):
        half = tips[number]
        i = half // 2
        long = chord(ends, i)
        if long > 40.0 * unit or long <= touch:
            continue
        far = min(15.0 * unit, max(2.0 * long, 3.0 * unit))
        ux, uy = leaves(ends, bulge, half)
        x, y = place[number, 0], place[number, 1]
        c0 = cell_of(min(x, x + far * ux) - 2.0 * touch, low[0], size[0], side)
        c1 = cell_of(max(x, x + far * ux) + 2.0 * touch, low[0], size[0], side)
        r0 = cell_of(min(y, y + far * uy) - 2.0 * touch, low[1], size[1], side)
        r1 = cell_of(max(y, y + far * uy) + 2.0 * touch, low[1], size[1], side)
        best = far
        for r in range(r0, r1 + 1):
            # The cells of a row are one run of tips.
            for k in range(begins[r * side + c0], begins[r * side + c1 + 1]):
                ox, oy = place[k, 0] - x, place[k, 1] - y
                ahead = ox * ux + oy * uy
                if ahead <= touch or ahead >= best or abs(ox * uy - oy * ux) > 2.0 * touch:
                    continue
                vx, vy = leaves(ends, bulge, tips[k])
                if tips[k] // 2 != i and ux * vx + uy * vy < -0.999:
                    best = ahead
                    link[half] = tips[k]
