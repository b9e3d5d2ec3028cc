"""queue: requests that need a worker process wait here, without a thread and in order.

    @router.post(…)
    @queued
    def upload_drawing(here: Here, …): …

Only a few of them are on threads at the same time, since each thread that computes delays every
other one of the server.  When too many wait, the next is refused before anything of it is kept.
"""

from __future__ import annotations

import asyncio
import math
import time
from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial, wraps
from typing import ParamSpec, Protocol, TypeVar, cast

from knifetip.errors import ServerBusy

P = ParamSpec("P")
T = TypeVar("T")

WAITING = 16  #: requests that may wait
_LONGEST = 60  # seconds that Retry-After may ask for


class WorkQueue:
    """A bounded queue of calls and the threads that make them.

    Parameters
    ----------
    at_once
        Calls that are made at the same time.
    waiting
        Calls that may wait besides.
    """

    def __init__(self, at_once: int, waiting: int = WAITING) -> None:
        self._threads = ThreadPoolExecutor(at_once, "work")
        self._at_once = at_once
        self._most = at_once + waiting
        self._inside = 0
        self._seconds = 1.0  # of a call, on average

    async def run(self, call: Callable[[], T]) -> T:
        """Return ``call()``, made on one of the threads.

        Raises
        ------
        ServerBusy
            Too many wait; the call was not made.
        """
        if self._inside >= self._most:
            waiting = self._inside - self._at_once
            seconds = math.ceil(self._seconds * (waiting + 1) / self._at_once)
            raise ServerBusy(waiting, min(max(seconds, 1), _LONGEST))
        self._inside += 1
        try:
            return await asyncio.get_running_loop().run_in_executor(
                self._threads, self._timed, call
            )
        finally:
            self._inside -= 1

    def _timed(self, call: Callable[[], T]) -> T:
        begun = time.monotonic()
        try:
            return call()
        finally:
            self._seconds += 0.2 * (time.monotonic() - begun - self._seconds)

    def close(self) -> None:
        """Make no further calls."""
        self._threads.shutdown(wait=False, cancel_futures=True)


class _Queued(Protocol):
    work: WorkQueue


def queued(endpoint: Callable[P, T]) -> Callable[P, Awaitable[T]]:
    """Return a route that waits in the queue of its argument ``here``."""

    @wraps(endpoint)
    async def route(*args: P.args, **named: P.kwargs) -> T:
        here = cast("_Queued", named["here"])
        return await here.work.run(partial(endpoint, *args, **named))

    return route
