"""A line on the wrong layer is detected by its mirror image."""

from __future__ import annotations

from knifetip.classification.questions import list_questions
from tests.support.classification import classified, drawing_of, style, words

BOX = [(0, 0, 300, 0), (300, 0, 300, 200), (300, 200, 0, 200), (0, 200, 0, 0)]
LEFT, RIGHT = (100, 0, 100, 200), (200, 0, 200, 200)


def test_a_cut_whose_mirror_image_is_a_crease_is_asked_with_it() -> None:
    sheet = drawing_of(([*BOX, LEFT], style("CUT")), ([RIGHT, (0, 100, 100, 100)], style("CREASE")))
    # The second crease has no image on the right: nearly all of the length is symmetrical.
    dieline = classified(sheet)
    assert words(dieline) == ["cut"] * 4 + ["unclassified"] * 2 + ["crease"]
    texts = [question.text for question in list_questions(sheet, dieline)]
    assert "a mirror image of the edge, and this mirror image is a fold" in texts[0]
    assert "a mirror image of the edge, and this mirror image is a cut" in texts[1]


def test_equal_pairs_are_not_asked() -> None:
    for left, right in (("CUT", "CUT"), ("CREASE", "CREASE")):
        sheet = drawing_of((BOX, style("CUT")), ([LEFT], style(left)), ([RIGHT], style(right)))
        assert "unclassified" not in words(classified(sheet))


def test_an_asymmetric_blank_is_not_asked() -> None:
    corner = [(100, 60, 200, 60), (100, 120, 0, 120), (200, 150, 300, 150), (30, 0, 30, 120)]
    sheet = drawing_of(
        ([*BOX, LEFT], style("CUT")), ([RIGHT, *corner, (240, 0, 240, 150)], style("CREASE"))
    )
    assert "unclassified" not in words(classified(sheet))
