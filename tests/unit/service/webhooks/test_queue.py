"""Outbox and queue of webhooks, on SQLite and PostgreSQL."""

from __future__ import annotations

import json
import threading
from collections import Counter
from typing import Any

import pytest
import sqlalchemy as sa

from knifetip.contract.job import OPERATOR
from knifetip.errors import NotFound, WrongState
from knifetip.messages import Message
from knifetip.service.database.tables import Event, Job
from knifetip.service.store import Store
from knifetip.service.webhooks.outbox import EVENT_TYPES
from knifetip.service.webhooks.queue import (
    DELAYS,
    IN_ORDER,
    LEASE,
    PAUSE_AFTER,
    PER_ENDPOINT,
    ClaimedDelivery,
    DeliveryAttempt,
)
from knifetip.service.webhooks.tables import Webhook, WebhookDelivery
from tests.support.stored import Clock, add_drawing, add_job

URL = "http://erp.example/hooks"


def add_webhook(store: Store, *types: str) -> str:
    return store.webhooks.add(URL, "", types, "test").id


def attempt(store: Store, status: int = 204) -> ClaimedDelivery:
    """Claim what is due, store an answer, and return what was claimed."""
    claimed = store.webhook_queue.claim()
    assert claimed is not None
    store.webhook_queue.store(claimed, DeliveryAttempt(store.database.clock(), status, 0.1))
    return claimed


def drain(store: Store) -> list[str]:
    """Deliver all that is due; return the types of the events in the order of delivery."""
    found = []
    while (claimed := store.webhook_queue.claim()) is not None:
        store.webhook_queue.store(claimed, DeliveryAttempt(store.database.clock(), 200, 0.1))
        found.append(json.loads(claimed.payload)["type"])
    return found


def deliveries(store: Store) -> list[WebhookDelivery]:
    with store.database.reading() as session:
        query = sa.select(WebhookDelivery).order_by(WebhookDelivery.serial)
        return list(session.scalars(query))


def test_without_endpoints_nothing_is_written(store: Store) -> None:
    add_job(store)
    assert deliveries(store) == []
    assert store.webhook_queue.claim() is None
    assert not store.webhook_queue.has_pending()


def test_an_event_is_sent_to_the_endpoints_that_subscribe_to_it(store: Store) -> None:
    everything = store.webhooks.get(add_webhook(store)).serial
    queued = store.webhooks.get(add_webhook(store, "job.cancelled", "drawing.read")).serial
    job = add_job(store)
    store.operators.cancel(job.id)
    found = [(row.webhook, row.event_type, row.subject) for row in deliveries(store)]
    assert found == [
        (everything, "drawing.read", job.drawing),
        (queued, "drawing.read", job.drawing),
        (everything, "job.received", job.id),
        (everything, "job.cancelled", job.id),
        (queued, "job.cancelled", job.id),
    ]


def test_the_payload_has_the_job_as_it_is_after_the_event(store: Store, clock: Clock) -> None:
    add_webhook(store, "job.cancelled")
    job = add_job(store, copies=3)
    clock.now = 1234.5
    store.operators.cancel(job.id)
    with store.database.reading() as session:
        event = session.scalars(sa.select(Event).order_by(Event.id.desc())).first()
    assert event is not None
    (row,) = deliveries(store)
    payload = json.loads(row.payload)
    assert payload["type"] == "job.cancelled"
    assert payload["id"] == event.id
    assert payload["timestamp"] == "1970-01-01T00:20:34.500Z"
    found = payload["data"]["job"]
    assert (found["id"], found["state"], found["copies"]) == (job.id, "cancelled", 3)
    assert found["updated"] == "1970-01-01T00:20:34.500Z"
    details = ("external_id", "customer", "due", "notes", "metadata")
    assert [found[name] for name in details] == ["", "", None, "", {}]


def test_an_event_that_leaves_the_state_is_an_update(store: Store) -> None:
    add_webhook(store)
    job = add_job(store)
    row = store.compiles.begin("worker")
    assert row is not None
    store.compiles.report_waiting(job.machine, 0.5)
    types = [row.event_type for row in deliveries(store) if row.subject == job.id]
    assert types[:2] == ["job.received", "job.compiling"]
    assert set(types[2:]) <= {"job.updated"}
    assert set(types) <= set(EVENT_TYPES)


def test_a_transaction_that_fails_sends_nothing(store: Store) -> None:
    add_webhook(store)
    job = add_job(store)
    before = len(deliveries(store))

    def fail() -> None:
        with store.database.writing() as session:
            store.operators._transitions.write_job_event(
                session, job.id, "done", OPERATOR, Message("job.ordered"), new_state=True
            )
            session.flush()
            raise RuntimeError("the power fails")

    with pytest.raises(RuntimeError):
        fail()
    assert len(deliveries(store)) == before


def test_a_failed_delivery_is_sent_again_and_becomes_a_dead_letter(
    store: Store, clock: Clock
) -> None:
    webhook = add_webhook(store, "job.received")
    add_job(store)
    first = attempt(store, 500)
    start, ids = clock.now, [first.id]
    for delay in DELAYS:
        assert store.webhook_queue.claim() is None
        clock.now += 0.79 * delay
        assert store.webhook_queue.claim() is None
        clock.now += 0.42 * delay
        ids.append(attempt(store, 500).id)
    # About three days, always with the same id.
    assert 3.0 * 86_400 < clock.now - start < 4.0 * 86_400
    assert set(ids) == {first.id}
    (row,) = deliveries(store)
    assert row.state == "dead"
    assert [one["status"] for one in row.attempts] == [500] * (len(DELAYS) + 1)
    clock.now += 1e6
    assert store.webhook_queue.claim() is None
    (replayed,) = store.webhooks.replay(webhook)
    assert replayed.state == "pending"
    assert attempt(store).id == first.id
    assert deliveries(store)[0].state == "delivered"


def test_a_delivery_of_a_killed_sender_is_sent_again_with_the_same_id(
    store: Store, clock: Clock
) -> None:
    add_webhook(store, "job.received")
    add_job(store)
    lost = store.webhook_queue.claim()
    assert lost is not None
    clock.now += 0.9 * LEASE
    assert store.webhook_queue.claim() is None
    clock.now += 0.2 * LEASE
    again = store.webhook_queue.claim()
    assert again is not None
    assert (again.id, again.payload) == (lost.id, lost.payload)


def test_a_clock_that_is_set_back_does_not_keep_a_lease(store: Store, clock: Clock) -> None:
    add_webhook(store, "job.received")
    clock.now = 10_000.0
    add_job(store)
    with store.database.writing() as session:
        session.execute(sa.update(WebhookDelivery).values(lease=clock.now + 3600.0))
    assert store.webhook_queue.claim() is not None


def test_events_of_a_job_stay_in_order(store: Store, clock: Clock) -> None:
    add_webhook(store, "job.received", "job.cancelled")
    first, second = add_job(store), add_job(store)
    for job in (first, second):
        store.operators.cancel(job.id)
    taken = store.webhook_queue.claim()
    assert taken is not None
    other = store.webhook_queue.claim()
    assert other is not None
    # While two are being sent, the later ones of the same jobs wait.
    assert [json.loads(one.payload)["data"]["job"]["id"] for one in (taken, other)] == [
        first.id,
        second.id,
    ]
    assert store.webhook_queue.claim() is None
    store.webhook_queue.store(taken, DeliveryAttempt(clock.now, 500, 0.1))
    store.webhook_queue.store(other, DeliveryAttempt(clock.now, 200, 0.1))
    # Only the job whose event failed waits.
    assert drain(store) == ["job.cancelled"]
    clock.now += 1.21 * DELAYS[0]
    assert drain(store) == ["job.received", "job.cancelled"]


def test_a_delivery_that_is_never_accepted_does_not_block_the_job(
    store: Store, clock: Clock
) -> None:
    webhook = add_webhook(store, "job.received", "job.cancelled")
    job = add_job(store)
    store.operators.cancel(job.id)
    for number in range(IN_ORDER):
        assert attempt(store, 500).payload.startswith('{"type":"job.received"')
        clock.now += 1.21 * DELAYS[number]
    clock.now -= 1.21 * DELAYS[IN_ORDER - 1] - 1.0
    store.webhooks.change(webhook, description="without a pause")
    assert drain(store)[0] == "job.cancelled"


def test_an_endpoint_that_works_again_gets_everything_at_once(store: Store, clock: Clock) -> None:
    webhook = add_webhook(store, "job.received")
    for _ in range(20):
        add_job(store)
    for _ in range(PAUSE_AFTER):
        assert store.webhooks.pause_end(store.webhooks.get(webhook)) is None
        attempt(store, 503)
    for number in range(5):
        # One attempt, then a pause: an endpoint that is down is not hammered.
        assert store.webhook_queue.claim() is None
        end = store.webhooks.pause_end(store.webhooks.get(webhook))
        assert end is not None
        pause = DELAYS[number]
        assert clock.now + 0.8 * pause <= end <= clock.now + 1.2 * pause
        clock.now += 1.21 * pause
        claimed = store.webhook_queue.claim()
        assert claimed is not None
        assert store.webhook_queue.claim({claimed.webhook: 1}) is None
        store.webhook_queue.store(claimed, DeliveryAttempt(clock.now, 503, 0.1))
    clock.now += 1.21 * DELAYS[5]
    assert len(drain(store)) == 20


def test_a_pause_is_never_longer_than_ten_minutes(store: Store, clock: Clock) -> None:
    webhook = add_webhook(store, "job.received")
    for _ in range(3):
        add_job(store)
    with store.database.writing() as session:
        session.execute(sa.update(Webhook).values(failures=300))
    attempt(store, 503)
    assert store.webhooks.pause_end(store.webhooks.get(webhook)) == clock.now + 600.0


def test_a_failure_delays_only_the_events_of_its_job(store: Store, clock: Clock) -> None:
    add_webhook(store, "job.received", "job.cancelled")
    jobs = [add_job(store).id for _ in range(5)]
    for job in jobs:
        store.operators.cancel(job)
    # The events of the first job are refused, each time between two that are accepted.
    arrived: list[tuple[str, str]] = []
    for _ in range(10):
        claimed = store.webhook_queue.claim()
        if claimed is None:
            clock.now += 1.21 * DELAYS[0]
            continue
        payload = json.loads(claimed.payload)
        job = payload["data"]["job"]["id"]
        status = 500 if job == jobs[0] else 204
        store.webhook_queue.store(claimed, DeliveryAttempt(clock.now, status, 0.1))
        if status == 204:
            arrived.append((job, payload["type"]))
    assert sorted(arrived) == sorted(
        (job, word) for job in jobs[1:] for word in ("job.received", "job.cancelled")
    )
    states = {(row.subject == jobs[0], row.state) for row in deliveries(store)}
    assert states == {(True, "pending"), (False, "delivered")}


def test_two_endpoints_of_one_url_do_not_share_failures(store: Store, clock: Clock) -> None:
    first, second = (store.webhooks.get(add_webhook(store, "job.received")) for _ in range(2))
    for _ in range(PAUSE_AFTER):
        add_job(store)
    while (claimed := store.webhook_queue.claim()) is not None:
        status = 500 if claimed.webhook == first.serial else 200
        store.webhook_queue.store(claimed, DeliveryAttempt(clock.now, status, 0.1))
    found = [store.webhooks.get(one.id) for one in (first, second)]
    assert [one.failures for one in found] == [PAUSE_AFTER, 0]
    assert [store.webhooks.pause_end(one) is None for one in found] == [False, True]


def test_an_endpoint_that_is_slow_does_not_occupy_all_senders(store: Store) -> None:
    slow, other = (store.webhooks.get(add_webhook(store, "job.received")) for _ in range(2))
    for _ in range(9):
        add_job(store)
    sending: Counter[int] = Counter()
    order = []
    while (claimed := store.webhook_queue.claim(sending)) is not None:
        sending[claimed.webhook] += 1
        order.append(claimed.webhook)
    assert order == [slow.serial, other.serial] * PER_ENDPOINT
    # What becomes free is given to the endpoint with the fewest deliveries in flight.
    sending[other.serial] -= 1
    claimed = store.webhook_queue.claim(sending)
    assert claimed is not None
    assert claimed.webhook == other.serial


def test_an_endpoint_gets_fewer_deliveries_at_once_after_failures(store: Store) -> None:
    webhook = store.webhooks.get(add_webhook(store, "job.received")).serial
    for _ in range(9):
        add_job(store)
    permitted = []
    for _ in range(PAUSE_AFTER - 1):
        permitted.append(
            [store.webhook_queue.claim({webhook: n}, lease=0.0) is not None for n in range(5)]
        )
        attempt(store, 500)
    assert [counts.count(True) for counts in permitted] == [4, 3, 2, 1]


def test_gone_switches_the_endpoint_off(store: Store, clock: Clock) -> None:
    webhook = add_webhook(store, "job.received")
    add_job(store), add_job(store)
    attempt(store, 410)
    assert not store.webhooks.get(webhook).active
    assert {row.state for row in deliveries(store)} == {"dead"}
    add_job(store)
    assert len(deliveries(store)) == 2
    clock.now += 1e5
    assert store.webhook_queue.claim() is None
    with pytest.raises(WrongState):
        store.webhooks.replay(webhook)
    store.webhooks.change(webhook, active=True)
    assert len(store.webhooks.replay(webhook)) == 2
    assert len(drain(store)) == 2


def test_a_secret_is_replaced_with_an_overlap(store: Store, clock: Clock) -> None:
    webhook = add_webhook(store, "job.received")
    old = store.webhooks.get(webhook).secret
    new = store.webhooks.rotate_secret(webhook, 100.0).secret
    add_job(store), add_job(store)
    assert attempt(store).secrets == (new, old)
    clock.now += 100.0
    assert attempt(store).secrets == (new,)


def test_deleting_an_endpoint_during_an_attempt_is_harmless(store: Store, clock: Clock) -> None:
    webhook = add_webhook(store)
    add_drawing(store)
    claimed = store.webhook_queue.claim()
    assert claimed is not None
    store.webhooks.delete(webhook)
    store.webhook_queue.store(claimed, DeliveryAttempt(clock.now, 200, 0.1))
    assert deliveries(store) == []
    with pytest.raises(NotFound):
        store.webhooks.get(webhook)


def test_old_deliveries_are_deleted_but_not_pending_ones(store: Store, clock: Clock) -> None:
    add_webhook(store, "job.received")
    add_job(store), add_job(store)
    attempt(store)
    clock.now += 31 * 86_400
    add_job(store)
    assert store.webhook_queue.delete_old() == 1
    assert [row.state for row in deliveries(store)] == ["pending", "pending"]


def test_deliveries_to_a_silent_endpoint_do_not_keep_those_of_the_others(
    store: Store, clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("knifetip.service.webhooks.queue._BATCH", 2)
    add_webhook(store, "drawing.read")
    for _ in range(5):
        add_drawing(store)
    with store.database.writing() as session:
        session.execute(sa.update(Webhook).values(resume_at=clock.now + 1e9))
    add_webhook(store, "job.received")
    add_job(store)
    assert drain(store) == ["job.received"]
    clock.now += 31 * 86_400
    assert store.webhook_queue.delete_old() == 1
    assert {row.state for row in deliveries(store)} == {"pending"}


def test_many_senders_deliver_each_event_once_and_in_order(store: Store) -> None:
    add_webhook(store, "job.received", "job.cancelled")
    for _ in range(20):
        store.operators.cancel(add_job(store).id)
    sent: list[str] = []
    order: dict[str, list[str]] = {}

    def send() -> None:
        while store.webhook_queue.has_pending():
            claimed = store.webhook_queue.claim()
            if claimed is None:
                continue
            payload = json.loads(claimed.payload)
            sent.append(claimed.id)
            order.setdefault(payload["data"]["job"]["id"], []).append(payload["type"])
            store.webhook_queue.store(claimed, DeliveryAttempt(store.database.clock(), 200, 0.1))

    threads = [threading.Thread(target=send) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert set(Counter(sent).values()) == {1}
    assert len(sent) == 40
    assert set(map(tuple, order.values())) == {("job.received", "job.cancelled")}


def test_the_history_is_not_read_for_the_next_delivery(store: Store) -> None:
    """A claim uses the indexes of pending deliveries only."""
    add_webhook(store, "job.received")
    add_job(store)
    plans: list[str] = []
    engine = store.database._engine
    word = "EXPLAIN QUERY PLAN " if engine.dialect.name == "sqlite" else "EXPLAIN "

    def explain(
        connection: Any, _cursor: Any, statement: str, parameters: Any, *_rest: Any
    ) -> None:
        if statement.startswith("SELECT") and "webhook_delivery" in statement:
            cursor = connection.connection.cursor()
            if engine.dialect.name != "sqlite":
                cursor.execute("SET LOCAL enable_seqscan = off")
            cursor.execute(word + statement, parameters)
            plans.append("\n".join(str(row) for row in cursor.fetchall()))

    sa.event.listen(engine, "before_cursor_execute", explain)
    try:
        assert store.webhook_queue.has_pending()
        assert store.webhook_queue.claim() is not None
    finally:
        sa.event.remove(engine, "before_cursor_execute", explain)
    assert len(plans) >= 3
    for plan in plans:
        assert "delivery_due" in plan or "delivery_of_subject" in plan
        assert "SCAN webhook_delivery" not in plan or "INDEX delivery_due" in plan
        assert "delivery_by_webhook" not in plan


def test_a_deleted_job_is_named(store: Store) -> None:
    add_webhook(store, "drawing.deleted")
    drawing = add_drawing(store)
    store.drawings.delete(drawing.id)
    (row,) = deliveries(store)
    assert json.loads(row.payload)["data"]["drawing"] == {"id": drawing.id}
    with store.database.reading() as session:
        assert session.scalar(sa.select(Job.id)) is None


def test_the_delivery_that_is_due_first_is_sent_first(store: Store, clock: Clock) -> None:
    """A busy endpoint does not delay those that were added after it."""
    busy = store.webhooks.get(add_webhook(store, "job.cancelled")).serial
    other = store.webhooks.get(add_webhook(store, "job.received")).serial
    job = add_job(store)
    clock.now += 1.0
    store.operators.cancel(job.id)
    assert [attempt(store).webhook for _ in range(2)] == [other, busy]


def test_the_endpoint_is_locked_before_its_deliveries(store: Store) -> None:
    """Otherwise the result of an attempt and a change of the endpoint could wait for each other."""
    webhook = add_webhook(store, "job.received")
    add_job(store)
    claimed = store.webhook_queue.claim()
    assert claimed is not None
    touched: list[str] = []

    def note(_connection: Any, _cursor: Any, statement: str, *_rest: Any) -> None:
        words = statement.split()
        table = words[words.index("FROM") + 1] if words[0] == "SELECT" else words[1]
        if "FOR UPDATE" in statement or words[0] == "UPDATE":
            touched.append(table)

    engine = store.database._engine
    sa.event.listen(engine, "before_cursor_execute", note)
    try:
        store.webhook_queue.store(claimed, DeliveryAttempt(store.database.clock(), 410, 0.1))
        store.webhooks.change(webhook, active=True)
        first, touched = touched, []
        store.webhooks.replay(webhook)
    finally:
        sa.event.remove(engine, "before_cursor_execute", note)
    locked = {"webhook", "webhook_delivery"}
    for tables in (first, touched):
        if store.database.url.startswith("postgresql"):
            assert tables[0] == "webhook"
        assert locked >= set(tables)
