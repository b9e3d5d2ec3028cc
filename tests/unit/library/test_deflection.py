"""The deflection of a tool in the TOML of a board."""

from __future__ import annotations

import tomllib

from knifetip.library.deflection import deflection_toml, replace_deflection
from knifetip.model.board import Deflection

BOARD = 'title = "A board"\ncaliper = 2.0\n'


def test_a_written_table_is_read_back() -> None:
    read = tomllib.loads(deflection_toml(Deflection("Router", 0.08, 0.05)))
    assert read == {"deflection": {"Router": {"x": 0.08, "y": 0.05}}}


def test_a_name_with_blanks_is_quoted() -> None:
    read = tomllib.loads(deflection_toml(Deflection('Router "big" 6 mm', 0.08, 0.05)))
    assert list(read["deflection"]) == ['Router "big" 6 mm']


def test_a_deflection_is_added_to_a_board() -> None:
    read = tomllib.loads(replace_deflection(BOARD, Deflection("Router", 0.08, 0.05)))
    assert read == {"title": "A board", "caliper": 2.0} | {
        "deflection": {"Router": {"x": 0.08, "y": 0.05}}
    }


def test_an_earlier_deflection_of_the_same_tool_is_replaced() -> None:
    once = replace_deflection(
        replace_deflection(BOARD, Deflection("Router", 0.1, 0.2)), Deflection("Beam 2", 0.3, 0.4)
    )
    again = tomllib.loads(replace_deflection(once, Deflection("Router", 0.08, 0.05)))
    assert again["deflection"] == {
        "Beam 2": {"x": 0.3, "y": 0.4},
        "Router": {"x": 0.08, "y": 0.05},
    }
    quoted = tomllib.loads(replace_deflection(once, Deflection("Beam 2", 0.5, 0.6)))
    assert quoted["deflection"]["Beam 2"] == {"x": 0.5, "y": 0.6}
