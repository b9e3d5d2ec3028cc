"""White lines: not visible on white paper, visible on a dark background."""

from __future__ import annotations

import numpy as np

from knifetip.drawing_builder.colours import UNKNOWN_COLOUR
from knifetip.drawing_builder.white_lines import is_white, unseen_white_lines

RED, WHITE, BLACK = 0xFF0000, 0xFFFFFF, 0x000000
SMALL, LARGE = (10.0, 10.0, 20.0, 20.0), (0.0, 0.0, 100.0, 100.0)


def unseen(
    *paths: tuple[int | None, int | None, tuple[float, ...]], page: int | None = None
) -> list[bool]:
    strokes, fills, boxes = zip(*paths, strict=True)
    return list(map(bool, unseen_white_lines(strokes, fills, np.array(boxes), page=page)))


def test_white_is_at_least_98_percent_of_each_component() -> None:
    assert is_white(0xFAFAFA)
    assert not is_white(0xFFFFF0)
    assert not is_white(UNKNOWN_COLOUR)


def test_a_white_line_beside_others_is_not_visible() -> None:
    assert unseen((RED, None, LARGE), (WHITE, None, SMALL)) == [False, True]


def test_a_drawing_with_white_lines_only_is_visible() -> None:
    assert unseen((WHITE, None, LARGE), (WHITE, None, SMALL)) == [False, False]


def test_a_white_line_on_a_dark_area_is_visible_if_the_area_is_below_it() -> None:
    background = (None, BLACK, LARGE)
    assert unseen(background, (RED, None, LARGE), (WHITE, None, SMALL)) == [False] * 3
    assert unseen((RED, None, LARGE), (WHITE, None, SMALL), background) == [False, True, False]


def test_a_white_line_on_a_dark_page_is_visible() -> None:
    assert unseen((RED, None, LARGE), (WHITE, None, SMALL), page=0x202020) == [False, False]
