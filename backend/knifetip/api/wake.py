"""wake: lets coroutines wait for the next change in the store."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from contextlib import contextmanager, suppress

from knifetip.jobs.changes import Changes


class Wake:
    """Set by every change in the store, from whatever thread."""

    def __init__(self) -> None:
        self._event = asyncio.Event()

    async def wait(self, seconds: float) -> None:
        """Return after the next change since the last call, or after so many seconds."""
        with suppress(TimeoutError):
            await asyncio.wait_for(self._event.wait(), seconds)
        self._event.clear()


@contextmanager
def woken_by(changes: Changes) -> Iterator[Wake]:
    """Return a ``Wake`` for the running event loop; inside the context no change is missed."""
    loop = asyncio.get_running_loop()
    wake = Wake()

    def set_event() -> None:
        with suppress(RuntimeError):  # the loop is closed
            loop.call_soon_threadsafe(wake._event.set)

    with changes.subscribed(set_event):
        yield wake
