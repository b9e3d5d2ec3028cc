"""The moves of a program in a form that is independent of the controller language.

Each language (HPGL, and RS274/NGC with its dialects) has its own reader in this package, which
converts the program's bytes to moves and faults.  A reader shares no code with the emitter of its
language.
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
    """The k program lines, in order, that switch an output or the spindle or select a station."""

    line: I32  #: (k,) 1-based line of the program
    move: I64  #: (k,) index of the last move before the line, -1 for none
    lowers: I32  #: (k,) index into ``machine.stations`` of the station that the line lowers, or -1
    beside: Bool  #: (k, stations) the station's output is on or unknown after the line
    at_end: Bool  #: (stations + e + 1,) ``Moves.stated`` at the end of the program
    spindle: Bool  #: (k,) the line switches only the spindle


@dataclass(frozen=True, eq=False, slots=True)
class Moves:
    """n moves of the machine's joints in program order; NaN marks an unknown position."""

    line: I32  #: (n,) 1-based line of the program
    code: U8  #: (n,) 0 rapid, 1 line, 2 arc clockwise, 3 arc counter-clockwise
    #: (n, 4) joints X Y Z in mm, C in degrees, of the carriage of the selected station; of the
    #: first carriage if no station is selected
    start: F64
    end: F64  #: (n, 4)
    centre: F64  #: (n, 2) mm, of arcs, in joints
    sweep: F64  #: (n,) radians, counter-clockwise positive, 0 for lines
    feed: F64  #: (n,) F in force, NaN if there is none
    inverse: Bool  #: (n,) ``feed`` is 1 / duration in minutes (G93)
    station: I32  #: (n,) index into ``machine.stations``, -1 for none
    lowered: Bool  #: (n, stations) the station's output is on
    oscillating: Bool  #: (n,) the spindle is on (M3 or M4)
    extra: Bool  #: (n, e) outputs of ``tools.extra_outputs`` that are on
    stated: Bool  #: (n, stations + e + 1) the program has set stations, extra outputs, spindle
    blend: F64  #: (n,) mm, corner rounding: larger of P and Q of G64; inf without a limit
    rested: Bool  #: (n,) the head is at rest between the move before and this move
    waited: F64  #: (n,) seconds of dwell since the last switching, inf before the first
    uses_tool_table: bool  #: the controller has a tool table: T words select stations
    dwell: float  #: sum of all dwells (s)
    switches: Switches
    #: joints of all axes of the machine, in the order of ``Machine.axes``, before and after each
    #: move: (n, axes), mm and degrees
    axes_start: F64
    axes_end: F64
    #: axes that the program moves; the machine controls depth (Z) and heading (C) itself otherwise
    programmed: str = "XYZC"
    #: greatest shift of a point by the rounding of coordinates (mm); 0 if it is negligible
    resolution: float = 0.0
    #: greatest shift of a height by the rounding of coordinates (mm); 0 if it is negligible
    height_resolution: float = 0.0
    #: least duration of a move that another one follows without a stop (s); 0 if there is none
    shortest: float = 0.0


class ProgramReader(Protocol):
    """Interface of a reader of programs in one controller language (HPGL or a dialect of
    RS274/NGC).
    """

    def placement(self, text: bytes) -> tuple[float, float] | None:
        """Return the placement that the program's comments state, or None if they state none.

        The placement is the offset (x, y) in mm from the drawing's to the sheet's coordinates.
        """
        ...

    def read(
        self, text: bytes, machine: Machine, board: Board
    ) -> tuple[Moves, list[tuple[int, Message]]]:
        """Return the moves of a program, and its faults (1-based line, message) in ascending order.

        The bytes may come from any source; wrong lines give faults, not exceptions.

        Raises
        ------
        ProgramUnreadable
            The text is not of type bytes, or is too large.
        """
        ...
