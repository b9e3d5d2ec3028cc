"""Rules that are proposed for overrides, and overrides that yield none."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest

from knifetip.classification.classify import classify
from knifetip.classification.rule_proposals import propose_rules
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.model.profile import LineRule, LineRules, ProposedRule
from tests.support.classification import side_by_side

C = "CONTINUOUS"
NONE = LineRules("none", "", ())


def proposals(
    rows: list[tuple[str, int, str]], overridden: dict[int, LineType], profile: LineRules = NONE
) -> list[ProposedRule]:
    sheet = side_by_side(rows)
    overrides = np.full(len(rows), NO_OVERRIDE, np.uint8)
    for row, kind in overridden.items():
        overrides[row] = kind
    return propose_rules(sheet, classify(sheet, profile), overrides, profile)


def test_a_layer_with_a_name_is_a_rule_by_itself() -> None:
    rows = [("Rille", 1, C), ("Rille", 1, C), ("other", 7, C)]
    (one,) = proposals(rows, {0: LineType.CREASE, 1: LineType.CREASE})
    assert one.rule == LineRule(LineType.CREASE, layer=("Rille",))
    assert (one.explains, one.changes) == ((0, 1), ())


def test_a_meaningless_layer_is_combined_with_a_colour() -> None:
    rows = [("Design", 1, C), ("Design", 7, C)]
    (one,) = proposals(rows, {0: LineType.CREASE})
    assert str(one.rule.conditions) == 'layer "Design", colour 1'


def test_undecided_edges_are_listed_as_changes() -> None:
    rows = [("X", 1, C), ("X", 1, C), ("X", 1, C)]
    (one,) = proposals(rows, {0: LineType.CREASE})
    assert (one.explains, one.changes) == ((0,), (1, 2))


def test_rules_do_not_contradict_edges_without_override() -> None:
    """Layer X has an edge that remains a cut, so the rule must include the colour."""
    rows = [("X", 1, C), ("X", 7, C)]
    profile = LineRules("own", "", (LineRule(LineType.CUT, layer=("X",)),))
    (one,) = proposals(rows, {0: LineType.CREASE}, profile)
    assert str(one.rule.conditions) == 'layer "X", colour 1'


def test_overrides_that_attributes_cannot_separate_yield_no_rule() -> None:
    assert proposals([("X", 1, C), ("X", 1, C)], {0: LineType.CREASE, 1: LineType.CUT}) == []


def test_one_colour_on_many_layers_is_one_rule() -> None:
    rows = [("a1", 1, C), ("b1", 1, C), ("d1", 1, C), ("e1", 7, C)]
    (one,) = proposals(rows, dict.fromkeys(range(3), LineType.CREASE))
    assert one.rule == LineRule(LineType.CREASE, colour=(1,))


def test_rules_of_the_profile_are_not_proposed() -> None:
    profile = LineRules("own", "", (LineRule(LineType.CUT, layer=("X",)),))
    assert proposals([("X", 1, C)], {0: LineType.CUT}, profile) == []


def test_rules_that_explain_most_overrides_come_first() -> None:
    rows = [("a1", 1, C), ("b1", 3, C), ("b1", 3, C)]
    first, second = proposals(rows, {0: LineType.CUT, 1: LineType.CREASE, 2: LineType.CREASE})
    assert (first.rule.line_type, first.explains) == (LineType.CREASE, (1, 2))
    assert (second.rule.line_type, second.explains) == (LineType.CUT, (0,))


def test_a_layer_named_like_a_pattern_matches_only_itself() -> None:
    rows = [("[CUT]*", 1, C), ("CUT x", 7, C)]
    (one,) = proposals(rows, {0: LineType.CREASE})
    profile = LineRules("own", "", (one.rule,))
    assert classify(side_by_side(rows), profile).line_type.tolist() == [LineType.CREASE, 0]


def test_proposed_rules_give_the_overrides_when_they_come_first() -> None:
    rows = [("Design", colour, C) for colour in (1, 2, 3, 1, 2)]
    base = load.profile("default")
    overridden = {0: LineType.CREASE, 1: LineType.CUT, 3: LineType.CREASE, 4: LineType.CUT}
    found = proposals(rows, overridden, base)
    own = LineRules("own", "Ours", tuple(one.rule for one in found) + base.rules)
    assert classify(side_by_side(rows), own).line_type[[0, 1, 3, 4]].tolist() == [2, 1, 2, 1]
    again = load.parse_profile("own", tomllib.loads(load.profile_toml(own, "default")))
    assert again.rules == own.rules


def test_overrides_of_another_length_are_refused() -> None:
    sheet = side_by_side([("X", 1, C)])
    with pytest.raises(ValueError, match="overrides"):
        propose_rules(sheet, classify(sheet, NONE), np.zeros(2, np.uint8), NONE)
