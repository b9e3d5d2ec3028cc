"""timing: the type of the functions that estimate for how long a controller halts between moves."""

from __future__ import annotations

from typing import Final, Protocol

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Toolpath

#: A shorter move is no move (mm or degrees).
STILL: Final = 1e-9


class Timing(Protocol):
    """A function that estimates how long a controller halts between moves."""

    def __call__(self, toolpath: Toolpath, travel: F64, seconds: F64, machine: Machine) -> F64:
        """Return the time for which the controller halts after each of n rows of the toolpath, (n,)
        s.

        Parameters
        ----------
        toolpath, machine
            The toolpath, and the machine that runs it.
        travel : (n,) mm
            Length of each row along XYZ.
        seconds : (n,) s
            Time of each row at its feed.
        """
        ...


def no_halts(toolpath: Toolpath, travel: F64, seconds: F64, machine: Machine) -> F64:
    """Return an array of zeros, (n,) s, for a controller that never halts between the n rows of the
    toolpath.
    """
    del travel, seconds, machine
    return np.zeros(len(toolpath))
