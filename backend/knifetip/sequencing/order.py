"""order: which track comes next, and from which end.

Nearest neighbour first; then 2-opt and Or-opt until neither finds anything, and segments swapped at
random and mended again, for a counted number of trials: never by the clock, so that the same tracks
always come in the same order.  What is made short is time: the axes' slowest on each link, C among
them.  The lift is the same for every link and so has no say.

Source: Croes 1958 (2-opt), Or 1976, Martin, Otto & Felten 1991 (swap and mend); the rest is ours.
"""

from __future__ import annotations

import math
from enum import IntEnum
from typing import Any, Final

import numpy as np
from numba import njit

from knifetip.geometry.columns import F64, I32, Bool

#: A track looks for a better place beside so many of its neighbours.
_NEIGHBOURS: Final = 6
#: Swaps that are tried per track, and in all.
_TRIALS: Final = 5
_MOST_TRIALS: Final = 3_000
#: Longest run that is reversed where every link in it must be measured anew.
_RUN: Final = 50


class Way(IntEnum):
    """How a track may be run."""

    ONE = 0  #: only from its start
    EITHER = 1  #: from either end, and back along the same poses
    SIDES = 2  #: from either end, and not along the same poses


def nearest_neighbour(start: F64, end: F64, origin: F64) -> I32:
    """Return the order of tracks, (t,), beginning with the one nearest to ``origin``.

    Parameters
    ----------
    start, end : (t, 2) mm
        Where the head begins and ends each track.
    origin : (2,) mm
    """
    order: I32 = _greedy(start, end, origin, len(start))
    return order


def greedy(entry: F64, leave: F64, origin: F64, way: Way) -> tuple[I32, Bool]:
    """Return the order that always goes to the nearest end, as ``shortest`` does."""
    count = entry.shape[1]
    if way == Way.ONE:
        order = nearest_neighbour(entry[0, :, :2], leave[0, :, :2], origin[:2])
        return order, np.zeros(count, np.bool_)
    ends = _greedy(
        entry[:, :, :2].reshape(-1, 2), leave[:, :, :2].reshape(-1, 2), origin[:2], count
    )
    return (ends % count).astype(np.int32), ends >= count


def shortest(
    entry: F64, leave: F64, origin: F64, pace: F64, period: float, way: Way
) -> tuple[I32, Bool]:
    """Return a short order of tracks, (t,), and which of them to run from their far end, (t,).

    Parameters
    ----------
    entry, leave : (2, t, 3) x y in mm, c in degrees
        Where the head begins and ends each track, run as it is and run from its far end.
    origin : (3,)
        Where the head is before.
    pace : (2, 3)
        Velocities and accelerations of X, Y and C.
    period : degrees
        After which the tool is the same again.
    """
    count = entry.shape[1]
    order, flip = greedy(entry, leave, origin, way)
    if count < 2:
        return order, flip
    # The origin is one more track, which comes first and stays there.
    place = np.broadcast_to(origin, (2, 1, 3))
    ends = np.stack(
        [np.concatenate([entry, place], axis=1), np.concatenate([leave, place], axis=1)], axis=1
    )
    ends[..., 2] %= period
    tour = np.concatenate([[count], order]).astype(np.int32)
    side = np.concatenate([[0], flip]).astype(np.uint8)
    near, far = _near(
        np.ascontiguousarray(entry[0, :, :2]),
        np.ascontiguousarray(leave[0, :, :2]),
        min(_NEIGHBOURS, count - 1),
    )
    velocity, acceleration = pace
    # Of each axis: where its ramps meet, 4/a, 1/v and v/a; below them the period of C.
    rates = np.zeros((4, 4))
    rates[:3] = np.column_stack(
        [velocity**2 / acceleration, 4.0 / acceleration, 1.0 / velocity, velocity / acceleration]
    )
    rates[3, 0] = period
    # No link to a neighbour can be faster: of two axes one has to go 1/√2 of the way.
    quick = np.array([pace[0, :2].max(), pace[1, :2].max()])
    floor = _rest_to_rest(far / math.sqrt(2.0), quick[0], quick[1])
    trials = min(_TRIALS * count, _MOST_TRIALS)
    _improve(tour, side, ends, rates, int(way), near, floor, trials)
    return tour[1:], side[1:].astype(np.bool_)


def link_times(entry: F64, leave: F64, origin: F64, pace: F64, period: float) -> F64:
    """Return the time of the link before each track, (t,) s, in the order in which they stand.

    Parameters
    ----------
    entry, leave : (t, 3) x y in mm, c in degrees
    origin, pace, period
        As for ``shortest``.

    Notes
    -----
    Every axis from rest to rest: 2√(Δ/a) where it never reaches v, Δ/v + v/a where it does; the
    slowest axis says how long the link takes.
    """
    change = np.abs(entry - np.concatenate([origin[None], leave[:-1]]))
    around = change[:, 2] % period
    change[:, 2] = np.minimum(around, period - around)
    times = _rest_to_rest(change, pace[0], pace[1])
    slowest: F64 = times.max(axis=1)
    return slowest


def _rest_to_rest(way: F64, velocity: Any, acceleration: Any) -> F64:
    """Return how long an axis takes for a way."""
    ramp = way < velocity**2 / acceleration
    times: F64 = np.where(
        ramp, 2.0 * np.sqrt(way / acceleration), way / velocity + velocity / acceleration
    )
    return times


def _greedy(start: F64, end: F64, origin: F64, count: int) -> Any:
    """Return the nearest candidate each time; candidates ``count`` apart are one track."""
    if count == 0:
        return np.zeros(0, np.int32)
    low = start.min(axis=0)
    extent = np.maximum(start.max(axis=0) - low, 1e-3)
    side = max(1, math.isqrt(len(start) // 2))
    size = extent / side
    cell = np.minimum(((start - low) / size).astype(np.int64), side - 1)
    key = cell[:, 0] * side + cell[:, 1]
    listed = np.argsort(key, kind="stable")
    first = np.searchsorted(key[listed], np.arange(side * side + 1))
    return _walked(start, end, origin, low, size, side, listed, first, key, count)


@njit(cache=True)
def _walked(
    start: Any,
    end: Any,
    origin: Any,
    low: Any,
    size: Any,
    side: int,
    listed: Any,
    first: Any,
    key: Any,
    count: int,
) -> Any:
    """Search the grid in growing rings; a found track is struck from its cells."""
    left = first[1:] - first[:-1]
    order = np.empty(count, np.int32)
    x = origin[0]
    y = origin[1]
    least = min(size[0], size[1])
    for step in range(count):
        column = min(max(int((x - low[0]) / size[0]), 0), side - 1)
        row = min(max(int((y - low[1]) / size[1]), 0), side - 1)
        best = -1
        reach = np.inf
        ring = 0
        while ring < side and (best < 0 or (ring - 1) * least <= reach):
            for i in range(max(column - ring, 0), min(column + ring, side - 1) + 1):
                edge = abs(i - column) == ring
                j = row - ring
                while j <= row + ring:
                    if 0 <= j < side:
                        cell = i * side + j
                        for place in range(first[cell], first[cell] + left[cell]):
                            track = listed[place]
                            distance = math.hypot(start[track, 0] - x, start[track, 1] - y)
                            if distance < reach or (distance == reach and track < best):
                                reach = distance
                                best = track
                    j += 1 if edge or ring == 0 else 2 * ring
            ring += 1
        order[step] = best
        for twin in range(best % count, len(start), count):
            cell = key[twin]
            for place in range(first[cell], first[cell] + left[cell]):
                if listed[place] == twin:
                    left[cell] -= 1
                    listed[place] = listed[first[cell] + left[cell]]
                    break
        x = end[best, 0]
        y = end[best, 1]
    return order


@njit(cache=True)
def _near(start: Any, end: Any, wanted: int) -> Any:
    """Return the tracks with the ends nearest to either end of each, and how near, (t, wanted)."""
    count = len(start)
    point = np.concatenate((start, end))
    low_x, low_y = point[:, 0].min(), point[:, 1].min()
    side = max(1, int(math.sqrt(count)))
    wide = max((point[:, 0].max() - low_x) / side, 1e-3)
    high = max((point[:, 1].max() - low_y) / side, 1e-3)
    column = np.minimum(((point[:, 0] - low_x) / wide).astype(np.int64), side - 1)
    row = np.minimum(((point[:, 1] - low_y) / high).astype(np.int64), side - 1)
    key = column * side + row
    listed = np.argsort(key, kind="mergesort")
    first = np.searchsorted(key[listed], np.arange(side * side + 1))
    near = np.empty((count, wanted), np.int32)
    far = np.empty((count, wanted))
    for track in range(count):
        best = far[track]
        found = 0
        for own in (track, track + count):
            x, y = point[own, 0], point[own, 1]
            ring = 0
            while ring < side:
                if found == wanted and (ring - 1) * min(wide, high) > best[wanted - 1]:
                    break
                for i in range(max(column[own] - ring, 0), min(column[own] + ring, side - 1) + 1):
                    edge = abs(i - column[own]) == ring
                    j = row[own] - ring
                    while j <= row[own] + ring:
                        if 0 <= j < side:
                            cell = i * side + j
                            for place in range(first[cell], first[cell + 1]):
                                other = listed[place] % count
                                if other == track:
                                    continue
                                distance = math.hypot(
                                    point[listed[place], 0] - x, point[listed[place], 1] - y
                                )
                                found = _listed(near[track], best, found, other, distance)
                        j += 1 if edge or ring == 0 else 2 * ring
                ring += 1
    return near, far


@njit(cache=True)
def _listed(near: Any, best: Any, found: int, other: int, distance: float) -> int:
    """Put a track into a list of the nearest, once, and return how long the list is."""
    at = found
    for place in range(found):
        if near[place] == other:
            if best[place] <= distance:
                return found
            at = place
            break
    if at == found:
        if found == len(near):
            if distance >= best[found - 1]:
                return found
            at = found - 1
        else:
            found += 1
    while at > 0 and best[at - 1] > distance:
        best[at], near[at] = best[at - 1], near[at - 1]
        at -= 1
    best[at], near[at] = distance, other
    return found


@njit(cache=True, error_model="numpy")
def _link(a: int, side_a: int, b: int, side_b: int, ends: Any, rates: Any) -> float:
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


@njit(cache=True)
def _between(
    i: int, turn_i: int, j: int, turn_j: int, tour: Any, side: Any, ends: Any, rates: Any
) -> float:
    """Return the time from place i to place j of the tour, each turned or not; 0 past its end."""
    if j >= len(tour):
        return 0.0
    return _link(tour[i], side[i] ^ turn_i, tour[j], side[j] ^ turn_j, ends, rates)


@njit(cache=True)
def _inside(i: int, j: int, turn: int, tour: Any, side: Any, ends: Any, rates: Any) -> float:
    """Return what reversing the places i … j adds to the links inside."""
    if turn:
        return 0.0
    more = 0.0
    for place in range(i, j):
        more += _between(place + 1, 0, place, 0, tour, side, ends, rates)
        more -= _between(place, 0, place + 1, 0, tour, side, ends, rates)
    return more


@njit(cache=True)
def _reverse_gain(i: int, j: int, turn: int, tour: Any, side: Any, ends: Any, rates: Any) -> float:
    """Return what reversing the places i … j adds to the whole."""
    if i < 1 or (not turn and j - i > 50):
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


@njit(cache=True)
def _move_gain(
    s: int,
    e: int,
    k: int,
    back: int,
    turn: int,
    tour: Any,
    side: Any,
    ends: Any,
    rates: Any,
) -> float:
    """Return what putting the places s … e after place k adds, reversed or not, turned or not."""
    head, tail = (e, s) if back else (s, e)
    more = _between(s - 1, 0, e + 1, 0, tour, side, ends, rates)
    more -= _between(s - 1, 0, s, 0, tour, side, ends, rates)
    more -= _between(e, 0, e + 1, 0, tour, side, ends, rates)
    more -= _between(k, 0, k + 1, 0, tour, side, ends, rates)
    more += _between(k, 0, head, turn, tour, side, ends, rates)
    if k + 1 < len(tour):
        more += _between(tail, turn, k + 1, 0, tour, side, ends, rates)
    if back and not turn:
        more += _inside(s, e, 0, tour, side, ends, rates)
    return more


@njit(cache=True)
def _reverse(i: int, j: int, turn: int, tour: Any, side: Any, where: Any) -> None:
    low, high = i, j
    while low < high:
        tour[low], tour[high] = tour[high], tour[low]
        side[low], side[high] = side[high], side[low]
        low += 1
        high -= 1
    for place in range(i, j + 1):
        side[place] ^= turn
        where[tour[place]] = place


@njit(cache=True)
def _swap(s: int, m: int, e: int, tour: Any, side: Any, where: Any) -> None:
    """Put the places m … e before the places s … m - 1."""
    _reverse(s, m - 1, 0, tour, side, where)
    _reverse(m, e, 0, tour, side, where)
    _reverse(s, e, 0, tour, side, where)


@njit(cache=True)
def _better(
    track: int,
    tour: Any,
    side: Any,
    where: Any,
    ends: Any,
    rates: Any,
    way: int,
    near: Any,
    floor: Any,
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
        for size in range(1, 4):
            for ahead in range(2):
                s = i if ahead else i - size + 1
                e = s + size - 1
                if s < 1 or e > last or s <= j <= e or (size == 1 and ahead):
                    continue
                for before in range(2):
                    k = j - before
                    if k < 0 or s - 1 <= k <= e:
                        continue
                    for back in range(2):
                        if back and size == 1 and way == 0:
                            continue
                        turn = back if (mirrored or size == 1) else 0
                        more = _move_gain(s, e, k, back, turn, tour, side, ends, rates)
                        if more < -1e-9:
                            if back:
                                _reverse(s, e, turn, tour, side, where)
                            if k > e:
                                _swap(s, e + 1, k, tour, side, where)
                                return s, k, more
                            _swap(k + 1, s, e, tour, side, where)
                            return k + 1, e, more
    return 0, -1, 0.0


@njit(cache=True)
def _settle(
    queue: Any,
    waiting: Any,
    head: int,
    size: int,
    most: int,
    tour: Any,
    side: Any,
    where: Any,
    ends: Any,
    rates: Any,
    way: int,
    near: Any,
    floor: Any,
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


@njit(cache=True)
def _improve(
    tour: Any,
    side: Any,
    ends: Any,
    rates: Any,
    way: int,
    near: Any,
    floor: Any,
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
