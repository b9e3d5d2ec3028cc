"""page_lines: collect the paths and texts of a PDF page, and its import report.

Every path, text and image has a row in the report.  Each path has its own coordinates, a matrix to
points on the displayed page, and a style.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from knifetip.drawing_builder.clip import UNCLIPPED, Box, Clip
from knifetip.drawing_builder.colours import nearest_index
from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.line_widths import add_line_widths, enlargements
from knifetip.drawing_builder.page_border import compare_with_page, report_page_border
from knifetip.drawing_builder.path_table import Paths, Table, boxes
from knifetip.drawing_builder.report import ReportWriter
from knifetip.drawing_builder.white_lines import is_white, unseen_white_lines
from knifetip.errors import DrawingTooLarge
from knifetip.formats.limits import Limits
from knifetip.geometry.affine import Matrix
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.messages import Message
from knifetip.model.drawing import Annotation, LocationBoxes
from knifetip.pdf.colours import Paint
from knifetip.pdf.layers import layer_names
from knifetip.pdf.path_builder import PathBuilder


class LayerMark(NamedTuple):
    """Layer of an object on the page, and the hidden layer because of which it is not visible.

    A layer may be nested in another layer: an object on a visible layer is not visible if an outer
    layer is hidden.  The name ``hidden`` is empty if the object is visible.
    """

    layer: str
    hidden: str  #: name of the hidden layer that contains the object, empty if visible


class LineStyle(NamedTuple):
    """Style of a path on the page: layer, colour, and whether it is dashed."""

    layer: str
    paint: Paint
    dashed: bool


class PageLine(NamedTuple):
    """A path on the page, with its import report row, matrix, visible area and style."""

    row: int
    size: int  #: number of segments
    matrix: Matrix  #: from path coordinates to points on the displayed page
    clip: Clip  #: visible area of the path on the displayed page
    style: LineStyle
    stroke: int | None  #: colour of the stroke, None for none
    fill: int | None  #: colour of the fill, None for none
    line_width: float  #: in path coordinates, -1 without a stroke


class PageLines:
    """The paths and texts of a page, and its import report."""

    def __init__(self, limits: Limits, page: Box) -> None:
        self.report = ReportWriter()
        self.path = PathBuilder(limits)
        self.annotations: list[Annotation] = []  #: in points
        self._limits = limits
        self._page = page  # visible area of the displayed page
        self._lines: list[PageLine] = []

    def row(self, path: str, kind: str, mark: LayerMark, drop_reason: Message | None = None) -> int:
        """Add a row for an object to the import report and return the index of the row.

        Parameters
        ----------
        path
            Names of the forms that contain the object, each followed by a slash.
        kind
            Type of the object, for example "path" or "image".
        mark
            Layer of the object.
        drop_reason
            Reason why the object gives no edge, None if it gives edges.
        """
        if len(self.report.handle) >= self._limits.entities:
            raise DrawingTooLarge(
                "reading.too-many-elements", limit=self._limits.entities, format="PDF"
            )
        handle = f"{path}#{len(self.report.handle) + 1}"
        return self.report.row(handle, kind, mark.layer or "0", drop_reason)

    def line(
        self,
        row: int,
        matrix: Matrix,
        clip: Clip,
        style: LineStyle,
        stroke: int | None,
        fill: int | None,
        line_width: float,
    ) -> None:
        """Add the current path of the path builder to the paths of the page.

        Parameters
        ----------
        row
            Row of the path in the import report.
        matrix
            From the coordinates of the path to points on the displayed page.
        clip
            Visible area of the path on the displayed page (points).
        style
            Layer, colour and dashes of the path.
        stroke, fill
            Colours of the stroke and of the fill, None for none.
        line_width
            Width of the stroke in path coordinates, -1 without a stroke.
        """
        self._lines.append(
            PageLine(row, self.path.keep(), matrix, clip, style, stroke, fill, line_width)
        )

    @property
    def empty(self) -> bool:
        """Whether the page has no path."""
        return not self._lines

    def collect(self, millimetres: float) -> tuple[Table, Paths, list[Style]]:
        """Return the paths of the page that are kept, and their styles.

        Paths outside the page and white lines are dropped, and so are filled areas if the page has
        strokes.  The reasons are written into the import report.

        Parameters
        ----------
        millimetres
            Length of a point of the page (mm).

        Returns
        -------
        Table
            The segments of all kept paths.
        Paths
            For each kept path: its row in the import report, the index of its style, its visible
            area, and the matrix from its coordinates to points on the displayed page.
        list of Style
            The styles of the kept paths.
        """
        lines = self._lines
        size = np.array([line.size for line in lines], np.int64)
        path = np.repeat(np.arange(len(lines), dtype=np.int64), size)
        numbers = np.array(self.path.numbers, np.float64).reshape(-1, 8)
        table = Table(np.array(self.path.kind, np.uint8), numbers, path)
        matrix = np.array([line.matrix for line in lines], np.float64).reshape(-1, 6)
        row = np.array([line.row for line in lines], np.int32)
        with np.errstate(all="ignore"):
            box = boxes(table, matrix)
            border = compare_with_page(table, matrix, box, self._page)
            report_page_border(self.report, row, border)
            keep = self._drop_areas(box, ~border.outside)
        self.report.location_boxes.append(LocationBoxes(row[~keep], box[~keep]))
        kept_lines = [line for line, is_kept in zip(lines, keep.tolist(), strict=True) if is_kept]
        with np.errstate(all="ignore"):
            widths = np.array([line.line_width for line in kept_lines], np.float64)
            widths = widths * enlargements(matrix[keep]) * millimetres
        styles, style = add_line_widths(*self._assign_styles(kept_lines), widths)
        is_clipped = any(line.clip is not UNCLIPPED for line in kept_lines)
        clip = [line.clip for line in kept_lines] if is_clipped else ()
        return table.select(keep), Paths(row[keep], style, matrix[keep], clip), styles

    def _drop_areas(self, box: F64, on_page: Bool) -> Bool:
        """Return the mask of the paths that are kept, shape (p,), one per path of the page.

        Paths with a visible stroke are kept, and paths with only a fill are dropped.  If no path of
        the page has a stroke, all fills are kept.  The reasons for dropping paths are written into
        the import report.

        ``box`` (p, 4): min x, min y, max x and max y of each of the page's p paths (points).
        ``on_page`` (p,): mask of the paths that are not outside the page.
        """
        strokes = [line.stroke for line in self._lines]
        fills = [line.fill for line in self._lines]
        white = unseen_white_lines(strokes, fills, box, page=None)
        areas = white | np.array([stroke is None for stroke in strokes], bool)
        filled = np.array([fill is not None for fill in fills], bool)
        stroked = bool((on_page & ~areas).any())
        for one in np.flatnonzero(on_page & areas).tolist():
            row, fill = self._lines[one].row, fills[one]
            if fill is None:
                self.report.dropped[row] = Message("import.white-line")
            elif not stroked:
                self._note(row, Message("import.area-outline-on-page"))
            else:
                code = "import.white-area" if is_white(fill) else "import.filled-area-on-page"
                self.report.dropped[row] = Message(code)
        kept: Bool = on_page & ~(areas & (stroked | ~filled))
        return kept

    def _assign_styles(self, lines: list[PageLine]) -> tuple[list[Style], I32]:
        """Return the styles of n paths without line widths, and the style index of each, (n,).

        The layer of each path is also written into the path's row of the import report.
        """
        named = layer_names({(line.style.layer, line.style.paint.spot) for line in lines})
        styles: list[Style] = []
        numbers: dict[LineStyle, int] = {}
        style = np.zeros(len(lines), np.int32)
        for number, line in enumerate(lines):
            layer, (colour, spot, _), dashed = line.style
            name = named[layer, spot]
            self.report.layer[line.row] = name
            if spot and name.lower() != spot.lower():
                self._note(line.row, Message("import.spot-colour", colour=spot))
            elif layer and name.lower() != layer.lower():
                self._note(line.row, Message("import.on-layer", layer=layer))
            cached = numbers.get(line.style)
            if cached is None:
                cached = numbers[line.style] = len(styles)
                linetype = "dashed" if dashed else "Continuous"
                styles.append(Style(name, nearest_index(colour), max(colour, -1), linetype))
            style[number] = cached
        return styles, style

    def _note(self, row: int, note: Message) -> None:
        self.report.notes.setdefault(row, []).append(note)
