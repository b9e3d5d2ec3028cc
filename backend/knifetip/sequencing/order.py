"""order: choose the order of the tracks, and the end at which each track starts.

A track is a path that a tool follows without lifting.  A nearest-neighbour tour is shortened by
local search.  The number of trials depends only on the number of tracks, so that the same tracks
always get the same order.  The cost of the air move between two tracks is the time of the slowest
of the axes X, Y and C.  Lifts are left out, since they take the same time in every air move.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I32, Bool
from knifetip.model.tool import Reversal
from knifetip.sequencing.improve import improve_tour
from knifetip.sequencing.nearest import find_neighbours, nearest_neighbour, nearest_walk
from knifetip.sequencing.tour import Tracks

#: Number of neighbours beside which a better position of a track is tried.
_NEIGHBOURS: Final = 6
#: Greatest number of random swaps per track, and of all of them.
_TRIALS: Final = 5
_MOST_TRIALS: Final = 3_000


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
    pace : (2, 3)
        Velocities (row 0) and accelerations (row 1) of X, Y and C, in mm or degrees, per s and per
        s².
    period : degrees
        Rotation of C after which the tool is the same.
    reversal
        Ends of a track at which the tool may start.
    """
    count = entry.shape[1]
    order, flip = greedy_order(entry, leave, origin, reversal)
    if count < 2:
        return order, flip
    # The origin is one more track, fixed in the first position.
    origin_pose = np.broadcast_to(origin, (2, 1, 3))
    ends = np.empty((count + 1, 2, 2, 3))
    ends[:, :, 0] = np.concatenate([entry, origin_pose], axis=1).swapaxes(0, 1)
    ends[:, :, 1] = np.concatenate([leave, origin_pose], axis=1).swapaxes(0, 1)
    ends[..., 2] %= period
    tour = np.concatenate([[count], order]).astype(np.int32)
    side = np.concatenate([[0], flip]).astype(np.uint8)
    near, far = find_neighbours(
        np.ascontiguousarray(entry[0, :, :2]),
        np.ascontiguousarray(leave[0, :, :2]),
        min(_NEIGHBOURS, count - 1),
    )
    # Lower bound of a link: one of the axes X and Y travels at least 1/√2 of the distance.
    fastest = np.array([pace[0, :2].max(), pace[1, :2].max()])
    least_time = _travel_times(far / math.sqrt(2.0), fastest[0], fastest[1])
    trials = min(_TRIALS * count, _MOST_TRIALS)
    tracks = Tracks(ends, axis_rates(pace, period), int(reversal), near, least_time)
    improve_tour(tour, side, tracks, trials)
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
