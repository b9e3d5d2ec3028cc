"""Find the paths of a page that lie outside its visible area, and those that cross its border.

A path outside the page is not visible.  It is kept if it is connected with a path that is at least
partly visible, because it then belongs to the same outline: a carton may be larger than the page.
If the whole drawing lies outside the page, the page has nothing to do with it, and all is kept.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.drawing_builder.clip import Box
from knifetip.drawing_builder.path_table import Table, transform_points
from knifetip.drawing_builder.report import ReportWriter
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.union_find import component_roots
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message

#: Distance by which a path may exceed the page, and within which ends are connected, as fractions
#: of the longer side of the page.
_MARGIN: Final = 1e-5
_NEAR: Final = 1e-4
#: Shifts of the grid to which ends are rounded, in cells: near ends share a cell of one grid.
_SHIFTS: Final = ((0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5))


class PageBorder(NamedTuple):
    """Position of p paths relative to the page."""

    outside: Bool  #: (p,) whether the path is not visible
    crossing: Bool  #: (p,) whether the path is kept although a part or all of it is outside
    note: Message  #: note about the paths that are kept


def compare_with_page(table: Table, matrix: F64, box: F64, page: Box) -> PageBorder:
    """Return which of p paths lie outside the page, and which cross its border.

    Parameters
    ----------
    table, matrix : Table and (p, 6)
        Segments of the paths, and the matrix of each path to file units.
    box : (p, 4)
        Bounding box of each path (file units).
    page
        Visible area of the page (file units); sides that do not limit it are infinite.
    """
    sides = [side for side in page if np.isfinite(side)]
    size = max(sides) - min(sides) if sides else 0.0
    low, high = box[:, :2], box[:, 2:]
    least, most = np.array(page[:2]), np.array(page[2:])
    margin = _MARGIN * size
    # A line on the border is visible.
    outside = np.any((high < least - margin) | (low > most + margin), axis=1)
    beyond = np.any((low < least - margin) | (high > most + margin), axis=1)
    drawn = ~np.isnan(box[:, 0])
    if outside[drawn].all():
        note = Message("import.all-outside-page")
        return PageBorder(np.zeros_like(outside), outside, note)
    if outside.any():
        part = _connected_paths(table, matrix, _NEAR * size)
        seen = np.zeros(len(part), bool)
        # A path without segments has no box and connects nothing.
        seen[part[~outside & drawn]] = True
        outside &= ~seen[part]
    return PageBorder(outside, beyond & ~outside, Message("import.partly-outside-page"))


def report_page_border(report: ReportWriter, row: I32, border: PageBorder) -> None:
    """Write to the import report which paths lie outside the page, and which cross its border.

    ``row`` (p,) is the row of each path in the report.
    """
    for one in row[border.outside].tolist():
        report.dropped.setdefault(one, Message("import.outside-page"))
    for one in row[border.crossing].tolist():
        report.notes.setdefault(one, []).append(border.note)


def _connected_paths(table: Table, matrix: F64, near: float) -> I64:
    """Return for each of p paths the number of the set of paths that its ends connect, (p,).

    ``near`` is the distance (file units) within which ends are connected.
    """
    matrices = matrix[table.path]
    points = np.concatenate(
        [transform_points(matrices, table.numbers[:, k : k + 2]) for k in (0, 2)]
    )
    path = np.concatenate([table.path, table.path])
    finite = np.isfinite(points).all(axis=1) & (np.abs(points) < near * 2.0**60).all(axis=1)
    points, path = points[finite], path[finite]
    pairs = []
    for shift in _SHIFTS:
        first, cell = unique_rows(np.floor(points / near + shift).astype(np.int64))
        pairs.append(np.stack([path[first[cell]], path], axis=1))
    roots: I64 = component_roots(np.concatenate(pairs).reshape(-1), len(matrix))
    return roots
