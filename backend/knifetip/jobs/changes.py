"""changes: wakes threads and coroutines of this process when a job or drawing has changed.

    with changes.subscribed(event.set): event.wait(1.0)

Other processes on the same database are not woken; they look at it now and then.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager


class Changes:
    """Callbacks that are called after each transaction that wrote an event."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._callbacks: list[Callable[[], object]] = []

    @contextmanager
    def subscribed(self, callback: Callable[[], object]) -> Iterator[None]:
        """Have ``callback()`` called after each change, on the thread that made it."""
        with self._lock:
            self._callbacks.append(callback)
        try:
            yield
        finally:
            with self._lock:
                self._callbacks.remove(callback)

    def notify(self) -> None:
        """Call the callbacks; each must return at once and raise nothing."""
        with self._lock:
            callbacks = list(self._callbacks)
        for callback in callbacks:
            callback()
