"""dash_rows: find dashes that follow one another in a row, and close the gaps between them.

Two dashes face each other across a gap if each dash points at the end of the other dash.  Three or
more dashes in a row with nearly equal gaps form a line.  Each gap is closed by a link, a straight
connection of two vertices.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from knifetip.geometry.capacity import double_i32_2
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.parallel import chunks, parallel_map
from knifetip.geometry.spatial_index.cells import cell_of, group_by_cell
from knifetip.kernels import F64_2, I32_1, Bool_1, OutBool_1, OutI32_1, kernel
from knifetip.topology.intersections import MIN_CHUNK
from knifetip.topology.lines import Lines
from knifetip.topology.segment import BULGE, chord_length, outward_direction


def link_dashes(lines: Lines, reach: float, loose: Bool) -> tuple[Bool, I32, F64]:
    """Find dashes, close the gaps between them by links, and find the search distance of each end.

    A dash is a short straight edge in a row of at least three with nearly equal gaps.  A link is a
    straight connection of two vertices that closes the gap between two dashes.  The search distance
    of an end is the distance within which another edge is looked for later, to close a gap at
    this end.

    Parameters
    ----------
    lines
        The n edges of the drawing.
    reach
        Least search distance (drawing units); the two outer ends of a row of dashes get a longer
        one if the gaps between the dashes are wide.
    loose : (q,)
        Whether only one edge ends at each of q vertices.  This function sets the entries of
        vertices that get a link to False.

    Returns
    -------
    dashed : (n,)
        Whether each edge is a dash of a row.
    links : (t, 2)
        Start vertex and end vertex of each of t links.
    gap_of : (2n,)
        Search distance of the start and of the end of each edge (drawing units).
    """
    count, side = len(lines.bulge), lines.grid.side
    facing = np.full(2 * count, -1, np.int32)
    cell = np.full(2 * count, -1, np.int32)
    parallel_map(
        lambda run: _find_dangling_ends(lines, loose, cell, *run), chunks(count, MIN_CHUNK)
    )
    # Few lines have dangling ends, and each end is in one cell only.
    begins, tips = group_by_cell(cell, side * side, np.arange(len(cell), dtype=np.int32))
    position = lines.ends.reshape(-1, 2).take(tips, axis=0)

    def face(run: tuple[int, int]) -> None:
        _find_facing_ends(lines, begins, tips, position, facing, *run)

    parallel_map(face, chunks(len(tips), MIN_CHUNK))
    dashed, link, gap_of = _form_rows(lines, facing, reach, loose)
    return dashed, link, gap_of


@kernel
def _form_rows(lines: Lines, facing: I32_1, reach: float, loose: OutBool_1) -> Any:
    """Find rows of at least three dashes with nearly equal gaps, and link neighbouring dashes.

    ``facing`` (2n,): number of the end that each end of an edge faces across a gap, -1 if it faces
    none.
    ``reach``: least search distance for ends of edges.
    ``loose`` (q,): whether only one edge ends at each vertex; set to False for vertices that get a
    link.
    Returns ``dashed`` (n,): whether each edge is a dash of a row; ``links`` (t, 2): pairs of
    vertices; a link closes the gap between the two vertices of a pair; ``gap_of`` (2n,): search
    distance of each end: within it, another edge is looked for later.
    """
    ends, _, end_vertex, twin, _, tolerance, _ = lines
    n = len(twin)
    link = np.empty((64, 2), np.int32)
    links = 0
    gap_of = np.full(2 * n, reach)
    dashed = np.zeros(n, np.bool_)
    visited = np.zeros(n, np.bool_)
    chain = np.empty(n, np.int64)
    for half in range(2 * n):
        # A row starts with an edge that no other dash precedes.
        back = half ^ 1
        if visited[half // 2] or facing[half] < 0 or facing[facing[half]] != half:
            continue
        if facing[back] >= 0 and facing[facing[back]] == back:
            continue
        count = 0
        least, widest, shortest, longest = np.inf, 0.0, np.inf, 0.0
        tail = half
        while True:
            chain[count] = tail
            count += 1
            i = tail // 2
            visited[i] = True
            length = chord_length(ends, i)
            longest = max(longest, length)
            other = facing[tail]
            if other < 0 or facing[other] != tail or visited[other // 2]:
                break
            if count > 1:
                shortest = min(shortest, length)
            gap = math.hypot(
                ends[i, tail % 2, 0] - ends[other // 2, other % 2, 0],
                ends[i, tail % 2, 1] - ends[other // 2, other % 2, 1],
            )
            least, widest = min(least, gap), max(widest, gap)
            tail = other ^ 1
        if count < 3 or widest > 1.5 * least + 2.0 * tolerance or longest > 2.5 * shortest:
            continue
        for k in range(count):
            dashed[chain[k] // 2] = True
            if k:
                if links == len(link):
                    link = double_i32_2(link)
                link[links, 0] = end_vertex[chain[k - 1]]
                link[links, 1] = end_vertex[chain[k] ^ 1]
                links += 1
                loose[end_vertex[chain[k - 1]]] = False
                loose[end_vertex[chain[k] ^ 1]] = False
        gap_of[chain[0] ^ 1] = max(reach, 1.25 * widest)
        gap_of[chain[count - 1]] = max(reach, 1.25 * widest)
    for i in range(n):
        dashed[i] = dashed[twin[i]]
    return dashed, link[:links], gap_of


@kernel(allocates=False)
def _find_dangling_ends(lines: Lines, loose: Bool_1, cell: OutI32_1, begin: int, end: int) -> None:
    """Write to ``cell`` the grid cell of each dangling end of a straight edge.

    Only the entries of dangling ends of edges ``begin`` … ``end`` - 1 are written.

    ``loose`` (q,): whether only one edge ends at each vertex.
    ``cell`` (2n,): number of the cell of the start and of the end of each edge.
    """
    ends, bulge, end_vertex, twin, grid, _, _ = lines
    low, size, side, _, _ = grid
    for i in range(begin, end):
        if abs(bulge[i]) > BULGE or twin[i] != i:
            continue
        for half in range(2 * i, 2 * i + 2):
            if loose[end_vertex[half]]:
                x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
                row = cell_of(y, low[1], size[1], side)
                cell[half] = row * side + cell_of(x, low[0], size[0], side)


@kernel(allocates=False)
def _find_facing_ends(
    lines: Lines,
    begins: I32_1,
    tips: I32_1,
    position: F64_2,
    facing: OutI32_1,
    begin: int,
    end: int,
) -> None:
    """Find the dangling end that each dangling end ``begin`` … ``end`` - 1 faces across a gap.

    ``begins`` (side² + 1,): index in ``tips`` of the first dangling end in each cell of the grid.
    ``tips``, ``position`` (t,) and (t, 2): numbers of the dangling ends in the order of their
    cells, and their positions.
    ``facing`` (2n,): receives for each end the nearest dangling end that is straight ahead of it
    and points back at it; unchanged if there is none.
    ``begin``, ``end``: range of indices in ``tips``.
    """
    ends, bulge, _, _, grid, tolerance, unit = lines
    low, size, side, _, _ = grid
    for number in range(begin, end):
        half = tips[number]
        i = half // 2
        length = chord_length(ends, i)
        if length > 40.0 * unit or length <= tolerance:
            continue
        reach = min(15.0 * unit, max(2.0 * length, 3.0 * unit))
        ux, uy = outward_direction(ends, bulge, half)
        x, y = position[number, 0], position[number, 1]
        c0 = cell_of(min(x, x + reach * ux) - 2.0 * tolerance, low[0], size[0], side)
        c1 = cell_of(max(x, x + reach * ux) + 2.0 * tolerance, low[0], size[0], side)
        r0 = cell_of(min(y, y + reach * uy) - 2.0 * tolerance, low[1], size[1], side)
        r1 = cell_of(max(y, y + reach * uy) + 2.0 * tolerance, low[1], size[1], side)
        best = reach
        for r in range(r0, r1 + 1):
            # The dangling ends of neighbouring cells in a row of the grid follow one another.
            for k in range(begins[r * side + c0], begins[r * side + c1 + 1]):
                ox, oy = position[k, 0] - x, position[k, 1] - y
                ahead = ox * ux + oy * uy
                if ahead <= tolerance or ahead >= best or abs(ox * uy - oy * ux) > 2.0 * tolerance:
                    continue
                vx, vy = outward_direction(ends, bulge, tips[k])
                if tips[k] // 2 != i and ux * vx + uy * vy < -0.999:
                    best = ahead
                    facing[half] = tips[k]
