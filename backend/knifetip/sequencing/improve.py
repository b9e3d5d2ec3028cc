"""improve: shorten a tour of tracks by local search.

A track is a path that a tool follows without lifting; a tour is an order of all tracks, each with
its direction.  The tour is changed by 2-opt (reverse a section of the tour) and Or-opt (move a
section) until neither of them improves it.  Then two neighbouring sections of the tour, chosen at
random, are swapped again and again.  Each swap is followed by the same local search, and undone if
the tour is not shorter.

A track is run forwards (side 0) or backwards (side 1).  ``improve_tour`` describes the arrays that
most functions of this module take.

Source: Croes 1958 (2-opt), Or 1976, Martin, Otto & Felten 1991 (perturb and repair).
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.kernels import (
    F64_2,
    F64_4,
    I32_1,
    I32_2,
    U8_1,
    OutBool_1,
    OutF64_1,
    OutF64_2,
    OutI32_1,
    OutI64_1,
    OutU8_1,
    inline_kernel,
    kernel,
)

#: Greatest rounding error of the times of links that are compared (s).
_ROUNDING: Final = 1e-12
#: Longest section that is reversed if the times of all links in it change.
_LONGEST_SECTION: Final = 50


@inline_kernel
def _travel_time(
    before: int, side_before: int, after: int, side_after: int, ends: F64_4, rates: F64_2
) -> float:
    """Return the time of the air move from the end of one track to the start of another track (s).

    It is the time of the slowest of the axes X, Y and C; C turns by the smaller angle.

    Parameters
    ----------
    before, after
        Numbers of the two tracks; the move leads from ``before`` to ``after``.
    side_before, side_after
        0 for a track that is run forwards, 1 for a track that is run backwards.
    ends : (t + 1, 2, 2, 3)
        ``ends[i, s, e]`` is the pose of the head (x, y in mm, c in degrees) at the start (e = 0) or
        the end (e = 1) of track i, if it is run forwards (s = 0) or backwards (s = 1).
    rates : (4, 4)
        Velocities and accelerations of X, Y and C, and the period of C, in the form that
        ``improve_tour`` documents.
    """
    slowest = 0.0
    for axis in range(3):
        distance = abs(ends[after, side_after, 0, axis] - ends[before, side_before, 1, axis])
        if axis == 2:
            distance = min(distance, rates[3, 0] - distance)
        # Both times are computed and one is selected: a branch would often be mispredicted.
        ramp = math.sqrt(distance * rates[axis, 1])
        cruise = distance * rates[axis, 2] + rates[axis, 3]
        slowest = max(slowest, ramp if distance < rates[axis, 0] else cruise)
    return slowest


@inline_kernel
def _link_time(
    before: int,
    flip_before: int,
    after: int,
    flip_after: int,
    tour: I32_1,
    side: U8_1,
    ends: F64_4,
    rates: F64_2,
) -> float:
    """Return the time of the air move between the tracks at two positions of the tour (s).

    The time is 0 if ``after`` is beyond the end of the tour.

    Parameters
    ----------
    before, after
        Positions in the tour: the move leads from the track at ``before`` to the track at
        ``after``.
    flip_before, flip_after
        1 if the track is to be run in the direction opposite to its entry in ``side``, else 0.
    tour, side : (t + 1,) and (t + 1,)
        Track at each position of the tour, with the origin (number t, the pose of the head before
        the first track) at position 0; and 1 if the track at the position is run backwards, else 0.
    ends : (t + 1, 2, 2, 3)
        ``ends[i, s, e]`` is the pose of the head (x, y in mm, c in degrees) at the start (e = 0) or
        the end (e = 1) of track i, if it is run forwards (s = 0) or backwards (s = 1).
    rates : (4, 4)
        Velocities and accelerations of X, Y and C, and the period of C, in the form that
        ``improve_tour`` documents.
    """
    if after >= len(tour):
        return 0.0
    return _travel_time(
        tour[before], side[before] ^ flip_before, tour[after], side[after] ^ flip_after, ends, rates
    )


@inline_kernel
def _current_link(
    after: int, tour: I32_1, side: U8_1, ends: F64_4, rates: F64_2, linked: OutF64_2
) -> float:
    """Return the time of the air move to position ``after`` of the tour from the position before
    it (s); 0 for the position beyond the end of the tour.

    The time is computed when it is first needed and then kept in row 0 of ``linked``, (2, t + 2).
    A negative number marks an unknown time.  Row 1 contains the times of the opposite moves
    (``_opposite_link``).  ``improve_tour`` describes the other arguments.
    """
    if linked[0, after] < 0.0:
        linked[0, after] = _link_time(after - 1, 0, after, 0, tour, side, ends, rates)
    time: float = linked[0, after]
    return time


@inline_kernel
def _opposite_link(
    after: int, tour: I32_1, side: U8_1, ends: F64_4, rates: F64_2, linked: OutF64_2
) -> float:
    """Return the time of the air move from the track at position ``after`` of the tour to the track
    at the position before it, if both keep their directions (s); see ``_current_link``.
    """
    if linked[1, after] < 0.0:
        linked[1, after] = _link_time(after, 0, after - 1, 0, tour, side, ends, rates)
    time: float = linked[1, after]
    return time


@inline_kernel
def _forget_link(after: int, linked: OutF64_2) -> None:
    """Mark the times of the air moves between position ``after`` and the position before it as
    unknown.
    """
    linked[0, after] = -1.0
    linked[1, after] = -1.0


@kernel(allocates=False)
def _inner_change(
    first: int,
    last: int,
    flip: int,
    tour: I32_1,
    side: U8_1,
    ends: F64_4,
    rates: F64_2,
    linked: OutF64_2,
) -> float:
    """Return the increase of the time inside a section of the tour if the section is reversed (s).

    The time is the sum of the air moves between the tracks of the section.  If ``flip`` is 1, the
    same moves are made in the opposite direction, in the same time, and the result is 0.

    Parameters
    ----------
    first, last
        First and last position of the section in the tour.
    flip
        1 if each track of the section is also run in its other direction, else 0.
    tour, side : (t + 1,) and (t + 1,)
        Track at each position of the tour, with the origin (number t, the pose of the head before
        the first track) at position 0; and 1 if the track at the position is run backwards, else 0.
    ends : (t + 1, 2, 2, 3)
        ``ends[i, s, e]`` is the pose of the head (x, y in mm, c in degrees) at the start (e = 0) or
        the end (e = 1) of track i, if it is run forwards (s = 0) or backwards (s = 1).
    rates : (4, 4)
        Velocities and accelerations of X, Y and C, and the period of C, in the form that
        ``improve_tour`` documents.
    linked : (2, t + 2)
        Times of the air moves of the tour, as ``_current_link`` keeps them.
    """
    if flip:
        return 0.0
    change = 0.0
    for slot in range(first, last):
        change += _opposite_link(slot + 1, tour, side, ends, rates, linked)
        change -= _current_link(slot + 1, tour, side, ends, rates, linked)
    return change


@kernel(allocates=False)
def _reversal_change(
    first: int,
    last: int,
    flip: int,
    tour: I32_1,
    side: U8_1,
    ends: F64_4,
    rates: F64_2,
    linked: OutF64_2,
) -> float:
    """Return the increase of the time of the tour if a section of it is reversed (s).

    If the section must not be reversed, the result is 0.  That is the case if the section contains
    the origin (position 0), or if it is longer than ``_LONGEST_SECTION`` and ``flip`` is 0.

    If the two air moves at the ends of the section do not become shorter in total, the result is
    only their change.  The air moves inside the section hardly ever save more than that.

    Parameters
    ----------
    first, last
        First and last position of the section in the tour.
    flip
        1 if each track of the section is also run in its other direction, else 0.
    tour, side : (t + 1,) and (t + 1,)
        Track at each position of the tour, with the origin (number t, the pose of the head before
        the first track) at position 0; and 1 if the track at the position is run backwards, else 0.
    ends : (t + 1, 2, 2, 3)
        ``ends[i, s, e]`` is the pose of the head (x, y in mm, c in degrees) at the start (e = 0) or
        the end (e = 1) of track i, if it is run forwards (s = 0) or backwards (s = 1).
    rates : (4, 4)
        Velocities and accelerations of X, Y and C, and the period of C, in the form that
        ``improve_tour`` documents.
    linked : (2, t + 2)
        Times of the air moves of the tour, as ``_current_link`` keeps them.
    """
    if first < 1 or (not flip and last - first > _LONGEST_SECTION):
        return 0.0
    change = _link_time(first - 1, 0, last, flip, tour, side, ends, rates)
    change -= _current_link(first, tour, side, ends, rates, linked)
    if last + 1 < len(tour):
        change += _link_time(first, flip, last + 1, 0, tour, side, ends, rates)
        change -= _current_link(last + 1, tour, side, ends, rates, linked)
    # A loss at the two ends is hardly ever regained inside, and computing that is costly.
    if change >= 0.0:
        return change
    return change + _inner_change(first, last, flip, tour, side, ends, rates, linked)


@kernel(allocates=False)
def _removal_gain(
    first: int,
    last: int,
    tour: I32_1,
    side: U8_1,
    ends: F64_4,
    rates: F64_2,
    linked: OutF64_2,
) -> float:
    """Return the time saved if a section of the tour is removed (s).

    The result is 0 if the section contains the origin (position 0) or reaches beyond the end of the
    tour.

    Parameters
    ----------
    first, last
        First and last position of the section in the tour.
    tour, side : (t + 1,) and (t + 1,)
        Track at each position of the tour, with the origin (number t, the pose of the head before
        the first track) at position 0; and 1 if the track at the position is run backwards, else 0.
    ends : (t + 1, 2, 2, 3)
        ``ends[i, s, e]`` is the pose of the head (x, y in mm, c in degrees) at the start (e = 0) or
        the end (e = 1) of track i, if it is run forwards (s = 0) or backwards (s = 1).
    rates : (4, 4)
        Velocities and accelerations of X, Y and C, and the period of C, in the form that
        ``improve_tour`` documents.
    linked : (2, t + 2)
        Times of the air moves of the tour, as ``_current_link`` keeps them.
    """
    if first < 1 or last >= len(tour):
        return 0.0
    saved = _current_link(first, tour, side, ends, rates, linked)
    saved += _current_link(last + 1, tour, side, ends, rates, linked)
    return saved - _link_time(first - 1, 0, last + 1, 0, tour, side, ends, rates)


@kernel(allocates=False)
def _reverse(
    first: int,
    last: int,
    flip: int,
    tour: OutI32_1,
    side: OutU8_1,
    position: OutI64_1,
    linked: OutF64_2,
) -> None:
    """Reverse the section of the tour from position ``first`` to position ``last``, in place.

    If ``flip`` is 1, each track of the section is also run in its other direction: its entry in
    ``side`` changes.  ``position``, the position of each track in the tour, is updated, and
    the times in ``linked`` that change are marked as unknown.
    """
    low, high = first, last
    while low < high:
        tour[low], tour[high] = tour[high], tour[low]
        side[low], side[high] = side[high], side[low]
        low += 1
        high -= 1
    for slot in range(first, last + 1):
        side[slot] ^= flip
        position[tour[slot]] = slot
        _forget_link(slot, linked)
    if last + 1 < len(tour):
        _forget_link(last + 1, linked)


@kernel(allocates=False)
def _swap(
    first: int,
    middle: int,
    last: int,
    tour: OutI32_1,
    side: OutU8_1,
    position: OutI64_1,
    linked: OutF64_2,
) -> None:
    """Swap two neighbouring sections of the tour in place.

    The first section reaches from position ``first`` to position ``middle - 1`` of the tour, the
    second from ``middle`` to ``last``.  The entries of ``tour`` and of ``side`` are swapped, and
    ``position``, the position of each track in the tour, is updated.
    """
    _reverse(first, middle - 1, 0, tour, side, position, linked)
    _reverse(middle, last, 0, tour, side, position, linked)
    _reverse(first, last, 0, tour, side, position, linked)


@kernel(allocates=False)
def _improve_track(
    track: int,
    tour: OutI32_1,
    side: OutU8_1,
    position: OutI64_1,
    ends: F64_4,
    rates: F64_2,
    reversal: int,
    near: I32_2,
    least_time: F64_2,
    linked: OutF64_2,
    freed: OutF64_1,
) -> Any:
    """Search the changes of the tour near one track, and apply the first one that shortens the
    tour.

    Returns the first and last position of the tour that changed, and the change of the tour's time
    (s, negative).  Returns (0, -1, 0) if no change shortens the tour.

    Parameters
    ----------
    track
        The track at which the changed section starts or ends.
    tour, side : (t + 1,) and (t + 1,)
        Track at each position of the tour, with the origin (number t, the pose of the head before
        the first track) at position 0; and 1 if the track at the position is run backwards, else 0.
        Both are changed in place.
    position : (t + 1,)
        Position of each track in the tour; updated in place.
    ends : (t + 1, 2, 2, 3)
        ``ends[i, s, e]`` is the pose of the head (x, y in mm, c in degrees) at the start (e = 0) or
        the end (e = 1) of track i, if it is run forwards (s = 0) or backwards (s = 1).
    rates : (4, 4)
        Velocities and accelerations of X, Y and C, and the period of C, in the form that
        ``improve_tour`` documents.
    reversal
        ``Reversal``: the ends of a track at which the tool may start.
    near, least_time : (t, k) and (t, k)
        k neighbours of each track, nearest first, and lower bounds of the times of the air moves to
        them (s).
    linked : (2, t + 2)
        Times of the air moves of the tour, as ``_current_link`` keeps them.
    freed : (6,)
        Scratch.
    """
    last = len(tour) - 1
    symmetric = 1 if reversal == 1 else 0
    here = position[track]
    if reversal == 2:
        change = _link_time(here - 1, 0, here, 1, tour, side, ends, rates)
        change -= _current_link(here, tour, side, ends, rates, linked)
        if here < last:
            change += _link_time(here, 1, here + 1, 0, tour, side, ends, rates)
            change -= _current_link(here + 1, tour, side, ends, rates, linked)
        if change < -1e-9:
            side[here] ^= 1
            _forget_link(here, linked)
            if here < last:
                _forget_link(here + 1, linked)
            return here, here, change
    # Every improvement replaces, at one of its tracks, a longer link by a shorter one.
    longest = _current_link(here, tour, side, ends, rates, linked)
    longest = max(longest, _current_link(here + 1, tour, side, ends, rates, linked))
    for slot in range(6):
        freed[slot] = math.inf  # not computed yet
    for rank in range(near.shape[1]):
        if least_time[track, rank] >= longest:
            break
        # Each change makes a link between the two tracks, which takes at least this time.  No bound
        # holds if the tracks have other poses in their other direction.
        least = -math.inf if reversal == 2 else least_time[track, rank] - _ROUNDING
        other = near[track, rank]
        there = position[other]
        low, high = min(here, there), max(here, there)
        removed = _current_link(low + 1, tour, side, ends, rates, linked)
        removed += _current_link(high + 1, tour, side, ends, rates, linked)
        # The other new link of the reversal that puts the first track before the second one.
        room = removed - least
        if room > 0.0 and room > _link_time(
            low + 1, symmetric, high + 1, 0, tour, side, ends, rates
        ):
            change = _reversal_change(low + 1, high, symmetric, tour, side, ends, rates, linked)
            if change < -1e-9:
                _reverse(low + 1, high, symmetric, tour, side, position, linked)
                return low + 1, high, change
        removed = _current_link(low, tour, side, ends, rates, linked)
        removed += _current_link(high, tour, side, ends, rates, linked)
        room = removed - least
        if room > 0.0 and room > _link_time(
            low - 1, 0, high - 1, symmetric, tour, side, ends, rates
        ):
            change = _reversal_change(low, high - 1, symmetric, tour, side, ends, rates, linked)
            if change < -1e-9:
                _reverse(low, high - 1, symmetric, tour, side, position, linked)
                return low, high - 1, change
        for slot in range(6):
            # Sections of one to three tracks that start or end at this track.
            size, ahead = slot // 2 + 1, slot % 2
            s = here if ahead else here - size + 1
            e = s + size - 1
            if s <= there <= e or slot == 1:
                continue
            if freed[slot] == math.inf:
                freed[slot] = _removal_gain(s, e, tour, side, ends, rates, linked)
            if freed[slot] <= 1e-9:
                continue
            # After or before the neighbour, reversed if needed to put the two side by side.
            for before in range(2):
                k = there - before
                back = before if ahead else 1 - before
                if size == 1:
                    back = 0
                if k < 0 or s - 1 <= k <= e:
                    continue
                removed = _current_link(k + 1, tour, side, ends, rates, linked) + freed[slot]
                room = removed - least
                if room <= 0.0:
                    continue
                for _ in range(2 if size == 1 and reversal != 0 else 1):
                    flip = back if (symmetric or size == 1) else 0
                    head, tail = (e, s) if back else (s, e)
                    # The new link that is not between the two tracks.
                    if before:
                        farther = _link_time(k, 0, head, flip, tour, side, ends, rates)
                    else:
                        farther = _link_time(tail, flip, k + 1, 0, tour, side, ends, rates)
                    if farther >= room:
                        back = 1
                        continue
                    change = _link_time(k, 0, head, flip, tour, side, ends, rates)
                    change -= removed
                    if change < -1e-9 and k < last:
                        change += _link_time(tail, flip, k + 1, 0, tour, side, ends, rates)
                    if change < -1e-9 and back and not flip:
                        change += _inner_change(s, e, 0, tour, side, ends, rates, linked)
                    if change < -1e-9:
                        if back:
                            _reverse(s, e, flip, tour, side, position, linked)
                        if k > e:
                            _swap(s, e + 1, k, tour, side, position, linked)
                            return s, k, change
                        _swap(k + 1, s, e, tour, side, position, linked)
                        return k + 1, e, change
                    back = 1
    return 0, -1, 0.0


@kernel(allocates=False, checks_division=True)
def _improve_queued(
    queue: OutI32_1,
    waiting: OutBool_1,
    front: int,
    size: int,
    limit: int,
    tour: OutI32_1,
    side: OutU8_1,
    position: OutI64_1,
    ends: F64_4,
    rates: F64_2,
    reversal: int,
    near: I32_2,
    least_time: F64_2,
    linked: OutF64_2,
    freed: OutF64_1,
) -> Any:
    """Improve the tour in place at the queued tracks, and at the tracks next to each change.

    The search ends when no further change shortens the tour, or after ``limit`` changes.  Returns
    the total change of the tour's time (s), and the first and last position that changed; the first
    position is greater than the last one if there was no change.

    Parameters
    ----------
    queue, waiting
        Tracks in a circular queue, and whether each track is in the queue; both are changed in
        place.
    front, size
        Index of the first track in ``queue``, and the number of tracks that are in the queue.
    limit
        Greatest number of changes.
    tour, side : (t + 1,) and (t + 1,)
        Track at each position of the tour, with the origin (number t, the pose of the head before
        the first track) at position 0; and 1 if the track at the position is run backwards, else 0.
        Both are changed in place.
    position : (t + 1,)
        Position of each track in the tour; updated in place.
    ends : (t + 1, 2, 2, 3)
        ``ends[i, s, e]`` is the pose of the head (x, y in mm, c in degrees) at the start (e = 0) or
        the end (e = 1) of track i, if it is run forwards (s = 0) or backwards (s = 1).
    rates : (4, 4)
        Velocities and accelerations of X, Y and C, and the period of C, in the form that
        ``improve_tour`` documents.
    reversal
        ``Reversal``: the ends of a track at which the tool may start.
    near, least_time : (t, k) and (t, k)
        k neighbours of each track, nearest first, and lower bounds of the times of the air moves to
        them (s).
    linked : (2, t + 2)
        Times of the air moves of the tour, as ``_current_link`` keeps them.
    freed : (6,)
        Scratch.
    """
    count = len(queue)
    gained = 0.0
    low, high = len(tour), 0
    while size > 0:
        track = queue[front]
        front = (front + 1) % count
        size -= 1
        waiting[track] = False
        while limit > 0:
            first, last, change = _improve_track(
                track,
                tour,
                side,
                position,
                ends,
                rates,
                reversal,
                near,
                least_time,
                linked,
                freed,
            )
            if last < first:
                break
            limit -= 1
            gained += change
            low, high = min(low, first), max(high, last)
            for slot in (first - 1, first, last, last + 1):
                if 1 <= slot < len(tour):
                    other = tour[slot]
                    if other != track and not waiting[other]:
                        waiting[other] = True
                        queue[(front + size) % count] = other
                        size += 1
    return gained, low, high


@inline_kernel
def _random_sections(state: int, last: int) -> tuple[int, int, int, int]:
    """Choose two neighbouring sections of a tour at random, among at most 40 tracks in sequence.

    The first section contains the positions ``first`` to ``middle - 1`` of the tour, the second
    section the positions ``middle`` to ``end - 1``.  Either of them may be empty.

    Parameters
    ----------
    state
        State of the linear congruential generator of random numbers.
    last
        Last position of the tour.

    Returns
    -------
    The next state of the generator, ``first``, ``middle`` and ``end``.
    """
    span = min(last, 40)
    state = (state * 1103515245 + 12345) & 0x7FFFFFFF
    base = 1 + (state >> 8) % (last - span + 1)
    first, end, total = last + 1, 0, 0
    for _ in range(3):
        state = (state * 1103515245 + 12345) & 0x7FFFFFFF
        position = base + (state >> 8) % span
        first, end = min(first, position), max(end, position)
        total += position
    return state, first, total - first - end, end


@inline_kernel
def _swap_change(
    first: int,
    middle: int,
    last: int,
    tour: I32_1,
    side: U8_1,
    ends: F64_4,
    rates: F64_2,
    linked: OutF64_2,
) -> float:
    """Return the increase of the time of the tour if two neighbouring sections are swapped (s).

    Parameters
    ----------
    first, middle, last
        The first section contains the positions ``first`` to ``middle - 1`` of the tour, the second
        the positions ``middle`` to ``last``.  Neither of them contains the origin.
    tour, side : (t + 1,) and (t + 1,)
        Track at each position of the tour, with the origin (number t, the pose of the head before
        the first track) at position 0; and 1 if the track at the position is run backwards, else 0.
    ends : (t + 1, 2, 2, 3)
        ``ends[i, s, e]`` is the pose of the head (x, y in mm, c in degrees) at the start (e = 0) or
        the end (e = 1) of track i, if it is run forwards (s = 0) or backwards (s = 1).
    rates : (4, 4)
        Velocities and accelerations of X, Y and C, and the period of C, in the form that
        ``improve_tour`` documents.
    linked : (2, t + 2)
        Times of the air moves of the tour, as ``_current_link`` keeps them.
    """
    change = (
        _link_time(first - 1, 0, middle, 0, tour, side, ends, rates)
        - _current_link(first, tour, side, ends, rates, linked)
        + _link_time(last, 0, first, 0, tour, side, ends, rates)
        - _current_link(middle, tour, side, ends, rates, linked)
    )
    if last + 1 < len(tour):
        change += _link_time(middle - 1, 0, last + 1, 0, tour, side, ends, rates)
        change -= _current_link(last + 1, tour, side, ends, rates, linked)
    return change


@kernel(checks_division=True)
def improve_tour(
    tour: OutI32_1,
    side: OutU8_1,
    ends: F64_4,
    rates: F64_2,
    reversal: int,
    near: I32_2,
    least_time: F64_2,
    trials: int,
) -> None:
    """Shorten a tour of t tracks in place, by changing their order and directions.

    Parameters
    ----------
    tour, side : (t + 1,) and (t + 1,)
        Track at each position of the tour, with the origin (number t, the pose of the head before
        the first track) at position 0; and 1 if the track at the position is run backwards, else 0.
        Both are changed in place.
    ends : (t + 1, 2, 2, 3)
        ``ends[i, s, e]`` is the pose of the head (x, y in mm, c in degrees) at the start (e = 0) or
        the end (e = 1) of track i, if it is run forwards (s = 0) or backwards (s = 1).
        The origin starts and ends in the same pose.
    rates : (4, 4)
        Rows 0, 1 and 2 belong to X, Y and C.  For an axis with velocity v and acceleration a, the
        four entries of its row are v² / a (the shortest distance on which the axis reaches v),
        4 / a, 1 / v and v / a.  Of row 3 only the first entry is used: the period of C (degrees),
        which is the rotation after which the tool is the same.
    reversal : int
        ``Reversal``: the ends of a track at which the tool may start.
    near, least_time : (t, k) and (t, k)
        k neighbours of each track, nearest first, and lower bounds of the times of the air moves to
        them (s).
    trials : int
        Number of random swaps of two sections.
    """
    last = len(tour) - 1
    position = np.empty(len(tour), np.int64)
    for slot in range(len(tour)):
        position[tour[slot]] = slot
    queue = tour[1:].copy()
    waiting = np.ones(last, np.bool_)
    freed = np.empty(6)
    linked = np.full((2, len(tour) + 1), -1.0)
    linked[:, len(tour)] = 0.0
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
        least_time,
        linked,
        freed,
    )
    best_tour, best_side = tour.copy(), side.copy()
    state = 12345
    for _ in range(trials if last >= 3 else 0):
        state, s, m, end = _random_sections(state, last)
        if s == m or m == end:
            continue
        e = end - 1
        change = _swap_change(s, m, e, tour, side, ends, rates, linked)
        size = 0
        for slot in (s - 1, s, m - 1, m, e, e + 1):
            if 1 <= slot <= last and not waiting[tour[slot]]:
                waiting[tour[slot]] = True
                queue[size] = tour[slot]
                size += 1
        _swap(s, m, e, tour, side, position, linked)
        more, low, high = _improve_queued(
            queue,
            waiting,
            0,
            size,
            200,
            tour,
            side,
            position,
            ends,
            rates,
            reversal,
            near,
            least_time,
            linked,
            freed,
        )
        low, high = min(low, s), max(high, e)
        if change + more < 0.0:
            best_tour[low : high + 1] = tour[low : high + 1]
            best_side[low : high + 1] = side[low : high + 1]
        else:
            for slot in range(low, high + 1):
                tour[slot], side[slot] = best_tour[slot], best_side[slot]
                position[tour[slot]] = slot
                _forget_link(slot, linked)
            if high < last:
                _forget_link(high + 1, linked)
