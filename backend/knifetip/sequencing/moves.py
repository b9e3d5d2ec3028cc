"""moves: measure the moves of a toolpath, for the functions that compute their times."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_1, F64_2, I64_1, U8_1, Bool_1, kernel
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.travel import carriage_changes

#: A shorter move is no move (mm or degrees).
STILL: Final = 1e-9
#: ``Motion`` values for the kernel.
_RAPID: Final = int(Motion.RAPID)
_SWIVEL: Final = int(Motion.SWIVEL)


class Arcs(NamedTuple):
    """The k rows of a toolpath that are arcs."""

    row: I64_1  #: (k,) ascending
    length: F64_1  #: (k,) mm
    radius: F64_1  #: (k,) mm
    begin: F64_2  #: (k, 2) tangent at the start, as long as the arc
    finish: F64_2  #: (k, 2) tangent at the end, as long as the arc


class Limits(NamedTuple):
    """Figures of n rows of a toolpath, (n,) each; ``durations`` has the formulas."""

    length: F64_1  #: over all four axes, mm and degrees added alike
    travel: F64_1  #: mm, along XYZ
    velocity: F64_1  #: greatest velocity along the row, at the programmed feed
    fastest: F64_1  #: greatest velocity along the row that the axes permit
    acceleration: F64_1  #: greatest acceleration along the row
    seconds: F64_1  #: s, time of the row at its greatest velocity


class Moves(NamedTuple):
    """The n moves of a toolpath, in their order; a move is one row."""

    pose: F64_2  #: (n + 1, 4) X, Y, Z (mm) and C (degrees) before and after each move
    rapid: Bool_1  #: (n,) moves at the greatest velocity of the axes
    arcs: Arcs
    limits: Limits
    hardest: F64_1  #: (4,) greatest acceleration that all carriages permit for X, Y, Z and C


def measure_moves(toolpath: Toolpath, machine: Machine) -> Moves:
    """Return the moves of a toolpath that a machine makes."""
    pose = np.ascontiguousarray(toolpath.pose)
    arcs = _measure_arcs(toolpath)
    parked = np.zeros(len(toolpath), np.bool_)
    parked[carriage_changes(toolpath, machine)] = True
    carriages = _measure_carriages(machine)
    motion = np.ascontiguousarray(toolpath.motion)
    tool = np.ascontiguousarray(toolpath.tool)
    limits = _row_limits(pose, arcs, parked, tool, carriages, toolpath.feed, motion)
    return Moves(pose, motion == Motion.RAPID, arcs, limits, carriages.hardest.min(axis=0))


def _measure_arcs(toolpath: Toolpath) -> Arcs:
    """Return the arcs of a toolpath."""
    rows = np.flatnonzero(np.abs(toolpath.bulge) >= BULGE)
    start, end, bulge = toolpath.pose[rows, :2], toolpath.pose[rows + 1, :2], toolpath.bulge[rows]
    length = arc.length(start, end, bulge)
    # Tangents are as long as the chord; scaled to the length of the arc.
    chord = np.hypot(*(end - start).T)
    stretch = (length / np.where(chord > 0.0, chord, 1.0))[:, None]
    begin, finish = arc.tangents(start, end, bulge)
    return Arcs(rows, length, arc.radius(start, end, bulge), begin * stretch, finish * stretch)


class _Carriages(NamedTuple):
    """The c carriages of a machine."""

    of_tool: I64_1  #: (256,) index of the carriage of the station with each number
    fastest: F64_2  #: (c, 4) greatest velocity of X, Y, Z and C
    hardest: F64_2  #: (c, 4) greatest acceleration of X, Y, Z and C


def _measure_carriages(machine: Machine) -> _Carriages:
    """Return the carriages of a machine."""
    of_tool = np.zeros(256, np.int64)
    for station in machine.stations:
        of_tool[station.number] = station.carriage - 1
    return _Carriages(
        of_tool,
        np.array([[axis.velocity for axis in one.axes] for one in machine.carriages]),
        np.array([[axis.acceleration for axis in one.axes] for one in machine.carriages]),
    )


@kernel
def _row_limits(
    pose: F64_2,
    arcs: Arcs,
    parked: Bool_1,
    tool: U8_1,
    carriages: _Carriages,
    feed: F64_1,
    motion: U8_1,
) -> Any:
    """Return the ``Limits`` of n rows of a toolpath.

    ``pose`` (n + 1, 4): poses before and after each row.
    ``parked`` (n,): mask of the rows before which the row's carriage was parked: only X moves.
    ``tool`` (n,): number of the station that makes each row.
    ``feed``, ``motion`` (n,): programmed feed, and ``Motion``.
    """
    count = len(feed)
    length, travel = np.empty(count), np.empty(count)
    velocity, acceleration = np.empty(count), np.empty(count)
    fastest, seconds = np.empty(count), np.empty(count)
    reach = np.empty(4)
    next_arc = 0
    for row in range(count):
        own = carriages.of_tool[tool[row]]
        for axis in range(4):
            reach[axis] = abs(pose[row + 1, axis] - pose[row, axis])
            if parked[row] and axis > 0:
                reach[axis] = 0.0
        flat = math.hypot(reach[0], reach[1])
        is_arc = next_arc < len(arcs.row) and arcs.row[next_arc] == row
        if is_arc:
            flat = reach[0] = reach[1] = arcs.length[next_arc]
        # On an arc X and Y share its length, which counts once.
        length[row] = math.sqrt(flat * flat + reach[2] * reach[2] + reach[3] * reach[3])
        travel[row] = flat if reach[2] == 0.0 else math.hypot(flat, reach[2])
        safe = length[row] if length[row] > STILL else 1.0
        fast, hard = math.inf, math.inf
        for axis in range(4):
            if reach[axis] > 0.0:
                fraction = reach[axis] / safe
                fast = min(fast, carriages.fastest[own, axis] / fraction)
                hard = min(hard, carriages.hardest[own, axis] / fraction)
        if is_arc:
            thrust = min(carriages.hardest[own, 0], carriages.hardest[own, 1])
            fast = min(fast, math.sqrt(thrust * arcs.radius[next_arc]) * safe / flat)
            next_arc += 1
        fastest[row] = fast
        feed_time = 0.0
        if motion[row] != _RAPID and feed[row] > 0.0:
            way = reach[3] if motion[row] == _SWIVEL else travel[row]
            feed_time = 60.0 * way / feed[row]
        if feed_time > 0.0:
            fast = min(fast, safe / feed_time)
        velocity[row], acceleration[row] = fast, hard
        seconds[row] = max(feed_time, safe / fast)
    return Limits(length, travel, velocity, fastest, acceleration, seconds)
