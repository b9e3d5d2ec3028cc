"""profile_file: the pydantic models of the TOML file of a classification profile.

Profiles come from users and are not trusted, so their size is limited, and they can refer only to
profiles of the library.
"""

from __future__ import annotations

import re
from typing import Annotated, Any, Final

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Field,
    PlainValidator,
    StringConstraints,
    WithJsonSchema,
)

from knifetip.fields import PartTable, Table, field_error
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRule

MAX_RULES: Final = 500
MAX_PATTERNS: Final = 500  #: largest number of patterns in one condition
MAX_PATTERN_LENGTH: Final = 255  #: characters; the longest layer name in a DXF
MAX_TITLE_LENGTH: Final = 200


def _as_list(value: Any) -> Any:
    return value if isinstance(value, list) else [value]


def _colour(value: Any) -> int | str:
    """Return a valid colour unchanged: a colour index 1…255, or a true colour "#rrggbb".

    Raises ``PydanticCustomError``: the value is not a colour.
    """
    if isinstance(value, str) and re.fullmatch("#[0-9a-fA-F]{6}", value):
        return value
    if isinstance(value, bool) or not isinstance(value, int):
        raise field_error("field.not-a-colour", value=repr(value)[:80])
    if not 0 < value < 256:
        raise field_error("field.not-a-colour", value=value)
    return value


def _check_not_blank(value: str) -> str:
    if not value.strip():
        raise field_error("field.blank")
    return value


def _line_type(value: str) -> str:
    try:
        return LineType.from_word(value).word
    except ValueError:
        raise field_error(
            "field.not-a-line-type", value=value[:80], known=[kind.word for kind in LineType]
        ) from None


_COLOUR_SCHEMA: Final = {
    "anyOf": [
        {"type": "integer", "minimum": 1, "maximum": 255},
        {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$"},
    ]
}
Colour = Annotated[Any, PlainValidator(_colour), WithJsonSchema(_COLOUR_SCHEMA)]
Pattern = Annotated[str, StringConstraints(max_length=MAX_PATTERN_LENGTH)]
#: One value, or a list of them.
Patterns = Annotated[
    list[Pattern],
    BeforeValidator(_as_list, json_schema_input_type=Pattern | list[Pattern]),
    Field(max_length=MAX_PATTERNS),
]
Colours = Annotated[
    list[Colour],
    BeforeValidator(_as_list, json_schema_input_type=Colour | list[Colour]),
    Field(max_length=MAX_PATTERNS),
]


class RuleTable(PartTable):
    """The TOML table of a rule; an edge that matches all conditions gets the line type ``type``."""

    type: Annotated[str, AfterValidator(_line_type)] = Field(
        json_schema_extra={"enum": [kind.word for kind in LineType]}
    )
    layer: Patterns = Field([])
    colour: Colours = Field([])
    linetype: Patterns = Field([])
    entity: Patterns = Field([], description="LINE, ARC, TEXT …")
    block: Patterns = Field([], description="name of the block that contains the entity")

    def record(self) -> LineRule:
        """Return the rule that the table describes."""
        return LineRule(
            line_type=LineType.from_word(self.type),
            layer=tuple(self.layer),
            colour=tuple(one for one in self.colour if isinstance(one, int)),
            true_colour=tuple(int(one[1:], 16) for one in self.colour if isinstance(one, str)),
            linetype=tuple(self.linetype),
            entity=tuple(self.entity),
            block=tuple(self.block),
        )


class ProfileFile(Table):
    """The fields of the TOML file of a classification profile: a title, and rules for line types.

    The conditions of a rule are layers, colours, dash patterns, entity types and blocks.
    """

    title: Annotated[
        str, StringConstraints(max_length=MAX_TITLE_LENGTH), AfterValidator(_check_not_blank)
    ] = Field(json_schema_extra={"pattern": r"\S"})
    extends: str | None = Field(None, description="profile of the library whose rules these extend")
    overrules: bool = Field(
        False, description="whether the rules come before those of the extended profile"
    )
    rule: list[RuleTable] = Field(max_length=MAX_RULES)
