"""Kernels for the checks of moves: lengths of moves, and the positions that the axes reach."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from knifetip.kernels import F64_1, F64_2, Bool_1, OutF64_2, inline_kernel, kernel


@kernel
def path_lengths(start: F64_2, end: F64_2, centre: F64_2, sweep: F64_1) -> Any:
    """Return the length of each of n moves along X, Y and Z, (n,) mm; NaN if a position is unknown.

    Parameters
    ----------
    start, end : (n, 4)
        Positions of X, Y, Z (mm) and C (degrees) at the start and the end of each move.
    centre, sweep : (n, 2) mm and (n,) radians
        Centre and signed sweep of each arc; the sweep of a line is 0.
    """
    length = np.empty(len(start))
    for row in range(len(start)):
        length[row] = path_length(start, end, centre, sweep, row)
    return length


@inline_kernel
def path_length(start: F64_2, end: F64_2, centre: F64_2, sweep: F64_1, row: int) -> float:
    """Return the length of one move along X, Y and Z (mm); see ``path_lengths``."""
    if sweep[row] != 0.0:
        radius = math.hypot(start[row, 0] - centre[row, 0], start[row, 1] - centre[row, 1])
        flat = radius * abs(sweep[row])
    else:
        flat = math.hypot(end[row, 0] - start[row, 0], end[row, 1] - start[row, 1])
    return math.hypot(flat, end[row, 2] - start[row, 2])


@kernel(allocates=False)
def rapid_seconds(start: F64_2, end: F64_2, rapid: Bool_1, velocity: F64_1) -> float:
    """Return the sum of the durations of the rapids among n moves (s), without acceleration.

    Travel from or to an unknown position takes no time.

    Parameters
    ----------
    start, end : (n, k)
        Positions of k axes at the start and the end of each move (mm, degrees).
    rapid
        Mask of the rapids, in which the axes run at their greatest velocities, (n,).
    velocity : (k,) mm/s, degrees/s
        Greatest velocity of each axis.
    """
    total = 0.0
    for row in range(len(start)):
        if rapid[row]:
            slowest = 0.0
            for axis in range(len(velocity)):
                distance = abs(end[row, axis] - start[row, axis])
                if not math.isnan(distance):
                    slowest = max(slowest, distance / velocity[axis])
            total += slowest
    return total


@kernel(allocates=False)
def feed_seconds(
    start: F64_2,
    end: F64_2,
    centre: F64_2,
    sweep: F64_1,
    feeding: Bool_1,
    inverse: Bool_1,
    feed: F64_1,
) -> float:
    """Return the sum of the durations of the feed moves among n moves (s), without acceleration.

    A move of unknown length or without a feed takes no time.

    Parameters
    ----------
    start, end, centre, sweep
        The moves; see ``path_lengths``.
    feeding
        Mask of the feed moves, (n,).
    inverse
        Mask of the moves whose ``feed`` is 1 / duration in minutes, (n,).
    feed : (n,) mm/min
        Feed of each move.
    """
    total = 0.0
    for row in range(len(start)):
        if feeding[row]:
            if inverse[row]:
                minutes = 1.0 / feed[row]
            else:
                minutes = path_length(start, end, centre, sweep, row) / feed[row]
            if math.isfinite(minutes):
                total += 60.0 * minutes
    return total


@kernel(allocates=False)
def _record_extremes(
    start: F64_2,
    end: F64_2,
    centre: F64_2,
    sweep: F64_1,
    row: int,
    reached: OutF64_2,
) -> None:
    """Write the lowest (row 0) and the highest (row 1) of the positions that end a move, or that
    are extremes of its arc, to ``reached``, (2, k).

    The move is row ``row`` of the other arguments, which ``reached_positions`` describes.
    """
    for axis in range(end.shape[1]):
        reached[0, axis] = end[row, axis]
        reached[1, axis] = end[row, axis]
    if sweep[row] == 0.0:
        return
    out_x, out_y = start[row, 0] - centre[row, 0], start[row, 1] - centre[row, 1]
    radius, first = math.hypot(out_x, out_y), math.atan2(out_y, out_x)
    for quarter in range(4):
        angle = quarter * math.pi / 2.0
        ahead = (angle - first if sweep[row] > 0.0 else first - angle) % (2.0 * math.pi)
        if ahead <= abs(sweep[row]):
            x = centre[row, 0] + radius * math.cos(angle)
            y = centre[row, 1] + radius * math.sin(angle)
            reached[0, 0], reached[1, 0] = min(reached[0, 0], x), max(reached[1, 0], x)
            reached[0, 1], reached[1, 1] = min(reached[0, 1], y), max(reached[1, 1], y)


@kernel
def reached_positions(start: F64_2, end: F64_2, centre: F64_2, sweep: F64_1) -> Any:
    """Return the lowest and the highest positions that k axes reach in each of n moves, (n, k)
    each.

    The start of a move does not count.

    Parameters
    ----------
    start, end : (n, k)
        Positions of the axes at the start and the end of each move (mm, degrees).  X and Y, which
        move on arcs, are the first two columns.
    centre, sweep : (n, 2) mm and (n,) radians
        Centre and signed sweep of each arc; the sweep of a line is 0.
    """
    low, high = np.empty(end.shape), np.empty(end.shape)
    reached = np.empty((2, end.shape[1]))
    for row in range(len(start)):
        _record_extremes(start, end, centre, sweep, row, reached)
        for axis in range(end.shape[1]):
            low[row, axis], high[row, axis] = reached[0, axis], reached[1, axis]
    return low, high


@kernel
def within_limits(
    start: F64_2, end: F64_2, centre: F64_2, sweep: F64_1, limits: F64_2, tolerance: float
) -> Any:
    """Return the mask of those of n moves that stay within the limits of the axes, (n,).

    An unknown position, NaN, is within the limits.

    Parameters
    ----------
    start, end, centre, sweep
        The moves; see ``reached_positions``.
    limits : (k, 2)
        Lowest and highest position of each axis (mm, degrees).
    tolerance : mm, degrees
        Permitted excess.
    """
    good = np.ones(len(start), np.bool_)
    reached = np.empty((2, end.shape[1]))
    for row in range(len(start)):
        if sweep[row] == 0.0:
            for axis in range(end.shape[1]):
                low, high = limits[axis, 0], limits[axis, 1]
                if (
                    low - end[row, axis] > tolerance
                    or end[row, axis] - high > tolerance
                    or start[row, axis] < low - tolerance
                    or start[row, axis] > high + tolerance
                ):
                    good[row] = False
            continue
        _record_extremes(start, end, centre, sweep, row, reached)
        for axis in range(end.shape[1]):
            low, high = limits[axis, 0], limits[axis, 1]
            if (
                low - reached[0, axis] > tolerance
                or reached[1, axis] - high > tolerance
                or start[row, axis] < low - tolerance
                or start[row, axis] > high + tolerance
            ):
                good[row] = False
    return good
