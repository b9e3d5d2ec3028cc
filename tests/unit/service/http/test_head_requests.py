"""The answer to HEAD has no body, whatever server sends it on."""

from __future__ import annotations

import pytest
from starlette.types import Message, Receive, Scope, Send

from knifetip.service.http.head_requests import HeadRequests, is_head

START: Message = {
    "type": "http.response.start",
    "status": 200,
    "headers": [(b"content-length", b"6")],
}


async def in_two_parts(scope: Scope, receive: Receive, send: Send) -> None:
    assert scope["method"] == "GET"
    await send(START)
    await send({"type": "http.response.body", "body": b"abc", "more_body": True})
    await send({"type": "http.response.body", "body": b"def"})


async def sent(method: str) -> list[Message]:
    found: list[Message] = []

    async def send(event: Message) -> None:
        found.append(event)

    async def receive() -> Message:
        return {"type": "http.request"}

    scope: Scope = {"type": "http", "method": method, "path": "/"}
    await HeadRequests(in_two_parts)(scope, receive, send)
    return found


async def test_the_parts_of_a_body_are_left_out_and_its_length_is_kept() -> None:
    assert await sent("HEAD") == [START, {"type": "http.response.body", "body": b""}]


async def test_get_is_answered_with_all_parts() -> None:
    bodies = [event.get("body") for event in await sent("GET")]
    assert bodies == [None, b"abc", b"def"]


@pytest.mark.parametrize(("method", "expected"), [("HEAD", True), ("GET", False)])
async def test_a_route_sees_that_no_body_will_be_sent(method: str, expected: bool) -> None:
    seen: list[bool] = []

    async def look(scope: Scope, receive: Receive, send: Send) -> None:
        seen.append(is_head(scope))

    async def receive() -> Message:
        return {"type": "http.request"}

    async def send(event: Message) -> None:
        raise AssertionError(event)

    await HeadRequests(look)({"type": "http", "method": method, "path": "/"}, receive, send)
    assert seen == [expected]
