"""Reader of programs for boards with the motion chip MCX314.

A program is a table of segments in pulses (docs/mcx314-programs.md).  Air moves state positions;
lines and arcs state signed distances from where the last one ended, so the reader adds them up.
The drive speed of a line is that of its axis with the most pulses, and the drive speed of an arc is
that along the arc.  Outputs, oscillation and dwells wait until the machine is at rest.

A segment that joins the one before it is written to the chip while that one is executed.  If that
one is shorter than the writing takes, the chip stops in the board without notice.

Source: the description of the format; for the limits of the chip, ``languages.mcx314.figures``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from operator import itemgetter
from typing import Final

import numpy as np

from knifetip.errors import ProgramUnreadable
from knifetip.languages.mcx314 import figures
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.verification.reading.moves import Moves, Switches
from knifetip.verification.tools import expected_tool, extra_outputs

#: Greatest size of a program: bytes and lines.
MAX_BYTES: Final = 64 << 20
MAX_LINES: Final = 2_000_000
#: Greatest difference between the radii at both ends of an arc (pulses).
ROUND: Final = 1.0
_MAX_FAULTS: Final = 1000

_POSITION: Final = r"(?:0|-?[1-9]\d{0,8})"
_WAY: Final = r"-?[1-9]\d{0,8}"
_SPEED: Final = r" V([1-9]\d{0,7})( JOIN)?"
_PLACEMENT: Final = re.compile(rb"^; placement X(-?\d+\.\d+) Y(-?\d+\.\d+)$", re.MULTILINE)


def _axes(number: str) -> str:
    return "".join(rf"(?: {letter}({number}))?" for letter in "XYZC")


_GO: Final = re.compile(rf"GO{_axes(_POSITION)}")
_LINE: Final = re.compile(rf"LINE{_axes(_WAY)}{_SPEED}")
_ARC: Final = re.compile(
    rf"(CW|CCW) X({_POSITION}) Y({_POSITION}) I({_POSITION}) J({_POSITION}){_SPEED}"
)
_OUT: Final = re.compile(r"OUT (0|[1-9]\d?) (ON|OFF)")
_OSC: Final = re.compile(r"OSC (ON|OFF)")
_DWELL: Final = re.compile(r"DWELL ([1-9]\d{0,5})")
_PULSES: Final = re.compile(
    "PULSES " + " ".join(rf"{letter}([1-9]\d*(?:\.\d+)?|0\.\d+)" for letter in "XYZC")
)

_Faults = list[tuple[int, Message]]
#: A move before it is a row of ``Moves``: line, code, start, end, centre, sweep and minutes.
_Move = tuple[int, int, list[float], list[float], tuple[float, float], float, float]


@dataclass(slots=True)
class _State:
    """The machine after a line of the program."""

    #: joints in pulses, NaN for an axis whose position no line has stated
    at: list[float] = field(default_factory=lambda: [math.nan] * 4)
    on: dict[int, int] = field(default_factory=dict)  #: outputs that are on: when switched
    stated: set[int] = field(default_factory=set)  #: outputs that a line has switched
    oscillates: bool = False
    osc_stated: bool = False
    waited: float = math.inf  #: dwell since the last switching (s)
    dwell: float = 0.0
    seconds: float = -1.0  #: duration of the segment of the line before; negative if it is none
    switched: int = 0
    unready: bool = False  #: a move began too early after the last switching


class Mcx314Reader:
    """Reader of programs for the board and the chip in the machine's file."""

    def placement(self, text: bytes) -> tuple[float, float] | None:
        """Return the placement that the program's comments state, or None if they state none.

        The placement is the offset (x, y) in mm from the drawing's to the sheet's coordinates.
        """
        match = _PLACEMENT.search(text)
        return (float(match[1]), float(match[2])) if match else None

    def read(self, text: bytes, machine: Machine, board: Board) -> tuple[Moves, _Faults]:
        """Return the moves of a program, and its faults (1-based line, message) in ascending order.

        Raises
        ------
        ProgramUnreadable
            The machine's file describes no MCX314, or the text is too large.
        """
        del board  # the program moves every axis
        wiring = machine.controller
        if not isinstance(wiring, Wiring):
            raise ProgramUnreadable("mcx314.no-wiring", machine=machine.title)
        if len(text) > MAX_BYTES:
            raise ProgramUnreadable("program.too-large", bytes=len(text), limit=MAX_BYTES)
        if text.count(b"\n") > MAX_LINES:
            lines = text.count(b"\n")
            raise ProgramUnreadable("program.too-many-moves", moves=lines, limit=MAX_LINES)
        interpretation = _Interpretation(machine, wiring)
        interpretation.run(text)
        return interpretation.moves(), sorted(interpretation.faults, key=itemgetter(0))


READER: Final = Mcx314Reader()


class _Interpretation:
    """Executes the lines of a program one by one and collects moves, switchings and faults."""

    def __init__(self, machine: Machine, wiring: Wiring) -> None:
        self._machine = machine
        self._wiring = wiring
        self._state = _State()
        self._stations = machine.stations
        self._by_output: Mapping[int, list[int]] = {
            output: [index for index, held in enumerate(self._stations) if held.output == output]
            for output in machine.outputs
        }
        fixed = [index for index, held in enumerate(self._stations) if held.output < 0]
        self._fixed = fixed[0] if len(fixed) == 1 else -1
        self._moves: list[_Move] = []
        self._conditions: list[tuple[object, ...]] = []  # of each move
        self._switches: list[tuple[int, int, int, list[bool], bool]] = []
        self.faults: _Faults = []

    def _fault(self, line: int, code: str, **arguments: str | float) -> None:
        if len(self.faults) < _MAX_FAULTS:
            self.faults.append((line, Message(code, **arguments)))

    # -- lines ------------------------------------------------------------------------------------

    def run(self, text: bytes) -> None:
        """Read all lines of a program."""
        lines = text.decode("latin-1").split("\n")
        if lines[-1]:
            self._fault(len(lines), "mcx314.no-newline")
        else:
            lines.pop()
        if not lines or lines[0] != f"MCX314 {figures.FORMAT}":
            self._fault(1, "mcx314.bad-header", version=figures.FORMAT)
        scaled = ended = False
        for number, line in enumerate(lines[1:], 2):
            if line.startswith(";"):
                if not line.isprintable() or not line.isascii():
                    self._fault(number, "mcx314.bad-line", text=line[:40])
                continue
            if ended:
                self._fault(number, "mcx314.after-end")
                return
            if not scaled:
                scaled = self._read_pulses(number, line)
                continue
            ended = line == "END"
            if ended:
                self._check_end(number)
            else:
                self._execute(number, line)
        if not scaled:
            self._fault(max(len(lines), 1), "mcx314.no-pulses")
        if not ended:
            self._fault(max(len(lines), 1), "mcx314.no-end")

    def _check_end(self, number: int) -> None:
        """Check that everything is off at the end of the program."""
        if self._state.on:
            self._fault(number, "mcx314.ends-lowered", output=min(self._state.on))
        if self._state.oscillates:
            self._fault(number, "mcx314.ends-oscillating")

    def _settle(self) -> float:
        """Return how long the machine must dwell after switching for the selected station (s)."""
        station = self._station()
        own = expected_tool(self._stations[station].tool).min_dwell if station >= 0 else 0.0
        return max(own, self._machine.settle)

    def _read_pulses(self, number: int, line: str) -> bool:
        """Read the line that states the pulses of each axis; return whether it is one."""
        match = _PULSES.fullmatch(line)
        if match is None:
            self._fault(number, "mcx314.no-pulses")
            return True
        stated = tuple(float(value) for value in match.groups())
        if any(abs(a - b) > 1e-6 for a, b in zip(stated, self._wiring.pulses, strict=True)):
            self._fault(number, "mcx314.other-pulses", machine=self._machine.title)
        return True

    def _execute(self, number: int, line: str) -> None:
        state, seconds = self._state, -1.0
        if match := _LINE.fullmatch(line):
            seconds = self._line(number, match)
        elif match := _ARC.fullmatch(line):
            seconds = self._arc(number, match)
        elif match := _GO.fullmatch(line):
            self._go(number, match)
        elif match := _OUT.fullmatch(line):
            self._switch(number, int(match[1]), match[2] == "ON")
        elif match := _OSC.fullmatch(line):
            state.oscillates, state.osc_stated = match[1] == "ON", True
            self._add_switch(number, -1, spindle=True)
        elif match := _DWELL.fullmatch(line):
            if int(match[1]) != round(self._settle() * 1e3):
                self._fault(number, "mcx314.wrong-dwell", needed=round(self._settle() * 1e3))
            state.waited += int(match[1]) / 1e3
            state.dwell += int(match[1]) / 1e3
        else:
            self._fault(number, "mcx314.bad-line", text=line[:40])
        state.seconds = seconds

    def _go(self, number: int, match: re.Match[str]) -> None:
        target = [None if value is None else int(value) for value in match.groups()]
        named = [axis for axis in range(4) if target[axis] is not None]
        if not 1 <= len(named) <= 3:
            self._fault(number, "mcx314.bad-axes", count=len(named))
        end = list(self._state.at)
        for axis in named:
            end[axis] = float(target[axis] or 0)
        if any(abs(end[axis]) > figures.LARGEST for axis in named):
            self._fault(number, "mcx314.out-of-range", limit=figures.LARGEST)
        self._add_move(number, 0, end, minutes=math.nan, rested=True)

    def _line(self, number: int, match: re.Match[str]) -> float:
        """Read a line; return its duration (s)."""
        way = [int(value or 0) for value in match.groups()[:4]]
        moved = [axis for axis in range(4) if way[axis]]
        if not 1 <= len(moved) <= 3:
            self._fault(number, "mcx314.bad-axes", count=len(moved))
        self._check_way(number, way, moved)
        end = [at + pulses for at, pulses in zip(self._state.at, way, strict=True)]
        seconds = max(map(abs, way)) / self._speed(number, match[5])
        joined = self._check_joint(number, match[6])
        self._add_move(number, 1, end, minutes=seconds / 60.0, rested=not joined)
        return seconds

    def _arc(self, number: int, match: re.Match[str]) -> float:
        """Read an arc; return its duration (s)."""
        x, y, i, j = (int(value) for value in match.groups()[1:5])
        side = 1 if match[1] == "CCW" else -1
        self._check_way(number, [x, y, i, j], [0, 1])
        scale = self._wiring.pulses[0]
        if scale != self._wiring.pulses[1]:
            self._fault(number, "mcx314.no-circle")
        radius, other = math.hypot(i, j), math.hypot(x - i, y - j)
        if radius < 1.0 or abs(radius - other) > ROUND or not (x or y):
            self._fault(number, "mcx314.bad-arc")
        angle = math.atan2(y - j, x - i) - math.atan2(-j, -i)
        sweep = side * (side * angle % math.tau)
        start = self._state.at
        end = [start[0] + x, start[1] + y, start[2], start[3]]
        seconds = radius * abs(sweep) / self._speed(number, match[6])
        joined = self._check_joint(number, match[7])
        centre = ((start[0] + i) / scale, (start[1] + j) / scale)
        self._add_move(
            number, 3 if side > 0 else 2, end,
            minutes=seconds / 60.0, rested=not joined, centre=centre, sweep=sweep,
        )  # fmt: skip
        return seconds

    def _check_way(self, number: int, pulses: list[int], moved: list[int]) -> None:
        if max(map(abs, pulses)) > figures.LARGEST:
            self._fault(number, "mcx314.out-of-range", limit=figures.LARGEST)
        if any(math.isnan(self._state.at[axis]) for axis in moved):
            self._fault(number, "mcx314.unknown-position")

    def _speed(self, number: int, word: str) -> int:
        """Return a drive speed (pulses/s)."""
        slowest = self._wiring.multiple
        fastest = figures.FASTEST * slowest
        if not slowest <= int(word) <= fastest:
            self._fault(number, "mcx314.bad-speed", slowest=slowest, fastest=fastest)
        return int(word)

    def _check_joint(self, number: int, word: str | None) -> bool:
        """Return whether a segment joins the one before it; check that it can."""
        if word is None:
            return False
        before = self._state.seconds
        if before < 0.0:
            self._fault(number, "mcx314.joins-nothing")
        elif before < self._wiring.refill * (1.0 - 1e-9):
            self._fault(
                number,
                "mcx314.joins-short",
                milliseconds=before * 1e3,
                refill=self._wiring.refill * 1e3,
            )
        return True

    def _switch(self, number: int, output: int, on: bool) -> None:
        state = self._state
        if output not in self._machine.outputs:
            self._fault(number, "mcx314.unknown-output", output=output)
            return
        state.stated.add(output)
        state.on.pop(output, None)
        lowers = -1
        if on:
            state.switched += 1
            state.on[output] = state.switched
            lowers = next(iter(self._by_output[output]), -1)
        self._add_switch(number, lowers)

    # -- rows -------------------------------------------------------------------------------------

    def _add_switch(self, number: int, lowers: int, *, spindle: bool = False) -> None:
        self._state.waited, self._state.unready = 0.0, False
        self._switches.append((number, len(self._moves) - 1, lowers, self._outputs_on(), spindle))

    def _outputs_on(self) -> list[bool]:
        """Return whether the output of each station is on or unknown."""
        state = self._state
        return [
            held.output >= 0 and (held.output in state.on or held.output not in state.stated)
            for held in self._stations
        ]

    def _are_outputs_stated(self) -> list[bool]:
        state = self._state
        known = [held.output < 0 or held.output in state.stated for held in self._stations]
        extra = [output in state.stated for output in extra_outputs(self._machine)]
        return [*known, *extra, state.osc_stated]

    def _station(self) -> int:
        """Return the index of the station whose output was switched on last, -1 for none."""
        latest = sorted(self._state.on.items(), key=itemgetter(1), reverse=True)
        for output, _ in latest:
            if self._by_output[output]:
                return self._by_output[output][0]
        return self._fixed

    def _add_move(
        self,
        number: int,
        code: int,
        end: list[float],
        *,
        minutes: float,
        rested: bool,
        centre: tuple[float, float] = (math.nan, math.nan),
        sweep: float = 0.0,
    ) -> None:
        state = self._state
        if state.waited < self._settle() - 1e-9 and not state.unready:
            # One fault for each switching, not one for each move after it.
            self._fault(number, "mcx314.not-settled", seconds=state.waited)
            state.unready = True
        self._moves.append((number, code, state.at, end, centre, sweep, minutes))
        on = [held.output in state.on for held in self._stations]
        extra = [output in state.on for output in extra_outputs(self._machine)]
        condition = self._station(), on, state.oscillates, extra, self._are_outputs_stated()
        self._conditions.append((*condition, rested, state.waited))
        state.at = end

    def moves(self) -> Moves:
        """Return all moves."""
        count, stations = len(self._moves), len(self._stations)
        line, code, start, end, centre, sweep, minutes = [
            list(column) for column in zip(*self._moves, strict=True)
        ] or [[]] * 7
        station, on, oscillates, extra, stated, rested, waited = [
            list(column) for column in zip(*self._conditions, strict=True)
        ] or [[]] * 7
        pulses = np.array(self._wiring.pulses)
        extras = len(extra_outputs(self._machine))
        first = np.array(start, np.float64).reshape(count, 4) / pulses
        last = np.array(end, np.float64).reshape(count, 4) / pulses
        with np.errstate(divide="ignore"):
            feed = 1.0 / np.array(minutes, np.float64)
        switch = [list(column) for column in zip(*self._switches, strict=True)] or [[]] * 5
        return Moves(
            line=np.array(line, np.int32),
            code=np.array(code, np.uint8),
            start=first,
            end=last,
            centre=np.array(centre, np.float64).reshape(count, 2),
            sweep=np.array(sweep, np.float64),
            feed=feed,
            inverse=np.array(code, np.uint8) > 0,
            station=np.array(station, np.int32),
            lowered=np.array(on, np.bool_).reshape(count, stations),
            oscillating=np.array(oscillates, np.bool_),
            extra=np.array(extra, np.bool_).reshape(count, extras),
            stated=np.array(stated, np.bool_).reshape(count, stations + extras + 1),
            blend=np.zeros(count),  # the chip follows each segment to its last pulse
            rested=np.array(rested, np.bool_),
            waited=np.array(waited, np.float64),
            uses_tool_table=False,
            shortest=self._wiring.refill,
            dwell=self._state.dwell,
            switches=Switches(
                line=np.array(switch[0], np.int32),
                move=np.array(switch[1], np.int64),
                lowers=np.array(switch[2], np.int32),
                beside=np.array(switch[3], np.bool_).reshape(len(switch[0]), stations),
                at_end=np.array(self._are_outputs_stated(), np.bool_),
                spindle=np.array(switch[4], np.bool_),
            ),
            axes_start=first,
            axes_end=last,
            resolution=math.hypot(0.5 / pulses[0], 0.5 / pulses[1]),
            height_resolution=0.5 / pulses[2],
        )
