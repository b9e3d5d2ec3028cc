"""Messages for tests."""

from __future__ import annotations

from knifetip.messages import Message


def stored(text: str) -> Message:
    """Return a text without a code of its own as a message."""
    return Message("stored.text", text=text, hint="")
