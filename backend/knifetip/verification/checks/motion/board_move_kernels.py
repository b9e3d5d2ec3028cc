"""Kernels that find moves which are wrong in the board or near it."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_2, I64_1, inline_kernel, kernel
from knifetip.verification.checks.motion.move_columns import MoveColumns, ToolColumns, rests_tip
from knifetip.verification.kinematics import LEVEL, is_known
from knifetip.verification.tools import ANGLE_TOLERANCE

#: Part of the turn clearance that may be missing because heights are rounded (mm).
HEIGHT_TOLERANCE: Final = 1e-3
#: A line may replace an arc with a sagitta up to this: controllers reject smaller arcs (mm).
MAX_BOW: Final = 1e-3

#: Marks of a move, as bits: a rapid near the board or in the board; a position of a joint is
#: unknown, and this is a fault; a slanted plunge or lift; a wrong turn of C.
LOW_RAPID: Final = 1
RAPID_IN_BOARD: Final = 2
UNKNOWN: Final = 4
UNKNOWN_FAULT: Final = 8
SLANTED: Final = 16
WRONG_TURN: Final = 32


@inline_kernel
def lowest_tip(moves: MoveColumns, row: int) -> float:
    """Return the lower of the heights of the tip at the ends of a move, of which one may be NaN."""
    low: float = moves.tip_start[row, 2]
    other: float = moves.tip_end[row, 2]
    return other if other < low or math.isnan(low) else low


@inline_kernel
def _moves_head(start: F64_2, end: F64_2, row: int) -> bool:
    """Return whether a move moves X, Y or C, or one of them is unknown."""
    moved: bool = start[row, 0] != end[row, 0] or start[row, 1] != end[row, 1]
    return moved or start[row, 3] != end[row, 3]


@inline_kernel
def _goes_sideways_unseen(start: F64_2, end: F64_2, row: int) -> bool:
    """Return whether a move moves X, Y or C at an unknown height."""
    if not math.isnan(start[row, 2]):
        return False
    for axis in (0, 1, 3):
        before, after = start[row, axis], end[row, axis]
        if not (before == after or (math.isnan(before) and math.isnan(after))):
            return True
    return False


@inline_kernel
def _is_steep(moves: MoveColumns, tools: ToolColumns, row: int) -> bool:
    """Return whether a move of a tool other than a laser changes the height of the tip."""
    drop = abs(moves.tip_end[row, 2] - moves.tip_start[row, 2])
    return drop > LEVEL and not tools.beam[moves.station[row]]


@inline_kernel
def _slant(moves: MoveColumns, tools: ToolColumns, caliper: float, row: int) -> float:
    """Return by how much the tip leaves the direction of its blade in a plunge or lift (mm).

    Only the part of the move in the board, whose thickness is ``caliper`` (mm), counts.
    """
    begin_z, end_z = moves.tip_start[row, 2], moves.tip_end[row, 2]
    drop = end_z - begin_z
    top = min(max(begin_z, end_z), caliper)
    fraction: float = (top - lowest_tip(moves, row)) / abs(drop)
    aside = drop * tools.slope[moves.station[row]]
    heading = math.radians(moves.tip_end[row, 3])
    x = moves.tip_end[row, 0] - moves.tip_start[row, 0] - math.sin(heading) * aside
    y = moves.tip_end[row, 1] - moves.tip_start[row, 1] + math.cos(heading) * aside
    return fraction * math.hypot(x, y)


@inline_kernel
def _turn(moves: MoveColumns, tools: ToolColumns, row: int) -> Any:
    """Return the turn of C in a feed move in the board, the turn of the path, the greatest
    permitted difference of the two (degrees), and whether the tool turns in place.

    A tool that turns in place, or while it plunges or lifts, has no direction of travel; only the
    size of its turn is limited.
    """
    station = moves.station[row]
    steep = _is_steep(moves, tools, row)
    turn = moves.tip_end[row, 3] - moves.tip_start[row, 3]
    in_place = steep or rests_tip(moves, tools, row)
    path = 0.0
    if tools.follows_path[station] and not in_place:
        path = math.degrees(moves.sweep[row])
    limit = ANGLE_TOLERANCE if steep else tools.swivel[station]
    if not in_place and moves.sweep[row] == 0.0:
        x = moves.tip_end[row, 0] - moves.tip_start[row, 0]
        y = moves.tip_end[row, 1] - moves.tip_start[row, 1]
        length = math.hypot(x, y)
        if length > 0.0:
            # The angle of an arc over this chord with a sagitta of MAX_BOW.
            limit += math.degrees(8.0 * MAX_BOW / length)
    return turn, path, min(limit, tools.max_turn[station] + ANGLE_TOLERANCE), in_place


@kernel
def mark_board_moves(
    moves: MoveColumns, tools: ToolColumns, needed: float, caliper: float, tolerance: float
) -> Any:
    """Return what is wrong or unknown about n moves in the board and near it, (n,) as bits of the
    module's constants.

    Parameters
    ----------
    needed : mm
        Least height of a rapid above the table.
    caliper : mm
        Thickness of the board.
    tolerance : mm
        Greatest sideways deviation of the tip in a plunge or lift.
    """
    marks = np.zeros(len(moves.code), np.uint8)
    for row in range(len(moves.code)):
        station, feeds = moves.station[row], moves.code[row] > 0
        unknown = not is_known(moves.start, moves.end, row)
        if unknown:
            marks[row] |= UNKNOWN
            if feeds or _goes_sideways_unseen(moves.start, moves.end, row):
                marks[row] |= UNKNOWN_FAULT
        if not feeds:
            if tools.beam[station]:
                continue
            if moves.inside[row]:
                marks[row] |= RAPID_IN_BOARD
            low = station >= 0 and lowest_tip(moves, row) < needed - HEIGHT_TOLERANCE
            if low and _moves_head(moves.start, moves.end, row):
                marks[row] |= LOW_RAPID
        elif moves.inside[row] and not unknown:
            if _is_steep(moves, tools, row) and (
                moves.sweep[row] != 0.0 or _slant(moves, tools, caliper, row) > tolerance
            ):
                marks[row] |= SLANTED
            turn, path, limit, _ = _turn(moves, tools, row)
            if abs(turn - path) > limit:
                marks[row] |= WRONG_TURN
    return marks


@kernel
def slants(moves: MoveColumns, tools: ToolColumns, caliper: float, rows: I64_1) -> Any:
    """Return by how much the tip leaves the direction of its blade in plunges and lifts, (k,) mm.

    ``caliper`` is the thickness of the board (mm), and ``rows`` are the indices of the moves, (k,).
    """
    distance = np.empty(len(rows))
    for k in range(len(rows)):
        distance[k] = _slant(moves, tools, caliper, rows[k])
    return distance


@kernel
def turn_figures(moves: MoveColumns, tools: ToolColumns, rows: I64_1) -> Any:
    """Return the figures of some feed moves in the board that messages about turns contain, (k, 4).

    The four figures are the turn of C, the turn of the path, the greatest permitted difference of
    the two (degrees), and 1 if the tool turns in place, else 0.  ``rows`` are the indices of the
    moves, (k,).
    """
    figures = np.empty((len(rows), 4))
    for k in range(len(rows)):
        turn, path, limit, in_place = _turn(moves, tools, rows[k])
        figures[k, 0], figures[k, 1], figures[k, 2] = turn, path, limit
        figures[k, 3] = 1.0 if in_place else 0.0
    return figures
