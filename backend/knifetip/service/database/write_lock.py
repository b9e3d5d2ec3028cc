"""Lock for the threads that write to SQLite, with priority for urgent threads.

SQLite permits one writer at a time and has no queue: a waiting thread retries at intervals, and
with many writers it may wait for seconds.  The threads of a process therefore wait for this lock.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext


class PriorityLock:
    """A lock with two priorities: urgent threads get it before all other waiting threads."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._taken = False
        self._urgent = 0  # that wait

    @contextmanager
    def acquired(self, urgent: bool) -> Iterator[None]:
        """Return a context manager that acquires the lock on entry and releases it on exit.

        Parameters
        ----------
        urgent
            Whether this thread gets the lock before waiting threads that are not urgent.
        """
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


class NoLock:
    """Replacement of ``PriorityLock`` for databases that permit several writers at a time."""

    def acquired(self, urgent: bool) -> AbstractContextManager[None]:  # noqa: ARG002  # signature of PriorityLock.acquired
        """Return a context manager that neither waits nor locks."""
        return nullcontext()
