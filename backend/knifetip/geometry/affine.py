"""affine: affine transforms as matrices of six numbers.

The matrix (a, b, c, d, e, f) maps the point (x, y) to (a x + c y + e, b x + d y + f).
"""

from __future__ import annotations

from typing import Final, TypeAlias

#: The numbers a, b, c, d, e, f of an affine transform, in the order of SVG and PDF.
Matrix: TypeAlias = tuple[float, float, float, float, float, float]

IDENTITY: Final[Matrix] = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)


def compose(outer: Matrix, inner: Matrix) -> Matrix:
    """Return the matrix of the transform that applies ``inner`` first, then ``outer``."""
    a, b, c, d, e, f = outer
    g, h, i, j, k, m = inner
    return (
        a * g + c * h,
        b * g + d * h,
        a * i + c * j,
        b * i + d * j,
        a * k + c * m + e,
        b * k + d * m + f,
    )
