"""takeover: what a controller shows of a program whose gateway was gone.

A gateway that is started again asks its controller about the program of its journal, before it
stops the machine.  A controller with ``Recalls`` names the program that it executes or has
executed, so that it is not taken for another one.  Everything that is not certain remains unknown:
then the lines of the journal are a lower bound.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice
from typing import Protocol, runtime_checkable

from knifetip.gateway.interpreter import LineInterpreter
from knifetip.gateway.motion import Pose
from knifetip.gateway.program_blocks import read_blocks

#: Greatest distance of a machine at rest from the end of its program (mm and degrees).
_AT_END = 0.01


@dataclass(frozen=True, slots=True)
class Found:
    """What a controller was doing when its gateway took over."""

    program: str  #: name of the program, as ``Recalls.program_name``
    executed: int | None = None  #: its executed lines; None if not known
    #: position at rest after the program, if nothing else has moved the machine since; else None
    rest: Pose | None = None
    begun: bool = True  #: False if it is certain that no line of it was begun


@runtime_checkable
class Recalls(Protocol):
    """Interface of a controller that reports which program it executes or executed last."""

    @property
    def program_name(self) -> str:
        """Name of the program that this connection runs, which no other program has; "" if none."""
        ...

    @property
    def found(self) -> Found | None:
        """What the machine was doing when the connection was opened to stop it; None if unknown."""
        ...


def has_ended(text: bytes, interpreter: LineInterpreter, executed: int, rest: Pose) -> bool:
    """Return whether a machine that rests at a position has executed a program to its last move.

    Parameters
    ----------
    text
        The program.
    interpreter
        Interpreter of its lines.
    executed
        Number of lines that were executed for certain.
    rest
        Position of the machine.

    Returns
    -------
    bool
        False if the program does not end at this position, or also passes it on another line that
        may not be executed: the machine may then have stopped there.
    """
    moves = [
        block.move
        for block in islice(read_blocks(text, interpreter), executed, None)
        if block is not None and block.move is not None
    ]
    near = [move.nearest(rest)[0] <= _AT_END for move in moves]
    while moves and _is_near(moves[-1].end, rest):
        moves.pop(), near.pop()
        # Only the last moves, which all end there, may touch the position.
        if not any(near):
            return True
    return False


def _is_near(first: Pose, second: Pose) -> bool:
    return all(abs(a - b) <= _AT_END for a, b in zip(first, second, strict=True))
