"""limits: refuses requests that are too large, or that another site's page sends, at the door.

A request's size is known before it is read where the client says it, and counted where not.
"""

from __future__ import annotations

import contextlib

from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from knifetip.api.schemas.common import Problem


class TooLarge(Exception):
    """More came than may come."""


class Limits:
    """ASGI middleware around the whole application."""

    def __init__(self, app: ASGIApp, upload: int, body: int) -> None:
        self.app = app
        self.upload = upload
        self.body = body

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, as long as it is small enough and our own."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        headers = Request(scope).headers
        if (
            scope["method"] not in ("GET", "HEAD", "OPTIONS")
            and headers.get("sec-fetch-site") == "cross-site"
        ):
            await _refuse(send, 403, "A page of another site sent this.", "Use this server's own.")
            return
        multipart = headers.get("content-type", "").lower().startswith("multipart/form-data")
        # The parts of a form have heads of their own: a little more than the file in it.
        limit = self.upload + 65536 if multipart else self.body
        mend = "Send a smaller drawing." if multipart else "Send it in several requests."
        told = f"A request may have {limit >> 20} MB here."
        declared = headers.get("content-length", "")
        if declared.isdecimal() and int(declared) > limit:
            await _refuse(send, 413, told, mend)
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
            await _refuse(send, 413, told, mend)


async def _refuse(send: Send, status: int, detail: str, mend: str) -> None:
    title = "Content Too Large" if status == 413 else "Forbidden"
    body = Problem(title=title, status=status, detail=detail, mend=mend).model_dump_json().encode()
    headers = [
        (b"content-type", b"application/problem+json"),
        (b"content-length", str(len(body)).encode()),
        (b"connection", b"close"),
    ]
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": body})
