"""contour_starts: choose where a tool starts closed paths, so that the air moves are short.

The paths are put into a short order, at first with the starts that are nearest to the parking
position.  For this order the best starts are found by dynamic programming: the shortest way from
the parking position to each start of a path is the best of the ways over the starts of the path
before it.

The result does not depend on the order of the starts of a path, so it does not matter with which
edge a closed path begins in the drawing.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import I32
from knifetip.kernels import F64_1, F64_2, I32_1, inline_kernel, kernel
from knifetip.model.contour_starts import ContourStarts
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import Reversal
from knifetip.sequencing.head import parking_pose
from knifetip.sequencing.order import axis_rates, greedy_order, link_times
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
    first = starts.first
    if len(starts.segment) == len(first) - 1:
        return starts.segment
    x, y, _, c = machine.carriage_of(station).axes
    axes = (x, y, c)
    pace = np.array([[axis.velocity for axis in axes], [axis.acceleration for axis in axes]])
    period = station.tool.period
    rates = axis_rates(pace, period)
    head = parking_pose(station, machine)[[0, 1, 3]]
    # The order of the starts of a path decides between equally good ones: the nearest one is the
    # first, and of equally near ones the leftmost and lowest one.
    heads = np.broadcast_to(head, starts.entry.shape)
    approach = link_times(starts.entry, heads, head, pace, period)
    owner = np.repeat(np.arange(len(first) - 1), np.diff(first))
    ranked = np.lexsort((starts.entry[:, 1], starts.entry[:, 0], approach, owner))
    entry, leave = starts.entry[ranked], starts.leave[ranked]
    for poses in (entry, leave, head[None]):
        poses[:, 2] %= period
    chosen = first[:-1].astype(np.int64)
    for _ in range(_ROUNDS):
        order, _ = greedy_order(entry[None, chosen], leave[None, chosen], head, Reversal.ONE)
        chosen = _choose_in_order(order, first, head, entry, leave, rates)
    result: I32 = starts.segment[ranked[chosen]]
    return result


@inline_kernel
def _time(before: F64_1, after: F64_1, rates: F64_2) -> float:
    """Return the time of the air move between two poses (s); ``rates`` is as in ``Tracks``."""
    slowest = 0.0
    for axis in range(3):
        slowest = max(slowest, axis_time(abs(after[axis] - before[axis]), axis, rates))
    return slowest


@kernel
def _choose_in_order(
    order: I32_1, first: I32_1, head: F64_1, entry: F64_2, leave: F64_2, rates: F64_2
) -> Any:
    """Return the start of each of p paths that makes the air moves in a given order shortest, (p,).

    ``order`` (p,): the paths in their order.
    ``first`` (p + 1,): first of the k starts of each path.
    ``head`` (3,): pose of the head before the first path.
    ``entry``, ``leave`` (k, 3) and (k, 3): poses (x, y in mm, c in degrees) at which a path with
    this start begins and ends.
    ``rates`` (4, 4): as in ``Tracks``.
    """
    total = np.empty(len(entry))
    before = np.full(len(entry), -1, np.int64)
    for start in range(first[order[0]], first[order[0] + 1]):
        total[start] = _time(head, entry[start], rates)
    for place in range(1, len(order)):
        path, previous = order[place], order[place - 1]
        for start in range(first[path], first[path + 1]):
            least = np.inf
            for other in range(first[previous], first[previous + 1]):
                time = total[other] + _time(leave[other], entry[start], rates)
                if time < least:
                    least = time
                    before[start] = other
            total[start] = least
    chosen = np.empty(len(order), np.int64)
    path = order[-1]
    start = first[path] + np.argmin(total[first[path] : first[path + 1]])
    for place in range(len(order) - 1, -1, -1):
        chosen[order[place]] = start
        start = before[start]
    return chosen
