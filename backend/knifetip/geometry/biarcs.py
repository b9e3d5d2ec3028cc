"""biarcs: one biarc for each piece of a curve, and its distance from the curve.

A biarc is two tangent arcs with the points and directions of the curve at the ends of the piece.

Source: biarc with equal tangent lengths, Bolton, "Biarc curves", Computer-Aided Design 7 (1975).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final, NamedTuple, TypeAlias

import numpy as np

from knifetip.geometry.azimuth import tan_half_angle
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_2, F64_3, I64_1, Bool_1, OutF64_1, inline_kernel, kernel

#: Function from numbers of curves (m,) and their parameters (m,) to points or directions (m, 2).
EvaluateEach: TypeAlias = Callable[[I64, F64], F64]

#: Parameters of the points of a piece, 0 … 1, at which its biarc is measured.
_ALL_FRACTIONS: Final = (np.linspace(0.0, 1.0, 26)[1:-1],)
#: The same in two steps: most biarcs that are not good are found at the first points.
_PROBE_FRACTIONS: Final = (
    _ALL_FRACTIONS[0][6::11],
    np.delete(_ALL_FRACTIONS[0], np.s_[6::11]),
)
#: Number of pieces up to which all points are measured in one step.
_FEW: Final = 256
#: Fraction of the tolerance that a measured deviation may use; the maximum may be between probes.
_MARGIN: Final = 0.97
#: Largest bulge of an arc (106°); longer arcs are not measured reliably.
_MAX_BULGE: Final = 0.5


class Pieces(NamedTuple):
    """m pieces of curves: the parts between two parameters of a curve."""

    first: F64  #: (m,) parameter at which the piece starts
    last: F64  #: (m,) parameter at which the piece ends
    curve: I64  #: (m,) number of the curve of the piece

    def select(self, rows: I64 | Bool | slice) -> Pieces:
        """Return the pieces in ``rows``, which are indices or a mask."""
        return Pieces(self.first[rows], self.last[rows], self.curve[rows])


def fit_biarcs(
    point: EvaluateEach, tangent: EvaluateEach, pieces: Pieces, tolerance: float
) -> tuple[F64, F64, F64, Bool]:
    """Return the biarc of each of m pieces of curves, its error, and whether it is good.

    A biarc is good if its distance from the curve is within the tolerance (mm) and the bulges of
    its arcs are at most ``_MAX_BULGE``.  ``point`` and ``tangent`` are functions from numbers of
    curves and parameters to points and derivatives.

    Returns ``joint`` (m, 2) mm: point at which the two arcs of each biarc meet; ``bulge`` (m, 2):
    bulges of the two arcs; ``error`` (m,) mm: greatest distance of each good biarc from the curve;
    ``good`` (m,): whether each biarc is good.
    """
    first, last, curve = pieces
    a, b = point(curve, first), point(curve, last)
    # A piece that ends in a corner has its own direction just before its end.
    u = _normalise(tangent(curve, first))
    v = _normalise(tangent(curve, np.nextafter(last, first)))
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

    # At a cusp the direction is undefined; use the chord if it is within tolerance.
    may_be_chord = ~np.isfinite(bulge).all(axis=1) | (square <= (4.0 * tolerance) ** 2)
    error = np.where((np.abs(bulge) <= _MAX_BULGE).all(axis=1), 0.0, np.inf)
    chord_error = np.where(may_be_chord, 0.0, np.inf)
    for fractions in _PROBE_FRACTIONS if len(a) >= _FEW else _ALL_FRACTIONS:
        rows = np.flatnonzero((error <= tolerance) | (chord_error <= tolerance))
        if not len(rows):
            break
        begin = first[rows]
        t = begin[:, None] + (last[rows] - begin)[:, None] * fractions
        probes = point(np.repeat(curve[rows], len(fractions)), t.reshape(-1))
        measure(
            Biarcs(a, joint, b, bulge, one_arc),
            rows,
            probes.reshape(len(rows), -1, 2),
            tolerance * _MARGIN,
            error,
            chord_error,
        )
    good = error <= tolerance
    blunt = ~good & (chord_error <= tolerance)
    joint[blunt], bulge[blunt], error[blunt] = b[blunt], 0.0, chord_error[blunt]
    bulge[np.abs(bulge) < BULGE] = 0.0
    enough: Bool = good | blunt
    return joint, bulge, error, enough


class Biarcs(NamedTuple):
    """m biarcs: arcs from a start to a joint, and from there to an end."""

    start: F64_2  #: (m, 2)
    joint: F64_2  #: (m, 2)
    end: F64_2  #: (m, 2)
    bulge: F64_2  #: (m, 2) bulges of both arcs
    is_one_arc: Bool_1  #: (m,) whether the first arc ends at the end, and there is no second one


@kernel(allocates=False)
def measure(
    biarcs: Biarcs,
    rows: I64_1,
    probes: F64_3,
    tolerance: float,
    error: OutF64_1,
    chord_error: OutF64_1,
) -> None:
    """Increase the errors of biarcs and of their chords to the distances of points from them.

    Parameters
    ----------
    biarcs
        All m biarcs.
    rows : (r,)
        The biarcs that are measured.
    probes : (r, k, 2)
        Points of the curve that each of these biarcs approximates.
    tolerance
        Largest error; an error that exceeds it becomes infinite, and is not measured further.
    error, chord_error : (m,)
        Greatest distance of points from each biarc and from its chord; infinite ones are skipped.
    """
    start, joint, end, bulge, is_one_arc = biarcs
    for at in range(len(rows)):
        row = rows[at]
        if error[row] < np.inf:
            most = 0.0
            first = _frame(start, joint, row, bulge[row, 0])
            second = _frame(joint, end, row, bulge[row, 1])
            for probe in range(probes.shape[1]):
                x, y = probes[at, probe, 0], probes[at, probe, 1]
                distance = _distance(first, x, y)
                if not is_one_arc[row]:
                    distance = min(distance, _distance(second, x, y))
                if not distance <= tolerance:
                    most = np.inf
                    break
                most = max(most, distance)
            error[row] = max(error[row], most / _MARGIN)
        if chord_error[row] < np.inf:
            most = 0.0
            chord = _frame(start, end, row, 0.0)
            for probe in range(probes.shape[1]):
                distance = _distance(chord, probes[at, probe, 0], probes[at, probe, 1])
                if not distance <= tolerance:
                    most = np.inf
                    break
                most = max(most, distance)
            chord_error[row] = max(chord_error[row], most / _MARGIN)


class Frame(NamedTuple):
    """A line or arc in coordinates with the origin at its start and x along its chord."""

    x: float  #: start
    y: float
    ahead_x: float  #: direction of the chord
    ahead_y: float
    length: float  #: length of the chord
    bulge: float  #: 0 for a line
    middle_y: float  #: y of the centre
    radius: float
    half: float  #: half the sweep (radians)


@inline_kernel
def _frame(start: F64_2, end: F64_2, row: int, bulge: float) -> Frame:
    """Return the line or arc from ``start[row]`` to ``end[row]`` as a frame."""
    x, y = end[row, 0] - start[row, 0], end[row, 1] - start[row, 1]
    length = math.hypot(x, y)
    if not length > 0.0:
        length = 1.0
    ahead_x, ahead_y = x / length, y / length
    x, y = start[row, 0], start[row, 1]
    if abs(bulge) < BULGE:
        return Frame(x, y, ahead_x, ahead_y, length, 0.0, 0.0, 0.0, 0.0)
    middle_y = length * (1.0 - bulge * bulge) / (4.0 * bulge)
    radius = length * (1.0 + bulge * bulge) / (4.0 * abs(bulge))
    half = 2.0 * math.atan(abs(bulge)) + 1e-15
    return Frame(x, y, ahead_x, ahead_y, length, bulge, middle_y, radius, half)


@inline_kernel
def _distance(frame: Frame, at_x: float, at_y: float) -> float:
    """Return the distance of a point from a line or arc."""
    from_x, from_y = at_x - frame.x, at_y - frame.y
    ahead_x, ahead_y, length, bulge = frame.ahead_x, frame.ahead_y, frame.length, frame.bulge
    x = from_x * ahead_x + from_y * ahead_y
    y = from_x * -ahead_y + from_y * ahead_x
    if bulge == 0.0:
        if x >= 0.0 and x <= length:
            return abs(y)
        return min(math.hypot(x, y), math.hypot(x - length, y))
    rx, ry = x - length / 2.0, y - frame.middle_y
    # The ray from the centre through the point meets the arc if it points into its sector.
    out = -1.0 if bulge > 0.0 else 1.0
    if math.atan2(abs(rx), ry * out) <= frame.half:
        return abs(math.hypot(rx, ry) - frame.radius)
    return min(math.hypot(x, y), math.hypot(x - length, y))


def _normalise(vectors: F64) -> F64:
    """Return vectors, (n, 2), scaled to length 1; NaN for zero vectors."""
    return vectors / np.hypot(vectors[:, 0], vectors[:, 1])[:, None]
