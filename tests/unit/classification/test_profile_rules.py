"""Patterns of a profile matched against names in a drawing."""

from __future__ import annotations

import pytest

from knifetip.classification.decision.profile_rules import (
    first_match,
    fold_name,
    narrow_rule,
    rule_confidence,
)
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRule


def test_no_patterns_match_everything() -> None:
    assert first_match((), ("CUT", "")).tolist() == [0, 0]


def test_the_first_pattern_that_matches_is_returned() -> None:
    names = ("cut", "outer_cut", "CREASE", "CUTS")
    assert first_match(("*_CUT", "Cuts", "C*"), names).tolist() == [2, 0, 2, 1]


def test_a_plain_pattern_matches_whole_names_and_ignores_case() -> None:
    assert first_match(("CUT",), ("cut", "Cut", " CUT ", "NoCut", "Cutout")).tolist() == [
        0,
        0,
        0,
        -1,
        -1,
    ]


def test_brackets_in_a_layer_name_are_literal() -> None:
    assert first_match(("[CUT]",), ("[CUT]", "C", "U")).tolist() == [-1, 0, 0]
    assert first_match(("[[]CUT]",), ("[CUT]", "CUT")).tolist() == [0, -1]


def test_a_star_crosses_dots_and_newlines_in_hostile_names() -> None:
    assert first_match(("*_cut",), ("a.b\nc_cut",)).tolist() == [0]


def test_composed_and_decomposed_accents_are_equal() -> None:
    composed, decomposed = "bi\u00e7ak", "BIC\u0327AK"
    assert composed != decomposed.casefold()
    assert fold_name(composed) == fold_name(decomposed)


def test_a_pattern_with_many_stars_is_fast() -> None:
    assert first_match(("*a" * 30 + "b",), ("a" * 2000,)).tolist() == [-1]


@pytest.mark.parametrize(
    ("rule", "confidence"),
    [
        (LineRule(LineType.CUT, layer=("CUT",), colour=(1,)), 1.0),
        (LineRule(LineType.CUT, layer=("CUT",)), 0.95),
        (LineRule(LineType.CUT, layer=("CUT",), linetype=("DASHED",)), 0.95),
        (LineRule(LineType.CUT, colour=(1,)), 0.8),
        (LineRule(LineType.CUT, linetype=("DASHED",)), 0.8),
        (LineRule(LineType.CUT), 0.5),
    ],
)
def test_a_rule_on_name_and_colour_has_the_highest_confidence(
    rule: LineRule, confidence: float
) -> None:
    assert rule_confidence(rule) == confidence


def test_a_narrowed_rule_has_only_the_patterns_that_matched() -> None:
    rule = LineRule(LineType.CREASE, ("FOLD", "SCORE"), (1, 5), ("DASHED", "HIDDEN"))
    assert narrow_rule(rule, 1, 5, 0, 0).conditions.arguments["conditions"] == (
        Message("rule.layer", patterns=['"SCORE"']),
        Message("rule.colour", colours=["5"]),
        Message("rule.linetype", patterns=['"DASHED"']),
    )
