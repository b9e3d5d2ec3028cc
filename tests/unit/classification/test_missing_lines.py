"""A panel whose outline lacks a line does not make its folds cuts."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.classification.questions import list_questions
from knifetip.classification.shape.features import extract_shape_features
from knifetip.classification.shape.roles import Role
from tests.support.classification import Line, classified, drawing_of, style, words

#: A sleeve of four panels and a glue flap with a lid at the third panel, without the top edge of
#: that panel.  The last three lines are its folds: to both neighbours, and to the lid.
SLEEVE: list[Line] = [
    (0, 0, 60, 0), (60, 0, 100, 0), (160, 0, 200, 0), (200, 0, 200, 120), (200, 120, 160, 120),
    (100, 120, 60, 120), (60, 120, 0, 120), (0, 120, -15, 110), (-15, 110, -15, 10),
    (-15, 10, 0, 0), (100, 0, 100, -40), (100, -40, 160, -40), (160, -40, 160, 0),
    (0, 0, 0, 120), (60, 0, 60, 120),
    (100, 0, 100, 120), (160, 0, 160, 120), (100, 0, 160, 0),
]  # fmt: skip
TOP: Line = (100, 120, 160, 120)


def test_the_folds_of_a_panel_without_a_top_edge_divide_panels() -> None:
    features = extract_shape_features(np.array(SLEEVE).reshape(-1, 2, 2), np.zeros(18))
    assert features.role.tolist() == [Role.OUTLINE] * 13 + [Role.DIVIDER] * 5
    assert features.beside_gap.tolist() == [False] * 15 + [True] * 3


@pytest.mark.parametrize("scale", [1.0, 1 / 25.4])
def test_nothing_is_missing_where_the_outline_is_complete(scale: float) -> None:
    ends = np.array([*SLEEVE, TOP]).reshape(-1, 2, 2) * scale
    features = extract_shape_features(ends, np.zeros(19), unit_known=scale == 1.0)
    assert not features.beside_gap.any()
    assert features.role.tolist()[13:] == [Role.DIVIDER] * 5 + [Role.OUTLINE]


def test_the_folds_are_asked_about_in_one_style_and_creased_in_a_style_of_folds() -> None:
    sheet = drawing_of((SLEEVE, style()))
    assert words(classified(sheet))[15:] == ["unclassified"] * 3
    (question,) = list_questions(sheet, classified(sheet))
    assert question.message.arguments["guess"].arguments["type"] == "crease"
    assert question.edges == (15, 16, 17)
    colours = drawing_of((SLEEVE[:13], style()), (SLEEVE[13:], style(colour=1)))
    assert words(classified(colours)) == ["cut"] * 13 + ["crease"] * 5


def test_two_blanks_that_touch_at_a_corner_are_not_joined() -> None:
    """No line of one continues a line of the other across a space."""
    square: list[Line] = [(0, 0, 50, 0), (50, 0, 50, 50), (50, 50, 0, 50), (0, 50, 0, 0)]
    other = [(x1 + 50, y1 + 50, x2 + 50, y2 + 50) for x1, y1, x2, y2 in square]
    ends = np.array([*square, *other]).reshape(-1, 2, 2)
    features = extract_shape_features(ends, np.zeros(8))
    assert features.role.tolist() == [Role.OUTLINE] * 8
