"""Queues of requests that need a worker process or store an order.

A waiting request occupies no thread.

The decorator ``queued`` executes a route in this queue::

    @router.post(…)
    @queued
    def upload_drawing(service: ServiceDep, …): …

The number of requests that are executed at the same time is small, because each computing thread
delays all other threads of the server.  If too many requests wait, the next one is refused before
any of its data is stored.  A request whose client has closed its connection is dropped.  One client
cannot occupy all workers or all places in the queue while others wait.
"""

from __future__ import annotations

import asyncio
import contextlib
import inspect
import math
import threading
import time
from collections import Counter
from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from contextvars import ContextVar, copy_context
from functools import partial, wraps
from typing import Any, Final, NamedTuple, ParamSpec, Protocol, TypeVar, cast

from fastapi import Request

from knifetip.errors import ServerBusy
from knifetip.jobs.process_pool import TaskCancelled

P = ParamSpec("P")
T = TypeVar("T")

WAITING = 16  #: most requests that may wait
#: Orders of stored drawings need no worker process; each takes a few ms.
ORDERS_AT_ONCE: Final = 4
ORDERS_WAITING: Final = 1024
_LONGEST = 60  # greatest Retry-After (s)
_LOOK = 0.5  # seconds between two checks whether a client has closed its connection

_gone: ContextVar[threading.Event | None] = ContextVar("gone", default=None)


def is_client_gone() -> bool:
    """Return whether the client of the call that this thread executes has gone."""
    gone = _gone.get()
    return gone is not None and gone.is_set()


async def _stays() -> bool:
    return False


class Client(NamedTuple):
    """The sender of a request."""

    name: str = ""  #: equal for all requests of one client
    has_gone: Callable[[], Awaitable[bool]] = _stays  #: whether it has closed its connection

    @classmethod
    def of(cls, request: Request) -> Client:
        """Return the client of a request: its address, and its key if it has sent one."""
        address = "" if request.client is None else request.client.host
        key = request.headers.get("Authorization") or request.headers.get("Cookie") or ""
        return cls(f"{address} {key}", request.is_disconnected)


class _Ticket:
    """A call that waits or is executed."""

    def __init__(self, call: Callable[[], Any], client: str) -> None:
        self.call = call
        self.client = client
        self.result: asyncio.Future[Any] = asyncio.get_running_loop().create_future()
        self.gone = threading.Event()
        #: of the request: a waiting call is begun by the end of another request's call
        self.context = copy_context()


class WorkQueue:
    """A bounded queue of calls, executed by a fixed number of threads.

    All methods except ``close`` must be called in one event loop.

    Parameters
    ----------
    at_once
        Number of threads.
    waiting
        Maximum number of waiting calls.
    per_client
        Number of calls of one client that are executed at the same time; a quarter of the places
        is then kept for other clients.  None for no limit.
    """

    def __init__(self, at_once: int, waiting: int = WAITING, per_client: int | None = None) -> None:
        self._threads = ThreadPoolExecutor(at_once, "work")
        self._at_once = at_once
        self._places = waiting
        self._per_client = per_client or at_once
        #: places that one client cannot occupy
        self._kept = waiting // 4 if self._per_client < at_once else 0
        self._waiting: list[_Ticket] = []
        self._running: Counter[str] = Counter()
        self._seconds = 1.0  # average duration of a call

    @property
    def waiting(self) -> int:
        """Number of calls that wait for a thread."""
        return len(self._waiting)

    async def run(self, call: Callable[[], T], client: Client | None = None) -> T:
        """Execute ``call`` on one of the threads and return its result.

        A waiting call whose client has gone is not executed.  A call that is being executed can
        find out with ``is_client_gone``.

        Raises
        ------
        ServerBusy
            Too many calls wait; ``call`` was not executed.
        TaskCancelled
            The client has gone; ``call`` was not executed.
        """
        client = client or Client()
        self._check_places(client.name)
        ticket = _Ticket(call, client.name)
        self._waiting.append(ticket)
        self._begin_calls()
        watch = asyncio.create_task(self._watch(ticket, client))
        try:
            result: T = await ticket.result
            return result
        finally:
            watch.cancel()
            if ticket in self._waiting:
                self._waiting.remove(ticket)

    def _check_places(self, client: str) -> None:
        """Raise ``ServerBusy`` if there is no place in the queue for a further call of a client."""
        if self._running.total() < self._at_once and self._running[client] < self._per_client:
            return
        waiting = len(self._waiting)
        own = sum(ticket.client == client for ticket in self._waiting)
        if waiting >= self._places or own >= self._places - self._kept:
            seconds = math.ceil(self._seconds * (waiting + 1) / self._at_once)
            raise ServerBusy(waiting, min(max(seconds, 1), _LONGEST))

    def _begin_calls(self) -> None:
        """Begin waiting calls while threads are free: first those of the client that has fewest."""
        while self._running.total() < self._at_once:
            ready = [one for one in self._waiting if self._running[one.client] < self._per_client]
            if not ready:
                return
            # The first of several least elements is the oldest.
            ticket = min(ready, key=lambda one: self._running[one.client])
            self._waiting.remove(ticket)
            self._running[ticket.client] += 1
            execute = partial(ticket.context.run, self._execute, ticket)
            work = asyncio.get_running_loop().run_in_executor(self._threads, execute)
            work.add_done_callback(partial(self._end, ticket))

    def _execute(self, ticket: _Ticket) -> Any:
        _gone.set(ticket.gone)
        return self._timed(ticket.call)

    def _end(self, ticket: _Ticket, work: asyncio.Future[Any]) -> None:
        self._running[ticket.client] -= 1
        self._running += Counter()  # drops the clients without calls
        if not ticket.result.done():
            if work.cancelled():
                ticket.result.cancel()
            elif (error := work.exception()) is not None:
                ticket.result.set_exception(error)
            else:
                ticket.result.set_result(work.result())
        with contextlib.suppress(RuntimeError):  # the threads are shut down
            self._begin_calls()

    async def _watch(self, ticket: _Ticket, client: Client) -> None:
        """Drop a call when its client has gone."""
        while not await client.has_gone():
            await asyncio.sleep(_LOOK)
        ticket.gone.set()
        if ticket in self._waiting and not ticket.result.done():
            ticket.result.set_exception(TaskCancelled())

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
    signature = inspect.signature(endpoint)
    takes_request = "request" in signature.parameters

    @wraps(endpoint)
    async def route(*args: P.args, **named: P.kwargs) -> T:
        service = cast("_Queued", named["service"])
        request = cast("Request", named["request"] if takes_request else named.pop("request"))
        return await service.work.run(partial(endpoint, *args, **named), Client.of(request))

    if not takes_request:
        own = inspect.Parameter("request", inspect.Parameter.KEYWORD_ONLY, annotation=Request)
        parameters = [*signature.parameters.values(), own]
        vars(route)["__signature__"] = signature.replace(parameters=parameters)
    return route
