"""Slots that lie at a fold are cut, and the fold remains a fold."""

from __future__ import annotations

import pytest

from knifetip.classification.shape.roles import Role
from tests.support.classification import Line, box, classified, drawing_of, roles, style, words

#: 300 × 200 mm with two folds across.
BLANK = [*box(0, 0, 300, 200), (100, 0, 100, 200), (200, 0, 200, 200)]


def slot(width: float, length: float = 40.0) -> list[Line]:
    """Return three sides of a slot, whose fourth side is on the first fold."""
    return [
        (100, 80, 100 + width, 80),
        (100 + width, 80, 100 + width, 80 + length),
        (100 + width, 80 + length, 100, 80 + length),
    ]


@pytest.mark.parametrize("width", [2.0, 8.0])
def test_the_sides_of_a_slot_at_a_fold_are_no_dividers(width: float) -> None:
    found = roles([*BLANK, *slot(width)])
    assert found[4:6] == [Role.DIVIDER] * 2
    assert found[6:] == [Role.SLOT] * 3


def test_a_slot_is_cut_although_the_drawing_has_one_style() -> None:
    assert words(classified(drawing_of(([*BLANK, *slot(3.0)], style()))))[6:] == ["cut"] * 3


def test_a_window_at_a_fold_is_wider_than_a_slot() -> None:
    assert roles([*BLANK, *slot(30.0)])[6:] == [Role.DIVIDER] * 3


def test_two_folds_near_each_other_are_no_slot() -> None:
    assert roles([*BLANK, (104, 0, 104, 200)])[4:] == [Role.DIVIDER] * 3


def test_short_folds_between_two_folds_near_each_other_are_no_slot() -> None:
    """Their ends lie on the folds, where three lines meet."""
    pair: list[Line] = [(104, 0, 104, 200), (100, 80, 104, 80), (100, 120, 104, 120)]
    assert Role.SLOT not in roles([*BLANK, *pair])


def test_the_bends_of_a_curved_fold_are_no_corners() -> None:
    curve: list[Line] = [(100, 80, 103, 90), (103, 90, 103, 110), (103, 110, 100, 120)]
    assert roles([*BLANK, *curve])[6:] == [Role.DIVIDER] * 3
