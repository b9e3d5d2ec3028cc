from __future__ import annotations

import pytest

from knifetip.errors import KnifetipError, ProfileError
from knifetip.library import load, own
from knifetip.model.dieline import LineType

OURS = """title = "Acme"
extends = "german"
overrules = true

[[rule]]
type = "crease"
layer = "INNER*"
colour = [1, "#00aeef"]
"""


def test_a_customers_rules_come_before_those_that_they_extend() -> None:
    rules = own.parsed("acme", OURS)
    assert (rules.name, rules.title) == ("acme", "Acme")
    assert rules.rules[0].line_type is LineType.CREASE
    assert rules.rules[1:] == load.profile("german").rules
    assert own.inherited(own.parts(OURS), rules)[:2] == [False, True]


def test_what_is_written_is_read_back_as_the_same_rules() -> None:
    written = own.written("acme", own.parts(OURS))
    assert own.parsed("acme", written) == own.parsed("acme", OURS)


def test_a_profile_that_extends_and_comes_last_says_so() -> None:
    after = OURS.replace("overrules = true", "overrules = false")
    rules = own.parsed("acme", after)
    assert own.inherited(own.parts(after), rules)[-2:] == [True, False]
    assert own.parsed("acme", own.written("acme", own.parts(after))) == rules


@pytest.mark.parametrize("name", load.names("profiles"))
def test_the_text_of_a_shipped_profile_says_its_rules(name: str) -> None:
    assert own.parsed(name, own.text_of(name)) == load.profile(name)


@pytest.mark.parametrize("name", ["a", "acme-2_b", "0" * 64])
def test_a_plain_name_is_one(name: str) -> None:
    assert own.checked_name(name) == name


@pytest.mark.parametrize("name", ["", "A", "a.toml", "../a", "a/b", "ä", "-a", "0" * 65, "a\n"])
def test_a_path_is_no_name(name: str) -> None:
    with pytest.raises(ProfileError) as caught:
        own.checked_name(name)
    assert caught.value.source == ("name",)


@pytest.mark.parametrize(
    "text",
    [
        "rule = " + "[" * 100_000,
        "rule = " + "{a = " * 2_000,
        "a." * 20_000 + "b = 1",
        'title = "' + "x" * own.LONGEST,
        "é" * own.LONGEST,
        "\ud800",
    ],
    ids=["deep", "nested tables", "dotted", "long", "long in UTF-8", "half a pair"],
)
def test_hostile_text_is_refused_at_once(text: str) -> None:
    with pytest.raises(KnifetipError) as caught:
        own.parsed("hostile", text)
    assert caught.value.hint
