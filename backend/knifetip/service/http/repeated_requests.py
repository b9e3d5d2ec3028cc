"""Requests with an Idempotency-Key that are executed once, whatever their route does (ADR 103).

Routes that make a drawing or a job, and commands to jobs, store the key in the transaction of the
request (``parameters.IdempotencyKey``).  For all other POST requests, ``answer_once`` stores the
key before the request is executed, and the answer after it.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from contextvars import Context
from functools import partial
from typing import Any, Final, ParamSpec, TypeVar

from fastapi.dependencies.models import Dependant
from fastapi.exceptions import RequestValidationError
from fastapi.routing import APIRoute
from starlette.datastructures import Headers, MutableHeaders
from starlette.types import Message, Receive, Scope, Send

from knifetip.errors import WrongState
from knifetip.service.components import Service
from knifetip.service.database.request_key import RequestKey, fingerprint
from knifetip.service.database.tables import AnsweredRequest
from knifetip.service.http.parameters import IDEMPOTENCY_KEY, LONGEST_KEY

P = ParamSpec("P")
T = TypeVar("T")

#: Headers of an answer that are kept with it.
_KEPT: Final = ("content-type", "location", "etag", "cache-control")
#: Statuses with which a request was refused before it changed anything.
_UNCHANGED: Final = (503, 507)
REPLAYED: Final = "Idempotency-Replayed"


def keeps_keys(route: APIRoute) -> bool:
    """Return whether a route stores the keys of its requests itself."""
    return _has_key(route.dependant)


def _has_key(dependant: Dependant) -> bool:
    if any(one.alias == IDEMPOTENCY_KEY for one in dependant.header_params):
        return True
    return any(map(_has_key, dependant.dependencies))


async def answer_once(
    handle: Callable[[Scope, Receive, Send], Awaitable[None]],
    scope: Scope,
    receive: Receive,
    send: Send,
) -> None:
    """Answer a request that has an Idempotency-Key; a repetition gets the answer of the first.

    Parameters
    ----------
    handle
        Executes the request.
    scope, receive, send
        The request, as ASGI describes it.

    Raises
    ------
    RequestValidationError
        The key is empty or too long.
    KeyReused
        The key was used for another request.
    WrongState
        The outcome of the first request is not known, or its answer had a secret.
    """
    text = Headers(scope=scope)[IDEMPOTENCY_KEY]
    if not 1 <= len(text) <= LONGEST_KEY:
        raise RequestValidationError([_length_fault(text)])
    body = await _read(receive)
    key = RequestKey(text, fingerprint(scope["method"], scope["path"], scope["query_string"], body))
    service: Service = scope["app"].state.service
    answers = service.store.answers
    earlier = await service.threads.reports(_run_unaudited, answers.begin, key)
    if earlier is not None:
        await _replay(earlier, send)
        return
    answer = _Answer()
    await handle(scope, _receive(body, receive), answer.collect)
    if answer.status < 400:
        is_secret = "no-store" in answer.headers.get("cache-control", "")
        kept = b"" if is_secret else bytes(answer.body)
        await service.threads.reports(
            _run_unaudited, answers.end, key, answer.status, answer.headers, kept
        )
    elif answer.status < 500 or answer.status in _UNCHANGED:
        await service.threads.reports(_run_unaudited, answers.forget, key)
    for event in answer.events:
        await send(event)


def _run_unaudited(call: Callable[P, T], *args: P.args, **named: P.kwargs) -> T:
    """Execute a call outside the request, whose first transaction writes its audit entry."""
    return Context().run(partial(call, *args, **named))


class _Answer:
    """The answer to a request, which is stored before it is sent."""

    def __init__(self) -> None:
        self.status = 0
        self.headers: dict[str, str] = {}
        self.body = bytearray()
        self.events: list[Message] = []

    async def collect(self, event: Message) -> None:
        """Keep a part of the answer."""
        if event["type"] == "http.response.start":
            self.status = event["status"]
            headers = Headers(raw=event["headers"])
            self.headers = {name: headers[name] for name in _KEPT if name in headers}
        elif event["type"] == "http.response.body":
            self.body += event.get("body", b"")
        self.events.append(event)


async def _replay(earlier: AnsweredRequest, send: Send) -> None:
    """Send the answer of an earlier request again."""
    if earlier.status == 0:
        raise WrongState("request.outcome-unknown")
    if "no-store" in earlier.headers.get("cache-control", ""):
        place = earlier.headers.get("location", "")
        raise WrongState("request.secret-not-kept", path=place)
    start: Message = {"type": "http.response.start", "status": earlier.status, "headers": []}
    headers = MutableHeaders(scope=start)
    for name, value in earlier.headers.items():
        headers[name] = value
    headers[REPLAYED] = "true"
    if earlier.status != 204:
        headers["content-length"] = str(len(earlier.body))
    await send(start)
    await send({"type": "http.response.body", "body": bytes(earlier.body)})


def _length_fault(text: str) -> dict[str, Any]:
    kind, limit = ("too_long", "max_length") if text else ("too_short", "min_length")
    return {
        "type": f"string_{kind}",
        "loc": ("header", IDEMPOTENCY_KEY),
        "input": text,
        "ctx": {limit: LONGEST_KEY if text else 1},
    }


async def _read(receive: Receive) -> bytes:
    """Return the body of a request."""
    body = bytearray()
    while True:
        event = await receive()
        body += event.get("body", b"")
        if event["type"] != "http.request" or not event.get("more_body", False):
            return bytes(body)


def _receive(body: bytes, receive: Receive) -> Receive:
    """Return a function that receives a body that was read before, and then what follows."""
    sent = False

    async def receive_again() -> Message:
        nonlocal sent
        if sent:
            return await receive()
        sent = True
        return {"type": "http.request", "body": body, "more_body": False}

    return receive_again
