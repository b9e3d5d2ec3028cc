"""curve: approximate parametric curves by lines and arcs within a tolerance.

Each piece of a curve becomes a biarc: two tangent arcs with the curve's points and directions at
the ends of the piece, so a smooth curve gives a smooth result.  The deviation of a biarc of length
h grows with |κ′| h³, where κ′ is the derivative of the curve's curvature by its length.  Therefore
pieces are distributed with a density of |κ′|^⅓.  Every biarc is then measured against the curve,
and its piece is halved if the deviation is too large.

Source: biarc with equal tangent lengths, Bolton, "Biarc curves", Computer-Aided Design 7 (1975);
order of its error, Meek & Walton, "Approximating smooth planar curves by arc splines", J. Comput.
Appl. Math. 59 (1995).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from knifetip.errors import GeometryError
from knifetip.geometry.azimuth import tan_half_angle
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import BULGE, CURVE

#: Function from parameters (m,) to points or directions (m, 2).
Evaluate: TypeAlias = Callable[[F64], F64]
#: Function from numbers of curves (m,) and their parameters (m,) to points or directions (m, 2).
EvaluateEach: TypeAlias = Callable[[I64, F64], F64]
#: Start (n, 2), end (n, 2) and bulge (n,) of n segments, and their greatest distance from the
#: curve that they approximate, (n,) in the unit of the coordinates; 0 for an exact segment.
Segments: TypeAlias = tuple[F64, F64, F64, F64]

#: Parameters of the points of a piece, 0 … 1, at which its biarc is measured.
_PROBE_FRACTIONS: Final = np.linspace(0.0, 1.0, 26)[1:-1]
#: Fraction of the tolerance that a measured deviation may use; the maximum may be between probes.
_MARGIN: Final = 0.97
#: Divisor c of the deviation |κ′| h³ / c, measured on ellipses with axes 1 : 1.01 to 1 : 100.
_BIARC_ERROR: Final = 150.0
#: Largest bulge of an arc (106°); longer arcs are not measured reliably.
_MAX_BULGE: Final = 0.5
#: Largest number of halvings of a piece.
_MAX_HALVINGS: Final = 40
#: Largest number of pieces of a fit.
_MAX_PIECES: Final = 100_000
#: Number of pieces or spans that are processed at once, to limit the memory for long curves.
_BATCH: Final = 4096


def fit(
    point: Evaluate, tangent: Evaluate, breaks: ArrayLike, tolerance: float = CURVE
) -> Segments:
    """Return lines and arcs that approximate a parametric curve within a tolerance.

    Parameters
    ----------
    point, tangent
        Functions from parameters (m,) to points (m, 2) mm and to derivatives (m, 2) of any length.
    breaks : (k,), increasing
        Parameters of the start and the end of the curve, and of points between at which the curve
        may have a corner or a jump in curvature.  A segment ends exactly at each of these points,
        unless the curve is straight there.
    tolerance : float, mm
        Largest distance of a point of the curve from the segments.

    Returns
    -------
    start, end : (n, 2) float64, mm
    bulge : (n,) float64, |bulge| ≤ 0.5
        The segments, lines or arcs.  The end of segment i and the start of segment i + 1 have equal
        coordinates.
    error : (n,) float64, mm
        Greatest distance of the curve from each segment: measured at 24 points of every biarc, and
        increased by 3 % because the maximum may be between two of them.

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
        edges = _spread_breaks(point, tangent, knots, tolerance)
        begin, _, joints, bulges, errors = _halve_until_fitted(
            point, tangent, edges[:-1], edges[1:], tolerance
        )
    corners = point(np.append(begin, knots[-1]))
    start = np.stack([corners[:-1], joints], axis=1).reshape(-1, 2)
    end = np.stack([joints, corners[1:]], axis=1).reshape(-1, 2)
    one = np.zeros(len(start), np.int64)
    segments = start, end, bulges.reshape(-1), np.repeat(errors, 2)
    return _merge_collinear(segments, one, 1e-6 * tolerance)[0]


def fit_many(
    point: EvaluateEach, tangent: EvaluateEach, count: int, tolerance: float = CURVE
) -> tuple[Segments, I64]:
    """Return lines and arcs that approximate many smooth curves within a tolerance.

    Parameters
    ----------
    point, tangent
        Functions from the numbers of curves (m,), 0 … ``count`` - 1, and parameters on them (m,), 0
        … 1, to points (m, 2) and to derivatives (m, 2) of any length.
    count
        Number of curves.
    tolerance : float, mm
        Largest distance of a point of a curve from the segments of the curve.

    Returns
    -------
    segments : Segments
        Ends (mm) of the n lines and arcs, their bulges (|bulge| ≤ 0.5), and the greatest distance
        of the curve from each of them (mm), as in ``fit``.
    curve : (n,) int64
        Number of the curve that each line or arc belongs to, never decreasing.  A curve without
        length has no line or arc.

    Raises
    ------
    GeometryError
        A curve has no finite points, or needs too many pieces.
    """
    parts = [
        _fit_block(point, tangent, low, min(_BATCH, count - low), tolerance)
        for low in range(0, count, _BATCH)
    ]
    if not parts:
        none = np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0), np.zeros(0)
        return none, np.zeros(0, np.int64)
    segments, curve = zip(*parts, strict=True)
    start, end, bulge, error = (np.concatenate(column) for column in zip(*segments, strict=True))
    return (start, end, bulge, error), np.concatenate(curve)


def _fit_block(
    point: EvaluateEach, tangent: EvaluateEach, low: int, count: int, tolerance: float
) -> tuple[Segments, I64]:
    """Return lines and arcs that approximate the curves ``low`` … ``low + count - 1``.

    The curves are joined into one curve and fitted together: the parameters 2i to 2i + 1 of the
    joined curve belong to the curve ``low + i``.

    Parameters
    ----------
    point, tangent
        Functions from the numbers of curves (m,) and parameters on them (m,), 0 … 1, to points (m,
        2) mm and to derivatives (m, 2).
    low, count
        Number of the first curve, and how many curves are fitted.
    tolerance : mm
        Largest distance of a point of a curve from its segments.

    Returns
    -------
    segments, curve
        The n lines and arcs, and the number of the curve that each of them approximates, (n,).
    """

    def curve_and_parameter(t: F64) -> tuple[I64, F64]:
        """Return curve numbers and the parameters on these curves, (m,) each.

        ``t`` (m,) are parameters of the joined curve.
        """
        k = np.minimum(t // 2.0, count - 1.0)
        return k.astype(np.int64) + low, np.clip(t - 2.0 * k, 0.0, 1.0)

    def point_at(t: F64) -> F64:
        return point(*curve_and_parameter(t))

    def tangent_at(t: F64) -> F64:
        return tangent(*curve_and_parameter(t))

    with np.errstate(all="ignore"):
        edges = _spread_breaks(point_at, tangent_at, np.arange(2.0 * count), tolerance)
        first, last = edges[:-1], edges[1:]
        nonempty = first // 1.0 % 2.0 == 0.0
        begin, finish, joints, bulges, errors = _halve_until_fitted(
            point_at, tangent_at, first[nonempty], last[nonempty], tolerance
        )
    start = np.stack([point_at(begin), joints], axis=1).reshape(-1, 2)
    end = np.stack([joints, point_at(finish)], axis=1).reshape(-1, 2)
    curve = np.repeat((begin // 2.0).astype(np.int64), 2) + low
    segments = start, end, bulges.reshape(-1), np.repeat(errors, 2)
    return _merge_collinear(segments, curve, 1e-6 * tolerance)


def _halve_until_fitted(
    point: Evaluate, tangent: Evaluate, first: F64, last: F64, tolerance: float
) -> tuple[F64, F64, F64, F64, F64]:
    """Return pieces of a curve, halved until the biarc of each piece is within the tolerance.

    Parameters
    ----------
    point, tangent
        Functions from parameters of the curve to its points and to its derivatives.
    first, last : (k,)
        Parameters at which the initial pieces start and end.
    tolerance : mm
        Largest distance of a biarc from the curve.

    Returns
    -------
    first, last : (m,)
        Parameters at which the final pieces start and end, in the order of the curve.
    joint : (m, 2) mm
        Point at which the two arcs of each biarc meet.
    bulge : (m, 2)
        Bulges of the two arcs.
    error : (m,) mm
        Greatest distance of each biarc from the curve.

    Raises
    ------
    GeometryError
        The curve needs too many pieces, or the biarc of a piece exceeds the tolerance after all
        permitted halvings.
    """
    done: list[tuple[F64, F64, F64, F64, F64]] = []
    total = 0
    for _ in range(_MAX_HALVINGS):
        blocks = [
            _biarcs(point, tangent, first[at : at + _BATCH], last[at : at + _BATCH], tolerance)
            for at in range(0, len(first), _BATCH)
        ]
        joint, bulge, error, good = (np.concatenate(column) for column in zip(*blocks, strict=True))
        done.append((first[good], last[good], joint[good], bulge[good], error[good]))
        total += int(good.sum())
        bad = ~good
        if not bad.any():
            break
        if total + 2 * int(bad.sum()) > _MAX_PIECES:
            raise GeometryError("curve.too-many-pieces", limit=_MAX_PIECES, tolerance=tolerance)
        middle = (first[bad] + last[bad]) / 2.0
        first, last = (
            np.concatenate([first[bad], middle]),
            np.concatenate([middle, last[bad]]),
        )
    else:
        raise GeometryError("curve.not-fitted", tolerance=tolerance)
    columns = [np.concatenate(column) for column in zip(*done, strict=True)]
    order = np.argsort(columns[0])
    first, last, joint, bulge, error = (column[order] for column in columns)
    return first, last, joint, bulge, error


def _merge_collinear(segments: Segments, curve: I64, min_length: float) -> tuple[Segments, I64]:
    """Remove segments of at most ``min_length`` mm, then merge neighbouring collinear lines.

    Arguments and results are segments, and the number of the curve of each segment, ``curve`` (n,).
    Segments of different curves are not merged.
    """
    start, end, bulge, error = segments
    # A piece that is a single arc or line has its joint at its end, so its second segment is empty.
    length = np.hypot(*(end - start).T)
    some = length > min_length
    start, end, bulge, length = start[some], end[some], bulge[some], length[some]
    error, curve = error[some], curve[some]
    if not len(bulge):
        return (start, end, bulge, error), curve
    same = curve[1:] == curve[:-1]
    start[1:][same] = end[:-1][same]
    ahead = (end - start) / length[:, None]
    cross = ahead[:-1, 0] * ahead[1:, 1] - ahead[:-1, 1] * ahead[1:, 0]
    collinear = (np.abs(cross) < 1e-9) & ((ahead[:-1] * ahead[1:]).sum(axis=1) > 0.0)
    collinear &= (bulge[:-1] == 0.0) & (bulge[1:] == 0.0) & same
    first = np.concatenate([[True], ~collinear])
    last = np.concatenate([~collinear, [True]])
    error = np.maximum.reduceat(error, np.flatnonzero(first))
    return (start[first], end[last], bulge[first], error), curve[first]


def _spread_breaks(point: Evaluate, tangent: Evaluate, knots: F64, tolerance: float) -> F64:
    """Return parameters that divide a curve into pieces whose biarcs have nearly equal errors.

    The result, (m,), is increasing and contains all ``knots``.

    Parameters
    ----------
    point, tangent
        Functions from parameters of the curve to its points and to its derivatives.
    knots : (k,)
        Parameters of the start and the end of the curve, and of points between at which a piece
        must end; increasing.
    tolerance : mm
        Largest distance of a biarc from the curve.
    """
    cells = 32
    if len(knots) - 1 > _MAX_PIECES:
        raise GeometryError("curve.too-many-spans", spans=len(knots) - 1, limit=_MAX_PIECES)
    edges: list[F64] = []
    for block in range(0, len(knots) - 1, _BATCH):
        left = knots[block : block + _BATCH + 1]
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
        wanted = np.cbrt(change * along**2 / (_BIARC_ERROR * tolerance))
        wanted = np.maximum(np.nan_to_num(wanted), np.abs(np.nan_to_num(turn)) / (np.pi / 2.0))
        wanted += wanted.max(axis=1, keepdims=True) * 1e-6 + 1e-12
        count = np.clip(np.ceil(wanted.sum(axis=1) - 1e-6), 1, 64).astype(np.int64)
        for row, pieces in enumerate(count):
            sum_ = np.concatenate([[0.0], np.cumsum(wanted[row])])
            fraction = np.linspace(0.0, sum_[-1], pieces + 1)[:-1]
            edges.append(np.interp(fraction, sum_, grid[row]))
    edges.append(knots[-1:])
    every = np.concatenate(edges)
    result: F64 = every[np.concatenate([[True], np.diff(every) > 0.0])]
    return result


def _biarcs(
    point: Evaluate, tangent: Evaluate, first: F64, last: F64, tolerance: float
) -> tuple[F64, F64, F64, Bool]:
    """Return the biarc of each of m pieces of a curve, its error, and whether it is good.

    A biarc is good if its distance from the curve is within the tolerance (mm) and the bulges of
    its arcs are at most ``_MAX_BULGE``.  ``point`` and ``tangent`` are functions from parameters of
    the curve to its points and derivatives.  ``first`` and ``last`` (m,) are the parameters at
    which the pieces start and end.

    Returns
    -------
    joint : (m, 2) mm
        Point at which the two arcs of each biarc meet.
    bulge : (m, 2)
        Bulges of the two arcs.
    error : (m,) mm
        Greatest distance of each biarc from the curve.
    good : (m,)
        Whether each biarc is good.
    """
    a, b = point(first), point(last)
    # A piece that ends in a corner has its own direction just before its end.
    u, v = _normalise(tangent(first)), _normalise(tangent(np.nextafter(last, first)))
    chord = b - a
    # Equal tangent lengths d: |chord|² - 2 d chord·(u + v) - 2 d² (1 - u·v) = 0, Bolton.
    square = (chord * chord).sum(axis=1)
    lean = (chord * (u + v)).sum(axis=1)
    open_ = 2.0 * (1.0 - (u * v).sum(axis=1))
    d = square / (lean + np.sqrt(lean * lean + open_ * square))
    joint = ((a + d[:, None] * u) + (b - d[:, None] * v)) / 2.0
    bulge = np.stack([tan_half_angle(u, joint - a), tan_half_angle(b - joint, v)], axis=1)

    # Use one arc where it fits as well as two (circles, straight parts).
    one_arc_bulge = tan_half_angle(u, chord)
    one_arc = np.abs(one_arc_bulge - tan_half_angle(chord, v)) < 1e-9
    joint[one_arc] = b[one_arc]
    bulge[one_arc, 0] = one_arc_bulge[one_arc]
    bulge[one_arc, 1] = 0.0

    t = first[:, None] + (last - first)[:, None] * _PROBE_FRACTIONS
    probes = point(t.reshape(-1)).reshape(len(first), -1, 2)
    deviation = _distances(a, joint, bulge[:, 0], probes)
    two = ~one_arc
    deviation[two] = np.minimum(
        deviation[two], _distances(joint[two], b[two], bulge[two, 1], probes[two])
    )
    error = deviation.max(axis=1) / _MARGIN
    good = (error <= tolerance) & (np.abs(bulge) <= _MAX_BULGE).all(axis=1)

    # At a cusp the direction is undefined; use the chord if it is within tolerance.
    chord_error = _distances(a, b, np.zeros(len(a)), probes).max(axis=1) / _MARGIN
    flat = ~good & (chord_error <= tolerance)
    blunt = flat & (~np.isfinite(bulge).all(axis=1) | (square <= (4.0 * tolerance) ** 2))
    joint[blunt], bulge[blunt], error[blunt] = b[blunt], 0.0, chord_error[blunt]
    bulge[np.abs(bulge) < BULGE] = 0.0
    enough: Bool = good | blunt
    return joint, bulge, error, enough


def _normalise(vectors: F64) -> F64:
    """Return vectors, (n, 2), scaled to length 1; NaN for zero vectors."""
    return vectors / np.hypot(vectors[:, 0], vectors[:, 1])[:, None]


def _distances(start: F64, end: F64, bulge: F64, points: F64) -> F64:
    """Return the distances of k points from each of m lines or arcs, (m, k) mm.

    ``start``, ``end`` (m, 2) mm and ``bulge`` (m,) are the lines or arcs; ``points`` (m, k, 2) mm
    has k points for each of them.
    """
    chord = end - start
    length = np.hypot(chord[:, 0], chord[:, 1])
    length = np.where(length > 0.0, length, 1.0)
    ahead = chord / length[:, None]
    x = ((points - start[:, None]) * ahead[:, None]).sum(axis=2)
    side = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
    y = ((points - start[:, None]) * side[:, None]).sum(axis=2)
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
