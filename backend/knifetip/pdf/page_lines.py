"""page_lines: collect the paths and texts of a PDF page, and its import report.

Every path, text and image has a row in the report.  Each path has its own coordinates, a matrix to
points on the displayed page, and a style.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.drawing_builder.colours import nearest_index
from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.path_table import Paths, Table, boxes
from knifetip.drawing_builder.report import ReportWriter
from knifetip.errors import DrawingTooLarge
from knifetip.formats.limits import Limits
from knifetip.geometry.affine import Matrix
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.messages import Message
from knifetip.model.drawing import Annotation, LocationBoxes
from knifetip.pdf.colours import Paint
from knifetip.pdf.document import Box
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
    clip: Box  #: visible area of the path on the displayed page
    style: LineStyle
    area: bool  #: whether the path is filled without a stroke


#: Lines that exceed the visible area by less than this get no note (points).
_MARGIN: Final = 0.01


class PageLines:
    """The paths and texts of a page, and its import report."""

    def __init__(self, limits: Limits) -> None:
        self.report = ReportWriter()
        self.path = PathBuilder(limits)
        self.annotations: list[Annotation] = []  #: in points
        self._limits = limits
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

    def line(self, row: int, matrix: Matrix, clip: Box, style: LineStyle, *, area: bool) -> None:
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
        area
            Whether the path is filled without a stroke.
        """
        self._lines.append(PageLine(row, self.path.keep(), matrix, clip, style, area))

    @property
    def empty(self) -> bool:
        """Whether the page has no path."""
        return not self._lines

    def collect(self) -> tuple[Table, Paths, list[Style]]:
        """Return the paths of the page that are kept, and their styles.

        Paths outside their visible area are dropped, and so are filled areas if the page has
        strokes.  The reasons are written into the import report.

        Returns
        -------
        Table
            The segments of all kept paths.
        Paths
            For each kept path: its row in the import report, the index of its style, and the matrix
            from its coordinates to points on the displayed page.
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
            keep = self._drop_invisible(box) & self._drop_fills()
        self.report.location_boxes.append(LocationBoxes(row[~keep], box[~keep]))
        kept_segments = keep[path]
        number = np.cumsum(keep) - 1
        table = Table(
            table.kind[kept_segments], numbers[kept_segments], number[path[kept_segments]]
        )
        styles, style = self._assign_styles(
            [line for line, is_kept in zip(lines, keep.tolist(), strict=True) if is_kept]
        )
        return table, Paths(row[keep], style, matrix[keep]), styles

    def _drop_invisible(self, box: F64) -> Bool:
        """Return the mask, (p,), of the paths that are at least partly inside their visible areas.

        The reason for dropping each path that is outside, and a note for each path that is only
        partly inside, is written into the import report.

        Parameters
        ----------
        box : (p, 4)
            min x, min y, max x and max y of each of the page's p paths (points).
        """
        clip = np.array([line.clip for line in self._lines], np.float64).reshape(-1, 4)
        low, high = box[:, :2], box[:, 2:]
        outside = ((high < clip[:, :2]) | (low > clip[:, 2:])).any(axis=1)
        crossing = ((low < clip[:, :2] - _MARGIN) | (high > clip[:, 2:] + _MARGIN)).any(axis=1)
        for one in np.flatnonzero(outside).tolist():
            self.report.dropped[self._lines[one].row] = Message("import.outside-page")
        for one in np.flatnonzero(crossing & ~outside).tolist():
            self._note(self._lines[one].row, Message("import.partly-outside-page"))
        shown: Bool = np.logical_not(outside)
        return shown

    def _drop_fills(self) -> Bool:
        """Return the mask of the paths that are kept, shape (p,), one per path of the page.

        Paths with a stroke are kept, and paths with only a fill are dropped.  If no path of the
        page has a stroke, all paths are kept.  The reasons for dropping paths are written into the
        import report.
        """
        areas = np.array([line.area for line in self._lines], bool)
        stroked = not areas.all()
        for one in np.flatnonzero(areas).tolist():
            row = self._lines[one].row
            if stroked:
                self.report.dropped.setdefault(row, Message("import.filled-area-on-page"))
            else:
                self._note(row, Message("import.area-outline-on-page"))
        return ~areas | (not stroked)

    def _assign_styles(self, lines: list[PageLine]) -> tuple[list[Style], I32]:
        """Return the list of the styles of n paths, and for each path the index of its style, (n,).

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
