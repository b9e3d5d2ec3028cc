"""messages: what carries a code with arguments and its English, and the union of all codes.

Answers keep their sentences; a client that has a catalogue of its own reads code and arguments.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Final

from pydantic import BaseModel, ConfigDict, Field, model_validator

from knifetip.messages import with_text
from knifetip.messages.codes import CODES, Kind

#: Marks schemas whose code is one of the union.
_MARK: Final = "x-message"
_UNION: Final = "#/components/schemas/Message"
_TYPES: Final[Mapping[Kind, dict[str, Any]]] = {
    "text": {"type": "string"},
    "count": {"type": "integer"},
    "number": {"type": "number"},
    "texts": {"type": "array", "items": {"type": "string"}},
    "message": {"$ref": _UNION},
    "message?": {"anyOf": [{"$ref": _UNION}, {"type": "null"}]},
    "messages": {"type": "array", "items": {"$ref": _UNION}},
}


class MessageOut(BaseModel):
    """Something to report: its code and arguments, and both in English."""

    model_config = ConfigDict(json_schema_extra={_MARK: True})
    #: Fields that hold the text under another name, which clients read.
    text_fields: ClassVar[tuple[str, ...]] = ("text",)

    code: str
    arguments: dict[str, Any] = Field(description="As the union Message has them for the code")
    text: str = Field(description="In English")
    hint: str = Field(description="What to do about it, in English; empty where nothing is to do")

    @model_validator(mode="before")
    @classmethod
    def _rendered(cls, given: Any) -> Any:
        """Take a message, or plain data that has one, and add its English."""
        plain = with_text(given)
        return {**plain, **dict.fromkeys(cls.text_fields, plain["text"])}


def describe_codes(schemas: dict[str, Any]) -> None:
    """Add all codes to the schemas of OpenAPI, and refer to them where they are used.

    ``MessageCode`` lists them; ``Message`` is the union of one object to a code, with the types of
    its arguments.
    """
    for schema in schemas.values():
        if schema.pop(_MARK, False):
            schema["properties"]["code"] = {"$ref": "#/components/schemas/MessageCode"}
    schemas["MessageCode"] = {"type": "string", "enum": list(CODES)}
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
