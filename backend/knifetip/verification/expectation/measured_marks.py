"""Where the edges of a drawing belong on a printed sheet whose marks were measured.

The verifier computes the map from the marks by itself, as a complex regression without weights::

    w = p z + q,   p = Σ conj(z - z̄) (w - w̄) / Σ |z - z̄|²,   q = w̄ - p z̄

for marks z of the drawing, measured at w.  The derivative of the sum of |w - p z - q|² with respect
to p and q is 0 there.  If the scale is kept, p is divided by its modulus, which minimises the same
sum among numbers of modulus 1.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from knifetip.model.registration import Registration
from knifetip.verification.columns import F64

Complex = NDArray[np.complex128]


class MarkMap(NamedTuple):
    """The map w = p z + q from the drawing to the table, and its n errors."""

    factor: complex  #: p: its modulus is the scale, its angle the turn
    shift: complex  #: q (mm)
    errors: F64  #: (n,) distance of each mark from where it was measured (mm)

    def place(self, points: Complex) -> Complex:
        """Return where points of the drawing belong on the table."""
        return self.factor * points + self.shift


def map_marks(registration: Registration | None) -> MarkMap | None:
    """Return the map from the drawing to the table; None if no marks were measured."""
    if registration is None or not registration.measured:
        return None
    drawn, measured = as_complex(registration.marks), as_complex(registration.measured)
    middle, goal = drawn.mean(), measured.mean()
    spread = (drawn - middle).conj()
    factor = complex((spread * (measured - goal)).sum() / (np.abs(spread) ** 2).sum())
    if registration.scale == "keep":
        factor /= abs(factor)
    shift = complex(goal - factor * middle)
    return MarkMap(factor, shift, np.abs(factor * drawn + shift - measured))


def sheet_turn(registration: Registration | None) -> complex:
    """Return exp(i · turn) of a sheet on the table; 1 if no marks were measured."""
    found = map_marks(registration)
    return 1.0 + 0.0j if found is None else found.factor / abs(found.factor)


def as_complex(points: F64 | tuple[tuple[float, float], ...]) -> Complex:
    """Return points (…, 2) mm as complex numbers, (…,)."""
    pairs = np.asarray(points, np.float64)
    return pairs[..., 0] + 1j * pairs[..., 1]
