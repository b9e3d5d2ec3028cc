"""contour_starts: choose where a tool starts closed paths, so that the air moves are short.

The paths are put into a short order with their first starts.  For this order the best starts are
found by dynamic programming: the shortest way to each start of a path is the best of the ways over
the starts of the path before it.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import I32
from knifetip.kernels import F64_2, I32_1, kernel
from knifetip.model.contour_starts import ContourStarts
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import Reversal
from knifetip.sequencing.order import axis_rates, greedy_order
from knifetip.sequencing.tour import axis_time

#: Numbers of orders for which the starts are chosen.
_ROUNDS: Final = 2


def choose_starts(starts: ContourStarts, station: Station, machine: Machine) -> I32:
    """Return the segment with which each of p paths should begin, (p,).

    Parameters
    ----------
    starts
        Possible starts of the p paths of one operation.
    station, machine
        Station and machine that run the operation.
    """
    chosen = starts.first[:-1].astype(np.int64)
    if len(starts.segment) == len(chosen):
        return starts.segment
    x, y, _, c = machine.carriage_of(station).axes
    axes = (x, y, c)
    pace = np.array([[axis.velocity for axis in axes], [axis.acceleration for axis in axes]])
    period = station.tool.period
    rates = axis_rates(pace, period)
    entry, leave = starts.entry.copy(), starts.leave.copy()
    entry[:, 2] %= period
    leave[:, 2] %= period
    for _ in range(_ROUNDS):
        order, _ = greedy_order(entry[None, chosen], leave[None, chosen], np.zeros(3), Reversal.ONE)
        chosen = _choose_in_order(order, starts.first, entry, leave, rates)
    result: I32 = starts.segment[chosen]
    return result


@kernel
def _choose_in_order(order: I32_1, first: I32_1, entry: F64_2, leave: F64_2, rates: F64_2) -> Any:
    """Return the start of each of p paths that makes the air moves in a given order shortest, (p,).

    Parameters
    ----------
    order : (p,)
        The paths in their order.
    first : (p + 1,)
        First of the k starts of each path.
    entry, leave : (k, 3) and (k, 3)
        Poses (x, y in mm, c in degrees) at which a path with this start begins and ends.
    rates : (4, 4)
        As in ``Tracks``.
    """
    total = np.zeros(len(entry))
    before = np.full(len(entry), -1, np.int64)
    for place in range(1, len(order)):
        path, previous = order[place], order[place - 1]
        for start in range(first[path], first[path + 1]):
            least = np.inf
            for other in range(first[previous], first[previous + 1]):
                slowest = 0.0
                for axis in range(3):
                    distance = abs(entry[start, axis] - leave[other, axis])
                    slowest = max(slowest, axis_time(distance, axis, rates))
                if total[other] + slowest < least:
                    least = total[other] + slowest
                    before[start] = other
            total[start] = least
    chosen = np.empty(len(order), np.int64)
    path = order[-1]
    start = first[path] + np.argmin(total[first[path] : first[path + 1]])
    for place in range(len(order) - 1, -1, -1):
        chosen[order[place]] = start
        start = before[start]
    return chosen
