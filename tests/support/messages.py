"""Messages for tests."""

from __future__ import annotations

from knifetip.messages import Message


def stored(text: str) -> Message:
    """Return a message that contains a text, like one stored before messages had codes."""
    return Message("stored.text", text=text, hint="")
