"""Separate threads for the requests of gateways.

Uploads and new jobs occupy threads of the server's shared pool while they wait for a process.
Heartbeats of gateways must not wait for these threads: the service interrupts a job if it
receives no heartbeat within a fixed time, the lease.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextvars import copy_context
from functools import partial
from typing import ParamSpec, TypeVar

P = ParamSpec("P")
T = TypeVar("T")


class GatewayThreads:
    """Two thread pools for requests of gateways: one for claims of jobs, one for reports on jobs.

    A claim can wait a long time for a job.  Because of the separate pools, waiting claims do not
    delay the reports.
    """

    def __init__(self) -> None:
        self._reports = ThreadPoolExecutor(4, "report")
        self._claims = ThreadPoolExecutor(2, "claim")

    async def reports(self, call: Callable[P, T], *args: P.args, **named: P.kwargs) -> T:
        """Execute a call for a heartbeat, the end of a job or a health check; return its result.

        The call uses other threads than the claims of jobs, so that claims do not delay it.
        """
        return await _run(self._reports, partial(call, *args, **named))

    async def claims(self, call: Callable[P, T], *args: P.args, **named: P.kwargs) -> T:
        """Execute a call that claims a job or fetches a program, and return its result."""
        return await _run(self._claims, partial(call, *args, **named))

    def close(self) -> None:
        """Shut the threads down after their current calls; waiting calls are cancelled."""
        for pool in (self._reports, self._claims):
            pool.shutdown(wait=False, cancel_futures=True)


async def _run(pool: ThreadPoolExecutor, call: Callable[[], T]) -> T:
    return await asyncio.get_running_loop().run_in_executor(pool, partial(copy_context().run, call))
