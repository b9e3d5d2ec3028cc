"""ellipse: ellipses and elliptic arcs, approximated by lines and arcs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.errors import GeometryError
from knifetip.geometry.columns import F64
from knifetip.geometry.curve import Segments, fit
from knifetip.geometry.tolerance import CURVE


@dataclass(frozen=True, eq=False, slots=True)
class Ellipse:
    """Elliptic arc: the points c + u cos t + v sin t for t from ``first`` to ``last`` (radians).

    The point c is the centre; the vectors u and v need not be perpendicular.
    """

    centre: F64  #: (2,) centre c (mm)
    u: F64  #: (2,) u, from the centre to the point at t = 0 (mm)
    v: F64  #: (2,) v, from the centre to the point at t = π/2 (mm)
    first: float  #: parameter t of the start (radians)
    last: float  #: parameter t of the end (radians), at most a full turn after ``first``

    def point(self, t: F64) -> F64:
        """Return the points of the ellipse at parameters t (m,), (m, 2) mm."""
        result: F64 = self.centre + np.cos(t)[:, None] * self.u + np.sin(t)[:, None] * self.v
        return result

    def tangent(self, t: F64) -> F64:
        """Return the derivatives of the ellipse by t at parameters t (m,), (m, 2) mm."""
        result: F64 = np.cos(t)[:, None] * self.v - np.sin(t)[:, None] * self.u
        return result

    def to_segments(self, tolerance: float = CURVE) -> Segments:
        """Return lines and arcs within a tolerance (mm) of the ellipse, with their errors.

        A circle becomes exact arcs.  Otherwise each quarter between the ends of the axes is
        approximated.  If u and v are parallel, the ellipse is flat and becomes lines; a full flat
        ellipse becomes lines that run forth and back over the same points.

        Raises
        ------
        GeometryError
            A coordinate is not a finite number, or ``last`` is not after ``first``.
        """
        turn = self.last - self.first
        shape = np.concatenate([self.centre, self.u, self.v, [self.first, self.last]])
        if not np.isfinite(shape).all() or not 0.0 < turn <= 2.0 * np.pi + 1e-9:
            raise GeometryError("curve.bad-ellipse")
        # At the ends of the axes, where u cos t + v sin t is longest, tan 2t = 2 u·v / (u² - v²).
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
            return corners[:-1], corners[1:], bulge, np.zeros(rows)
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
            straight = np.zeros(len(corners) - 1)
            return corners[:-1], corners[1:], straight, straight
        start, end, bulge, error = fit(self.point, self.tangent, breaks, tolerance)
        if abs(turn - 2.0 * np.pi) <= 1e-9:
            end[-1] = start[0]
        return start, end, bulge, error
