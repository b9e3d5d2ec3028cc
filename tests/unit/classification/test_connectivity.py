"""Cuts that would separate a panel from its blank, and slits that do not."""

from __future__ import annotations

from knifetip.classification.questions import list_questions
from tests.support.classification import classified, drawing_of, style, words

BOX = [(0, 0, 300, 0), (300, 0, 300, 200), (300, 200, 0, 200), (0, 200, 0, 0)]


def test_a_cut_that_would_separate_a_flap_is_asked() -> None:
    """A glue flap of 30 mm is on the left; its fold is drawn on the layer of the cuts."""
    sheet = drawing_of(
        ([*BOX, (30, 0, 30, 200)], style("CUT")), ([(150, 0, 150, 200)], style("CREASE"))
    )
    dieline = classified(sheet)
    assert words(dieline) == ["cut"] * 4 + ["unclassified", "crease"]
    (question,) = list_questions(sheet, dieline)
    assert (
        "a cut at the position of the edge would separate a panel from its blank" in question.text
    )


def test_a_slit_between_flaps_attached_by_creases_is_cut() -> None:
    flaps = [(100, 150, 100, 200), (200, 150, 200, 200)]
    sheet = drawing_of((BOX + flaps, style("CUT")), ([(0, 150, 300, 150)], style("CREASE")))
    assert words(classified(sheet)) == ["cut"] * 6 + ["crease"]


def test_a_lock_whose_slits_begin_at_a_crease_is_cut() -> None:
    """The middle of the crease, its longest piece, attaches the lock; its ends attach the panel."""
    lock = [(60, 180, 60, 165), (60, 165, 240, 165), (240, 165, 240, 180)]
    folds = [(0, 180, 300, 180), (0, 80, 300, 80)]
    sheet = drawing_of((BOX + lock, style("CUT")), (folds, style("CREASE")))
    assert words(classified(sheet)) == ["cut"] * 7 + ["crease"] * 2
    # The same with an edge that does not belong to the carton, after which edges are numbered.
    label = [(-50, 0, -40, 0)]
    sheet = drawing_of(
        (label, style("DIMENSION")), (BOX + lock, style("CUT")), (folds, style("CREASE"))
    )
    assert words(classified(sheet)) == ["ignored"] + ["cut"] * 7 + ["crease"] * 2


def test_a_hole_on_a_crease_is_cut() -> None:
    hole = [(140, 90, 160, 90), (160, 90, 160, 110), (160, 110, 140, 110), (140, 110, 140, 90)]
    folds = [(150, 0, 150, 90), (150, 110, 150, 200)]
    assert words(classified(drawing_of((BOX + hole, style("CUT")), (folds, style("CREASE"))))) == (
        ["cut"] * 8 + ["crease"] * 2
    )


def test_two_blanks_that_share_a_cut_are_two_blanks() -> None:
    folds = [(75, 0, 75, 200), (225, 0, 225, 200)]
    sheet = drawing_of(([*BOX, (150, 0, 150, 200)], style("CUT")), (folds, style("CREASE")))
    assert words(classified(sheet)) == ["cut"] * 5 + ["crease"] * 2
