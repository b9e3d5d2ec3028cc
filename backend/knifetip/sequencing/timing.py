"""timing: functions that return the time for which a controller halts between moves."""

from __future__ import annotations

from typing import Final, Protocol

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Toolpath

#: A shorter move is no move (mm or degrees).
STILL: Final = 1e-9


class Timing(Protocol):
    """A function that estimates the halts of a controller that runs programs in one language."""

    def __call__(self, toolpath: Toolpath, travel: F64, seconds: F64, machine: Machine) -> F64:
        """Return the time for which the controller halts after each row of the toolpath, (n,) s.

        Parameters
        ----------
        toolpath, machine
            The toolpath, and the machine that runs it.
        travel : (n,) mm
            Length of each row along XYZ.
        seconds : (n,)
            Time of each row at its feed.
        """
        ...


def no_halts(toolpath: Toolpath, travel: F64, seconds: F64, machine: Machine) -> F64:
    """Return an array of zeros, (n,) s, one for each row: the controller never halts between
    moves.
    """
    del travel, seconds, machine
    return np.zeros(len(toolpath))
