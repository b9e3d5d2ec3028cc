"""segment: a line or an arc of at most half a turn, as compiled code sees it."""

from __future__ import annotations

import math
from typing import Any, Final

from numba import njit

#: What bends less is straight.
BULGE: Final = 1e-9


@njit(cache=True, error_model="numpy")
def near(ends: Any, bulge: Any, i: int, x: float, y: float) -> tuple[float, float]:
    """Distance from a point to a segment, and at which share of it that is."""
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    dx, dy = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay
    b = bulge[i]
    square = dx * dx + dy * dy
    if square == 0.0:
        return math.hypot(x - ax, y - ay), 0.0
    if abs(b) <= BULGE:
        share = min(max(((x - ax) * dx + (y - ay) * dy) / square, 0.0), 1.0)
        return math.hypot(x - ax - share * dx, y - ay - share * dy), share
    sweep = 4.0 * math.atan(b)
    up = (1.0 - b * b) / (4.0 * b)
    cx = ax + 0.5 * dx - up * dy
    cy = ay + 0.5 * dy + up * dx
    radius = math.hypot(ax - cx, ay - cy)
    turn = math.atan2(y - cy, x - cx) - math.atan2(ay - cy, ax - cx)
    if sweep < 0.0:
        turn = -turn
    turn %= 2.0 * math.pi
    if turn <= abs(sweep):
        return abs(math.hypot(x - cx, y - cy) - radius), turn / abs(sweep)
    from_start = math.hypot(x - ax, y - ay)
    from_end = math.hypot(x - ax - dx, y - ay - dy)
    if from_start <= from_end:
        return from_start, 0.0
    return from_end, 1.0


@njit(cache=True, error_model="numpy")
def point_at(ends: Any, bulge: Any, i: int, share: float) -> tuple[float, float]:
    """The point at a share of a segment."""
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    dx, dy = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay
    b = bulge[i]
    if abs(b) <= BULGE:
        return ax + share * dx, ay + share * dy
    up = (1.0 - b * b) / (4.0 * b)
    cx = ax + 0.5 * dx - up * dy
    cy = ay + 0.5 * dy + up * dx
    angle = 4.0 * math.atan(b) * share
    c, s = math.cos(angle), math.sin(angle)
    return cx + c * (ax - cx) - s * (ay - cy), cy + s * (ax - cx) + c * (ay - cy)


@njit(cache=True, error_model="numpy")
def leaves(ends: Any, bulge: Any, half: int) -> tuple[float, float]:
    """The direction in which a segment goes on beyond its end number ``half`` % 2."""
    i = half // 2
    dx, dy = ends[i, 1, 0] - ends[i, 0, 0], ends[i, 1, 1] - ends[i, 0, 1]
    if half % 2 == 0:
        dx, dy = -dx, -dy
    angle = 2.0 * math.atan(bulge[i]) * (1.0 if half % 2 == 1 else -1.0)
    c, s = math.cos(angle), math.sin(angle)
    long = math.hypot(dx, dy)
    if long == 0.0:
        return 0.0, 0.0
    return (c * dx - s * dy) / long, (s * dx + c * dy) / long
