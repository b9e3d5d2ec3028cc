"""untrimmed: the moved segments of a path, mostly untrimmed, for paths that ``trim`` cannot offset.

``region`` splits these segments at their intersections.  Here, two neighbouring moved segments are
trimmed to their intersection only if each of them keeps about half its length.
"""

from __future__ import annotations

import math
from typing import Final

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
from knifetip.offset.records import Contours, CornerTypes, MovedCorner, MovedPath, RawRows

#: Largest overlap of two moved segments that are trimmed like their tangents (mm).  There, the
#: tangents deviate from arcs with radii above 1.3 mm by less than DISTANCE_TOLERANCE.
_FLAT: Final = 1e-4


@kernel
def _trim_point(
    contours: Contours,
    last: int,
    next_: int,
    table: F64_2,
    row_before: int,
    row_after: int,
    signed: float,
) -> tuple[float, float]:
    """Return the point (x, y) to which the moved segments at a concave corner are trimmed (mm).

    The point is NaN if the two moved segments do not cross once, or if one of them would lose more
    than about half its length.  In a very flat corner, where rounding decides how often arcs cross,
    it is the intersection of their tangents.

    ``last``, ``next_``: contour segments before and after the corner.
    ``table``, ``row_before``, ``row_after``: moved segments, and the rows in which ``last`` and
    ``next_`` are.
    ``signed`` mm: radius of the tool, positive left of travel.
    """
    if table[row_before, RADIUS] == 0.0 and table[row_after, RADIUS] == 0.0:
        _, cross, dot = classify_corner(table, row_before, row_after, signed)
        factor = signed / (1.0 + dot)
        if abs(factor * cross) > 0.49 * min(table[row_before, CHORD], table[row_after, CHORD]):
            return math.nan, math.nan
        x, y = contours.start[next_, 0], contours.start[next_, 1]
        return line_crossing(table, row_before, row_after, x, y, factor)
    if math.isnan(table[row_before, MOVED]) or math.isnan(table[row_after, MOVED]):
        return math.nan, math.nan
    hits, gx, gy, _, sine, _ = concave_crossing(
        contours, last, next_, table, row_before, row_after, signed
    )
    if hits != 1 or sine < 0.0:
        _, cross, dot = classify_corner(table, row_before, row_after, signed)
        if dot < 0.0 or abs(signed * cross) > _FLAT:
            return math.nan, math.nan
        x, y = contours.start[next_, 0], contours.start[next_, 1]
        gx, gy = line_crossing(table, row_before, row_after, x, y, signed / (1.0 + dot))
    for row, x, y in (
        (row_before, table[row_before, EX], table[row_before, EY]),
        (row_after, table[row_after, SX], table[row_after, SY]),
    ):
        length = table[row, CHORD]
        if table[row, RADIUS] != 0.0:
            length *= table[row, MOVED] / table[row, RADIUS]
        if math.hypot(gx - x, gy - y) > 0.4 * length:
            return math.nan, math.nan
    return gx, gy


@kernel
def _trim_long_neighbours(contours: Contours, path: MovedPath) -> None:
    """Classify each corner of a path, and trim neighbouring moved segments to their intersection.

    They are trimmed only if each of them keeps about half its length.  Writes the kinds of the
    corners and the trimmed ends into ``path.segments``.
    """
    low, high, closed, signed, (table, joint), first_row = path
    start = contours.start
    count = high - low
    for i in range(count):
        row_after = first_row + i
        joint[row_after] = OPEN
        if i == 0 and not closed:
            continue
        row_before = first_row + (i - 1 if i > 0 else count - 1)
        last = low + (i - 1 if i > 0 else count - 1)
        joint[row_after], _, dot = classify_corner(table, row_before, row_after, signed)
        if joint[row_after] == CONVEX:
            continue
        if joint[row_after] == SMOOTH:
            x, y = start[low + i, 0], start[low + i, 1]
            gx, gy = line_crossing(table, row_before, row_after, x, y, signed / (1.0 + dot))
            joint[row_after] = smooth_joint(table, row_after, gx, gy)
        else:
            # Parts beyond the crossing are too close to a neighbour, but in a very flat corner by
            # less than DISTANCE_TOLERANCE, so they are removed here.
            gx, gy = _trim_point(contours, last, low + i, table, row_before, row_after, signed)
            if math.isnan(gx):
                continue
            joint[row_after] = SHIFTED
        join_segments(table, row_before, row_after, gx, gy)


@kernel
def raw_offset(
    contours: Contours,
    path: MovedPath,
    corners: CornerTypes,
    raw: RawRows,
    next_row: int,
    member: int,
) -> int:
    """Write the moved segments and transitions of a path to ``raw``, for ``region`` to split.

    Neighbouring segments are trimmed only if each of them keeps about half its length.  An arc is
    omitted if the offset leaves no part of the arc.

    Parameters
    ----------
    contours, path
        The input contours, and the path; its moved segments are trimmed in place.
    corners
        Types of the transitions at the corners.
    raw, next_row
        Output rows, and the index of the first row to write.
    member
        Number of the path in the region; -1 for rows that only split other rows and are not part of
        the offset.

    Returns
    -------
    The next free row of ``raw``.
    """
    _trim_long_neighbours(contours, path)
    low, high, closed, signed, (table, joint), first_row = path
    start, bulge, (rows, info, _) = contours.start, contours.bulge, raw
    count = high - low
    for i in range(count):
        row_after = first_row + i
        none = math.isnan(table[row_after, MOVED])
        if none and next_row > 0 and info[next_row - 1, 3] == member:
            info[next_row - 1, 2] = 0
        if joint[row_after] == CONVEX:
            row_before = first_row + (i - 1 if i > 0 else count - 1)
            begun = next_row
            corner = MovedCorner(low + i, row_before, row_after, signed)
            next_row = write_corner_transition(contours, corner, table, corners, rows, next_row)
            for j in range(begun, next_row):
                info[j, 0] = low + i
                info[j, 1] = 1
                info[j, 2] = 1
                info[j, 3] = member
            if none:
                info[next_row - 1, 2] = 0
        if none:
            continue
        for column in range(4):
            rows[next_row, column] = table[row_after, SX + column]
        follows = first_row + (i + 1 if i < count - 1 else 0)
        bent = 0.0
        if table[row_after, RADIUS] != 0.0:
            bent = bulge[low + i]
            if joint[row_after] == SHIFTED or joint[follows] == SHIFTED:
                dx = table[row_after, EX] - table[row_after, SX]
                dy = table[row_after, EY] - table[row_after, SY]
                kept = remaining_bulge(
                    table, row_after, dx, dy, bent, start[low + i, 0], start[low + i, 1]
                )
                bent = kept if kept != 0.0 else bent
        rows[next_row, 4] = bent
        info[next_row, 0] = low + i
        info[next_row, 1] = 0
        info[next_row, 2] = joint[follows] != CONCAVE and (closed or i < count - 1)
        info[next_row, 3] = member
        next_row += 1
    return next_row
