"""improve: shorten a tour of tracks by local search with random changes.

After a local search, three neighbouring sections of the tour, chosen at random, are put into the
opposite order again and again.  This exchange of four links is a *double bridge*: no sequence of
the changes of a local search makes it, unless the tour becomes longer in between.  Each exchange is
followed by a local search at the changed positions, and undone if the tour is not shorter.  The
exchanges end early on tours that they hardly shorten, for example on a regular grid of tracks.

Source: Martin, Otto & Felten 1991 (double bridge and repair).
"""

from __future__ import annotations

from typing import Final, NamedTuple

from knifetip.kernels import OutI32_1, OutU8_1, inline_kernel, kernel
from knifetip.sequencing.local_search import enqueue, improve_queued, queue_tracks
from knifetip.sequencing.ring import (
    Ends,
    Ring,
    linked_end,
    make_ring,
    record_reversal,
    undo_reversals,
)
from knifetip.sequencing.sections import exchange_sections
from knifetip.sequencing.three_opt import enqueue_end, queue_ends, shorten_ring
from knifetip.sequencing.tour import Tour, Tracks, current_link, forget_link, make_tour

#: Greatest number of changes of the tour: per track in the first search, and after each exchange.
_CHANGES: Final = 100
_CHANGES_AFTER_EXCHANGE: Final = 200
#: Greatest number of tracks of a section that is exchanged.
_LONGEST_SECTION: Final = 15
#: Every saving permits one more exchange for each such fraction of the tour's time that it saves.
_WORTH: Final = 2e-6


class Limits(NamedTuple):
    """Limits of the number of random exchanges."""

    trials: int  #: greatest number of exchanges
    first: int  #: number of exchanges that are tried even if none of them shortens the tour
    patience: int  #: greatest number of exchanges after the last one that shortened the tour


@inline_kernel
def _random(state: int) -> int:
    """Return the next state of a linear congruential generator of random numbers."""
    return (state * 1103515245 + 12345) & 0x7FFFFFFF


@inline_kernel
def _random_sections(state: int, count: int) -> tuple[int, int, int, int, int]:
    """Choose three neighbouring sections of a tour at random.

    ``state``: state of the generator of random numbers.
    ``count``: number of tracks, 3 at least; they have the positions 1 to ``count``.
    Returns the next state of the generator, the first position of each section, and the last
    position of the third section.
    """
    longest = min(count // 3, _LONGEST_SECTION)
    state = _random(state)
    one = 1 + (state >> 8) % longest
    state = _random(state)
    two = one + 1 + (state >> 8) % longest
    state = _random(state)
    all_three = two + 1 + (state >> 8) % longest
    state = _random(state)
    first = 1 + (state >> 8) % (count - all_three + 1)
    return state, first, first + one, first + two, first + all_three - 1


@inline_kernel
def _restore(low: int, high: int, track: OutI32_1, side: OutU8_1, tour: Tour) -> None:
    """Restore the tour from position ``low`` to position ``high`` from a copy of its arrays."""
    changed = False
    for slot in range(low, high + 1):
        before = changed
        changed = tour.track[slot] != track[slot] or tour.side[slot] != side[slot]
        if changed:
            tour.track[slot], tour.side[slot] = track[slot], side[slot]
            tour.position[track[slot]] = slot
        if changed or before:
            forget_link(slot, tour)
    if changed and high + 1 < len(track):
        forget_link(high + 1, tour)


@kernel(checks_division=True)
def improve_tour(track: OutI32_1, side: OutU8_1, tracks: Tracks, limits: Limits) -> int:
    """Shorten a tour of t tracks in place, by changing their order and directions.

    Returns the number of random exchanges that were tried.

    Parameters
    ----------
    track, side : (t + 1,) and (t + 1,)
        Track at each position of the tour, with the origin (number t) at position 0; and 1 if the
        track at the position is run backwards, else 0.  Both are changed in place.
    tracks
        The t tracks.
    limits
        Limits of the number of random exchanges.
    """
    count = len(track) - 1
    tour, queue = make_tour(track, side), queue_tracks(track[1:])
    improve_queued(queue, count, _CHANGES * count, tour, tracks)
    worth = 0.0
    for slot in range(1, count + 1):
        worth += _WORTH * current_link(slot, tour, tracks)
    best_track, best_side = track.copy(), side.copy()
    state, trial, left = 12345, 0, float(limits.first)
    while count >= 3 and trial < limits.trials and left > 0.0:
        trial += 1
        left -= 1.0
        state, first, second, third, last = _random_sections(state, count)
        change = exchange_sections(first, second, third, last, tour, tracks)
        middle, end = first + last + 1 - third, first + last + 1 - second
        size = 0
        for slot in (first - 1, first, middle - 1, middle, end - 1, end, last, last + 1):
            if 1 <= slot <= count:
                size = enqueue(track[slot], size, 0, queue)
        more, low, high = improve_queued(queue, size, _CHANGES_AFTER_EXCHANGE, tour, tracks)
        low, high = min(low, first), max(high, last)
        if change + more < 0.0:
            best_track[low : high + 1] = track[low : high + 1]
            best_side[low : high + 1] = side[low : high + 1]
            left = min(left - (change + more) / worth, limits.patience)
        else:
            _restore(low, high, best_track, best_side, tour)
    return trial


@inline_kernel
def _exchange_paths(
    first: int, second: int, third: int, last: int, ring: Ring, ends: Ends
) -> tuple[float, int, int, int, int, int, int, int, int]:
    """Put three neighbouring sections of the ring into the opposite order, in place.

    The reversals are recorded as the first four ones.  Returns the change of the ring's time (s),
    and the eight ends of the changed links.  See ``exchange_sections`` for the arguments, which are
    places of the ring.
    """
    entered, linked = ring.entered, ring.linked
    before, end1 = linked_end(entered[first], ring), linked_end(entered[second], ring)
    end2, behind = linked_end(entered[third], ring), linked_end(entered[last] ^ 1, ring)
    one, two = linked_end(before, ring), linked_end(end1, ring)
    three, end3 = linked_end(end2, ring), linked_end(behind, ring)
    change = -(linked[one] + linked[two] + linked[three] + linked[behind])
    done = record_reversal(one, end3, 0, ring, ends)
    done = record_reversal(end3, three, done, ring, ends)
    done = record_reversal(end2, two, done, ring, ends)
    record_reversal(end1, one, done, ring, ends)
    change += linked[before] + linked[one] + linked[two] + linked[behind]
    return change, before, one, end1, two, end2, three, end3, behind


@kernel(checks_division=True)
def improve_ring(entered: OutI32_1, ends: Ends, limits: Limits) -> int:
    """Shorten a ring of t tracks and the origin in place.

    Returns the number of random exchanges that were tried.

    Parameters
    ----------
    entered : (t + 1,)
        End at which each track is entered, in the order of the tracks; changed in place.
    ends
        The ends of the tracks.
    limits
        Limits of the number of random exchanges.
    """
    count = len(entered) - 1
    ring, queue = make_ring(entered, ends, 3 * _CHANGES_AFTER_EXCHANGE), queue_ends(entered)
    shorten_ring(queue, 2 * count + 2, 3 * _CHANGES * count, 0, ring, ends)
    worth = 0.5 * _WORTH * ring.linked.sum()
    state, trial, left = 12345, 0, float(limits.first)
    while count >= 3 and trial < limits.trials and left > 0.0:
        trial += 1
        left -= 1.0
        state, first, second, third, last = _random_sections(state, count)
        exchange = _exchange_paths(first, second, third, last, ring, ends)
        size = 0
        for end in exchange[1:]:
            size = enqueue_end(end, size, 0, queue)
        gained, done = shorten_ring(queue, size, len(ring.reversed), 4, ring, ends)
        if gained > exchange[0]:
            left = min(left + (gained - exchange[0]) / worth, limits.patience)
        else:
            undo_reversals(done, ring, ends)
    return trial
