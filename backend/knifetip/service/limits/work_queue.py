"""Queues of requests that need a worker process or store an order.

A waiting request occupies no thread.

The decorator ``queued`` executes a route in this queue::

    @router.post(…)
    @queued
    def upload_drawing(service: ServiceDep, …): …

The number of requests that are executed at the same time is small, because each computing thread
delays all other threads of the server.  If too many requests wait, the next one is refused before
any of its data is stored.  One client cannot occupy all workers or all places in the queue while
others wait.

A call that is being executed ends even if its client has closed the connection: the client will
repeat the request, and the repetition gets the result of the call that is still executed.  Such a
call counts as one of its client until it ends.  A waiting call whose client has gone is dropped,
unless the request has an Idempotency-Key, which announces the repetition.
"""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import inspect
import math
import time
from collections import Counter
from collections.abc import Awaitable, Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextvars import copy_context
from functools import partial, wraps
from typing import Any, Final, NamedTuple, ParamSpec, Protocol, TypeVar, cast

from fastapi import Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import BaseModel
from starlette.datastructures import UploadFile

from knifetip.errors import ServerBusy
from knifetip.service.database.acting import acting_principal
from knifetip.service.processes.pool import TaskCancelled

P = ParamSpec("P")
T = TypeVar("T")

WAITING = 16  #: most requests that may wait
#: Orders of stored drawings need no worker process; each takes a few ms.
ORDERS_AT_ONCE: Final = 4
ORDERS_WAITING: Final = 1024
_LONGEST = 60  # greatest Retry-After (s)
_BLOCK: Final = 1 << 20  # bytes of a file that are read at once
#: Arguments of a route that are not part of the content of its request.
_CIRCUMSTANCES: Final = ("service", "principal", "request", "response", "key")
_LOOK = 0.5  # seconds between two checks whether a client has closed its connection


async def _stays() -> bool:
    return False


class Client(NamedTuple):
    """The sender of a request."""

    name: str = ""  #: equal for all requests of one client
    has_gone: Callable[[], Awaitable[bool]] = _stays  #: whether it has closed its connection

    @classmethod
    def from_request(cls, request: Request) -> Client:
        """Return the client of a request: its address, and its key if it has sent one."""
        address = "" if request.client is None else request.client.host
        key = request.headers.get("Authorization") or request.headers.get("Cookie") or ""
        return cls(f"{address} {key}", request.is_disconnected)


class RequestIdentity(NamedTuple):
    """What two requests have in common if one of them repeats the other."""

    #: hash of sender, operation, Idempotency-Key and content
    digest: str
    has_key: bool  #: whether the request has an Idempotency-Key

    @classmethod
    def from_content(cls, operation: str, key: str | None, *content: bytes) -> RequestIdentity:
        """Return the identity of a request of the acting principal.

        Parameters
        ----------
        operation
            Name of the operation.
        key
            Idempotency-Key of the request, None if it has none.
        *content
            All parameters of the request.
        """
        digest = hashlib.sha256()
        for part in (acting_principal().encode(), operation.encode(), repr(key).encode(), *content):
            # The length separates neighbouring parts.
            digest.update(len(part).to_bytes(8, "big") + part)
        return cls(digest.hexdigest(), key is not None)


class _Ticket:
    """A call that waits or is executed, for the requests that wait for its result."""

    def __init__(
        self, call: Callable[[], Any], client: str, identity: RequestIdentity | None
    ) -> None:
        self.call = call
        self.client = client
        self.identity = identity
        #: the clients that wait for the result; one may wait several times
        self.present: dict[object, Client] = {}
        self.result: asyncio.Future[Any] = asyncio.get_running_loop().create_future()
        #: of the request: a waiting call is begun by the end of another request's call
        self.context = copy_context()
        # The clients may all have gone when the call fails.
        self.result.add_done_callback(lambda done: done.cancelled() or done.exception())

    async def is_abandoned(self) -> bool:
        """Return whether all clients that waited for the result have gone."""
        for client in tuple(self.present.values()):
            if not await client.has_gone():
                return False
        return True


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
        #: waiting and running calls of requests that may be repeated, by ``digest``
        self._repeatable: dict[str, list[_Ticket]] = {}
        self._running: Counter[str] = Counter()
        self._seconds = 1.0  # average duration of a call

    @property
    def waiting(self) -> int:
        """Number of calls that wait for a thread."""
        return len(self._waiting)

    async def run(
        self,
        call: Callable[[], T],
        client: Client | None = None,
        identity: RequestIdentity | None = None,
    ) -> T:
        """Execute ``call`` on one of the threads and return its result.

        If the request repeats one whose call waits or is executed, it gets the result of that call
        and needs no place.  It repeats another request if both have the same content and the same
        Idempotency-Key.  A request without a key repeats only requests whose clients have gone:
        two clients may both want a drawing of the same content.

        Parameters
        ----------
        call
            Function to execute.
        client
            Sender of the request.
        identity
            What the request has in common with its repetitions; None if it cannot be repeated.

        Raises
        ------
        ServerBusy
            Too many calls wait; ``call`` was not executed.
        TaskCancelled
            All clients have gone while the call waited; it was not executed.
        """
        client = client or Client()
        ticket = None if identity is None else await self._find_earlier_call(identity)
        if ticket is None:
            self._check_places(client.name)
            ticket = self._new_ticket(call, client.name, identity)
        visit = object()
        ticket.present[visit] = client
        self._begin_calls()
        watch = asyncio.create_task(self._watch(ticket, visit))
        try:
            # The end of one request must not end the call of the others.
            result: T = await asyncio.shield(ticket.result)
            return result
        finally:
            watch.cancel()
            self._leave(ticket, visit)

    async def _find_earlier_call(self, identity: RequestIdentity) -> _Ticket | None:
        """Return the waiting or running call of an identical earlier request; None if there is
        none.
        """
        for ticket in tuple(self._repeatable.get(identity.digest, ())):
            repeats = identity.has_key or await ticket.is_abandoned()
            # It may have ended or been dropped meanwhile.
            if repeats and not ticket.result.done():
                return ticket
        return None

    def _new_ticket(
        self, call: Callable[[], Any], client: str, identity: RequestIdentity | None
    ) -> _Ticket:
        ticket = _Ticket(call, client, identity)
        self._waiting.append(ticket)
        if identity is not None:
            self._repeatable.setdefault(identity.digest, []).append(ticket)
            ticket.result.add_done_callback(lambda _: self._forget(identity.digest, ticket))
        return ticket

    def _forget(self, digest: str, ticket: _Ticket) -> None:
        tickets = self._repeatable[digest]
        tickets.remove(ticket)
        if not tickets:
            del self._repeatable[digest]

    def _leave(self, ticket: _Ticket, visit: object) -> None:
        """Note that a client does not wait for a result any more; drop a call without clients."""
        if ticket.present.pop(visit, None) is None:
            return
        returns = ticket.identity is not None and ticket.identity.has_key
        if ticket in self._waiting and not ticket.present and not returns:
            self._waiting.remove(ticket)
            if not ticket.result.done():
                ticket.result.set_exception(TaskCancelled())

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
            execute = partial(ticket.context.run, self._measure_time, ticket.call)
            work = asyncio.get_running_loop().run_in_executor(self._threads, execute)
            work.add_done_callback(partial(self._end, ticket))

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

    async def _watch(self, ticket: _Ticket, visit: object) -> None:
        """Note when a client has gone."""
        while not await ticket.present[visit].has_gone():
            await asyncio.sleep(_LOOK)
        self._leave(ticket, visit)

    def _measure_time(self, call: Callable[[], T]) -> T:
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
        own = cast("Response | None", named.get("response"))
        identity = await run_in_threadpool(_identity, endpoint.__name__, named)

        def call() -> tuple[T, Response | None]:
            return endpoint(*args, **named), own

        result, response = await service.work.run(call, Client.from_request(request), identity)
        if own is not None and response is not None and response is not own:
            own.raw_headers.extend(response.raw_headers)
        return result

    if not takes_request:
        own = inspect.Parameter("request", inspect.Parameter.KEYWORD_ONLY, annotation=Request)
        parameters = [*signature.parameters.values(), own]
        vars(route)["__signature__"] = signature.replace(parameters=parameters)
    return route


def _identity(operation: str, named: Mapping[str, object]) -> RequestIdentity:
    """Return the identity of a request from the arguments of its route."""
    key = cast("str | None", named.get("key"))
    parts = [
        part
        for name, value in sorted(named.items())
        if name not in _CIRCUMSTANCES
        for part in (name.encode(), _content(value))
    ]
    return RequestIdentity.from_content(operation, key, *parts)


def _content(value: object) -> bytes:
    """Return a parameter of a request, or a hash of it, as bytes."""
    match value:
        case UploadFile():
            digest = hashlib.sha256()
            value.file.seek(0)
            while block := value.file.read(_BLOCK):
                digest.update(block)
            value.file.seek(0)
            return f"{value.filename}\0{digest.hexdigest()}".encode("utf-8", "replace")
        case BaseModel():
            # A field that is missing may have another meaning than one with its default.
            return repr(value.model_dump(exclude_unset=True)).encode()
    return repr(value).encode()
