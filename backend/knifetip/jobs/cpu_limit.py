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
from knifetip.warming import missing_parts

#: Processor time that a reading may use (s).
READING: Final = 20.0
#: Processor time after which the error is raised again, if a reader has caught it (s).
_AGAIN: Final = 1.0


class _Kernels:
    """Whether the kernels of the readers are compiled; once they are, this is not checked again."""

    def __init__(self) -> None:
        self._compiled = False

    def are_compiled(self) -> bool:
        self._compiled = self._compiled or not missing_parts("drawings")
        return self._compiled


_KERNELS: Final = _Kernels()


@contextmanager
def limit_cpu(seconds: float = READING) -> Iterator[None]:
    """Raise an error in the body of the ``with`` statement when it has used its processor time.

    The time of all threads of the process counts.  A compiled function is not interrupted; the
    error is raised when it returns.  Call it in the main thread.

    Without machine code of the readers on disk there is no limit: a new installation compiles it
    in the first reading, which takes longer than the drawing.

    Raises
    ------
    DrawingTooLarge
        The body has used ``seconds`` of processor time.
    """
    if not _KERNELS.are_compiled():
        yield
        return

    def stop(_signal: int, _frame: FrameType | None) -> None:
        raise DrawingTooLarge("reading.too-slow", seconds=seconds, format="drawing")

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds, _AGAIN)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
