"""order: choose the order of the tracks, and the end at which each track starts.

A track is a path that a tool follows without lifting.  A nearest-neighbour tour is shortened by
local search with random changes.  Their number is bounded by the number of tracks, not by time, so
that the same tracks always get the same order.  The cost of the air move between two tracks is the
time of the slowest of the axes X, Y and C.  Lifts are left out, since they take the same time in
every air move.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I32, Bool
from knifetip.model.tool import Reversal
from knifetip.sequencing.improve import Limits, improve_ring, improve_tour
from knifetip.sequencing.nearest import find_neighbours, nearest_neighbour, nearest_walk
from knifetip.sequencing.ring import make_ends
from knifetip.sequencing.tour import Tracks

#: Number of ends of other tracks to which each end of a track may be linked.
_NEAR_ENDS: Final = 12
#: Greatest number of random exchanges per track, and of all of them.
_TRIALS: Final = 50
_MOST_TRIALS: Final = 25_000
#: Number of tracks times the number of exchanges that are tried in any case, and bounds of the
#: latter.
_FIRST: Final = 50_000
_LEAST_FIRST: Final = 250
_MOST_FIRST: Final = 1_000
#: Number of tracks times the greatest number of exchanges after the last saving, and bounds of the
#: latter.  Tracks that must be run as given are mostly outlines of like parts, in great numbers.
_PATIENCE: Final = {Reversal.EITHER: 4_000_000, Reversal.ONE: 300_000}
_LEAST_PATIENCE: Final = 300
_MOST_PATIENCE: Final = 4_000
#: The same for tracks with two sides, and the number of tracks beside which each one may be put.
_NEAR_TRACKS: Final = 6
_TRIALS_OF_SIDES: Final = 5
_MOST_OF_SIDES: Final = 3_000


def greedy_order(entry: F64, leave: F64, origin: F64, reversal: Reversal) -> tuple[I32, Bool]:
    """Return t tracks in nearest-neighbour order, and which of them start at their far end.

    The far end of a track is the end at which the given track stops.  The first returned array,
    (t,), contains the indices of the tracks in their order.  The second, (t,), is a mask with one
    entry per entry of the first.

    Parameters
    ----------
    entry, leave : (2, t, 3) x y in mm, c in degrees
        Poses of the head at the start and at the end of each track.  Row 0 contains the poses of
        the track as given, and row 1 the poses of the track if it starts at its far end.
    origin : (3,) x y in mm, c in degrees
        Pose of the head before the first track.
    reversal
        Ends of a track at which the tool may start.
    """
    count = entry.shape[1]
    if reversal == Reversal.ONE:
        order = nearest_neighbour(entry[0, :, :2], leave[0, :, :2], origin[:2])
        return order, np.zeros(count, np.bool_)
    ends = nearest_walk(
        entry[:, :, :2].reshape(-1, 2), leave[:, :, :2].reshape(-1, 2), origin[:2], count
    )
    return (ends % count).astype(np.int32), ends >= count


def short_order(
    entry: F64, leave: F64, origin: F64, pace: F64, period: float, reversal: Reversal
) -> tuple[I32, Bool]:
    """Return t tracks in a short order, and which of them start at their far end.

    The result and the parameters without a description are those of ``greedy_order``.

    Parameters
    ----------
    pace : (2, 3)
        Velocities (row 0) and accelerations (row 1) of X, Y and C, in mm or degrees, per s and per
        s².
    period : degrees
        Rotation of C after which the tool is the same.
    """
    count = entry.shape[1]
    order, flip = greedy_order(entry, leave, origin, reversal)
    if count < 2:
        return order, flip
    # The origin is one more track, fixed in the first position.
    origin_pose = np.broadcast_to(origin, (2, 1, 3))
    entry = np.concatenate([entry, origin_pose], axis=1)
    leave = np.concatenate([leave, origin_pose], axis=1)
    if reversal == Reversal.SIDES:
        return _order_with_sides(entry, leave, pace, period, (order, flip))
    one_way = reversal == Reversal.ONE
    if one_way:
        # The end of a track has the pose at which the head leaves it.
        entry[1], leave[1] = leave[0], entry[0]
    entered = np.concatenate([[2 * count], 2 * order + flip]).astype(np.int32)
    pose = np.empty((2 * count + 2, 4))
    pose[:, :3] = entry.swapaxes(0, 1).reshape(-1, 3)
    pose[:, 3] = leave[::-1, :, 2].T.ravel()
    pose[:, 2:] %= period
    near, _ = find_neighbours(
        pose[:, :2].copy(), False, one_way, min(_NEAR_ENDS, count if one_way else 2 * count)
    )
    ends = make_ends(pose, axis_rates(pace, period), near)
    limits = Limits(
        min(_TRIALS * count, _MOST_TRIALS),
        min(max(_FIRST // count, _LEAST_FIRST), _MOST_FIRST),
        min(max(_PATIENCE[reversal] // count, _LEAST_PATIENCE), _MOST_PATIENCE),
    )
    improve_ring(entered, ends, limits)
    return _tour_from_origin(entered)


def _tour_from_origin(entered: I32) -> tuple[I32, Bool]:
    """Return the order of t tracks in a ring, and which of them start at their far end.

    ``entered`` is the array of ``Ring``, (t + 1,).
    """
    origin = len(entered) - 1
    start = int(np.flatnonzero(entered >> 1 == origin)[0])
    tour = np.concatenate([entered[start + 1 :], entered[:start]])
    if entered[start] != 2 * origin:
        # The ring leads to the origin: it is run in the other direction.
        tour = tour[::-1] ^ 1
    return (tour >> 1).astype(np.int32), (tour & 1).astype(np.bool_)


def _order_with_sides(
    entry: F64, leave: F64, pace: F64, period: float, first: tuple[I32, Bool]
) -> tuple[I32, Bool]:
    """Return t tracks, each of which may begin with one of two sides, in a short order.

    The result, ``pace`` and ``period`` are those of ``short_order``.

    ``entry``, ``leave`` (2, t + 1, 3): as for ``short_order``; the last track is the origin.
    ``first``: the order that is shortened, in the form of the result.
    """
    count = len(first[0])
    ends = np.stack([entry, leave], axis=2).swapaxes(0, 1).copy()
    ends[..., 2] %= period
    point = ends[:-1, 0, :, :2].reshape(-1, 2)
    near, far = find_neighbours(
        np.ascontiguousarray(point), True, False, min(_NEAR_TRACKS, count - 1)
    )
    # Lower bound of a link: X or Y travels the distance.
    least_time = _travel_times(far, pace[0, :2].max(), pace[1, :2].max())
    tour = np.concatenate([[count], first[0]]).astype(np.int32)
    side = np.concatenate([[0], first[1]]).astype(np.uint8)
    tracks = Tracks(ends, axis_rates(pace, period), near, least_time)
    trials = min(_TRIALS_OF_SIDES * count, _MOST_OF_SIDES)
    improve_tour(tour, side, tracks, Limits(trials, _LEAST_FIRST, _MOST_PATIENCE))
    return tour[1:], side[1:].astype(np.bool_)


def axis_rates(pace: F64, period: float) -> F64:
    """Return the array ``rates`` of ``Tracks``, (4, 4); see ``short_order`` for the arguments."""
    velocity, acceleration = pace
    rates = np.zeros((4, 4))
    rates[:3] = np.column_stack(
        [velocity**2 / acceleration, 4.0 / acceleration, 1.0 / velocity, velocity / acceleration]
    )
    rates[3, 0] = period
    return rates


def link_times(entry: F64, leave: F64, origin: F64, pace: F64, period: float) -> F64:
    """Return the time of the air move before each of t tracks, (t,) s; the tracks keep their order.

    Parameters
    ----------
    entry, leave : (t, 3) x y in mm, c in degrees
        Poses at the start and the end of each track.
    origin : (3,) x y in mm, c in degrees
        Pose of the head before the first track.
    pace : (2, 3)
        Velocities (row 0) and accelerations (row 1) of X, Y and C, in mm or degrees, per s and per
        s².
    period : degrees
        Rotation of C after which the tool is the same.

    Notes
    -----
    Every axis travels its distance Δ from rest to rest, with velocity v and acceleration a.  This
    takes 2√(Δ/a) if the axis never reaches v, else Δ/v + v/a.  The slowest axis determines the
    time.
    """
    change = np.abs(entry - np.concatenate([origin[None], leave[:-1]]))
    turn = change[:, 2] % period
    change[:, 2] = np.minimum(turn, period - turn)
    times = _travel_times(change, pace[0], pace[1])
    slowest: F64 = times.max(axis=1)
    return slowest


def _travel_times(distance: F64, velocity: Any, acceleration: Any) -> F64:
    """Return the time that an axis needs to travel each distance from rest to rest (s).

    ``velocity`` and ``acceleration`` are the limits of the axis.  The arguments are broadcast
    against each other; the result has the shape of ``distance``.
    """
    ramp = distance < velocity**2 / acceleration
    times: F64 = np.where(
        ramp, 2.0 * np.sqrt(distance / acceleration), distance / velocity + velocity / acceleration
    )
    return times
