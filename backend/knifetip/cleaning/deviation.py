"""deviation: measure the distance of drawn edges from the cleaned edges that replace them."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_1, F64_2, I64_1, inline_kernel, kernel

#: Number of steps between the points of a stretch at which it is measured.
_STEPS: Final = 4


class MeasuredEdges(NamedTuple):
    """The ends and bulges of k edges."""

    ends: F64_2  #: (k, 4) x0, y0, x1, y1 (mm)
    bulge: F64_1  #: (k,)


def measured_edges(ends: F64, bulge: F64) -> MeasuredEdges:
    """Return the record of k edges with the ends ``ends``, (k, 2, 2) mm, and ``bulge``, (k,)."""
    return MeasuredEdges(np.ascontiguousarray(ends.reshape(-1, 4)), bulge)


def measure_deviation(
    drawn: MeasuredEdges, cleaned: MeasuredEdges, row: I64, low: F64, high: F64, target: I64
) -> F64:
    """Return the greatest distance of each stretch from its cleaned edge, (q,) mm.

    The distance is measured at five points of each stretch.  It is 0 for a stretch whose edge is
    unchanged, or that was dropped.

    Parameters
    ----------
    drawn, cleaned
        The n edges before cleaning, and the m edges after it.
    row, low, high, target : (q,)
        For each of q stretches: its drawn edge, its start and its end as fractions of that edge's
        length, and the row of its cleaned edge (-1 if it was dropped).
    """
    result: F64 = _measure(drawn, cleaned, row, low, high, target)
    return result


@kernel
def _measure(
    drawn: MeasuredEdges, cleaned: MeasuredEdges, row: I64_1, low: F64_1, high: F64_1, target: I64_1
) -> Any:
    result = np.zeros(len(row))
    edge, on = np.empty(5), np.empty(5)
    for k in range(len(row)):
        if target[k] < 0:
            continue
        edge[4], on[4] = drawn.bulge[row[k]], cleaned.bulge[target[k]]
        is_same = edge[4] == on[4]
        for column in range(4):
            edge[column] = drawn.ends[row[k], column]
            on[column] = cleaned.ends[target[k], column]
            is_same &= edge[column] == on[column]
        if is_same:
            continue
        for step in range(_STEPS + 1):
            x, y = point_on_edge(edge, low[k] + step / _STEPS * (high[k] - low[k]))
            result[k] = max(result[k], distance_to_edge(on, x, y))
    return result


@inline_kernel
def point_on_edge(edge: F64_1, fraction: float) -> tuple[float, float]:
    """Return the point of an edge at a fraction of its length (mm)."""
    dx, dy, b = edge[2] - edge[0], edge[3] - edge[1], edge[4]
    if abs(b) < BULGE:
        return edge[0] + fraction * dx, edge[1] + fraction * dy
    # The chord to the point is the chord of the arc, scaled and turned.
    half = 2.0 * math.atan(b)
    scale = math.sin(fraction * half) / math.sin(half)
    turn = (fraction - 1.0) * half
    c, s = scale * math.cos(turn), scale * math.sin(turn)
    return edge[0] + dx * c - dy * s, edge[1] + dx * s + dy * c


@inline_kernel
def distance_to_edge(edge: F64_1, x: float, y: float) -> float:
    """Return the distance of a point from a line or an arc (mm)."""
    dx, dy, b = edge[2] - edge[0], edge[3] - edge[1], edge[4]
    px, py = x - edge[0], y - edge[1]
    if abs(b) < BULGE:
        along = min(max((px * dx + py * dy) / (dx * dx + dy * dy), 0.0), 1.0)
        return math.hypot(px - along * dx, py - along * dy)
    lean = (1.0 - b * b) / (4.0 * b)
    ux, uy = px - 0.5 * dx + lean * dy, py - 0.5 * dy - lean * dx
    from_centre = math.hypot(ux, uy)
    # The middle of the arc lies on the right of its chord if the arc turns to the left.
    chord = math.hypot(dx, dy)
    sense = 1.0 if b > 0.0 else -1.0
    middle = sense * (ux * dy - uy * dx) / chord
    if middle >= (1.0 - b * b) / (1.0 + b * b) * from_centre:
        return float(abs(from_centre - chord * (1.0 + b * b) / (4.0 * abs(b))))
    return min(math.hypot(px, py), math.hypot(px - dx, py - dy))
