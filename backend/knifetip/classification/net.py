"""net: the edges of a drawing as a net of pieces between places.

    ends, bulge -> Net

Edges are parted where others end on them or cross them.  Ends that stop just short of another line
are joined to it, and rows of dashes to one line, by links: pieces without an edge, which only the
net knows.  Lines that lie on each other count once.

Everything here is compiled: 100,000 edges take less than a tenth of a second.  A drawing so tangled
that this would take long is not looked at: ``built`` returns None.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numba import njit

from knifetip.geometry.columns import F64, I32, Bool

#: At so many cells or pairs of lines, as a multiple of the edges, a drawing is too tangled.
_WORK: Final = 400
_BULGE: Final = 1e-9


@dataclass(frozen=True, eq=False, slots=True)
class Grid:
    """Which edges pass through which cell."""

    low: F64  #: (2,)
    size: F64  #: (2,) of a cell
    side: int  #: cells in each direction
    first: I32  #: (side² + 1,)
    listed: I32  #: edges, cell by cell


@dataclass(frozen=True, eq=False, slots=True)
class Net:
    """p pieces of n edges between q places."""

    grid: Grid
    place: F64  #: (q, 2)
    start: I32  #: (p,) the place where each piece begins
    end: I32  #: (p,)
    bulge: F64  #: (p,)
    edge: I32  #: (p,) the edge that it is of, -1 for a link
    share: F64  #: (p,) where on its edge it begins, 0 … 1
    first: I32  #: (n + 1,) the pieces of each edge are first … first + 1 - 1
    same: I32  #: (p,) the first piece that lies where this one lies
    dashed: Bool  #: (n,) the edge is one of a row of dashes


def built(ends: F64, bulge: F64, touch: float, reach: float) -> Net | None:
    """Return the net of n edges, or None where they are too tangled.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) and (n,)
    touch
        Ends nearer than this touch.
    reach
        A loose end nearer than this to another line was meant to touch it.
    """
    count = len(bulge)
    if count == 0:
        return None
    boxes = np.empty((count, 4))
    _boxes(ends, bulge, boxes)
    low = boxes[:, :2].min(axis=0) - 2.0 * reach
    high = boxes[:, 2:].max(axis=0) + 2.0 * reach
    # A speck far away must not put all the rest into one cell: what lies outside counts to the rim.
    near, far = np.percentile(boxes[:, :2], (2.0, 98.0), axis=0)
    near, far = near - (far - near), far + (far - near)
    low, high = np.maximum(low, near), np.maximum(np.minimum(high, far), low)
    side = max(1, math.isqrt(count))
    while True:
        size = np.maximum((high - low) / side, 4.0 * touch)
        cells, total = _counted(ends, bulge, boxes, low, size, side, touch, 8 * count + 4096)
        if total >= 0:
            break
        if side == 1:
            return None
        side = max(1, side // 2)
    grid = Grid(low, size, side, *_filled(ends, bulge, boxes, low, size, side, touch, cells))
    if (np.diff(grid.first).astype(np.int64) ** 2).sum() > _WORK * count + 1_000_000:
        return None
    made: Any = _net(
        ends, bulge, touch, reach, low, size, side, grid.first, grid.listed, 64 * count + 4096
    )
    return None if len(made[0]) == 0 else Net(grid, *made)


@njit(cache=True, error_model="numpy")
def _boxes(ends: Any, bulge: Any, boxes: Any) -> None:
    for i in range(len(bulge)):
        ax, ay, bx, by = ends[i, 0, 0], ends[i, 0, 1], ends[i, 1, 0], ends[i, 1, 1]
        boxes[i, 0], boxes[i, 2] = min(ax, bx), max(ax, bx)
        boxes[i, 1], boxes[i, 3] = min(ay, by), max(ay, by)
        b = bulge[i]
        if abs(b) > _BULGE:
            # The box of the chord and its sagitta on either side holds the arc, up to half a turn.
            sagitta = 0.5 * abs(b) * math.hypot(bx - ax, by - ay)
            boxes[i, 0] -= sagitta
            boxes[i, 1] -= sagitta
            boxes[i, 2] += sagitta
            boxes[i, 3] += sagitta


@njit(cache=True, error_model="numpy")
def _cell(value: float, low: float, size: float, side: int) -> int:
    return min(max(int((value - low) / size), 0), side - 1)


@njit(cache=True, error_model="numpy")
def _rows(
    ends: Any, bulge: Any, boxes: Any, i: int, left: float, right: float, pad: float
) -> tuple[float, float]:
    """Between which y a segment runs in a column of cells."""
    if abs(bulge[i]) > _BULGE:
        return boxes[i, 1] - pad, boxes[i, 3] + pad
    ax, ay, bx, by = ends[i, 0, 0], ends[i, 0, 1], ends[i, 1, 0], ends[i, 1, 1]
    if ax > bx:
        ax, ay, bx, by = bx, by, ax, ay
    if bx - ax <= right - left:
        return min(ay, by) - pad, max(ay, by) + pad
    slope = (by - ay) / (bx - ax)
    y0 = ay + slope * (max(ax, left - pad) - ax)
    y1 = ay + slope * (min(bx, right + pad) - ax)
    return min(y0, y1) - pad, max(y0, y1) + pad


@njit(cache=True, error_model="numpy")
def _counted(
    ends: Any, bulge: Any, boxes: Any, low: Any, size: Any, side: int, pad: float, most: int
) -> Any:
    count = np.zeros(side * side + 1, np.int32)
    total = 0
    for i in range(len(bulge)):
        c0 = _cell(boxes[i, 0] - pad, low[0], size[0], side)
        c1 = _cell(boxes[i, 2] + pad, low[0], size[0], side)
        for c in range(c0, c1 + 1):
            left = low[0] + c * size[0]
            y0, y1 = _rows(ends, bulge, boxes, i, left, left + size[0], pad)
            r0 = _cell(y0, low[1], size[1], side)
            r1 = _cell(y1, low[1], size[1], side)
            for r in range(r0, r1 + 1):
                count[r * side + c + 1] += 1
            total += r1 - r0 + 1
        if total > most:
            return count, -1
    return count, total


@njit(cache=True, error_model="numpy")
def _filled(
    ends: Any, bulge: Any, boxes: Any, low: Any, size: Any, side: int, pad: float, count: Any
) -> Any:
    first = np.cumsum(count).astype(np.int32)
    listed = np.empty(first[-1], np.int32)
    put = first[:-1].copy()
    for i in range(len(bulge)):
        c0 = _cell(boxes[i, 0] - pad, low[0], size[0], side)
        c1 = _cell(boxes[i, 2] + pad, low[0], size[0], side)
        for c in range(c0, c1 + 1):
            left = low[0] + c * size[0]
            y0, y1 = _rows(ends, bulge, boxes, i, left, left + size[0], pad)
            r0 = _cell(y0, low[1], size[1], side)
            r1 = _cell(y1, low[1], size[1], side)
            for r in range(r0, r1 + 1):
                listed[put[r * side + c]] = i
                put[r * side + c] += 1
    return first, listed


@njit(cache=True, error_model="numpy")
def _near(ends: Any, bulge: Any, i: int, x: float, y: float) -> tuple[float, float]:
    """Distance from a point to a segment, and at which share of it that is."""
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    dx, dy = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay
    b = bulge[i]
    square = dx * dx + dy * dy
    if square == 0.0:
        return math.hypot(x - ax, y - ay), 0.0
    if abs(b) <= _BULGE:
        share = min(max(((x - ax) * dx + (y - ay) * dy) / square, 0.0), 1.0)
        return math.hypot(x - ax - share * dx, y - ay - share * dy), share
    sweep = 4.0 * math.atan(b)
    up = (1.0 - b * b) / (4.0 * b)
    cx = ax + 0.5 * dx - up * dy
    cy = ay + 0.5 * dy + up * dx
    radius = math.hypot(ax - cx, ay - cy)
    turn = math.atan2(y - cy, x - cx) - math.atan2(ay - cy, ax - cx)
    if sweep < 0.0:
        turn = -turn
    turn %= 2.0 * math.pi
    if turn <= abs(sweep):
        return abs(math.hypot(x - cx, y - cy) - radius), turn / abs(sweep)
    from_start = math.hypot(x - ax, y - ay)
    from_end = math.hypot(x - ax - dx, y - ay - dy)
    if from_start <= from_end:
        return from_start, 0.0
    return from_end, 1.0


@njit(cache=True, error_model="numpy")
def point_at(ends: Any, bulge: Any, i: int, share: float) -> tuple[float, float]:
    """The point at a share of a segment."""
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    dx, dy = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay
    b = bulge[i]
    if abs(b) <= _BULGE:
        return ax + share * dx, ay + share * dy
    up = (1.0 - b * b) / (4.0 * b)
    cx = ax + 0.5 * dx - up * dy
    cy = ay + 0.5 * dy + up * dx
    angle = 4.0 * math.atan(b) * share
    c, s = math.cos(angle), math.sin(angle)
    return cx + c * (ax - cx) - s * (ay - cy), cy + s * (ax - cx) + c * (ay - cy)


@njit(cache=True, error_model="numpy")
def _leaves(ends: Any, bulge: Any, half: int) -> tuple[float, float]:
    """The direction in which a segment goes on beyond its end number ``half`` % 2."""
    i = half // 2
    dx, dy = ends[i, 1, 0] - ends[i, 0, 0], ends[i, 1, 1] - ends[i, 0, 1]
    if half % 2 == 0:
        dx, dy = -dx, -dy
    angle = 2.0 * math.atan(bulge[i]) * (1.0 if half % 2 == 1 else -1.0)
    c, s = math.cos(angle), math.sin(angle)
    long = math.hypot(dx, dy)
    if long == 0.0:
        return 0.0, 0.0
    return (c * dx - s * dy) / long, (s * dx + c * dy) / long


@njit(cache=True, error_model="numpy")
def _hashed(cx: int, cy: int, mask: int) -> Any:
    key = np.uint64(cx) * np.uint64(0x9E3779B97F4A7C15) ^ np.uint64(cy) * np.uint64(
        0xC2B2AE3D27D4EB4F
    )
    return np.int64((key ^ (key >> np.uint64(31))) & np.uint64(mask))


@njit(cache=True, error_model="numpy")
def _placed(
    x: float, y: float, touch: float, place: Any, count: int, head: Any, onward: Any, mask: int
) -> int:
    """The number of the place at a point: one that is known, or ``count`` for a new one."""
    cell = 16.0 * touch
    fx, fy = x / cell, y / cell
    cx, cy = math.floor(fx), math.floor(fy)
    edge = 1.0 / 16.0
    x0 = -1 if fx - cx <= edge else 0
    x1 = 1 if fx - cx >= 1.0 - edge else 0
    y0 = -1 if fy - cy <= edge else 0
    y1 = 1 if fy - cy >= 1.0 - edge else 0
    for dx in range(x0, x1 + 1):
        for dy in range(y0, y1 + 1):
            at = head[_hashed(cx + dx, cy + dy, mask)]
            while at >= 0:
                ox = place[at, 0] - x
                oy = place[at, 1] - y
                if ox * ox + oy * oy <= touch * touch:
                    known: int = at
                    return known
                at = onward[at]
    own = _hashed(cx, cy, mask)
    place[count, 0] = x
    place[count, 1] = y
    onward[count] = head[own]
    head[own] = count
    return count


@njit(cache=True, error_model="numpy")
def _longer(column: Any) -> Any:
    more = np.empty(2 * len(column) + 16, column.dtype)
    more[: len(column)] = column
    return more


@njit(cache=True, error_model="numpy")
def _dash_links(
    ends: Any,
    bulge: Any,
    node: Any,
    twin: Any,
    loose: Any,
    touch: float,
    unit: float,
    low: Any,
    size: Any,
    side: int,
    first: Any,
    listed: Any,
    link: Any,
) -> None:
    """Write to ``link`` which loose end each loose end looks at across a gap, -1 for none."""
    for half in range(2 * len(bulge)):
        link[half] = -1
        i = half // 2
        if not loose[node[half]] or abs(bulge[i]) > _BULGE or twin[i] != i:
            continue
        long = math.hypot(ends[i, 1, 0] - ends[i, 0, 0], ends[i, 1, 1] - ends[i, 0, 1])
        if long > 40.0 * unit or long <= touch:
            continue
        far = min(15.0 * unit, max(2.0 * long, 3.0 * unit))
        ux, uy = _leaves(ends, bulge, half)
        x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
        c0 = _cell(min(x, x + far * ux) - touch, low[0], size[0], side)
        c1 = _cell(max(x, x + far * ux) + touch, low[0], size[0], side)
        r0 = _cell(min(y, y + far * uy) - touch, low[1], size[1], side)
        r1 = _cell(max(y, y + far * uy) + touch, low[1], size[1], side)
        best = far
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                for k in range(first[r * side + c], first[r * side + c + 1]):
                    j = listed[k]
                    if j == i or abs(bulge[j]) > _BULGE or twin[j] != j:
                        continue
                    for tip in range(2):
                        other = 2 * j + tip
                        if not loose[node[other]]:
                            continue
                        ox, oy = ends[j, tip, 0] - x, ends[j, tip, 1] - y
                        ahead = ox * ux + oy * uy
                        if ahead <= touch or ahead >= best or abs(ox * uy - oy * ux) > 2.0 * touch:
                            continue
                        vx, vy = _leaves(ends, bulge, other)
                        if ux * vx + uy * vy < -0.999:
                            best = ahead
                            link[half] = other


@njit(cache=True, error_model="numpy")
def _alike(start: Any, end: Any, bent: Any, place: Any, touch: float, mask: int) -> Any:
    """The first of the lines between two places that each line lies on."""
    count = len(start)
    same = np.empty(count, np.int32)
    heads = np.full(mask + 1, -1, np.int32)
    behind = np.empty(count, np.int32)
    for p in range(count):
        a, b, bend = start[p], end[p], bent[p]
        if a > b:
            a, b, bend = b, a, -bend
        slot = _hashed(a, b, mask)
        at = heads[slot]
        same[p] = p
        chord = math.hypot(place[a, 0] - place[b, 0], place[a, 1] - place[b, 1])
        while at >= 0:
            other = bent[at] if start[at] == a else -bent[at]
            alike = (start[at] == a and end[at] == b) or (start[at] == b and end[at] == a)
            if alike and 0.5 * abs(other - bend) * chord <= 2.0 * touch:
                same[p] = at
                break
            at = behind[at]
        if same[p] == p:
            behind[p] = heads[slot]
            heads[slot] = p
    return same


@njit(cache=True, error_model="numpy")
def _net(
    ends: Any,
    bulge: Any,
    touch: float,
    reach: float,
    low: Any,
    size: Any,
    side: int,
    first: Any,
    listed: Any,
    most: int,
) -> Any:
    n = len(bulge)
    mask = 1
    while mask < 4 * n + 16:
        mask *= 2
    head = np.full(mask, -1, np.int32)
    mask -= 1
    room = 2 * n + 1024
    place = np.empty((room, 2))
    onward = np.empty(room, np.int32)
    places = 0
    node = np.empty(2 * n, np.int32)
    for half in range(2 * n):
        x, y = ends[half // 2, half % 2, 0], ends[half // 2, half % 2, 1]
        at = _placed(x, y, touch, place, places, head, onward, mask)
        node[half] = at
        if at == places:
            places += 1
    whole = places
    twin = _alike(node[::2].copy(), node[1::2].copy(), bulge, place, touch, mask)
    # Where edges are parted: row, share, place.
    row = np.empty(n + 16, np.int32)
    share = np.empty(n + 16)
    cut = np.empty(n + 16, np.int32)
    cuts = 0
    degree = np.zeros(room, np.int32)
    for half in range(2 * n):
        if twin[half // 2] == half // 2:
            degree[node[half]] += 1
    for at in range(whole):
        x, y = place[at, 0], place[at, 1]
        cell = _cell(y, low[1], size[1], side) * side + _cell(x, low[0], size[0], side)
        for k in range(first[cell], first[cell + 1]):
            i = listed[k]
            if node[2 * i] == at or node[2 * i + 1] == at:
                continue
            away, part = _near(ends, bulge, i, x, y)
            if away <= touch and 0.0 < part < 1.0:
                if cuts == len(row):
                    row, share, cut = _longer(row), _longer(share), _longer(cut)
                row[cuts], share[cuts], cut[cuts] = i, part, at
                cuts += 1
                degree[at] += 2
    # Lines that cross each other between their ends.
    for cell in range(side * side):
        left = low[0] + (cell % side) * size[0]
        floor = low[1] + (cell // side) * size[1]
        for k in range(first[cell], first[cell + 1]):
            i = listed[k]
            if abs(bulge[i]) > _BULGE:
                continue
            ax, ay = ends[i, 0, 0], ends[i, 0, 1]
            ux, uy = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay
            for m in range(k + 1, first[cell + 1]):
                j = listed[m]
                if abs(bulge[j]) > _BULGE:
                    continue
                vx, vy = ends[j, 1, 0] - ends[j, 0, 0], ends[j, 1, 1] - ends[j, 0, 1]
                cross = ux * vy - uy * vx
                if cross == 0.0:
                    continue
                ox, oy = ends[j, 0, 0] - ax, ends[j, 0, 1] - ay
                s = (ox * vy - oy * vx) / cross
                t = (ox * uy - oy * ux) / cross
                if not (0.0 < s < 1.0 and 0.0 < t < 1.0):
                    continue
                a, b = math.hypot(ux, uy), math.hypot(vx, vy)
                if min(s, 1.0 - s) * a <= touch or min(t, 1.0 - t) * b <= touch:
                    continue
                x, y = ax + s * ux, ay + s * uy
                if not (left <= x < left + size[0] and floor <= y < floor + size[1]):
                    continue
                if places + 1 >= room:
                    bigger = np.empty((2 * room, 2))
                    bigger[:room] = place
                    place, onward, degree = bigger, _longer(onward), _longer(degree)
                    degree[room:] = 0
                    room = 2 * room
                at = _placed(x, y, touch, place, places, head, onward, mask)
                if at == places:
                    places += 1
                for which in range(2):
                    if cuts == len(row):
                        row, share, cut = _longer(row), _longer(share), _longer(cut)
                    row[cuts] = i if which == 0 else j
                    share[cuts] = s if which == 0 else t
                    cut[cuts] = at
                    cuts += 1
                degree[at] += 4
        if cuts > most:
            return (
                np.empty((0, 2)), node, node, share, node, share, node, node,
                np.zeros(0, np.bool_),
            )  # fmt: skip
    # Loose ends that stop just short of something.
    loose = np.zeros(room, np.bool_)
    for at in range(whole):
        loose[at] = degree[at] == 1
    tie = np.empty((64, 2), np.int32)
    ties = 0
    gap_of = np.full(2 * n, reach)
    link = np.empty(2 * n, np.int64)
    unit = touch / 0.05
    _dash_links(ends, bulge, node, twin, loose, touch, unit, low, size, side, first, listed, link)
    dashed = np.zeros(n, np.bool_)
    seen = np.zeros(n, np.bool_)
    chain = np.empty(n, np.int64)
    for half in range(2 * n):
        # A row begins with an edge that looks back at nothing.
        back = half ^ 1
        if seen[half // 2] or link[half] < 0 or link[link[half]] != half:
            continue
        if link[back] >= 0 and link[link[back]] == back:
            continue
        count = 0
        least, widest, shortest, longest = np.inf, 0.0, np.inf, 0.0
        tail = half
        while True:
            chain[count] = tail
            count += 1
            i = tail // 2
            seen[i] = True
            long = math.hypot(ends[i, 1, 0] - ends[i, 0, 0], ends[i, 1, 1] - ends[i, 0, 1])
            longest = max(longest, long)
            other = link[tail]
            if other < 0 or link[other] != tail or seen[other // 2]:
                break
            if count > 1:
                shortest = min(shortest, long)
            gap = math.hypot(
                ends[i, tail % 2, 0] - ends[other // 2, other % 2, 0],
                ends[i, tail % 2, 1] - ends[other // 2, other % 2, 1],
            )
            least, widest = min(least, gap), max(widest, gap)
            tail = other ^ 1
        if count < 3 or widest > 1.5 * least + 2.0 * touch or longest > 2.5 * shortest:
            continue
        for k in range(count):
            dashed[chain[k] // 2] = True
            if k:
                if ties == len(tie):
                    more = np.empty((2 * ties, 2), np.int32)
                    more[:ties] = tie
                    tie = more
                tie[ties, 0] = node[chain[k - 1]]
                tie[ties, 1] = node[chain[k] ^ 1]
                ties += 1
                loose[node[chain[k - 1]]] = False
                loose[node[chain[k] ^ 1]] = False
        gap_of[chain[0] ^ 1] = max(reach, 1.25 * widest)
        gap_of[chain[count - 1]] = max(reach, 1.25 * widest)
    for i in range(n):
        dashed[i] = dashed[twin[i]]
    for half in range(2 * n):
        i = half // 2
        if not loose[node[half]] or twin[i] != i:
            continue
        x, y = ends[i, half % 2, 0], ends[i, half % 2, 1]
        ux, uy = _leaves(ends, bulge, half)
        far = gap_of[half]
        c0, c1 = _cell(x - far, low[0], size[0], side), _cell(x + far, low[0], size[0], side)
        r0, r1 = _cell(y - far, low[1], size[1], side), _cell(y + far, low[1], size[1], side)
        best, partner, where = far, -1, 0.0
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                for k in range(first[r * side + c], first[r * side + c + 1]):
                    j = listed[k]
                    if twin[j] == i:
                        continue
                    away, part = _near(ends, bulge, j, x, y)
                    if away < best:
                        px, py = point_at(ends, bulge, j, part)
                        if (px - x) * ux + (py - y) * uy >= 0.5 * away:
                            best, partner, where = away, j, part
        if partner < 0:
            continue
        long = math.hypot(
            ends[partner, 1, 0] - ends[partner, 0, 0], ends[partner, 1, 1] - ends[partner, 0, 1]
        )
        if where * long <= touch:
            at = node[2 * partner]
        elif (1.0 - where) * long <= touch:
            at = node[2 * partner + 1]
        else:
            px, py = point_at(ends, bulge, partner, where)
            if places + 1 >= room:
                bigger = np.empty((2 * room, 2))
                bigger[:room] = place
                place, onward = bigger, _longer(onward)
                wider = np.zeros(2 * room, np.bool_)
                wider[:room] = loose
                loose = wider
                room = 2 * room
            at = _placed(px, py, touch, place, places, head, onward, mask)
            if at == places:
                places += 1
            if cuts == len(row):
                row, share, cut = _longer(row), _longer(share), _longer(cut)
            row[cuts], share[cuts], cut[cuts] = partner, where, at
            cuts += 1
        if at != node[half]:
            if ties == len(tie):
                wide = np.empty((2 * ties, 2), np.int32)
                wide[:ties] = tie
                tie = wide
            tie[ties, 0] = node[half]
            tie[ties, 1] = at
            ties += 1
    # A link is parted by the lines that run through the gap that it closes.
    k = 0
    while k < ties:
        ax, ay = place[tie[k, 0], 0], place[tie[k, 0], 1]
        ux, uy = place[tie[k, 1], 0] - ax, place[tie[k, 1], 1] - ay
        c0 = _cell(min(ax, ax + ux), low[0], size[0], side)
        c1 = _cell(max(ax, ax + ux), low[0], size[0], side)
        r0 = _cell(min(ay, ay + uy), low[1], size[1], side)
        r1 = _cell(max(ay, ay + uy), low[1], size[1], side)
        least, through, where = 1.0, -1, 0.0
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                for m in range(first[r * side + c], first[r * side + c + 1]):
                    j = listed[m]
                    if abs(bulge[j]) > _BULGE or twin[j] != j:
                        continue
                    vx, vy = ends[j, 1, 0] - ends[j, 0, 0], ends[j, 1, 1] - ends[j, 0, 1]
                    cross = ux * vy - uy * vx
                    if cross == 0.0:
                        continue
                    ox, oy = ends[j, 0, 0] - ax, ends[j, 0, 1] - ay
                    s = (ox * vy - oy * vx) / cross
                    t = (ox * uy - oy * ux) / cross
                    if not (0.0 < s < least and 0.0 < t < 1.0):
                        continue
                    long = math.hypot(vx, vy)
                    if min(s, 1.0 - s) * math.hypot(ux, uy) <= touch:
                        continue
                    if min(t, 1.0 - t) * long > touch:
                        least, through, where = s, j, t
        if through >= 0:
            if places + 1 >= room:
                bigger = np.empty((2 * room, 2))
                bigger[:room] = place
                place, onward = bigger, _longer(onward)
                room = 2 * room
            at = _placed(ax + least * ux, ay + least * uy, touch, place, places, head, onward, mask)
            if at == places:
                places += 1
            if cuts == len(row):
                row, share, cut = _longer(row), _longer(share), _longer(cut)
            row[cuts], share[cuts], cut[cuts] = through, where, at
            cuts += 1
            if at != tie[k, 0] and at != tie[k, 1]:
                if ties == len(tie):
                    more_ = np.empty((2 * ties, 2), np.int32)
                    more_[:ties] = tie
                    tie = more_
                tie[ties, 0], tie[ties, 1] = at, tie[k, 1]
                tie[k, 1] = at
                ties += 1
        k += 1
    # The parts of each edge in their order.
    begins = np.zeros(n + 1, np.int32)
    for k in range(cuts):
        begins[row[k] + 1] += 1
    begins = np.cumsum(begins).astype(np.int32)
    ordered = np.empty(cuts, np.int32)
    put = begins[:-1].copy()
    for k in range(cuts):
        at = put[row[k]]
        put[row[k]] += 1
        while at > begins[row[k]] and share[ordered[at - 1]] > share[k]:
            ordered[at] = ordered[at - 1]
            at -= 1
        ordered[at] = k
    total = n + cuts + ties
    start = np.empty(total, np.int32)
    end = np.empty(total, np.int32)
    bent = np.empty(total)
    edge = np.empty(total, np.int32)
    begin = np.empty(total)
    first_piece = np.empty(n + 1, np.int32)
    pieces = 0
    for i in range(n):
        first_piece[i] = pieces
        here, last = node[2 * i], 0.0
        for k in range(begins[i], begins[i + 1] + 1):
            there, to = node[2 * i + 1], 1.0
            if k < begins[i + 1]:
                there, to = cut[ordered[k]], share[ordered[k]]
            # What returns to the place that it comes from, unless round a bend, is a speck.
            round_ = abs(bulge[i]) > _BULGE and to - last > 0.5
            if there == here and not round_:
                continue
            start[pieces], end[pieces], edge[pieces], begin[pieces] = here, there, i, last
            bent[pieces] = math.tan(math.atan(bulge[i]) * (to - last))
            pieces += 1
            here, last = there, to
    first_piece[n] = pieces
    for k in range(ties):
        start[pieces], end[pieces], edge[pieces] = tie[k, 0], tie[k, 1], -1
        bent[pieces], begin[pieces] = 0.0, 0.0
        pieces += 1
    same = _alike(start[:pieces], end[:pieces], bent[:pieces], place, touch, mask)
    return (
        place[:places].copy(),
        start[:pieces].copy(),
        end[:pieces].copy(),
        bent[:pieces].copy(),
        edge[:pieces].copy(),
        begin[:pieces].copy(),
        first_piece,
        same,
        dashed,
    )
