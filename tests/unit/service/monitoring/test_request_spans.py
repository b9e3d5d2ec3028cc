"""A request has a span that continues the trace of its client, up to the end of its compile."""

from __future__ import annotations

import json
import logging
from collections.abc import Iterator

import pytest

from knifetip import logs
from knifetip.service.settings import Settings
from tests.support.serving.server import (
    LocalClient,
    order_job,
    run_server,
    square,
    upload_drawing,
    wait_for_state,
)
from tests.support.serving.trace_receiver import TraceReceiver, export_traces
from tests.support.serving.webhook_receiver import run_receiver

pytestmark = pytest.mark.xdist_group("server")

TRACE = "4bf92f3577b34da6a3ce929d0e0e4736"
PARENT = {"traceparent": f"00-{TRACE}-00f067aa0ba902b7-01"}


@pytest.fixture(scope="module")
def traces() -> Iterator[TraceReceiver]:
    # The variable asks FastAPI for spans of its own, which contain URLs with their queries.
    with export_traces(FASTAPI_OTEL_AUTO_CONFIGURE="true") as receiver:
        yield receiver


@pytest.fixture(scope="module")
def client(
    traces: TraceReceiver, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[LocalClient]:
    folder = tmp_path_factory.mktemp("traced")
    settings = Settings(database=f"sqlite:///{folder}/shop.sqlite", name="traced")
    with run_server(settings) as client:
        yield client


def test_an_upload_continues_the_trace_of_its_client(
    client: LocalClient, traces: TraceReceiver
) -> None:
    files = {"file": ("secret-customer.dxf", square())}
    answer = client.post("/api/v1/drawings", files=files, headers=PARENT)
    request = traces.wait_for("POST /api/drawings")
    assert (request.trace_id, request.parent_id) == (TRACE, "00f067aa0ba902b7")
    assert request.kind == "server"
    assert request.attributes == {
        "http.request.method": "POST",
        "http.route": "/api/drawings",
        "http.response.status_code": 201,
        "knifetip.operation": "upload_drawing",
        "knifetip.drawing": answer.json()["id"],
    }
    task = traces.wait_for("task read")
    assert task.parent_id == request.span_id
    assert traces.children(task) == ["read", "classify", "store"]


def test_a_compile_and_its_webhook_belong_to_the_order(
    client: LocalClient, traces: TraceReceiver
) -> None:
    drawing = upload_drawing(client, square())
    with run_receiver() as hooks:
        event_types = ["job.ready"]
        client.post("/api/webhooks", json={"url": hooks.url, "event_types": event_types})
        names = {"external_id": "PO-SECRET", "customer": "SECRET Ltd", "notes": "SECRET"}
        job = order_job(client, drawing["id"], **names, metadata={"token": "SECRET"})
        wait_for_state(client, job["id"], "ready")
        (call,) = hooks.wait(lambda calls: len(calls) == 1)
    order = traces.wait_for("POST /api/jobs", lambda span: span.parent_id == "")
    compiled = traces.wait_for("compile")
    assert compiled.kind == "consumer"
    assert (compiled.trace_id, compiled.parent_id) == (order.trace_id, order.span_id)
    assert compiled.attributes.pop("knifetip.lines") > 0
    assert compiled.attributes == {
        "knifetip.job": job["id"],
        "knifetip.drawing": drawing["id"],
        "knifetip.machine": "demo-table",
        "knifetip.attempt": 1,
        "knifetip.outcome": "accepted",
    }
    assert traces.children(compiled) == [
        *("read", "clean", "plan", "compensate", "sequence", "process", "verify"),
        "save result",
    ]
    delivery = traces.wait_for("webhook")
    (saved,) = (one for one in traces.named("save result") if one.parent_id == compiled.span_id)
    assert (delivery.trace_id, delivery.parent_id) == (order.trace_id, saved.span_id)
    assert delivery.attributes["http.response.status_code"] == 204
    assert delivery.attributes["knifetip.event_type"] == "job.ready"
    assert call.headers["traceparent"][:52] == f"00-{delivery.trace_id}-{delivery.span_id}"
    assert not any(b"SECRET" in body or b"/hooks?" in body for body in traces.bodies)


def test_a_refused_compile_has_the_code_of_its_reason(
    client: LocalClient, traces: TraceReceiver
) -> None:
    drawing = upload_drawing(client, square(side=9000.0), unit="mm")
    job = order_job(client, drawing["id"])
    refused = wait_for_state(client, job["id"], "refused")
    compiled = traces.wait_for("compile", lambda one: one.attributes["knifetip.job"] == job["id"])
    assert compiled.attributes["knifetip.outcome"] == "refused"
    assert compiled.attributes["error.type"] == refused["message"]["code"]
    # A refusal is a result; only the stage that raised it has failed.
    assert not compiled.failed
    stages = [one for one in traces.spans if one.parent_id == compiled.span_id]
    assert [one.name for one in stages if one.failed] == [stages[-1].name]


def test_an_error_has_its_status_and_code(client: LocalClient, traces: TraceReceiver) -> None:
    assert client.get("/api/v1/jobs/nothing22").status_code == 404
    missing = traces.wait_for("GET /api/jobs/{id}", lambda one: "error.type" in one.attributes)
    assert missing.attributes == {
        "http.request.method": "GET",
        "http.route": "/api/jobs/{id}",
        "http.response.status_code": 404,
        "knifetip.operation": "get_job",
        "knifetip.job": "nothing22",
        "error.type": "job.unknown",
    }
    assert not missing.failed


def test_a_refused_request_has_a_span_without_its_key(
    client: LocalClient, traces: TraceReceiver
) -> None:
    key = "SECRET-key-of-nobody"
    headers = {"Authorization": f"Bearer {key}", "Cookie": f"s={key}", "User-Agent": key}
    assert client.get(f"/api/queues?key={key}", headers=headers).status_code == 401
    refused = traces.wait_for("GET", lambda one: "error.type" in one.attributes)
    assert refused.attributes["http.response.status_code"] == 401
    assert not any(b"SECRET" in body for body in traces.bodies)


def test_requests_that_repeat_all_the_time_have_no_span(
    client: LocalClient, traces: TraceReceiver
) -> None:
    before = len(traces.spans)
    assert client.get("/healthz").status_code == 200
    assert client.get("/metrics").status_code == 200
    claim = {"gateway": "g", "machine": "demo-table", "wait": 0.0}
    client.post("/api/v1/gateway/claim", json=claim, headers={"X-Knifetip": "gateway"})
    client.get("/api/machines")
    traces.wait_for("GET /api/machines")
    assert [span.name for span in traces.spans[before:]] == ["GET /api/machines"]


def test_the_record_of_a_request_has_the_ids_of_its_span(
    client: LocalClient, traces: TraceReceiver
) -> None:
    lines: list[str] = []

    class Lines(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            lines.append(self.format(record))

    handler = Lines()
    handler.setFormatter(logs.JsonFormatter())
    log = logging.getLogger("knifetip.access")
    log.addHandler(handler)
    log.setLevel(logging.INFO)
    try:
        client.get("/api/v1/boards")
        # Ends after the record is written, which is after the response is sent.
        span = traces.wait_for("GET /api/boards")
    finally:
        log.removeHandler(handler)
        log.setLevel(logging.NOTSET)
    (record,) = map(json.loads, lines)
    assert (record["trace_id"], record["span_id"]) == (span.trace_id, span.span_id)
    assert record["request_id"]
