"""Contours of the sample cartons, and the layers on which they are drawn."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from knifetip.dxf.samples.write import Layer
from knifetip.geometry.azimuth import left_normal
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths, path_through

CUT = Layer("CUT", 1)
CREASE = Layer("CREASE", 5, "DASHED")
V_GROOVE = Layer("V-GROOVE", 6, "DASHDOT")


def thumb_notch(radius: float, depth: float, lead: float) -> F64:
    """Return the corners of a thumb notch in the edge of a panel, shape (4, 4).

    The notch is an arc of radius ``radius`` that reaches ``depth`` into the board.  At each side a
    fillet of radius ``lead`` leads from the edge into the arc (all in mm).  The board is to the
    left of the edge, and the middle of the notch is at u = 0.

    The columns of the returned array are u along the edge (mm), v into the board (mm), radius of
    the fillet that ``closed_contour`` adds at the corner, and bulge of the side after the corner.
    The radius is 0, because the two fillets of the notch are already sides with a bulge.

    The centre of the arc is ``radius - depth`` outside the board.  The common tangent of the arc
    and a fillet therefore makes the angle φ with the edge, with
    cos φ = (radius - depth + lead) / (radius + lead).
    """
    turned = math.acos((radius - depth + lead) / (radius + lead))
    half = (radius + lead) * math.sin(turned)
    inner, sunk = half - lead * math.sin(turned), lead * (1.0 - math.cos(turned))
    edge, belly = math.tan(turned / 4.0), -math.tan(turned / 2.0)
    return np.array(
        [
            (-half, 0.0, 0.0, edge),
            (-inner, sunk, 0.0, belly),
            (inner, sunk, 0.0, edge),
            (half, 0.0, 0.0, 0.0),
        ]
    )


def sheet_corners(corners: F64, origin: tuple[float, float], axis: tuple[float, float]) -> F64:
    """Convert corners of a contour from coordinates along an edge to the coordinates of the sheet.

    The columns of ``corners`` and of the returned array, (k, 4), are the two coordinates, radius of
    the fillet at the corner (mm), and bulge of the side after the corner.

    Parameters
    ----------
    corners : (k, 4)
        Corners with the coordinates u along the edge and v to the left of the edge.
    origin
        Point u = v = 0 in the coordinates of the sheet.
    axis
        Unit vector along the edge, in the coordinates of the sheet.
    """
    u = np.array(axis)
    xy = origin + corners[:, :1] * u + corners[:, 1:2] * left_normal(u)
    return np.hstack([xy, corners[:, 2:]])


def four_quarters(quarter: F64) -> list[F64]:
    """Return the corners of the four quarters of a contour that is symmetrical to the x and y axes.

    ``quarter`` contains the corners of the quarter with positive x and y, counter-clockwise.  The
    returned list contains this array and its three mirror images, in counter-clockwise order.  The
    columns of an array, (k, 4), are x, y, radius of the fillet at the corner, and bulge.
    """
    backwards = quarter[::-1]
    return [
        quarter,
        backwards * (-1.0, 1.0, 1.0, 1.0),
        quarter * (-1.0, -1.0, 1.0, 1.0),
        backwards * (1.0, -1.0, 1.0, 1.0),
    ]


def oblong(centre: tuple[float, float], length: float, radius: float) -> Paths:
    """Return the closed path of a hole with semicircular ends, ``length`` mm long in y.

    ``centre`` is the centre of the hole, and ``radius`` the radius of its ends (mm).
    """
    x, y = centre
    straight = length / 2.0 - radius
    xy = np.array(
        [
            (x + radius, y - straight),
            (x + radius, y + straight),
            (x - radius, y + straight),
            (x - radius, y - straight),
            (x + radius, y - straight),
        ]
    )
    return path_through(xy, np.array([0.0, 1.0, 0.0, 1.0]))


def rectangle(x: float, y: float, width: float, height: float) -> Paths:
    """Return the closed path of a rectangle with its centre at (x, y), all in mm."""
    corners = np.array([(1, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)])
    return path_through(corners * (width / 2.0, height / 2.0) + np.array([x, y]), np.zeros(4))


def separate_lines(rows: ArrayLike) -> Paths:
    """Return a separate path for each row of ``rows``, (k, 4): x, y of the start and of the end."""
    ends = np.asarray(rows, np.float64)
    return split_paths(
        Paths(ends[:, :2], ends[:, 2:], np.zeros(len(ends)), np.array([0, len(ends)]))
    )


def split_paths(paths: Paths) -> Paths:
    """Return the segments of ``paths``, each as a path of one segment."""
    numbers = np.arange(len(paths.bulge) + 1, dtype=np.int32)
    return Paths(paths.start, paths.end, paths.bulge, numbers)


def shifted_paths(paths: Paths, shift: F64) -> Paths:
    """Return ``paths`` shifted by the vector ``shift``, (2,) mm, with rounded coordinates.

    Coordinates are rounded to nanometres, because the file would otherwise contain numbers such as
    251.00000000000003.
    """
    start, end = (paths.start + shift).round(6), (paths.end + shift).round(6)
    # Adding 0 makes a zero of minus zero.
    return Paths(start + 0.0, end + 0.0, paths.bulge.round(12), paths.first)
