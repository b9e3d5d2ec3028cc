"""The stated time of a program is the time for which a complete LinuxCNC moves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.gateway.controller import SafeState
from knifetip.gateway.linuxcnc.driver import dial
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.model.machine import Axis, Machine
from knifetip.model.toolpath import Toolpath
from knifetip.sequencing import linuxcnc
from knifetip.sequencing.duration import durations
from tests.controllers.linuxcnc_machine import Supply, missing_requirement
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


def stated(toolpath: Toolpath, machine: Machine) -> float:
    """Return the time for which the machine is expected to move (s)."""
    still = machine.settle + linuxcnc.CHANGE
    changes = 1 + np.count_nonzero(np.diff(toolpath.tool))
    return float(durations(toolpath, machine).sum()) - linuxcnc.START - changes * still


async def moving(program: bytes, machine: Machine) -> float:
    """Return the time for which the joints move while LinuxCNC runs a program (s).

    LinuxCNC reads programs without real-time priority: on a busy computer it rests between moves.
    """
    with Supply(machine) as supply, supply.machine() as running:
        controller = await dial(running.address, SafeState.from_machine(machine))
        mark = running.mark()
        await controller.run(program)
        await controller.close()
        assert running.comes_to_rest()
        joints = running.samples(mark)[:, :4]
    return np.count_nonzero((np.diff(joints, axis=0) != 0.0).any(axis=1)) / 1000.0


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
    real = await moving(made.program.text, machine)
    assert real == pytest.approx(stated(made.toolpath, machine), rel=0.04)
