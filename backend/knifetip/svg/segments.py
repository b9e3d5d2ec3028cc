"""segments: convert path data and matrices to arrays of lines and arcs.

The arrays contain the ends, the bulge and the style of each line or arc, in file order.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from knifetip.drawing_builder.clip import UNCLIPPED
from knifetip.drawing_builder.columns import Columns, Style
from knifetip.drawing_builder.line_widths import add_line_widths, enlargements
from knifetip.drawing_builder.page_border import compare_with_page, report_page_border
from knifetip.drawing_builder.path_segments import too_many
from knifetip.drawing_builder.path_table import Paths, boxes
from knifetip.drawing_builder.paths import columns
from knifetip.drawing_builder.report import ReportWriter
from knifetip.drawing_builder.white_lines import is_white, unseen_white_lines
from knifetip.formats.limits import Limits
from knifetip.geometry.columns import F64, Bool
from knifetip.messages import Message
from knifetip.model.drawing import LocationBoxes
from knifetip.svg.drawn_paths import DrawnPaths, OmittedShape
from knifetip.svg.filled_outlines import FilledPaths, close_subpaths, find_filled_outlines
from knifetip.svg.page import Page
from knifetip.svg.path_data import ScannedPaths, scan_paths


def segment_columns(
    report: ReportWriter, drawn_paths: DrawnPaths, page: Page, limits: Limits
) -> tuple[Columns, list[Style]]:
    """Return the segments of all visible paths as lines and arcs, and their styles.

    Parameters
    ----------
    report
        Import report, which is changed: it gets reasons for dropped paths, notes about changed
        ones, and the locations of elements that give no edge.
    drawn_paths
        Paths of the drawn elements.
    page
        The page, with the length of a file unit.
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
    row = np.array(drawn_paths.row, np.int32)
    matrix = np.array(drawn_paths.matrix, np.float64).reshape(-1, 6)
    with np.errstate(all="ignore"):
        box = boxes(table, matrix)
        kept = _report_broken_paths(report, drawn_paths, table)
        kept &= _report_invisible_paths(report, drawn_paths, table, matrix, box, kept)
    if drawn_paths.omitted:
        report.location_boxes.append(_location_boxes(drawn_paths.omitted, limits))
    report.location_boxes.append(LocationBoxes(row[~kept], box[~kept]))
    is_clipped = any(clip is not UNCLIPPED for clip in drawn_paths.clip)
    widths = _line_widths(drawn_paths, matrix, page)[kept]
    styles, style = add_line_widths(
        drawn_paths.styles, np.array(drawn_paths.style, np.int32)[kept], widths
    )
    placed = Paths(
        row[kept],
        style,
        matrix[kept],
        [drawn_paths.clip[path] for path in np.flatnonzero(kept).tolist()] if is_clipped else (),
    )
    is_area = np.array([stroke is None for stroke in drawn_paths.stroke], np.bool_)[kept]
    segments = close_subpaths(table.select(kept), is_area)
    return columns(report, segments, placed, page.scale, limits, "SVG"), styles


def _line_widths(drawn_paths: DrawnPaths, matrix: F64, page: Page) -> F64:
    """Return the width of the stroke of each of p paths, (p,) (mm; file units without a unit).

    The width is negative for a path without a stroke.  ``matrix`` (p, 6) is the matrix of each path
    to file units.
    """
    with np.errstate(all="ignore"):
        fixed = np.array(drawn_paths.fixed_stroke, np.bool_)
        factors = np.where(fixed, page.pixel, enlargements(matrix))
        widths: F64 = np.array(drawn_paths.stroke_width, np.float64) * factors
        return widths * (page.scale or 1.0)


def _report_broken_paths(
    report: ReportWriter, drawn_paths: DrawnPaths, table: ScannedPaths
) -> Bool:
    """Drop the paths with an error in their data, and return the mask of the others, (p,).

    A browser draws such a path up to the error, but half an outline is not what its author drew.
    """
    for path in np.flatnonzero(table.wrong >= 0).tolist():
        row = drawn_paths.row[path]
        text, position = drawn_paths.data[path], int(table.wrong[path])
        kind = report.kind[row]
        if kind in ("polyline", "polygon"):
            # The path data begin with "M", and those of a polygon end with "Z".
            rest = text[position:].removesuffix("Z")
            reason = (
                Message("import.bad-points", points=text[position : position + 12])
                if rest.strip(" \t\r\n,") and not _is_number(rest)
                else Message("import.odd-points")
            )
        elif position < len(text):
            part = text[position : position + 12]
            reason = Message("import.bad-path-data", character=position + 1, text=part)
        else:
            reason = Message("import.short-path-data")
        report.dropped[row] = reason
    unbroken: Bool = table.wrong < 0
    return unbroken


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _report_invisible_paths(
    report: ReportWriter,
    drawn_paths: DrawnPaths,
    table: ScannedPaths,
    matrix: F64,
    box: F64,
    unbroken: Bool,
) -> Bool:
    """Drop the paths that are not visible and areas beside lines; return the mask of the others.

    ``report``: import report, which gets the reasons and notes.
    ``drawn_paths``, ``table``, ``matrix``, ``box``: the p paths with their segments, matrices, (p,
    6), and bounding boxes, (p, 4).
    ``unbroken`` (p,): mask of the paths without an error in their data.
    """
    row = np.array(drawn_paths.row, np.int32)
    white = unbroken & unseen_white_lines(
        drawn_paths.stroke, drawn_paths.fill, box, page=drawn_paths.page_colour
    )
    border = compare_with_page(table, matrix, box, drawn_paths.page)
    report_page_border(report, row, border)
    on_page = unbroken & ~border.outside
    is_area = white | np.array([stroke is None for stroke in drawn_paths.stroke], bool)
    fills = drawn_paths.fill
    filled = np.array([fill is not None for fill in fills], bool)
    coloured = filled & np.array([fill is not None and not is_white(fill) for fill in fills], bool)
    is_line = on_page & ~is_area
    if is_line.any():
        kept = find_filled_outlines(
            FilledPaths(table, matrix, box, is_line, on_page & is_area & coloured)
        )
        note = Message("import.area-outline-round-lines")
    else:
        kept = on_page & is_area & filled
        note = Message("import.area-outline")
    for path in np.flatnonzero(on_page & is_area).tolist():
        one = int(row[path])
        if kept[path]:
            report.notes.setdefault(one, []).append(note)
        elif not filled[path]:
            report.dropped[one] = Message("import.white-line")
        elif not coloured[path]:
            report.dropped[one] = Message("import.white-area")
        else:
            report.dropped[one] = Message("import.filled-area-beside-strokes")
    visible: Bool = is_line | kept
    return visible


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
