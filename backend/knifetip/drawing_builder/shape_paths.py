"""Collect the lines, arcs and curves of drawn objects, and convert them to a table of paths."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import chain
from typing import TypeAlias

import numpy as np

from knifetip.drawing_builder.assemble import KnownUnit, assemble
from knifetip.drawing_builder.clip import UNCLIPPED, Clip
from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.path_segments import too_many
from knifetip.drawing_builder.path_table import ARC, CUBIC, LINE, Paths, Table
from knifetip.drawing_builder.paths import columns
from knifetip.drawing_builder.report import ReportWriter
from knifetip.formats.limits import Limits
from knifetip.geometry.affine import Matrix
from knifetip.geometry.columns import F64, I64
from knifetip.model.drawing import Annotation, Drawing

#: The eight numbers of an arc or a Bézier curve in a path table.
Numbers: TypeAlias = tuple[float, float, float, float, float, float, float, float]


@dataclass(slots=True)
class Shape:
    """Lines, arcs and curves of an object, in the coordinates of the object."""

    #: x and y of the points of each polyline, one after the other
    polylines: list[list[float]] = field(default_factory=list)
    arcs: list[Numbers] = field(default_factory=list)
    curves: list[Numbers] = field(default_factory=list)

    def add(self, other: Shape) -> None:
        """Add the lines, arcs and curves of another shape."""
        self.polylines += other.polylines
        self.arcs += other.arcs
        self.curves += other.curves


class ShapePaths:
    """The shapes of drawn objects of a file, with their report rows, styles, matrices and clips.

    Parameters
    ----------
    limits
        Limits of the number of segments.
    format_name
        Name of the file format in error messages.
    """

    def __init__(self, limits: Limits, format_name: str) -> None:
        self.styles: list[Style] = []
        self._numbers: dict[Style, int] = {}
        self._limits = limits
        self._format_name = format_name
        self._segments = 0
        self._row: list[int] = []
        self._style: list[int] = []
        self._matrix: list[Matrix] = []
        self._clip: list[Clip] = []
        self._polylines: list[list[float]] = []
        self._polyline_path: list[int] = []
        self._arcs: list[Numbers] = []
        self._arc_path: list[int] = []
        self._curves: list[Numbers] = []
        self._curve_path: list[int] = []

    def add(
        self, row: int, style: Style, matrix: Matrix, shape: Shape, clip: Clip = UNCLIPPED
    ) -> None:
        """Add the shape of an object.

        Parameters
        ----------
        row
            Row of the object in the import report.
        style
            Style of all lines of the object.
        matrix
            Matrix from the coordinates of the shape to file units.
        shape
            Lines, arcs and curves of the object.
        clip
            Visible area of the object.

        Raises
        ------
        DrawingTooLarge
            The number of segments exceeds its limit.
        """
        self._segments += sum(len(points) // 2 - 1 for points in shape.polylines)
        self._segments += len(shape.arcs) + len(shape.curves)
        if self._segments > self._limits.segments:
            raise too_many(self._limits, self._format_name)
        path = len(self._row)
        number = self._numbers.setdefault(style, len(self.styles))
        if number == len(self.styles):
            self.styles.append(style)
        self._row.append(row)
        self._style.append(number)
        self._matrix.append(matrix)
        self._clip.append(clip)
        self._polylines += shape.polylines
        self._polyline_path += [path] * len(shape.polylines)
        self._arcs += shape.arcs
        self._arc_path += [path] * len(shape.arcs)
        self._curves += shape.curves
        self._curve_path += [path] * len(shape.curves)

    def drawing(
        self, report: ReportWriter, annotations: Iterable[Annotation], known_unit: KnownUnit
    ) -> Drawing:
        """Return the drawing of all shapes.

        Parameters
        ----------
        report
            Rows of the import report; the reasons for dropped shapes are added.
        annotations
            Texts in file units.
        known_unit
            Unit of length of the file.
        """
        scale = known_unit.scale
        segments = columns(
            report, self.table(), self.paths(), scale, self._limits, self._format_name
        )
        return assemble(report, segments, self.styles, annotations, known_unit)

    def table(self) -> Table:
        """Return the segments of all shapes; within a shape first lines, then arcs and curves."""
        lines, line_path = self._lines()
        numbers = np.zeros((len(lines), 8))
        numbers[:, :4] = lines
        arcs, curves = (
            np.array(part, np.float64).reshape(-1, 8) for part in (self._arcs, self._curves)
        )
        kind = np.repeat(
            np.array([LINE, ARC, CUBIC], np.uint8), [len(lines), len(arcs), len(curves)]
        )
        path = np.concatenate(
            [line_path, np.array(self._arc_path, np.int64), np.array(self._curve_path, np.int64)]
        )
        order = np.argsort(path, kind="stable")
        return Table(kind[order], np.concatenate([numbers, arcs, curves])[order], path[order])

    def paths(self) -> Paths:
        """Return report row, style, matrix and clip of each shape."""
        is_clipped = any(clip is not UNCLIPPED for clip in self._clip)
        return Paths(
            np.array(self._row, np.int32),
            np.array(self._style, np.int32),
            np.array(self._matrix, np.float64).reshape(-1, 6),
            self._clip if is_clipped else (),
        )

    def _lines(self) -> tuple[F64, I64]:
        """Return the ends of the lines of all polylines, (n, 4), and the path of each, (n,)."""
        sizes = np.array([len(points) // 2 for points in self._polylines], np.int64)
        total = int(sizes.sum())
        points = np.fromiter(chain.from_iterable(self._polylines), np.float64, 2 * total).reshape(
            -1, 2
        )
        begins = np.ones(max(total - 1, 0), np.bool_)
        # No line joins the last point of a polyline and the first point of the next one.
        begins[np.cumsum(sizes)[:-1] - 1] = False
        lines = np.concatenate([points[:-1], points[1:]], axis=1)[begins]
        path = np.repeat(np.array(self._polyline_path, np.int64), np.maximum(sizes - 1, 0))
        return lines, path
