"""gap_links: connect the dangling ends of edges with the edges that they almost touch.

A link is a straight piece of the planar graph that closes such a gap and belongs to no edge.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry.capacity import double_f64, double_f64_2, double_i32, double_i32_2
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.parallel import chunks, parallel_map
from knifetip.geometry.spatial_index.cells import cell_of
from knifetip.kernels import (
    F64_1,
    F64_2,
    I32_1,
    I32_2,
    I64_1,
    Bool_1,
    OutBool_1,
    OutF64_1,
    OutI32_1,
    OutI32_2,
    kernel,
)
from knifetip.topology.intersections import MIN_CHUNK, Splits
from knifetip.topology.lines import Lines
from knifetip.topology.segment import (
    BULGE,
    chord_length,
    crossing_parameters,
    distance_to,
    outward_direction,
    point_at,
)
from knifetip.topology.vertices import VertexTable, vertex_at, with_capacity

#: Largest gap that is closed at both ends of a straight line, such as a crease (mm).
_SHORT: Final = 2.5


def link_loose_ends(
    lines: Lines, loose: Bool, gap_of: F64, vertices: VertexTable
) -> tuple[Splits, I32, VertexTable]:
    """Link each dangling end of an edge to the nearest edge ahead of it.

    A link is a straight connection of two vertices that closes a gap.  If a straight edge dangles
    at both ends, and other edges are straight ahead of both, larger gaps are closed, because
    creases often end a little before the outline.

    Parameters
    ----------
    lines
        The n edges of the drawing.
    loose : (q,)
        Whether only one edge ends at each of q vertices.
    gap_of : (2n,)
        Search distance of the start and of the end of each edge: another edge must be nearer to a
        dangling end than this to be linked to it.
    vertices
        The q vertices.

    Returns
    -------
    splits
        Points inside edges at which links end; the edges must be split there.
    links : (t, 2)
        Start vertex and end vertex of each link.
    vertices
        The given vertices and the vertices of the splits.
    """
    partner, position = np.full(len(gap_of), -1, np.int32), np.empty(len(gap_of))

    def find(run: tuple[int, int]) -> None:
        _find_targets(lines, loose, gap_of, partner, position, *run)

    parallel_map(find, chunks(len(lines.bulge), MIN_CHUNK))
    ends_ahead = np.flatnonzero(partner >= 0).astype(np.int32)
    vertices = with_capacity(vertices, len(ends_ahead))
    row, parameter, cut, link, count = _make_links(lines, ends_ahead, partner, position, vertices)
    return Splits(row, parameter, cut), link, vertices._replace(vertex_count=count)


@kernel(allocates=False)
def _find_targets(
    lines: Lines,
    loose: Bool_1,
    gap_of: F64_1,
    partner: OutI32_1,
    position: OutF64_1,
    begin: int,
    end: int,
) -> None:
    """Find the nearest edge ahead of each dangling end of edges ``begin`` … ``end`` - 1.

    An edge is found only within the search distance of the end, its entry in ``gap_of``.  The
    search distance is raised to ``_SHORT`` for both ends of an edge that is long and straight,
    dangles at both ends, and has another edge straight ahead of each end within ``_SHORT``.

    ``loose`` (q,): whether only one edge ends at each vertex.
    ``gap_of`` (2n,): search distance of each end (drawing units).
    ``partner``, ``position`` (2n,): receive for each end the edge that is found, and the parameter
    of the nearest point on it (0 … 1).  The entries of ends without an edge ahead are not changed.
    """
    ends, bulge, end_vertex, twin, grid, _, unit = lines
    low, size, side, first, listed = grid
    ahead = _SHORT * unit
    for i in range(begin, end):
        if twin[i] != i or not (loose[end_vertex[2 * i]] or loose[end_vertex[2 * i + 1]]):
            continue
        # Whether there are edges straight ahead of both ends.
        both = loose[end_vertex[2 * i]] and loose[end_vertex[2 * i + 1]] and abs(bulge[i]) <= BULGE
        both = both and chord_length(ends, i) >= 4.0 * ahead
        for half in range(2 * i, 2 * i + 2):
            both = both and _has_line_ahead(lines, half, ahead)
        for half in range(2 * i, 2 * i + 2):
            if not loose[end_vertex[half]]:
                continue
            x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
            best = max(gap_of[half], ahead) if both else gap_of[half]
            c0 = cell_of(x - best, low[0], size[0], side)
            c1 = cell_of(x + best, low[0], size[0], side)
            r0 = cell_of(y - best, low[1], size[1], side)
            r1 = cell_of(y + best, low[1], size[1], side)
            for c in range(c0, c1 + 1):
                for r in range(r0, r1 + 1):
                    for k in range(first[r * side + c], first[r * side + c + 1]):
                        j = listed[k]
                        if j == i:
                            continue
                        away, part = distance_to(ends, bulge, j, x, y, best)
                        if away < best and twin[j] != i:
                            px, py = point_at(ends, bulge, j, part)
                            ux, uy = outward_direction(ends, bulge, half)
                            if (px - x) * ux + (py - y) * uy >= 0.5 * away:
                                best = away
                                partner[half], position[half] = j, part


@kernel
def _make_links(
    lines: Lines, ends_ahead: I32_1, partner: I32_1, position: F64_1, vertices: VertexTable
) -> Any:
    """Return edge, parameter and vertex of each split, the links, and the new number of vertices.

    A link connects a dangling end of an edge with the nearest point of the edge ahead of it.  The
    edge ahead is split at this point, unless the point is one of its ends within the tolerance.

    ``partner``, ``position`` (2n,): the edge ahead of each end, and the parameter of its nearest
    point (0 … 1).
    ``vertices``: table of the vertices, to which the vertices of the splits are added.
    """
    ends, bulge, end_vertex, _, _, tolerance, _ = lines
    count = vertices.vertex_count
    row = np.empty(len(ends_ahead), np.int32)
    parameter = np.empty(len(ends_ahead))
    cut = np.empty(len(ends_ahead), np.int32)
    link = np.empty((len(ends_ahead), 2), np.int32)
    cuts = links = 0
    for half in ends_ahead:
        j, part = partner[half], position[half]
        length = chord_length(ends, j)
        if part * length <= tolerance:
            at = end_vertex[2 * j]
        elif (1.0 - part) * length <= tolerance:
            at = end_vertex[2 * j + 1]
        else:
            px, py = point_at(ends, bulge, j, part)
            at = vertex_at(
                px, py, tolerance, vertices.point, count, vertices.head, vertices.next_vertex
            )
            if at == count:
                count += 1
            row[cuts], parameter[cuts], cut[cuts] = j, part, at
            cuts += 1
        if at != end_vertex[half]:
            link[links, 0] = end_vertex[half]
            link[links, 1] = at
            links += 1
    return row[:cuts], parameter[:cuts], cut[:cuts], link[:links], count


def split_links(lines: Lines, link: I32, vertices: VertexTable) -> tuple[Splits, I32, VertexTable]:
    """Split links at the edges that run through the gaps that the links close.

    A link is a straight connection of two vertices.  The edges are split at the same points.

    Parameters
    ----------
    lines
        The edges of the drawing.
    link : (t, 2)
        Start vertex and end vertex of each link.
    vertices
        The vertices of edges and links.

    Returns
    -------
    splits
        Splits of the edges that cross links.
    links : (at least t, 2)
        Start vertex and end vertex of each link after the splits.
    vertices
        The given vertices and the vertices of the splits.
    """
    is_crossed = np.zeros(len(link), np.bool_)

    def find(run: tuple[int, int]) -> None:
        _find_crossed(lines, link, vertices.point, is_crossed, *run)

    parallel_map(find, chunks(len(link), MIN_CHUNK))
    row, parameter, cut, link, point, next_vertex, count = _split_at_lines(
        lines, link, np.flatnonzero(is_crossed), vertices
    )
    return Splits(row, parameter, cut), link, VertexTable(point, count, next_vertex, vertices.head)


@kernel(allocates=False)
def _find_crossed(
    lines: Lines, link: I32_2, point: F64_2, is_crossed: OutBool_1, begin: int, end: int
) -> None:
    """Write to ``is_crossed`` whether a straight edge crosses links ``begin`` … ``end`` - 1.

    ``is_crossed`` (t,) receives the result for each of t links; ``link`` and ``point`` are those of
    ``_first_line_through``.
    """
    for k in range(begin, end):
        is_crossed[k] = _first_line_through(lines, link, point, k)[0] >= 0


@kernel(allocates=False)
def _first_line_through(
    lines: Lines, link: I32_2, point: F64_2, k: int
) -> tuple[int, float, float, float]:
    """Return the straight edge that crosses link ``k`` nearest to its start, and the crossing.

    A crossing within the tolerance of an end of the link or of the edge does not count.

    ``link`` (t, 2): start vertex and end vertex of each link.
    ``point`` (q, 2): positions of the vertices.
    Returns edge: index of the edge, -1 if no edge crosses the link; the other results are then
    meaningless; parameter, x, y: parameter of the crossing on the edge, 0 … 1, and its coordinates.
    """
    ends, bulge, _, twin, grid, tolerance, _ = lines
    low, size, side, first, listed = grid
    ax, ay = point[link[k, 0], 0], point[link[k, 0], 1]
    ux, uy = point[link[k, 1], 0] - ax, point[link[k, 1], 1] - ay
    length = math.sqrt(ux * ux + uy * uy)
    c0 = cell_of(min(ax, ax + ux), low[0], size[0], side)
    c1 = cell_of(max(ax, ax + ux), low[0], size[0], side)
    r0 = cell_of(min(ay, ay + uy), low[1], size[1], side)
    r1 = cell_of(max(ay, ay + uy), low[1], size[1], side)
    least, through, position = 1.0, -1, 0.0
    for c in range(c0, c1 + 1):
        for r in range(r0, r1 + 1):
            for m in range(first[r * side + c], first[r * side + c + 1]):
                j = listed[m]
                if abs(bulge[j]) > BULGE or twin[j] != j:
                    continue
                s, t = crossing_parameters(ax, ay, ux, uy, ends, j)
                if not 0.0 < s < least or min(s, 1.0 - s) * length <= tolerance:
                    continue
                if min(t, 1.0 - t) * chord_length(ends, j) > tolerance:
                    least, through, position = s, j, t
    return through, position, ax + least * ux, ay + least * uy


@kernel
def _split_at_lines(lines: Lines, link: OutI32_2, crossed: I64_1, vertices: VertexTable) -> Any:
    """Split links at all edges that cross them, and split the edges at the same points.

    ``link`` (t, 2): start vertex and end vertex of each link.  The end vertices of split links are
    overwritten.
    ``vertices``: table of the vertices, to which the vertices of the splits are added.
    Returns ``edge, parameter, vertex`` (k,) each: the edge, the parameter on it and the vertex of
    each split of an edge; ``links`` (at least t, 2): start vertex and end vertex of each link after
    the splits; point, next_vertex, vertex_count: new values of these columns of ``vertices``.
    """
    point, vertex_count, next_vertex, head = vertices
    row = np.empty(16, np.int32)
    parameter = np.empty(16)
    cut = np.empty(16, np.int32)
    cuts = 0
    old = links = len(link)
    turn = 0
    while turn < len(crossed) + links - old:
        k = crossed[turn] if turn < len(crossed) else old + turn - len(crossed)
        through, position, x, y = _first_line_through(lines, link, point, k)
        if through >= 0:
            if vertex_count + 1 >= len(point):
                point, next_vertex = double_f64_2(point), double_i32(next_vertex)
            at = vertex_at(x, y, lines.tolerance, point, vertex_count, head, next_vertex)
            if at == vertex_count:
                vertex_count += 1
            if cuts == len(row):
                row, parameter, cut = double_i32(row), double_f64(parameter), double_i32(cut)
            row[cuts], parameter[cuts], cut[cuts] = through, position, at
            cuts += 1
            if at != link[k, 0] and at != link[k, 1]:
                if links == len(link):
                    link = double_i32_2(link)
                link[links, 0], link[links, 1] = at, link[k, 1]
                link[k, 1] = at
                links += 1
        turn += 1
    return row[:cuts], parameter[:cuts], cut[:cuts], link[:links], point, next_vertex, vertex_count


@kernel(allocates=False)
def _has_line_ahead(lines: Lines, half: int, reach: float) -> bool:
    """Return whether another edge is straight ahead of an end of an edge, at most ``reach`` away.

    ``half`` is 2 i for the start of edge i and 2 i + 1 for its end.
    """
    ends, bulge, _, _, grid, _, _ = lines
    low, size, side, first, listed = grid
    i = half // 2
    x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
    ux, uy = outward_direction(ends, bulge, half)
    c0, c1 = cell_of(x - reach, low[0], size[0], side), cell_of(x + reach, low[0], size[0], side)
    r0, r1 = cell_of(y - reach, low[1], size[1], side), cell_of(y + reach, low[1], size[1], side)
    for c in range(c0, c1 + 1):
        for r in range(r0, r1 + 1):
            for k in range(first[r * side + c], first[r * side + c + 1]):
                j = listed[k]
                if j == i:
                    continue
                away, part = distance_to(ends, bulge, j, x, y, reach)
                if away <= reach:
                    px, py = point_at(ends, bulge, j, part)
                    if (px - x) * ux + (py - y) * uy >= 0.9 * away:
                        return True
    return False
