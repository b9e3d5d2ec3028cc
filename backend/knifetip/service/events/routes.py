"""Changes of jobs, drawings, stations and the library as server-sent events.

The first event is ``connected``: changes are sent from now on, so a client that lists jobs after it
misses none.  The others are ``job`` with a JobOut, ``drawing`` with a DrawingSummary, ``deleted``
with ``{"drawing": id}``, ``station`` with a StationOut, and ``library`` with ``{}`` when a machine,
a board, a tool or a profile has changed.

The id of an event is the number of the change.  Events about stations and the library, and events
that report only the progress of a job or only a new reason why a job waits, have no id.  A client
that reconnects sends the last id that it received (``Last-Event-ID``) and gets one event for each
job and drawing that has changed since then.
"""

from __future__ import annotations

import asyncio
import json
import logging
import time
from collections.abc import AsyncIterator, Awaitable, Callable, Collection, Sequence
from contextvars import Context
from functools import partial
from typing import Annotated, Any, Final, NamedTuple, ParamSpec, TypeVar

import sqlalchemy.exc
from fastapi import Header, Query, Request
from fastapi.sse import EventSourceResponse, ServerSentEvent
from pydantic.json_schema import SkipJsonSchema

from knifetip.contract.job import State
from knifetip.errors import NotFound
from knifetip.model.stage import Stage
from knifetip.service.components import Service
from knifetip.service.database.change_event import event_on_change
from knifetip.service.database.key_limits import UNLIMITED, KeyLimits
from knifetip.service.database.tables import Event
from knifetip.service.drawings.requests import summary_out
from knifetip.service.events.gaps import EventGaps
from knifetip.service.http.head_requests import is_head
from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.principal import permission_of, principal_of
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.machines.routes import station_out
from knifetip.service.machines.station_models import StationOut
from knifetip.service.machines.waiting import WaitingFor
from knifetip.service.orders.job_answers import job_out, jobs_out
from knifetip.service.orders.models import JobOut

P = ParamSpec("P")
T = TypeVar("T")

router = ScopedRouter(tags=["events"])

_PROGRESS_POLL = 0.2  # seconds between two queries for progress
_EVENT_POLL = 1.0  # seconds between two queries for changes made by other servers
_RECENT = 100  # events among which late ones are searched when the first client connects
_REFRESH = 2.0  # seconds between two queries for what queued jobs wait for, without events
_RETRY = 2000  # milliseconds after which a client connects again
_BACKLOG = 1000  # unsent messages after which a slow listener is disconnected
_PERMISSION_POLL = 1.0  # seconds between two checks whether a client may still listen
_MAX_WAITING = 50  # newest jobs whose wait for kernels is reported
_ACTIVE_STATES = (State.COMPILING.value, State.RUNNING.value, State.HELD.value)
_log = logging.getLogger("knifetip.api")


class Change(NamedTuple):
    """A message for clients, and whose job, drawing or machine it is about."""

    sent: ServerSentEvent
    customer: str | None = ""  #: "" for none; None for a message about all customers
    machine: str = ""  #: of a job or a station; "" for none

    def is_for(self, limits: KeyLimits) -> bool:
        """Return whether a client with limits may see the message."""
        if limits.customer and self.customer is not None and self.customer != limits.customer:
            return False
        return not self.machine or limits.sees_machine(self.machine)


class Stream:
    """Sends every change of a job or drawing in the store to all connected clients.

    It queries the store only while clients are connected.
    """

    def __init__(self, service: Service) -> None:
        self._service = service
        self._listeners: dict[asyncio.Queue[ServerSentEvent | None], KeyLimits] = {}
        self._has_listeners = asyncio.Event()
        self._lock = asyncio.Lock()
        self._last = 0
        self._gaps = EventGaps()
        self._sent_progress: dict[str, tuple[object, ...]] = {}
        self._sent_stations: dict[str, StationOut] = {}
        self._library: object = None  #: newest versions in the library; None before the first query
        self._waits: dict[str, tuple[WaitingFor, MessageOut | None]] = {}
        self._refreshed = 0.0
        self._watched = False  # a person looks at a machine

    async def run(self) -> None:
        """Send changes to the connected clients; runs until its asyncio task is cancelled."""
        with event_on_change(self._service.store.changes) as changed:
            while True:
                await self._has_listeners.wait()
                try:
                    async with self._lock:
                        messages = await _read(self._new_messages)
                        for message in messages:
                            self._broadcast(message)
                except Exception:
                    _log.exception("the stream of events failed")
                    self._forget_sent()
                # Progress and reports on machines set no change event, so they are polled while a
                # job is active or a person looks at a machine.
                moving = self._sent_progress or self._watched
                poll = self._service.store.changes.poll(_EVENT_POLL)
                await changed.wait(_PROGRESS_POLL if moving else min(poll, _REFRESH))
                if self._service.stopping.is_set():
                    self._disconnect_all()

    def _disconnect_all(self) -> None:
        """End the event streams of all clients."""
        for queue in list(self._listeners):
            if queue.full():
                queue.get_nowait()
            queue.put_nowait(None)

    async def _disconnect_when_refused(
        self,
        queue: asyncio.Queue[ServerSentEvent | None],
        permission: Callable[[], Awaitable[bool]],
    ) -> None:
        """End the event stream of a client as soon as it is no longer permitted."""
        while await _is_permitted(permission):
            await asyncio.sleep(_PERMISSION_POLL)
        self._listeners.pop(queue, None)
        # The client must not receive what it has not read so far.
        while not queue.empty():
            queue.get_nowait()
        queue.put_nowait(None)

    def _forget_sent(self) -> None:
        """Send the present state of active jobs and stations again.

        After an error it is unknown which changes were sent.
        """
        self._sent_progress, self._sent_stations = {}, {}

    def _broadcast(self, change: Change) -> None:
        for queue, limits in list(self._listeners.items()):
            if not change.is_for(limits):
                continue
            try:
                queue.put_nowait(change.sent)
            except asyncio.QueueFull:
                self._listeners.pop(queue, None)
                queue.get_nowait()
                queue.put_nowait(None)

    def _new_messages(self) -> list[Change]:
        events = self._service.store.events.after(self._last, late=self._gaps.numbers)
        messages = self._messages(events)
        search = self._service.store.jobs.search
        waiting = search((State.RECEIVED.value,), limit=_MAX_WAITING)
        # Other received jobs have no progress.
        active = [row for row in waiting if row.stage == Stage.PREPARE]
        active += search(_ACTIVE_STATES, limit=500)
        progress: dict[str, tuple[object, ...]] = {
            row.id: (
                *(row.state, row.stage, row.progress, row.line, row.position),
                *(row.copies_done, row.phase),
            )
            for row in active
        }
        messages += [
            _job_message(job_out(self._service.store, row))
            for row in active
            if self._sent_progress.get(row.id) != progress[row.id]
        ]
        self._sent_progress = progress
        messages += self._stations()
        if events or time.monotonic() - self._refreshed >= _REFRESH:
            messages += self._queue_events({event.subject for event in events})
            messages += self._library_changed()
        self._last = self._gaps.read(self._last, {event.id for event in events})
        return messages

    def _stations(self) -> list[Change]:
        """Return one event for each station that has changed since the last call."""
        views = self._service.store.stations.all()
        self._watched = any(view.watched for view in views)
        # The time since the last report changes with each call and is no change of the station.
        now = {
            view.row.machine: station_out(view).model_copy(update={"seen_seconds_ago": None})
            for view in views
        }
        changed = [
            view
            for view in views
            if self._sent_stations.get(view.row.machine) != now[view.row.machine]
        ]
        self._sent_stations = now
        return [
            # It names the job on the machine, which may be one of any customer.
            Change(_message("station", station_out(view).model_dump_json()), "", view.row.machine)
            for view in changed
        ]

    def _queue_events(self, sent: Collection[str]) -> list[Change]:
        """Return one event for each queued job whose reason to wait changed since the last call.

        The reason is in the fields ``waiting_for`` and ``message`` of a job.  It can change without
        a change of the job itself, when another job changes or a gateway connects.

        ``sent``: ids of jobs and drawings that already have an event and get no second one.
        """
        self._refreshed = time.monotonic()
        rows = self._service.store.jobs.search((State.QUEUED.value,), limit=500)
        models = jobs_out(self._service.store, rows)
        waits = {job.id: (job.waiting_for, job.message) for job in models}
        messages = [
            _job_message(job)
            for job in models
            if job.id not in sent and self._waits.get(job.id, waits[job.id]) != waits[job.id]
        ]
        self._waits = waits
        return messages

    def _library_changed(self) -> list[Change]:
        """Return an event if an entry or a profile has changed since the last call."""
        store = self._service.store
        before = self._library
        self._library = store.library.newest_versions(), store.profiles.newest_versions()
        if before in (None, self._library):
            return []
        return [Change(_message("library", "{}"), None)]

    def _messages(self, events: Sequence[Event]) -> list[Change]:
        newest = {(event.kind, event.subject): event.id for event in events}
        ids = [subject for kind, subject in newest if kind == "job"]
        store = self._service.store
        jobs = {
            job.id: job for job in jobs_out(store, store.jobs.search(ids=ids, limit=len(ids) or 1))
        }
        messages = []
        for (kind, subject), number in sorted(newest.items(), key=lambda item: item[1]):
            if kind == "job" and subject in jobs:
                messages.append(_job_message(jobs[subject], number))
            elif kind == "drawing":
                messages.append(self._drawing(subject, number))
        return messages

    def _drawing(self, id: str, number: int) -> Change:
        try:
            drawing = summary_out(self._service.store.drawings.get(id))
        except NotFound:
            return Change(_message("deleted", json.dumps({"drawing": id}), number))
        return Change(_message("drawing", drawing.model_dump_json(), number), drawing.customer)

    async def listen(
        self,
        after: int | None,
        permission: Callable[[], Awaitable[bool]],
        limits: KeyLimits = UNLIMITED,
    ) -> AsyncIterator[ServerSentEvent]:
        """Yield server-sent events: past changes, then new changes.

        Parameters
        ----------
        after
            Number of the event after which changes are yielded; None for only new changes.
        permission
            Returns whether the client may still listen; if not, the iterator ends.
        limits
            Limits of the key of the client, which gets changes of what it may see only.
        """
        store = self._service.store
        queue: asyncio.Queue[ServerSentEvent | None] = asyncio.Queue(_BACKLOG)
        async with self._lock:
            newest = await _read(store.events.last_id)
            missed: list[Change] = []
            read = last = 0
            if not self._listeners:
                self._last, self._sent_progress = newest, {}
                await _read(self._find_gaps, newest)
                # The client has just fetched jobs and stations: their present state is not sent.
                await _read(self._queue_events, ())
                await _read(self._stations)
                await _read(self._library_changed)
            if after is not None and after < self._last:
                last = self._last
                missed, read = await _read(self._missed_messages, after, last)
            self._listeners[queue] = limits
            self._has_listeners.set()
        watch = asyncio.create_task(self._disconnect_when_refused(queue, permission))
        try:
            # The headers are sent before this client is a listener, so they prove nothing.
            yield ServerSentEvent(event="connected", raw_data="{}", retry=_RETRY)
            # After a long absence there may be more than the memory should contain at a time.
            while missed and not watch.done():
                for change in missed:
                    if change.is_for(limits):
                        yield change.sent
                missed, read = await _read(self._missed_messages, read, last)
            while (news := await queue.get()) is not None:
                yield news
        finally:
            watch.cancel()
            self._listeners.pop(queue, None)
            if not self._listeners:
                self._has_listeners.clear()

    def _find_gaps(self, newest: int) -> None:
        """Note which of the last events before the newest one may still appear."""
        before = max(newest - _RECENT, 0)
        recent = self._service.store.events.after(before)
        self._gaps = EventGaps()
        self._gaps.read(before, {event.id for event in recent if event.id <= newest})

    def _missed_messages(self, after: int, last: int) -> tuple[list[Change], int]:
        """Return messages about the changes after a given one, and the number of the last of them.

        There are none if ``after`` is ``last``, the number of the last change of all.
        """
        while after < last and (batch := self._service.store.events.after(after)):
            after = batch[-1].id
            if found := self._messages([event for event in batch if event.id <= last]):
                return found, after
        return [], last


async def _read(call: Callable[P, T], *args: P.args, **named: P.kwargs) -> T:
    """Execute a call on another thread, without the limits of the client that is listening.

    What the stream remembers is for all clients; each gets what its limits permit.
    """
    return await asyncio.to_thread(Context().run, partial(call, *args, **named))


async def _is_permitted(permission: Callable[[], Awaitable[bool]]) -> bool:
    try:
        return await permission()
    except sqlalchemy.exc.SQLAlchemyError:
        # Without the database there are no events either; the next check decides.
        return True


def _job_message(job: JobOut, number: int | None = None) -> Change:
    """Return the message with the present state of a job."""
    return Change(_message("job", job.model_dump_json(), number), job.customer, job.machine)


def _message(kind: str, data: str, number: int | None = None) -> ServerSentEvent:
    return ServerSentEvent(event=kind, raw_data=data, id=None if number is None else str(number))


#: The answer of the stream, which OpenAPI 3.1 has no schema for.
_ANSWER: Final[dict[int | str, dict[str, Any]]] = {
    200: {
        "description": "Server-sent events. `connected`: first, without data. `job`: a `JobOut`. "
        '`drawing`: a `DrawingSummary`. `deleted`: `{"drawing": ID}`. `station`: a `StationOut`. '
        "`library`: an entry or a profile changed, without data. The `id` of an event is for "
        "`Last-Event-ID`",
        "content": {
            "text/event-stream": {
                "schema": {
                    "type": "string",
                    "description": "Events with the fields `event`, `data` (JSON) and `id`",
                },
                "example": 'event: job\nid: 42\ndata: {"id": "a1b2c3d4e5", "state": "queued"}\n\n',
            }
        },
    }
}


@router.get("/events", response_class=EventSourceResponse, responses=_ANSWER)
@requires(AccessScope.VIEWER)
async def get_events(
    request: Request,
    last: Annotated[
        str | SkipJsonSchema[None],  # a header is never null
        Header(
            alias="Last-Event-ID",
            description="Id of the last received event; later changes are sent again",
        ),
    ] = None,
    after: Annotated[
        int | None, Query(ge=0, le=2**53, description="Same as the header, which takes precedence")
    ] = None,
) -> AsyncIterator[ServerSentEvent]:
    """Stream changes of jobs, drawings, stations and the library as server-sent events.

    ``Last-Event-ID`` or ``after`` is the id of the last event that the client received; the changes
    since then are sent first.  If neither is given, only new changes are sent.  The first event is
    ``connected``: a client that lists jobs after it misses no change.  The stream ends when its
    session or its key ends.
    """
    if is_head(request.scope):
        return
    stream: Stream = request.app.state.stream
    limits = principal_of(request).limits
    # An id that is not a number is not from this server; past events are not replayed.
    last_event = int(last) if last is not None and last.isdecimal() and len(last) < 16 else after
    async for event in stream.listen(last_event, permission_of(request), limits):
        yield event
