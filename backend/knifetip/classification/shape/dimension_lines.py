"""dimension_lines: find dimensions that consist of plain lines, by the text that states a length.

A line beside which a text states the length of the line is a dimension line, whatever its colour
and whatever strokes it ends with.  The strokes at its ends belong to it, and so do the extension
lines, which cross its ends at right angles and end a little beyond it.

A side of an outline may also have its length written beside it.  It joins its neighbours at both
ends, which a dimension line does not.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import GAP
from knifetip.model.drawing import Annotation

_STATED: Final = re.compile(r"\s*[^\d\s.,+-]?\s*(\d+(?:[.,]\d+)?)\s*(?:mm)?\s*", re.IGNORECASE)
#: Shortest dimension line (mm); shorter numbers may be anything.
_SHORTEST: Final = 5.0
#: Assumed height of a text whose height is unknown (mm).
_HEIGHT: Final = 4.0
#: Greatest distance of a text from its dimension line, in heights of the text.
_BESIDE: Final = 2.5
#: Longest stroke at the end of a dimension line (mm), such as a tick or half an arrowhead.
_STROKE: Final = 6.0
#: Greatest length by which an extension line goes beyond the dimension line (mm).
_OVERSHOOT: Final = 5.0
#: Greatest distance of strokes and extension lines from an end of the dimension line (mm).
_NEAR: Final = 0.2
#: Most pairs of a text and an edge that are compared.
_MOST_PAIRS: Final = 20_000_000


class DimensionEdges(NamedTuple):
    """Masks of n edges that belong to dimensions."""

    certain: Bool  #: (n,) belongs to a dimension
    possible: Bool  #: (n,) may be a dimension line or a line between two panels


def find_dimension_edges(
    ends: F64, bulge: F64, annotations: Sequence[Annotation], unit: float
) -> DimensionEdges | None:
    """Return the edges that belong to dimensions; None if there are none.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) and (n,)
        Ends and bulges of the edges.
    annotations
        Texts of the drawing.
    unit
        Number of drawing units in a millimetre.
    """
    stated = [
        (float(found[1].replace(",", ".")), _precision(found[1]), text)
        for text in annotations
        if (found := _STATED.fullmatch(text.text)) is not None
    ]
    stated = [one for one in stated if one[0] >= _SHORTEST * unit]
    if not stated or len(stated) * len(bulge) > _MOST_PAIRS:
        return None
    edges = _Lines(ends, bulge, unit)
    certain, possible = np.zeros(len(bulge), np.bool_), np.zeros(len(bulge), np.bool_)
    for length, precision, text in stated:
        for line in edges.beside(text, length, precision):
            if not edges.is_side(line):
                marks = np.concatenate([edges.strokes(line), edges.extensions(line)])
                if len(marks) or not edges.divides(line):
                    certain[line] = True
                    certain[marks] = True
                else:
                    possible[line] = True
                break
    possible &= ~certain
    return DimensionEdges(certain, possible) if certain.any() or possible.any() else None


def _precision(number: str) -> float:
    """Return half a unit of the last digit of a number."""
    _, _, decimals = number.replace(",", ".").partition(".")
    return 0.5 * 10.0 ** -len(decimals)


class _Lines:
    """The edges of a drawing, with lengths and directions of the straight ones."""

    def __init__(self, ends: F64, bulge: F64, unit: float) -> None:
        self._ends = ends
        self._unit = unit
        along = ends[:, 1] - ends[:, 0]
        chord = np.hypot(along[:, 0], along[:, 1])
        self._length = np.where((bulge == 0.0) & (chord > 0.0), chord, np.nan)
        self._along = along / np.maximum(chord, 1e-300)[:, None]

    def beside(self, text: Annotation, length: float, precision: float) -> list[int]:
        """Return the lines of a length beside a text, the nearest first.

        ``text``: the text, which lies beside the line between its ends.
        ``length``, ``precision``: length of the line, and the greatest deviation from it (drawing
        units).
        """
        rows = np.flatnonzero(np.abs(self._length - length) <= precision)
        start, along = self._ends[rows, 0], self._along[rows]
        from_start = np.array([text.x, text.y]) - start
        across = np.abs(from_start[:, 0] * along[:, 1] - from_start[:, 1] * along[:, 0])
        onward = (from_start * along).sum(axis=1)
        height = text.height or _HEIGHT * self._unit
        near = (across <= _BESIDE * height) & (onward >= 0.0) & (onward <= self._length[rows])
        ordered: list[int] = rows[near][np.argsort(across[near], kind="stable")].tolist()
        return ordered

    def is_side(self, line: int) -> bool:
        """Return whether both ends of a line coincide with ends of other long lines."""
        return all(len(self._lines_ending_at(line, end)) for end in (0, 1))

    def _lines_ending_at(self, line: int, end: int) -> I64:
        """Return the long lines that end where an end of a line lies, unless others pass there."""
        point = self._ends[line, end]
        gaps = np.hypot(*(self._ends - point).transpose(2, 0, 1)).min(axis=1)
        joined = (gaps <= GAP * self._unit) & ~(self._length <= _STROKE * self._unit)
        joined[line] = False
        passing = self._mask_of_passing(point, joined)
        passing[line] = False
        return np.flatnonzero(joined) if not passing.any() else np.zeros(0, np.int64)

    def _mask_of_passing(self, point: F64, joined: Bool) -> Bool:
        """Return the mask of the lines that pass through a point and do not end there, (n,)."""
        across, onward = self._offsets(point)
        inside = (onward > _NEAR * self._unit) & (onward < self._length - _NEAR * self._unit)
        return (across <= _NEAR * self._unit) & inside & ~joined

    def _offsets(self, point: F64) -> tuple[F64, F64]:
        """Return distances of a point across each line, and along it from its start, (n,) each."""
        to_point = point - self._ends[:, 0]
        across = np.abs(to_point[:, 0] * self._along[:, 1] - to_point[:, 1] * self._along[:, 0])
        return across, (to_point * self._along).sum(axis=1)

    def strokes(self, line: int) -> I64:
        """Return the short lines that start at an end of a line or have their middle there.

        The line that connects two of them belongs to an arrowhead.
        """
        short = self._length <= min(_STROKE * self._unit, 0.4 * float(self._length[line]))
        found = np.zeros(len(short), np.bool_)
        for point in self._ends[line]:
            gaps = np.hypot(*(self._ends - point).transpose(2, 0, 1)).min(axis=1)
            middle = np.hypot(*(self._ends.mean(axis=1) - point).T)
            found |= short & (np.minimum(gaps, middle) <= _NEAR * self._unit)
        tips = self._ends[found].reshape(-1, 2)
        for row in np.flatnonzero(short & ~found).tolist() if len(tips) else ():
            gaps = np.hypot(*(self._ends[row][:, None] - tips).transpose(2, 0, 1)).min(axis=1)
            found[row] = (gaps <= _NEAR * self._unit).all()
        return np.flatnonzero(found)

    def extensions(self, line: int) -> I64:
        """Return the lines across the ends of a line that end a little beyond it.

        Nothing joins them there, unlike the lines of a carton.
        """
        square = np.abs(self._along @ self._along[line]) < 0.02
        found = []
        for point in self._ends[line]:
            across, onward = self._offsets(point)
            beyond = np.minimum(onward, self._length - onward)
            reach = -_NEAR * self._unit
            near = (across <= _NEAR * self._unit) & (beyond >= reach)
            near &= square & (beyond <= _OVERSHOOT * self._unit)
            for row in np.flatnonzero(near).tolist():
                tip = 1 if onward[row] > 0.5 * self._length[row] else 0
                if not self._touches_line(row, tip, line):
                    found.append(row)
        return np.array(found, np.int64)

    def _touches_line(self, line: int, end: int, but: int) -> bool:
        """Return whether an end of a line touches another line than ``but``."""
        point = self._ends[line, end]
        across, onward = self._offsets(point)
        reach = _NEAR * self._unit
        touches = (across <= reach) & (onward >= -reach) & (onward <= self._length + reach)
        touches[[line, but]] = False
        return bool(touches.any())

    def divides(self, line: int) -> bool:
        """Return whether both ends of a line lie on other lines, as those of a fold do."""
        return all(self._touches_line(line, end, line) for end in (0, 1))
