"""Wait in a coroutine for the next change in the store."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from contextlib import contextmanager, suppress

from knifetip.jobs.changes import Changes


class Wake:
    """An event of the running event loop that every change in the store sets, from any thread."""

    def __init__(self) -> None:
        self._event = asyncio.Event()

    async def wait(self, seconds: float) -> None:
        """Return at the next change in the store, or after ``seconds`` without a change.

        A change since the previous call counts: the call then returns immediately.
        """
        with suppress(TimeoutError):
            await asyncio.wait_for(self._event.wait(), seconds)
        self._event.clear()


@contextmanager
def wake_on_change(changes: Changes) -> Iterator[Wake]:
    """Context manager that yields a ``Wake`` of the running event loop.

    The ``Wake`` is set by every change in the store from the start of the context on.
    """
    loop = asyncio.get_running_loop()
    wake = Wake()

    def set_event() -> None:
        with suppress(RuntimeError):  # the loop is closed
            loop.call_soon_threadsafe(wake._event.set)

    with changes.subscribed(set_event):
        yield wake
