"""ring: a closed tour of tracks, and its reversals.

Every track has two ends, and a tool that arrives at one of them leaves at the other.  In a ring all
tracks follow each other, the last one and the first one too: each end is linked to one end of
another track by an air move.  The ring has no direction, so that a path of it can be reversed: the
air moves take the same time in both directions.  One more track, the origin, makes a ring of an
open tour: one of its ends is the pose of the head before the first track, and air moves to its
other end take no time, since the tour may end anywhere.

The ends of track i have the numbers 2 i (its start, as given) and 2 i + 1.  The origin is the last
track; its free end is the even one.  If the tracks must be run as given, air moves lead from odd to
even ends only: this holds as long as it holds for all new links.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from knifetip.kernels import F64_2, I32_2, OutF64_1, OutI32_1, OutI32_2, inline_kernel, kernel
from knifetip.sequencing.tour import axis_time


class Ends(NamedTuple):
    """The ends of t tracks, and the axes that move the head between them."""

    #: (2t + 2, 4) x and y (mm) of the head at each end; then c (degrees, from 0 to its period) if
    #: the track is started there, and if it is finished there
    pose: F64_2
    rates: F64_2  #: as in ``Tracks``
    near: I32_2  #: (2t + 2, k) k ends of other tracks near each end, in the order of ``near_time``
    near_time: F64_2  #: (2t + 2, k) times of the air moves to them (s)


class Ring(NamedTuple):
    """A ring of t tracks and the origin."""

    entered: OutI32_1  #: (t + 1,) end at which the track at each place of the ring is entered
    place: OutI32_1  #: (t + 1,) place of each track in the ring
    linked: OutF64_1  #: (2t + 2,) time of the air move to or from each end (s)
    #: (r, 2) first and last end of each path that was reversed, from the oldest to the latest; once
    #: the array is full, reversals are not recorded
    reversed: OutI32_2


@inline_kernel
def end_time(end_a: int, end_b: int, ends: Ends) -> float:
    """Return the time of the air move between two ends (s)."""
    pose, rates = ends.pose, ends.rates
    free = len(pose) - 2
    turn = abs(pose[end_a, 3] - pose[end_b, 2])
    slowest = max(
        axis_time(abs(pose[end_a, 0] - pose[end_b, 0]), 0, rates),
        axis_time(abs(pose[end_a, 1] - pose[end_b, 1]), 1, rates),
    )
    slowest = max(slowest, axis_time(turn, 2, rates))
    return 0.0 if end_a == free or end_b == free else slowest


@kernel
def make_ends(pose: F64_2, rates: F64_2, near: OutI32_2) -> Ends:
    """Return the ends of t tracks; ``near`` is sorted in place by the times of the air moves.

    See ``Ends`` for the arguments.
    """
    near_time = np.empty(near.shape)
    ends = Ends(pose, rates, near, near_time)
    for end in range(len(near)):
        others, times = near[end], near_time[end]
        for rank in range(len(others)):
            other = others[rank]
            time = end_time(end, other, ends)
            slot = rank
            while slot > 0 and times[slot - 1] > time:
                times[slot], others[slot] = times[slot - 1], others[slot - 1]
                slot -= 1
            times[slot], others[slot] = time, other
    return ends


@inline_kernel
def linked_end(end: int, ring: Ring) -> int:
    """Return the end to which an end is linked by an air move."""
    entered = ring.entered
    last = len(entered) - 1
    place = ring.place[end >> 1]
    if entered[place] == end:
        return int(np.int64(entered[place - 1 if place > 0 else last] ^ 1))
    return int(np.int64(entered[place + 1 if place < last else 0]))


@kernel(allocates=False)
def _link(end_a: int, end_b: int, ring: Ring, ends: Ends) -> None:
    """Set the time of the air move between two ends that are neighbours now."""
    time = end_time(end_a, end_b, ends)
    ring.linked[end_a] = time
    ring.linked[end_b] = time


@kernel
def make_ring(entered: OutI32_1, ends: Ends, room: int) -> Ring:
    """Return a ring of t tracks and the origin.

    Parameters
    ----------
    entered : (t + 1,)
        End at which each track is entered, in the order of the tracks; changes with the ring.
    ends
        The ends of the tracks.
    room
        Greatest number of reversals that can be recorded.
    """
    count = len(entered)
    place = np.empty(count, np.int32)
    for at in range(count):
        place[entered[at] >> 1] = at
    ring = Ring(entered, place, np.empty(2 * count), np.empty((room, 2), np.int32))
    for at in range(count):
        _link(entered[at - 1] ^ 1, entered[at], ring, ends)
    return ring


@kernel(allocates=False)
def reverse_path(first: int, last: int, ring: Ring, ends: Ends) -> None:
    """Reverse a path of the ring in place; if it is longer than the rest, reverse the rest instead.

    Both make the same ring: the end before the path is then linked to ``last``, and the end behind
    it to ``first``.

    Parameters
    ----------
    first, last
        The two ends at which the path is linked to the rest of the ring.
    """
    entered, place = ring.entered, ring.place
    count = len(entered)
    low, high = place[first >> 1], place[last >> 1]
    if entered[low] != first:
        low, high = high, low
    size = high - low + 1
    if size <= 0:
        size += count
    if 2 * size > count:
        low, high = high + 1, low - 1
        size = count - size
        low = 0 if low == count else low
        high = count - 1 if high < 0 else high
    before, behind = linked_end(first, ring), linked_end(last, ring)
    for _ in range(size // 2):
        one, other = entered[low] ^ 1, entered[high] ^ 1
        entered[low], entered[high] = other, one
        place[other >> 1], place[one >> 1] = low, high
        low = 0 if low == count - 1 else low + 1
        high = count - 1 if high == 0 else high - 1
    if size % 2:
        entered[low] ^= 1
    _link(before, last, ring, ends)
    _link(first, behind, ring, ends)


@inline_kernel
def record_reversal(first: int, last: int, done: int, ring: Ring, ends: Ends) -> int:
    """Reverse a path as ``reverse_path`` does, and record it as reversal number ``done``.

    Returns ``done`` + 1.
    """
    reverse_path(first, last, ring, ends)
    if done < len(ring.reversed):
        ring.reversed[done, 0], ring.reversed[done, 1] = first, last
    return done + 1


@kernel(allocates=False)
def undo_reversals(done: int, ring: Ring, ends: Ends) -> None:
    """Undo the last ``done`` reversals, all of which are recorded."""
    for number in range(done - 1, -1, -1):
        # The path lies between the same two ends as before, in the opposite direction.
        reverse_path(ring.reversed[number, 1], ring.reversed[number, 0], ring, ends)
