"""threads: threads of their own for the requests of gateways.

Requests that wait for a process (uploads, orders) hold threads of the server's common pool.  What a
gateway reports must not wait behind them: a heartbeat that is late by a lease interrupts the cut.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import ParamSpec, TypeVar

P = ParamSpec("P")
T = TypeVar("T")


class GatewayThreads:
    """Two pools: gateways that wait for work do not keep those waiting that report."""

    def __init__(self) -> None:
        self._reports = ThreadPoolExecutor(4, "report")
        self._claims = ThreadPoolExecutor(2, "claim")

    async def reports(self, call: Callable[P, T], *args: P.args, **named: P.kwargs) -> T:
        """Return ``call(*args, **named)``, of a heartbeat, a finish or a health check."""
        return await _run(self._reports, partial(call, *args, **named))

    async def claims(self, call: Callable[P, T], *args: P.args, **named: P.kwargs) -> T:
        """Return ``call(*args, **named)``, of a look at the queue or the fetch of a program."""
        return await _run(self._claims, partial(call, *args, **named))

    def close(self) -> None:
        """End the threads when their calls have returned."""
        for pool in (self._reports, self._claims):
            pool.shutdown(wait=False, cancel_futures=True)


async def _run(pool: ThreadPoolExecutor, call: Callable[[], T]) -> T:
    return await asyncio.get_running_loop().run_in_executor(pool, call)
