"""turns: who of several threads writes to SQLite next.

SQLite has one writer at a time and no queue: a thread that waits looks again now and then, and
under many writers it may be late by seconds.  Within a process, turns are taken here instead.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext


class Turns:
    """One thread at a time; urgent ones come before all others that wait."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._taken = False
        self._urgent = 0  # that wait

    @contextmanager
    def turn(self, urgent: bool) -> Iterator[None]:
        """Wait for a turn, and have it for the time of the context."""
        with self._changed:
            self._urgent += urgent
            try:
                self._changed.wait_for(lambda: not self._taken and (urgent or not self._urgent))
            finally:
                self._urgent -= urgent
            self._taken = True
        try:
            yield
        finally:
            with self._changed:
                self._taken = False
                self._changed.notify_all()


class NoTurns:
    """For databases that take many writers at a time."""

    def turn(self, urgent: bool) -> AbstractContextManager[None]:  # noqa: ARG002
        """Return a context that waits for nothing."""
        return nullcontext()
