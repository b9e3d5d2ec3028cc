"""timing: the type of the functions that compute the times of moves on a controller."""

from __future__ import annotations

from typing import Protocol

from knifetip.geometry.columns import F64, Bool
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Toolpath
from knifetip.sequencing.moves import Moves


class Timing(Protocol):
    """A function that computes the times of moves on a controller of one language."""

    def __call__(self, moves: Moves, rests: Bool, toolpath: Toolpath, machine: Machine) -> F64:
        """Return the time of each of n moves of a toolpath, (n,) s.

        Parameters
        ----------
        moves
            The moves of the toolpath.
        rests : (n,)
            Mask of the moves before which the program has the machine at rest: a tool changes, or a
            beam is switched.
        toolpath, machine
            The toolpath, and the machine that runs it.
        """
        ...
