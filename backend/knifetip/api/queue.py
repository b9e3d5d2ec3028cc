"""Queue of requests that need a worker process; a waiting request occupies no thread.

The decorator ``queued`` executes a route in this queue::

    @router.post(…)
    @queued
    def upload_drawing(service: ServiceDep, …): …

The number of requests that are executed at the same time is small, because each computing thread
delays all other threads of the server.  If too many requests wait, the next one is refused before
any of its data is stored.
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

WAITING = 16  #: most requests that may wait
_LONGEST = 60  # greatest Retry-After (s)


class WorkQueue:
    """A bounded queue of calls, executed by a fixed number of threads.

    Parameters
    ----------
    at_once
        Number of threads.
    waiting
        Maximum number of waiting calls.
    """

    def __init__(self, at_once: int, waiting: int = WAITING) -> None:
        self._threads = ThreadPoolExecutor(at_once, "work")
        self._at_once = at_once
        self._most = at_once + waiting
        self._inside = 0
        self._seconds = 1.0  # average duration of a call

    async def run(self, call: Callable[[], T]) -> T:
        """Execute ``call`` on one of the threads and return its result.

        Raises
        ------
        ServerBusy
            Too many calls wait; ``call`` was not executed.
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
        started = time.monotonic()
        try:
            return call()
        finally:
            self._seconds += 0.2 * (time.monotonic() - started - self._seconds)

    def close(self) -> None:
        """Refuse new calls, and do not begin the calls that wait; running calls continue."""
        self._threads.shutdown(wait=False, cancel_futures=True)


class _Queued(Protocol):
    work: WorkQueue


def queued(endpoint: Callable[P, T]) -> Callable[P, Awaitable[T]]:
    """Return a route that executes ``endpoint`` in the ``WorkQueue`` of the server.

    Parameters
    ----------
    endpoint
        Function of the route; its argument ``service`` contains the ``WorkQueue``.
    """

    @wraps(endpoint)
    async def route(*args: P.args, **named: P.kwargs) -> T:
        service = cast("_Queued", named["service"])
        return await service.work.run(partial(endpoint, *args, **named))

    return route
