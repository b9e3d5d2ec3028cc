"""intersect: common points of pairs of segments, which are lines or arcs.

Touching segments have a common point.  If two segments overlap, the ends of the common stretch are
returned, so that after splitting at these points any two pieces are either equal or disjoint.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, I32
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_2, OutF64_2, OutF64_3, OutI32_1, kernel

#: Largest number of common points of two segments: two arcs of one circle may overlap twice.
MAX_POINTS: Final = 4
#: Relative rounding error of a length.
ROUNDING: Final = 1e-15
#: Distance within which segments touch (mm).
TOUCH: Final = 1e-9


@dataclass(frozen=True, eq=False, slots=True)
class Crossings:
    """For each of n pairs of segments, the common points of the two segments."""

    count: I32  #: (n,) number of points of each pair
    points: F64  #: (n, 4, 2) mm, NaN beyond ``count``
    first: F64  #: (n, 4) parameters on the first segments, fractions 0 … 1 of the length
    second: F64  #: (n, 4) parameters on the second segments


def intersect_pairs(
    start: F64,
    end: F64,
    bulge: F64,
    other_start: F64,
    other_end: F64,
    other_bulge: F64,
    touch: float = TOUCH,
) -> Crossings:
    """Return the common points of each of n pairs of segments, which are lines or arcs.

    Parameters
    ----------
    start, end, bulge : (n, 2), (n, 2) mm and (n,)
        First segment of each pair.
    other_start, other_end, other_bulge : (n, 2), (n, 2) mm and (n,)
        Second segment of each pair.
    touch : mm
        Largest distance at which two segments count as touching.
    """
    one = np.column_stack([start, end, bulge]).astype(np.float64, copy=False)
    two = np.column_stack([other_start, other_end, other_bulge]).astype(np.float64, copy=False)
    count = np.zeros(len(one), np.int32)
    points = np.full((len(one), MAX_POINTS, 4), np.nan)
    _intersect_pairs(one, two, touch, count, points)
    return Crossings(count, points[:, :, :2], points[:, :, 2], points[:, :, 3])


@kernel(allocates=False)
def _intersect_pairs(
    segments_a: F64_2, segments_b: F64_2, touch: float, count: OutI32_1, points: OutF64_3
) -> None:
    """Write the common points of n pairs of segments to ``points``, and how many to ``count``.

    Pair i consists of the segments in row i of ``segments_a`` and in row i of ``segments_b``, which
    are (x0, y0, x1, y1, bulge).  ``count[i]`` is the number of their common points.  Each of the
    first ``count[i]`` rows of ``points[i]`` gets x and y of one common point, and its parameters on
    the first and on the second segment (0 … 1).  ``touch`` is the largest distance (mm) at which
    two segments count as touching.
    """
    for i in range(len(segments_a)):
        count[i] = intersect_rows(segments_a, i, segments_b, i, touch, points[i])


@kernel(allocates=False)
def circle_of_arc(rows: F64_2, i: int) -> tuple[float, float, float]:
    """Return the centre x, the centre y and the radius of an arc (mm).

    The arc is row i of ``rows``, (n, 5): x0, y0, x1, y1, bulge.
    """
    dx = rows[i, 2] - rows[i, 0]
    dy = rows[i, 3] - rows[i, 1]
    b = rows[i, 4]
    lean = (1.0 - b * b) / (4.0 * b)
    return (
        (rows[i, 0] + rows[i, 2]) / 2.0 - lean * dy,
        (rows[i, 1] + rows[i, 3]) / 2.0 + lean * dx,
        math.sqrt(dx * dx + dy * dy) * (1.0 + b * b) / (4.0 * abs(b)),
    )


@kernel(allocates=False)
def write_box(rows: F64_2, i: int, boxes: OutF64_2, box_row: int) -> None:
    """Write a box around a segment to row ``box_row`` of ``boxes``: x min, y min, x max, y max.

    The segment is row i of ``rows``, (n, 5): x0, y0, x1, y1, bulge.  The box of an arc may be
    larger than necessary.
    """
    x0 = rows[i, 0]
    y0 = rows[i, 1]
    x1 = rows[i, 2]
    y1 = rows[i, 3]
    low_x = min(x0, x1)
    low_y = min(y0, y1)
    high_x = max(x0, x1)
    high_y = max(y0, y1)
    b = rows[i, 4]
    if abs(b) > 1.0:
        cx, cy, radius = circle_of_arc(rows, i)
        low_x = cx - radius
        low_y = cy - radius
        high_x = cx + radius
        high_y = cy + radius
    elif b != 0.0:
        # An arc of up to half a turn lies in the rectangle of its chord and its height.
        rise_x = 0.5 * b * (y1 - y0)
        rise_y = 0.5 * b * (x0 - x1)
        low_x += min(rise_x, 0.0)
        low_y += min(rise_y, 0.0)
        high_x += max(rise_x, 0.0)
        high_y += max(rise_y, 0.0)
    boxes[box_row, 0] = low_x
    boxes[box_row, 1] = low_y
    boxes[box_row, 2] = high_x
    boxes[box_row, 3] = high_y


@kernel(allocates=False)
def parameter_of_point(rows: F64_2, i: int, x: float, y: float, touch: float) -> float:
    """Return the parameter of a point on a segment, 0 … 1, or -1 if the point is beyond the ends.

    The segment is row i of ``rows``, (n, 5): x0, y0, x1, y1, bulge.  The point (x, y) must be on
    the line or circle of the segment.  ``touch`` is the distance beyond an end, in mm, up to which
    the point still counts as the end.
    """
    x0 = rows[i, 0]
    y0 = rows[i, 1]
    dx = rows[i, 2] - x0
    dy = rows[i, 3] - y0
    b = rows[i, 4]
    if abs(b) < BULGE:
        square = dx * dx + dy * dy
        fraction = ((x - x0) * dx + (y - y0) * dy) / square
        slack = touch / math.sqrt(square)
        if fraction < -slack or fraction > 1.0 + slack:
            return -1.0
        inside: float = min(max(fraction, 0.0), 1.0)
        return inside
    cx, cy, radius = circle_of_arc(rows, i)
    fx = x0 - cx
    fy = y0 - cy
    px = x - cx
    py = y - cy
    angle = math.atan2(fx * py - fy * px, fx * px + fy * py)
    if b < 0.0:
        angle = -angle
    sweep = 4.0 * math.atan(abs(b))
    slack = touch / radius
    if angle < 0.0:
        if angle >= -slack:
            return 0.0
        angle += 2.0 * math.pi
    if angle <= sweep:
        return angle / sweep
    if angle <= sweep + slack:
        return 1.0
    return -1.0


@kernel(allocates=False)
def point_at_parameter(rows: F64_2, i: int, fraction: float) -> tuple[float, float]:
    """Return x and y of the point of a segment at a parameter, a fraction of its length, 0 … 1.

    The segment is row i of ``rows``, (n, 5): x0, y0, x1, y1, bulge.
    """
    x0 = rows[i, 0]
    y0 = rows[i, 1]
    dx = rows[i, 2] - x0
    dy = rows[i, 3] - y0
    b = rows[i, 4]
    if abs(b) < BULGE:
        return x0 + fraction * dx, y0 + fraction * dy
    cx, cy, _ = circle_of_arc(rows, i)
    turned = fraction * 4.0 * math.atan(b)
    cos = math.cos(turned)
    sin = math.sin(turned)
    return (
        cx + (x0 - cx) * cos - (y0 - cy) * sin,
        cy + (x0 - cx) * sin + (y0 - cy) * cos,
    )


@kernel(allocates=False)
def _add_point(
    segments_a: F64_2,
    i: int,
    segments_b: F64_2,
    j: int,
    point: tuple[float, float],
    touch: float,
    points: OutF64_2,
    count: int,
) -> int:
    """Append a point (x, y) to ``points`` if it is on both segments; return the number of points.

    The point must be on the lines or circles of both segments.  It is left out if ``points``
    already has one within ``touch`` mm of it, or if ``points`` has no free row.

    ``segments_a``, ``i``, ``segments_b``, ``j``: the segments are row i of ``segments_a`` and row j
    of
    ``segments_b``: x0, y0, x1, y1, bulge.
    ``touch`` mm: distance beyond an end of a segment up to which the point still counts as on the
    segment.
    ``points``: receives in one row x, y, and the parameters on the first and on the second segment
    (0 … 1).
    ``count``: number of points in ``points`` before the call.
    """
    x, y = point
    for k in range(count):
        if abs(points[k, 0] - x) <= touch and abs(points[k, 1] - y) <= touch:
            return count
    first = parameter_of_point(segments_a, i, x, y, touch)
    if first < 0.0:
        return count
    second = parameter_of_point(segments_b, j, x, y, touch)
    if second < 0.0 or count == MAX_POINTS:
        return count
    points[count, 0] = x
    points[count, 1] = y
    points[count, 2] = first
    points[count, 3] = second
    return count + 1


@kernel(allocates=False)
def _add_common_ends(
    segments_a: F64_2, i: int, segments_b: F64_2, j: int, touch: float, points: OutF64_2
) -> int:
    """Write each end of two segments that is on the other segment to ``points``; return the number.

    The segments are row i of ``segments_a`` and row j of ``segments_b``; a row is (x0, y0, x1, y1,
    bulge).  They must be on one line or on one circle.  A row of ``points`` gets x, y, and the
    parameters on the first and on the second segment (0 … 1).  ``touch`` is the largest distance
    (mm) from the other segment at which an end still counts as on this segment.
    """
    count = _add_point(
        segments_a, i, segments_b, j, (segments_a[i, 0], segments_a[i, 1]), touch, points, 0
    )
    count = _add_point(
        segments_a, i, segments_b, j, (segments_a[i, 2], segments_a[i, 3]), touch, points, count
    )
    count = _add_point(
        segments_a, i, segments_b, j, (segments_b[j, 0], segments_b[j, 1]), touch, points, count
    )
    return _add_point(
        segments_a, i, segments_b, j, (segments_b[j, 2], segments_b[j, 3]), touch, points, count
    )


@kernel(allocates=False)
def intersect_rows(
    segments_a: F64_2, i: int, segments_b: F64_2, j: int, touch: float, points: OutF64_2
) -> int:
    """Write the common points of two segments to ``points`` and return the number of the points.

    The segments are row i of ``segments_a`` and row j of ``segments_b``; a row is (x0, y0, x1, y1,
    bulge).  A row of ``points`` is x, y, and the parameters on the first and on the second segment.
    ``touch`` is the largest distance (mm) at which two segments count as touching.
    """
    flat = abs(segments_a[i, 4]) < BULGE
    other_flat = abs(segments_b[j, 4]) < BULGE
    if flat and other_flat:
        return _intersect_lines(segments_a, i, segments_b, j, touch, points)
    if flat or other_flat:
        return _intersect_line_arc(segments_a, i, segments_b, j, flat, touch, points)
    ax, ay, ar = circle_of_arc(segments_a, i)
    bx, by, br = circle_of_arc(segments_b, j)
    dx = bx - ax
    dy = by - ay
    apart = math.sqrt(dx * dx + dy * dy)
    if apart <= touch and abs(ar - br) <= touch:
        return _add_common_ends(segments_a, i, segments_b, j, touch, points)
    if apart > ar + br + touch or apart < abs(ar - br) - touch or apart == 0.0:
        return 0
    foot = (apart * apart + (ar - br) * (ar + br)) / (2.0 * apart)
    rise = math.sqrt(max(0.0, (ar - foot) * (ar + foot)))
    if min(abs(apart - (ar + br)), abs(apart - abs(ar - br))) <= ROUNDING * (apart + ar + br):
        # The circles touch; the root would turn the last bit into a tenth of a micrometre.
        rise = 0.0
    ux = dx / apart
    uy = dy / apart
    x = ax + foot * ux
    y = ay + foot * uy
    count = _add_point(
        segments_a, i, segments_b, j, (x - rise * uy, y + rise * ux), touch, points, 0
    )
    return _add_point(
        segments_a, i, segments_b, j, (x + rise * uy, y - rise * ux), touch, points, count
    )


@kernel(allocates=False)
def _intersect_lines(
    segments_a: F64_2, i: int, segments_b: F64_2, j: int, touch: float, points: OutF64_2
) -> int:
    """Write the common points of two lines to ``points`` and return the number of the points.

    The lines are row i of ``segments_a`` and row j of ``segments_b``; a row is (x0, y0, x1, y1,
    bulge).  A row of ``points`` gets x, y, and the parameters on the first and on the second line
    (0 … 1).  ``touch`` is the largest distance (mm) at which two lines count as touching.
    """
    ax = segments_a[i, 2] - segments_a[i, 0]
    ay = segments_a[i, 3] - segments_a[i, 1]
    bx = segments_b[j, 2] - segments_b[j, 0]
    by = segments_b[j, 3] - segments_b[j, 1]
    cx = segments_b[j, 0] - segments_a[i, 0]
    cy = segments_b[j, 1] - segments_a[i, 1]
    cross = ax * by - ay * bx
    a2 = ax * ax + ay * ay
    b2 = bx * bx + by * by
    if cross * cross <= 1e-24 * a2 * b2:
        off = ax * cy - ay * cx
        if off * off > touch * touch * a2:
            return 0
        return _add_common_ends(segments_a, i, segments_b, j, touch, points)
    # Most pairs are rejected because both ends of a segment are clearly on one side of the other.
    near = ax * cy - ay * cx
    far = near + cross
    if near * far > 0.0 and min(near * near, far * far) > touch * touch * a2:
        return 0
    near = bx * cy - by * cx
    far = near + cross
    if near * far > 0.0 and min(near * near, far * far) > touch * touch * b2:
        return 0
    first = (cx * by - cy * bx) / cross
    second = (cx * ay - cy * ax) / cross
    slack = touch / math.sqrt(a2)
    if first < -slack or first > 1.0 + slack:
        return 0
    slack = touch / math.sqrt(b2)
    if second < -slack or second > 1.0 + slack:
        return 0
    first = min(max(first, 0.0), 1.0)
    points[0, 0] = segments_a[i, 0] + first * ax
    points[0, 1] = segments_a[i, 1] + first * ay
    points[0, 2] = first
    points[0, 3] = min(max(second, 0.0), 1.0)
    return 1


@kernel(allocates=False)
def _intersect_line_arc(
    segments_a: F64_2, i: int, segments_b: F64_2, j: int, flat: bool, touch: float, points: OutF64_2
) -> int:
    """Write the common points of a line and an arc to ``points`` and return the number of points.

    The two segments are row i of ``segments_a`` and row j of ``segments_b``; a row is (x0, y0, x1,
    y1, bulge).
    ``flat`` is True if the line is row i of ``segments_a``, and False if it is row j of
    ``segments_b``.  A row of ``points`` gets x, y, and the parameters on the first and on the
    second segment (0 … 1).
    ``touch`` is the largest distance (mm) at which the two count as touching.
    """
    if flat:
        x0, y0, dx, dy = (
            segments_a[i, 0],
            segments_a[i, 1],
            segments_a[i, 2] - segments_a[i, 0],
            segments_a[i, 3] - segments_a[i, 1],
        )
        cx, cy, radius = circle_of_arc(segments_b, j)
    else:
        x0, y0, dx, dy = (
            segments_b[j, 0],
            segments_b[j, 1],
            segments_b[j, 2] - segments_b[j, 0],
            segments_b[j, 3] - segments_b[j, 1],
        )
        cx, cy, radius = circle_of_arc(segments_a, i)
    length = math.sqrt(dx * dx + dy * dy)
    ux = dx / length
    uy = dy / length
    # Signed distance of the centre from the line.
    off = ux * (cy - y0) - uy * (cx - x0)
    if abs(off) > radius + touch:
        return 0
    reach = math.sqrt(max(0.0, (radius - off) * (radius + off)))
    if abs(radius - abs(off)) <= ROUNDING * (radius + abs(cx - x0) + abs(cy - y0)):
        reach = 0.0
    fx = cx + off * uy
    fy = cy - off * ux
    count = _add_point(
        segments_a, i, segments_b, j, (fx - reach * ux, fy - reach * uy), touch, points, 0
    )
    return _add_point(
        segments_a, i, segments_b, j, (fx + reach * ux, fy + reach * uy), touch, points, count
    )
