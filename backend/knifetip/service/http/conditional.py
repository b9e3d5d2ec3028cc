"""Conditional requests: status 304 if a client has the current answer (RFC 9110, section 13).

A route that declares ``NOT_MODIFIED`` takes part: ``ScopedRoute`` sends its answers through
``conditional``, and ``describe_conditions`` adds the headers to the OpenAPI description.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Any, Final

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import Message, Scope, Send

from knifetip.service.http.revisions import is_known

NOT_MODIFIED: Final[dict[int | str, dict[str, Any]]] = {
    304: {"description": "The client's copy is current; the response has no body"}
}

#: Header by which a route gives the start of the ETag; it is not sent.
TAG_PREFIX: Final = "X-Tag-Prefix"
_KNOWN: Final = {
    "name": "If-None-Match",
    "in": "header",
    "required": False,
    "description": "ETag of the client's copy; 304 if it is current",
    "schema": {"type": "string"},
}
_TAG: Final = {
    "description": "Identifies this state of the answer, for `If-None-Match`",
    "schema": {"type": "string"},
}
#: Headers that describe a body, which an answer with status 304 does not have.
_OF_BODY: Final = ("content-length", "content-type", "content-disposition")


def conditional(scope: Scope, send: Send) -> Send:
    """Return a function that sends the answer to a GET request, or 304 if the client has it.

    An answer without an ETag gets a hash of its body as one; one that is sent in several parts
    stays as it is.

    Parameters
    ----------
    scope
        ASGI scope of the request, with its header ``If-None-Match``.
    send
        Sends an ASGI message to the client.
    """
    known = Headers(scope=scope).get("If-None-Match")
    waiting: Message | None = None  # the head of the answer, until its body is known

    async def send_conditional(event: Message) -> None:
        nonlocal waiting
        if event["type"] == "http.response.start" and event["status"] == 200:
            waiting = event
            return
        if waiting is not None:
            start, waiting = waiting, None
            whole = not event.get("more_body", False)
            headers = MutableHeaders(scope=start)
            prefix = headers.get(TAG_PREFIX)
            if prefix is not None:
                del headers[TAG_PREFIX]
            if whole and "ETag" not in headers:
                digest = hashlib.sha256(event.get("body", b"")).hexdigest()[:32]
                headers["ETag"] = f'"{digest}"' if prefix is None else f'"{prefix}.{digest}"'
                headers["Cache-Control"] = "no-cache"
            if whole and is_known(headers["ETag"], known):
                start["status"] = 304
                event["body"] = b""
                for name in _OF_BODY:
                    if name in headers:
                        del headers[name]
            await send(start)
        await send(event)

    return send_conditional


def describe_conditions(described: Mapping[str, Any]) -> None:
    """Add ``If-None-Match`` and ``ETag`` to the operations with status 304 in a description."""
    for item in described["paths"].values():
        for operation in item.values():
            if "304" in operation["responses"]:
                operation.setdefault("parameters", []).append(_KNOWN)
                operation["responses"]["200"].setdefault("headers", {})["ETag"] = _TAG
