"""Decisions from rules, shape, names and colours together, on simple blanks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.classification.answers import follow_answers
from knifetip.classification.classify import apply_overrides, classify
from knifetip.classification.questions import list_questions
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE
from tests.support.cartons.random_drawings import random_drawing
from tests.support.classification import box, classified, drawing_of, style, text, words
from tests.support.drawings import Style

Line = tuple[float, float, float, float]

BLANK = [(0, 0, 300, 0), (300, 0, 300, 200), (300, 200, 0, 200), (0, 200, 0, 0)]
FOLDS = [(100, 0, 100, 200), (200, 0, 200, 200)]
SLIT = [(20, 50, 60, 50)]
OUTSIDE = [(0, -30, 300, -30)]


def why(dieline: Dieline, row: int) -> str:
    return str(dieline.rules[dieline.rule[row]])


def test_with_meaningless_layers_shape_decides_the_outline_and_asks_the_rest() -> None:
    sheet = drawing_of((BLANK + FOLDS, style()))
    dieline = classified(sheet)
    assert words(dieline) == ["cut"] * 4 + ["unclassified"] * 2
    assert dieline.alternatives[dieline.rule[4]][0] == LineType.CREASE
    assert 0.5 <= dieline.confidence[4] < 0.8
    (question,) = list_questions(sheet, dieline)
    assert question.edges == (4, 5)
    assert question.choices[0] == "crease"
    assert "divides two panels" in question.text


@pytest.mark.parametrize(("cut", "crease"), [(1, 5), (7, 1), (1, 3), (7, 3)])
def test_the_convention_that_fits_the_shape_decides(cut: int, crease: int) -> None:
    dieline = classified(drawing_of((BLANK, style(colour=cut)), (FOLDS, style(colour=crease))))
    assert words(dieline) == ["cut"] * 4 + ["crease"] * 2
    assert "closed outline, and 2 of 2 lines inside the outline are folds" in why(dieline, 4)
    assert dieline.confidence[4] < dieline.confidence[0]


def test_the_only_style_that_only_divides_panels_is_creased() -> None:
    dieline = classified(drawing_of((BLANK, style(colour=30)), (FOLDS, style(colour=40))))
    assert words(dieline) == ["cut"] * 4 + ["crease"] * 2
    assert "only colour and line style whose edges do nothing but divide panels" in why(dieline, 4)


def test_two_styles_that_only_divide_panels_are_asked() -> None:
    """One of them may be perforated or half cut."""
    dieline = classified(
        drawing_of(
            (BLANK, style(colour=30)), (FOLDS[:1], style(colour=40)), (FOLDS[1:], style(colour=50))
        )
    )
    assert words(dieline) == ["cut"] * 4 + ["unclassified"] * 2


def test_folds_with_the_line_style_of_centre_lines_are_creased() -> None:
    dieline = classified(
        drawing_of((BLANK, style(colour=30)), (FOLDS, style(colour=40, linetype="CENTER")))
    )
    assert words(dieline) == ["cut"] * 4 + ["crease"] * 2


def test_an_unknown_layer_name_and_shape_decide_together() -> None:
    dieline = classified(drawing_of((BLANK, style("Découpe")), (FOLDS, style("Plis (2)"))))
    assert words(dieline) == ["cut"] * 4 + ["crease"] * 2
    assert 'the name of the layer of the edge contains "plis"' in why(dieline, 4)
    # Neither the name nor the shape alone decides.
    assert words(classified(drawing_of((FOLDS, style("Plis (2)"))))) == ["unclassified"] * 2


def test_a_negated_name_is_asked() -> None:
    dieline = classified(drawing_of((BLANK, style("NoCut")), (FOLDS, style("CREASE"))))
    assert words(dieline) == ["unclassified"] * 4 + ["crease"] * 2
    assert dieline.alternatives[dieline.rule[0]][0] == LineType.CUT


def test_swapped_cut_and_crease_are_asked_with_the_types_by_shape_first() -> None:
    sheet = drawing_of((BLANK, style("CREASE")), (FOLDS, style("CUT")))
    dieline = classified(sheet)
    assert words(dieline) == ["unclassified"] * 6
    assert "edges of the closed outline into creases" in why(dieline, 0)
    (question,) = list_questions(sheet, dieline)
    assert (question.edges, question.choices[:2]) == ((0, 1, 2, 3), ("cut", "crease"))
    assert "the answer also decides the edges that the profile cuts" in question.text
    (following,) = question.follows
    assert (following.edges, following.layer) == ((4, 5), "CUT")
    assert following.line_types == {"cut": "crease", "crease": "cut"}
    assert str(following.message) == (
        'The answer also decides 2 edges on layer "CUT" (colour 7, line style CONTINUOUS): crease '
        "if the answer is cut, and cut if it is crease."
    )
    assert question.as_json()["follows"] == [
        {
            **following.message.as_json(),
            "edges": [4, 5],
            "layer": "CUT",
            "colour": 7,
            "line_types": {"cut": "crease", "crease": "cut"},
        }
    ]


def test_two_questions_about_swapped_rules_list_the_edges_that_both_decide() -> None:
    sheet = drawing_of(
        (BLANK[:2], style("CREASE", colour=1)),
        (BLANK[2:], style("CREASE", colour=2)),
        (FOLDS, style("CUT")),
    )
    questions = list_questions(sheet, classified(sheet))
    assert [one.edges for one in questions] == [(0, 1), (2, 3)]
    assert [one.follows[0].edges for one in questions] == [(4, 5), (4, 5)]
    text = "crease if all 2 answers about this rule are cut, and cut if they are crease."
    assert all(str(one.follows[0].message).endswith(text) for one in questions)
    assert words(answered(sheet, dict.fromkeys((0, 1), LineType.CUT)))[4:] == ["unclassified"] * 2
    assert words(answered(sheet, dict.fromkeys(range(4), LineType.CUT)))[4:] == ["crease"] * 2


@pytest.mark.parametrize(("answer", "folds"), [(LineType.CUT, "crease"), (LineType.CREASE, "cut")])
def test_the_answer_about_the_outline_decides_the_other_swapped_rule(
    answer: LineType, folds: str
) -> None:
    sheet = drawing_of((BLANK, style("CREASE")), (FOLDS, style("CUT")))
    assert words(answered(sheet, {0: answer, 1: answer, 2: answer, 3: answer})) == [
        *[answer.word] * 4,
        *[folds] * 2,
    ]


def test_one_line_of_the_outline_does_not_confirm_a_swap() -> None:
    sheet = drawing_of((BLANK, style("CREASE")), (FOLDS, style("CUT")))
    assert words(answered(sheet, {0: LineType.CUT}))[1:] == ["unclassified"] * 5


def test_with_another_answer_the_other_swapped_rule_is_asked_about() -> None:
    sheet = drawing_of((BLANK, style("CREASE")), (FOLDS, style("CUT")))
    dieline = answered(sheet, dict.fromkeys(range(4), LineType.PERFORATION))
    assert words(dieline)[4:] == ["unclassified"] * 2
    (question,) = list_questions(sheet, dieline)
    assert (question.edges, question.choices[0]) == ((4, 5), "crease")


def answered(sheet: Drawing, overrides: dict[int, LineType]) -> Dieline:
    """Return the dieline of a drawing after its user gave line types to some edges."""
    types = np.full(len(sheet), NO_OVERRIDE, np.uint8)
    types[list(overrides)] = list(overrides.values())
    decided = classified(sheet)
    return follow_answers(sheet, decided, apply_overrides(decided, types), types)


def test_a_profile_with_the_wrong_colours_is_detected() -> None:
    sheet = drawing_of((BLANK, style(colour=7)), (FOLDS, style(colour=1)))
    assert words(classified(sheet, "red-crease-black-cut")) == ["cut"] * 4 + ["crease"] * 2
    wrong = classified(sheet, "red-cut-blue-crease")
    assert words(wrong)[4:] == ["unclassified"] * 2


def test_one_crease_on_the_outline_is_asked_and_the_others_are_creases() -> None:
    dieline = classified(
        drawing_of((BLANK[1:], style("CUT")), (BLANK[:1] + FOLDS, style("CREASE")))
    )
    assert words(dieline) == ["cut"] * 3 + ["unclassified"] + ["crease"] * 2
    assert "such an edge should be cut" in why(dieline, 3)


def test_slits_between_flaps_in_the_style_of_the_outline_are_cuts() -> None:
    """Dividers in the style of the outline are cuts if another style has the folds."""
    slit = [(150, 0, 150, 40)]
    across = [(100, 40, 200, 40)]
    dieline = classified(
        drawing_of((BLANK + slit, style(colour=1)), (FOLDS + across, style(colour=5)))
    )
    assert words(dieline) == ["cut"] * 5 + ["crease"] * 3


def test_a_cut_outside_every_blank_that_closes_nothing_is_asked() -> None:
    dieline = classified(drawing_of((BLANK + OUTSIDE, style("CUT")), (FOLDS, style("CREASE"))))
    assert words(dieline) == ["cut"] * 4 + ["unclassified"] + ["crease"] * 2
    assert dieline.alternatives[dieline.rule[4]][-1] == LineType.IGNORED


def test_an_ignored_colour_that_closes_the_outline_is_asked_and_an_ignored_layer_is_ignored() -> (
    None
):
    """In the profile red-cut-blue-crease yellow is the colour of dimensions."""
    yellow = drawing_of((BLANK, style(colour=2)), (FOLDS, style(colour=5)))
    assert words(classified(yellow, "red-cut-blue-crease"))[:4] == ["unclassified"] * 4
    bleed = [(-3, -3, 303, -3), (303, -3, 303, 203), (303, 203, -3, 203), (-3, 203, -3, -3)]
    named = classified(
        drawing_of((bleed, style("BLEED")), (BLANK, style("CUT")), (FOLDS, style("CREASE")))
    )
    assert words(named) == ["ignored"] * 4 + ["cut"] * 4 + ["crease"] * 2


#: A bottom of 100 mm × 60 mm with four walls of 20 mm, in edges without corners in common.
WALLS = [(0, -20, 100, -20), (100, -20, 100, 0), (100, 0, 120, 0), (120, 0, 120, 60),
         (120, 60, 100, 60), (100, 60, 100, 80), (100, 80, 0, 80), (0, 80, 0, 60),
         (0, 60, -20, 60), (-20, 60, -20, 0), (-20, 0, 0, 0), (0, 0, 0, -20)]  # fmt: skip
BOTTOM = [(0, 0, 100, 0), (100, 0, 100, 60), (100, 60, 0, 60), (0, 60, 0, 0)]
SHEET = [(-20, -20, 120, -20), (120, -20, 120, 80), (120, 80, -20, 80), (-20, 80, -20, -20)]
ACROSS = [(0, -20, 0, 80), (100, -20, 100, 80), (-20, 0, 120, 0), (-20, 60, 120, 60)]


@pytest.mark.parametrize(("outline", "folds"), [(WALLS, BOTTOM), (SHEET, ACROSS)], ids=str)
def test_the_folds_of_a_box_without_glue_tabs_are_asked_if_only_a_colour_names_them(
    outline: list[Line], folds: list[Line]
) -> None:
    sheet = drawing_of((outline, style(colour=1)), (folds, style(colour=3)))
    dieline = classified(sheet)
    assert words(dieline) == ["cut"] * len(outline) + ["unclassified"] * 4
    (question,) = list_questions(sheet, dieline)
    assert question.choices[:2] == ("crease", "v-groove")
    assert "no glue tabs" in question.text
    named = drawing_of((outline, style("CUT")), (folds, style("FOLD")))
    assert words(classified(named))[-4:] == ["crease"] * 4


def test_a_contour_like_a_bleed_in_the_style_of_the_cuts_is_asked() -> None:
    house: list[Line] = [(0, 0, 300, 0), (300, 0, 300, 200), (300, 200, 150, 230),
             (150, 230, 0, 200), (0, 200, 0, 0)]  # fmt: skip
    bleed: list[Line] = [(-3, -3, 303, -3), (303, -3, 303, 202.459), (303, 202.459, 150, 233.059),
             (150, 233.059, -3, 202.459), (-3, 202.459, -3, -3)]  # fmt: skip
    folds = [(100, 0, 100, 220), (200, 0, 200, 220)], style(colour=5)
    like = classified(drawing_of((bleed + house, style(colour=1)), folds))
    assert words(like)[:5] == ["unclassified"] * 5
    other = drawing_of((bleed, style(colour=6)), (house, style(colour=1)), folds)
    assert words(classified(other))[:5] == ["ignored"] * 5


def test_the_main_folds_are_asked_if_another_style_has_folds_too() -> None:
    perforated = [(75, 0, 75, 200)]
    both = drawing_of(
        (BLANK, style(colour=30)), (FOLDS, style(colour=40)), (perforated, style(colour=50))
    )
    assert words(classified(both))[4:] == ["unclassified"] * 3


DASHED = "DASHED"
ACROSS_A_PANEL: list[Line] = [(200, 150, 300, 150)]


@pytest.mark.parametrize(
    "other",
    [
        style(colour=4, linetype=DASHED),
        style(colour=1, linetype="HIDDEN"),
        style("P2", colour=1, linetype=DASHED),
    ],
    ids=["colour", "dashes", "layer"],
)
@pytest.mark.parametrize("more", [[], [(220, 50, 260, 50)]], ids=["dividers", "free line"])
def test_dashes_of_a_second_look_are_asked_beside_the_main_folds(
    other: Style, more: list[Line]
) -> None:
    """The perforation is dashed like the folds, but differs in one attribute."""
    dieline = classified(
        drawing_of(
            (BLANK, style(colour=5)),
            (FOLDS, style(colour=1, linetype=DASHED)),
            (ACROSS_A_PANEL + more, other),
        )
    )
    assert words(dieline)[:6] == ["cut"] * 4 + ["crease"] * 2
    assert set(words(dieline)[6:]) == {"unclassified"}
    assert dieline.confidence[6] < 0.75


def test_dashed_folds_on_a_layer_for_each_panel_are_creased() -> None:
    dieline = classified(
        drawing_of(
            (BLANK, style(colour=5)),
            (FOLDS[:1], style("front", colour=1, linetype=DASHED)),
            (FOLDS[1:], style("back", colour=1, linetype=DASHED)),
        )
    )
    assert words(dieline)[4:] == ["crease"] * 2


def test_a_line_across_a_panel_beside_folds_in_another_style_is_asked() -> None:
    """The shape makes it a fold: it begins and ends at folds."""
    corners = [(0.0, 0.0), (400.0, 0.0), (400.0, 100.0)]
    for x in (300.0, 200.0, 100.0, 0.0):
        corners += [(x + 95, 100.0), (x + 90, 150.0), (x + 10, 150.0), (x + 5, 100.0), (x, 100.0)]
    ends = zip(corners, [*corners[1:], corners[0]], strict=True)
    outline: list[Line] = [(*start, *end) for start, end in ends]
    folds: list[Line] = [(x, 0, x, 100) for x in (100, 200, 300)]
    folds += [(x + 5, 100, x + 95, 100) for x in (0, 100, 200, 300)]
    tear: list[Line] = [(100, 50, 200, 50), (220, 50, 260, 50)]
    dieline = classified(
        drawing_of((outline, style(colour=30)), (folds, style(colour=40)), (tear, style(colour=50)))
    )
    assert words(dieline) == ["cut"] * len(outline) + ["crease"] * 7 + ["unclassified"] * 2


def test_rules_without_contradiction_keep_their_words_and_confidence() -> None:
    dieline = classified(drawing_of((BLANK + SLIT, style("CUT")), (FOLDS, style("CREASE"))))
    said = {str(rule) for rule in dieline.rules}
    assert said == {'profile default: layer "CUT"', 'profile default: layer "CREASE"'}
    assert set(dieline.confidence) == {0.95}


def test_a_rule_for_a_block_or_a_true_colour_decides() -> None:
    sheet = drawing_of((BLANK, style()), (FOLDS, style(colour=1)))
    fields = {
        "title": "Ours",
        "rule": [
            {"type": "crease", "colour": "#ff0000"},
            {"type": "cut", "block": "CARTON*"},
        ],
    }
    rules = load.parse_profile("own", fields)
    assert words(classify(sheet, rules))[4:] == ["crease"] * 2
    blocks = replace(
        sheet,
        import_report=replace(sheet.import_report, block=("Carton 7",) * len(sheet.import_report)),
    )
    dieline = classify(blocks, rules)
    assert words(dieline) == ["cut"] * 4 + ["crease"] * 2
    assert why(dieline, 0) == 'profile own: inside the block "CARTON*"'
    assert why(dieline, 4) == "profile own: colour #ff0000"


def test_no_more_than_one_edge_in_three_thousand_is_silently_wrong_in_drawings_of_our_own() -> None:
    edges = wrong = decided = 0
    for seed in range(5000, 5150):
        sheet, truth, _ = random_drawing(seed)
        said = classified(sheet).line_type
        edges += len(said)
        decided += int((said != LineType.UNCLASSIFIED).sum())
        wrong += int(((said != LineType.UNCLASSIFIED) & (said != truth)).sum())
    assert edges > 10_000
    assert decided > 0.6 * edges
    assert wrong <= edges / 3000


def test_dividers_on_a_layer_that_says_cut_are_offered_as_cuts() -> None:
    """The offered line type is the one for which the reason argues."""
    dieline = classified(
        drawing_of((BLANK, style("Plate")), (FOLDS, style("Découpe")), (SLIT, style("Découpe")))
    )
    row = int(dieline.rule[4])
    assert words(dieline)[4] == "unclassified"
    assert dieline.alternatives[row][:2] == (LineType.CUT, LineType.CREASE)
    assert 'the name of the layer of the edge contains "decoupe"' in why(dieline, 4)


def test_a_name_against_the_shape_is_said_to_be_so() -> None:
    dieline = classified(drawing_of((BLANK, style("Plis")), (FOLDS, style("Plis"))))
    assert 'but the name of the layer of the edge contains "plis"' in why(dieline, 0)


def test_a_closed_shape_beside_a_text_is_asked_about_and_not_left_out() -> None:
    sheet = drawing_of(
        (BLANK, style()), (FOLDS, style(colour=40)), (box(340, 0, 400, 60), style(colour=90))
    )
    sheet = replace(sheet, annotations=(text(365, 30, "Lid"),))
    dieline = classified(sheet)
    assert words(dieline)[6:] == ["ignored"] * 4  # nothing else has its colour
    own = replace(sheet, colour=np.where(sheet.colour == 90, 7, sheet.colour))
    dieline = classified(own)
    assert words(dieline)[6:] == ["unclassified"] * 4
    assert dieline.alternatives[dieline.rule[6]][:2] == (LineType.IGNORED, LineType.CUT)


def test_a_name_of_two_line_types_needs_another_witness() -> None:
    sheet = drawing_of((BLANK, style("CUT")), (FOLDS, style("Rill-Schnitt")))
    assert words(classified(sheet))[4:] == ["unclassified"] * 2


def test_a_name_decides_about_perforations_and_half_cuts_inside_a_panel() -> None:
    inner = [(130, 50, 170, 50)]
    for name, kind in (("Perf tear", "perforation"), ("half", "half-cut"), ("Falz", None)):
        dieline = classified(drawing_of((BLANK, style("CUT")), (inner, style(name, colour=90))))
        assert words(dieline)[4] == (kind or "unclassified"), name


def test_a_question_calls_a_line_type_most_likely_only_if_the_evidence_is_strong() -> None:
    two_styles = drawing_of(
        (BLANK, style(colour=30)), (FOLDS[:1], style(colour=40)), (FOLDS[1:], style(colour=50))
    )
    weak = list_questions(two_styles, classified(two_styles))[0]
    assert weak.message.arguments["guess"].code == "question.shape"
    assert weak.choices[0] == "crease"
    assert "most likely" not in weak.text
    dashed = drawing_of(
        (BLANK, style(colour=30)),
        (FOLDS[:1], style(colour=40, linetype="DASHED")),
        (FOLDS[1:], style(colour=50)),
    )
    strong = list_questions(dashed, classified(dashed))[0]
    assert "The most likely line type is crease (75 %)" in strong.text
