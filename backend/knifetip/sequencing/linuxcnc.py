"""linuxcnc: estimate where a LinuxCNC program halts between moves, and for how long (ADR 0008)."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.timing import STILL

#: Time of an exact stop in addition to the deceleration (s): measured, ADR 0008.
HALT: Final = 0.015
#: Deviation of the tip, at the start or the end of a turn of C, above which the program halts (mm).
BLENDED: Final = 0.005


def halts(toolpath: Toolpath, travel: F64, seconds: F64, machine: Machine) -> F64:
    """Return the time for which LinuxCNC halts after each of n rows of a toolpath, (n,) s.

    A row is one move.  In it the head turns by κ radians per mm of travel.  At a joint of two rows
    where κ changes by Δκ, the trajectory planner of LinuxCNC overlaps the two rows for the time t
    that the axes need to change their speeds.  The tip then deviates by Δκ (v t)² / 2, where v is
    the faster of the two feeds (ADR 0008).  The program halts if this deviation is more than
    ``BLENDED`` and neither row is a rapid.  It also halts between a turn without travel and a row
    with travel, unless both are rapids.

    Parameters
    ----------
    travel, seconds : (n,) and (n,)
        Length of each row along XYZ (mm), and the time of each row at its feed (s).
    machine
        Machine whose accelerations of X, Y and C determine t; the least of all carriages are used.
    """
    turn = np.radians(np.diff(toolpath.pose[:, 3]))
    moves = travel > STILL
    in_place = ~moves & (np.abs(turn) > STILL)
    bend = np.divide(turn, travel, out=np.zeros_like(turn), where=moves)
    speed = np.divide(travel, seconds, out=np.zeros_like(travel), where=seconds > 0.0)
    change = np.abs(np.diff(bend))
    fastest = np.maximum(speed[1:], speed[:-1])
    hardest = np.array([[axis.acceleration for axis in one.axes] for one in machine.carriages])
    x, y, _, c = hardest.min(axis=0)
    twist, thrust = np.radians(c), min(x, y)
    time = np.maximum(fastest / thrust, fastest * change / twist)
    deviation = change * (fastest * time) ** 2 / 2.0
    rapid = toolpath.motion == Motion.RAPID
    air, both = rapid[1:] | rapid[:-1], rapid[1:] & rapid[:-1]
    result = np.zeros(len(turn))
    result[:-1] = HALT * np.where(
        in_place[1:] != in_place[:-1], ~both, ~air & (deviation > BLENDED)
    )
    return result
