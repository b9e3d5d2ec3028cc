"""Find rapid moves that stay beside a sheet that was cut to size.

Where there is no board, a tool may travel and turn below the height of the top face.  The condition
is that the footprint of the tool, the part of it below the top face seen from above, keeps the
machine's clearance from the edge of the sheet during the entire move, and that the tip stays above
the mat.

The footprint is moved along each rapid in steps.  A step is never longer than the distance by which
the footprint could approach the sheet without coming too near, so no contact is missed.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.expectation.sheet_area import SheetArea
from knifetip.verification.kinematics import LEVEL
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import footprint_corners

#: Part of the clearance that may be missing (mm): rounding, and the shortest step.
_SLACK: Final = 0.05
_MAX_STEPS: Final = 20_000


def stays_beside_sheet(
    moves: Moves, rapids: I64, machine: Machine, board: Board, sheet: SheetArea
) -> Bool:
    """Return the mask of the rapids that keep the machine's clearance from the sheet, (k,).

    Parameters
    ----------
    moves
        The moves of the program.
    rapids : (k,)
        Indices of k rapids in ``moves``; their positions are known and have a station.
    machine, board
        Machine and board of the program.
    sheet
        The sheet on the machine's table.
    """
    result = np.zeros(len(rapids), np.bool_)
    if len(sheet.start) == 0:
        return result
    for index, station in enumerate(machine.stations):
        own = np.flatnonzero(moves.station[rapids] == index)
        if len(own) == 0:
            continue
        datum = np.array([station.x, station.y, station.z, station.c])
        start, end = moves.start[rapids[own]] - datum, moves.end[rapids[own]] - datum
        low = np.minimum(start[:, 2], end[:, 2])
        corners = np.array(footprint_corners(station.tool, board.caliper - float(low.min())))
        above_mat = low >= -LEVEL
        result[own] = above_mat & _keeps_clear(start, end, corners, machine.clearance, sheet)
    return result


def _keeps_clear(start: F64, end: F64, corners: F64, clearance: float, sheet: SheetArea) -> Bool:
    """Return the mask of the moves on which a footprint keeps its distance from the sheet, (k,).

    ``start``, ``end`` (k, 4) x y z in mm, c in degrees: poses of the head's axis.
    ``corners`` (p, 2) mm: corners of the footprint: ahead of the axis, and to the right of it.
    ``clearance`` mm: distance to keep.
    """
    travel = end - start
    farthest = float(np.hypot(*corners.T).max())
    # No corner moves farther than this on a whole move.
    reach = np.hypot(travel[:, 0], travel[:, 1]) + farthest * np.radians(np.abs(travel[:, 3]))
    clear = np.zeros(len(start), np.bool_)
    progress = np.zeros(len(start))
    active = np.flatnonzero(~sheet.contains(_footprints(start, corners)[:, 0]))
    for _ in range(_MAX_STEPS):
        if len(active) == 0:
            break
        pose = start[active] + travel[active] * progress[active, None]
        spare = sheet.distances(_footprints(pose, corners)) - clearance + _SLACK
        remaining = reach[active] * (1.0 - progress[active])
        ended = (spare > 0.0) & (spare >= remaining)
        clear[active[ended]] = True
        goes_on = (spare > 0.0) & ~ended
        active, spare = active[goes_on], spare[goes_on]
        progress[active] += spare / reach[active]
    return clear


def _footprints(pose: F64, corners: F64) -> F64:
    """Return the corners of the footprint at each of k poses of the head's axis, (k, p, 2) mm."""
    heading = np.radians(pose[:, 3])
    ahead = np.stack([np.cos(heading), np.sin(heading)], axis=1)[:, None]
    right = np.stack([np.sin(heading), -np.cos(heading)], axis=1)[:, None]
    result: F64 = pose[:, None, :2] + corners[:, :1] * ahead + corners[:, 1:] * right
    return result
