"""Equal cartons that touch are classified like one of them, and their common cuts are cut."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.classification.questions import list_questions
from knifetip.model.drawing import Drawing
from tests.support.cartons.kinds import crossed_case, tear_case
from tests.support.cartons.rewritings import three_up, turned
from tests.support.classification import Line, box, classified, drawing_of, style, words

#: A sleeve of four panels with a glue flap, a flap at the first panel and a lid at the third one,
#: without the top of that panel.  The last six lines are its folds, three of them at that panel.
OPEN_SLEEVE: list[Line] = [
    (60, 0, 100, 0), (160, 0, 200, 0), (200, 0, 200, 120), (200, 120, 160, 120),
    (100, 120, 60, 120), (60, 120, 0, 120), (0, 120, -15, 110), (-15, 110, -15, 10),
    (-15, 10, 0, 0), (100, 0, 100, -40), (100, -40, 160, -40), (160, -40, 160, 0),
    (0, 0, 5, -30), (5, -30, 55, -30), (55, -30, 60, 0),
    (0, 0, 0, 120), (60, 0, 60, 120), (0, 0, 60, 0),
    (100, 0, 100, 120), (160, 0, 160, 120), (100, 0, 160, 0),
]  # fmt: skip


def case(seed: int = 1) -> Drawing:
    """Return a slotted case with perforations, in one style."""
    plan = tear_case(np.random.default_rng(seed))
    return drawing_of(([(s.x0, s.y0, s.x1, s.y1) for s in plan.strokes], style()))


@pytest.mark.parametrize("angle", [0.0, 17.0])
def test_three_cases_that_touch_have_the_line_types_of_one(angle: float) -> None:
    single = case()
    sheet, row = three_up(single, 0.0)
    one = np.array(words(classified(single)))
    assert np.count_nonzero(one == "crease") == 8
    assert words(classified(turned(sheet, angle)[0])) == one[row].tolist()


def test_the_lines_that_three_open_cartons_lack_are_found_together() -> None:
    sheet, row = three_up(drawing_of((OPEN_SLEEVE, style())), 0.0)
    dieline = classified(sheet)
    beside_gap = [
        str(dieline.rules[rule]).count("a straight line is missing") for rule in dieline.rule
    ]
    assert beside_gap == [1 if one >= 18 else 0 for one in row]
    assert "cut" not in np.array(words(dieline))[row >= 15]


def test_two_halves_of_a_carton_may_be_one_carton() -> None:
    """Two equal blanks have the shape of one case without a glue flap."""
    plan = crossed_case(np.random.default_rng(1))
    x0, _, x1, _ = plan.bounds
    plan.strokes += plan.moved(x1 - x0, 0.0)
    sheet = drawing_of(([(s.x0, s.y0, s.x1, s.y1) for s in plan.strokes], style()))
    assert "unclassified" in words(classified(sheet))


def test_equal_panels_in_a_row_may_be_a_sleeve_or_cards() -> None:
    lines: list[Line] = [*box(0, 0, 360, 100), *[(x, 0, x, 100) for x in range(60, 360, 60)]]
    sheet = drawing_of((lines, style()))
    assert words(classified(sheet))[4:] == ["unclassified"] * 5
    (question,) = list_questions(sheet, classified(sheet))
    assert question.message.arguments["guess"].code == "question.shape"
