"""A deflection in a board's file."""

from __future__ import annotations

import tomllib

from knifetip.library.deflection import stored, table
from knifetip.model.board import Deflection

BOARD = 'title = "A board"\ncaliper = 2.0\n'


def test_a_table_reads_back() -> None:
    read = tomllib.loads(table(Deflection("Router", 0.08, 0.05)))
    assert read == {"deflection": {"Router": {"x": 0.08, "y": 0.05}}}


def test_a_name_that_is_no_bare_key_is_quoted() -> None:
    read = tomllib.loads(table(Deflection('Router "big" 6 mm', 0.08, 0.05)))
    assert list(read["deflection"]) == ['Router "big" 6 mm']


def test_it_is_added_to_a_board_and_the_rest_stays() -> None:
    read = tomllib.loads(stored(BOARD, Deflection("Router", 0.08, 0.05)))
    assert read == {"title": "A board", "caliper": 2.0} | {
        "deflection": {"Router": {"x": 0.08, "y": 0.05}}
    }


def test_an_earlier_one_of_the_same_tool_gives_way_and_that_of_another_stays() -> None:
    once = stored(stored(BOARD, Deflection("Router", 0.1, 0.2)), Deflection("Beam 2", 0.3, 0.4))
    again = tomllib.loads(stored(once, Deflection("Router", 0.08, 0.05)))
    assert again["deflection"] == {
        "Beam 2": {"x": 0.3, "y": 0.4},
        "Router": {"x": 0.08, "y": 0.05},
    }
    quoted = tomllib.loads(stored(once, Deflection("Beam 2", 0.5, 0.6)))
    assert quoted["deflection"]["Beam 2"] == {"x": 0.5, "y": 0.6}
