"""Spans are exported if the environment asks for it, with nothing that they must not contain."""

from __future__ import annotations

import io
import json
import logging
import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator

import pytest

from knifetip import logs, tracing
from knifetip.errors import StoreError
from knifetip.logs import LogFormat, LogLevel
from knifetip.tracing import SpanKind
from tests.support.serving.trace_receiver import (
    TraceReceiver,
    run_silent_receiver,
    run_trace_receiver,
)

#: The example of W3C Trace Context.
PARENT = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01"
SAMPLED = 1  #: bit of its flags


@pytest.fixture
def receiver(monkeypatch: pytest.MonkeyPatch) -> Iterator[TraceReceiver]:
    """A receiver to which the environment asks to export."""
    with run_trace_receiver() as running:
        for name, value in running.environment.items():
            monkeypatch.setenv(name, value)
        yield running


def test_spans_are_exported_as_a_tree(receiver: TraceReceiver) -> None:
    with tracing.exporting("knifetip-test"):
        assert tracing.is_on()
        with tracing.span("request", SpanKind.SERVER, method="POST", route="/api/jobs", status=201):
            with tracing.span("inner", job="j1") as inner:
                inner.event("lines executed", line=7)
                inner.set(outcome="done", lines=70)
            with tracing.span("other", SpanKind.CONSUMER, PARENT):
                pass
    assert not tracing.is_on()
    request, inside, other = map(receiver.wait_for, ("request", "inner", "other"))
    assert request.kind == "server"
    assert request.parent_id == ""
    assert request.attributes == {
        "http.request.method": "POST",
        "http.route": "/api/jobs",
        "http.response.status_code": 201,
    }
    assert (inside.trace_id, inside.parent_id) == (request.trace_id, request.span_id)
    assert inside.attributes == {
        "knifetip.job": "j1",
        "knifetip.outcome": "done",
        "knifetip.lines": 70,
    }
    assert inside.events == [("lines executed", {"knifetip.line": 7})]
    assert other.kind == "consumer"
    assert f"00-{other.trace_id}-{other.parent_id}-01" == PARENT
    assert request.service["service.name"] == "knifetip-test"
    assert request.service["service.version"]
    assert not any(span.failed for span in receiver.spans)


def test_the_standard_variables_name_the_service_and_sample(
    receiver: TraceReceiver, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OTEL_SERVICE_NAME", "shop 3")
    monkeypatch.setenv("OTEL_RESOURCE_ATTRIBUTES", "deployment.environment.name=hall-2")
    monkeypatch.setenv("OTEL_TRACES_SAMPLER", "parentbased_always_off")
    with tracing.exporting("knifetip-test"):
        with tracing.span("not sampled"):
            # The decision is passed on: no other process exports a part of the trace.
            assert not int(tracing.traceparent()[-2:], 16) & SAMPLED
        with tracing.span("sampled by the client", parent=PARENT):
            assert int(tracing.traceparent()[-2:], 16) & SAMPLED
    service = receiver.wait_for("sampled by the client").service
    assert service["service.name"] == "shop 3"
    assert service["deployment.environment.name"] == "hall-2"
    assert [span.name for span in receiver.spans] == ["sampled by the client"]


@pytest.mark.parametrize("parent", ["", "x", PARENT[:-1], PARENT.replace("4bf", "xyz"), "é" * 55])
def test_a_malformed_context_begins_a_trace(receiver: TraceReceiver, parent: str) -> None:
    with (
        tracing.exporting("knifetip-test"),
        tracing.span("outer"),
        tracing.span("s", parent=parent),
    ):
        assert re.fullmatch(r"00-[0-9a-f]{32}-[0-9a-f]{16}-0[13]", tracing.traceparent())
        assert tracing.headers() == {"traceparent": tracing.traceparent()}
    assert receiver.wait_for("s").parent_id == ""


def test_a_failed_span_has_a_code_but_no_text(receiver: TraceReceiver) -> None:
    with tracing.exporting("knifetip-test"):
        with pytest.raises(StoreError), tracing.span("known"):
            raise StoreError("server.address-in-use", host="SECRET", port=1, reason="SECRET")
        with pytest.raises(ZeroDivisionError), tracing.span("unknown"):
            raise ZeroDivisionError("SECRET")
    known, unknown = receiver.wait_for("known"), receiver.wait_for("unknown")
    assert known.failed
    assert unknown.failed
    assert known.attributes == {"error.type": "server.address-in-use"}
    assert unknown.attributes == {"error.type": "ZeroDivisionError"}
    assert (known.message, unknown.message) == ("", "")
    assert not any(b"SECRET" in body for body in receiver.bodies)


def test_the_command_line_is_not_exported(
    receiver: TraceReceiver, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OTEL_EXPERIMENTAL_RESOURCE_DETECTORS", "process,otel")
    monkeypatch.setattr(sys, "argv", ["knifetip", "serve", "--key", "SECRET"])
    with tracing.exporting("knifetip-test"), tracing.span("s"):
        pass
    assert receiver.wait_for("s").service["process.pid"]
    assert not any(b"SECRET" in body for body in receiver.bodies)


def test_records_of_the_log_have_the_ids_of_the_span(receiver: TraceReceiver) -> None:
    root = logging.getLogger()
    handlers, level = root.handlers[:], root.level
    written = io.StringIO()
    logs.configure(LogFormat.JSON, LogLevel.INFO, written)
    try:
        log = logging.getLogger("knifetip.test")
        with tracing.exporting("knifetip-test"):
            with tracing.span("outer"), tracing.span("inner"):
                log.info("inside")
            log.info("outside")
    finally:
        logging.captureWarnings(False)
        root.handlers[:] = handlers
        root.setLevel(level)
    inside, outside = map(json.loads, written.getvalue().splitlines())
    inner = receiver.wait_for("inner")
    assert (inside["trace_id"], inside["span_id"]) == (inner.trace_id, inner.span_id)
    assert not {"trace_id", "span_id"} & outside.keys()


@pytest.mark.parametrize(
    "changes",
    [
        {"OTEL_EXPORTER_OTLP_ENDPOINT": None},
        {"OTEL_EXPORTER_OTLP_ENDPOINT": " "},
        {"OTEL_TRACES_EXPORTER": "none"},
        {"OTEL_SDK_DISABLED": "True"},
    ],
)
def test_nothing_is_exported_without_being_asked_for(
    receiver: TraceReceiver,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    changes: dict[str, str | None],
) -> None:
    for name, value in changes.items():
        if value is None:
            monkeypatch.delenv(name)
        else:
            monkeypatch.setenv(name, value)
    with tracing.exporting("knifetip-test"), tracing.span("s", job="j1") as span:
        assert not tracing.is_on()
        span.event("e", line=1)
        span.rename("r")
        span.fail("code")
        assert (tracing.traceparent(), tracing.headers()) == ("", {})
    assert receiver.bodies == []
    assert caplog.records == []


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("OTEL_TRACES_EXPORTER", "zipkin"),
        ("OTEL_EXPORTER_OTLP_PROTOCOL", "grpc"),
        ("OTEL_EXPORTER_OTLP_TRACES_PROTOCOL", "http/json"),
        ("OTEL_BSP_MAX_QUEUE_SIZE", "-1"),
        ("OTEL_SPAN_EVENT_COUNT_LIMIT", "many"),
    ],
)
def test_a_wrong_variable_is_one_warning(
    receiver: TraceReceiver,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    name: str,
    value: str,
) -> None:
    monkeypatch.setenv(name, value)
    with tracing.exporting("knifetip-test"), tracing.span("s"):
        assert not tracing.is_on()
    (record,) = caplog.records
    assert record.levelno == logging.WARNING
    assert "no traces" in record.getMessage()
    assert receiver.bodies == []


def test_a_missing_extra_is_one_warning_with_what_to_install(
    receiver: TraceReceiver, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.delitem(sys.modules, "knifetip.telemetry", raising=False)
    monkeypatch.delattr("knifetip.telemetry", raising=False)
    # FastAPI needs the API of OpenTelemetry, so only its SDK and the exporter are absent.
    monkeypatch.setitem(sys.modules, "opentelemetry.sdk.trace", None)
    with tracing.exporting("knifetip-test"), tracing.span("s"):
        assert not tracing.is_on()
    (record,) = caplog.records
    assert record.levelno == logging.WARNING
    assert "OTEL_EXPORTER_OTLP_ENDPOINT is set" in record.getMessage()
    assert "pip install 'knifetip[telemetry]'" in record.getMessage()
    assert receiver.bodies == []


def test_services_without_traces_do_not_import_opentelemetry() -> None:
    code = (
        "import re, sys\n"
        "from knifetip import tracing\n"
        "def found(pattern): return [name for name in sys.modules if re.match(pattern, name)]\n"
        "import knifetip.cli.service, knifetip.gateway.claim, knifetip.service.compiling.service\n"
        "with tracing.exporting('knifetip-test'), tracing.span('s'):\n"
        "    print(found('opentelemetry|knifetip.telemetry'))\n"
        # FastAPI imports the API of OpenTelemetry.
        "    import knifetip.server.embedded\n"
        "    print(found('opentelemetry.(sdk|exporter|proto)'))\n"
    )
    environment = {name: text for name, text in os.environ.items() if name[:5] != "OTEL_"}
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines() == ["[]", "[]"]


def test_a_receiver_that_does_not_answer_is_not_waited_for(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr("knifetip.telemetry.PATIENCE", 0.2)
    with run_silent_receiver() as silent:
        for name, value in silent.environment.items():
            monkeypatch.setenv(name, value)
        begun = time.monotonic()
        with tracing.exporting("knifetip-test"):
            with tracing.span("first"):
                pass
            assert silent.asked.wait(30.0)  # the export has begun, and does not end
            for _ in range(3000):  # more than the queue keeps
                with tracing.span("s", job="j1"):
                    pass
        # An export lasts 600 s, which is also what the end would wait for.
        assert time.monotonic() - begun < 60.0
    messages = [record.getMessage() for record in caplog.records]
    assert sum("dropping" in message for message in messages) == 1
    assert any("the receiver does not answer" in message for message in messages)
