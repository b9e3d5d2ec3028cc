"""Dimensions of plain lines, recognised only by the text beside them."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from knifetip.classification.shape.roles import Role
from knifetip.model.drawing import Annotation
from tests.support.classification import BLANK, Line, roles, text

#: A dimension line across the middle panel.
ACROSS: Line = (100, 90, 200, 90)
ABOVE: Line = (0, 230, 300, 230)
TICKS: list[Line] = [(98, 88, 102, 92), (198, 88, 202, 92)]
EXTENSIONS: list[Line] = [(0, 203, 0, 232), (300, 203, 300, 232)]
ARROWHEAD: list[Line] = [(100, 90, 103, 91), (103, 91, 103, 89), (103, 89, 100, 90)]


def added_roles(added: Sequence[Line], *texts: Annotation) -> list[Role]:
    """Return the roles of the folds of the blank and of the lines that were added to it."""
    found = roles([*BLANK, *added], texts=texts)
    assert found[:4] == [Role.OUTLINE] * 4
    return found[4:]


FOLDS = [Role.DIVIDER] * 2


@pytest.mark.parametrize("words", ["100", "100.0", "100,0 mm", "Ø100"])
def test_a_line_beside_a_text_with_its_length_is_a_dimension_with_its_strokes(words: str) -> None:
    found = added_roles([ACROSS, *TICKS], text(145, 92, words))
    assert found == FOLDS + [Role.DIMENSION] * 3


def test_extension_lines_belong_to_the_dimension() -> None:
    found = added_roles([ABOVE, *EXTENSIONS], text(145, 232, "300"))
    assert found == FOLDS + [Role.DIMENSION] * 3


def test_arrowheads_of_three_lines_belong_to_the_dimension() -> None:
    found = added_roles([ACROSS, *ARROWHEAD], text(145, 92, "100"))
    assert found == FOLDS + [Role.DIMENSION] * 4


def test_a_line_without_strokes_from_fold_to_fold_may_be_a_dimension() -> None:
    assert added_roles([ACROSS], text(145, 92, "100")) == [*FOLDS, Role.MEASURED]


@pytest.mark.parametrize(
    "label",
    [
        pytest.param(text(145, 92, "99"), id="another length"),
        pytest.param(text(145, 120, "100"), id="far away"),
        pytest.param(text(260, 92, "100"), id="beyond the end"),
        pytest.param(text(145, 92, "No. 100"), id="a word"),
        pytest.param(text(145, 92, "100 x 50"), id="two numbers"),
    ],
)
def test_other_texts_make_no_dimension(label: Annotation) -> None:
    assert added_roles([ACROSS], label) == [*FOLDS, Role.DIVIDER]


def test_the_length_beside_a_side_of_the_outline_does_not_make_it_a_dimension() -> None:
    assert added_roles([], text(145, 203, "300"), text(303, 100, "200")) == FOLDS


def test_short_numbers_are_no_lengths() -> None:
    assert added_roles([(130, 100, 133, 100)], text(131, 101, "3")) == [*FOLDS, Role.FREE]
