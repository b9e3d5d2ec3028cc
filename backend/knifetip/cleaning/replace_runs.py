"""replace_runs: replace the edges of a run by as few lines, arcs or circles as possible.

A run is a chain of edges that continue each other.  The distance of the edges from what replaces
them, and their own distance from the curve of the file that import has approximated, are together
at most ``CURVE`` (0.0035 mm).  Where the vertices of a curve are rounded to 0.01 mm, nearly every
chord then stays, as no arc is that near.  A run with many such chords is replaced within ``FIT``
(0.008 mm) if that leaves at most half as many edges.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.cleaning.fit_curves import (
    FEW_CHORDS,
    FEW_FINE,
    FINE,
    SMOOTH_TURN,
    divide_circle,
    fit_arc,
    fit_circle,
    greatest_distance,
    longest_arc,
    longest_line,
    mark_smooth,
)
from knifetip.geometry.tolerance import BULGE, CURVE, FIT, JOIN, POINT
from knifetip.kernels import (
    F64_1,
    F64_2,
    I32_1,
    Bool_1,
    OutBool_1,
    OutF64_1,
    OutF64_2,
    OutI32_1,
    OutI64_1,
    inline_kernel,
    kernel,
)

#: Cosine of a turn that is none (0.0026°).
_STRAIGHT: Final = 1.0 - 1e-9
#: A curve is rough if an edge is left of every so many of its chords.
_ROUGH: Final = 8


class _Run(NamedTuple):
    """The segments of one run in order; only the first rows are used."""

    rows: OutF64_2  #: (k, 6): x0, y0, x1, y1, bulge, distance from the curve of the file (mm)
    size: OutF64_1  #: (k,) lengths of the segments (mm)
    along: OutF64_1  #: (k + 1,) length of the run before each segment (mm)
    stays: OutBool_1  #: (k,) mask of the segments that belong to no fitted curve
    until: OutI64_1  #: (k,) index after the last segment of the smooth run of each segment


class _Groups(NamedTuple):
    """Groups of segments that are each replaced by one line or one arc."""

    begin: OutI64_1  #: (m,) index of the first segment
    new: OutF64_2  #: (m, 6) the edge that replaces the group, as a row like those of a run
    is_curve: OutBool_1  #: (m,) whether the edge replaces chords of a curve


@kernel
def _oriented(row: F64_1, back: bool, out: OutF64_1) -> None:
    if back:
        out[0], out[1], out[2], out[3], out[4] = row[2], row[3], row[0], row[1], -row[4]
        out[5] = row[5]
    else:
        out[:] = row


@kernel
def replace_runs(
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
    run = _Run(
        np.empty((count, 6)),
        np.empty(count),
        np.empty(count + 1),
        np.empty(count, np.bool_),
        np.empty(count, np.int64),
    )
    groups = _Groups(np.empty(count, np.int64), np.empty((count, 6)), np.empty(count, np.bool_))
    wider = _Groups(np.empty(count, np.int64), np.empty((count, 6)), np.empty(count, np.bool_))
    turned, again = np.empty(count, np.int32), np.empty(count, np.bool_)
    total = 0
    for r in range(len(first) - 1):
        low, high = first[r], first[r + 1]
        many = high - low
        if not changeable[order[low]]:
            for i in range(low, high):
                groups.begin[total] = i
                groups.is_curve[total] = False
                total += 1
            continue
        for i in range(many):
            _oriented(rows[order[low + i]], flipped[low + i], run.rows[i])
            run.size[i] = length[order[low + i]]
        if closed[r]:
            shift = _first_segment(run.rows, run.size, many)
            if shift:
                for i in range(many):
                    turned[i] = order[low + i]
                    again[i] = flipped[low + i]
                for i in range(many):
                    order[low + i] = turned[(i + shift) % many]
                    flipped[low + i] = again[(i + shift) % many]
                    _oriented(rows[order[low + i]], flipped[low + i], run.rows[i])
                    run.size[i] = length[order[low + i]]
        run.along[0] = 0.0
        for i in range(many):
            run.along[i + 1] = run.along[i] + run.size[i]
            run.stays[i] = acute[order[low + i]]
        made = _replace_run(run, many, closed[r], CURVE, groups, total)
        if _has_rough_curve(run, many, groups, total, made):
            found = _replace_run(run, many, closed[r], FIT, wider, 0)
            if 2 * found <= made:
                made = found
                groups.begin[total : total + made] = wider.begin[:made]
                groups.new[total : total + made] = wider.new[:made]
                groups.is_curve[total : total + made] = wider.is_curve[:made]
        groups.begin[total : total + made] += low
        total += made
    return groups.begin[:total], groups.new[:total], groups.is_curve[:total]


@inline_kernel
def _has_rough_curve(run: _Run, count: int, groups: _Groups, place: int, made: int) -> bool:
    """Return whether many edges are left of the smooth curves of a run.

    The run has ``count`` segments, and ``made`` groups from index ``place`` of ``groups`` on.
    """
    smooth = left = 0
    for i in range(count):
        smooth += run.until[i] > i + 1
    for k in range(place + 1, place + made):
        before = groups.begin[k] - 1
        left += run.until[before] > before + 1
    return left >= FEW_CHORDS and left * _ROUGH >= smooth


@kernel
def _replace_run(
    run: _Run, count: int, closed: bool, tolerance: float, groups: _Groups, place: int
) -> int:
    """Replace the segments of one run.

    The run has ``count`` segments; its array ``until`` is computed here.  ``closed`` is whether it
    is closed, and ``tolerance`` the greatest distance of a segment from the curve of the file (mm).
    The result is written to ``groups`` from index ``place`` on; ``begin`` is an index into the run.
    Returns the number of groups.
    """
    at = place
    is_smooth = mark_smooth(run.rows, run.size, run.stays, count, tolerance, FINE, run.until)
    if closed and is_smooth and run.until[0] == count:
        number = _replace_by_circle(run.rows, count, tolerance, groups, at)
        if number:
            return number
    i = 0
    while i < count:
        groups.begin[at] = i
        j = _longest_fit(run, i, count, tolerance, groups.new[at])
        if i == 0 and j == count and closed:
            # A whole circle stays in parts: one edge cannot start where it ends.
            for k in range(count):
                groups.begin[at] = k
                groups.new[at] = run.rows[k]
                groups.is_curve[at] = False
                at += 1
            break
        groups.is_curve[at] = j < 0
        j = abs(j)
        at += 1
        if groups.is_curve[at - 1]:
            rest = _balance(run, i, j, tolerance, groups.new[at - 1], groups.new[at])
            if rest > 0:
                groups.begin[at] = (i + rest) // 2
                groups.is_curve[at] = True
                at += 1
                j = rest
        i = j
    return at - place


@kernel
def _replace_by_circle(
    run: F64_2, count: int, tolerance: float, groups: _Groups, place: int
) -> int:
    """Replace the ``count`` segments of a closed smooth run by the arcs of a circle.

    The other parameters are those of ``_replace_run``.  Returns the number of groups; 0 if no
    circle is near enough.
    """
    carried = run[:count, 5].max()
    x, y, radius, far = fit_circle(run, count, tolerance - carried)
    if far == math.inf:
        return 0
    part, arcs = np.empty(3, np.int64), np.empty((3, 5))
    number = divide_circle(run, count, x, y, radius, part, arcs)
    for k in range(number):
        groups.begin[place + k] = part[k]
        groups.new[place + k, :5] = arcs[k]
        groups.new[place + k, 5] = carried + far
        groups.is_curve[place + k] = True
    return number


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
    ax, ay = direction(run[i - 1] if i else run[count - 1], True)
    bx, by = direction(run[i], False)
    return ax * bx + ay * by


@kernel
def direction(row: F64_1, last: bool) -> tuple[float, float]:
    """Return the direction of an edge at its start, or at its end, as a unit vector."""
    half = 2.0 * math.atan(row[4])
    if not last:
        half = -half
    dx, dy = row[2] - row[0], row[3] - row[1]
    size = math.hypot(dx, dy)
    c, s = math.cos(half) / size, math.sin(half) / size
    return dx * c - dy * s, dx * s + dy * c


@kernel
def _longest_fit(segments: _Run, i: int, count: int, tolerance: float, out: OutF64_1) -> int:
    """Fit the longest possible line or arc to the segments of a run, from segment ``i`` on.

    Returns the index of the first segment that the line or arc does not replace; it is negative if
    the line or arc replaces chords of a curve.

    ``segments``: the run, of ``count`` segments.
    ``tolerance``: greatest distance of a segment from the curve of the file (mm).
    ``out`` (6,): receives the line or arc, as a row like those of a run.
    """
    run, size = segments.rows, segments.size
    best = i + 1
    bulge = run[i, 4]
    far = 0.0
    if i + 1 < count:
        carried = run[i, 5]
        if abs(bulge) < BULGE:
            end = longest_line(run, i, count, _permitted_move(carried, tolerance))
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
                if off > _permitted_move(carried, tolerance):
                    break
                end += 1
                best, bulge, far = end, code, off
    is_curve = False
    limit = segments.until[i]
    few = FEW_FINE if size[i] < FINE else FEW_CHORDS
    if limit >= i + few and limit > best:
        carried = run[i:limit, 5].max()
        slack = tolerance - carried
        end = longest_line(run, i, limit, slack) if slack > JOIN else best
        if end >= i + few and end > best:
            off = greatest_distance(run, i, end, 0.0)
            if off <= slack:
                best, bulge, far, is_curve = end, 0.0, off, True
        end, code, off = longest_arc(run, segments.along, i, limit, slack, tolerance > CURVE)
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
def _permitted_move(carried: float, tolerance: float) -> float:
    """Return the distance by which an edge may still be moved (mm).  ``carried`` is its distance
    from the curve that it replaces, and ``tolerance`` the greatest one (mm).
    """
    return min(JOIN, tolerance - carried) if carried > 0.0 else JOIN


@kernel
def _balance(
    segments: _Run,
    i: int,
    j: int,
    tolerance: float,
    first_arc: OutF64_1,
    second_arc: OutF64_1,
) -> int:
    """Divide the last chords of a smooth run equally between two arcs.

    The chords ``i`` … ``j - 1`` are replaced by one arc, which leaves fewer than ``FEW_CHORDS`` of
    the smooth run, too few for an arc of their own.  A smooth run may end with a line that is no
    chord: the last segment is left out if no two arcs fit otherwise.

    ``segments``, ``tolerance``: as for ``_longest_fit``.
    ``first_arc``, ``second_arc`` (6,): receive the two arcs, which meet after half of the chords.
    Returns the index of the first segment that the two arcs do not replace; 0 if there are no such
    arcs.
    """
    run, along, limit = segments.rows, segments.along, segments.until[i]
    if not 0 < limit - j < FEW_CHORDS:
        return 0
    carried = run[i:limit, 5].max()
    for last in range(limit, max(j, limit - 2), -1):
        middle = (i + last) // 2
        b, far = fit_arc(run, along, i, middle, tolerance - carried, tolerance > CURVE)
        if far == math.inf:
            continue
        code, off = fit_arc(run, along, middle, last, tolerance - carried, tolerance > CURVE)
        if off == math.inf:
            continue
        first_arc[2:4] = run[middle - 1, 2:4]
        first_arc[4], first_arc[5] = b, carried + far
        second_arc[:2] = run[middle, :2]
        second_arc[2:4] = run[last - 1, 2:4]
        second_arc[4], second_arc[5] = code, carried + off
        return last
    return 0
