"""Check that the carriages of a gantry keep their distance, and that idle carriages are lifted.

All carriages move along one gantry and cannot pass each other.  Their order is that of their
parking positions.  A carriage that is not in use remains where the program last sent it.  At the
start of the program the position of every carriage is unknown, so that the first move along the
gantry must send all carriages at once.  Each of them then moves towards its own end.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.verification.checks.motion.moves import TRAVEL_TOLERANCE, axis_ranges
from knifetip.verification.columns import I64, Bool
from knifetip.verification.findings import MAX_FINDINGS, Findings
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import carriage_columns, travel_heights

#: Half of the last printed digit of a height (mm).
PRINT_ROUNDING: Final = 5e-5


def check_carriages(moves: Moves, machine: Machine, findings: Findings) -> None:
    """Check the distance of the carriages at every moment, and the height of idle carriages; add
    findings.

    The distance of two carriages changes linearly along a line, so that it is least at one of the
    ends of the move.  On an arc, the first carriage also reaches the extremes of the arc.
    """
    if machine.gantry is None:
        return
    letters = list(machine.axes)
    low, high = axis_ranges(moves)
    least = machine.gantry.min_distance
    order = sorted(machine.carriages, key=lambda carriage: carriage.park)
    for near, far in pairwise(order):
        first, second = letters.index(near.letters[1]), letters.index(far.letters[1])
        gap = low[:, second] - high[:, first]
        rows = _run_starts(gap < least - TRAVEL_TOLERANCE)
        for row in rows[:MAX_FINDINGS]:
            message = Message(
                "verify.heads-too-near",
                first=near.letters[1],
                second=far.letters[1],
                distance=gap[row],
                least=least,
            )
            findings.add("travel", message, least - gap[row], line=moves.line[row])
    _check_located(moves, machine, letters, findings)
    _check_idle(moves, machine, letters, findings)


def _check_located(moves: Moves, machine: Machine, letters: list[str], findings: Findings) -> None:
    """Add a finding for each carriage that another carriage moves beside although its position is
    unknown.
    """
    columns = [letters.index(carriage.letters[1]) for carriage in machine.carriages]
    start, end = moves.axes_start[:, columns], moves.axes_end[:, columns]
    goes = ((start != end) & ~(np.isnan(start) & np.isnan(end))).any(axis=1)
    for place, column in enumerate(columns):
        for row in np.flatnonzero(goes & np.isnan(end[:, place]))[:1]:
            message = Message("verify.head-not-located", other=letters[column])
            findings.add("program", message, 0.0, line=moves.line[row])


def _check_idle(moves: Moves, machine: Machine, letters: list[str], findings: Findings) -> None:
    """Add a finding for each idle carriage with a Z of its own that is not lifted."""
    heights = travel_heights(machine)
    selected = carriage_columns(machine)[moves.station, 2]
    for letter, needed in heights.items():
        column = letters.index(letter)
        height = moves.axes_end[:, column]
        low = ~(height >= needed - PRINT_ROUNDING) & (moves.station >= 0) & (selected != column)
        for row in _run_starts(low)[:MAX_FINDINGS]:
            if np.isnan(height[row]):
                findings.add(
                    "program", Message("verify.unknown-position"), 0.0, line=moves.line[row]
                )
                continue
            message = Message(
                "verify.idle-head-low", letter=letter, height=height[row], needed=needed
            )
            findings.add("travel", message, needed - height[row], line=moves.line[row])


def _run_starts(rows: Bool) -> I64:
    """Return the first index of each run of True in a mask of n moves."""
    before = np.concatenate([[False], rows[:-1]])
    result: I64 = np.flatnonzero(rows & ~before)
    return result
