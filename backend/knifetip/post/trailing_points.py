"""trailing_points: round the points of the axis of a free blade so that its tip stays on its path.

A free blade trails its axis by e, and only the path of the axis turns it.  Where points are rounded
one by one, each error turns the blade, and the errors of a tight bend add up: on a circle of
0.1 mm the axis travels 7.5 times as far as the tip.  Therefore each point is chosen from the nine
nearest ones so that tip and axis come closest to their planned positions, given the heading that
the blade has from the points before.  In front of a track the axis is placed by this heading, too.

The blade is dragged along a line of length s as in ``sequencing.free_blades``: the angle φ from the
direction of travel to the blade falls as tan(φ/2) = tan(φ₀/2) exp(-s / e).

Source: our derivation.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I64, U8
from knifetip.kernels import F64_1, F64_2, U8_1, Bool_1, inline_kernel, kernel
from knifetip.model.machine import Machine
from knifetip.model.tool import Knife
from knifetip.model.toolpath import Motion

#: Weight of the squared error of the tip, whose path is the cut, against that of the axis.
_TIP_WEIGHT: Final = 2.0
# Kernels take plain numbers.
_RAPID, _PLUNGE, _LIFT = int(Motion.RAPID), int(Motion.PLUNGE), int(Motion.LIFT)


def round_points(
    point: F64, heading: F64, motion: U8, tool: U8, machine: Machine, units: float
) -> I64:
    """Return the whole points of the head in m moves, (m + 1, 2) units of a device.

    Points of tools other than free blades are rounded one by one.

    Parameters
    ----------
    point : (m + 1, 2) units
        Planned points before the first move and after each move.
    heading : (m + 1,) degrees
        Planned heading of the tool at each point.
    motion, tool : (m,)
        ``Motion`` and station of each move.
    machine
        Machine with the stations.
    units
        Units per mm.
    """
    rounded = np.rint(point)
    for station in machine.stations:
        blade = station.tool
        if isinstance(blade, Knife) and blade.free:
            own = tool == station.number
            rounded = _chosen_points(
                np.ascontiguousarray(point),
                np.ascontiguousarray(rounded),
                np.radians(heading),
                motion,
                own,
                units * blade.trail,
                math.radians(blade.park_heading),
            )
    result: I64 = rounded.astype(np.int64)
    return result


@inline_kernel
def _dragged_heading(heading: float, x: float, y: float, trail: float) -> float:
    """Return the heading of a blade whose axis has moved by (x, y) (radians)."""
    length = math.hypot(x, y)
    angle = heading - math.atan2(y, x)
    angle = math.atan2(math.sin(angle), math.cos(angle))
    if length == 0.0 or abs(angle) > math.pi - 1e-9:
        return heading
    after: float = 2.0 * math.atan(math.tan(0.5 * angle) * math.exp(-length / trail))
    return heading + after - angle


@inline_kernel
def _leads_down(point: F64_2, motion: U8_1, row: int) -> bool:
    """Return whether a rapid ends where the blade is lowered next."""
    while row + 1 < len(motion) and motion[row] == _RAPID:
        row += 1
        if point[row + 1, 0] != point[row, 0] or point[row + 1, 1] != point[row, 1]:
            return False
    lowered: bool = motion[row] == _PLUNGE
    return lowered


@kernel
def _chosen_points(
    point: F64_2,
    rounded: F64_2,
    heading: F64_1,
    motion: U8_1,
    own: Bool_1,
    trail: float,
    park: float,
) -> Any:
    """Return the whole points with those of the moves of one free blade chosen, (m + 1, 2) units.

    ``point``, ``rounded`` (m + 1, 2) units: planned points, and the same rounded one by one.
    ``heading`` (m + 1,) radians: planned heading at each point.
    ``motion``, ``own`` (m,): ``Motion`` of each move, and whether the blade makes it.
    ``trail`` units: distance of the tip behind the axis.
    ``park`` radians: heading of the blade before the first move.
    """
    chosen = rounded.copy()
    blade = park
    for row in range(len(motion)):
        if not own[row]:
            continue
        x, y = point[row + 1, 0], point[row + 1, 1]
        planned = heading[row + 1]
        tip_x, tip_y = x - trail * math.cos(planned), y - trail * math.sin(planned)
        stays = x == point[row, 0] and y == point[row, 1]
        if motion[row] == _PLUNGE or motion[row] == _LIFT or (motion[row] == _RAPID and stays):
            if stays:
                chosen[row + 1] = chosen[row]
            continue
        if motion[row] == _RAPID:
            if _leads_down(point, motion, row):
                chosen[row + 1, 0] = np.rint(tip_x + trail * math.cos(blade))
                chosen[row + 1, 1] = np.rint(tip_y + trail * math.sin(blade))
            continue
        least, best_x, best_y, best = math.inf, chosen[row + 1, 0], chosen[row + 1, 1], blade
        for number in range(9):
            to_x = rounded[row + 1, 0] + (number // 3 - 1)
            to_y = rounded[row + 1, 1] + (number % 3 - 1)
            after = _dragged_heading(blade, to_x - chosen[row, 0], to_y - chosen[row, 1], trail)
            off_x = to_x - trail * math.cos(after) - tip_x
            off_y = to_y - trail * math.sin(after) - tip_y
            error = _TIP_WEIGHT * (off_x**2 + off_y**2) + (to_x - x) ** 2 + (to_y - y) ** 2
            if error < least:
                least, best_x, best_y, best = error, to_x, to_y, after
        chosen[row + 1, 0], chosen[row + 1, 1], blade = best_x, best_y, best
    return chosen
