"""contour_starts: find the points at which a tool may start the closed paths of an operation.

A knife starts at a corner at which it is lifted and turned anyway: such a corner needs no overrun,
and a start there saves one lift.  A closed path without such a corner, and every path of a router
or a laser, starts in the middle of a segment (ADR 4).
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.compensation.corner import turn_angles
from knifetip.compensation.tracks import end_azimuths
from knifetip.geometry import arc
from knifetip.geometry.azimuth import azimuth, left_normal, turn_angle, unit_vectors
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.path import Paths, longest_segments, segments_before
from knifetip.geometry.tolerance import ANGLE, BULGE
from knifetip.model.contour_starts import ContourStarts
from knifetip.model.operation import End, Operation
from knifetip.model.tool import DiscTool, Knife

#: Greatest number of starts per path, to limit time and memory.
_MOST_STARTS: Final = 12
#: A segment in whose middle a path starts is at least this long (mm), unless it is the longest one.
SHORTEST_START: Final = 2.0
#: A knife starts only in segments that are longer than the overrun by this factor.
_OVERRUN_FACTOR: Final = 4.0


def contour_starts(operation: Operation) -> ContourStarts | None:
    """Return the possible starts of the paths of an operation; None if the tool has no choice."""
    closed = operation.finish == End.CLOSED
    if isinstance(operation.tool, Knife) and operation.side == 0 and closed.any():
        return _knife_starts(operation, closed)
    if isinstance(operation.tool, DiscTool) and not len(operation.bridges) and closed.any():
        return _disc_starts(operation, operation.tool, closed)
    return None


def lifting_corners(operation: Operation, blade: Knife) -> Bool:
    """Return the mask of the segments of closed paths at whose start a knife is lifted and turned,
    (n,).
    """
    paths = operation.paths
    ahead, arriving = end_azimuths(paths)
    turn = turn_angle(arriving[segments_before(paths)], ahead)
    closed = (operation.finish == End.CLOSED)[paths.path_of]
    result: Bool = closed & (np.abs(turn) > blade.lift_angle)
    return result


def _knife_starts(operation: Operation, closed: Bool) -> ContourStarts:
    """Return the possible starts of p paths of a knife without leads.

    ``closed`` is the mask of the closed paths, (p,).
    """
    blade, paths = operation.tool, operation.paths
    assert isinstance(blade, Knife)
    corner = lifting_corners(operation, blade)
    owner = paths.path_of
    smooth = closed & (np.bincount(owner[corner], minlength=len(paths)) == 0)
    depth = np.minimum(operation.depth[:, -1], operation.caliper)
    shortest = np.maximum(SHORTEST_START, _OVERRUN_FACTOR * blade.lead(1.0) * depth)
    allowed = corner | (smooth[owner] & _long_segments(paths, shortest, smooth, operation.endable))
    allowed[paths.first[:-1]] |= ~closed
    rows = _limit_starts(_keep_chosen_starts(allowed, operation), paths)
    entry, leave = np.empty((len(rows), 3)), np.empty((len(rows), 3))
    in_middle = (smooth & (operation.starts < 0))[owner[rows]]
    middles = np.flatnonzero(in_middle)
    entry[middles] = leave[middles] = _middles(paths, rows[middles])
    at_start = np.flatnonzero(~in_middle)
    first = rows[at_start]
    ahead, _ = arc.tangents(paths.start[first], paths.end[first], paths.bulge[first])
    entry[at_start, :2], entry[at_start, 2] = paths.start[first], azimuth(ahead)
    # A closed path ends with the segment before its first one.
    finish = paths.first[1:][owner[first]] - 1
    last = np.where(closed[owner[first]], segments_before(paths)[first], finish)
    _, arriving = arc.tangents(paths.start[last], paths.end[last], paths.bulge[last])
    leave[at_start, :2], leave[at_start, 2] = paths.end[last], azimuth(arriving)
    return _starts(paths, rows, entry, leave)


def _disc_starts(operation: Operation, cutter: DiscTool, closed: Bool) -> ContourStarts:
    """Return the possible starts of p paths of a router or a laser.

    Beside a contour the cutter enters and leaves the board at the far end of its lead-in.  With a
    lead-in round a corner it starts at a corner that turns far enough away from the cutter.
    ``closed`` is the mask of the closed paths, (p,).
    """
    paths = operation.paths
    owner = paths.path_of
    corner = np.zeros(len(owner), np.bool_)
    if operation.side != 0 and cutter.approach < 0.0:
        turn = np.degrees(turn_angles(paths, operation.side))
        corner = closed[owner] & (turn >= -cutter.approach - ANGLE)
        corner &= operation.endable[segments_before(paths)]
    # At an inner corner the centre path is shorter than the contour.
    shortest = np.full(len(owner), max(SHORTEST_START, 4.0 * cutter.radius))
    smooth = closed & (np.bincount(owner[corner], minlength=len(paths)) == 0)
    allowed = corner | (smooth[owner] & _long_segments(paths, shortest, smooth, operation.endable))
    allowed[paths.first[:-1]] |= ~closed
    rows = _limit_starts(_keep_chosen_starts(allowed, operation), paths)
    last = paths.first[1:][owner[rows]] - 1
    entry = _middles(paths, rows)
    entry[:, 2] = 0.0
    at_start = ~(smooth | (operation.starts >= 0))[owner[rows]]
    entry[at_start, :2] = paths.start[rows][at_start]
    is_open = ~closed[owner[rows]]
    leave = entry.copy()
    leave[is_open, :2] = paths.end[last][is_open]
    if operation.side != 0:
        along = unit_vectors(paths.end[rows] - paths.start[rows])
        beside = operation.side * cutter.lead_in * left_normal(along)
        entry[~is_open, :2] += beside[~is_open]
        leave[~is_open, :2] += beside[~is_open]
    return _starts(paths, rows, entry, leave)


def _long_segments(paths: Paths, shortest: F64, mask: Bool, endable: Bool) -> Bool:
    """Return the mask of the n segments in whose middle a path may start, (n,).

    These are the lines of at least ``shortest``, (n,) mm, and the longest segment of each path in
    ``mask``, (p,).  ``endable`` is the mask of the segments in which the paths may begin, (n,).
    """
    long: Bool = arc.length(paths.start, paths.end, paths.bulge) >= shortest
    long &= (np.abs(paths.bulge) < BULGE) & endable
    if mask.any():
        long[longest_segments(paths, endable)[mask]] = True
    return long


def _keep_chosen_starts(allowed: Bool, operation: Operation) -> Bool:
    """Return the mask of the n segments with which paths may start, (n,).  If the user has chosen a
    start for a path, only this start remains.
    """
    chosen = operation.fixed[operation.fixed >= 0]
    if len(chosen) == 0:
        return allowed
    result = allowed & (operation.starts < 0)[operation.paths.path_of]
    result[chosen] = True
    return result


def _limit_starts(allowed: Bool, paths: Paths) -> I32:
    """Return the allowed segments, evenly reduced to ``_MOST_STARTS`` per path, (k,).

    ``allowed`` is the mask of the n segments, with at least one for each path.  The segments are
    counted from the leftmost and lowest one of each path, so that the first segment of a closed
    path in the drawing does not matter.
    """
    rows = np.flatnonzero(allowed)
    owner = paths.path_of[rows]
    count = np.bincount(owner, minlength=len(paths))
    before = np.cumsum(count) - count
    x, y = paths.start[rows].T
    leftmost = np.lexsort((y, x, owner))[before]
    place = (np.arange(len(rows)) - leftmost[owner]) % count[owner]
    size = np.maximum(count, _MOST_STARTS)[owner]
    kept = place * _MOST_STARTS // size > (place - 1) * _MOST_STARTS // size
    result: I32 = rows[kept].astype(np.int32)
    return result


def _middles(paths: Paths, rows: I32) -> F64:
    """Return the middle of each of k segments (mm) and the direction there (degrees), (k, 3)."""
    start, end = paths.start[rows], paths.end[rows]
    middle = arc.point_at(start, end, paths.bulge[rows], np.full(len(rows), 0.5))
    return np.column_stack([middle, azimuth(end - start)])


def _starts(paths: Paths, rows: I32, entry: F64, leave: F64) -> ContourStarts:
    """Return the record of k starts; ``rows`` are their segments, path by path, (k,)."""
    count = np.bincount(paths.path_of[rows], minlength=len(paths))
    return ContourStarts(np.concatenate([[0], np.cumsum(count)]), rows, entry, leave)
