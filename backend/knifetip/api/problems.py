"""Error responses in the format application/problem+json (RFC 9457)."""

from __future__ import annotations

import http
from collections.abc import Mapping, Sequence
from typing import Any

from fastapi import Response
from starlette.types import Receive, Scope, Send

from knifetip import tracing
from knifetip.api.schemas.common import Problem
from knifetip.messages import Message, printable

PROBLEM = "application/problem+json"
#: URIs of the types of errors: that of the class of an error, or none beyond its HTTP status.
TYPE_PREFIX = "urn:knifetip:problem:"
TYPE_PATTERN = f"^(about:blank|{TYPE_PREFIX}[a-z]+(-[a-z]+)*)$"


def problem(
    status: int,
    message: Message,
    *,
    kind: str = "about:blank",
    title: str = "",
    source: Sequence[str] = (),
    edges: Sequence[int] = (),
    questions: Sequence[dict[str, Any]] = (),
    revision: int | None = None,
    headers: Mapping[str, str] | None = None,
) -> Response:
    """Return an error response in the format of RFC 9457.

    Parameters
    ----------
    status
        HTTP status.
    message
        The error message, which the response contains with its text and hint.
    kind
        URI of the error type.
    title
        Title of the error type; "" for the reason phrase of the status.
    source
        Handles of entities, or names of fields, that the error concerns.
    edges
        Rows of the edges of the drawing that the error concerns.
    questions
        Questions that the user must answer, as JSON data; empty if they are not the cause of the
        error.
    revision
        Newest revision of the drawing if the request named another one; None for other errors.
    headers
        Additional HTTP headers; None for none.
    """
    body = Problem.model_validate(
        {
            **message.as_json(),
            "type": kind,
            "title": title or http.HTTPStatus(status).phrase,
            "status": status,
            "source": [printable(place) for place in source],
            "edges": edges,
            "questions": questions,
            "revision": revision,
        }
    )
    return _Problem(message.code, body.model_dump_json(), status, headers)


class _Problem(Response):
    """An error response; the span of its request gets its code when it is sent."""

    def __init__(
        self, code: str, content: str, status: int, headers: Mapping[str, str] | None
    ) -> None:
        super().__init__(content, status, headers=dict(headers or {}), media_type=PROBLEM)
        self._code = code

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        tracing.current().set(error=self._code)
        await super().__call__(scope, receive, send)
