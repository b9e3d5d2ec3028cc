"""transition: the path of the tool's centre around a convex corner.

A transition leads from the point B₀ to the point E₀.  At B₀ the tool touches the end of the segment
before the corner, at E₀ the start of the segment after the corner.  Type B is an arc around the
vertex of the corner, and the tool touches the vertex on the whole arc.  Type C consists of two or
three lines with a stop at each bend between them.  Type D is a line, an arc and a line, without a
stop.  In types C and D the tool touches the vertex only at B₀ and E₀.

Source: "Radius compensation algorithm for convex contour closed-angle linear and circular arc
composite transitional cutting tool" (Dalian Jiaotong University) names and draws the three types;
the lengths of D are our derivation from "between B and C".
"""

from __future__ import annotations

import math
from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from knifetip.errors import CompensationError
from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import POINT
from knifetip.kernels import F64_1, F64_2, U8_1, OutF64_2, OutI32_1, kernel


class Corner(IntEnum):
    """Type of the tool's path round a convex corner: B, C or D."""

    B = 0
    C = 1
    D = 2


class ContourVertex(NamedTuple):
    """A vertex of a contour, and the unit tangents into and out of it."""

    x: float  #: mm
    y: float  #: mm
    u1x: float  #: x of the tangent into it
    u1y: float
    u2x: float  #: x of the tangent out of it
    u2y: float


#: Largest number of segments of a transition.
MAX_SEGMENTS = 3


def transitions(
    corner: ArrayLike,
    u1: F64,
    u2: F64,
    point: F64,
    radius: ArrayLike,
    side: ArrayLike,
    k: ArrayLike,
) -> Paths:
    """Return the path of the tool's centre around each of m corners.

    With φ the angle of the corner, r the radius of the tool and L the length of the path, for the
    types B, C and D::

        B   L = r φ
        C   L = 2 r tan(φ/2)          φ ≤ 90°, else 2 r (1 + sin(φ/2) - cos(φ/2))
        D   l = k r tan(φ/2)          φ ≤ 90°, else k (L_C - L_B) / (2 - φ cot(φ/2))
            r′ = r - l cot(φ/2),  L = 2 l + r′ φ = (1 - k) L_B + k L_C

    Type D has two straight parts of the length l and an arc of the radius r′ between them; L_B and
    L_C are the lengths of the types B and C.

    Parameters
    ----------
    corner : (m,) or one for all
        ``Corner`` type.
    u1, u2 : (m, 2)
        Directions of travel into and out of the corner.
    point : (m, 2) mm
        Vertex of each corner.
    radius : (m,) mm, or one for all
        Radius r of the tool.
    side : (m,) or one for all
        +1 with the tool left of travel, -1 right.
    k : (m,) or one for all
        Parameter of type D, 0 (as B) to 1 (as C).

    Returns
    -------
    Paths
        m paths.  A corner that is not convex for the tool has no segments.

    Raises
    ------
    CompensationError
        k or the radius is not a number in its range.
    """
    previous, next_ = (
        unit_vectors(np.asarray(u1, np.float64)),
        unit_vectors(np.asarray(u2, np.float64)),
    )
    vertex = np.asarray(point, np.float64)
    count = len(vertex)
    kind = np.broadcast_to(np.asarray(corner, np.uint8), count)
    k_values = np.broadcast_to(np.asarray(k, np.float64), count)
    size = np.broadcast_to(np.asarray(radius, np.float64), count)
    check_corners(kind, k_values)
    if not (np.isfinite(size) & (size >= 0.0)).all():
        raise CompensationError("tool.bad-radius")
    signed = size * np.broadcast_to(np.asarray(side, np.float64), count)
    rows = np.empty((MAX_SEGMENTS * count, 5))
    first = np.zeros(count + 1, np.int32)
    column = np.ascontiguousarray
    _write_transitions(
        column(kind), previous, next_, column(vertex), signed, column(k_values), rows, first
    )
    rows = rows[: first[-1]]
    return Paths(rows[:, :2], rows[:, 2:4], rows[:, 4], first)


def check_corners(corner: Any, k: F64) -> None:
    """Raise an error if a corner type is unknown, or the k of a D corner is not in 0 … 1."""
    if (np.asarray(corner) > Corner.D).any():
        row = int(np.flatnonzero(np.asarray(corner) > Corner.D)[0])
        raise CompensationError(
            "corner.unknown-number", corner=row, type=int(corner[row]), at_edges=[row]
        )
    wrong = (np.asarray(corner) == Corner.D) & ~((k >= 0.0) & (k <= 1.0))
    if wrong.any():
        row = int(np.flatnonzero(wrong)[0])
        raise CompensationError("corner.bad-share", corner=row, k=f"{k[row]:g}", at_edges=[row])


@kernel(allocates=False)
def _write_transitions(
    kind: U8_1,
    u1: F64_2,
    u2: F64_2,
    point: F64_2,
    signed: F64_1,
    k: F64_1,
    rows: OutF64_2,
    first: OutI32_1,
) -> None:
    """Write the transitions at m corners to ``rows`` (x0, y0, x1, y1, bulge).

    A transition is the path of the tool's centre round a convex corner.

    ``kind``, ``k`` (m,): ``Corner`` type of each corner, and the parameter of type D, 0 … 1.
    ``u1``, ``u2`` (m, 2): unit tangents into and out of each corner.
    ``point`` (m, 2) mm: vertex of each corner.
    ``signed`` (m,) mm: radius of the tool, positive left of travel.
    ``first`` (m + 1,): gets the index of the first row of each corner, then the total number of
    rows.
    """
    for i in range(len(kind)):
        next_row = first[i]
        cross = u1[i, 0] * u2[i, 1] - u1[i, 1] * u2[i, 0]
        dot = u1[i, 0] * u2[i, 0] + u1[i, 1] * u2[i, 1]
        if signed[i] != 0.0 and (cross * signed[i] < 0.0 or dot <= -1.0 + 1e-12):
            vertex = ContourVertex(point[i, 0], point[i, 1], u1[i, 0], u1[i, 1], u2[i, 0], u2[i, 1])
            next_row = write_transition(kind[i], k[i], vertex, signed[i], rows, next_row)
        first[i + 1] = next_row


@kernel(allocates=False)
def quarter_tangent(cross: float, dot: float) -> float:
    """Return tan(φ/4) of an angle 0 ≤ φ ≤ π.

    ``cross`` is the sine of φ with either sign, and ``dot`` is the cosine of φ.
    """
    if dot < -0.99:
        # There tan(φ/2) is inaccurate or infinite.
        sin = math.sqrt(0.5 * (1.0 - dot))
        return sin / (1.0 + abs(cross) / (2.0 * sin))
    half = abs(cross) / (1.0 + dot)
    return half / (1.0 + math.sqrt(1.0 + half * half))


@kernel(allocates=False)
def straight_and_radius(
    kind: int, cross: float, dot: float, size: float, k: float
) -> tuple[float, float]:
    """Return the length of the straight parts and the radius of the arc of a transition (mm).

    The length is 0 for type B, the radius is 0 for type C.  For type C beyond 90° the straight
    parts are as long as the radius of the tool, and a third line connects them.

    Parameters
    ----------
    kind
        ``Corner`` type.
    cross, dot
        Sine, of either sign, and cosine of the corner's angle φ.
    size : mm
        Radius of the tool.
    k
        Parameter of type D.
    """
    if kind == 0:
        return 0.0, size
    if kind == 1:
        return (size * abs(cross) / (1.0 + dot) if dot >= 0.0 else size), 0.0
    if dot >= 0.0:
        return k * size * abs(cross) / (1.0 + dot), (1.0 - k) * size
    phi = math.atan2(abs(cross), dot)
    sin, cos = math.sin(phi / 2.0), math.cos(phi / 2.0)
    more = 2.0 * (1.0 + sin - cos) - phi
    straight = k * size * more / (2.0 - phi * cos / sin)
    return straight, size - straight * cos / sin


@kernel(allocates=False)
def _write_row(
    rows: OutF64_2, row: int, x0: float, y0: float, x1: float, y1: float, bulge: float
) -> int:
    """Write the segment (x0, y0, x1, y1, bulge) to a row of ``rows``; return the next row.

    ``row`` is the index of the row.
    """
    rows[row, 0] = x0
    rows[row, 1] = y0
    rows[row, 2] = x1
    rows[row, 3] = y1
    rows[row, 4] = bulge
    return row + 1


@kernel(allocates=False)
def write_transition(
    kind: int, k: float, vertex: ContourVertex, signed: float, rows: OutF64_2, row: int
) -> int:
    """Write the transition at a convex corner to ``rows`` (x0, y0, x1, y1, bulge) from ``row`` on.

    If a segment would be shorter than ``tolerance.POINT``, type C is replaced by B, and type D by C
    or B.

    Parameters
    ----------
    kind, k
        ``Corner`` type, and the parameter of type D.
    vertex
        Vertex of the corner.
    signed : mm
        Radius of the tool, positive left of travel.

    Returns
    -------
    The next free row.
    """
    x, y, u1x, u1y, u2x, u2y = vertex
    size = abs(signed)
    cross = u1x * u2y - u1y * u2x
    dot = u1x * u2x + u1y * u2y
    bx = x - signed * u1y
    by = y + signed * u1x
    ex = x - signed * u2y
    ey = y + signed * u2x
    straight, _ = straight_and_radius(kind, cross, dot, size, k)
    bulge = -math.copysign(quarter_tangent(cross, dot), signed)
    if straight < POINT:
        return _write_row(rows, row, bx, by, ex, ey, bulge)
    cx = bx + straight * u1x
    cy = by + straight * u1y
    dx = ex - straight * u2x
    dy = ey - straight * u2y
    gap = math.hypot(dx - cx, dy - cy)
    if gap < POINT:
        row = _write_row(rows, row, bx, by, cx, cy, 0.0)
        return _write_row(rows, row, cx, cy, ex, ey, 0.0)
    row = _write_row(rows, row, bx, by, cx, cy, 0.0)
    row = _write_row(rows, row, cx, cy, dx, dy, bulge if kind == 2 else 0.0)
    return _write_row(rows, row, dx, dy, ex, ey, 0.0)
