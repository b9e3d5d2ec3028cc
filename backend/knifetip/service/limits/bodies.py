"""Middleware that refuses requests whose body is too large.

The size of a body is its Content-Length; without this header, the received bytes are counted.
"""

from __future__ import annotations

import contextlib

from fastapi import Response
from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from knifetip import messages
from knifetip.service.http.principal import PrincipalKind, principal_of
from knifetip.service.http.problems import ProblemKind, problem

#: Routes whose body may be a package with a drawing.
_PACKAGES = ("/xjdf", "/xjmf")
#: Largest body of a sender who is not authenticated (bytes): a name and a password.
_STRANGER = 1 << 20


class TooLarge(Exception):
    """Raised when a request body exceeds its limit."""


class Limits:
    """ASGI middleware that refuses requests whose body is too large.

    It must be inside the access control, which finds the principal of a request.
    """

    def __init__(self, app: ASGIApp, upload: int, body: int) -> None:
        self.app = app
        self.upload = upload
        self.body = body

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Forward a request; refuse it with 413 if its body exceeds the limit of the route."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        request = Request(scope)
        headers = request.headers
        form = headers.get("content-type", "").lower().startswith("multipart/form-data")
        multipart = form or scope["path"].endswith(_PACKAGES)
        # A multipart form has part headers in addition to the file.
        limit = self.upload + 65536 if multipart else self.body
        if principal_of(request).kind is PrincipalKind.NONE:
            # The body is kept in memory, and a stranger may send it on each of many connections.
            limit, multipart = min(limit, _STRANGER), False
        refusal = _refusal(limit, multipart)
        declared = headers.get("content-length", "")
        if declared.isdecimal() and int(declared) > limit:
            await refusal(scope, receive, send)
            return
        received = 0
        refused = False
        started = False

        async def receive_counted() -> Message:
            nonlocal received, refused
            message = await receive()
            received += len(message.get("body", b""))
            if received > limit:
                refused = True
                raise TooLarge
            return message

        async def send_unless_refused(message: Message) -> None:
            nonlocal started
            # The application's response to the truncated body is replaced by the refusal.
            if not refused or started:
                started = True
                await send(message)

        with contextlib.suppress(TooLarge):
            await self.app(scope, receive_counted, send_unless_refused)
        if refused and not started:
            await refusal(scope, receive, send)


def _refusal(limit: int, multipart: bool) -> Response:
    code = "request.upload-too-large" if multipart else "request.body-too-large"
    return problem(
        413,
        messages.Message(code, limit=limit >> 20),
        kind=ProblemKind(title="Content Too Large"),
        headers={"Connection": "close"},
    )
