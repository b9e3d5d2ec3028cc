"""Messages in responses: code, arguments and text, and the schema of all codes.

Clients may print the text, or render code and arguments with a catalogue of their own.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any, ClassVar, Final, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from knifetip.fields import field_error
from knifetip.messages import Message, from_json, with_text
from knifetip.messages.codes import CODES
from knifetip.messages.entry import Kind

#: Key that marks schemas whose ``code`` is a MessageCode.
_MARK: Final = "x-message"
#: Key of the values that a string has at present; newer servers may have more.
_KNOWN: Final = "x-known-values"
#: Maximum size of a message in a request, as JSON (characters).
_LONGEST: Final = 20_000
_UNION: Final = "#/components/schemas/Message"
_TYPES: Final[Mapping[Kind, dict[str, Any]]] = {
    "text": {"type": "string"},
    "count": {"type": "integer"},
    "number": {"type": "number"},
    "texts": {"type": "array", "items": {"type": "string"}},
    "message": {"$ref": _UNION},
    "message?": {"anyOf": [{"$ref": _UNION}, {"type": "null"}]},
    "messages": {"type": "array", "items": {"$ref": _UNION}},
    "edge": {"type": "integer", "description": "Row of an edge of the drawing"},
    "edges": {
        "type": "array",
        "items": {"type": "integer"},
        "description": "Rows of edges of the drawing",
    },
    "x": {"type": "number", "description": "Position in the drawing (mm)"},
    "y": {"type": "number", "description": "Position in the drawing (mm)"},
}


class MessageOut(BaseModel):
    """A message: its code and arguments, and its text and hint in the language of the request."""

    model_config = ConfigDict(json_schema_extra={_MARK: True})
    #: Names of the fields that contain the text.
    text_fields: ClassVar[tuple[str, ...]] = ("text",)

    code: str = Field(
        description="Code that identifies the message; its arguments are in the schema Message"
    )
    arguments: dict[str, Any] = Field(
        description="Arguments by name, to be inserted into the text; their types for each code "
        "are in the schema Message"
    )
    text: str = Field(
        description="Text of the message, in the language of `Accept-Language` or in English"
    )
    hint: str = Field(
        description="What the user can do, in the same language; empty if there is no hint"
    )

    @model_validator(mode="before")
    @classmethod
    def _render(cls, message: Any) -> Any:
        """Return a message as JSON data with its text and its hint.

        pydantic calls this function first, and then validates the returned data.

        ``message``: the message as a ``Message``, or as JSON data.
        """
        data = with_text(message)
        return {**data, **dict.fromkeys(cls.text_fields, data["text"])}


class MessageIn(BaseModel):
    """A message from a gateway; text and hint are used if the server does not know the code."""

    model_config = ConfigDict(extra="forbid")

    code: str = Field(
        max_length=100,
        description="Code that identifies the message; if the server does not know it, `text` and "
        "`hint` are shown",
    )
    arguments: dict[str, Any] = Field(
        default={},
        description="Arguments by name, to be inserted into the text; their types for each code "
        "are in the schema Message",
    )
    text: str = Field(
        default="",
        max_length=2000,
        description="Text of the message in English, shown if the server does not know the code",
    )
    hint: str = Field(
        default="",
        max_length=2000,
        description="What the user can do, in English, shown if the server does not know the "
        "code; empty for no hint",
    )

    @model_validator(mode="after")
    def _check(self) -> Self:
        """Return this model unchanged if it is valid.

        Raises ``PydanticCustomError``: the message is too long, or its arguments cannot be inserted
        into the text of the code.
        """
        try:
            size = len(json.dumps(with_text(self.message)))
        except (TypeError, ValueError, ArithmeticError, RecursionError) as error:
            raise field_error("field.bad-arguments", name=self.code) from error
        if size > _LONGEST:
            raise field_error("field.too-long", most=_LONGEST)
        return self

    @property
    def message(self) -> Message:
        """The received message as a ``Message``.

        If the server does not have the code, or the code has other arguments, the result has the
        code ``stored.text`` and contains the received ``text`` and ``hint``.
        """
        return from_json(self.model_dump())


def describe_codes(schemas: dict[str, Any]) -> None:
    """Add the schemas ``MessageCode`` and ``Message`` to an OpenAPI document.

    ``MessageCode`` is a string with the list of all codes in ``x-known-values``; the field ``code``
    of messages in responses becomes a reference to it.  It is no enumeration, because a client that
    was generated before a code existed would refuse the response.  ``Message`` is the union of one
    object per code with the types of its arguments.

    Parameters
    ----------
    schemas
        Schemas of the document, by name; changed in place.
    """
    for schema in schemas.values():
        if schema.pop(_MARK, False):
            schema["properties"]["code"] = {
                "$ref": "#/components/schemas/MessageCode",
                "description": schema["properties"]["code"]["description"],
            }
    schemas["MessageCode"] = {
        "type": "string",
        "description": "Code of a message. Newer servers have further codes.",
        _KNOWN: list(CODES),
    }
    schemas["Message"] = {
        "description": "A code with its arguments.",
        "oneOf": [
            {
                "type": "object",
                "properties": {
                    "code": {"type": "string", "const": code},
                    "arguments": {
                        "type": "object",
                        "properties": {name: _TYPES[kind] for name, kind in kinds.items()},
                        "required": list(kinds),
                    },
                },
                "required": ["code", "arguments"],
            }
            for code, kinds in CODES.items()
        ],
    }
