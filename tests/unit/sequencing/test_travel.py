"""Two heads on one beam: each has its own datum and its own limits."""

from __future__ import annotations

from dataclasses import replace

import pytest

from knifetip.compensation.compensate import compensate
from knifetip.errors import TravelExceeded
from knifetip.model.dieline import LineType
from knifetip.model.machine import Axis
from knifetip.model.toolpath import Toolpath
from knifetip.planning.plan import plan
from knifetip.sequencing.sequence import sequence
from tests.support.shapes import BOARD, MACHINE, dieline, edges

# The knife's datum is zero; the V-cutter is mounted 60 mm to its left and 5 mm behind it.
BEAM = replace(
    MACHINE,
    x=Axis(0.0, 500.0, 1500.0, 8000.0),
    stations=(MACHINE.stations[0], replace(MACHINE.stations[2], x=-60.0, y=5.0)),
)


def travelled(kind: LineType, left: float, right: float) -> Toolpath:
    line = dieline((kind, edges(((left, 100), (right, 100)))))
    return sequence([compensate(plan(line, BEAM, BOARD)[0])], BEAM)


def test_the_v_cutter_does_not_reach_the_left_edge() -> None:
    travelled(LineType.CUT, 10, 200)
    # Its tip at 10 on the way back, the head 1.5 further left: joint 10 - 1.5 - 60.
    with pytest.raises(
        TravelExceeded, match=r"V-cutter \(station 3\) would move 51\.50 mm beyond the lower end"
    ):
        travelled(LineType.V_GROOVE, 10, 200)


def test_the_knife_does_not_reach_the_right_edge() -> None:
    travelled(LineType.V_GROOVE, 300, 550)
    with pytest.raises(
        TravelExceeded, match=r"Knife \(station 1\) would move 47\.70 mm beyond the upper end"
    ):
        travelled(LineType.CUT, 300, 550)
