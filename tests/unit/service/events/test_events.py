from __future__ import annotations

import json
import queue
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import httpx
import pytest

from knifetip.service.database.tables import Event, Job
from knifetip.service.lifecycle.event_store import EventStore
from knifetip.service.orders.store import JobStore
from tests.support.serving.server import (
    confirm_job,
    order_job,
    square,
    upload_drawing,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("server")


@dataclass
class Heard:
    kind: str
    number: int | None
    data: dict[str, Any]


@contextmanager
def event_queue(client: httpx.Client, last: int | None = None) -> Iterator[queue.Queue[Heard]]:
    """Connect to the stream of events and yield a queue of the received ones.

    ``last`` is the number of the last event that the client has already received.
    """
    heard: queue.Queue[Heard] = queue.Queue()
    headers = {} if last is None else {"Last-Event-ID": str(last)}
    opened, over = threading.Event(), threading.Event()

    def listen() -> None:
        with client.stream("GET", "/api/events", headers=headers) as answer:
            assert answer.headers["content-type"].startswith("text/event-stream")
            fields: dict[str, str] = {}
            for line in answer.iter_lines():
                if over.is_set():
                    return
                if line:
                    key, _, value = line.partition(": ")
                    fields[key] = value
                    continue
                if fields.get("event") == "connected":
                    opened.set()
                elif "event" in fields:
                    number = int(fields["id"]) if "id" in fields else None
                    heard.put(Heard(fields["event"], number, json.loads(fields["data"])))
                fields = {}

    thread = threading.Thread(target=listen)
    thread.start()
    assert opened.wait(60.0)
    try:
        yield heard
    finally:
        over.set()
        upload_drawing(client, square())  # any event, so that the listener notices the end
        thread.join(60.0)


def wait_for_event(heard: queue.Queue[Heard], id: str, state: str = "") -> Heard:
    while True:
        event = heard.get(timeout=20.0)
        if event.data.get("id") == id and event.data.get("state", "") == state:
            return event


def test_a_new_drawing_and_the_states_of_a_job_are_events(client: httpx.Client) -> None:
    with event_queue(client) as heard:
        drawing = upload_drawing(client, square())["id"]
        assert wait_for_event(heard, drawing).kind == "drawing"
        job = order_job(client, drawing)["id"]
        event = wait_for_event(heard, job, "ready")
        assert event.kind == "job"
        assert event.number is not None
        assert event.data == client.get(f"/api/jobs/{job}").json()


def test_a_change_of_the_library_is_an_event(client: httpx.Client) -> None:
    fields = client.get("/api/boards/e-flute/definition").json()["fields"]
    changes: tuple[tuple[str, str, object], ...] = (
        ("PUT", "boards/heard", {**fields, "title": "Heard"}),
        ("PUT", "profiles/heard", {"title": "Heard", "extends": None, "rules": []}),
        ("DELETE", "profiles/heard", None),
        ("DELETE", "boards/heard", None),
    )
    with event_queue(client) as heard:
        for method, path, body in changes:
            assert client.request(method, f"/api/{path}", json=body).is_success
            event = heard.get(timeout=20.0)
            assert (event.kind, event.number, event.data) == ("library", None, {})
        assert heard.empty()


def test_the_first_event_states_that_changes_are_sent_from_now_on(client: httpx.Client) -> None:
    with client.stream("GET", "/api/events") as answer:
        lines = answer.iter_lines()
        first = [next(lines) for _ in range(3)]
    assert sorted(first) == ["data: {}", "event: connected", "retry: 2000"]


def test_a_client_that_reconnects_receives_only_missed_events(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    with event_queue(client) as heard:
        before = order_job(client, drawing)["id"]
        last = wait_for_event(heard, before, "ready").number
    assert last is not None
    missed = order_job(client, drawing)["id"]
    wait_for_state(client, missed, "ready")
    client.post(f"/api/jobs/{missed}/release")
    with event_queue(client, last) as heard:
        event = wait_for_event(heard, missed, "queued")
        assert event.number is not None
        assert event.number > last
        assert heard.empty()
        client.post(f"/api/jobs/{missed}/cancel")
        cancelled = wait_for_event(heard, missed, "cancelled")
        assert cancelled.number is not None
        assert cancelled.number > event.number


def test_a_client_that_was_away_for_long_receives_changes_in_portions(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = upload_drawing(client, square())["id"]
    with event_queue(client) as heard:
        last = wait_for_event(heard, upload_drawing(client, square())["id"]).number
    missed = [order_job(client, first)["id"] for _ in range(3)]
    for job in missed:
        wait_for_state(client, job, "ready")
    after, search = EventStore.after, JobStore.search
    searched: list[int] = []

    def two_events(store: EventStore, last: int, limit: int = 2, **late: Any) -> list[Event]:
        return after(store, last, limit, **late)

    def count_ids(store: JobStore, *conditions: Any, **more: Any) -> list[Job]:
        searched.append(len(more.get("ids") or ()))
        return search(store, *conditions, **more)

    monkeypatch.setattr(EventStore, "after", two_events)
    monkeypatch.setattr(JobStore, "search", count_ids)
    with event_queue(client, last) as heard:
        numbers = [wait_for_event(heard, job, "ready").number for job in missed]
        assert None not in numbers
        after_all = upload_drawing(client, square())["id"]
        assert wait_for_event(heard, after_all).kind == "drawing"
    assert max(searched) <= 2


def test_events_of_progress_have_no_number(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    job = wait_for_state(client, order_job(client, drawing, release=True)["id"], "queued")["id"]
    with event_queue(client) as heard:
        claim = {"gateway": "g", "machine": "demo-table", "wait": 0.0}
        epoch = client.post("/api/gateway/claim", json=claim).json()["epoch"]
        while wait_for_event(heard, job, "queued").data["waiting_for"] != "confirmation":
            pass
        confirm_job(client, job)
        waits = {"job": job, "epoch": epoch, "line": 0, "waiting": True}
        client.post("/api/gateway/heartbeat", json=waits)
        wait_for_event(heard, job, "running")
        beat = {"job": job, "epoch": epoch, "line": 7, "position": [1.0, 2.0, 3.0, 4.0]}
        client.post("/api/gateway/heartbeat", json=beat)
        while (event := wait_for_event(heard, job, "running")).data["line"] != 7:
            pass
        assert event.number is None
        assert event.data["position"] == [1.0, 2.0, 3.0, 4.0]
        finish = {"job": job, "epoch": epoch, "outcome": "done"}
        client.post("/api/gateway/finish", json=finish)
        assert wait_for_event(heard, job, "done").number is not None


def test_an_unknown_event_number_replays_nothing(client: httpx.Client) -> None:
    upload_drawing(client, square())
    with event_queue(client, 10**12) as heard:
        drawing = upload_drawing(client, square())["id"]
        assert heard.get(timeout=10.0).data["id"] == drawing


def test_a_deleted_drawing_is_an_event(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    with event_queue(client) as heard:
        client.delete(f"/api/drawings/{drawing}")
        event = heard.get(timeout=10.0)
        assert (event.kind, event.data) == ("deleted", {"drawing": drawing})


def test_a_changed_reason_for_waiting_is_an_event(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    first, second = (
        wait_for_state(client, order_job(client, drawing, release=True)["id"], "queued")["id"]
        for _ in range(2)
    )
    with event_queue(client) as heard:
        assert client.get(f"/api/jobs/{second}").json()["waiting_for"] == "turn"
        client.post(f"/api/jobs/{first}/cancel")
        event = wait_for_event(heard, second, "queued")
        # Its own state did not change: another job ended.
        assert (event.number, event.data["waiting_for"]) == (None, "machine")
        client.post(f"/api/jobs/{second}/cancel")
