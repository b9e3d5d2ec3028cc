"""Overlaps of curves with edges, and the stretches of curves and edges without an overlap.

An overlap is a stretch of a curve whose distance from an edge is at most a limit.  If a stretch of
a curve overlaps several edges, only the overlap with the nearest edge counts.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_1, F64_2, I32_1, I32_2, I64_1, OutF64_2, kernel
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.group_order import order_in_groups

#: Lengths that differ by less are equal (mm).
EPSILON: Final = 1e-9
#: An overlap that adds less than this does not count (mm): paths may have gaps of 0.002 mm, and
#: programs are printed to 0.0001 mm.
SHORT: Final = 0.005
#: Copies of an edge differ by less in their distance from a curve (mm).
TWIN: Final = 1e-6


@dataclass(frozen=True, eq=False, slots=True)
class Overlaps:
    """k overlaps of curves with edges, sorted by curve and then by distance from the edge.

    An overlap is a stretch of a curve whose distance from an edge is at most a limit.
    """

    curve: I32  #: (k,) index of the curve
    edge: I32  #: (k,) index of the edge
    along: F64  #: (k, 2) mm along the curve, ascending
    place: F64  #: (k, 2) mm along the edge, at the two points of ``along``
    distance: F64  #: (k,) mm, greatest distance within the overlap
    best: Bool  #: (k,) a part of the overlap is on no nearer edge, so it counts

    def __len__(self) -> int:
        return len(self.curve)

    @property
    def is_forward(self) -> Bool:
        """Mask of the overlaps in which curve and edge run in the same direction, (k,)."""
        result: Bool = self.place[:, 1] > self.place[:, 0]
        return result

    def place_range(self) -> tuple[F64, F64]:
        """Return the lowest and the highest position of each overlap on its edge, (k,) mm each."""
        # By column, since operations on rows of two numbers are slow.
        first, last = self.place.T
        return np.minimum(first, last), np.maximum(first, last)

    def select(self, keep: Bool) -> Overlaps:
        """Return the overlaps for which the mask ``keep``, (k,), is True."""
        return Overlaps(
            self.curve[keep],
            self.edge[keep],
            self.along[keep],
            self.place[keep],
            self.distance[keep],
            self.best[keep],
        )

    @classmethod
    def none(cls) -> Overlaps:
        """Return an empty record, for curves that overlap no edge."""
        rows, spans = np.zeros(0, np.int32), np.zeros((0, 2))
        return cls(rows, rows, spans, spans, np.zeros(0), np.zeros(0, np.bool_))


def sort_overlaps(pairs: I32, spans: F64, curves: F64) -> Overlaps:
    """Return k overlaps of curves with edges, sorted by curve and then by distance from the edge.

    The field ``best`` of the result is False for an overlap if overlaps of the same curve with
    nearer edges cover it.

    Parameters
    ----------
    pairs : (k, 2)
        Index of the curve and index of the edge of each overlap, sorted by curve.
    spans : (k, 5) mm
        Five lengths for each overlap: its start and end along the curve, the positions on the edge
        of these two points, and its greatest distance from the edge.
    curves : (n, 6)
        All curves: lines and arcs as rows of six numbers (see ``curves.curve``).
    """
    curve, edge, along, place, distance = _sort_by_distance(pairs, spans)
    length = curves[:, 5].copy()
    best = _nearest_mask(curve, along, distance, length, length)
    return Overlaps(curve, edge, along, place, distance, best)


def mark_nearest(overlaps: Overlaps, curves: F64, considered: F64) -> Overlaps:
    """Return the overlaps with their field ``best`` computed again, for the first part of each
    curve only.

    ``best`` is False for an overlap if overlaps of the same curve with nearer edges cover it, or if
    the overlap begins after the first part of its curve.

    Parameters
    ----------
    overlaps
        Overlaps of curves with edges.
    curves : (n, 6)
        All curves: lines and arcs as rows of six numbers (see ``curves.curve``).
    considered : (n,) mm
        Length of the first part of each curve.
    """
    best = _nearest_mask(
        overlaps.curve, overlaps.along, overlaps.distance, curves[:, 5].copy(), considered
    )
    return replace(overlaps, best=best)


def within_limits(overlaps: Overlaps, limit: F64, curves: F64) -> Overlaps:
    """Return the overlaps whose distance from their edge is at most the limit of the edge.

    Their field ``best`` is computed again: it is False for an overlap if overlaps of the same curve
    with nearer edges cover it.

    Parameters
    ----------
    overlaps
        Overlaps of curves with edges.
    limit : (m,) mm
        Greatest distance from each of m edges.
    curves : (n, 6)
        All curves: lines and arcs as rows of six numbers (see ``curves.curve``).
    """
    near_overlaps = overlaps.select(overlaps.distance <= limit[overlaps.edge])
    return mark_nearest(near_overlaps, curves, curves[:, 5].copy())


def nearest_parts(overlaps: Overlaps, rows: I64) -> F64:
    """Return the start and end on its curve of the part of each of n overlaps that no nearer edge
    covers, (n, 2) mm.

    If there are several such parts, the result reaches from the first to the last of them; if there
    is none, it is the whole overlap.

    Parameters
    ----------
    overlaps
        Overlaps of curves with edges, sorted by curve and then by distance.
    rows : (n,)
        Indices of the n overlaps.
    """
    first = np.searchsorted(overlaps.curve, overlaps.curve[rows]).astype(np.int64)
    parts: F64 = _nearest_parts(first, rows, overlaps.along, overlaps.distance)
    return parts


def uncovered_curves(overlaps: Overlaps, curves: F64) -> tuple[I32, F64]:
    """Return the k stretches of curves that overlap no edge.

    The result is the index of the curve of each stretch, (k,), and the start and end of the stretch
    along that curve, (k, 2) mm.  A curve of length 0 that overlaps no edge gives a stretch of
    length 0.  ``curves`` are all curves, and ``overlaps`` are their overlaps with the edges.
    """
    curve_rows, spans, count = _uncovered_spans(overlaps.curve, overlaps.along, curves[:, 5].copy())
    return curve_rows[:count], spans[:count]


def uncovered_edges(edge: I64, low: F64, high: F64, size: F64) -> tuple[I64, F64, F64]:
    """Return the k stretches of m edges that none of n intervals covers.

    Parameters
    ----------
    edge, low, high : (n,)
        Index of the edge of each interval, and the start and end of the interval along that edge
        (mm), with start ≤ end.  The intervals need not be sorted.
    size : (m,) mm
        Length of each edge.

    Returns
    -------
    Three arrays, (k,) each: index of the edge of each stretch, and the start and the end of the
    stretch on that edge (mm).
    """
    all_rows = np.arange(len(size))
    edge = np.concatenate([edge, all_rows])
    low, high = np.concatenate([low, size]), np.concatenate([high, size])
    order = order_in_groups(edge, low, high)
    edge, low, high = edge[order], np.maximum(low[order], 0.0), high[order]
    # Offset each edge, so that one running maximum serves all edges.
    step = edge * (2.0 * float(size.max(initial=0.0)) + 1.0)
    reached = np.maximum.accumulate(np.minimum(high, size[edge]) + step) - step
    before = np.concatenate([[0.0], reached[:-1]])
    new = np.ones(len(edge), np.bool_)
    new[1:] = edge[1:] != edge[:-1]
    before[new] = 0.0
    is_uncovered = low - before > EPSILON
    return edge[is_uncovered].astype(np.int64), before[is_uncovered], low[is_uncovered]


@kernel
def _sort_by_distance(pairs: I32_2, spans: F64_2) -> Any:
    """Return the columns of overlaps, with the overlaps of each curve sorted by distance.

    The overlaps are sorted by curve already; equal distances keep their order.  ``sort_overlaps``
    describes the arguments, and ``Overlaps`` the five returned columns ``curve`` to ``distance``.
    """
    count = len(pairs)
    order = np.empty(count, np.int64)
    curve, edge = np.empty(count, np.int32), np.empty(count, np.int32)
    along, place = np.empty((count, 2)), np.empty((count, 2))
    distance = np.empty(count)
    begin = 0
    while begin < count:
        end = begin + 1
        while end < count and pairs[end, 0] == pairs[begin, 0]:
            end += 1
        if end - begin > 32:
            order[begin:end] = begin + np.argsort(spans[begin:end, 4], kind="mergesort")
        else:
            for row in range(begin, end):
                slot = row
                while slot > begin and spans[order[slot - 1], 4] > spans[row, 4]:
                    order[slot] = order[slot - 1]
                    slot -= 1
                order[slot] = row
        begin = end
    for row in range(count):
        source = order[row]
        curve[row], edge[row] = pairs[source, 0], pairs[source, 1]
        along[row, 0], along[row, 1] = spans[source, 0], spans[source, 1]
        place[row, 0], place[row, 1] = spans[source, 2], spans[source, 3]
        distance[row] = spans[source, 4]
    return curve, edge, along, place, distance


@kernel
def _nearest_mask(
    curve_of: I32_1, along: F64_2, distance: F64_1, length: F64_1, considered: F64_1
) -> Any:
    """Return the mask of those of k overlaps that count as overlaps with the nearest edge, (k,).

    An overlap is a stretch of a curve near an edge.  It counts if overlaps of the same curve with
    nearer edges leave a part of the stretch uncovered.  If an edge is drawn twice, the overlaps
    with both copies count.

    ``curve_of`` (k,): index of the curve of each overlap.  The overlaps are sorted by curve, then
    by distance.
    ``along``, ``distance`` (k, 2) and (k,) mm: start and end of each overlap along its curve, and
    its greatest distance from the edge.
    ``length``, ``considered`` (n,) mm: length of each of n curves, and the length from its start
    that is considered.
    """
    best = np.zeros(len(curve_of), np.bool_)
    covered = np.empty((16, 2))
    begin = 0
    while begin < len(curve_of):
        end = begin
        while end < len(curve_of) and curve_of[end] == curve_of[begin]:
            end += 1
        if len(covered) <= end - begin:
            covered = np.empty((2 * (end - begin), 2))
        many = 0
        curve = curve_of[begin]
        short = length[curve] <= SHORT
        for row in range(begin, end):
            right = min(along[row, 1], considered[curve])
            left = min(along[row, 0], right)
            many, gained = add_interval(covered, many, left, right)
            # A curve works both copies of an edge that is drawn twice.
            twin = distance[row] <= distance[begin] + TWIN
            counts = right - left > SHORT or (short and along[row, 1] <= considered[curve])
            best[row] = gained > SHORT or (twin and counts)
        begin = end
    return best


@kernel
def _nearest_parts(first: I64_1, rows: I64_1, along: F64_2, distance: F64_1) -> Any:
    """Return the parts of n of k overlaps that no nearer edge covers; see ``nearest_parts``.

    ``first``, ``rows`` (n,): index of the first overlap of the same curve, and of the overlap
    itself.
    ``along``, ``distance`` (k, 2) and (k,) mm: start and end of each overlap along its curve, and
    its greatest distance from the edge.
    """
    parts = np.empty((len(rows), 2))
    covered = np.empty((16, 2))
    for k in range(len(rows)):
        row, start = rows[k], first[k]
        if len(covered) <= row - start:
            covered = np.empty((2 * (row - start), 2))
        many = 0
        for other in range(start, row):
            # An edge that is drawn twice covers none of its copies.
            if distance[other] < distance[row] - TWIN:
                many, _ = add_interval(covered, many, along[other, 0], along[other, 1])
        left, right = along[row, 0], along[row, 1]
        for other in range(many):
            if covered[other, 0] <= left < covered[other, 1]:
                left = covered[other, 1]
            if covered[other, 0] < right <= covered[other, 1]:
                right = covered[other, 0]
        if left >= right:
            left, right = along[row, 0], along[row, 1]
        parts[k, 0], parts[k, 1] = left, right
    return parts


@kernel(allocates=False)
def add_interval(covered: OutF64_2, used: int, left: float, right: float) -> Any:
    """Merge an interval into a list of sorted, disjoint intervals, in place.

    The list is the first ``used`` rows of ``covered``, each a start and an end; ``left`` and
    ``right`` are the start and end of the new interval.  Returns the new number of rows in use, and
    the length of the new interval that was not covered before.
    """
    first = 0
    while first < used and covered[first, 1] < left:
        first += 1
    last = first
    old = 0.0
    low = left
    high = right
    while last < used and covered[last, 0] <= right:
        old += min(covered[last, 1], right) - max(covered[last, 0], left)
        low = min(low, covered[last, 0])
        high = max(high, covered[last, 1])
        last += 1
    merged = last - first
    if merged == 0:
        for k in range(used, first, -1):
            covered[k, 0] = covered[k - 1, 0]
            covered[k, 1] = covered[k - 1, 1]
        used += 1
    elif merged > 1:
        for k in range(last, used):
            covered[k - merged + 1, 0] = covered[k, 0]
            covered[k - merged + 1, 1] = covered[k, 1]
        used -= merged - 1
    covered[first, 0] = low
    covered[first, 1] = high
    return used, (right - left) - old


@kernel
def _uncovered_spans(curve_of: I32_1, along: F64_2, length: F64_1) -> Any:
    curve_rows = np.empty(len(curve_of) + len(length), np.int32)
    spans = np.empty((len(curve_rows), 2))
    count = 0
    covered = np.empty((16, 2))
    row = 0
    for curve in range(len(length)):
        begin = row
        while row < len(curve_of) and curve_of[row] == curve:
            row += 1
        if len(covered) <= row - begin:
            covered = np.empty((2 * (row - begin), 2))
        many = 0
        for k in range(begin, row):
            many, _ = add_interval(covered, many, along[k, 0], along[k, 1])
        if length[curve] < 1e-9:
            if row == begin:
                curve_rows[count] = curve
                spans[count, 0] = 0.0
                spans[count, 1] = 0.0
                count += 1
            continue
        position = 0.0
        for k in range(many + 1):
            stop = covered[k, 0] if k < many else length[curve]
            if stop - position > 1e-7:
                curve_rows[count] = curve
                spans[count, 0] = position
                spans[count, 1] = stop
                count += 1
            if k < many:
                position = covered[k, 1]
    return curve_rows, spans, count
