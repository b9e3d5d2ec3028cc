"""gap_links: connect dangling ends with the lines that they stop just short of.

A link is a straight piece of the planar graph that belongs to no edge and closes such a gap.
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
    F64_3,
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
from knifetip.topology.edge_grid import EdgeGrid
from knifetip.topology.intersections import MIN_CHUNK, Splits
from knifetip.topology.lines import Lines
from knifetip.topology.segment import (
    BULGE,
    chord_length,
    crossing_shares,
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
    """Link each dangling end to the nearest line ahead of it.

    A straight line of which both ends stop short of other lines, as creases often do, is linked
    across wider gaps.

    Parameters
    ----------
    loose : (q,)
        Whether only one line ends at each vertex.
    gap_of : (2n,)
        Largest distance from each end to the line that it is linked to.

    Returns
    -------
    splits
        Splits of the lines at which links end, unless a link ends at a vertex of the line.
    links : (t, 2)
        Pairs of vertices that a link connects.
    vertices
        The given vertices and those of the splits.
    """
    ends, bulge, node, twin, grid, touch, unit = lines
    ahead = _SHORT * unit
    partner, where = np.full(len(gap_of), -1, np.int32), np.empty(len(gap_of))

    def find(run: tuple[int, int]) -> None:
        _find_targets(ends, bulge, node, twin, loose, ahead, gap_of, grid, partner, where, *run)

    parallel_map(find, chunks(len(bulge), MIN_CHUNK))
    met = np.flatnonzero(partner >= 0).astype(np.int32)
    vertices = with_capacity(vertices, len(met))
    row, share, cut, link, count = _link(ends, bulge, touch, node, met, partner, where, vertices)
    return Splits(row, share, cut), link, vertices._replace(known=count)


@kernel(allocates=False)
def _find_targets(
    ends: F64_3,
    bulge: F64_1,
    node: I32_1,
    twin: I32_1,
    loose: Bool_1,
    ahead: float,
    gap_of: F64_1,
    grid: EdgeGrid,
    partner: OutI32_1,
    where: OutF64_1,
    begin: int,
    end: int,
) -> None:
    """Write the line ahead of each dangling end of edges ``begin`` … ``end`` - 1.

    Writes the line to ``partner``, (2n,), and the parameter of the nearest point on it to
    ``where``, (2n,).  Ends without a line ahead are not changed.
    """
    low, size, side, first, listed = grid
    for i in range(begin, end):
        if twin[i] != i or not (loose[node[2 * i]] or loose[node[2 * i + 1]]):
            continue
        # Whether there is a line straight ahead of both ends.
        both = loose[node[2 * i]] and loose[node[2 * i + 1]] and abs(bulge[i]) <= BULGE
        both = both and chord_length(ends, i) >= 4.0 * ahead
        for half in range(2 * i, 2 * i + 2):
            both = both and _meets(ends, bulge, half, ahead, grid)
        for half in range(2 * i, 2 * i + 2):
            if not loose[node[half]]:
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
                                partner[half], where[half] = j, part


@kernel
def _link(
    ends: F64_3,
    bulge: F64_1,
    touch: float,
    node: I32_1,
    met: I32_1,
    partner: I32_1,
    where: F64_1,
    vertices: VertexTable,
) -> Any:
    """Return edge, parameter and vertex of each split, the links, and the new number of vertices.

    ``met`` are the ends that have a line ahead; ``partner`` and ``where`` are that line and the
    parameter on it, as ``_find_targets`` writes them.
    """
    count = vertices.known
    row = np.empty(len(met), np.int32)
    share = np.empty(len(met))
    cut = np.empty(len(met), np.int32)
    link = np.empty((len(met), 2), np.int32)
    cuts = links = 0
    for half in met:
        j, part = partner[half], where[half]
        long = chord_length(ends, j)
        if part * long <= touch:
            at = node[2 * j]
        elif (1.0 - part) * long <= touch:
            at = node[2 * j + 1]
        else:
            px, py = point_at(ends, bulge, j, part)
            at = vertex_at(px, py, touch, vertices.point, count, vertices.head, vertices.onward)
            if at == count:
                count += 1
            row[cuts], share[cuts], cut[cuts] = j, part, at
            cuts += 1
        if at != node[half]:
            link[links, 0] = node[half]
            link[links, 1] = at
            links += 1
    return row[:cuts], share[:cuts], cut[:cuts], link[:links], count


def split_links(lines: Lines, link: I32, vertices: VertexTable) -> tuple[Splits, I32, VertexTable]:
    """Split links, (t, 2), at lines that run through the gaps that the links close.

    Returns
    -------
    splits
        Splits of these lines.
    links : (at least t, 2)
        Pairs of vertices that a link connects.
    vertices
        The given vertices and those of the splits.
    """
    ends, bulge, _, twin, grid, touch, _ = lines
    is_crossed = np.zeros(len(link), np.bool_)

    def find(run: tuple[int, int]) -> None:
        _find_crossed(ends, bulge, touch, twin, link, vertices.point, grid, is_crossed, *run)

    parallel_map(find, chunks(len(link), MIN_CHUNK))
    row, share, cut, link, point, onward, count = _cross(
        ends, bulge, touch, twin, link, np.flatnonzero(is_crossed), vertices, grid
    )
    return Splits(row, share, cut), link, VertexTable(point, count, onward, vertices.head)


@kernel(allocates=False)
def _find_crossed(
    ends: F64_3,
    bulge: F64_1,
    touch: float,
    twin: I32_1,
    link: I32_2,
    point: F64_2,
    grid: EdgeGrid,
    is_crossed: OutBool_1,
    begin: int,
    end: int,
) -> None:
    """Write whether a line crosses each of the links ``begin`` … ``end`` - 1 to ``is_crossed``."""
    for k in range(begin, end):
        is_crossed[k] = _first_through(ends, bulge, touch, twin, link, point, grid, k)[0] >= 0


@kernel(allocates=False)
def _first_through(
    ends: F64_3,
    bulge: F64_1,
    touch: float,
    twin: I32_1,
    link: I32_2,
    point: F64_2,
    grid: EdgeGrid,
    k: int,
) -> tuple[int, float, float, float]:
    """Return the line that crosses link ``k`` nearest to its start, and where.

    Returns
    -------
    line, parameter, x, y
        The line is -1 if none crosses the link; the parameter, 0 … 1, is on the line.
    """
    low, size, side, first, listed = grid
    ax, ay = point[link[k, 0], 0], point[link[k, 0], 1]
    ux, uy = point[link[k, 1], 0] - ax, point[link[k, 1], 1] - ay
    long = math.sqrt(ux * ux + uy * uy)
    c0 = cell_of(min(ax, ax + ux), low[0], size[0], side)
    c1 = cell_of(max(ax, ax + ux), low[0], size[0], side)
    r0 = cell_of(min(ay, ay + uy), low[1], size[1], side)
    r1 = cell_of(max(ay, ay + uy), low[1], size[1], side)
    least, through, where = 1.0, -1, 0.0
    for c in range(c0, c1 + 1):
        for r in range(r0, r1 + 1):
            for m in range(first[r * side + c], first[r * side + c + 1]):
                j = listed[m]
                if abs(bulge[j]) > BULGE or twin[j] != j:
                    continue
                s, t = crossing_shares(ax, ay, ux, uy, ends, j)
                if not 0.0 < s < least or min(s, 1.0 - s) * long <= touch:
                    continue
                if min(t, 1.0 - t) * chord_length(ends, j) > touch:
                    least, through, where = s, j, t
    return through, where, ax + least * ux, ay + least * uy


@kernel
def _cross(
    ends: F64_3,
    bulge: F64_1,
    touch: float,
    twin: I32_1,
    link: OutI32_2,
    wanted: I64_1,
    vertices: VertexTable,
    grid: EdgeGrid,
) -> Any:
    """Split the links ``wanted`` at all lines that cross them.

    Returns edge, parameter and vertex of the splits, the links, and the three columns of the
    vertices: positions, next vertex in the hash bucket, and number.
    """
    point, places, onward, head = vertices
    row = np.empty(16, np.int32)
    share = np.empty(16)
    cut = np.empty(16, np.int32)
    cuts = 0
    old = links = len(link)
    turn = 0
    while turn < len(wanted) + links - old:
        k = wanted[turn] if turn < len(wanted) else old + turn - len(wanted)
        through, where, x, y = _first_through(ends, bulge, touch, twin, link, point, grid, k)
        if through >= 0:
            if places + 1 >= len(point):
                point, onward = double_f64_2(point), double_i32(onward)
            at = vertex_at(x, y, touch, point, places, head, onward)
            if at == places:
                places += 1
            if cuts == len(row):
                row, share, cut = double_i32(row), double_f64(share), double_i32(cut)
            row[cuts], share[cuts], cut[cuts] = through, where, at
            cuts += 1
            if at != link[k, 0] and at != link[k, 1]:
                if links == len(link):
                    link = double_i32_2(link)
                link[links, 0], link[links, 1] = at, link[k, 1]
                link[k, 1] = at
                links += 1
        turn += 1
    return row[:cuts], share[:cuts], cut[:cuts], link[:links], point, onward, places


@kernel(allocates=False)
def _meets(ends: F64_3, bulge: F64_1, half: int, far: float, grid: EdgeGrid) -> bool:
    """Return whether another line is straight ahead of end ``half``, at most ``far`` away."""
    low, size, side, first, listed = grid
    i = half // 2
    x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
    ux, uy = outward_direction(ends, bulge, half)
    c0, c1 = cell_of(x - far, low[0], size[0], side), cell_of(x + far, low[0], size[0], side)
    r0, r1 = cell_of(y - far, low[1], size[1], side), cell_of(y + far, low[1], size[1], side)
    for c in range(c0, c1 + 1):
        for r in range(r0, r1 + 1):
            for k in range(first[r * side + c], first[r * side + c + 1]):
                j = listed[k]
                if j == i:
                    continue
                away, part = distance_to(ends, bulge, j, x, y, far)
                if away <= far:
                    px, py = point_at(ends, bulge, j, part)
                    if (px - x) * ux + (py - y) * uy >= 0.9 * away:
                        return True
    return False
