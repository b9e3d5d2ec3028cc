"""executed: which line of a program the machine is executing, not which one was sent.

bytes of the program + what the controller reports -> lines executed, seconds still to go

The program that was previewed is, byte for byte, the one that runs, so no N words are added.
Three things that a controller says are put together, each safe on its own:

- a line that waits for all motion (G4, M3, M5, M30) and has been answered: all before it is done;
- ``Bf``: of the moves answered, no more can be undone than the planner holds blocks;
- the position: the first move after those that passes through it is the one being executed.

Where a program has N words and the controller reports ``Ln``, that names the line at once.
The search only ever goes forward, over the few lines between executed and answered, so memory
does not grow with the program.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass

from knifetip.gateway.controller import Status
from knifetip.gateway.interpreter import NOTHING as NO_BLOCK
from knifetip.gateway.interpreter import Block, Interpreter, Refused
from knifetip.gateway.motion import NOTHING, Limits, Pose

#: A reported position this near to a move is on it (mm and degrees): steps, chords, rounding.
NEAR = 0.05
#: A later move is preferred only where it is nearer by more than the rounding (mm and degrees).
CLEARLY = 0.002
#: Blocks that a planner may already have given up while the steps are still being made.
AHEAD = 1


def lines_of(text: bytes) -> Iterator[bytes]:
    """Return the lines one by one, without newlines and without a copy of them all."""
    at = 0
    while at < len(text):
        end = text.find(b"\n", at)
        if end < 0:
            end = len(text)
        yield text[at:end]
        at = end + 1


@dataclass(frozen=True, slots=True)
class _Line:
    block: Block
    seconds: float


def blocks_of(text: bytes, start: Pose = (0.0, 0.0, 0.0, 0.0)) -> Iterator[Block]:
    """Return what each line does; nothing for one that only the controller can judge."""
    interpreter = Interpreter(start)
    for line in lines_of(text):
        try:
            yield interpreter.read(line)
        except Refused:
            yield NO_BLOCK


def seconds_of(block: Block, limits: Limits) -> float:
    """Return how long a block nominally takes."""
    return (block.dwell or 0.0) + (block.move.seconds(limits) if block.move else 0.0)


class Executed:
    """Follows the machine along a program."""

    def __init__(self, text: bytes, limits: Limits, start: Pose = (0.0, 0.0, 0.0, 0.0)) -> None:
        self._blocks = blocks_of(text, start)
        self._limits = limits
        self._window: deque[_Line] = deque()  # from the first line not executed to the answered
        self._moves = 0  # moves in the window
        self._read = 0  # lines that have entered the window
        self._fraction = 0.0  # of the line being executed
        self.lines = 0  #: executed
        self.seconds = 0.0  #: nominal, of what has been executed
        self.output = -1  #: digital output last switched on by an executed line

    def update(self, status: Status, acknowledged: int, capacity: int | None) -> int:
        """Take in a report; return the number of lines executed.

        Parameters
        ----------
        status
            What the controller reported.
        acknowledged
            Lines of this program that had been answered by then.
        capacity
            Blocks that the planner holds when it is full, if known.
        """
        self._take(acknowledged)
        if capacity is not None and status.free is not None:
            self._release(capacity - status.free + AHEAD)
        row, fraction = self._find(status)
        self._drop(row)
        self._fraction = fraction if row else max(fraction, self._fraction)
        self._skip()
        return self.lines

    def finish(self, acknowledged: int) -> int:
        """Say that the machine is at rest with nothing left of what it has answered."""
        self._take(acknowledged)
        self._drop(len(self._window))
        return self.lines

    @property
    def seconds_done(self) -> float:
        """Nominal seconds of everything executed, the part of the current line included."""
        part = self._window[0].seconds * self._fraction if self._window else 0.0
        return self.seconds + part

    def _find(self, status: Status) -> tuple[int, float]:
        """Return the row of the window that is being executed, and how much of it is done."""
        nearest, found = NEAR, (0, 0.0)
        for row, line in enumerate(self._window):
            if status.number > 0 and line.block.number == status.number:
                return row, 0.0
            if (move := line.block.move) is None or move.length <= NOTHING:
                continue
            distance, fraction = move.nearest(status.position)
            if distance < nearest:
                nearest, found = distance - CLEARLY, (row, fraction)
            elif nearest < NEAR:
                # Only the move that follows can be nearer for being the true one: at their joint.
                break
        return found

    def _take(self, acknowledged: int) -> None:
        """Read on to the last line answered; a line that waits for motion settles all before."""
        while self._read < acknowledged and (block := next(self._blocks, None)) is not None:
            self._window.append(_Line(block, seconds_of(block, self._limits)))
            self._moves += _moves(block)
            self._read += 1
            if block.waits:
                self._drop(len(self._window))

    def _release(self, held: int) -> None:
        """Drop lines until no more moves remain than the planner can still hold."""
        while self._moves > held:
            self._drop(1)

    def _skip(self) -> None:
        """Lines that move nothing are done as soon as they are the first."""
        while self._window and not _moves(self._window[0].block):
            self._drop(1)

    def _drop(self, count: int) -> None:
        for _ in range(count):
            line = self._window.popleft()
            self._moves -= _moves(line.block)
            self.lines += 1
            self.seconds += line.seconds
            if line.block.output >= 0 and line.block.on:
                self.output = line.block.output
            self._fraction = 0.0


def _moves(block: Block) -> bool:
    return block.move is not None and block.move.length > NOTHING
