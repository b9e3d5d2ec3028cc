"""headers: tells browsers what no page may do with an answer, unless the answer sets its own."""

from __future__ import annotations

from starlette.datastructures import MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

#: Answers of the API are data: no page may frame them, run them or load them across origins.
DEFAULTS = {
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Content-Security-Policy": "default-src 'none'; frame-ancestors 'none'",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "same-origin",
}


class SecurityHeaders:
    """ASGI middleware around the whole application."""

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, and add the headers to its answer."""

        async def passed(event: Message) -> None:
            # A browser puts the headers of a 304 in place of those that it has kept.
            if event["type"] == "http.response.start" and event["status"] != 304:
                headers = MutableHeaders(scope=event)
                for name, value in DEFAULTS.items():
                    headers.setdefault(name, value)
            await send(event)

        await self.app(scope, receive, passed if scope["type"] == "http" else send)
