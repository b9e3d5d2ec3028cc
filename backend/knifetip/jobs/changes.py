"""Notifies threads and coroutines of this process after a change of a job or a drawing.

    with changes.subscribed(event.set): event.wait(1.0)

Other processes on the same database are not notified; they query the database at intervals.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager


class Changes:
    """The functions that are called after each transaction that changed a job or a drawing."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._callbacks: list[Callable[[], object]] = []

    @contextmanager
    def subscribed(self, callback: Callable[[], object]) -> Iterator[None]:
        """Return a context in which ``callback()`` is called after each change of a job or drawing.

        The callback is called on the thread that made the change.
        """
        with self._lock:
            self._callbacks.append(callback)
        try:
            yield
        finally:
            with self._lock:
                self._callbacks.remove(callback)

    def notify(self) -> None:
        """Call all subscribed callbacks, which must return immediately and raise nothing."""
        with self._lock:
            callbacks = list(self._callbacks)
        for callback in callbacks:
            callback()
