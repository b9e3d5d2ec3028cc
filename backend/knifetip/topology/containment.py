"""containment: the bounded face that holds each component of edges that meet only at their ends.

    edges, the faces on their sides, their components -> enclosing face and depth of each component

A ray downwards from the lowest point of a component first hits either the boundary of the face
that holds the component, or a neighbouring component in the same face.  The edges are split into
spans, which run from left to right, so that a vertical ray meets each of them at most once.

The rays walk through a grid of cells: the time is linear in the number of edges, but for sorting.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_1, F64_2, I32_1, I64_1, Bool_1, OutF64_2, OutI64_1, kernel

#: Columns of a span: its left and right end (4), the centre and the radius of its circle (3), and
#: whether it is on the upper half of the circle (1), on the lower half (-1), or straight (0).
_SPAN: Final = 8
#: Limit for the mean number of cells that a span has in one row or one column of the grid.
_CROWDED: Final = 4.0


def enclosing_by_rays(
    start: F64, end: F64, bulge: F64, face: I32, outer: Bool, component: I32
) -> tuple[I64, I64]:
    """Return the bounded face around each component, -1 for none, and its nesting depth.

    Parameters
    ----------
    start, end, bulge : (n, 2), (n, 2) mm and (n,)
        Edges; ends that meet are equal to the last bit, so that no ray passes between them.
    face : (n, 2)
        Faces on the left and on the right of each edge.
    outer : (f,)
        Whether each face is the outer face of its component.
    component : (n,)
        Component of each edge, 0 … c - 1.

    Returns
    -------
    enclosing, depth : (c,) and (c,)
    """
    count = int(component.max()) + 1
    if count == 1:
        return np.full(1, -1, np.int64), np.zeros(1, np.int64)
    centre = np.where(np.abs(bulge)[:, None] < BULGE, 0.0, arc.centre(start, end, bulge))
    radius = arc.radius(start, end, bulge)
    spans, above = _split_into_spans(
        start, end, bulge, centre, np.where(np.isfinite(radius), radius, 0.0)
    )
    if len(spans) == 0:
        return np.full(count, -1, np.int64), np.zeros(count, np.int64)
    owner = component[above // 2]
    low, size, shape = _grid_layout(spans)
    lowest = _lowest_points(start, end, component, spans, owner, count)
    first, listed = _fill_cells(spans, low, size, shape)
    hit = _first_below(lowest, spans, owner, low, size, shape, first, listed)
    # A component that is hit has a lower lowest point, so its enclosing face is found earlier.
    order = np.argsort(lowest[:, 1], kind="stable")
    enclosing, depth = _follow_hits(order, hit, above, face.ravel(), outer, component)
    return enclosing, depth


@kernel
def _follow_hits(
    order: I64_1, hit: I64_1, above: I64_1, face: I32_1, outer: Bool_1, component: I32_1
) -> Any:
    """Return enclosing face and depth of each component, from the span that its ray hits."""
    enclosing = np.full(len(order), -1, np.int64)
    depth = np.zeros(len(order), np.int64)
    for c in order:
        if hit[c] < 0:
            continue
        half = above[hit[c]]
        around = component[half // 2]
        if outer[face[half]]:
            enclosing[c], depth[c] = enclosing[around], depth[around]
        else:
            enclosing[c], depth[c] = face[half], depth[around] + 1
    return enclosing, depth


@kernel
def _split_into_spans(start: F64_2, end: F64_2, bulge: F64_1, centre: F64_2, radius: F64_1) -> Any:
    """Return the spans of all edges, (k, 8), and the half-edge on the upper side of each, (k,)."""
    spans = np.empty((3 * len(bulge), _SPAN))
    above = np.empty(3 * len(bulge), np.int64)
    count = 0
    for i in range(len(bulge)):
        ax, ay, bx, by = start[i, 0], start[i, 1], end[i, 0], end[i, 1]
        if radius[i] == 0.0:
            count = _add_span(spans, above, count, i, ax, ay, bx, by, 0.0, 0.0, 0.0, 0.0)
            continue
        cx, cy, r = centre[i, 0], centre[i, 1], radius[i]
        first = math.atan2(ay - cy, ax - cx)
        sweep = 4.0 * math.atan(bulge[i])
        turn = 1.0 if sweep > 0.0 else -1.0
        # Arcs are split at the leftmost and the rightmost point of their circle.
        half = np.floor(first / math.pi) if turn > 0.0 else np.ceil(first / math.pi)
        x, y = ax, ay
        while True:
            until = (half + turn) * math.pi
            last = (until - first) * turn >= abs(sweep)
            nx = bx if last else cx + r * math.cos(until)
            ny = by if last else cy
            # Between two multiples of pi the sine keeps its sign.
            side = 1.0 if math.sin((half + 0.5 * turn) * math.pi) > 0.0 else -1.0
            count = _add_span(spans, above, count, i, x, y, nx, ny, cx, cy, r, side)
            if last:
                break
            x, y = nx, ny
            half += turn
    return spans[:count].copy(), above[:count].copy()


@kernel
def _add_span(
    spans: OutF64_2, above: OutI64_1, count: int, edge: int,
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, r: float, side: float,
) -> int:  # fmt: skip
    """Add one span unless it is vertical; return the number of spans."""
    if ax == bx:
        return count
    right = bx > ax
    spans[count, 0], spans[count, 1] = (ax, ay) if right else (bx, by)
    spans[count, 2], spans[count, 3] = (bx, by) if right else (ax, ay)
    spans[count, 4], spans[count, 5], spans[count, 6], spans[count, 7] = cx, cy, r, side
    above[count] = 2 * edge if right else 2 * edge + 1
    return count + 1


@kernel(checks_division=True)
def _height_at(span: F64_1, x: float) -> float:
    """Return y of a span at x (mm)."""
    if x <= span[0]:
        return float(span[1])
    if x >= span[2]:
        return float(span[3])
    if span[7] == 0.0:
        return float(span[1] + (x - span[0]) / (span[2] - span[0]) * (span[3] - span[1]))
    return float(span[5] + span[7] * math.sqrt(max(span[6] ** 2 - (x - span[4]) ** 2, 0.0)))


@kernel(checks_division=True)
def _slope_at(span: F64_1, x: float) -> float:
    """Return dy/dx of a span at x."""
    if span[7] == 0.0:
        return float((span[3] - span[1]) / (span[2] - span[0]))
    rise = math.sqrt(max(span[6] ** 2 - (x - span[4]) ** 2, 0.0))
    if rise == 0.0:
        return math.inf if (x < span[4]) == (span[7] > 0.0) else -math.inf
    return float(-span[7] * (x - span[4]) / rise)


@kernel
def _lowest_points(
    start: F64_2, end: F64_2, component: I32_1, spans: F64_2, owner: I32_1, count: int
) -> Any:
    """Return the lowest point of each component, (c, 2) mm."""
    lowest = np.full((count, 2), math.inf)
    for i in range(len(component)):
        c = component[i]
        for point in (start[i], end[i]):
            if point[1] < lowest[c, 1]:
                lowest[c, 0], lowest[c, 1] = point[0], point[1]
    for i in range(len(spans)):
        c = owner[i]
        bottom = spans[i, 5] - spans[i, 6]
        if spans[i, 7] < 0.0 and spans[i, 0] < spans[i, 4] < spans[i, 2] and bottom < lowest[c, 1]:
            lowest[c, 0], lowest[c, 1] = spans[i, 4], bottom
    return lowest


def _grid_layout(spans: F64) -> tuple[F64, F64, I64]:
    """Return lower left corner, cell size, and number of columns and rows of a grid over spans."""
    bow = np.where(spans[:, 7] == 0.0, 0.0, 2.0 * spans[:, 6])
    low = np.array([spans[:, 0].min(), (np.minimum(spans[:, 1], spans[:, 3]) - bow).min()])
    high = np.array([spans[:, 2].max(), (np.maximum(spans[:, 1], spans[:, 3]) + bow).max()])
    extent = np.maximum(high - low, 1e-6)
    # The cells that a span lies in must not grow in number with the spans.
    wide = (spans[:, 2] - spans[:, 0]).mean() / extent[0]
    tall = (np.abs(spans[:, 3] - spans[:, 1]) + bow).mean() / extent[1]
    most = np.array([_CROWDED / max(wide, 1e-9), _CROWDED / max(tall, 1e-9)])
    side = math.sqrt(len(spans))
    columns = max(1.0, min(side, most[0]))
    rows = max(1.0, min(len(spans) / columns, most[1]))
    columns = max(columns, min(len(spans) / rows, most[0]))
    shape = np.array([int(columns), int(rows)])
    return low, extent / shape, shape


@kernel(checks_division=True)
def _rows_in_column(span: F64_1, column: int, low: F64_1, size: F64_1, shape: I64_1) -> Any:
    """Return the first and last row of the grid that a span passes in a column."""
    x0 = max(low[0] + column * size[0], span[0])
    x1 = min(low[0] + (column + 1) * size[0], span[2])
    a, b = _height_at(span, x0), _height_at(span, x1)
    y0, y1 = min(a, b), max(a, b)
    if span[7] != 0.0 and x0 < span[4] < x1:
        top = span[5] + span[7] * span[6]
        y0, y1 = min(y0, top), max(y1, top)
    # A margin for rounding.
    first = int((y0 - 1e-6 - low[1]) / size[1])
    last = int((y1 + 1e-6 - low[1]) / size[1])
    return min(max(first, 0), shape[1] - 1), min(max(last, 0), shape[1] - 1)


@kernel(checks_division=True)
def _column_of(x: float, low: F64_1, size: F64_1, shape: I64_1) -> int:
    """Return the column of the grid that contains x."""
    return int(min(max(int((x - low[0]) / size[0]), 0), shape[0] - 1))


@kernel
def _fill_cells(spans: F64_2, low: F64_1, size: F64_1, shape: I64_1) -> Any:
    """Return the spans in each cell, in compressed rows: offsets and span numbers."""
    first = np.zeros(shape[0] * shape[1] + 1, np.int64)
    listed = np.empty(0, np.int32)
    # The first pass counts, the second writes.
    for writes in range(2):
        for i in range(len(spans)):
            begin = _column_of(spans[i, 0] - 1e-6, low, size, shape)
            end = _column_of(spans[i, 2] + 1e-6, low, size, shape)
            for column in range(begin, end + 1):
                bottom, top = _rows_in_column(spans[i], column, low, size, shape)
                for row in range(bottom, top + 1):
                    cell = column * shape[1] + row
                    if writes:
                        first[cell] -= 1
                        listed[first[cell]] = i
                    else:
                        first[cell] += 1
        if not writes:
            for cell in range(len(first) - 1):
                first[cell + 1] += first[cell]
            listed = np.empty(first[-1], np.int32)
    return first, listed


@kernel(checks_division=True)
def _first_below(
    lowest: F64_2,
    spans: F64_2,
    owner: I32_1,
    low: F64_1,
    size: F64_1,
    shape: I64_1,
    first: I64_1,
    listed: I32_1,
) -> Any:
    """Return the first span of another component below each point, -1 for none.

    The ray is taken infinitesimally to the right of the point: spans that start at its x are hit,
    and of two that start at one point the steeper one is the upper.
    """
    hit = np.full(len(lowest), -1, np.int64)
    for c in range(len(lowest)):
        x, y = lowest[c, 0], lowest[c, 1]
        column = _column_of(x, low, size, shape)
        row = min(max(int((y - low[1]) / size[1]), 0), shape[1] - 1)
        best, steep = -math.inf, -math.inf
        while row >= 0:
            cell = column * shape[1] + row
            for k in range(first[cell], first[cell + 1]):
                i = listed[k]
                if owner[i] == c or not spans[i, 0] <= x < spans[i, 2]:
                    continue
                height = _height_at(spans[i], x)
                if height >= y or height < best:
                    continue
                slope = _slope_at(spans[i], x)
                if height > best or slope > steep:
                    best, steep = height, slope
                    hit[c] = i
            if hit[c] >= 0 and best >= low[1] + row * size[1]:
                break
            row -= 1
    return hit
