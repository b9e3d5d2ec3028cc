"""edge_parameter: inline kernels for positions along an edge.

Each row of ``rows`` is one edge: x0, y0, x1, y1, bulge.  A parameter is the position along an edge
as a fraction of its length, 0 at the start and 1 at the end.
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_1, F64_2, kernel


@kernel
def circle_of(rows: F64_2, i: int) -> tuple[float, float, float, float]:
    """Return centre x and y, radius and signed sweep (radians) of the arc in ``rows[i]``.

    A row is x0, y0, x1, y1, bulge.
    """
    b = rows[i, 4]
    dx = rows[i, 2] - rows[i, 0]
    dy = rows[i, 3] - rows[i, 1]
    lean = (1.0 - b * b) / (4.0 * b)
    cx = 0.5 * (rows[i, 0] + rows[i, 2]) - lean * dy
    cy = 0.5 * (rows[i, 1] + rows[i, 3]) + lean * dx
    radius = math.hypot(dx, dy) * (1.0 + b * b) / (4.0 * abs(b))
    return cx, cy, radius, 4.0 * math.atan(b)


@kernel
def size_of(rows: F64_2, i: int) -> float:
    """Return the length (mm) of the edge in ``rows[i]``, a line or an arc."""
    chord = math.hypot(rows[i, 2] - rows[i, 0], rows[i, 3] - rows[i, 1])
    b = abs(rows[i, 4])
    if b < BULGE:
        return chord
    return float(chord * (1.0 + b * b) * math.atan(b) / b)


@kernel
def middle_of(rows: F64_2, i: int) -> tuple[float, float]:
    """Return the midpoint (x, y) of the edge in ``rows[i]``, a line or an arc."""
    b = rows[i, 4]
    return (
        0.5 * (rows[i, 0] + rows[i, 2]) + 0.5 * b * (rows[i, 3] - rows[i, 1]),
        0.5 * (rows[i, 1] + rows[i, 3]) - 0.5 * b * (rows[i, 2] - rows[i, 0]),
    )


@kernel
def place_of(rows: F64_2, i: int, x: float, y: float) -> float:
    """Return the parameter of the point on edge ``i``, or on its extension, nearest to (x, y).

    The parameter is 0 at the start and 1 at the end of the edge, less than 0 before the start and
    greater than 1 beyond the end.  The extension of an arc is the rest of its circle, up to the
    point opposite the midpoint of the arc.  ``rows`` (k, 5) are edges: x0, y0, x1, y1, bulge.
    """
    if abs(rows[i, 4]) < BULGE:
        dx = rows[i, 2] - rows[i, 0]
        dy = rows[i, 3] - rows[i, 1]
        return float(((x - rows[i, 0]) * dx + (y - rows[i, 1]) * dy) / (dx * dx + dy * dy))
    cx, cy, _, sweep = circle_of(rows, i)
    mx, my = middle_of(rows, i)
    mx -= cx
    my -= cy
    x -= cx
    y -= cy
    return 0.5 + math.atan2(mx * y - my * x, mx * x + my * y) / sweep


@kernel
def range_of(rows: F64_2, i: int, piece: F64_1) -> tuple[float, float]:
    """Return the lower and the upper limit of the part of edge ``i`` that another edge covers.

    The limits are parameters: 0 is the start and 1 the end of edge ``i``, and a limit is outside
    0 … 1 if the other edge reaches farther than edge ``i``.  The other edge, ``piece`` (5,), is
    coincident with edge ``i``.  ``rows`` (k, 5) and ``piece`` are edges: x0, y0, x1, y1, bulge.
    """
    if abs(rows[i, 4]) < BULGE:
        a = place_of(rows, i, piece[0], piece[1])
        b = place_of(rows, i, piece[2], piece[3])
        return min(a, b), max(a, b)
    sweep = 4.0 * math.atan(rows[i, 4])
    mx = 0.5 * (piece[0] + piece[2]) + 0.5 * piece[4] * (piece[3] - piece[1])
    my = 0.5 * (piece[1] + piece[3]) - 0.5 * piece[4] * (piece[2] - piece[0])
    middle = place_of(rows, i, mx, my)
    round_ = abs(2.0 * math.pi / sweep)
    # Not by its sweep: a shallow arc within the tolerance may have another radius.
    a = place_of(rows, i, piece[0], piece[1]) - middle
    b = place_of(rows, i, piece[2], piece[3]) - middle
    a -= round_ * round(a / round_)
    b -= round_ * round(b / round_)
    low, high = min(a, b), max(a, b)
    best = middle
    most = -np.inf
    for turn in range(-1, 2):
        at = middle + turn * round_
        common = min(at + high, 1.0) - max(at + low, 0.0)
        if common > most:
            most = common
            best = at
    return best + low, best + high


@kernel
def part_beside(edge: F64_2, longer: F64_2) -> tuple[float, float, bool]:
    """Return the part of an edge that is beside a longer edge, as fractions 0 … 1 of the edge, and
    whether the longer edge has the opposite direction.

    In contrast to ``range_of``, the two edges may be curved differently.  ``edge`` and ``longer``
    are (1, 5): x0, y0, x1, y1, bulge.
    """
    low, high = range_of(longer, 0, edge[0])
    span = place_of(longer, 0, edge[0, 2], edge[0, 3]) - place_of(longer, 0, edge[0, 0], edge[0, 1])
    if abs(longer[0, 4]) >= BULGE:
        turn = 2.0 * math.pi / abs(4.0 * math.atan(longer[0, 4]))
        span -= turn * round(span / turn)
    size = max(high - low, 1e-12)
    begin, end = max(0.0, -low / size), min(1.0, (1.0 - low) / size)
    if span < 0.0:
        begin, end = 1.0 - end, 1.0 - begin
    return begin, end, span < 0.0
