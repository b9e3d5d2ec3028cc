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
    MovedCorner,
    MovedPath,
    MovedSegments,
    OffsetChains,
    OffsetGroups,
    OffsetProgress,
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
    corner is written to ``path.segments.joint``.  At a concave corner, the disc of the tool touches
    the two segments of the contour at one contact point each.

    Returns code, segment: ``NO_FAILURE`` or another failure code of ``raw_segments``, and the
    contour segment that failed; ``twice`` mm²: twice the area that the tool cannot reach at concave
    corners, plus twice the area of the sectors of the disc between the two contact points.
    ``trim_path`` subtracts the sectors; ``angle`` radians: sum of the angles of these sectors.
    """
    low, high, closed, signed, (table, joint), first_row = path
    start = contours.start
    count = high - low
    size = abs(signed)
    twice = 0.0
    # The sum of all angles, as a product of complex numbers and the number of turns.
    re, im, turns = 1.0, 0.0, 0
    for i in range(count):
        row_after = first_row + i
        joint[row_after] = OPEN
        if math.isnan(table[row_after, MOVED]):
            return DOES_NOT_FIT, low + i, 0.0, 0.0
        if i == 0 and not closed:
            continue
        row_before = row_after - 1 if i > 0 else first_row + count - 1
        last = low + i - 1 if i > 0 else high - 1
        kind, cross, dot = classify_corner(table, row_before, row_after, signed)
        if kind == CONVEX:
            joint[row_after] = CONVEX
            if dot < -1.0 + 1e-12:
                return DOES_NOT_FIT, low + i, 0.0, 0.0
            continue
        if kind == SMOOTH or (table[row_before, RADIUS] == 0.0 and table[row_after, RADIUS] == 0.0):
            # A nearly smooth joint is intersected like two lines.
            if dot < -1.0 + 1e-9:
                return DOES_NOT_FIT, low + i, 0.0, 0.0
            factor = signed / (1.0 + dot)
            x, y = start[low + i, 0], start[low + i, 1]
            gx, gy = line_crossing(table, row_before, row_after, x, y, factor)
            joint[row_after] = CONCAVE
            sine = abs(cross)
            if kind == SMOOTH:
                joint[row_after] = smooth_joint(table, row_after, gx, gy)
                dot, sine = 1.0, 0.0
            else:
                twice += 2.0 * abs(factor) * size * sine
        else:
            if math.isnan(table[row_before, MOVED]):
                return DOES_NOT_FIT, last, 0.0, 0.0
            hits, gx, gy, dot, sine, more = concave_crossing(
                contours, last, low + i, table, row_before, row_after, signed
            )
            if hits != 1 or sine < 0.0:
                return DOES_NOT_FIT, low + i, 0.0, 0.0
            joint[row_after] = CONCAVE
            twice += more
        join_segments(table, row_before, row_after, gx, gy)
        if sine > 0.0:
            re, im, round_ = _multiply_rotations(re, im, dot, sine)
            turns += round_
    return NO_FAILURE, low, twice, math.atan2(im, re) + 2.0 * math.pi * turns


@kernel(allocates=False)
def _trimmed_bulge(
    contours: Contours, i: int, segments: MovedSegments, row: int, begins: bool, ends: bool
) -> float:
    """Return the bulge of the moved contour segment ``i`` after trimming, NaN if no part remains.

    ``begins`` and ``ends`` state whether the segment is trimmed at its start and at its end;
    ``row`` is the row of the segment in ``segments``.
    """
    table = segments.table
    dx = table[row, EX] - table[row, SX]
    dy = table[row, EY] - table[row, SY]
    if table[row, RADIUS] == 0.0:
        if dx * table[row, U1X] + dy * table[row, U1Y] < POINT:
            return math.nan
        return 0.0
    bent: float = contours.bulge[i]
    if abs(bent) <= 1.0 and dx * dx + dy * dy < POINT * POINT:
        return math.nan
    if begins and ends and abs(bent) > 1.0:
        # Beyond half a turn the remaining part is not distinguishable from its complement.
        return math.nan
    if begins or ends:
        bent = remaining_bulge(table, row, dx, dy, bent, contours.start[i, 0], contours.start[i, 1])
        if bent == 0.0:
            return math.nan
    return bent


@kernel(allocates=False)
def _write_corner(
    contours: Contours,
    corner: MovedCorner,
    table: F64_2,
    corners: CornerTypes,
    out: OffsetSegments,
    next_row: int,
    rows: OutF64_2,
) -> int:
    """Write the transition at a corner to ``out`` from ``next_row`` on; return the next free row.

    The transition is the path of the tool's centre round the corner.  ``table`` are the moved
    segments, ``corners`` the types of the transitions of all corners, and ``rows`` scratch rows for
    one transition.
    """
    i, row_before, row_after, signed = corner
    if corners.kind[corners.step * i] == 0:
        u1x, u1y = table[row_before, U2X], table[row_before, U2Y]
        u2x, u2y = table[row_after, U1X], table[row_after, U1Y]
        turn = quarter_tangent(u1x * u2y - u1y * u2x, u1x * u2x + u1y * u2y)
        out.start[next_row, 0] = table[row_before, EX]
        out.start[next_row, 1] = table[row_before, EY]
        out.end[next_row, 0] = table[row_after, SX]
        out.end[next_row, 1] = table[row_after, SY]
        out.bulge[next_row] = -math.copysign(turn, signed)
        out.source[next_row] = i
        out.inserted[next_row] = True
        return next_row + 1
    count = write_corner_transition(contours, corner, table, corners, rows, 0)
    for r in range(count):
        out.start[next_row, 0] = rows[r, 0]
        out.start[next_row, 1] = rows[r, 1]
        out.end[next_row, 0] = rows[r, 2]
        out.end[next_row, 1] = rows[r, 3]
        out.bulge[next_row] = rows[r, 4]
        out.source[next_row] = i
        out.inserted[next_row] = True
        next_row += 1
    return next_row


@kernel(allocates=False)
def trim_path(
    contours: Contours,
    path: MovedPath,
    corners: CornerTypes,
    out: OffsetSegments,
    next_row: int,
    rows: OutF64_2,
) -> tuple[int, int, int, float]:
    """Write the offset of a path: moved segments, trimmed to their intersections, and transitions.

    Parameters
    ----------
    contours, path
        The input contours, and the path; its moved segments are trimmed in place.
    corners
        Types of the transitions at the corners.
    out, next_row
        Output columns, written from row ``next_row`` on.
    rows
        Scratch rows for one transition.

    Returns
    -------
    next_row
        Next free row of the output.
    code, segment
        ``NO_FAILURE`` or another failure code of ``raw_segments``, and the contour segment that
        failed.
    lost : mm²
        Area that the tool cannot reach at concave corners.
    """
    code, row, twice, angle = _trim_corners(contours, path)
    if code != NO_FAILURE:
        return next_row, code, row, 0.0
    low, high, closed, signed, segments, first_row = path
    table, joint = segments
    count = high - low
    for i in range(count):
        row_after = first_row + i
        follows = row_after + 1 if i < count - 1 else first_row
        begins = joint[row_after] >= CONCAVE
        ends = joint[follows] >= CONCAVE and (closed or i < count - 1)
        bent = _trimmed_bulge(contours, low + i, segments, row_after, begins, ends)
        if math.isnan(bent):
            return next_row, DOES_NOT_FIT, low + i, 0.0
        if joint[row_after] == CONVEX:
            row_before = row_after - 1 if i > 0 else first_row + count - 1
            corner = MovedCorner(low + i, row_before, row_after, signed)
            next_row = _write_corner(contours, corner, table, corners, out, next_row, rows)
        out.start[next_row, 0] = table[row_after, SX]
        out.start[next_row, 1] = table[row_after, SY]
        out.end[next_row, 0] = table[row_after, EX]
        out.end[next_row, 1] = table[row_after, EY]
        out.bulge[next_row] = bent
        out.source[next_row] = low + i
        out.inserted[next_row] = False
        next_row += 1
    size = abs(signed)
    return next_row, NO_FAILURE, low, max(0.5 * (twice - size * size * angle), 0.0)


@kernel(allocates=False)
def offset_simple(
    contours: Contours,
    groups: OffsetGroups,
    corners: CornerTypes,
    segments: MovedSegments,
    scratch: Scratch,
    out: OffsetSegments,
    chains: OffsetChains,
    progress: OffsetProgress,
) -> OffsetProgress:
    """Offset groups of one closed path each as long as trimming is enough; return the progress.

    The function stops before the first group that needs more than trimming, and before a group for
    which the output columns lack capacity.

    Parameters
    ----------
    contours, groups, corners
        Input contours, their groups, and the types of the transitions at their corners.
    segments, scratch
        Scratch arrays for the moved segments of one path, and for everything else.
    out, chains
        Columns for the segments and for the chains of all offsets.
    progress
        The first group to offset, and the numbers of segments and chains written before.
    """
    group, segment_count, chain_count = progress
    bounds, signed = groups.bounds, groups.signed
    checked = CheckedSegments(out.start, out.end, out.bulge, out.inserted)
    while group < len(bounds) - 1:
        path = groups.member[bounds[group]]
        low, high = contours.first[path], contours.first[path + 1]
        if (
            bounds[group + 1] - bounds[group] > 1
            or low == high
            or signed[path] == 0.0
            or segment_count + (MAX_SEGMENTS + 1) * (high - low) > len(out.bulge)
            or not is_closed(contours, low, high)
        ):
            break
        code, _ = move_segments(contours, low, high, signed[path], segments.table, 0)
        if code != NO_FAILURE:
            break
        moved = MovedPath(low, high, True, signed[path], segments, 0)
        next_row, code, _, lost = trim_path(
            contours, moved, corners, out, segment_count, scratch.pair
        )
        if code != NO_FAILURE or path_meets_itself(checked, segment_count, next_row, scratch):
            break
        chains.first[chain_count] = segment_count
        chains.owner[chain_count] = path
        chains.unreached[path] = lost
        chain_count += 1
        segment_count = next_row
        group += 1
    return OffsetProgress(group, segment_count, chain_count)
