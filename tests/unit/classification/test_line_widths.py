"""Line widths as a part of the style: which distinguish edges, and what follows from them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.classification.classify import classify
from knifetip.classification.line_widths import distinguishing_widths
from knifetip.classification.questions import list_questions
from knifetip.dxf.read import read as read_dxf
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.model.profile import LineRule, LineRules
from tests.support.classification import Line, box, classified, style, words
from tests.support.drawings import Style, drawing
from tests.support.writers import dxf_text

OUTLINE = box(0, 0, 300, 200)
FOLDS: list[Line] = [(100, 0, 100, 200), (200, 0, 200, 200)]
HOLE = box(120, 80, 180, 120)
SLITS: list[Line] = [(20.0, y, 60.0, y) for y in (40.0, 80.0, 120.0, 160.0)]
WIDE, THIN, THINNER = 50, 18, 9
BLACK, RED = style(colour=30), style(colour=40)

Part = tuple[Sequence[Line], Style, int]


def sheet(*parts: Part) -> Drawing:
    """Return a drawing of groups of lines, each with its style and line width (1/100 mm)."""
    return drawing(
        np.array([line for lines, _, _ in parts for line in lines], float),
        [look for lines, look, _ in parts for _ in lines],
        line_width=[width for lines, _, width in parts for _ in lines],
    )


def why(dieline: Dieline, row: int) -> str:
    return str(dieline.rules[dieline.rule[row]])


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        pytest.param([50, 50, 18, 18], [2, 2, 1, 1], id="two widths"),
        pytest.param([50, 50, 50, 50], [0, 0, 0, 0], id="one width"),
        pytest.param([50, 52, 51, 50], [0, 0, 0, 0], id="widths that look alike"),
        pytest.param([50, 53], [1, 2], id="widths that look different"),
        pytest.param([50, 51, 18, 19], [2, 2, 1, 1], id="two widths, written differently"),
        pytest.param([0, 2, 4, 6], [0, 0, 0, 0], id="a row of widths that look alike"),
        pytest.param([-1, 25, 50, -1], [1, 1, 2, 1], id="none is 0.25 mm in most programs"),
        pytest.param([-1, -1, 0], [2, 2, 1], id="the thinnest lines"),
        pytest.param([70, 50, 18] * 3, [3, 2, 1] * 3, id="three widths of three edges each"),
        pytest.param([70, 50, 18, 18], [0, 0, 0, 0], id="three widths of few edges"),
        pytest.param([10, 20, 30, 40] * 3, [1, 2, 3, 4] * 3, id="four widths"),
        pytest.param([10, 20, 30, 40, 50] * 9, [0] * 45, id="five widths are chance"),
        pytest.param([], [], id="no edges"),
    ],
)
def test_widths_that_distinguish_edges_have_numbers(given: list[int], expected: list[int]) -> None:
    one_style = np.zeros(len(given), np.int64)
    found = distinguishing_widths(np.array(given, np.int32), one_style)
    assert found.tolist() == expected


def test_widths_are_numbered_within_their_style() -> None:
    layer, colour = np.array([0, 0, 1, 1, 1, 1]), np.array([7, 7, 7, 7, 1, 1])
    width = np.array([18, 50, 50, 50, 70, 50], np.int32)
    assert distinguishing_widths(width, layer, colour).tolist() == [1, 2, 0, 0, 2, 1]


def test_thin_lines_that_only_divide_panels_are_creased_like_lines_of_another_colour() -> None:
    by_width = classified(sheet((OUTLINE, BLACK, WIDE), (FOLDS, BLACK, THIN)))
    by_colour = classified(sheet((OUTLINE, BLACK, WIDE), (FOLDS, RED, WIDE)))
    assert words(by_width) == words(by_colour) == ["cut"] * 4 + ["crease"] * 2
    assert by_width.confidence.tolist() == by_colour.confidence.tolist()
    assert "the line width of the edge distinguishes it" in why(by_width, 4)
    assert "width" not in why(by_width, 0)
    assert "width" not in why(by_colour, 4)


@pytest.mark.parametrize("widths", [(50, 50), (50, 52), (-1, -1), (-1, 25)])
def test_lines_whose_widths_look_alike_are_asked_about_as_one_style(
    widths: tuple[int, int],
) -> None:
    drawn = sheet((OUTLINE, BLACK, widths[0]), (FOLDS, BLACK, widths[1]))
    dieline = classified(drawn)
    assert words(dieline) == ["cut"] * 4 + ["unclassified"] * 2
    (question,) = list_questions(drawn, dieline)
    assert question.message.code == "question.line-type"
    assert "wide" not in question.text


def test_folds_of_two_widths_are_asked_about_by_width() -> None:
    """Lines of one of them may be perforated or half cut."""
    drawn = sheet((OUTLINE, BLACK, WIDE), (FOLDS[:1], BLACK, THIN), (FOLDS[1:], BLACK, THINNER))
    dieline = classified(drawn)
    # Three widths of six edges may be chance.
    assert {question.edges for question in list_questions(drawn, dieline)} == {(4, 5)}
    more = [(x, 0.0, x, 200.0) for x in (40.0, 70.0, 130.0, 160.0)]
    drawn = sheet((OUTLINE, BLACK, WIDE), (FOLDS, BLACK, THIN), (more, BLACK, THINNER))
    dieline = classified(drawn)
    assert words(dieline) == ["cut"] * 4 + ["unclassified"] * 6
    thin, thinner = list_questions(drawn, dieline)
    assert (thin.edges, thinner.edges) == ((4, 5), (6, 7, 8, 9))
    assert "line style CONTINUOUS, lines 0.18 mm wide) have no line type" in thin.text
    assert "lines 0.09 mm wide" in thinner.text
    assert thin.message.code == "question.line-type-by-width"


def test_one_thin_line_among_folds_of_another_width_is_asked_about() -> None:
    """It may be a slit, or was drawn thinner by chance."""
    drawn = sheet((OUTLINE, BLACK, WIDE), (FOLDS, BLACK, WIDE), ([(150, 0, 150, 200)], BLACK, THIN))
    dieline = classified(drawn)
    assert words(dieline) == ["cut"] * 4 + ["unclassified"] * 3
    assert [question.edges for question in list_questions(drawn, dieline)] == [(4, 5), (6,)]


def test_two_widths_of_the_only_style_are_evidence_like_two_colours() -> None:
    """One width closes all outlines; the other has folds and a hole."""
    by_width = classified(sheet((OUTLINE, BLACK, WIDE), (FOLDS + HOLE, BLACK, THIN)))
    by_colour = classified(sheet((OUTLINE, BLACK, WIDE), (FOLDS + HOLE, RED, WIDE)))
    assert words(by_width) == words(by_colour)
    assert by_width.confidence.tolist() == by_colour.confidence.tolist()


def test_an_outline_of_two_widths_is_decided_like_one_of_one_width() -> None:
    """Widths that differ by chance have no meaning."""
    lines = OUTLINE + FOLDS + HOLE
    one = classified(sheet((lines, BLACK, WIDE)))
    alternating = [([line], BLACK, (WIDE, THIN)[at % 2]) for at, line in enumerate(lines)]
    two = classified(sheet(*alternating))
    assert words(two) == words(one)
    assert two.confidence.tolist() == one.confidence.tolist()


def test_thin_holes_beside_coloured_folds_are_cut_like_the_outline() -> None:
    """Where colours tell cuts from folds, the widths of the cuts say nothing."""
    parts = (OUTLINE, BLACK, WIDE), (FOLDS, RED, WIDE)
    alike = classified(sheet(*parts, (HOLE, BLACK, WIDE)))
    thin = classified(sheet(*parts, (HOLE, BLACK, THIN)))
    assert words(thin) == words(alike) == ["cut"] * 4 + ["crease"] * 2 + ["cut"] * 4
    assert thin.confidence.tolist() == alike.confidence.tolist()


def test_thin_folds_in_the_colour_that_the_profile_cuts_are_asked_about() -> None:
    shop = LineRules("shop", "Shop", (LineRule(LineType.CUT, colour=(30,)),))
    alike = sheet((OUTLINE, BLACK, WIDE), (FOLDS, BLACK, WIDE))
    assert words(classify(alike, shop)) == ["cut"] * 6
    drawn = sheet((OUTLINE, BLACK, WIDE), (FOLDS, BLACK, THIN))
    dieline = classify(drawn, shop)
    assert words(dieline) == ["cut"] * 4 + ["unclassified"] * 2
    (question,) = list_questions(drawn, dieline)
    assert question.choices[:2] == ("cut", "crease")
    assert "lines 0.18 mm wide" in question.text


def test_widths_do_not_matter_on_layers_that_the_profile_knows() -> None:
    drawn = sheet(
        (OUTLINE, style("CUT"), WIDE),
        (HOLE, style("CUT"), THIN),
        (FOLDS[:1], style("CREASE"), THIN),
        (FOLDS[1:], style("CREASE"), THINNER),
    )
    assert words(classified(drawn)) == ["cut"] * 8 + ["crease"] * 2


def test_a_width_for_each_part_multiplies_no_questions() -> None:
    by_chance = [([slit], BLACK, 13 + 5 * at) for at, slit in enumerate(SLITS)]
    drawn = sheet((OUTLINE, RED, WIDE), *by_chance)
    dieline = classified(drawn)
    (question,) = list_questions(drawn, dieline)
    assert question.edges == (4, 5, 6, 7)
    assert "wide" not in question.text


def test_a_width_for_each_blank_does_not_tell_line_types_apart() -> None:
    """The outline of the second blank is a cut like that of the first."""
    second = [*box(400, 0, 500, 100), (430, 0, 430, 100), (470, 0, 470, 100)]
    drawn = sheet((OUTLINE, BLACK, WIDE), (second, BLACK, THIN))
    assert words(classified(drawn))[:8] == ["cut"] * 8


@pytest.mark.parametrize(
    ("width", "words_of_it"),
    [(-1, "lines of the default width"), (0, "thinnest lines"), (13, "lines 0.13 mm wide")],
)
def test_a_question_names_the_width_of_its_lines(width: int, words_of_it: str) -> None:
    drawn = sheet((OUTLINE, RED, WIDE), (SLITS[:2], BLACK, WIDE), (SLITS[2:], BLACK, width))
    first, second = list_questions(drawn, classified(drawn))
    assert "lines 0.5 mm wide" in first.text
    assert words_of_it in second.text


def test_a_question_names_no_unit_while_it_is_unknown() -> None:
    drawn = replace(
        sheet((OUTLINE, RED, WIDE), (SLITS[:2], BLACK, WIDE), (SLITS[2:], BLACK, THIN)), unit=""
    )
    first, second = list_questions(drawn, classified(drawn))
    assert "lines 0.5 wide" in first.text
    assert "lines 0.18 wide" in second.text


def test_an_answer_is_followed_by_lines_of_its_width_on_other_layers_without_a_name() -> None:
    drawn = sheet(
        (OUTLINE, RED, WIDE),
        (SLITS[:1], style("Layer 1", 30), WIDE),
        (SLITS[1:2], style("Layer 2", 30), WIDE),
        (SLITS[2:], style("Layer 2", 30), THIN),
    )
    overrides = np.full(len(drawn), NO_OVERRIDE, np.uint8)
    overrides[4] = LineType.CREASE
    dieline = pipeline.classify(drawn, load.profile("default"), overrides)
    assert words(dieline)[4:] == ["crease", "crease", "unclassified", "unclassified"]


def test_cuts_and_folds_of_a_file_in_one_style_are_told_apart_by_their_weight() -> None:
    def weighted(lines: Sequence[Line], weight: int) -> list[str]:
        return [dxf_text.line(*one, (62, 30), (370, weight)) for one in lines]

    drawn = read_dxf(dxf_text.dxf(*weighted(OUTLINE, 50), *weighted(FOLDS, 18), version="AC1015"))
    assert words(classified(drawn)) == ["cut"] * 4 + ["crease"] * 2
