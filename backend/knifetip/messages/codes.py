"""codes: every message that knifetip can report, with the types of its arguments.

The first part of a code is the room that reports it.  The OpenAPI description carries this table
as the union ``Message``, so that a client can hold its own catalogue complete.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, Literal, TypeAlias

#: Types: str, int, float, list of str, another message, such a one or None, list of messages.
Kind: TypeAlias = Literal["text", "count", "number", "texts", "message", "message?", "messages"]

#: A text that was stored before it had a code, or that another version of knifetip sent.
STORED: Final = "stored.text"

CODES: Final[Mapping[str, Mapping[str, Kind]]] = {
    STORED: {"text": "text", "hint": "text"},
    # Questions
    "question.unit": {
        "reason": "message",
        "sizes": "messages",
        "evidence": "message?",
    },
    "question.unit-size": {"unit": "text", "width": "number", "height": "number"},
    "question.unit-evidence": {"unit": "text", "evidence": "messages"},
    "question.unit-doubtful": {"stated": "text", "other": "text"},
    "question.unit-contradicted": {"stated": "text"},
    "question.unit-not-stated": {},
    "question.unit-unreadable": {"evidence": "message"},
    "question.line-type": {
        "edges": "count",
        "layer": "text",
        "colour": "text",
        "linetype": "text",
        "length": "number",
        "width": "number",
        "height": "number",
        "x": "number",
        "y": "number",
        "unit": "text",
        "guess": "message?",
    },
    "question.guess": {"type": "text", "percent": "count", "reason": "message"},
    "question.shape": {"reason": "message"},
    "question.tool": {"edges": "count", "type": "text", "machine": "text"},
}
