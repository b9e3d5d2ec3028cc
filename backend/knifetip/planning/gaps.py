"""gaps: the lines that close contours whose cuts do not quite meet.

    cuts -> links from their loose ends to what each of them was meant to meet

A loose end is linked to the nearest point of any other cut within ``CONTOUR_GAP``, and to its
relative neighbours among the loose ends within it, those to which no third loose end is nearer than
both are to each other: where two contours run close beside each other the nearest point is on the
neighbour.  What links between all pairs would join is so joined by few links.  A point of the same
chain of cuts counts only where the way to it along the chain is three times as long as the gap, so
that no end is linked to the corner it comes from.

A link is no cut.  It only closes a contour for ``layers``, where a link too many does no harm: the
work inside such a contour comes earlier than it had to.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.chain import nodes
from knifetip.geometry.columns import F64
from knifetip.geometry.grid import touching
from knifetip.geometry.tolerance import CONTOUR_GAP, JOIN
from knifetip.kernels import F64_1, F64_2, I64_1, Bool_1, kernel
from knifetip.planning.near import near

#: The way along a chain is so many times as long as the gap that closes it, at least.
_ROUND: Final = 3.0


def links(ends: F64, bulge: F64) -> F64:
    """Return the straight lines that close gaps, (k, 2, 2) mm.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Cuts of any order and direction.
    """
    points = ends.reshape(-1, 2)
    start, end = ends[:, 0], ends[:, 1]
    own = np.repeat(np.arange(len(ends), dtype=np.int32), 2)
    loose = ~touching(points, own, start, end, bulge, JOIN)
    tips = np.flatnonzero(loose)
    if len(tips) == 0:
        return np.zeros((0, 2, 2))
    tip, row = near(np.tile(points[tips], 2), arc.bounds(start, end, bulge), CONTOUR_GAP)
    share = arc.nearest(start[row], end[row], bulge[row], points[tips[tip]])
    place = arc.point_at(start[row], end[row], bulge[row], share)
    for side in range(2):
        there = np.hypot(*(place - ends[row, side]).T) <= JOIN
        place[there], share[there] = ends[row[there], side], float(side)
    node = nodes(points).astype(np.int64)
    by_node = np.argsort(node, kind="stable")
    begin = np.searchsorted(node[by_node], np.arange(node.max() + 2))
    one, other = near(np.tile(points[tips], 2), np.tile(points[tips], 2), CONTOUR_GAP)
    tip, row = np.concatenate([tip, one]), np.concatenate([row, tips[other] // 2])
    share = np.concatenate([share, tips[other] % 2])
    place = np.concatenate([place, points[tips[other]]])
    to_end = np.arange(len(tip)) >= len(tip) - len(one)
    order = np.argsort(tip, kind="stable")
    first = np.searchsorted(tip[order], np.arange(len(tips) + 1))
    linked = _linked(
        tips, first, row[order], share[order], place[order], to_end[order], points,
        arc.length(start, end, bulge), node, by_node, begin,
    )  # fmt: skip
    kept = order[linked]
    found = np.stack([points[tips[tip[kept]]], place[kept]], axis=1)
    # Two ends that are linked to each other have one link.
    swap = (found[:, 0, 0] > found[:, 1, 0]) | (
        (found[:, 0, 0] == found[:, 1, 0]) & (found[:, 0, 1] > found[:, 1, 1])
    )
    found[swap] = found[swap][:, ::-1]
    return np.unique(found.reshape(-1, 4), axis=0).reshape(-1, 2, 2)


@kernel
def _linked(
    tips: I64_1, first: I64_1, row: I64_1, share: F64_1, place: F64_2, to_end: Bool_1,
    points: F64_2, length: F64_1,
    node: I64_1, by_node: I64_1, begin: I64_1,
) -> Any:  # fmt: skip
    """Return which candidates are links: neighbours among loose ends, the nearest other point."""
    linked = np.zeros(len(row), np.bool_)
    seen = np.full(len(length), -1, np.int64)
    # The way from the tip to where an edge of its chain begins, and whether it is run backwards.
    way = np.empty(len(length))
    back = np.empty(len(length), np.bool_)
    for t in range(len(tips)):
        tip = tips[t]
        half, walked = tip, 0.0
        while walked <= _ROUND * CONTOUR_GAP and seen[half // 2] != t:
            edge = half // 2
            seen[edge], way[edge], back[edge] = t, walked, half % 2 == 1
            walked += length[edge]
            at = node[half ^ 1]
            if begin[at + 1] - begin[at] != 2:
                break
            one, other = by_node[begin[at]], by_node[begin[at] + 1]
            half = other if one == half ^ 1 else one
        nearest, best = CONTOUR_GAP, -1
        for k in range(first[t], first[t + 1]):
            gap = math.hypot(place[k, 0] - points[tip, 0], place[k, 1] - points[tip, 1])
            if gap <= JOIN or gap > CONTOUR_GAP:
                continue
            if not _apart(row[k], share[k], gap, t, seen, way, back, length):
                continue
            if to_end[k]:
                linked[k] = not _between(k, gap, first[t], first[t + 1], place, to_end, points[tip])
            elif row[k] != tip // 2 and gap <= nearest:
                nearest, best = gap, k
        if best >= 0:
            linked[best] = True
    return linked


@kernel
def _between(
    k: int, gap: float, low: int, high: int, place: F64_2, to_end: Bool_1, tip: F64_1
) -> bool:
    """Whether another loose end is nearer to both ends of a gap than they are to each other."""
    for other in range(low, high):
        if (
            to_end[other]
            and math.hypot(place[other, 0] - tip[0], place[other, 1] - tip[1]) < gap
            and math.hypot(place[other, 0] - place[k, 0], place[other, 1] - place[k, 1]) < gap
            and (place[other, 0] != tip[0] or place[other, 1] != tip[1])
        ):
            return True
    return False


@kernel
def _apart(
    edge: int,
    share: float,
    gap: float,
    t: int,
    seen: I64_1,
    way: F64_1,
    back: Bool_1,
    length: F64_1,
) -> bool:
    """Whether a place on an edge is not too near to the tip along the chain of both."""
    if seen[edge] != t:
        return True
    along = (1.0 - share if back[edge] else share) * length[edge]
    return bool(way[edge] + along >= _ROUND * gap)
