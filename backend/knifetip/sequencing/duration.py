"""duration: how long the machine will take.

    Toolpath, Machine -> seconds of every row

Every move is a trapezoid of speed within what its axes can do; look-ahead carries speed through
tangent joints and stops at corners.  Dwells count where the post-processor writes them: while a
piston or the oscillation settles, and where the controller must halt (see ``timing``).

Speed along a move is measured over all four axes, mm and degrees alike, as grblHAL does, but every
limit is an axis's own, so that the time of a move does not depend on it.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, Bool
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_1, F64_2, Bool_1, kernel
from knifetip.languages.registry import find_language
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.timing import STILL, Timing

#: At a joint the velocity of an axis may jump by what it gains in this time (s).
JOLT: Final = 0.002


def duration(toolpath: Toolpath, machine: Machine) -> float:
    """Return how long the machine will take for all of a toolpath (s)."""
    return float(durations(toolpath, machine).sum())


def durations(toolpath: Toolpath, machine: Machine) -> F64:
    """Return how long each row of a toolpath takes, (n,) s.

    A station's change counts to its first row, a halt to the row that it ends.

    Parameters
    ----------
    toolpath : Toolpath
        One chain of moves, as ``sequence`` makes it.
    machine : Machine
        Velocities and accelerations of its axes, the time to settle, and what it speaks.

    Notes
    -----
    Per row, with Δᵢ the travel of axis i and L² = ΣΔᵢ²::

        v = min(L / t, vᵢ L / Δᵢ)      a = min aᵢ L / Δᵢ      t the time that the feed asks for

    On an arc Δx = Δy = its length, and v² ≤ a R keeps the centripetal acceleration.  At a joint no
    axis jumps by more than aᵢ · ``JOLT``.  The simulated table agrees within 2 %; LinuxCNC took
    12 to 21 % longer on the samples, since only its halts are modelled, not how it blends.
    """
    if len(toolpath) == 0:
        return np.zeros(0)
    change = np.abs(np.diff(toolpath.pose, axis=0))
    start, end = toolpath.pose[:-1, :2], toolpath.pose[1:, :2]
    round_ = np.abs(toolpath.bulge) >= BULGE
    along = arc.length(start, end, toolpath.bulge)
    reach = change.copy()
    reach[round_, :2] = along[round_, None]
    flat = np.where(round_, along, np.hypot(change[:, 0], change[:, 1]))
    # On an arc X and Y share its length: together they count once.
    length = np.sqrt(flat**2 + change[:, 2] ** 2 + change[:, 3] ** 2)
    moving = length > STILL
    safe = np.where(moving, length, 1.0)

    axes = (machine.x, machine.y, machine.z, machine.c)
    fastest = np.array([axis.velocity for axis in axes])
    hardest = np.array([axis.acceleration for axis in axes])
    share = reach / safe[:, None]
    with np.errstate(divide="ignore"):
        velocity = np.min(fastest / share, axis=1)
        acceleration = np.min(hardest / share, axis=1)
    asked = _asked(toolpath, np.hypot(flat, change[:, 2]), change[:, 3])
    velocity = np.minimum(velocity, np.divide(safe, asked, out=velocity.copy(), where=asked > 0.0))
    size = np.where(round_, arc.radius(start, end, toolpath.bulge), 1.0)
    thrust = min(hardest[0], hardest[1])
    bent = np.sqrt(thrust * size) * safe / np.where(round_, flat, 1.0)
    velocity = np.where(round_, np.minimum(velocity, bent), velocity)

    first, last = _headings(toolpath, safe)
    stops = np.zeros(len(moving), np.bool_)
    changed = np.ones(len(moving), np.bool_)
    changed[1:] = toolpath.tool[1:] != toolpath.tool[:-1]
    stops |= changed
    timing: Timing = find_language(machine.dialect).part("timing")
    seconds = np.maximum(asked, safe / velocity)
    waits = timing(toolpath, np.hypot(flat, change[:, 2]), seconds, machine)
    stops[1:] |= waits[:-1] > 0.0
    switched, pierced = _beams(toolpath, machine)
    stops |= switched
    times: F64 = _travelled(length, velocity, acceleration, first, last, hardest * JOLT, stops)
    times += changed * machine.settle + waits + pierced
    return times


def _beams(toolpath: Toolpath, machine: Machine) -> tuple[Bool, F64]:
    """Return the rows at whose start a beam is switched, and how long it pierces there (s)."""
    beams = np.zeros(256, np.bool_)
    pierce = np.zeros(256)
    for station in machine.stations:
        beams[station.number] = station.beams
        pierce[station.number] = station.tool.pierce_time
    on = beams[toolpath.tool] & (toolpath.motion != Motion.RAPID)
    before = np.concatenate([[False], on[:-1]])
    return on != before, np.where(on & ~before, pierce[toolpath.tool], 0.0)


def _asked(toolpath: Toolpath, travel: F64, degrees: F64) -> F64:
    """Return the time that each row's feed asks for (s); 0 for rapids."""
    swivel = toolpath.motion == Motion.SWIVEL
    feed = np.where(toolpath.feed > 0.0, toolpath.feed, np.inf)
    asked: F64 = 60.0 * np.where(swivel, degrees, travel) / feed
    return np.where(toolpath.motion == Motion.RAPID, 0.0, asked)


def _headings(toolpath: Toolpath, length: F64) -> tuple[F64, F64]:
    """Return how fast each axis changes per unit of length at both ends of each row, (n, 4)."""
    change = np.diff(toolpath.pose, axis=0)
    first, last = change.copy(), change.copy()
    round_ = np.abs(toolpath.bulge) >= BULGE
    start, end = toolpath.pose[:-1, :2][round_], toolpath.pose[1:, :2][round_]
    bulge = toolpath.bulge[round_]
    # Tangents come as long as the chord, and a heading on an arc is as long as the arc.
    chord = np.hypot(*(end - start).T)
    stretch = (arc.length(start, end, bulge) / np.where(chord > 0.0, chord, 1.0))[:, None]
    begin, finish = arc.tangents(start, end, bulge)
    first[round_, :2], last[round_, :2] = begin * stretch, finish * stretch
    return first / length[:, None], last / length[:, None]


@kernel(checks_division=True)
def _travelled(
    length: F64_1,
    velocity: F64_1,
    acceleration: F64_1,
    first: F64_2,
    last: F64_2,
    jolt: F64_1,
    stops: Bool_1,
) -> Any:
    """Return the seconds of each row, (n,): joints, look-ahead backwards, trapezoids forwards.

    ``stops`` are the rows that begin at rest; a row that moves nothing is passed over.
    """
    count = len(length)
    times = np.zeros(count)
    entry = np.zeros(count)
    before = -1
    rest = True
    for row in range(count):
        rest = rest or stops[row]
        if length[row] <= 1e-9:
            continue
        if before >= 0 and not rest:
            joint = min(velocity[before], velocity[row])
            for axis in range(4):
                jump = abs(first[row, axis] - last[before, axis])
                if jump > 1e-9:
                    joint = min(joint, jolt[axis] / jump)
            entry[row] = joint
        before = row
        rest = False
    leaving = 0.0
    for row in range(count - 1, -1, -1):
        if length[row] > 1e-9:
            reach = math.sqrt(leaving * leaving + 2.0 * acceleration[row] * length[row])
            entry[row] = leaving = min(entry[row], reach)
    speed = 0.0
    row = 0
    while row < count:
        after = row + 1
        while after < count and length[after] <= 1e-9:
            after += 1
        if length[row] > 1e-9:
            hard, way = acceleration[row], length[row]
            reach = math.sqrt(speed * speed + 2.0 * hard * way)
            finish = min(entry[after] if after < count else 0.0, reach)
            peak = math.sqrt(hard * way + (speed * speed + finish * finish) / 2.0)
            peak = max(min(peak, velocity[row]), speed, finish)
            rise, fall = (peak - speed) / hard, (peak - finish) / hard
            ramps = (peak + speed) / 2.0 * rise + (peak + finish) / 2.0 * fall
            times[row] = rise + fall + max(way - ramps, 0.0) / peak
            speed = finish
        row = after
    return times
