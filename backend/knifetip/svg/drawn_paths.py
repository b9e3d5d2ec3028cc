"""The paths of the drawn elements of an SVG, with their matrices and styles."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from knifetip.drawing_builder.clip import UNBOUNDED, Box, Clip
from knifetip.drawing_builder.colours import UNKNOWN_COLOUR, nearest_index
from knifetip.drawing_builder.columns import Style
from knifetip.geometry.affine import Matrix
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
    styles: list[Style] = field(default_factory=list)  #: without line widths
    stroke_width: list[float] = field(default_factory=list)  #: user units, or pixels; -1 for none
    fixed_stroke: list[bool] = field(default_factory=list)  #: whether it is in pixels
    stroke: list[int | None] = field(default_factory=list)  #: colours of strokes, None for none
    fill: list[int | None] = field(default_factory=list)  #: colours of fills, None for none
    clip: list[Clip] = field(default_factory=list)  #: visible areas
    page: Box = UNBOUNDED  #: visible area of the page (file units)
    page_colour: int | None = None  #: background of the page, None if the file states none
    omitted: list[OmittedShape] = field(default_factory=list)
    annotations: list[Annotation] = field(default_factory=list)  #: in file units
    _numbers: dict[Style, int] = field(default_factory=dict)  #: index of each style

    def add(
        self,
        row: int,
        data: str,
        layer: str,
        matrix: Matrix,
        appearance: Appearance,
        clip: Clip,
        window_diagonal: float,
    ) -> None:
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
        clip
            Visible area of the element.
        window_diagonal
            Length to which a stroke width in per cent refers (user units).
        """
        stroke, fill = appearance.drawn_stroke, appearance.drawn_fill
        paint = stroke if stroke is not None else fill
        colour = UNKNOWN_COLOUR if paint is None else paint
        style = Style(
            layer,
            nearest_index(colour),
            colour if colour >= 0 else -1,
            "dashed" if appearance.dashed and stroke is not None else "Continuous",
        )
        number = self._numbers.get(style)
        if number is None:
            number = self._numbers[style] = len(self.styles)
            self.styles.append(style)
        self.data.append(data)
        self.matrix.append(matrix)
        self.row.append(row)
        self.style.append(number)
        width = -1.0 if stroke is None else appearance.stroke_width
        self.stroke_width.append(
            width * window_diagonal / 100.0 if appearance.is_percent and width > 0.0 else width
        )
        self.fixed_stroke.append(appearance.fixed_stroke)
        self.stroke.append(stroke)
        self.fill.append(fill)
        self.clip.append(clip)
