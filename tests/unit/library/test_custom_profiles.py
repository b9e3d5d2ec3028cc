from __future__ import annotations

import pytest

from knifetip.errors import KnifetipError, ProfileError
from knifetip.library import custom_profiles, load
from knifetip.model.dieline import LineType

OURS = """title = "Acme"
extends = "german"
overrules = true

[[rule]]
type = "crease"
layer = "INNER*"
colour = [1, "#00aeef"]
"""


def test_overruling_rules_come_before_inherited_ones() -> None:
    rules = custom_profiles.parse_text("acme", OURS)
    assert (rules.name, rules.title) == ("acme", "Acme")
    assert rules.rules[0].line_type is LineType.CREASE
    assert rules.rules[1:] == load.profile("german").rules
    assert custom_profiles.inherited_rules(custom_profiles.parse_fields(OURS), rules)[:2] == [
        False,
        True,
    ]


def test_written_profiles_have_the_same_rules() -> None:
    written = custom_profiles.profile_text("acme", custom_profiles.parse_fields(OURS))
    assert custom_profiles.parse_text("acme", written) == custom_profiles.parse_text("acme", OURS)


def test_rules_that_do_not_overrule_come_last() -> None:
    after = OURS.replace("overrules = true", "overrules = false")
    rules = custom_profiles.parse_text("acme", after)
    assert custom_profiles.inherited_rules(custom_profiles.parse_fields(after), rules)[-2:] == [
        True,
        False,
    ]
    assert (
        custom_profiles.parse_text(
            "acme", custom_profiles.profile_text("acme", custom_profiles.parse_fields(after))
        )
        == rules
    )


@pytest.mark.parametrize("name", load.names("profiles"))
def test_the_text_of_a_library_profile_has_its_rules(name: str) -> None:
    assert custom_profiles.parse_text(name, load.library_text("profiles", name)) == load.profile(
        name
    )


@pytest.mark.parametrize("name", ["a", "acme-2_b", "0" * 64])
def test_valid_names_are_returned(name: str) -> None:
    assert custom_profiles.check_name(name) == name


@pytest.mark.parametrize("name", ["", "A", "a.toml", "../a", "a/b", "ä", "-a", "0" * 65, "a\n"])
def test_paths_and_other_names_are_refused(name: str) -> None:
    with pytest.raises(ProfileError) as caught:
        custom_profiles.check_name(name)
    assert caught.value.source == ("name",)


@pytest.mark.parametrize(
    "text",
    [
        "rule = " + "[" * 100_000,
        "rule = " + "{a = " * 2_000,
        "a." * 20_000 + "b = 1",
        'title = "' + "x" * custom_profiles.MAX_BYTES,
        "é" * custom_profiles.MAX_BYTES,
        "\ud800",
    ],
    ids=["deep", "nested tables", "dotted", "long", "long in UTF-8", "half a pair"],
)
def test_hostile_text_is_refused(text: str) -> None:
    with pytest.raises(KnifetipError) as caught:
        custom_profiles.parse_text("hostile", text)
    assert caught.value.hint
