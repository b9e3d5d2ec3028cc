"""Turns at the least height above the board, and the verifier's limit for them."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from knifetip.compensation.compensate import compensate
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Axis, Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.planning.plan import plan
from knifetip.post.emit import process
from knifetip.sequencing.duration import duration
from knifetip.sequencing.rest_time import rest_times
from knifetip.sequencing.sequence import sequence
from knifetip.verification.verify import verify
from tests.support.shapes import BOARD, MACHINE, closed, dieline, edges

SAFETY = 0.5
TABLE = replace(MACHINE, turn_clearance=SAFETY)
DRAWN = dieline(
    (LineType.CUT, closed((0, 0), (300, 0), (300, 200), (0, 200))),
    (LineType.V_GROOVE, edges(*(((0, y), (300, y)) for y in range(40, 200, 40)))),
    (LineType.CREASE, edges(((50, 20), (250, 20)), ((250, 180), (50, 180)))),
)


def sequenced(safety: float, drawn: Dieline = DRAWN) -> Toolpath:
    work = [compensate(operation) for operation in plan(drawn, TABLE, BOARD)]
    return sequence(work, TABLE, None, safety)


def heights(path: Toolpath, station: int) -> set[float]:
    """Return the heights above the board of rapids below travel height."""
    rows = (path.motion == Motion.RAPID) & (path.tool == station)
    moved = rows & (np.abs(np.diff(path.pose, axis=0))[:, [0, 1, 3]] > 1e-9).any(axis=1)
    z = path.pose[1:][moved, 2]
    return set(np.round(z[z < TABLE.travel_z] - BOARD.caliper, 4).tolist())


def codes(text: bytes, machine: Machine = TABLE) -> list[str]:
    found = verify(text, DRAWN, (0.0, 0.0), machine, BOARD).findings
    return [finding.message.code for finding in found]


def test_the_lowest_point_of_each_tool_is_above_the_board_by_the_safety() -> None:
    path = sequenced(SAFETY)
    # Knife and wheel are upright; the V-cutter leans by 45°, r sin 45° = 1.0607.
    assert heights(path, 1) == {0.5}
    assert heights(path, 2) == {0.5}
    assert heights(path, 3) == {1.5607}
    for station in (1, 2, 3):
        assert heights(sequenced(0.0), station) == {2.0}


def test_the_least_lift_saves_time_and_is_accepted() -> None:
    low, high = sequenced(SAFETY), sequenced(0.0)
    assert duration(low, TABLE) < duration(high, TABLE)
    for path in (low, high):
        assert codes(process(path, TABLE, tolerance=0.01).text) == []


def test_the_tip_moves_along_the_tilted_blade_at_any_lift() -> None:
    path = sequenced(SAFETY)
    rows = np.flatnonzero((path.tool == 3) & (path.motion == Motion.LIFT))
    rise = np.diff(path.pose, axis=0)[rows]
    assert np.hypot(rise[:, 0], rise[:, 1]) == pytest.approx(rise[:, 2] * np.tan(np.pi / 4))


def test_a_least_lift_that_is_higher_than_the_clearance_is_not_used() -> None:
    # 1.0607 + 1.5 mm of the V-cutter take longer than 2 mm; the knife's 1.5 mm do not.
    path = sequenced(1.5)
    assert heights(path, 1) == {1.5}
    assert heights(path, 3) == {2.0}


def test_every_turn_that_is_lowered_below_the_turn_clearance_is_refused() -> None:
    text = process(sequenced(SAFETY), TABLE, tolerance=0.01).text
    lifts = [*re.finditer(rb"Z2\.5000", text), *re.finditer(rb"Z3\.5607", text)]
    lowered = 0
    for match in lifts:
        for height in (b"Z2.4900", b"Z2.0000", b"Z1.9000"):
            mutant = text[: match.start()] + height + text[match.end() :]
            if b"G1 " in text[text.rfind(b"\n", 0, match.start()) : match.start()]:
                found = codes(mutant)
                assert "verify.rapid-too-low" in found or "verify.rapid-in-board" in found
                lowered += 1
    assert lowered >= 3 * 8


def test_without_a_turn_clearance_only_rapids_in_the_board_are_refused() -> None:
    text = process(sequenced(SAFETY), TABLE, tolerance=0.01).text
    assert codes(text, MACHINE) == []
    assert "verify.rapid-too-low" in codes(text, replace(MACHINE, turn_clearance=0.6))


def test_moves_from_rest_to_rest_have_trapezoidal_speed() -> None:
    axes = (Axis(0.0, 9.0, 100.0, 1000.0),) * 4
    pose = np.array([(0, 0, 0, 0), (40, 0, 0, 0), (40, 1.6, 0, 0), (40, 1.6, 30, 0)], float)
    # 40 mm at 100 mm/s and 0.1 s of ramps; 1.6 mm never reach that speed.
    assert rest_times(pose, axes) == pytest.approx([0.5, 0.08, 0.4])
    assert rest_times(pose, axes, feed=3000.0)[2] == pytest.approx(30.0 / 50.0 + 0.05)
