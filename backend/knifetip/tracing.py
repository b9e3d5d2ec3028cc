"""tracing: spans of traces, which a process exports if it is asked to (ADR 97).

    with tracing.span("compile", SpanKind.CONSUMER, job.traceparent, job=job.id) as span:
        ...
        span.set(outcome="accepted")

A process that has called ``exporting`` exports its spans with OpenTelemetry if the standard
environment variables ask for it and the extra ``telemetry`` is installed.  Otherwise the functions
of this module do nothing, and OpenTelemetry is not imported.

The context of a trace is passed to other processes as text, in the form of the header
``traceparent`` of W3C Trace Context.
"""

from __future__ import annotations

import logging
import os
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from contextvars import ContextVar
from enum import StrEnum
from typing import Final, Protocol, TypedDict, Unpack

from knifetip import logs
from knifetip.errors import KnifetipError

#: Header of a request with the context of a trace.
HEADER: Final = "traceparent"
#: Length of a ``traceparent``.
LENGTH: Final = 55

#: Variables each of which asks for traces; empty ones count as absent.
_ENDPOINTS: Final = ("OTEL_EXPORTER_OTLP_TRACES_ENDPOINT", "OTEL_EXPORTER_OTLP_ENDPOINT")
_EXPORTER: Final = "OTEL_TRACES_EXPORTER"
_PROTOCOLS: Final = ("OTEL_EXPORTER_OTLP_TRACES_PROTOCOL", "OTEL_EXPORTER_OTLP_PROTOCOL")
_PROTOCOL: Final = "http/protobuf"
_log = logging.getLogger("knifetip.tracing")


class SpanKind(StrEnum):
    """Kind of a span, as OpenTelemetry defines it: server, client, consumer or internal."""

    INTERNAL = "internal"
    SERVER = "server"  #: answers a request
    CLIENT = "client"  #: sends a request
    CONSUMER = "consumer"  #: carries out what another process has queued


class Attributes(TypedDict, total=False):
    """The attributes that spans may have: no names of users or customers, and no secrets."""

    method: str  #: of a request
    route: str  #: template of the path of a request
    operation: str  #: id of the operation in the description of the REST API
    status: int  #: of an answer
    error: str  #: code of a message or name of an exception, never its text
    job: str  #: id
    drawing: str  #: id
    machine: str  #: name
    outcome: str
    attempt: int
    copy: int
    copies: int
    line: int
    lines: int
    event_type: str  #: of a webhook
    webhook: int  #: serial number of an endpoint


class Span(Protocol):
    """A part of a trace with a beginning and an end."""

    @property
    def trace_id(self) -> str:
        """Id of the trace, 32 hexadecimal digits; "" without a trace."""
        ...

    @property
    def span_id(self) -> str:
        """Id of the span, 16 hexadecimal digits; "" without a trace."""
        ...

    @property
    def traceparent(self) -> str:
        """Context for spans of other processes that belong to this one; "" without a trace."""
        ...

    def rename(self, name: str) -> None:
        """Give the span another name."""

    def set(self, **attributes: Unpack[Attributes]) -> None:
        """Set attributes of the span."""

    def event(self, name: str, **attributes: Unpack[Attributes]) -> None:
        """Record an event at the present time, with its attributes."""

    def fail(self, error: str = "") -> None:
        """Mark the span as failed, with a code or the name of an exception if it is known."""


class Exporter(Protocol):
    """Exports spans to another system; see ``telemetry``."""

    def span(
        self, name: str, kind: str, parent: str | None, attributes: Attributes
    ) -> AbstractContextManager[Span]:
        """Return a context in which a new span is the current one; the span ends with the context.

        Parameters
        ----------
        name, kind, attributes
            Name, kind (see ``SpanKind``) and attributes of the span.
        parent
            ``traceparent`` of the span to which it belongs; None for the current span.  Without
            either, and if it is malformed, a trace begins.
        """
        ...

    def close(self) -> None:
        """Export the spans that have ended, and stop; takes a short time also without an answer."""


class _NoSpan:
    """The span of a process that exports none."""

    trace_id = span_id = traceparent = ""

    def rename(self, name: str) -> None:
        pass

    def set(self, **attributes: Unpack[Attributes]) -> None:
        pass

    def event(self, name: str, **attributes: Unpack[Attributes]) -> None:
        pass

    def fail(self, error: str = "") -> None:
        pass


_NO_SPAN: Final = _NoSpan()
_exporter: Exporter | None = None
_current: ContextVar[Span] = ContextVar("span", default=_NO_SPAN)


def is_on() -> bool:
    """Return whether this process exports spans."""
    return _exporter is not None


@contextmanager
def exporting(service: str) -> Iterator[None]:
    """Return a context manager; in its context spans are exported if the environment asks for it.

    Wrong values of the variables and a missing extra are logged as warnings; nothing is raised.

    Parameters
    ----------
    service
        Name of the service, unless ``OTEL_SERVICE_NAME`` gives another one.
    """
    global _exporter
    _exporter = _open_exporter(service, os.environ)
    try:
        yield
    finally:
        closed, _exporter = _exporter, None
        if closed is not None:
            closed.close()


def _open_exporter(service: str, environment: Mapping[str, str]) -> Exporter | None:
    """Return the exporter that the environment asks for; None for none."""

    def first(*names: str) -> tuple[str, str]:
        """Return name and value of the first variable that is set; empty texts if none is."""
        found = ((name, environment.get(name, "").strip()) for name in names)
        return next(((name, value) for name, value in found if value), ("", ""))

    cause, value = first(_EXPORTER, *_ENDPOINTS)
    if not cause or environment.get("OTEL_SDK_DISABLED", "").strip().lower() == "true":
        return None
    kind = value if cause == _EXPORTER else "otlp"
    if kind == "none":
        return None
    if kind not in ("otlp", "console"):
        _log.warning("no traces: %s is %r; use otlp, console or none", _EXPORTER, kind)
        return None
    variable, protocol = first(*_PROTOCOLS)
    if kind == "otlp" and protocol not in ("", _PROTOCOL):
        _log.warning("no traces: %s is %r; only %s is supported", variable, protocol, _PROTOCOL)
        return None
    try:
        from knifetip import telemetry  # imports OpenTelemetry
    except ImportError as reason:
        _log.warning(
            "no traces: %s is set, but OpenTelemetry is not installed (%s). "
            "Install it: pip install 'knifetip[telemetry]'",
            cause,
            reason,
        )
        return None
    try:
        return telemetry.Telemetry(service, console=kind == "console")
    except Exception as reason:
        # Values of other variables that OpenTelemetry does not accept.
        _log.warning("no traces: a variable of OpenTelemetry is wrong: %s", reason)
        return None


@contextmanager
def span(
    name: str,
    kind: SpanKind = SpanKind.INTERNAL,
    parent: str | None = None,
    **attributes: Unpack[Attributes],
) -> Iterator[Span]:
    """Return a context manager that begins a span; log records in the context have its ids.

    An exception that leaves the context marks the span as failed.

    Parameters
    ----------
    name
        Name of the span; one of few.
    kind
        Whether the span is the server or the client of a request, a queued task, or work inside
        the process.
    parent
        ``traceparent`` of the span to which it belongs; None for the current span.  Without
        either, and if it is malformed, a trace begins.
    **attributes
        Attributes of the span.
    """
    if _exporter is None:
        yield _NO_SPAN
        return
    with (
        _exporter.span(name, kind.value, parent, attributes) as opened,
        logs.about(trace_id=opened.trace_id, span_id=opened.span_id),
    ):
        token = _current.set(opened)
        try:
            yield opened
        except BaseException as reason:
            opened.fail(_error_code(reason))
            raise
        finally:
            _current.reset(token)


def _error_code(error: BaseException) -> str:
    """Return what identifies an error, without the names and values in its text."""
    return error.message.code if isinstance(error, KnifetipError) else type(error).__name__


def current() -> Span:
    """Return the current span."""
    return _current.get()


def traceparent() -> str:
    """Return the context of the current span, to be stored or sent; "" without a trace."""
    return _current.get().traceparent


def headers() -> dict[str, str]:
    """Return the header of a request that belongs to the current span; empty without a trace."""
    context = traceparent()
    return {HEADER: context} if context else {}
