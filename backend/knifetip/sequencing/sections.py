"""sections: change sections of a tour, and compute the times that the changes cost or save.

A section is a sequence of neighbouring positions of a tour.  It never contains the origin.
"""

from __future__ import annotations

from typing import Final

from knifetip.kernels import inline_kernel, kernel
from knifetip.sequencing.tour import (
    Tour,
    Tracks,
    current_link,
    forget_link,
    link_time,
    opposite_link,
)

#: Longest section that is reversed if the times of all links in it change.
_LONGEST_SECTION: Final = 50


@kernel(allocates=False)
def inner_change(first: int, last: int, flip: int, tour: Tour, tracks: Tracks) -> float:
    """Return the increase of the time inside a section of the tour if the section is reversed (s).

    The time is the sum of the air moves between the tracks of the section.  If ``flip`` is 1, the
    same moves are made in the opposite direction, in the same time, and the result is 0.

    Parameters
    ----------
    first, last
        First and last position of the section in the tour.
    flip
        1 if each track of the section is also run in its other direction, else 0.
    """
    if flip:
        return 0.0
    change = 0.0
    for slot in range(first, last):
        change += opposite_link(slot + 1, tour, tracks)
        change -= current_link(slot + 1, tour, tracks)
    return change


@inline_kernel
def turn_change(here: int, tour: Tour, tracks: Tracks) -> float:
    """Return the increase of the time of the tour if the track at one position of the tour is run
    in its other direction (s).
    """
    change: float = link_time(here - 1, 0, here, 1, tour, tracks)
    change -= current_link(here, tour, tracks)
    if here < len(tour.track) - 1:
        change += link_time(here, 1, here + 1, 0, tour, tracks)
        change -= current_link(here + 1, tour, tracks)
    return change


@kernel(allocates=False)
def reversal_change(first: int, last: int, flip: int, tour: Tour, tracks: Tracks) -> float:
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
    """
    if first < 1 or (not flip and last - first > _LONGEST_SECTION):
        return 0.0
    change = link_time(first - 1, 0, last, flip, tour, tracks)
    change -= current_link(first, tour, tracks)
    if last + 1 < len(tour.track):
        change += link_time(first, flip, last + 1, 0, tour, tracks)
        change -= current_link(last + 1, tour, tracks)
    # A loss at the two ends is hardly ever regained inside, and computing that is costly.
    if change >= 0.0:
        return change
    return change + inner_change(first, last, flip, tour, tracks)


@kernel(allocates=False)
def removal_gain(first: int, last: int, tour: Tour, tracks: Tracks) -> float:
    """Return the time saved if a section of the tour is removed (s).

    The section contains the positions from ``first`` to ``last``.  The result is 0 if the section
    contains the origin (position 0) or reaches beyond the end of the tour.
    """
    if first < 1 or last >= len(tour.track):
        return 0.0
    saved = current_link(first, tour, tracks)
    saved += current_link(last + 1, tour, tracks)
    return saved - link_time(first - 1, 0, last + 1, 0, tour, tracks)


@inline_kernel
def swap_change(first: int, middle: int, last: int, tour: Tour, tracks: Tracks) -> float:
    """Return how much longer a tour takes if two neighbouring sections are swapped (s).

    The first section contains the positions from ``first`` to ``middle - 1``, the second those from
    ``middle`` to ``last``.
    """
    change: float = link_time(first - 1, 0, middle, 0, tour, tracks)
    change += link_time(last, 0, first, 0, tour, tracks)
    change -= current_link(first, tour, tracks) + current_link(middle, tour, tracks)
    if last + 1 < len(tour.track):
        change += link_time(middle - 1, 0, last + 1, 0, tour, tracks)
        change -= current_link(last + 1, tour, tracks)
    return change


@kernel(allocates=False)
def reverse(first: int, last: int, flip: int, tour: Tour) -> None:
    """Reverse the section of the tour from position ``first`` to position ``last``, in place.

    If ``flip`` is 1, each track of the section is also run in its other direction.  Times of air
    moves that change are marked as unknown.
    """
    track, side, position = tour.track, tour.side, tour.position
    low, high = first, last
    while low < high:
        track[low], track[high] = track[high], track[low]
        side[low], side[high] = side[high], side[low]
        low += 1
        high -= 1
    for slot in range(first, last + 1):
        side[slot] ^= flip
        position[track[slot]] = slot
        forget_link(slot, tour)
    if last + 1 < len(track):
        forget_link(last + 1, tour)


@kernel(allocates=False)
def swap(first: int, middle: int, last: int, tour: Tour) -> None:
    """Swap two neighbouring sections of the tour in place.

    The first section reaches from position ``first`` to position ``middle - 1`` of the tour, the
    second from ``middle`` to ``last``.
    """
    reverse(first, middle - 1, 0, tour)
    reverse(middle, last, 0, tour)
    reverse(first, last, 0, tour)
