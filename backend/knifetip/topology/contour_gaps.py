"""contour_gaps: find links that close contours whose cuts do not quite meet.

A dangling end is an end of a cut that lies on no other cut.  A link is a straight line from a
dangling end to a point nearby.  Each dangling end is linked to the nearest
point of another cut, and to every dangling end that is its relative neighbour.  Two dangling ends
are relative neighbours if no third dangling end is nearer to both than they are to each other.
Without the links between relative neighbours, an end of one of two close contours would only be
linked to the other contour.

If cuts connect a dangling end with a point, the two are linked only if the path along these cuts is
at least three times as long as the gap.  Otherwise an end would be linked to the corner from which
it comes.

Links only close contours for searches: for the order of the cuts, and for the outlines of panels
when cleaning drops folds outside them.  They are never cut.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.points_on_segments import find_points_on_segments
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import JOIN
from knifetip.geometry.vertices import number_vertices, sort_by_vertex
from knifetip.kernels import F64_1, F64_2, I32_1, I64_1, Bool_1, kernel

#: Least ratio of the path along a chain to the gap that closes it.
_CHAIN_FACTOR: Final = 3.0


class _Cuts(NamedTuple):
    """n cuts and the vertices at which they meet; cut i has the ends 2 i and 2 i + 1."""

    points: F64_2  #: (2n, 2) position of each end (mm)
    length: F64_1  #: (n,) length of each cut (mm)
    node: I32_1  #: (2n,) vertex of each end
    by_node: I64_1  #: (2n,) ends, sorted by vertex
    begin: I64_1  #: index in ``by_node`` of the first end of each vertex


class _Candidates(NamedTuple):
    """k points to which dangling ends may be linked, sorted by their t dangling ends."""

    first: I64_1  #: (t + 1,) index of the first candidate of each dangling end
    row: I64_1  #: (k,) cut on which each candidate lies
    fraction: F64_1  #: (k,) parameter of the candidate on the cut, 0 … 1
    target: F64_2  #: (k, 2) position of each candidate (mm)
    to_end: Bool_1  #: (k,) whether each candidate is a dangling end


def find_dangling_ends(ends: F64, bulge: F64) -> I64:
    """Return the indices of the dangling ends of n cuts, (t,); cut i has the ends 2i and 2i + 1.

    The parameters are those of ``closing_links``.
    """
    own = np.repeat(np.arange(len(ends), dtype=np.int32), 2)
    on_cut = find_points_on_segments(ends.reshape(-1, 2), own, ends[:, 0], ends[:, 1], bulge, JOIN)
    return np.flatnonzero(~on_cut)


def closing_links(ends: F64, bulge: F64, tips: I64, longest: float) -> F64:
    """Return straight links that close gaps of at most ``longest`` mm in contours, (k, 2, 2) mm.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the cuts, in any order and direction.
    tips : (t,)
        Indices of the dangling ends at which links may start; cut i has the ends 2i and 2i + 1.
    """
    points = ends.reshape(-1, 2)
    start, end = ends[:, 0], ends[:, 1]
    around = np.tile(points[tips], 2)
    tip, row = box_pairs(around, arc.bounding_boxes(start, end, bulge), longest)
    one, other = box_pairs(around, around, longest)
    others, apart = row != tips[tip] // 2, one != other
    tip, row, one, other = tip[others], row[others], one[apart], other[apart]
    if len(tip) + len(one) == 0:
        return np.zeros((0, 2, 2))
    fraction = arc.nearest_fraction(start[row], end[row], bulge[row], points[tips[tip]])
    target = arc.point_at(start[row], end[row], bulge[row], fraction)
    for side in range(2):
        there = np.hypot(*(target - ends[row, side]).T) <= JOIN
        target[there], fraction[there] = ends[row[there], side], float(side)
    node = number_vertices(points)
    by_node, begin = sort_by_vertex(node)
    tip, row = np.concatenate([tip, one]), np.concatenate([row, tips[other] // 2])
    fraction = np.concatenate([fraction, tips[other] % 2])
    target = np.concatenate([target, points[tips[other]]])
    to_end = np.arange(len(tip)) >= len(tip) - len(one)
    order = np.argsort(tip, kind="stable")
    first = np.searchsorted(tip[order], np.arange(len(tips) + 1))
    candidates = _Candidates(first, row[order], fraction[order], target[order], to_end[order])
    cuts = _Cuts(points, arc.length(start, end, bulge), node, by_node, begin)
    linked = _choose_links(tips, candidates, cuts, longest)
    link_rows = order[linked]
    links = np.stack([points[tips[tip[link_rows]]], target[link_rows]], axis=1)
    # Two ends that are linked to each other need only one link.
    swap = (links[:, 0, 0] > links[:, 1, 0]) | (
        (links[:, 0, 0] == links[:, 1, 0]) & (links[:, 0, 1] > links[:, 1, 1])
    )
    links[swap] = links[swap][:, ::-1]
    return np.unique(links.reshape(-1, 4), axis=0).reshape(-1, 2, 2)


@kernel
def _choose_links(tips: I64_1, candidates: _Candidates, cuts: _Cuts, longest: float) -> Any:
    """Return the mask of the candidates that become links, (k,).

    Each dangling end is linked to its relative neighbours among the dangling ends, and to the
    nearest point of another cut.

    ``tips`` (t,): the dangling ends.
    ``longest`` mm: greatest length of a link.
    """
    first, row, fraction, target, to_end = candidates
    points, length, node, by_node, begin = cuts
    linked = np.zeros(len(row), np.bool_)
    reached_from = np.full(len(length), -1, np.int64)
    # Distance along the chain from the tip to each edge, and whether that edge is run backwards.
    along_chain = np.empty(len(length))
    back = np.empty(len(length), np.bool_)
    for number in range(len(tips)):
        tip = tips[number]
        half, walked = tip, 0.0
        while walked <= _CHAIN_FACTOR * longest and reached_from[half // 2] != number:
            edge = half // 2
            reached_from[edge], along_chain[edge], back[edge] = number, walked, half % 2 == 1
            walked += length[edge]
            vertex = node[half ^ 1]
            if begin[vertex + 1] - begin[vertex] != 2:
                break
            one, other = by_node[begin[vertex]], by_node[begin[vertex] + 1]
            half = other if one == half ^ 1 else one
        nearest, best = longest, -1
        for k in range(first[number], first[number + 1]):
            gap = math.hypot(target[k, 0] - points[tip, 0], target[k, 1] - points[tip, 1])
            if gap <= JOIN or gap > longest:
                continue
            if not _far_along_chain(
                row[k], fraction[k], gap, number, reached_from, along_chain, back, length
            ):
                continue
            if to_end[k]:
                linked[k] = not _has_end_between(
                    k, gap, first[number], first[number + 1], target, to_end, points[tip]
                )
            elif gap <= nearest:
                nearest, best = gap, k
        if best >= 0:
            linked[best] = True
    return linked


@kernel
def _has_end_between(
    candidate: int, gap: float, low: int, high: int, target: F64_2, to_end: Bool_1, tip: F64_1
) -> bool:
    """Return whether a third dangling end is nearer to both ends of a gap than the gap is long.

    ``candidate``, ``gap``: candidate at the far end of the gap, and the length of the gap (mm).
    ``low``, ``high``: index of the first candidate of the dangling end, and the index after its
    last candidate.
    ``target``, ``to_end`` (k, 2) mm and (k,): point of each candidate, and whether it is a dangling
    end.
    ``tip`` (2,) mm: position of the dangling end.
    """
    for other in range(low, high):
        if (
            to_end[other]
            and math.hypot(target[other, 0] - tip[0], target[other, 1] - tip[1]) < gap
            and math.hypot(
                target[other, 0] - target[candidate, 0], target[other, 1] - target[candidate, 1]
            )
            < gap
            and (target[other, 0] != tip[0] or target[other, 1] != tip[1])
        ):
            return True
    return False


@kernel
def _far_along_chain(
    edge: int,
    fraction: float,
    gap: float,
    number: int,
    reached_from: I64_1,
    along_chain: F64_1,
    back: Bool_1,
    length: F64_1,
) -> bool:
    """Return whether a point is far enough from a dangling end to be linked to it.

    The distance is measured along the chain of edges from the dangling end to the point.  It must
    be at least ``_CHAIN_FACTOR`` times as long as the gap.  A point of another chain is always far
    enough.

    ``edge``, ``fraction``: edge on which the point lies, and the parameter of the point on it, 0 …
    1.
    ``gap`` mm: straight distance of the point from the dangling end.
    ``reached_from``, ``along_chain``, ``back`` (n,): for each edge: the number of the dangling end
    from which the edge was reached last, the distance along the chain from that end to the edge
    (mm), and whether the chain runs from the edge's end to its start.
    ``length`` (n,) mm: length of each edge.
    """
    if reached_from[edge] != number:
        return True
    along = (1.0 - fraction if back[edge] else fraction) * length[edge]
    return bool(along_chain[edge] + along >= _CHAIN_FACTOR * gap)
