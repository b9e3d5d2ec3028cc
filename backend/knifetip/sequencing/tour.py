"""tour: a tour of tracks for local search, and the times of the air moves in it.

A track is a path that a tool follows without lifting; a tour is an order of all tracks, each with
its direction.  A track is run forwards (side 0) or backwards (side 1).  Position 0 of every tour
contains the origin: a track of length 0 at the pose of the head before the first track.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from knifetip.kernels import (
    F64_2,
    F64_4,
    I32_2,
    OutF64_2,
    OutI32_1,
    OutI64_1,
    OutU8_1,
    inline_kernel,
    kernel,
)


class Tracks(NamedTuple):
    """t tracks, and the axes that move the head between them."""

    #: (t + 1, 2, 2, 3) ``ends[i, s, e]`` is the pose of the head (x, y in mm, c in degrees) at the
    #: start (e = 0) or the end (e = 1) of track i, if it is run forwards (s = 0) or backwards
    #: (s = 1); the last track is the origin
    ends: F64_4
    #: (4, 4) Rows 0, 1 and 2 belong to X, Y and C.  For an axis with velocity v and acceleration a,
    #: the four entries of its row are v² / a (the shortest distance on which the axis reaches v),
    #: 4 / a, 1 / v and v / a.  Of row 3 only the first entry is used: the period of C (degrees),
    #: which is the rotation after which the tool is the same.
    rates: F64_2
    near: I32_2  #: (t, k) k neighbours of each track, nearest first
    least_time: F64_2  #: (t, k) lower bounds of the times of the air moves to the neighbours (s)


class Tour(NamedTuple):
    """A tour of t tracks."""

    track: OutI32_1  #: (t + 1,) track at each position of the tour
    side: OutU8_1  #: (t + 1,) 1 if the track at the position is run backwards, else 0
    position: OutI64_1  #: (t + 1,) position of each track in the tour
    #: (2, t + 2) Row 0: times of the air moves to each position of the tour from the position
    #: before it (s).  Row 1: times of the opposite moves, between the same two tracks with
    #: unchanged directions.  Negative numbers mark unknown times, which are computed when they are
    #: first needed.  The times for the position beyond the end of the tour are 0.
    linked: OutF64_2


@kernel
def make_tour(track: OutI32_1, side: OutU8_1) -> Tour:
    """Return a tour that consists of the given arrays, with all times still unknown."""
    position = np.empty(len(track), np.int64)
    for slot in range(len(track)):
        position[track[slot]] = slot
    linked = np.full((2, len(track) + 1), -1.0)
    linked[:, len(track)] = 0.0
    return Tour(track, side, position, linked)


@inline_kernel
def axis_time(distance: float, axis: int, rates: F64_2) -> float:
    """Return the time that one axis needs to travel a distance from rest to rest (s).

    ``distance`` is in mm, or in degrees for C; ``rates`` is the array of ``Tracks``.
    """
    # C turns by the smaller angle.
    if axis == 2:
        distance = min(distance, rates[3, 0] - distance)
    # Both times are computed and one is selected: a branch would often be mispredicted.
    ramp: float = math.sqrt(distance * rates[axis, 1])
    cruise: float = distance * rates[axis, 2] + rates[axis, 3]
    return ramp if distance < rates[axis, 0] else cruise


@inline_kernel
def _travel_time(
    before: int, side_before: int, after: int, side_after: int, ends: F64_4, rates: F64_2
) -> float:
    """Return the time of the air move from the end of one track to the start of another track (s).

    It is the time of the slowest of the axes X, Y and C.

    ``before``, ``after``: numbers of the two tracks; the move leads from ``before`` to ``after``.
    ``side_before``, ``side_after``: 0 for a track that is run forwards, 1 for a track that is run
    backwards.
    ``ends``, ``rates``: as in ``Tracks``.
    """
    slowest = 0.0
    for axis in range(3):
        distance = abs(ends[after, side_after, 0, axis] - ends[before, side_before, 1, axis])
        slowest = max(slowest, axis_time(distance, axis, rates))
    return slowest


@inline_kernel
def link_time(
    before: int, flip_before: int, after: int, flip_after: int, tour: Tour, tracks: Tracks
) -> float:
    """Return the time of the air move between the tracks at two positions of the tour (s).

    The time is 0 if ``after`` is beyond the end of the tour.

    Parameters
    ----------
    before, after
        Positions in the tour: the move leads from the track at ``before`` to the track at
        ``after``.
    flip_before, flip_after
        1 if the track is to be run in the direction opposite to its direction in the tour, else 0.
    """
    if after >= len(tour.track):
        return 0.0
    return _travel_time(
        tour.track[before],
        tour.side[before] ^ flip_before,
        tour.track[after],
        tour.side[after] ^ flip_after,
        tracks.ends,
        tracks.rates,
    )


@inline_kernel
def current_link(after: int, tour: Tour, tracks: Tracks) -> float:
    """Return the time of the air move to position ``after`` of the tour from the position before
    it (s); 0 for the position beyond the end of the tour.
    """
    if tour.linked[0, after] < 0.0:
        tour.linked[0, after] = link_time(after - 1, 0, after, 0, tour, tracks)
    time: float = tour.linked[0, after]
    return time


@inline_kernel
def opposite_link(after: int, tour: Tour, tracks: Tracks) -> float:
    """Return the time of the air move from the track at position ``after`` of the tour to the track
    at the position before it, if both keep their directions (s).
    """
    if tour.linked[1, after] < 0.0:
        tour.linked[1, after] = link_time(after, 0, after - 1, 0, tour, tracks)
    time: float = tour.linked[1, after]
    return time


@inline_kernel
def forget_link(after: int, tour: Tour) -> None:
    """Mark the times of the air moves between position ``after`` and the position before it as
    unknown.
    """
    tour.linked[0, after] = -1.0
    tour.linked[1, after] = -1.0
