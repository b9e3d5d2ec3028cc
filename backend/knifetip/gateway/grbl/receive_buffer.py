"""receive_buffer: counts the bytes of unanswered lines in the receive buffer of a controller.

A controller stores received bytes in a buffer and answers each line after it has taken the line out
of the buffer.  The sender adds up the bytes of the unanswered lines.  It sends a further line,
without waiting for answers, if the buffer has room for the line.  The buffer therefore never
overflows, and the controller does not run out of lines.

If the controller answers a line twice, the sum of the sender becomes too small.  The buffer still
does not overflow, because room for the longest line is always kept free.  If an answer is lost, the
sum becomes too large.  Both are detected by comparing the sum with the free bytes that the
controller reports.
"""

from __future__ import annotations

import asyncio
from collections import deque
from dataclasses import dataclass
from enum import Enum, auto

from knifetip.errors import ControllerError
from knifetip.messages import Message

#: Size of the receive buffer (bytes) until it is known, and longest line if it stays unknown.
DEFAULT_SIZE = 128
#: Most characters of a line that a message contains.
_EXCERPT = 60
#: Seconds after which a status request counts as ignored; controllers answer several at once.
_IGNORED = 5.0


class Count(Enum):
    """Result of comparing the sum of the sender with the bytes in the controller's buffer."""

    POSSIBLE = auto()
    SURPLUS = auto()  #: more bytes than the unanswered lines have: a line was answered twice
    MISSING = auto()  #: fewer bytes than the unanswered lines must have: an answer was lost


@dataclass(slots=True)
class PendingLine:
    """A line that the controller has not answered; its bytes may be in the receive buffer."""

    text: bytes
    number: int = 0  #: number of the program line, from 1; 0 for a command of the driver
    #: For a command: its error code, and the lines received before its answer.
    answer: asyncio.Future[tuple[int, list[str]]] | None = None

    @property
    def size(self) -> int:
        """Number of bytes of the line as it is sent, including the line end."""
        return len(self.text) + 1

    @property
    def excerpt(self) -> str:
        """The beginning of the line, for messages."""
        return self.text.decode("ascii", "replace").strip()[:_EXCERPT]

    def fail(self, error: ControllerError) -> None:
        """Raise an error in the task that waits for the answer to this line, if a task waits."""
        if self.answer is not None and not self.answer.done():
            self.answer.set_exception(error)
            self.answer.exception()  # asyncio logs the error if the waiting task was cancelled


class ReceiveBuffer:
    """The unanswered lines of a controller, and the number of bytes that they occupy."""

    def __init__(self) -> None:
        self.capacity = DEFAULT_SIZE - 1  #: bytes that unanswered lines may occupy
        self._singly = False  # the size is unknown: send each line after the last answer
        self._lines: deque[PendingLine] = deque()
        self._used = 0
        self._longest = 0  # program line since all answers were assigned to lines
        self._most_free = 0  # most bytes that the controller ever reported as free
        self._sent = 0  # bytes of all lines sent so far
        self._requests: deque[tuple[float, int]] = deque()  # time, and bytes sent before
        self._unrequested = False  # the controller sends reports without a request
        self._last = Count.POSSIBLE
        self._repeats = 0  # consecutive reports with the result ``_last``

    def set_size(self, size: int | None) -> None:
        """Set the size of the buffer (bytes), as the controller reports it.

        If it is None, the controller does not report it, and each line is sent only after the line
        before it was answered.
        """
        self._singly = size is None
        self.capacity = max(size or DEFAULT_SIZE, 2) - 1

    @property
    def first(self) -> PendingLine | None:
        """Oldest unanswered line, to which the next answer belongs; None if there is none."""
        return self._lines[0] if self._lines else None

    def due(self) -> Message | None:
        """Return a message that names the oldest unanswered program line, for error messages.

        The message contains the number and the text of the line.  Returns None if no program line
        is unanswered; commands of the driver are not program lines.
        """
        line = next((line for line in self._lines if line.number), None)
        if line is None:
            return None
        return Message("controller.due", line=line.number, text=line.excerpt)

    def reserve(self, line: PendingLine) -> None:
        """Keep at least the size of a line free in the buffer from now on.

        If the controller answers a line twice, the sender counts too few occupied bytes; the error
        is the size of that line.  The free bytes then prevent an overflow of the buffer.
        """
        self._longest = max(self._longest, line.size)

    def release_reserve(self) -> None:
        """Stop keeping bytes free in the buffer.

        Called when all answers have been matched to lines, so that none was answered twice and
        the count of occupied bytes is right.
        """
        self._longest = 0

    def has_room_for(self, line: PendingLine) -> bool:
        """Return whether the buffer has room for a line and for the bytes that are kept free.

        Returns True if there is no unanswered line.
        """
        if not self._lines:
            return True
        return not self._singly and self._used + line.size + self._longest <= self.capacity

    def add(self, line: PendingLine) -> None:
        """Add a line that is being sent to the unanswered lines."""
        self._lines.append(line)
        self._used += line.size
        self._sent += line.size

    def remove_first(self) -> PendingLine:
        """Remove the oldest unanswered line, which has just been answered, and return it."""
        line = self._lines.popleft()
        self._used -= line.size
        return line

    def fail(self, error: ControllerError) -> None:
        """Raise an error in all tasks that wait for the answer to a line of this buffer."""
        for line in self._lines:
            line.fail(error)

    def clear(self) -> None:
        """Remove all unanswered lines, because a reset empties the buffer of the controller."""
        self._lines.clear()
        self._used = self._longest = self._repeats = 0

    def note_request(self, now: float) -> None:
        """Store how many bytes were sent before the status request that is being sent.

        Parameters
        ----------
        now
            Present time (s).
        """
        while self._requests and now - self._requests[0][0] > _IGNORED:
            self._requests.popleft()
        self._requests.append((now, self._sent))

    def compare(self, free: int | None) -> tuple[Count, int]:
        """Compare a status report with the sum of the unanswered lines.

        Must be called for every status report, because it is also matched to its request.  The
        result is exact if reports arrive in the order of their requests.  A controller that also
        sends reports without a request is not checked for missing bytes.

        Parameters
        ----------
        free
            Free bytes of the buffer according to the report; None if the report does not state it.

        Returns
        -------
        result
            Result for this report.
        repeats
            Number of consecutive reports with this result; a single one may be damaged.
        """
        self._unrequested = self._unrequested or not self._requests
        before = self._requests.popleft()[1] if self._requests else 0
        if free is None:
            return Count.POSSIBLE, 0
        result = self._compare_bytes(free, before)
        self._repeats = self._repeats + 1 if result is self._last else 1
        self._last = result
        return result, self._repeats

    def _compare_bytes(self, free: int, before: int) -> Count:
        """Compare the free bytes of the controller's buffer with the unanswered lines.

        ``before``: bytes sent before the status request; those sent later may not have arrived.
        """
        self._most_free = max(self._most_free, min(free, self.capacity + 1))
        occupied = self._most_free - free
        if occupied > self._used:
            return Count.SURPLUS
        stated = free <= self.capacity + 1
        if self.first is None or self._unrequested or not stated:
            return Count.POSSIBLE
        # The controller takes a line out of the buffer before it answers it, but only one.
        least = self._used - (self._sent - before) - self.first.size
        return Count.MISSING if occupied < least else Count.POSSIBLE
