"""region: the equidistant of one region with all its contours, where shortening is not enough.

    contours of a region, radius and side -> chains, and the area that the tool cannot reach

Every path is moved by itself, everything is cut where it crosses, what comes nearer than the
radius to any contour is thrown away, and the rest is joined again: nothing, one path or several.

Source: our own.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry.beside import (
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
    moved,
)
from knifetip.geometry.boxes import FAN, STACK, any_meet, tree, tree_size
from knifetip.geometry.clearance import NEARER, clear, distance, nearest
from knifetip.geometry.intersect import box, point_on
from knifetip.geometry.pieces import cut, joined, pieces, strung
from knifetip.geometry.shortened import shortened
from knifetip.geometry.swept import area_under, swept_under
from knifetip.geometry.tolerance import BULGE
from knifetip.geometry.transition import MOST, transition
from knifetip.geometry.whole import as_moved
from knifetip.kernels import F64_1, F64_2, I32_1, U8_1, OutF64_2, OutI64_1, OutI64_2, kernel

#: Cells along each side of the plane in which the paths of a large group are put in order.
CELLS: Final = 1 << 15


@kernel
def _in_order(start: F64_2, first: I32_1, member: I32_1) -> Any:
    """The members with those that are near each other together, along a Z-shaped curve.

    The tree over their rows lives on that.
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
def _tree_over(rows: F64_2, count: int) -> tuple[Any, Any, int]:
    boxes = np.empty((tree_size(count), 4))
    level = np.empty(24, np.int64)
    for i in range(count):
        box(rows, i, boxes, i)
    return boxes, level, tree(boxes, count, level)


@kernel
def fitting(
    start: F64_2,
    end: F64_2,
    bulge: F64_1,
    first: I32_1,
    members: I32_1,
    signed: float,
    corner: U8_1,
    k: F64_1,
    step: int,
    refuse: bool,
    pair: OutF64_2,
    found: OutF64_2,
) -> tuple[Any, Any, Any, int, float, bool, int, int, int, float]:
    """The equidistant of one region with all its contours, cut and joined.

    ``step`` is 0 where all corners are of the type corner[0], else 1; members are path numbers.

    Returns rows (x0, y0, x1, y1, bulge), tags (segment, inserted, path, row), bounds and number of
    the chains, the area that is not reached and whether it is an estimate, and a failure with two
    segments and a depth.
    """
    size = abs(signed)
    member = _in_order(start, first, members)
    count = len(member)
    begin = np.zeros(count + 1, np.int64)
    for m in range(count):
        begin[m + 1] = begin[m] + first[member[m] + 1] - first[member[m]]
    total = begin[count]
    most = 0
    for m in range(count):
        most = max(most, begin[m + 1] - begin[m])
    table = np.empty((total, COLUMNS))
    joint = np.empty(total, np.int64)
    origin = np.empty((total, 5))
    source = np.empty(total, np.int64)
    before = np.empty(total, np.int64)
    kinds = np.empty(total, np.int64)
    share = np.empty(total)
    room = 8 * total + 4 * count + 8
    rows = np.empty((room, 5))
    info = np.empty((room, 4), np.int64)
    follow = np.empty(room, np.int64)
    shut = np.zeros(count, np.bool_)
    made = (MOST + 1) * most
    made_start = np.empty((made, 2))
    made_end = np.empty((made, 2))
    made_bulge = np.empty(made)
    made_source = np.empty(made, np.int32)
    made_inserted = np.empty(made, np.bool_)
    none = np.empty(0, np.int64)
    put = 0
    capped = False
    lost_row = -1
    under = 0.0
    for m in range(count):
        a, b = first[member[m]], first[member[m] + 1]
        at = begin[m]
        if a == b:
            continue
        code, row = moved(start, end, bulge, a, b, signed, table, at)
        if code != FINE:
            return rows, info, none, 0, 0.0, False, code, row, row, 0.0
        shut[m] = is_closed(start, end, a, b)
        for i in range(a, b):
            here = at + i - a
            origin[here, 0] = start[i, 0]
            origin[here, 1] = start[i, 1]
            origin[here, 2] = end[i, 0]
            origin[here, 3] = end[i, 1]
            origin[here, 4] = bulge[i] if abs(bulge[i]) >= BULGE else 0.0
            source[here] = i
            before[here] = here - 1 if i > a else at + b - a - 1
            kinds[here] = corner[step * i]
            share[here] = k[step * i]
            capped |= corner[step * i] > 0
        begun = put
        many, code, row, _ = shortened(
            start, end, bulge, a, b, shut[m], signed, corner, k, step, table, at, joint,
            made_start, made_end, made_bulge, made_source, made_inserted, 0, pair,
        )  # fmt: skip
        if code == FINE:
            for r in range(many):
                rows[put, 0] = made_start[r, 0]
                rows[put, 1] = made_start[r, 1]
                rows[put, 2] = made_end[r, 0]
                rows[put, 3] = made_end[r, 1]
                rows[put, 4] = made_bulge[r]
                info[put, 0] = made_source[r]
                info[put, 1] = made_inserted[r]
                info[put, 2] = shut[m] or r < many - 1
                info[put, 3] = m
                put += 1
        else:
            moved(start, end, bulge, a, b, signed, table, at)
            put = as_moved(
                start, end, bulge, a, b, shut[m], signed, corner, k, step, table, at, joint,
                rows, info, put, m,
            )  # fmt: skip
            for here in range(at, at + b - a):
                if math.isnan(table[here, MOVED]):
                    lost_row = source[here]
        for e in range(begun, put):
            follow[e] = e + 1 if info[e, 2] else -1
        if put > begun and info[put - 1, 2]:
            follow[put - 1] = begun
        under += area_under(start, end, bulge, a, b)
    real = put
    for m in range(count):
        if begin[m] < begin[m + 1] and not shut[m]:
            a, b = first[member[m]], first[member[m] + 1]
            put = _other_side(start, end, bulge, a, b, signed, rows, info, put)
    boxes, level, height = _tree_over(rows, put)
    stack = np.empty((STACK, 2), np.int64)
    which, place, cuts = cut(rows, follow, put, real, boxes, level, height, stack, found)
    piece, owner, opening, touched, many = pieces(rows, real, which, place, cuts)
    boxes, level, height = _tree_over(origin, total)
    limit = size - NEARER
    good = np.empty(many, np.bool_)
    worst = 0.0
    worst_row = lost_row
    worst_other = lost_row
    if lost_row >= 0:
        worst = size - abs(_radius_of(start, end, bulge, lost_row))
    for q in range(many):
        i = owner[q]
        runs_on = not refuse and q > 0 and q == opening[i] and follow[i - 1] == i
        if runs_on and not touched[i, 0] and not touched[i - 1, 1]:
            # Only where lines cross does a way become too near, or clear again.
            good[q] = good[q - 1]
            continue
        m = info[i, 3]
        mine = begin[m] + info[i, 0] - first[member[m]]
        x, y = point_on(rows, i, 0.5 * (piece[q, 4] + piece[q, 5]))
        # What is lost is mostly lost to the next segments: ask them first.
        lost = False
        for near in range(max(mine - 2, 0), min(mine + 3, total)):
            lost |= distance(origin, near, x, y) < limit
        good[q] = not lost and clear(
            x, y, origin, boxes, level, height, stack, signed, limit,
            table, before, joint, kinds, share, capped,
        )  # fmt: skip
        if refuse and not good[q]:
            other, away = nearest(x, y, origin, boxes, level, height, stack, size, mine)
            ordinary = (other == before[mine] or before[other] == mine) and (
                piece[q, 4] > 0.0 or piece[q, 5] < 1.0
            )
            if not ordinary and size - away > worst:
                worst = size - away
                worst_row = info[i, 0]
                worst_other = source[other]
    if refuse and worst_row >= 0:
        return rows, info, none, 0, 0.0, False, NO_ROOM, worst_row, worst_other, worst
    after = np.empty(many, np.int64)
    prior = np.empty(many, np.int64)
    joined(piece, owner, opening, follow, good, many, after, prior)
    line = np.empty((many + 1, 5))
    tag = np.empty((many + 1, 4), np.int64)
    bounds = np.empty(many + 1, np.int64)
    ring = np.empty(many + 1, np.bool_)
    chains = strung(rows, info, piece, owner, good, after, prior, many, line, tag, bounds, ring)
    # What is not reached, and chains that should be closed and are not.
    last = np.empty((count, 2))
    for m in range(count):
        if begin[m] < begin[m + 1]:
            last[m, 0] = start[first[member[m]], 0]
            last[m, 1] = start[first[member[m]], 1]
    swept = 0.0
    hops = np.empty((bounds[chains] + chains, 5))
    hop = 0
    for c in range(chains):
        m = tag[bounds[c], 2]
        if not ring[c] and shut[m]:
            length = 0.0
            for r in range(bounds[c], bounds[c + 1]):
                length += math.hypot(line[r, 2] - line[r, 0], line[r, 3] - line[r, 1])
            return line, tag, bounds, 0, 0.0, False, TORN, tag[bounds[c], 0], 0, length
        area, x, y, hop = swept_under(
            line, tag, bounds[c], bounds[c + 1], ring[c], start, signed,
            last[m, 0], last[m, 1], hops, hop,
        )  # fmt: skip
        swept += area
        if not ring[c]:
            last[m, 0] = x
            last[m, 1] = y
    for m in range(count):
        if begin[m] < begin[m + 1] and not shut[m]:
            x = end[first[member[m] + 1] - 1, 0]
            y = end[first[member[m] + 1] - 1, 1]
            swept += last[m, 0] * y - last[m, 1] * x
    unreached = 0.5 * (under - swept)
    if signed < 0.0:
        unreached = -unreached
    for r in range(bounds[chains]):
        tag[r, 2] = member[tag[r, 2]]
    # Where these arcs meet, some of the area has been swept twice.
    twice: bool = (
        chains > 0
        and bool(ring[:chains].all())
        and hop > 1
        and any_meet(
            hops[:hop, :2].copy(), hops[:hop, 2:4].copy(), hops[:hop, 4].copy(), pair, found
        )
    )
    return line, tag, bounds, chains, unreached, twice, FINE, 0, 0, 0.0


@kernel
def _radius_of(start: F64_2, end: F64_2, bulge: F64_1, i: int) -> float:
    b = abs(bulge[i])
    chord = math.hypot(end[i, 0] - start[i, 0], end[i, 1] - start[i, 1])
    size: float = chord * (1.0 + b * b) / (4.0 * b)
    return size


@kernel
def _other_side(
    start: F64_2,
    end: F64_2,
    bulge: F64_1,
    low: int,
    high: int,
    signed: float,
    rows: OutF64_2,
    info: OutI64_2,
    put: int,
) -> int:
    """Write how far the other side of an open path and its two ends reach: no path, but it cuts."""
    count = high - low
    back_start = end[low:high][::-1].copy()
    back_end = start[low:high][::-1].copy()
    back_bulge = (-bulge[low:high][::-1]).copy()
    table = np.empty((count, COLUMNS))
    joint = np.empty(count, np.int64)
    plain = np.zeros(1, np.uint8)
    half = np.zeros(1)
    moved(back_start, back_end, back_bulge, 0, count, signed, table, 0)
    put = as_moved(
        back_start, back_end, back_bulge, 0, count, False, signed, plain, half, 0, table, 0, joint,
        rows, info, put, -1,
    )  # fmt: skip
    for e in range(2):
        if e == 0:
            x, y, ux, uy = back_start[0, 0], back_start[0, 1], -table[0, U1X], -table[0, U1Y]
        else:
            last = count - 1
            x, y = back_end[last, 0], back_end[last, 1]
            ux, uy = table[last, U2X], table[last, U2Y]
        put = transition(0, x, y, ux, uy, -ux, -uy, signed, 0.0, rows, put)
    return put


@kernel
def left_over(
    start: F64_2,
    end: F64_2,
    bulge: F64_1,
    first: I32_1,
    members: I32_1,
    signed: float,
    line: F64_2,
    bounds: OutI64_1,
    chains: int,
    estimate: float,
    pair: OutF64_2,
    found: OutF64_2,
) -> float:
    """The area that is not reached, by the equidistant of the equidistant, back at the contour."""
    rows = bounds[chains]
    edge, _, parts, count, _, _, code, _, _, _ = fitting(
        line[:rows, :2].copy(),
        line[:rows, 2:4].copy(),
        line[:rows, 4].copy(),
        bounds[: chains + 1].astype(np.int32),
        np.arange(chains).astype(np.int32),
        -signed,
        np.zeros(1, np.uint8),
        np.zeros(1),
        0,
        False,
        pair,
        found,
    )
    if code != FINE:
        return estimate
    under = 0.0
    for path in members:
        under += area_under(start, end, bulge, first[path], first[path + 1])
    size = parts[count]
    under -= area_under(
        edge[:size, :2].copy(), edge[:size, 2:4].copy(), edge[:size, 4].copy(), 0, size
    )
    return 0.5 * math.copysign(under, under * signed)
