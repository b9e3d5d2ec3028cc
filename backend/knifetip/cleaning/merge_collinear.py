"""merge_collinear: merge collinear lines, concentric arcs and the chords of curves.

Two edges are merged only if they have the same line type and no third edge ends at the point where
they meet or near it (within ``GAP``).  Lines become one line if every joint is within ``JOIN``
(0.002 mm) of it; arcs that turn in the same direction become one arc within the same distance.
Chords of a curve are replaced by lines, arcs or a circle (``fit_curves``): four or more, or three
or more edges shorter than ``FINE`` (0.05 mm).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.cleaning.end_points import EndPoints
from knifetip.cleaning.fit_curves import FINE, SHORT, SMOOTH_TURN
from knifetip.cleaning.replace_runs import direction, replace_runs
from knifetip.geometry import arc
from knifetip.geometry.chain import follow_links
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_1, F64_2, I32_1, I64_1, I64_2, U8_1, Bool_1, inline_kernel, kernel

#: Cosine of the angle between the sides of an acute corner (30°).
_ACUTE: Final = math.cos(math.radians(30.0))


@dataclass(frozen=True, eq=False, slots=True)
class MergedEdges:
    """The m edges that result from merging k edges.

    ``merged_edge`` contains for each of the k edges the index of the edge that replaces it.
    """

    ends: F64  #: (m, 2, 2) mm
    bulge: F64  #: (m,)
    kind: U8  #: (m,) LineType
    merged_edge: I32  #: (k,) merged edge that contains each edge
    fit_error: F64  #: (m,) distance of the edge from the curve that was drawn or read (mm)
    fitted: Bool  #: (m,) whether the merged edge replaces chords of a curve


def merge_collinear(
    ends: F64,
    bulge: F64,
    kind: U8,
    fit_error: F64,
    end_points: EndPoints,
    *,
    curves_only: bool = False,
) -> MergedEdges:
    """Return k edges after merging those that continue each other.

    A merged edge has the direction of the first edge, in drawing order, that it contains.  Edges
    that are not merged are unchanged, bit for bit.

    Parameters
    ----------
    ends : (k, 2, 2)
        Start and end points of the edges (mm).
    bulge, kind : (k,)
        Bulges and line types of the edges.
    fit_error : (k,)
        Distances of the edges from the curves that were drawn or read (mm).
    end_points
        Points that the ends of the edges share, and pairs of ends that are near each other.
    curves_only
        Whether only edges shorter than ``SHORT`` are merged.
    """
    count = len(bulge)
    length = arc.length(ends[:, 0], ends[:, 1], bulge)
    joined = length < (SHORT if curves_only else math.inf)
    link = _continuations(end_points.place, end_points.pairs, kind, length < FINE, joined)
    order, flipped, first, round_ = follow_links(link)
    edges = np.ascontiguousarray(ends.reshape(-1, 4))
    changeable = _in_changeable_runs(edges, bulge, length, order, flipped, first, round_)
    if not changeable.any():
        every = np.arange(count, dtype=np.int32)
        return MergedEdges(ends, bulge, kind, every, fit_error, np.zeros(count, np.bool_))
    rows = np.column_stack([edges, bulge, fit_error])
    acute = _at_acute_corners(rows, end_points.place, changeable)
    begin, new, is_curve = replace_runs(
        rows, length, changeable, acute, order, flipped, first, round_
    )
    size = np.diff(np.append(begin, count))
    if (size == 1).all():
        every = np.arange(count, dtype=np.int32)
        return MergedEdges(ends, bulge, kind, every, fit_error, np.zeros(count, np.bool_))
    group = np.repeat(np.arange(len(begin)), size)
    least = np.minimum.reduceat(order, begin)
    rank = np.argsort(np.argsort(least, kind="stable"), kind="stable").astype(np.int32)
    several = size > 1
    position = np.empty(count, np.int64)
    position[order] = np.arange(count)
    back = flipped[position[least[several]]]
    start, finish, code = new[several, :2], new[several, 2:4], new[several, 4]
    new_ends, new_bulge, error = ends[least].copy(), bulge[least].copy(), fit_error[least].copy()
    new_ends[several, 0] = np.where(back[:, None], finish, start)
    new_ends[several, 1] = np.where(back[:, None], start, finish)
    new_bulge[several] = np.where(back, -code, code)
    error[several] = new[several, 5]
    where = np.argsort(rank)
    of = np.empty(count, np.int32)
    of[order] = rank[group]
    return MergedEdges(
        new_ends[where], new_bulge[where], kind[least][where], of, error[where], is_curve[where]
    )


@kernel
def _continuations(
    place: I64_1, near_pairs: I64_2, kind: U8_1, fine: Bool_1, joined: Bool_1
) -> Any:
    """Return for each end of k edges the end of another edge with which it may be merged, (2k,).

    The entry is -1 unless exactly two edges meet at the end, both edges have the same line type,
    and no end of a third edge is near.  A third end that is near does not matter if an edge shorter
    than ``FINE`` (0.05 mm) ends at the point of the third end, or at the point where the two edges
    meet, because the points along a flattened curve are always near each other.

    ``place`` (2k,): index of the point of each end; ends that meet have the same point.
    ``near_pairs`` (q, 2): pairs of ends at different points that are near each other.
    ``kind``, ``fine`` (k,): line type of each edge, and whether it is shorter than ``FINE``.
    ``joined`` (k,): mask of the edges that may be merged.
    """
    count = np.zeros(len(place), np.int64)
    short = np.zeros(len(place), np.bool_)
    for end in range(len(place)):
        count[place[end]] += 1
        short[place[end]] |= fine[end // 2]
    joint = count == 2
    for k in range(len(near_pairs)):
        a, b = place[near_pairs[k, 0]], place[near_pairs[k, 1]]
        # Ends along a flattened curve are always near others, and two joints of lines that nearly
        # coincide are not connected.
        if not short[a] and not short[b] and not (joint[a] and joint[b]):
            count[a] += 1
            count[b] += 1
    one = np.full(len(place), -1, np.int64)
    link = np.full(len(place), -1, np.int64)
    for end in range(len(place)):
        at = place[end]
        if count[at] != 2:
            continue
        other = one[at]
        if other < 0:
            one[at] = end
        elif (
            other // 2 != end // 2
            and kind[other // 2] == kind[end // 2]
            and joined[other // 2]
            and joined[end // 2]
        ):
            link[other] = end
            link[end] = other
    return link


@kernel
def _in_changeable_runs(
    ends: F64_2,
    bulge: F64_1,
    length: F64_1,
    order: I32_1,
    flipped: Bool_1,
    first: I32_1,
    closed: Bool_1,
) -> Any:
    """Return the mask of the edges in runs of which edges may be merged or replaced, (k,).

    Most runs are outlines with corners at all joints, which need no search for lines and arcs.

    ``ends`` (k, 4): ends of the edges: x0, y0, x1, y1 (mm).
    ``bulge``, ``length`` (k,): bulges and lengths (mm) of the edges.
    ``order``, ``flipped``, ``first``, ``closed``: the runs, as for ``replace_runs``.
    """
    changeable = np.zeros(len(order), np.bool_)
    for r in range(len(first) - 1):
        low, high = first[r], first[r + 1]
        joints = high - low if closed[r] else high - low - 1
        for i in range(low, low + joints):
            after = i + 1 if i + 1 < high else low
            one, other = order[i], order[after]
            if not _is_corner(ends, bulge, length, one, flipped[i], other, flipped[after]):
                for at in range(low, high):
                    changeable[order[at]] = True
                break
    return changeable


@inline_kernel
def _is_corner(
    ends: F64_2,
    bulge: F64_1,
    length: F64_1,
    edge: int,
    edge_flipped: bool,
    next_edge: int,
    next_flipped: bool,
) -> bool:
    """Return whether no line or arc can replace two edges of a run that follow each other.

    The result may be False for some corners.  The edges are ``edge`` and ``next_edge``, each with
    whether the run traverses it from its end to its start.  The other parameters are those of
    ``_in_changeable_runs``.
    """
    if length[edge] < FINE or length[next_edge] < FINE:
        return False
    edge_bulge, next_bulge = bulge[edge], bulge[next_edge]
    if max(abs(edge_bulge), abs(next_bulge)) >= BULGE:
        if min(abs(edge_bulge), abs(next_bulge)) < BULGE:
            return True
        # Arcs that turn to different sides.
        return bool(((edge_bulge > 0.0) == edge_flipped) != ((next_bulge > 0.0) == next_flipped))
    ax, ay = ends[edge, 2] - ends[edge, 0], ends[edge, 3] - ends[edge, 1]
    bx, by = ends[next_edge, 2] - ends[next_edge, 0], ends[next_edge, 3] - ends[next_edge, 1]
    if edge_flipped != next_flipped:
        bx, by = -bx, -by
    # A line within ``JOIN`` of both ends is none: ``JOIN`` is far smaller than ``FINE`` times the
    # sine of the turn, unless the second edge goes back.
    along = ax * bx + ay * by
    return bool(along <= 0.0 or abs(ax * by - ay * bx) > SMOOTH_TURN * along)


@kernel
def _at_acute_corners(rows: F64_2, place: I64_1, wanted: Bool_1) -> Any:
    """Return the mask of the edges with an end at a corner of less than 30°, (k,).

    An arc that bulges by the tolerance could cross the other side of such a corner.  The result is
    False for a corner between two edges that are not ``wanted``, (k,).

    ``rows`` (k, 6): edges: x0, y0, x1, y1, bulge, and distance from the curve of the file (mm).
    ``place`` (2k,): index of the point of each end; ends that meet have the same point.
    """
    acute = np.zeros(len(rows), np.bool_)
    last = np.full(len(place), -1, np.int64)
    for end in range(len(place)):
        other = last[place[end]]
        last[place[end]] = end
        if other < 0 or other // 2 == end // 2:
            continue
        if not wanted[end // 2] and not wanted[other // 2]:
            continue
        ax, ay = direction(rows[end // 2], end % 2 == 1)
        bx, by = direction(rows[other // 2], other % 2 == 1)
        # Both directions point along their edges: an end at the start leaves the corner.
        if (ax * bx + ay * by) * (1.0 if end % 2 == other % 2 else -1.0) > _ACUTE:
            acute[end // 2] = True
            acute[other // 2] = True
    return acute
