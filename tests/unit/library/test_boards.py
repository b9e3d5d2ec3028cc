"""Optional fields of a board: passes, bridges, double creases, chords."""

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


def test_optional_fields_default_to_zero() -> None:
    board = load.parse_board("a", FIELDS)
    assert [getattr(board, key) for key in MORE] == [0.0] * 5


def test_optional_fields_are_read() -> None:
    board = load.parse_board("a", FIELDS | MORE)
    assert {key: getattr(board, key) for key in MORE} == MORE


@pytest.mark.parametrize("key", MORE)
@pytest.mark.parametrize("value", [-1.0, float("nan"), "wide"])
def test_values_that_are_not_lengths_are_refused(key: str, value: float | str) -> None:
    with pytest.raises(LibraryError, match=key):
        load.parse_board("a", FIELDS | {key: value})


def test_the_fold_angle_is_90_degrees_unless_the_board_states_another() -> None:
    assert load.parse_board("a", FIELDS).fold_angle == 90.0
    assert load.parse_board("a", FIELDS | {"fold_angle": 60.0}).fold_angle == 60.0
    for value in (0.0, 181.0, float("nan"), "flat"):
        with pytest.raises(LibraryError, match="fold_angle"):
            load.parse_board("a", FIELDS | {"fold_angle": value})


def test_absurd_passes_and_bridges_are_refused() -> None:
    with pytest.raises(LibraryError, match="more than 50 passes"):
        load.parse_board("a", FIELDS | {"groove_pass": 0.001})
    with pytest.raises(LibraryError, match="at least 10"):
        load.parse_board("a", FIELDS | {"bridge_spacing": 0.5})


def test_boards_of_the_library_have_no_optional_fields() -> None:
    for name in load.names("boards"):
        board = load.board(name)
        assert [getattr(board, key) for key in MORE] == [0.0] * 5


@pytest.mark.parametrize("base", ["", "rigid"])
def test_only_creases_on_a_soft_base_may_be_deeper_than_the_board(base: str) -> None:
    deep = {**FIELDS, "crease_across": 2.3}
    assert load.parse_board("a", {**deep, "crease_base": "soft"}).crease_across == 2.3
    with pytest.raises(LibraryError, match="crease_across"):
        load.parse_board("a", {**deep, "crease_base": base})
    with pytest.raises(LibraryError, match="half_cut_depth"):
        load.parse_board("a", {**FIELDS, "crease_base": "soft", "half_cut_depth": 2.3})
