"""timing: what a controller adds to the time that the axes need.

Toolpath -> seconds of rest at the end of every row
"""

from __future__ import annotations

from typing import Final, Protocol

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Toolpath

#: A move shorter than this moves nothing (mm or degrees).
STILL: Final = 1e-9


class Timing(Protocol):
    """The halts of one controller language."""

    def __call__(self, toolpath: Toolpath, travel: F64, seconds: F64, machine: Machine) -> F64:
        """Return how long the controller halts after each row, (n,) s; 0 where it moves on.

        Parameters
        ----------
        travel : (n,) mm
            Along XYZ.
        seconds : (n,)
            That each row takes at its feed.
        """
        ...


def no_halts(toolpath: Toolpath, travel: F64, seconds: F64, machine: Machine) -> F64:
    """Return the halts of a controller that needs none, (n,) s."""
    del travel, seconds, machine
    return np.zeros(len(toolpath))
