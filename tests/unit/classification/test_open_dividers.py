"""With one style, the ends of lines between panels show which are slits and which are folds."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.classification.questions import list_questions
from knifetip.classification.shape.features import extract_shape_features
from knifetip.classification.shape.open_dividers import DividerKind
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing
from knifetip.model.question import Question
from tests.support.cartons.kinds import crossed_case
from tests.support.cartons.rewritings import turned
from tests.support.classification import Line, box, classified, drawing_of, style, words

#: A bottom of 140 × 100 mm with walls of 80 mm, and four corners that are attached to one wall and
#: cut from the other one.  Which of the two is the author's choice.
TRAY = box(0, 0, 300, 260)
BOTTOM: list[Line] = [
    (80, 80, 220, 80), (80, 180, 220, 180), (80, 80, 80, 180), (220, 80, 220, 180),
]  # fmt: skip
ACROSS: list[Line] = [
    (0, 80, 80, 80), (220, 80, 300, 80), (0, 180, 80, 180), (220, 180, 300, 180),
]  # fmt: skip
UP: list[Line] = [
    (80, 0, 80, 80), (220, 0, 220, 80), (80, 180, 80, 260), (220, 180, 220, 260),
]  # fmt: skip
#: The four walls of a bottom of 100 mm, with an ear at each end of two of them.  The sides of the
#: other walls, in two lines, go on beyond the ears.
EARS: list[Line] = [
    (100, 0, 200, 0), (100, 300, 200, 300),
    *[(x, y, far, y) for y in (100, 200) for x, far in ((60, 0), (240, 300))],
    (0, 100, 0, 200), (300, 100, 300, 200),
    *[(x, y, x, far) for y, far in ((100, 20), (200, 280)) for x in (60, 240)],
    *[(x, y, near, end) for y, end in ((20, 0), (280, 300)) for x, near in ((60, 100), (240, 200))],
]  # fmt: skip
FOLDS: list[Line] = [
    (100, 100, 200, 100), (100, 200, 200, 200), (100, 100, 100, 200), (200, 100, 200, 200),
]  # fmt: skip
EAR_FOLDS: list[Line] = [(x, y, x, y + 100) for x in (100, 200) for y in (0, 200)]
SLITS: list[Line] = [(x, y, x + 40, y) for y in (100, 200) for x in (60, 200)]


def kinds(lines: list[Line]) -> list[DividerKind]:
    """Return the kind of each line."""
    ends = np.array(lines, float).reshape(-1, 2, 2)
    features = extract_shape_features(ends, np.zeros(len(ends)))
    return [DividerKind(int(kind)) for kind in features.divider_kind]


def questions(sheet: Drawing) -> list[Question]:
    return list_questions(sheet, classified(sheet))


def likely(question: Question) -> str:
    """Return the line type that a question calls the most likely one, "" for none."""
    guess = question.message.arguments["guess"]
    return str(guess.arguments.get("type", "")) if guess is not None else ""


@pytest.mark.parametrize("angle", [0.0, 17.0])
def test_slits_and_folds_round_the_corners_of_a_tray_are_two_questions(angle: float) -> None:
    sheet, _ = turned(drawing_of(([*TRAY, *BOTTOM, *ACROSS, *UP], style())), angle)
    assert [(question.edges, likely(question)) for question in questions(sheet)] == [
        ((8, 9, 10, 11), ""),
        ((12, 13, 14, 15), ""),
    ]


def test_lines_beside_which_the_side_of_a_wall_goes_on_are_likely_slits() -> None:
    sheet = drawing_of(([*EARS, *FOLDS, *SLITS, *EAR_FOLDS], style()))
    first = len(EARS)
    slits = tuple(range(first + 4, first + 8))
    found = {question.edges: likely(question) for question in questions(sheet)}
    assert found[slits] == "cut"
    (folds,) = (edges for edges in found if set(range(first + 8, first + 12)) <= set(edges))
    assert found[folds] == "crease"
    assert not set(folds) & set(slits)


def test_a_window_across_a_fold_is_a_likely_cut_and_the_fold_a_likely_crease() -> None:
    sheet = drawing_of(
        (box(0, 0, 300, 200), style()),
        ([*box(60, 80, 140, 120), (100, 0, 100, 80), (100, 120, 100, 200)], style()),
    )
    found = {question.edges: likely(question) for question in questions(sheet)}
    assert found == {(4, 5, 6, 7): "cut", (8, 9): "crease"}


def test_a_line_that_passes_a_crossing_is_a_likely_fold_and_those_that_end_there_slits() -> None:
    plan = crossed_case(np.random.default_rng(1))
    sheet = drawing_of(([(s.x0, s.y0, s.x1, s.y1) for s in plan.strokes], style()))
    truth = [LineType.CREASE if s.part == "crease" else LineType.CUT for s in plan.strokes]
    for question in questions(sheet):
        (kind,) = {truth[row] for row in question.edges}
        assert likely(question) == kind.word


def test_short_lines_between_a_fold_and_the_outline_are_likely_slits() -> None:
    """A tuck flap: its fold is 80 mm long, and a slit of 10 mm locks it at each end."""
    body = [*box(0, 0, 300, 100), (100, 0, 100, 100), (200, 0, 200, 100)]
    lid: list[Line] = [
        (100, 100, 100, 140), (200, 140, 200, 100), (100, 140, 100, 160), (200, 160, 200, 140),
        (100, 160, 200, 160), (110, 140, 190, 140),
    ]  # fmt: skip
    flaps: list[Line] = [
        (0, 0, 0, -30), (0, -30, 90, -30), (90, -30, 100, 0), (200, 0, 210, -30),
        (210, -30, 300, -30), (300, -30, 300, 0),
    ]  # fmt: skip
    locks: list[Line] = [(100, 140, 110, 140), (190, 140, 200, 140)]
    lines = [*body, *lid, *flaps, *locks]
    assert kinds(lines)[-2:] == [DividerKind.FOLD_END] * 2


def test_a_side_of_a_slot_that_is_a_line_of_its_own_is_a_likely_cut() -> None:
    lines: list[Line] = [
        *box(0, 0, 300, 200), (100, 0, 100, 90), (100, 90, 100, 110), (100, 110, 100, 200),
        (100, 90, 104, 90), (104, 90, 104, 110), (104, 110, 100, 110),
    ]  # fmt: skip
    assert kinds(lines)[4:7] == [DividerKind.OTHER, DividerKind.SLOT_SIDE, DividerKind.OTHER]


def test_equal_lines_that_lead_nowhere_show_an_open_flap() -> None:
    """The corners of a flap are missing, so its fold of 200 mm is on the outline."""
    sides: list[Line] = [(300, 0, 320, 0), (300, 200, 320, 200)]
    sheet = drawing_of(([*box(0, 0, 300, 200), *sides, (340, 20, 340, 180)], style()))
    assert words(classified(sheet))[:4] == ["cut", "unclassified", "cut", "cut"]
    longer = [*box(0, 0, 300, 200), sides[0], (300, 200, 330, 200)]
    assert words(classified(drawing_of((longer, style()))))[1] == "cut"
