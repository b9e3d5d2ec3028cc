"""Writing of TOML text: the standard library reads the same fields from it."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest

from knifetip.library import load
from knifetip.library.definition import Shelf, check_definition
from knifetip.library.toml_text import read_toml, write_toml


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


@pytest.mark.parametrize("part", ["a", '"\\""', "'x y'"])
@pytest.mark.parametrize("dot", [".", " . "])
@pytest.mark.parametrize("form", ["{} = 1", "[{}]", "a = {{ {} = 1 }}"])
def test_keys_with_very_many_parts_are_refused_unread(
    part: str, dot: str, form: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert read_toml(form.format(dot.join([part] * 20)))
    monkeypatch.delattr("knifetip.library.toml_text.tomllib.loads")
    with pytest.raises(RecursionError):
        read_toml(form.format(dot.join([part] * 33)))


def test_long_texts_with_many_dots_are_read() -> None:
    text = "a.b = [" + "1.5, " * 100 + "]\nc = 'www.example.org'\n# and so on ....\n"
    assert read_toml(text) == {"a": {"b": [1.5] * 100}, "c": "www.example.org"}
