"""program_follower: find the program line that the machine is executing, from its status reports.

Line numbers (N words) would make this simple, but they are not added to a program, because the
program must run exactly as it was verified.  Instead three facts are combined, each of which is
reliable by itself:

- The controller answers a line with G4, M3, M5 or M30 only when all lines before it are executed.
- The field ``Bf`` of a report shows how many moves are still in the planner.  The answered moves
  that have left the planner are executed, except the last ones, whose steps are prepared.
- The first answered move that passes through the reported position is being executed.

If a program does have N words and the controller reports the field ``Ln``, this field is the number
of the line.  Only the lines from the first one that is not executed to the last answered one are
stored, so memory does not grow with the program.
"""

from __future__ import annotations

import itertools
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from knifetip.gateway.controller import Status
from knifetip.gateway.interpreter import EMPTY_BLOCK, Block
from knifetip.gateway.motion import NOTHING

#: Largest distance of a reported position from its move (mm and degrees): steps, chords, rounding.
NEAR = 0.05
#: A later move is preferred only if it is nearer by more than this (mm and degrees).
CLEARLY = 0.002
#: Least number of moves that have left the planner although their steps are still being executed.
AHEAD = 1


@dataclass(frozen=True, slots=True)
class _Line:
    block: Block
    seconds: float


class ProgramFollower:
    """Follows a running program by status reports and counts its executed lines.

    Parameters
    ----------
    blocks
        The effect of each program line, None for a line that is refused.
    seconds
        Duration of each line (s).
    ahead
        Largest number of moves that have left the planner and are not executed yet.
    """

    def __init__(
        self, blocks: Iterator[Block | None], seconds: Sequence[float], ahead: int = AHEAD
    ) -> None:
        self._ahead = max(ahead, AHEAD)
        self._blocks = blocks
        self._durations = seconds
        self._window: deque[_Line] = (
            deque()
        )  # lines from the first one that is not executed to the last answered
        self._moves = 0  # moves in the window
        self._read = 0  # lines that have entered the window
        self._fraction = 0.0  # of the line being executed
        self.lines = 0  #: number of executed lines
        self.seconds = 0.0  #: duration of the executed lines (s)
        self.output = -1  #: digital output last switched on by an executed line

    def update(self, status: Status, acknowledged: int, capacity: int | None) -> int:
        """Process a status report and return the number of executed lines.

        Parameters
        ----------
        status
            The status report.
        acknowledged
            Number of lines of this program that the controller had answered when the report
            arrived.
        capacity
            Number of blocks that the planner of the controller holds, None if unknown.
        """
        self._take(acknowledged)
        if capacity is not None and status.free is not None:
            self._release(capacity - status.free + self._ahead)
        row, fraction = self._find(status)
        self._drop(row)
        self._fraction = fraction if row else max(fraction, self._fraction)
        self._skip()
        return self.lines

    def finish(self, acknowledged: int) -> int:
        """Count all answered lines as executed, and return their number; the machine is at rest.

        Parameters
        ----------
        acknowledged
            Number of lines of this program that the controller has answered.
        """
        self._take(acknowledged)
        self._drop(len(self._window))
        return self.lines

    @property
    def seconds_done(self) -> float:
        """Duration of the executed lines and of the executed part of the next line (s)."""
        part = self._window[0].seconds * self._fraction if self._window else 0.0
        return self.seconds + part

    def _find(self, status: Status) -> tuple[int, float]:
        """Return the index of the line being executed, and the executed fraction of its move.

        The index counts the stored lines from 0.  These are the answered lines that are not known
        to be executed.  Returns ``(0, 0.0)`` if no stored move passes through the reported
        position.
        """
        nearest, executing = NEAR, (0, 0.0)
        for row, line in enumerate(self._window):
            if status.number > 0 and line.block.number == status.number:
                return row, 0.0
            if (move := line.block.move) is None or move.length <= NOTHING:
                continue
            distance, fraction = move.nearest(status.position)
            if distance < nearest:
                nearest, executing = distance - CLEARLY, (row, fraction)
            elif nearest < NEAR:
                # Only the next move can be nearer because it is the true one: at their joint.
                break
        return executing

    def _take(self, acknowledged: int) -> None:
        """Read the program lines that the controller has answered since the last call.

        The lines are stored until they are known to be executed.  Some lines, such as a dwell, are
        answered only when all earlier motion has ended.  The answer to such a line proves that the
        line and all lines before it are executed.

        ``acknowledged``: number of lines of this program that the controller has answered.
        """
        for read in itertools.islice(self._blocks, max(acknowledged - self._read, 0)):
            block = read or EMPTY_BLOCK
            self._window.append(_Line(block, self._durations[self._read]))
            self._moves += _moves(block)
            self._read += 1
            if block.waits:
                self._drop(len(self._window))

    def _release(self, max_moves: int) -> None:
        """Count the oldest stored lines as executed until at most ``max_moves`` moves remain.

        ``max_moves``: greatest number of answered moves that can still be queued or running in the
        controller.
        """
        while self._moves > max_moves:
            self._drop(1)

    def _skip(self) -> None:
        """Count the stored lines before the first stored move as executed.

        These lines do not move the machine.
        """
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
