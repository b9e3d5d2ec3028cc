"""nearest: find nearest-neighbour tours of tracks, and the nearest other tracks of each track.

The starts and ends of the tracks are sorted into a grid of cells.  The cells are searched in rings
of growing size round a position.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I32
from knifetip.geometry.spatial_index.cells import cell_of, group_by_cell
from knifetip.kernels import (
    F64_1,
    F64_2,
    F64_2A,
    I32_1,
    I64_1,
    OutF64_1,
    OutF64_2,
    OutI32_1,
    OutI32_2,
    kernel,
)


def nearest_neighbour(start: F64, end: F64, origin: F64) -> I32:
    """Return the indices of t tracks in nearest-neighbour order, (t,), starting at ``origin``.

    All tracks are run forwards.

    Parameters
    ----------
    start, end : (t, 2) mm
        Positions of the head at the start and the end of each track.
    origin : (2,) mm
        Position of the head before the first track.
    """
    order: I32 = nearest_walk(start, end, origin, len(start))
    return order


def nearest_walk(start: F64, end: F64, origin: F64, count: int) -> Any:
    """Return a nearest-neighbour tour: ``count`` tracks in their order, each in its best direction.

    The result, (count,), contains every track once: as i if track i is run forwards, or as
    i + ``count`` if it is run backwards.

    Parameters
    ----------
    start, end : (count, 2) or (2 count, 2) mm
        Positions of the head at the start and the end of the tracks.  Row i is track i run
        forwards, and row i + ``count`` is track i run backwards.  If there are only ``count`` rows,
        all tracks are run forwards.
    origin : (2,) mm
        Position of the head before the first track.
    """
    if count == 0:
        return np.zeros(0, np.int32)
    low = start.min(axis=0)
    extent = np.maximum(start.max(axis=0) - low, 1e-3)
    side = max(1, math.isqrt(len(start) // 2))
    size = extent / side
    cell = np.minimum(((start - low) / size).astype(np.int32), side - 1)
    key = cell[:, 0] * np.int32(side) + cell[:, 1]
    first, listed = group_by_cell(key, side * side, np.arange(len(key), dtype=np.int32))
    starts = _StartGrid(low, size, side, first, listed, key)
    return _search_rings(start, end, origin, starts, count)


class _StartGrid(NamedTuple):
    """A grid of side × side cells with the tracks that start in each cell."""

    low: F64_1  #: (2,) mm, lower left corner of the grid
    size: F64_1  #: (2,) mm, width and height of its cells
    side: int  #: number of columns and of rows
    first: I32_1  #: (side² + 1,) index in ``listed`` of the first track of each cell
    listed: OutI32_1  #: tracks sorted by cell
    key: I32_1  #: cell of each track


@kernel(checks_division=True)
def _search_rings(start: F64_2A, end: F64_2A, origin: F64_1, grid: _StartGrid, count: int) -> Any:
    """Return a nearest-neighbour tour, (count,); the next track is searched in growing rings round
    the head.

    The tour consists of candidates: candidate i is track i run forwards, and candidate
    i + ``count`` is track i run backwards.  The candidates are listed in the cells of a grid by
    their start points.  When a candidate is chosen, all candidates of its track are removed from
    the grid.

    ``start``, ``end`` (count, 2) or (2 count, 2) mm: positions of the head at the start and the end
    of each candidate.  If there are only ``count`` rows, all tracks are run forwards.
    ``origin`` (2,) mm: position of the head before the first track.
    ``grid``: the candidates by their start points; changed in place.
    """
    low, size, side, first, listed, key = grid
    left = first[1:] - first[:-1]
    order = np.empty(count, np.int32)
    x = origin[0]
    y = origin[1]
    least = min(size[0], size[1])
    for step in range(count):
        column = cell_of(x, low[0], size[0], side)
        row = cell_of(y, low[1], size[1], side)
        best = -1
        reach = np.inf
        ring = 0
        while ring < side and (best < 0 or (ring - 1) * least <= reach):
            for i in range(max(column - ring, 0), min(column + ring, side - 1) + 1):
                edge = abs(i - column) == ring
                j = row - ring
                while j <= row + ring:
                    if 0 <= j < side:
                        cell = i * side + j
                        for entry in range(first[cell], first[cell] + left[cell]):
                            track = listed[entry]
                            distance = math.hypot(start[track, 0] - x, start[track, 1] - y)
                            if distance < reach or (distance == reach and track < best):
                                reach = distance
                                best = track
                    j += 1 if edge or ring == 0 else 2 * ring
            ring += 1
        order[step] = best
        for twin in range(best % count, len(start), count):
            cell = key[twin]
            for entry in range(first[cell], first[cell] + left[cell]):
                if listed[entry] == twin:
                    left[cell] -= 1
                    listed[entry] = listed[first[cell] + left[cell]]
                    break
        x = end[best, 0]
        y = end[best, 1]
    return order


@kernel(checks_division=True)
def find_neighbours(point: F64_2, shared: bool, opposite: bool, number: int) -> Any:
    """Return the nearest ends of other tracks of each end of t tracks, or the nearest other tracks.

    Parameters
    ----------
    point : (2t, 2) mm
        Positions of the head at the ends of the tracks.  Track i has the ends 2 i and 2 i + 1.
    shared
        Whether to return the nearest tracks of each track, instead of the nearest ends of each end.
        The distance of two tracks is then the shortest distance between their ends.
    opposite
        Whether only ends of the other kind are neighbours: odd ends of even ends, and vice versa.
    number
        Number of neighbours of each end or track.

    Returns
    -------
    near, far : (2t, number) or (t, number)
        The neighbours, nearest first, and their distances (mm).  The distance of two ends is the
        greater of their distances along X and along Y.
    """
    count = len(point)
    low_x, low_y = point[:, 0].min(), point[:, 1].min()
    side = max(1, int(math.sqrt(count // 2)))
    wide = max((point[:, 0].max() - low_x) / side, 1e-3)
    high = max((point[:, 1].max() - low_y) / side, 1e-3)
    column, row = np.empty(count, np.int64), np.empty(count, np.int64)
    cell = np.empty(count, np.int32)
    for k in range(count):
        column[k] = cell_of(point[k, 0], low_x, wide, side)
        row[k] = cell_of(point[k, 1], low_y, high, side)
        cell[k] = column[k] * side + row[k]
    first, listed = group_by_cell(cell, side * side, np.arange(count).astype(np.int32))
    rows = count // 2 if shared else count
    near = np.empty((rows, number), np.int32)
    far = np.empty((rows, number))
    grid = _EndGrid(point, column, row, first, listed, side, min(wide, high), opposite)
    _search_neighbours(grid, near, far)
    return near, far


class _EndGrid(NamedTuple):
    """The 2t ends of t tracks in a grid of cells."""

    point: F64_2  #: (2t, 2) mm
    column: I64_1  #: (2t,)
    row: I64_1  #: (2t,)
    first: I32_1  #: index in ``listed`` of the first end of each cell, and their number
    listed: I32_1  #: ends sorted by cell
    side: int  #: number of columns, equal to the number of rows
    width: float  #: smaller of the width and the height of a cell, mm
    opposite: bool  #: whether only ends of the other kind are neighbours


@kernel(allocates=False)
def _search_neighbours(grid: _EndGrid, near: OutI32_2, far: OutF64_2) -> None:
    """Write the nearest ends or tracks, and their distances (mm), to ``near`` and ``far``.

    These are arrays as returned by ``find_neighbours``: with a row for each end, or for each track.
    """
    number = near.shape[1]
    side, point = grid.side, grid.point
    shift = 0 if len(near) == len(point) else 1
    for item in range(len(near)):
        best, names = far[item], near[item]
        length = 0
        for own in range(item << shift, (item + 1) << shift):
            x, y = point[own, 0], point[own, 1]
            column, row = grid.column[own], grid.row[own]
            ring = 0
            while ring < side:
                if length == number and (ring - 1) * grid.width > best[number - 1]:
                    break
                for i in range(max(column - ring, 0), min(column + ring, side - 1) + 1):
                    edge = abs(i - column) == ring
                    j = row - ring
                    while j <= row + ring:
                        if 0 <= j < side:
                            cell = i * side + j
                            for entry in range(grid.first[cell], grid.first[cell + 1]):
                                end = grid.listed[entry]
                                distance = max(abs(point[end, 0] - x), abs(point[end, 1] - y))
                                if length == number and distance >= best[number - 1]:
                                    continue
                                if end >> 1 == own >> 1 or (grid.opposite and (end ^ own) & 1 == 0):
                                    continue
                                other = end >> shift
                                length = _insert_nearest(names, best, length, other, distance)
                        j += 1 if edge or ring == 0 else 2 * ring
                ring += 1


@kernel(allocates=False)
def _insert_nearest(
    near: OutI32_1, best: OutF64_1, length: int, neighbour: int, distance: float
) -> int:
    """Insert a neighbour into the list of the nearest ones found so far; return the list's new
    length.

    The list is sorted by distance.  If the neighbour is already in the list, the smaller of its two
    distances is kept.  If the list is full and all others in it are nearer, the neighbour is not
    inserted.

    ``near``, ``best``: ends or tracks in the list and their distances (mm); both are changed in
    place.
    ``length``: number of neighbours in the list before the call; later entries of the arrays are
    unused.
    ``neighbour``, ``distance``: end or track to be inserted, and its distance (mm).
    """
    slot = length
    for entry in range(length):
        if near[entry] == neighbour:
            if best[entry] <= distance:
                return length
            slot = entry
            break
    if slot == length:
        if length == len(near):
            if distance >= best[length - 1]:
                return length
            slot = length - 1
        else:
            length += 1
    while slot > 0 and best[slot - 1] > distance:
        best[slot], near[slot] = best[slot - 1], near[slot - 1]
        slot -= 1
    best[slot], near[slot] = distance, neighbour
    return length
