"""telemetry: exports the spans of ``tracing`` with OpenTelemetry; the only module that imports it.

The standard environment variables of OpenTelemetry configure it: endpoint, headers, certificates,
timeouts, sampling, batches and limits.  A thread of its own sends ended spans in batches.  If the
receiver does not answer, a bounded queue drops spans; nothing waits for it.
"""

from __future__ import annotations

import logging
import threading
import time
import uuid
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from importlib.metadata import version
from typing import Any, Final

from opentelemetry import trace
from opentelemetry.context import Context
from opentelemetry.exporter.otlp.proto.http.trace_exporter import OTLPSpanExporter
from opentelemetry.sdk.resources import Resource
from opentelemetry.sdk.trace import TracerProvider
from opentelemetry.sdk.trace.export import BatchSpanProcessor, ConsoleSpanExporter, SpanExporter
from opentelemetry.trace import SpanKind, Status, StatusCode
from opentelemetry.trace.propagation.tracecontext import TraceContextTextMapPropagator

#: Longest time that the end of a process waits for the receiver of its last spans (s).
PATIENCE: Final = 2.0
_QUIET: Final = 60.0  # seconds between two records of the log about failed exports
#: Names of attributes by the semantic conventions; others have the prefix ``knifetip.``.
_NAMES: Final = {
    "method": "http.request.method",
    "route": "http.route",
    "status": "http.response.status_code",
    "error": "error.type",
}
#: What a detector of resources may find in the command line: keys and passwords.
_SECRET: Final = ("process.command", "process.command_args", "process.command_line")
_W3C: Final = TraceContextTextMapPropagator()
_log = logging.getLogger("knifetip.tracing")


class ExportedSpan:
    """A span of OpenTelemetry; see ``tracing.Span``."""

    def __init__(self, span: trace.Span) -> None:
        self._span = span
        context = span.get_span_context()
        self.trace_id = trace.format_trace_id(context.trace_id)
        self.span_id = trace.format_span_id(context.span_id)
        self.traceparent = f"00-{self.trace_id}-{self.span_id}-{context.trace_flags:02x}"

    def rename(self, name: str) -> None:
        self._span.update_name(name)

    def set(self, **attributes: Any) -> None:
        self._span.set_attributes(_trace_names(attributes))

    def event(self, name: str, **attributes: Any) -> None:
        self._span.add_event(name, _trace_names(attributes))

    def fail(self, error: str = "") -> None:
        # Without a description: texts of errors contain names of files and persons.
        self._span.set_status(Status(StatusCode.ERROR))
        if error:
            self.set(error=error)


class Telemetry:
    """Exports spans; see ``tracing.Exporter``.

    Parameters
    ----------
    service
        Name of the service, unless ``OTEL_SERVICE_NAME`` gives another one.
    console
        Whether the spans are written to stdout; otherwise they are sent with OTLP over HTTP.

    Raises
    ------
    Exception
        OpenTelemetry refuses the value of a variable.
    """

    def __init__(self, service: str, *, console: bool = False) -> None:
        found = Resource.create({"service.instance.id": str(uuid.uuid4())})
        attributes = {
            # What OpenTelemetry itself names a service without a name.
            **found.attributes,
            "service.version": version("knifetip"),
        }
        if str(attributes["service.name"]).startswith("unknown_service"):
            attributes["service.name"] = service
        for name in _SECRET:
            attributes.pop(name, None)
        # It is stopped by ``close``, which does not wait long.
        self._provider = TracerProvider(
            resource=Resource(attributes, found.schema_url), shutdown_on_exit=False
        )
        exporter: SpanExporter = ConsoleSpanExporter() if console else OTLPSpanExporter()
        self._quieten()
        self._provider.add_span_processor(BatchSpanProcessor(exporter))
        self._tracer = self._provider.get_tracer("knifetip", version("knifetip"))

    @contextmanager
    def span(
        self, name: str, kind: str, parent: str | None, attributes: Mapping[str, Any]
    ) -> Iterator[ExportedSpan]:
        """Return a context manager that begins a span and makes it the current one."""
        span = self._tracer.start_span(
            name,
            None if parent is None else _context(parent),
            SpanKind[kind.upper()],
            _trace_names(attributes),
        )
        try:
            with trace.use_span(span, record_exception=False, set_status_on_exception=False):
                yield ExportedSpan(span)
        finally:
            span.end()

    def close(self) -> None:
        """Export the spans that have ended, and stop; waits ``PATIENCE`` at most."""
        ending = threading.Thread(target=self._provider.shutdown, name="telemetry", daemon=True)
        ending.start()
        ending.join(PATIENCE)
        if ending.is_alive():
            _log.warning("the last spans were not exported: the receiver does not answer")

    def _quieten(self) -> None:
        """Limit the log records about failed exports to one per minute for each logger."""
        for name in (OTLPSpanExporter.__module__, "opentelemetry.sdk._shared_internal"):
            logger = logging.getLogger(name)
            if not any(isinstance(one, _NowAndThen) for one in logger.filters):
                logger.addFilter(_NowAndThen())


class _NowAndThen(logging.Filter):
    """Filter of a logger that passes at most one record per minute."""

    def __init__(self) -> None:
        super().__init__()
        self._passed = -_QUIET

    def filter(self, _record: logging.LogRecord) -> bool:
        if time.monotonic() - self._passed < _QUIET:
            return False
        self._passed = time.monotonic()
        return True


def _context(traceparent: str) -> Context:
    """Return the context of a ``traceparent``; an empty one if it is malformed."""
    return _W3C.extract({"traceparent": traceparent}, Context())


def _trace_names(attributes: Mapping[str, Any]) -> dict[str, Any]:
    """Return attributes under the names that they have in traces."""
    return {_NAMES.get(name, f"knifetip.{name}"): value for name, value in attributes.items()}
