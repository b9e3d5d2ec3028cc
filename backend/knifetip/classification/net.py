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
from numba import njit

from knifetip.classification.cutting import parted, together
from knifetip.classification.dashes import rows_of_dashes
from knifetip.classification.gaps import crossed, tied
from knifetip.classification.grid import Grid, gridded
from knifetip.classification.places import alike, placed_ends
from knifetip.classification.segment import BULGE
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.tolerance import GAP


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
    same: I32  #: (p,) the first piece that lies where this one lies
    dashed: Bool  #: (n,) the edge is one of a row of dashes


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
    grid = gridded(ends, bulge, touch, reach)
    if grid is None:
        return None
    unit = touch / GAP
    spots, node = placed_ends(ends, touch)
    twin = alike(node[::2].copy(), node[1::2].copy(), bulge, spots.point, touch)
    found = parted(ends, bulge, touch, node, spots, grid, 64 * count + 4096)
    if found is None:
        return None
    on, across, spots = found
    degree = np.bincount(node.reshape(-1, 2)[twin == np.arange(count)].ravel(), None, spots.known)
    degree += 2 * np.bincount(on.place, None, spots.known)
    degree += 2 * np.bincount(across.place, None, spots.known)
    loose = degree == 1
    dashed, dash_ties, gap_of = rows_of_dashes(
        ends, bulge, touch, unit, reach, node, twin, loose, grid
    )
    met, ties, spots = tied(ends, bulge, touch, unit, node, twin, loose, gap_of, spots, grid)
    ties = np.concatenate([dash_ties, ties])
    through, ties, spots = crossed(ends, bulge, touch, twin, ties, spots, grid)
    start, end, bent, edge, share, first = _pieces(
        bulge, node, *together(on, across, met, through), ties
    )
    point = spots.point[: spots.known].copy()
    same = alike(start, end, bent, point, touch)
    return Net(grid, point, start, end, bent, edge, share, first, same, dashed)


@njit(cache=True, error_model="numpy")
def _pieces(bulge: Any, node: Any, row: Any, share: Any, cut: Any, tie: Any) -> Any:
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
            bent[pieces] = math.tan(math.atan(bulge[i]) * (to - last))
            pieces += 1
            here, last = there, to
    first_piece[n] = pieces
    for k in range(ties):
        start[pieces], end[pieces], edge[pieces] = tie[k, 0], tie[k, 1], -1
        bent[pieces], begin[pieces] = 0.0, 0.0
        pieces += 1
    return (
        start[:pieces].copy(),
        end[:pieces].copy(),
        bent[:pieces].copy(),
        edge[:pieces].copy(),
        begin[:pieces].copy(),
        first_piece,
    )
