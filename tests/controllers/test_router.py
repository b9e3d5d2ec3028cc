"""Router programs interpreted by LinuxCNC: the disc touches the part and never enters it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

from knifetip import compensate, plan, process, sequence
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.dieline import LineType
from tests.controllers.linuxcnc_rs274 import (
    ABSENT,
    ARC,
    RS274,
    TRAVERSE,
    Moves,
    TipTool,
    read_program,
)
from tests.support.shapes import closed, dieline, edges

pytestmark = [pytest.mark.controller, pytest.mark.skipif(RS274 is None, reason=ABSENT)]

BLANK = [(100, 100), (300, 100), (300, 200), (200, 200), (200, 250), (100, 250)]
HOLE = [(120, 120), (170, 120), (170, 160), (120, 160)]
#: The blank with its hole as a shapely polygon, and the radius r of the cutter.
PART = shapely.Polygon(BLANK, [HOLE])
RADIUS = 3.0
TABLE = {4: TipTool("router", 3.0)}


def program(corner: str) -> bytes:
    machine, board = load.machine("router-table"), load.board("greyboard-3.0")
    line = dieline(
        (LineType.CUT, closed(*BLANK)),
        (LineType.CUT, closed(*HOLE)),
        (LineType.CUT, edges(((200, 120), (200, 180)))),
    )
    work = [replace(operation, corner=corner) for operation in plan(line, machine, board)]
    toolpath = sequence([compensate(operation) for operation in work], machine)
    return process(toolpath, machine, "linuxcnc").text


def way(moves: Moves, row: int) -> F64:
    """Return points along the move in a row of ``moves``, as LinuxCNC interprets it, (n, 2)."""
    start, end, middle = moves.start[row, :2], moves.end[row, :2], moves.centre[row]
    share = np.linspace(0.0, 1.0, 33)[:, None]
    if moves.kind[row] != ARC:
        return start + share * (end - start)
    first, last = start - middle, end - middle
    turn = np.arctan2(last[1], last[0]) - np.arctan2(first[1], first[0])
    sweep = turn % (2 * np.pi) if moves.turns[row] > 0 else -(-turn % (2 * np.pi))
    angle = np.arctan2(first[1], first[0]) + sweep * share[:, 0]
    around: F64 = middle + np.hypot(*first) * np.column_stack([np.cos(angle), np.sin(angle)])
    return around


@pytest.mark.parametrize("corner", ["B", "C", "D", "auto"])
def test_linuxcnc_moves_the_router_around_the_part(corner: str) -> None:
    text = program(corner)
    assert b"T4 M6 G43" in text
    assert b"M3 S18000\nG4 P2\n" in text
    reading = read_program(text, TABLE)
    assert reading.accepted, reading.stderr
    moves = reading.moves
    deep = (np.maximum(moves.start[:, 2], moves.end[:, 2]) < 0.0) & (moves.kind != TRAVERSE)
    assert (moves.station[deep] == 4).all()
    assert moves.oscillates[deep].all()
    points = np.concatenate([way(moves, row) for row in np.flatnonzero(deep).tolist()])
    places = shapely.points(points)
    slit = np.abs(points[:, 0] - 200.0) + np.maximum(120.0 - points[:, 1], 0.0) < 1e-9
    slit &= points[:, 1] <= 180.0
    beside = shapely.distance(PART, places)
    # Rounding of X and Y by half of the last decimal, and again by rs274, which prints 4.
    assert beside[~slit].min() >= RADIUS - 2e-4
    swept = shapely.union_all(shapely.linestrings(
        [way(moves, row) for row in np.flatnonzero(deep & (moves.start[:, 2] < -0.299)).tolist()]
    ).tolist()).buffer(RADIUS, quad_segs=64)  # fmt: skip
    # All edges are touched except 3 mm to either side of five inside corners (within 0.002 mm).
    left = PART.boundary.difference(swept.buffer(2e-3)).length
    assert left == pytest.approx(5 * 6.0 - 10 * 0.11, abs=0.3)
    assert swept.intersection(PART).area == pytest.approx(60.0 * 6.0 + np.pi * 9.0, abs=2.0)


def test_two_passes_cut_through_a_board_of_three_millimetres() -> None:
    depths = read_program(program("B"), TABLE).moves.end[:, 2]
    # 3.3 mm in passes of at most 3: to z 1.35, then to −0.3.
    assert {1.35, -0.3} <= {round(float(z), 4) for z in depths}
