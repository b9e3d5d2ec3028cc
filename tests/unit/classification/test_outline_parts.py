"""Edges of a cut outline whose layers are named for half-cuts, perforations or folds."""

from __future__ import annotations

import pytest

from knifetip.classification.questions import list_questions
from tests.support.classification import Line, classified, drawing_of, style, words

BLANK: list[Line] = [(0, 0, 300, 0), (300, 0, 300, 200), (300, 200, 0, 200), (0, 200, 0, 0)]
FOLDS: list[Line] = [(100, 0, 100, 200), (200, 0, 200, 200)]
#: A side of the blank, a fifth of its outline.
SIDE = 3


def with_part(*names: str, part: list[Line] | None = None) -> list[str]:
    """Return the line types of the cuts, the folds and the part of an outline, by layer names."""
    cut, fold, other = names
    rest = [one for one in BLANK if one not in (part or [BLANK[SIDE]])]
    sheet = drawing_of(
        (rest, style(cut)), (FOLDS, style(fold)), (part or [BLANK[SIDE]], style(other))
    )
    dieline = classified(sheet)
    asked = sum(len(question.edges) for question in list_questions(sheet, dieline))
    found = words(dieline)
    assert found.count("unclassified") == asked
    return found


@pytest.mark.parametrize(
    ("names", "kind"),
    [
        (("CUT", "CREASE", "HALFCUT"), "half-cut"),
        (("CUT", "CREASE", "PERF"), "perforation"),
        (("CUT", "CREASE", "CREASE"), "crease"),
        (("Schneidlinien", "Falzlinie", "Falzlinie"), "crease"),
        (("Tracé de coupe", "Filets de rainage", "Coupe à mi-chair"), "half-cut"),
        (("Cutting knife", "Creasing knife", "Perforated knife"), "perforation"),
        (("CUT", "V-GROOVE", "V-GROOVE"), "v-groove"),
    ],
)
def test_a_part_of_a_cut_outline_has_the_line_type_of_its_layer(
    names: tuple[str, str, str], kind: str
) -> None:
    found = with_part(*names)
    assert found[:3] == ["cut"] * 3
    assert found[5] == kind


@pytest.mark.parametrize(
    "names",
    [
        ("CUT", "CREASE", "Rill-Schnitt"),  # two meanings
        ("CUT", "CREASE", "no half cut"),  # negated
        ("CUT", "PERF", "CREASE"),  # creases on the outline only
        ("Plate", "CREASE", "HALFCUT"),  # nothing names the cuts
    ],
)
def test_a_part_of_an_outline_with_a_doubtful_name_is_asked(names: tuple[str, str, str]) -> None:
    assert with_part(*names)[5] == "unclassified"


def test_parts_that_are_more_than_a_quarter_of_an_outline_are_asked() -> None:
    assert with_part("CUT", "CREASE", "HALFCUT", part=[BLANK[0]])[5] == "unclassified"


def test_the_outline_of_each_blank_is_examined_alone() -> None:
    """The second blank is closed by half-cuts only, though most of all outlines is cut."""
    small: list[Line] = [(400, 0, 450, 0), (450, 0, 450, 50), (450, 50, 400, 50), (400, 50, 400, 0)]
    sheet = drawing_of(
        (BLANK[:SIDE], style("CUT")),
        (FOLDS, style("CREASE")),
        ([BLANK[SIDE], *small], style("HALFCUT")),
    )
    assert words(classified(sheet))[5:] == ["half-cut"] + ["unclassified"] * 4


def test_a_colour_does_not_make_a_part_of_an_outline() -> None:
    sheet = drawing_of((BLANK[:SIDE], style(colour=1)), ([*FOLDS, BLANK[SIDE]], style(colour=5)))
    assert words(classified(sheet, "red-cut-blue-crease"))[5] == "unclassified"
