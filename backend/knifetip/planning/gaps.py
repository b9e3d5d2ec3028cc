"""gaps: the lines that close contours whose cuts do not quite meet.

    cuts -> links from their loose ends to what each of them was meant to meet

A loose end is linked to the nearest point of any other cut within ``CONTOUR_GAP``, and to the
nearest loose end that lies ahead of it, within 60° of the direction in which its cut ends: where
two contours run close beside each other the nearest point is on the neighbour, and their own other
ends are ahead.  A point of the same chain of cuts counts only where the way to it along the chain
is three times as long as the gap, so that no end is linked to the corner it comes from.

A link is no cut.  It only closes a contour for ``layers``, where a link too many does no harm: the
work inside such a contour comes earlier than it had to.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np
from numba import njit

from knifetip.geometry import arc
from knifetip.geometry.chain import nodes, outward
from knifetip.geometry.columns import F64
from knifetip.geometry.grid import touching
from knifetip.geometry.tolerance import CONTOUR_GAP, JOIN
from knifetip.planning.near import near

#: The cosine of the angle within which a loose end lies ahead.
_AHEAD: Final = 0.5
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
    first = np.searchsorted(tip, np.arange(len(tips) + 1))
    target = _targets(
        tips, first, row, share, place, points, outward(ends, bulge).reshape(-1, 2),
        arc.length(start, end, bulge), loose, node, by_node, begin,
    )  # fmt: skip
    found = np.concatenate([np.stack([points[tips], target[:, side]], axis=1) for side in range(2)])
    found = found[~np.isnan(found).any(axis=(1, 2))]
    # Two ends that are linked to each other have one link.
    swap = (found[:, 0, 0] > found[:, 1, 0]) | (
        (found[:, 0, 0] == found[:, 1, 0]) & (found[:, 0, 1] > found[:, 1, 1])
    )
    found[swap] = found[swap][:, ::-1]
    return np.unique(found.reshape(-1, 4), axis=0).reshape(-1, 2, 2)


@njit(cache=True)
def _targets(
    tips: Any, first: Any, row: Any, share: Any, place: Any, points: Any, out: Any, length: Any,
    loose: Any, node: Any, by_node: Any, begin: Any,
) -> Any:  # fmt: skip
    """Return the nearest point and the nearest loose end ahead of each tip, (t, 2, 2), or NaN."""
    target = np.full((len(tips), 2, 2), np.nan)
    seen = np.full(len(length), -1, np.int64)
    #: The way from the tip to the start of an edge of its chain, and whether it is run backwards.
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
        x, y = points[tip, 0], points[tip, 1]
        nearest, ahead = CONTOUR_GAP, CONTOUR_GAP
        for k in range(first[t], first[t + 1]):
            edge = row[k]
            if edge != tip // 2:
                gap = math.hypot(place[k, 0] - x, place[k, 1] - y)
                if gap <= nearest and _apart(edge, share[k], gap, t, seen, way, back, length):
                    nearest = gap
                    target[t, 0, 0], target[t, 0, 1] = place[k, 0], place[k, 1]
            for side in range(2):
                end = 2 * edge + side
                if not loose[end] or end == tip:
                    continue
                dx, dy = points[end, 0] - x, points[end, 1] - y
                gap = math.hypot(dx, dy)
                if gap > ahead or not _apart(edge, float(side), gap, t, seen, way, back, length):
                    continue
                if dx * out[tip, 0] + dy * out[tip, 1] <= -_AHEAD * gap:
                    ahead = gap
                    target[t, 1, 0], target[t, 1, 1] = points[end, 0], points[end, 1]
    return target


@njit(cache=True)
def _apart(
    edge: int, share: float, gap: float, t: int, seen: Any, way: Any, back: Any, length: Any
) -> bool:
    """Whether a place on an edge is not too near to the tip along the chain of both."""
    if seen[edge] != t:
        return True
    along = (1.0 - share if back[edge] else share) * length[edge]
    return bool(way[edge] + along >= _ROUND * gap)
