"""merge_collinear: merge collinear lines, concentric arcs and segments of flattened curves.

Two edges are merged only if they have the same line type and no third edge ends at the point where
they meet or near it (within ``GAP``).  Lines become one line if every joint is within ``JOIN``
(0.002 mm) of it; arcs that turn in the same direction become one arc within the same distance.
Three or more edges shorter than ``FINE`` (0.05 mm) are treated as a flattened curve: they are
replaced by a line or an arc within ``FITTED`` (0.005 mm) of them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.cleaning.end_points import EndPoints
from knifetip.geometry import arc
from knifetip.geometry.chain import follow_links
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.tolerance import BULGE, GAP, JOIN, SAME
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
    kernel,
)

#: Segments shorter than this belong to a flattened curve (mm).
FINE: Final = GAP
#: Largest distance of a flattened curve from the line or arc that replaces it (mm).
FITTED: Final = SAME / 2.0
#: Least number of segments of a curve.
_FEW: Final = 3


@dataclass(frozen=True, eq=False, slots=True)
class Merged:
    """The m edges that result from merging k edges.

    ``merged_edge`` contains for each of the k edges the index of the edge that replaces it.
    """

    ends: F64  #: (m, 2, 2) mm
    bulge: F64  #: (m,)
    kind: U8  #: (m,) LineType
    merged_edge: I32  #: (k,) merged edge that contains each edge
    deviation: F64  #: (m,) greatest distance of its parts from the merged edge (mm)
    fitted: Bool  #: (m,) whether the merged edge replaces a flattened curve


def merge_collinear(
    ends: F64, bulge: F64, kind: U8, end_points: EndPoints, *, curves_only: bool = False
) -> Merged:
    """Return k edges after merging those that continue each other.

    A merged edge has the direction of the first edge, in drawing order, that it contains.  Edges
    that are not merged are unchanged, bit for bit.

    Parameters
    ----------
    ends : (k, 2, 2)
        Start and end points of the edges (mm).
    bulge, kind : (k,)
        Bulges and line types of the edges.
    end_points
        Points that the ends of the edges share, and pairs of ends that are near each other.
    curves_only
        Whether only segments of flattened curves are merged.
    """
    count = len(bulge)
    length = arc.length(ends[:, 0], ends[:, 1], bulge)
    fine = length < FINE
    link = _continuations(end_points.place, end_points.pairs, kind, fine, curves_only)
    order, flipped, first, round_ = follow_links(link)
    rows = np.column_stack([ends.reshape(-1, 4), bulge])
    begin, code, off = _split_runs(rows, length, order, flipped, first, round_, JOIN, FITTED, FINE)
    size = np.diff(np.append(begin, count))
    if (size == 1).all():
        every = np.arange(count, dtype=np.int32)
        return Merged(ends, bulge, kind, every, np.zeros(count), np.zeros(count, np.bool_))
    group = np.repeat(np.arange(len(begin)), size)
    least = np.minimum.reduceat(order, begin)
    rank = np.argsort(np.argsort(least, kind="stable"), kind="stable").astype(np.int32)
    several = size > 1
    head, tail = begin[several], (begin + size)[several] - 1
    start = ends[order[head], flipped[head].astype(np.int64)]
    finish = ends[order[tail], 1 - flipped[tail]]
    position = np.empty(count, np.int64)
    position[order] = np.arange(count)
    back = flipped[position[least[several]]]
    new_ends, new_bulge = ends[least].copy(), bulge[least].copy()
    new_ends[several, 0] = np.where(back[:, None], finish, start)
    new_ends[several, 1] = np.where(back[:, None], start, finish)
    new_bulge[several] = np.where(back, -code[several], code[several])
    where = np.argsort(rank)
    of = np.empty(count, np.int32)
    of[order] = rank[group]
    curve = np.bincount(group[fine[order]], minlength=len(begin)) >= _FEW
    return Merged(
        new_ends[where],
        new_bulge[where],
        kind[least][where],
        of,
        off[where],
        curve[where],
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

    Parameters
    ----------
    place : (2k,)
        Index of the point of each end; ends that meet have the same point.
    near_pairs : (q, 2)
        Pairs of ends at different points that are near each other.
    kind, fine : (k,)
        Line type of each edge, and whether it is shorter than ``FINE``.
    curves_only
        Whether only edges shorter than ``FINE`` are merged.
    """
    count = np.zeros(len(place), np.int64)
    short = np.zeros(len(place), np.bool_)
    for end in range(len(place)):
        count[place[end]] += 1
        short[place[end]] |= fine[end // 2]
    for k in range(len(near_pairs)):
        a, b = place[near_pairs[k, 0]], place[near_pairs[k, 1]]
        # Ends along a flattened curve are always near others.
        if not short[a] and not short[b]:
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
def _oriented(row: F64_1, back: bool, out: OutF64_1) -> None:
    if back:
        out[0], out[1], out[2], out[3], out[4] = row[2], row[3], row[0], row[1], -row[4]
    else:
        out[:] = row


@kernel
def _split_runs(
    rows: F64_2,
    length: F64_1,
    order: OutI32_1,
    flipped: OutBool_1,
    first: I32_1,
    closed: Bool_1,
    join: float,
    fitted: float,
    fine: float,
) -> Any:
    """Split runs of connected edges into groups that are each replaced by one line or one arc.

    A run is a chain of edges that continue each other.

    Parameters
    ----------
    rows : (k, 5)
        Edges: x0, y0, x1, y1, bulge.
    length : (k,)
        Lengths of the edges (mm).
    order, flipped : (k,)
        Edges in the order of the runs, and whether each is traversed from its end to its start.
        In both arrays the edges of a closed run are rotated in place, so that the run starts at its
        sharpest corner.
    first : (r + 1,)
        Index into ``order`` of the first edge of each of r runs, followed by the number k.
    closed : (r,)
        Whether each run is closed.
    join
        Largest distance of collinear lines, or of concentric arcs, from their replacement (mm).
    fitted
        Largest distance of a flattened curve from its replacement (mm).
    fine
        Edges shorter than this belong to a flattened curve (mm).

    Returns
    -------
    begin, bulge, deviation
        For each group: index into ``order`` of its first edge, bulge of the line or arc that
        replaces the group, and greatest distance of the group from it (mm).
    """
    count = len(order)
    begin = np.empty(count, np.int64)
    code = np.empty(count)
    off = np.zeros(count)
    run = np.empty((count, 5))
    size = np.empty(count)
    groups = 0
    for r in range(len(first) - 1):
        low, high = first[r], first[r + 1]
        many = high - low
        if many == 1:
            begin[groups] = low
            code[groups] = rows[order[low], 4]
            groups += 1
            continue
        for i in range(many):
            _oriented(rows[order[low + i]], flipped[low + i], run[i])
        if closed[r]:
            shift = _sharpest(run, many)
            if shift:
                turned = np.roll(order[low:high], -shift)
                order[low:high] = turned
                again = np.roll(flipped[low:high].astype(np.int64), -shift)
                for i in range(many):
                    flipped[low + i] = again[i] == 1
                    _oriented(rows[order[low + i]], flipped[low + i], run[i])
        for i in range(many):
            size[i] = length[order[low + i]]
        i = 0
        while i < many:
            j, b, far = _longest_fit(run, size, i, many, join, fitted, fine)
            if i == 0 and j == many and closed[r]:
                # A whole circle stays in parts: one edge cannot start where it ends.
                for k in range(many):
                    begin[groups] = low + k
                    code[groups] = run[k, 4]
                    groups += 1
                break
            begin[groups] = low + i
            code[groups] = b
            off[groups] = far
            groups += 1
            i = j
    return begin[:groups].copy(), code[:groups].copy(), off[:groups].copy()


@kernel
def _sharpest(run: F64_2, count: int) -> int:
    """Return the index of the segment that starts at the sharpest corner of a closed run.

    The first ``count`` rows of ``run`` are the segments of the closed run: x0, y0, x1, y1, bulge.
    """
    best = 0
    least = 2.0
    for i in range(count):
        before = run[i - 1] if i else run[count - 1]
        ax, ay = _direction(before, True)
        bx, by = _direction(run[i], False)
        cosine = ax * bx + ay * by
        if cosine < least - 1e-6:
            least = cosine
            best = i
    return best


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
    run: F64_2, size: F64_1, i: int, count: int, join: float, fitted: float, fine: float
) -> tuple[int, float, float]:
    """Fit the longest possible line or arc to the segments of a run, from segment ``i`` on.

    A run is a chain of segments.  Returns the index of the first segment that the line or arc does
    not replace, the bulge of the line or arc, and the greatest distance of the replaced segments
    from it (mm).

    Parameters
    ----------
    run : (k, 5)
        Segments in order: x0, y0, x1, y1, bulge; only the first ``count`` rows are used.
    size : (k,)
        Lengths of the segments (mm).
    i
        Index of the first segment to replace.
    count
        Number of segments in the run.
    join
        Largest distance of collinear lines, or of concentric arcs, from their replacement (mm).
    fitted
        Largest distance of a flattened curve from its replacement (mm).
    fine
        Segments shorter than this belong to a flattened curve (mm).
    """
    best = i + 1
    bulge = run[i, 4]
    far = 0.0
    if i + 1 < count:
        if abs(bulge) < BULGE:
            end = _longest_line(run, i, count, join)
            if end > best:
                best, bulge, far = end, 0.0, _deviation(run, i, end, 0.0)
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
                off = _deviation(run, i, end + 1, code)
                if off > join:
                    break
                end += 1
                best, bulge, far = end, code, off
    if size[i] < fine:
        limit = i
        while limit < count and size[limit] < fine:
            limit += 1
        if limit - i >= 3:
            end = _longest_line(run, i, limit, fitted)
            if end >= i + 3 and end > best:
                best, bulge, far = end, 0.0, _deviation(run, i, end, 0.0)
            end, code, off = _longest_arc(run, size, i, limit, fitted)
            if end >= i + 3 and end > best:
                best, bulge, far = end, code, off
    return best, bulge, far


@kernel
def _longest_line(run: F64_2, i: int, limit: int, tolerance: float) -> int:
    """Fit the longest line that starts where segment ``i`` of ``run`` starts.

    All joints between the replaced segments are within ``tolerance`` mm of the line.  Segments from
    index ``limit`` on are not replaced.  Returns the index of the first segment that is not
    replaced.
    """
    x, y = run[i, 0], run[i, 1]
    low, high = -math.inf, math.inf
    base = math.atan2(run[i, 3] - y, run[i, 2] - x)
    reached = 0.0
    end = i
    best = i + 1
    while end < limit and abs(run[end, 4]) < BULGE:
        dx, dy = run[end, 2] - x, run[end, 3] - y
        far = math.hypot(dx, dy)
        if far <= reached:
            break
        way = math.atan2(dy, dx) - base
        way = (way + math.pi) % (2.0 * math.pi) - math.pi
        if abs(way) > 0.5 * math.pi:
            break
        end += 1
        if low <= way <= high:
            best = end
        slack = math.asin(tolerance / far) if far > tolerance else math.pi
        low = max(low, way - slack)
        high = min(high, way + slack)
        if low > high:
            break
        reached = far
    return best


@kernel
def _longest_arc(
    run: F64_2, size: F64_1, i: int, limit: int, tolerance: float
) -> tuple[int, float, float]:
    """Fit the longest arc that starts where segment ``i`` of ``run`` starts.

    The replaced segments are within ``tolerance`` mm of the arc.  Segments from index ``limit`` on
    are not replaced.  ``size`` contains the lengths of the segments (mm).  The number of replaced
    segments is found by doubling and bisection.

    Returns the index of the first segment that is not replaced, the bulge of the arc, and the
    greatest distance of the replaced segments from it (mm).  If no arc fits, the index is ``i``,
    and bulge and distance are 0.
    """
    good, code, off = i, 0.0, 0.0
    step = 4
    bad = limit + 1
    while True:
        end = min(i + step, limit)
        b = _arc_bulge(run, size, i, end)
        far = _deviation(run, i, end, b) if abs(b) <= 1.0 else math.inf
        if far <= tolerance:
            good, code, off = end, b, far
            if end == limit:
                return good, code, off
            step *= 2
        else:
            bad = end
            break
    low = good if good > i else i + 2
    while bad - low > 1:
        end = (low + bad) // 2
        b = _arc_bulge(run, size, i, end)
        far = _deviation(run, i, end, b) if abs(b) <= 1.0 else math.inf
        if far <= tolerance:
            low, good, code, off = end, end, b, far
        else:
            bad = end
    return good, code, off


@kernel
def _arc_bulge(run: F64_2, size: F64_1, i: int, end: int) -> float:
    """Return the bulge of the arc that replaces the segments ``run[i]`` … ``run[end - 1]``.

    The arc passes through the start of the first segment, the end of the last segment, and the
    joint near the middle of their length.  ``size`` contains the lengths of the segments (mm).
    """
    total = 0.0
    for k in range(i, end):
        total += size[k]
    half = 0.0
    mid = i
    while mid < end - 2 and half + size[mid] < 0.5 * total:
        half += size[mid]
        mid += 1
    px, py = run[mid, 2], run[mid, 3]
    ax, ay = run[i, 0] - px, run[i, 1] - py
    bx, by = run[end - 1, 2] - px, run[end - 1, 3] - py
    # The inscribed angle at the joint is π minus half the sweep.
    angle = math.atan2(ax * by - ay * bx, ax * bx + ay * by)
    open_ = math.pi - abs(angle)
    bulge = math.tan(0.5 * open_)
    return -bulge if angle > 0.0 else bulge


@kernel
def _deviation(run: F64_2, i: int, end: int, bulge: float) -> float:
    """Return the greatest distance (mm) of some segments from the line or arc that replaces them.

    The segments are ``run[i]`` … ``run[end - 1]``.  The line or arc has the bulge ``bulge``, and
    connects the start of the first segment to the end of the last segment.  The distance is
    measured at the midpoint and at the end of each segment.  It is infinite if these points do not
    follow each other along the line or arc, or if the start and the end coincide.
    """
    x0, y0, x1, y1 = run[i, 0], run[i, 1], run[end - 1, 2], run[end - 1, 3]
    dx, dy = x1 - x0, y1 - y0
    chord = math.hypot(dx, dy)
    if chord == 0.0:
        return math.inf
    worst = 0.0
    before = -1.0
    straight = abs(bulge) < 1e-7
    cx = cy = radius = sweep = 0.0
    mx = my = 0.0
    if not straight:
        lean = (1.0 - bulge * bulge) / (4.0 * bulge)
        cx = 0.5 * (x0 + x1) - lean * dy
        cy = 0.5 * (y0 + y1) + lean * dx
        radius = chord * (1.0 + bulge * bulge) / (4.0 * abs(bulge))
        sweep = 4.0 * math.atan(bulge)
        mx = 0.5 * (x0 + x1) + 0.5 * bulge * dy - cx
        my = 0.5 * (y0 + y1) - 0.5 * bulge * dx - cy
    for k in range(2 * i, 2 * end):
        s = k // 2
        if k % 2:
            x, y = run[s, 2], run[s, 3]
        else:
            b = run[s, 4]
            x = 0.5 * (run[s, 0] + run[s, 2]) + 0.5 * b * (run[s, 3] - run[s, 1])
            y = 0.5 * (run[s, 1] + run[s, 3]) - 0.5 * b * (run[s, 2] - run[s, 0])
        if straight:
            off = abs((x - x0) * dy - (y - y0) * dx) / chord
            place = ((x - x0) * dx + (y - y0) * dy) / (chord * chord)
        else:
            off = abs(math.hypot(x - cx, y - cy) - radius)
            px, py = x - cx, y - cy
            place = 0.5 + math.atan2(mx * py - my * px, mx * px + my * py) / sweep
        worst = max(worst, off)
        if place <= before or place < -1e-3 or place > 1.0 + 1e-3:
            return math.inf
        before = place
    return worst
