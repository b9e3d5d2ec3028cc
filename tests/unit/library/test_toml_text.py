"""Writing of TOML text: the standard library reads the same fields from it."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest

from knifetip.library import load
from knifetip.library.definition import Shelf, check_definition
from knifetip.library.toml_text import write_toml


@pytest.mark.parametrize(
    "fields",
    [
        {},
        {"a": 1, "b": -2.5e-7, "c": True, "d": 'x "y" \\ \n \x7f \0 刀', "e": []},
        {"list": [1.0, [2, 3], ["x"]], "a b": {"c.d": {"": 0}}, "after": 1},
        {"station": [{"n": 1, "tool": {"k": 1}}, {"n": 2, "pens": [{"w": 1}]}], "x": {"y": [{}]}},
        {"mixed": [{"a": 1}, 2, {"b": {"c": None, "d": 1}}, {}], "none": {}},
    ],
)
def test_written_fields_are_read_again(fields: dict[str, Any]) -> None:
    assert tomllib.loads(write_toml(fields)) == _without_none(fields)


def _without_none(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_none(one) for key, one in value.items() if one is not None}
    return [_without_none(one) for one in value] if isinstance(value, list) else value


@pytest.mark.parametrize(
    ("shelf", "name"), [(shelf, name) for shelf in Shelf for name in load.names(shelf)]
)
def test_entries_of_the_library_are_written_with_the_same_fields(shelf: Shelf, name: str) -> None:
    fields = tomllib.loads(load.library_text(shelf, name))
    text = write_toml(fields)
    assert tomllib.loads(text) == fields
    assert check_definition(shelf, name, text) == fields["title"]


def test_values_that_toml_does_not_have_are_refused() -> None:
    with pytest.raises(TypeError):
        write_toml({"a": [None]})


def test_a_lone_surrogate_becomes_a_question_mark() -> None:
    assert tomllib.loads(write_toml({"a": "\ud800"})) == {"a": "?"}
