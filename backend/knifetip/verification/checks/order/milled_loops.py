"""Find the milling that follows a closed path round it, which has released the board there.

A disc that goes through the board on a closed path separates what lies inside the path from what
lies outside, whatever the cuts of the drawing are: if a bay in a part has a mouth narrower than the
disc, the path round the part closes the mouth too.  So a path inside is made in a loose piece.
Closed paths are found in the program, and not derived from the cuts.
"""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import F64_2, F64_3, I64_1, OutF64_1, inline_kernel, kernel
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.verification.checks.common.context import DEPTH_TOLERANCE
from knifetip.verification.columns import F64, I64
from knifetip.verification.curves.curve import point_at
from knifetip.verification.expectation.edges import JOIN_DISTANCE
from knifetip.verification.expectation.outline import ray_crossings
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind, expected_tool

#: A closed path begins and ends within so many tip paths of the ends of its track; the others are
#: leads.
_LEADS: Final = 4
#: Paths that are less far inside a closed path lie beside it or repeat it (mm).
_MARGIN: Final = 0.1
#: Shifts of the four tested points along X and Y; the rays pass between vertices of round numbers.
_SHIFTS: Final = _MARGIN * np.array([(1, 0.0137), (-1, -0.0211), (0.0173, 1), (-0.0119, -1)])


class _Loops(NamedTuple):
    """c closed paths of discs through the board."""

    curve: F64_2  #: (k, 6) their tip paths, loop by loop
    first: I64_1  #: (c + 1,) first tip path of each loop
    box: F64_2  #: (c, 4) mm, low x, low y, high x, high y
    line: I64_1  #: (c,) program line that closes each loop


def loose_lines(work: TipPaths, machine: Machine, board: Board) -> tuple[I64, F64]:
    """Return the m program lines in which discs mill, ascending, (m,), and for each of them the
    program line that has released the board there, (m,).

    The latter is infinite for a line that lies in no closed path that an earlier line closes.
    ``work`` are all tip paths, in the order of the program.
    """
    rows = np.flatnonzero(work.operation == OperationKind.MILL)
    curve, line = work.curve[rows], work.line[rows].astype(np.int64)
    loops = _find_loops(work, rows, machine, board)
    points = np.stack([point_at(curve, share * curve[:, 5]) for share in (0.5, 0.0, 1.0)], axis=1)
    released = np.full(len(rows), np.inf)
    order = np.argsort(points[:, 0, 0], kind="stable")
    _release_paths(points[order], line[order], order, loops, _SHIFTS, released)
    lines, place = np.unique(line, return_inverse=True)
    result = np.full(len(lines), np.inf)
    np.minimum.at(result, place, released)
    return lines, result


def _find_loops(work: TipPaths, rows: I64, machine: Machine, board: Board) -> _Loops:
    """Return the closed paths of discs through the board, at most one of each track.

    ``rows`` are the indices of the tip paths of discs.
    """
    through = np.array(
        [
            expected_tool(station.tool).through_depth(board.caliper, machine.into_mat)
            for station in machine.stations
        ]
    )
    deep = board.caliper - work.z[rows] >= through[work.station[rows]] - DEPTH_TOLERANCE
    rows = rows[deep]
    first = np.flatnonzero(np.diff(work.track[rows], prepend=-1) != 0)
    start, end = (points[rows] for points in work.ends())
    low, high = _closed_ranges(start, end, np.append(first, len(rows)))
    kept = high > low
    low, high = low[kept], high[kept]
    size = high - low
    bounds = np.concatenate([[0], np.cumsum(size)])
    inner = np.repeat(low - bounds[:-1], size) + np.arange(bounds[-1])
    curve = np.ascontiguousarray(work.curve[rows[inner]])
    box = np.empty((len(size), 4))
    bow = np.where(curve[:, 0] == 0.0, 0.0, curve[:, 5])
    if len(size):
        # No point of an arc is farther from its start than the arc is long.
        for axis in range(2):
            one, other = start[inner, axis], end[inner, axis]
            box[:, axis] = np.minimum.reduceat(np.minimum(one, other) - bow, bounds[:-1])
            box[:, 2 + axis] = np.maximum.reduceat(np.maximum(one, other) + bow, bounds[:-1])
    line = work.line[rows[high - 1]].astype(np.int64)
    return _Loops(curve, bounds.astype(np.int64), box, line)


@kernel
def _closed_ranges(start: F64_2, end: F64_2, first: I64_1) -> Any:
    """Return the first tip path of the closed path of each of t tracks, and the one after its last,
    (t,) each; both are equal for a track without a closed path.

    ``start``, ``end`` (n, 2) mm: ends of the tip paths.
    ``first`` (t + 1,): first tip path of each track, and n.
    """
    count = len(first) - 1
    low, high = np.zeros(count, np.int64), np.zeros(count, np.int64)
    for track in range(count):
        begin, stop = first[track], first[track + 1]
        for i in range(begin, min(begin + _LEADS, stop)):
            for j in range(stop - 1, max(stop - 1 - _LEADS, i - 1), -1):
                apart = max(abs(start[i, 0] - end[j, 0]), abs(start[i, 1] - end[j, 1]))
                if apart <= JOIN_DISTANCE and j + 1 - i > high[track] - low[track]:
                    low[track], high[track] = i, j + 1
    return low, high


@kernel
def _release_paths(
    points: F64_3, line: I64_1, row: I64_1, loops: _Loops, shifts: F64_2, released: OutF64_1
) -> None:
    """Write the program line that has released the board under each of n tip paths to ``released``.

    The board under a path that leaves a loop is not regarded as released: a long cut may also be
    made after the piece that it crosses.

    ``points`` (n, 3, 2) mm: middle, start and end of each tip path, sorted by the x of the middle.
    ``line``, ``row`` (n,): program line of each tip path, and the path's place in ``released``.
    ``shifts`` (4, 2) mm: shifts of the points that must lie in a loop, too.
    """
    first = np.searchsorted(points[:, 0, 0].copy(), loops.box[:, 0].copy())
    for loop in range(len(loops.line)):
        closed = loops.line[loop]
        for k in range(first[loop], len(points)):
            if points[k, 0, 0] > loops.box[loop, 2]:
                break
            if line[k] <= closed or released[row[k]] <= closed:
                continue
            if points[k, 0, 1] < loops.box[loop, 1] or points[k, 0, 1] > loops.box[loop, 3]:
                continue
            inside = True
            for place in range(3):
                if inside:
                    x, y = points[k, place, 0], points[k, place, 1]
                    inside = _is_inside(x, y, loops, loop, shifts)
            if inside:
                released[row[k]] = closed


@inline_kernel
def _is_inside(x: float, y: float, loops: _Loops, loop: int, shifts: F64_2) -> bool:
    """Return whether a point lies in a loop, and ``_MARGIN`` to its right, left, above and below,
    too.
    """
    for k in range(len(shifts)):
        crossed = 0
        for row in range(loops.first[loop], loops.first[loop + 1]):
            crossed += ray_crossings(loops.curve[row], x + shifts[k, 0], y + shifts[k, 1])
        if crossed % 2 == 0:
            return False
    return True
