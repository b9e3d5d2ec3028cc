"""drawn: the lines of a page as they are found, and its ledger.

    paths as they are built, each with its matrix and its look -> Table, Paths, Styles

Every path, text and picture gets its row; paths keep the matrix through which they are seen.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.drawing_builder.colours import nearest_index
from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.paths import Paths, Table, boxes
from knifetip.drawing_builder.report import ReportWriter
from knifetip.errors import DrawingTooLarge
from knifetip.formats.limits import Limits
from knifetip.geometry.affine import Matrix
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.model.drawing import Inscription, LocationBoxes
from knifetip.pdf.colours import Paint
from knifetip.pdf.document import Box
from knifetip.pdf.layers import names
from knifetip.pdf.outline import Outline


class Mark(NamedTuple):
    """What something on the page lies on."""

    layer: str
    hidden: str  #: the layer around it that is not shown, empty if all are


class Look(NamedTuple):
    """What a line is drawn with."""

    layer: str
    paint: Paint
    dashed: bool


class Line(NamedTuple):
    """A path that is kept."""

    row: int
    size: int  #: segments
    matrix: Matrix  #: from its coordinates to points on the page as it is shown
    clip: Box  #: what of that page is seen of it
    look: Look
    area: bool  #: it is filled and has no stroke


#: Beyond what is seen by less than this is not worth a word (points).
_EDGE: Final = 0.01


class Drawn:
    """The lines and words of a page."""

    def __init__(self, limits: Limits) -> None:
        self.sheet = ReportWriter()
        self.outline = Outline(limits)
        self.inscriptions: list[Inscription] = []  #: in points
        self._limits = limits
        self._lines: list[Line] = []

    def row(self, path: str, kind: str, mark: Mark, dropped: str = "") -> int:
        """Add a row to the ledger.

        Parameters
        ----------
        path
            Names of the forms around it, each with a slash behind it.
        """
        if len(self.sheet.handle) >= self._limits.entities:
            raise DrawingTooLarge(
                "reading.too-many-elements", limit=self._limits.entities, format="PDF"
            )
        handle = f"{path}#{len(self.sheet.handle) + 1}"
        return self.sheet.row(handle, kind, mark.layer or "0", dropped)

    def line(self, row: int, matrix: Matrix, clip: Box, look: Look, *, area: bool) -> None:
        """Keep the path that was built."""
        self._lines.append(Line(row, self.outline.keep(), matrix, clip, look, area))

    @property
    def empty(self) -> bool:
        """Whether there is no line."""
        return not self._lines

    def gathered(self) -> tuple[Table, Paths, list[Style]]:
        """Return what is drawn, once the whole page is known."""
        lines = self._lines
        size = np.array([line.size for line in lines], np.int64)
        path = np.repeat(np.arange(len(lines), dtype=np.int64), size)
        numbers = np.array(self.outline.numbers, np.float64).reshape(-1, 8)
        table = Table(np.array(self.outline.kind, np.uint8), numbers, path)
        matrix = np.array([line.matrix for line in lines], np.float64).reshape(-1, 6)
        row = np.array([line.row for line in lines], np.int32)
        with np.errstate(all="ignore"):
            box = boxes(table, matrix)
            keep = self._shown(box) & self._areas()
        self.sheet.location_boxes.append(LocationBoxes(row[~keep], box[~keep]))
        of = keep[path]
        number = np.cumsum(keep) - 1
        table = Table(table.kind[of], numbers[of], number[path[of]])
        styles, style = self._styled(
            [line for line, kept in zip(lines, keep.tolist(), strict=True) if kept]
        )
        return table, Paths(row[keep], style, matrix[keep]), styles

    def _shown(self, box: F64) -> Bool:
        """Drop the lines that lie beside what is seen of the page.

        Parameters
        ----------
        box : (p, 4)
            Around each.
        """
        clip = np.array([line.clip for line in self._lines], np.float64).reshape(-1, 4)
        low, high = box[:, :2], box[:, 2:]
        beside = ((high < clip[:, :2]) | (low > clip[:, 2:])).any(axis=1)
        over = ((low < clip[:, :2] - _EDGE) | (high > clip[:, 2:] + _EDGE)).any(axis=1)
        for one in np.flatnonzero(beside).tolist():
            self.sheet.dropped[self._lines[one].row] = "it lies outside of what the page shows"
        for one in np.flatnonzero(over & ~beside).tolist():
            self._note(self._lines[one].row, "part of it lies outside of what the page shows")
        shown: Bool = np.logical_not(beside)
        return shown

    def _areas(self) -> Bool:
        """Drop filled areas without a stroke, unless the page has no other lines."""
        areas = np.array([line.area for line in self._lines], bool)
        stroked = not areas.all()
        for one in np.flatnonzero(areas).tolist():
            row = self._lines[one].row
            if stroked:
                self.sheet.dropped.setdefault(
                    row, "a filled area without a stroke; others have one"
                )
            else:
                self._note(row, "outline of a filled area: nothing on the page has a stroke")
        return ~areas | (not stroked)

    def _styled(self, lines: list[Line]) -> tuple[list[Style], I32]:
        """Return the styles of lines, and give their rows the layers that they are called by."""
        named = names({(line.look.layer, line.look.paint.spot) for line in lines})
        styles: list[Style] = []
        known: dict[Look, int] = {}
        style = np.zeros(len(lines), np.int32)
        for number, line in enumerate(lines):
            layer, (colour, spot, _), dashed = line.look
            name = named[layer, spot]
            self.sheet.layer[line.row] = name
            if spot and name.lower() != spot.lower():
                self._note(line.row, f"drawn in the spot colour {spot}")
            elif layer and name.lower() != layer.lower():
                self._note(line.row, f"on the layer {layer}")
            found = known.get(line.look)
            if found is None:
                found = known[line.look] = len(styles)
                linetype = "dashed" if dashed else "Continuous"
                styles.append(Style(name, nearest_index(colour), max(colour, -1), linetype))
            style[number] = found
        return styles, style

    def _note(self, row: int, what: str) -> None:
        self.sheet.notes.setdefault(row, []).append(what)
