"""Jobs and deliveries of webhooks keep the context of the trace of their order."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from knifetip import tracing
from knifetip.service.store import Store
from knifetip.service.webhooks.queue import DeliveryAttempt
from tests.support.job_states import ordered, running
from tests.support.serving.trace_receiver import TraceReceiver, export_traces
from tests.support.stored import Clock


@pytest.fixture
def traces() -> Iterator[TraceReceiver]:
    with export_traces() as receiver:
        yield receiver


def contexts(store: Store) -> dict[str, str]:
    """Deliver what is pending; return the contexts by the type of their event."""
    found = {}
    while (claimed := store.webhook_queue.claim()) is not None:
        found[claimed.event_type] = claimed.traceparent
        store.webhook_queue.store(claimed, DeliveryAttempt(store.database.clock(), 204, 0.1))
    return found


def test_the_events_of_an_order_belong_to_its_request(store: Store, traces: TraceReceiver) -> None:
    types = ("job.received", "job.cancelled")
    store.webhooks.add("http://erp.example/hooks", "", types, "test")
    with tracing.span("order"):
        context = tracing.traceparent()
        job = ordered(store)
    assert store.jobs.get(job.id).traceparent == context
    # Outside of any span.
    store.operators.cancel(job.id)
    assert contexts(store) == {"job.received": context, "job.cancelled": context}
    assert traces.wait_for("order").span_id in context


def test_an_expired_lease_is_a_span_of_the_order(
    store: Store, clock: Clock, traces: TraceReceiver
) -> None:
    with tracing.span("order"):
        job = running(store)
    store.webhooks.add("http://erp.example/hooks", "", (), "test")
    clock.now += 60.0
    assert store.leases.run()
    order, expired = traces.wait_for("order"), traces.wait_for("lease expired")
    assert (expired.trace_id, expired.parent_id) == (order.trace_id, order.span_id)
    assert expired.attributes == {"knifetip.job": job.id, "knifetip.machine": "table"}
    ((event_type, context),) = contexts(store).items()
    assert event_type == "job.interrupted"
    assert expired.span_id in context


def test_without_traces_no_context_is_stored(store: Store) -> None:
    store.webhooks.add("http://erp.example/hooks", "", ("job.received",), "test")
    with tracing.span("order"):
        job = ordered(store)
    assert store.jobs.get(job.id).traceparent == ""
    assert contexts(store) == {"job.received": ""}
