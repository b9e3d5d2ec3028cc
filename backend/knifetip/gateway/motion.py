"""motion: moves of four axes, and a planner that computes the motion along them over time.

A pose is x, y, z in mm and c in degrees.  The simulated table moves as the planner computes.  For a
real machine, the gateway uses the same moves to find the point that is nearest to a reported
position, and to estimate durations.

Lengths are measured over all four axes, and a degree counts as a millimetre, as in grblHAL.  The
feed (G94) is the length that is covered per minute.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass
from typing import TypeAlias

from knifetip.model.machine import Machine

#: x, y, z (mm) and c (degrees)
Pose: TypeAlias = tuple[float, float, float, float]

#: A velocity may jump at a joint by what the axis gains in this time (s).
JOLT = 0.002
#: A move shorter than this moves nothing (mm or degrees).
NOTHING = 1e-9


@dataclass(frozen=True, slots=True)
class Limits:
    """Limits of the axes x, y, z and c: velocity, acceleration, and lowest and highest position.

    x, y and z are in mm, mm/s and mm/s²; c is in degrees, degrees/s and degrees/s².
    """

    velocity: Pose
    acceleration: Pose
    low: Pose
    high: Pose

    @classmethod
    def from_machine(cls, machine: Machine) -> Limits:
        """Return the limits of the axes of a machine."""
        x, y, z, c = machine.x, machine.y, machine.z, machine.c
        return cls(
            (x.velocity, y.velocity, z.velocity, c.velocity),
            (x.acceleration, y.acceleration, z.acceleration, c.acceleration),
            (x.low, y.low, z.low, c.low),
            (x.high, y.high, z.high, c.high),
        )


class Move:
    """A straight line, or an arc in the XY plane along which Z and C change linearly."""

    __slots__ = ("centre", "end", "length", "minutes", "rate", "start", "sweep", "travel")

    def __init__(
        self,
        start: Pose,
        end: Pose,
        *,
        centre: tuple[float, float] | None = None,
        sweep: float = 0.0,
        rate: float = math.inf,
        minutes: float = 0.0,
    ) -> None:
        self.start = start
        self.end = end
        self.centre = centre
        self.sweep = sweep  #: radians, positive counter-clockwise; 0 for a line
        self.rate = rate  #: per minute along the length; infinite for a rapid
        self.minutes = minutes  #: duration given by G93, 0 otherwise
        dx, dy, dz, dc = (b - a for a, b in zip(start, end, strict=True))
        if centre is not None:
            around = abs(sweep) * math.hypot(start[0] - centre[0], start[1] - centre[1])
            #: greatest distance of each axis per unit of length, times the length
            self.travel = (around, around, abs(dz), abs(dc))
            self.length = math.sqrt(around * around + dz * dz + dc * dc)
        else:
            self.travel = (abs(dx), abs(dy), abs(dz), abs(dc))
            self.length = math.sqrt(dx * dx + dy * dy + dz * dz + dc * dc)

    def at(self, fraction: float) -> Pose:
        """Return the pose at a fraction (0 … 1) of the length of the move."""
        if fraction >= 1.0:
            return self.end
        (x, y, z, c), end = self.start, self.end
        if self.centre is None:
            x += fraction * (end[0] - x)
            y += fraction * (end[1] - y)
        else:
            (i, j), turn = self.centre, fraction * self.sweep
            cos, sin = math.cos(turn), math.sin(turn)
            x, y = (
                i + (x - i) * cos - (y - j) * sin,
                j + (x - i) * sin + (y - j) * cos,
            )
        return x, y, z + fraction * (end[2] - z), c + fraction * (end[3] - c)

    def heading(self, fraction: float) -> Pose:
        """Return the direction of the move at one of its points.

        It is the derivative of each axis position with respect to the length covered.

        Parameters
        ----------
        fraction
            Fraction (0 … 1) of the length at which the derivative is computed.
        """
        inverse = 1.0 / self.length
        start, end = self.start, self.end
        dz, dc = (end[2] - start[2]) * inverse, (end[3] - start[3]) * inverse
        if self.centre is None:
            return (end[0] - start[0]) * inverse, (end[1] - start[1]) * inverse, dz, dc
        (i, j), turn = self.centre, fraction * self.sweep
        cos, sin = math.cos(turn), math.sin(turn)
        rx, ry = start[0] - i, start[1] - j
        pace = self.sweep * inverse
        return -pace * (rx * sin + ry * cos), pace * (rx * cos - ry * sin), dz, dc

    def nearest(self, pose: Pose) -> tuple[float, float]:
        """Return the distance from a pose to the nearest point of the move, and the point itself.

        The point is given as a fraction (0 … 1) of the length of the move.  The distance is
        measured over all four axes (mm and degrees).  On an arc, the nearest point is chosen by X
        and Y only.
        """
        start, end = self.start, self.end
        if self.centre is None:
            along = [b - a for a, b in zip(start, end, strict=True)]
            square = sum(step * step for step in along)
            fraction = 0.0
            if square > NOTHING * NOTHING:
                there = sum((p - a) * step for p, a, step in zip(pose, start, along, strict=True))
                fraction = min(max(there / square, 0.0), 1.0)
        else:
            i, j = self.centre
            first = math.atan2(start[1] - j, start[0] - i)
            angle = math.atan2(pose[1] - j, pose[0] - i) - first
            turned = (angle if self.sweep > 0 else -angle) % math.tau
            size = abs(self.sweep)
            if turned > size:
                # Beyond the arc: take the nearer end.
                turned = size if turned - size < math.tau - turned else 0.0
            fraction = turned / size
        return math.dist(pose, self.at(fraction)), fraction

    def bounds(self) -> tuple[Pose, Pose]:
        """Return two poses: the least and the greatest value of each axis along the move."""
        pairs = list(zip(self.start, self.end, strict=True))
        low, high = [min(pair) for pair in pairs], [max(pair) for pair in pairs]
        if self.centre is not None:
            i, j = self.centre
            radius = math.hypot(self.start[0] - i, self.start[1] - j)
            first = math.atan2(self.start[1] - j, self.start[0] - i)
            for quarter, (axis, side) in enumerate(((0, 1), (1, 1), (0, -1), (1, -1))):
                angle = quarter * math.pi / 2.0 - first
                turned = (angle if self.sweep > 0 else -angle) % math.tau
                if turned < abs(self.sweep):
                    extreme = (i, j)[axis] + side * radius
                    low[axis] = min(low[axis], extreme)
                    high[axis] = max(high[axis], extreme)
        return (low[0], low[1], low[2], low[3]), (high[0], high[1], high[2], high[3])

    def pace(self, limits: Limits) -> tuple[float, float]:
        """Return the greatest velocity (per s) and acceleration (per s²) along the move.

        Both are measured along the length of the move, which is computed over all four axes, mm and
        degrees alike.  No axis exceeds its limits, and the velocity is at most the programmed one.
        On an arc, the velocity is also limited by the centripetal acceleration, which must not
        exceed the limits of X and Y.
        """
        velocity = self.length / (self.minutes * 60.0) if self.minutes else self.rate / 60.0
        acceleration = math.inf
        for travel, fastest, hardest in zip(
            self.travel, limits.velocity, limits.acceleration, strict=True
        ):
            if travel > NOTHING:
                velocity = min(velocity, fastest * self.length / travel)
                acceleration = min(acceleration, hardest * self.length / travel)
        if self.centre is not None and self.travel[0] > NOTHING:
            radius = self.travel[0] / abs(self.sweep)
            hardest = min(limits.acceleration[:2])
            velocity = min(velocity, math.sqrt(hardest * radius) * self.length / self.travel[0])
        return velocity, acceleration


class _Block:
    """A queued move with its velocity, its acceleration and the planned speed at its start."""

    __slots__ = ("acceleration", "entry", "joint", "move", "tag", "velocity")

    def __init__(self, move: Move, tag: int, velocity: float, acceleration: float) -> None:
        self.move = move
        self.tag = tag
        self.velocity = velocity
        self.acceleration = acceleration
        self.joint = 0.0  #: greatest speed at the joint before it
        self.entry = 0.0  #: planned speed at its start


class Planner:
    """A queue of moves with look-ahead, and a point that moves along them.

    The speed of the point rises, stays constant and falls along each move (trapezoidal profile).
    At the joint of two moves, the velocity of an axis changes by at most the change that the axis
    can reach in ``JOLT`` seconds.  The last queued move ends at rest.
    """

    def __init__(self, limits: Limits, capacity: int, position: Pose) -> None:
        self.limits = limits
        self.capacity = capacity
        self.position = position
        self.speed = 0.0  #: along the length, per second
        self.holding = False
        self.arcs_done = 0
        self._queue: deque[_Block] = deque()
        self._along = 0.0

    def __len__(self) -> int:
        return len(self._queue)

    @property
    def full(self) -> bool:
        """Whether the queue of moves is full."""
        return len(self._queue) >= self.capacity

    @property
    def halted(self) -> bool:
        """Whether a hold was requested and the point has come to rest."""
        return self.holding and self.speed == 0.0

    @property
    def moving(self) -> bool:
        """Whether the queue contains a move and the point is not at rest in a hold."""
        return bool(self._queue) and not self.halted

    @property
    def current(self) -> Move | None:
        """The move on which the point is, None if the queue is empty."""
        return self._queue[0].move if self._queue else None

    @property
    def tag(self) -> int:
        """Number that was passed to ``append`` with the current move; 0 without a current move."""
        return self._queue[0].tag if self._queue else 0

    @property
    def fraction(self) -> float:
        """Fraction (0 … 1) of the length of the current move that the point has covered."""
        return self._along / self._queue[0].move.length if self._queue else 0.0

    def append(self, move: Move, tag: int = 0) -> None:
        """Append a move to the queue; a move of zero length is ignored, as in real planners.

        Parameters
        ----------
        move
            The move; it must begin at the end of the last queued move.
        tag
            Number that the property ``tag`` returns while the point is on the move.
        """
        if move.length <= NOTHING:
            return
        block = _Block(move, tag, *move.pace(self.limits))
        if self._queue:
            last = self._queue[-1]
            before, after = last.move.heading(1.0), move.heading(0.0)
            block.joint = min(last.velocity, block.velocity)
            for a, b, hardest in zip(before, after, self.limits.acceleration, strict=True):
                if (jump := abs(b - a)) > NOTHING:
                    block.joint = min(block.joint, hardest * JOLT / jump)
        self._queue.append(block)
        leaving = 0.0
        for queued in reversed(self._queue):
            reach = math.sqrt(leaving * leaving + 2.0 * queued.acceleration * queued.move.length)
            entry = min(queued.joint, reach)
            if queued.entry == entry and queued is not block:
                break
            queued.entry = leaving = entry

    def clear(self) -> None:
        """Discard all moves and stop the point at its present position."""
        self._queue.clear()
        self._along = self.speed = 0.0
        self.holding = False

    def advance(self, seconds: float) -> float:
        """Move the point along the current move for at most ``seconds``; return the time used (s).

        The time used is less than ``seconds`` if the point reaches the end of the current move or
        comes to rest in a hold.  It is 0 if the queue is empty or the point rests in a hold.
        Within one move, several calls have the same effect as one call with the sum of their times.
        """
        if not self.moving:
            return 0.0
        block = self._queue[0]
        rest = block.move.length - self._along
        used, gone, speed = (
            _brake(rest, self.speed, block.acceleration, seconds)
            if self.holding
            else self._travel(block, rest, seconds)
        )
        self.speed = speed
        if gone < rest:
            self._along += gone
            self.position = block.move.at(self._along / block.move.length)
            return used
        self.position = block.move.end
        self._queue.popleft()
        self._along = 0.0
        self.arcs_done += block.move.centre is not None
        if not self._queue:
            self.speed = 0.0
        return used

    def _travel(
        self, block: _Block, remaining: float, seconds: float
    ) -> tuple[float, float, float]:
        """Return the time used (s), the length covered and the new speed of the point.

        The speed follows the trapezoidal profile of the move.  Lengths are in mm and degrees alike.

        ``block``: the current move with its planned speeds.
        ``remaining``: length from the point to the end of the move.
        ``seconds``: available time (s).
        """
        a, v0 = block.acceleration, self.speed
        v1 = self._queue[1].entry if len(self._queue) > 1 else 0.0
        # After a hold the planned speed may be unreachable; it is not needed.
        v1 = min(v1, math.sqrt(v0 * v0 + 2.0 * a * remaining))
        peak = math.sqrt(max((2.0 * a * remaining + v0 * v0 + v1 * v1) / 2.0, 0.0))
        peak = max(min(peak, block.velocity), v0, v1)
        rise, fall = (peak - v0) / a, (peak - v1) / a
        ramps = (peak + v0) / 2.0 * rise + (peak + v1) / 2.0 * fall
        cruise = max(remaining - ramps, 0.0) / peak if peak > 0.0 else 0.0
        if seconds >= rise + cruise + fall:
            return rise + cruise + fall, remaining, v1
        if seconds < rise:
            return seconds, v0 * seconds + a * seconds * seconds / 2.0, v0 + a * seconds
        covered = (peak + v0) / 2.0 * rise
        if seconds < rise + cruise:
            return seconds, covered + peak * (seconds - rise), peak
        falling = seconds - rise - cruise
        covered += peak * cruise + peak * falling - a * falling * falling / 2.0
        return seconds, covered, peak - a * falling


def _brake(
    remaining: float, speed: float, deceleration: float, seconds: float
) -> tuple[float, float, float]:
    """Return the time used (s), the length covered and the new speed of a decelerating point.

    Lengths are in mm and degrees alike.  The time used is less than ``seconds`` if the point comes
    to rest or reaches the end of its move earlier.

    ``remaining``: length from the point to the end of its move.
    ``speed``: present speed (length per s).
    ``deceleration``: deceleration (length per s²).
    ``seconds``: available time (s).
    """
    if speed * speed / (2.0 * deceleration) <= remaining:
        stop = speed / deceleration
        if seconds >= stop:
            # A stop exactly at the end must complete the move.
            return stop, min(speed * stop / 2.0, remaining * (1.0 - 1e-12)), 0.0
        return (
            seconds,
            speed * seconds - deceleration * seconds * seconds / 2.0,
            speed - deceleration * seconds,
        )
    end_speed = math.sqrt(max(speed * speed - 2.0 * deceleration * remaining, 0.0))
    duration = (speed - end_speed) / deceleration
    if seconds >= duration:
        return duration, remaining, end_speed
    return (
        seconds,
        speed * seconds - deceleration * seconds * seconds / 2.0,
        speed - deceleration * seconds,
    )
