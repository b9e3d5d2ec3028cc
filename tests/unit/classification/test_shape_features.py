"""Roles and other features that edges have by their shape alone."""

from __future__ import annotations

import math

import numpy as np
import pytest

from knifetip.classification.shape.features import extract_shape_features
from knifetip.classification.shape.roles import Role
from tests.support.classification import BLANK, box, roles, text


def test_a_blank_has_an_outline_and_lines_that_divide_panels() -> None:
    assert roles(BLANK) == [Role.OUTLINE] * 4 + [Role.DIVIDER] * 2


def test_a_closed_line_in_a_panel_is_a_hole_whether_lines_or_arcs() -> None:
    classified = roles(
        [*BLANK, *box(20, 20, 40, 40), (130, 100, 170, 100), (170, 100, 130, 100)],
        [0.0] * 10 + [1.0, 1.0],
    )
    assert classified[6:] == [Role.HOLE] * 4 + [Role.SLOT] * 2


def test_a_line_that_ends_in_a_panel_is_a_slit_and_an_isolated_one_is_free() -> None:
    classified = roles([*BLANK, (100, 50, 140, 50), (20, 50, 60, 50)])
    assert classified[6:] == [Role.SLIT, Role.FREE]


def test_a_line_outside_belongs_to_no_blank() -> None:
    assert roles([*BLANK, (0, -30, 300, -30)])[6:] == [Role.STRAY]


def test_a_crease_that_ends_a_little_short_divides_panels() -> None:
    short = [*box(0, 0, 300, 200), (100, 0.7, 100, 199.3)]
    assert roles(short)[4] == Role.DIVIDER
    assert roles([*box(0, 0, 300, 200), (100, 3, 100, 197)])[4] == Role.FREE


def test_a_row_of_dashes_divides_panels() -> None:
    dashes = [(100.0, 9.0 * i, 100.0, 9.0 * i + 6.0) for i in range(22)]
    ends = np.array([*box(0, 0, 300, 198), *dashes], float).reshape(-1, 2, 2)
    classified = extract_shape_features(ends, np.zeros(len(ends)))
    assert set(classified.role[4:]) == {Role.DIVIDER}
    assert classified.dashed[4:].all()
    assert not classified.dashed[:4].any()


def test_a_rectangle_round_a_blank_is_a_frame_and_its_boxes_belong_to_it() -> None:
    block = [*box(-50, -60, 350, 250), (250, -60, 250, -30), (250, -30, 350, -30)]
    assert roles([*BLANK, *block])[6:] == [Role.FRAME] * 6
    assert roles([*BLANK, *block])[:6] == roles(BLANK)


def test_a_rectangle_with_a_plain_hole_is_no_frame() -> None:
    assert roles([*box(0, 0, 300, 200), *box(50, 50, 250, 150)]) == (
        [Role.OUTLINE] * 4 + [Role.HOLE] * 4
    )


def test_a_double_frame_is_a_frame() -> None:
    classified = roles([*BLANK, *box(-50, -60, 350, 250), *box(-60, -70, 360, 260)])
    assert classified[6:] == [Role.FRAME] * 8


def test_boxes_with_texts_beside_a_blank_are_a_title_block() -> None:
    table = [*box(320, 0, 380, 40), (320, 20, 380, 20)]
    assert set(roles([*BLANK, *table], texts=(text(325, 5), text(325, 25)))[6:]) == {Role.TABLE}
    assert set(roles([*BLANK, *table])[6:]) == {Role.OUTLINE, Role.DIVIDER}


def test_a_small_closed_shape_outside_is_a_mark() -> None:
    assert roles([*BLANK, *box(-20, 0, -15, 5)])[6:] == [Role.MARK] * 4


def test_creases_inside_an_open_outline_are_no_outline() -> None:
    """The outline of a tray lacks a piece; its creases form a closed contour, but are no
    outline.
    """
    walls = [(-40, -40, 340, -40), (340, -40, 340, 240), (340, 240, -40, 240), (-40, 240, -40, 20)]
    creases = [*box(0, 0, 300, 200), (0, 0, 0, -40), (300, 0, 300, -40)]
    classified = roles([*walls, *creases])
    assert Role.OUTLINE not in classified
    assert Role.OPEN in classified


def test_two_lines_close_together_are_a_pair() -> None:
    lines = [*BLANK, (103, 0, 103, 200)]
    classified = extract_shape_features(
        np.array(lines, float).reshape(-1, 2, 2), np.zeros(len(lines))
    )
    assert classified.paired.tolist() == [False] * 4 + [True, False, True]


def test_edges_drawn_twice_have_the_roles_of_single_ones() -> None:
    twice = [(x1, y1, x0, y0) for x0, y0, x1, y1 in BLANK]
    assert roles([*BLANK, *twice]) == roles(BLANK) * 2


@pytest.mark.parametrize("turn", [0.3, 1.1, 2.0])
def test_a_rotated_blank_has_the_same_roles(turn: float) -> None:
    c, s = math.cos(turn), math.sin(turn)
    lines = [*BLANK, *box(20, 20, 40, 40), (100, 50, 140, 50)]
    turned = np.array(lines, float).reshape(-1, 2, 2) @ np.array([[c, s], [-s, c]])
    classified = [
        Role(int(role)) for role in extract_shape_features(turned, np.zeros(len(lines))).role
    ]
    assert classified == roles(lines)


def test_without_a_unit_tolerances_are_relative_to_the_drawing() -> None:
    metres = np.array(BLANK, float).reshape(-1, 2, 2) / 1000.0
    classified = extract_shape_features(metres, np.zeros(len(BLANK)), unit_known=False)
    assert [Role(int(role)) for role in classified.role] == roles(BLANK)


def test_very_short_edges_have_the_role_of_the_previous_edge() -> None:
    steps = [(0.02 * i, 0.0, 0.02 * (i + 1), 0.0) for i in range(5)]
    lines = [(-100, 0, 0, 0), *steps, (0.1, 0, 200, 0), (200, 0, 200, 150), (200, 150, -100, 150),
             (-100, 150, -100, 0)]  # fmt: skip
    assert set(roles(lines)) == {Role.OUTLINE}


def test_a_hundred_blanks_on_a_sheet_are_a_hundred_blanks() -> None:
    lines = [
        (x0 + 400 * (i % 10), y0 + 300 * (i // 10), x1 + 400 * (i % 10), y1 + 300 * (i // 10))
        for i in range(100)
        for x0, y0, x1, y1 in BLANK
    ]
    assert roles(lines) == roles(BLANK) * 100


def test_no_edges_have_no_roles() -> None:
    assert len(extract_shape_features(np.zeros((0, 2, 2)), np.zeros(0)).role) == 0
