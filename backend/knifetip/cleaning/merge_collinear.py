"""merge_collinear: merge collinear lines, concentric arcs and the chords of curves.

Two edges are merged only if they have the same line type and no third edge ends at the point where
they meet or near it (within ``GAP``).  Lines become one line if every joint is within ``JOIN``
(0.002 mm) of it; arcs that turn in the same direction become one arc within the same distance.
Chords of a curve are replaced by lines, arcs or a circle (``fit_curves``): four or more, or three
or more edges shorter than ``FINE`` (0.05 mm).  The distance of the chords from the edge that
replaces them, and the distance of the edges from the curve of the file that import has
approximated, are together at most ``CURVE`` (0.0035 mm): the part of a program's tolerance that
fitted curves may use.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.cleaning.end_points import EndPoints
from knifetip.cleaning.fit_curves import (
    FEW_CHORDS,
    FEW_FINE,
    SMOOTH_TURN,
    divide_circle,
    fit_arc,
    fit_circle,
    greatest_distance,
    longest_arc,
    longest_line,
    mark_smooth,
)
from knifetip.geometry import arc
from knifetip.geometry.chain import follow_links
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.tolerance import BULGE, CURVE, GAP, JOIN, POINT
from knifetip.kernels import (
    F64_1,
    F64_2,
    I32_1,
    I64_1,
    I64_2,
    U8_1,
    Bool_1,
    OutBool_1,
    OutF64_1,
    OutI32_1,
    inline_kernel,
    kernel,
)

#: Segments shorter than this belong to a flattened curve (mm).
FINE: Final = GAP
#: Cosine of a turn that is none (0.0026°).
_STRAIGHT: Final = 1.0 - 1e-9
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
        Whether only edges shorter than ``FINE`` are merged.
    """
    count = len(bulge)
    length = arc.length(ends[:, 0], ends[:, 1], bulge)
    fine = length < FINE
    link = _continuations(end_points.place, end_points.pairs, kind, fine, curves_only)
    order, flipped, first, round_ = follow_links(link)
    edges = np.ascontiguousarray(ends.reshape(-1, 4))
    changeable = _in_changeable_runs(edges, bulge, length, order, flipped, first, round_)
    if not changeable.any():
        every = np.arange(count, dtype=np.int32)
        return MergedEdges(ends, bulge, kind, every, fit_error, np.zeros(count, np.bool_))
    rows = np.column_stack([edges, bulge, fit_error])
    acute = _at_acute_corners(rows, end_points.place, changeable)
    begin, new, is_curve = _split_runs(
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
    place: I64_1, near_pairs: I64_2, kind: U8_1, fine: Bool_1, curves_only: bool
) -> Any:
    """Return for each end of k edges the end of another edge with which it may be merged, (2k,).

    The entry is -1 unless exactly two edges meet at the end, both edges have the same line type,
    and no end of a third edge is near.  A third end that is near does not matter if an edge shorter
    than ``FINE`` (0.05 mm) ends at the point of the third end, or at the point where the two edges
    meet, because the points along a flattened curve are always near each other.

    ``place`` (2k,): index of the point of each end; ends that meet have the same point.
    ``near_pairs`` (q, 2): pairs of ends at different points that are near each other.
    ``kind``, ``fine`` (k,): line type of each edge, and whether it is shorter than ``FINE``.
    ``curves_only``: whether only edges shorter than ``FINE`` are merged.
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
            and (not curves_only or (fine[other // 2] and fine[end // 2]))
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
    ``order``, ``flipped``, ``first``, ``closed``: the runs, as for ``_split_runs``.
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
        ax, ay = _direction(rows[end // 2], end % 2 == 1)
        bx, by = _direction(rows[other // 2], other % 2 == 1)
        # Both directions point along their edges: an end at the start leaves the corner.
        if (ax * bx + ay * by) * (1.0 if end % 2 == other % 2 else -1.0) > _ACUTE:
            acute[end // 2] = True
            acute[other // 2] = True
    return acute


@kernel
def _oriented(row: F64_1, back: bool, out: OutF64_1) -> None:
    if back:
        out[0], out[1], out[2], out[3], out[4] = row[2], row[3], row[0], row[1], -row[4]
        out[5] = row[5]
    else:
        out[:] = row


@kernel
def _split_runs(
    rows: F64_2,
    length: F64_1,
    changeable: Bool_1,
    acute: Bool_1,
    order: OutI32_1,
    flipped: OutBool_1,
    first: I32_1,
    closed: Bool_1,
) -> Any:
    """Split runs of connected edges into groups that are each replaced by one line or one arc.

    A run is a chain of edges that continue each other.

    ``rows`` (k, 6): edges: x0, y0, x1, y1, bulge, and distance from the curve of the file (mm).
    ``length`` (k,): lengths of the edges (mm).
    ``changeable`` (k,): whether each edge belongs to a run of which edges may be merged or
    replaced.
    ``acute`` (k,): whether each edge ends at an acute corner, so that it belongs to no fitted
    curve.
    ``order``, ``flipped`` (k,): edges in the order of the runs, and whether each is traversed from
    its end to its start. In both arrays the edges of a closed run are rotated in place, so that the
    run starts at its sharpest corner, or with its longest line.
    ``first`` (r + 1,): index into ``order`` of the first edge of each of r runs, followed by the
    number k.
    ``closed`` (r,): whether each run is closed.
    Returns begin, new, is_curve: for each of m groups: index into ``order`` of its first edge,
    (m,); the edge that replaces it, in the direction of the run, as a row like those of ``rows``,
    (m, 6); and whether it replaces chords of a curve, (m,).
    """
    count = len(order)
    begin = np.empty(count, np.int64)
    new = np.empty((count, 6))
    is_curve = np.zeros(count, np.bool_)
    run, size, along = np.empty((count, 6)), np.empty(count), np.empty(count + 1)
    stays, turned, again = (
        np.empty(count, np.bool_),
        np.empty(count, np.int32),
        np.empty(count, np.bool_),
    )
    until, part, arcs = np.empty(count, np.int64), np.empty(3, np.int64), np.empty((3, 5))
    groups = 0
    for r in range(len(first) - 1):
        low, high = first[r], first[r + 1]
        many = high - low
        if not changeable[order[low]]:
            for i in range(low, high):
                begin[groups] = i
                groups += 1
            continue
        for i in range(many):
            _oriented(rows[order[low + i]], flipped[low + i], run[i])
            size[i] = length[order[low + i]]
        if closed[r]:
            shift = _first_segment(run, size, many)
            if shift:
                for i in range(many):
                    turned[i] = order[low + i]
                    again[i] = flipped[low + i]
                for i in range(many):
                    order[low + i] = turned[(i + shift) % many]
                    flipped[low + i] = again[(i + shift) % many]
                    _oriented(rows[order[low + i]], flipped[low + i], run[i])
                    size[i] = length[order[low + i]]
        along[0] = 0.0
        for i in range(many):
            along[i + 1] = along[i] + size[i]
            stays[i] = acute[order[low + i]]
        is_smooth = mark_smooth(run, size, stays, many, CURVE, FINE, until)
        if closed[r] and is_smooth and until[0] == many:
            carried = run[:many, 5].max()
            x, y, radius, far = fit_circle(run, many, CURVE - carried)
            number = 0
            if far < math.inf:
                number = divide_circle(run, many, x, y, radius, part, arcs)
            for k in range(number):
                begin[groups] = low + part[k]
                new[groups, :5] = arcs[k]
                new[groups, 5] = carried + far
                is_curve[groups] = True
                groups += 1
            if number:
                continue
        i = 0
        while i < many:
            begin[groups] = low + i
            j = _longest_fit(run, size, along, until, i, many, new[groups])
            if i == 0 and j == many and closed[r]:
                # A whole circle stays in parts: one edge cannot start where it ends.
                for k in range(many):
                    begin[groups] = low + k
                    new[groups] = run[k]
                    groups += 1
                break
            is_curve[groups] = j < 0
            j = abs(j)
            groups += 1
            if is_curve[groups - 1]:
                rest = _balance(run, along, i, j, until[i], new[groups - 1], new[groups])
                if rest > 0:
                    begin[groups] = low + (i + rest) // 2
                    is_curve[groups] = True
                    groups += 1
                    j = rest
            i = j
    return begin[:groups], new[:groups], is_curve[:groups]


@kernel
def _first_segment(run: F64_2, size: F64_1, count: int) -> int:
    """Return the index of the segment with which a closed run starts.

    It is the one after the sharpest corner.  If there are only smooth joints, it is the first one
    of the line that contains the longest segment, so that no arc is divided there.

    ``run`` (k, 6): the first ``count`` rows are the segments of the closed run: x0, y0, x1, y1,
    bulge, distance from the curve of the file (mm).
    ``size`` (k,): lengths of the segments (mm).
    """
    best, longest = 0, 0
    least = 2.0
    for i in range(count):
        cosine = _turn(run, i, count)
        if cosine < least - 1e-6:
            least = cosine
            best = i
        if size[i] > size[longest] + POINT:
            longest = i
    if least < 1.0 / math.hypot(1.0, SMOOTH_TURN):
        return best
    for _ in range(count):
        if _turn(run, longest, count) < _STRAIGHT:
            break
        longest = (longest - 1) % count
    return longest


@kernel(allocates=False)
def _turn(run: F64_2, i: int, count: int) -> float:
    """Return the cosine of the turn at the start of segment ``i`` of a closed run."""
    ax, ay = _direction(run[i - 1] if i else run[count - 1], True)
    bx, by = _direction(run[i], False)
    return ax * bx + ay * by


@kernel
def _direction(row: F64_1, last: bool) -> tuple[float, float]:
    half = 2.0 * math.atan(row[4])
    if not last:
        half = -half
    dx, dy = row[2] - row[0], row[3] - row[1]
    size = math.hypot(dx, dy)
    c, s = math.cos(half) / size, math.sin(half) / size
    return dx * c - dy * s, dx * s + dy * c


@kernel
def _longest_fit(
    run: F64_2,
    size: F64_1,
    along: F64_1,
    until: I64_1,
    i: int,
    count: int,
    out: OutF64_1,
) -> int:
    """Fit the longest possible line or arc to the segments of a run, from segment ``i`` on.

    A run is a chain of segments.  Returns the index of the first segment that the line or arc does
    not replace; it is negative if the line or arc replaces chords of a curve.

    ``run`` (k, 6): segments in order: x0, y0, x1, y1, bulge, distance from the curve of the file
    (mm); only the first ``count`` rows are used.
    ``size``, ``along`` (k,) and (k + 1,): lengths of the segments, and length of the run before
    each of them (mm).
    ``until`` (k,): for each segment, the index after the last segment of its smooth run.
    ``i``: index of the first segment to replace.
    ``out`` (6,): receives the line or arc, as a row like those of ``run``.
    """
    best = i + 1
    bulge = run[i, 4]
    far = 0.0
    if i + 1 < count:
        carried = run[i, 5]
        if abs(bulge) < BULGE:
            end = longest_line(run, i, count, _permitted_move(carried))
            if end > best:
                best, bulge, far = end, 0.0, greatest_distance(run, i, end, 0.0)
        else:
            turn = run[i, 4] > 0.0
            end = i + 1
            sum_ = math.atan(run[i, 4])
            code = 0.0
            while end < count and abs(run[end, 4]) >= BULGE and (run[end, 4] > 0.0) == turn:
                sum_ += math.atan(run[end, 4])
                if abs(sum_) > math.pi / 4.0 + 1e-9:
                    break
                code = math.tan(sum_)
                off = greatest_distance(run, i, end + 1, code)
                carried = max(carried, run[end, 5])
                if off > _permitted_move(carried):
                    break
                end += 1
                best, bulge, far = end, code, off
    is_curve = False
    limit = until[i]
    few = FEW_FINE if size[i] < FINE else FEW_CHORDS
    if limit >= i + few and limit > best:
        carried = run[i:limit, 5].max()
        tolerance = CURVE - carried
        end = longest_line(run, i, limit, tolerance) if tolerance > JOIN else best
        if end >= i + few and end > best:
            off = greatest_distance(run, i, end, 0.0)
            if off <= tolerance:
                best, bulge, far, is_curve = end, 0.0, off, True
        end, code, off = longest_arc(run, along, i, limit, tolerance)
        # Chords at the end of a curve are no line, although one would be near enough.
        is_nearer = is_curve and end == best and off < 0.5 * far
        if end >= i + few and (end > best or is_nearer):
            best, bulge, far, is_curve = end, code, off, True
    out[0], out[1], out[2], out[3] = run[i, 0], run[i, 1], run[best - 1, 2], run[best - 1, 3]
    out[4] = bulge
    out[5] = run[i:best, 5].max()
    if far > POINT:
        out[5] += far
    return -best if is_curve else best


@inline_kernel
def _permitted_move(carried: float) -> float:
    """Return the distance by which an edge may still be moved (mm).  ``carried`` is its distance
    from the curve that it replaces (mm).
    """
    return min(JOIN, CURVE - carried) if carried > 0.0 else JOIN


@kernel
def _balance(
    run: F64_2,
    along: F64_1,
    i: int,
    j: int,
    limit: int,
    first_arc: OutF64_1,
    second_arc: OutF64_1,
) -> int:
    """Divide the last chords of a smooth run equally between two arcs.

    The chords ``i`` … ``j - 1`` are replaced by one arc, which leaves fewer than ``FEW_CHORDS`` of
    the run, too few for an arc of their own.  A smooth run may end with a line that is no chord:
    the last segment is left out if no two arcs fit otherwise.

    ``run``, ``along``: segments, and length of the run before each of them (mm), as for
    ``_longest_fit``.
    ``limit``: index after the last segment of the smooth run.
    ``first_arc``, ``second_arc`` (6,): receive the two arcs, which meet after half of the chords.
    Returns the index of the first segment that the two arcs do not replace; 0 if there are no such
    arcs.
    """
    if not 0 < limit - j < FEW_CHORDS:
        return 0
    carried = run[i:limit, 5].max()
    for last in range(limit, max(j, limit - 2), -1):
        middle = (i + last) // 2
        b, far = fit_arc(run, along, i, middle, CURVE - carried)
        if far == math.inf:
            continue
        code, off = fit_arc(run, along, middle, last, CURVE - carried)
        if off == math.inf:
            continue
        first_arc[2:4] = run[middle - 1, 2:4]
        first_arc[4], first_arc[5] = b, carried + far
        second_arc[:2] = run[middle, :2]
        second_arc[2:4] = run[last - 1, 2:4]
        second_arc[4], second_arc[5] = code, carried + off
        return last
    return 0
