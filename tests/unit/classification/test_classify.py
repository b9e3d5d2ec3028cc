"""Line types by the rules of a profile, overrides, and questions."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest

from knifetip.classification.classify import apply_overrides, classify
from knifetip.classification.questions import list_questions
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.model.profile import LineRule, LineRules
from tests.support.classification import side_by_side, words
from tests.support.drawings import Style


def under(profile: str, *rows: Style) -> list[str]:
    return words(classify(side_by_side(rows), load.profile(profile)))


RULES = LineRules(
    "house",
    "",
    (
        LineRule(LineType.PERFORATION, colour=(1,), linetype=("DASH*",)),
        LineRule(LineType.CUT, layer=("die", "knife"), colour=(1, 7)),
        LineRule(LineType.CREASE, layer=("die",)),
        LineRule(LineType.HALF_CUT, colour=(4,)),
        LineRule(LineType.IGNORED, entity=("CIRCLE",)),
    ),
)


def test_the_first_rule_that_matches_decides() -> None:
    dieline = classify(
        side_by_side(
            [
                ("DIE", 1, "DASHED"),
                ("DIE", 1, "CONTINUOUS"),
                ("die", 3, "CONTINUOUS"),
                ("other", 4, "CONTINUOUS"),
                ("other", 3, "CONTINUOUS"),
            ]
        ),
        RULES,
    )
    assert words(dieline) == [
        "perforation",
        "cut",
        "crease",
        "half-cut",
        "unclassified",
    ]
    assert dieline.confidence.tolist() == [0.8, 1.0, 0.95, 0.8, 0.0]
    assert [str(dieline.rules[row]) for row in dieline.rule] == [
        'profile house: colour 1, line style "DASH*"',
        'profile house: layer "die", colour 1',
        'profile house: layer "die"',
        "profile house: colour 4",
        "no rule of the profile house matches the edge",
    ]


def test_the_dieline_keeps_the_edges_of_the_drawing_in_their_order() -> None:
    sheet = side_by_side([("die", 1, "C"), ("x", 4, "C"), ("die", 2, "C")], bulge=[0.0, 0.5, -1.0])
    dieline = classify(sheet, RULES)
    np.testing.assert_array_equal(dieline.ends, sheet.ends)
    np.testing.assert_array_equal(dieline.bulge, [0.0, 0.5, -1.0])
    np.testing.assert_array_equal(dieline.source, [0, 1, 2])


def test_a_rule_may_match_the_kind_of_entity() -> None:
    sheet = side_by_side([("x", 3, "C"), ("x", 3, "C")], kinds=["CIRCLE", "LINE"])
    assert words(classify(sheet, RULES)) == ["ignored", "unclassified"]


def test_a_true_colour_counts_as_an_index_only_where_it_is_that_colour() -> None:
    sheet = side_by_side(
        [("die", 7, "C"), ("knife", 7, "C"), ("knife", 1, "C"), ("knife", 3, "C")],
        true_colour=[0x00FFFF, 0xFF8000, 0xFF8000, 0xFF0000],
    )
    dieline = classify(sheet, RULES)
    assert words(dieline) == ["crease", "unclassified", "unclassified", "cut"]
    assert str(dieline.rules[dieline.rule[3]]) == 'profile house: layer "knife", colour 1'


def test_an_empty_drawing_has_an_empty_dieline_and_no_questions() -> None:
    sheet = side_by_side([], ends=np.zeros((0, 2, 2)))
    dieline = classify(sheet, RULES)
    assert len(dieline) == 0
    assert list_questions(sheet, dieline) == []


def test_a_rule_may_leave_edges_unclassified() -> None:
    rules = LineRules(
        "careful",
        "",
        (
            LineRule(LineType.UNCLASSIFIED, layer=("NoCut",)),
            LineRule(LineType.CUT, colour=(1,)),
        ),
    )
    sheet = side_by_side([("NoCut", 1, "C"), ("0", 1, "C")])
    dieline = classify(sheet, rules)
    assert words(dieline) == ["unclassified", "cut"]
    assert dieline.confidence.tolist() == [0.0, 0.8]
    assert [question.layer for question in list_questions(sheet, dieline)] == ["NoCut"]


def test_a_hundred_thousand_edges_have_the_type_of_their_style() -> None:
    n = 100_000
    rows = [("die", 1, "C"), ("die", 2, "C"), ("none", 9, "C"), ("none", 4, "C")] * (n // 4)
    dieline = classify(side_by_side(rows), RULES)
    expected = [LineType.CUT, LineType.CREASE, LineType.UNCLASSIFIED, LineType.HALF_CUT]
    np.testing.assert_array_equal(dieline.line_type.reshape(-1, 4), [expected] * (n // 4))
    assert len(dieline.rules) == 4


# ── overrides ────────────────────────────────────────────────────────────────────────────────────


def test_an_override_comes_last_and_is_the_reason() -> None:
    dieline = classify(side_by_side([("die", 1, "C"), ("none", 9, "C"), ("die", 2, "C")]), RULES)
    given = np.array([LineType.V_GROOVE, LineType.CUT, NO_OVERRIDE], np.uint8)
    changed = apply_overrides(dieline, given)
    assert words(changed) == ["v-groove", "cut", "crease"]
    assert [str(changed.rules[row]) for row in changed.rule] == [
        "the user set the line type of the edge",
        "the user set the line type of the edge",
        'profile house: layer "die"',
    ]
    assert changed.confidence.tolist() == [1.0, 1.0, 0.95]
    assert words(dieline) == ["cut", "unclassified", "crease"]


def test_overriding_twice_adds_one_reason() -> None:
    dieline = classify(side_by_side([("die", 1, "C")]), RULES)
    once = apply_overrides(dieline, np.array([LineType.CUT], np.uint8))
    twice = apply_overrides(once, np.array([LineType.CREASE], np.uint8))
    assert [str(rule) for rule in twice.rules].count("the user set the line type of the edge") == 1
    assert words(twice) == ["crease"]


def test_nothing_overridden_is_the_same_dieline() -> None:
    dieline = classify(side_by_side([("die", 1, "C")]), RULES)
    assert apply_overrides(dieline, np.array([NO_OVERRIDE], np.uint8)) is dieline


@pytest.mark.parametrize(("given", "said"), [([1, 1], "overrides"), ([77], "not a line type")])
def test_overrides_that_do_not_fit_are_refused(given: list[int], said: str) -> None:
    dieline = classify(side_by_side([("die", 1, "C")]), RULES)
    with pytest.raises(ValueError, match=said):
        apply_overrides(dieline, np.array(given, np.uint8))


# ── questions ────────────────────────────────────────────────────────────────────────────────────


def asked(*rows: Style, **more: Any) -> list[str]:
    sheet = side_by_side(rows, **more)
    return [question.text for question in list_questions(sheet, classify(sheet, RULES))]


def test_one_question_for_each_layer_colour_and_linetype() -> None:
    sheet = side_by_side(
        [
            ("b", 2, "C"),
            ("a", 2, "C"),
            ("b", 2, "C"),
            ("b", 3, "C"),
            ("b", 2, "DASHED"),
            ("die", 1, "C"),
        ]
    )
    put = list_questions(sheet, classify(sheet, RULES))
    assert [(q.layer, q.colour, q.edges) for q in put] == [
        ("b", 2, (0, 2)),
        ("a", 2, (1,)),
        ("b", 3, (3,)),
        ("b", 2, (4,)),
    ]
    assert {q.kind for q in put} == {"line-type"}


def test_very_many_layers_are_asked_about_together() -> None:
    names = ["".join(letters) for letters in product("xyz", repeat=5)]
    few = side_by_side([(name, 2, "C") for name in names[:200]])
    assert len(list_questions(few, classify(few, RULES))) == 200
    many = side_by_side([(name, 2 + at % 2, "C") for at, name in enumerate(names)])
    put = list_questions(many, classify(many, RULES))
    assert [(q.layer, q.colour, len(q.edges)) for q in put] == [
        ("xxxxx … zzzzz", 2, 122),
        ("xxxxx … zzzzz", 3, 121),
    ]


def test_very_many_layers_and_colours_are_asked_about_together() -> None:
    names = ["".join(letters) for letters in product("xyz", repeat=5)]
    sheet = side_by_side([(name, 12 + at, "C") for at, name in enumerate(names)])
    (question,) = list_questions(sheet, classify(sheet, RULES))
    assert question.edges == tuple(range(243))
    assert 'layer "xxxxx … zzzzz" (colour 12 …, line style C)' in question.text


def test_a_question_gives_number_length_and_position() -> None:
    assert asked(("b", 2, "C"), ("b", 2, "C")) == [
        '2 edges on layer "b" (colour 2, line style C) have no line type: total length 20.0 mm, '
        "extent 30.0 × 0.0 mm, lower left corner at X 0.0, Y 0.0. "
        "Which line type should these edges get?"
    ]


def test_without_a_unit_lengths_are_in_units_of_the_file() -> None:
    assert "total length 10.0 units of the file" in asked(("b", 2, "C"), unit="")[0]


def test_true_colours_are_asked_separately_and_named() -> None:
    texts = asked(("b", 7, "C"), ("b", 7, "C"), true_colour=[0xFF8000, 0x0080FF])
    assert len(texts) == 2
    assert "colour #ff8000" in texts[0]
    assert "colour #0080ff" in texts[1]


def test_a_hostile_name_cannot_steer_a_terminal() -> None:
    text = asked(("\x1b[2J" + "x" * 500, 2, "C"))[0]
    assert "\x1b" not in text
    assert len(text) < 300


def test_the_choices_are_all_line_types_but_unclassified() -> None:
    sheet = side_by_side([("b", 2, "C")])
    (question,) = list_questions(sheet, classify(sheet, RULES))
    assert sorted(question.choices) == [
        "combi",
        "crease",
        "cut",
        "half-cut",
        "ignored",
        "perforation",
        "v-groove",
    ]


@pytest.mark.parametrize(
    ("row", "first"),
    [
        (("my fold lines", 2, "C"), "crease"),
        (("outline of tray", 2, "C"), "cut"),
        (("half deep", 2, "C"), "half-cut"),
        (("groove 45", 2, "C"), "v-groove"),
        (("perf 3-2", 2, "C"), "perforation"),
        (("GEOMETRY-ENGRAVING", 2, "C"), "ignored"),
        (("Cut Lazer out line", 2, "C"), "cut"),
        (("b", 2, "CENTER2"), "ignored"),
        (("b", 2, "HIDDEN"), "crease"),
    ],
)
def test_a_name_or_linetype_with_a_meaning_is_the_first_choice(row: Style, first: str) -> None:
    sheet = side_by_side([row, ("die", 1, "C")])
    (question,) = list_questions(sheet, classify(sheet, RULES))
    assert question.choices[0] == first


def test_the_outline_is_cut_and_what_lies_inside_is_asked_with_the_likeliest_first() -> None:
    square = [[0, 0], [100, 0], [100, 60], [0, 60]]
    ends = [[square[i], square[(i + 1) % 4]] for i in range(4)]
    ends += [[[30, 0], [30, 60]], [[40, 20], [50, 20]]]
    sheet = side_by_side(
        [("a", 2, "C")] * 4 + [("b", 2, "C"), ("c", 2, "C")],
        ends=ends,
        bulge=[0] * 5 + [1],
    )
    dieline = classify(sheet, RULES)
    assert words(dieline)[:4] == ["cut"] * 4
    assert str(dieline.rules[dieline.rule[0]]) == "the edge closes the outline of a blank"
    put = list_questions(sheet, dieline)
    assert words(dieline)[4] == "crease"
    assert [(q.layer, q.choices[0]) for q in put] == [("c", "cut")]


# ── the shipped profiles ─────────────────────────────────────────────────────────────────────────

DEFAULT = {
    "cut": (
        "cut CUT CUTS Cut LT_CUT DIECUT TRIM CutContour THRU-CUT IV_OUTER_PROFILE "
        "IV_INTERIOR_PROFILES body holes outer PERIMETER front_outsideCutPath cutexternal "
        "cutinternal Schnitt Stanzkontur coupant taglio Bicak BIÇAK bıçak 刀线 模切线 裁切线"
    ),
    "crease": (
        "crease CREASE FOLDS SCORE SCORE2 joints hinge_mountain hinge_valley inner_up inner_down "
        "LT_FOLD CreaseLine IV_BEND IV_BEND_DOWN Rilllinie Rilllinien rainant pilyaj cordonatura "
        "биговка БИГОВКА 压痕线"
    ),
    "v-groove": "V-cut V-GROOVE VGROOVE V_GROOVE v-groove",
    "perforation": "perforation PERF perforaj",
    "half-cut": "HALFCUT half-cut KISS KISSCUT kiss-cut mi-chair 半刀",
    "combi": "combination Combi perfo-rainant",
    "ignored": (
        "dimensions DIMENSION DIM BEMASSUNG INFO top_labelLayer text notes cotation LT_COTATION "
        "FOIL SPOTUV Bleed Glue Mask Registration Reference IV_TANGENT IV_ROLL IV_ARC_CENTERS "
        "IV_TOOL_CENTER"
    ),
}


@pytest.mark.parametrize(
    ("name", "kind"),
    [(name, kind) for kind, names in DEFAULT.items() for name in names.split()],
)
def test_the_default_matches_this_name_in_any_colour(name: str, kind: str) -> None:
    rows = [(name, colour, "CONTINUOUS") for colour in (1, 2, 3, 5, 7)]
    assert under("default", *rows) == [kind] * 5


@pytest.mark.parametrize("name", ["Kiss Cut", "kiss cut"])
def test_the_default_matches_names_of_two_words(name: str) -> None:
    assert under("default", (name, 7, "CONTINUOUS")) == ["half-cut"]


@pytest.mark.parametrize(
    "name",
    [
        "NoCut",
        "Cutout",
        "SCHNITTKANTEN",
        "SCHNITTLINIEN",
        "Cut Lazer out line",
        "GEOMETRY-ENGRAVING",
        "Faltmarken",
        "Bevel cut",
        "fustella",
        "points",
        "Default",
        "0",
        "Drafting",
        "10",
        "20",
        "C00-00-00-BLACK",
        "CFF-00-00",
        "[CUT]",
        "CUT?",
        "C*",
    ],
)
def test_the_default_asks_about_this_name(name: str) -> None:
    rows = [(name, colour, style) for colour in (2, 3, 5) for style in ("CONTINUOUS", "DASHED")]
    assert under("default", *rows) == ["unclassified"] * 6


@pytest.mark.parametrize(
    ("layer", "colour", "kind"),
    [
        ("Design", 1, "cut"),
        ("Design", 2, "crease"),
        ("Design", 3, "unclassified"),
        ("10", 7, "cut"),
        ("20", 1, "crease"),
        ("10", 1, "unclassified"),
        ("20", 7, "unclassified"),
    ],
)
def test_the_default_has_rules_for_pairs_of_layer_and_colour(
    layer: str, colour: int, kind: str
) -> None:
    dieline = classify(side_by_side([(layer, colour, "CONTINUOUS")]), load.profile("default"))
    assert words(dieline) == [kind]
    assert dieline.confidence[0] == (0.0 if kind == "unclassified" else 1.0)


def test_the_default_decides_nothing_by_a_bare_colour_or_line_style() -> None:
    for rule in load.profile("default").rules:
        assert rule.layer or all(name.startswith("CF2 ") for name in rule.linetype), str(
            rule.conditions
        )


S, D = "CONTINUOUS", "DASHED"


@pytest.mark.parametrize(
    ("profile", "expected"),
    [
        (
            "red-cut-blue-crease",
            {
                (1, S): "cut",
                (1, D): "perforation",
                (5, D): "crease",
                (4, S): "half-cut",
                (2, S): "ignored",
                (3, S): "ignored",
                (7, S): "unclassified",
            },
        ),
        (
            "red-crease-black-cut",
            {(1, S): "crease", (7, S): "cut", (5, S): "unclassified"},
        ),
        (
            "pinits",
            {
                (1, S): "cut",
                (3, S): "crease",
                (2, S): "perforation",
                (5, S): "combi",
                (255, S): "ignored",
            },
        ),
        ("open-dieline", {(7, S): "cut", (3, S): "crease", (2, S): "half-cut"}),
        ("lightburn", {(1, S): "cut", (5, S): "crease", (7, S): "unclassified"}),
        (
            "boxes-py",
            {(7, S): "cut", (5, S): "cut", (1, S): "ignored", (3, S): "unclassified"},
        ),
        ("gds2vec", {(7, S): "cut", (3, S): "unclassified", (4, S): "unclassified"}),
        (
            "turkish",
            {
                (1, S): "cut",
                (3, S): "crease",
                (2, S): "perforation",
                (34, S): "combi",
                (5, S): "unclassified",
            },
        ),
        ("german", {(7, S): "cut", (5, D): "crease", (5, S): "unclassified"}),
        (
            "magenta-cut-cyan-crease",
            {
                (6, S): "cut",
                (4, D): "crease",
                (6, D): "unclassified",
                (4, S): "unclassified",
            },
        ),
        ("solid-cut-dashed-crease", {(9, S): "cut", (9, D): "crease"}),
    ],
)
def test_a_named_profile_has_its_own_colours(
    profile: str, expected: dict[tuple[int, str], str]
) -> None:
    assert under(profile, *[("0", *style) for style in expected]) == list(expected.values())


@pytest.mark.parametrize("profile", load.names("profiles"))
def test_in_every_profile_a_meaningful_layer_name_outweighs_its_colour(
    profile: str,
) -> None:
    rows = [("CREASE", 1, S), ("CREASE", 7, S), ("CUT", 5, D), ("DIMENSION", 7, S)]
    assert under(profile, *rows) == ["crease", "crease", "cut", "ignored"]


def test_layers_named_after_their_colour_need_a_profile_with_their_names() -> None:
    rows = [("C00-00-00-BLACK", 7, S), ("CFF-00-00", 1, S), ("10", 3, S), ("20", 3, S)]
    assert under("default", *rows) == ["unclassified"] * 4
    assert under("red-crease-black-cut", *rows) == ["cut", "crease", "cut", "crease"]
