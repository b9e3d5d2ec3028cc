"""A span for each request; it continues the trace of a client that sends its context (ADR 97)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from starlette.datastructures import Headers
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from knifetip import tracing
from knifetip.service.http.api_version import ALIAS, route_path
from knifetip.service.http.routing import endpoint_of
from knifetip.service.monitoring.request_log import subject_of
from knifetip.service.monitoring.routes import METHODS
from knifetip.tracing import SpanKind

#: Requests that are repeated all the time or last as long as their client.
_UNTRACED: Final = frozenset(
    {
        "/api/events",
        "/api/gateway/claim",
        "/api/gateway/heartbeat",
        "/api/gateway/station",
    }
)


class RequestSpans:
    """ASGI middleware whose span is the current one while a request of the API is answered.

    It must be the outermost middleware, so that all records of the log have the ids of the span.
    """

    def __init__(self, app: ASGIApp, templates: Callable[[object], str | None]) -> None:
        self.app = app
        self._templates = templates

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Forward a request within a span."""
        path = route_path(scope["path"]) if scope["type"] == "http" else ""
        if not path.startswith(f"{ALIAS}/") or path in _UNTRACED:
            await self.app(scope, receive, send)
            return
        scope.setdefault("state", {})
        method = scope["method"] if scope["method"] in METHODS else "_OTHER"
        parent = Headers(scope=scope).get(tracing.HEADER, "")
        status = 500  # an exception is answered outside this middleware

        async def send_traced(event: Message) -> None:
            nonlocal status
            if event["type"] == "http.response.start":
                status = event["status"]
                location = Headers(raw=event["headers"]).get("location", "")
                span.set(**subject_of(route_path(location)))
            await send(event)

        with tracing.span(
            method, SpanKind.SERVER, parent, method=method, **subject_of(path)
        ) as span:
            try:
                await self.app(scope, receive, send_traced)
            finally:
                span.set(status=status)
                if status >= 500:
                    span.fail()
                endpoint = endpoint_of(scope)
                template = self._templates(endpoint)
                if endpoint is not None and template is not None:
                    span.rename(f"{method} {template}")
                    span.set(route=template, operation=endpoint.__name__.strip("_"))
