"""Find the stretches of curves that lie within a given distance of edges.

Curves and edges are lines and arcs as rows of six numbers (see ``curves.curve``).  The ends of a
stretch are computed in closed form; only the greatest distance within it is sampled.  A grid over
the edges finds the pairs of a curve and an edge that may be near each other.
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
    OutF64_2,
    OutI32_1,
    OutI32_2,
    OutI64_1,
    inline_kernel,
    kernel,
)
from knifetip.verification.columns import F64
from knifetip.verification.curves.intervals import Overlaps, sort_overlaps


def find_overlaps(curves: F64, edges: F64, low: F64, high: F64, limit: float) -> Overlaps:
    """Return the stretches of n curves that lie within ``limit`` of m edges.

    Parameters
    ----------
    curves : (n, 6)
        Lines and arcs as rows of six numbers (see ``curves.curve``).  A curve of length 0 is a
        point; it may lie up to ``limit`` past the ends of an edge.
    edges : (m, 6)
        The edges, in the same format.
    low, high : (m,) mm
        Start and end of the part of each edge that is compared; no part if high < low.
    limit : mm
        Greatest distance of a stretch from the edge.
    """
    if len(curves) == 0 or len(edges) == 0:
        return Overlaps.none()
    return search_overlaps(curves, list_edges(edges, limit), low, high, limit)


def search_overlaps(curves: F64, grid: EdgeGrid, low: F64, high: F64, limit: float) -> Overlaps:
    """Return the stretches of n curves that lie within ``limit`` of the m edges of a grid.

    The other arguments are those of ``find_overlaps``.
    """
    if len(curves) == 0:
        return Overlaps.none()
    curves = np.ascontiguousarray(curves)
    pairs, spans = _search_grid(
        curves, grid, np.ascontiguousarray(low), np.ascontiguousarray(high), limit
    )
    return sort_overlaps(pairs, spans, curves)


class EdgeGrid(NamedTuple):
    """A grid of square cells over m ≥ 1 edges, with the edges of each cell."""

    edges: F64_2  #: (m, 6) rows as in ``curves.curve``
    corner: F64_1  #: (2,) mm, lower left corner of the grid
    size: float  #: width of the cells, mm
    wide: int  #: number of columns
    tall: int  #: number of rows
    first: I32_1  #: as in ``CellLists``
    listed: I32_1


def list_edges(edges: F64, limit: float, margin: float = 0.0) -> EdgeGrid:
    """Return a grid of m ≥ 1 edges for searches with limits that are not much greater than
    ``limit``.

    ``edges`` are lines and arcs as rows of six numbers (see ``curves.curve``), (m, 6).  An edge is
    listed in each cell within ``margin`` of it.  The limit and the margin are distances in mm.
    """
    edges = np.ascontiguousarray(edges)
    corner, size, (wide, tall) = grid_layout(edges, limit)
    usable = np.ones(len(edges), np.bool_)
    cells = list_by_cell(edges, usable, margin, corner, size, wide, tall)
    return EdgeGrid(edges, corner, size, wide, tall, *cells)


def grid_layout(edges: F64, limit: float) -> tuple[F64, float, tuple[int, int]]:
    """Return the layout of a grid of square cells over edges and their surroundings.

    ``edges`` are lines and arcs as rows of six numbers (see ``curves.curve``), (n, 6).  The grid
    extends at least ``limit`` mm past them.  Returns the lower left corner of the grid (2,) mm, the
    width of its cells (mm), and its numbers of columns and rows.
    """
    low_x, low_y, high_x, high_y = _bounding_box(np.ascontiguousarray(edges))
    corner = np.array([low_x - limit, low_y - limit])
    extent = (high_x + limit - corner[0], high_y + limit - corner[1])
    size = max(2.0 * limit, 0.5, math.sqrt(extent[0] * extent[1] / len(edges)), max(extent) / 2048)
    shape = (int(extent[0] / size) + 1, int(extent[1] / size) + 1)
    return corner, size, shape


@kernel(allocates=False)
def _bounding_box(curves: F64_2) -> Any:
    """Return low x, low y, high x and high y (mm) of a box round lines and round full circles of
    arcs.
    """
    low_x, low_y, high_x, high_y = math.inf, math.inf, -math.inf, -math.inf
    for row in range(len(curves)):
        box = _curve_box(curves, row, 0.0, curves[row, 5])
        low_x, low_y = min(low_x, box[0]), min(low_y, box[1])
        high_x, high_y = max(high_x, box[2]), max(high_y, box[3])
    return low_x, low_y, high_x, high_y


@inline_kernel
def _curve_box(curves: F64_2, row: int, begin: float, end: float) -> Any:
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
    curves: F64_2,
    row: int,
    margin: float,
    corner: F64_1,
    size: float,
    wide: int,
    high: int,
    out: OutI32_1,
) -> int:
    """Write the indices of the grid cells within ``margin`` mm of a curve to ``out``.

    A cell may occur repeatedly.  Returns the number of indices; if it is greater than the length
    of ``out``, the last indices are missing.

    Parameters
    ----------
    curves, row
        Lines and arcs as rows of six numbers (see ``curves.curve``), and the row of the curve.
    corner : (2,) mm
        Lower left corner of the grid.
    size : mm
        Width of the square cells.
    wide, high
        Numbers of columns and rows of the grid.
    out
        Array that receives the indices from its start on.
    """
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


class CellLists(NamedTuple):
    """The curves of each cell of a grid: cell c has those of ``listed[first[c] : first[c + 1]]``,
    in the order of their indices.
    """

    first: I32_1  #: (cells + 1,)
    listed: I32_1


@kernel(checks_division=True)
def list_by_cell(
    curves: F64_2,
    usable: Bool_1,
    margin: float,
    corner: F64_1,
    size: float,
    wide: int,
    tall: int,
) -> Any:
    """Return the ``CellLists`` of those curves for which ``usable`` is True.

    A curve is listed in each cell within ``margin`` mm of it, once.  The curves are lines and arcs
    as rows of six numbers (see ``curves.curve``); ``cells_near_curve`` describes the grid.
    """
    first = np.zeros(wide * tall + 1, np.int32)
    last_row = np.full(wide * tall, -1, np.int32)
    cells = np.empty(64, np.int32)
    entries = np.empty(4 * len(curves) + 64, np.int32)
    ends = np.empty(len(curves), np.int64)
    row, used = 0, 0
    while True:
        row, used, room = _enter_cells(
            curves, usable, margin, corner, size, wide, tall, row, used, cells, entries, last_row,
            first, ends,
        )  # fmt: skip
        if row == len(curves):
            break
        if room > len(cells):
            cells = np.empty(2 * room, np.int32)
        longer = np.empty(2 * (used + room), np.int32)
        longer[:used] = entries[:used]
        entries = longer
    for cell in range(wide * tall):
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
    corner: F64_1,
    size: float,
    wide: int,
    tall: int,
    begin: int,
    used: int,
    cells: OutI32_1,
    entries: OutI32_1,
    last_row: OutI32_1,
    first: OutI32_1,
    ends: OutI64_1,
) -> Any:
    """Append the cells of the curves from row ``begin`` on to ``entries``, after ``used`` entries.

    Counts the curves of cell c in ``first[c + 1]``, and writes the number of entries after each
    curve to ``ends``.  ``last_row`` is the last curve in each cell, and ``cells`` is scratch.
    Returns the number of curves that are finished, the number of entries, and the number of cells
    of the curve for which ``cells`` or ``entries`` is too small.  ``list_by_cell`` describes the
    other arguments.
    """
    for row in range(begin, len(curves)):
        if usable[row]:
            many = cells_near_curve(curves, row, margin, corner, size, wide, tall, cells)
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


class _ComparedParts(NamedTuple):
    """The parts of m edges that are compared with curves."""

    low: F64_1  #: (m,) mm, start of the part
    high: F64_1  #: (m,) mm, its end; no part if high < low
    boxes: F64_2  #: (m, 4) mm, box outside of which no curve overlaps the part


@kernel
def _enclose_parts(edges: F64_2, low: F64_1, high: F64_1, limit: float) -> Any:
    """Return boxes outside of which no curve overlaps an edge, (m, 4) mm.

    A box is low x, low y, high x and high y; it is empty for an edge without a part to compare.
    ``low`` and ``high`` are the start and end of the part of each edge that is compared, (m,) mm.
    """
    boxes = np.empty((len(edges), 4))
    # A point may lie up to the limit beside an edge and up to the limit past its end.
    margin = 2.0 * limit + 1e-6
    for edge in range(len(edges)):
        if high[edge] < low[edge]:
            boxes[edge, 0] = boxes[edge, 1] = math.inf
            boxes[edge, 2] = boxes[edge, 3] = -math.inf
            continue
        box = _curve_box(edges, edge, low[edge], high[edge])
        boxes[edge, 0], boxes[edge, 1] = box[0] - margin, box[1] - margin
        boxes[edge, 2], boxes[edge, 3] = box[2] + margin, box[3] + margin
    return boxes


class _Found(NamedTuple):
    """Overlaps that have been found so far, and scratch arrays for the search."""

    pairs: OutI32_2  #: (c, 2) curve and edge
    spans: OutF64_2  #: (c, 5) see ``_overlap_pair``
    cells: OutI32_1
    met: OutI32_1  #: (m,) curve that was compared with each edge last
    hits: OutF64_2  #: (16, 5)
    near: OutF64_2  #: (8, 2)


@kernel
def _search_grid(curves: F64_2, grid: EdgeGrid, low: F64_1, high: F64_1, limit: float) -> Any:
    """Return the pairs of a curve and an edge that overlap, and their spans; see ``_Found``."""
    parts = _ComparedParts(low, high, _enclose_parts(grid.edges, low, high, limit))
    pairs = np.empty((max(256, 2 * len(curves)), 2), np.int32)
    spans = np.empty((len(pairs), 5))
    cells = np.empty(64, np.int32)
    met = np.full(len(grid.edges), -1, np.int32)
    hits, near = np.empty((16, 5)), np.empty((8, 2))
    curve, used = 0, 0
    while True:
        found = _Found(pairs, spans, cells, met, hits, near)
        curve, used, room = _search_from(curves, curve, limit, grid, parts, found, used)
        if curve == len(curves):
            return pairs[:used], spans[:used]
        # One of the arrays was too small for this curve.
        if room > len(cells):
            cells = np.empty(2 * room, np.int32)
        else:
            more_pairs = np.empty((2 * len(pairs), 2), np.int32)
            more_spans = np.empty((2 * len(pairs), 5))
            more_pairs[:used], more_spans[:used] = pairs[:used], spans[:used]
            pairs, spans = more_pairs, more_spans
        met[:] = -1


@kernel(allocates=False)
def _search_from(
    curves: F64_2,
    begin: int,
    limit: float,
    grid: EdgeGrid,
    parts: _ComparedParts,
    found: _Found,
    used: int,
) -> Any:
    """Write the overlaps of the curves from row ``begin`` on to ``found``, after ``used`` rows.

    Returns the number of curves that are finished, the number of overlaps, and the number of cells
    near the last curve.  The search ends early if an array of ``found`` is too small for a curve.
    """
    boxes, met, listed = parts.boxes, found.met, grid.listed
    for curve in range(begin, len(curves)):
        is_line = curves[curve, 0] == 0.0
        is_point = is_line and curves[curve, 5] == 0.0
        if is_point:
            many = _cells_near_point(curves[curve, 1], curves[curve, 2], limit, grid, found.cells)
        else:
            many = cells_near_curve(
                curves, curve, limit, grid.corner, grid.size, grid.wide, grid.tall, found.cells
            )
        if many > len(found.cells):
            return curve, used, many
        box = _curve_box(curves, curve, 0.0, curves[curve, 5])
        done = used
        for k in range(many):
            cell = found.cells[k]
            for place in range(grid.first[cell], grid.first[cell + 1]):
                edge = listed[place]
                if (
                    box[2] < boxes[edge, 0]
                    or box[0] > boxes[edge, 2]
                    or box[3] < boxes[edge, 1]
                    or box[1] > boxes[edge, 3]
                    or met[edge] == curve
                ):
                    continue
                met[edge] = curve
                if is_point and grid.edges[edge, 0] == 0.0:
                    hit_count = _overlap_point(
                        box[0], box[1], grid.edges, edge, parts.low[edge], parts.high[edge],
                        limit, found.hits,
                    )  # fmt: skip
                elif is_line and grid.edges[edge, 0] == 0.0:
                    hit_count = _overlap_lines(
                        curves, curve, grid.edges, edge, parts.low[edge], parts.high[edge],
                        limit, found.hits,
                    )  # fmt: skip
                else:
                    hit_count = _overlap_pair(
                        curves[curve],
                        grid.edges[edge],
                        parts.low[edge],
                        parts.high[edge],
                        limit,
                        found.near,
                        found.hits,
                    )
                if used + hit_count > len(found.pairs):
                    return curve, done, 0
                for hit in range(hit_count):
                    found.pairs[used, 0] = curve
                    found.pairs[used, 1] = edge
                    for column in range(5):
                        found.spans[used, column] = found.hits[hit, column]
                    used += 1
    return len(curves), used, 0


@inline_kernel
def _cells_near_point(x: float, y: float, margin: float, grid: EdgeGrid, out: OutI32_1) -> int:
    """Write the indices of the grid cells within ``margin`` mm of the point (x, y) to ``out``.

    This is the short form of ``cells_near_curve``, which describes the result.
    """
    column_0 = max(math.floor((x - margin - grid.corner[0]) / grid.size), 0)
    column_1 = min(math.floor((x + margin - grid.corner[0]) / grid.size), grid.wide - 1)
    row_0 = max(math.floor((y - margin - grid.corner[1]) / grid.size), 0)
    row_1 = min(math.floor((y + margin - grid.corner[1]) / grid.size), grid.tall - 1)
    count = 0
    for column in range(column_0, column_1 + 1):
        for row in range(row_0, row_1 + 1):
            if count < len(out):
                out[count] = column * grid.tall + row
            count += 1
    return count


@inline_kernel
def _overlap_lines(
    curves: F64_2, curve: int, edges: F64_2, edge: int, low: float, high: float, limit: float,
    hits: OutF64_2,
) -> int:  # fmt: skip
    """Write the overlap of a line with a straight edge to the first row of ``hits``.

    Returns the number of overlaps, 0 or 1.  This is the short form of ``_overlap_pair``, which
    describes the arguments, for two lines.
    """
    x, y, length = curves[curve, 1], curves[curve, 2], curves[curve, 5]
    ahead_x, ahead_y = curves[curve, 3], curves[curve, 4]
    edge_x, edge_y = edges[edge, 3], edges[edge, 4]
    dx, dy = x - edges[edge, 1], y - edges[edge, 2]
    offset = edge_x * dy - edge_y * dx
    slope = edge_x * ahead_y - edge_y * ahead_x
    begin, end = 0.0, length
    if abs(slope) * max(length, 1.0) < 1e-12:
        if abs(offset) > limit:
            return 0
    else:
        a, b = (-limit - offset) / slope, (limit - offset) / slope
        begin, end = max(min(a, b), 0.0), min(max(a, b), length)
        if begin > end:
            return 0
    begin_x, begin_y = x + ahead_x * begin - edges[edge, 1], y + ahead_y * begin - edges[edge, 2]
    end_x, end_y = x + ahead_x * end - edges[edge, 1], y + ahead_y * end - edges[edge, 2]
    first, last = begin_x * edge_x + begin_y * edge_y, end_x * edge_x + end_y * edge_y
    past = max(low - max(first, last), min(first, last) - high, 0.0)
    if past > (limit if end - begin < 1e-9 else 1e-9):
        return 0
    if past > 1e-9 and math.hypot(past, edge_x * begin_y - edge_y * begin_x) > limit:
        return 0
    from_place, to_place = min(max(first, low), high), min(max(last, low), high)
    if abs(last - first) > 1e-9:
        rate = (end - begin) / (last - first)
        end = begin + (to_place - first) * rate
        begin = begin + (from_place - first) * rate
    farthest = 0.0
    for sample in range(2):
        at = begin + (end - begin) * sample
        dx, dy = x + ahead_x * at - edges[edge, 1], y + ahead_y * at - edges[edge, 2]
        farthest = max(farthest, abs(edge_x * dy - edge_y * dx))
    hits[0, 0], hits[0, 1], hits[0, 2], hits[0, 3] = begin, end, from_place, to_place
    hits[0, 4] = farthest
    return 1


@inline_kernel
def _overlap_point(
    x: float, y: float, edges: F64_2, edge: int, low: float, high: float, limit: float,
    hits: OutF64_2,
) -> int:  # fmt: skip
    """Write the overlap of the point (x, y) with a straight edge to the first row of ``hits``.

    Returns the number of overlaps, 0 or 1.  This is the short form of ``_overlap_pair``, which
    describes the arguments, for the most common pairs.
    """
    dx, dy = x - edges[edge, 1], y - edges[edge, 2]
    along = dx * edges[edge, 3] + dy * edges[edge, 4]
    offset = abs(edges[edge, 3] * dy - edges[edge, 4] * dx)
    past = max(low - along, along - high, 0.0)
    if offset > limit or past > limit or (past > 1e-9 and math.hypot(past, offset) > limit):
        return 0
    place = min(max(along, low), high)
    hits[0, 0], hits[0, 1], hits[0, 2], hits[0, 3], hits[0, 4] = 0.0, 0.0, place, place, offset
    return 1


@kernel(allocates=False, checks_division=True)
def _project(edge: F64_1, x: float, y: float) -> Any:
    """Return the position of the point (x, y) along an edge, and its distance from the edge.

    Both are in mm, and refer to the infinite line or the full circle of the edge.  The distance is
    positive to the left of a line and outside of a circle.
    """
    dx = x - edge[1]
    dy = y - edge[2]
    if edge[0] == 0.0:
        return dx * edge[3] + dy * edge[4], edge[3] * dy - edge[4] * dx
    turned = edge[0] * (math.atan2(dy, dx) - edge[4])
    # Centre the range of angles on the arc, so that it extends beyond both ends.
    half = 0.5 * edge[5] / edge[3]
    turned = (turned - half + math.pi) % (2.0 * math.pi) - math.pi + half
    return turned * edge[3], math.hypot(dx, dy) - edge[3]


@kernel(allocates=False, checks_division=True)
def _point_on(curve: F64_1, along: float) -> Any:
    if curve[0] == 0.0:
        return curve[1] + curve[3] * along, curve[2] + curve[4] * along
    angle = curve[4] + curve[0] * along / curve[3]
    return curve[1] + curve[3] * math.cos(angle), curve[2] + curve[3] * math.sin(angle)


@kernel(allocates=False, checks_division=True)
def _overlap_pair(
    curve: F64_1,
    edge: F64_1,
    low: float,
    high: float,
    limit: float,
    near: OutF64_2,
    hits: OutF64_2,
) -> int:
    """Write the overlaps of one curve with one edge to the rows of ``hits``; return their number.

    ``low`` and ``high`` are the start and end of the part of the edge that is compared, and
    ``limit`` is the greatest distance of an overlap from the edge (mm).  A row has five lengths
    (mm): start and end of the overlap along the curve, the positions on the edge of these two
    points, and the greatest distance from the edge.  ``near`` is scratch, (8, 2).
    """
    if curve[0] == 0.0:
        pieces = _line_near_edge(curve, edge, limit, near)
    else:
        pieces = _arc_near_edge(curve, edge, limit, near)
    hit_count = 0
    for piece in range(pieces):
        begin = near[piece, 0]
        end = near[piece, 1]
        x, y = _point_on(curve, begin)
        first, _ = _project(edge, x, y)
        x, y = _point_on(curve, end)
        last, _ = _project(edge, x, y)
        turns = 1
        circumference = 0.0
        if edge[0] != 0.0:
            # On a circle, choose the turn of the end that fits the curve's length, and try the edge
            # one turn earlier and later.  A curve with its centre outside turns by less than π.
            circumference = 2.0 * math.pi * edge[3]
            ahead = 0.0
            if curve[0] != 0.0 and math.hypot(curve[1] - edge[1], curve[2] - edge[2]) < curve[3]:
                ahead = curve[0] * edge[0] * (end - begin) * edge[3] / curve[3]
            last += circumference * round((first + ahead - last) / circumference)
            turns = 3
        for turn in range(turns):
            shift = 0.0 if turn == 0 else (circumference if turn == 1 else -circumference)
            a = first + shift
            b = last + shift
            slack = limit if end - begin < 1e-9 else 1e-9
            past = max(low - max(a, b), min(a, b) - high, 0.0)
            if past > slack:
                continue
            if past > 1e-9:
                # A point beyond the end of the edge: its distance is that from the end.
                x, y = _point_on(curve, begin)
                _, offset = _project(edge, x, y)
                if math.hypot(past, offset) > limit:
                    continue
            u0 = begin
            u1 = end
            if abs(b - a) > 1e-9:
                rate = (end - begin) / (b - a)
                t0 = min(max(a, low), high)
                t1 = min(max(b, low), high)
                u0 = begin + (t0 - a) * rate
                u1 = begin + (t1 - a) * rate
                a = t0
                b = t1
            else:
                a = min(max(a, low), high)
                b = min(max(b, low), high)
            if hit_count == len(hits):
                return hit_count
            farthest = 0.0
            samples = 2 if curve[0] == 0.0 and edge[0] == 0.0 else 9
            for sample in range(samples):
                x, y = _point_on(curve, u0 + (u1 - u0) * sample / (samples - 1))
                _, offset = _project(edge, x, y)
                farthest = max(farthest, abs(offset))
            hits[hit_count, 0] = u0
            hits[hit_count, 1] = u1
            hits[hit_count, 2] = a
            hits[hit_count, 3] = b
            hits[hit_count, 4] = farthest
            hit_count += 1
    return hit_count


@kernel(allocates=False)
def _append_clipped(begin: float, end: float, length: float, near: OutF64_2, pieces: int) -> int:
    begin = max(begin, 0.0)
    end = min(end, length)
    if begin <= end and pieces < len(near):
        near[pieces, 0] = begin
        near[pieces, 1] = end
        return pieces + 1
    return pieces


@kernel(allocates=False, checks_division=True)
def _line_near_edge(curve: F64_1, edge: F64_1, limit: float, near: OutF64_2) -> int:
    """Find the stretches of a line that lie within ``limit`` mm of the line or circle of an edge.

    The edge is extended to its infinite line or full circle.  Writes start and end of each stretch
    along the line ``curve`` (mm) to the rows of ``near``; returns the number of stretches.
    """
    length = curve[5]
    if edge[0] == 0.0:
        _, offset = _project(edge, curve[1], curve[2])
        slope = edge[3] * curve[4] - edge[4] * curve[3]
        if abs(slope) * max(length, 1.0) < 1e-12:
            return _append_clipped(0.0, length, length, near, 0) if abs(offset) <= limit else 0
        a = (-limit - offset) / slope
        b = (limit - offset) / slope
        return _append_clipped(min(a, b), max(a, b), length, near, 0)
    foot = (edge[1] - curve[1]) * curve[3] + (edge[2] - curve[2]) * curve[4]
    centre_offset = (edge[1] - curve[1]) * curve[4] - (edge[2] - curve[2]) * curve[3]
    outer = (edge[3] + limit) ** 2 - centre_offset * centre_offset
    if outer < 0.0:
        return 0
    outer = math.sqrt(outer)
    inner = (edge[3] - limit) ** 2 - centre_offset * centre_offset
    if edge[3] <= limit or inner <= 0.0:
        return _append_clipped(foot - outer, foot + outer, length, near, 0)
    inner = math.sqrt(inner)
    pieces = _append_clipped(foot - outer, foot - inner, length, near, 0)
    return _append_clipped(foot + inner, foot + outer, length, near, pieces)


@kernel(allocates=False, checks_division=True)
def _arc_near_edge(curve: F64_1, edge: F64_1, limit: float, near: OutF64_2) -> int:
    """Find the stretches of an arc that lie within ``limit`` mm of the line or circle of an edge.

    The edge is extended to its infinite line or full circle.  Writes start and end of each stretch
    along the arc ``curve`` (mm) to the rows of ``near``; returns the number of stretches.  The
    distance of a point at angle α on the arc depends only on sin(α - shift), with a constant shift.
    The limit of the distance therefore becomes a lowest and a highest value of that sine.
    """
    radius = curve[3]
    if edge[0] == 0.0:
        # The distance from the line is middle + r sin(angle - direction of the line).
        _, middle = _project(edge, curve[1], curve[2])
        shift = math.atan2(edge[4], edge[3])
        lowest = (-limit - middle) / radius
        highest = (limit - middle) / radius
    else:
        # The distance from the centre is √(r² + D² + 2 r D cos(angle - direction of the centres)).
        dx = curve[1] - edge[1]
        dy = curve[2] - edge[2]
        distance = math.hypot(dx, dy)
        if distance < 1e-12:
            if abs(radius - edge[3]) <= limit:
                return _append_clipped(0.0, curve[5], curve[5], near, 0)
            return 0
        shift = math.atan2(dy, dx) - 0.5 * math.pi
        inside = max(edge[3] - limit, 0.0)
        fixed = radius * radius + distance * distance
        lowest = (inside * inside - fixed) / (2.0 * radius * distance)
        highest = ((edge[3] + limit) ** 2 - fixed) / (2.0 * radius * distance)
    if lowest > 1.0 or highest < -1.0:
        return 0
    if lowest <= -1.0 and highest >= 1.0:
        return _append_clipped(0.0, curve[5], curve[5], near, 0)
    low = math.asin(max(lowest, -1.0))
    high = math.asin(min(highest, 1.0))
    if highest >= 1.0:
        return _append_arc_spans(curve, shift + low, shift + math.pi - low, near, 0)
    if lowest <= -1.0:
        return _append_arc_spans(curve, shift - math.pi - high, shift + high, near, 0)
    pieces = _append_arc_spans(curve, shift + low, shift + high, near, 0)
    return _append_arc_spans(curve, shift + math.pi - high, shift + math.pi - low, near, pieces)


@kernel(allocates=False)
def _append_arc_spans(curve: F64_1, begin: float, end: float, near: OutF64_2, used: int) -> int:
    """Find the stretches of the arc ``curve`` that lie between two angles of its circle.

    The angles are ``begin`` and ``end`` (radians).  Appends the start and end of each stretch along
    the arc (mm) to the rows of ``near``, of which the first ``used`` are in use.  Returns the new
    number of rows in use.
    """
    if curve[0] < 0.0:
        begin, end = -end, -begin
    a = begin - curve[0] * curve[4]
    span = end - begin
    a = a % (2.0 * math.pi)
    for turn in range(-1, 1):
        angle = a + 2.0 * math.pi * turn
        used = _append_clipped(angle * curve[3], (angle + span) * curve[3], curve[5], near, used)
    return used
