"""Lines and arcs as rows of six numbers, called curves, and points and directions on them.

The first number of a curve is the kind: 0 for a line, 1 for an arc to the left, -1 for an arc to
the right.  The next four are, for a line, its start (x, y) and unit direction (x, y), and for an
arc, its centre (x, y), radius and start angle (radians).  The last number is the length.  Lengths
are mm.
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.verification.columns import F64


def point_at(curve: F64, along: F64) -> F64:
    """Return one point on each of n curves, (n, 2) mm.

    ``curve`` contains lines and arcs as rows of six numbers (see the module docstring), (n, 6).
    ``along`` is the distance of each point from the start of its curve, (n,) mm.
    """
    straight = curve[:, 0] == 0.0
    radius = np.where(straight, 1.0, curve[:, 3])
    angle = curve[:, 4] + curve[:, 0] * along / radius
    x = np.where(straight, curve[:, 3] * along, radius * np.cos(angle))
    y = np.where(straight, curve[:, 4] * along, radius * np.sin(angle))
    result: F64 = curve[:, 1:3] + np.stack([x, y], axis=1)
    return result


def azimuth_at(curve: F64, along: F64) -> F64:
    """Return the direction of travel at one point on each of n curves, (n,) degrees from the X
    axis.

    ``curve`` contains lines and arcs as rows of six numbers (see the module docstring), (n, 6).
    ``along`` is the distance of each point from the start of its curve, (n,) mm.
    """
    straight = curve[:, 0] == 0.0
    radius = np.where(straight, 1.0, curve[:, 3])
    angle = curve[:, 4] + curve[:, 0] * (along / radius + math.pi / 2.0)
    result: F64 = np.degrees(np.where(straight, np.arctan2(curve[:, 4], curve[:, 3]), angle))
    return result


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
    vector = end - start
    length = np.hypot(vector[:, 0], vector[:, 1])
    safe = np.where(length > 0.0, length, 1.0)
    direction = np.where(length[:, None] > 0.0, vector / safe[:, None], (1.0, 0.0))
    return np.column_stack([np.zeros(len(start)), start, direction, length])


def arc_curves(centre: F64, start: F64, sweep: F64) -> F64:
    """Return n arcs as rows of six numbers, (n, 6), in the format of the module docstring.

    ``centre`` and ``start`` are the centres and start points, (n, 2) mm each.  ``sweep`` is the
    angle of each arc, (n,) radians, positive for an anticlockwise arc.
    """
    radial = start - centre
    radius = np.hypot(radial[:, 0], radial[:, 1])
    first = np.arctan2(radial[:, 1], radial[:, 0])
    return np.column_stack([np.sign(sweep), centre, radius, first, radius * np.abs(sweep)])
