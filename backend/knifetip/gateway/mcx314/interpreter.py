"""interpreter: the effect of each line of a program for an MCX314, as blocks to be followed."""

from __future__ import annotations

import math

from knifetip.gateway.interpreter import EMPTY_BLOCK, Block, LineRefused
from knifetip.gateway.mcx314.instructions import (
    AXES,
    SEGMENTS,
    BadLine,
    Instruction,
    InstructionName,
    parse,
)
from knifetip.gateway.motion import Move, Pose


class Mcx314Interpreter:
    """Interprets the program lines one by one, and keeps the position of the axes.

    Parameters
    ----------
    pulses
        Pulses per mm of X, Y and Z, and per degree of C.
    position
        Present position of the axes.
    """

    def __init__(self, pulses: Pose, position: Pose) -> None:
        self._pulses = pulses
        self.position = position

    def read(self, line: bytes) -> Block:
        """Return the effect of a program line.

        Raises
        ------
        LineRefused
            The line is not an instruction.
        """
        try:
            instruction = parse(line.decode("latin-1"))
        except BadLine:
            raise LineRefused(2) from None
        match instruction.name:
            case InstructionName.OUT:
                return Block(output=instruction.output, on=instruction.on)
            case InstructionName.OSC:
                return Block(oscillation=instruction.on)
            case InstructionName.DWELL:
                return Block(dwell=instruction.number / 1e3)
            case InstructionName.END:
                return Block(end=True)
            case (
                InstructionName.GO
                | InstructionName.LINE
                | InstructionName.CLOCKWISE
                | InstructionName.COUNTER_CLOCKWISE
            ):
                move = self._move(instruction)
                self.position = move.end
                return Block(move=move)
            case _:
                return EMPTY_BLOCK

    def _move(self, instruction: Instruction) -> Move:
        start, pose = self.position, list(self.position)
        for axis, letter in enumerate(AXES):
            if letter in instruction.words:
                value = instruction.words[letter] / self._pulses[axis]
                pose[axis] = value if instruction.name is InstructionName.GO else pose[axis] + value
        end = (pose[0], pose[1], pose[2], pose[3])
        if instruction.name not in SEGMENTS:
            return Move(start, end)
        speed = max(instruction.words.get("V", 0.0), 1.0)
        if instruction.name is InstructionName.LINE:
            return Move(start, end, minutes=max(map(abs, instruction.ways)) / speed / 60.0)
        i, j = instruction.pulses("I"), instruction.pulses("J")
        x, y, *_ = instruction.ways
        side = 1 if instruction.name is InstructionName.COUNTER_CLOCKWISE else -1
        turn = math.atan2(y - j, x - i) - math.atan2(-j, -i)
        sweep = side * (side * turn % math.tau)
        centre = start[0] + i / self._pulses[0], start[1] + j / self._pulses[1]
        minutes = math.hypot(i, j) * abs(sweep) / speed / 60.0
        return Move(start, end, centre=centre, sweep=sweep, minutes=max(minutes, 1e-9))
