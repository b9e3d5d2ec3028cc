"""untrimmed: the moved segments of a path, mostly untrimmed, for paths that ``trim`` cannot offset.

``region`` splits these segments at their intersections.  Here, two neighbouring moved segments are
trimmed to their intersection only if each of them keeps about half its length.
"""

from __future__ import annotations

import math

from knifetip.kernels import F64_2, kernel
from knifetip.offset.corners import (
    classify_corner,
    concave_crossing,
    join_segments,
    line_crossing,
    smooth_joint,
    write_corner_transition,
)
from knifetip.offset.raw_segments import (
    CHORD,
    CONCAVE,
    CONVEX,
    EX,
    EY,
    MOVED,
    OPEN,
    RADIUS,
    SHIFTED,
    SMOOTH,
    SX,
    SY,
    remaining_bulge,
)
from knifetip.offset.records import Contours, CornerTypes, MovedPath, RawRows


@kernel
def _trim_point(
    contours: Contours,
    last: int,
    next_: int,
    table: F64_2,
    before: int,
    here: int,
    signed: float,
) -> tuple[float, float]:
    """Return the point (x, y) to which the moved segments at a concave corner are trimmed (mm).

    The point is NaN if the two moved segments do not cross once, or if one of them would lose more
    than about half its length.

    Parameters
    ----------
    last, next_
        Contour segments before and after the corner.
    table, before, here
        Moved segments, and the rows in which ``last`` and ``next_`` are.
    signed : mm
        Radius of the tool, positive left of travel.
    """
    if table[before, RADIUS] == 0.0 and table[here, RADIUS] == 0.0:
        _, cross, dot = classify_corner(table, before, here, signed)
        factor = signed / (1.0 + dot)
        if abs(factor * cross) > 0.49 * min(table[before, CHORD], table[here, CHORD]):
            return math.nan, math.nan
        x, y = contours.start[next_, 0], contours.start[next_, 1]
        return line_crossing(table, before, here, x, y, factor)
    if math.isnan(table[before, MOVED]) or math.isnan(table[here, MOVED]):
        return math.nan, math.nan
    hits, gx, gy, _, sine, _ = concave_crossing(contours, last, next_, table, before, here, signed)
    if hits != 1 or sine < 0.0:
        return math.nan, math.nan
    for at, x, y in (
        (before, table[before, EX], table[before, EY]),
        (here, table[here, SX], table[here, SY]),
    ):
        length = table[at, CHORD]
        if table[at, RADIUS] != 0.0:
            length *= table[at, MOVED] / table[at, RADIUS]
        if math.hypot(gx - x, gy - y) > 0.4 * length:
            return math.nan, math.nan
    return gx, gy


@kernel
def _trim_long_neighbours(contours: Contours, path: MovedPath) -> None:
    """Classify each corner of a path, and trim neighbouring moved segments to their intersection.

    They are trimmed only if each of them keeps about half its length.  Writes the kinds of the
    corners and the trimmed ends into ``path.segments``.
    """
    low, high, closed, signed, (table, joint), at = path
    start = contours.start
    count = high - low
    for i in range(count):
        here = at + i
        joint[here] = OPEN
        if i == 0 and not closed:
            continue
        before = at + (i - 1 if i > 0 else count - 1)
        last = low + (i - 1 if i > 0 else count - 1)
        joint[here], _, dot = classify_corner(table, before, here, signed)
        if joint[here] == CONVEX:
            continue
        if joint[here] == SMOOTH:
            x, y = start[low + i, 0], start[low + i, 1]
            gx, gy = line_crossing(table, before, here, x, y, signed / (1.0 + dot))
            joint[here] = smooth_joint(table, here, gx, gy)
        else:
            # Parts beyond the crossing are too close to a neighbour, but in a very flat corner by
            # less than DISTANCE_TOLERANCE, so they are removed here.
            gx, gy = _trim_point(contours, last, low + i, table, before, here, signed)
            if math.isnan(gx):
                continue
            joint[here] = SHIFTED
        join_segments(table, before, here, gx, gy)


@kernel
def raw_offset(
    contours: Contours,
    path: MovedPath,
    corners: CornerTypes,
    raw: RawRows,
    put: int,
    member: int,
) -> int:
    """Write the moved segments and transitions of a path to ``raw``, for ``region`` to split.

    Neighbouring segments are trimmed only if each of them keeps about half its length.  Arcs of
    which no part remains are omitted.

    Parameters
    ----------
    path
        The path; its moved segments are trimmed in place.
    raw, put
        Output rows, and the index of the first row to write.
    member
        Number of the path in the region, or -1.

    Returns
    -------
    The next free row of ``raw``.
    """
    _trim_long_neighbours(contours, path)
    low, high, closed, signed, (table, joint), at = path
    start, bulge, (rows, info) = contours.start, contours.bulge, raw
    count = high - low
    for i in range(count):
        here = at + i
        none = math.isnan(table[here, MOVED])
        if none and put > 0 and info[put - 1, 3] == member:
            info[put - 1, 2] = 0
        if joint[here] == CONVEX:
            before = at + (i - 1 if i > 0 else count - 1)
            begun = put
            put = write_corner_transition(
                contours, low + i, table, before, here, signed, corners, rows, put
            )
            for j in range(begun, put):
                info[j, 0] = low + i
                info[j, 1] = 1
                info[j, 2] = 1
                info[j, 3] = member
            if none:
                info[put - 1, 2] = 0
        if none:
            continue
        for column in range(4):
            rows[put, column] = table[here, SX + column]
        follows = at + (i + 1 if i < count - 1 else 0)
        bent = 0.0
        if table[here, RADIUS] != 0.0:
            bent = bulge[low + i]
            if joint[here] == SHIFTED or joint[follows] == SHIFTED:
                dx = table[here, EX] - table[here, SX]
                dy = table[here, EY] - table[here, SY]
                kept = remaining_bulge(
                    table, here, dx, dy, bent, start[low + i, 0], start[low + i, 1]
                )
                bent = kept if kept != 0.0 else bent
        rows[put, 4] = bent
        info[put, 0] = low + i
        info[put, 1] = 0
        info[put, 2] = joint[follows] != CONCAVE and (closed or i < count - 1)
        info[put, 3] = member
        put += 1
    return put
