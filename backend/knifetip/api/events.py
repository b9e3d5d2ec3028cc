"""events: what happens to jobs and drawings, as server-sent events.

    event: job       data: JobOut           id: of the transition; none for mere progress
    event: drawing   data: DrawingSummary   id
    event: deleted   data: {"drawing": id}  id

A client that connects again sends the last id that it received (``Last-Event-ID``) and gets one
event for each job and drawing that has changed since.
"""

from __future__ import annotations

import asyncio
import json
import logging
import time
from collections.abc import AsyncIterator, Collection, Sequence
from typing import Annotated

from fastapi import APIRouter, Header, Query, Request
from fastapi.sse import EventSourceResponse, ServerSentEvent

from knifetip.api.drawings import summary_out
from knifetip.api.jobs import job_out, jobs_out
from knifetip.api.service import Service
from knifetip.api.wake import woken_by
from knifetip.errors import NoSuchJob
from knifetip.jobs.job import State
from knifetip.jobs.tables import Event

router = APIRouter(tags=["events"])

_TICK = 0.2  # seconds between two looks for progress
_LOOK = 1.0  # seconds between two looks for changes that other servers made
_REFRESH = 2.0  # seconds between two looks at what queued jobs wait for, where nothing happened
_RETRY = 2000  # milliseconds after which a client connects again
_BACKLOG = 1000  # messages that a slow listener may owe before it is hung up on
_MOVING = (State.COMPILING.value, State.RUNNING.value, State.HELD.value)
_log = logging.getLogger("knifetip.api")


class Stream:
    """Looks for changes while there are listeners, and sends them to all."""

    def __init__(self, service: Service) -> None:
        self._service = service
        self._listeners: set[asyncio.Queue[ServerSentEvent | None]] = set()
        self._somebody = asyncio.Event()
        self._door = asyncio.Lock()
        self._last = 0
        self._told: dict[str, tuple[object, ...]] = {}
        self._waits: dict[str, tuple[str, str, str]] = {}
        self._refreshed = 0.0

    async def run(self) -> None:
        """Send changes to the listeners until cancelled."""
        with woken_by(self._service.store.changes) as changed:
            while True:
                await self._somebody.wait()
                try:
                    async with self._door:
                        messages = await asyncio.to_thread(self._news)
                        for message in messages:
                            self._tell(message)
                except Exception:
                    _log.exception("the stream of events failed")
                # Progress is no change: it is looked for while a job moves.
                await changed.wait(_TICK if self._told else _LOOK)
                if self._service.stopping.is_set():
                    self._hang_up()

    def _hang_up(self) -> None:
        """End all streams."""
        for queue in list(self._listeners):
            if queue.full():
                queue.get_nowait()
            queue.put_nowait(None)

    def _tell(self, message: ServerSentEvent) -> None:
        for queue in list(self._listeners):
            try:
                queue.put_nowait(message)
            except asyncio.QueueFull:
                self._listeners.discard(queue)
                queue.get_nowait()
                queue.put_nowait(None)

    def _news(self) -> list[ServerSentEvent]:
        events = self._service.store.events.after(self._last)
        messages = self._messages(events)
        if events:
            self._last = events[-1].id
        moving = self._service.store.jobs.search(_MOVING, limit=500)
        told: dict[str, tuple[object, ...]] = {
            row.id: (row.state, row.stage, row.progress, row.line, row.position, row.copies_done)
            for row in moving
        }
        messages += [
            _message("job", job_out(self._service.store, row).model_dump_json())
            for row in moving
            if self._told.get(row.id) != told[row.id]
        ]
        self._told = told
        if events or time.monotonic() - self._refreshed >= _REFRESH:
            messages += self._queued({event.subject for event in events})
        return messages

    def _queued(self, sent: Collection[str]) -> list[ServerSentEvent]:
        """Return messages for queued jobs that wait for something else than before.

        Another job, or a gateway that comes or goes, changes that without an event of their own.
        """
        self._refreshed = time.monotonic()
        rows = self._service.store.jobs.search((State.QUEUED.value,), limit=500)
        shown = jobs_out(self._service.store, rows)
        waits: dict[str, tuple[str, str, str]] = {
            job.id: (job.waiting_for, job.reason, job.hint) for job in shown
        }
        news = [
            _message("job", job.model_dump_json())
            for job in shown
            if job.id not in sent and self._waits.get(job.id, waits[job.id]) != waits[job.id]
        ]
        self._waits = waits
        return news

    def _messages(self, events: Sequence[Event]) -> list[ServerSentEvent]:
        newest = {(event.kind, event.subject): event.id for event in events}
        ids = [subject for kind, subject in newest if kind == "job"]
        store = self._service.store
        jobs = {
            job.id: job for job in jobs_out(store, store.jobs.search(ids=ids, limit=len(ids) or 1))
        }
        messages = []
        for (kind, subject), number in sorted(newest.items(), key=lambda item: item[1]):
            if kind == "job" and subject in jobs:
                messages.append(_message("job", jobs[subject].model_dump_json(), number))
            elif kind == "drawing":
                messages.append(self._drawing(subject, number))
        return messages

    def _drawing(self, id: str, number: int) -> ServerSentEvent:
        try:
            drawing = summary_out(self._service.store.drawings.get(id))
        except NoSuchJob:
            return _message("deleted", json.dumps({"drawing": id}), number)
        return _message("drawing", drawing.model_dump_json(), number)

    async def listen(self, after: int | None) -> AsyncIterator[ServerSentEvent]:
        """Yield what happened after an event (None: nothing of the past), then what happens."""
        store = self._service.store
        queue: asyncio.Queue[ServerSentEvent | None] = asyncio.Queue(_BACKLOG)
        async with self._door:
            newest = await asyncio.to_thread(store.events.last_id)
            missed: list[ServerSentEvent] = []
            if not self._listeners:
                self._last, self._told = newest, {}
                # What queued jobs wait for now is no news: who listens has asked for the jobs.
                await asyncio.to_thread(self._queued, ())
            if after is not None and after < self._last:
                missed = await asyncio.to_thread(self._missed, after, self._last)
            self._listeners.add(queue)
            self._somebody.set()
        try:
            yield ServerSentEvent(retry=_RETRY)
            for message in missed:
                yield message
            while (news := await queue.get()) is not None:
                yield news
        finally:
            self._listeners.discard(queue)
            if not self._listeners:
                self._somebody.clear()

    def _missed(self, after: int, last: int) -> list[ServerSentEvent]:
        events: list[Event] = []
        while after < last and (some := self._service.store.events.after(after)):
            events += [event for event in some if event.id <= last]
            after = some[-1].id
        return self._messages(events)


def _message(kind: str, data: str, number: int | None = None) -> ServerSentEvent:
    return ServerSentEvent(event=kind, raw_data=data, id=None if number is None else str(number))


@router.get("/events", response_class=EventSourceResponse)
async def get_events(
    request: Request,
    last: Annotated[str | None, Header(alias="Last-Event-ID")] = None,
    after: Annotated[int | None, Query(ge=0, le=2**53)] = None,
) -> AsyncIterator[ServerSentEvent]:
    """Stream what happens to jobs and drawings as server-sent events."""
    stream: Stream = request.app.state.stream
    # An id that is no number is not from this server: the past is not replayed.
    since = int(last) if last is not None and last.isdecimal() and len(last) < 16 else after
    async for event in stream.listen(since):
        yield event
