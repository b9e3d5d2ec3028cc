"""net: the edges of a drawing as a net of pieces between places.

    ends, bulge -> Net

Edges are parted where others end on them or cross them.  Ends that stop just short of another line
are joined to it, and rows of dashes to one line, by links: pieces without an edge, which only the
net knows.  Lines that lie on each other count once.

Everything is compiled: 100,000 edges take less than a tenth of a second.  A drawing so tangled
that this would take long is not looked at: ``built`` returns None.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from knifetip.classification.cutting import Crossings, crossings, parted, together
from knifetip.classification.dashes import rows_of_dashes
from knifetip.classification.gaps import crossed, tied
from knifetip.classification.grid import Grid, gridded
from knifetip.classification.places import Places, alike, placed_ends
from knifetip.classification.segment import BULGE
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.cores import both
from knifetip.geometry.sets import settle, unite
from knifetip.geometry.tolerance import GAP
from knifetip.kernels import F64_1, F64_2, I32_1, I32_2, kernel


@dataclass(frozen=True, eq=False, slots=True)
class Net:
    """p pieces of n edges between q places."""

    grid: Grid
    place: F64  #: (q, 2)
    start: I32  #: (p,) the place where each piece begins
    end: I32  #: (p,)
    bulge: F64  #: (p,)
    edge: I32  #: (p,) the edge that it is of, -1 for a link
    share: F64  #: (p,) where on its edge it begins, 0 … 1
    first: I32  #: (n + 1,) the pieces of each edge are first … first + 1 - 1
    node: I32  #: (2n,) the places where each edge begins and ends
    same: I32  #: (p,) the first piece that lies where this one lies
    part: I32  #: (p,) the connected part of the drawing that it belongs to
    leftmost: I32  #: (c,) the leftmost place of each part
    dashed: Bool  #: (n,) the edge is one of a row of dashes

    def chords(self) -> F64:
        """Return how far apart the ends of each piece are, (p,)."""
        chord: F64 = _chords(self.place, self.start, self.end)
        return chord


@kernel
def _chords(place: F64_2, start: I32_1, end: I32_1) -> Any:
    result = np.empty(len(start))
    for p in range(len(start)):
        x = place[end[p], 0] - place[start[p], 0]
        y = place[end[p], 1] - place[start[p], 1]
        result[p] = math.sqrt(x * x + y * y)
    return result


def built(ends: F64, bulge: F64, touch: float, reach: float) -> Net | None:
    """Return the net of n edges, or None where they are too tangled.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) and (n,)
    touch
        Ends nearer than this touch.
    reach
        A loose end nearer than this to another line was meant to touch it.
    """
    count = len(bulge)
    if count == 0:
        return None
    most = 64 * count + 4096
    found, (spots, node, twin) = both(
        lambda: _crossing(ends, bulge, touch, reach, most), lambda: _lines(ends, bulge, touch)
    )
    if found is None:
        return None
    unit = touch / GAP
    grid, pairs = found
    partings = parted(ends, bulge, touch, node, spots, grid, pairs, most)
    if partings is None:
        return None
    on, across, spots = partings
    loose = _loose(node, twin, on.place, across.place, spots.known)
    dashed, dash_ties, gap_of = rows_of_dashes(
        ends, bulge, touch, unit, reach, node, twin, loose, grid
    )
    met, ties, spots = tied(ends, bulge, touch, unit, node, twin, loose, gap_of, spots, grid)
    ties = np.concatenate([dash_ties, ties])
    through, ties, spots = crossed(ends, bulge, touch, twin, ties, spots, grid)
    start, end, bent, edge, share, first = _pieces(
        bulge, node, *together(on, across, met, through), ties
    )
    point = spots.point[: spots.known]
    same, (part, leftmost) = both(
        lambda: alike(start, end, bent, point, touch), lambda: _parts(point, start, end)
    )
    line = start, end, bent, edge, share, first, node
    return Net(grid, point, *line, same, part, leftmost, dashed)


def _crossing(
    ends: F64, bulge: F64, touch: float, reach: float, most: int
) -> tuple[Grid, Crossings] | None:
    """Return which edges pass through which cell, and where they cross there."""
    grid = gridded(ends, bulge, touch, reach)
    return None if grid is None else (grid, crossings(ends, bulge, touch, grid, most))


def _lines(ends: F64, bulge: F64, touch: float) -> tuple[Places, I32, I32]:
    """Return the places of ends, those of each edge, (2n,), and the first edge like it, (n,)."""
    spots, node = placed_ends(ends, touch)
    return spots, node, alike(node[::2].copy(), node[1::2].copy(), bulge, spots.point, touch)


@kernel
def _parts(place: F64_2, start: I32_1, end: I32_1) -> Any:
    """Return the connected part of each piece, and the leftmost place of each part."""
    pieces, places = len(start), len(place)
    parent = np.arange(places)
    for p in range(pieces):
        unite(parent, start[p], end[p])
    settle(parent)
    number = np.full(places, -1, np.int32)
    part = np.empty(pieces, np.int32)
    parts = 0
    leftmost = np.empty(places, np.int32)
    for p in range(pieces):
        root = parent[start[p]]
        if number[root] < 0:
            number[root] = parts
            leftmost[parts] = start[p]
            parts += 1
        own = number[root]
        part[p] = own
        if place[start[p], 0] < place[leftmost[own], 0]:
            leftmost[own] = start[p]
        if place[end[p], 0] < place[leftmost[own], 0]:
            leftmost[own] = end[p]
    return part, leftmost[:parts]


@kernel
def _loose(node: I32_1, twin: I32_1, on: I32_1, across: I32_1, places: int) -> Any:
    """Return at which places nothing but one line ends, (q,)."""
    degree = np.zeros(places, np.uint8)
    for half in range(len(node)):
        if twin[half // 2] == half // 2:
            degree[node[half]] = min(degree[node[half]] + 1, 2)
    for parting in (on, across):
        for at in parting:
            degree[at] = 2
    return degree == 1


@kernel
def _pieces(bulge: F64_1, node: I32_1, row: I32_1, share: F64_1, cut: I32_1, tie: I32_2) -> Any:
    """Return where each piece begins and ends, its bulge and edge, and the pieces of each edge."""
    n, cuts, ties = len(bulge), len(row), len(tie)
    begins = np.zeros(n + 1, np.int32)
    for k in range(cuts):
        begins[row[k] + 1] += 1
    begins = np.cumsum(begins).astype(np.int32)
    ordered = np.empty(cuts, np.int32)
    put = begins[:-1].copy()
    for k in range(cuts):
        at = put[row[k]]
        put[row[k]] += 1
        while at > begins[row[k]] and share[ordered[at - 1]] > share[k]:
            ordered[at] = ordered[at - 1]
            at -= 1
        ordered[at] = k
    total = n + cuts + ties
    start = np.empty(total, np.int32)
    end = np.empty(total, np.int32)
    bent = np.empty(total)
    edge = np.empty(total, np.int32)
    begin = np.empty(total)
    first_piece = np.empty(n + 1, np.int32)
    pieces = 0
    for i in range(n):
        first_piece[i] = pieces
        here, last = node[2 * i], 0.0
        for k in range(begins[i], begins[i + 1] + 1):
            there, to = node[2 * i + 1], 1.0
            if k < begins[i + 1]:
                there, to = cut[ordered[k]], share[ordered[k]]
            # What returns to the place that it comes from, unless round a bend, is a speck.
            round_ = abs(bulge[i]) > BULGE and to - last > 0.5
            if there == here and not round_:
                continue
            start[pieces], end[pieces], edge[pieces], begin[pieces] = here, there, i, last
            bent[pieces] = bulge[i]
            if to - last < 1.0 and bulge[i] != 0.0:
                bent[pieces] = math.tan(math.atan(bulge[i]) * (to - last))
            pieces += 1
            here, last = there, to
    first_piece[n] = pieces
    for k in range(ties):
        start[pieces], end[pieces], edge[pieces] = tie[k, 0], tie[k, 1], -1
        bent[pieces], begin[pieces] = 0.0, 0.0
        pieces += 1
    return (
        start[:pieces],
        end[:pieces],
        bent[:pieces],
        edge[:pieces],
        begin[:pieces],
        first_piece,
    )
