"""place: path data through its matrices, as columns of lines and arcs.

ReportWriter, Drawn, scale -> Columns: ends, bulge and the style of each segment, in file order
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from knifetip.drawing_builder import paths
from knifetip.drawing_builder.columns import Columns
from knifetip.drawing_builder.report import ReportWriter
from knifetip.formats.limits import Limits
from knifetip.model.drawing import LocationBoxes
from knifetip.svg.expand import Drawn, Unseen
from knifetip.svg.path import scanned


def columns(sheet: ReportWriter, drawn: Drawn, scale: float, limits: Limits) -> Columns:
    """Return all lines of a document as segments; elements that cannot be placed get their reason.

    Parameters
    ----------
    scale
        Millimetres to a file unit, 0 while it is unknown.

    Raises
    ------
    DrawingTooLarge
        More segments, or more time, than the limits allow.
    """
    table = scanned(drawn.data, limits.segments)
    if table is None:
        raise paths.too_many(limits, "SVG")
    for path in np.flatnonzero(table.wrong >= 0).tolist():
        text = drawn.data[path]
        at = int(table.wrong[path])
        where = (
            f"is wrong at character {at + 1} ({text[at : at + 12]!r})"
            if at < len(text)
            else "stops inside a command"
        )
        sheet.notes.setdefault(drawn.row[path], []).append(
            f"its path data {where}: drawn up to there, as in a browser"
        )
    if drawn.unseen:
        sheet.location_boxes.append(_location_boxes(drawn.unseen, limits))
    made = paths.Paths(
        np.array(drawn.row, np.int32),
        np.array(drawn.style, np.int32),
        np.array(drawn.matrix, np.float64).reshape(-1, 6),
    )
    return paths.columns(sheet, table, made, scale, limits, "SVG")


def _location_boxes(unseen: Sequence[Unseen], limits: Limits) -> LocationBoxes:
    """Return the boxes around elements that give no line."""
    rows, data, matrices = zip(*unseen, strict=True)
    matrix = np.array(matrices, np.float64).reshape(-1, 6)
    table = scanned(data, limits.segments)
    with np.errstate(all="ignore"):
        box = np.full((len(rows), 4), np.nan) if table is None else paths.boxes(table, matrix)
    return LocationBoxes(np.array(rows, np.int32), box)
