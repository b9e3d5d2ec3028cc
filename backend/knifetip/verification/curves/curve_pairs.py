"""Find the stretches of one curve that lie within a given distance of one edge.

Curves and edges are lines and arcs as rows of six numbers (see ``curves.curve``).  The ends of a
stretch are computed in closed form; only the greatest distance within it is sampled.
"""

from __future__ import annotations

import math
from typing import Any, Final

from knifetip.kernels import F64_1, F64_2, OutF64_2, inline_kernel, kernel

#: Number of points of a stretch at which its distance from the edge is computed.
_SAMPLES: Final = 9


@kernel(allocates=False, checks_division=True)
def overlap_pair(
    curve: F64_1,
    edge: F64_1,
    low: float,
    high: float,
    limit: float,
    near: OutF64_2,
    hits: OutF64_2,
) -> int:
    """Write the overlaps of one curve with one edge to the rows of ``hits``; return their number.

    At least one of the two is an arc; for two lines see ``overlap_lines``.
    ``low`` and ``high`` are the start and end of the part of the edge that is compared, and
    ``limit`` is the greatest distance of an overlap from the edge (mm).  A row has five lengths
    (mm): start and end of the overlap along the curve, the positions on the edge of these two
    points, and the greatest distance from the edge.  ``near`` is scratch, (8, 2).
    """
    if curve[0] == 0.0:
        pieces = _line_near_arc(curve, edge, limit, near)
    else:
        pieces = _arc_near_edge(curve, edge, limit, near)
    hit_count = 0
    for piece in range(pieces):
        begin = near[piece, 0]
        end = near[piece, 1]
        x, y = _point_on(curve, begin)
        first, _ = _project(edge, x, y)
        x, y = _point_on(curve, end)
        last, _ = _project(edge, x, y)
        turns = 1
        circumference = 0.0
        if edge[0] != 0.0:
            # On a circle, choose the turn of the end that fits the curve's length, and try the edge
            # one turn earlier and later.  A curve with its centre outside turns by less than π.
            circumference = 2.0 * math.pi * edge[3]
            ahead = 0.0
            if curve[0] != 0.0 and math.hypot(curve[1] - edge[1], curve[2] - edge[2]) < curve[3]:
                ahead = curve[0] * edge[0] * (end - begin) * edge[3] / curve[3]
            last += circumference * round((first + ahead - last) / circumference)
            turns = 3
        for turn in range(turns):
            shift = 0.0 if turn == 0 else (circumference if turn == 1 else -circumference)
            a = first + shift
            b = last + shift
            slack = limit if end - begin < 1e-9 else 1e-9
            past = max(low - max(a, b), min(a, b) - high, 0.0)
            if past > slack:
                continue
            if past > 1e-9:
                # A point beyond the end of the edge: its distance is that from the end.
                x, y = _point_on(curve, begin)
                _, offset = _project(edge, x, y)
                if math.hypot(past, offset) > limit:
                    continue
            u0 = begin
            u1 = end
            if abs(b - a) > 1e-9:
                rate = (end - begin) / (b - a)
                t0 = min(max(a, low), high)
                t1 = min(max(b, low), high)
                u0 = begin + (t0 - a) * rate
                u1 = begin + (t1 - a) * rate
                a = t0
                b = t1
            else:
                a = min(max(a, low), high)
                b = min(max(b, low), high)
            if hit_count == len(hits):
                return hit_count
            farthest = 0.0
            for sample in range(_SAMPLES):
                x, y = _point_on(curve, u0 + (u1 - u0) * sample / (_SAMPLES - 1))
                _, offset = _project(edge, x, y)
                farthest = max(farthest, abs(offset))
            hits[hit_count, 0] = u0
            hits[hit_count, 1] = u1
            hits[hit_count, 2] = a
            hits[hit_count, 3] = b
            hits[hit_count, 4] = farthest
            hit_count += 1
    return hit_count


@inline_kernel
def overlap_lines(
    curves: F64_2, curve: int, edges: F64_2, edge: int, low: float, high: float, limit: float,
    hits: OutF64_2,
) -> int:  # fmt: skip
    """Write the overlap of a line with a straight edge to the first row of ``hits``.

    Returns the number of overlaps, 0 or 1.  ``overlap_pair`` describes the other arguments and the
    row.  The line is row ``curve`` of ``curves``, and the edge is row ``edge`` of ``edges``.
    """
    x, y, length = curves[curve, 1], curves[curve, 2], curves[curve, 5]
    ahead_x, ahead_y = curves[curve, 3], curves[curve, 4]
    edge_x, edge_y = edges[edge, 3], edges[edge, 4]
    dx, dy = x - edges[edge, 1], y - edges[edge, 2]
    offset = edge_x * dy - edge_y * dx
    slope = edge_x * ahead_y - edge_y * ahead_x
    begin, end = 0.0, length
    if abs(slope) * max(length, 1.0) < 1e-12:
        if abs(offset) > limit:
            return 0
    else:
        a, b = (-limit - offset) / slope, (limit - offset) / slope
        begin, end = max(min(a, b), 0.0), min(max(a, b), length)
        if begin > end:
            return 0
    begin_x, begin_y = x + ahead_x * begin - edges[edge, 1], y + ahead_y * begin - edges[edge, 2]
    end_x, end_y = x + ahead_x * end - edges[edge, 1], y + ahead_y * end - edges[edge, 2]
    first, last = begin_x * edge_x + begin_y * edge_y, end_x * edge_x + end_y * edge_y
    past = max(low - max(first, last), min(first, last) - high, 0.0)
    if past > (limit if end - begin < 1e-9 else 1e-9):
        return 0
    if past > 1e-9 and math.hypot(past, edge_x * begin_y - edge_y * begin_x) > limit:
        return 0
    from_place, to_place = min(max(first, low), high), min(max(last, low), high)
    if abs(last - first) > 1e-9:
        rate = (end - begin) / (last - first)
        end = begin + (to_place - first) * rate
        begin = begin + (from_place - first) * rate
    farthest = 0.0
    for sample in range(2):
        at = begin + (end - begin) * sample
        dx, dy = x + ahead_x * at - edges[edge, 1], y + ahead_y * at - edges[edge, 2]
        farthest = max(farthest, abs(edge_x * dy - edge_y * dx))
    hits[0, 0], hits[0, 1], hits[0, 2], hits[0, 3] = begin, end, from_place, to_place
    hits[0, 4] = farthest
    return 1


@inline_kernel
def overlap_point(
    x: float, y: float, edges: F64_2, edge: int, low: float, high: float, limit: float,
    hits: OutF64_2,
) -> int:  # fmt: skip
    """Write the overlap of the point (x, y) with a straight edge to the first row of ``hits``.

    Returns the number of overlaps, 0 or 1.  This is the short form of ``overlap_lines``, which
    describes the arguments, for the most common pairs.
    """
    dx, dy = x - edges[edge, 1], y - edges[edge, 2]
    along = dx * edges[edge, 3] + dy * edges[edge, 4]
    offset = abs(edges[edge, 3] * dy - edges[edge, 4] * dx)
    past = max(low - along, along - high, 0.0)
    if offset > limit or past > limit or (past > 1e-9 and math.hypot(past, offset) > limit):
        return 0
    place = min(max(along, low), high)
    hits[0, 0], hits[0, 1], hits[0, 2], hits[0, 3], hits[0, 4] = 0.0, 0.0, place, place, offset
    return 1


@kernel(allocates=False, checks_division=True)
def _project(edge: F64_1, x: float, y: float) -> Any:
    """Return the position of the point (x, y) along an edge, and its distance from the edge.

    Both are in mm, and refer to the infinite line or the full circle of the edge.  The distance is
    positive to the left of a line and outside of a circle.
    """
    dx = x - edge[1]
    dy = y - edge[2]
    if edge[0] == 0.0:
        return dx * edge[3] + dy * edge[4], edge[3] * dy - edge[4] * dx
    turned = edge[0] * (math.atan2(dy, dx) - edge[4])
    # Centre the range of angles on the arc, so that it extends beyond both ends.
    half = 0.5 * edge[5] / edge[3]
    turned = (turned - half + math.pi) % (2.0 * math.pi) - math.pi + half
    return turned * edge[3], math.hypot(dx, dy) - edge[3]


@kernel(allocates=False, checks_division=True)
def _point_on(curve: F64_1, along: float) -> Any:
    if curve[0] == 0.0:
        return curve[1] + curve[3] * along, curve[2] + curve[4] * along
    angle = curve[4] + curve[0] * along / curve[3]
    return curve[1] + curve[3] * math.cos(angle), curve[2] + curve[3] * math.sin(angle)


@kernel(allocates=False)
def _append_clipped(begin: float, end: float, length: float, near: OutF64_2, pieces: int) -> int:
    begin = max(begin, 0.0)
    end = min(end, length)
    if begin <= end and pieces < len(near):
        near[pieces, 0] = begin
        near[pieces, 1] = end
        return pieces + 1
    return pieces


@kernel(allocates=False, checks_division=True)
def _line_near_arc(curve: F64_1, edge: F64_1, limit: float, near: OutF64_2) -> int:
    """Find the stretches of a line that lie within ``limit`` mm of the full circle of an arc.

    Writes start and end of each stretch
    along the line ``curve`` (mm) to the rows of ``near``; returns the number of stretches.
    """
    length = curve[5]
    foot = (edge[1] - curve[1]) * curve[3] + (edge[2] - curve[2]) * curve[4]
    centre_offset = (edge[1] - curve[1]) * curve[4] - (edge[2] - curve[2]) * curve[3]
    outer = (edge[3] + limit) ** 2 - centre_offset * centre_offset
    if outer < 0.0:
        return 0
    outer = math.sqrt(outer)
    inner = (edge[3] - limit) ** 2 - centre_offset * centre_offset
    if edge[3] <= limit or inner <= 0.0:
        return _append_clipped(foot - outer, foot + outer, length, near, 0)
    inner = math.sqrt(inner)
    pieces = _append_clipped(foot - outer, foot - inner, length, near, 0)
    return _append_clipped(foot + inner, foot + outer, length, near, pieces)


@kernel(allocates=False, checks_division=True)
def _arc_near_edge(curve: F64_1, edge: F64_1, limit: float, near: OutF64_2) -> int:
    """Find the stretches of an arc that lie within ``limit`` mm of the line or circle of an edge.

    The edge is extended to its infinite line or full circle.  Writes start and end of each stretch
    along the arc ``curve`` (mm) to the rows of ``near``; returns the number of stretches.  The
    distance of a point at angle α on the arc depends only on sin(α - shift), with a constant shift.
    The limit of the distance therefore becomes a lowest and a highest value of that sine.
    """
    radius = curve[3]
    if edge[0] == 0.0:
        # The distance from the line is middle + r sin(angle - direction of the line).
        _, middle = _project(edge, curve[1], curve[2])
        shift = math.atan2(edge[4], edge[3])
        lowest = (-limit - middle) / radius
        highest = (limit - middle) / radius
    else:
        # The distance from the centre is √(r² + D² + 2 r D cos(angle - direction of the centres)).
        dx = curve[1] - edge[1]
        dy = curve[2] - edge[2]
        distance = math.hypot(dx, dy)
        if distance < 1e-12:
            if abs(radius - edge[3]) <= limit:
                return _append_clipped(0.0, curve[5], curve[5], near, 0)
            return 0
        shift = math.atan2(dy, dx) - 0.5 * math.pi
        inside = max(edge[3] - limit, 0.0)
        fixed = radius * radius + distance * distance
        lowest = (inside * inside - fixed) / (2.0 * radius * distance)
        highest = ((edge[3] + limit) ** 2 - fixed) / (2.0 * radius * distance)
    if lowest > 1.0 or highest < -1.0:
        return 0
    if lowest <= -1.0 and highest >= 1.0:
        return _append_clipped(0.0, curve[5], curve[5], near, 0)
    low = math.asin(max(lowest, -1.0))
    high = math.asin(min(highest, 1.0))
    if highest >= 1.0:
        return _append_arc_spans(curve, shift + low, shift + math.pi - low, near, 0)
    if lowest <= -1.0:
        return _append_arc_spans(curve, shift - math.pi - high, shift + high, near, 0)
    pieces = _append_arc_spans(curve, shift + low, shift + high, near, 0)
    return _append_arc_spans(curve, shift + math.pi - high, shift + math.pi - low, near, pieces)


@kernel(allocates=False)
def _append_arc_spans(curve: F64_1, begin: float, end: float, near: OutF64_2, used: int) -> int:
    """Find the stretches of the arc ``curve`` that lie between two angles of its circle.

    The angles are ``begin`` and ``end`` (radians).  Appends the start and end of each stretch along
    the arc (mm) to the rows of ``near``, of which the first ``used`` are in use.  Returns the new
    number of rows in use.
    """
    if curve[0] < 0.0:
        begin, end = -end, -begin
    a = begin - curve[0] * curve[4]
    span = end - begin
    a = a % (2.0 * math.pi)
    for turn in range(-1, 1):
        angle = a + 2.0 * math.pi * turn
        used = _append_clipped(angle * curve[3], (angle + span) * curve[3], curve[5], near, used)
    return used
