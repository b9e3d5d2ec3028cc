"""spline: rational B-splines, approximated by lines and arcs.

Source: de Boor's recurrence, "A Practical Guide to Splines" (1978).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from knifetip.errors import GeometryError
from knifetip.geometry.biarcs import Pieces
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.curve import (
    MAX_PIECES,
    Fit,
    Segments,
    fit_spans,
    fitted,
    split_fits,
)
from knifetip.geometry.tolerance import CURVE
from knifetip.kernels import F64_1, F64_2, I64_1, OutI64_1, kernel


class SplineTable(NamedTuple):
    """s polynomial B-splines: their control points and knots, one spline after another."""

    rows: F64_2  #: (k, c) control points in c dimensions
    knots: F64_1
    first_row: I64_1  #: (s + 1,) first control point of each spline
    first_knot: I64_1  #: (s + 1,) first knot of each spline; there are more than control points
    degree: I64_1  #: (s,) degree of the polynomials
    #: (k,) for each control point, the last span of its spline with a length that is not after it
    span: I64_1


@kernel(allocates=False)
def find_spans(
    knots: F64_1, first_row: I64_1, first_knot: I64_1, degree: I64_1, span: OutI64_1
) -> None:
    """Write the column ``span`` of a ``SplineTable`` with these columns.

    A span of no length has no points; the last span before it that has a length is used, or the
    last span of the spline if there is none.  Some knot of each spline with an index from its
    degree to its number of control points - 1 is less than the next one.
    """
    for spline in range(len(degree)):
        low, high, base = first_row[spline], first_row[spline + 1], first_knot[spline]
        last = -1
        for number in range(degree[spline], high - low):
            if knots[base + number] < knots[base + number + 1]:
                last = number
            span[low + number] = last
        for number in range(degree[spline], high - low):
            if span[low + number] < 0:
                span[low + number] = last


@kernel
def de_boor(t: F64_1, spline: I64_1, table: SplineTable) -> Any:
    """Return points of polynomial B-splines by de Boor's recurrence, (m, c).

    Parameters
    ----------
    t : (m,)
        The parameters.
    spline : (m,)
        Number of the spline of each point.
    table
        The splines.
    """
    rows, knots, first_row, first_knot, degrees, spans = table
    size = rows.shape[1]
    points = np.empty((len(t), size))
    most = 0
    for degree in degrees:
        most = max(most, degree)
    d = np.empty((most + 1, size))
    for row in range(len(t)):
        degree, base = degrees[spline[row]], first_knot[spline[row]]
        first = first_row[spline[row]]
        low, high = base, first_knot[spline[row] + 1]
        while low < high:
            middle = (low + high) // 2
            if t[row] < knots[middle]:
                high = middle
            else:
                low = middle + 1
        count = first_row[spline[row] + 1] - first
        span = spans[first + min(max(low - base - 1, degree), count - 1)]
        for j in range(degree + 1):
            for column in range(size):
                d[j, column] = rows[first + span - degree + j, column]
        for level in range(1, degree + 1):
            for j in range(degree, level - 1, -1):
                begin = knots[base + span - degree + j]
                wide = knots[base + span + 1 + j - level] - begin
                fraction = (t[row] - begin) / wide if wide > 0.0 else 0.0
                for column in range(size):
                    d[j, column] = (1.0 - fraction) * d[j - 1, column] + fraction * d[j, column]
        for column in range(size):
            points[row, column] = d[degree, column]
    return points


@dataclass(frozen=True, eq=False, slots=True)
class Spline:
    """Rational B-spline curve in the plane, defined by control points, weights and knots.

    All weights are 1 for a polynomial B-spline.
    """

    control: F64  #: (k, 2) control points (mm)
    weights: F64  #: (k,) weights of the control points, > 0
    knots: F64  #: (k + degree + 1,) parameters, never decreasing
    degree: int  #: degree of the polynomials, at least 1

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

    def to_segments(self, tolerance: float = CURVE) -> Segments:
        """Return lines and arcs within a tolerance (mm) of the spline, with their errors.

        Raises
        ------
        GeometryError
            The spline has no finite points, or needs more than 100,000 pieces.
        """
        return fitted(fit_splines([self], tolerance, MAX_PIECES)[0])


class Splines:
    """s rational B-splines, evaluated together.

    Parameters
    ----------
    splines
        The splines, at least one.
    """

    def __init__(self, splines: Sequence[Spline]) -> None:
        control = np.concatenate([one.control for one in splines])
        weights = np.concatenate([one.weights for one in splines])
        knots = np.concatenate([one.knots for one in splines])
        count = np.array([len(one.control) for one in splines], np.int64)
        degree = np.array([one.degree for one in splines], np.int64)
        # Homogeneous coordinates: x w, y w, weight w.
        rows = np.hstack([control * weights[:, None], weights[:, None]])
        self.table = _table(rows, knots, count, degree)
        self._slopes = self._derivatives(count)

    @property
    def breaks(self) -> tuple[F64, I64]:
        """Parameters between which the splines are smooth, (n,), and the spline of each, (n,).

        Both ends are included; the parameters of a spline are increasing.
        """
        table = self.table
        spline = np.repeat(np.arange(len(table.degree)), np.diff(table.first_knot))
        number = np.arange(len(table.knots)) - table.first_knot[spline]
        count = np.diff(table.first_row)[spline]
        is_first = number == table.degree[spline]
        inside = (number >= table.degree[spline]) & (number <= count)
        inside &= is_first | (np.diff(table.knots, prepend=np.nan) > 0.0)
        return table.knots[inside], spline[inside]

    def point(self, spline: I64, t: F64) -> F64:
        """Return the points at parameters t (m,) of splines with numbers (m,), (m, 2) mm."""
        value = de_boor(t, spline, self.table)
        result: F64 = value[:, :2] / value[:, 2:]
        return result

    def tangent(self, spline: I64, t: F64) -> F64:
        """Return the derivatives at parameters t (m,) of splines with numbers (m,), (m, 2) mm.

        At a corner of a spline it is the derivative after the corner.
        """
        value = de_boor(t, spline, self.table)
        rate = de_boor(t, spline, self._slopes)
        # (A / w)′ = (A′ - (A / w) w′) / w, and w > 0 changes no direction.
        result: F64 = rate[:, :2] - value[:, :2] / value[:, 2:] * rate[:, 2:]
        return result

    def _derivatives(self, count: I64) -> SplineTable:
        """Return the derivatives of the splines, which have ``count`` (s,) control points."""
        rows, knots, first_row, first_knot, degree, _ = self.table
        spline = np.repeat(np.arange(len(count)), count - 1)
        low = np.arange(len(spline)) + spline
        knot = low - first_row[spline] + first_knot[spline]
        wide = knots[knot + degree[spline] + 1] - knots[knot + 1]
        change = degree[spline][:, None] * (rows[low + 1] - rows[low])
        slope = change / np.where(wide > 0.0, wide, 1.0)[:, None]
        inner = np.ones(len(knots), np.bool_)
        inner[first_knot[:-1]] = inner[first_knot[1:] - 1] = False
        return _table(slope, knots[inner], count - 1, degree - 1)


def _table(rows: F64, knots: F64, count: I64, degree: I64) -> SplineTable:
    """Return s polynomial B-splines, which have ``count`` (s,) control points."""
    first_row = np.concatenate([[0], np.cumsum(count)])
    first_knot = np.concatenate([[0], np.cumsum(count + degree + 1)])
    span = np.full(len(rows), -1, np.int64)
    find_spans(knots, first_row, first_knot, degree, span)
    return SplineTable(rows, knots, first_row, first_knot, degree, span)


def fit_splines(splines: Sequence[Spline], tolerance: float, max_pieces: int) -> list[Fit]:
    """Return lines and arcs within a tolerance (mm) of each spline, or the reason if it has none.

    Raises
    ------
    GeometryError
        The splines together need more than ``max_pieces`` pieces.
    """
    if not splines:
        return []
    curves = Splines(splines)
    breaks, spline = curves.breaks
    corners = curves.point(spline, breaks)
    inner = spline[1:] == spline[:-1]
    curved = inner & (curves.table.degree[spline[1:]] > 1)
    spans = Pieces(breaks[:-1][curved], breaks[1:][curved], spline[1:][curved])
    fits = fit_spans(curves.point, curves.tangent, spans, len(splines), tolerance, max_pieces)
    found = split_fits(fits, len(splines))
    first = np.searchsorted(spline, np.arange(len(splines) + 1))
    for number in np.flatnonzero(curves.table.degree == 1).tolist():
        path = corners[first[number] : first[number + 1]]
        some = np.any(path[:-1] != path[1:], axis=1)
        straight = np.zeros(int(some.sum()))
        found[number] = path[:-1][some], path[1:][some], straight, straight
    return found
