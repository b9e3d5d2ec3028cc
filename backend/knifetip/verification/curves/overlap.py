"""Find the stretches of curves that lie within a given distance of edges.

Curves and edges are lines and arcs as rows of six numbers (see ``curves.curve``).  A grid over the
edges finds the pairs of a curve and an edge that may be near each other; ``curves.curve_pairs``
compares the two.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from knifetip.kernels import F64_1, F64_2, OutF64_2, OutI32_1, OutI32_2, kernel
from knifetip.verification.columns import F64
from knifetip.verification.curves.curve_grid import (
    CurveGrid,
    cells_near_curve,
    cells_near_point,
    curve_box,
    list_curves,
)
from knifetip.verification.curves.curve_pairs import overlap_lines, overlap_pair, overlap_point
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
    return search_overlaps(curves, list_curves(edges, limit), low, high, limit)


def search_overlaps(curves: F64, grid: CurveGrid, low: F64, high: F64, limit: float) -> Overlaps:
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
        box = curve_box(edges, edge, low[edge], high[edge])
        boxes[edge, 0], boxes[edge, 1] = box[0] - margin, box[1] - margin
        boxes[edge, 2], boxes[edge, 3] = box[2] + margin, box[3] + margin
    return boxes


class _Found(NamedTuple):
    """Overlaps that have been found so far, and scratch arrays for the search."""

    pairs: OutI32_2  #: (c, 2) curve and edge
    spans: OutF64_2  #: (c, 5) see ``overlap_pair``
    cells: OutI32_1
    met: OutI32_1  #: (m,) curve that was compared with each edge last
    hits: OutF64_2  #: (16, 5)
    near: OutF64_2  #: (8, 2)


@kernel
def _search_grid(curves: F64_2, grid: CurveGrid, low: F64_1, high: F64_1, limit: float) -> Any:
    """Return the pairs of a curve and an edge that overlap, and their spans; see ``_Found``."""
    parts = _ComparedParts(low, high, _enclose_parts(grid.curves, low, high, limit))
    pairs = np.empty((max(256, 2 * len(curves)), 2), np.int32)
    spans = np.empty((len(pairs), 5))
    cells = np.empty(64, np.int32)
    met = np.full(len(grid.curves), -1, np.int32)
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
    grid: CurveGrid,
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
            many = cells_near_point(
                curves[curve, 1], curves[curve, 2], limit, grid.layout, found.cells
            )
        else:
            many = cells_near_curve(curves, curve, limit, grid.layout, found.cells)
        if many > len(found.cells):
            return curve, used, many
        box = curve_box(curves, curve, 0.0, curves[curve, 5])
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
                if is_point and grid.curves[edge, 0] == 0.0:
                    hit_count = overlap_point(
                        box[0], box[1], grid.curves, edge, parts.low[edge], parts.high[edge],
                        limit, found.hits,
                    )  # fmt: skip
                elif is_line and grid.curves[edge, 0] == 0.0:
                    hit_count = overlap_lines(
                        curves, curve, grid.curves, edge, parts.low[edge], parts.high[edge],
                        limit, found.hits,
                    )  # fmt: skip
                else:
                    hit_count = overlap_pair(
                        curves[curve],
                        grid.curves[edge],
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
