"""run: edges that go on in each other, made one: pieces of a line, of an arc, of a flattened curve.

    edges of line types -> fewer edges, and which of them each has become a part of

Only where the ends of exactly two edges meet, of one line type, they may become one: a place where,
or within ``GAP`` of which, a third one ends stays a place.  Lines become one line where every joint
is within ``JOIN`` of it, arcs that turn one way one arc.  What is drawn in segments shorter than
``FINE`` is a curve that somebody flattened: it becomes a line or an arc again, within ``FITTED``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.cleaning.meeting import Meetings
from knifetip.geometry import arc
from knifetip.geometry.chain import walked
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.tolerance import BULGE, GAP, JOIN, SAME
from knifetip.kernels import (
    F64_1,
    F64_2,
    I32_1,
    I64_1,
    I64_2,
    U8_1,
    Bool_1,
    OutBool_1,
    OutF64_1,
    OutI32_1,
    kernel,
)

#: Segments shorter than this are no edges that somebody drew, but a curve flattened (mm).
FINE: Final = GAP
#: A flattened curve stays within this of the line or arc that it becomes (mm).
FITTED: Final = SAME / 2.0
#: From so many segments on they are a curve.
_FEW: Final = 3


@dataclass(frozen=True, eq=False, slots=True)
class Joined:
    """m edges that k have become."""

    ends: F64  #: (m, 2, 2) mm
    bulge: F64  #: (m,)
    kind: U8  #: (m,) LineType
    of: I32  #: (k,) the edge that each has become a part of
    off: F64  #: (m,) how far its parts' ends are from it (mm)
    fitted: Bool  #: (m,) whether it was a flattened curve


def joined(ends: F64, bulge: F64, kind: U8, met: Meetings, *, curves_only: bool = False) -> Joined:
    """Return the edges with those that go on in each other made one.

    ``curves_only`` leaves alone what is not a flattened curve.
    An edge that becomes one with others runs in the direction of the first of them; the others are
    left as they are, bit for bit.
    """
    count = len(bulge)
    length = arc.length(ends[:, 0], ends[:, 1], bulge)
    fine = length < FINE
    link = _links(met.place, met.near, kind, fine, curves_only)
    order, flipped, first, round_ = walked(link)
    rows = np.column_stack([ends.reshape(-1, 4), bulge])
    begin, code, off = _cut_up(rows, length, order, flipped, first, round_, JOIN, FITTED, FINE)
    size = np.diff(np.append(begin, count))
    if (size == 1).all():
        every = np.arange(count, dtype=np.int32)
        return Joined(ends, bulge, kind, every, np.zeros(count), np.zeros(count, np.bool_))
    group = np.repeat(np.arange(len(begin)), size)
    least = np.minimum.reduceat(order, begin)
    rank = np.argsort(np.argsort(least, kind="stable"), kind="stable").astype(np.int32)
    several = size > 1
    head, tail = begin[several], (begin + size)[several] - 1
    start = ends[order[head], flipped[head].astype(np.int64)]
    finish = ends[order[tail], 1 - flipped[tail]]
    position = np.empty(count, np.int64)
    position[order] = np.arange(count)
    back = flipped[position[least[several]]]
    new_ends, new_bulge = ends[least].copy(), bulge[least].copy()
    new_ends[several, 0] = np.where(back[:, None], finish, start)
    new_ends[several, 1] = np.where(back[:, None], start, finish)
    new_bulge[several] = np.where(back, -code[several], code[several])
    where = np.argsort(rank)
    of = np.empty(count, np.int32)
    of[order] = rank[group]
    curve = np.bincount(group[fine[order]], minlength=len(begin)) >= _FEW
    return Joined(
        new_ends[where],
        new_bulge[where],
        kind[least][where],
        of,
        off[where],
        curve[where],
    )


@kernel
def _links(place: I64_1, near: I64_2, kind: U8_1, fine: Bool_1, curves_only: bool) -> Any:
    """Which end is joined to which: where two meet that are of one line type, and no third."""
    many = np.zeros(len(place), np.int64)
    short = np.zeros(len(place), np.bool_)
    for end in range(len(place)):
        many[place[end]] += 1
        short[place[end]] |= fine[end // 2]
    for k in range(len(near)):
        a, b = place[near[k, 0]], place[near[k, 1]]
        # Along a flattened curve every end is near others.
        if not short[a] and not short[b]:
            many[a] += 1
            many[b] += 1
    one = np.full(len(place), -1, np.int64)
    link = np.full(len(place), -1, np.int64)
    for end in range(len(place)):
        at = place[end]
        if many[at] != 2:
            continue
        other = one[at]
        if other < 0:
            one[at] = end
        elif (
            other // 2 != end // 2
            and kind[other // 2] == kind[end // 2]
            and (not curves_only or (fine[other // 2] and fine[end // 2]))
        ):
            link[other] = end
            link[end] = other
    return link


@kernel
def _turned(row: F64_1, back: bool, out: OutF64_1) -> None:
    if back:
        out[0], out[1], out[2], out[3], out[4] = row[2], row[3], row[0], row[1], -row[4]
    else:
        out[:] = row


@kernel
def _cut_up(
    rows: F64_2,
    length: F64_1,
    order: OutI32_1,
    flipped: OutBool_1,
    first: I32_1,
    closed: Bool_1,
    join: float,
    fitted: float,
    fine: float,
) -> Any:
    """Where in ``order``, which is turned to begin closed runs at a corner, groups begin that are
    one line or arc; with the bulge of each, and how far its parts are off."""
    count = len(order)
    begin = np.empty(count, np.int64)
    code = np.empty(count)
    off = np.zeros(count)
    run = np.empty((count, 5))
    size = np.empty(count)
    groups = 0
    for r in range(len(first) - 1):
        low, high = first[r], first[r + 1]
        many = high - low
        if many == 1:
            begin[groups] = low
            code[groups] = rows[order[low], 4]
            groups += 1
            continue
        for i in range(many):
            _turned(rows[order[low + i]], flipped[low + i], run[i])
        if closed[r]:
            shift = _sharpest(run, many)
            if shift:
                turned = np.roll(order[low:high], -shift)
                order[low:high] = turned
                again = np.roll(flipped[low:high].astype(np.int64), -shift)
                for i in range(many):
                    flipped[low + i] = again[i] == 1
                    _turned(rows[order[low + i]], flipped[low + i], run[i])
        for i in range(many):
            size[i] = length[order[low + i]]
        i = 0
        while i < many:
            j, b, far = _reach(run, size, i, many, join, fitted, fine)
            if i == 0 and j == many and closed[r]:
                # All round: leave what there is, for one edge cannot begin where it ends.
                for k in range(many):
                    begin[groups] = low + k
                    code[groups] = run[k, 4]
                    groups += 1
                break
            begin[groups] = low + i
            code[groups] = b
            off[groups] = far
            groups += 1
            i = j
    return begin[:groups].copy(), code[:groups].copy(), off[:groups].copy()


@kernel
def _sharpest(run: F64_2, many: int) -> int:
    """Which segment of a closed run begins at its sharpest corner; the first of several."""
    best = 0
    least = 2.0
    for i in range(many):
        before = run[i - 1] if i else run[many - 1]
        ax, ay = _direction(before, True)
        bx, by = _direction(run[i], False)
        cosine = ax * bx + ay * by
        if cosine < least - 1e-6:
            least = cosine
            best = i
    return best


@kernel
def _direction(row: F64_1, last: bool) -> tuple[float, float]:
    half = 2.0 * math.atan(row[4])
    if not last:
        half = -half
    dx, dy = row[2] - row[0], row[3] - row[1]
    size = math.hypot(dx, dy)
    c, s = math.cos(half) / size, math.sin(half) / size
    return dx * c - dy * s, dx * s + dy * c


@kernel
def _reach(
    run: F64_2, size: F64_1, i: int, many: int, join: float, fitted: float, fine: float
) -> tuple[int, float, float]:
    """How far one line or arc holds from segment i on, its bulge, and how far it is off."""
    best = i + 1
    bulge = run[i, 4]
    far = 0.0
    if i + 1 < many:
        if abs(bulge) < BULGE:
            end = _straight(run, i, many, join)
            if end > best:
                best, bulge, far = end, 0.0, _off(run, i, end, 0.0)
        else:
            turn = run[i, 4] > 0.0
            end = i + 1
            sum_ = math.atan(run[i, 4])
            code = 0.0
            while end < many and abs(run[end, 4]) >= BULGE and (run[end, 4] > 0.0) == turn:
                sum_ += math.atan(run[end, 4])
                if abs(sum_) > math.pi / 4.0 + 1e-9:
                    break
                code = math.tan(sum_)
                off = _off(run, i, end + 1, code)
                if off > join:
                    break
                end += 1
                best, bulge, far = end, code, off
    if size[i] < fine:
        limit = i
        while limit < many and size[limit] < fine:
            limit += 1
        if limit - i >= 3:
            end = _straight(run, i, limit, fitted)
            if end >= i + 3 and end > best:
                best, bulge, far = end, 0.0, _off(run, i, end, 0.0)
            end, code, off = _round(run, size, i, limit, fitted)
            if end >= i + 3 and end > best:
                best, bulge, far = end, code, off
    return best, bulge, far


@kernel
def _straight(run: F64_2, i: int, limit: int, within: float) -> int:
    """How far one line holds: its end must be seen from its start past every joint between."""
    x, y = run[i, 0], run[i, 1]
    low, high = -math.inf, math.inf
    base = math.atan2(run[i, 3] - y, run[i, 2] - x)
    reached = 0.0
    end = i
    best = i + 1
    while end < limit and abs(run[end, 4]) < BULGE:
        dx, dy = run[end, 2] - x, run[end, 3] - y
        far = math.hypot(dx, dy)
        if far <= reached:
            break
        way = math.atan2(dy, dx) - base
        way = (way + math.pi) % (2.0 * math.pi) - math.pi
        if abs(way) > 0.5 * math.pi:
            break
        end += 1
        if low <= way <= high:
            best = end
        slack = math.asin(within / far) if far > within else math.pi
        low = max(low, way - slack)
        high = min(high, way + slack)
        if low > high:
            break
        reached = far
    return best


@kernel
def _round(run: F64_2, size: F64_1, i: int, limit: int, within: float) -> tuple[int, float, float]:
    """How far one arc holds, by doubling and halving."""
    good, code, off = i, 0.0, 0.0
    step = 4
    bad = limit + 1
    while True:
        end = min(i + step, limit)
        b = _bow(run, size, i, end)
        far = _off(run, i, end, b) if abs(b) <= 1.0 else math.inf
        if far <= within:
            good, code, off = end, b, far
            if end == limit:
                return good, code, off
            step *= 2
        else:
            bad = end
            break
    low = good if good > i else i + 2
    while bad - low > 1:
        end = (low + bad) // 2
        b = _bow(run, size, i, end)
        far = _off(run, i, end, b) if abs(b) <= 1.0 else math.inf
        if far <= within:
            low, good, code, off = end, end, b, far
        else:
            bad = end
    return good, code, off


@kernel
def _bow(run: F64_2, size: F64_1, i: int, end: int) -> float:
    """The bulge of the arc from the start of segment i to that of ``end`` through the joint that
    is nearest to the middle."""
    total = 0.0
    for k in range(i, end):
        total += size[k]
    half = 0.0
    mid = i
    while mid < end - 2 and half + size[mid] < 0.5 * total:
        half += size[mid]
        mid += 1
    px, py = run[mid, 2], run[mid, 3]
    ax, ay = run[i, 0] - px, run[i, 1] - py
    bx, by = run[end - 1, 2] - px, run[end - 1, 3] - py
    # Seen from the joint the ends stand at π less half the sweep; to its left if it bulges right.
    angle = math.atan2(ax * by - ay * bx, ax * bx + ay * by)
    open_ = math.pi - abs(angle)
    bulge = math.tan(0.5 * open_)
    return -bulge if angle > 0.0 else bulge


@kernel
def _off(run: F64_2, i: int, end: int, bulge: float) -> float:
    """How far joints, and middles of segments, are from one line or arc; infinite where they do
    not follow it."""
    x0, y0, x1, y1 = run[i, 0], run[i, 1], run[end - 1, 2], run[end - 1, 3]
    dx, dy = x1 - x0, y1 - y0
    chord = math.hypot(dx, dy)
    if chord == 0.0:
        return math.inf
    worst = 0.0
    before = -1.0
    straight = abs(bulge) < 1e-7
    cx = cy = radius = sweep = 0.0
    mx = my = 0.0
    if not straight:
        lean = (1.0 - bulge * bulge) / (4.0 * bulge)
        cx = 0.5 * (x0 + x1) - lean * dy
        cy = 0.5 * (y0 + y1) + lean * dx
        radius = chord * (1.0 + bulge * bulge) / (4.0 * abs(bulge))
        sweep = 4.0 * math.atan(bulge)
        mx = 0.5 * (x0 + x1) + 0.5 * bulge * dy - cx
        my = 0.5 * (y0 + y1) - 0.5 * bulge * dx - cy
    for k in range(2 * i, 2 * end):
        s = k // 2
        if k % 2:
            x, y = run[s, 2], run[s, 3]
        else:
            b = run[s, 4]
            x = 0.5 * (run[s, 0] + run[s, 2]) + 0.5 * b * (run[s, 3] - run[s, 1])
            y = 0.5 * (run[s, 1] + run[s, 3]) - 0.5 * b * (run[s, 2] - run[s, 0])
        if straight:
            off = abs((x - x0) * dy - (y - y0) * dx) / chord
            place = ((x - x0) * dx + (y - y0) * dy) / (chord * chord)
        else:
            off = abs(math.hypot(x - cx, y - cy) - radius)
            px, py = x - cx, y - cy
            place = 0.5 + math.atan2(mx * py - my * px, mx * px + my * py) / sweep
        worst = max(worst, off)
        if place <= before or place < -1e-3 or place > 1.0 + 1e-3:
            return math.inf
        before = place
    return worst
