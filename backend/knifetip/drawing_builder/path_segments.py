"""Approximate the segments of paths by lines and circular arcs, many curves at a time.

A circular arc that is rotated, mirrored or evenly scaled remains an arc.  All other arcs and all
Bézier curves are approximated by arcs.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.drawing_builder.path_table import (
    ARC,
    CUBIC,
    LINE,
    Table,
    half_chords,
    transform_points,
    transform_vectors,
)
from knifetip.errors import DrawingTooLarge, GeometryError
from knifetip.formats.limits import Limits
from knifetip.geometry.biarcs import EvaluateEach
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.curve import fit_many
from knifetip.messages import Message

#: Fraction of the tolerance within which an arc counts as circular and a curve as straight.
_SHAPE_TOLERANCE: Final = 0.01


def too_many(limits: Limits, format_name: str) -> DrawingTooLarge:
    """Return the error for a file that has more segments than ``limits`` allow.

    ``format_name`` is the name of the file format in the message, such as "SVG".
    """
    return DrawingTooLarge("reading.too-many-segments", format=format_name, limit=limits.segments)


class PlacedSegments:
    """The segments of the paths of an SVG or PDF file, converted to file units.

    Lines are stored by their ends, Bézier curves by their control points, and elliptic arcs by
    centre, axes and angles.
    """

    def __init__(self, table: Table, matrices: F64) -> None:
        numbers = table.numbers
        self.failed: dict[int, Message] = {}  #: reason by segment that cannot be fitted
        self.kind = table.kind.copy()
        self.start = transform_points(matrices, numbers[:, :2])
        self.end = transform_points(matrices, numbers[:, 2:4])
        self.cubic = np.flatnonzero(self.kind == CUBIC)
        bezier, inner = matrices[self.cubic], numbers[self.cubic, 4:]
        self.control = np.stack(
            [
                self.start[self.cubic],
                transform_points(bezier, inner[:, :2]),
                transform_points(bezier, inner[:, 2:]),
                self.end[self.cubic],
            ],
            axis=1,
        )
        # SVG omits an arc between equal points; as a line without length it is dropped and
        # reported.
        same = (numbers[:, 0] == numbers[:, 2]) & (numbers[:, 1] == numbers[:, 3])
        self.kind[(self.kind == ARC) & same] = LINE
        self.arc = np.flatnonzero(self.kind == ARC)
        centre, u, v, self.first, self.turn = _centre_form(numbers[self.arc])
        elliptic = matrices[self.arc]
        self.centre = transform_points(elliptic, centre)
        self.u = transform_vectors(elliptic, u)
        self.v = transform_vectors(elliptic, v)


def _centre_form(numbers: F64) -> tuple[F64, F64, F64, F64, F64]:
    """Return centre, semi-axes u and v, first angle and sweep of n elliptic arcs.

    A point of an arc is centre + u cos t + v sin t, for t from the first angle to first angle +
    sweep (radians).  Centre, u and v have shape (n, 2), the angles shape (n,).

    Source: SVG 1.1, appendix F.6.5 and F.6.6.

    ``numbers`` (n, 8): for each arc: x and y of the start, x and y of the end, both radii, the
    angle of the first radius (degrees), and flags: 1 for a sweep above 180° plus 2 for increasing
    angles.
    """
    angle = np.radians(numbers[:, 6])
    cosine, sine = np.cos(angle), np.sin(angle)
    rx, ry = numbers[:, 4], numbers[:, 5]
    large = numbers[:, 7] % 2.0 == 1.0
    rising = numbers[:, 7] >= 2.0
    middle = (numbers[:, :2] + numbers[:, 2:4]) / 2.0
    x, y = half_chords(numbers)
    chord = x * x + y * y
    # Radii that are too small are increased until the arc reaches both ends.
    grown = np.sqrt(np.maximum(chord, 1.0))
    x, y, rx, ry = x / grown, y / grown, rx * grown, ry * grown
    chord = np.where(chord > 1.0, 1.0, chord)
    off = np.sqrt(np.maximum(1.0 / chord - 1.0, 0.0)) * np.where(large == rising, -1.0, 1.0)
    centre_x, centre_y = off * y, -off * x
    first = np.arctan2(y - centre_y, x - centre_x)
    # From the chord: the difference of two angles would lose the sweep of a short arc.
    turn = 2.0 * np.arcsin(np.sqrt(chord))
    turn = np.where(large, 2.0 * np.pi - turn, turn) * np.where(rising, 1.0, -1.0)
    u = np.stack([rx * cosine, rx * sine], axis=1)
    v = np.stack([-ry * sine, ry * cosine], axis=1)
    return middle + centre_x[:, None] * u + centre_y[:, None] * v, u, v, first, turn


class FittedSegments(NamedTuple):
    """n lines and arcs, in the order of the file, that were made from m segments of paths."""

    ends: F64  #: (n, 2, 2) ends (file units)
    bulge: F64  #: (n,) bulges
    error: F64  #: (n,) greatest distance from the curve of the file (file units)
    origin: I64  #: (n,) index of the segment from which each line or arc was made
    curved: Bool  #: (m,) mask of the segments that were approximated by arcs


def fit_segments(
    placed: PlacedSegments, tolerance: float, limits: Limits, format_name: str
) -> FittedSegments:
    """Return the segments of a drawing as n lines and arcs, in the order of the file.

    Parameters
    ----------
    placed
        m segments of the paths of the file.
    tolerance
        Maximum distance between a curve and its arcs (file units).
    limits
        Limits of the number of segments and of the time.
    format_name
        Name of the file format in error messages.

    Raises
    ------
    DrawingTooLarge
        The number of lines and arcs or the time exceeds its limit.
    """
    curved = np.zeros(len(placed.kind), bool)
    straight = np.flatnonzero(placed.kind == LINE)
    parts = [_lines(placed, straight, 0.0)]

    chord = placed.control[:, 3] - placed.control[:, 0]
    is_line = _are_straight(placed.control, chord, _SHAPE_TOLERANCE * tolerance)
    parts.append(_lines(placed, placed.cubic[is_line], _SHAPE_TOLERANCE * tolerance))
    bent = np.flatnonzero(~is_line)
    curved[placed.cubic[bent]] = True

    size_u, size_v = (np.hypot(*vectors.T) for vectors in (placed.u, placed.v))
    dot_product = np.abs((placed.u * placed.v).sum(axis=1))
    larger = np.maximum(size_u, size_v)
    off = np.maximum(np.abs(size_u - size_v), dot_product / np.where(larger > 0.0, larger, 1.0))
    circle = off <= _SHAPE_TOLERANCE * tolerance
    parts.append(_circular_arcs(placed, np.flatnonzero(circle), off))
    oval = np.flatnonzero(~circle)
    curved[placed.arc[oval]] = True

    total = sum(len(part[1]) for part in parts)
    for indices, numbers, point, tangent in (
        (bent, placed.cubic, *_bezier(placed.control)),
        (oval, placed.arc, *_elliptic(placed)),
    ):
        try:
            part = _fit_arcs(
                placed, indices, numbers, point, tangent, tolerance, limits.segments - total
            )
        except GeometryError:
            raise too_many(limits, format_name) from None
        total += len(part[1])
        parts.append(part)
    if total > limits.segments:
        raise too_many(limits, format_name)
    ends, bulge, error, origin = (np.concatenate(column) for column in zip(*parts, strict=True))
    order = np.argsort(origin, kind="stable")
    return FittedSegments(ends[order], bulge[order], error[order], origin[order], curved)


def _lines(placed: PlacedSegments, rows: I64, error: float) -> tuple[F64, F64, F64, I64]:
    """Return ends, bulges, errors and segment indices of the segments ``rows`` as lines.

    ``error`` is the greatest distance of a segment from its line (file units).
    """
    ends = np.stack([placed.start[rows], placed.end[rows]], axis=1)
    return ends, np.zeros(len(rows)), np.full(len(rows), error), rows


def _are_straight(control: F64, chord: F64, tolerance: float) -> Bool:
    """Return the mask of the Bézier curves that are straight, (n,).

    A curve is straight if all its control points are near its chord, or are equal.

    ``control`` (n, 4, 2): control points of each curve (file units).
    ``chord`` (n, 2): vector from the start to the end of each curve.
    ``tolerance``: maximum distance of a control point from the chord (file units).
    """
    size = np.hypot(chord[:, 0], chord[:, 1])
    ahead = chord / np.where(size > 0.0, size, 1.0)[:, None]
    straight: Bool = size > 0.0
    for handle in (1, 2):
        away = control[:, handle] - control[:, 0]
        distance = np.abs(ahead[:, 0] * away[:, 1] - ahead[:, 1] * away[:, 0])
        position = (ahead * away).sum(axis=1)
        straight &= (
            (distance <= tolerance) & (position >= -tolerance) & (position <= size + tolerance)
        )
    # Curves without length count as straight, and ``assemble`` drops them.
    return straight | (np.abs(control - control[:, :1]) <= 0.0).all(axis=(1, 2))


def _circular_arcs(placed: PlacedSegments, indices: I64, off: F64) -> tuple[F64, F64, F64, I64]:
    """Return the circular arcs among the segments; an arc longer than 180° is split in two.

    ``placed``: segments of the paths of the file.
    ``indices``: indices into ``placed.arc`` of the arcs that are circular.
    ``off``: distance of each arc of ``placed.arc`` from a circular one (file units).
    Returns ``ends, bulge, error`` (m, 2, 2), (m,) and (m,): ends (file units) and bulges of m arcs,
    and their distance from the arc of the file (file units); ``source`` (m,): index of the segment
    in ``placed`` from which each arc was made.
    """
    rows = placed.arc[indices]
    u, v, first, turn = (
        placed.u[indices],
        placed.v[indices],
        placed.first[indices],
        placed.turn[indices],
    )
    side = np.sign((u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) * turn)
    two = np.abs(turn) > np.pi * (1.0 + 1e-9)
    bulge = side * np.minimum(np.tan(np.abs(turn) / np.where(two, 8.0, 4.0)), 1.0)
    half = first + turn / 2.0
    middle = placed.centre[indices] + np.cos(half)[:, None] * u + np.sin(half)[:, None] * v
    start, end = placed.start[rows], placed.end[rows]
    ends = np.concatenate(
        [
            np.stack([start, np.where(two[:, None], middle, end)], axis=1),
            np.stack([middle, end], axis=1)[two],
        ]
    )
    error = off[indices]
    return (
        ends,
        np.concatenate([bulge, bulge[two]]),
        np.concatenate([error, error[two]]),
        np.concatenate([rows, rows[two]]),
    )


def _bezier(control: F64) -> tuple[EvaluateEach, EvaluateEach]:
    """Return two functions that evaluate n cubic Bézier curves: their points and their derivatives.

    Both functions take indices of curves (k,) and parameters 0 … 1 (k,), and return an array (k,
    2).

    ``control`` (n, 4, 2): control points of n curves.
    """
    step = np.diff(control, axis=1)
    # The tangent at the start points to the first control point that differs from the start.
    leaving = control[:, 1:] - control[:, :1]
    first = np.argmax((leaving != 0.0).any(axis=2), axis=1)
    leaving = leaving[np.arange(len(control)), first]

    def point(k: I64, s: F64) -> F64:
        p, t, r = control[k], s[:, None], 1.0 - s[:, None]
        return r * r * r * p[:, 0] + 3.0 * r * t * (r * p[:, 1] + t * p[:, 2]) + t * t * t * p[:, 3]

    def tangent(k: I64, s: F64) -> F64:
        d, t, r = step[k], s[:, None], 1.0 - s[:, None]
        derivative = r * r * d[:, 0] + 2.0 * r * t * d[:, 1] + t * t * d[:, 2]
        return np.where(t > 0.0, derivative, leaving[k])

    return point, tangent


def _elliptic(placed: PlacedSegments) -> tuple[EvaluateEach, EvaluateEach]:
    """Return two functions that evaluate elliptic arcs: their points and their derivatives.

    Both functions take indices into ``placed.arc`` (k,) and parameters 0 … 1 (k,), and return an
    array (k, 2).
    """

    def point(k: I64, s: F64) -> F64:
        t = placed.first[k] + s * placed.turn[k]
        return (
            placed.centre[k] + np.cos(t)[:, None] * placed.u[k] + np.sin(t)[:, None] * placed.v[k]
        )

    def tangent(k: I64, s: F64) -> F64:
        t = placed.first[k] + s * placed.turn[k]
        sign = np.sign(placed.turn[k])[:, None]
        return sign * (np.cos(t)[:, None] * placed.v[k] - np.sin(t)[:, None] * placed.u[k])

    return point, tangent


def _fit_arcs(
    placed: PlacedSegments,
    indices: I64,
    numbers: I64,
    point: EvaluateEach,
    tangent: EvaluateEach,
    tolerance: float,
    max_pieces: int,
) -> tuple[F64, F64, F64, I64]:
    """Approximate curves by circular arcs, and return the arcs.

    The messages about curves that cannot be fitted are written to ``placed.failed``.

    ``placed``: segments of the paths of the file.
    ``indices``: numbers of the curves to fit, as ``point`` and ``tangent`` take them.
    ``numbers``: ``numbers[i]`` is the index in ``placed`` of the curve with number i.
    ``point``, ``tangent``: functions that take numbers of curves and parameters 0 … 1, and return
    points and derivatives.
    ``tolerance``: maximum distance between a curve and its arcs (file units).
    ``max_pieces``: largest number of pieces of the curves, each of which becomes one or two arcs.
    Returns ``ends, bulge, error`` (m, 2, 2), (m,) and (m,): ends (file units) and bulges of m arcs,
    and their greatest distance from the curve (file units); ``source`` (m,): index in ``placed`` of
    the curve that each arc approximates.
    Raises ``GeometryError``: the curves need too many pieces.
    """
    (start, end, bulge, error), origin, failed = fit_many(
        lambda k, s: point(indices[k], s),
        lambda k, s: tangent(indices[k], s),
        len(indices),
        tolerance,
        max_pieces,
    )
    for one, reason in failed.items():
        placed.failed[int(numbers[indices[one]])] = reason.message
    rows = numbers[indices[origin]]
    # Exact ends, so that the next segment begins where this one ends.
    first = np.flatnonzero(np.diff(origin, prepend=-1))
    last = np.flatnonzero(np.diff(origin, append=len(indices)))
    start[first], end[last] = placed.start[rows[first]], placed.end[rows[last]]
    return np.stack([start, end], axis=1), bulge, error, rows
