"""table: a simulated cutting table with the protocol of grbl 1.1 and grblHAL.

It simulates all behaviour that a sender of programs must handle:

- a receive buffer of 128 bytes that can overflow, and a planner of 15 blocks;
- an ``ok`` that is sent only when the line moves from the buffer to the planner;
- soft limits, check mode, and holds that decelerate within an arc;
- M64 and M65, which switch an output as soon as the line is read;
- alarms that lock the controller until a reset.

Simulated time passes ``speed`` times as fast as real time, and only while an axis moves or the
table dwells.
"""

from __future__ import annotations

import asyncio
import re
from array import array
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from knifetip.errors import ControllerError
from knifetip.gateway.interpreter import (
    EMPTY_BLOCK,
    Block,
    Interpreter,
    LineRefused,
    strip_comments,
)
from knifetip.gateway.motion import Limits, Move, Planner, Pose
from knifetip.model.machine import Machine

#: Real time between two steps while the machine moves (s).
TICK = 0.002
#: Longest real time of one step, so that a high speed does not block the port (s).
STINT = 0.01
#: Real time that the machine may catch up after the process was busy (s).
LAG = 0.1
#: Distance between the limits of travel and the mechanical end stops (mm or degrees).
PAST = 1e-4
#: Blocks of the planner, as ``$I`` and ``Bf`` report.
BLOCKS = 15
#: Samples that a trace keeps at most.
SAMPLES = 500_000
#: Stores the present position as the work zero of some axes.
_SET_ZERO = re.compile(rb"G10L20P1((?:[XYZC]0(?:\.0*)?)+)")
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


@dataclass(frozen=True, slots=True)
class Firmware:
    """Properties that differ between builds of grblHAL, and between grblHAL and grbl 1.1."""

    axes: str = "XYZC"  #: letters in the order of status reports; one of them is A or C, or none
    outputs: int = 16  #: number of digital outputs (M64, M65)
    grblhal: bool = True  #: grblHAL, which states its axes and outputs; False for grbl 1.1
    sizes: bool = True  #: whether it states the sizes of planner and receive buffer


@dataclass(frozen=True, slots=True)
class SwitchEvent:
    """One change of a digital output."""

    time: float
    output: int
    on: bool
    position: Pose
    moving: bool  #: whether an axis was moving


@dataclass(slots=True)
class Trace:
    """Positions of the simulated axes, sampled every ``interval`` seconds of motion or dwell."""

    interval: float
    _values: array[float] = field(default_factory=lambda: array("d"))

    def add(self, time: float, position: Pose) -> None:
        """Add a sample, unless the trace already has ``SAMPLES`` samples.

        Parameters
        ----------
        time
            Simulated time (s).
        position
            Position of the axes.
        """
        if len(self._values) < 5 * SAMPLES:
            self._values.extend((time, *position))

    def samples(self) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
        """Return time (s), x, y, z (mm) and c (degrees) of each sample, shape (samples, 5)."""
        return np.array(self._values, dtype=np.float64).reshape(-1, 5)


class Table:
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
        if machine.gantry:
            count = len(machine.carriages)
            raise ControllerError("controller.one-carriage", machine=machine.title, count=count)
        self.machine = machine
        self.speed = speed
        self.faults = faults or Faults()
        self.firmware = firmware or Firmware()
        self.window = window
        self.time = 0.0  #: simulated seconds of motion and dwell
        self.trace = Trace(sample) if sample > 0.0 else None
        self.outputs: dict[int, bool] = {}
        self.switch_events: deque[SwitchEvent] = deque(maxlen=10_000)
        self.oscillating = False
        self.reversed = False  #: the spindle turns counter-clockwise
        self.lost = 0  #: bytes that overflowed the buffer
        self.answer: Callable[[str], None] = discard_answer
        self.hang_up: Callable[[], None] = lambda: None
        self.awake = asyncio.Event()
        self._limits = Limits.of(machine)  # in work coordinates
        self._offset: Pose = (0.0, 0.0, 0.0, 0.0)  # machine position of the work zero
        rest: Pose = (0.0, 0.0, machine.travel_z, 0.0)
        self._planner = Planner(self._limits, BLOCKS, rest)
        self._interpreter = Interpreter(rest)
        self._buffer = bytearray()
        self._state = "Idle"
        self._critical = False
        self._error = 0  # of the last program line that was refused, until it is cleared
        self._check = False
        self._waiting: tuple[Block, int] | None = None  # read, not yet answered
        self._dwell = 0.0
        self._count = 0
        self._reports = 0
        self._pending_time = 0.0

    # -- state ----------------------------------------------------------------------------------

    @property
    def position(self) -> Pose:
        """Position of the axes in work coordinates: x, y, z (mm) and c (degrees)."""
        return self._planner.position

    @property
    def state(self) -> str:
        """State of the controller, as grbl writes it in a status report, such as ``Hold:0``."""
        if self._state != "Idle":
            return self._state
        if self._check:
            return "Check"
        if self._planner.holding:
            return "Hold:0" if self._planner.halted or not len(self._planner) else "Hold:1"
        return "Run" if len(self._planner) or self._dwell > 0.0 else "Idle"

    @property
    def busy(self) -> bool:
        """Whether an axis moves or the table dwells."""
        return self._planner.moving or (self._dwell > 0.0 and not self._planner.holding)

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
            elif byte == 0x7E:
                self._planner.holding = False
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

    def _hold(self) -> None:
        if self._state == "Idle" and not self._check and (self.busy or len(self._planner)):
            self._planner.holding = True

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
            f"MPos:{self._by_axis((x, y, z, c))}",
            f"Bf:{free},{self.window - len(self._buffer)}",
            f"FS:{self._planner.speed * 60.0:.0f},{int(self.oscillating)}",
        ]
        if self._planner.tag:
            fields.append(f"Ln:{self._planner.tag}")
        if self._reports % 10 == 1:
            fields.append(f"WCO:{self._by_axis(self._offset)}")
        self.answer(f"<{'|'.join(fields)}>")

    def _by_axis(self, pose: Pose) -> str:
        """Return the figures of a pose for each axis of the controller; 0 for further axes."""
        figures = dict(zip(f"XYZ{self._rotary or '-'}", pose, strict=True))
        return ",".join(f"{figures.get(axis, 0.0):.3f}" for axis in self.firmware.axes)

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
            self._require_axes(text)
            block = self._interpreter.read(line)
            self._require_output(block)
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

    @property
    def _rotary(self) -> str:
        """Letter of the axis that rotates the tool; empty if there is none."""
        return next((letter for letter in "CA" if letter in self.firmware.axes), "")

    def _require_axes(self, text: bytes) -> None:
        """Raise ``LineRefused`` for an axis letter that the controller does not know."""
        if any(letter in text and letter != self._rotary.encode() for letter in (b"A", b"C")):
            raise LineRefused(36 if self.firmware.grblhal else 20)

    def _require_output(self, block: Block) -> None:
        """Raise ``LineRefused`` for an output that the controller does not have."""
        if block.output >= self.firmware.outputs:
            raise LineRefused(39 if self.firmware.outputs else 20)

    def _execute_block(self, block: Block, order: int) -> bool:
        """Execute and answer a program line; return False if the line must wait.

        A line waits for the end of all motion, for a dwell, or for room in the planner.

        Parameters
        ----------
        block
            Effect of the line.
        order
            Number of the program line, from 1; 0 in check mode.
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
            self.outputs[block.output] = block.on
            self.switch_events.append(
                SwitchEvent(
                    self.time, block.output, block.on, self.position, self._planner.speed > 0.0
                )
            )
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

    def _is_within_travel(self, move: Move) -> bool:
        low, high = move.bounds()
        return all(
            least >= bottom - PAST and most <= top + PAST
            for least, most, bottom, top in zip(
                low, high, self._limits.low, self._limits.high, strict=True
            )
        )

    def _alarm(self, code: int) -> None:
        """Enter an alarm that locks the controller until a reset.

        Parameters
        ----------
        code
            Code that is sent as ``ALARM:code``.
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
            for axis, value in zip("XYZC", self.position, strict=True)
        )
        self._move_zero(shift)

    def _move_zero(self, shift: Sequence[float]) -> None:
        """Move the work zero; the axes do not move, so their work coordinates change.

        Parameters
        ----------
        shift
            Distance along each axis (mm or degrees).
        """

        def shifted(pose: Pose) -> Pose:
            x, y, z, c = (value - by for value, by in zip(pose, shift, strict=True))
            return x, y, z, c

        limits = self._limits
        x, y, z, c = (value + by for value, by in zip(self._offset, shift, strict=True))
        self._offset = (x, y, z, c)
        self._limits = replace(limits, low=shifted(limits.low), high=shifted(limits.high))
        self._planner.position = shifted(self.position)
        self._interpreter.reset(self._planner.position)
        self._reports = 0  # the next report contains the new offset

    def _execute_command(self, text: bytes) -> None:
        idle = self.state == "Idle" and self._waiting is None
        if text == b"$X":
            if self._state == "Alarm":
                self._state = "Idle"
                self.answer("[MSG:Caution: Unlocked]")
        elif text == b"$I":
            axes = self.firmware.axes
            self.answer("[VER:1.1f.knifetip:simulated table]")
            if not self.firmware.sizes:
                self.answer("[OPT:PHS]")
            elif self.firmware.grblhal:
                self.answer(f"[OPT:VNMSL,{BLOCKS},{self.window},{len(axes)},0]")
            else:
                self.answer(f"[OPT:V,{BLOCKS},{self.window}]")
            if self.firmware.grblhal:
                self.answer(f"[AXS:{len(axes)}:{axes}]")
                self.answer("[FIRMWARE:grblHAL]")
                self.answer(f"[AUX IO:0,{self.firmware.outputs},0,0]")
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
            zero_x, zero_y, zero_z, zero_c = self._offset
            self._planner.position = (-zero_x, -zero_y, self.machine.travel_z - zero_z, -zero_c)
            self._interpreter.reset(self._planner.position)
            self._state = "Idle"
        elif text == b"$$":
            for line in self._settings():
                self.answer(line)
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

    def _settings(self) -> list[str]:
        limits = self._limits
        rows = ["$10=511", "$13=0", "$20=1", "$22=1", f"$32={int(self.machine.has_beam)}"]
        for axis in range(4):
            rows.append(f"$11{axis}={limits.velocity[axis] * 60.0:.3f}")
            rows.append(f"$12{axis}={limits.acceleration[axis]:.3f}")
            rows.append(f"$13{axis}={limits.high[axis] - limits.low[axis]:.3f}")
        return rows

    def _jog(self, text: bytes) -> int:
        """Start a jog (a move outside a program); return the error code, 0 if accepted.

        Parameters
        ----------
        text
            Line after ``$J=``.
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
                used = self._move(step)
            elif self._dwell > 0.0 and not self._planner.holding:
                used = min(step, self._dwell)
                self._dwell -= used
            else:
                return
            left -= used
            self.time += used
            if self.trace:
                self.trace.add(self.time, self.position)
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

    async def run(self) -> None:
        """Advance the simulated time with the real time until cancelled."""
        loop = asyncio.get_running_loop()
        last = loop.time()
        while True:
            if not self.busy:
                self._pending_time = 0.0
                self.awake.clear()
                await self.awake.wait()
                # Time in which nothing could move is skipped.
                last = loop.time() - TICK
                continue
            now = loop.time()
            self._pending_time = min(
                self._pending_time + (now - last) * self.speed, LAG * self.speed
            )
            last = now
            self._advance_pending(now + STINT, loop)
            await asyncio.sleep(TICK if self.busy else 0.0)

    def _advance_pending(self, deadline: float, loop: asyncio.AbstractEventLoop) -> None:
        """Simulate the time that is not simulated yet, but return at ``deadline`` at the latest.

        The time that is left at ``deadline`` is simulated by the next call.

        Parameters
        ----------
        deadline
            Real time at which to return (s, clock of ``loop``).
        loop
            The running event loop.
        """
        part = max(self._pending_time / 16.0, 1e-4)  # checks the clock from time to time
        while self._pending_time > 0.0 and self.busy and loop.time() < deadline:
            step = min(part, self._pending_time)
            before = self.time
            self.elapse(step)
            self._pending_time -= step
            if self.time == before:
                return
