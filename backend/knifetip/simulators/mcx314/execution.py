"""execution: executes the queue of the board, and moves of its own, on the chip.

Motions are taken from the queue as stretches, planned and written to the chip piece by piece, so
that joined ones follow without a stop.  All other instructions wait until the machine is at rest.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from enum import StrEnum

from knifetip.gateway.mcx314.instructions import MOTIONS, Instruction, InstructionName
from knifetip.simulators.mcx314.outputs import OSCILLATION, joints_of
from knifetip.simulators.mcx314.parts import BoardParts
from knifetip.simulators.mcx314.planner import Planner, ProgramSegment
from knifetip.simulators.mcx314.refusal import RequestRefused
from knifetip.simulators.mcx314.stretches import Joints

#: Times below this value count as 0 (s).
MOMENT = 1e-9


class BoardState(StrEnum):
    """States that the board reports."""

    IDLE = "IDLE"
    RUN = "RUN"
    HOLD = "HOLD"
    JOG = "JOG"
    HOME = "HOME"
    ALARM = "ALARM"


class Execution:
    """The present and the next work of the board.

    Parameters
    ----------
    parts
        The parts that execute it.
    """

    def __init__(self, parts: BoardParts) -> None:
        self.holding = self.discarding = False
        self.dwell = 0.0  #: s that are left of a dwell
        self.jogs = False  #: executes a move that was requested
        self.at_rest: deque[Callable[[], None]] = deque()  #: steps to do once nothing moves
        self._chip = parts.chip
        self._feeder = parts.feeder
        self._planner = Planner(parts.wiring)
        self._queue = parts.queue
        self._stretches = parts.stretches
        self._outputs = parts.outputs
        self._interlock = parts.interlock
        self._record = parts.record
        self._pending: deque[ProgramSegment] = deque()  # not completely written
        self._step = 0  # steps of the first of them that are written
        self._planned: Joints = self.joints()  # at the end of the last stretch
        self._purpose = BoardState.IDLE

    # -- state ------------------------------------------------------------------------------------

    def joints(self) -> Joints:
        """Return the positions of the joints X, Y, Z and C (pulses)."""
        return joints_of(self._chip)

    @property
    def state(self) -> BoardState:
        """State that the board reports."""
        if self._interlock.alarm:
            return BoardState.ALARM
        if self.holding:
            return BoardState.HOLD
        if self._purpose is not BoardState.IDLE:
            return self._purpose
        return BoardState.RUN if self._queue.runs else BoardState.IDLE

    @property
    def busy(self) -> bool:
        """Whether an axis moves or will move, or a dwell passes."""
        return bool(self._feeder.driving or self._pending or self.dwell > 0.0)

    def require_rest(self) -> None:
        """Raise ``RequestRefused`` unless the machine is at rest."""
        if self.busy or self.at_rest:
            raise RequestRefused("moving")

    def require_idle(self) -> None:
        """Raise ``RequestRefused`` unless the machine is at rest and no program runs."""
        self.require_rest()
        if self.state is not BoardState.IDLE:
            raise RequestRefused("busy", self.state)

    # -- commands ---------------------------------------------------------------------------------

    def begin(self, lines: int) -> int:
        """Begin a program of so many lines at the present position; return its number."""
        self._planned = self.joints()
        return self._queue.begin(lines)

    def hold(self) -> None:
        """Decelerate to a stop on the way, if a program runs."""
        if self._queue.runs:
            self.holding = True

    def abort(self) -> None:
        """Decelerate to a stop, and then discard the program and the move."""
        self.discarding = True
        self.holding = False
        self.at_rest.clear()

    def discard(self) -> None:
        """Discard the program and what is left of a move; the machine is at rest."""
        self._queue.discard()
        self._pending.clear()
        self._step = 0
        self.dwell = 0.0
        self.holding = self.discarding = False
        self._purpose = BoardState.IDLE
        self.jogs = False
        self._planned = self.joints()

    def jog(self, instruction: Instruction) -> None:
        """Begin to move axes to a position in work coordinates."""
        stretch = self._stretches.rapid(0, instruction, self.joints())
        if stretch is not None:
            self._pending.append(stretch)
            self._purpose = BoardState.JOG
            self.jogs = True

    def lift(self, target: int) -> None:
        """Begin to raise Z to a joint position (pulses), unless it is there."""
        start = self.joints()
        if start[2] < target:
            self._pending.append(self._stretches.lift(target, start))
            self._purpose = BoardState.JOG

    def home(self) -> None:
        """Simulate homing: lift Z, then move the other axes to zero."""
        self._purpose = BoardState.HOME
        self._pending.extend(self._stretches.homing(self.joints()))

    def _finish_homing(self) -> None:
        self._interlock.homed = True
        self._stretches.zero = [0, 0, 0, 0]

    def act(self, instruction: Instruction) -> None:
        """Execute an instruction that does not move, with the machine at rest."""
        match instruction.name:
            case InstructionName.OUT:
                self._outputs.switch(instruction.output, instruction.on)
            case InstructionName.OSC:
                self._outputs.switch(OSCILLATION, instruction.on)
            case InstructionName.DWELL:
                self.dwell = instruction.number / 1e3
            case _:
                pass

    # -- work -------------------------------------------------------------------------------------

    def let_pass(self, seconds: float) -> None:
        """Advance the time of a dwell, unless it is held."""
        if not self.holding and self.dwell > 0.0:
            left = self.dwell - seconds
            self.dwell = left if left > MOMENT else 0.0

    def work(self) -> None:
        """Complete the ended pieces, and write the next ones."""
        for piece in self._feeder.completed():
            if piece.completes and self._queue.program is not None and piece.stretch.line:
                self._queue.complete(piece.stretch.line)
        if self._interlock.alarm:
            return
        if not self._feeder.driving:
            self._begin_next()
        self._load_stretches()
        if self._feeder.driving and self._feeder.can_write():
            self._continue()

    def _begin_next(self) -> None:
        """Begin the next instruction, with the machine at rest."""
        if self.discarding:
            self.discard()
        if self._purpose is not BoardState.IDLE and not self._pending:
            if self._purpose is BoardState.HOME:
                self._finish_homing()
            self._purpose = BoardState.IDLE
            self.jogs = False
        if self.at_rest and not self._pending:
            self.at_rest.popleft()()
        if self.holding or self.dwell > 0.0:
            return
        while not self._pending and self._queue.items and self.dwell <= 0.0:
            if not self._queue.primed:
                return
            line, instruction = self._queue.items[0]
            if instruction.name in MOTIONS:
                if not self._load_stretch():
                    return
                self._load_stretches()
                break
            self._queue.items.popleft()
            self.act(instruction)
            self._queue.complete(line)
        if self._pending:
            stretch = self._pending[0]
            if self._step == 0 and stretch.joined and self._feeder.last is None and stretch.line:
                self._record.starved += 1
            self._write(self._planner.rest(stretch))

    def _continue(self) -> None:
        """Write the piece after the one that the chip drives, unless it shall stop."""
        last = self._feeder.last
        if last is None:
            return
        stopping = self.holding or self.discarding
        if stopping and last.end <= self._planner.rest(last.stretch) + 1e-6:
            return
        if not self._pending:
            return
        stretch = self._pending[0]
        if self._step == 0 and not self._planner.joins(last.stretch, stretch):
            return
        self._write(last.end)

    def _write(self, speed: float) -> None:
        """Write the next piece of the first stretch; the chip has a rate at its start."""
        stretch = self._pending[0]
        ahead = list(self._pending)[1:]
        stopping = self.holding or self.discarding
        piece = self._planner.piece(stretch, self._step, speed, ahead, stopping=stopping)
        self._feeder.write(piece)
        self._step = piece.last
        if piece.completes:
            self._pending.popleft()
            self._step = 0

    def _load_stretches(self) -> None:
        """Take all motions of the queue that can follow without a stop."""
        while self._load_stretch():
            pass

    def _load_stretch(self) -> bool:
        """Take the next motion of the queue to the stretches; return whether there is one.

        Instructions that do not move wait until the machine is at rest.
        """
        if not self._queue.items or self.discarding or self._purpose is not BoardState.IDLE:
            return False
        line, instruction = self._queue.items[0]
        if instruction.name not in MOTIONS:
            return False
        if self._pending and not instruction.joined:
            return False
        self._queue.items.popleft()
        stretch = self._stretches.motion(line, instruction, self._planned)
        if stretch is None:
            if not self._pending and not self._feeder.driving:
                self._queue.complete(line)
            return True
        self._pending.append(stretch)
        x, y, z, c = (a + b for a, b in zip(stretch.start, stretch.way, strict=True))
        self._planned = x, y, z, c
        return True
