"""Durations, compared with results worked out by hand and with the simulated table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.library import load
from knifetip.model.machine import Machine
from knifetip.model.tool import Cutter
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing import linuxcnc
from knifetip.sequencing.duration import duration, durations
from knifetip.simulators.grbl.table import Table
from tests.support.shapes import MACHINE, toolpath
from tests.support.truth.named import SAMPLES, Named

R, F, S = Motion.RAPID, Motion.FEED, Motion.SWIVEL
#: A machine that does not wait for pistons.
QUICK = replace(MACHINE, settle=0.0, dialect="grblhal")


def path(
    *moves: tuple[Motion, float, float, float, float, float],
    start: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0),
    bulge: Sequence[float] = (),
) -> Toolpath:
    """Return a toolpath of moves (motion, x, y, z, c, feed) from a start pose."""
    pose = np.array([start, *[move[1:5] for move in moves]], float)
    n = len(moves)
    bent = np.zeros(n)
    bent[: len(bulge)] = bulge
    return toolpath(pose, [(move[0], move[5], 1) for move in moves], bulge=bent)


def test_a_long_feed_is_a_trapezoid() -> None:
    # 400 mm/s at 8000 mm/s²: 800/400 and once 400/8000.
    assert duration(path((F, 800, 0, 0, 0, 24000)), QUICK) == pytest.approx(2.05)


def test_a_short_rapid_is_a_triangle() -> None:
    # 50 mm never reaches 1500 mm/s: 2 √(50/8000).
    assert duration(path((R, 50, 0, 0, 0, 0)), QUICK) == pytest.approx(0.158113883)


def test_both_axes_accelerate_a_diagonal() -> None:
    # Acceleration √2 · 8000 along the diagonal, 400 mm/s: 565.685/400 + 400/11313.7.
    expected = 565.685425 / 400.0 + 400.0 / 11313.70850
    assert duration(path((F, 400, 400, 0, 0, 24000)), QUICK) == pytest.approx(expected)


def test_a_tangent_joint_is_passed_at_speed_and_a_reversal_stops() -> None:
    on = path((F, 400, 0, 0, 0, 24000), (F, 800, 0, 0, 0, 24000))
    assert duration(on, QUICK) == pytest.approx(2.05)
    back = path((F, 400, 0, 0, 0, 24000), (F, 0, 0, 0, 0, 24000))
    # Velocity may jump by 16 mm/s, so 8 mm/s before and after: almost twice 1.05.
    assert 2.09 < duration(back, QUICK) < 2.1


def test_a_right_angle_is_slower_than_straight_on_by_slowing_down_and_up() -> None:
    corner = path((F, 400, 0, 0, 0, 24000), (F, 400, 400, 0, 0, 24000))
    # From 400 to 16 mm/s and back costs (384/8000)·(1 - 208/400) each way.
    lost = 2.0 * 384.0 / 8000.0 * (1.0 - 208.0 / 400.0)
    assert duration(corner, QUICK) == pytest.approx(2.05 + lost)


def test_an_arc_keeps_its_centripetal_acceleration() -> None:
    # A half circle of radius 5 mm: v² = 8000 · 5, v = 200 instead of 400 mm/s; 15.70796 mm.
    half = path((F, 0, 10, 0, 0, 24000), bulge=[1.0])
    assert duration(half, QUICK) == pytest.approx(15.707963 / 200.0 + 200.0 / 8000.0)


def test_a_swivel_has_its_feed_in_degrees() -> None:
    # 90° at 1800°/s and 36000°/s²: 90/1800 + 1800/36000.
    turn = path((S, 0, 0, 0, 90, 108000))
    assert duration(turn, QUICK) == pytest.approx(0.1)


def test_c_limits_the_speed_of_an_arc() -> None:
    # A half circle of radius 100 mm would take 0.785 s; C turns by 180° at 90°/s, which takes 2 s.
    slow = replace(QUICK, c=replace(QUICK.c, velocity=90.0))
    half = path((F, 0, 200, 0, 180, 24000), bulge=[1.0])
    assert duration(half, slow) == pytest.approx(2.0, rel=0.05)
    assert duration(half, QUICK) == pytest.approx(314.159 / 400.0, rel=0.1)


def test_each_change_of_tool_waits_for_its_piston() -> None:
    two = path((R, 50, 0, 0, 0, 0), (R, 100, 0, 0, 0, 0))
    two = replace(two, tool=np.array([1, 2], np.uint8))
    slow = replace(QUICK, settle=0.15)
    np.testing.assert_allclose(durations(two, slow), 0.15 + 0.158113883)


def test_a_change_to_a_router_waits_for_its_spindle() -> None:
    router = load.machine("router-table")
    (station,) = (one for one in router.stations if one.tool.settle(0.0) > router.settle)
    assert isinstance(station.tool, Cutter)
    moved = replace(path((R, 50, 0, 0, 0, 0)), tool=np.array([station.number], np.uint8))
    quick = replace(station, tool=replace(station.tool, spin_up=0.0))
    without = replace(
        router, stations=tuple(quick if one is station else one for one in router.stations)
    )
    waits = station.tool.settle(0.0) - router.settle
    assert duration(moved, router) - duration(moved, without) == pytest.approx(waits)


def on_linuxcnc(*moves: tuple[Motion, float, float, float, float, float]) -> list[float]:
    """Return the times of moves on LinuxCNC (s), without start and change of the station."""
    seconds = durations(path(*moves), replace(QUICK, dialect="linuxcnc"))
    seconds[0] -= linuxcnc.START + linuxcnc.CHANGE
    return list(seconds)


def test_linuxcnc_halves_the_acceleration_of_the_last_move_before_a_halt() -> None:
    # C turns by 90° at 36000/2 °/s², and never reaches 3600°/s: 2 √(90/18000).
    (turn,) = on_linuxcnc((R, 0, 0, 0, 90, 0))
    assert turn == pytest.approx(2.0 * np.sqrt(90.0 / 18000.0) + linuxcnc.HALT)


def test_linuxcnc_rests_between_rapids_and_feeds_at_full_acceleration() -> None:
    # 100 mm at 8000 mm/s²: 2 √(100/8000); the feed of 400 mm/s at half of it: 0.25 + 400/4000.
    rapid, feed = on_linuxcnc((R, 100, 0, 0, 0, 0), (F, 200, 0, 0, 0, 24000))
    assert rapid == pytest.approx(2.0 * np.sqrt(100.0 / 8000.0))
    assert feed == pytest.approx(100.0 / 400.0 + 400.0 / 4000.0 + linuxcnc.HALT)


def test_linuxcnc_overlaps_moves_in_which_c_turns() -> None:
    """Two arcs with C on the tangent nearly come to rest between them."""
    quarter, table = np.tan(np.pi / 8.0), replace(QUICK, dialect="linuxcnc")
    first, second = (F, 3, 3, 0, 90, 24000), (F, 0, 6, 0, 180, 24000)
    both = duration(path(first, second, bulge=[quarter, quarter]), table)
    one = duration(path(first, bulge=[quarter]), table)
    still = linuxcnc.START + linuxcnc.CHANGE + linuxcnc.HALT
    assert 1.9 * (one - still) < both - still < 2.0 * (one - still)


def test_linuxcnc_halts_where_c_begins_to_turn() -> None:
    # A line at 400 mm/s into an arc of 50 mm with C on the tangent: ADR 0008.
    moves = path(
        (F, 400, 0, 0, 0, 24000), (F, 450, 50, 0, 90, 24000), bulge=[0.0, np.tan(np.pi / 8)]
    )
    grbl, linuxcnc = (
        duration(moves, replace(QUICK, dialect=name)) for name in ("grblhal", "linuxcnc")
    )
    assert linuxcnc > grbl + 0.015


def test_rows_without_motion_take_no_time_and_do_not_stop() -> None:
    still = path((F, 400, 0, 0, 0, 24000), (F, 400, 0, 0, 0, 24000), (F, 800, 0, 0, 0, 24000))
    seconds = durations(still, QUICK)
    assert seconds[1] == 0.0
    assert seconds.sum() == pytest.approx(2.05)


def simulated(text: bytes, machine: Machine) -> float:
    """Return the seconds that the simulated table takes for a program."""
    table = Table(machine)
    refused = []
    table.answer = lambda line: refused.append(line) if line[:5] in ("error", "ALARM") else None
    for line in text.splitlines(keepends=True):
        while table.window - len(table._buffer) < len(line):
            table.elapse(0.02)
        table.receive(line)
    while table.busy or table._buffer:
        table.elapse(0.5)
    assert refused == []
    return table.time


@pytest.mark.parametrize("named", SAMPLES, ids=str)
def test_the_simulated_table_takes_as_long(named: Named) -> None:
    machine = load.machine("demo-table")
    drawing, dieline, board = named.classified(None)
    made = pipeline.compile(drawing, dieline, machine, board, dialect="grblhal")
    ours = duration(made.toolpath, machine)
    assert ours == pytest.approx(simulated(made.program.text, machine), rel=0.02)
