"""Distances of points from lines and arcs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from knifetip.kernels import F64_2, inline_kernel, kernel
from knifetip.verification.columns import F64


def distance_from_curves(points: F64, curves: F64) -> F64:
    """Return the distance of each of n points from the nearest of m curves, (n,) mm.

    Each point is compared with each curve, so this is for a few curves, such as those of one track.
    The result is infinite if there are no curves.

    Parameters
    ----------
    points : (n, 2) mm
        The points.
    curves : (m, 6)
        Lines and arcs as rows of six numbers (see ``curves.curve``).
    """
    result: F64 = _least_distances(np.ascontiguousarray(points), np.ascontiguousarray(curves))
    return result


@kernel
def _least_distances(points: F64_2, curves: F64_2) -> Any:
    """Return the distances of n points from the nearest curve; see ``distance_from_curves``."""
    least = np.full(len(points), math.inf)
    for point in range(len(points)):
        for curve in range(len(curves)):
            distance = distance_from_curve(points[point, 0], points[point, 1], curves, curve)
            least[point] = min(least[point], distance)
    return least


@inline_kernel
def distance_from_curve(x: float, y: float, curves: F64_2, row: int) -> float:
    """Return the distance of the point (x, y) from one of some curves (mm).

    ``curves`` are lines and arcs as rows of six numbers (see ``curves.curve``), and ``row`` is the
    index of the one.
    """
    x -= curves[row, 1]
    y -= curves[row, 2]
    kind, size = curves[row, 0], curves[row, 5]
    if kind == 0.0:
        ux, uy = curves[row, 3], curves[row, 4]
        along = min(max(x * ux + y * uy, 0.0), size)
        beside: float = math.hypot(x - along * ux, y - along * uy)
        return beside
    radius, angle = curves[row, 3], curves[row, 4]
    sweep = size / radius
    turn = (kind * (math.atan2(y, x) - angle)) % (2.0 * math.pi)
    if turn <= sweep:
        inside: float = radius - math.hypot(x, y)
        return abs(inside)
    # Past one end of the arc, the nearer end counts.
    if turn - sweep < 2.0 * math.pi - turn:
        angle += kind * sweep
    distance: float = math.hypot(x - radius * math.cos(angle), y - radius * math.sin(angle))
    return distance
