"""cutting: where edges are parted, by others that end on them and by others that cross them."""

from __future__ import annotations

from functools import partial
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.classification.grid import Grid, cell_of
from knifetip.classification.places import Places, placed, roomy
from knifetip.classification.segment import BULGE, chord, crossing, near
from knifetip.geometry.capacity import double_f64, double_f64_2, double_i32, double_i32_2
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.cores import each, number, runs
from knifetip.kernels import F64_1, F64_2, F64_3, I32_1, I32_2, OutI32_1, kernel

#: Places, and cells of the grid, that one core has looked at before another has begun.
WORTH: Final = 40_000


class Partings(NamedTuple):
    """Where edges are parted."""

    row: I32_1  #: (c,) the edge
    share: F64_1  #: (c,) where on it, 0 … 1
    place: I32_1  #: (c,)


def together(*several: Partings) -> Partings:
    """Return all of several partings."""
    return Partings(*(np.concatenate(column) for column in zip(*several, strict=True)))


class Crossings(NamedTuple):
    """Where two lines cross between their ends."""

    pair: I32_2  #: (c, 2) the lines
    share: F64_2  #: (c, 2) where on each of them, 0 … 1


def crossings(ends: F64, bulge: F64, touch: float, grid: Grid, most: int) -> Crossings:
    """Return where lines cross; of many more than ``most`` not all."""

    def crossed(run: tuple[int, int]) -> Any:
        return _crossed(ends, bulge, touch, grid, most, *run)

    found = each(crossed, runs(grid.side * grid.side, WORTH))
    return Crossings(*(np.concatenate(column) for column in zip(*found, strict=True)))


def parted(
    ends: F64, bulge: F64, touch: float, node: I32, spots: Places, grid: Grid,
    pairs: Crossings, most: int,
) -> tuple[Partings, Partings, Places] | None:  # fmt: skip
    """Return where ends lie on edges, where edges cross, and the places with those of crossings.

    Parameters
    ----------
    node : (2n,)
        The places of the ends.
    most
        Of more partings than this there are none: None.
    """
    if 2 * len(pairs.pair) > most:
        return None
    beside = [
        partial(_ended, ends, bulge, touch, node, spots.point, grid, *run)
        for run in runs(spots.known, WORTH, 2 * number())
    ]
    (across, spots), *found = each(
        lambda work: work(), (partial(_joined, ends, touch, pairs, spots), *beside)
    )
    on = together(*(Partings(*one) for one in found))
    return None if len(on.row) + len(across.row) > most else (on, across, spots)


def _joined(ends: F64, touch: float, pairs: Crossings, spots: Places) -> tuple[Partings, Places]:
    """Return how crossings part their lines, and the places with theirs."""
    pair, share = pairs
    spots = roomy(spots, len(pair))
    at = np.empty(len(pair), np.int32)
    count = _join(ends, touch, pair, share, spots, at)
    return Partings(pair.ravel(), share.ravel(), np.repeat(at, 2)), spots._replace(known=count)


@kernel
def _ended(
    ends: F64_3,
    bulge: F64_1,
    touch: float,
    node: I32_1,
    point: F64_2,
    grid: Grid,
    begin: int,
    end: int,
) -> Any:
    """Return row, share and place where one of the places lies on an edge that ends elsewhere."""
    low, size, side, first, listed = grid
    row = np.empty(end - begin + 16, np.int32)
    share = np.empty(end - begin + 16)
    cut = np.empty(end - begin + 16, np.int32)
    cuts = 0
    for at in range(begin, end):
        x, y = point[at, 0], point[at, 1]
        cell = cell_of(y, low[1], size[1], side) * side + cell_of(x, low[0], size[0], side)
        for k in range(first[cell], first[cell + 1]):
            i = listed[k]
            # Of an arc it takes time to say that it ends here.
            if abs(bulge[i]) > BULGE and (node[2 * i] == at or node[2 * i + 1] == at):
                continue
            away, part = near(ends, bulge, i, x, y, touch)
            if away > touch or not 0.0 < part < 1.0:
                continue
            if node[2 * i] == at or node[2 * i + 1] == at:
                continue
            if cuts == len(row):
                row, share, cut = double_i32(row), double_f64(share), double_i32(cut)
            row[cuts], share[cuts], cut[cuts] = i, part, at
            cuts += 1
    return row[:cuts], share[:cuts], cut[:cuts]


@kernel
def _crossed(
    ends: F64_3, bulge: F64_1, touch: float, grid: Grid, most: int, begin: int, end: int
) -> Any:
    """Return which lines cross between their ends in some of the cells, and where on both.

    There may be a few more than ``most`` of them.
    """
    low, size, side, first, listed = grid
    pair = np.empty((64, 2), np.int32)
    share = np.empty((64, 2))
    found = 0
    for cell in range(begin, end):
        left = low[0] + (cell % side) * size[0]
        floor = low[1] + (cell // side) * size[1]
        for k in range(first[cell], first[cell + 1]):
            i = listed[k]
            if abs(bulge[i]) > BULGE:
                continue
            ax, ay = ends[i, 0, 0], ends[i, 0, 1]
            ux, uy, long = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay, chord(ends, i)
            for m in range(k + 1, first[cell + 1]):
                j = listed[m]
                if abs(bulge[j]) > BULGE:
                    continue
                s, t = crossing(ax, ay, ux, uy, ends, j)
                if not 0.0 < s < 1.0:
                    continue
                if min(s, 1.0 - s) * long <= touch or min(t, 1.0 - t) * chord(ends, j) <= touch:
                    continue
                x, y = ax + s * ux, ay + s * uy
                if not (left <= x < left + size[0] and floor <= y < floor + size[1]):
                    continue
                if found == len(pair):
                    pair, share = double_i32_2(pair), double_f64_2(share)
                pair[found, 0], pair[found, 1] = i, j
                share[found, 0], share[found, 1] = s, t
                found += 1
        if found > most:
            break
    return pair[:found], share[:found]


@kernel(allocates=False)
def _join(ends: F64_3, touch: float, pair: I32_2, share: F64_2, spots: Places, at: OutI32_1) -> int:
    """Write the places where lines cross; return how many places there are."""
    count = spots.known
    for k in range(len(pair)):
        i, s = pair[k, 0], share[k, 0]
        x = ends[i, 0, 0] + s * (ends[i, 1, 0] - ends[i, 0, 0])
        y = ends[i, 0, 1] + s * (ends[i, 1, 1] - ends[i, 0, 1])
        at[k] = placed(x, y, touch, spots.point, count, spots.head, spots.onward)
        if at[k] == count:
            count += 1
    return count
