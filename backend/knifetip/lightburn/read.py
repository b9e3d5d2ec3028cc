"""read: read a project of LightBurn (.lbrn2, or .lbrn of older versions).

``read`` returns a Drawing with segments in mm, and a row of the import report for every shape that
is no group.  Lines are distinguished by layer and colour, and perforated ones by their linetype.

``project`` parses the file, ``layers`` names the layers, ``outlines`` gives the lines of a shape.
"""

from __future__ import annotations

import math

from knifetip.drawing_builder.assemble import KnownUnit
from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.report import ReportWriter
from knifetip.drawing_builder.shape_paths import Shape, ShapePaths
from knifetip.errors import NotADrawing
from knifetip.formats.invalid_content import InvalidContent
from knifetip.formats.limits import Limits
from knifetip.formats.refusals import refuse_unexpected
from knifetip.geometry.affine import Matrix, compose
from knifetip.lightburn.layers import Layers
from knifetip.lightburn.outlines import Outlines, parse_matrix
from knifetip.lightburn.project import Project, ProjectShape, parse_project
from knifetip.messages import Message
from knifetip.model.drawing import Annotation, Drawing


def read(
    data: bytes,
    unit: str | None = None,
    *,
    limits: Limits = Limits(),
) -> Drawing:
    """Return the drawing in a project of LightBurn.

    Parameters
    ----------
    data
        Content of the file.
    unit
        The unit that the user gives for one unit of the coordinates, "mm", "in" …; None or "" for
        millimetres, which LightBurn always writes.
    limits
        Limits of the size of the file and of the drawing.

    Returns
    -------
    Drawing
        In mm, as LightBurn displays it: x to the right, y upwards.

    Raises
    ------
    NotADrawing
        The file is not a project of LightBurn, contains no shape, or is truncated or damaged.
    DrawingTooLarge
        A limit is exceeded.
    NoSuchUnit
        ``unit`` is not a unit.
    """
    with refuse_unexpected(data, unit, limits, "LightBurn"):
        project = parse_project(data, limits)
        if not project.shapes:
            raise NotADrawing("lightburn.empty")
        reader = _ShapeReader(project, limits)
        for one in project.shapes:
            reader.add(one, reader.root)
        reader.add_areas()
        known = KnownUnit.choose(unit, "mm", Message("unit.lightburn"))
        return reader.paths.drawing(reader.report, reader.annotations, known)


class _ShapeReader:
    """Collects the outlines and report rows of the shapes of a project."""

    def __init__(self, project: Project, limits: Limits) -> None:
        self.report = ReportWriter()
        self.paths = ShapePaths(limits, "LightBurn")
        self.annotations: list[Annotation] = []
        across, down = project.mirror
        #: Matrix from the coordinates of the project to those of the drawing.
        self.root: Matrix = (-1.0 if across else 1.0, 0.0, 0.0, -1.0 if down else 1.0, 0.0, 0.0)
        self._layers = Layers(project.settings)
        self._areas: list[tuple[int, Style, Matrix, Shape]] = []
        self._has_lines = False
        self._outlines = Outlines(limits)

    def add(self, shape: ProjectShape, outer: Matrix, broken: Message | None = None) -> None:
        """Add a shape, or all shapes of a group.

        ``shape``: the shape.
        ``outer``: matrix of the groups that contain the shape.
        ``broken``: reason why the position of a group that contains the shape is not known.
        """
        matrix = outer
        try:
            matrix = compose(outer, parse_matrix(shape.texts.get("XForm")))
        except InvalidContent as error:
            broken = broken or Message("import.bad-place", reason=error.message)
        if shape.kind == "Group":
            for child in shape.children:
                self.add(child, matrix, broken)
        else:
            self._add_shape(shape, matrix, broken)

    def _add_shape(self, one: ProjectShape, matrix: Matrix, broken: Message | None) -> None:
        index = one.attributes.get("CutIndex", "")
        layer = self._layers.name(index)
        dropped, shape = broken, None
        try:
            # Also for a hidden shape, because later shapes may share its vertices.
            shape = self._outlines.outline(one)
        except InvalidContent as error:
            dropped = dropped or error.message
        if shape is None and dropped is None:
            dropped = self._not_read(one, matrix, layer)
        dropped = self._layers.hidden(index) or dropped
        is_empty = shape is None or not (shape.polylines or shape.arcs or shape.curves)
        if dropped is None and is_empty:
            dropped = Message("import.empty-path")
        row = self.report.row(f"#{one.number}", one.kind[:40], layer, dropped)
        if dropped is not None:
            self.report.set_location(row, (*matrix[4:], *matrix[4:]))
        elif shape is not None:
            style = self._layers.style(index)
            if self._layers.is_filled(index):
                self._areas.append((row, style, matrix, shape))
            else:
                self._has_lines = True
                self.paths.add(row, style, matrix, shape)

    def add_areas(self) -> None:
        """Add the outlines of filled shapes if the project has no lines; otherwise leave them out.

        SVG and PDF files are read in the same way.
        """
        for row, style, matrix, shape in self._areas:
            if self._has_lines:
                self.report.dropped[row] = Message("import.filled-area-beside-strokes")
                self.report.set_location(row, (*matrix[4:], *matrix[4:]))
            else:
                self.report.notes[row] = [Message("import.area-outline")]
                self.paths.add(row, style, matrix, shape)

    def _not_read(self, shape: ProjectShape, matrix: Matrix, layer: str) -> Message:
        """Return the reason for leaving out a shape of another type; keep the words of a text."""
        if shape.kind == "Bitmap":
            return Message("import.image")
        if shape.kind != "Text":
            return Message("import.lightburn-shape", kind=shape.kind[:40])
        words = shape.attributes.get("Str", "").strip()
        x, y = matrix[4:]
        if words and math.isfinite(x) and math.isfinite(y):
            self.annotations.append(
                Annotation(words, x, y, _height(shape), math.nan, "Text", layer)
            )
        return Message("import.text")


def _height(shape: ProjectShape) -> float:
    """Return the height of the letters of a text (mm), 0 if the file does not state it."""
    try:
        height = float(shape.attributes.get("H", "0"))
    except ValueError:
        return 0.0
    return abs(height) if math.isfinite(height) else 0.0
