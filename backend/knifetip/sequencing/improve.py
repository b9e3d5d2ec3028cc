"""improve: local search for a shorter tour of tracks.

    tour of tracks, link times, neighbours -> the same tracks in a shorter order

2-opt and Or-opt until neither improves the tour; then random segment swaps.  Each swap is followed
by the same local search, and undone if the tour is not shorter.

A track is run forwards (side 0) or backwards (side 1).  ``reversal`` is a ``Reversal``.  ``ends``
and ``rates`` are as in ``improve_tour``.

Source: Croes 1958 (2-opt), Or 1976, Martin, Otto & Felten 1991 (perturb and repair).
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

#: Longest run that is reversed if the times of all links in it change.
_LONGEST_RUN: Final = 50


@kernel
def _travel_time(a: int, side_a: int, b: int, side_b: int, ends: F64_4A, rates: F64_2) -> float:
    """Return the time from the end of track a to the start of track b (s).

    ``side_a`` and ``side_b`` are 0 for a track that is run forwards and 1 for backwards.
    """
    x = abs(ends[side_b, 0, b, 0] - ends[side_a, 1, a, 0])
    y = abs(ends[side_b, 0, b, 1] - ends[side_a, 1, a, 1])
    c = abs(ends[side_b, 0, b, 2] - ends[side_a, 1, a, 2])
    c = min(c, rates[3, 0] - c)
    slowest = 0.0
    for axis, distance in ((0, x), (1, y), (2, c)):
        if distance < rates[axis, 0]:
            time = math.sqrt(distance * rates[axis, 1])
        else:
            time = distance * rates[axis, 2] + rates[axis, 3]
        slowest = max(slowest, time)
    return slowest


@kernel
def _link_time(
    i: int, turn_i: int, j: int, turn_j: int, tour: I32_1, side: U8_1, ends: F64_4A, rates: F64_2
) -> float:
    """Return the time from position i to position j of the tour (s); 0 if j is beyond its end.

    ``turn_i`` and ``turn_j`` are 1 if the track there is run opposite to ``side``.
    """
    if j >= len(tour):
        return 0.0
    return _travel_time(tour[i], side[i] ^ turn_i, tour[j], side[j] ^ turn_j, ends, rates)


@kernel
def _inner_change(
    i: int, j: int, turn: int, tour: I32_1, side: U8_1, ends: F64_4A, rates: F64_2
) -> float:
    """Return how much longer the links between positions i … j take if these are reversed (s).

    With ``turn`` 1 the tracks are run the other way round too, which changes no link time.
    """
    if turn:
        return 0.0
    more = 0.0
    for place in range(i, j):
        more += _link_time(place + 1, 0, place, 0, tour, side, ends, rates)
        more -= _link_time(place, 0, place + 1, 0, tour, side, ends, rates)
    return more


@kernel
def _reversal_change(
    i: int, j: int, turn: int, tour: I32_1, side: U8_1, ends: F64_4A, rates: F64_2
) -> float:
    """Return how much longer the tour takes if its positions i … j are reversed (s).

    With ``turn`` 1 the tracks are run the other way round too.  Returns 0 if i is the origin or the
    run is too long.
    """
    if i < 1 or (not turn and j - i > _LONGEST_RUN):
        return 0.0
    more = _link_time(i - 1, 0, j, turn, tour, side, ends, rates)
    more -= _link_time(i - 1, 0, i, 0, tour, side, ends, rates)
    if j + 1 < len(tour):
        more += _link_time(i, turn, j + 1, 0, tour, side, ends, rates)
        more -= _link_time(j, 0, j + 1, 0, tour, side, ends, rates)
    # A loss at the two ends is hardly ever regained inside, and computing that is costly.
    if more >= 0.0:
        return more
    return more + _inner_change(i, j, turn, tour, side, ends, rates)


@kernel
def _removal_gain(s: int, e: int, tour: I32_1, side: U8_1, ends: F64_4A, rates: F64_2) -> float:
    """Return the time saved by removing positions s … e of the tour (s); 0 if not removable."""
    if s < 1 or e >= len(tour):
        return 0.0
    saved = _link_time(s - 1, 0, s, 0, tour, side, ends, rates)
    saved += _link_time(e, 0, e + 1, 0, tour, side, ends, rates)
    return saved - _link_time(s - 1, 0, e + 1, 0, tour, side, ends, rates)


@kernel
def _reverse(i: int, j: int, turn: int, tour: OutI32_1, side: OutU8_1, position: OutI64_1) -> None:
    """Reverse positions i … j of the tour in place; with ``turn`` 1 also the sides of their tracks.

    Updates ``position``, the position of each track in the tour.
    """
    low, high = i, j
    while low < high:
        tour[low], tour[high] = tour[high], tour[low]
        side[low], side[high] = side[high], side[low]
        low += 1
        high -= 1
    for place in range(i, j + 1):
        side[place] ^= turn
        position[tour[place]] = place


@kernel
def _swap(s: int, m: int, e: int, tour: OutI32_1, side: OutU8_1, position: OutI64_1) -> None:
    """Move positions m … e of the tour before positions s … m - 1, in place."""
    _reverse(s, m - 1, 0, tour, side, position)
    _reverse(m, e, 0, tour, side, position)
    _reverse(s, e, 0, tour, side, position)


@kernel
def _improve_track(
    track: int,
    tour: OutI32_1,
    side: OutU8_1,
    position: OutI64_1,
    ends: F64_4A,
    rates: F64_2,
    reversal: int,
    near: I32_2,
    floor: F64_2,
) -> Any:
    """Make the first change near a track that shortens the tour.

    Returns the first and last position that changed and the change (s); (0, -1, 0) for none.

    Parameters
    ----------
    position
        Position of each track in the tour.
    near, floor : (t, k) and (t, k)
        Neighbours of each track, and lower bounds of the link times to them (s).
    """
    last = len(tour) - 1
    symmetric = 1 if reversal == 1 else 0
    i = position[track]
    if reversal == 2:
        more = _link_time(i - 1, 0, i, 1, tour, side, ends, rates)
        more -= _link_time(i - 1, 0, i, 0, tour, side, ends, rates)
        if i < last:
            more += _link_time(i, 1, i + 1, 0, tour, side, ends, rates)
            more -= _link_time(i, 0, i + 1, 0, tour, side, ends, rates)
        if more < -1e-9:
            side[i] ^= 1
            return i, i, more
    # Every improvement replaces, at one of its tracks, a longer link by a shorter one.
    longest = _link_time(i - 1, 0, i, 0, tour, side, ends, rates)
    longest = max(longest, _link_time(i, 0, i + 1, 0, tour, side, ends, rates))
    freed = np.empty(6)
    for place in range(6):
        s = i if place % 2 else i - place // 2
        freed[place] = (
            _removal_gain(s, s + place // 2, tour, side, ends, rates) if place != 1 else 0.0
        )
    for rank in range(near.shape[1]):
        if floor[track, rank] >= longest:
            break
        other = near[track, rank]
        j = position[other]
        low, high = min(i, j), max(i, j)
        more = _reversal_change(low + 1, high, symmetric, tour, side, ends, rates)
        if more < -1e-9:
            _reverse(low + 1, high, symmetric, tour, side, position)
            return low + 1, high, more
        more = _reversal_change(low, high - 1, symmetric, tour, side, ends, rates)
        if more < -1e-9:
            _reverse(low, high - 1, symmetric, tour, side, position)
            return low, high - 1, more
        for place in range(6):
            # Runs of one to three tracks that start or end at this track.
            size, ahead = place // 2 + 1, place % 2
            s = i if ahead else i - size + 1
            e = s + size - 1
            if freed[place] <= 1e-9 or s <= j <= e:
                continue
            # After or before the neighbour, reversed if needed to put the two side by side.
            for before in range(2):
                k = j - before
                back = before if ahead else 1 - before
                if size == 1:
                    back = 0
                if k < 0 or s - 1 <= k <= e:
                    continue
                for _ in range(2 if size == 1 and reversal != 0 else 1):
                    turn = back if (symmetric or size == 1) else 0
                    head, tail = (e, s) if back else (s, e)
                    more = _link_time(k, 0, head, turn, tour, side, ends, rates)
                    more -= _link_time(k, 0, k + 1, 0, tour, side, ends, rates) + freed[place]
                    if more < -1e-9 and k < last:
                        more += _link_time(tail, turn, k + 1, 0, tour, side, ends, rates)
                    if more < -1e-9 and back and not turn:
                        more += _inner_change(s, e, 0, tour, side, ends, rates)
                    if more < -1e-9:
                        if back:
                            _reverse(s, e, turn, tour, side, position)
                        if k > e:
                            _swap(s, e + 1, k, tour, side, position)
                            return s, k, more
                        _swap(k + 1, s, e, tour, side, position)
                        return k + 1, e, more
                    back = 1
    return 0, -1, 0.0


@kernel(checks_division=True)
def _improve_queued(
    queue: OutI32_1,
    waiting: OutBool_1,
    head: int,
    size: int,
    most: int,
    tour: OutI32_1,
    side: OutU8_1,
    position: OutI64_1,
    ends: F64_4A,
    rates: F64_2,
    reversal: int,
    near: I32_2,
    floor: F64_2,
) -> Any:
    """Improve the tour around the queued tracks and those next to each change, until none helps.

    Returns the total change (s), and the first and last position that changed.

    Parameters
    ----------
    queue, waiting, head, size
        Circular queue of tracks, whether each track is in it, its first element and its length.
    most
        Greatest number of changes.
    """
    count = len(queue)
    gained = 0.0
    low, high = len(tour), 0
    while size > 0:
        track = queue[head]
        head = (head + 1) % count
        size -= 1
        waiting[track] = False
        while most > 0:
            first, last, more = _improve_track(
                track, tour, side, position, ends, rates, reversal, near, floor
            )
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
def improve_tour(
    tour: OutI32_1,
    side: OutU8_1,
    ends: F64_4A,
    rates: F64_2,
    reversal: int,
    near: I32_2,
    floor: F64_2,
    trials: int,
) -> None:
    """Shorten a tour of tracks in place.

    Parameters
    ----------
    tour, side : (t + 1,) and (t + 1,)
        Tracks in their order, the origin first, and whether each is run backwards.
    ends : (2, 2, t + 1, 3)
        x, y, c at the start (0) and the end (1) of each track, for each side.
    rates : (4, 4)
        Rates of the axes, see ``short_order``.
    reversal : int
        ``Reversal``: which tracks may be run backwards.
    near, floor : (t, k) and (t, k)
        Neighbours of each track, and lower bounds of the link times to them (s).
    trials : int
        Number of random swaps.
    """
    last = len(tour) - 1
    position = np.empty(len(tour), np.int64)
    for place in range(len(tour)):
        position[tour[place]] = place
    queue = tour[1:].copy()
    waiting = np.ones(last, np.bool_)
    _improve_queued(
        queue,
        waiting,
        0,
        last,
        100 * last,
        tour,
        side,
        position,
        ends,
        rates,
        reversal,
        near,
        floor,
    )
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
        # Positions s … m - 1 and m … e - 1 are swapped.
        e -= 1
        gained = (
            _link_time(s - 1, 0, m, 0, tour, side, ends, rates)
            - _link_time(s - 1, 0, s, 0, tour, side, ends, rates)
            + _link_time(e, 0, s, 0, tour, side, ends, rates)
            - _link_time(m - 1, 0, m, 0, tour, side, ends, rates)
        )
        if e < last:
            gained += _link_time(m - 1, 0, e + 1, 0, tour, side, ends, rates)
            gained -= _link_time(e, 0, e + 1, 0, tour, side, ends, rates)
        size = 0
        for place in (s - 1, s, m - 1, m, e, e + 1):
            if 1 <= place <= last and not waiting[tour[place]]:
                waiting[tour[place]] = True
                queue[size] = tour[place]
                size += 1
        _swap(s, m, e, tour, side, position)
        more, low, high = _improve_queued(
            queue, waiting, 0, size, 200, tour, side, position, ends, rates, reversal, near, floor
        )
        low, high = min(low, s), max(high, e)
        if gained + more < 0.0:
            kept[low : high + 1] = tour[low : high + 1]
            kept_side[low : high + 1] = side[low : high + 1]
        else:
            for place in range(low, high + 1):
                tour[place], side[place] = kept[place], kept_side[place]
                position[tour[place]] = place
