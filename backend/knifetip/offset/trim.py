"""trim: offset a path by trimming neighbouring moved segments to their intersection.

This is enough for most contours.  A moved segment is trimmed if the next one crosses it once.  If
no part of a segment remains, or if two neighbouring moved segments at a concave corner cross twice
or not at all, ``region`` computes the offset instead.
"""

from __future__ import annotations

import math

from knifetip.geometry.intersect import TOUCH
from knifetip.geometry.tolerance import POINT
from knifetip.kernels import F64_2, OutF64_2, kernel
from knifetip.offset.raw_segments import (
    CONCAVE,
    CONVEX,
    DOES_NOT_FIT,
    EX,
    EY,
    MOVED,
    NEGLIGIBLE_SHIFT,
    NO_FAILURE,
    OPEN,
    RADIUS,
    SHIFTED,
    SMOOTH,
    SX,
    SY,
    U1X,
    U1Y,
    U2X,
    U2Y,
    is_closed,
    move_segments,
    remaining_bulge,
)
from knifetip.offset.records import (
    Contours,
    CornerTypes,
    MovedSegments,
    OffsetChains,
    OffsetGroups,
    OffsetSegments,
)
from knifetip.offset.self_contact import CheckedSegments, Scratch, path_meets_itself
from knifetip.offset.transition import MAX_SEGMENTS, quarter_tangent, write_transition


@kernel(allocates=False)
def _twice_circular_segment(x: float, y: float, radius: float) -> float:
    """Return twice the area between a chord and its arc of less than half a turn (mm²).

    (x, y) is the vector of the chord.  The area has the sign of ``radius``; it is 0 for radius 0.
    """
    if radius == 0.0:
        return 0.0
    square = min(0.25 * (x * x + y * y) / (radius * radius), 1.0)
    half = math.sqrt(square)
    if square < 0.01:
        # Series of asin h - h √(1 - h²), which cancels for small h.
        more = 0.0378605769230769 + square * (0.030078125 + square * 0.0246438419117647)
        more = 0.0694444444444444 + square * (0.0497159090909091 + square * more)
        more = 0.2 + square * (0.107142857142857 + square * more)
        area = 2.0 * half * square * (0.666666666666667 + square * more)
    else:
        area = 2.0 * (math.asin(half) - half * math.sqrt(1.0 - square))
    return math.copysign(radius * radius * area, radius)


@kernel(allocates=False)
def _contains_point(
    table: F64_2, at: int, sx: float, sy: float, ex: float, ey: float, x: float, y: float
) -> bool:
    """Return whether a moved segment contains a point (x, y) that lies on its line or circle.

    The segment goes from (sx, sy) to (ex, ey); row ``at`` of ``table`` has its radius.
    """
    dx, dy = ex - sx, ey - sy
    slack = TOUCH * (abs(dx) + abs(dy))
    radius = table[at, RADIUS]
    if radius == 0.0:
        along = (x - sx) * dx + (y - sy) * dy
        return -slack <= along <= dx * dx + dy * dy + slack
    side = dx * (y - sy) - dy * (x - sx)
    return (side if radius > 0.0 else -side) <= slack


@kernel(allocates=False)
def concave_crossing(
    contours: Contours,
    last: int,
    next_: int,
    table: F64_2,
    before: int,
    here: int,
    signed: float,
) -> tuple[int, float, float, float, float, float]:
    """Intersect the two moved segments at a concave corner, at least one of which is an arc.

    Parameters
    ----------
    last, next_
        Contour segments before and after the corner.
    table, before, here
        Moved segments, and the rows in which ``last`` and ``next_`` are.
    signed : mm
        Radius of the tool, positive left of travel.

    Returns
    -------
    hits
        Number of intersections.
    x, y : mm
        The intersection.
    cosine, sine
        Cosine and sine of the angle, at the centre of a disc at the intersection, between the two
        points at which the disc touches the contour segments.
    twice : mm²
        Twice the area between corner and contact points that the disc cannot reach, plus twice the
        area of the disc's sector between the contact points.
    """
    start, end = contours.start, contours.end
    x, y = start[next_, 0], start[next_, 1]
    u1x, u1y = table[before, U2X], table[before, U2Y]
    u2x, u2y = table[here, U1X], table[here, U1Y]
    radius1, radius2 = table[before, RADIUS], table[here, RADIUS]
    moved1, moved2 = table[before, MOVED], table[here, MOVED]
    # Relative to the corner, untrimmed segments: a is the end of one, b the start of the other.
    ax, ay = -signed * u1y, signed * u1x
    bx, by = -signed * u2y, signed * u2x
    sx = start[last, 0] - signed * table[before, U1Y] - x
    sy = start[last, 1] + signed * table[before, U1X] - y
    ex = end[next_, 0] - signed * table[here, U2Y] - x
    ey = end[next_, 1] + signed * table[here, U2X] - y
    c1x, c1y = -radius1 * u1y, radius1 * u1x
    c2x, c2y = -radius2 * u2y, radius2 * u2x
    if radius1 == 0.0 or radius2 == 0.0:
        if radius1 == 0.0:
            ux, uy, off, size = u1x, u1y, u1x * (c2y - ay) - u1y * (c2x - ax), moved2
            fx, fy = c2x + off * uy, c2y - off * ux
        else:
            ux, uy, off, size = u2x, u2y, u2x * (c1y - by) - u2y * (c1x - bx), moved1
            fx, fy = c1x + off * uy, c1y - off * ux
        square = (size - off) * (size + off)
        rise = math.sqrt(max(square, 0.0))
        rx, ry = rise * ux, rise * uy
    else:
        dx, dy = c2x - c1x, c2y - c1y
        apart = dx * dx + dy * dy
        foot = 0.5 + 0.5 * (moved1 - moved2) * (moved1 + moved2) / apart
        square = moved1 * moved1 / apart - foot * foot
        rise = math.sqrt(max(square, 0.0))
        fx, fy = c1x + foot * dx, c1y + foot * dy
        rx, ry = -rise * dy, rise * dx
    if not square > 0.0:
        return 0, x, y, 1.0, 0.0, 0.0
    gx, gy = fx + rx, fy + ry
    hits = int(
        _contains_point(table, before, sx, sy, ax, ay, gx, gy)
        and _contains_point(table, here, bx, by, ex, ey, gx, gy)
    )
    ox, oy = fx - rx, fy - ry
    if _contains_point(table, before, sx, sy, ax, ay, ox, oy) and _contains_point(
        table, here, bx, by, ex, ey, ox, oy
    ):
        hits += 1
        gx, gy = ox, oy
    # Contact points of the disc around g with both segments.
    if radius1 == 0.0:
        along = gx * u1x + gy * u1y
        f1x, f1y = along * u1x, along * u1y
    else:
        scale = radius1 / moved1
        f1x, f1y = c1x + (gx - c1x) * scale, c1y + (gy - c1y) * scale
    if radius2 == 0.0:
        along = gx * u2x + gy * u2y
        f2x, f2y = along * u2x, along * u2y
    else:
        scale = radius2 / moved2
        f2x, f2y = c2x + (gx - c2x) * scale, c2y + (gy - c2y) * scale
    twice = (
        f2x * f1y
        - f2y * f1x
        + _twice_circular_segment(f1x, f1y, radius1)
        + _twice_circular_segment(f2x, f2y, radius2)
    )
    ax, ay, bx, by = f1x - gx, f1y - gy, f2x - gx, f2y - gy
    sine = ax * by - ay * bx
    if signed < 0.0:
        sine, twice = -sine, -twice
    scale = 1.0 / (signed * signed)
    return hits, x + gx, y + gy, (ax * bx + ay * by) * scale, sine * scale, twice + sine


@kernel(allocates=False)
def _multiply_rotations(re: float, im: float, dot: float, sine: float) -> tuple[float, float, bool]:
    """Return the product of two rotations, and whether the sum of their angles passes 180°.

    Rotations are complex numbers of modulus 1: ``re`` + i ``im`` and ``dot`` + i ``sine``.
    """
    product = re * dot - im * sine
    up = re * sine + im * dot
    return product, up, im >= 0.0 > up and min(re, product) < 0.0


@kernel(allocates=False)
def _trim_corners(
    contours: Contours,
    low: int,
    high: int,
    closed: bool,
    signed: float,
    segments: MovedSegments,
    at: int,
) -> tuple[int, int, float, float]:
    """Trim the moved segments at concave corners to their intersection, and classify all corners.

    Parameters
    ----------
    low, high
        The path has the contour segments low … high - 1.
    closed
        Whether the path is closed.
    signed : mm
        Radius of the tool, positive left of travel.
    segments, at
        The moved segments, and the row of the path's first segment in them.  The kind of each
        corner is written to ``segments.joint``.

    Returns
    -------
    code, segment
        Failure code (a constant of ``raw_segments``), and the contour segment that failed.
    twice : mm²
        Twice the area that the tool cannot reach at concave corners, plus twice the area of the
        disc's sectors between its contact points there.
    angle : radians
        Sum of the angles of these sectors.
    """
    start, table, joint = contours.start, segments.table, segments.joint
    count = high - low
    size = abs(signed)
    twice = 0.0
    # The sum of all angles, as a product of complex numbers and the number of turns.
    re, im, turns = 1.0, 0.0, 0
    for i in range(count):
        here = at + i
        joint[here] = OPEN
        if math.isnan(table[here, MOVED]):
            return DOES_NOT_FIT, low + i, 0.0, 0.0
        if i == 0 and not closed:
            continue
        before = here - 1 if i > 0 else at + count - 1
        last = low + i - 1 if i > 0 else high - 1
        u1x, u1y = table[before, U2X], table[before, U2Y]
        u2x, u2y = table[here, U1X], table[here, U1Y]
        cross = u1x * u2y - u1y * u2x
        dot = u1x * u2x + u1y * u2y
        smooth = dot > 0.0 and size * abs(cross) < POINT
        if not smooth and (cross * signed < 0.0 or dot < -1.0 + 1e-12):
            joint[here] = CONVEX
            if dot < -1.0 + 1e-12:
                return DOES_NOT_FIT, low + i, 0.0, 0.0
            continue
        if smooth or (table[before, RADIUS] == 0.0 and table[here, RADIUS] == 0.0):
            # A nearly smooth joint is intersected like two lines.
            if dot < -1.0 + 1e-9:
                return DOES_NOT_FIT, low + i, 0.0, 0.0
            factor = signed / (1.0 + dot)
            gx = start[low + i, 0] - factor * (u1y + u2y)
            gy = start[low + i, 1] + factor * (u1x + u2x)
            joint[here] = CONCAVE
            sine = abs(cross)
            if smooth:
                off = abs(gx - table[here, SX]) + abs(gy - table[here, SY])
                joint[here] = SHIFTED if off > NEGLIGIBLE_SHIFT else SMOOTH
                dot, sine = 1.0, 0.0
            else:
                twice += 2.0 * abs(factor) * size * sine
        else:
            if math.isnan(table[before, MOVED]):
                return DOES_NOT_FIT, last, 0.0, 0.0
            hits, gx, gy, dot, sine, more = concave_crossing(
                contours, last, low + i, table, before, here, signed
            )
            if hits != 1 or sine < 0.0:
                return DOES_NOT_FIT, low + i, 0.0, 0.0
            joint[here] = CONCAVE
            twice += more
        table[before, EX] = gx
        table[before, EY] = gy
        table[here, SX] = gx
        table[here, SY] = gy
        if sine > 0.0:
            re, im, round_ = _multiply_rotations(re, im, dot, sine)
            turns += round_
    return NO_FAILURE, low, twice, math.atan2(im, re) + 2.0 * math.pi * turns


@kernel(allocates=False)
def _trimmed_bulge(
    contours: Contours, i: int, segments: MovedSegments, here: int, begins: bool, ends: bool
) -> float:
    """Return the bulge of the moved contour segment ``i`` after trimming, NaN if no part remains.

    ``begins`` and ``ends`` state whether the segment is trimmed at its start and at its end;
    ``here`` is the row of the segment in ``segments``.
    """
    table = segments.table
    dx = table[here, EX] - table[here, SX]
    dy = table[here, EY] - table[here, SY]
    if table[here, RADIUS] == 0.0:
        if dx * table[here, U1X] + dy * table[here, U1Y] < POINT:
            return math.nan
        return 0.0
    bent: float = contours.bulge[i]
    if abs(bent) <= 1.0 and dx * dx + dy * dy < POINT * POINT:
        return math.nan
    if begins and ends and abs(bent) > 1.0:
        # Beyond half a turn the remaining part is not distinguishable from its complement.
        return math.nan
    if begins or ends:
        bent = remaining_bulge(
            table, here, dx, dy, bent, contours.start[i, 0], contours.start[i, 1]
        )
        if bent == 0.0:
            return math.nan
    return bent


@kernel(allocates=False)
def _write_corner(
    contours: Contours,
    i: int,
    table: F64_2,
    before: int,
    here: int,
    signed: float,
    corners: CornerTypes,
    out: OffsetSegments,
    put: int,
    rows: OutF64_2,
) -> int:
    """Write the transition at the start of contour segment ``i`` to ``out``.

    Returns the next free row of ``out``.

    Parameters
    ----------
    table, before, here
        Moved segments, and the rows of the segments before and after the corner.
    signed : mm
        Radius of the tool, positive left of travel.
    put
        First row of ``out`` to write.
    rows
        Scratch rows for one transition.
    """
    u1x, u1y = table[before, U2X], table[before, U2Y]
    u2x, u2y = table[here, U1X], table[here, U1Y]
    if corners.kind[corners.step * i] == 0:
        turn = quarter_tangent(u1x * u2y - u1y * u2x, u1x * u2x + u1y * u2y)
        out.start[put, 0] = table[before, EX]
        out.start[put, 1] = table[before, EY]
        out.end[put, 0] = table[here, SX]
        out.end[put, 1] = table[here, SY]
        out.bulge[put] = -math.copysign(turn, signed)
        out.source[put] = i
        out.inserted[put] = True
        return put + 1
    count = write_transition(
        corners.kind[corners.step * i],
        contours.start[i, 0],
        contours.start[i, 1],
        u1x,
        u1y,
        u2x,
        u2y,
        signed,
        corners.k[corners.step * i],
        rows,
        0,
    )
    for r in range(count):
        out.start[put, 0] = rows[r, 0]
        out.start[put, 1] = rows[r, 1]
        out.end[put, 0] = rows[r, 2]
        out.end[put, 1] = rows[r, 3]
        out.bulge[put] = rows[r, 4]
        out.source[put] = i
        out.inserted[put] = True
        put += 1
    return put


@kernel(allocates=False)
def trim_path(
    contours: Contours,
    low: int,
    high: int,
    closed: bool,
    signed: float,
    corners: CornerTypes,
    segments: MovedSegments,
    at: int,
    out: OffsetSegments,
    put: int,
    rows: OutF64_2,
) -> tuple[int, int, int, float]:
    """Write the offset of a path: moved segments, trimmed to their intersections, and transitions.

    Parameters
    ----------
    low, high
        The path has the contour segments low … high - 1.
    closed
        Whether the path is closed.
    signed : mm
        Radius of the tool, positive left of travel.
    segments, at
        The moved segments, and the row of the path's first segment in them.
    out, put
        Output columns, written from row ``put`` on.
    rows
        Scratch rows for one transition.

    Returns
    -------
    put
        Next free row of the output.
    code, segment
        Failure code (a constant of ``raw_segments``), and the contour segment that failed.
    lost : mm²
        Area that the tool cannot reach at concave corners.
    """
    code, row, twice, angle = _trim_corners(contours, low, high, closed, signed, segments, at)
    if code != NO_FAILURE:
        return put, code, row, 0.0
    table, joint = segments.table, segments.joint
    count = high - low
    for i in range(count):
        here = at + i
        follows = here + 1 if i < count - 1 else at
        begins = joint[here] >= CONCAVE
        ends = joint[follows] >= CONCAVE and (closed or i < count - 1)
        bent = _trimmed_bulge(contours, low + i, segments, here, begins, ends)
        if math.isnan(bent):
            return put, DOES_NOT_FIT, low + i, 0.0
        if joint[here] == CONVEX:
            before = here - 1 if i > 0 else at + count - 1
            put = _write_corner(
                contours, low + i, table, before, here, signed, corners, out, put, rows
            )
        out.start[put, 0] = table[here, SX]
        out.start[put, 1] = table[here, SY]
        out.end[put, 0] = table[here, EX]
        out.end[put, 1] = table[here, EY]
        out.bulge[put] = bent
        out.source[put] = low + i
        out.inserted[put] = False
        put += 1
    size = abs(signed)
    return put, NO_FAILURE, low, max(0.5 * (twice - size * size * angle), 0.0)


@kernel(allocates=False)
def offset_simple(
    contours: Contours,
    groups: OffsetGroups,
    group: int,
    corners: CornerTypes,
    segments: MovedSegments,
    boxes: OutF64_2,
    scratch: Scratch,
    out: OffsetSegments,
    done: int,
    chains: OffsetChains,
    count: int,
) -> tuple[int, int, int]:
    """Offset groups of one closed path each, from ``group`` on, while trimming is enough.

    The function stops before the first group that needs more than trimming, and before a group for
    which the output columns lack capacity.

    Parameters
    ----------
    out, done
        Columns for the segments of all offsets, and the number of segments written before.
    chains, count
        Columns for the chains of all offsets, and the number of chains written before.

    Returns
    -------
    group
        First group that is not done.
    done, count
        Number of segments and number of chains that are written.
    """
    bounds, signed = groups.bounds, groups.signed
    checked = CheckedSegments(out.start, out.end, out.bulge, out.inserted)
    while group < len(bounds) - 1:
        path = groups.member[bounds[group]]
        low, high = contours.first[path], contours.first[path + 1]
        if (
            bounds[group + 1] - bounds[group] > 1
            or low == high
            or signed[path] == 0.0
            or done + (MAX_SEGMENTS + 1) * (high - low) > len(out.bulge)
            or not is_closed(contours, low, high)
        ):
            break
        code, _ = move_segments(contours, low, high, signed[path], segments.table, 0)
        if code != NO_FAILURE:
            break
        put, code, _, lost = trim_path(
            contours, low, high, True, signed[path], corners, segments, 0, out, done, scratch.pair
        )
        if code != NO_FAILURE or path_meets_itself(checked, done, put, boxes, scratch):
            break
        chains.first[count] = done
        chains.owner[count] = path
        chains.unreached[path] = lost
        count += 1
        done = put
        group += 1
    return group, done, count
