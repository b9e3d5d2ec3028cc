"""A receiver of OpenTelemetry traces over HTTP, and one that never answers."""

from __future__ import annotations

import socket
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

import pytest
from opentelemetry.proto.collector.trace.v1.trace_service_pb2 import (
    ExportTraceServiceRequest,
    ExportTraceServiceResponse,
)
from opentelemetry.proto.trace.v1.trace_pb2 import Span, Status

from knifetip import tracing


@dataclass(frozen=True)
class ReceivedSpan:
    """A span as it was received."""

    service: dict[str, Any]  #: attributes of the resource
    name: str
    kind: str
    trace_id: str
    span_id: str
    parent_id: str  #: "" for the first span of a trace
    failed: bool
    message: str  #: description of the failure
    attributes: dict[str, Any]
    events: list[tuple[str, dict[str, Any]]]


@dataclass
class TraceReceiver:
    """What a receiver has received."""

    endpoint: str = ""
    bodies: list[bytes] = field(default_factory=list)
    spans: list[ReceivedSpan] = field(default_factory=list)

    @property
    def environment(self) -> dict[str, str]:
        """Variables with which a process exports its spans to this receiver soon."""
        return {"OTEL_EXPORTER_OTLP_ENDPOINT": self.endpoint, "OTEL_BSP_SCHEDULE_DELAY": "50"}

    def named(self, name: str) -> list[ReceivedSpan]:
        return [span for span in list(self.spans) if span.name == name]

    def wait_for(
        self, name: str, condition: Callable[[ReceivedSpan], bool] = lambda _span: True
    ) -> ReceivedSpan:
        """Wait until a span of a name meets a condition, and return it."""
        end = time.monotonic() + 120.0
        while time.monotonic() < end:
            for span in self.named(name):
                if condition(span):
                    return span
            time.sleep(0.02)
        raise AssertionError(f"no span {name!r} of {sorted({span.name for span in self.spans})}")

    def children(self, parent: ReceivedSpan) -> list[str]:
        """Return the names of the spans that belong to one, in the order of their end."""
        return [one.name for one in list(self.spans) if one.parent_id == parent.span_id]

    def receive(self, body: bytes) -> None:
        request = ExportTraceServiceRequest()
        request.ParseFromString(body)
        self.bodies.append(body)
        for resource in request.resource_spans:
            service = _values(resource.resource.attributes)
            for scope in resource.scope_spans:
                self.spans.extend(_received(service, span) for span in scope.spans)


def _values(attributes: Iterable[Any]) -> dict[str, Any]:
    found = ((one.key, one.value) for one in attributes)
    return {key: getattr(value, value.WhichOneof("value")) for key, value in found}


def _received(service: dict[str, Any], span: Span) -> ReceivedSpan:
    return ReceivedSpan(
        service,
        span.name,
        Span.SpanKind.Name(span.kind).removeprefix("SPAN_KIND_").lower(),
        span.trace_id.hex(),
        span.span_id.hex(),
        span.parent_span_id.hex(),
        span.status.code == Status.STATUS_CODE_ERROR,
        span.status.message,
        _values(span.attributes),
        [(event.name, _values(event.attributes)) for event in span.events],
    )


@contextmanager
def run_trace_receiver() -> Iterator[TraceReceiver]:
    """Run a receiver on loopback."""
    receiver = TraceReceiver()

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:  # name of http.server
            assert self.path == "/v1/traces"
            receiver.receive(self.rfile.read(int(self.headers["Content-Length"])))
            answer = ExportTraceServiceResponse().SerializeToString()
            self.send_response(200)
            self.send_header("Content-Type", "application/x-protobuf")
            self.send_header("Content-Length", str(len(answer)))
            self.end_headers()
            self.wfile.write(answer)

        def log_message(self, *_: object) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    receiver.endpoint = f"http://127.0.0.1:{server.server_address[1]}"
    thread = threading.Thread(target=server.serve_forever, args=(0.05,), daemon=True)
    thread.start()
    try:
        yield receiver
    finally:
        server.shutdown()
        server.server_close()


@contextmanager
def export_traces(**variables: str) -> Iterator[TraceReceiver]:
    """Return a context in which this process exports its spans to a receiver.

    Parameters
    ----------
    **variables
        Further variables of the environment at the beginning of the export.
    """
    with run_trace_receiver() as receiver, pytest.MonkeyPatch.context() as patch:
        for name, value in (receiver.environment | variables).items():
            patch.setenv(name, value)
        with tracing.exporting("knifetip-test"):
            yield receiver


@dataclass
class SilentReceiver:
    """A receiver that accepts connections and reads, but never answers."""

    endpoint: str
    asked: threading.Event = field(default_factory=threading.Event)  #: an export has begun

    @property
    def environment(self) -> dict[str, str]:
        """Variables with which a process exports its spans to this receiver soon."""
        # An export that anything waits for would last longer than any test may.
        return {
            "OTEL_EXPORTER_OTLP_ENDPOINT": self.endpoint,
            "OTEL_EXPORTER_OTLP_TIMEOUT": "600",
            "OTEL_BSP_SCHEDULE_DELAY": "20",
        }


@contextmanager
def run_silent_receiver() -> Iterator[SilentReceiver]:
    """Run a receiver that never answers, on loopback."""
    with ExitStack() as opened:
        listener = opened.enter_context(socket.create_server(("127.0.0.1", 0)))
        receiver = SilentReceiver(f"http://127.0.0.1:{listener.getsockname()[1]}")

        def accept() -> None:
            with suppress(OSError):  # the listener is closed
                while True:
                    connection, _ = listener.accept()
                    opened.enter_context(connection)
                    connection.recv(1)
                    receiver.asked.set()

        threading.Thread(target=accept, daemon=True).start()
        yield receiver
        listener.shutdown(socket.SHUT_RDWR)
