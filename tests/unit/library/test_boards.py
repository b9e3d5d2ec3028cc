"""What a board may ask for beyond its caliper: passes, bridges, double creases, chords."""

from __future__ import annotations

from typing import Any

import pytest

from knifetip.errors import LibraryError
from knifetip.library import load

FIELDS: dict[str, Any] = {
    "title": "A board",
    "material": "greyboard",
    "caliper": 2.0,
    "grain": 90.0,
    "crease_along": 0.6,
    "crease_across": 0.65,
    "end_clearance": 0.2,
    "groove_depth": 1.3,
    "groove_overcut": 3.0,
    "half_cut_depth": 1.0,
    "perforation": [3.0, 2.0],
    "short_crease": "press",
}
MORE = {
    "bridge_width": 0.5,
    "bridge_spacing": 150.0,
    "double_crease": 3.0,
    "groove_pass": 0.5,
    "groove_curve": 0.1,
}


def test_a_board_that_says_nothing_asks_for_nothing() -> None:
    board = load.parse_board("a", FIELDS)
    assert [getattr(board, key) for key in MORE] == [0.0] * 5


def test_what_it_asks_for_is_read() -> None:
    board = load.parse_board("a", FIELDS | MORE)
    assert {key: getattr(board, key) for key in MORE} == MORE


@pytest.mark.parametrize("key", MORE)
@pytest.mark.parametrize("value", [-1.0, float("nan"), "wide"])
def test_what_is_no_measure_is_refused(key: str, value: float | str) -> None:
    with pytest.raises(LibraryError, match=key):
        load.parse_board("a", FIELDS | {key: value})


def test_passes_and_bridges_beyond_all_sense_are_refused() -> None:
    with pytest.raises(LibraryError, match="more than 50 passes"):
        load.parse_board("a", FIELDS | {"groove_pass": 0.001})
    with pytest.raises(LibraryError, match="must be 10 or more"):
        load.parse_board("a", FIELDS | {"bridge_spacing": 0.5})


def test_the_shelf_keeps_bridges_and_double_creases_off() -> None:
    for name in load.names("boards"):
        board = load.board(name)
        assert [getattr(board, key) for key in MORE] == [0.0] * 5
