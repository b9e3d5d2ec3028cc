"""trim: offset a path by trimming neighbouring moved segments to their intersection.

This is enough for most contours.  A moved segment is trimmed if the next one crosses it once.  If
no part of a segment remains, or if two neighbouring moved segments at a concave corner cross twice
or not at all, ``region`` computes the offset instead.
"""

from __future__ import annotations

import math

from knifetip.geometry.tolerance import POINT
from knifetip.kernels import F64_2, OutF64_2, kernel
from knifetip.offset.corners import (
    classify_corner,
    concave_crossing,
    join_segments,
    line_crossing,
    smooth_joint,
    write_corner_transition,
)
from knifetip.offset.raw_segments import (
    CONCAVE,
    CONVEX,
    DOES_NOT_FIT,
    EX,
    EY,
    MOVED,
    NO_FAILURE,
    OPEN,
    RADIUS,
    SMOOTH,
    SX,
    SY,
    U1X,
    U1Y,
    U2X,
    U2Y,
    is_closed,
    move_segments,
    remaining_bulge,
)
from knifetip.offset.records import (
    Contours,
    CornerTypes,
    MovedPath,
    MovedSegments,
    OffsetChains,
    OffsetGroups,
    OffsetSegments,
)
from knifetip.offset.self_contact import CheckedSegments, Scratch, path_meets_itself
from knifetip.offset.transition import MAX_SEGMENTS, quarter_tangent


@kernel(allocates=False)
def _multiply_rotations(re: float, im: float, dot: float, sine: float) -> tuple[float, float, bool]:
    """Return the product of two rotations, and whether the sum of their angles passes 180°.

    Rotations are complex numbers of modulus 1: ``re`` + i ``im`` and ``dot`` + i ``sine``.
    """
    product = re * dot - im * sine
    up = re * sine + im * dot
    return product, up, im >= 0.0 > up and min(re, product) < 0.0


@kernel(allocates=False)
def _trim_corners(contours: Contours, path: MovedPath) -> tuple[int, int, float, float]:
    """Trim the moved segments at concave corners to their intersection, and classify all corners.

    The ends of the moved segments are changed in ``path.segments.table``, and the kind of each
    corner is written to ``path.segments.joint``.

    Returns
    -------
    code, segment
        Failure code (a constant of ``raw_segments``), and the contour segment that failed.
    twice : mm²
        Twice the area that the tool cannot reach at concave corners, plus twice the area of the
        disc's sectors between its contact points there.
    angle : radians
        Sum of the angles of these sectors.
    """
    low, high, closed, signed, (table, joint), at = path
    start = contours.start
    count = high - low
    size = abs(signed)
    twice = 0.0
    # The sum of all angles, as a product of complex numbers and the number of turns.
    re, im, turns = 1.0, 0.0, 0
    for i in range(count):
        here = at + i
        joint[here] = OPEN
        if math.isnan(table[here, MOVED]):
            return DOES_NOT_FIT, low + i, 0.0, 0.0
        if i == 0 and not closed:
            continue
        before = here - 1 if i > 0 else at + count - 1
        last = low + i - 1 if i > 0 else high - 1
        kind, cross, dot = classify_corner(table, before, here, signed)
        if kind == CONVEX:
            joint[here] = CONVEX
            if dot < -1.0 + 1e-12:
                return DOES_NOT_FIT, low + i, 0.0, 0.0
            continue
        if kind == SMOOTH or (table[before, RADIUS] == 0.0 and table[here, RADIUS] == 0.0):
            # A nearly smooth joint is intersected like two lines.
            if dot < -1.0 + 1e-9:
                return DOES_NOT_FIT, low + i, 0.0, 0.0
            factor = signed / (1.0 + dot)
            x, y = start[low + i, 0], start[low + i, 1]
            gx, gy = line_crossing(table, before, here, x, y, factor)
            joint[here] = CONCAVE
            sine = abs(cross)
            if kind == SMOOTH:
                joint[here] = smooth_joint(table, here, gx, gy)
                dot, sine = 1.0, 0.0
            else:
                twice += 2.0 * abs(factor) * size * sine
        else:
            if math.isnan(table[before, MOVED]):
                return DOES_NOT_FIT, last, 0.0, 0.0
            hits, gx, gy, dot, sine, more = concave_crossing(
                contours, last, low + i, table, before, here, signed
            )
            if hits != 1 or sine < 0.0:
                return DOES_NOT_FIT, low + i, 0.0, 0.0
            joint[here] = CONCAVE
            twice += more
        join_segments(table, before, here, gx, gy)
        if sine > 0.0:
            re, im, round_ = _multiply_rotations(re, im, dot, sine)
            turns += round_
    return NO_FAILURE, low, twice, math.atan2(im, re) + 2.0 * math.pi * turns


@kernel(allocates=False)
def _trimmed_bulge(
    contours: Contours, i: int, segments: MovedSegments, here: int, begins: bool, ends: bool
) -> float:
    """Return the bulge of the moved contour segment ``i`` after trimming, NaN if no part remains.

    ``begins`` and ``ends`` state whether the segment is trimmed at its start and at its end;
    ``here`` is the row of the segment in ``segments``.
    """
    table = segments.table
    dx = table[here, EX] - table[here, SX]
    dy = table[here, EY] - table[here, SY]
    if table[here, RADIUS] == 0.0:
        if dx * table[here, U1X] + dy * table[here, U1Y] < POINT:
            return math.nan
        return 0.0
    bent: float = contours.bulge[i]
    if abs(bent) <= 1.0 and dx * dx + dy * dy < POINT * POINT:
        return math.nan
    if begins and ends and abs(bent) > 1.0:
        # Beyond half a turn the remaining part is not distinguishable from its complement.
        return math.nan
    if begins or ends:
        bent = remaining_bulge(
            table, here, dx, dy, bent, contours.start[i, 0], contours.start[i, 1]
        )
        if bent == 0.0:
            return math.nan
    return bent


@kernel(allocates=False)
def _write_corner(
    contours: Contours,
    i: int,
    table: F64_2,
    before: int,
    here: int,
    signed: float,
    corners: CornerTypes,
    out: OffsetSegments,
    put: int,
    rows: OutF64_2,
) -> int:
    """Write the transition at the start of contour segment ``i`` to ``out``.

    Returns the next free row of ``out``.

    Parameters
    ----------
    table, before, here
        Moved segments, and the rows of the segments before and after the corner.
    signed : mm
        Radius of the tool, positive left of travel.
    put
        First row of ``out`` to write.
    rows
        Scratch rows for one transition.
    """
    if corners.kind[corners.step * i] == 0:
        u1x, u1y = table[before, U2X], table[before, U2Y]
        u2x, u2y = table[here, U1X], table[here, U1Y]
        turn = quarter_tangent(u1x * u2y - u1y * u2x, u1x * u2x + u1y * u2y)
        out.start[put, 0] = table[before, EX]
        out.start[put, 1] = table[before, EY]
        out.end[put, 0] = table[here, SX]
        out.end[put, 1] = table[here, SY]
        out.bulge[put] = -math.copysign(turn, signed)
        out.source[put] = i
        out.inserted[put] = True
        return put + 1
    count = write_corner_transition(contours, i, table, before, here, signed, corners, rows, 0)
    for r in range(count):
        out.start[put, 0] = rows[r, 0]
        out.start[put, 1] = rows[r, 1]
        out.end[put, 0] = rows[r, 2]
        out.end[put, 1] = rows[r, 3]
        out.bulge[put] = rows[r, 4]
        out.source[put] = i
        out.inserted[put] = True
        put += 1
    return put


@kernel(allocates=False)
def trim_path(
    contours: Contours,
    path: MovedPath,
    corners: CornerTypes,
    out: OffsetSegments,
    put: int,
    rows: OutF64_2,
) -> tuple[int, int, int, float]:
    """Write the offset of a path: moved segments, trimmed to their intersections, and transitions.

    Parameters
    ----------
    path
        The path; its moved segments are trimmed in place.
    out, put
        Output columns, written from row ``put`` on.
    rows
        Scratch rows for one transition.

    Returns
    -------
    put
        Next free row of the output.
    code, segment
        Failure code (a constant of ``raw_segments``), and the contour segment that failed.
    lost : mm²
        Area that the tool cannot reach at concave corners.
    """
    code, row, twice, angle = _trim_corners(contours, path)
    if code != NO_FAILURE:
        return put, code, row, 0.0
    low, high, closed, signed, segments, at = path
    table, joint = segments
    count = high - low
    for i in range(count):
        here = at + i
        follows = here + 1 if i < count - 1 else at
        begins = joint[here] >= CONCAVE
        ends = joint[follows] >= CONCAVE and (closed or i < count - 1)
        bent = _trimmed_bulge(contours, low + i, segments, here, begins, ends)
        if math.isnan(bent):
            return put, DOES_NOT_FIT, low + i, 0.0
        if joint[here] == CONVEX:
            before = here - 1 if i > 0 else at + count - 1
            put = _write_corner(
                contours, low + i, table, before, here, signed, corners, out, put, rows
            )
        out.start[put, 0] = table[here, SX]
        out.start[put, 1] = table[here, SY]
        out.end[put, 0] = table[here, EX]
        out.end[put, 1] = table[here, EY]
        out.bulge[put] = bent
        out.source[put] = low + i
        out.inserted[put] = False
        put += 1
    size = abs(signed)
    return put, NO_FAILURE, low, max(0.5 * (twice - size * size * angle), 0.0)


@kernel(allocates=False)
def offset_simple(
    contours: Contours,
    groups: OffsetGroups,
    group: int,
    corners: CornerTypes,
    segments: MovedSegments,
    boxes: OutF64_2,
    scratch: Scratch,
    out: OffsetSegments,
    done: int,
    chains: OffsetChains,
    count: int,
) -> tuple[int, int, int]:
    """Offset groups of one closed path each, from ``group`` on, while trimming is enough.

    The function stops before the first group that needs more than trimming, and before a group for
    which the output columns lack capacity.

    Parameters
    ----------
    out, done
        Columns for the segments of all offsets, and the number of segments written before.
    chains, count
        Columns for the chains of all offsets, and the number of chains written before.

    Returns
    -------
    group
        First group that is not done.
    done, count
        Number of segments and number of chains that are written.
    """
    bounds, signed = groups.bounds, groups.signed
    checked = CheckedSegments(out.start, out.end, out.bulge, out.inserted)
    while group < len(bounds) - 1:
        path = groups.member[bounds[group]]
        low, high = contours.first[path], contours.first[path + 1]
        if (
            bounds[group + 1] - bounds[group] > 1
            or low == high
            or signed[path] == 0.0
            or done + (MAX_SEGMENTS + 1) * (high - low) > len(out.bulge)
            or not is_closed(contours, low, high)
        ):
            break
        code, _ = move_segments(contours, low, high, signed[path], segments.table, 0)
        if code != NO_FAILURE:
            break
        moved = MovedPath(low, high, True, signed[path], segments, 0)
        put, code, _, lost = trim_path(contours, moved, corners, out, done, scratch.pair)
        if code != NO_FAILURE or path_meets_itself(checked, done, put, boxes, scratch):
            break
        chains.first[count] = done
        chains.owner[count] = path
        chains.unreached[path] = lost
        count += 1
        done = put
        group += 1
    return group, done, count
