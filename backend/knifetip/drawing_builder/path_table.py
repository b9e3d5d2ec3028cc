"""Segments of paths as SVG and PDF files contain them, and bounding boxes of the paths.

The segments are in the coordinates of their paths; a matrix for each path converts them to file
units.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.drawing_builder.clip import Clip
from knifetip.geometry.columns import F64, I32, I64, U8, Bool

LINE: Final = 0
CUBIC: Final = 1
ARC: Final = 2


@dataclass(frozen=True, eq=False, slots=True)
class Table:
    """n segments of several paths in the order of the file, each in the coordinates of its path."""

    kind: U8  #: (n,) LINE, CUBIC or ARC
    #: (n, 8) x and y of both ends; then for a CUBIC x and y of both inner control points; for an
    #: ARC both radii, the angle of the first radius (degrees), and 1 for a sweep above 180° plus 2
    #: for a sweep in the direction of increasing angles
    numbers: F64
    path: I64  #: (n,) path of each segment

    def select(self, kept: Bool) -> Table:
        """Return the segments of the paths in the mask ``kept``, (p,), which are numbered anew."""
        rows = kept[self.path]
        number = np.cumsum(kept) - 1
        return Table(self.kind[rows], self.numbers[rows], number[self.path[rows]])


@dataclass(frozen=True, eq=False, slots=True)
class Paths:
    """Import report row, style, matrix and clip of each of p paths."""

    row: I32  #: (p,) row in the import report
    style: I32  #: (p,) index of the style
    matrix: F64  #: (p, 6) a … f of the matrix from path coordinates to file units
    clip: Sequence[Clip] = ()  #: (p,) visible area of each path; empty if nothing is clipped


def boxes(table: Table, matrix: F64) -> F64:
    """Return the bounding box of each of p paths, (p, 4): x min, y min, x max, y max (file units).

    A box contains the ends and control points of its path; it is NaN for a path without segments.

    Parameters
    ----------
    table
        Segments of the paths.
    matrix : (p, 6)
        Matrix from the coordinates of each path to file units.
    """
    matrices, numbers = matrix[table.path], table.numbers
    low = np.full((len(matrices), 2), np.inf)
    high = -low
    for k in range(4):
        points = transform_points(matrices, numbers[:, 2 * k : 2 * k + 2])
        has_point = (table.kind == CUBIC)[:, None] | (k < 2)
        low = np.where(has_point, np.minimum(low, points), low)
        high = np.where(has_point, np.maximum(high, points), high)
    box = np.full((len(matrix), 4), np.nan)
    if len(matrices):
        first = np.flatnonzero(np.diff(table.path, prepend=-1))
        box[table.path[first], :2] = np.minimum.reduceat(low, first)
        box[table.path[first], 2:] = np.maximum.reduceat(high, first)
    return box


def farthest_coordinates(table: Table, matrix: F64, paths: int) -> F64:
    """Return for each of p paths an upper bound of its absolute coordinates, (p,) (file units).

    The bound is NaN or infinite if a coordinate of the path is NaN or infinite.

    Parameters
    ----------
    table
        Segments of the paths.
    matrix : (p, 6)
        Matrix from the coordinates of each path to file units.
    paths
        Number p of paths.
    """
    farthest = np.zeros(paths)
    if not len(table.kind):
        return farthest
    matrices = matrix[table.path]
    numbers = table.numbers
    cubic, is_arc = table.kind == CUBIC, table.kind == ARC
    reach = np.zeros(len(matrices))
    for x, has_point in ((0, True), (2, True), (4, cubic), (6, cubic)):
        distance = np.abs(transform_points(matrices, numbers[:, x : x + 2])).max(axis=1)
        reach = np.maximum(reach, np.where(has_point, distance, 0.0))
    # On a unit circle, the points of a small arc are at most its chord away from the ends of the
    # arc, and the points of a large arc at most the diameter.  The radii scale this distance; radii
    # that are too small for the chord are increased until the chord is a diameter.
    size = np.abs(matrices[:, :4]).sum(axis=1)
    half = np.hypot(*half_chords(numbers))
    large = numbers[:, 7] % 2.0 == 1.0
    wide = 2.0 * np.where(large, np.maximum(half, 1.0), half) * numbers[:, 4:6].max(axis=1)
    reach = reach + np.where(is_arc, 2.0 * size * wide, 0.0)
    first = np.flatnonzero(np.diff(table.path, prepend=-1))
    farthest[table.path[first]] = np.maximum.reduceat(reach, first)
    return farthest


def transform_vectors(matrices: F64, vectors: F64) -> F64:
    """Return n vectors, each multiplied by the linear part of its matrix, (n, 2).

    Parameters
    ----------
    matrices : (n, 6)
        Matrix for each vector: the numbers a … f of an SVG matrix.
    vectors : (n, 2)
        The vectors.
    """
    x, y = vectors[:, 0], vectors[:, 1]
    return np.stack(
        [matrices[:, 0] * x + matrices[:, 2] * y, matrices[:, 1] * x + matrices[:, 3] * y], axis=1
    )


def transform_points(matrices: F64, points: F64) -> F64:
    """Return n points, each transformed by its matrix, (n, 2).

    Parameters
    ----------
    matrices : (n, 6)
        Matrix for each point: the numbers a … f of an SVG matrix.
    points : (n, 2)
        The points.
    """
    return transform_vectors(matrices, points) + matrices[:, 4:]


def half_chords(numbers: F64) -> tuple[F64, F64]:
    """Return half the vector from the end to the start of n elliptic arcs, in units of the radii.

    The two arrays, (n,) each, contain the components of the half vector along the first and the
    second axis of the ellipse, each divided by the radius along that axis.

    Parameters
    ----------
    numbers : (n, 8)
        For each arc: x and y of the start, x and y of the end, both radii, the angle of the first
        radius (degrees), and flags that are not used here.
    """
    angle = np.radians(numbers[:, 6])
    cosine, sine = np.cos(angle), np.sin(angle)
    half = (numbers[:, :2] - numbers[:, 2:4]) / 2.0
    return (
        (cosine * half[:, 0] + sine * half[:, 1]) / numbers[:, 4],
        (cosine * half[:, 1] - sine * half[:, 0]) / numbers[:, 5],
    )
