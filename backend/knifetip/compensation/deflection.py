"""deflection: compensate the deflection of a cutter by moving its path towards the contour.

A contour that runs at azimuth a pushes the cutter away from it by Δ = σ (−δx sin a, δy cos a), with
δx and δy the largest deflections along X and Y, and σ = +1 if the cutter is left of travel, −1 if
right.  So for a contour point P with left normal n and a cutter of radius r, the centre is
programmed at P + σ diag(r − δx, r − δy) n instead of P + σ r n: every point of the offset moves by
−σ diag(δx, δy) n.  Lines are shifted, arcs become elliptical.

Source: the paper "Tool radius compensation", eqs 6–12.  The paper does not state in which direction
to correct; here the path moves towards the contour.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import CompensationError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, tan_half_angle, unit_vectors
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import BULGE

#: Least Σ sin² to determine δx, and Σ cos² to determine δy: one point within 13° of the axis.
_MIN_WEIGHT: Final = 0.05
#: Largest negative deflection that is taken for a measuring error (mm).
_MAX_NEGATIVE: Final = 0.01
#: Largest jump of direction that keeps shifted neighbours connected (radians).
_MIN_JUMP: Final = 1e-7
#: A biarc deviates from an elliptical arc with half axes a and b and sweep φ by |a − b| φ³
#: divided by this number, as measured.
_BIARC_ERROR: Final = 40.0
#: Default tolerance of arcs fitted to elliptical arcs (mm).
FIT_TOLERANCE: Final = 0.0005


def deflection_at(tangent: F64, side: int, x: float, y: float) -> F64:
    """Return the deflection of a cutter, (n, 2) mm, at points of contours with given tangents.

    Δ = σ (−δx sin a, δy cos a): "Tool radius compensation", eqs 6–9, where ΔXmax in eq 9 is a
    misprint for ΔYmax.

    Parameters
    ----------
    tangent : (n, 2)
        Directions of travel, of any length; a is their azimuth.
    side
        σ, +1 if the cutter is left of travel, −1 if right.
    x, y : mm
        δx, δy: largest deflections along X and Y.
    """
    displacement: F64 = side * np.array([x, y]) * left_normal(unit_vectors(tangent))
    return displacement


def programmed_centre(
    point: F64, tangent: F64, side: int, radius: float, x: float, y: float
) -> F64:
    """Return the positions of a cutter's centre that cut given contour points, (n, 2) mm.

    P + σ diag(r − δx, r − δy) n with n the left normal: eq 5 minus eq 11 of "Tool radius
    compensation".

    Parameters
    ----------
    point : (n, 2) mm
        P, points of the contour.
    tangent : (n, 2)
        Directions of travel at the points.
    side
        σ, +1 if the cutter is left of travel, −1 if right.
    radius : mm
        r, radius of the cutter.
    x, y : mm
        δx, δy: largest deflections along X and Y.
    """
    return (
        point
        + side * radius * left_normal(unit_vectors(tangent))
        - deflection_at(tangent, side, x, y)
    )


def fit_deflection(tangent: F64, measured: F64, side: int) -> tuple[float, float]:
    """Return δx and δy (mm), the largest deflections along X and Y, fitted to measured points.

    With a the azimuth of the contour at a point, least squares give::

        δx = −σ Σ ΔX sin a / Σ sin² a        δy = σ Σ ΔY cos a / Σ cos² a

    For one point at azimuth a₀ this is the solution of eq 10 of "Tool radius compensation", which
    divides by sin a₀ and cos a₀.

    Parameters
    ----------
    tangent : (m, 2)
        Tangents of the contour at the measured points, in the direction of travel.
    measured : (m, 2) mm
        ΔX, ΔY: actual position of the cutter minus the intended position.
    side
        σ, +1 if the cutter is left of travel, −1 if right.

    Raises
    ------
    CompensationError
        The points do not determine δx or δy, or are not numbers.  Or δx or δy is clearly
        negative, as if the contour pulled the cutter towards it; then the side or a sign is wrong.
    """
    if len(tangent) == 0 or not (np.isfinite(tangent).all() and np.isfinite(measured).all()):
        raise CompensationError("calibration.bad-points", count=len(tangent))
    cos, sin = unit_vectors(tangent).T
    weight = np.array([(sin * sin).sum(), (cos * cos).sum()])
    for axis, direction, other in ((0, "Y", "δx"), (1, "X", "δy")):
        if weight[axis] < _MIN_WEIGHT:
            along = "X" if axis == 0 else "Y"
            raise CompensationError(
                "calibration.undetermined",
                along=along,
                other=other,
                weight=weight[axis],
                least=_MIN_WEIGHT,
                direction=direction,
            )
    sums = side * np.array([-(measured[:, 0] * sin).sum(), (measured[:, 1] * cos).sum()])
    x, y = (sums / weight).tolist()
    if min(x, y) < -_MAX_NEGATIVE:
        raise CompensationError("calibration.wrong-sign", x=x, y=y)
    return max(x, 0.0), max(y, 0.0)


def shift_centres(
    paths: Paths, side: int, x: float, y: float, tolerance: float = FIT_TOLERANCE
) -> tuple[Paths, I32]:
    """Return paths of a cutter's centre, moved towards the contours to compensate the deflection.

    The paths may go round corners on arcs or on lines (types B, C and D).  The shift of a point
    depends only on the direction of the path there.  Where the direction jumps, as at the bend of a
    corner of type C or at an inside corner, the two neighbouring segments are extended or trimmed
    to their intersection.

    Parameters
    ----------
    paths
        Offsets of the contours: paths of the cutter's centre without deflection.
    side
        σ, +1 if the cutter is left of travel, −1 if right.
    x, y : mm
        δx, δy: largest deflections along X and Y.
    tolerance : mm
        Largest distance of the returned arcs from the exact elliptical arcs.

    Returns
    -------
    paths : Paths
        Shifted paths with m segments.
    rows : (m,)
        For each shifted segment, the index of the segment of the given ``paths`` that was shifted.

    Raises
    ------
    CompensationError
        A segment is too short, or the radius of an arc too small, for the deflection.
    """
    if (x == 0.0 and y == 0.0) or len(paths.bulge) == 0:
        return paths, np.arange(len(paths.bulge), dtype=np.int32)
    shifted = _ShiftedSegments(paths, side, x, y)
    low, high = shifted.intersect_neighbours(paths)
    rows, start, end, bulge = shifted.to_arcs(low, high, abs(x - y), tolerance)
    count = np.bincount(paths.path_of[rows], minlength=len(paths))
    first = np.concatenate([[0], np.cumsum(count)])
    # Neighbours meet within rounding; make their common point exactly equal.
    successor = np.arange(1, len(rows) + 1)
    successor[first[1:] - 1] = np.where(paths.closed, first[:-1], -1)
    end[successor >= 0] = start[successor[successor >= 0]]
    return Paths(start, end, bulge, first), rows.astype(np.int32)


class _ShiftedSegments:
    """Paths of a cutter's centre, shifted by its deflection: lines and elliptical arcs.

    A position on a segment is given by a parameter t: mm along a line, or the angle of an
    elliptical arc in radians.
    """

    def __init__(self, paths: Paths, side: int, x: float, y: float) -> None:
        start, end, bulge = paths.start, paths.end, paths.bulge
        self.curved: Bool = np.abs(bulge) >= BULGE
        ahead, _ = arc.tangents(start, end, bulge)
        self.ahead = unit_vectors(ahead)
        self.origin = start - deflection_at(ahead, side, x, y)
        radius = np.where(self.curved, arc.radius(start, end, bulge), 0.0)
        middle = np.where(self.curved[:, None], arc.centre(start, end, bulge), 0.0)
        # The left normal points away from the centre of a right-hand arc, towards that of a left
        # one.
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
        """Return one point of each of m segments, (m, 2) mm.

        ``row`` (m,) are the indices of the segments, and ``t`` (m,) is the parameter of the point.
        """
        cos, sin = np.cos(t), np.sin(t)
        turned = self.middle[row] + self.half[row] * np.column_stack([cos, sin])
        straight = self.origin[row] + self.ahead[row] * t[:, None]
        result: F64 = np.where(self.curved[row, None], turned, straight)
        return result

    def slope(self, row: I32, t: F64) -> F64:
        """Return the tangent at one point of each of m segments, (m, 2).

        The tangent is the derivative of the point with respect to its parameter.  ``row`` (m,) are
        the indices of the segments, and ``t`` (m,) is the parameter of the point.
        """
        turned = self.half[row] * np.column_stack([-np.sin(t), np.cos(t)])
        result: F64 = np.where(self.curved[row, None], turned, self.ahead[row])
        return result

    def intersect_neighbours(self, paths: Paths) -> tuple[F64, F64]:
        """Return the parameters at which each of n shifted segments starts and ends, (n,) each.

        If the direction jumps from one segment of a path to the next, the shifted segments do
        not meet.  There, the first one ends and the second one starts at their intersection.
        All other starts and ends are unchanged.  ``paths`` contains the segments before the shift.

        Raises
        ------
        CompensationError
            Two neighbouring segments do not intersect, or nothing remains of a segment.
        """
        low, high = self.low.copy(), self.high.copy()
        ahead, arriving = arc.tangents(paths.start, paths.end, paths.bulge)
        first, last = paths.first[:-1], paths.first[1:] - 1
        before = np.arange(len(paths.bulge)) - 1
        before[first] = np.where(paths.closed, last, -1)
        after = np.flatnonzero(before >= 0)
        before = before[after]
        u, v = unit_vectors(arriving[before]), unit_vectors(ahead[after])
        jump = np.arctan2(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0], (u * v).sum(axis=1))
        jumps = np.abs(jump) > _MIN_JUMP
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
        failed = np.zeros(len(low), np.bool_)
        failed[after[~(np.hypot(*gap.T) < 1e-9)]] = True
        failed |= (high - low) * (self.high - self.low) <= 0.0
        if failed.any():
            row = int(np.argmax(failed))
            place = paths.start[row]
            raise CompensationError("deflection.path-too-short", x=place[0], y=place[1])
        return low, high

    def to_arcs(
        self, low: F64, high: F64, difference: float, tolerance: float
    ) -> tuple[I32, F64, F64, F64]:
        """Return the parts of the segments between two parameters as lines and circular arcs.

        Parameters
        ----------
        low, high : (n,)
            Parameters at the start and the end of each segment.
        difference : mm
            |δx − δy|, the difference of the half axes of the elliptical arcs.
        tolerance : mm
            Largest distance of the circular arcs from the elliptical arcs.

        Returns
        -------
        row : (m,)
            Segment of which each of m lines and arcs is a part.
        start, end, bulge : (m, 2) mm, (m, 2) mm and (m,)
            Ends and bulges of the lines and arcs.
        """
        sweep = np.where(self.curved, np.abs(high - low), 0.0)
        longest = np.cbrt(_BIARC_ERROR * tolerance / max(difference, 1e-12))
        # One bulge covers at most half a turn; a biarc halves it again.
        pieces = np.maximum(np.ceil(sweep / min(longest, np.pi / 2.0)), 1.0).astype(np.int64)
        row = np.repeat(np.arange(len(low), dtype=np.int32), pieces)
        place = np.arange(len(row)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
        step = ((high - low) / pieces)[row]
        t = low[row] + step * place
        a, b = self.point(row, t), self.point(row, t + step)
        sign = np.where(self.curved[row], np.sign(step), 1.0)[:, None]
        u, v = (
            unit_vectors(sign * self.slope(row, t)),
            unit_vectors(sign * self.slope(row, t + step)),
        )
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
        bulge = np.where(
            second, tan_half_angle(b - joint, v)[which], tan_half_angle(u, joint - a)[which]
        )
        return row[which], start, end, np.where(halved, bulge, 0.0)
