"""look_ahead: the times of moves on a controller with look-ahead (``timing``).

Every move has a trapezoidal speed profile within the limits of all axes.  Look-ahead keeps the
speed at tangent joints and stops the head at corners.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, Bool
from knifetip.kernels import F64_1, F64_2, Bool_1, kernel
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Toolpath
from knifetip.sequencing.moves import STILL, Arcs, Limits, Moves

#: At a joint the velocity of an axis may jump by its acceleration times this (s).
JOLT: Final = 0.002


def look_ahead(moves: Moves, rests: Bool, toolpath: Toolpath, machine: Machine) -> F64:
    """Return the time of each of n moves on a controller with look-ahead, (n,) s.

    See ``timing.Timing`` for the arguments.

    At a joint of two moves the velocity of axis i jumps by at most aᵢ · ``JOLT``, with the
    greatest acceleration aᵢ of the axis.
    """
    del toolpath, machine
    times: F64 = _simulate(moves.pose, moves.arcs, moves.limits, moves.hardest * JOLT, rests)
    return times


@kernel(checks_division=True)
def _simulate(pose: F64_2, arcs: Arcs, limits: Limits, jolt: F64_1, stops: Bool_1) -> Any:
    """Return the time that the machine takes for each of n rows of a toolpath, (n,) s.

    The highest permitted speed at each joint between two rows is reduced from the last row back to
    the first, so that the machine can always slow down in time.  Then each row gets a trapezoidal
    speed profile.

    ``pose`` (n + 1, 4): poses before and after each row.
    ``arcs``, ``limits``: the rows that are arcs, and the figures of all rows; rows of length 0 take
    no time.
    ``jolt`` (4,): greatest permitted jump of the velocity of each axis at a joint.
    ``stops`` (n,): mask of the rows at whose start the machine is at rest.
    """
    length, velocity, acceleration = limits.length, limits.velocity, limits.acceleration
    count = len(length)
    times = np.zeros(count)
    entry = np.zeros(count)
    # Change of each axis per unit of length, at the start of a row and at the end of the last one.
    rate_of, rate_before = np.zeros(4), np.zeros(4)
    next_arc = 0
    before = -1
    rest = True
    for row in range(count):
        rest = rest or stops[row]
        is_arc = next_arc < len(arcs.row) and arcs.row[next_arc] == row
        next_arc += is_arc
        if length[row] <= STILL:
            continue
        for axis in range(4):
            rate_of[axis] = (pose[row + 1, axis] - pose[row, axis]) / length[row]
        if is_arc:
            for axis in range(2):
                rate_of[axis] = arcs.begin[next_arc - 1, axis] / length[row]
        if before >= 0 and not rest:
            joint = min(velocity[before], velocity[row])
            for axis in range(4):
                jump = abs(rate_of[axis] - rate_before[axis])
                if jump > 1e-9:
                    joint = min(joint, jolt[axis] / jump)
            entry[row] = joint
        rate_before[:] = rate_of
        if is_arc:
            for axis in range(2):
                rate_before[axis] = arcs.finish[next_arc - 1, axis] / length[row]
        before = row
        rest = False
    leaving = 0.0
    for row in range(count - 1, -1, -1):
        if length[row] > STILL:
            reach = math.sqrt(leaving * leaving + 2.0 * acceleration[row] * length[row])
            entry[row] = leaving = min(entry[row], reach)
    speed = 0.0
    row = 0
    while row < count:
        after = row + 1
        while after < count and length[after] <= STILL:
            after += 1
        if length[row] > STILL:
            rate, distance = acceleration[row], length[row]
            reach = math.sqrt(speed * speed + 2.0 * rate * distance)
            finish = min(entry[after] if after < count else 0.0, reach)
            peak = math.sqrt(rate * distance + (speed * speed + finish * finish) / 2.0)
            peak = max(min(peak, velocity[row]), speed, finish)
            rise, fall = (peak - speed) / rate, (peak - finish) / rate
            ramps = (peak + speed) / 2.0 * rise + (peak + finish) / 2.0 * fall
            times[row] = rise + fall + max(distance - ramps, 0.0) / peak
            speed = finish
        row = after
    return times
