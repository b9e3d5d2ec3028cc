"""local_search: shorten a tour by changes near single tracks, until no such change shortens it.

The changes are 2-opt (reverse a section of the tour), Or-opt (move a section of one to three
tracks), and to run one track in its other direction.  They are tried near the tracks of a queue: at
first all tracks, later only tracks beside which the tour changed.

Source: Croes 1958 (2-opt), Or 1976, Bentley 1992 (neighbour lists and a queue).
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import OutBool_1, OutF64_1, OutI32_1, inline_kernel, kernel
from knifetip.sequencing.sections import (
    removal_gain,
    reversal_change,
    reverse,
    swap,
    time_change_inside,
    turn_change,
)
from knifetip.sequencing.tour import Tour, Tracks, current_link, link_time

#: A change that saves less than this is not made (s).
LEAST_GAIN: Final = 1e-9
#: Sections that are moved: those of one to three tracks that start or end at a track.
_SECTIONS: Final = 6


class Queue(NamedTuple):
    """A circular queue of tracks, and scratch space of the search."""

    tracks: OutI32_1  #: (t,)
    waiting: OutBool_1  #: (t,) whether each track is in the queue
    freed: OutF64_1  #: (6,) time saved if each section at a track is removed (s)


@kernel
def queue_tracks(track: OutI32_1) -> Queue:
    """Return a queue of t tracks, (t,), in the given order."""
    return Queue(track.copy(), np.ones(len(track), np.bool_), np.empty(_SECTIONS))


@inline_kernel
def _try_reversal(first: int, last: int, tour: Tour, tracks: Tracks) -> float:
    """Reverse a section of the tour if that shortens the tour; return the change of its time (s).

    The tracks of the section keep their directions.  The result is 0 if nothing changed.
    ``first`` and ``last`` are the first and last position of the section.
    """
    change: float = reversal_change(first, last, tour, tracks)
    if change >= -LEAST_GAIN:
        return 0.0
    reverse(first, last, 0, tour)
    return change


@inline_kernel
def _try_moves(here: int, there: int, tour: Tour, tracks: Tracks, freed: OutF64_1) -> Any:
    """Move a section at one position of the tour beside another position if that shortens the tour.

    Returns the first and last position that changed, and the change of the tour's time (s); (0, -1,
    0) if nothing changed.

    ``here``, ``there``: position at which the sections start or end, and position beside which they
    are put.
    ``freed`` (6,): time saved if each section is removed (s), infinite if not yet computed; updated
    in place.
    """
    end = len(tour.track) - 1
    for slot in range(_SECTIONS):
        size, ahead = slot // 2 + 1, slot % 2
        s = here if ahead else here - size + 1
        e = s + size - 1
        if s <= there <= e or slot == 1:
            continue
        if freed[slot] == math.inf:
            freed[slot] = removal_gain(s, e, tour, tracks)
        if freed[slot] <= LEAST_GAIN:
            continue
        # After or before the neighbour, reversed if needed to put the two side by side.  A single
        # track is tried in both directions instead.
        for before in range(2):
            k = there - before
            if k < 0 or s - 1 <= k <= e:
                continue
            removed = current_link(k + 1, tour, tracks) + freed[slot]
            back = 0 if size == 1 else (before if ahead else 1 - before)
            for _ in range(2 if size == 1 else 1):
                flip = back if size == 1 else 0
                head, tail = (e, s) if back else (s, e)
                change = link_time(k, 0, head, flip, tour, tracks) - removed
                if change < -LEAST_GAIN and k < end:
                    change += link_time(tail, flip, k + 1, 0, tour, tracks)
                if change < -LEAST_GAIN and back and not flip:
                    change += time_change_inside(s, e, tour, tracks)
                if change < -LEAST_GAIN:
                    if back:
                        reverse(s, e, flip, tour)
                    if k > e:
                        swap(s, e + 1, k, tour)
                        return s, k, change
                    swap(k + 1, s, e, tour)
                    return k + 1, e, change
                back = 1
    return 0, -1, 0.0


@kernel(allocates=False)
def _improve_track(track: int, tour: Tour, tracks: Tracks, freed: OutF64_1) -> Any:
    """Apply the first change near a track that shortens the tour.

    Returns the first and last position of the tour that changed, and the change of the tour's time
    (s, negative).  Returns (0, -1, 0) if no change shortens the tour.

    ``track``: the track at which the changed section starts or ends.
    ``freed`` (6,): scratch.
    """
    here = tour.position[track]
    change = turn_change(here, tour, tracks)
    if change < -LEAST_GAIN:
        reverse(here, here, 1, tour)
        return here, here, change
    # Most improvements replace, at one of their tracks, a longer link by a shorter one.
    longest = current_link(here, tour, tracks)
    longest = max(longest, current_link(here + 1, tour, tracks))
    for slot in range(_SECTIONS):
        freed[slot] = math.inf
    for rank in range(tracks.near.shape[1]):
        if tracks.least_time[track, rank] >= longest:
            break
        there = tour.position[tracks.near[track, rank]]
        low, high = min(here, there), max(here, there)
        change = _try_reversal(low + 1, high, tour, tracks)
        if change < 0.0:
            return low + 1, high, change
        change = _try_reversal(low, high - 1, tour, tracks)
        if change < 0.0:
            return low, high - 1, change
        first, last, change = _try_moves(here, there, tour, tracks, freed)
        if last >= first:
            return first, last, change
    return 0, -1, 0.0


@inline_kernel
def enqueue(track: int, size: int, front: int, queue: Queue) -> int:
    """Add a track to the queue, unless it is in the queue, and return the new size of the queue.

    ``front`` is the index of the first track in the circular queue, and ``size`` is the number of
    tracks in it.
    """
    if queue.waiting[track]:
        return size
    queue.waiting[track] = True
    queue.tracks[(front + size) % len(queue.tracks)] = track
    return size + 1


@kernel(allocates=False, checks_division=True)
def improve_queued(queue: Queue, size: int, limit: int, tour: Tour, tracks: Tracks) -> Any:
    """Improve the tour in place at the queued tracks, and at the tracks next to each change.

    The search ends when no further change shortens the tour, or after ``limit`` changes.  Returns
    the total change of the tour's time (s), and the first and last position that changed; the first
    position is greater than the last one if there was no change.

    Parameters
    ----------
    queue
        The queue, which begins at index 0; it is empty at the end.
    size
        Number of tracks in the queue.
    limit
        Greatest number of changes.
    """
    gained = 0.0
    front, count = 0, len(queue.tracks)
    low, high = len(tour.track), 0
    while size > 0:
        track = queue.tracks[front]
        front = (front + 1) % count
        size -= 1
        queue.waiting[track] = False
        while limit > 0:
            first, last, change = _improve_track(track, tour, tracks, queue.freed)
            if last < first:
                break
            limit -= 1
            gained += change
            low, high = min(low, first), max(high, last)
            for slot in (first - 1, first, last, last + 1):
                if 1 <= slot < len(tour.track) and tour.track[slot] != track:
                    size = enqueue(tour.track[slot], size, front, queue)
    return gained, low, high
