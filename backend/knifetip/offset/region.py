"""region: the offset of one region with all its contours, if trimming is not enough.

    contours of a region, radius and side -> chains, and the area that the tool cannot reach

Every path is moved by itself, all moved segments are split where they cross, pieces nearer than
the radius to a contour are removed, and the rest is connected: to nothing, one path or several.

Source: our derivation.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry.boxes import FAN, STACK, Scratch, any_meet, tree, tree_size
from knifetip.geometry.intersect import box, point_on
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import (
    F64_2,
    I32_1,
    I64_1,
    Bool_2,
    OutBool_1,
    OutF64_2,
    OutI64_1,
    OutI64_2,
    kernel,
)
from knifetip.offset.clearance import NEARER, clear, distance, nearest
from knifetip.offset.raw_segments import (
    COLUMNS,
    FINE,
    MOVED,
    NO_ROOM,
    TORN,
    U1X,
    U1Y,
    U2X,
    U2Y,
    is_closed,
    move_segments,
)
from knifetip.offset.records import (
    BoxTree,
    Contours,
    CornerTypes,
    JoinedPieces,
    MovedSegments,
    OffsetSegments,
    RawRows,
    RegionCorners,
    RegionOffset,
    RegionPaths,
    ResultChains,
)
from knifetip.offset.slices import find_cuts, follow_pieces, link_chains, split_rows
from knifetip.offset.swept_area import area_under, swept_under
from knifetip.offset.transition import MOST, transition
from knifetip.offset.trim import trim_path
from knifetip.offset.untrimmed import raw_offset

#: Cells per side of the grid that orders the paths of a large group.
CELLS: Final = 1 << 15


@kernel
def _in_order(start: F64_2, first: I32_1, member: I32_1) -> Any:
    """Return the members ordered along a Z-order curve, so that near ones are together.

    The tree of boxes depends on this order.
    """
    count = len(member)
    if count <= FAN:
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
        x_cell = int((start[first[path], 0] - low_x) / side * (CELLS - 1))
        y_cell = int((start[first[path], 1] - low_y) / side * (CELLS - 1))
        for bit in range(15):
            code[m] |= ((x_cell >> bit) & 1) << (2 * bit)
            code[m] |= ((y_cell >> bit) & 1) << (2 * bit + 1)
    return member[np.argsort(code, kind="mergesort")]


@kernel
def _tree_over(rows: F64_2, count: int) -> BoxTree:
    boxes = np.empty((tree_size(count), 4))
    level = np.empty(24, np.int64)
    for i in range(count):
        box(rows, i, boxes, i)
    return BoxTree(boxes, level, tree(boxes, count, level))


@kernel
def _failed(code: int, row: int, other: int, depth: float) -> RegionOffset:
    """Return the failure of a region."""
    line = np.empty((0, 5))
    tag = np.empty((0, 4), np.int64)
    return RegionOffset(line, tag, np.zeros(1, np.int64), 0, 0.0, False, code, row, other, depth)


@kernel
def _region_paths(contours: Contours, members: I32_1) -> RegionPaths:
    """Return the paths of a region in spatial order."""
    member = _in_order(contours.start, contours.first, members)
    count = len(member)
    begin = np.zeros(count + 1, np.int64)
    closed = np.zeros(count, np.bool_)
    for m in range(count):
        a, b = contours.first[member[m]], contours.first[member[m] + 1]
        begin[m + 1] = begin[m] + b - a
        closed[m] = a < b and is_closed(contours, a, b)
    return RegionPaths(member, begin, closed)


@kernel
def _region_segments(
    contours: Contours, paths: RegionPaths, corners: CornerTypes, source: OutI64_1, origin: OutF64_2
) -> RegionCorners:
    """Write the segments of a region as rows, and return their corners before the offset."""
    total = len(source)
    segments = MovedSegments(np.empty((total, COLUMNS)), np.empty(total, np.int64))
    before = np.empty(total, np.int64)
    kind = np.empty(total, np.int64)
    share = np.empty(total)
    capped = False
    for m in range(len(paths.member)):
        a, b = contours.first[paths.member[m]], contours.first[paths.member[m] + 1]
        at = paths.begin[m]
        for i in range(a, b):
            here = at + i - a
            origin[here, 0] = contours.start[i, 0]
            origin[here, 1] = contours.start[i, 1]
            origin[here, 2] = contours.end[i, 0]
            origin[here, 3] = contours.end[i, 1]
            origin[here, 4] = contours.bulge[i] if abs(contours.bulge[i]) >= BULGE else 0.0
            source[here] = i
            before[here] = here - 1 if i > a else at + b - a - 1
            kind[here] = corners.kind[corners.step * i]
            share[here] = corners.share[corners.step * i]
            capped |= corners.kind[corners.step * i] > 0
    return RegionCorners(segments, before, kind, share, capped)


@kernel
def _write_trimmed(
    made: OffsetSegments, count: int, closed: bool, raw: RawRows, put: int, m: int
) -> int:
    """Write a trimmed path as raw rows of path ``m``; return the next free row."""
    for r in range(count):
        raw.rows[put, 0] = made.start[r, 0]
        raw.rows[put, 1] = made.start[r, 1]
        raw.rows[put, 2] = made.end[r, 0]
        raw.rows[put, 3] = made.end[r, 1]
        raw.rows[put, 4] = made.bulge[r]
        raw.info[put, 0] = made.source[r]
        raw.info[put, 1] = made.inserted[r]
        raw.info[put, 2] = closed or r < count - 1
        raw.info[put, 3] = m
        put += 1
    return put


@kernel
def _raw_region(
    contours: Contours,
    paths: RegionPaths,
    signed: float,
    corners: CornerTypes,
    segments: MovedSegments,
    raw: RawRows,
    follow: OutI64_1,
    rows: OutF64_2,
) -> tuple[int, int, int, int]:
    """Write the offset of each path of a region by itself into ``raw``.

    Returns the next free row, a segment that is lost as a whole, or -1, and a failure and its
    segment.
    """
    most = 0
    for m in range(len(paths.member)):
        most = max(most, paths.begin[m + 1] - paths.begin[m])
    room = (MOST + 1) * most
    made = OffsetSegments(
        np.empty((room, 2)),
        np.empty((room, 2)),
        np.empty(room),
        np.empty(room, np.int32),
        np.empty(room, np.bool_),
    )
    table = segments.table
    put = 0
    lost = -1
    for m in range(len(paths.member)):
        a, b = contours.first[paths.member[m]], contours.first[paths.member[m] + 1]
        at = paths.begin[m]
        if a == b:
            continue
        code, row = move_segments(contours, a, b, signed, table, at)
        if code != FINE:
            return put, lost, code, row
        closed = paths.closed[m]
        begun = put
        count, code, row, _ = trim_path(
            contours, a, b, closed, signed, corners, segments, at, made, 0, rows
        )
        if code == FINE:
            put = _write_trimmed(made, count, closed, raw, put, m)
        else:
            move_segments(contours, a, b, signed, table, at)
            put = raw_offset(contours, a, b, closed, signed, corners, segments, at, raw, put, m)
            for here in range(at, at + b - a):
                if math.isnan(table[here, MOVED]):
                    lost = a + here - at
        for e in range(begun, put):
            follow[e] = e + 1 if raw.info[e, 2] else -1
        if put > begun and raw.info[put - 1, 2]:
            follow[put - 1] = begun
    return put, lost, FINE, 0


@kernel
def _select_pieces(
    contours: Contours,
    paths: RegionPaths,
    raw: RawRows,
    follow: I64_1,
    pieces: JoinedPieces,
    touched: Bool_2,
    count: int,
    corners: RegionCorners,
    source: I64_1,
    origin: F64_2,
    signed: float,
    refuse: bool,
    lost: int,
    stack: OutI64_2,
    good: OutBool_1,
) -> tuple[int, int, float]:
    """Select the valid pieces: those not nearer to a contour than the radius.

    With ``refuse``, returns the segment where the tool fits worst, or -1, the segment that it is
    too close to, and the distance that is missing.
    """
    size = abs(signed)
    limit = size - NEARER
    total = len(source)
    piece, owner, opening, _, _ = pieces
    info = raw.info
    tree = _tree_over(origin, total)
    worst = 0.0
    worst_row = lost
    worst_other = lost
    if lost >= 0:
        worst = size - abs(_radius_of(contours, lost))
    for q in range(count):
        i = owner[q]
        runs_on = not refuse and q > 0 and q == opening[i] and follow[i - 1] == i
        if runs_on and not touched[i, 0] and not touched[i - 1, 1]:
            # Whether a piece is valid changes only at crossings.
            good[q] = good[q - 1]
            continue
        m = info[i, 3]
        mine = paths.begin[m] + info[i, 0] - contours.first[paths.member[m]]
        x, y = point_on(raw.rows, i, 0.5 * (piece[q, 4] + piece[q, 5]))
        # Most invalid pieces are too close to the next segments: test these first.
        near_by = False
        for near in range(max(mine - 2, 0), min(mine + 3, total)):
            near_by |= distance(origin, near, x, y) < limit
        good[q] = not near_by and clear(x, y, origin, tree, stack, signed, limit, corners)
        if refuse and not good[q]:
            other, away = nearest(x, y, origin, tree, stack, size, mine)
            ordinary = (other == corners.before[mine] or corners.before[other] == mine) and (
                piece[q, 4] > 0.0 or piece[q, 5] < 1.0
            )
            if not ordinary and size - away > worst:
                worst = size - away
                worst_row = info[i, 0]
                worst_other = source[other]
    return worst_row, worst_other, worst


@kernel
def _swept_area(
    contours: Contours,
    paths: RegionPaths,
    signed: float,
    out: ResultChains,
    chains: int,
    scratch: Scratch,
) -> tuple[float, bool, int, float]:
    """Return twice the area that the tool's edge encloses beside the chains of a region.

    Also returns whether some of it is swept twice, and a chain that should be closed but is not
    (-1 for none) with its length.
    """
    line, tag, bounds, ring = out
    count = len(paths.member)
    last = np.empty((count, 2))
    for m in range(count):
        if paths.begin[m] < paths.begin[m + 1]:
            last[m, 0] = contours.start[contours.first[paths.member[m]], 0]
            last[m, 1] = contours.start[contours.first[paths.member[m]], 1]
    swept = 0.0
    hops = np.empty((bounds[chains] + chains, 5))
    hop = 0
    for c in range(chains):
        m = tag[bounds[c], 2]
        if not ring[c] and paths.closed[m]:
            length = 0.0
            for r in range(bounds[c], bounds[c + 1]):
                length += math.hypot(line[r, 2] - line[r, 0], line[r, 3] - line[r, 1])
            return 0.0, False, c, length
        area, x, y, hop = swept_under(
            line, tag, bounds[c], bounds[c + 1], ring[c], contours.start, signed,
            last[m, 0], last[m, 1], hops, hop,
        )  # fmt: skip
        swept += area
        if not ring[c]:
            last[m, 0] = x
            last[m, 1] = y
    for m in range(count):
        if paths.begin[m] < paths.begin[m + 1] and not paths.closed[m]:
            x = contours.end[contours.first[paths.member[m] + 1] - 1, 0]
            y = contours.end[contours.first[paths.member[m] + 1] - 1, 1]
            swept += last[m, 0] * y - last[m, 1] * x
    # If these arcs meet, some of the area was swept twice.
    overlaps: bool = (
        chains > 0
        and bool(ring[:chains].all())
        and hop > 1
        and any_meet(hops[:hop, :2].copy(), hops[:hop, 2:4].copy(), hops[:hop, 4].copy(), scratch)
    )
    return swept, overlaps, -1, 0.0


@kernel
def offset_region(
    contours: Contours,
    members: I32_1,
    signed: float,
    corners: CornerTypes,
    refuse: bool,
    scratch: Scratch,
) -> RegionOffset:
    """Return the offset of one region with all its contours, split and connected.

    Parameters
    ----------
    members
        Numbers of its paths.
    refuse
        Fail where the tool does not fit.
    """
    paths = _region_paths(contours, members)
    count = len(paths.member)
    total = paths.begin[count]
    origin = np.empty((total, 5))
    source = np.empty(total, np.int64)
    region = _region_segments(contours, paths, corners, source, origin)
    room = 8 * total + 4 * count + 8
    raw = RawRows(np.empty((room, 5)), np.empty((room, 4), np.int64))
    follow = np.empty(room, np.int64)
    put, lost, code, row = _raw_region(
        contours, paths, signed, corners, region.moved, raw, follow, scratch.pair
    )
    if code != FINE:
        return _failed(code, row, row, 0.0)
    under = 0.0
    for m in range(count):
        a, b = contours.first[paths.member[m]], contours.first[paths.member[m] + 1]
        under += area_under(contours.start, contours.end, contours.bulge, a, b)
    real = put
    for m in range(count):
        if paths.begin[m] < paths.begin[m + 1] and not paths.closed[m]:
            a, b = contours.first[paths.member[m]], contours.first[paths.member[m] + 1]
            put = _other_side(contours, a, b, signed, raw, put)
    stack = np.empty((STACK, 2), np.int64)
    which, place, cuts = find_cuts(
        raw.rows, follow, put, real, _tree_over(raw.rows, put), stack, scratch.found
    )
    piece, owner, opening, touched, many = split_rows(raw.rows, real, which, place, cuts)
    pieces = JoinedPieces(piece, owner, opening, np.empty(many, np.int64), np.empty(many, np.int64))
    good = np.empty(many, np.bool_)
    row, other, depth = _select_pieces(
        contours, paths, raw, follow, pieces, touched, many, region, source, origin, signed, refuse,
        lost, stack, good,
    )  # fmt: skip
    if refuse and row >= 0:
        return _failed(NO_ROOM, row, other, depth)
    follow_pieces(pieces, follow, good, many)
    out = ResultChains(
        np.empty((many + 1, 5)),
        np.empty((many + 1, 4), np.int64),
        np.empty(many + 1, np.int64),
        np.empty(many + 1, np.bool_),
    )
    chains = link_chains(raw, pieces, good, many, out)
    swept, overlaps, torn, length = _swept_area(contours, paths, signed, out, chains, scratch)
    if torn >= 0:
        return _failed(TORN, out.tag[out.bounds[torn], 0], 0, length)
    unreached = 0.5 * (under - swept)
    if signed < 0.0:
        unreached = -unreached
    for r in range(out.bounds[chains]):
        out.tag[r, 2] = paths.member[out.tag[r, 2]]
    return RegionOffset(out.line, out.tag, out.bounds, chains, unreached, overlaps, FINE, 0, 0, 0.0)


@kernel
def _radius_of(contours: Contours, i: int) -> float:
    start, end = contours.start, contours.end
    b = abs(contours.bulge[i])
    chord = math.hypot(end[i, 0] - start[i, 0], end[i, 1] - start[i, 1])
    size: float = chord * (1.0 + b * b) / (4.0 * b)
    return size


@kernel
def _other_side(
    contours: Contours, low: int, high: int, signed: float, raw: RawRows, put: int
) -> int:
    """Write the other side and the ends of an open path: rows that only split others."""
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
    put = raw_offset(back, 0, count, False, signed, corners, segments, 0, raw, put, -1)
    for e in range(2):
        if e == 0:
            x, y, ux, uy = back.start[0, 0], back.start[0, 1], -table[0, U1X], -table[0, U1Y]
        else:
            last = count - 1
            x, y = back.end[last, 0], back.end[last, 1]
            ux, uy = table[last, U2X], table[last, U2Y]
        put = transition(0, x, y, ux, uy, -ux, -uy, signed, 0.0, raw.rows, put)
    return put


@kernel
def unreached_area(
    contours: Contours, members: I32_1, signed: float, region: RegionOffset, scratch: Scratch
) -> float:
    """Return the unreachable area: between the contours and the offset of their offset back."""
    rows = region.bounds[region.chains]
    back = Contours(
        region.line[:rows, :2].copy(),
        region.line[:rows, 2:4].copy(),
        region.line[:rows, 4].copy(),
        region.bounds[: region.chains + 1].astype(np.int32),
    )
    corners = CornerTypes(np.zeros(1, np.uint8), np.zeros(1), 0)
    paths = np.arange(region.chains).astype(np.int32)
    edge = offset_region(back, paths, -signed, corners, False, scratch)
    if edge.code != FINE:
        return region.unreached
    under = 0.0
    for path in members:
        under += area_under(
            contours.start,
            contours.end,
            contours.bulge,
            contours.first[path],
            contours.first[path + 1],
        )
    size = edge.bounds[edge.chains]
    under -= area_under(
        edge.line[:size, :2].copy(),
        edge.line[:size, 2:4].copy(),
        edge.line[:size, 4].copy(),
        0,
        size,
    )
    return 0.5 * math.copysign(under, under * signed)
