"""planner: divide segments into pieces that a chip drives without losing steps.

The chip ramps from the speed that it has towards the drive speed of each piece, and does not look
ahead.  The planner therefore computes how fast each segment may end, from the loaded segments that
join it, and ends the last of them at a rate at which the axes can stop.  It divides a segment where
the chip must begin to decelerate, and lowers the drive speed of the rest.

Pieces last at most ``LONGEST``, so that a hold takes effect soon.  All rates are those of the steps
of the chip: pulses/s of the axis with the most pulses, or steps along an arc.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from knifetip.languages.mcx314.wiring import Wiring

#: Longest piece (s).
LONGEST: Final = 0.05
#: Length of the straight and diagonal steps along an octant of a circle, divided by its own length:
#: the chip keeps the speed along the steps constant.
STAIRS: Final = 8.0 / math.pi * (math.sqrt(2.0) - 1.0)
#: The greatest such ratio on a part of an octant.
MOST_STAIRS: Final = 1.0824
#: A piece lasts this many times as long as the writing of the next one takes at most.
SPARE: Final = 1.5

_Point = tuple[int, int, int, int]


@dataclass(frozen=True, slots=True)
class ProgramSegment:
    """A line or an arc between two positions of the axes X, Y, Z and C (pulses)."""

    line: int  #: line of the program
    start: _Point
    way: _Point
    rate: float  #: greatest rate of steps (pulses/s)
    joined: bool
    side: int = 0  #: 1 for an arc counter-clockwise, -1 for clockwise, 0 for a line
    centre: tuple[int, int] = (0, 0)  #: of an arc, relative to its start

    @property
    def radius(self) -> float:
        """Radius of an arc (pulses)."""
        return math.hypot(*self.centre)

    @property
    def sweep(self) -> float:
        """Angle of an arc (radians), counter-clockwise positive."""
        first = math.atan2(-self.centre[1], -self.centre[0])
        last = math.atan2(self.way[1] - self.centre[1], self.way[0] - self.centre[0])
        return self.side * (self.side * (last - first) % math.tau)

    @property
    def steps(self) -> int:
        """Least number of steps."""
        if self.side:
            return max(int(self.radius * abs(self.sweep)), 1)
        return max(map(abs, self.way))

    @property
    def most(self) -> float:
        """Greatest length of the steps, divided by ``steps``."""
        return MOST_STAIRS if self.side else 1.0

    def ratios(self, fraction: float) -> tuple[float, ...]:
        """Return the rate of each axis per rate of steps, at a fraction of the length."""
        if not self.side:
            return tuple(pulses / self.steps for pulses in self.way)
        angle = math.atan2(-self.centre[1], -self.centre[0]) + fraction * self.sweep
        pace = self.side / STAIRS
        return -pace * math.sin(angle), pace * math.cos(angle), 0.0, 0.0

    def position(self, step: int) -> _Point:
        """Return the position after a number of steps (pulses)."""
        if step >= self.steps:
            x, y, z, c = (a + b for a, b in zip(self.start, self.way, strict=True))
            return x, y, z, c
        if not self.side:
            count = self.steps
            x, y, z, c = (
                at + _share(pulses, step, count)
                for at, pulses in zip(self.start, self.way, strict=True)
            )
            return x, y, z, c
        i, j = self.start[0] + self.centre[0], self.start[1] + self.centre[1]
        angle = math.atan2(-self.centre[1], -self.centre[0]) + step / self.steps * self.sweep
        exact = i + self.radius * math.cos(angle), j + self.radius * math.sin(angle)
        near = [
            (math.floor(exact[0]) + dx, math.floor(exact[1]) + dy) for dx in (0, 1) for dy in (0, 1)
        ]
        # The chip refuses ends that are not on the circle.
        x, y = min(near, key=lambda at: abs(math.hypot(at[0] - i, at[1] - j) - self.radius))
        return x, y, self.start[2], self.start[3]


def _share(pulses: int, step: int, count: int) -> int:
    size = (2 * step * abs(pulses) + count) // (2 * count)
    return size if pulses > 0 else -size


@dataclass(frozen=True, slots=True)
class Piece:
    """A part of a stretch, from one step to another, with the drive speed of the chip."""

    stretch: ProgramSegment
    first: int
    last: int
    rate: float  #: drive speed (pulses/s)
    end: float  #: greatest speed at its end (pulses/s)

    @property
    def completes(self) -> bool:
        """Whether it is the last piece of its stretch."""
        return self.last >= self.stretch.steps


class Planner:
    """Computes the pieces of stretches.

    Parameters
    ----------
    wiring
        How the machine is connected to its chip.
    """

    def __init__(self, wiring: Wiring) -> None:
        self._wiring = wiring

    def rest(self, stretch: ProgramSegment) -> float:
        """Return the rate at which a stretch can begin and end at rest (pulses/s)."""
        return min(float(self._wiring.start), self._whole(stretch.rate))

    def joins(self, before: ProgramSegment, after: ProgramSegment) -> bool:
        """Return whether a stretch can begin without a stop after another."""
        slowest = min(self.rest(before), self.rest(after))
        return after.joined and self._joint(before, after) >= slowest

    def piece(
        self,
        stretch: ProgramSegment,
        step: int,
        speed: float,
        ahead: Sequence[ProgramSegment],
        *,
        stopping: bool,
    ) -> Piece:
        """Return the next piece of a stretch.

        Parameters
        ----------
        stretch, step
            The stretch, and the step at which the piece begins.
        speed
            Rate at the start of the piece (pulses/s).
        ahead
            Loaded stretches that follow it.
        stopping
            Whether to stop as soon as possible.
        """
        rest = self.rest(stretch)
        left = stretch.steps - step
        if stopping:
            way = math.ceil(max(speed * speed - rest * rest, 0.0) / (2.0 * self._steepness))
            count = self._limit_steps(max(way, self._least_steps(rest)), left, speed)
            return self._piece(stretch, step, count, speed, rest)
        end = self._whole(self._exit(stretch, ahead))
        top = self._whole(stretch.rate)
        reached = math.sqrt(self._steepness * left + (speed * speed + end * end) / 2.0)
        peak = self._whole(min(top, reached))
        brake = max(math.ceil((peak * peak - end * end) / (2.0 * self._steepness)), 0)
        if peak > end:
            brake = max(brake, self._least_steps(peak))
        cruise = left - brake
        if peak <= end or cruise < self._least_steps(peak):
            return self._piece(
                stretch, step, self._limit_steps(left, left, max(speed, end)), speed, end
            )
        count = self._limit_steps(cruise, cruise, peak)
        return self._piece(stretch, step, count, speed, peak)

    def _piece(
        self, stretch: ProgramSegment, step: int, count: int, speed: float, rate: float
    ) -> Piece:
        change = 2.0 * self._steepness * count
        if speed > rate:
            end = math.sqrt(max(speed * speed - change, rate * rate))
        else:
            end = math.sqrt(min(speed * speed + change * stretch.most, rate * rate))
        return Piece(stretch, step, step + count, rate, end)

    def _limit_steps(self, count: int, left: int, rate: float) -> int:
        """Return ``count`` limited to ``LONGEST``; the steps that remain are none, or enough for a
        piece.
        """
        count = min(count, left)
        most = max(int(rate * LONGEST), self._least_steps(rate))
        if count > most:
            count = most
        return left if left - count < self._least_steps(rate) else count

    def _exit(self, stretch: ProgramSegment, ahead: Sequence[ProgramSegment]) -> float:
        """Return the greatest rate at the end of a stretch, from which the rest can be driven."""
        chain = [stretch]
        far = 0.0
        reach = stretch.rate * stretch.rate / (2.0 * self._steepness)
        for following in ahead:
            if far > reach or not self.joins(chain[-1], following):
                break
            chain.append(following)
            far += following.steps
        speed = self.rest(chain[-1])
        for before, after in zip(chain[-2::-1], chain[:0:-1], strict=True):
            entry = math.sqrt(speed * speed + 2.0 * self._steepness * after.steps)
            speed = min(self._joint(before, after), entry)
        return speed

    def _joint(self, before: ProgramSegment, after: ProgramSegment) -> float:
        """Return the greatest rate between two stretches at which no axis loses steps.

        An axis may change its rate at once by as much as it can begin with at rest.
        """
        most = min(before.rate, after.rate)
        for one, other in zip(before.ratios(1.0), after.ratios(0.0), strict=True):
            if (jump := abs(one - other)) > 0.0:
                most = min(most, self._wiring.start / jump)
        return most

    @property
    def _steepness(self) -> float:
        return float(self._wiring.acceleration)

    def _least_steps(self, rate: float) -> int:
        """Return the steps that last long enough to write the next piece."""
        return math.ceil(SPARE * self._wiring.refill * rate)

    def _whole(self, rate: float) -> float:
        """Return the greatest rate that the speed register can contain, up to a given one."""
        multiple = self._wiring.multiple
        return float(max(math.floor(rate / multiple + 1e-9), 1) * multiple)
