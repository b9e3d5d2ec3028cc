"""shapes: compute lines and arcs from the numbers of DXF entities, for one entity or for many.

Each line or arc is a row: its ends (2, 2) and its bulge.  Both readers use these kernels, so that
their results are equal bit by bit.  NumPy may round an operation on an array differently from the
same operation on a single number, so it is not used here.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.kernels import F64_2, OutF64_1, OutF64_3, kernel

#: Radians to a degree.
_DEGREE: Final = math.pi / 180.0


@kernel
def swept(first: float, last: float) -> float:
    """Return the sweep of an arc between two angles (degrees), in (0, 360].

    The sweep is 360 if the angles differ by a multiple of 360.
    """
    sweep = (last - first) % 360.0
    return 360.0 if sweep == 0.0 and last != first else sweep


@kernel
def round_count(sweep: float) -> int:
    """Return the number of rows for an arc: each row turns by at most 180 degrees."""
    return 1 if sweep <= 180.0 + 1e-9 else 2


@kernel
def round_rows(
    x: float,
    y: float,
    radius: float,
    first: float,
    sweep: float,
    ends: OutF64_3,
    bulge: OutF64_1,
    at: int,
) -> int:
    """Write the rows of an arc from row ``at`` on; return the index of the row after them.

    ``first`` and ``sweep`` are in degrees.
    """
    rows = round_count(sweep)
    turn = min(math.tan(sweep * _DEGREE / rows / 4.0), 1.0)
    angle = first * _DEGREE
    from_x, from_y = math.cos(angle) * radius + x, math.sin(angle) * radius + y
    home_x, home_y = from_x, from_y
    for row in range(rows):
        angle = (first + sweep * (row + 1) / rows) * _DEGREE
        to_x, to_y = math.cos(angle) * radius + x, math.sin(angle) * radius + y
        if row == rows - 1 and sweep >= 360.0:
            to_x, to_y = home_x, home_y
        ends[at, 0, 0], ends[at, 0, 1] = from_x, from_y
        ends[at, 1, 0], ends[at, 1, 1] = to_x, to_y
        bulge[at] = turn
        from_x, from_y = to_x, to_y
        at += 1
    return at


@kernel
def chain_count(vertex: F64_2, low: int, high: int, closed: bool) -> int:
    """Return the number of rows for a polyline; an arc of more than 180 degrees has two rows.

    The vertices of the polyline are the rows ``low`` to ``high`` of ``vertex``.
    """
    rows = 0
    for i in range(low, high if closed else high - 1):
        rows += 2 if abs(vertex[i, 2]) > 1.0 else 1
    return rows


@kernel
def chain_rows(
    vertex: F64_2, low: int, high: int, closed: bool, ends: OutF64_3, bulge: OutF64_1, at: int
) -> int:
    """Write the rows of a polyline from row ``at`` on; return the index of the row after them.

    The vertices (x, y, bulge) are the rows ``low`` to ``high`` of ``vertex``.
    """
    for i in range(low, high if closed else high - 1):
        j = i + 1 if i + 1 < high else low
        x, y, turn = vertex[i, 0], vertex[i, 1], vertex[i, 2]
        to_x, to_y = vertex[j, 0], vertex[j, 1]
        if abs(turn) > 1.0:
            # The middle of the arc: half a chord times the bulge to the right of the chord.
            half = math.tan(math.atan(turn) / 2.0)
            mid_x = (x + to_x) / 2.0 + (to_y - y) * turn / 2.0
            mid_y = (y + to_y) / 2.0 - (to_x - x) * turn / 2.0
            ends[at, 0, 0], ends[at, 0, 1] = x, y
            ends[at, 1, 0], ends[at, 1, 1] = mid_x, mid_y
            bulge[at] = half
            at += 1
            x, y, turn = mid_x, mid_y, half
        ends[at, 0, 0], ends[at, 0, 1] = x, y
        ends[at, 1, 0], ends[at, 1, 1] = to_x, to_y
        bulge[at] = turn
        at += 1
    return at


@kernel
def mirror_rows(ends: OutF64_3, bulge: OutF64_1, low: int, high: int) -> None:
    """Negate x in the rows ``low`` to ``high``, as an extrusion of −Z does."""
    for i in range(low, high):
        ends[i, 0, 0] = -ends[i, 0, 0]
        ends[i, 1, 0] = -ends[i, 1, 0]
        bulge[i] = -bulge[i]


@kernel
def turning(rotation: float) -> tuple[float, float]:
    """Return cosine and sine of an angle in degrees."""
    return math.cos(rotation * _DEGREE), math.sin(rotation * _DEGREE)


def moved(linear: F64, shift: F64, points: F64) -> F64:
    """Return transformed points: ``linear @ p + shift`` for each p.

    Parameters
    ----------
    linear : (..., 2, 2)
    shift : (..., 2)
    points : (..., 2)
        Written out, because rounding of matrix products depends on the processor.
    """
    x, y = points[..., 0], points[..., 1]
    result: F64 = np.stack(
        [
            linear[..., 0, 0] * x + linear[..., 0, 1] * y + shift[..., 0],
            linear[..., 1, 0] * x + linear[..., 1, 1] * y + shift[..., 1],
        ],
        axis=-1,
    )
    return result
