"""intersections: find the points at which edges must be split.

An edge must be split at a point at which another edge crosses it or ends on it.
"""

from __future__ import annotations

from functools import partial
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry.capacity import double_f64, double_f64_2, double_i32, double_i32_2
from knifetip.geometry.columns import F64
from knifetip.geometry.parallel import chunks, core_count, parallel_map
from knifetip.geometry.spatial_index.cells import cell_of
from knifetip.kernels import F64_1, F64_2, F64_3, I32_1, I32_2, OutI32_1, kernel
from knifetip.topology.edge_grid import EdgeGrid
from knifetip.topology.lines import Lines
from knifetip.topology.segment import BULGE, chord_length, crossing_parameters, distance_to
from knifetip.topology.vertices import VertexTable, vertex_at, with_capacity

#: Smallest number of vertices or cells for which a task on another core saves time.
MIN_CHUNK: Final = 40_000


class Splits(NamedTuple):
    """Positions at which edges are split: for each of c splits its edge, parameter and vertex."""

    row: I32_1  #: (c,) edge that is split
    parameter: F64_1  #: (c,) parameter on the edge, 0 … 1
    vertex: I32_1  #: (c,) vertex at the point


def concatenate(*several: Splits) -> Splits:
    """Return one record with the splits of all records in ``several``, in their order."""
    return Splits(*(np.concatenate(column) for column in zip(*several, strict=True)))


class Crossings(NamedTuple):
    """Points at which two straight edges cross between their ends, c in total."""

    pair: I32_2  #: (c, 2) the two edges
    parameter: F64_2  #: (c, 2) parameters of the point on both edges, 0 … 1


def find_crossings(
    ends: F64, bulge: F64, tolerance: float, grid: EdgeGrid, limit: int
) -> Crossings:
    """Return the points at which two of n straight edges cross between their ends.

    The search ends soon after it has found ``limit`` crossings; further crossings are then missing.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) and (n,)
        Start and end points and bulges of all edges; arcs are left out.
    tolerance
        A crossing that is at most this far from an end of one of the edges is left out.
    grid
        Grid that lists the edges in each cell.
    """

    def crossed(run: tuple[int, int]) -> Any:
        return _crossings_in_cells(ends, bulge, tolerance, grid, limit, *run)

    crossings = parallel_map(crossed, chunks(grid.side * grid.side, MIN_CHUNK))
    return Crossings(*(np.concatenate(column) for column in zip(*crossings, strict=True)))


def find_splits(
    lines: Lines, vertices: VertexTable, pairs: Crossings, limit: int
) -> tuple[Splits, Splits, VertexTable] | None:
    """Return the points at which edges must be split, or None if there are more than ``limit``.

    Parameters
    ----------
    lines
        The edges of the drawing.
    vertices
        Vertices at the ends of the edges.
    pairs
        Crossings of two edges each.

    Returns
    -------
    end_splits
        Splits of edges at the ends of other edges.
    crossing_splits
        Splits of the two edges of each crossing.
    vertices
        The given vertices and the vertices of the crossings.
    """
    if 2 * len(pairs.pair) > limit:
        return None
    beside = [
        partial(_split_by_ends, lines, vertices.point, *run)
        for run in chunks(vertices.vertex_count, MIN_CHUNK, 2 * core_count())
    ]
    (crossing_splits, vertices), *end_columns = parallel_map(
        lambda task: task(),
        (partial(_split_at_crossings, lines.ends, lines.tolerance, pairs, vertices), *beside),
    )
    end_splits = concatenate(*(Splits(*one) for one in end_columns))
    if len(end_splits.row) + len(crossing_splits.row) > limit:
        return None
    return end_splits, crossing_splits, vertices


def _split_at_crossings(
    ends: F64, tolerance: float, pairs: Crossings, vertices: VertexTable
) -> tuple[Splits, VertexTable]:
    """Return the splits of the two edges of each crossing, and the vertices including new ones.

    A vertex is added at each crossing that has no vertex within the tolerance.

    ``ends`` (n, 2, 2): start and end points of the edges.
    ``vertices``: the vertices before the function adds any.
    """
    pair, parameter = pairs
    vertices = with_capacity(vertices, len(pair))
    at = np.empty(len(pair), np.int32)
    count = _merge_crossings(ends, tolerance, pair, parameter, vertices, at)
    return Splits(pair.ravel(), parameter.ravel(), np.repeat(at, 2)), vertices._replace(
        vertex_count=count
    )


@kernel
def _split_by_ends(lines: Lines, point: F64_2, begin: int, end: int) -> Any:
    """Return the splits of edges at vertices ``begin`` … ``end`` - 1 that are inside an edge.

    A vertex is inside an edge if its distance is at most the tolerance and the edge does not end at
    it.

    ``point`` (q, 2): positions of the vertices.
    Returns ``row, parameter, cut`` (k,): edge, parameter on the edge (0 … 1), and vertex of each
    split.
    """
    ends, bulge, end_vertex, _, grid, tolerance, _ = lines
    low, size, side, first, listed = grid
    row = np.empty(end - begin + 16, np.int32)
    parameter = np.empty(end - begin + 16)
    cut = np.empty(end - begin + 16, np.int32)
    cuts = 0
    for at in range(begin, end):
        x, y = point[at, 0], point[at, 1]
        cell = cell_of(y, low[1], size[1], side) * side + cell_of(x, low[0], size[0], side)
        for k in range(first[cell], first[cell + 1]):
            i = listed[k]
            # For arcs this is checked first, because their distance takes long to compute.
            if abs(bulge[i]) > BULGE and (end_vertex[2 * i] == at or end_vertex[2 * i + 1] == at):
                continue
            away, part = distance_to(ends, bulge, i, x, y, tolerance)
            if away > tolerance or not 0.0 < part < 1.0:
                continue
            if end_vertex[2 * i] == at or end_vertex[2 * i + 1] == at:
                continue
            if cuts == len(row):
                row, parameter, cut = double_i32(row), double_f64(parameter), double_i32(cut)
            row[cuts], parameter[cuts], cut[cuts] = i, part, at
            cuts += 1
    return row[:cuts], parameter[:cuts], cut[:cuts]


@kernel
def _crossings_in_cells(
    ends: F64_3, bulge: F64_1, tolerance: float, grid: EdgeGrid, limit: int, begin: int, end: int
) -> Any:
    """Return the crossings of straight edges in the grid cells ``begin`` … ``end`` - 1.

    The search ends after the cell with which the number of crossings exceeds ``limit``.

    ``ends``, ``bulge`` (n, 2, 2) and (n,): start and end points and bulges of the edges; arcs are
    left out.
    ``tolerance``: a crossing that is at most this far from an end of one of the edges is left out.
    Returns ``pair, parameter`` (c, 2) and (c, 2): the two edges of each crossing, and the
    parameters of the crossing on these edges, 0 … 1.
    """
    low, size, side, first, listed = grid
    pair = np.empty((64, 2), np.int32)
    parameter = np.empty((64, 2))
    crossings = 0
    for cell in range(begin, end):
        left = low[0] + (cell % side) * size[0]
        bottom = low[1] + (cell // side) * size[1]
        for k in range(first[cell], first[cell + 1]):
            i = listed[k]
            if abs(bulge[i]) > BULGE:
                continue
            ax, ay = ends[i, 0, 0], ends[i, 0, 1]
            ux, uy, length = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay, chord_length(ends, i)
            for m in range(k + 1, first[cell + 1]):
                j = listed[m]
                if abs(bulge[j]) > BULGE:
                    continue
                s, t = crossing_parameters(ax, ay, ux, uy, ends, j)
                if not 0.0 < s < 1.0:
                    continue
                if (
                    min(s, 1.0 - s) * length <= tolerance
                    or min(t, 1.0 - t) * chord_length(ends, j) <= tolerance
                ):
                    continue
                x, y = ax + s * ux, ay + s * uy
                if not (left <= x < left + size[0] and bottom <= y < bottom + size[1]):
                    continue
                if crossings == len(pair):
                    pair, parameter = double_i32_2(pair), double_f64_2(parameter)
                pair[crossings, 0], pair[crossings, 1] = i, j
                parameter[crossings, 0], parameter[crossings, 1] = s, t
                crossings += 1
        if crossings > limit:
            break
    return pair[:crossings], parameter[:crossings]


@kernel(allocates=False)
def _merge_crossings(
    ends: F64_3,
    tolerance: float,
    pair: I32_2,
    parameter: F64_2,
    vertices: VertexTable,
    crossing_vertex: OutI32_1,
) -> int:
    """Write the vertex of each crossing to ``crossing_vertex``, and return the number of vertices.

    A crossing within ``tolerance`` of a vertex gets this vertex; otherwise a vertex is added to the
    table ``vertices``.  ``pair`` (c, 2) are the two edges of each crossing, and ``parameter`` (c,
    2) the parameters of the crossing on them.  ``ends`` (n, 2, 2) are the end points of the edges;
    ``crossing_vertex`` has the shape (c,).
    """
    count = vertices.vertex_count
    for k in range(len(pair)):
        i, s = pair[k, 0], parameter[k, 0]
        x = ends[i, 0, 0] + s * (ends[i, 1, 0] - ends[i, 0, 0])
        y = ends[i, 0, 1] + s * (ends[i, 1, 1] - ends[i, 0, 1])
        crossing_vertex[k] = vertex_at(
            x, y, tolerance, vertices.point, count, vertices.head, vertices.next_vertex
        )
        if crossing_vertex[k] == count:
            count += 1
    return count
