"""Texts of messages in answers, in the language that a request accepts (ADR 133).

Answers are made and stored in English.  Before one is sent to a client that accepts another
language, each message in its JSON is rendered again from its code and arguments.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any, Final, TypeGuard

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import Message, Scope, Send

from knifetip.messages import from_json, with_text
from knifetip.messages.codes import CODES
from knifetip.messages.english import ENGLISH
from knifetip.messages.languages import accepted_languages, choose_language

#: Largest answer (bytes) that is translated.  Longer ones would hold up the other requests.
LARGEST: Final = 1 << 18
_JSON: Final = "application/json"
#: Fields with a message whose text other fields of the same object repeat.
_BESIDE: Final = ("message", "evidence_message")


def requested_language(scope: Scope) -> str:
    """Return the tag of the language that a request accepts, by its ``Accept-Language``."""
    accepted = Headers(scope=scope).get("accept-language", "")
    return choose_language(accepted_languages(accepted))


def in_requested_language(scope: Scope, send: Send) -> Send:
    """Return a function that sends an answer in the language that a request accepts.

    Compressed answers, and those with more than ``LARGEST`` bytes, are sent as they are.
    """
    language = requested_language(scope)
    head: Message | None = None  # of a JSON answer, until its body is known
    body = bytearray()

    async def send_translated(event: Message) -> None:
        nonlocal head
        if event["type"] == "http.response.start" and _is_translatable(event):
            MutableHeaders(scope=event).add_vary_header("Accept-Language")
            if language != ENGLISH.tag:
                head = event
                return
        if head is None:
            await send(event)
            return
        body.extend(event.get("body", b""))
        is_whole = not event.get("more_body", False)
        if not is_whole and len(body) <= LARGEST:
            return
        start, head = head, None
        if is_whole and len(body) <= LARGEST:
            content = json.dumps(
                translate(json.loads(body), language), ensure_ascii=False, separators=(",", ":")
            ).encode()
            headers = MutableHeaders(scope=start)
            headers["Content-Language"] = language
            headers["Content-Length"] = str(len(content))
            event = {**event, "body": content}
        else:
            event = {**event, "body": bytes(body)}
        await send(start)
        await send(event)

    return send_translated


def _is_translatable(start: Message) -> bool:
    """Return whether the body after the head of an answer is uncompressed JSON."""
    headers = Headers(raw=start["headers"])
    media = headers.get("content-type", "").partition(";")[0]
    return media == _JSON and "content-encoding" not in headers


def translate(data: Any, language: str) -> Any:
    """Return JSON data in which the texts of messages are in a language.

    A message is an object with ``code``, ``arguments``, ``text`` and ``hint``.  Other fields that
    repeat its English text or hint get the other one too: fields of this object, and those beside
    a field ``message`` or ``evidence_message``, such as the ``reason`` of a job.

    Parameters
    ----------
    data
        JSON data of an answer, with English texts.
    language
        Tag of the language.
    """
    if isinstance(data, list):
        return [translate(item, language) for item in data]
    if not isinstance(data, dict):
        return data
    translated = {key: translate(value, language) for key, value in data.items()}
    texts: dict[str, str] = {}
    for message in (data, *(data.get(name) for name in _BESIDE)):
        if _is_message(message):
            texts |= _translations(message, language)
    return {
        key: texts.get(value, value) if isinstance(value, str) else value
        for key, value in translated.items()
    }


def _is_message(data: Any) -> TypeGuard[dict[str, Any]]:
    """Return whether JSON data is a message with its text, of a code that is known."""
    return (
        isinstance(data, dict)
        and {"code", "arguments", "text", "hint"} <= data.keys()
        and isinstance(data["arguments"], dict)
        and CODES.get(str(data["code"]), {}).keys() == data["arguments"].keys()
    )


def _translations(message: Mapping[str, Any], language: str) -> dict[str, str]:
    """Return the text and the hint of a message in a language, by those in English."""
    found = with_text(from_json(message), language)
    return {message["hint"]: found["hint"], message["text"]: found["text"]}
