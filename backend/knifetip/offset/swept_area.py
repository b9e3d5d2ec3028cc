"""swept_area: areas under a path, and under the edge that a tool leaves beside its path.

The area under a path is the signed area between the path and the coordinate origin, positive
counter-clockwise.
"""

from __future__ import annotations

import math

from knifetip.geometry.tolerance import BULGE, POINT
from knifetip.kernels import F64_1, F64_2, OutF64_2, kernel
from knifetip.offset.records import ResultChains


@kernel
def _cap_area(chord: float, b: float) -> float:
    """Return the area between a chord (mm) and its arc of bulge b, > 0 for a left turn (mm²)."""
    if abs(b) < BULGE:
        return 0.0
    whole = 1.0 + b * b
    radius = chord * whole / (4.0 * b)
    # Sine of the sweep, 4 atan b, by two doublings.
    return 0.5 * radius * radius * (4.0 * math.atan(b) - 4.0 * b * (1.0 - b * b) / (whole * whole))


@kernel
def _turn_area(
    x: float, y: float, ax: float, ay: float, bx: float, by: float, signed: float
) -> float:
    """Return twice the signed area between an arc around (x, y) and its chord (mm²).

    The arc goes from (ax, ay) to (bx, by); ``signed`` is its radius (mm), positive
    counter-clockwise.
    """
    ax -= x
    ay -= y
    bx -= x
    by -= y
    angle = math.atan2(ax * by - ay * bx, ax * bx + ay * by)
    if signed < 0.0:
        angle = -angle
    if angle < -1e-7:
        angle += 2.0 * math.pi
    return math.copysign(signed * signed * (angle - math.sin(angle)), signed)


@kernel
def area_under_edge(
    chains: ResultChains,
    chain: int,
    start: F64_2,
    signed: float,
    begin: tuple[float, float],
    corner_arcs: OutF64_2,
    arc_row: int,
) -> tuple[float, float, float, int]:
    """Return twice the area between the origin and the edge that a tool leaves beside a chain.

    A chain is a path of the tool's centre.  The edge is the border of the area that the tool sweeps
    on this path, on the side of the contour.

    Parameters
    ----------
    chains, chain
        All chains, and the number of the chain.
    start
        Start points of the contour segments.
    signed : mm
        Radius of the tool, positive left of travel.
    begin : mm
        Point at which the edge of an open chain starts.
    corner_arcs, arc_row
        Rows that receive the arcs of the edge around the corners of the chain, and the first free
        row.

    Returns
    -------
    twice : mm²
        Twice the area.
    x, y : mm
        Point at which the edge ends.
    arc_row
        Next free row of ``corner_arcs``.
    """
    line, tag, bounds, ring = chains
    low, high, closed = bounds[chain], bounds[chain + 1], ring[chain]
    twice = 0.0
    x, y = begin
    size = abs(signed)
    begun = not closed
    for r in range(low, high + (1 if closed else 0)):
        again = r == high
        row = low if again else r
        x0, y0, x1, y1, b = line[row, 0], line[row, 1], line[row, 2], line[row, 3], line[row, 4]
        if tag[row, 1]:
            ax, ay = start[tag[row, 0], 0], start[tag[row, 0], 1]
            bx, by = ax, ay
            bent = 0.0
        else:
            dx = x1 - x0
            dy = y1 - y0
            scale = signed / math.sqrt(dx * dx + dy * dy)
            whole = 1.0 + b * b
            cos = (1.0 - b * b) / whole * scale
            sin = 2.0 * b / whole * scale
            ax = x0 + dy * cos - dx * sin
            ay = y0 - dx * cos - dy * sin
            bx = x1 + dy * cos + dx * sin
            by = y1 - dx * cos + dy * sin
            bent = b
        if begun:
            twice += x * ay - y * ax
            gap = math.hypot(ax - x, ay - y)
            if (
                gap > POINT
                and abs(math.hypot(x - x0, y - y0) - size) < 1e-6
                and abs(math.hypot(ax - x0, ay - y0) - size) < 1e-6
            ):
                twice += _turn_area(x0, y0, x, y, ax, ay, signed)
                half = min(gap / (2.0 * size), 1.0)
                corner_arcs[arc_row, 0] = x
                corner_arcs[arc_row, 1] = y
                corner_arcs[arc_row, 2] = ax
                corner_arcs[arc_row, 3] = ay
                corner_arcs[arc_row, 4] = math.copysign(
                    half / (1.0 + math.sqrt(1.0 - half * half)), signed
                )
                arc_row += 1
        begun = True
        if again:
            break
        twice += ax * by - ay * bx
        if bent != 0.0:
            twice += 2.0 * math.copysign(_cap_area(math.hypot(bx - ax, by - ay), bent), bent)
        x, y = bx, by
    return twice, x, y, arc_row


@kernel
def area_under_path(start: F64_2, end: F64_2, bulge: F64_1, low: int, high: int) -> float:
    """Return twice the signed area between the origin and the segments low … high - 1 (mm²).

    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the segments.
    """
    twice = 0.0
    for i in range(low, high):
        twice += start[i, 0] * end[i, 1] - start[i, 1] * end[i, 0]
        if bulge[i] != 0.0:
            chord = math.hypot(end[i, 0] - start[i, 0], end[i, 1] - start[i, 1])
            twice += 2.0 * _cap_area(chord, bulge[i])
    return twice
