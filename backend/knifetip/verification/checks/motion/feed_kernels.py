"""Kernels that compare the feeds of moves with the feeds and turning velocities of the tools."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.kernels import I64_1, inline_kernel, kernel
from knifetip.verification.checks.motion.kernels import path_length
from knifetip.verification.checks.motion.move_columns import MoveColumns, ToolColumns, rests_tip
from knifetip.verification.kinematics import LEVEL

#: Greatest relative error of a feed: programs print six significant digits.
FEED_TOLERANCE: Final = 1e-5
#: Greatest relative error of a feed that depends on the radius of a curve, which follows from the
#: rounded ends of a move and from its chord; and how many roundings of a point count besides.
SLOWING_ERROR: Final = 0.02
SLOWING_ROUNDINGS: Final = 2.0
#: Greatest error of a time: relative, and by rounded coordinates of the move (mm).
TIME_TOLERANCE: Final = 1e-4
LENGTH_TOLERANCE: Final = 5e-4
#: A short move may last as long as the controller needs to be given the next one, and up to this
#: many times longer.
SLOWED: Final = 1.1
#: Shorter times are not checked, because controllers round them up (minutes).
MIN_MINUTES: Final = 2e-6

#: Faults of a move, as bits: a wrong feed or time; a turn of C at an F word in mm/min; and travel
#: of another carriage than the first one that is not timed.
WRONG_FEED: Final = 1
TURNS_AT_FEED: Final = 2
UNTIMED_CARRIAGE: Final = 4


@inline_kernel
def _bend(moves: MoveColumns, tools: ToolColumns, row: int) -> float:
    """Return the radius of a curve as a multiple of the radius below which the tool slows down."""
    slow = tools.slow_radius[moves.station[row]]
    turn = math.radians(abs(moves.end[row, 3] - moves.start[row, 3]))
    if slow == 0.0 or turn == 0.0 or rests_tip(moves, tools, row):
        return math.inf
    length: float = path_length(moves.start, moves.end, moves.centre, moves.sweep, row)
    bend: float = length / (turn * slow)
    return bend


@inline_kernel
def _slows(moves: MoveColumns, tools: ToolColumns, row: int) -> bool:
    """Return whether the tool may slow down along a move: its radius has an error, too."""
    return _bend(moves, tools, row) < 1.0 + SLOWING_ERROR


@inline_kernel
def _own_feed(moves: MoveColumns, tools: ToolColumns, row: int) -> float:
    """Return the tool's feed for a move (mm/min): the plunge feed if the height changes."""
    station = moves.station[row]
    if abs(moves.end[row, 2] - moves.start[row, 2]) > LEVEL:
        plunge: float = tools.plunge[station]
        return plunge
    feed: float = tools.feed[station] * min(1.0, _bend(moves, tools, row))
    return feed


@inline_kernel
def _times(moves: MoveColumns, tools: ToolColumns, row: int) -> Any:
    """Return the time of a move, its planned time (minutes), and whether the tip rests in it."""
    own = _own_feed(moves, tools, row)
    length = path_length(moves.start, moves.end, moves.centre, moves.sweep, row)
    degrees = abs(moves.end[row, 3] - moves.start[row, 3])
    level = abs(moves.end[row, 2] - moves.start[row, 2]) <= LEVEL
    # If the tip does not move while C turns, the move is a swivel, even if the head axis moves.
    swivel = level and degrees > 0.0 and rests_tip(moves, tools, row)
    least = 0.0 if swivel else length / own
    turning = degrees / (60.0 * tools.turn_velocity[moves.station[row]])
    if turning > least or math.isnan(turning):
        least = turning
    minutes = 1.0 / moves.feed[row] if moves.inverse[row] else length / moves.feed[row]
    return minutes, least, swivel


@inline_kernel
def _has_wrong_time(
    moves: MoveColumns, tools: ToolColumns, shortest: float, resolution: float, row: int
) -> bool:
    minutes, least, swivel = _times(moves, tools, row)
    slows = _slows(moves, tools, row)
    error = (SLOWING_ERROR if slows else TIME_TOLERANCE) * least
    if not swivel:
        rounding = SLOWING_ROUNDINGS * resolution if slows else 0.0
        error += (LENGTH_TOLERANCE + rounding) / _own_feed(moves, tools, row)
    if least < minutes <= SLOWED * shortest and not swivel:
        return False
    return abs(minutes - least) > error and not (minutes <= MIN_MINUTES and minutes > least)


@kernel
def feed_faults(
    moves: MoveColumns, tools: ToolColumns, arcs_turn: bool, shortest: float, resolution: float
) -> Any:
    """Return the faults of the feeds of n moves, (n,) as bits of the module's constants.

    Parameters
    ----------
    arcs_turn
        Whether C may turn during an arc at a feed in mm/min.
    shortest : minutes
        Least time of a move that follows another one without a stop.
    resolution : mm
        Greatest shift of a point by the rounding of coordinates.
    """
    faults = np.zeros(len(moves.code), np.uint8)
    for row in range(len(moves.code)):
        if moves.code[row] == 0 or math.isnan(moves.feed[row]):
            continue
        own = _own_feed(moves, tools, row)
        length = path_length(moves.start, moves.end, moves.centre, moves.sweep, row)
        if math.isnan(own) or math.isnan(length):
            continue
        if moves.inverse[row]:
            if _has_wrong_time(moves, tools, shortest, resolution, row):
                faults[row] |= WRONG_FEED
            continue
        # A move that is not timed has the feed of its F word.
        slows = _slows(moves, tools, row)
        if abs(moves.feed[row] - own) > (SLOWING_ERROR if slows else FEED_TOLERANCE) * own:
            faults[row] |= WRONG_FEED
        turns = abs(moves.end[row, 3] - moves.start[row, 3]) > 0.0
        if turns and not (arcs_turn and moves.sweep[row] != 0.0):
            faults[row] |= TURNS_AT_FEED
        if tools.other_carriage[moves.station[row]] and length > 0.0:
            faults[row] |= UNTIMED_CARRIAGE
    return faults


@kernel
def feed_figures(moves: MoveColumns, tools: ToolColumns, rows: I64_1) -> Any:
    """Return the figures of some moves that messages about their feeds contain, (k, 4).

    The four figures are the time of the move and its planned time (minutes), the tool's feed
    (mm/min), and the length of the move (mm).  ``rows`` are the indices of the moves, (k,).
    """
    figures = np.empty((len(rows), 4))
    for k in range(len(rows)):
        row = rows[k]
        figures[k, 0], figures[k, 1], _ = _times(moves, tools, row)
        figures[k, 2] = _own_feed(moves, tools, row)
        figures[k, 3] = path_length(moves.start, moves.end, moves.centre, moves.sweep, row)
    return figures
