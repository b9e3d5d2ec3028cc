"""duration: estimate the time that the machine takes for each row of a toolpath.

A row is one move.  Every move has a trapezoidal speed profile within the limits of all axes.
Look-ahead keeps the speed at tangent joints and stops the head at corners.  Also included are the
dwells after a piston or the oscillation of a tool is switched, and the times for which the
controller halts between moves (``timing``).

As in grblHAL, the length of a move is computed from all four axes, with mm and degrees added alike.
The speed is limited for each axis separately, so the time of a move does not depend on this
convention.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.chords import DEVIATION, chord_counts, split_moves
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_1, F64_2, I64_1, U8_1, Bool_1, kernel
from knifetip.languages.registry import find_language
from knifetip.model.held_heading import hold_heading
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.timing import STILL, Timing
from knifetip.sequencing.travel import carriage_changes

#: ``Motion`` values for the kernel.
_RAPID: Final = int(Motion.RAPID)
_SWIVEL: Final = int(Motion.SWIVEL)
#: At a joint the velocity of an axis may jump by its acceleration times this (s).
JOLT: Final = 0.002


def duration(toolpath: Toolpath, machine: Machine) -> float:
    """Return the time that the machine takes for a toolpath (s)."""
    return float(durations(toolpath, machine).sum())


def durations(toolpath: Toolpath, machine: Machine) -> F64:
    """Return the time of each of the n rows of a toolpath, (n,) s; a row is one move.

    The time of a station change is added to the first row of the new station, and the time of a
    halt to the row before the halt.

    Parameters
    ----------
    toolpath : Toolpath
        One chain of moves, as ``sequence`` returns it.
    machine : Machine
        The function uses the velocities and accelerations of its axes, its settling time, the
        piercing times of its tools and its controller language.

    Notes
    -----
    Let Δᵢ be the travel of axis i in a row, vᵢ and aᵢ the greatest velocity and acceleration of the
    axis, L the length of the row with L² = ΣΔᵢ², and t its time at the programmed feed.  The
    velocity v and the acceleration a along the row are limited to::

        v = min(L / t, vᵢ L / Δᵢ)      a = min aᵢ L / Δᵢ

    On an arc of radius R, Δx and Δy are both the length of the arc, which counts once in L, and
    v² ≤ a R limits the centripetal acceleration.  At a joint of two rows the velocity of axis i
    jumps by at most aᵢ · ``JOLT``.

    The times agree within 2 % with those of the simulated table.  LinuxCNC took 12 to 21 % longer
    for the sample programs, because its blending of moves is not modelled.
    """
    if len(toolpath) == 0:
        return np.zeros(0)
    toolpath = hold_heading(toolpath, machine)
    if machine.arcs == "chords":
        chords, row = _in_chords(toolpath)
        times = np.zeros(len(toolpath))
        np.add.at(times, row, _move_times(chords, machine))
        return times
    return _move_times(toolpath, machine)


def _in_chords(toolpath: Toolpath) -> tuple[Toolpath, I64]:
    """Return a toolpath with chords instead of arcs, and the row of each of its moves, (m,)."""
    start, end = toolpath.pose[:-1, :2], toolpath.pose[1:, :2]
    pieces = chord_counts(start, end, toolpath.bulge, DEVIATION)
    pose, row = split_moves(toolpath.pose, toolpath.bulge, pieces)
    straight = replace(toolpath, bulge=np.zeros(len(toolpath)))
    return straight.with_moves(row, pose), row


def _move_times(toolpath: Toolpath, machine: Machine) -> F64:
    """Return the time of each of the n moves of a toolpath, (n,) s; see ``durations``."""
    pose = np.ascontiguousarray(toolpath.pose)
    arcs = _measure_arcs(toolpath)
    parked = np.zeros(len(toolpath), np.bool_)
    parked[carriage_changes(toolpath, machine)] = True
    carriages = _measure_carriages(machine)
    limits = _row_limits(
        pose,
        arcs,
        parked,
        np.ascontiguousarray(toolpath.tool),
        carriages,
        toolpath.feed,
        np.ascontiguousarray(toolpath.motion),
    )
    changed = np.ones(len(toolpath), np.bool_)
    changed[1:] = toolpath.tool[1:] != toolpath.tool[:-1]
    stops = changed.copy()
    timing: Timing = find_language(machine.dialect).load_part("timing")
    halts = timing(toolpath, limits.travel, limits.seconds, machine)
    stops[1:] |= halts[:-1] > 0.0
    pierced = None
    if any(station.is_beam for station in machine.stations):
        switched, pierced = _beam_switching(toolpath, machine)
        stops |= switched
    jolt = carriages.hardest.min(axis=0) * JOLT
    times: F64 = _simulate(pose, arcs, limits, jolt, stops)
    halts[changed] += machine.settle
    times += halts
    if pierced is not None:
        times += pierced
    return times


class _Arcs(NamedTuple):
    """The k rows of a toolpath that are arcs."""

    row: I64_1  #: (k,) ascending
    length: F64_1  #: (k,) mm
    radius: F64_1  #: (k,) mm
    begin: F64_2  #: (k, 2) tangent at the start, as long as the arc
    finish: F64_2  #: (k, 2) tangent at the end, as long as the arc


def _measure_arcs(toolpath: Toolpath) -> _Arcs:
    """Return the arcs of a toolpath."""
    rows = np.flatnonzero(np.abs(toolpath.bulge) >= BULGE)
    start, end, bulge = toolpath.pose[rows, :2], toolpath.pose[rows + 1, :2], toolpath.bulge[rows]
    length = arc.length(start, end, bulge)
    # Tangents are as long as the chord; scaled to the length of the arc.
    chord = np.hypot(*(end - start).T)
    stretch = (length / np.where(chord > 0.0, chord, 1.0))[:, None]
    begin, finish = arc.tangents(start, end, bulge)
    return _Arcs(rows, length, arc.radius(start, end, bulge), begin * stretch, finish * stretch)


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


def _beam_switching(toolpath: Toolpath, machine: Machine) -> tuple[Bool, F64]:
    """Return the mask of the rows at whose start a laser beam is switched, and the piercing times.

    Both arrays have one entry per row of the toolpath, (n,).  The piercing time (s) is the time for
    which the laser rests at the start of a cut; it is 0 for a row that does not start with
    switching the beam on.
    """
    beams = np.zeros(256, np.bool_)
    pierce = np.zeros(256)
    for station in machine.stations:
        beams[station.number] = station.is_beam
        pierce[station.number] = station.tool.pierce_time
    beam_on = beams[toolpath.tool] & (toolpath.motion != Motion.RAPID)
    before = np.concatenate([[False], beam_on[:-1]])
    return beam_on != before, np.where(beam_on & ~before, pierce[toolpath.tool], 0.0)


class _Limits(NamedTuple):
    """Figures of n rows of a toolpath, (n,) each; ``durations`` has the formulas."""

    length: F64_1  #: over all four axes, mm and degrees added alike
    travel: F64_1  #: mm, along XYZ
    velocity: F64_1  #: greatest velocity along the row
    acceleration: F64_1  #: greatest acceleration along the row
    seconds: F64_1  #: s, time of the row at its greatest velocity


@kernel
def _row_limits(
    pose: F64_2,
    arcs: _Arcs,
    parked: Bool_1,
    tool: U8_1,
    carriages: _Carriages,
    feed: F64_1,
    motion: U8_1,
) -> Any:
    """Return the ``_Limits`` of n rows of a toolpath.

    Parameters
    ----------
    pose : (n + 1, 4)
        Poses before and after each row.
    arcs
        The rows that are arcs.
    parked : (n,)
        Mask of the rows before which the row's carriage was parked: only X moves.
    tool : (n,)
        Number of the station that makes each row.
    carriages
        The carriages of the machine.
    feed, motion : (n,)
        Programmed feed, and ``Motion``.
    """
    count = len(feed)
    length, travel = np.empty(count), np.empty(count)
    velocity, acceleration = np.empty(count), np.empty(count)
    seconds = np.empty(count)
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
        feed_time = 0.0
        if motion[row] != _RAPID and feed[row] > 0.0:
            way = reach[3] if motion[row] == _SWIVEL else travel[row]
            feed_time = 60.0 * way / feed[row]
        if feed_time > 0.0:
            fast = min(fast, safe / feed_time)
        if is_arc:
            thrust = min(carriages.hardest[own, 0], carriages.hardest[own, 1])
            fast = min(fast, math.sqrt(thrust * arcs.radius[next_arc]) * safe / flat)
            next_arc += 1
        velocity[row], acceleration[row] = fast, hard
        seconds[row] = max(feed_time, safe / fast)
    return _Limits(length, travel, velocity, acceleration, seconds)


@kernel(checks_division=True)
def _simulate(pose: F64_2, arcs: _Arcs, limits: _Limits, jolt: F64_1, stops: Bool_1) -> Any:
    """Return the time that the machine takes for each of n rows of a toolpath, (n,) s.

    The highest permitted speed at each joint between two rows is reduced from the last row back to
    the first, so that the machine can always slow down in time.  Then each row gets a trapezoidal
    speed profile.

    Parameters
    ----------
    pose : (n + 1, 4)
        Poses before and after each row.
    arcs, limits
        The rows that are arcs, and the figures of all rows; rows of length 0 take no time.
    jolt : (4,)
        Greatest permitted jump of the velocity of each axis at a joint.
    stops : (n,)
        Mask of the rows at whose start the machine is at rest.
    """
    length, velocity, acceleration = limits.length, limits.velocity, limits.acceleration
    count = len(length)
    times = np.zeros(count)
    entry = np.zeros(count)
    # Change of each axis per unit of length, at the start of a row and at the end of the last one.
    rate_of, rate_before = np.zeros(4), np.zeros(4)
    next_arc = 0
    before = -1
    rest = True
    for row in range(count):
        rest = rest or stops[row]
        is_arc = next_arc < len(arcs.row) and arcs.row[next_arc] == row
        next_arc += is_arc
        if length[row] <= STILL:
            continue
        for axis in range(4):
            rate_of[axis] = (pose[row + 1, axis] - pose[row, axis]) / length[row]
        if is_arc:
            for axis in range(2):
                rate_of[axis] = arcs.begin[next_arc - 1, axis] / length[row]
        if before >= 0 and not rest:
            joint = min(velocity[before], velocity[row])
            for axis in range(4):
                jump = abs(rate_of[axis] - rate_before[axis])
                if jump > 1e-9:
                    joint = min(joint, jolt[axis] / jump)
            entry[row] = joint
        rate_before[:] = rate_of
        if is_arc:
            for axis in range(2):
                rate_before[axis] = arcs.finish[next_arc - 1, axis] / length[row]
        before = row
        rest = False
    leaving = 0.0
    for row in range(count - 1, -1, -1):
        if length[row] > STILL:
            reach = math.sqrt(leaving * leaving + 2.0 * acceleration[row] * length[row])
            entry[row] = leaving = min(entry[row], reach)
    speed = 0.0
    row = 0
    while row < count:
        after = row + 1
        while after < count and length[after] <= STILL:
            after += 1
        if length[row] > STILL:
            rate, distance = acceleration[row], length[row]
            reach = math.sqrt(speed * speed + 2.0 * rate * distance)
            finish = min(entry[after] if after < count else 0.0, reach)
            peak = math.sqrt(rate * distance + (speed * speed + finish * finish) / 2.0)
            peak = max(min(peak, velocity[row]), speed, finish)
            rise, fall = (peak - speed) / rate, (peak - finish) / rate
            ramps = (peak + speed) / 2.0 * rise + (peak + finish) / 2.0 * fall
            times[row] = rise + fall + max(distance - ramps, 0.0) / peak
            speed = finish
        row = after
    return times
