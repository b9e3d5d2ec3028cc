"""spline: rational B-splines, approximated by lines and arcs.

Source: de Boor's recurrence, "A Practical Guide to Splines" (1978).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from knifetip.errors import GeometryError
from knifetip.geometry.columns import F64
from knifetip.geometry.curve import Segments, fit
from knifetip.geometry.tolerance import CURVE
from knifetip.kernels import F64_1, F64_2, kernel


@kernel
def de_boor(t: F64_1, rows: F64_2, knots: F64_1, degree: int) -> Any:
    """Return points of a polynomial B-spline by de Boor's recurrence, (m, c).

    Parameters
    ----------
    t : (m,)
        The parameters.
    rows : (k, c)
        Control points in c dimensions.
    knots : (k + degree + 1,)
        Knots, never decreasing; some knot with an index from ``degree`` to k - 1 is less than the
        next one.
    degree
        Degree of the polynomials.
    """
    count, size = rows.shape
    # A span of no length has no points; use the last span before it that has a length.
    filled = np.empty(count, np.int64)
    last = -1
    for span in range(degree, count):
        if knots[span] < knots[span + 1]:
            last = span
        filled[span] = last
    points = np.empty((len(t), size))
    d = np.empty((degree + 1, size))
    for row in range(len(t)):
        low, high = 0, len(knots)
        while low < high:
            middle = (low + high) // 2
            if t[row] < knots[middle]:
                high = middle
            else:
                low = middle + 1
        span = filled[min(max(low - 1, degree), count - 1)]
        if span < 0:
            span = last
        for j in range(degree + 1):
            for column in range(size):
                d[j, column] = rows[span - degree + j, column]
        for level in range(1, degree + 1):
            for j in range(degree, level - 1, -1):
                begin = knots[span - degree + j]
                wide = knots[span + 1 + j - level] - begin
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

    @property
    def breaks(self) -> F64:
        """Parameters between which the spline is smooth, increasing, both ends included."""
        inside = self.knots[self.degree : len(self.control) + 1]
        return np.unique(inside)

    def _homogeneous(self) -> F64:
        """Return the k control points as homogeneous coordinates, (k, 3): x w, y w, weight w."""
        return np.hstack([self.control * self.weights[:, None], self.weights[:, None]])

    def point(self, t: F64) -> F64:
        """Return the points of the spline at parameters t (m,), (m, 2) mm."""
        value = de_boor(t, self._homogeneous(), self.knots, self.degree)
        result: F64 = value[:, :2] / value[:, 2:]
        return result

    def tangent(self, t: F64) -> F64:
        """Return the derivatives of the spline by t at parameters t (m,), (m, 2) mm.

        At a corner of the spline it is the derivative after the corner.
        """
        p = self.degree
        rows = self._homogeneous()
        value = de_boor(t, rows, self.knots, p)
        wide = self.knots[p + 1 : len(rows) + p] - self.knots[1 : len(rows)]
        slope = p * np.diff(rows, axis=0) / np.where(wide > 0.0, wide, 1.0)[:, None]
        rate = de_boor(t, slope, self.knots[1:-1], p - 1)
        # (A / w)′ = (A′ - (A / w) w′) / w, and w > 0 changes no direction.
        result: F64 = rate[:, :2] - value[:, :2] / value[:, 2:] * rate[:, 2:]
        return result

    def to_segments(self, tolerance: float = CURVE) -> Segments:
        """Return lines and arcs within a tolerance (mm) of the spline, with their errors.

        Raises
        ------
        GeometryError
            The spline has no finite points, or needs more than 100,000 pieces.
        """
        breaks = self.breaks
        if self.degree == 1:
            corners = self.point(breaks)
            some = np.any(corners[:-1] != corners[1:], axis=1)
            straight = np.zeros(int(some.sum()))
            return corners[:-1][some], corners[1:][some], straight, straight
        return fit(self.point, self.tangent, breaks, tolerance)
