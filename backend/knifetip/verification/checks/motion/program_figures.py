"""Measure the figures of a program as a whole."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.model.program_figures import ProgramFigures
from knifetip.verification.columns import Bool
from knifetip.verification.kinematics import TipPoses
from knifetip.verification.reading.moves import Moves

#: Shorter moves along X and Y are no travel (mm).
_LEAST_TRAVEL: Final = 0.01


def measure_program(moves: Moves, tip: TipPoses, machine: Machine, board: Board) -> ProgramFigures:
    """Return the figures of a program from its moves and the poses of the tip, n each."""
    return ProgramFigures(
        lowest_travel=_lowest_travel(moves, tip, machine, board),
        mat_depth=_mat_depth(moves, tip, machine),
    )


def _lowest_travel(moves: Moves, tip: TipPoses, machine: Machine, board: Board) -> float:
    """Return the least height above the board at which a tool travels over it (mm); 0 for none.

    A beam works at any height, so its travel does not count.
    """
    above = np.flatnonzero(~tip.inside & ~_moves_beam(moves, machine))
    start, end = tip.start[above], tip.end[above]
    travels = np.hypot(*(end - start)[:, :2].T) > _LEAST_TRAVEL
    height = np.minimum(start[:, 2], end[:, 2])[travels] - board.caliper
    height = height[np.isfinite(height)]
    return float(height.min()) if len(height) else 0.0


def _mat_depth(moves: Moves, tip: TipPoses, machine: Machine) -> float:
    """Return the greatest depth of a tool below the top of the mat (mm); 0 for none.

    A beam has no tip, so its focus does not count.
    """
    height = tip.end[~_moves_beam(moves, machine), 2]
    return max(0.0, -float(height[np.isfinite(height)].min(initial=0.0)))


def _moves_beam(moves: Moves, machine: Machine) -> Bool:
    """Return whether each of n moves is one of a beam, or of no station, (n,)."""
    is_beam = np.array([*(station.is_beam for station in machine.stations), True])
    return is_beam[moves.station]
