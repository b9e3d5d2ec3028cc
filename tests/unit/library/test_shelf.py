"""The boards, wheels and machines of the library, with figures of the trade."""

from __future__ import annotations

import tomllib

import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.tool import CreaseWheel, Cutter
from knifetip.model.verdict import Verdict
from knifetip.verification.verify import verify
from tests.support.shapes import closed, dieline, edges

OUTLINE = (LineType.CUT, closed((0, 0), (400, 0), (400, 300), (0, 300)))
#: One line of each type on a sheet of 400 × 300 mm: creases along and across the grain.
ALL_TYPES = dieline(
    OUTLINE,
    (LineType.CREASE, edges(((100, 0), (100, 300)), ((100, 100), (300, 100)))),
    (LineType.HALF_CUT, edges(((320, 50), (320, 250)))),
    (LineType.PERFORATION, edges(((360, 50), (360, 250)))),
    (LineType.V_GROOVE, edges(((50, 50), (50, 250)))),
)


def judged(drawing: Dieline, machine: Machine, board: str) -> Verdict:
    used = load.board(board)
    toolpath = sequence([compensate(one) for one in plan(drawing, machine, used)], machine)
    text = process(toolpath, machine, machine.dialect).text
    return verify(text, drawing, (0.0, 0.0), machine, used)


@pytest.mark.parametrize(
    ("name", "caliper"),
    [
        ("fbb-0.3", 0.3),
        ("fbb-0.5", 0.5),
        ("fbb-0.6", 0.6),
        ("c-flute", 4.0),
        ("eb-flute", 4.5),
        ("bc-flute", 6.8),
        ("solid-1.0", 1.0),
        ("greyboard-1.0", 1.0),
        ("greyboard-4.0", 4.0),
        ("foam-5.0", 5.0),
        ("foam-10.0", 10.0),
    ],
)
def test_boards_have_the_caliper_of_their_name(name: str, caliper: float) -> None:
    assert load.board(name).caliper == caliper


@pytest.mark.parametrize("name", load.names("boards"))
def test_depths_are_fractions_of_the_caliper_that_are_usual_for_the_material(name: str) -> None:
    board = load.board(name)
    # Foam board is grooved and half-cut as far as its lower facing and its lower third.
    foam = board.material == "foam board"
    assert 0.25 <= board.crease_along / board.caliper <= board.crease_across / board.caliper <= 0.63
    assert 0.55 <= board.groove_depth / board.caliper <= (0.92 if foam else 0.75)
    assert board.half_cut_depth / board.caliper == pytest.approx(0.66 if foam else 0.5)


@pytest.mark.parametrize(
    ("name", "web"),
    # A quarter to three tenths of the thickness.
    [("greyboard-1.0", 0.3), ("greyboard-4.0", 1.0), ("solid-1.0", 0.3), ("foam-10.0", 0.8)],
)
def test_the_board_that_a_groove_leaves(name: str, web: float) -> None:
    board = load.board(name)
    assert board.caliper - board.groove_depth == pytest.approx(web)


@pytest.mark.parametrize(
    ("board", "rim"),
    [
        ("fbb-0.3", 0.7),
        ("fbb-0.6", 0.7),
        ("solid-1.0", 1.4),
        ("greyboard-1.0", 1.4),
        ("e-flute", 3.0),
        ("b-flute", 3.0),
        ("c-flute", 6.0),
        ("bc-flute", 6.0),
        ("foam-10.0", 6.0),
    ],
)
def test_the_sample_table_creases_each_board_with_the_rim_for_its_caliper(
    board: str, rim: float
) -> None:
    machine = load.machine("sample-table")
    stations = {
        one.station
        for one in plan(ALL_TYPES, machine, load.board(board))
        if one.line_type == LineType.CREASE
    }
    tools = [station.tool for station in machine.stations if station.number in stations]
    assert [tool.width for tool in tools if isinstance(tool, CreaseWheel)] == [rim]


@pytest.mark.parametrize("board", load.names("boards"))
def test_the_sample_table_makes_all_line_types_in_all_boards(board: str) -> None:
    assert judged(ALL_TYPES, load.machine("sample-table"), board).findings == ()


@pytest.mark.parametrize("machine", ["router-table", "fine-router-table"])
def test_the_routers_reach_the_whole_table_with_each_cutter(machine: str) -> None:
    used = load.machine(machine)
    cutters = [one for one in used.stations if isinstance(one.tool, Cutter)]
    assert {one.tool.diameter for one in cutters} == (
        {6.0} if machine == "router-table" else {1.5, 2.0, 3.0}
    )
    for station in cutters:
        assert used.x.low <= station.x
        assert station.x + used.width <= used.x.high
        assert used.y.low <= station.y
        assert station.y + used.height <= used.y.high


@pytest.mark.parametrize("width", [1.0, 1.4, 3.0, 6.0])
def test_crease_wheels_of_the_library_are_named_after_their_rim(width: float) -> None:
    name = f"crease-wheel-{width}"
    wheel = load.parse_tool(name, tomllib.loads(load.library_text("tools", name)))
    assert isinstance(wheel, CreaseWheel)
    assert wheel.width == width
