"""held_heading: the positions of C in a program whose free blades no axis turns."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from knifetip.geometry.columns import hand_over
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Toolpath


def hold_heading(toolpath: Toolpath, machine: Machine) -> Toolpath:
    """Return a toolpath in which C rests while a tool is used that no axis turns.

    Such tools are free blades, whose headings in ``toolpath`` are those that their travel in the
    board gives them.  On a machine that has no C, it is 0 everywhere.
    """
    if not machine.heading_letter:
        held = np.zeros(len(toolpath.pose))
    else:
        free = [one.number for one in machine.stations if one.tool.drags]
        resting = np.append(False, np.isin(toolpath.tool, free))
        if not resting.any():
            return toolpath
        last = np.maximum.accumulate(np.where(resting, 0, np.arange(len(resting))))
        held = toolpath.pose[last, 3]
    pose = toolpath.pose.copy()
    pose[:, 3] = held
    return replace(toolpath, pose=hand_over(pose))
