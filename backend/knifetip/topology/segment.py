"""segment: kernels for the geometry of one segment: a line, or an arc of at most half a turn."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.kernels import F64_1, F64_3, inline_kernel, kernel

#: Bulge below which a segment counts as a line.
BULGE: Final = 1e-9
#: Ratio above which two squares of distances differ by more than rounding.
_CLEARLY: Final = 1.000001
#: Square of the sine of the least angle between lines that cross; below it, it is rounding.
_PARALLEL: Final = 1e-18


@inline_kernel
def distance_to(
    ends: F64_3, bulge: F64_1, i: int, x: float, y: float, max_distance: float
) -> tuple[float, float]:
    """Return the distance of (``x``, ``y``) from segment ``i``, and the nearest parameter on it.

    The parameter is 0 at the start and 1 at the end of the segment.  The distance may be infinite
    for a segment that is clearly farther away than ``max_distance``.  ``ends`` (n, 2, 2) and
    ``bulge`` (n,) are the end points and bulges of n segments.
    """
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    dx, dy = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay
    square = dx * dx + dy * dy
    ox, oy = x - ax, y - ay
    if abs(bulge[i]) <= BULGE:
        off = ox * dy - oy * dx
        if off * off > _CLEARLY * max_distance * max_distance * square:
            return np.inf, 0.0
        parameter = min(max((ox * dx + oy * dy) / square, 0.0), 1.0) if square > 0.0 else 0.0
        ox -= parameter * dx
        oy -= parameter * dy
        return math.sqrt(ox * ox + oy * oy), parameter
    # An arc of at most half a turn is in the circle with its chord as diameter.
    mx, my = ox - 0.5 * dx, oy - 0.5 * dy
    room = 0.5 * math.sqrt(square) + max_distance
    if mx * mx + my * my > _CLEARLY * room * room:
        return np.inf, 0.0
    return _distance_to_arc(dx, dy, bulge[i], ox, oy, max_distance)


@kernel(allocates=False)
def _distance_to_arc(
    dx: float, dy: float, b: float, x: float, y: float, max_distance: float
) -> tuple[float, float]:
    """Return the distance of (``x``, ``y``) from an arc, and the nearest parameter on it.

    The parameter is 0 at the start and 1 at the end of the arc.  The arc starts at (0, 0), ends at
    (``dx``, ``dy``) and has the bulge ``b``.  The distance may be infinite for an arc that is
    clearly farther away than ``max_distance``.
    """
    if dx == 0.0 and dy == 0.0:
        return math.hypot(x, y), 0.0
    up = (1.0 - b * b) / (4.0 * b)
    cx = 0.5 * dx - up * dy
    cy = 0.5 * dy + up * dx
    px, py = x - cx, y - cy
    if abs(math.sqrt(px * px + py * py) - math.sqrt(cx * cx + cy * cy)) > _CLEARLY * max_distance:
        # Far from the whole circle: skip the angles, which are slow to compute.
        return np.inf, 0.0
    sweep = 4.0 * abs(math.atan(b))
    # The angle from the beginning of the arc, along it.
    side = cx * px + cy * py
    turn = math.atan2(cy * px - cx * py, -side)
    if b < 0.0:
        turn = -turn
    if turn < 0.0:
        turn += 2.0 * math.pi
    if turn <= sweep:
        return abs(math.hypot(px, py) - math.hypot(cx, cy)), turn / sweep
    from_start = math.hypot(x, y)
    from_end = math.hypot(x - dx, y - dy)
    if from_start <= from_end:
        return from_start, 0.0
    return from_end, 1.0


@inline_kernel
def point_at(ends: F64_3, bulge: F64_1, i: int, parameter: float) -> tuple[float, float]:
    """Return the point (x, y) of segment ``i`` at a parameter from 0 (start) to 1 (end).

    ``ends`` (n, 2, 2) and ``bulge`` (n,) are the end points and bulges of n segments.
    """
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    dx, dy = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay
    b = bulge[i]
    if abs(b) <= BULGE:
        return ax + parameter * dx, ay + parameter * dy
    up = (1.0 - b * b) / (4.0 * b)
    cx = ax + 0.5 * dx - up * dy
    cy = ay + 0.5 * dy + up * dx
    angle = 4.0 * math.atan(b) * parameter
    c, s = math.cos(angle), math.sin(angle)
    return cx + c * (ax - cx) - s * (ay - cy), cy + s * (ax - cx) + c * (ay - cy)


@inline_kernel
def outward_direction(ends: F64_3, bulge: F64_1, half: int) -> tuple[float, float]:
    """Return the unit vector (x, y) in which a segment would continue beyond one of its ends.

    ``half`` is the number of the end: 2 i for the start of segment i and 2 i + 1 for its end.  The
    vector is (0, 0) if both ends are at one point.  ``ends`` (n, 2, 2) and ``bulge`` (n,) are the
    end points and bulges of n segments.
    """
    i = half // 2
    dx, dy = ends[i, 1, 0] - ends[i, 0, 0], ends[i, 1, 1] - ends[i, 0, 1]
    if half % 2 == 0:
        dx, dy = -dx, -dy
    # The direction of the chord, turned by half the sweep.
    b = bulge[i] if half % 2 == 1 else -bulge[i]
    c, s = (1.0 - b * b) / (1.0 + b * b), 2.0 * b / (1.0 + b * b)
    length = math.sqrt(dx * dx + dy * dy)
    if length == 0.0:
        return 0.0, 0.0
    return (c * dx - s * dy) / length, (s * dx + c * dy) / length


@inline_kernel
def crossing_parameters(
    ax: float, ay: float, ux: float, uy: float, ends: F64_3, j: int
) -> tuple[float, float]:
    """Return the parameters, 0 … 1, of the point at which two straight segments cross.

    Returns NaN twice if the segments do not cross between their ends, or are parallel except for
    rounding: two lines that continue each other have no point of crossing.  The first segment runs
    from (``ax``, ``ay``) to (``ax + ux``, ``ay + uy``), the second from ``ends[j, 0]`` to
    ``ends[j, 1]``; the result has one parameter for each of the two.
    """
    vx, vy = ends[j, 1, 0] - ends[j, 0, 0], ends[j, 1, 1] - ends[j, 0, 1]
    ox, oy = ends[j, 0, 0] - ax, ends[j, 0, 1] - ay
    cross = ux * vy - uy * vx
    s, t = ox * vy - oy * vx, ox * uy - oy * ux
    if cross < 0.0:
        cross, s, t = -cross, -s, -t
    if not (0.0 < s < cross and 0.0 < t < cross):
        return np.nan, np.nan
    if cross * cross <= _PARALLEL * (ux * ux + uy * uy) * (vx * vx + vy * vy):
        return np.nan, np.nan
    return s / cross, t / cross


@inline_kernel
def chord_length(ends: F64_3, i: int) -> float:
    """Return the distance between the start and the end of segment ``i``.

    ``ends`` (n, 2, 2) are the start and end points of n segments.
    """
    dx, dy = ends[i, 1, 0] - ends[i, 0, 0], ends[i, 1, 1] - ends[i, 0, 1]
    return math.sqrt(dx * dx + dy * dy)
