"""Messages about invalid fields: their path, the value, and the values that are permitted."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Any, Literal

import pytest
from pydantic import Field

from knifetip.fields import LISTED, InvalidFields, Table, check_fields
from knifetip.messages import Message


class Side(StrEnum):
    LEFT = "left"
    RIGHT = "right"


class Knife(Table):
    kind: Literal["knife"]


class Wheel(Table):
    kind: Literal["wheel"]
    rim: float = 0.7


class Station(Table):
    lift: Literal["turn", "always"] = "turn"
    side: Annotated[Side, LISTED] = Side.LEFT
    tool: Annotated[Knife | Wheel, Field(discriminator="kind")] = Knife(kind="knife")


def fault(**fields: Any) -> tuple[Message, tuple[str, ...]]:
    with pytest.raises(InvalidFields) as refused:
        check_fields(Station, fields)
    return refused.value.faults[0], refused.value.source


@pytest.mark.parametrize(
    ("fields", "path", "value", "known"),
    [
        ({"lift": "never"}, "lift", "'never'", ("'turn'", "'always'")),
        ({"lift": 3}, "lift", "3", ("'turn'", "'always'")),
        ({"side": "top"}, "side", "'top'", ("'left'", "'right'")),
        ({"tool": {"kind": "saw"}}, "tool.kind", "'saw'", ("'knife'", "'wheel'")),
    ],
    ids=["literal", "literal of another type", "enumeration", "kind"],
)
def test_a_wrong_choice_names_its_path_and_the_permitted_values(
    fields: dict[str, Any], path: str, value: str, known: tuple[str, ...]
) -> None:
    message, source = fault(**fields)
    assert message.code == "field.not-one-of"
    assert message.arguments == {"path": path, "value": value, "known": known}
    assert source == (path.partition(".")[0],)


def test_a_kind_that_is_missing_is_named() -> None:
    message, _ = fault(tool={"rim": 0.5})
    assert message.code == "field.no-kind"
    assert message.arguments["path"] == "tool"
    assert "kind" in message.arguments["field"]


def test_a_field_of_the_chosen_kind_has_no_kind_in_its_path() -> None:
    message, source = fault(tool={"kind": "wheel", "rim": "thin"})
    assert (message.code, message.arguments["path"]) == ("field.not-a-number", "tool → rim")
    assert source == ("tool", "rim")
