"""Which control characters the texts of requests may contain, and the errors of all others."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from pydantic_core import ErrorDetails

from knifetip.fields import QUOTED_FIELDS, Place, control_characters
from knifetip.messages.characters import TextKind

#: What the texts in fields with these names may contain; those in other fields are lines.
KINDS: Final[Mapping[str, TextKind]] = {
    **dict.fromkeys(("metadata", "note", "notes", "reason", "rules", "toml"), TextKind.LINES),
    # Messages of gateways, which quote controllers.
    **dict.fromkeys(("arguments", "hint", "text", "why"), TextKind.QUOTED),
    "content": TextKind.QUOTED,  # base64, also in lines
    **QUOTED_FIELDS,
}


def text_faults(value: object) -> list[ErrorDetails]:
    """Return an error, in the form of pydantic, for each text in a JSON value that is refused.

    Parameters
    ----------
    value
        The JSON value, in which the paths of the errors begin.
    """
    return [control_fault(*found) for found in control_characters(value, (), KINDS)]


def control_fault(place: Place, character: str) -> ErrorDetails:
    """Return the error of a text with a control character."""
    return {
        "type": "field.control-character",
        "loc": place,
        "msg": "",
        "input": None,
        "ctx": {"character": character},
    }
