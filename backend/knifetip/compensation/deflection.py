"""deflection: compensate the deflection of a cutter under load by aiming deeper into the board.

    centre paths, δx, δy -> centre paths        measured points -> δx, δy

A contour that runs at angle a pushes the cutter off it by Δ = σ (−δx sin a, δy cos a), so the
centre is programmed at P + σ diag(r − δx, r − δy) n instead of P + σ r n: that is, every point of
the offset moves by −σ diag(δx, δy) n.  Lines are shifted, arcs become elliptical.

Source: radius paper, eqs 6–12.  The paper does not state the side of the correction; here it is
into the board.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import CompensationError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left, unit
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import BULGE

#: Least Σ sin² to determine δx, and Σ cos² to determine δy: one point within 13° of the axis.
_LEAST: Final = 0.05
#: Largest negative deflection that is taken for a measuring error (mm).
_NOISE: Final = 0.01
#: Largest jump of direction at which shifted neighbours still meet (radians).
_SMOOTH: Final = 1e-7
#: Measured: a biarc deviates from an elliptical arc of sweep φ by |a − b| φ³ divided by this.
_ERROR: Final = 40.0
#: Tolerance of fitted elliptical arcs (mm).
FITTED: Final = 0.0005


def deflection(tangent: F64, side: int, x: float, y: float) -> F64:
    """Return the deflection of the cutter, (n, 2) mm, for tangents (n, 2) of any length.

    Δ = σ (−δx sin a, δy cos a): radius paper, eqs 6–9; its eq 9 prints ΔXmax instead of ΔYmax.
    """
    pushed: F64 = side * np.array([x, y]) * left(unit(tangent))
    return pushed


def programmed_centre(
    point: F64, tangent: F64, side: int, radius: float, x: float, y: float
) -> F64:
    """Return the centre, (n, 2) mm, that cuts the part at points (n, 2) with tangents (n, 2).

    P + σ diag(r − δx, r − δy) n, eq 5 less eq 11.
    """
    return point + side * radius * left(unit(tangent)) - deflection(tangent, side, x, y)


def fit_deflection(tangent: F64, measured: F64, side: int) -> tuple[float, float]:
    """Return δx and δy (mm) from the deflection at one or more points, by least squares.

    ::

        δx = −σ Σ ΔX sin a / Σ sin² a        δy = σ Σ ΔY cos a / Σ cos² a

    For one point this is the solution of eq 10, which divides by sin a₀ and cos a₀.

    Parameters
    ----------
    tangent : (m, 2)
        Of the contour at the measured points, in the direction of travel.
    measured : (m, 2) mm
        ΔX, ΔY: actual position of the cutter minus the intended one.
    side
        σ, +1 with the cutter left of travel, −1 right.

    Raises
    ------
    CompensationError
        The points do not determine δx or δy, are not numbers, or give a deflection *into* the
        board, which means a wrong side or sign.
    """
    if len(tangent) == 0 or not (np.isfinite(tangent).all() and np.isfinite(measured).all()):
        raise CompensationError("calibration.bad-points", count=len(tangent))
    cos, sin = unit(tangent).T
    weight = np.array([(sin * sin).sum(), (cos * cos).sum()])
    for axis, direction, other in ((0, "Y", "δx"), (1, "X", "δy")):
        if weight[axis] < _LEAST:
            along = "X" if axis == 0 else "Y"
            raise CompensationError(
                "calibration.undetermined",
                along=along,
                other=other,
                weight=weight[axis],
                least=_LEAST,
                direction=direction,
            )
    sums = side * np.array([-(measured[:, 0] * sin).sum(), (measured[:, 1] * cos).sum()])
    x, y = (sums / weight).tolist()
    if min(x, y) < -_NOISE:
        raise CompensationError("calibration.wrong-sign", x=x, y=y)
    return max(x, 0.0), max(y, 0.0)


def shift_centres(
    paths: Paths, side: int, x: float, y: float, tolerance: float = FITTED
) -> tuple[Paths, I32]:
    """Return centre paths aimed deeper by the deflection, and the segment of each new one.

    Valid for corner types B, C and D: only the direction of travel of the centre matters, which is
    that of the contour wherever the cutter touches it.  Where the direction jumps, at a bend of
    type C or in an inside corner, neighbours are extended or trimmed to their intersection.

    Parameters
    ----------
    paths
        Offsets: the paths of the cutter's centre.
    side
        σ, +1 with the cutter left of travel, −1 right.
    x, y : mm
        δx, δy.
    tolerance : mm
        Of arcs that are fitted to elliptical arcs.

    Raises
    ------
    CompensationError
        A segment is too short, or an arc too tight, for the deflection.
    """
    if (x == 0.0 and y == 0.0) or len(paths.bulge) == 0:
        return paths, np.arange(len(paths.bulge), dtype=np.int32)
    ways = _Ways(paths, side, x, y)
    low, high = ways.met(paths)
    rows, start, end, bulge = ways.arcs(low, high, abs(x - y), tolerance)
    count = np.bincount(paths.path_of[rows], minlength=len(paths))
    first = np.concatenate([[0], np.cumsum(count)])
    # Neighbours meet within rounding: let them share the same point exactly.
    onward = np.arange(1, len(rows) + 1)
    onward[first[1:] - 1] = np.where(paths.closed, first[:-1], -1)
    end[onward >= 0] = start[onward[onward >= 0]]
    return Paths(start, end, bulge, first), rows.astype(np.int32)


class _Ways:
    """n shifted segments by parameter: mm along a line, the angle of an elliptical arc."""

    def __init__(self, paths: Paths, side: int, x: float, y: float) -> None:
        start, end, bulge = paths.start, paths.end, paths.bulge
        self.curved: Bool = np.abs(bulge) >= BULGE
        ahead, _ = arc.tangents(start, end, bulge)
        self.ahead = unit(ahead)
        self.origin = start - deflection(ahead, side, x, y)
        radius = np.where(self.curved, arc.radius(start, end, bulge), 0.0)
        middle = np.where(self.curved[:, None], arc.centre(start, end, bulge), 0.0)
        # n points away from the centre for an arc to the right, towards it for one to the left.
        outward = side * np.sign(bulge)
        self.half = radius[:, None] + outward[:, None] * np.array([x, y])
        tight = self.curved & (self.half <= 0.0).any(axis=1)
        if tight.any():
            row = int(np.argmax(tight))
            raise CompensationError(
                "deflection.arc-too-small",
                radius=radius[row],
                x=start[row, 0],
                y=start[row, 1],
                deflection=max(x, y),
            )
        self.middle = middle
        first = np.arctan2(*(start - middle).T[::-1])
        self.low = np.where(self.curved, first, 0.0)
        along = np.where(self.curved, arc.sweep(bulge), np.hypot(*(end - start).T))
        self.high = self.low + along

    def point(self, row: I32, t: F64) -> F64:
        cos, sin = np.cos(t), np.sin(t)
        turned = self.middle[row] + self.half[row] * np.column_stack([cos, sin])
        straight = self.origin[row] + self.ahead[row] * t[:, None]
        result: F64 = np.where(self.curved[row, None], turned, straight)
        return result

    def slope(self, row: I32, t: F64) -> F64:
        turned = self.half[row] * np.column_stack([-np.sin(t), np.cos(t)])
        result: F64 = np.where(self.curved[row, None], turned, self.ahead[row])
        return result

    def met(self, paths: Paths) -> tuple[F64, F64]:
        """Return the parameters of start and end of each segment at which neighbours meet."""
        low, high = self.low.copy(), self.high.copy()
        ahead, arriving = arc.tangents(paths.start, paths.end, paths.bulge)
        first, last = paths.first[:-1], paths.first[1:] - 1
        before = np.arange(len(paths.bulge)) - 1
        before[first] = np.where(paths.closed, last, -1)
        after = np.flatnonzero(before >= 0)
        before = before[after]
        u, v = unit(arriving[before]), unit(ahead[after])
        jump = np.arctan2(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0], (u * v).sum(axis=1))
        jumps = np.abs(jump) > _SMOOTH
        before, after = before[jumps].astype(np.int32), after[jumps].astype(np.int32)
        a, b = high[before].copy(), low[after].copy()
        gap = np.zeros((len(a), 2))
        # Newton iteration in two parameters; exact after one step for lines.
        for _ in range(8):
            gap = self.point(after, b) - self.point(before, a)
            p, q = self.slope(before, a), self.slope(after, b)
            area = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
            area = np.where(np.abs(area) > 1e-12, area, np.inf)
            a += (gap[:, 0] * q[:, 1] - gap[:, 1] * q[:, 0]) / area
            b += (gap[:, 0] * p[:, 1] - gap[:, 1] * p[:, 0]) / area
        high[before], low[after] = a, b
        gap = self.point(after, b) - self.point(before, a)
        lost = np.zeros(len(low), np.bool_)
        lost[after[~(np.hypot(*gap.T) < 1e-9)]] = True
        lost |= (high - low) * (self.high - self.low) <= 0.0
        if lost.any():
            row = int(np.argmax(lost))
            place = paths.start[row]
            raise CompensationError("deflection.path-too-short", x=place[0], y=place[1])
        return low, high

    def arcs(
        self, low: F64, high: F64, uneven: float, tolerance: float
    ) -> tuple[I32, F64, F64, F64]:
        """Return lines and arcs: segment, start, end and bulge of each."""
        sweep = np.where(self.curved, np.abs(high - low), 0.0)
        longest = np.cbrt(_ERROR * tolerance / max(uneven, 1e-12))
        # One bulge covers at most half a turn; a biarc halves it again.
        pieces = np.maximum(np.ceil(sweep / min(longest, np.pi / 2.0)), 1.0).astype(np.int64)
        row = np.repeat(np.arange(len(low), dtype=np.int32), pieces)
        place = np.arange(len(row)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
        step = ((high - low) / pieces)[row]
        t = low[row] + step * place
        a, b = self.point(row, t), self.point(row, t + step)
        sign = np.where(self.curved[row], np.sign(step), 1.0)[:, None]
        u, v = unit(sign * self.slope(row, t)), unit(sign * self.slope(row, t + step))
        # Biarc with equal tangent lengths d: |c|² − 2 d c·(u + v) − 2 d² (1 − u·v) = 0.
        chord = b - a
        square = (chord * chord).sum(axis=1)
        lean = (chord * (u + v)).sum(axis=1)
        open_ = 2.0 * (1.0 - (u * v).sum(axis=1))
        d = (square / (lean + np.sqrt(lean * lean + open_ * square)))[:, None]
        joint = (a + d * u + b - d * v) / 2.0
        double = self.curved[row]
        which = np.repeat(np.arange(len(row)), np.where(double, 2, 1))
        second = np.concatenate([[False], which[1:] == which[:-1]])
        halved = double[which]
        start = np.where(second[:, None], joint[which], a[which])
        end = np.where((halved & ~second)[:, None], joint[which], b[which])
        bulge = np.where(second, _half_angle(b - joint, v)[which], _half_angle(u, joint - a)[which])
        return row[which], start, end, np.where(halved, bulge, 0.0)


def _half_angle(before: F64, after: F64) -> F64:
    """Return tan of half the angle between two vectors: the bulge, from tangent and chord."""
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    dot = (before * after).sum(axis=1)
    result: F64 = cross / (np.hypot(cross, dot) + dot)
    return result
