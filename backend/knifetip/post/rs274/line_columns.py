"""line_columns: round the poses of moves to printed digits, and compute the times of the moves."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import F64_1, F64_2, I64_1, I64_2, U8_1, Bool_1, Bool_2, kernel
from knifetip.model.toolpath import Motion

#: Least time of a move in G93 (minutes).
MIN_MINUTES: Final = 1e-4 / 60.0

_RAPID: Final = int(Motion.RAPID)
_SWIVEL: Final = int(Motion.SWIVEL)


class TimeRules(NamedTuple):
    """The rules by which the moves of one station are timed."""

    scale: float  #: printed units per mm and per degree
    turn_velocity: float  #: degrees/min, greatest velocity of C
    arcs: bool  #: arcs in which C turns are timed
    always: bool  #: all feed moves are timed


class LineColumns(NamedTuple):
    """The columns of m program lines; see ``line_text.LineWords``."""

    row: I64_1  #: (m,) index of the move
    code: U8_1
    rapid: Bool_1
    inverse: Bool_1
    axes: I64_2  #: (m, 4)
    emit: Bool_2  #: (m, 4)
    feed: F64_1  #: (m,) mm/min or degrees/min; 1 / minutes if ``inverse``
    turn: F64_1  #: (m,) degrees, turn of C
    travel: F64_1  #: (m,) mm, length of the move
    minutes: F64_1  #: (m,) time of the move


@kernel
def round_poses(pose: F64_2, scale: float) -> Any:
    """Return poses in units of the last printed digit, (n + 1, 4).

    ``pose`` are the poses, (n + 1, 4) mm and degrees, and ``scale`` is the number of units per mm
    and per degree.
    """
    units = np.empty(pose.shape, np.int64)
    for row in range(len(pose)):
        for axis in range(4):
            units[row, axis] = np.int64(np.rint(pose[row, axis] * scale))
    return units


@kernel(allocates=False)
def swivel_without_turn(units: I64_2, motion: U8_1) -> int:
    """Return the index of the first swivel that moves without a turn of C, -1 if there is none.

    A move of one unit may be only the rounding of a turn that is too small to be written.  For
    ``units`` and ``motion`` see ``compute_lines``.
    """
    for row in range(len(motion)):
        if motion[row] == _SWIVEL and units[row + 1, 3] == units[row, 3]:
            for axis in range(3):
                if abs(units[row + 1, axis] - units[row, axis]) > 1:
                    return row
    return -1


@kernel
def compute_lines(
    units: I64_2, bulge: F64_1, arc_length: F64_1, motion: U8_1, feed: F64_1, rules: TimeRules
) -> Any:
    """Return the ``LineColumns`` of n moves.

    A move other than the first gets no line if its length and its turn are both 0 after rounding.

    Parameters
    ----------
    units : (n + 1, 4)
        Rounded poses before the first move and after each move; see ``round_poses``.
    bulge : (n,)
        tan(sweep / 4) of each move; 0 for a line.
    arc_length : (k,) mm
        Lengths along X and Y of the k moves with a bulge.
    motion : (n,)
        ``Motion`` of each move.
    feed : (n,) mm/min
        Feed of each move; degrees/min for a swivel.
    rules
        The rules by which the moves are timed.
    """
    count = len(motion)
    rows, code = np.empty(count, np.int64), np.empty(count, np.uint8)
    rapid, inverse = np.empty(count, np.bool_), np.empty(count, np.bool_)
    axes, emit = np.empty((count, 4), np.int64), np.empty((count, 4), np.bool_)
    line_feed, turn = np.empty(count), np.empty(count)
    travel, minutes = np.empty(count), np.empty(count)
    used, arcs = 0, 0
    for row in range(count):
        is_arc, prints = bulge[row] != 0.0, row == 0
        flat = 0.0
        if is_arc:
            flat = arc_length[arcs]
            arcs += 1
        for axis in range(4):
            changes = units[row + 1, axis] != units[row, axis]
            prints |= changes
            emit[used, axis] = changes or row == 0 or (is_arc and axis != 2)
            axes[used, axis] = units[row + 1, axis]
        if not prints:
            continue
        if not is_arc:
            x = units[row + 1, 0] / rules.scale - units[row, 0] / rules.scale
            y = units[row + 1, 1] / rules.scale - units[row, 1] / rules.scale
            flat = math.sqrt(x * x + y * y)
        rise = units[row + 1, 2] / rules.scale - units[row, 2] / rules.scale
        degrees = units[row + 1, 3] / rules.scale - units[row, 3] / rules.scale
        is_rapid, is_swivel = motion[row] == _RAPID, motion[row] == _SWIVEL
        length = math.hypot(flat, rise)
        work = abs(degrees) if is_swivel else length
        time = work if is_rapid else work / feed[row]
        time = max(time, abs(degrees) / rules.turn_velocity)
        timed = rules.always or (degrees != 0.0 and (not is_arc or is_swivel or rules.arcs))
        rows[used], rapid[used], inverse[used] = row, is_rapid, timed and not is_rapid
        if inverse[used] or time == 0.0:
            # Only in inverse time does the program state the time of a move.
            time = max(time, MIN_MINUTES)
        code[used] = 0 if is_rapid else (1 if not is_arc else (3 if bulge[row] > 0.0 else 2))
        line_feed[used] = 1.0 / time if inverse[used] else feed[row]
        turn[used], travel[used], minutes[used] = degrees, length, time
        used += 1
    return LineColumns(
        rows[:used], code[:used], rapid[:used], inverse[:used], axes[:used], emit[:used],
        line_feed[:used], turn[:used], travel[:used], minutes[:used],
    )  # fmt: skip
