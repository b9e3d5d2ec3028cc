"""learn: what somebody's corrections teach, and what they do not."""

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


def taught(
    rows: list[tuple[str, int, str]], said: dict[int, LineType], profile: LineRules = NONE
) -> list[ProposedRule]:
    sheet = side_by_side(rows)
    overrides = np.full(len(rows), NO_OVERRIDE, np.uint8)
    for row, kind in said.items():
        overrides[row] = kind
    return propose_rules(sheet, classify(sheet, profile), overrides, profile)


def test_the_layer_alone_is_the_rule_where_it_has_a_name() -> None:
    rows = [("Rille", 1, C), ("Rille", 1, C), ("other", 7, C)]
    (one,) = taught(rows, {0: LineType.CREASE, 1: LineType.CREASE})
    assert one.rule == LineRule(LineType.CREASE, layer=("Rille",))
    assert (one.explains, one.changes) == ((0, 1), ())


def test_a_layer_that_means_nothing_is_named_with_its_colour() -> None:
    rows = [("Design", 1, C), ("Design", 7, C)]
    (one,) = taught(rows, {0: LineType.CREASE})
    assert one.rule.words == 'layer "Design", colour 1'


def test_edges_that_nobody_has_decided_are_counted_as_changed() -> None:
    rows = [("X", 1, C), ("X", 1, C), ("X", 1, C)]
    (one,) = taught(rows, {0: LineType.CREASE})
    assert (one.explains, one.changes) == ((0,), (1, 2))


def test_what_was_left_as_it_is_may_not_be_contradicted() -> None:
    """Layer X holds an edge that the profile cuts and nobody corrected: only the colour is left."""
    rows = [("X", 1, C), ("X", 7, C)]
    profile = LineRules("own", "", (LineRule(LineType.CUT, layer=("X",)),))
    (one,) = taught(rows, {0: LineType.CREASE}, profile)
    assert one.rule.words == 'layer "X", colour 1'


def test_what_attributes_cannot_tell_apart_teaches_nothing() -> None:
    assert taught([("X", 1, C), ("X", 1, C)], {0: LineType.CREASE, 1: LineType.CUT}) == []


def test_one_colour_on_many_layers_is_one_rule() -> None:
    rows = [("a1", 1, C), ("b1", 1, C), ("d1", 1, C), ("e1", 7, C)]
    (one,) = taught(rows, dict.fromkeys(range(3), LineType.CREASE))
    assert one.rule == LineRule(LineType.CREASE, colour=(1,))


def test_what_the_profile_says_already_is_not_proposed() -> None:
    profile = LineRules("own", "", (LineRule(LineType.CUT, layer=("X",)),))
    assert taught([("X", 1, C)], {0: LineType.CUT}, profile) == []


def test_two_types_make_two_rules_those_that_explain_most_first() -> None:
    rows = [("a1", 1, C), ("b1", 3, C), ("b1", 3, C)]
    first, second = taught(rows, {0: LineType.CUT, 1: LineType.CREASE, 2: LineType.CREASE})
    assert (first.rule.line_type, first.explains) == (LineType.CREASE, (1, 2))
    assert (second.rule.line_type, second.explains) == (LineType.CUT, (0,))


def test_a_layer_named_like_a_pattern_is_only_itself() -> None:
    rows = [("[CUT]*", 1, C), ("CUT x", 7, C)]
    (one,) = taught(rows, {0: LineType.CREASE})
    profile = LineRules("own", "", (one.rule,))
    assert classify(side_by_side(rows), profile).line_type.tolist() == [LineType.CREASE, 0]


def test_what_was_learned_gives_what_was_corrected_when_it_is_put_first() -> None:
    rows = [("Design", colour, C) for colour in (1, 2, 3, 1, 2)]
    base = load.profile("default")
    said = {0: LineType.CREASE, 1: LineType.CUT, 3: LineType.CREASE, 4: LineType.CUT}
    found = taught(rows, said, base)
    own = LineRules("own", "Ours", tuple(one.rule for one in found) + base.rules)
    assert classify(side_by_side(rows), own).line_type[[0, 1, 3, 4]].tolist() == [2, 1, 2, 1]
    again = load.parse_profile("own", tomllib.loads(load.profile_toml(own, "default")))
    assert again.rules == own.rules


def test_overrides_of_another_length_are_refused() -> None:
    sheet = side_by_side([("X", 1, C)])
    with pytest.raises(ValueError, match="overrides"):
        propose_rules(sheet, classify(sheet, NONE), np.zeros(2, np.uint8), NONE)
