"""limits: refuses requests that are too large.

A request's size is known before it is read where the client says it, and counted where not.
"""

from __future__ import annotations

import contextlib

from fastapi import Response
from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from knifetip import messages
from knifetip.api.problems import problem


class TooLarge(Exception):
    """More came than may come."""


class Limits:
    """ASGI middleware around the whole application."""

    def __init__(self, app: ASGIApp, upload: int, body: int) -> None:
        self.app = app
        self.upload = upload
        self.body = body

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, as long as it is small enough."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        headers = Request(scope).headers
        multipart = headers.get("content-type", "").lower().startswith("multipart/form-data")
        # The parts of a form have heads of their own: a little more than the file in it.
        limit = self.upload + 65536 if multipart else self.body
        refusal = _refusal(limit, multipart)
        declared = headers.get("content-length", "")
        if declared.isdecimal() and int(declared) > limit:
            await refusal(scope, receive, send)
            return
        received = 0
        refused = False
        begun = False

        async def counted() -> Message:
            nonlocal received, refused
            message = await receive()
            received += len(message.get("body", b""))
            if received > limit:
                refused = True
                raise TooLarge
            return message

        async def passed(message: Message) -> None:
            nonlocal begun
            # Whatever the application makes of the broken-off body, the answer is ours.
            if not refused or begun:
                begun = True
                await send(message)

        with contextlib.suppress(TooLarge):
            await self.app(scope, counted, passed)
        if refused and not begun:
            await refusal(scope, receive, send)


def _refusal(limit: int, multipart: bool) -> Response:
    code = "request.upload-too-large" if multipart else "request.body-too-large"
    return problem(
        413,
        messages.Message(code, limit=limit >> 20),
        title="Content Too Large",
        headers={"Connection": "close"},
    )
