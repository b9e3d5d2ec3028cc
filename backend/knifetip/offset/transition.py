"""transition: the path of the tool's centre around a convex corner.

    vertex, tangent in, tangent out, signed radius, type, k -> lines and arcs from B₀ to E₀

B is an arc around the vertex, which the tool touches all the way.  C continues straight and touches
the vertex only at both ends, but stops at its corners.  D is C with rounded corners: it touches the
vertex only at both ends and does not stop.

Source: "Radius compensation algorithm for convex contour closed-angle linear and circular arc
composite transitional cutting tool" (Dalian Jiaotong University) names and draws the three; the
lengths of D are our derivation from "between B and C".
"""

from __future__ import annotations

import math
from enum import IntEnum
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from knifetip.errors import CompensationError
from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import POINT
from knifetip.kernels import F64_1, F64_2, U8_1, OutF64_2, OutI32_1, kernel


class Corner(IntEnum):
    """Types of transitions at convex corners."""

    B = 0
    C = 1
    D = 2


#: Largest number of segments of a transition.
MOST = 3


def transitions(
    corner: ArrayLike,
    u1: F64,
    u2: F64,
    point: F64,
    radius: ArrayLike,
    side: ArrayLike,
    k: ArrayLike,
) -> Paths:
    """Return the path of the tool's centre around each corner.

    With φ the angle of the corner, relative to the tool, and r the radius::

        B   L = r φ
        C   L = 2 r tan(φ/2)          φ ≤ 90°, else 2 r (1 + sin(φ/2) - cos(φ/2))
        D   l = k r tan(φ/2)          φ ≤ 90°, else k (L_C - L_B) / (2 - φ cot(φ/2))
            r′ = r - l cot(φ/2),  L = 2 l + r′ φ = (1 - k) L_B + k L_C

    Parameters
    ----------
    corner, radius, side, k : (m,) or one for all
        ``Corner``, mm, +1 left of travel or -1 right, and the share of C in D, 0 to 1.
    u1, u2 : (m, 2)
        Directions of travel into and out of the corner.
    point : (m, 2) mm
        The vertex.

    Returns
    -------
    Paths
        m paths.  A corner that is not convex for the tool has no segments.

    Raises
    ------
    CompensationError
        k or the radius is not a number in its range.
    """
    before, after = (
        unit_vectors(np.asarray(u1, np.float64)),
        unit_vectors(np.asarray(u2, np.float64)),
    )
    vertex = np.asarray(point, np.float64)
    count = len(vertex)
    kind = np.broadcast_to(np.asarray(corner, np.uint8), count)
    share = np.broadcast_to(np.asarray(k, np.float64), count)
    size = np.broadcast_to(np.asarray(radius, np.float64), count)
    check(kind, share)
    if not (np.isfinite(size) & (size >= 0.0)).all():
        raise CompensationError("tool.bad-radius")
    signed = size * np.broadcast_to(np.asarray(side, np.float64), count)
    rows = np.empty((MOST * count, 5))
    first = np.zeros(count + 1, np.int32)
    column = np.ascontiguousarray
    _all(column(kind), before, after, column(vertex), signed, column(share), rows, first)
    rows = rows[: first[-1]]
    return Paths(rows[:, :2], rows[:, 2:4], rows[:, 4], first)


def check(corner: Any, k: F64) -> None:
    """Raise if a type is unknown, or a knob that is used is outside 0 … 1."""
    if (np.asarray(corner) > Corner.D).any():
        row = int(np.flatnonzero(np.asarray(corner) > Corner.D)[0])
        raise CompensationError(
            "corner.unknown-number", corner=row, type=int(corner[row]), source=[str(row)]
        )
    wrong = (np.asarray(corner) == Corner.D) & ~((k >= 0.0) & (k <= 1.0))
    if wrong.any():
        row = int(np.flatnonzero(wrong)[0])
        raise CompensationError("corner.bad-share", corner=row, k=f"{k[row]:g}", source=[str(row)])


@kernel(allocates=False)
def _all(
    kind: U8_1,
    u1: F64_2,
    u2: F64_2,
    vertex: F64_2,
    signed: F64_1,
    k: F64_1,
    rows: OutF64_2,
    first: OutI32_1,
) -> None:
    for i in range(len(kind)):
        at = first[i]
        cross = u1[i, 0] * u2[i, 1] - u1[i, 1] * u2[i, 0]
        dot = u1[i, 0] * u2[i, 0] + u1[i, 1] * u2[i, 1]
        if signed[i] != 0.0 and (cross * signed[i] < 0.0 or dot <= -1.0 + 1e-12):
            at = transition(
                kind[i],
                vertex[i, 0],
                vertex[i, 1],
                u1[i, 0],
                u1[i, 1],
                u2[i, 0],
                u2[i, 1],
                signed[i],
                k[i],
                rows,
                at,
            )
        first[i + 1] = at


@kernel(allocates=False)
def quarter_tangent(cross: float, dot: float) -> float:
    """Return tan(φ/4) for 0 ≤ φ ≤ π from sin φ and cos φ."""
    if dot < -0.99:
        # There tan(φ/2) is inaccurate or infinite.
        sin = math.sqrt(0.5 * (1.0 - dot))
        return sin / (1.0 + abs(cross) / (2.0 * sin))
    half = abs(cross) / (1.0 + dot)
    return half / (1.0 + math.sqrt(1.0 + half * half))


@kernel(allocates=False)
def reach(kind: int, cross: float, dot: float, size: float, k: float) -> tuple[float, float]:
    """Return the straight length l and the radius r′ of D; l (r′ = 0) for C, r′ for B.

    For C beyond 90° l is r: the path continues by r, then across.
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
def _put(rows: OutF64_2, at: int, x0: float, y0: float, x1: float, y1: float, bulge: float) -> int:
    rows[at, 0] = x0
    rows[at, 1] = y0
    rows[at, 2] = x1
    rows[at, 3] = y1
    rows[at, 4] = bulge
    return at + 1


@kernel(allocates=False)
def transition(
    kind: int,
    x: float,
    y: float,
    u1x: float,
    u1y: float,
    u2x: float,
    u2y: float,
    signed: float,
    k: float,
    rows: OutF64_2,
    at: int,
) -> int:
    """Write the transition at a convex corner into rows (x0, y0, x1, y1, bulge) from ``at`` on.

    ``signed`` is the radius, positive left of travel.  Returns the next free row.  Transitions with
    pieces shorter than POINT are simplified: C and D to B, D to C.
    """
    size = abs(signed)
    cross = u1x * u2y - u1y * u2x
    dot = u1x * u2x + u1y * u2y
    bx = x - signed * u1y
    by = y + signed * u1x
    ex = x - signed * u2y
    ey = y + signed * u2x
    straight, _ = reach(kind, cross, dot, size, k)
    bulge = -math.copysign(quarter_tangent(cross, dot), signed)
    if straight < POINT:
        return _put(rows, at, bx, by, ex, ey, bulge)
    cx = bx + straight * u1x
    cy = by + straight * u1y
    dx = ex - straight * u2x
    dy = ey - straight * u2y
    gap = math.hypot(dx - cx, dy - cy)
    if gap < POINT:
        at = _put(rows, at, bx, by, cx, cy, 0.0)
        return _put(rows, at, cx, cy, ex, ey, 0.0)
    at = _put(rows, at, bx, by, cx, cy, 0.0)
    at = _put(rows, at, cx, cy, dx, dy, bulge if kind == 2 else 0.0)
    return _put(rows, at, dx, dy, ex, ey, 0.0)
