"""Outlines with pieces that are missing between lines that face each other."""

from __future__ import annotations

import pytest

from knifetip.classification.shape.roles import Role
from tests.support.classification import Line, roles

#: A blank of 300 × 200 whose corners were arcs of 20 mm, and its folds.
SIDES: list[Line] = [(20, 0, 280, 0), (300, 20, 300, 180), (280, 200, 20, 200), (0, 180, 0, 20)]
FOLDS: list[Line] = [(100, 0, 100, 200), (200, 0, 200, 200)]
#: The same blank with sharp corners, and a gap in one side.
GAP: list[Line] = [(0, 0, 120, 0), (140, 0, 300, 0), (300, 0, 300, 200), (300, 200, 0, 200),
                   (0, 200, 0, 0)]  # fmt: skip
#: The same with a corner of 45° that was cut off by 10 mm on both sides.
OBLIQUE: list[Line] = [(0, 0, 240, 0), (257.0710678, 7.0710678, 300, 50), (300, 50, 300, 200),
                       (300, 200, 0, 200), (0, 200, 0, 0)]  # fmt: skip


@pytest.mark.parametrize("sides", [SIDES, GAP, OBLIQUE], ids=["corners", "gap", "45°"])
def test_a_missing_piece_closes_the_outline(sides: list[Line]) -> None:
    found = roles([*sides, *FOLDS])
    assert found == [Role.OUTLINE] * len(sides) + [Role.DIVIDER] * 2


@pytest.mark.parametrize(
    "sides",
    [
        pytest.param([*SIDES[:3], (0, 170, 0, 20)], id="unequal distances from the corner"),
        pytest.param([*GAP[:1], (140, 9, 300, 9), *GAP[2:]], id="lines that do not face"),
        pytest.param([(0, 0, 60, 0), (240, 0, 300, 0), *GAP[2:]], id="longer than the lines"),
        pytest.param([(0, 0, 300, 0), (0, 0, 0, 200), (300, 0, 300, 200)], id="a side"),
        pytest.param([*GAP, (130, -10, 130, -50)], id="a free end that faces two others"),
    ],
)
def test_other_open_outlines_stay_open(sides: list[Line]) -> None:
    assert Role.OUTLINE not in roles([*sides, *FOLDS])


def test_slits_in_a_panel_that_face_each_other_are_not_joined() -> None:
    slits: list[Line] = [(20, 100, 45, 100), (60, 100, 85, 100)]
    found = roles([*SIDES, *FOLDS, *slits])
    assert found == [Role.OUTLINE] * 4 + [Role.DIVIDER] * 2 + [Role.FREE] * 2
