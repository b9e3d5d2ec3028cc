"""HEAD: the headers of the answer to GET, without its body (RFC 9110, section 9.3.2)."""

from __future__ import annotations

from typing import Final

from starlette.types import ASGIApp, Message, Receive, Scope, Send

_KEY: Final = "knifetip.head"


class HeadRequests:
    """ASGI middleware that answers HEAD with the routes of GET.

    It must be inside the middleware that logs and counts requests, which see HEAD.
    """

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Forward a request; the body of the answer to HEAD is left out."""
        if scope["type"] != "http" or scope["method"] != "HEAD":
            await self.app(scope, receive, send)
            return

        async def send_without_body(event: Message) -> None:
            if event["type"] == "http.response.body":
                if event.get("more_body", False):
                    return
                event = {**event, "body": b""}
            await send(event)

        await self.app({**scope, "method": "GET", _KEY: True}, receive, send_without_body)


def is_head(scope: Scope) -> bool:
    """Return whether a request is HEAD, whose answer has no body."""
    return _KEY in scope
