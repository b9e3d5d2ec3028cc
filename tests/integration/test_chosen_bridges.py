"""Bridges that the user has placed: programs, their verdicts, and bridges without room."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import unary_union

from knifetip import pipeline
from knifetip.errors import PlanError
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.job_options import BridgeAt, JobOptions
from knifetip.model.tool import DiscTool
from knifetip.model.toolpath import Motion
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline

#: A blank (edges 0 to 3) with a hole (4 to 7).
LINE = dieline(
    (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
    (LineType.CUT, closed((150, 150), (180, 150), (180, 180), (150, 180))),
)
#: One bridge of 2 mm at (150, 100), and one of 3 mm at (300, 220).
TWO = (BridgeAt(edges=(0,), at=0.25, width=2.0), BridgeAt(edges=(1,), at=0.8, width=3.0))
TARGETS = [
    ("demo-table", "fbb-0.4"),
    ("demo-table", "greyboard-3.0"),  # in two passes
    ("router-table", "greyboard-3.0"),
    ("laser-table", "fbb-0.4"),
    ("drag-knife-hpgl", "fbb-0.4"),
]


def board_of(name: str, spacing: float = 0.0) -> Board:
    """Return a board that requires bridges of 1 mm at most ``spacing`` mm apart, or none."""
    return replace(load.board(name), bridge_width=1.0 if spacing else 0.0, bridge_spacing=spacing)


def compiled(machine: str, board: Board, *bridges: BridgeAt) -> Compiled:
    drawn = drawing(LINE.ends, [("CUT", 7, "CONTINUOUS")] * len(LINE), bulge=LINE.bulge)
    options = JobOptions(bridges=bridges)
    return pipeline.compile(drawn, LINE, load.machine(machine), board, options=options)


def refused(made: Compiled, machine: str, board: Board, *bridges: BridgeAt) -> set[str]:
    """Return the codes of the findings that refuse a program for other bridges."""
    options = JobOptions(bridges=bridges)
    found = pipeline.verify(
        made.program.text, LINE, made.placement, load.machine(machine), board, options=options
    )
    return {one.message.code for one in found.findings if one.refuses}


@pytest.mark.parametrize("spacing", [0.0, 120.0])
@pytest.mark.parametrize(("machine", "name"), TARGETS)
def test_exactly_the_placed_bridges_stay(machine: str, name: str, spacing: float) -> None:
    board = board_of(name, spacing)
    made = compiled(machine, board, *TWO)
    assert [one.message.code for one in made.verdict.findings if one.refuses] == []
    assert refused(made, machine, board, *TWO) == set()
    moved = (BridgeAt(edges=(0,), at=0.3, width=2.0), TWO[1])
    assert refused(made, machine, board, *moved) == {
        "verify.bridge-missing",
        "verify.bridge-not-chosen",
    }
    assert refused(made, machine, board, TWO[0]) == {"verify.bridge-not-chosen"}
    wider = (replace_width(TWO[0], 2.5), TWO[1])
    assert refused(made, machine, board, *wider) == {"verify.bridge-width"}
    # Without the option the bridges are faults.
    assert refused(made, machine, board)


def replace_width(bridge: BridgeAt, width: float) -> BridgeAt:
    return bridge.model_copy(update={"width": width})


def test_the_board_stays_whole_at_the_bridges() -> None:
    """The area that the router's disc sweeps, by shapely, leaves both bridges and no more."""
    made = compiled("router-table", board_of("greyboard-3.0"), *TWO)
    path = made.toolpath
    tool = load.machine("router-table").station(int(path.tool[path.source == 0][0])).tool
    assert isinstance(tool, DiscTool)
    radius = tool.radius
    feeds = np.flatnonzero((path.motion == Motion.FEED) & (path.pose[1:, 2] < 0.0))
    xy = path.pose[:, :2] - made.placement
    swept = unary_union([LineString(xy[[row, row + 1]]).buffer(radius) for row in feeds])
    # In the middle of the kerf, what two positions of the disc leave is as wide as the bridge.
    kerf = Polygon([(100, 100), (300, 100), (300, 250), (100, 250)]).buffer(radius).exterior
    left = _parts(kerf.difference(swept.buffer(1e-3)))
    wide = sorted((part for part in left if part.length > 0.5), key=lambda one: one.length)
    assert [round(part.length, 1) for part in wide] == [2.0, 3.0]
    for part, middle in zip(wide, ((150, 100), (300, 220)), strict=True):
        assert part.centroid.distance(Point(middle)) == pytest.approx(radius, abs=0.01)


def _parts(shape: object) -> list[LineString]:
    return [LineString(one.coords) for one in getattr(shape, "geoms", [shape])]


def test_an_outline_without_placed_bridges_keeps_those_of_the_board() -> None:
    board = board_of("fbb-0.4", 120.0)
    usual = compiled("demo-table", board)
    assert usual.verdict.accepted
    assert refused(usual, "demo-table", board, *TWO)


@pytest.mark.parametrize("machine", ["demo-table", "router-table"])
@pytest.mark.parametrize(
    ("bridges", "code"),
    [
        ((BridgeAt(edges=(0,), at=0.0, width=2.0),), "bridge.at-corner"),
        (
            (BridgeAt(edges=(0,), at=0.5, width=2.0), BridgeAt(edges=(0,), at=0.505, width=2.0)),
            "bridge.too-near",
        ),
        ((BridgeAt(edges=(8,), width=2.0),), "edge-choice.no-edge"),
    ],
)
def test_a_bridge_without_room_is_refused(
    machine: str, bridges: tuple[BridgeAt, ...], code: str
) -> None:
    with pytest.raises(PlanError) as caught:
        compiled(machine, board_of("greyboard-3.0"), *bridges)
    message = caught.value.message
    inner = message.arguments["error"] if message.code == "error.at-edge" else message
    assert inner.code == code
