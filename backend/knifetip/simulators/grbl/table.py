"""table: a simulated cutting table with the protocol of grbl 1.1 and grblHAL.

It simulates all behaviour that a sender of programs must handle:

- a receive buffer of 128 bytes that can overflow, and a planner of 15 blocks;
- an ``ok`` that is sent only when the line moves from the buffer to the planner;
- soft limits, check mode, and holds that decelerate within an arc;
- a safety door, which holds the machine until it is closed and the machine is resumed;
- M64 and M65, which switch an output as soon as the line is read;
- alarms that lock the controller until a reset.

Simulated time passes only while an axis moves or the table dwells (see ``clock``).
"""

from __future__ import annotations

import asyncio
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from knifetip.gateway.interpreter import (
    EMPTY_BLOCK,
    Block,
    Interpreter,
    LineRefused,
    strip_comments,
)
from knifetip.gateway.motion import Pose
from knifetip.model.machine import Machine
from knifetip.simulators.grbl.firmware import Firmware, settings
from knifetip.simulators.grbl.machine import BLOCKS, TableMachine

#: Stores the present position as the work zero of some axes.
_SET_ZERO = re.compile(rb"G10L20P1((?:[XYZABC]0(?:\.0*)?)+)")
#: A command that reads a setting, or writes it.
_SETTING = re.compile(rb"\$(\d+)(?:=([-\d.]+))?")
#: Last setting that ``$$`` reports; grblHAL reports further ones only by their numbers.
_LAST_LISTED = 255
#: Changes of the feed override (%) by realtime commands; 0 sets it to 100.
_OVERRIDES = {0x90: 0, 0x91: 10, 0x92: -10, 0x93: 1, 0x94: -1}
BANNER = "GrblHAL 1.1f ['$' or '$HELP' for help]"


def discard_answer(line: str) -> None:
    """Discard an answer of the simulated table; used while no client is connected."""


@dataclass(frozen=True, slots=True)
class Faults:
    """Faults that the simulated table injects.

    Lines are numbered from 1 in the order in which they are received; lines in check mode are not
    counted.
    """

    drop_ok: frozenset[int] = frozenset()  #: lines that are executed but not answered
    errors: Mapping[int, int] = field(
        default_factory=dict
    )  #: lines that are refused, with the error code
    disconnect: int = 0  #: line at which the connection breaks
    reset_in_arc: int = (
        0  #: number of the arc (from 1) in the middle of which the controller resets
    )


class Table(TableMachine):
    """The simulated controller and its machine, without a network.

    ``receive`` processes bytes that a client sends; ``answer`` is called with each line for the
    client.
    """

    def __init__(
        self,
        machine: Machine,
        *,
        speed: float = 1.0,
        faults: Faults | None = None,
        window: int = 128,
        sample: float = 0.0,
        firmware: Firmware | None = None,
    ) -> None:
        if not speed > 0.0:
            raise ValueError(f"a speed of {speed} would never move")
        super().__init__(machine, sample)
        self.speed = speed
        self.faults = faults or Faults()
        self.firmware = firmware or Firmware(f"XYZ{machine.heading_letter}")
        #: settings of the controller by their numbers, which ``$n=value`` changes
        self.settings = settings(machine, self.firmware)
        self.window = window
        self.pressed = ""  #: letters of the axes whose limit switches are pressed
        self.lost = 0  #: bytes that overflowed the buffer
        self.answer: Callable[[str], None] = discard_answer
        self.hang_up: Callable[[], None] = lambda: None
        self.awake = asyncio.Event()
        self._interpreter = Interpreter(self.position)
        self._buffer = bytearray()
        self._state = "Idle"
        self._critical = False
        self.override = 100  #: feed override (%)
        self._override_changed = True  # since the last report that contained it
        self._error = 0  # of the last program line that was refused, until it is cleared
        self._check = False
        self._door_open = False
        self._held_by_door = False
        self._waiting: tuple[Block, int] | None = None  # read, not yet answered
        self._count = 0
        self._reports = 0

    # -- state ----------------------------------------------------------------------------------

    @property
    def state(self) -> str:
        """State of the controller, as grbl writes it in a status report, such as ``Hold:0``."""
        if self._state != "Idle":
            return self._state
        if self._check:
            return "Check"
        if self._planner.holding:
            at_rest = self._planner.halted or not len(self._planner)
            if self._held_by_door:
                return f"Door:{1 if self._door_open else 0}" if at_rest else "Door:2"
            return "Hold:0" if at_rest else "Hold:1"
        return "Run" if len(self._planner) or self._dwell > 0.0 else "Idle"

    @property
    def lines_read(self) -> int:
        """Number of program lines that were read outside check mode."""
        return self._count

    @property
    def jogs_to(self) -> Pose:
        """Position at which the moves that the controller has got end (mm and degrees)."""
        return self._interpreter.position

    # -- received bytes -------------------------------------------------------------------------

    def receive(self, data: bytes) -> None:
        """Process received bytes: execute realtime commands at once, buffer other bytes."""
        for byte in data:
            if byte == 0x18:
                self._reset()
            elif byte == 0x3F:
                self._report()
            elif byte == 0x21:
                self._hold()
            elif byte in _OVERRIDES:
                self._change_override(byte)
            elif byte == 0x7E:
                self._resume()
            elif byte >= 0x80:
                if byte == 0x85 and self._state == "Jog":
                    self._discard_motion()
            elif len(self._buffer) < self.window:
                self._buffer.append(byte)
                if byte == 0x0A:
                    self._read()
            else:
                self.lost += 1
        self.awake.set()

    def _change_override(self, command: int) -> None:
        """Change the feed override by a realtime command; the next report contains it."""
        step = _OVERRIDES[command]
        changed = 100 if step == 0 else min(max(self.override + step, 10), 200)
        self._override_changed |= changed != self.override
        self.override = changed

    def _hold(self) -> None:
        if self._state == "Idle" and not self._check and (self.busy or len(self._planner)):
            self._planner.holding = True

    def _resume(self) -> None:
        if not self._door_open:
            self._planner.holding = self._held_by_door = False

    def open_door(self) -> None:
        """Open the safety door, which holds the machine, also one at rest."""
        self._door_open = True
        if self._state == "Idle" and not self._check:
            self._planner.holding = self._held_by_door = True
        self.awake.set()

    def close_door(self) -> None:
        """Close the safety door; the machine remains held."""
        self._door_open = False

    def _discard_motion(self) -> None:
        """Discard all moves and the dwell, and stop at the present position."""
        self._planner.clear()
        self._interpreter.reset(self._planner.position)
        self._waiting = None
        self._dwell = 0.0
        if self._state == "Jog":
            self._state = "Idle"

    def _reset(self, *, requested: bool = True) -> None:
        moving = self._planner.moving
        locked = self._critical or self._state == "Alarm"
        self._critical = self._check = False
        self._error = 0
        self._discard_motion()
        # A reset does not close the door.
        self._planner.holding = self._held_by_door = self._door_open
        self._buffer.clear()
        self.oscillating = False
        if moving:
            self._state = "Alarm"
            if requested:
                self.answer("ALARM:3")
        self.answer("")
        self.answer(BANNER)
        if locked or moving:
            self._state = "Alarm"
            self.answer("[MSG:'$H'|'$X' to unlock]")

    def _report(self) -> None:
        if self._critical:
            return
        self._reports += 1
        x, y, z, c = map(sum, zip(self.position, self._offset, strict=True))
        free = BLOCKS - len(self._planner)
        fields = [
            self.state,
            f"MPos:{self.firmware.by_axis((x, y, z, c))}",
            f"Bf:{free},{self.window - len(self._buffer)}",
            f"FS:{self._planner.speed * 60.0:.0f},{int(self.oscillating)}",
        ]
        if self._planner.tag:
            fields.append(f"Ln:{self._planner.tag}")
        if self.pressed:
            fields.append(f"Pn:{self.pressed}")
        if self._override_changed:
            fields.append(f"Ov:{self.override},100,100")
            self._override_changed = False
        if self._reports % 10 == 1:
            fields.append(f"WCO:{self.firmware.by_axis(self._offset)}")
        self.answer(f"<{'|'.join(fields)}>")

    # -- program lines --------------------------------------------------------------------------

    def _read(self) -> None:
        """Execute and answer lines from the buffer until it is empty or a line must wait."""
        while True:
            if self._waiting is not None and not self._execute_block(*self._waiting):
                return
            end = self._buffer.find(b"\n")
            if end < 0 or self._critical:
                return
            line = bytes(self._buffer[:end])
            del self._buffer[: end + 1]
            self._execute_line(line.rstrip(b"\r"))

    def _execute_line(self, line: bytes) -> None:
        text = strip_comments(line)
        if text.startswith(b"$") or not line.strip():
            self._error = 0
        if text.startswith(b"$"):
            self._execute_command(text)
            return
        if self._error and self.firmware.grblhal:
            # grblHAL repeats an error until a command or an empty line; a comment is not empty.
            self.answer(f"error:{self._error}")
            return
        if self._state in ("Alarm", "Jog"):
            self._refuse(9)
            return
        order = 0
        if not self._check:
            self._count += 1
            order = self._count
            if order == self.faults.disconnect:
                self.hang_up()
                return
            if order in self.faults.errors:
                self._refuse(self.faults.errors[order])
                return
        if zeroed := _SET_ZERO.fullmatch(text.replace(b" ", b"")):
            if not self._check:
                self._set_zero(zeroed[1].decode())
            self.answer("ok")
            return
        try:
            self.firmware.require_axes(text)
            block = self._interpreter.read(line)
            self.firmware.require_output(block)
        except LineRefused as refused:
            self._refuse(refused.code)
            return
        if block.move and not self._is_within_travel(block.move):
            self._alarm(2)
            return
        if self._check:
            block = EMPTY_BLOCK
        self._waiting = (block, order)

    def _refuse(self, code: int) -> None:
        """Answer a program line with an error."""
        self._error = code
        self.answer(f"error:{code}")

    def _execute_block(self, block: Block, order: int) -> bool:
        """Execute and answer a program line; return False if the line must wait.

        A line waits for the end of all motion, for a dwell, or for room in the planner.

        ``order``: number of the program line, from 1; 0 in check mode.
        """
        if block.waits:
            if len(self._planner) or self._dwell > 0.0:
                return False
            if block.dwell:
                # After the dwell the same line is processed with a dwell of 0.
                self._dwell = block.dwell
                self._waiting = (replace(block, dwell=0.0), order)
                return False
            if block.oscillation is not None:
                self.oscillating, self.reversed = block.oscillation, block.reverse
        elif block.move and self._planner.full:
            return False
        if block.output >= 0:
            self._switch(block.output, block.on)
        if block.move:
            self._planner.append(block.move, block.number)
        if block.end:
            self.oscillating = False
        if block.pause:
            self._planner.holding = True
        self._waiting = None
        if order not in self.faults.drop_ok or order == 0:
            self.answer("ok")
        return True

    def _alarm(self, code: int) -> None:
        """Enter an alarm that locks the controller until a reset.

        ``code``: code that is sent as ``ALARM:code``.
        """
        self._discard_motion()
        self._buffer.clear()
        self._state = "Alarm"
        self._critical = True
        self._check = False
        self.answer(f"ALARM:{code}")
        self.answer("[MSG:Reset to continue]")

    def trip_limit(self) -> None:
        """Enter the alarm that a limit switch causes."""
        self._alarm(1)

    def _set_zero(self, words: str) -> None:
        """Store the present position as the work zero of the axes named in ``words``."""
        shift = tuple(
            value if axis in words else 0.0
            for axis, value in zip(f"XYZ{self.firmware.rotary or '-'}", self.position, strict=True)
        )
        self._move_zero(shift)
        self._interpreter.reset(self.position)
        self._reports = 0  # the next report contains the new offset

    def _execute_command(self, text: bytes) -> None:
        idle = self.state == "Idle" and self._waiting is None
        if text == b"$X":
            if self._state == "Alarm":
                self._state = "Idle"
                self.answer("[MSG:Caution: Unlocked]")
        elif text == b"$I":
            for line in self.firmware.build_info(BLOCKS, self.window):
                self.answer(line)
        elif text == b"$C" and (idle or self._check):
            if self._check:
                self.answer("[MSG:Disabled]")
                self.answer("ok")
                self._reset()
                return
            self._check = True
            self.answer("[MSG:Enabled]")
        elif text == b"$H" and (idle or self._state == "Alarm"):
            self._discard_motion()
            self._go_home()
            self._interpreter.reset(self._planner.position)
            self._state = "Idle"
        elif text == b"$$":
            for number, value in self.settings.items():
                if number <= _LAST_LISTED:
                    self.answer(f"${number}={value}")
        elif setting := _SETTING.fullmatch(text):
            number = int(setting[1])
            if number not in self.settings:
                self.answer("error:3")
                return
            if setting[2] is None:
                self.answer(f"${number}={self.settings[number]}")
            else:
                self.settings[number] = setting[2].decode("ascii", "replace")
        elif text == b"$G":
            self.answer("[GC:G0 G54 G17 G21 G90 G94 G49 M5 M9 T0 F0 S0]")
        elif text.startswith(b"$J="):
            code = self._jog(text[3:]) if idle or self._state == "Jog" else 8
            if code:
                self.answer(f"error:{code}")
                return
        elif text != b"$":
            self.answer("error:8" if text in (b"$C", b"$H") else "error:3")
            return
        self.answer("ok")

    def _jog(self, text: bytes) -> int:
        """Start a jog (a move outside a program); return the error code, 0 if accepted.

        ``text``: line after ``$J=``.
        """
        jog = Interpreter(self._interpreter.position)
        try:
            move = jog.read(b"G1" + text.replace(b"G53", b"")).move
        except LineRefused as refused:
            return 16 if refused.code == 22 else refused.code
        if move is None:
            return 16
        if not self._is_within_travel(move):
            return 15
        self._interpreter.position = move.end
        self._planner.append(move)
        if len(self._planner):
            self._state = "Jog"
        return 0

    # -- motion ---------------------------------------------------------------------------------

    def elapse(self, seconds: float) -> None:
        """Advance the simulated time by ``seconds``, or until the table neither moves nor dwells.

        Lines in the buffer are executed as soon as the planner has room.
        """
        left = seconds
        while left > 0.0:
            self._read()
            step = min(left, self.trace.interval) if self.trace else left
            if len(self._planner) and self._planner.moving:
                move = self._planner.current
                share = self.override / 100.0 if move is not None and move.rate < math.inf else 1.0
                used = self._move(step * share) / share
            elif self._dwell > 0.0 and not self._planner.holding:
                used = min(step, self._dwell)
                self._dwell -= used
            else:
                return
            left -= used
            self._pass_time(used)
        self._read()

    def _move(self, seconds: float) -> float:
        """Move the axes along the current move for at most ``seconds``; return the time used.

        Both times are simulated seconds.
        """
        move = self._planner.current
        doomed = (
            move is not None
            and move.centre is not None
            and self._planner.arcs_done + 1 == self.faults.reset_in_arc
        )
        used = self._planner.advance(min(seconds, 1e-3) if doomed else seconds)
        if doomed and (self._planner.fraction >= 0.5 or self._planner.current is not move):
            self.faults = replace(self.faults, reset_in_arc=0)
            self._reset(requested=False)
        if self._state == "Jog" and not len(self._planner):
            self._state = "Idle"
        return used
