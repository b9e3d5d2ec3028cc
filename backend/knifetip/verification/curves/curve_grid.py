"""List the curves that are near each cell of a grid.

Curves are lines and arcs as rows of six numbers (see ``curves.curve``).
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from knifetip.kernels import (
    F64_1,
    F64_2,
    I32_1,
    Bool_1,
    OutI32_1,
    OutI64_1,
    inline_kernel,
    kernel,
)
from knifetip.verification.columns import F64


class GridLayout(NamedTuple):
    """A grid of square cells."""

    corner: F64_1  #: (2,) mm, lower left corner of the grid
    size: float  #: width of the cells, mm
    wide: int  #: number of columns
    tall: int  #: number of rows


class CurveGrid(NamedTuple):
    """A grid of square cells over m ≥ 1 curves, with the curves of each cell."""

    curves: F64_2  #: (m, 6) rows as in ``curves.curve``
    layout: GridLayout
    first: I32_1  #: as in ``CellLists``
    listed: I32_1


def list_curves(curves: F64, limit: float, margin: float = 0.0) -> CurveGrid:
    """Return a grid of m ≥ 1 curves for searches with limits that are not much greater than
    ``limit``.

    ``curves`` are lines and arcs as rows of six numbers (see ``curves.curve``), (m, 6).  A curve is
    listed in each cell within ``margin`` of it.  The limit and the margin are distances in mm.
    """
    curves = np.ascontiguousarray(curves)
    layout = grid_layout(curves, limit)
    usable = np.ones(len(curves), np.bool_)
    return CurveGrid(curves, layout, *list_by_cell(curves, usable, margin, layout))


def grid_layout(curves: F64, limit: float) -> GridLayout:
    """Return the layout of a grid of square cells over curves and their surroundings.

    ``curves`` are lines and arcs as rows of six numbers (see ``curves.curve``), (n, 6).  The grid
    extends at least ``limit`` mm past them.
    """
    low_x, low_y, high_x, high_y = _bounding_box(np.ascontiguousarray(curves))
    corner = np.array([low_x - limit, low_y - limit])
    extent = (high_x + limit - corner[0], high_y + limit - corner[1])
    size = max(2.0 * limit, 0.5, math.sqrt(extent[0] * extent[1] / len(curves)), max(extent) / 2048)
    return GridLayout(corner, size, int(extent[0] / size) + 1, int(extent[1] / size) + 1)


@kernel(allocates=False)
def _bounding_box(curves: F64_2) -> Any:
    """Return low x, low y, high x and high y (mm) of a box round lines and round full circles of
    arcs.
    """
    low_x, low_y, high_x, high_y = math.inf, math.inf, -math.inf, -math.inf
    for row in range(len(curves)):
        box = curve_box(curves, row, 0.0, curves[row, 5])
        low_x, low_y = min(low_x, box[0]), min(low_y, box[1])
        high_x, high_y = max(high_x, box[2]), max(high_y, box[3])
    return low_x, low_y, high_x, high_y


@inline_kernel
def curve_box(curves: F64_2, row: int, begin: float, end: float) -> Any:
    """Return low x, low y, high x and high y (mm) of a box round a part of a curve.

    The part of a line reaches from ``begin`` to ``end`` (mm along the line); the box of an arc
    contains its full circle.
    """
    x, y = curves[row, 1], curves[row, 2]
    if curves[row, 0] != 0.0:
        radius = curves[row, 3]
        return x - radius, y - radius, x + radius, y + radius
    x0, y0 = x + begin * curves[row, 3], y + begin * curves[row, 4]
    x1, y1 = x + end * curves[row, 3], y + end * curves[row, 4]
    return min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1)


@kernel(allocates=False, checks_division=True)
def cells_near_curve(
    curves: F64_2, row: int, margin: float, layout: GridLayout, out: OutI32_1
) -> int:
    """Write the indices of the grid cells within ``margin`` mm of a curve to ``out``.

    A cell may occur repeatedly.  Returns the number of indices; if it is greater than the length
    of ``out``, the last indices are missing.

    Parameters
    ----------
    curves, row
        Lines and arcs as rows of six numbers (see ``curves.curve``), and the row of the curve.
    layout
        Position, width and number of the cells.
    out
        Array that receives the indices from its start on.
    """
    corner, size, wide, high = layout
    count = 0
    kind, cx, cy, p, q = (
        curves[row, 0],
        curves[row, 1],
        curves[row, 2],
        curves[row, 3],
        curves[row, 4],
    )
    length = curves[row, 5]
    step = size
    if kind != 0.0:
        step = min(size, 0.5 * p)
    pieces = max(1, math.ceil(length / step))
    each = length / pieces
    bow = 0.0
    if kind != 0.0:
        bow = each * each / (8.0 * p)
    x = 0.0
    y = 0.0
    for node in range(pieces + 1):
        if kind == 0.0:
            nx = cx + p * each * node
            ny = cy + q * each * node
        else:
            angle = q + kind * each * node / p
            nx = cx + p * math.cos(angle)
            ny = cy + p * math.sin(angle)
        if node > 0:
            grown = margin + bow
            x0 = math.floor((min(x, nx) - grown - corner[0]) / size)
            x1 = math.floor((max(x, nx) + grown - corner[0]) / size)
            y0 = math.floor((min(y, ny) - grown - corner[1]) / size)
            y1 = math.floor((max(y, ny) + grown - corner[1]) / size)
            for i in range(max(x0, 0), min(x1, wide - 1) + 1):
                for j in range(max(y0, 0), min(y1, high - 1) + 1):
                    if count < len(out):
                        out[count] = i * high + j
                    count += 1
        x = nx
        y = ny
    return count


@inline_kernel
def cells_near_point(x: float, y: float, margin: float, layout: GridLayout, out: OutI32_1) -> int:
    """Write the indices of the grid cells within ``margin`` mm of the point (x, y) to ``out``.

    This is the short form of ``cells_near_curve``, which describes the result.
    """
    corner, size, wide, tall = layout
    column_0 = max(math.floor((x - margin - corner[0]) / size), 0)
    column_1 = min(math.floor((x + margin - corner[0]) / size), wide - 1)
    row_0 = max(math.floor((y - margin - corner[1]) / size), 0)
    row_1 = min(math.floor((y + margin - corner[1]) / size), tall - 1)
    count = 0
    for column in range(column_0, column_1 + 1):
        for row in range(row_0, row_1 + 1):
            if count < len(out):
                out[count] = column * tall + row
            count += 1
    return count


class CellLists(NamedTuple):
    """The curves of each cell of a grid: cell c has those of ``listed[first[c] : first[c + 1]]``,
    in the order of their indices.
    """

    first: I32_1  #: (cells + 1,)
    listed: I32_1


class _Entries(NamedTuple):
    """Pairs of a curve and a cell of a grid, in the order of the curves, and what is counted."""

    cells: OutI32_1  #: scratch for the cells of one curve
    entries: OutI32_1  #: cell of each pair
    last_row: OutI32_1  #: (cells,) last curve in each cell, -1 for none
    first: OutI32_1  #: (cells + 1,) number of the curves of cell c in row c + 1
    ends: OutI64_1  #: (n,) number of pairs after each curve


@kernel(checks_division=True)
def list_by_cell(curves: F64_2, usable: Bool_1, margin: float, layout: GridLayout) -> Any:
    """Return the ``CellLists`` of those curves for which ``usable`` is True.

    A curve is listed in each cell within ``margin`` mm of it, once.  The curves are lines and arcs
    as rows of six numbers (see ``curves.curve``).
    """
    count = layout.wide * layout.tall
    first = np.zeros(count + 1, np.int32)
    last_row = np.full(count, -1, np.int32)
    cells = np.empty(64, np.int32)
    entries = np.empty(4 * len(curves) + 64, np.int32)
    ends = np.empty(len(curves), np.int64)
    row, used = 0, 0
    while True:
        found = _Entries(cells, entries, last_row, first, ends)
        row, used, room = _enter_cells(curves, usable, margin, layout, row, used, found)
        if row == len(curves):
            break
        if room > len(cells):
            cells = np.empty(2 * room, np.int32)
        longer = np.empty(2 * (used + room), np.int32)
        longer[:used] = entries[:used]
        entries = longer
    for cell in range(count):
        first[cell + 1] += first[cell]
        last_row[cell] = first[cell]
    listed = np.empty(used, np.int32)
    entry = 0
    for row in range(len(curves)):
        while entry < ends[row]:
            cell = entries[entry]
            listed[last_row[cell]] = row
            last_row[cell] += 1
            entry += 1
    return CellLists(first, listed)


@kernel(allocates=False, checks_division=True)
def _enter_cells(
    curves: F64_2,
    usable: Bool_1,
    margin: float,
    layout: GridLayout,
    begin: int,
    used: int,
    found: _Entries,
) -> Any:
    """Append the cells of the curves from row ``begin`` on to ``found``, after ``used`` entries.

    Returns the number of curves that are finished, the number of entries, and the number of cells
    of the curve for which ``cells`` or ``entries`` is too small.  ``list_by_cell`` describes the
    other arguments.
    """
    cells, entries, last_row, first, ends = found
    for row in range(begin, len(curves)):
        if usable[row]:
            many = cells_near_curve(curves, row, margin, layout, cells)
            if many > len(cells) or used + many > len(entries):
                return row, used, many
            for k in range(many):
                cell = cells[k]
                if last_row[cell] != row:
                    last_row[cell] = row
                    entries[used] = cell
                    used += 1
                    first[cell + 1] += 1
        ends[row] = used
    return len(curves), used, 0
