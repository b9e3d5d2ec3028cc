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

#: Longest section that is reversed; the times of all links in it change.
_LONGEST_SECTION: Final = 50


@kernel(allocates=False)
def time_change_inside(first: int, last: int, tour: Tour, tracks: Tracks) -> float:
    """Return the increase of the time inside a section of the tour if the section is reversed (s).

    The time is the sum of the air moves between the tracks of the section, which keep their
    directions.  ``first`` and ``last`` are the first and last position of the section in the tour.
    """
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
def reversal_change(first: int, last: int, tour: Tour, tracks: Tracks) -> float:
    """Return the increase of the time of the tour if a section of it is reversed (s).

    The tracks of the section keep their directions.  If the section must not be reversed, the
    result is 0.  That is the case if the section contains the origin (position 0), or if it is
    longer than ``_LONGEST_SECTION``.

    If the two air moves at the ends of the section do not become shorter in total, the result is
    only their change.  The air moves inside the section hardly ever save more than that.

    ``first`` and ``last`` are the first and last position of the section in the tour.
    """
    if first < 1 or last - first > _LONGEST_SECTION:
        return 0.0
    change = link_time(first - 1, 0, last, 0, tour, tracks)
    change -= current_link(first, tour, tracks)
    if last + 1 < len(tour.track):
        change += link_time(first, 0, last + 1, 0, tour, tracks)
        change -= current_link(last + 1, tour, tracks)
    # A loss at the two ends is hardly ever regained inside, and computing that is costly.
    if change >= 0.0:
        return change
    return change + time_change_inside(first, last, tour, tracks)


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


@inline_kernel
def exchange_sections(
    first: int, second: int, third: int, last: int, tour: Tour, tracks: Tracks
) -> float:
    """Put three neighbouring sections of the tour into the opposite order, in place.

    The tracks inside each section keep their order.  Returns the change of the tour's time (s).

    Parameters
    ----------
    first, second, third
        First position of each section.
    last
        Last position of the third section.
    """
    change = 0.0
    for slot in (first, second, third, last + 1):
        change -= current_link(slot, tour, tracks)
    middle, end = first + last + 1 - third, first + last + 1 - second
    reverse(first, last, 0, tour)
    reverse(first, middle - 1, 0, tour)
    reverse(middle, end - 1, 0, tour)
    reverse(end, last, 0, tour)
    for slot in (first, middle, end, last + 1):
        change += current_link(slot, tour, tracks)
    return change
