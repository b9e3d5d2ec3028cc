"""similarity: shift, turn and scale of points, and the one that fits pairs of points best.

The least squares are solved in closed form: S. Umeyama, "Least-squares estimation of transformation
parameters between two point patterns", IEEE Transactions on Pattern Analysis and Machine
Intelligence 13 (1991) 376-380, equations 34 to 42.  With U D Vᵀ the singular value decomposition of
the covariance of targets and sources, the turn is R = U S Vᵀ and the scale tr(D S) / σ², where σ²
is the variance of the sources.  S is diag(1, ±1), so that R is no mirror: det(R) = 1.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from knifetip.geometry.columns import F64


class Similarity(NamedTuple):
    """The map from (x, y) to (a x - b y + shift x, b x + a y + shift y).

    a = scale · cos(turn) and b = scale · sin(turn).  Lines stay lines, and arcs keep their bulges.
    """

    a: float
    b: float
    x: float  #: shift along X: where the origin comes to (mm)
    y: float  #: shift along Y (mm)

    @property
    def scale(self) -> float:
        """Factor of all lengths."""
        return math.hypot(self.a, self.b)

    @property
    def turn(self) -> float:
        """Angle of the turn, counter-clockwise, -180 … 180 (degrees)."""
        return math.degrees(math.atan2(self.b, self.a))

    def apply(self, points: F64) -> F64:
        """Return where points come to, (…, 2) mm; ``points`` has the same shape."""
        x, y = points[..., 0], points[..., 1]
        return np.stack(
            [self.a * x - self.b * y + self.x, self.b * x + self.a * y + self.y], axis=-1
        )

    @property
    def inverse(self) -> Similarity:
        """The map back."""
        square = self.a * self.a + self.b * self.b
        a, b = self.a / square, -self.b / square
        return Similarity(a, b, -a * self.x + b * self.y, -b * self.x - a * self.y)


def fit_similarity(source: F64, target: F64, *, keep_scale: bool = False) -> Similarity:
    """Return the similarity that brings points closest to others, in the sum of squared distances.

    Parameters
    ----------
    source, target : (n, 2) mm
        n ≥ 2 points, and where they should come to.  At least two of the sources differ.
    keep_scale
        Whether the scale is 1; otherwise the scale with the least squares.
    """
    middle, goal = source.mean(axis=0), target.mean(axis=0)
    left, diagonal, right, sign = _decompose(source, target)
    (a, _), (b, _) = left @ np.diag([1.0, sign]) @ right
    variance = float(((source - middle) ** 2).sum()) / len(source)
    scale = 1.0 if keep_scale else float(diagonal[0] + sign * diagonal[1]) / variance
    a, b = scale * float(a), scale * float(b)
    x, y = float(middle[0]), float(middle[1])
    return Similarity(a, b, float(goal[0]) - a * x + b * y, float(goal[1]) - b * x - a * y)


def is_mirrored(source: F64, target: F64) -> bool:
    """Return whether points come closer to others if they are mirrored before they are turned.

    ``source`` and ``target`` are as for ``fit_similarity``.  Points on one line fit both ways; the
    result is then False.
    """
    _, diagonal, _, sign = _decompose(source, target)
    return sign < 0.0 and bool(diagonal[1] > 1e-6 * diagonal[0])


def _decompose(source: F64, target: F64) -> tuple[F64, F64, F64, float]:
    """Return U, the diagonal of D, Vᵀ and the last entry of S of the covariance of two sets."""
    covariance = (target - target.mean(axis=0)).T @ (source - source.mean(axis=0)) / len(source)
    left, diagonal, right = np.linalg.svd(covariance)
    return left, diagonal, right, float(np.sign(np.linalg.det(left) * np.linalg.det(right)))
