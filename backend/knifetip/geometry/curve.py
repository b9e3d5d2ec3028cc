"""curve: approximate parametric curves by lines and arcs within a tolerance.

Each piece of a curve becomes a biarc (see ``biarcs``): two tangent arcs with the curve's points and
directions at the ends of the piece, so a smooth curve gives a smooth result.  The deviation of a
biarc of length h grows with |κ′| h³, where κ′ is the derivative of the curve's curvature by its
length.  Therefore pieces are distributed with a density of |κ′|^⅓.  Every biarc is then measured
against the curve, and its piece is halved if the deviation is too large.

Source: order of the error of biarcs, Meek & Walton, "Approximating smooth planar curves by arc
splines", J. Comput. Appl. Math. 59 (1995).
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Final, NamedTuple, TypeAlias

import numpy as np

from knifetip.errors import GeometryError
from knifetip.geometry.biarcs import EvaluateEach, Pieces, fit_biarcs
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.tolerance import CURVE
from knifetip.kernels import F64_2, I64_1, OutF64_1, kernel

#: Start (n, 2), end (n, 2) and bulge (n,) of n segments, and their greatest distance from the
#: curve that they approximate, (n,) in the unit of the coordinates; 0 for an exact segment.
Segments: TypeAlias = tuple[F64, F64, F64, F64]

#: Divisor c of the deviation |κ′| h³ / c, measured on ellipses with axes 1 : 1.01 to 1 : 100.
_BIARC_ERROR: Final = 150.0
#: Largest number of halvings of a piece.
_MAX_HALVINGS: Final = 40
#: Largest number of pieces of a curve.
MAX_PIECES: Final = 100_000
#: Borders of the cells of a span, 0 … 1, at which its curvature is measured.
_GRID: Final = np.linspace(0.0, 1.0, 33)
#: Number of pieces or spans that are processed at once, to limit the memory for long curves.
_BATCH: Final = 4096


class ManyFits(NamedTuple):
    """n lines and arcs that approximate many curves, and the curves that cannot be approximated."""

    segments: Segments  #: in the order of the curves
    curve: I64  #: (n,) number of the curve of each line or arc, never decreasing
    failed: Mapping[int, GeometryError]  #: reason by number of a curve without lines and arcs


#: Lines and arcs that approximate one curve, or the reason why there are none.
Fit: TypeAlias = Segments | GeometryError


def fitted(fit: Fit) -> Segments:
    """Return the lines and arcs of a curve.

    Raises
    ------
    GeometryError
        The curve has none.
    """
    if isinstance(fit, GeometryError):
        raise fit
    return fit


def split_fits(fits: ManyFits, count: int) -> list[Fit]:
    """Return the lines and arcs of each of ``count`` curves, as views of those of all curves."""
    first = np.searchsorted(fits.curve, np.arange(count + 1)).tolist()
    start, end, bulge, error = fits.segments
    found: list[Fit] = [
        (start[low:high], end[low:high], bulge[low:high], error[low:high])
        for low, high in pairwise(first)
    ]
    for number, reason in fits.failed.items():
        found[number] = reason
    return found


def fit_many(
    point: EvaluateEach,
    tangent: EvaluateEach,
    count: int,
    tolerance: float = CURVE,
    max_pieces: int = MAX_PIECES,
) -> ManyFits:
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
    max_pieces
        Largest number of pieces of all curves; each piece becomes one or two segments.

    Returns
    -------
    ManyFits
        Ends (mm) of the n lines and arcs, their bulges (|bulge| ≤ 0.5), and the greatest distance
        of the curve from each of them (mm).  The distance is measured at 24 points of every biarc,
        and increased by 3 % because the maximum may be between two of them.  The end of a segment
        and the start of the next one have equal coordinates.  A curve without length has no line
        or arc.

    Raises
    ------
    GeometryError
        The curves together need too many pieces.
    """
    first: F64 = 2.0 * (np.arange(count, dtype=np.float64) % _BATCH)

    def parameter(k: I64, t: F64) -> F64:
        return np.clip(t - first[k], 0.0, 1.0)

    return fit_spans(
        lambda k, t: point(k, parameter(k, t)),
        lambda k, t: tangent(k, parameter(k, t)),
        Pieces(first, first + 1.0, np.arange(count)),
        count,
        tolerance,
        max_pieces,
    )


def fit_spans(
    point: EvaluateEach,
    tangent: EvaluateEach,
    spans: Pieces,
    count: int,
    tolerance: float,
    max_pieces: int,
) -> ManyFits:
    """Return lines and arcs that approximate curves of one or more smooth spans.

    The pieces of all curves are counted before the first of them is converted.

    Parameters
    ----------
    point, tangent
        Functions from the numbers of curves (m,) and parameters on them (m,) to points (m, 2) and
        to derivatives (m, 2) of any length.
    spans
        The smooth spans of the curves, in the order of the curves.
    count
        Number of curves.
    tolerance : mm
        Largest distance of a point of a curve from its segments.
    max_pieces
        Largest number of pieces of all curves.

    Raises
    ------
    GeometryError
        The tolerance is not positive, or the curves together need too many pieces.
    """
    if not tolerance > 0.0:
        raise GeometryError("curve.bad-tolerance", tolerance=tolerance)
    failed: dict[int, GeometryError] = {}
    with np.errstate(all="ignore"):
        pieces = _divide_spans(point, tangent, spans, count, tolerance, max_pieces, failed)
        parts = []
        spare = max_pieces
        # Each batch has whole curves.
        for low in range(0, count, _BATCH):
            begin, end = np.searchsorted(pieces.curve, [low, low + _BATCH])
            if begin == end:
                continue
            part = _fit_pieces(
                point, tangent, pieces.select(slice(begin, end)), tolerance, spare, failed
            )
            spare -= len(part[1]) // 2
            parts.append(_merge_collinear(*part, 1e-6 * tolerance))
    if not parts:
        none = np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0), np.zeros(0)
        return ManyFits(none, np.zeros(0, np.int64), failed)
    segments, curve = zip(*parts, strict=True)
    start, end_, bulge, error = (np.concatenate(column) for column in zip(*segments, strict=True))
    return ManyFits((start, end_, bulge, error), np.concatenate(curve), failed)


def _fit_pieces(
    point: EvaluateEach,
    tangent: EvaluateEach,
    pieces: Pieces,
    tolerance: float,
    max_pieces: int,
    failed: dict[int, GeometryError],
) -> tuple[Segments, I64]:
    """Return two segments for each piece of curves, and the curve of each segment.

    The pieces are halved until the biarc of each piece is within the tolerance (mm).  The reason
    for each curve that cannot be fitted is added to ``failed``.

    Raises ``GeometryError``: the curves need more than ``max_pieces`` pieces.
    """
    done: list[tuple[Pieces, F64, F64, F64]] = []
    base = int(pieces.curve[0])
    made = np.zeros(int(pieces.curve[-1]) - base + 1, np.int64)
    for halvings in range(_MAX_HALVINGS + 1):
        wanted = made + np.bincount(pieces.curve - base, minlength=len(made))
        lost = wanted > MAX_PIECES
        if halvings == _MAX_HALVINGS:
            lost |= np.bincount(pieces.curve - base, minlength=len(made)) > 0
        for one in np.flatnonzero(lost).tolist():
            failed[base + one] = (
                GeometryError("curve.too-many-pieces", limit=MAX_PIECES, tolerance=tolerance)
                if wanted[one] > MAX_PIECES
                else GeometryError("curve.not-fitted", tolerance=tolerance)
            )
        if lost.any():
            pieces = pieces.select(~lost[pieces.curve - base])
            wanted[lost] = made[lost] = 0
        if wanted.sum() > max_pieces:
            raise GeometryError("curve.too-many-pieces", limit=max_pieces, tolerance=tolerance)
        if not len(pieces.curve):
            break
        blocks = [
            fit_biarcs(point, tangent, pieces.select(slice(at, at + _BATCH)), tolerance)
            for at in range(0, len(pieces.curve), _BATCH)
        ]
        joint, bulge, error, good = (np.concatenate(column) for column in zip(*blocks, strict=True))
        finished = pieces.select(good)
        done.append((finished, joint[good], bulge[good], error[good]))
        made += np.bincount(finished.curve - base, minlength=len(made))
        first, last, curve = pieces.select(~good)
        middle = (first + last) / 2.0
        pieces = Pieces(
            np.concatenate([first, middle]),
            np.concatenate([middle, last]),
            np.concatenate([curve, curve]),
        )
    every, *columns = zip(*done, strict=True)
    first, last, curve = (np.concatenate(column) for column in zip(*every, strict=True))
    joint, bulge, error = (np.concatenate(column) for column in columns)
    order = np.lexsort((first, curve))
    if failed:
        order = order[~np.isin(curve[order], list(failed))]
    first, last, curve = first[order], last[order], curve[order]
    joint, bulge, error = joint[order], bulge[order], error[order]
    begin, end = point(curve, first), point(curve, last)
    # Neighbouring pieces of a curve have a common point.
    same = (curve[1:] == curve[:-1]) & (first[1:] == last[:-1])
    end[:-1][same] = begin[1:][same]
    start = np.stack([begin, joint], axis=1).reshape(-1, 2)
    finish = np.stack([joint, end], axis=1).reshape(-1, 2)
    return (start, finish, bulge.reshape(-1), np.repeat(error, 2)), np.repeat(curve, 2)


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


def _divide_spans(
    point: EvaluateEach,
    tangent: EvaluateEach,
    spans: Pieces,
    count: int,
    tolerance: float,
    max_pieces: int,
    failed: dict[int, GeometryError],
) -> Pieces:
    """Return pieces of the spans of curves whose biarcs have nearly equal errors.

    ``point``, ``tangent``: functions from numbers of curves and parameters to points and to
    derivatives.
    ``spans``: the smooth spans of the curves, in the order of the curves.
    ``tolerance`` mm: largest distance of a biarc from the curve.
    ``max_pieces``: largest number of pieces of all curves.
    ``failed``: the reason for each curve that cannot be divided is added to it.
    Raises ``GeometryError``: the curves together need too many pieces.
    """
    spans_of = np.bincount(spans.curve, minlength=count)
    for one in np.flatnonzero(spans_of > MAX_PIECES).tolist():
        failed[one] = GeometryError(
            "curve.too-many-spans", spans=int(spans_of[one]), limit=MAX_PIECES
        )
    if failed:
        spans = spans.select(spans_of[spans.curve] <= MAX_PIECES)
    made = np.zeros(count, np.int64)
    parts = []
    for at in range(0, len(spans.curve), _BATCH):
        block = spans.select(slice(at, at + _BATCH))
        grid = block.first[:, None] + (block.last - block.first)[:, None] * _GRID
        place, ahead = _evaluate_grid(point, tangent, block.curve, grid)
        infinite = ~np.isfinite(place).all(axis=(1, 2))
        if infinite.any():
            for one in np.unique(block.curve[infinite]).tolist():
                failed[one] = GeometryError("curve.not-finite")
        wanted = _wanted_pieces(place, ahead, tolerance)
        number = np.clip(np.ceil(wanted.sum(axis=1) - 1e-6), 1, 64).astype(np.int64)
        number[infinite] = 0
        made += np.bincount(block.curve, number, minlength=count).astype(np.int64)
        heavy = made > MAX_PIECES
        if heavy.any():
            for one in np.flatnonzero(heavy).tolist():
                failed[one] = GeometryError(
                    "curve.too-many-pieces", limit=MAX_PIECES, tolerance=tolerance
                )
            number[heavy[block.curve]] = 0
        if made[~heavy].sum() > max_pieces:
            raise GeometryError("curve.too-many-pieces", limit=max_pieces, tolerance=tolerance)
        sums = np.concatenate([np.zeros((len(wanted), 1)), np.cumsum(wanted, axis=1)], axis=1)
        start = np.empty(int(number.sum()))
        spread(sums, grid, number, start)
        row = np.repeat(np.arange(len(number)), number)
        last = np.append(start[1:], 0.0)
        ends = np.cumsum(number[number > 0]) - 1
        last[ends] = block.last[number > 0]
        parts.append(Pieces(start, last, block.curve[row]).select(start < last))
    if not parts:
        return spans
    pieces = Pieces(*(np.concatenate(column) for column in zip(*parts, strict=True)))
    if failed:
        return pieces.select(~np.isin(pieces.curve, list(failed)))
    return pieces


def _evaluate_grid(
    point: EvaluateEach, tangent: EvaluateEach, curve: I64, grid: F64
) -> tuple[F64, F64]:
    """Return points and derivatives of n spans at their parameters ``grid``, (n, c, 2) each.

    The derivative at the end of a span is that just before its end, where there may be a corner.
    """
    shape = (*grid.shape, 2)
    curves = np.repeat(curve, grid.shape[1])
    place = point(curves, grid.reshape(-1)).reshape(shape)
    seen = grid.copy()
    seen[:, -1] = np.nextafter(grid[:, -1], grid[:, 0])
    return place, tangent(curves, seen.reshape(-1)).reshape(shape)


def _wanted_pieces(place: F64, ahead: F64, tolerance: float) -> F64:
    """Return the number of pieces that each cell of n spans needs, (n, c - 1), not rounded.

    ``place``, ``ahead`` (n, c, 2): points and derivatives of each span at the borders of its cells.
    ``tolerance`` mm: largest distance of a biarc from the curve.
    """
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
    result: F64 = wanted
    return result


@kernel(allocates=False)
def spread(sums: F64_2, grid: F64_2, number: I64_1, start: OutF64_1) -> None:
    """Write the parameters at which the pieces of spans start, ``start``, one span after another.

    Parameters
    ----------
    sums : (n, c)
        For each parameter of the grid, how many pieces the part of the span before it needs.
    grid : (n, c)
        Parameters of each span.
    number : (n,)
        Number of pieces of each span.
    """
    at = 0
    for row in range(len(number)):
        pieces = number[row]
        if pieces == 0:
            continue
        step = sums[row, -1] / pieces
        cell = 0
        for piece in range(pieces):
            fraction = piece * step
            while cell < sums.shape[1] - 2 and sums[row, cell + 1] <= fraction:
                cell += 1
            low = sums[row, cell]
            slope = (grid[row, cell + 1] - grid[row, cell]) / (sums[row, cell + 1] - low)
            start[at] = slope * (fraction - low) + grid[row, cell]
            at += 1
