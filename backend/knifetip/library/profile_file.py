"""profile_file: a classification profile's TOML: a title and a list of ``[[rule]]``.

It comes from anywhere, so it is short, and names nothing outside the library.
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

from knifetip.library.files import Table
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRule

MOST_RULES: Final = 500
MOST_PATTERNS: Final = 500  #: of one condition
LONGEST_PATTERN: Final = 255  #: as long as a layer's name may be
LONGEST_TITLE: Final = 200


def _as_list(value: Any) -> Any:
    return value if isinstance(value, list) else [value]


def _colour(value: Any) -> int | str:
    """Return a colour: an index, or a true colour as text."""
    if isinstance(value, str) and re.fullmatch("#[0-9a-fA-F]{6}", value):
        return value
    if isinstance(value, bool) or not isinstance(value, int):
        # pydantic collects ValueErrors; a TypeError would be ours.
        raise ValueError(f'is {repr(value)[:80]}, not a whole number or "#rrggbb"')  # noqa: TRY004
    if not 0 < value < 256:
        raise ValueError(f"is {value}, and must lie in 1 … 255")
    return value


def _line_type(value: str) -> str:
    try:
        return LineType.of(value).word
    except ValueError as reason:
        raise ValueError(f"is {value[:80]!r}: {reason}") from None


_COLOUR_SCHEMA: Final = {
    "anyOf": [
        {"type": "integer", "minimum": 1, "maximum": 255},
        {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$"},
    ]
}
Colour = Annotated[Any, PlainValidator(_colour), WithJsonSchema(_COLOUR_SCHEMA)]
Pattern = Annotated[str, StringConstraints(max_length=LONGEST_PATTERN)]
#: One value, or a list of them.
Patterns = Annotated[
    list[Pattern],
    BeforeValidator(_as_list, json_schema_input_type=Pattern | list[Pattern]),
    Field(max_length=MOST_PATTERNS),
]
Colours = Annotated[
    list[Colour],
    BeforeValidator(_as_list, json_schema_input_type=Colour | list[Colour]),
    Field(max_length=MOST_PATTERNS),
]


class RuleTable(Table):
    """If all that it names matches, an edge has its line type."""

    type: Annotated[str, AfterValidator(_line_type)] = Field(
        json_schema_extra={"enum": [kind.word for kind in LineType]}
    )
    layer: Patterns = Field([])
    colour: Colours = Field([])
    linetype: Patterns = Field([])
    entity: Patterns = Field([], description="LINE, ARC, TEXT …")
    block: Patterns = Field([], description="the block that holds the entity")

    def record(self) -> LineRule:
        """Return the rule."""
        return LineRule(
            line_type=LineType.of(self.type),
            layer=tuple(self.layer),
            colour=tuple(one for one in self.colour if isinstance(one, int)),
            true_colour=tuple(int(one[1:], 16) for one in self.colour if isinstance(one, str)),
            linetype=tuple(self.linetype),
            entity=tuple(self.entity),
            block=tuple(self.block),
        )


class ProfileFile(Table):
    """A classification profile: the words that a customer has for cut, crease and the rest."""

    title: Annotated[str, StringConstraints(pattern=r"\S", max_length=LONGEST_TITLE)]
    extends: str | None = Field(None, description="a shipped profile whose rules these extend")
    overrules: bool = Field(
        False, description="the rules come before those that they extend, not after"
    )
    rule: list[RuleTable] = Field(max_length=MOST_RULES)
