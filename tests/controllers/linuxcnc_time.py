"""The time for which a complete LinuxCNC moves, stated and measured."""

from __future__ import annotations

import numpy as np

from knifetip.gateway.controller import SafeState
from knifetip.gateway.linuxcnc.driver import dial
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Toolpath
from knifetip.sequencing import linuxcnc
from knifetip.sequencing.duration import durations
from tests.controllers.linuxcnc_machine import Supply


def stated_seconds(toolpath: Toolpath, machine: Machine) -> float:
    """Return the time for which the machine is expected to move (s)."""
    still = machine.settle + linuxcnc.CHANGE
    changes = 1 + np.count_nonzero(np.diff(toolpath.tool))
    return float(durations(toolpath, machine).sum()) - linuxcnc.START - changes * still


async def moving_seconds(program: bytes, machine: Machine) -> float:
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
