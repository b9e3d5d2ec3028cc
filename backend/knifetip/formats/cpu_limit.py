"""cpu_limit: end a reading that uses too much processor time.

The readers count what a file will cost before they expand it, and refuse what is too large.  This
limit is for what no count has foreseen.  It is processor time, not time on the clock, so that a
busy computer refuses no drawing that a quiet one reads.
"""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Final

from knifetip.errors import DrawingTooLarge

#: Processor time that a reading may use (s).
READING: Final = 20.0
#: Processor time after which the error is raised again, if a reader has caught it (s).
_AGAIN: Final = 1.0
#: Least time after which a timer ends (s).
_LEAST: Final = 1e-3


@contextmanager
def limit_cpu(seconds: float = READING) -> Iterator[None]:
    """Raise an error in the body of the ``with`` statement when it has used its processor time.

    The time of all threads of the process counts.  A compiled function is not interrupted; the
    error is raised when it returns.  Call it in the main thread.

    Raises
    ------
    DrawingTooLarge
        The body has used ``seconds`` of processor time.
    """

    def stop(_signal: int, _frame: FrameType | None) -> None:
        raise DrawingTooLarge("reading.too-slow", seconds=seconds, format="drawing")

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds, _AGAIN)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)


def remaining() -> float:
    """Return the processor time that is left for a child process of the reading (s).

    It is ``READING`` if no reading is limited.
    """
    return signal.getitimer(signal.ITIMER_PROF)[0] or READING


def charge(seconds: float) -> None:
    """Count the processor time of a child process as time of the reading, if one is limited.

    ``seconds`` is the time that the child process has used (s).
    """
    left = signal.getitimer(signal.ITIMER_PROF)[0]
    if left > 0.0:
        signal.setitimer(signal.ITIMER_PROF, max(left - seconds, _LEAST), _AGAIN)


@contextmanager
def pause() -> Iterator[None]:
    """Suspend the limit in the body of the ``with`` statement, whose processor time does not count.

    It is for what must not be left half done, such as the removal of temporary files.
    """
    left, _ = signal.setitimer(signal.ITIMER_PROF, 0.0)
    try:
        yield
    finally:
        if left > 0.0:
            signal.setitimer(signal.ITIMER_PROF, left, _AGAIN)
