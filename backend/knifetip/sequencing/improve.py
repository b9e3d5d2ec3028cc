"""improve: a tour made shorter, link by link.

    a tour of tracks, what its links take, neighbours -> the same tracks in a shorter order

2-opt and Or-opt until neither finds anything, then segments swapped at random and mended again.

Source: Croes 1958 (2-opt), Or 1976, Martin, Otto & Felten 1991 (swap and mend); the rest is ours.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.kernels import (
    F64_2,
    F64_4A,
    I32_1,
    I32_2,
    U8_1,
    OutBool_1,
    OutI32_1,
    OutI64_1,
    OutU8_1,
    kernel,
)

#: Longest run that is reversed where every link in it must be measured anew.
_RUN: Final = 50


@kernel
def _link(a: int, side_a: int, b: int, side_b: int, ends: F64_4A, rates: F64_2) -> float:
    """Return the time from the end of track a to the start of track b (s)."""
    x = abs(ends[side_b, 0, b, 0] - ends[side_a, 1, a, 0])
    y = abs(ends[side_b, 0, b, 1] - ends[side_a, 1, a, 1])
    c = abs(ends[side_b, 0, b, 2] - ends[side_a, 1, a, 2])
    c = min(c, rates[3, 0] - c)
    slowest = 0.0
    for axis, way in ((0, x), (1, y), (2, c)):
        if way < rates[axis, 0]:
            time = math.sqrt(way * rates[axis, 1])
        else:
            time = way * rates[axis, 2] + rates[axis, 3]
        slowest = max(slowest, time)
    return slowest


@kernel
def _between(
    i: int, turn_i: int, j: int, turn_j: int, tour: I32_1, side: U8_1, ends: F64_4A, rates: F64_2
) -> float:
    """Return the time from place i to place j of the tour, each turned or not; 0 past its end."""
    if j >= len(tour):
        return 0.0
    return _link(tour[i], side[i] ^ turn_i, tour[j], side[j] ^ turn_j, ends, rates)


@kernel
def _inside(
    i: int, j: int, turn: int, tour: I32_1, side: U8_1, ends: F64_4A, rates: F64_2
) -> float:
    """Return what reversing the places i … j adds to the links inside."""
    if turn:
        return 0.0
    more = 0.0
    for place in range(i, j):
        more += _between(place + 1, 0, place, 0, tour, side, ends, rates)
        more -= _between(place, 0, place + 1, 0, tour, side, ends, rates)
    return more


@kernel
def _reverse_gain(
    i: int, j: int, turn: int, tour: I32_1, side: U8_1, ends: F64_4A, rates: F64_2
) -> float:
    """Return what reversing the places i … j adds to the whole."""
    if i < 1 or (not turn and j - i > _RUN):
        return 0.0
    more = _between(i - 1, 0, j, turn, tour, side, ends, rates)
    more -= _between(i - 1, 0, i, 0, tour, side, ends, rates)
    if j + 1 < len(tour):
        more += _between(i, turn, j + 1, 0, tour, side, ends, rates)
        more -= _between(j, 0, j + 1, 0, tour, side, ends, rates)
    # What is lost at the ends is hardly ever won inside, and costs a look at every link.
    if more >= 0.0:
        return more
    return more + _inside(i, j, turn, tour, side, ends, rates)


@kernel
def _freed(s: int, e: int, tour: I32_1, side: U8_1, ends: F64_4A, rates: F64_2) -> float:
    """Return what taking the places s … e out saves; 0 where that cannot be."""
    if s < 1 or e >= len(tour):
        return 0.0
    saved = _between(s - 1, 0, s, 0, tour, side, ends, rates)
    saved += _between(e, 0, e + 1, 0, tour, side, ends, rates)
    return saved - _between(s - 1, 0, e + 1, 0, tour, side, ends, rates)


@kernel
def _reverse(i: int, j: int, turn: int, tour: OutI32_1, side: OutU8_1, where: OutI64_1) -> None:
    low, high = i, j
    while low < high:
        tour[low], tour[high] = tour[high], tour[low]
        side[low], side[high] = side[high], side[low]
        low += 1
        high -= 1
    for place in range(i, j + 1):
        side[place] ^= turn
        where[tour[place]] = place


@kernel
def _swap(s: int, m: int, e: int, tour: OutI32_1, side: OutU8_1, where: OutI64_1) -> None:
    """Put the places m … e before the places s … m - 1."""
    _reverse(s, m - 1, 0, tour, side, where)
    _reverse(m, e, 0, tour, side, where)
    _reverse(s, e, 0, tour, side, where)


@kernel
def _better(
    track: int,
    tour: OutI32_1,
    side: OutU8_1,
    where: OutI64_1,
    ends: F64_4A,
    rates: F64_2,
    way: int,
    near: I32_2,
    floor: F64_2,
) -> Any:
    """Make the first change for the better around a track.

    Returns the first and last place that changed, and by how much; (0, -1, 0) for none.
    """
    last = len(tour) - 1
    mirrored = 1 if way == 1 else 0
    i = where[track]
    if way == 2:
        more = _between(i - 1, 0, i, 1, tour, side, ends, rates)
        more -= _between(i - 1, 0, i, 0, tour, side, ends, rates)
        if i < last:
            more += _between(i, 1, i + 1, 0, tour, side, ends, rates)
            more -= _between(i, 0, i + 1, 0, tour, side, ends, rates)
        if more < -1e-9:
            side[i] ^= 1
            return i, i, more
    # A change is found from the end where it puts a shorter link for a longer one.
    longest = _between(i - 1, 0, i, 0, tour, side, ends, rates)
    longest = max(longest, _between(i, 0, i + 1, 0, tour, side, ends, rates))
    freed = np.empty(6)
    for place in range(6):
        s = i if place % 2 else i - place // 2
        freed[place] = _freed(s, s + place // 2, tour, side, ends, rates) if place != 1 else 0.0
    for rank in range(near.shape[1]):
        if floor[track, rank] >= longest:
            break
        other = near[track, rank]
        j = where[other]
        low, high = min(i, j), max(i, j)
        more = _reverse_gain(low + 1, high, mirrored, tour, side, ends, rates)
        if more < -1e-9:
            _reverse(low + 1, high, mirrored, tour, side, where)
            return low + 1, high, more
        more = _reverse_gain(low, high - 1, mirrored, tour, side, ends, rates)
        if more < -1e-9:
            _reverse(low, high - 1, mirrored, tour, side, where)
            return low, high - 1, more
        for place in range(6):
            # Runs of one to three that begin at the track, or end at it.
            size, ahead = place // 2 + 1, place % 2
            s = i if ahead else i - size + 1
            e = s + size - 1
            if freed[place] <= 1e-9 or s <= j <= e:
                continue
            # After the neighbour or before it, and turned so that the two are joined.
            for before in range(2):
                k = j - before
                back = before if ahead else 1 - before
                if size == 1:
                    back = 0
                if k < 0 or s - 1 <= k <= e:
                    continue
                for _ in range(2 if size == 1 and way != 0 else 1):
                    turn = back if (mirrored or size == 1) else 0
                    head, tail = (e, s) if back else (s, e)
                    more = _between(k, 0, head, turn, tour, side, ends, rates)
                    more -= _between(k, 0, k + 1, 0, tour, side, ends, rates) + freed[place]
                    if more < -1e-9 and k < last:
                        more += _between(tail, turn, k + 1, 0, tour, side, ends, rates)
                    if more < -1e-9 and back and not turn:
                        more += _inside(s, e, 0, tour, side, ends, rates)
                    if more < -1e-9:
                        if back:
                            _reverse(s, e, turn, tour, side, where)
                        if k > e:
                            _swap(s, e + 1, k, tour, side, where)
                            return s, k, more
                        _swap(k + 1, s, e, tour, side, where)
                        return k + 1, e, more
                    back = 1
    return 0, -1, 0.0


@kernel(checks_division=True)
def _settle(
    queue: OutI32_1,
    waiting: OutBool_1,
    head: int,
    size: int,
    most: int,
    tour: OutI32_1,
    side: OutU8_1,
    where: OutI64_1,
    ends: F64_4A,
    rates: F64_2,
    way: int,
    near: I32_2,
    floor: F64_2,
) -> Any:
    """Better the tracks in the queue, and those beside a change, until nothing more is found."""
    count = len(queue)
    gained = 0.0
    low, high = len(tour), 0
    while size > 0:
        track = queue[head]
        head = (head + 1) % count
        size -= 1
        waiting[track] = False
        while most > 0:
            first, last, more = _better(track, tour, side, where, ends, rates, way, near, floor)
            if last < first:
                break
            most -= 1
            gained += more
            low, high = min(low, first), max(high, last)
            for place in (first - 1, first, last, last + 1):
                if 1 <= place < len(tour):
                    other = tour[place]
                    if other != track and not waiting[other]:
                        waiting[other] = True
                        queue[(head + size) % count] = other
                        size += 1
    return gained, low, high


@kernel(checks_division=True)
def improve(
    tour: OutI32_1,
    side: OutU8_1,
    ends: F64_4A,
    rates: F64_2,
    way: int,
    near: I32_2,
    floor: F64_2,
    trials: int,
) -> None:
    """Shorten the tour in place: 2-opt and Or-opt, then swaps of near segments, mended."""
    last = len(tour) - 1
    where = np.empty(len(tour), np.int64)
    for place in range(len(tour)):
        where[tour[place]] = place
    queue = tour[1:].copy()
    waiting = np.ones(last, np.bool_)
    _settle(queue, waiting, 0, last, 100 * last, tour, side, where, ends, rates, way, near, floor)
    kept, kept_side = tour.copy(), side.copy()
    state = 12345
    for _ in range(trials if last >= 3 else 0):
        cut = np.empty(3, np.int64)
        span = min(last, 40)
        state = (state * 1103515245 + 12345) & 0x7FFFFFFF
        base = 1 + (state >> 8) % (last - span + 1)
        for place in range(3):
            state = (state * 1103515245 + 12345) & 0x7FFFFFFF
            cut[place] = base + (state >> 8) % span
        cut.sort()
        s, m, e = cut[0], cut[1], cut[2]
        if s == m or m == e:
            continue
        # The places s … m - 1 and m … e - 1 change places.
        e -= 1
        gained = (
            _between(s - 1, 0, m, 0, tour, side, ends, rates)
            - _between(s - 1, 0, s, 0, tour, side, ends, rates)
            + _between(e, 0, s, 0, tour, side, ends, rates)
            - _between(m - 1, 0, m, 0, tour, side, ends, rates)
        )
        if e < last:
            gained += _between(m - 1, 0, e + 1, 0, tour, side, ends, rates)
            gained -= _between(e, 0, e + 1, 0, tour, side, ends, rates)
        size = 0
        for place in (s - 1, s, m - 1, m, e, e + 1):
            if 1 <= place <= last and not waiting[tour[place]]:
                waiting[tour[place]] = True
                queue[size] = tour[place]
                size += 1
        _swap(s, m, e, tour, side, where)
        more, low, high = _settle(
            queue, waiting, 0, size, 200, tour, side, where, ends, rates, way, near, floor
        )
        low, high = min(low, s), max(high, e)
        if gained + more < 0.0:
            kept[low : high + 1] = tour[low : high + 1]
            kept_side[low : high + 1] = side[low : high + 1]
        else:
            for place in range(low, high + 1):
                tour[place], side[place] = kept[place], kept_side[place]
                where[tour[place]] = place
