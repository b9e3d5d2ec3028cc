"""Default security headers of all responses; a response may set other values."""

from __future__ import annotations

from starlette.datastructures import MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

#: Responses of the API are data: pages must not frame, execute or load them across origins.
DEFAULTS = {
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Content-Security-Policy": "default-src 'none'; frame-ancestors 'none'",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "same-origin",
}


class SecurityHeaders:
    """ASGI middleware that adds the default security headers to every response."""

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Forward a request and add the security headers to its response."""

        async def send_with_headers(event: Message) -> None:
            # A browser would replace the cached headers with those of a 304.
            if event["type"] == "http.response.start" and event["status"] != 304:
                headers = MutableHeaders(scope=event)
                for name, value in DEFAULTS.items():
                    headers.setdefault(name, value)
            await send(event)

        await self.app(scope, receive, send_with_headers if scope["type"] == "http" else send)
