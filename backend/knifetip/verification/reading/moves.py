"""moves: what a program does, in the terms that every controller language has in common.

    program bytes -> Moves, and what is wrong with the lines

Each language has a reader of its own in this room, which shares no code with the emitter.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.verification.columns import F64, I32, I64, U8, Bool


@dataclass(frozen=True, eq=False, slots=True)
class Switches:
    """k lines that switch an output or the spindle, or call a station, in order."""

    line: I32  #: (k,) 1-based line of the program
    move: I64  #: (k,) the last move before it, -1 for none
    lowers: I32  #: (k,) index into ``machine.stations`` of the station that it lowers, or -1
    beside: Bool  #: (k, stations) which outputs are on, or not stated
    at_end: Bool  #: (stations + e + 1,) what is stated when the program ends, as ``Moves.stated``
    spindle: Bool  #: (k,) it switches the spindle and nothing else


@dataclass(frozen=True, eq=False, slots=True)
class Moves:
    """n moves of the joints, in the order of the program; NaN is a position that nobody stated."""

    line: I32  #: (n,) 1-based line of the program
    code: U8  #: (n,) 0 rapid, 1 line, 2 arc clockwise, 3 arc counter-clockwise
    start: F64  #: (n, 4) joints X Y Z in mm, C in degrees
    end: F64  #: (n, 4)
    centre: F64  #: (n, 2) mm, of arcs, in joints
    sweep: F64  #: (n,) radians, counter-clockwise positive, 0 for lines
    feed: F64  #: (n,) the F in force, NaN where there is none
    inverse: Bool  #: (n,) F is 1 / minutes (G93)
    station: I32  #: (n,) index into ``machine.stations``, -1 while none is chosen
    lowered: Bool  #: (n, stations) output on
    oscillating: Bool  #: (n,) M3
    extra: Bool  #: (n, e) output of ``tools.extra_outputs`` on
    stated: Bool  #: (n, stations + e + 1) outputs as above, and last the spindle, on or off
    blend: F64  #: (n,) mm, the larger of G64's P and Q; inf where the path is not bounded
    waited: F64  #: (n,) seconds of G4 since something was last switched, inf if never
    uses_tool_table: bool  #: stations are called by T words, so there is a tool table
    dwell: float  #: seconds of all G4
    switches: Switches
    #: the axes that the program moves; the machine itself sets depth (Z) and heading (C) otherwise
    programmed: str = "XYZC"
    #: how far rounding alone moves a printed point (mm), where that is not far below the tolerance
    resolution: float = 0.0


class ProgramReader(Protocol):
    """Reads programs of one language."""

    def placement(self, text: bytes) -> tuple[float, float] | None:
        """Return the placement that the program states (mm), None where it states none."""
        ...

    def read(
        self, text: bytes, machine: Machine, board: Board
    ) -> tuple[Moves, list[tuple[int, Message]]]:
        """Return the moves, and what is wrong: (1-based line, message), ascending.

        Nothing is assumed about who wrote the bytes.

        Raises
        ------
        ProgramUnreadable
            The text is not bytes, or too large.
        """
        ...
