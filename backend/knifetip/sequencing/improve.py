"""improve: shorten a tour of tracks by local search with random changes.

After a local search (``local_search``), two neighbouring sections of the tour, chosen at random,
are swapped again and again.  Each swap is followed by a local search at the changed positions, and
undone if the tour is not shorter.  The swaps end early on tours that they hardly shorten, for
example on a regular grid of tracks.

Source: Martin, Otto & Felten 1991 (perturb and repair).
"""

from __future__ import annotations

from typing import Final

from knifetip.kernels import OutI32_1, OutU8_1, inline_kernel, kernel
from knifetip.sequencing.local_search import enqueue, improve_queued, queue_tracks
from knifetip.sequencing.sections import swap, swap_change
from knifetip.sequencing.tour import Tour, Tracks, current_link, forget_link, make_tour

#: Greatest number of changes of the tour: per track in the first search, and after each swap.
_CHANGES: Final = 100
_CHANGES_AFTER_SWAP: Final = 200
#: The swaps end when more than this number of them, plus a third of all swaps, have shortened the
#: tour in sequence by less than this fraction of its time.
_PATIENCE: Final = 200
_LEAST_SHARE: Final = 1e-4


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
def improve_tour(track: OutI32_1, side: OutU8_1, tracks: Tracks, trials: int) -> int:
    """Shorten a tour of t tracks in place, by changing their order and directions.

    Returns the number of random swaps that were tried.

    Parameters
    ----------
    track, side : (t + 1,) and (t + 1,)
        Track at each position of the tour, with the origin (number t) at position 0; and 1 if the
        track at the position is run backwards, else 0.  Both are changed in place.
    tracks
        The t tracks.
    trials : int
        Greatest number of random swaps of two sections.
    """
    last = len(track) - 1
    tour, queue = make_tour(track, side), queue_tracks(track[1:])
    improve_queued(queue, last, _CHANGES * last, tour, tracks)
    worth = 0.0
    for slot in range(1, last + 1):
        worth += _LEAST_SHARE * current_link(slot, tour, tracks)
    best_track, best_side = track.copy(), side.copy()
    state, idle, saved = 12345, 0, 0.0
    trial = 0
    while last >= 3 and trial < trials and idle <= _PATIENCE + trial // 3:
        trial += 1
        idle += 1
        state, first, middle, end = _random_sections(state, last)
        if first == middle or middle == end:
            continue
        change = swap_change(first, middle, end - 1, tour, tracks)
        size = 0
        for slot in (first - 1, first, middle - 1, middle, end - 1, end):
            if 1 <= slot <= last:
                size = enqueue(track[slot], size, 0, queue)
        swap(first, middle, end - 1, tour)
        more, low, high = improve_queued(queue, size, _CHANGES_AFTER_SWAP, tour, tracks)
        low, high = min(low, first), max(high, end - 1)
        if change + more < 0.0:
            best_track[low : high + 1] = track[low : high + 1]
            best_side[low : high + 1] = side[low : high + 1]
            saved -= change + more
            if saved > worth:
                idle, saved = 0, 0.0
        else:
            _restore(low, high, best_track, best_side, tour)
    return trial
