"""curve: approximate ellipses and splines by lines and arcs within a tolerance.

    point(t), tangent(t), breakpoints -> start (n, 2), end (n, 2), bulge (n,)

Each piece is a biarc: two tangent arcs with the curve's points and directions at its ends, so a
smooth curve gives a smooth result.  The deviation of a biarc of length h grows with |κ′| h³, so
pieces are distributed with a density of |κ′|^⅓.  Every piece is then measured against the curve,
and halved if it deviates too much.

Source: biarc with equal tangent lengths, Bolton, "Biarc curves", Computer-Aided Design 7 (1975);
order of its error, Meek & Walton, "Approximating smooth planar curves by arc splines", J. Comput.
Appl. Math. 59 (1995); B-splines by de Boor's recurrence, "A Practical Guide to Splines" (1978).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from knifetip.errors import GeometryError
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import BULGE, CURVE

#: Parameters (m,) -> points or directions (m, 2).
Evaluate: TypeAlias = Callable[[F64], F64]
#: Numbers of curves (m,), parameters on them (m,) -> points or directions (m, 2).
EvaluateEach: TypeAlias = Callable[[I64, F64], F64]
#: Segments: start (n, 2), end (n, 2), bulge (n,).
Segments: TypeAlias = tuple[F64, F64, F64]

#: Number of points of the curve, evenly spaced in a piece, at which its biarc is measured.
_PROBES: Final = np.linspace(0.0, 1.0, 26)[1:-1]
#: Largest relative error of the measured maximum, which may lie between probes.
_MARGIN: Final = 0.97
#: The deviation of a biarc is |κ′| h³ divided by this; measured on ellipses 1 : 1.01 to 1 : 100.
_ERROR: Final = 150.0
#: Largest bulge of a piece (an arc of 106°); longer pieces are not measured reliably.
_LONGEST: Final = 0.5
#: Largest number of halvings of a piece.
_HALVINGS: Final = 40
#: Largest number of pieces of a fit.
_MOST: Final = 100_000
#: Pieces or spans processed at once, to limit the memory for long curves.
_BLOCK: Final = 4096


def fit(
    point: Evaluate, tangent: Evaluate, breaks: ArrayLike, tolerance: float = CURVE
) -> Segments:
    """Fit arcs and lines to a parametric curve.

    Parameters
    ----------
    point, tangent
        Map parameters (m,) to points (m, 2), and to the derivative there (any length).
    breaks : (k,), increasing
        Parameters at which the curve may have a corner or jump in curvature, both ends included.
        Segments meet there exactly on the curve, unless they are one straight line.
    tolerance : float, mm
        No point of the curve is farther than this from the segments.

    Returns
    -------
    start, end : (n, 2) float64, mm
    bulge : (n,) float64, |bulge| ≤ 0.5
        Segment i ends where segment i + 1 starts, to the bit.

    Raises
    ------
    GeometryError
        The curve has no finite points, or needs more than a hundred thousand pieces.
    """
    knots = np.asarray(breaks, dtype=np.float64)
    if len(knots) < 2 or not np.isfinite(knots).all() or not (np.diff(knots) > 0.0).all():
        raise GeometryError("curve.parameters")
    if not tolerance > 0.0:
        raise GeometryError("curve.bad-tolerance", tolerance=tolerance)
    with np.errstate(all="ignore"):
        edges = _spread(point, tangent, knots, tolerance)
        begin, _, joints, bulges = _pieces(point, tangent, edges[:-1], edges[1:], tolerance)
    corners = point(np.append(begin, knots[-1]))
    start = np.stack([corners[:-1], joints], axis=1).reshape(-1, 2)
    end = np.stack([joints, corners[1:]], axis=1).reshape(-1, 2)
    one = np.zeros(len(start), np.int64)
    return _tidied(start, end, bulges.reshape(-1), one, 1e-6 * tolerance)[:3]


def each(
    point: EvaluateEach, tangent: EvaluateEach, count: int, tolerance: float = CURVE
) -> tuple[F64, F64, F64, I64]:
    """Fit arcs and lines to many smooth curves at once.

    Parameters
    ----------
    point, tangent
        Map the number of a curve (m,), 0 … ``count`` - 1, and a parameter (m,), 0 … 1, to
        points (m, 2), and to the derivative there (any length).
    tolerance : float, mm
        No point of a curve is farther than this from its segments.

    Returns
    -------
    start, end : (n, 2) float64, mm
    bulge : (n,) float64, |bulge| ≤ 0.5
    which : (n,) int64
        The curve that each segment belongs to, never decreasing.  A curve without length has none.

    Raises
    ------
    GeometryError
        One of them has no finite points, or cannot be followed.
    """
    parts = [
        _block(point, tangent, low, min(_BLOCK, count - low), tolerance)
        for low in range(0, count, _BLOCK)
    ]
    if not parts:
        return np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0), np.zeros(0, np.int64)
    start, end, bulge, which = (np.concatenate(column) for column in zip(*parts, strict=True))
    return start, end, bulge, which


def _block(
    point: EvaluateEach, tangent: EvaluateEach, low: int, count: int, tolerance: float
) -> tuple[F64, F64, F64, I64]:
    """Fit the curves from ``low`` on as one curve, with parameters 2k to 2k + 1 for curve k."""

    def apart(t: F64) -> tuple[I64, F64]:
        k = np.minimum(t // 2.0, count - 1.0)
        return k.astype(np.int64) + low, np.clip(t - 2.0 * k, 0.0, 1.0)

    def on(t: F64) -> F64:
        return point(*apart(t))

    def along(t: F64) -> F64:
        return tangent(*apart(t))

    with np.errstate(all="ignore"):
        edges = _spread(on, along, np.arange(2.0 * count), tolerance)
        first, last = edges[:-1], edges[1:]
        drawn = first // 1.0 % 2.0 == 0.0
        begin, finish, joints, bulges = _pieces(on, along, first[drawn], last[drawn], tolerance)
    start = np.stack([on(begin), joints], axis=1).reshape(-1, 2)
    end = np.stack([joints, on(finish)], axis=1).reshape(-1, 2)
    which = np.repeat((begin // 2.0).astype(np.int64), 2) + low
    return _tidied(start, end, bulges.reshape(-1), which, 1e-6 * tolerance)


def _pieces(
    point: Evaluate, tangent: Evaluate, first: F64, last: F64, tolerance: float
) -> tuple[F64, F64, F64, F64]:
    """Halve pieces until each is within tolerance of its biarc.

    Returns
    -------
    first, last : (m,)
        Parameters of the pieces, in order.
    joint : (m, 2)
    bulge : (m, 2)
    """
    done: list[tuple[F64, F64, F64, F64]] = []
    total = 0
    for _ in range(_HALVINGS):
        blocks = [
            _biarcs(point, tangent, first[at : at + _BLOCK], last[at : at + _BLOCK], tolerance)
            for at in range(0, len(first), _BLOCK)
        ]
        joint, bulge, good = (np.concatenate(column) for column in zip(*blocks, strict=True))
        done.append((first[good], last[good], joint[good], bulge[good]))
        total += int(good.sum())
        bad = ~good
        if not bad.any():
            break
        if total + 2 * int(bad.sum()) > _MOST:
            raise GeometryError("curve.too-many-pieces", limit=_MOST, tolerance=tolerance)
        middle = (first[bad] + last[bad]) / 2.0
        first, last = (
            np.concatenate([first[bad], middle]),
            np.concatenate([middle, last[bad]]),
        )
    else:
        raise GeometryError("curve.not-fitted", tolerance=tolerance)
    first, last, joint, bulge = (np.concatenate(column) for column in zip(*done, strict=True))
    order = np.argsort(first)
    return first[order], last[order], joint[order], bulge[order]


def _tidied(
    start: F64, end: F64, bulge: F64, which: I64, speck: float
) -> tuple[F64, F64, F64, I64]:
    """Remove segments shorter than ``speck`` and merge collinear lines."""
    # A piece of a single arc or line has its joint at its end.
    length = np.hypot(*(end - start).T)
    some = length > speck
    start, end, bulge, length = start[some], end[some], bulge[some], length[some]
    which = which[some]
    if not len(bulge):
        return start, end, bulge, which
    same = which[1:] == which[:-1]
    start[1:][same] = end[:-1][same]
    ahead = (end - start) / length[:, None]
    cross = ahead[:-1, 0] * ahead[1:, 1] - ahead[:-1, 1] * ahead[1:, 0]
    onward = (np.abs(cross) < 1e-9) & ((ahead[:-1] * ahead[1:]).sum(axis=1) > 0.0)
    onward &= (bulge[:-1] == 0.0) & (bulge[1:] == 0.0) & same
    first = np.concatenate([[True], ~onward])
    last = np.concatenate([~onward, [True]])
    return start[first], end[last], bulge[first], which[first]


def _spread(point: Evaluate, tangent: Evaluate, knots: F64, tolerance: float) -> F64:
    """Return parameters that split each span into pieces of nearly equal deviation."""
    cells = 32
    if len(knots) - 1 > _MOST:
        raise GeometryError("curve.too-many-spans", spans=len(knots) - 1, limit=_MOST)
    edges: list[F64] = []
    for block in range(0, len(knots) - 1, _BLOCK):
        left = knots[block : block + _BLOCK + 1]
        grid = left[:-1, None] + np.diff(left)[:, None] * np.linspace(0.0, 1.0, cells + 1)
        shape = (*grid.shape, 2)
        place = point(grid.reshape(-1)).reshape(shape)
        if not np.isfinite(place).all():
            raise GeometryError("curve.not-finite")
        seen = grid.copy()
        seen[:, -1] = np.nextafter(grid[:, -1], grid[:, 0])
        ahead = tangent(seen.reshape(-1)).reshape(shape)
        step = np.diff(place, axis=1)
        along = np.hypot(step[..., 0], step[..., 1])
        before, after = ahead[:, :-1], ahead[:, 1:]
        turn = np.arctan2(
            before[..., 0] * after[..., 1] - before[..., 1] * after[..., 0],
            (before * after).sum(axis=-1),
        )
        curvature = np.nan_to_num(turn / along, nan=0.0, posinf=0.0, neginf=0.0)
        change = np.abs(np.gradient(curvature, axis=1))
        # |κ′|^⅓ ds with κ′ = Δκ / Δs; at least one piece per 90° of turning.
        wanted = np.cbrt(change * along**2 / (_ERROR * tolerance))
        wanted = np.maximum(np.nan_to_num(wanted), np.abs(np.nan_to_num(turn)) / (np.pi / 2.0))
        wanted += wanted.max(axis=1, keepdims=True) * 1e-6 + 1e-12
        count = np.clip(np.ceil(wanted.sum(axis=1) - 1e-6), 1, 64).astype(np.int64)
        for row, pieces in enumerate(count):
            sum_ = np.concatenate([[0.0], np.cumsum(wanted[row])])
            share = np.linspace(0.0, sum_[-1], pieces + 1)[:-1]
            edges.append(np.interp(share, sum_, grid[row]))
    edges.append(knots[-1:])
    every = np.concatenate(edges)
    result: F64 = every[np.concatenate([[True], np.diff(every) > 0.0])]
    return result


def _biarcs(
    point: Evaluate, tangent: Evaluate, first: F64, last: F64, tolerance: float
) -> tuple[F64, F64, Bool]:
    """Return joint (m, 2) and bulges (m, 2) of each piece, and whether it is within tolerance."""
    a, b = point(first), point(last)
    # A piece that ends in a corner has its own direction just before its end.
    u, v = _direction(tangent(first)), _direction(tangent(np.nextafter(last, first)))
    chord = b - a
    # Equal tangent lengths d: |chord|² - 2 d chord·(u + v) - 2 d² (1 - u·v) = 0, Bolton.
    square = (chord * chord).sum(axis=1)
    lean = (chord * (u + v)).sum(axis=1)
    open_ = 2.0 * (1.0 - (u * v).sum(axis=1))
    d = square / (lean + np.sqrt(lean * lean + open_ * square))
    joint = ((a + d[:, None] * u) + (b - d[:, None] * v)) / 2.0
    bulge = np.stack([_half_angle(u, joint - a), _half_angle(b - joint, v)], axis=1)

    # Use one arc where it fits as well as two (circles, straight parts).
    whole = _half_angle(u, chord)
    alike = np.abs(whole - _half_angle(chord, v)) < 1e-9
    joint[alike] = b[alike]
    bulge[alike, 0] = whole[alike]
    bulge[alike, 1] = 0.0

    t = first[:, None] + (last - first)[:, None] * _PROBES
    probes = point(t.reshape(-1)).reshape(len(first), -1, 2)
    allowed = tolerance * _MARGIN
    near = _off(a, joint, bulge[:, 0], probes)
    two = ~alike
    near[two] = np.minimum(near[two], _off(joint[two], b[two], bulge[two, 1], probes[two]))
    good = (near.max(axis=1) <= allowed) & (np.abs(bulge) <= _LONGEST).all(axis=1)

    # At a cusp the direction is undefined; use the chord if it is within tolerance.
    flat = ~good & (_off(a, b, np.zeros(len(a)), probes).max(axis=1) <= allowed)
    blunt = flat & (~np.isfinite(bulge).all(axis=1) | (square <= (4.0 * tolerance) ** 2))
    joint[blunt], bulge[blunt] = b[blunt], 0.0
    bulge[np.abs(bulge) < BULGE] = 0.0
    enough: Bool = good | blunt
    return joint, bulge, enough


def _direction(vectors: F64) -> F64:
    return vectors / np.hypot(vectors[:, 0], vectors[:, 1])[:, None]


def _half_angle(before: F64, after: F64) -> F64:
    """Return tan of half the angle between two vectors: the bulge, from tangent and chord."""
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    dot = (before * after).sum(axis=1)
    result: F64 = cross / (np.hypot(cross, dot) + dot)
    return result


def _off(start: F64, end: F64, bulge: F64, probes: F64) -> F64:
    """Return the distances (m, k) of probes (m, k, 2) from segments (m)."""
    chord = end - start
    length = np.hypot(chord[:, 0], chord[:, 1])
    length = np.where(length > 0.0, length, 1.0)
    ahead = chord / length[:, None]
    x = ((probes - start[:, None]) * ahead[:, None]).sum(axis=2)
    side = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
    y = ((probes - start[:, None]) * side[:, None]).sum(axis=2)
    size = length[:, None]
    to_ends = np.minimum(np.hypot(x, y), np.hypot(x - size, y))
    straight = np.where((x >= 0.0) & (x <= size), np.abs(y), to_ends)
    b = bulge[:, None]
    flat = np.abs(b) < BULGE
    safe = np.where(flat, 1.0, b)
    middle_y = size * (1.0 - safe * safe) / (4.0 * safe)
    radius = size * (1.0 + safe * safe) / (4.0 * np.abs(safe))
    rx, ry = x - size / 2.0, y - middle_y
    # The ray from the centre through the probe meets the arc if it points into its sector.
    out = np.where(safe > 0.0, -1.0, 1.0)
    inside = np.arctan2(np.abs(rx), ry * out) <= 2.0 * np.arctan(np.abs(safe)) + 1e-15
    round_ = np.where(inside, np.abs(np.hypot(rx, ry) - radius), to_ends)
    result: F64 = np.where(flat, straight, round_)
    return result


@dataclass(frozen=True, eq=False, slots=True)
class Ellipse:
    """c + u cos t + v sin t for t from ``first`` to ``last``; u and v need not be perpendicular."""

    centre: F64  #: (2,) mm
    u: F64  #: (2,) from the centre to t = 0 (mm)
    v: F64  #: (2,) from the centre to t = π/2 (mm)
    first: float  #: radians
    last: float  #: radians, > first, at most a full turn after it

    def point(self, t: F64) -> F64:
        """Return the points at parameters (m,), (m, 2) mm."""
        result: F64 = self.centre + np.cos(t)[:, None] * self.u + np.sin(t)[:, None] * self.v
        return result

    def tangent(self, t: F64) -> F64:
        """Return the derivatives at parameters (m,), (m, 2)."""
        result: F64 = np.cos(t)[:, None] * self.v - np.sin(t)[:, None] * self.u
        return result

    def fitted(self, tolerance: float = CURVE) -> Segments:
        """Return lines and arcs within a tolerance (mm) of the ellipse.

        Circles give exact arcs; otherwise each quarter between the ends of the axes is fitted.  An
        ellipse without width gives a line in both directions.

        Raises
        ------
        GeometryError
            A size is not a number, or the parameters do not increase.
        """
        turn = self.last - self.first
        shape = np.concatenate([self.centre, self.u, self.v, [self.first, self.last]])
        if not np.isfinite(shape).all() or not 0.0 < turn <= 2.0 * np.pi + 1e-9:
            raise GeometryError("curve.bad-ellipse")
        # The axes: where u cos t + v sin t is longest, tan 2t = 2 u·v / (u² - v²).
        uu, vv, uv = float(self.u @ self.u), float(self.v @ self.v), float(self.u @ self.v)
        cross = float(self.u[0] * self.v[1] - self.u[1] * self.v[0])
        if abs(uu - vv) <= 1e-12 * uu and abs(uv) <= 1e-12 * uu:
            rows = max(1, int(np.ceil(turn / np.pi - 1e-9)))
            t = np.linspace(self.first, self.last, rows + 1)
            corners = self.point(t)
            if abs(turn - 2.0 * np.pi) <= 1e-9:
                corners[-1] = corners[0]
            side = 1.0 if cross > 0.0 else -1.0
            bulge = np.full(rows, side * min(np.tan(turn / rows / 4.0), 1.0))
            return corners[:-1], corners[1:], bulge
        axis = 0.5 * np.arctan2(2.0 * uv, uu - vv)
        quarter = np.pi / 2.0
        number = np.arange(
            np.floor((self.first - axis) / quarter), np.ceil((self.last - axis) / quarter) + 1.0
        )
        inner = axis + number * quarter
        inner = inner[(inner > self.first + 1e-9) & (inner < self.last - 1e-9)]
        breaks = np.concatenate([[self.first], inner, [self.last]])
        if abs(cross) <= 1e-12 * max(uu, vv):
            corners = self.point(breaks)
            return corners[:-1], corners[1:], np.zeros(len(corners) - 1)
        start, end, bulge = fit(self.point, self.tangent, breaks, tolerance)
        if abs(turn - 2.0 * np.pi) <= 1e-9:
            end[-1] = start[0]
        return start, end, bulge


def ellipse(
    centre: ArrayLike,
    major: ArrayLike,
    ratio: float,
    first: float = 0.0,
    last: float = 2.0 * np.pi,
    tolerance: float = CURVE,
) -> Segments:
    """Fit arcs and lines to an elliptic arc, counter-clockwise from ``first`` to ``last``.

    Parameters
    ----------
    centre, major : (2,) mm
        ``major`` goes from the centre to the end of an axis.
    ratio : float
        Length of the other axis divided by this one; negative for clockwise.
    first, last : float, radians
        Parameters (not angles), counted from ``major``.
    tolerance : float, mm

    Returns
    -------
    start, end : (n, 2) float64, mm
    bulge : (n,) float64, |bulge| ≤ 1

    Raises
    ------
    GeometryError
        A size is not a number, or ``last`` is not after ``first``.
    """
    u = np.asarray(major, dtype=np.float64)
    v = np.array([-u[1], u[0]]) * ratio
    return Ellipse(np.asarray(centre, dtype=np.float64), u, v, first, last).fitted(tolerance)


@dataclass(frozen=True, eq=False, slots=True)
class Spline:
    """A rational B-spline; all weights are 1 if it is not rational."""

    control: F64  #: (k, 2) mm
    weights: F64  #: (k,) > 0
    knots: F64  #: (k + degree + 1,) never decreasing
    degree: int

    def __post_init__(self) -> None:
        count = len(self.control)
        numbers = np.concatenate([self.control.reshape(-1), self.weights, self.knots])
        if (
            self.degree < 1
            or count <= self.degree
            or len(self.weights) != count
            or len(self.knots) != count + self.degree + 1
            or not np.isfinite(numbers).all()
            or not (np.diff(self.knots) >= 0.0).all()
            or not (self.weights > 0.0).all()
            or not self.knots[count] > self.knots[self.degree]
        ):
            raise GeometryError(
                "curve.bad-spline", degree=self.degree, points=count, knots=len(self.knots)
            )

    @property
    def breaks(self) -> F64:
        """Parameters between which the spline is smooth."""
        inside = self.knots[self.degree : len(self.control) + 1]
        return np.unique(inside)

    def _evaluated(self, t: F64, rows: F64, knots: F64, degree: int) -> F64:
        """Return a polynomial B-spline (m, columns) at t by de Boor's recurrence."""
        count = len(rows)
        span = np.clip(np.searchsorted(knots, t, side="right") - 1, degree, count - 1)
        # Empty spans have no points; use the span that ends there.
        filled = np.flatnonzero(knots[degree:count] < knots[degree + 1 : count + 1]) + degree
        span = filled[np.searchsorted(filled, span, side="right") - 1]
        d = rows[span[:, None] - degree + np.arange(degree + 1)]
        for level in range(1, degree + 1):
            for j in range(degree, level - 1, -1):
                low = knots[span - degree + j]
                high = knots[span + 1 + j - level]
                wide = high - low
                share = np.where(wide > 0.0, (t - low) / np.where(wide > 0.0, wide, 1.0), 0.0)
                d[:, j] = (1.0 - share)[:, None] * d[:, j - 1] + share[:, None] * d[:, j]
        result: F64 = d[:, degree]
        return result

    def _homogeneous(self) -> F64:
        return np.hstack([self.control * self.weights[:, None], self.weights[:, None]])

    def point(self, t: F64) -> F64:
        """Return the points at parameters (m,), (m, 2) mm."""
        value = self._evaluated(t, self._homogeneous(), self.knots, self.degree)
        result: F64 = value[:, :2] / value[:, 2:]
        return result

    def tangent(self, t: F64) -> F64:
        """Return the derivatives at parameters (m,), (m, 2); at a corner, that after it."""
        p = self.degree
        rows = self._homogeneous()
        value = self._evaluated(t, rows, self.knots, p)
        wide = self.knots[p + 1 : len(rows) + p] - self.knots[1 : len(rows)]
        slope = p * np.diff(rows, axis=0) / np.where(wide > 0.0, wide, 1.0)[:, None]
        rate = self._evaluated(t, slope, self.knots[1:-1], p - 1)
        # (A / w)′ = (A′ - (A / w) w′) / w, and w > 0 changes no direction.
        result: F64 = rate[:, :2] - value[:, :2] / value[:, 2:] * rate[:, 2:]
        return result

    def fitted(self, tolerance: float = CURVE) -> Segments:
        """Return lines and arcs within a tolerance (mm) of the spline.

        Raises
        ------
        GeometryError
            It cannot be fitted, or needs more than 100,000 pieces.
        """
        breaks = self.breaks
        if self.degree == 1:
            corners = self.point(breaks)
            some = np.any(corners[:-1] != corners[1:], axis=1)
            return corners[:-1][some], corners[1:][some], np.zeros(int(some.sum()))
        return fit(self.point, self.tangent, breaks, tolerance)
