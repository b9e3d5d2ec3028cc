"""stretches: the path of the axes for an instruction, or for a move of the board's own."""

from __future__ import annotations

from knifetip.gateway.mcx314.instructions import AXES, Instruction, InstructionName
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.model.machine import Machine
from knifetip.simulators.mcx314.feeder import rate_of_arc
from knifetip.simulators.mcx314.planner import ProgramSegment

#: Rate of homing and of the lift after a lost connection, as a fraction of the axis's greatest.
SLOW = 0.2

Joints = tuple[int, int, int, int]


class StretchBuilder:
    """Builds the stretches (planned moves of the axes) of one machine.

    Parameters
    ----------
    machine
        States the greatest speeds of its axes and its travel height.
    wiring
        How the machine is connected to the chip.
    """

    def __init__(self, machine: Machine, wiring: Wiring) -> None:
        self.zero = [0, 0, 0, 0]  #: joints at the zero of programs (pulses)
        self._machine = machine
        self._wiring = wiring

    @property
    def top(self) -> int:
        """Travel height of Z (pulses)."""
        return round(self._machine.travel_z * self._wiring.pulses[2])

    def motion(self, line: int, instruction: Instruction, start: Joints) -> ProgramSegment | None:
        """Return the stretch of a motion; None if the axes are there already."""
        speed = instruction.words.get("V", 0.0)
        if instruction.name is InstructionName.GO:
            return self.rapid(line, instruction, start)
        if instruction.name is InstructionName.LINE:
            return ProgramSegment(line, start, instruction.ways, speed, instruction.joined)
        centre = instruction.pulses("I"), instruction.pulses("J")
        side = 1 if instruction.name is InstructionName.COUNTER_CLOCKWISE else -1
        return ProgramSegment(
            line,
            start,
            instruction.ways,
            rate_of_arc(speed),
            instruction.joined,
            side,
            centre,
        )

    def rapid(self, line: int, instruction: Instruction, start: Joints) -> ProgramSegment | None:
        """Return the stretch to a position in work coordinates; None if the axes are there."""
        way = [0, 0, 0, 0]
        for axis, letter in enumerate(AXES):
            if letter in instruction.words:
                way[axis] = instruction.pulses(letter) + self.zero[axis] - start[axis]
        if not any(way):
            return None
        limit = self._limit(way)
        rate = instruction.words.get("V", limit)
        x, y, z, c = way
        return ProgramSegment(line, start, (x, y, z, c), min(rate, limit), joined=False)

    def lift(self, target: int, start: Joints) -> ProgramSegment:
        """Return the slow stretch that raises Z to a joint position."""
        way = (0, 0, target - start[2], 0)
        return ProgramSegment(0, start, way, self._limit(way) * SLOW, joined=False)

    def homing(self, start: Joints) -> list[ProgramSegment]:
        """Return the stretches of a simulated homing: lift Z, then move the others to zero."""
        rate = self._fastest(2) * SLOW
        up = (0, 0, self.top - start[2], 0)
        lifted = (start[0], start[1], self.top, start[3])
        back = (-start[0], -start[1], 0, -start[3])
        return [
            ProgramSegment(0, begin, way, rate, joined=False)
            for begin, way in ((start, up), (lifted, back))
            if any(way)
        ]

    def _limit(self, way: list[int] | Joints) -> float:
        """Return the greatest rate at which no axis exceeds its limit along a way (pulses/s)."""
        seconds = max(abs(pulses) / self._fastest(axis) for axis, pulses in enumerate(way))
        return max(map(abs, way)) / seconds

    def _fastest(self, axis: int) -> float:
        """Return the greatest rate of an axis (pulses/s)."""
        machine = self._machine
        limits = (machine.x, machine.y, machine.z, machine.c)
        return limits[axis].velocity * self._wiring.pulses[axis]
