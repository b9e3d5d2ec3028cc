"""Wait in a coroutine for the next change in the store."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from contextlib import contextmanager, suppress

from knifetip.service.database.change_notifier import ChangeNotifier


class ChangeEvent:
    """An event for coroutines, which is set by changes in any thread or process."""

    def __init__(self) -> None:
        self._event = asyncio.Event()

    async def wait(self, seconds: float) -> None:
        """Wait until a job or drawing changes in the store, at most ``seconds``.

        Returns immediately if a change was made since the previous call.
        """
        with suppress(TimeoutError):
            # Not ``wait_for``, which loses a cancellation at the moment of a change.
            async with asyncio.timeout(seconds):
                await self._event.wait()
        self._event.clear()


@contextmanager
def event_on_change(changes: ChangeNotifier, *topics: str) -> Iterator[ChangeEvent]:
    """Return a context manager that yields a ``ChangeEvent``, which changes in the store set.

    Parameters
    ----------
    changes
        Notifier of the changes in the store.
    *topics
        Topics of the changes (see ``changes``); none for all changes.

    Yields
    ------
    ChangeEvent
        The event, for coroutines of the running event loop.
    """
    loop = asyncio.get_running_loop()
    wake = ChangeEvent()

    def set_event() -> None:
        with suppress(RuntimeError):  # the loop is closed
            loop.call_soon_threadsafe(wake._event.set)

    with changes.subscribed(set_event, *topics):
        yield wake
