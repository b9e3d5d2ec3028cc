"""corridor: check that the machine is on the path of the program.

Each status report is compared with the program; a position off the path is an error.  If a digit of
a program line was changed in transmission, the controller still answers ``ok``, and only the
position of the machine reveals the change.  X, Y and Z are compared with the moves that the
controller may be executing: all moves that were sent and not answered, and the last answered moves,
up to the number of moves that the planner of the controller holds.  At rest the position must be
the end of the last program line.

C is compared modulo 360 degrees, because some controllers report it so, and with the range of C on
the whole move only: a tool that is turned to a heading between two others passes through all.
"""

from __future__ import annotations

import itertools
import math
from collections import deque
from collections.abc import Iterator

from knifetip.errors import ControllerError
from knifetip.gateway.controller import State, Status
from knifetip.gateway.interpreter import Block
from knifetip.gateway.motion import Move, Pose

#: Largest distance of a position from the path (mm), for a controller of unknown accuracy.
OFF = 0.5
#: Largest deviation of C from the headings on a move (degrees).
TURNED = 1.0
#: Consecutive reports that must be off the path: a single report may be damaged.
REPORTS = 2
#: Moves that a planner holds if the controller does not report it.
PLANNER = 128
#: Surplus answers of the controller that may be counted before they are detected.
MARGIN = 4

_STATES = (State.IDLE, State.RUN, State.HOLD)


class Corridor:
    """Checks that each reported position is on the path of the program that is being sent.

    Parameters
    ----------
    blocks
        The effect of each program line, None for a line that is refused.
    start
        Status of the controller before the first program line is sent.
    capacity
        Number of blocks that the planner of the controller can hold; if None, ``PLANNER`` blocks
        are assumed.
    off
        Largest distance of a position from the path (mm).
    ahead
        Largest number of moves that have left the planner and are not executed yet.
    """

    def __init__(
        self,
        blocks: Iterator[Block | None],
        start: Status,
        capacity: int | None,
        *,
        off: float = OFF,
        ahead: int = 0,
    ) -> None:
        self._greatest = off
        self._blocks = blocks
        self._base = start.sent
        self._held = (capacity or PLANNER) + ahead + MARGIN
        self._moves: deque[tuple[int, Move]] = deque()
        self._moves.append((0, Move(start.position, start.position)))
        self._read = 0
        self._near = 0  # row of the last matching move
        self._off = 0  # consecutive reports off the path
        self._blind = not start.located  # or a line cannot be interpreted here

    @property
    def doubtful(self) -> bool:
        """Whether the position in the last status report was off the path of the program."""
        return self._off > 0

    def observe(self, status: Status) -> ControllerError | None:
        """Return an error if the machine has left the path of the program, else None.

        A single report may be damaged.  An error is therefore returned only if the last ``REPORTS``
        positions are off the path; the last one is the position in ``status``.
        """
        self._take(status.sent - self._base)
        self._forget(status.acknowledged - self._base)
        if self._blind or not status.located or status.state not in _STATES:
            return None
        distance, turn, line = self._nearest(status.position)
        if distance <= self._greatest and turn <= TURNED:
            self._off = 0
            return None
        self._off += 1
        return self._error(status.position, distance, turn, line) if self._off >= REPORTS else None

    def check_rest(self, status: Status) -> None:
        """Compare the position of a machine at rest with the end of the last program line sent.

        Raises
        ------
        ControllerError
            The position is farther from the end of the line than permitted, or C is more than
            ``TURNED`` degrees from it.
        """
        self._take(status.sent - self._base)
        if self._blind or not status.located:
            return
        line, move = self._moves[-1]
        end = move.end
        distance = math.dist(status.position[:3], end[:3])
        turn = turned_off(Move(end, end), status.position[3])
        if distance > self._greatest or turn > TURNED:
            raise self._error(status.position, distance, turn, line)

    def _take(self, sent: int) -> None:
        """Read the program lines sent since the last call, and store their moves.

        ``sent``: number of program lines sent so far.
        """
        for block in itertools.islice(self._blocks, max(sent - self._read, 0)):
            self._read += 1
            if block is None:
                self._blind = True
            elif block.move is not None:
                self._blind = self._blind or block.in_machine_coordinates
                self._moves.append((self._read, block.move))

    def _forget(self, answered: int) -> None:
        """Delete the oldest stored moves that the machine has certainly executed.

        The planner of the controller holds a limited number of moves.  A move is certainly executed
        when at least that number of moves after it have been answered, and the machine was seen on
        a later one: some controllers execute their steps later than their planner states.

        ``answered``: number of program lines answered so far.
        """
        while len(self._moves) > self._held and self._moves[self._held][0] <= answered:
            if not (self._near or self._blind):
                break
            self._moves.popleft()
            self._near = max(self._near - 1, 0)

    def _nearest(self, position: Pose) -> tuple[float, float, int]:
        """Return the deviations of a position from the path, and the number of a program line.

        The deviations are a distance (mm) and an angle of C (degrees).  They are measured to one
        stored move: to the first move found with permitted deviations, else to one within the
        permitted distance, else to the nearest move.  The program line is the line with this
        move, counted from 1; 0 stands for the start position, which is stored as a move of length
        0.  At least one move must be stored.
        """
        least, nearest = (math.inf, math.inf), (math.inf, 0.0, 0)
        count = len(self._moves)
        for step in range(count):
            # Start at the last match, where it is nearly always found.
            row = (self._near + step) % count
            number, move = self._moves[row]
            distance, turn = distance_to(move, position), turned_off(move, position[3])
            if distance <= self._greatest and turn <= TURNED:
                self._near = row
                return distance, turn, number
            order = (0.0, turn) if distance <= self._greatest else (distance, 0.0)
            if order < least:
                least, nearest = order, (distance, turn, number)
        return nearest

    def _error(self, position: Pose, distance: float, turn: float, line: int) -> ControllerError:
        x, y, z, c = position
        if distance > self._greatest:
            return ControllerError(
                "controller.off-path", x=x, y=y, z=z, distance=distance, line=line
            )
        return ControllerError("controller.off-heading", x=x, y=y, c=c, turn=turn, line=line)


def turned_off(move: Move, heading: float) -> float:
    """Return by how much a heading of C is outside those of a move (degrees), modulo 360."""
    start, end = move.start[3], move.end[3]
    from_middle = math.remainder(heading - (start + end) / 2.0, 360.0)
    return max(abs(from_middle) - abs(end - start) / 2.0, 0.0)


def distance_to(move: Move, position: Pose) -> float:
    """Return the distance (mm) of a position from the path of a move, in X, Y and Z.

    On an arc, the distance is measured to the point that is nearest in X and Y.
    """
    x, y, z, _ = position
    start, end = move.start, move.end
    if move.centre is None:
        dx, dy, dz = end[0] - start[0], end[1] - start[1], end[2] - start[2]
        square = dx * dx + dy * dy + dz * dz
        fraction = 0.0
        if square > 0.0:
            along = (x - start[0]) * dx + (y - start[1]) * dy + (z - start[2]) * dz
            fraction = min(max(along / square, 0.0), 1.0)
    else:
        _, fraction = move.nearest((x, y, start[2], start[3]))
    return math.dist((x, y, z), move.at(fraction)[:3])
