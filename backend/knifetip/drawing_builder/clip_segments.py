"""Clip lines and arcs at the regions of a ``Clip``: keep only what lies inside.

A segment is split where it crosses an edge of a region.  Each piece is kept if its middle lies
inside the region or on its edge: a line along the border of a clip path is visible.

The edges of a region are sorted into horizontal strips, so that a segment is compared only with the
edges near it.  The number of comparisons is limited: a file may be made so that all edges cross all
strips.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.drawing_builder.clip import UNBOUNDED, Box, Clip, Region
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.kernels import F64_1, F64_3, I64_1, Bool_1, OutF64_1, kernel

#: Largest number of comparisons of a segment with an edge, in one drawing.
_BUDGET: Final = 60_000_000
#: Edges per strip, and largest number of strips.
_PER_STRIP: Final = 4
_STRIPS: Final = 4096
#: A segment whose bulge is smaller is a line.
_STRAIGHT: Final = 1e-9


class ClippedSegments(NamedTuple):
    """m pieces that remain of n segments."""

    ends: F64  #: (m, 2, 2)
    bulge: F64  #: (m,)
    source: I64  #: (m,) segment of each piece, ascending
    unlimited: Bool  #: (n,) whether a region was not applied, because clipping takes too long


class _Segment(NamedTuple):
    """A line or an arc."""

    x0: float  #: x of its start
    y0: float  #: y of its start
    x1: float  #: x of its end
    y1: float  #: y of its end
    bulge: float  #: tan(sweep / 4)


class _Edges(NamedTuple):
    """The m edges of a ``Region``, which describes the columns."""

    ends: F64_3  #: (m, 2, 2)
    part: I64_1  #: (m,)
    even_odd: Bool_1  #: (parts,)


def clip_segments(
    ends: F64, bulge: F64, clip_of: I64, clips: Sequence[Clip], margin: float
) -> ClippedSegments:
    """Return the parts of n segments that lie inside their clips.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) and (n,)
        Ends (file units) and bulges of the segments.
    clip_of : (n,)
        Index into ``clips`` of the clip of each segment.
    clips
        The clips.
    margin
        Distance from the edge of a region within which a point counts as inside (file units).
    """
    source = np.arange(len(bulge))
    unlimited = np.zeros(len(bulge), bool)
    budget = _BUDGET
    # The n-th pass applies the n-th region of every clip; the first pass applies the rectangles.
    for number in range(1 + max((len(clip.regions) for clip in clips), default=0)):
        regions, region_of_clip = _regions(clips, number)
        if not regions:
            continue
        region_of = region_of_clip[clip_of[source]]
        kept, crossing = _compare_boxes(ends, bulge, regions, region_of, margin)
        pieces = [(kept, np.zeros(len(kept)), np.ones(len(kept)))]
        for rows in _groups(crossing, region_of):
            region = regions[region_of[rows[0]]]
            edges = _Edges(region.edges, region.part, region.even_odd)
            row, first, last, cost = _clip_to_region(ends, bulge, rows, edges, margin, budget)
            budget -= cost
            if budget < 0:
                unlimited[source[rows]] = True
                row, first, last = rows, np.zeros(len(rows)), np.ones(len(rows))
            pieces.append((row, first, last))
        row, first, last = (np.concatenate(column) for column in zip(*pieces, strict=True))
        order = np.lexsort((first, row))
        row, first, last = row[order], first[order], last[order]
        source = source[row]
        ends, bulge = _parts(ends[row], bulge[row], first, last)
    return ClippedSegments(ends, bulge, source, unlimited)


def _regions(clips: Sequence[Clip], number: int) -> tuple[list[Region], I64]:
    """Return the different regions that are region number ``number`` of a clip.

    The second value is the index of the region of each clip, -1 for none.  Region 0 of a clip is
    its rectangle.
    """
    regions: list[Region] = []
    index: dict[Box | int, int] = {}
    region_of_clip = np.full(len(clips), -1, np.int64)
    for one, clip in enumerate(clips):
        if number > len(clip.regions) or (number == 0 and clip.box == UNBOUNDED):
            continue
        key = id(clip.regions[number - 1]) if number else clip.box
        if key not in index:
            index[key] = len(regions)
            regions.append(clip.regions[number - 1] if number else _rectangle(clip.box))
        region_of_clip[one] = index[key]
    return regions, region_of_clip


def _rectangle(box: Box) -> Region:
    low_x, low_y, high_x, high_y = box
    if low_x > high_x or low_y > high_y:
        return Region()
    corners = np.array([(low_x, low_y), (high_x, low_y), (high_x, high_y), (low_x, high_y)])
    edges = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)
    return Region(edges, np.zeros(4, np.int64), np.zeros(1, np.bool_))


def _compare_boxes(
    ends: F64, bulge: F64, regions: Sequence[Region], region_of: I64, margin: float
) -> tuple[I64, I64]:
    """Return the segments that are wholly visible, and those that an edge of a region may cross.

    ``ends``, ``bulge`` (n, 2, 2) and (n,): the segments.
    ``regions``, ``region_of``: the regions, and the index of the region of each segment, (n,), -1
    for none.
    ``margin``: distance from the edge of a region within which a point counts as inside (file
    units).
    """
    low_x, low_y, high_x, high_y = _boxes(ends, bulge)
    box = np.array([one.box for one in regions])[region_of]
    is_rectangle = np.array([one.is_rectangle for one in regions])[region_of]
    outside = (
        (high_x < box[:, 0] - margin)
        | (high_y < box[:, 1] - margin)
        | (low_x > box[:, 2] + margin)
        | (low_y > box[:, 3] + margin)
    )
    inside = (
        is_rectangle
        & (low_x >= box[:, 0] - margin)
        & (low_y >= box[:, 1] - margin)
        & (high_x <= box[:, 2] + margin)
        & (high_y <= box[:, 3] + margin)
    )
    free = region_of < 0
    return np.flatnonzero(free | inside), np.flatnonzero(~free & ~inside & ~outside)


def _boxes(ends: F64, bulge: F64) -> tuple[F64, F64, F64, F64]:
    """Return x min, y min, x max and y max of n segments; boxes of arcs may be too large."""
    x, y = ends[:, :, 0], ends[:, :, 1]
    # No point of an arc is farther from its chord than the sagitta, half a chord times the bulge.
    rise = np.abs(bulge) / 2.0 * np.hypot(x[:, 1] - x[:, 0], y[:, 1] - y[:, 0])
    return x.min(axis=1) - rise, y.min(axis=1) - rise, x.max(axis=1) + rise, y.max(axis=1) + rise


def _groups(rows: I64, region_of: I64) -> list[I64]:
    """Return the ``rows`` that have the same region, for each region."""
    if not len(rows):
        return []
    rows = rows[np.argsort(region_of[rows], kind="stable")]
    return np.split(rows, np.flatnonzero(np.diff(region_of[rows])) + 1)


def _parts(ends: F64, bulge: F64, first: F64, last: F64) -> tuple[F64, F64]:
    """Return ends and bulge of the part of each of n segments between two fractions of it."""
    ends, bulge = ends.copy(), bulge.copy()
    cut = np.flatnonzero((first > 0.0) | (last < 1.0))
    start, end, turn = ends[cut, 0], ends[cut, 1], bulge[cut]
    begins, stops = first[cut], last[cut]
    lead = np.where(begins[:, None] > 0.0, arc.point_at(start, end, turn, begins), start)
    tail = np.where(stops[:, None] < 1.0, arc.point_at(start, end, turn, stops), end)
    ends[cut] = np.stack([lead, tail], axis=1)
    bulge[cut] = np.tan(np.arctan(turn) * (stops - begins))
    return ends, bulge


@kernel
def _clip_to_region(
    ends: F64_3, bulge: F64_1, rows: I64_1, region: _Edges, margin: float, budget: int
) -> Any:
    """Return the parts of segments that lie inside a region, and the number of comparisons.

    ``ends``, ``bulge`` (n, 2, 2) and (n,): ends and bulges of segments.
    ``rows`` (k,): the segments to clip.
    ``margin``: distance from an edge within which a point counts as inside (file units).
    ``budget``: number of comparisons after which the function stops; its parts are then incomplete.
    Returns ``row, first, last`` (p,): segment of each part, and the fractions of the segment at
    which the part starts and ends; cost: number of comparisons.
    """
    edges = region.ends
    low, height, strip, first_edge = _strips(edges, margin)
    capacity = len(rows) + 16
    row_of = np.empty(capacity, np.int64)
    first, last = np.empty(capacity), np.empty(capacity)
    count = cost = 0
    cuts = np.empty(64)
    for row in rows:
        x0, y0, x1, y1, b = (
            ends[row, 0, 0],
            ends[row, 0, 1],
            ends[row, 1, 0],
            ends[row, 1, 1],
            bulge[row],
        )
        segment = _Segment(x0, y0, x1, y1, b)
        chord = math.hypot(x1 - x0, y1 - y0)
        rise = abs(b) / 2.0 * chord
        length = chord if abs(b) < _STRAIGHT else chord * math.atan(abs(b)) * (1.0 + b * b) / abs(b)
        from_strip = _strip_at(min(y0, y1) - rise - margin, low, height, len(first_edge) - 1)
        to_strip = _strip_at(max(y0, y1) + rise + margin, low, height, len(first_edge) - 1)
        cuts[0], cuts[1] = 0.0, 1.0
        cut_count = 2
        for at in range(first_edge[from_strip], first_edge[to_strip + 1]):
            if cut_count + 4 > len(cuts):
                more = np.empty(2 * len(cuts))
                more[:cut_count] = cuts[:cut_count]
                cuts = more
            edge = strip[at]
            if (
                min(edges[edge, 0, 0], edges[edge, 1, 0]) > max(x0, x1) + rise + margin
                or max(edges[edge, 0, 0], edges[edge, 1, 0]) < min(x0, x1) - rise - margin
                or min(edges[edge, 0, 1], edges[edge, 1, 1]) > max(y0, y1) + rise + margin
                or max(edges[edge, 0, 1], edges[edge, 1, 1]) < min(y0, y1) - rise - margin
            ):
                continue
            start = (edges[edge, 0, 0], edges[edge, 0, 1])
            end = (edges[edge, 1, 0], edges[edge, 1, 1])
            cut_count = _add_cuts(segment, start, end, margin, cuts, cut_count)
        cost += first_edge[to_strip + 1] - first_edge[from_strip]
        sorted_cuts = np.sort(cuts[:cut_count])
        visible = 0.0
        begin = count
        for k in range(cut_count - 1):
            low_cut, high_cut = sorted_cuts[k], sorted_cuts[k + 1]
            if high_cut - low_cut <= 0.0:
                continue
            x, y = _point_at(segment, (low_cut + high_cut) / 2.0)
            at_strip = _strip_at(y, low, height, len(first_edge) - 1)
            cost += first_edge[at_strip + 1] - first_edge[at_strip]
            if cost > budget:
                return row_of[:0], first[:0], last[:0], cost
            near = strip[first_edge[at_strip] : first_edge[at_strip + 1]]
            if not _is_inside(x, y, region, near, margin):
                continue
            visible += high_cut - low_cut
            if count > begin and last[count - 1] == low_cut:
                last[count - 1] = high_cut
                continue
            if count == capacity:
                capacity *= 2
                more_rows = np.empty(capacity, np.int64)
                more_first, more_last = np.empty(capacity), np.empty(capacity)
                more_rows[:count] = row_of
                more_first[:count], more_last[:count] = first, last
                row_of, first, last = more_rows, more_first, more_last
            row_of[count], first[count], last[count] = row, low_cut, high_cut
            count += 1
        # Parts that the width of a line would hide are neither removed nor kept alone.
        if (1.0 - visible) * length <= 2.0 * margin and visible > 0.0:
            row_of[begin], first[begin], last[begin] = row, 0.0, 1.0
            count = begin + 1
        elif visible * length <= 2.0 * margin:
            count = begin
    return row_of[:count], first[:count], last[:count], cost


@kernel
def _strips(edges: F64_3, margin: float) -> Any:
    """Return the horizontal strips of a region, each with the edges that reach into it.

    The result is y of the lowest strip, the height of a strip, the edges of all strips one after
    the other, and for each strip where its edges begin, with the end of the last strip.
    """
    low, high, rises = np.inf, -np.inf, 0.0
    for edge in range(len(edges)):
        low = min(low, edges[edge, 0, 1], edges[edge, 1, 1])
        high = max(high, edges[edge, 0, 1], edges[edge, 1, 1])
        rises += abs(edges[edge, 1, 1] - edges[edge, 0, 1])
    strips = max(1, min(len(edges) // _PER_STRIP, _STRIPS))
    # Strips lower than most edges would only repeat the edges.
    if rises > 0.0:
        strips = max(1, min(strips, int((high - low) * len(edges) / rises)))
    if not high > low:
        strips, low, high = 1, 0.0, 1.0
    height = (high - low) / strips
    first_edge = np.zeros(strips + 1, np.int64)
    for fill in range(2):
        if fill:
            for one in range(strips):
                first_edge[one + 1] += first_edge[one]
            strip = np.empty(first_edge[strips], np.int64)
            used = first_edge.copy()
        for edge in range(len(edges)):
            bottom = min(edges[edge, 0, 1], edges[edge, 1, 1]) - margin
            top = max(edges[edge, 0, 1], edges[edge, 1, 1]) + margin
            for one in range(
                _strip_at(bottom, low, height, strips), _strip_at(top, low, height, strips) + 1
            ):
                if fill:
                    strip[used[one]] = edge
                    used[one] += 1
                else:
                    first_edge[one + 1] += 1
    return low, height, strip, first_edge


@kernel
def _strip_at(y: float, low: float, height: float, strips: int) -> int:
    """Return the strip at height ``y``, the nearest strip outside the region."""
    return min(max(int((y - low) / height), 0), strips - 1)


@kernel
def _point_at(segment: _Segment, fraction: float) -> tuple[float, float]:
    """Return the point at a fraction (0 … 1) of the length of a segment."""
    x0, y0, x1, y1, bulge = segment
    if abs(bulge) < _STRAIGHT:
        return x0 + (x1 - x0) * fraction, y0 + (y1 - y0) * fraction
    half = 2.0 * math.atan(bulge)
    ratio = math.sin(fraction * half) / math.sin(half)
    turn = (fraction - 1.0) * half
    cosine, sine = ratio * math.cos(turn), ratio * math.sin(turn)
    x, y = x1 - x0, y1 - y0
    return x0 + x * cosine - y * sine, y0 + x * sine + y * cosine


@kernel
def _fraction_at(
    x0: float, y0: float, centre_x: float, centre_y: float, sweep: float, x: float, y: float
) -> float:
    """Return the fraction of an arc at the direction of a point (x, y), outside 0 … 1 if beyond."""
    ax, ay, px, py = x0 - centre_x, y0 - centre_y, x - centre_x, y - centre_y
    turn = math.atan2(ax * py - ay * px, ax * px + ay * py)
    if turn * sweep < 0.0:
        turn += 2.0 * math.pi if sweep > 0.0 else -2.0 * math.pi
    return turn / sweep


@kernel
def _add_cuts(
    segment: _Segment,
    start: tuple[float, float],
    end: tuple[float, float],
    margin: float,
    cuts: OutF64_1,
    count: int,
) -> int:
    """Add the fractions of a segment at which it may cross an edge, and return their new number.

    The edge goes from ``start`` to ``end``.  The fractions are those of common
    points with the edge, and of the points next to the start of the edge.
    """
    x0, y0, x1, y1, bulge = segment
    edge_x, edge_y = start
    across_x, across_y = end[0] - edge_x, end[1] - edge_y
    size = math.hypot(across_x, across_y)
    if size == 0.0:
        return count
    over = margin / size
    if abs(bulge) < _STRAIGHT:
        dx, dy = x1 - x0, y1 - y0
        square = dx * dx + dy * dy
        if square == 0.0:
            return count
        ax, ay = edge_x - x0, edge_y - y0
        determinant = dx * across_y - dy * across_x
        if determinant != 0.0:
            t = (ax * across_y - ay * across_x) / determinant
            u = (ax * dy - ay * dx) / determinant
            if 0.0 < t < 1.0 and -over <= u <= 1.0 + over:
                cuts[count] = t
                count += 1
        if abs(dx * ay - dy * ax) <= margin * math.sqrt(square):
            t = (dx * ax + dy * ay) / square
            if 0.0 < t < 1.0:
                cuts[count] = t
                count += 1
        return count
    apothem = (1.0 - bulge * bulge) / (4.0 * bulge)
    cx = (x0 + x1) / 2.0 - (y1 - y0) * apothem
    cy = (y0 + y1) / 2.0 + (x1 - x0) * apothem
    radius = math.hypot(x0 - cx, y0 - cy)
    sweep = 4.0 * math.atan(bulge)
    along = ((cx - edge_x) * across_x + (cy - edge_y) * across_y) / (size * size)
    off = ((cx - edge_x) * across_y - (cy - edge_y) * across_x) / size
    half_square = radius * radius - off * off
    if half_square >= 0.0:
        half = math.sqrt(half_square) / size
        for u in (along - half, along + half):
            if -over <= u <= 1.0 + over:
                t = _fraction_at(
                    x0, y0, cx, cy, sweep, edge_x + u * across_x, edge_y + u * across_y
                )
                if 0.0 < t < 1.0:
                    cuts[count] = t
                    count += 1
    if abs(math.hypot(edge_x - cx, edge_y - cy) - radius) <= margin:
        t = _fraction_at(x0, y0, cx, cy, sweep, edge_x, edge_y)
        if 0.0 < t < 1.0:
            cuts[count] = t
            count += 1
    return count


@kernel
def _is_inside(x: float, y: float, region: _Edges, near: I64_1, margin: float) -> bool:
    """Return whether a point lies inside a region or within ``margin`` of an edge of it.

    ``near`` are the edges that reach into the strip of the point.
    """
    edges, part, even_odd = region
    winding = 0
    current = -1
    for edge in near:
        if part[edge] != current:
            if current >= 0 and (winding % 2 != 0 if even_odd[current] else winding != 0):
                return True
            current, winding = part[edge], 0
        ax, ay, bx, by = edges[edge, 0, 0], edges[edge, 0, 1], edges[edge, 1, 0], edges[edge, 1, 1]
        dx, dy = bx - ax, by - ay
        square = dx * dx + dy * dy
        t = min(max(((x - ax) * dx + (y - ay) * dy) / square, 0.0), 1.0) if square > 0.0 else 0.0
        if math.hypot(ax + t * dx - x, ay + t * dy - y) <= margin:
            return True
        if (ay <= y) != (by <= y) and ax + (y - ay) / dy * dx > x:
            winding += 1 if dy > 0.0 else -1
    return current >= 0 and (winding % 2 != 0 if even_odd[current] else winding != 0)
