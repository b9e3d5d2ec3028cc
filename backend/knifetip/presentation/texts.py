"""Add the English text of messages to JSON data that contains messages."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from knifetip.messages import with_text


def with_texts(data: Any) -> Any:
    """Return JSON data in which every message has its English text and hint.

    A message is an object with ``code`` and ``arguments``.  ``text`` and ``hint`` are added to
    messages at every depth, but not to messages within the arguments of a message.
    """
    if isinstance(data, Mapping):
        if "code" in data and "arguments" in data:
            return with_text(data)
        return {key: with_texts(value) for key, value in data.items()}
    if isinstance(data, list):
        return [with_texts(item) for item in data]
    return data
