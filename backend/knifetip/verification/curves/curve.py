"""Lines and arcs as rows of six numbers, called curves, and points and directions on them.

The first number of a curve is the kind: 0 for a line, 1 for an arc to the left, -1 for an arc to
the right.  The next four are, for a line, its start (x, y) and unit direction (x, y), and for an
arc, its centre (x, y), radius and start angle (radians).  The last number is the length.  Lengths
are mm.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from knifetip.kernels import F64_1, F64_2, OutF64_2, inline_kernel, kernel
from knifetip.verification.columns import F64


def point_at(curve: F64, along: F64) -> F64:
    """Return one point on each of n curves, (n, 2) mm.

    ``curve`` contains lines and arcs as rows of six numbers (see the module docstring), (n, 6).
    ``along`` is the distance of each point from the start of its curve, (n,) mm.
    """
    result: F64 = _points(np.ascontiguousarray(curve), np.ascontiguousarray(along, np.float64))
    return result


@kernel
def _points(curve: F64_2, along: F64_1) -> Any:
    """Return one point on each of n curves, (n, 2) mm; see ``point_at``."""
    point = np.empty((len(curve), 2))
    for row in range(len(curve)):
        if curve[row, 0] == 0.0:
            x, y = curve[row, 3] * along[row], curve[row, 4] * along[row]
        else:
            angle = curve[row, 4] + curve[row, 0] * along[row] / curve[row, 3]
            x, y = curve[row, 3] * math.cos(angle), curve[row, 3] * math.sin(angle)
        point[row, 0], point[row, 1] = curve[row, 1] + x, curve[row, 2] + y
    return point


def azimuth_at(curve: F64, along: F64) -> F64:
    """Return the direction of travel at one point on each of n curves, (n,) degrees from the X
    axis.

    ``curve`` contains lines and arcs as rows of six numbers (see the module docstring), (n, 6).
    ``along`` is the distance of each point from the start of its curve, (n,) mm.
    """
    result: F64 = np.degrees(
        _headings(np.ascontiguousarray(curve), np.ascontiguousarray(along, np.float64))
    )
    return result


@kernel
def _headings(curve: F64_2, along: F64_1) -> Any:
    """Return the direction of travel at one point on each of n curves, (n,) radians; see
    ``azimuth_at``.
    """
    heading = np.empty(len(curve))
    for row in range(len(curve)):
        heading[row] = heading_on(curve, row, along[row])
    return heading


@inline_kernel
def heading_on(curve: F64_2, row: int, along: float) -> float:
    """Return the direction of travel at one point on a curve, in radians; see ``azimuth_at``."""
    if curve[row, 0] == 0.0:
        return math.atan2(curve[row, 4], curve[row, 3])
    quarter = math.pi / 2.0
    direction: float = curve[row, 4] + curve[row, 0] * (along / curve[row, 3] + quarter)
    return direction


def left_distance(curve: F64, along: F64, edge: F64) -> F64:
    """Return the signed distance of one point on each of n curves from an edge, (n,) mm.

    The distance is positive to the left of the edge.  It is measured from the infinite line or the
    full circle of the edge.

    Parameters
    ----------
    curve, edge : (n, 6)
        The curves, and the edge for each of them: lines and arcs as rows of six numbers (see the
        module docstring).
    along : (n,) mm
        Distance of each point from the start of its curve.
    """
    x, y = (point_at(curve, along) - edge[:, 1:3]).T
    straight = edge[:, 0] == 0.0
    distance = np.where(straight, edge[:, 3] * y - edge[:, 4] * x, 0.0)
    result: F64 = np.where(straight, distance, edge[:, 0] * (edge[:, 3] - np.hypot(x, y)))
    return result


def line_curves(start: F64, end: F64) -> F64:
    """Return n lines as rows of six numbers, (n, 6), in the format of the module docstring.

    Line i leads from the point ``start[i]`` to the point ``end[i]``; the points are (n, 2) mm.  A
    line between equal points has length 0 and the direction of the X axis.
    """
    result: F64 = _lines(
        np.ascontiguousarray(start, np.float64), np.ascontiguousarray(end, np.float64)
    )
    return result


@kernel
def _lines(start: F64_2, end: F64_2) -> Any:
    """Return n lines as rows of six numbers, (n, 6); see ``line_curves``."""
    curve = np.empty((len(start), 6))
    for row in range(len(start)):
        write_line(curve, row, start[row, 0], start[row, 1], end[row, 0], end[row, 1])
    return curve


@inline_kernel
def write_line(
    curve: OutF64_2, row: int, start_x: float, start_y: float, end_x: float, end_y: float
) -> None:
    """Write the line between two points to a row of ``curve``; see ``line_curves``."""
    x, y = end_x - start_x, end_y - start_y
    length = math.hypot(x, y)
    if not length > 0.0:
        x, y = 1.0, 0.0
    else:
        x, y = x / length, y / length
    curve[row, 0], curve[row, 1], curve[row, 2] = 0.0, start_x, start_y
    curve[row, 3], curve[row, 4], curve[row, 5] = x, y, length


def arc_curves(centre: F64, start: F64, sweep: F64) -> F64:
    """Return n arcs as rows of six numbers, (n, 6), in the format of the module docstring.

    ``centre`` and ``start`` are the centres and start points, (n, 2) mm each.  ``sweep`` is the
    angle of each arc, (n,) radians, positive for an anticlockwise arc.
    """
    radial = start - centre
    radius = np.hypot(radial[:, 0], radial[:, 1])
    first = np.arctan2(radial[:, 1], radial[:, 0])
    return np.column_stack([np.sign(sweep), centre, radius, first, radius * np.abs(sweep)])
