"""Error responses in the format application/problem+json (RFC 9457)."""

from __future__ import annotations

import http
import json
from collections.abc import Mapping, Sequence
from typing import Any, Final, NamedTuple

from fastapi import Response
from starlette.types import Receive, Scope, Send

from knifetip import tracing
from knifetip.messages import Message, printable
from knifetip.messages.english import ENGLISH
from knifetip.service.http.answer_language import requested_language, translate
from knifetip.service.http.models import Problem

PROBLEM = "application/problem+json"
#: URIs of the types of errors: that of the class of an error, or none beyond its HTTP status.
TYPE_PREFIX = "urn:knifetip:problem:"
TYPE_PATTERN = f"^(about:blank|{TYPE_PREFIX}[a-z]+(-[a-z]+)*)$"


class ProblemKind(NamedTuple):
    """The type of an error."""

    uri: str = "about:blank"  #: URI of the type
    title: str = ""  #: title of the type; "" for the reason phrase of the HTTP status


_NO_KIND: Final = ProblemKind()


def problem(
    status: int,
    message: Message,
    *,
    kind: ProblemKind = _NO_KIND,
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
        Type of the error; by default none beyond its HTTP status.
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
            "type": kind.uri,
            "title": kind.title or http.HTTPStatus(status).phrase,
            "status": status,
            "source": [printable(place) for place in source],
            "edges": edges,
            "questions": questions,
            "revision": revision,
        }
    )
    return _Problem(message, body, headers)


class _Problem(Response):
    """An error response; the span of its request gets its code when it is sent.

    Its text and hint are in the language that the request accepts, and else in English.
    """

    def __init__(
        self, message: Message, problem: Problem, headers: Mapping[str, str] | None
    ) -> None:
        content = problem.model_dump_json()
        super().__init__(content, problem.status, headers=dict(headers or {}), media_type=PROBLEM)
        self.headers.add_vary_header("Accept-Language")
        self._message = message

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        tracing.current().set(error=self._message.code)
        language = requested_language(scope)
        self.headers["Content-Language"] = language
        if language != ENGLISH.tag:
            self.body = self.render(
                json.dumps(translate(json.loads(bytes(self.body)), language), ensure_ascii=False)
            )
            self.headers["Content-Length"] = str(len(self.body))
        await super().__call__(scope, receive, send)
