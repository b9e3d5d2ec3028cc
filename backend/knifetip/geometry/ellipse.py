"""ellipse: ellipses and elliptic arcs, approximated by lines and arcs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

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
        return fitted(fit_ellipses([self], tolerance, MAX_PIECES)[0])

    def exact_or_breaks(self) -> Segments | F64:
        """Return exact lines or arcs, or else the parameters (k,) at the ends of quarters.

        A circle becomes arcs, and a flat ellipse lines.

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
            corners = self._point(t)
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
            corners = self._point(breaks)
            straight = np.zeros(len(corners) - 1)
            return corners[:-1], corners[1:], straight, straight
        return breaks

    @property
    def is_closed(self) -> bool:
        """Whether the arc is a full turn."""
        return abs(self.last - self.first - 2.0 * np.pi) <= 1e-9

    def _point(self, t: F64) -> F64:
        """Return the points of the ellipse at parameters t (m,), (m, 2) mm."""
        result: F64 = self.centre + np.cos(t)[:, None] * self.u + np.sin(t)[:, None] * self.v
        return result


def fit_ellipses(ellipses: Sequence[Ellipse], tolerance: float, max_pieces: int) -> list[Fit]:
    """Return lines and arcs within a tolerance (mm) of each ellipse, or the reason if it has none.

    Raises
    ------
    GeometryError
        The ellipses together need more than ``max_pieces`` pieces.
    """
    fits: list[Fit] = []
    breaks: list[F64] = []
    rows: list[int] = []
    for row, one in enumerate(ellipses):
        try:
            found = one.exact_or_breaks()
        except GeometryError as error:
            fits.append(error)
            continue
        if isinstance(found, tuple):
            fits.append(found)
        else:
            fits.append(GeometryError("curve.bad-ellipse"))  # until it is fitted
            breaks.append(found)
            rows.append(row)
    if not rows:
        return fits
    centre = np.array([ellipses[row].centre for row in rows])
    u, v = (np.array([getattr(ellipses[row], axis) for row in rows]) for axis in ("u", "v"))

    def point(k: I64, t: F64) -> F64:
        result: F64 = centre[k] + np.cos(t)[:, None] * u[k] + np.sin(t)[:, None] * v[k]
        return result

    def tangent(k: I64, t: F64) -> F64:
        result: F64 = np.cos(t)[:, None] * v[k] - np.sin(t)[:, None] * u[k]
        return result

    spans = Pieces(
        np.concatenate([one[:-1] for one in breaks]),
        np.concatenate([one[1:] for one in breaks]),
        np.repeat(np.arange(len(rows)), [len(one) - 1 for one in breaks]),
    )
    many = fit_spans(point, tangent, spans, len(rows), tolerance, max_pieces)
    for row, fit in zip(rows, split_fits(many, len(rows)), strict=True):
        if isinstance(fit, tuple) and ellipses[row].is_closed:
            fit[1][-1] = fit[0][0]
        fits[row] = fit
    return fits
