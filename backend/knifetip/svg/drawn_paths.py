"""The paths of the drawn elements of an SVG, with their matrices and styles."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from knifetip.drawing_builder.colours import UNKNOWN_COLOUR, nearest_index
from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.report import ReportWriter
from knifetip.geometry.affine import Matrix
from knifetip.messages import Message
from knifetip.model.drawing import Annotation
from knifetip.svg.style import Appearance


class OmittedShape(NamedTuple):
    """The path of an element that has a row in the import report but gives no edge.

    The bounding box of the path becomes the location of the element in the import report.
    """

    row: int  #: row of the import report
    data: str  #: path data
    matrix: Matrix


@dataclass(slots=True)
class DrawnPaths:
    """The n drawn paths of an SVG in the order of the file, with their matrices and styles.

    The shapes that give no edge, and the texts, are also stored here.
    """

    data: list[str] = field(default_factory=list)  #: path data
    matrix: list[Matrix] = field(default_factory=list)  #: from path coordinates to file units
    row: list[int] = field(default_factory=list)  #: row of the import report
    style: list[int] = field(default_factory=list)  #: index in ``styles``
    styles: list[Style] = field(default_factory=list)
    omitted: list[OmittedShape] = field(default_factory=list)
    annotations: list[Annotation] = field(default_factory=list)  #: in file units
    _numbers: dict[Style, int] = field(default_factory=dict)  #: index of each style
    _fills: list[int] = field(default_factory=list)  #: paths with a fill but no stroke
    _has_stroke: bool = False  #: whether any path has a stroke

    def add(self, row: int, data: str, layer: str, matrix: Matrix, appearance: Appearance) -> None:
        """Add the path of an element, with the style of the element.

        Parameters
        ----------
        row
            Row of the element in the import report.
        data
            Path data of the element.
        layer
            Layer name of the element.
        matrix
            Matrix from the coordinates of the element to file units.
        appearance
            Stroke, fill and dashes of the element.
        """
        paint = appearance.stroke if appearance.stroke is not None else appearance.fill
        colour = UNKNOWN_COLOUR if paint is None else paint
        if appearance.stroke is None:
            self._fills.append(len(self.row))
        else:
            self._has_stroke = True
        style = Style(
            layer,
            nearest_index(colour),
            colour if colour >= 0 else -1,
            "dashed" if appearance.dashed and appearance.stroke is not None else "Continuous",
        )
        number = self._numbers.get(style)
        if number is None:
            number = self._numbers[style] = len(self.styles)
            self.styles.append(style)
        self.data.append(data)
        self.matrix.append(matrix)
        self.row.append(row)
        self.style.append(number)

    def drop_fills(self, report: ReportWriter) -> None:
        """If any path has a stroke, drop the paths that have only a fill; otherwise keep all paths.

        The reason for each dropped path, or a note for each filled path that is kept, is added to
        the import report ``report``.  Dropped paths are moved to the list ``omitted``.
        """
        for number in self._fills:
            row = self.row[number]
            if self._has_stroke:
                report.dropped[row] = Message("import.filled-area-beside-strokes")
            else:
                report.notes.setdefault(row, []).append(Message("import.area-outline"))
        if self._has_stroke and self._fills:
            dropped_paths = set(self._fills)
            self.omitted += [
                OmittedShape(self.row[one], self.data[one], self.matrix[one]) for one in self._fills
            ]
            kept_paths = [number for number in range(len(self.row)) if number not in dropped_paths]
            for name in ("data", "matrix", "row", "style"):
                column = getattr(self, name)
                column[:] = [column[number] for number in kept_paths]
