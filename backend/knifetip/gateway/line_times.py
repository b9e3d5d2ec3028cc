"""line_times: the time that a controller with look-ahead takes for each line of a program.

As in ``motion.Planner``, the speed along each move has a trapezoidal profile, and at the joint of
two moves the velocity of an axis jumps by at most what it gains in ``JOLT``.  The machine comes to
rest before a line that waits for all motion, such as a dwell.
"""

from __future__ import annotations

import math
from array import array
from typing import NamedTuple

from knifetip.gateway.interpreter import Block
from knifetip.gateway.motion import JOLT, NOTHING, Limits, Move

#: Moves after which a run without a stop is computed as if the machine stopped there.
_LONGEST_RUN = 2000


class _PlannedMove(NamedTuple):
    line: int  #: index of the program line
    move: Move
    velocity: float
    acceleration: float
    joint: float  #: greatest speed at the start of the move


class LineTimes:
    """Collects the blocks of a program in their order, and computes the time of each.

    Parameters
    ----------
    limits
        Limits of the axes.
    """

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._run: list[_PlannedMove] = []  # moves since the machine was last at rest
        self.seconds = array("f")  #: time of each line (s); of moves after ``end`` was called

    def add(self, block: Block | None) -> None:
        """Add the block of the next line; None for a line that is refused."""
        line = len(self.seconds)
        self.seconds.append(0.0)
        if block is None:
            return
        if block.waits or block.output >= 0:
            self.end()
        self.seconds[line] = block.dwell or 0.0
        move = block.move
        if move is None or move.length <= NOTHING:
            return
        velocity, acceleration = move.pace(self._limits)
        joint = 0.0
        if self._run:
            joint = self._joint(self._run[-1], move, velocity)
        self._run.append(_PlannedMove(line, move, velocity, acceleration, joint))
        if len(self._run) >= _LONGEST_RUN:
            self.end()

    def end(self) -> None:
        """Compute the times of the moves since the machine was last at rest; it then rests."""
        run, self._run = self._run, []
        leaving = 0.0
        entries = [0.0] * (len(run) + 1)
        for place in range(len(run) - 1, -1, -1):
            one = run[place]
            reach = math.sqrt(leaving * leaving + 2.0 * one.acceleration * one.move.length)
            entries[place] = leaving = min(one.joint, reach)
        speed = 0.0
        for place, one in enumerate(run):
            length, rate = one.move.length, one.acceleration
            finish = min(entries[place + 1], math.sqrt(speed * speed + 2.0 * rate * length))
            peak = math.sqrt(rate * length + (speed * speed + finish * finish) / 2.0)
            peak = max(min(peak, one.velocity), speed, finish)
            rise, fall = (peak - speed) / rate, (peak - finish) / rate
            ramps = (peak + speed) / 2.0 * rise + (peak + finish) / 2.0 * fall
            self.seconds[one.line] += rise + fall + max(length - ramps, 0.0) / peak
            speed = finish

    def _joint(self, last: _PlannedMove, move: Move, velocity: float) -> float:
        """Return the greatest speed between two moves."""
        joint = min(last.velocity, velocity)
        before, after = last.move.heading(1.0), move.heading(0.0)
        for a, b, hardest in zip(before, after, self._limits.acceleration, strict=True):
            if (jump := abs(b - a)) > NOTHING:
                joint = min(joint, hardest * JOLT / jump)
        return joint
