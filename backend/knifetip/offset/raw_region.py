"""raw_region: move the segments of all paths of a region sideways by the radius of the tool.

Afterwards ``region`` splits the moved segments and selects the pieces that belong to the offset.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry.spatial_index.box_tree import NODE_SIZE
from knifetip.geometry.spatial_index.morton import morton_code
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_2, I32_1, OutF64_2, kernel
from knifetip.offset.raw_segments import (
    COLUMNS,
    MOVED,
    NO_FAILURE,
    U1X,
    U1Y,
    U2X,
    U2Y,
    is_closed,
    move_segments,
)
from knifetip.offset.records import (
    Contours,
    CornerTypes,
    MovedPath,
    MovedSegments,
    OffsetSegments,
    RawRows,
    RegionCorners,
    RegionPaths,
    empty_segments,
)
from knifetip.offset.transition import MAX_SEGMENTS, ContourVertex, write_transition
from knifetip.offset.trim import trim_path
from knifetip.offset.untrimmed import raw_offset

#: Number of columns and of rows of the grid that orders the paths of a large group.
GRID_CELLS: Final = 1 << 15


@kernel
def _sort_spatially(start: F64_2, first: I32_1, member: I32_1) -> Any:
    """Return the numbers of the c paths of a region, (c,), sorted so that near paths are adjacent.

    The order is that of a Z-order curve; a tree of bounding boxes in this order is searched fast.

    ``start`` (n, 2) mm: start points of the segments of all paths.
    ``first``: first segment of each path.
    ``member`` (c,): numbers of the paths of the region.
    """
    count = len(member)
    if count <= NODE_SIZE:
        return member.copy()
    low_x = low_y = math.inf
    high_x = high_y = -math.inf
    for path in member:
        if first[path] < first[path + 1]:
            x, y = start[first[path], 0], start[first[path], 1]
            low_x, low_y = min(low_x, x), min(low_y, y)
            high_x, high_y = max(high_x, x), max(high_y, y)
    side = max(high_x - low_x, high_y - low_y)
    code = np.zeros(count, np.int64)
    if not (side > 0.0 and math.isfinite(side)):
        return member.copy()
    for m in range(count):
        path = member[m]
        if first[path] == first[path + 1]:
            continue
        x_cell = int((start[first[path], 0] - low_x) / side * (GRID_CELLS - 1))
        y_cell = int((start[first[path], 1] - low_y) / side * (GRID_CELLS - 1))
        code[m] = morton_code(x_cell, y_cell)
    return member[np.argsort(code, kind="mergesort")]


@kernel
def region_paths(contours: Contours, members: I32_1) -> RegionPaths:
    """Return the paths of a region, in an order in which near paths are adjacent.

    ``members`` are the numbers of the paths of the region.
    """
    member = _sort_spatially(contours.start, contours.first, members)
    count = len(member)
    begin = np.zeros(count + 1, np.int64)
    closed = np.zeros(count, np.bool_)
    for m in range(count):
        a, b = contours.first[member[m]], contours.first[member[m] + 1]
        begin[m + 1] = begin[m] + b - a
        closed[m] = a < b and is_closed(contours, a, b)
    return RegionPaths(member, begin, closed)


@kernel
def region_corners(contours: Contours, paths: RegionPaths, corners: CornerTypes) -> RegionCorners:
    """Return the corners and the contour segments of a region.

    The arrays for moved segments are allocated but not filled.

    Parameters
    ----------
    contours, paths, corners
        Input contours, the paths of the region, and the types of transitions at its corners.
    """
    total = paths.begin[len(paths.member)]
    origin = np.empty((total, 5))
    source = np.empty(total, np.int64)
    segments = MovedSegments(np.empty((total, COLUMNS)), np.empty(total, np.int64))
    previous = np.empty(total, np.int64)
    kind = np.empty(total, np.int64)
    corner_k = np.empty(total)
    capped = False
    for m in range(len(paths.member)):
        a, b = contours.first[paths.member[m]], contours.first[paths.member[m] + 1]
        first_row = paths.begin[m]
        for i in range(a, b):
            row = first_row + i - a
            origin[row, 0] = contours.start[i, 0]
            origin[row, 1] = contours.start[i, 1]
            origin[row, 2] = contours.end[i, 0]
            origin[row, 3] = contours.end[i, 1]
            origin[row, 4] = contours.bulge[i] if abs(contours.bulge[i]) >= BULGE else 0.0
            source[row] = i
            previous[row] = row - 1 if i > a else first_row + b - a - 1
            kind[row] = corners.kind[corners.step * i]
            corner_k[row] = corners.k[corners.step * i]
            capped |= corners.kind[corners.step * i] > 0
    return RegionCorners(origin, source, segments, previous, kind, corner_k, capped)


@kernel
def _write_trimmed(
    trimmed: OffsetSegments, count: int, closed: bool, raw: RawRows, next_row: int, m: int
) -> int:
    """Append the segments of a trimmed path to ``raw``, and return the next free row of ``raw``.

    ``trimmed``, ``count``: columns of the trimmed path, and the number of its segments.
    ``closed``: whether the path is closed.
    ``next_row``: first row of ``raw`` to write.
    ``m``: number of the path in the region.
    """
    for r in range(count):
        raw.rows[next_row, 0] = trimmed.start[r, 0]
        raw.rows[next_row, 1] = trimmed.start[r, 1]
        raw.rows[next_row, 2] = trimmed.end[r, 0]
        raw.rows[next_row, 3] = trimmed.end[r, 1]
        raw.rows[next_row, 4] = trimmed.bulge[r]
        raw.info[next_row, 0] = trimmed.source[r]
        raw.info[next_row, 1] = trimmed.inserted[r]
        raw.info[next_row, 2] = closed or r < count - 1
        raw.info[next_row, 3] = m
        next_row += 1
    return next_row


@kernel
def write_raw_region(
    contours: Contours,
    paths: RegionPaths,
    signed: float,
    corners: CornerTypes,
    segments: MovedSegments,
    raw: RawRows,
    rows: OutF64_2,
) -> tuple[int, int, int, int]:
    """Write the moved segments of all paths of a region, as if each path were the only one.

    Parameters
    ----------
    contours, paths, corners
        Input contours, the paths of the region, and the types of its corners.
    signed : mm
        Radius of the tool, positive left of travel.
    segments
        The moved segments of the region, which this function computes.
    raw
        Gets the moved segments after trimming, the transitions between them, and the row that
        continues each row.
    rows
        Scratch rows for one transition.

    Returns
    -------
    next_row
        Number of rows of ``raw`` that are written.
    lost
        A contour segment that has no offset at all, because its arc is too small for the tool; -1
        if there is none.
    code, segment
        ``NO_FAILURE`` or another failure code of ``raw_segments``, and the contour segment that
        failed.
    """
    longest = 0
    for m in range(len(paths.member)):
        longest = max(longest, paths.begin[m + 1] - paths.begin[m])
    capacity = (MAX_SEGMENTS + 1) * longest
    trimmed = empty_segments(capacity)
    table = segments.table
    next_row = 0
    lost = -1
    for m in range(len(paths.member)):
        a, b = contours.first[paths.member[m]], contours.first[paths.member[m] + 1]
        first_row = paths.begin[m]
        if a == b:
            continue
        code, row = move_segments(contours, a, b, signed, table, first_row)
        if code != NO_FAILURE:
            return next_row, lost, code, row
        closed = paths.closed[m]
        begun = next_row
        path = MovedPath(a, b, closed, signed, segments, first_row)
        count, code, row, _ = trim_path(contours, path, corners, trimmed, 0, rows)
        if code == NO_FAILURE:
            next_row = _write_trimmed(trimmed, count, closed, raw, next_row, m)
        else:
            move_segments(contours, a, b, signed, table, first_row)
            next_row = raw_offset(contours, path, corners, raw, next_row, m)
            for moved_row in range(first_row, first_row + b - a):
                if math.isnan(table[moved_row, MOVED]):
                    lost = a + moved_row - first_row
        for e in range(begun, next_row):
            raw.follow[e] = e + 1 if raw.info[e, 2] else -1
        if next_row > begun and raw.info[next_row - 1, 2]:
            raw.follow[next_row - 1] = begun
    return next_row, lost, NO_FAILURE, 0


@kernel
def write_far_side(
    contours: Contours, low: int, high: int, signed: float, raw: RawRows, next_row: int
) -> int:
    """Append the offset on the other side of an open path, and arcs around its ends, to ``raw``.

    The appended rows only split other rows of ``raw``; they are not part of the offset of the
    region. Returns the next free row of ``raw``.

    Parameters
    ----------
    low, high
        The path has the contour segments low … high - 1.
    signed : mm
        Radius of the tool, positive left of travel.
    next_row
        First row of ``raw`` to write.
    """
    count = high - low
    back = Contours(
        contours.end[low:high][::-1].copy(),
        contours.start[low:high][::-1].copy(),
        (-contours.bulge[low:high][::-1]).copy(),
        np.zeros(1, np.int32),
    )
    segments = MovedSegments(np.empty((count, COLUMNS)), np.empty(count, np.int64))
    table = segments.table
    corners = CornerTypes(np.zeros(1, np.uint8), np.zeros(1), 0)
    move_segments(back, 0, count, signed, table, 0)
    path = MovedPath(0, count, False, signed, segments, 0)
    next_row = raw_offset(back, path, corners, raw, next_row, -1)
    for e in range(2):
        if e == 0:
            x, y, ux, uy = back.start[0, 0], back.start[0, 1], -table[0, U1X], -table[0, U1Y]
        else:
            last = count - 1
            x, y = back.end[last, 0], back.end[last, 1]
            ux, uy = table[last, U2X], table[last, U2Y]
        vertex = ContourVertex(x, y, ux, uy, -ux, -uy)
        next_row = write_transition(0, 0.0, vertex, signed, raw.rows, next_row)
    return next_row
