"""rest_time: the time of moves that begin and end at rest, with trapezoidal speed."""

from __future__ import annotations

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.machine import Axis


def rest_times(pose: F64, axes: tuple[Axis, ...], feed: float = 0.0) -> F64:
    """Return the times of the moves between n + 1 poses, with a stop at each pose, (n,) s.

    Each move takes the time of its slowest axis.  With a feed it takes at least the time of its
    length along X, Y and Z at the feed, with the acceleration of Z.

    Parameters
    ----------
    pose : (n + 1, 4) x y z in mm, c in degrees
        The poses; further axes before these two are carried along.
    axes
        The X, Y, Z and C axes.
    feed : mm/min
        Greatest speed of feed moves; 0 for rapids.
    """
    travel = np.abs(np.diff(pose, axis=-2))
    velocity = np.array([axis.velocity for axis in axes])
    acceleration = np.array([axis.acceleration for axis in axes])
    times: F64 = _trapezoid(travel, velocity, acceleration).max(axis=-1)
    if feed > 0.0:
        length = np.sqrt((travel[..., :3] ** 2).sum(axis=-1))
        times = np.maximum(times, _trapezoid(length, np.array(feed / 60.0), acceleration[2]))
    return times


def _trapezoid(travel: F64, velocity: F64, acceleration: F64) -> F64:
    """Return the times for distances from rest to rest, in the shape of ``travel`` (s)."""
    ramp = velocity**2 / acceleration
    short = 2.0 * np.sqrt(travel / acceleration)
    result: F64 = np.where(travel < ramp, short, travel / velocity + velocity / acceleration)
    return result
