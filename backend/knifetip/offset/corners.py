"""corners: classify the corners of a path, and connect the moved segments there.

Moved segments are contour segments moved sideways by the tool's radius, in the rows of
``MovedSegments.table``.  At a corner, ``row_before`` and ``row_after`` are the rows of the segments
before and after it, and ``signed`` is the radius of the tool (mm), positive left of travel.
"""

from __future__ import annotations

import math
from typing import Final

from knifetip.geometry.intersect import TOUCH
from knifetip.geometry.tolerance import POINT
from knifetip.kernels import F64_2, OutF64_2, inline_kernel, kernel
from knifetip.offset.raw_segments import (
    CONCAVE,
    CONVEX,
    EX,
    EY,
    MOVED,
    NEGLIGIBLE_SHIFT,
    RADIUS,
    SHIFTED,
    SMOOTH,
    SX,
    SY,
    U1X,
    U1Y,
    U2X,
    U2Y,
)
from knifetip.offset.records import Contours, CornerTypes, MovedCorner
from knifetip.offset.transition import ContourVertex, write_transition

#: Of two intersections, the one nearer to the corner is that of the corner if it is so many times
#: nearer.
_AT_CORNER: Final = 0.01


@inline_kernel
def classify_corner(
    table: F64_2, row_before: int, row_after: int, signed: float
) -> tuple[int, float, float]:
    """Return the kind of a corner, and the sine and cosine of the angle by which it turns left.

    The kind is ``SMOOTH`` if the ends of the moved segments coincide within the tolerance of a
    point, ``CONVEX`` if there is a gap between them, or if the path turns back, and ``CONCAVE`` if
    the moved segments overlap.

    Parameters
    ----------
    table, row_before, row_after
        Moved segments, and the rows of the segments before and after the corner.
    signed : mm
        Radius of the tool, positive left of travel.
    """
    u1x, u1y = table[row_before, U2X], table[row_before, U2Y]
    u2x, u2y = table[row_after, U1X], table[row_after, U1Y]
    cross = u1x * u2y - u1y * u2x
    dot = u1x * u2x + u1y * u2y
    if dot > 0.0 and abs(signed) * abs(cross) < POINT:
        return SMOOTH, cross, dot
    if cross * signed < 0.0 or dot < -1.0 + 1e-12:
        return CONVEX, cross, dot
    return CONCAVE, cross, dot


@inline_kernel
def line_crossing(
    table: F64_2, row_before: int, row_after: int, x: float, y: float, factor: float
) -> tuple[float, float]:
    """Return the intersection (x, y) of two moved lines at a corner, in mm.

    Parameters
    ----------
    table, row_before, row_after
        Moved segments, and the rows of the lines before and after the corner.
    x, y : mm
        Vertex of the corner.
    factor : mm
        Signed radius of the tool, divided by 1 plus the cosine of the corner's angle.
    """
    u1x, u1y = table[row_before, U2X], table[row_before, U2Y]
    u2x, u2y = table[row_after, U1X], table[row_after, U1Y]
    return x - factor * (u1y + u2y), y + factor * (u1x + u2x)


@inline_kernel
def smooth_joint(table: F64_2, row: int, x: float, y: float) -> int:
    """Return the kind of a smooth corner whose moved segments are joined at the point (x, y).

    Joining moves the start of the segment after the corner, which is row ``row`` of ``table``, the
    moved segments.  The kind is ``SHIFTED`` if the start moves by more than rounding errors, so
    that the bulge of this segment must be computed again, else ``SMOOTH``.
    """
    shift = abs(x - table[row, SX]) + abs(y - table[row, SY])
    return SHIFTED if shift > NEGLIGIBLE_SHIFT else SMOOTH


@inline_kernel
def join_segments(table: OutF64_2, row_before: int, row_after: int, x: float, y: float) -> None:
    """Set the end of the segment before a corner and the start of the segment after it to (x, y).

    ``row_before`` and ``row_after`` are the rows of the two segments in ``table``, the moved
    segments.
    """
    table[row_before, EX] = x
    table[row_before, EY] = y
    table[row_after, SX] = x
    table[row_after, SY] = y


@inline_kernel
def write_corner_transition(
    contours: Contours,
    corner: MovedCorner,
    table: F64_2,
    corners: CornerTypes,
    rows: OutF64_2,
    next_row: int,
) -> int:
    """Write the transition at a corner to ``rows``; return the next free row.

    The transition is the path of the tool's centre round the corner.

    Parameters
    ----------
    contours, corner, table
        The input contours, the corner, and the moved segments.
    corners
        Types of the transitions of all corners.
    rows
        Gets the segments of the transition: x0, y0, x1, y1, bulge.
    next_row
        First row of ``rows`` to write.
    """
    i, row_before, row_after, signed = corner
    vertex = ContourVertex(
        contours.start[i, 0],
        contours.start[i, 1],
        table[row_before, U2X],
        table[row_before, U2Y],
        table[row_after, U1X],
        table[row_after, U1Y],
    )
    at = corners.step * i
    return write_transition(corners.kind[at], corners.k[at], vertex, signed, rows, next_row)


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
    table: F64_2, row: int, sx: float, sy: float, ex: float, ey: float, x: float, y: float
) -> bool:
    """Return whether a point (x, y) on the line or circle of a moved segment is on the segment.

    The segment goes from (sx, sy) to (ex, ey).  The column ``RADIUS`` in row ``row`` of ``table``
    is its radius, 0 for a line.
    """
    dx, dy = ex - sx, ey - sy
    slack = TOUCH * (abs(dx) + abs(dy))
    radius = table[row, RADIUS]
    if radius == 0.0:
        along = (x - sx) * dx + (y - sy) * dy
        return -slack <= along <= dx * dx + dy * dy + slack
    side = dx * (y - sy) - dy * (x - sx)
    return (side if radius > 0.0 else -side) <= slack


@inline_kernel
def _contact_point(
    gx: float, gy: float, table: F64_2, row: int, ux: float, uy: float
) -> tuple[float, float]:
    """Return the point at which a disc around (gx, gy) touches a contour segment at a corner.

    Coordinates are relative to the corner (mm).

    ``gx``, ``gy`` mm: centre of the disc, on the line or circle of the moved segment.
    ``ux``, ``uy``: unit tangent of the segment at the corner.
    """
    radius = table[row, RADIUS]
    if radius == 0.0:
        along = gx * ux + gy * uy
        return along * ux, along * uy
    cx, cy = -radius * uy, radius * ux
    scale = radius / table[row, MOVED]
    return cx + (gx - cx) * scale, cy + (gy - cy) * scale


@kernel(allocates=False)
def concave_crossing(
    contours: Contours,
    last: int,
    next_: int,
    table: F64_2,
    row_before: int,
    row_after: int,
    signed: float,
) -> tuple[int, float, float, float, float, float]:
    """Intersect the two moved segments at a concave corner, at least one of which is an arc.

    Parameters
    ----------
    contours
        The input contours.
    last, next_
        Contour segments before and after the corner.
    table, row_before, row_after
        Moved segments, and the rows in which ``last`` and ``next_`` are.
    signed : mm
        Radius of the tool, positive left of travel.

    Returns
    -------
    hits
        Number of intersections; the other results are valid only if it is 1.  Of two, one that is
        far nearer to the corner counts alone: two arcs that are a circle meet at both ends.
    x, y : mm
        The intersection, which is the centre of the tool's disc when it touches both contour
        segments.
    cosine, sine
        Cosine and sine of the angle at the centre of this disc between its two contact points.
    twice : mm²
        Twice the area bounded by the contour from one contact point over the corner to the other,
        and by the radii to the contact points.  It is the area that the disc cannot reach, plus the
        disc's sector, which ``trim_path`` subtracts for all corners at once.
    """
    start, end = contours.start, contours.end
    x, y = start[next_, 0], start[next_, 1]
    u1x, u1y = table[row_before, U2X], table[row_before, U2Y]
    u2x, u2y = table[row_after, U1X], table[row_after, U1Y]
    radius1, radius2 = table[row_before, RADIUS], table[row_after, RADIUS]
    moved1, moved2 = table[row_before, MOVED], table[row_after, MOVED]
    # Relative to the corner, untrimmed segments: a is the end of one, b the start of the other.
    ax, ay = -signed * u1y, signed * u1x
    bx, by = -signed * u2y, signed * u2x
    sx = start[last, 0] - signed * table[row_before, U1Y] - x
    sy = start[last, 1] + signed * table[row_before, U1X] - y
    ex = end[next_, 0] - signed * table[row_after, U2Y] - x
    ey = end[next_, 1] + signed * table[row_after, U2X] - y
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
        _contains_point(table, row_before, sx, sy, ax, ay, gx, gy)
        and _contains_point(table, row_after, bx, by, ex, ey, gx, gy)
    )
    ox, oy = fx - rx, fy - ry
    if _contains_point(table, row_before, sx, sy, ax, ay, ox, oy) and _contains_point(
        table, row_after, bx, by, ex, ey, ox, oy
    ):
        # Coordinates are relative to the corner.
        first, second = math.hypot(gx - ax, gy - ay), math.hypot(ox - ax, oy - ay)
        if hits == 1 and min(first, second) > _AT_CORNER * max(first, second):
            hits = 2
        elif hits == 0 or second < first:
            hits, gx, gy = 1, ox, oy
    # Contact points of the disc around g with both segments.
    f1x, f1y = _contact_point(gx, gy, table, row_before, u1x, u1y)
    f2x, f2y = _contact_point(gx, gy, table, row_after, u2x, u2y)
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
