"""deflection: compensate the deflection of a cutter by moving its path towards the contour.

A contour that runs at azimuth a pushes the cutter away from it by Δ = σ (−δx sin a, δy cos a), with
δx and δy the largest deflections along X and Y, and σ = +1 if the cutter is left of travel, −1 if
right.  So for a contour point P with left normal n and a cutter of radius r, the centre is
programmed at P + σ diag(r − δx, r − δy) n instead of P + σ r n: every point of the offset moves by
−σ diag(δx, δy) n.  Lines are shifted, arcs become elliptical.  The mean of δx and δy is taken off
the radius before the offset; the shift has the difference of δx and δy from their mean, of which
one is negative.

Source: the paper "Tool radius compensation", eqs 6–12.  The paper does not state in which direction
to correct; here the path moves towards the contour.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import CompensationError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, tan_half_angle, unit_vectors
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import BULGE, POINT

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
    to their intersection.  A segment of which nothing is left is dropped, and a path of which
    nothing is left, too.

    Parameters
    ----------
    paths
        Offsets of the contours: paths of the cutter's centre without deflection.
    side
        σ, +1 if the cutter is left of travel, −1 if right.
    x, y : mm
        δx, δy: largest deflections along X and Y; a negative value moves the path away from the
        contours.
    tolerance : mm
        Largest distance of the returned arcs from the exact elliptical arcs.

    Returns
    -------
    paths : Paths
        Shifted paths with m segments.
    rows : (m,)
        For each shifted segment, the index of the segment of the given ``paths`` that was shifted.
    """
    if (x == 0.0 and y == 0.0) or len(paths.bulge) == 0:
        return paths, np.arange(len(paths.bulge), dtype=np.int32)
    shifted = _ShiftedSegments(paths, side, x, y)
    segment, low, high = shifted.intersect_neighbours(paths)
    rows, start, end, bulge = shifted.to_arcs(segment, low, high, abs(x - y), tolerance)
    count = np.bincount(paths.path_of[rows], minlength=len(paths))
    remains = count > 0
    first = np.concatenate([[0], np.cumsum(count[remains])])
    # Neighbours meet within rounding; make their common point exactly equal.
    successor = np.arange(1, len(rows) + 1)
    successor[first[1:] - 1] = np.where(paths.closed[remains], first[:-1], -1)
    end[successor >= 0] = start[successor[successor >= 0]]
    return Paths(start, end, bulge, first), rows.astype(np.int32)


def _has_jump(paths: Paths, before: I32, after: I32) -> Bool:
    """Return whether the direction jumps from one segment to the next, for m pairs, (m,).

    ``before`` (m,) and ``after`` (m,) are the indices of the segments of each pair.
    """
    ahead, arriving = arc.tangents(paths.start, paths.end, paths.bulge)
    u, v = unit_vectors(arriving[before]), unit_vectors(ahead[after])
    turn = np.arctan2(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0], (u * v).sum(axis=1))
    jump: Bool = np.abs(turn) > _MIN_JUMP
    return jump


def _first_to_vanish(rows: I64, left: F64, before: I32, following: I32) -> I32:
    """Return those of k segments that shrink to nothing before their neighbours do.

    ``rows`` (k,): indices of segments that have no length left after the shift.
    ``left`` (n,): length of each segment after the shift, divided by its length before; negative
    for a segment that ends before it starts.  The smaller this quotient is, the sooner during the
    shift no length is left.
    ``before``, ``following`` (n,): neighbours of each segment, -1 for none.
    """
    # The last entry is the rank of a neighbour that does not exist or is not among the segments.
    rank = np.full(len(left) + 1, len(rows))
    rank[rows[np.argsort(left[rows], kind="stable")]] = np.arange(len(rows))
    own = rank[rows]
    first = (own <= rank[before[rows]]) & (own <= rank[following[rows]])
    result: I32 = rows[first].astype(np.int32)
    return result


class _ShiftedSegments:
    """Paths of a cutter's centre, shifted by its deflection: lines and elliptical arcs.

    A position on a segment is given by a parameter t: mm along a line, or the angle of an
    elliptical arc in radians.
    """

    def __init__(self, paths: Paths, side: int, x: float, y: float) -> None:
        start, end, bulge = paths.start, paths.end, paths.bulge
        self.curved: Bool = np.abs(bulge) >= BULGE
        ahead, arriving = arc.tangents(start, end, bulge)
        self.origin = start - deflection_at(ahead, side, x, y)
        radius = np.where(self.curved, arc.radius(start, end, bulge), 0.0)
        # The left normal points away from the centre of a right-hand arc, towards that of a left
        # one.
        outward = side * np.sign(bulge)
        self.half = radius[:, None] + outward[:, None] * np.array([x, y])
        # An arc with a smaller radius than the shift becomes the line between its shifted ends.
        tight = self.curved & (self.half <= 0.0).any(axis=1)
        chord = end - deflection_at(arriving, side, x, y) - self.origin
        ahead = np.where((tight & (np.hypot(*chord.T) > POINT))[:, None], chord, ahead)
        self.ahead = unit_vectors(ahead)
        along = np.where(tight, np.maximum(np.hypot(*chord.T), POINT), np.hypot(*(end - start).T))
        self.curved &= ~tight
        self.middle = np.where(self.curved[:, None], arc.centre(start, end, bulge), 0.0)
        first = np.arctan2(*(start - self.middle).T[::-1])
        self.low = np.where(self.curved, first, 0.0)
        self.high = self.low + np.where(self.curved, arc.sweep(bulge), along)

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

    def intersect_neighbours(self, paths: Paths) -> tuple[I32, F64, F64]:
        """Intersect neighbouring segments where the direction jumps, and drop reversed segments.

        If the direction jumps from one segment of a path to the next, the shifted segments do not
        meet.  There, the first one ends and the second one starts at their intersection.  A segment
        that would end before it starts is dropped, and its neighbours are intersected instead.  Of
        neighbours that both would, the one that has no length left after the smaller part of the
        shift is dropped first.  All other starts and ends are unchanged.

        ``paths``: the n segments before the shift.
        Returns ``rows`` (m,): indices of the segments that are not dropped; ``low, high`` (m,):
        parameters at which these segments start and end after the shift.
        """
        low, high = self.low.copy(), self.high.copy()
        count = len(low)
        kept = np.ones(count, np.bool_)
        before = np.arange(-1, count - 1, dtype=np.int32)
        last = paths.first[1:] - 1
        before[paths.first[:-1]] = np.where(paths.closed, last, -1)
        following = np.full(count, -1, np.int32)
        following[before[before >= 0]] = np.flatnonzero(before >= 0)
        joints = np.flatnonzero(before >= 0).astype(np.int32)
        joints = joints[_has_jump(paths, before[joints], joints)]
        length = self._length(np.arange(count, dtype=np.int32))
        while True:
            previous = before[joints]
            high[previous], low[joints], met = self._intersect(previous, joints)
            left = (high - low) / (self.high - self.low)
            # Where two segments do not meet, the shift has consumed the shorter one.
            shorter = length[previous] < length[joints]
            left[np.where(shorter, previous, joints)[~met]] = -np.inf
            dropped = _first_to_vanish(
                np.flatnonzero(kept & (left * length <= POINT)), left, before, following
            )
            if len(dropped) == 0:
                break
            kept[dropped] = False
            one, other = before[dropped], following[dropped]
            alone = (one == other) & (one >= 0)
            kept[one[alone]] = False
            following[one[one >= 0]] = other[one >= 0]
            before[other[other >= 0]] = one[other >= 0]
            high[one[one >= 0]] = self.high[one[one >= 0]]
            low[other[other >= 0]] = self.low[other[other >= 0]]
            joints = other[(one >= 0) & (other >= 0) & ~alone]
        rows = np.flatnonzero(kept).astype(np.int32)
        return rows, low[rows], high[rows]

    def _length(self, row: I32) -> F64:
        """Return the approximate lengths of m segments before the shift, (m,) mm.

        ``row`` (m,) are the indices of the segments.
        """
        size = np.abs(self.high[row] - self.low[row])
        length: F64 = np.where(self.curved[row], size * self.half[row].max(axis=1), size)
        return length

    def _intersect(self, before: I32, after: I32) -> tuple[F64, F64, Bool]:
        """Return the intersections of m pairs of shifted segments, extended beyond their ends.

        ``before``, ``after`` (m,): indices of the first and of the second segment of each pair.
        Returns ``a, b`` (m,): parameter of the intersection on the first and on the second segment;
        ``met`` (m,): whether the two segments intersect.
        """
        a, b = self.high[before].copy(), self.low[after].copy()
        gap = np.zeros((len(a), 2))
        # Newton iteration in two parameters; exact after one step for lines.
        for _ in range(8):
            gap = self.point(after, b) - self.point(before, a)
            p, q = self.slope(before, a), self.slope(after, b)
            area = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
            area = np.where(np.abs(area) > 1e-12, area, np.inf)
            a += (gap[:, 0] * q[:, 1] - gap[:, 1] * q[:, 0]) / area
            b += (gap[:, 0] * p[:, 1] - gap[:, 1] * p[:, 0]) / area
        gap = self.point(after, b) - self.point(before, a)
        u = self.ahead[before]
        # Lines one behind the other have no intersection, and need none.
        aligned = ~self.curved[before] & ~self.curved[after]
        aligned &= (u * self.ahead[after]).sum(axis=1) > 1.0 - 1e-15
        aligned &= np.abs(gap[:, 0] * u[:, 1] - gap[:, 1] * u[:, 0]) < POINT
        met = aligned | (np.hypot(*gap.T) < 1e-9)
        # An arc is extended by less than half a turn.
        met &= ~self.curved[before] | (np.abs(a - self.high[before]) < np.pi)
        met &= ~self.curved[after] | (np.abs(b - self.low[after]) < np.pi)
        return a, b, met

    def to_arcs(
        self, segment: I32, low: F64, high: F64, difference: float, tolerance: float
    ) -> tuple[I32, F64, F64, F64]:
        """Return the parts of k segments between two parameters as lines and circular arcs.

        ``segment`` (k,): indices of the segments.
        ``low``, ``high`` (k,): parameters at the start and the end of each of them.
        ``difference`` mm: |δx − δy|, the difference of the half axes of the elliptical arcs.
        ``tolerance`` mm: largest distance of the circular arcs from the elliptical arcs.
        Returns ``row`` (m,): segment of which each of m lines and arcs is a part; ``start, end,
        bulge`` (m, 2) mm, (m, 2) mm and (m,): ends and bulges of the lines and arcs.
        """
        sweep = np.where(self.curved[segment], np.abs(high - low), 0.0)
        longest = np.cbrt(_BIARC_ERROR * tolerance / max(difference, 1e-12))
        # One bulge covers at most half a turn; a biarc halves it again.
        pieces = np.maximum(np.ceil(sweep / min(longest, np.pi / 2.0)), 1.0).astype(np.int64)
        row = np.repeat(segment, pieces)
        place = np.arange(len(row)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
        step = np.repeat((high - low) / pieces, pieces)
        t = np.repeat(low, pieces) + step * place
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
