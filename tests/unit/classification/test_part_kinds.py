"""Bleeds, letters, legends, marks and frames, by the roles of their edges."""

from __future__ import annotations

import math

import numpy as np

from knifetip.classification.shape.roles import Role
from tests.support.classification import BLANK, box, roles, text


def diamond(half: float) -> list[tuple[float, float, float, float]]:
    """Return the sides of a square on its corner; ``half`` is half of its diagonal."""
    corner = [(half, 0.0), (0.0, half), (-half, 0.0), (0.0, -half)]
    return [(*corner[k], *corner[(k + 1) % 4]) for k in range(4)]


#: The outer one lies 3 mm outside the inner one.
INNER, OUTER = diamond(100.0), diamond(100.0 + 3.0 * math.sqrt(2.0))


def test_a_contour_3_mm_outside_a_blank_is_its_bleed() -> None:
    classified = roles([*INNER, (0, -100, 0, 100), *OUTER])
    assert classified == [Role.OUTLINE] * 4 + [Role.DIVIDER] + [Role.BLEED] * 4


def test_a_ring_in_a_ring_has_no_bleed() -> None:
    assert Role.BLEED not in roles([*INNER, *OUTER])


def test_a_contour_round_a_carton_at_varying_distance_is_enclosing() -> None:
    slanted = [(-3, -3, 340, -3), (340, -3, 303, 203), (303, 203, -3, 203), (-3, 203, -3, -3)]
    panels = [*BLANK, (0, 60, 300, 60), (0, 140, 300, 140)]
    assert roles([*panels, *slanted])[8:] == [Role.ENCLOSING] * 4


def letters(x: float, y: float) -> list[tuple[float, float, float, float]]:
    """Return the lines of the letters T, L and V, 5 mm high, at (x, y)."""
    t = [(x, y + 5, x + 3, y + 5), (x + 1.5, y, x + 1.5, y + 5)]
    ell = [(x + 5, y, x + 5, y + 5), (x + 5, y, x + 8, y)]
    return [*t, *ell, (x + 10, y + 5, x + 11.5, y), (x + 11.5, y, x + 13, y + 5)]


def test_small_shapes_in_a_row_are_letters_inside_and_outside() -> None:
    assert roles([*BLANK, *letters(20, 20)])[6:] == [Role.LETTER] * 6
    assert roles([*BLANK, *letters(20, -40)])[6:] == [Role.LETTER] * 6


def test_equal_holes_in_a_row_are_no_word() -> None:
    holes = [side for k in range(4) for side in box(20 + 8 * k, 20, 24 + 8 * k, 24)]
    assert set(roles([*BLANK, *holes])[6:]) == {Role.HOLE}


def test_a_line_beside_the_name_of_a_line_type_is_a_legend() -> None:
    sample = (0, -40, 20, -40)
    assert roles([*BLANK, sample], texts=(text(24, -41, "Crease"),))[6:] == [Role.LEGEND]
    assert roles([*BLANK, sample], texts=(text(24, -41, "Smith & Co"),))[6:] != [Role.LEGEND]


def test_a_cross_in_a_ring_beside_the_blank_is_a_mark() -> None:
    around = [
        (
            330 + 3 * math.cos(k),
            100 + 3 * math.sin(k),
            330 + 3 * math.cos(k + 1),
            100 + 3 * math.sin(k + 1),
        )
        for k in np.linspace(0.0, 2.0 * math.pi, 13)[:-1]
    ]
    ring = [(a, b, *around[(k + 1) % 12][:2]) for k, (a, b, _, _) in enumerate(around)]
    cross = [(325, 100, 335, 100), (330, 95, 330, 105)]
    assert set(roles([*BLANK, *ring, *cross])[6:]) == {Role.DEBRIS}


def test_a_narrow_slot_is_distinguished_from_a_window() -> None:
    classified = roles([*BLANK, *box(20, 20, 60, 24), *box(20, 60, 60, 100)])
    assert classified[6:] == [Role.SLOT] * 4 + [Role.HOLE] * 4
