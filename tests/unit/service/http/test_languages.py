"""Texts are in the language that the request accepts; their codes and arguments are the same."""

from __future__ import annotations

import asyncio
import json
from typing import Any

import pytest

from knifetip.messages import Message, with_text
from knifetip.service.http.answer_language import LARGEST, in_requested_language, translate
from tests.support.serving.server import LocalClient, square, upload_drawing

pytestmark = pytest.mark.xdist_group("server")

GERMAN = "Auftrag 'none' gibt es nicht."
ENGLISH = "Job 'none' does not exist."


@pytest.mark.parametrize(
    ("accepted", "language", "text"),
    [
        ("de-AT,de;q=0.9,en;q=0.5", "de", GERMAN),
        ("en, de;q=0.5", "en", ENGLISH),
        ("fr", "en", ENGLISH),
        ("", "en", ENGLISH),
    ],
)
def test_an_error_is_in_the_language_of_the_request(
    client: LocalClient, accepted: str, language: str, text: str
) -> None:
    answer = client.get("/api/v1/jobs/none", headers={"Accept-Language": accepted})
    assert answer.status_code == 404
    assert answer.headers["Content-Language"] == language
    assert "Accept-Language" in answer.headers["Vary"]
    problem = answer.json()
    assert problem["code"] == "job.unknown"
    assert problem["arguments"] == {"job": "'none'"}
    assert (problem["text"], problem["detail"]) == (text, text)


def test_the_hint_of_an_error_is_in_the_same_language(client: LocalClient) -> None:
    answer = client.get("/api/v1/jobs/none", headers={"Accept-Language": "de"})
    assert answer.json()["hint"] == "Einen der Aufträge wählen, die GET /api/jobs nennt."
    assert int(answer.headers["Content-Length"]) == len(answer.content)


def test_the_messages_of_an_answer_are_in_the_language_of_the_request(client: LocalClient) -> None:
    id = upload_drawing(client, square(layer="DUBIOUS", units=None))["id"]
    german, english = (
        client.get(f"/api/drawings/{id}", headers={"Accept-Language": language})
        for language in ("de", "en")
    )
    assert german.headers["Content-Language"] == "de"
    assert int(german.headers["Content-Length"]) == len(german.content)
    assert "Accept-Language" in german.headers["Vary"] == english.headers["Vary"]
    there, here = german.json(), english.json()
    assert there["questions"][0]["code"] == here["questions"][0]["code"]
    assert "In welcher Einheit ist die Zeichnung?" in there["questions"][0]["text"]
    assert "In which unit is the drawing?" in here["questions"][0]["text"]
    assert there["evidence"] == there["evidence_message"]["text"] != here["evidence"]


def test_the_answer_to_a_changing_request_is_in_its_language(client: LocalClient) -> None:
    id = upload_drawing(client, square(side=61.0))["id"]
    body = {"drawing": id, "board": "e-flute", "release": False}
    key = {"Idempotency-Key": "an-order-in-german", "Accept-Language": "de"}
    job = client.post("/api/jobs", json=body, headers=key).json()["id"]
    events = client.get(f"/api/jobs/{job}/events", headers={"Accept-Language": "de"}).json()
    assert all(event["why"] == (event["message"] or {"text": ""})["text"] for event in events)
    assert events[0]["why"] != client.get(f"/api/jobs/{job}/events").json()[0]["why"]


def test_only_messages_are_translated() -> None:
    message = with_text(Message("job.unknown", job="7"))
    foreign = {"code": "job.unknown", "arguments": {"other": 1}, "text": "x", "hint": ""}
    data = {"message": message, "reason": message["text"], "title": "7", "notes": [foreign]}
    found = translate(data, "de")
    assert found["reason"] == found["message"]["text"] == "Auftrag 7 gibt es nicht."
    assert (found["title"], found["notes"]) == ("7", [foreign])


def test_a_long_answer_is_sent_as_it_is() -> None:
    body = json.dumps([with_text(Message("job.unknown", job="7"))] * 2000).encode()
    assert len(body) > LARGEST
    assert sent(body[:LARGEST], body[LARGEST:]) == body


def test_an_answer_in_parts_is_translated_as_a_whole() -> None:
    body = json.dumps(with_text(Message("job.unknown", job="7"))).encode()
    assert "gibt es nicht" in sent(body[:30], body[30:]).decode()


def sent(*parts: bytes) -> bytes:
    """Return the body of an answer in parts, as a client gets it that accepts German."""
    events: list[dict[str, Any]] = []

    async def send(event: Any) -> None:
        events.append(event)

    async def answer() -> None:
        scope = {"type": "http", "headers": [(b"accept-language", b"de")]}
        forward = in_requested_language(scope, send)
        media = [(b"content-type", b"application/json")]
        await forward({"type": "http.response.start", "status": 200, "headers": media})
        for number, part in enumerate(parts, 1):
            more = number < len(parts)
            await forward({"type": "http.response.body", "body": part, "more_body": more})

    asyncio.run(answer())
    assert [event["type"] for event in events][:1] == ["http.response.start"]
    return b"".join(event.get("body", b"") for event in events)
