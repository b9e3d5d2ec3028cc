"""azimuth: directions of vectors as unit vectors and as azimuths.

An azimuth is an angle in degrees, counter-clockwise from +x.

Source: Yang, Du, Shu & Qian, "Study on tool compensation of NC carton samplemaker", 4.1.  The
source distinguishes five cases of arctan, which one call of arctan2 combines.
"""

from __future__ import annotations

import numpy as np

from knifetip.errors import ZeroLengthEdge
from knifetip.geometry.columns import F64
from knifetip.geometry.tolerance import POINT


def unit_vectors(vectors: F64) -> F64:
    """Return vectors, (n, 2) mm, scaled to length 1.

    Raises
    ------
    ZeroLengthEdge
        A vector shorter than ``tolerance.POINT`` has no direction.
    """
    length = np.hypot(vectors[..., 0], vectors[..., 1])
    short = ~(length >= POINT)  # written so that NaN is refused too
    if short.any():
        raise ZeroLengthEdge(np.flatnonzero(short))
    result: F64 = vectors / length[..., None]
    return result


def azimuth(vectors: F64) -> F64:
    """Return the azimuths of n vectors, (n, 2), in degrees, (n,), at least 0 and below 360."""
    degrees = np.degrees(np.arctan2(vectors[..., 1], vectors[..., 0])) % 360.0
    # Just below the x axis the remainder may round up to 360.0.
    folded: F64 = np.where(degrees >= 360.0, 0.0, degrees)
    return folded


def right_normal(vectors: F64) -> F64:
    """Return vectors, (n, 2), rotated by -90 degrees: normals to the right of travel."""
    return np.stack([vectors[..., 1], -vectors[..., 0]], axis=-1)


def left_normal(vectors: F64) -> F64:
    """Return vectors, (n, 2), rotated by +90 degrees: normals to the left of travel."""
    return np.stack([-vectors[..., 1], vectors[..., 0]], axis=-1)


def turn_angle(before: F64, after: F64) -> F64:
    """Return the turn from each azimuth ``before`` to the azimuth ``after``, (n,) degrees.

    The turn is positive to the left, greater than -180 and at most 180.
    """
    folded: F64 = 180.0 - (180.0 - (after - before)) % 360.0
    return folded


def tan_half_angle(before: F64, after: F64) -> F64:
    """Return tan of half the angle from each vector ``before`` to the vector ``after``, (n,).

    The vectors have the shape (n, 2).  The result is the bulge of an arc if the vectors are the
    tangent at the arc's start and its chord, or its chord and the tangent at its end.
    """
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    dot = (before * after).sum(axis=1)
    result: F64 = cross / (np.hypot(cross, dot) + dot)
    return result


def unwrap(azimuths: F64, period: float = 360.0) -> F64:
    """Return azimuths, (n,) degrees, without jumps between successive values.

    Multiples of ``period`` degrees are added to each azimuth so that it is as near as possible to
    the preceding azimuth.  The period is 360, or 180 for a tool that is the same from both sides,
    such as a crease wheel.
    """
    return np.unwrap(azimuths, period=period)
