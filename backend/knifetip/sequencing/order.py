"""order: which track comes next, and from which end.

Nearest neighbour first (``nearest``); then what ``improve`` makes of it, for a counted number of
trials: never by the clock, so that the same tracks always come in the same order.  What is made
short is time: the axes' slowest on each link, C among them.  The lift is the same for every link
and so has no say.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I32, Bool
from knifetip.model.tool import Reversal
from knifetip.sequencing.improve import improve
from knifetip.sequencing.nearest import nearest_neighbour, neighbours, walk

#: A track looks for a better place beside so many of its neighbours.
_NEIGHBOURS: Final = 6
#: Swaps that are tried per track, and in all.
_TRIALS: Final = 5
_MOST_TRIALS: Final = 3_000


def greedy(entry: F64, leave: F64, origin: F64, way: Reversal) -> tuple[I32, Bool]:
    """Return the order that always goes to the nearest end, as ``shortest`` does."""
    count = entry.shape[1]
    if way == Reversal.ONE:
        order = nearest_neighbour(entry[0, :, :2], leave[0, :, :2], origin[:2])
        return order, np.zeros(count, np.bool_)
    ends = walk(entry[:, :, :2].reshape(-1, 2), leave[:, :, :2].reshape(-1, 2), origin[:2], count)
    return (ends % count).astype(np.int32), ends >= count


def shortest(
    entry: F64, leave: F64, origin: F64, pace: F64, period: float, way: Reversal
) -> tuple[I32, Bool]:
    """Return a short order of tracks, (t,), and which of them to run from their far end, (t,).

    Parameters
    ----------
    entry, leave : (2, t, 3) x y in mm, c in degrees
        Where the head begins and ends each track, run as it is and run from its far end.
    origin : (3,)
        Where the head is before.
    pace : (2, 3)
        Velocities and accelerations of X, Y and C.
    period : degrees
        After which the tool is the same again.
    """
    count = entry.shape[1]
    order, flip = greedy(entry, leave, origin, way)
    if count < 2:
        return order, flip
    # The origin is one more track, which comes first and stays there.
    place = np.broadcast_to(origin, (2, 1, 3))
    ends = np.stack(
        [np.concatenate([entry, place], axis=1), np.concatenate([leave, place], axis=1)], axis=1
    )
    ends[..., 2] %= period
    tour = np.concatenate([[count], order]).astype(np.int32)
    side = np.concatenate([[0], flip]).astype(np.uint8)
    near, far = neighbours(
        np.ascontiguousarray(entry[0, :, :2]),
        np.ascontiguousarray(leave[0, :, :2]),
        min(_NEIGHBOURS, count - 1),
    )
    velocity, acceleration = pace
    # Of each axis: where its ramps meet, 4/a, 1/v and v/a; below them the period of C.
    rates = np.zeros((4, 4))
    rates[:3] = np.column_stack(
        [velocity**2 / acceleration, 4.0 / acceleration, 1.0 / velocity, velocity / acceleration]
    )
    rates[3, 0] = period
    # No link to a neighbour can be faster: of two axes one has to go 1/√2 of the way.
    quick = np.array([pace[0, :2].max(), pace[1, :2].max()])
    floor = _rest_to_rest(far / math.sqrt(2.0), quick[0], quick[1])
    trials = min(_TRIALS * count, _MOST_TRIALS)
    improve(tour, side, ends, rates, int(way), near, floor, trials)
    return tour[1:], side[1:].astype(np.bool_)


def link_times(entry: F64, leave: F64, origin: F64, pace: F64, period: float) -> F64:
    """Return the time of the link before each track, (t,) s, in the order in which they stand.

    Parameters
    ----------
    entry, leave : (t, 3) x y in mm, c in degrees
    origin, pace, period
        As for ``shortest``.

    Notes
    -----
    Every axis from rest to rest: 2√(Δ/a) where it never reaches v, Δ/v + v/a where it does; the
    slowest axis says how long the link takes.
    """
    change = np.abs(entry - np.concatenate([origin[None], leave[:-1]]))
    around = change[:, 2] % period
    change[:, 2] = np.minimum(around, period - around)
    times = _rest_to_rest(change, pace[0], pace[1])
    slowest: F64 = times.max(axis=1)
    return slowest


def _rest_to_rest(way: F64, velocity: Any, acceleration: Any) -> F64:
    """Return how long an axis takes for a way."""
    ramp = way < velocity**2 / acceleration
    times: F64 = np.where(
        ramp, 2.0 * np.sqrt(way / acceleration), way / velocity + velocity / acceleration
    )
    return times
