"""The stated time of a program is the time for which a complete LinuxCNC moves."""

from __future__ import annotations

from dataclasses import replace

import pytest

from knifetip import pipeline
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.model.machine import Axis, Machine
from tests.controllers.linuxcnc_machine import missing_requirement
from tests.controllers.linuxcnc_time import moving_seconds, stated_seconds
from tests.support.truth.named import SAMPLES, Named

SKIP_REASON = missing_requirement()
pytestmark = [
    pytest.mark.controller,
    pytest.mark.xdist_group("linuxcnc"),
    pytest.mark.skipif(bool(SKIP_REASON), reason=SKIP_REASON),
]

TABLE = with_language(load.machine("demo-table"), "linuxcnc")


def other(axis: Axis) -> Axis:
    return replace(axis, velocity=axis.velocity / 2.0, acceleration=axis.acceleration * 3.0)


#: The table with half the velocities and three times the accelerations.
QUICK = replace(TABLE, x=other(TABLE.x), y=other(TABLE.y), z=other(TABLE.z), c=other(TABLE.c))


@pytest.mark.parametrize(
    ("named", "machine"),
    [
        pytest.param(SAMPLES[0], TABLE, id="table"),
        pytest.param(SAMPLES[1], QUICK, id="quick", marks=pytest.mark.long),
    ],
)
async def test_it_moves_as_long_as_stated(named: Named, machine: Machine) -> None:
    drawing, dieline, board = named.classified(None)
    made = pipeline.compile(drawing, dieline, machine, board)
    real = await moving_seconds(made.program.text, machine)
    assert real == pytest.approx(stated_seconds(made.toolpath, machine), rel=0.04)
