"""shapes: compute lines and arcs from the numbers of DXF entities, for one entity or for many.

Each line or arc is a row: its ends (2, 2) and its bulge.  The fast reader and the ezdxf reader both
use these kernels, so that their results are equal bit by bit.  The kernels do not use NumPy's array
operations, because NumPy may round an operation on an array differently from the same operation on
a single number.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.kernels import F64_2, OutF64_1, OutF64_3, kernel

#: Widths of a polyline whose relative difference is smaller are equal.
_SAME_WIDTH: Final = 1e-6
#: Radians to a degree.
_DEGREE: Final = math.pi / 180.0


def one_width(least: F64, most: F64) -> F64:
    """Return the line width of each of k polylines, (k,); 0 if it is not drawn as one wide line.

    ``least`` and ``most`` (k,) are the least and the greatest width at the vertices of each
    polyline (file units).
    """
    with np.errstate(invalid="ignore"):
        is_one = (least > 0.0) & (most - least <= _SAME_WIDTH * most) & np.isfinite(most)
    return np.where(is_one, most, 0.0)


@kernel
def sweep_angle(first: float, last: float) -> float:
    """Return the counter-clockwise angle from ``first`` to ``last``, in (0, 360] (all in degrees).

    It is 360 if ``first`` and ``last`` differ by a multiple of 360.
    """
    sweep = (last - first) % 360.0
    return 360.0 if sweep == 0.0 and last != first else sweep


@kernel
def arc_segment_count(sweep: float) -> int:
    """Return the number of segments of at most 180 degrees for an arc of ``sweep`` degrees."""
    return 1 if sweep <= 180.0 + 1e-9 else 2


@kernel
def write_arc(
    x: float,
    y: float,
    radius: float,
    first: float,
    sweep: float,
    ends: OutF64_3,
    bulge: OutF64_1,
    next_row: int,
) -> int:
    """Write the segments of an arc into ``ends`` and ``bulge``, from row ``next_row`` on.

    Returns the index of the row after the last segment.

    Parameters
    ----------
    x, y, radius
        Centre and radius of the arc (file units).
    first, sweep
        Start angle and sweep of the arc (degrees).
    """
    rows = arc_segment_count(sweep)
    turn = min(math.tan(sweep * _DEGREE / rows / 4.0), 1.0)
    angle = first * _DEGREE
    from_x, from_y = math.cos(angle) * radius + x, math.sin(angle) * radius + y
    home_x, home_y = from_x, from_y
    for row in range(rows):
        angle = (first + sweep * (row + 1) / rows) * _DEGREE
        to_x, to_y = math.cos(angle) * radius + x, math.sin(angle) * radius + y
        if row == rows - 1 and sweep >= 360.0:
            to_x, to_y = home_x, home_y
        ends[next_row, 0, 0], ends[next_row, 0, 1] = from_x, from_y
        ends[next_row, 1, 0], ends[next_row, 1, 1] = to_x, to_y
        bulge[next_row] = turn
        from_x, from_y = to_x, to_y
        next_row += 1
    return next_row


@kernel
def polyline_segment_count(vertex: F64_2, low: int, high: int, closed: bool) -> int:
    """Return the number of segments of a polyline; an arc of more than 180 degrees becomes two.

    The vertices of the polyline are ``vertex[low:high]``: x, y, bulge.  If ``closed``, a segment
    connects the last vertex to the first vertex.
    """
    rows = 0
    for i in range(low, high if closed else high - 1):
        rows += 2 if abs(vertex[i, 2]) > 1.0 else 1
    return rows


@kernel
def write_polyline(
    vertex: F64_2, low: int, high: int, closed: bool, ends: OutF64_3, bulge: OutF64_1, next_row: int
) -> int:
    """Write the segments of a polyline into ``ends`` and ``bulge``, from row ``next_row`` on.

    The vertices of the polyline are ``vertex[low:high]``: x, y, bulge.  If ``closed``, a segment
    connects the last vertex to the first vertex.  Returns the index of the row after the last
    segment.
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
            ends[next_row, 0, 0], ends[next_row, 0, 1] = x, y
            ends[next_row, 1, 0], ends[next_row, 1, 1] = mid_x, mid_y
            bulge[next_row] = half
            next_row += 1
            x, y, turn = mid_x, mid_y, half
        ends[next_row, 0, 0], ends[next_row, 0, 1] = x, y
        ends[next_row, 1, 0], ends[next_row, 1, 1] = to_x, to_y
        bulge[next_row] = turn
        next_row += 1
    return next_row


@kernel
def mirror_segments(ends: OutF64_3, bulge: OutF64_1, low: int, high: int) -> None:
    """Negate x in the segments ``low`` … ``high`` - 1 and reverse the sign of their bulges.

    An entity with an extrusion of −Z is mirrored in this way.
    """
    for i in range(low, high):
        ends[i, 0, 0] = -ends[i, 0, 0]
        ends[i, 1, 0] = -ends[i, 1, 0]
        bulge[i] = -bulge[i]


@kernel
def cos_sin(rotation: float) -> tuple[float, float]:
    """Return the cosine and the sine of the angle ``rotation`` (degrees)."""
    return math.cos(rotation * _DEGREE), math.sin(rotation * _DEGREE)


def map_points(linear: F64, shift: F64, points: F64) -> F64:
    """Return the points ``linear @ p + shift``, (..., 2), for each point p of ``points``.

    The matrix product is computed with single multiplications, because the rounding of NumPy's
    matrix product depends on the processor.

    Parameters
    ----------
    linear : (..., 2, 2)
        Linear maps.
    shift : (..., 2)
        Translations.
    points : (..., 2)
        Points to transform.
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
