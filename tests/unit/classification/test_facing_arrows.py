"""Heads beyond the measured lines belong to a dimension; forks at the ends of slits do not."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from knifetip.classification.shape.roles import Role
from tests.support.classification import Line, box, classified, drawing_of, roles, style, words
from tests.unit.classification.test_arrows import found

#: Two heads of 1.6 mm beyond the ends of a measured length of 100 mm.
HEADS: list[Line] = [
    (0, 0, -1.3, 0.9), (0, 0, -1.3, -0.9), (100, 0, 101.3, 0.9), (100, 0, 101.3, -0.9),
]  # fmt: skip
#: A shaft with a space for its text.
PARTS: list[Line] = [(0, 0, 38, 0), (62, 0, 100, 0)]
WHOLE: list[Line] = [(0, 0, 100, 0)]
ACROSS: list[Line] = [(0, 50, 0, -50), (100, 50, 100, -50)]


@pytest.mark.parametrize("angle", [0.0, 17.0, 90.0])
def test_a_shaft_with_a_space_for_its_text_is_a_dimension(angle: float) -> None:
    assert found(turn([*HEADS, *PARTS], angle)) == [True] * 6


def test_a_whole_shaft_is_a_dimension_between_the_lines_that_it_measures() -> None:
    assert found([*HEADS, *WHOLE, *ACROSS]) == [True] * 5 + [False] * 2


def test_a_slit_with_a_fork_at_each_end_is_no_dimension() -> None:
    assert found([*HEADS, *WHOLE]) == [False] * 5


def test_parts_of_different_lengths_are_two_slits() -> None:
    assert found([*HEADS, (0, 0, 38, 0), (70, 0, 100, 0)]) == [False] * 6


def test_a_head_whose_sides_continue_is_the_notch_of_a_fold() -> None:
    onward = [(x2, y2, 3 * x2 - 2 * x1, 9 * y2) for x1, y1, x2, y2 in HEADS]
    assert found([*HEADS, *PARTS, *onward]) == [False] * 10


def test_heads_of_two_lines_beside_each_other_are_no_dimension() -> None:
    beside = [(x1, y1 + 5, x2, y2 + 5) for x1, y1, x2, y2 in (*HEADS[2:], PARTS[1])]
    assert found([*HEADS[:2], PARTS[0], *beside]) == [False] * 6


def test_a_dimension_in_the_colour_of_the_cuts_is_not_cut() -> None:
    """A tray whose dimension lies in its bottom, drawn like the outline and without a text."""
    outline = [*box(0, 0, 300, 200)]
    folds: list[Line] = [(100, 0, 100, 200), (200, 0, 200, 200)]
    shift = [(x1 + 100, y1 + 90, x2 + 100, y2 + 90) for x1, y1, x2, y2 in (*HEADS, *PARTS)]
    sheet = drawing_of((outline, style()), (folds, style(colour=1)), (shift, style()))
    assert words(classified(sheet)) == ["cut"] * 4 + ["crease"] * 2 + ["ignored"] * 6
    assert roles([*outline, *folds, *shift])[6:] == [Role.ARROW] * 6


def turn(lines: Sequence[Line], degrees: float) -> list[tuple[float, ...]]:
    """Return the lines turned about the origin."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    turned = np.array(lines).reshape(-1, 2) @ [[c, s], [-s, c]]
    return [tuple(line) for line in turned.reshape(-1, 4).tolist()]
