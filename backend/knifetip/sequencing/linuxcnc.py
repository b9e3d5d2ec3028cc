"""linuxcnc: where a LinuxCNC program halts, and what that costs (ADR 0008)."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.timing import STILL

#: What an exact stop costs besides slowing down (s): measured, ADR 0008.
HALT: Final = 0.015
#: How far the tip may leave the path where C begins or ends to turn, before a halt (mm).
BLENDED: Final = 0.005


def halts(toolpath: Toolpath, travel: F64, seconds: F64, machine: Machine) -> F64:
    """Return how long the controller halts after each row, (n,) s: the estimate of ADR 0008.

    Where C begins or ends to turn, its planner overlaps both rows for the time t in which the
    slower axis changes its speed, and the tip is off by Δκ (v t)² / 2, κ the turn of C per mm.
    """
    turn = np.radians(np.diff(toolpath.pose[:, 3]))
    moves = travel > STILL
    alone = ~moves & (np.abs(turn) > STILL)
    bend = np.divide(turn, travel, out=np.zeros_like(turn), where=moves)
    speed = np.divide(travel, seconds, out=np.zeros_like(travel), where=seconds > 0.0)
    change = np.abs(np.diff(bend))
    fastest = np.maximum(speed[1:], speed[:-1])
    twist = np.radians(machine.c.acceleration)
    thrust = min(machine.x.acceleration, machine.y.acceleration)
    time = np.maximum(fastest / thrust, fastest * change / twist)
    aside = change * (fastest * time) ** 2 / 2.0
    rapid = toolpath.motion == Motion.RAPID
    air, both = rapid[1:] | rapid[:-1], rapid[1:] & rapid[:-1]
    result = np.zeros(len(turn))
    result[:-1] = HALT * np.where(alone[1:] != alone[:-1], ~both, ~air & (aside > BLENDED))
    return result
