"""segments: convert path data and matrices to arrays of lines and arcs.

The arrays contain the ends, the bulge and the style of each line or arc, in file order.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from knifetip.drawing_builder.columns import Columns
from knifetip.drawing_builder.path_segments import too_many
from knifetip.drawing_builder.path_table import Paths, boxes
from knifetip.drawing_builder.paths import columns
from knifetip.drawing_builder.report import ReportWriter
from knifetip.formats.limits import Limits
from knifetip.messages import Message
from knifetip.model.drawing import LocationBoxes
from knifetip.svg.drawn_paths import DrawnPaths, OmittedShape
from knifetip.svg.path_data import scan_paths


def segment_columns(
    report: ReportWriter, drawn_paths: DrawnPaths, scale: float, limits: Limits
) -> Columns:
    """Return the segments of all drawn paths as lines and arcs.

    Parameters
    ----------
    report
        Import report, which is changed: it gets notes on errors in path data, reasons for dropped
        paths, and the locations of elements that give no edge.
    drawn_paths
        Paths of the drawn elements.
    scale
        Millimetres in one file unit, 0 if unknown.
    limits
        Limits of the number of segments and of the time.

    Raises
    ------
    DrawingTooLarge
        The number of segments or the time exceeds the limits.
    """
    table = scan_paths(drawn_paths.data, limits.segments)
    if table is None:
        raise too_many(limits, "SVG")
    for path in np.flatnonzero(table.wrong >= 0).tolist():
        text = drawn_paths.data[path]
        error_position = int(table.wrong[path])
        note = (
            Message(
                "import.bad-path-data",
                character=error_position + 1,
                text=text[error_position : error_position + 12],
            )
            if error_position < len(text)
            else Message("import.short-path-data")
        )
        report.notes.setdefault(drawn_paths.row[path], []).append(note)
    if drawn_paths.omitted:
        report.location_boxes.append(_location_boxes(drawn_paths.omitted, limits))
    placed = Paths(
        np.array(drawn_paths.row, np.int32),
        np.array(drawn_paths.style, np.int32),
        np.array(drawn_paths.matrix, np.float64).reshape(-1, 6),
    )
    return columns(report, table, placed, scale, limits, "SVG")


def _location_boxes(omitted: Sequence[OmittedShape], limits: Limits) -> LocationBoxes:
    """Return the bounding box and the import report row of each element that gives no edge.

    ``omitted`` contains the path of each such element.
    """
    rows, data, matrices = zip(*omitted, strict=True)
    matrix = np.array(matrices, np.float64).reshape(-1, 6)
    table = scan_paths(data, limits.segments)
    with np.errstate(all="ignore"):
        box = np.full((len(rows), 4), np.nan) if table is None else boxes(table, matrix)
    return LocationBoxes(np.array(rows, np.int32), box)
