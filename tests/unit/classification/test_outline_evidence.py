"""Lines that lie on the outline only in part, or again, do not make their style doubtful."""

from __future__ import annotations

from knifetip.classification.questions import list_questions
from tests.support.classification import Line, box, classified, drawing_of, style, words

OUTLINE = box(0, 0, 300, 200)
FOLDS: list[Line] = [(100, 0, 100, 200), (200, 0, 200, 200)]
#: A fold of flaps that this carton does not have: it lies on the outline.
AGAIN: list[Line] = [(300, 200, 0, 200)]


def test_a_fold_drawn_on_the_outline_is_a_fold_like_its_style() -> None:
    sheet = drawing_of((OUTLINE, style()), (FOLDS, style(colour=1)), (AGAIN, style(colour=1)))
    assert words(classified(sheet)) == ["cut"] * 4 + ["crease"] * 3
    assert list_questions(sheet, classified(sheet)) == []


def test_a_line_on_the_outline_whose_style_has_no_folds_is_cut() -> None:
    sheet = drawing_of((OUTLINE, style()), (AGAIN, style(colour=1)))
    assert words(classified(sheet)) == ["cut"] * 5


def test_exchanged_layers_are_noticed_although_folds_lie_on_the_outline() -> None:
    sheet = drawing_of((OUTLINE, style("CREASE")), ([*FOLDS, *AGAIN], style("CUT")))
    assert words(classified(sheet)) == ["unclassified"] * 7


#: A bottom with a wall above it and an ear at the wall; the line below the ear is at first a slit
#: beside the ear, then a side of the outline.
TRAY: list[Line] = [
    (0, 0, 100, 0), (100, 0, 200, 0), (200, 0, 200, 100), (100, 200, 0, 200), (0, 200, 0, 0),
    (140, 100, 140, 180), (140, 180, 100, 200), (200, 100, 100, 100),
]  # fmt: skip
TRAY_FOLDS: list[Line] = [(100, 0, 100, 100), (100, 100, 100, 200), (0, 100, 100, 100)]


def test_a_cut_that_is_outline_and_slit_needs_no_question() -> None:
    sheet = drawing_of((TRAY, style()), (TRAY_FOLDS, style(colour=1)))
    assert words(classified(sheet)) == ["cut"] * 8 + ["crease"] * 3


def test_with_one_style_a_line_that_is_mostly_outline_is_cut_beside_the_ear_too() -> None:
    """An edge has one line type: 60 mm of the line are outline, and 40 mm are beside the ear."""
    sheet = drawing_of(([*TRAY, *TRAY_FOLDS], style()))
    assert words(classified(sheet)) == ["cut"] * 8 + ["unclassified"] * 3


def test_with_one_style_the_slit_alone_may_be_a_fold() -> None:
    sheet = drawing_of(([*TRAY[:-1], (140, 100, 100, 100), *TRAY_FOLDS], style()))
    assert words(classified(sheet))[7] == "unclassified"
