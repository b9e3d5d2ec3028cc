"""The judge against the router: what it makes is accepted, and a wrong offset is refused."""

from __future__ import annotations

from dataclasses import replace

import pytest

from knifetip import compensate, plan, process, sequence, verify
from knifetip.compensation import radius
from knifetip.library import load
from knifetip.model.board import Deflection
from knifetip.model.dieline import LineType
from shapes import closed, dieline, edges

ROUTER = load.machine("router-table")
BOARD = load.board("greyboard-3.0")
LINE = dieline(
    (LineType.CUT, closed((100, 100), (300, 100), (300, 200), (200, 200), (200, 250), (100, 250))),
    (LineType.CUT, closed((120, 120), (170, 120), (170, 160), (120, 160))),
    (LineType.CUT, edges(((200, 120), (200, 180)))),
    bulge={1: 0.2, 7: -0.1},
)


def verdict(board=BOARD, dialect="linuxcnc", corner="auto"):
    work = [replace(operation, corner=corner) for operation in plan(LINE, ROUTER, board)]
    toolpath = sequence([compensate(operation) for operation in work], ROUTER)
    return verify(process(toolpath, ROUTER, dialect).text, LINE, (0.0, 0.0), ROUTER, board)


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
@pytest.mark.parametrize("corner", ["B", "C", "D", "auto"])
def test_what_the_router_makes_is_accepted(dialect, corner):
    result = verdict(dialect=dialect, corner=corner)
    assert result.accepted, result.findings[:3]


@pytest.mark.parametrize("factor", [0.99, 1.01])
def test_a_radius_wrong_by_a_hundredth_is_refused(monkeypatch, factor):
    right = radius.equidistant

    def wrong(paths, distance, side, **more):
        return right(paths, distance * factor, side, **more)

    monkeypatch.setattr(radius, "equidistant", wrong)
    assert not verdict().accepted


def test_a_cutter_on_the_wrong_side_is_refused(monkeypatch):
    right = radius.equidistant

    def wrong(paths, distance, side, **more):
        return right(paths, distance, -side, **more)

    monkeypatch.setattr(radius, "equidistant", wrong)
    monkeypatch.setattr(radius, "_with_leads", lambda _operation, _cutter, way: _bare(way))
    assert not verdict().accepted


def _bare(way):
    return way.paths, way.segment, radius._all(radius.Motion.FEED, way.segment)


def test_a_deflection_that_the_board_knows_is_accepted_and_one_aimed_outwards_is_not(monkeypatch):
    soft = replace(BOARD, deflection=(Deflection("Router", 0.08, 0.05),))
    result = verdict(soft)
    assert result.accepted, result.findings[:3]
    right = radius.deflected
    monkeypatch.setattr(radius, "deflected", lambda paths, side, x, y: right(paths, -side, x, y))
    assert not verdict(soft).accepted
