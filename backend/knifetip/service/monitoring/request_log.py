"""A record of the log for each request, with an id that the response returns (ADR 84)."""

from __future__ import annotations

import logging
import re
import time
import uuid
from typing import Final, TypedDict

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from knifetip import logs
from knifetip.service.http.api_version import route_path
from knifetip.service.http.principal import PrincipalKind, principal_of

_log = logging.getLogger("knifetip.access")
_HEADER: Final = "X-Request-ID"
_ACCEPTED: Final = re.compile(r"[A-Za-z0-9._-]{1,64}")
_SUBJECT: Final = re.compile(r"/api/(job|drawing)s/([A-Za-z0-9_-]{1,64})(?:/|$)")
_PROBES: Final = ("/healthz", "/readyz", "/metrics")
_LONGEST: Final = 1000  # characters of a path in the log


class RequestLog:
    """ASGI middleware that gives each request an id and writes a record at its end.

    Only ``RequestSpans`` may be outside it, so that refused requests have an id and a record too.
    """

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Forward a request; records of its processing have its id."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        scope.setdefault("state", {})
        given = Headers(scope=scope).get(_HEADER, "")
        id = given if _ACCEPTED.fullmatch(given) else uuid.uuid4().hex
        path = route_path(scope["path"])
        fields: dict[str, object] = {"request_id": id, **subject_of(path)}
        status = 0

        async def send_with_id(event: Message) -> None:
            nonlocal status
            if event["type"] == "http.response.start":
                status = event["status"]
                headers = MutableHeaders(scope=event)
                headers[_HEADER] = id
                fields.update(subject_of(route_path(headers.get("location", ""))))
            await send(event)

        begun = time.monotonic()
        with logs.about(**fields):
            try:
                await self.app(scope, receive, send_with_id)
            finally:
                level = logging.DEBUG if path in _PROBES else logging.INFO
                if _log.isEnabledFor(level):
                    principal = principal_of(Request(scope))
                    if principal.kind is not PrincipalKind.NONE:
                        fields["principal"] = principal.name
                    fields["method"], fields["status"] = scope["method"], status
                    fields["duration"] = round(time.monotonic() - begun, 4)
                    # Without the query, which may contain a key.
                    path = scope["path"][:_LONGEST]
                    _log.log(level, "%s %s", scope["method"], path, extra={logs.FIELDS: fields})


class Subject(TypedDict, total=False):
    """The id of a job or a drawing."""

    job: str
    drawing: str


def subject_of(path: str) -> Subject:
    """Return the id of the job or drawing that a path names."""
    found = _SUBJECT.match(path)
    if found is None:
        return {}
    return {"job": found[2]} if found[1] == "job" else {"drawing": found[2]}
