"""Convert paths of SVG and PDF files to arrays of lines and arcs.

Curves are approximated by ``path_segments``.  The tolerance of the approximation is
``tolerance.CURVE`` (0.0035 mm).  If the unit of the file is unknown, the tolerance is 1 / 250,000
of the diagonal of the drawing, so that it is at most 0.0035 mm for drawings smaller than 0.87 m.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.drawing_builder.clip_segments import ClippedSegments, clip_segments
from knifetip.drawing_builder.columns import Columns
from knifetip.drawing_builder.path_segments import PlacedSegments, fit_segments
from knifetip.drawing_builder.path_table import Paths, Table, farthest_coordinates
from knifetip.drawing_builder.report import ReportWriter, curves_fitted, too_far
from knifetip.formats.limits import REACH, Limits
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.tolerance import CURVE
from knifetip.messages import Message
from knifetip.model.drawing import LocationBoxes
from knifetip.model.unit import MILLIMETRES

#: Fitting tolerance for an unknown unit, as a fraction of the diagonal of the drawing.
_TOLERANCE_PER_SIZE: Final = 1.0 / 250_000.0
#: Distance (mm) beyond the edge of a clip path within which a line is visible: lines have a width.
_CLIP_MARGIN: Final = 0.02


def columns(
    sheet: ReportWriter, table: Table, paths: Paths, scale: float, limits: Limits, format_name: str
) -> Columns:
    """Return all segments of the paths of a file as lines and arcs in file units.

    The reasons for paths that are dropped are written to ``sheet``.

    Parameters
    ----------
    sheet
        Import report of the file.
    table, paths
        Segments of the paths, and report row, style and matrix of each path.
    scale
        Millimetres per file unit, 0 if unknown.
    limits
        Limits of the number of segments and of the time.
    format_name
        Name of the file format in error messages: "SVG" or "PDF".

    Raises
    ------
    DrawingTooLarge
        The number of segments or the time exceeds its limit.
    """
    rows, matrix = paths.row, paths.matrix
    with np.errstate(all="ignore"):
        farthest = farthest_coordinates(table, matrix, len(rows))
        reach = REACH / (scale or 1.0)
        for path in np.flatnonzero(~(farthest <= reach)).tolist():
            sheet.dropped[int(rows[path])] = too_far(farthest[path], reach)
        good = (farthest <= reach)[table.path]
        table = Table(table.kind[good], table.numbers[good], table.path[good])
        placed = PlacedSegments(table, matrix[table.path])
        tolerance = CURVE / scale if scale else _tolerance_without_unit(placed.start, placed.end)
        segments = fit_segments(placed, tolerance, limits, format_name)
    kept = np.arange(len(segments.bulge))
    path_of = table.path[segments.origin]
    if placed.failed:
        lost = np.zeros(len(rows), bool)
        for segment, reason in placed.failed.items():
            lost[table.path[segment]] = True
            sheet.dropped[int(rows[table.path[segment]])] = reason
        kept = np.flatnonzero(~lost[path_of])
    ends, bulge = segments.ends[kept], segments.bulge[kept]
    if paths.clip:
        clipped = _clip(sheet, paths, ends, bulge, path_of[kept], scale)
        ends, bulge, kept = clipped.ends, clipped.bulge, kept[clipped.source]
    path_of, origin = path_of[kept], segments.origin[kept]
    fitted = np.bincount(path_of[segments.curved[origin]], minlength=len(rows))
    for one in np.flatnonzero(fitted).tolist():
        sheet.notes.setdefault(int(rows[one]), []).append(
            curves_fitted(int(fitted[one]), tolerance, relative=not scale)
        )
    return Columns(ends, bulge, rows[path_of], paths.style[path_of], segments.error[kept])


def _clip(
    sheet: ReportWriter, paths: Paths, ends: F64, bulge: F64, path_of: I64, scale: float
) -> ClippedSegments:
    """Return the parts of n segments that are visible, and write to ``sheet`` what was removed.

    ``sheet``: import report of the file.
    ``paths``: report row and clip of each path.
    ``ends``, ``bulge``, ``path_of`` (n, 2, 2), (n,) and (n,): the segments, and the path of each.
    ``scale``: millimetres per file unit, 0 if unknown.
    """
    index = {id(clip): number for number, clip in enumerate(paths.clip)}
    clip_of = np.array([index[id(clip)] for clip in paths.clip], np.int64)
    margin = _CLIP_MARGIN / (scale or MILLIMETRES["pt"])
    clipped = clip_segments(ends, bulge, clip_of[path_of], paths.clip, margin)
    count = len(paths.row)
    drawn = np.bincount(path_of, minlength=count)
    length = np.bincount(path_of, _lengths(ends, bulge), minlength=count)
    is_left = np.bincount(path_of[clipped.source], minlength=count) > 0
    left = np.bincount(
        path_of[clipped.source], _lengths(clipped.ends, clipped.bulge), minlength=count
    )
    unlimited = np.bincount(path_of[clipped.unlimited], minlength=count) > 0
    removed = (drawn > 0) & ~is_left
    for row in paths.row[removed].tolist():
        sheet.dropped[row] = Message("import.clipped-away")
    box = np.tile((np.inf, np.inf, -np.inf, -np.inf), (count, 1))
    np.minimum.at(box[:, :2], path_of, ends.min(axis=1))
    np.maximum.at(box[:, 2:], path_of, ends.max(axis=1))
    sheet.location_boxes.append(LocationBoxes(paths.row[removed], box[removed]))
    for path in np.flatnonzero(is_left & (left < length - margin)).tolist():
        sheet.notes.setdefault(int(paths.row[path]), []).append(Message("import.clipped"))
    incomplete = np.array([clip.incomplete for clip in paths.clip]) | unlimited
    for path in np.flatnonzero(is_left & incomplete).tolist():
        sheet.notes.setdefault(int(paths.row[path]), []).append(Message("import.not-clipped"))
    return clipped


def _lengths(ends: F64, bulge: F64) -> F64:
    return arc.length(ends[:, 0], ends[:, 1], bulge)


def _tolerance_without_unit(start: F64, end: F64) -> float:
    """Return the fitting tolerance for a drawing whose unit is unknown (file units).

    It is 1 / 250,000 of the diagonal of the drawing, at most ``CURVE``, and ``CURVE`` for a drawing
    without extent.

    ``start``, ``end`` (n, 2): ends of the segments of the drawing (file units).
    """
    if not len(start):
        return CURVE
    ends = np.concatenate([start, end])
    size = float(np.hypot(*(ends.max(axis=0) - ends.min(axis=0))))
    return min(CURVE, size * _TOLERANCE_PER_SIZE) if size > 0.0 else CURVE
