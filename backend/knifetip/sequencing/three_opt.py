"""three_opt: shorten a ring of tracks by changes of two or three links, until none shortens it.

A change removes links, whose ends are then linked otherwise.  It starts at an end: its link to end
2 is removed, end 2 is linked to a nearer end 3, whose link to end 4 is removed, and so on; the last
end is linked to the first one.  The sum of the removed links must exceed the sum of the new ones
after each step, so that few ends have to be tried.

Source: Lin 1965 (3-opt), Lin & Kernighan 1973 (positive gain), Bentley 1992 (neighbour lists and a
queue).
"""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import OutBool_1, OutI32_1, inline_kernel, kernel
from knifetip.sequencing.ring import Ends, Ring, end_time, linked_end, record_reversal

#: A change that saves less than this is not made (s).
_LEAST_GAIN: Final = 1e-9
#: Greatest number of reversals of one change.
_MOST_REVERSALS: Final = 3


class Queue(NamedTuple):
    """A circular queue of the ends of t tracks and the origin, which begins at index 0 whenever no
    search is running.
    """

    ends: OutI32_1  #: (2t + 2,)
    waiting: OutBool_1  #: (2t + 2,) whether each end is in the queue


@kernel
def queue_ends(entered: OutI32_1) -> Queue:
    """Return a queue of all ends in the order of the ring; ``entered`` is the array of ``Ring``."""
    ends = np.empty(2 * len(entered), np.int32)
    ends[0::2], ends[1::2] = entered, entered ^ 1
    return Queue(ends, np.ones(len(ends), np.bool_))


@inline_kernel
def enqueue_end(end: int, size: int, front: int, queue: Queue) -> int:
    """Add an end to the queue, unless it is in the queue, and return the new size of the queue.

    ``front`` is the index of the first end in the circular queue, and ``size`` is the number of
    ends in it.
    """
    if queue.waiting[end]:
        return size
    queue.waiting[end] = True
    slot = front + size
    queue.ends[slot if slot < len(queue.ends) else slot - len(queue.ends)] = end
    return size + 1


@inline_kernel
def _find_change(end1: int, ring: Ring, ends: Ends) -> Any:
    """Return the first change found that starts at an end and shortens the ring.

    Returns the time saved (s, 0 if there is no such change), the ends 2 to 6 of the change, and
    whether ends 3 and 4 alone could be linked; ends 5 and 6 are -1 if two links are changed.
    """
    entered, place, linked = ring.entered, ring.place, ring.linked
    near, near_time = ends.near, ends.near_time
    count = len(entered)
    end2 = linked_end(end1, ring)
    # Places are counted from the track of end 2, away from end 1.
    base, ahead = place[end2 >> 1], entered[place[end2 >> 1]] == end2
    for rank3 in range(near.shape[1]):
        open2 = linked[end1] - near_time[end2, rank3]
        if open2 <= _LEAST_GAIN:
            break
        end3 = int(np.int64(near[end2, rank3]))
        end4 = linked_end(end3, ring)
        if end3 == end1 or end4 == end2:
            continue
        open4 = open2 + linked[end3]
        # Whether a link of ends 4 and 1 closes the ring: else it would make two rings.
        closes = (entered[place[end3 >> 1]] == end3) == ahead
        if closes:
            saved = open4 - end_time(end4, end1, ends)
            if saved > _LEAST_GAIN:
                return saved, end2, end3, end4, -1, -1, True
        # Tracks of the path from end 2: up to end 4 if that closes the ring, else up to end 3.
        span = place[(end4 if closes else end3) >> 1] - base
        span = span if ahead else -span
        span = span if span >= 0 else span + count
        for rank5 in range(near.shape[1]):
            open5 = open4 - near_time[end4, rank5]
            if open5 <= _LEAST_GAIN:
                break
            end5 = int(np.int64(near[end4, rank5]))
            end6 = linked_end(end5, ring)
            if end5 in (end1, end2, end3) or end6 in (end1, end2, end3):
                continue
            at = place[end5 >> 1]
            offset = at - base if ahead else base - at
            offset = offset if offset >= 0 else offset + count
            inside = offset <= span
            if closes:
                # The path from end 2 to end 4 would be reversed first.
                if ((entered[at] == end5) == ahead) == inside:
                    continue
            elif not inside:
                continue
            saved = open5 + linked[end5] - end_time(end6, end1, ends)
            if saved > _LEAST_GAIN:
                return saved, end2, end3, end4, end5, end6, closes
    return 0.0, end2, -1, -1, -1, -1, False


@inline_kernel
def _apply_change(
    change: tuple[float, int, int, int, int, int, bool], done: int, ring: Ring, ends: Ends
) -> int:
    """Apply a change to the ring, and return the number of reversals made so far.

    ``change``: as returned by ``_find_change``.
    """
    _, end2, end3, end4, end5, end6, closes = change
    if closes:
        done = record_reversal(end2, end4, done, ring, ends)
        if end5 >= 0:
            done = record_reversal(end4, end6, done, ring, ends)
        return done
    place = ring.place
    # The path from end 2 to end 3 contains the link of ends 5 and 6, in one of two directions.
    same = ring.entered[place[end5 >> 1]] == end5
    if same == (ring.entered[place[end2 >> 1]] == end2):
        done = record_reversal(end2, end6, done, ring, ends)
        return record_reversal(end5, end3, done, ring, ends)
    done = record_reversal(end2, end3, done, ring, ends)
    done = record_reversal(end3, end6, done, ring, ends)
    return record_reversal(end5, end2, done, ring, ends)


@kernel(allocates=False)
def shorten_ring(queue: Queue, size: int, limit: int, done: int, ring: Ring, ends: Ends) -> Any:
    """Improve the ring in place at the queued ends, and at the ends of the links that change.

    The search ends when no further change shortens the ring, or when the number of reversals might
    exceed ``limit``.  Returns the time saved (s) and the number of reversals made so far.

    Parameters
    ----------
    queue
        The queue; it is empty at the end.
    size
        Number of ends in the queue.
    limit
        Greatest number of reversals.
    done
        Number of reversals made before.
    """
    saved = 0.0
    front = 0
    while size > 0:
        end = queue.ends[front]
        front = front + 1 if front < len(queue.ends) - 1 else 0
        size -= 1
        queue.waiting[end] = False
        while done + _MOST_REVERSALS <= limit:
            change = _find_change(end, ring, ends)
            if change[0] == 0.0:
                break
            saved += change[0]
            done = _apply_change(change, done, ring, ends)
            for other in change[1:6]:
                if other >= 0:
                    size = enqueue_end(other, size, front, queue)
    return saved, done
