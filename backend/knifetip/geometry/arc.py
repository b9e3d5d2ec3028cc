"""arc: lengths, tangents, points and bounding boxes of segments, which are lines or arcs.

An arc is stored as its two ends and its bulge, which is tan(sweep / 4), positive to the left, 0 for
a line.  The functions take columns of n segments, lines and arcs mixed: ``start`` and ``end`` (n,
2) mm and ``bulge`` (n,).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from knifetip.geometry.azimuth import left_normal
from knifetip.geometry.columns import F64
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_2A, kernel


def sweep(bulge: F64) -> F64:
    """Return the angle by which each of n segments turns, (n,) radians, from its bulge, (n,).

    The angle is positive to the left, and 0 for a line.
    """
    angle: F64 = 4.0 * np.arctan(bulge)
    return angle


def centre(start: F64, end: F64, bulge: F64) -> F64:
    """Return the centre of each of n arcs, (n, 2) mm; NaN for lines.

    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the arcs.
    """
    straight = np.abs(bulge) < BULGE
    safe = np.where(straight, 1.0, bulge)
    middle = (start + end) / 2.0
    # The apothem, along the left normal of the chord: (1 - b²) / 4b chords.
    result: F64 = (
        middle + left_normal(end - start) * ((1.0 - safe * safe) / (4.0 * safe))[..., None]
    )
    result[straight] = np.nan
    return result


def radius(start: F64, end: F64, bulge: F64) -> F64:
    """Return the radius of each of n arcs, (n,) mm; infinite for lines.

    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the arcs.
    """
    chord = np.hypot(*(end - start).T)
    size = np.abs(bulge)
    straight = size < BULGE
    safe = np.where(straight, 1.0, size)
    result: F64 = np.where(straight, np.inf, chord * (1.0 + safe * safe) / (4.0 * safe))
    return result


def length(start: F64, end: F64, bulge: F64) -> F64:
    """Return the length of each of n lines and arcs, (n,) mm.

    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the lines and arcs.  Coordinates must be so
    small that their squares are finite floats; otherwise the result is inf.
    """
    return length_from_chord(_chord_lengths(start, end), bulge)


@kernel
def _chord_lengths(start: F64_2A, end: F64_2A) -> Any:
    """Return the distance of ``start`` (n, 2) mm from ``end`` (n, 2) mm, (n,) mm."""
    size = np.empty(len(start))
    for row in range(len(start)):
        x, y = end[row, 0] - start[row, 0], end[row, 1] - start[row, 1]
        size[row] = math.sqrt(x * x + y * y)
    return size


def length_from_chord(chord: F64, bulge: F64) -> F64:
    """Return the length of each of n lines and arcs, (n,) mm.

    ``chord`` (n,) mm is the distance between the two ends, and ``bulge`` (n,) is 0 for a line.
    """
    result = chord.copy()
    curved = np.flatnonzero(bulge != 0.0)
    size = np.abs(bulge[curved])
    # Half the sweep, 2 atan b, divided by its sine, 2b / (1 + b²).
    result[curved] *= np.arctan(size) * (1.0 + size * size) / size
    return result


def _rotate(vectors: F64, angle: F64) -> F64:
    """Return n vectors, (n, 2), each rotated counter-clockwise by its own angle, (n,) radians."""
    result = vectors.copy()
    turned = np.flatnonzero(angle)
    if len(turned):
        cos, sin = np.cos(angle[turned]), np.sin(angle[turned])
        x, y = vectors[turned, 0], vectors[turned, 1]
        result[turned, 0], result[turned, 1] = x * cos - y * sin, x * sin + y * cos
    return result


def tangents(start: F64, end: F64, bulge: F64) -> tuple[F64, F64]:
    """Return the tangents at the start and the tangents at the end of n segments, (n, 2) each.

    A tangent points in the direction of travel and has the length of the segment's chord.
    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the segments.
    """
    half = sweep(bulge) / 2.0
    chord = end - start
    return _rotate(chord, -half), _rotate(chord, half)


def point_at(start: F64, end: F64, bulge: F64, fraction: F64) -> F64:
    """Return one point of each of n segments, (n, 2) mm.

    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the segments.  ``fraction`` (n,) is the
    distance of the point from the start along the segment, as a fraction of the segment's length, 0
    … 1.
    """
    result: F64 = start + (end - start) * fraction[:, None]
    bent = np.flatnonzero(bulge)
    if len(bent):
        start, end, fraction = start[bent], end[bent], fraction[bent]
        # Half-angle form: the chord from start to the point is r·2·sin(fθ/2), turned by (f-1)θ/2.
        half = sweep(bulge[bent]) / 2.0
        ratio = fraction * np.sinc(fraction * half / np.pi) / np.sinc(half / np.pi)
        result[bent] = start + _rotate(end - start, (fraction - 1.0) * half) * ratio[:, None]
    return result


def tangent_at(start: F64, end: F64, bulge: F64, fraction: F64) -> F64:
    """Return the tangent at one point of each of n segments, (n, 2).

    Each tangent points in the direction of travel and has the length of the segment's chord.
    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the segments.  ``fraction`` (n,) is the
    distance of the point from the start along the segment, as a fraction of the segment's length, 0
    … 1.
    """
    return _rotate(end - start, sweep(bulge) * (fraction - 0.5))


def nearest_fraction(start: F64, end: F64, bulge: F64, point: F64) -> F64:
    """Return the position on each of n segments that is nearest to the point given for it, (n,).

    A position is a fraction of the segment's length, 0 at its start and 1 at its end.  ``start``,
    ``end`` (n, 2) mm and ``bulge`` (n,) are the segments.  ``point`` (n, 2) mm are the points, one
    per segment.
    """
    chord = end - start
    along, square = (point - start) * chord, chord**2
    # By column, since sums of rows of two numbers are slow.
    position: F64 = (along[:, 0] + along[:, 1]) / (square[:, 0] + square[:, 1])
    straight = np.abs(bulge) < BULGE
    if not straight.all():
        middle, theta = centre(start, end, bulge), sweep(bulge)
        spoke, first = point - middle, start - middle
        turned = np.arctan2(
            first[:, 0] * spoke[:, 1] - first[:, 1] * spoke[:, 0], (first * spoke).sum(axis=1)
        )
        # Measured from the middle of the arc, so that points beyond an end get that end's fraction.
        turned = (turned - theta / 2.0 + np.pi) % (2.0 * np.pi) - np.pi
        position = np.where(straight, position, 0.5 + turned / np.where(straight, 1.0, theta))
    return np.clip(position, 0.0, 1.0)


def points_along(start: F64, end: F64, bulge: F64, count: int) -> F64:
    """Return ``count`` equidistant points of each of n segments, (n, count, 2) mm, ends included.

    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the segments.
    """
    fraction = np.tile(np.linspace(0.0, 1.0, count), len(bulge))
    points = point_at(
        np.repeat(start, count, axis=0),
        np.repeat(end, count, axis=0),
        np.repeat(bulge, count),
        fraction,
    )
    return points.reshape(-1, count, 2)


def sub_arc(start: F64, end: F64, bulge: F64, first: F64, last: F64) -> tuple[F64, F64, F64]:
    """Return the part of each segment between two fractions of its length.

    The part goes from the fraction ``first`` (n,) to the fraction ``last`` (n,), both 0 … 1.  The
    result is the start (n, 2), end (n, 2) and bulge (n,) of the parts.
    """
    return (
        point_at(start, end, bulge, first),
        point_at(start, end, bulge, last),
        np.tan(np.arctan(bulge) * (last - first)),
    )


@kernel
def _chord_boxes(start: F64_2A, end: F64_2A) -> Any:
    """Return the bounding box of each of n chords, (n, 4) mm: x min, y min, x max, y max.

    ``start`` and ``end`` (n, 2) mm are the ends of the chords.  As in NumPy, a box with a
    coordinate that is not a number has no number there either.
    """
    boxes = np.empty((len(start), 4))
    for row in range(len(start)):
        for axis in range(2):
            one, other = start[row, axis], end[row, axis]
            boxes[row, axis] = one if one <= other or math.isnan(one) else other
            boxes[row, axis + 2] = one if one >= other or math.isnan(one) else other
    return boxes


def point_boxes(points: F64) -> F64:
    """Return the bounding box of each of n points, (n, 4) mm, from ``points`` (n, 2) mm."""
    boxes: F64 = _chord_boxes(points, points)
    return boxes


def bounding_boxes(start: F64, end: F64, bulge: F64) -> F64:
    """Return the bounding box of each of n lines and arcs, (n, 4) mm: x min, y min, x max, y max.

    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the lines and arcs.
    """
    boxes: F64 = _chord_boxes(start, end)
    low, high = boxes[:, :2], boxes[:, 2:]
    arcs = np.flatnonzero(np.abs(bulge) >= BULGE)
    if len(arcs):
        start, end, bulge = start[arcs], end[arcs], bulge[arcs]
        middle = centre(start, end, bulge)
        size = radius(start, end, bulge)
        theta = sweep(bulge)
        first = np.arctan2(*(start - middle).T[::-1])
        for quarter in range(4):
            axis = quarter * np.pi / 2.0
            along = np.where(theta > 0, axis - first, first - axis) % (2.0 * np.pi)
            hit = along < np.abs(theta)
            extreme = middle + size[:, None] * np.array([np.cos(axis), np.sin(axis)])
            rows, extreme = arcs[hit], extreme[hit]
            low[rows] = np.minimum(low[rows], extreme)
            high[rows] = np.maximum(high[rows], extreme)
    return boxes
