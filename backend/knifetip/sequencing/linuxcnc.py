"""linuxcnc: the times of moves on LinuxCNC, by a model of its trajectory planner (ADR 0111).

LinuxCNC plans each move with a trapezoidal speed profile, and joins two moves in one of four ways:

- It comes to rest between a rapid and a feed move, and before a move in the opposite direction.
- At a joint of two moves without C, it keeps a speed at which the velocity of no axis jumps by more
  than a tenth of what the axis may gain in one servo period, or it inserts an arc within the
  tolerance of ``G64 P``, whichever is faster.
- If C turns in one of two moves, both are made with half the acceleration, and the second begins
  while the first slows down: as early as the tolerance permits.
- The last move before the program waits, for a dwell or an output, is also made with half the
  acceleration: it could still have been joined to another one.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, Bool
from knifetip.kernels import F64_1, F64_2, I64_1, Bool_1, OutF64_1, inline_kernel, kernel
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.moves import STILL, Arcs, Limits, Moves

#: Tolerance of the program, ``G64 P``; the program halts where the tip would deviate by more at the
#: start or the end of a turn of C (mm).
BLENDED: Final = 0.0005
#: Time that a halt takes after the machine has come to rest (s): measured.
HALT: Final = 0.003
#: Time that a blend arc takes beside the moves, which it hardly shortens (s): measured.
BLEND: Final = 0.003
#: Time from the start of a program to its first line (s): measured.
START: Final = 0.25
#: Time that a change of the station takes beside its dwell (s): measured.
CHANGE: Final = 0.1

#: Servo period (s).
_PERIOD: Final = 0.001
#: Periods that the shortest move takes.
_LEAST_PERIODS: Final = 1.02
#: Largest jump of an axis' velocity at a joint without a blend, as a part of what it gains in one
#: period: LinuxCNC's ARC_BLEND_KINK_RATIO.
_KINK: Final = 0.1
#: Part of the acceleration that is left for the centripetal one if half of it is tangential.
_CENTRIPETAL: Final = math.sqrt(0.75)
#: Cosine of the angle between two moves of opposite directions, for LinuxCNC.
_OPPOSITE: Final = math.cos(math.radians(178.0))
#: Cosine below which the angle between two moves does not limit the speed of a blend.
_ALONG: Final = math.cos(math.pi / 2.0 - 1e-3)
#: Part of the length of a move that a blend arc may replace.
_REPLACED: Final = 0.5

# How a move ends.
_LAST: Final = 0  # the program waits after it
_REST: Final = 1  # it comes to rest at its end
_OVERLAP: Final = 2  # the next move begins while it slows down
_JOINED: Final = 3  # it keeps some speed
_ROUNDED: Final = 4  # it keeps some speed in a blend arc


def linuxcnc(moves: Moves, rests: Bool, toolpath: Toolpath, machine: Machine) -> F64:
    """Return the time of each of n moves on LinuxCNC, (n,) s; see ``timing.Timing``."""
    halts = rests.copy()
    halts[1:] |= exact_stops(toolpath, moves.limits.travel, moves.limits.seconds, machine)[:-1]
    times = _plan(_tangents(moves), moves.arcs, moves.limits, moves.rapid, moves.hardest, halts)
    changed = np.flatnonzero(toolpath.tool[1:] != toolpath.tool[:-1]) + 1
    times[0] += START + CHANGE
    times[changed] += CHANGE
    result: F64 = times
    return result


def exact_stops(toolpath: Toolpath, travel: F64, seconds: F64, machine: Machine) -> Bool:
    """Return the mask of the n rows of a toolpath after which LinuxCNC must halt, (n,).

    A row is one move.  In it the head turns by κ radians per mm of travel.  At a joint of two rows
    where κ changes by Δκ, the trajectory planner of LinuxCNC overlaps the two rows for the time t
    that the axes need to change their speeds.  The tip then deviates by Δκ (v t)² / 2, where v is
    the faster of the two feeds (ADR 0008).  The program halts if this deviation is more than
    ``BLENDED`` and neither row is a rapid.  It also halts between a turn without travel and a row
    with travel, unless both are rapids.

    Parameters
    ----------
    travel, seconds : (n,) and (n,)
        Length of each row along XYZ (mm), and the time of each row at its feed (s).
    machine
        Machine whose accelerations of X, Y and C determine t; the least of all carriages are used.
    """
    turn = np.radians(np.diff(toolpath.pose[:, 3]))
    moves = travel > STILL
    in_place = ~moves & (np.abs(turn) > STILL)
    bend = np.divide(turn, travel, out=np.zeros_like(turn), where=moves)
    speed = np.divide(travel, seconds, out=np.zeros_like(travel), where=seconds > 0.0)
    change = np.abs(np.diff(bend))
    fastest = np.maximum(speed[1:], speed[:-1])
    hardest = np.array([[axis.acceleration for axis in one.axes] for one in machine.carriages])
    x, y, _, c = hardest.min(axis=0)
    twist, thrust = np.radians(c), min(x, y)
    time = np.maximum(fastest / thrust, fastest * change / twist)
    deviation = change * (fastest * time) ** 2 / 2.0
    rapid = toolpath.motion == Motion.RAPID
    air, both = rapid[1:] | rapid[:-1], rapid[1:] & rapid[:-1]
    result = np.zeros(len(turn), np.bool_)
    result[:-1] = np.where(in_place[1:] != in_place[:-1], ~both, ~air & (deviation > BLENDED))
    return result


class _Tangents(NamedTuple):
    """Directions of n moves along XYZ, as unit vectors; (1, 0, 0) for turns in place."""

    begin: F64_2  #: (n, 3) at the start
    finish: F64_2  #: (n, 3) at the end
    turns: Bool_1  #: (n,) whether C turns


def _tangents(moves: Moves) -> _Tangents:
    """Return the directions of moves."""
    step = np.diff(moves.pose, axis=0)
    begin = np.ascontiguousarray(step[:, :3])
    finish = begin.copy()
    begin[moves.arcs.row, :2] = moves.arcs.begin
    finish[moves.arcs.row, :2] = moves.arcs.finish
    for vectors in (begin, finish):
        length = np.linalg.norm(vectors, axis=1)
        vectors[length <= STILL] = (1.0, 0.0, 0.0)
        vectors /= np.where(length > STILL, length, 1.0)[:, None]
    return _Tangents(begin, finish, np.abs(step[:, 3]) > STILL)


class _Plan(NamedTuple):
    """Scratch arrays with one entry per move, (n,) each."""

    length: OutF64_1  #: mm along XYZ; degrees for a turn in place
    velocity: OutF64_1  #: greatest speed along the move, per s
    fastest: OutF64_1  #: greatest speed at any feed, per s
    acceleration: OutF64_1  #: greatest tangential acceleration, per s²
    full: OutF64_1  #: greatest acceleration with the part for the centripetal one, per s²
    joint: OutF64_1  #: greatest speed at the end of the move
    kink: OutF64_1  #: part of the acceleration that jumps at the joints need
    radius: OutF64_1  #: of an arc (mm); 0 for a straight move


@kernel(checks_division=True)
def _plan(
    tangents: _Tangents,
    arcs: Arcs,
    limits: Limits,
    rapid: Bool_1,
    hardest: F64_1,
    halts: Bool_1,
) -> Any:
    """Return the time that LinuxCNC takes for each of n moves, (n,) s.

    ``tangents``, ``arcs``, ``limits``: directions, arcs and figures of the moves; moves of length 0
    take no time.
    ``rapid`` (n,): mask of the rapids.
    ``hardest`` (4,): greatest acceleration of each axis.
    ``halts`` (n,): mask of the moves before which the program waits for the machine.
    """
    count = len(rapid)
    times = np.zeros(count)
    plan = _Plan(
        np.zeros(count),
        np.zeros(count),
        np.zeros(count),
        np.zeros(count),
        np.zeros(count),
        np.zeros(count),
        np.zeros(count),
        np.zeros(count),
    )
    end = np.zeros(count, np.int64)
    for k in range(len(arcs.row)):
        plan.radius[arcs.row[k]] = arcs.radius[k]
    before = -1
    halt = True
    for row in range(count):
        halt = halt or halts[row]
        if limits.length[row] <= STILL:
            continue
        length = limits.travel[row] if limits.travel[row] > STILL else limits.length[row]
        part = length / limits.length[row]
        clamp = length / (_PERIOD * _LEAST_PERIODS)
        plan.length[row] = length
        plan.velocity[row] = min(limits.velocity[row] * part, clamp)
        plan.fastest[row] = min(limits.fastest[row] * part, clamp)
        plan.full[row] = limits.acceleration[row] * part
        end[row] = _LAST
        if before >= 0 and not halt:
            end[before] = _join(before, row, tangents, rapid, hardest, plan)
        before = row
        halt = False
    overlapped = False
    for row in range(count):
        if plan.length[row] <= 0.0:
            continue
        halved = overlapped or end[row] == _LAST or end[row] == _OVERLAP
        overlapped = end[row] == _OVERLAP
        _limit(row, halved, plan)
    _set_times(end, plan, times)
    after = -1
    for row in range(count - 1, -1, -1):
        if plan.length[row] <= 0.0:
            continue
        if end[row] == _OVERLAP:
            times[row] -= min(_overlap(row, after, tangents, plan), 0.5 * times[row])
        elif end[row] == _LAST:
            times[row] += HALT
        elif end[row] == _ROUNDED:
            times[row] += BLEND
        after = row
    return times


@inline_kernel
def _join(
    before: int, row: int, tangents: _Tangents, rapid: Bool_1, hardest: F64_1, plan: _Plan
) -> int:
    """Return how the move ``before`` ends if ``row`` follows it; set the speed at the joint."""
    if rapid[before] != rapid[row]:
        return _REST
    if tangents.turns[before] or tangents.turns[row]:
        return _OVERLAP
    cosine = 0.0
    for axis in range(3):
        cosine += tangents.finish[before, axis] * tangents.begin[row, axis]
    if cosine < _OPPOSITE:
        return _REST
    fastest = min(plan.fastest[before], plan.fastest[row])
    # The velocity is assumed to change within one period.
    jerk = fastest / _PERIOD + plan.full[row]
    kink = 0.0
    for axis in range(3):
        jump = abs(tangents.begin[row, axis] - tangents.finish[before, axis])
        kink = max(kink, jump * jerk / hardest[axis])
    if plan.radius[before] > 0.0 or plan.radius[row] > 0.0:
        kink *= 2.0
    if kink < _KINK:
        plan.joint[before] = fastest
        plan.kink[before] = max(plan.kink[before], kink)
        plan.kink[row] = max(plan.kink[row], kink)
        return _JOINED
    # Half the angle between the two moves.
    half = math.acos(min(max(-cosine, -1.0), 1.0)) / 2.0
    reach = _REPLACED * min(plan.length[before], plan.length[row])
    reach = min(reach, math.cos(half) * BLENDED / (1.0 - math.sin(half)))
    thrust = _CENTRIPETAL * min(plan.full[before], plan.full[row])
    rounded = min(math.sqrt(thrust * math.tan(half) * reach), fastest)
    straight = fastest * _KINK / kink
    if straight <= rounded:
        plan.joint[before] = rounded
        return _ROUNDED
    plan.joint[before] = straight
    plan.kink[before] = max(plan.kink[before], _KINK)
    plan.kink[row] = max(plan.kink[row], _KINK)
    return _JOINED


@inline_kernel
def _limit(row: int, halved: bool, plan: _Plan) -> None:
    """Set the acceleration of a move, and limit its speed by the centripetal acceleration."""
    full = plan.full[row] * (1.0 - plan.kink[row]) * (0.5 if halved else 1.0)
    plan.full[row] = plan.acceleration[row] = full
    if plan.radius[row] > 0.0:
        inward = plan.fastest[row] ** 2 / plan.radius[row]
        part = 0.5
        if inward > _CENTRIPETAL * full:
            fastest = math.sqrt(_CENTRIPETAL * full * plan.radius[row])
            plan.velocity[row] = min(plan.velocity[row], fastest)
        else:
            part = math.sqrt(1.0 - (inward / full) ** 2)
        plan.acceleration[row] = part * full


@inline_kernel
def _set_times(end: I64_1, plan: _Plan, times: OutF64_1) -> None:
    """Set the time of each move from the speeds at its ends, as if no moves overlapped."""
    count = len(end)
    leaving = 0.0  # greatest speed at the start of the next move
    for row in range(count - 1, -1, -1):
        if plan.length[row] <= 0.0:
            continue
        if end[row] < _JOINED:
            plan.joint[row] = 0.0
        plan.joint[row] = finish = min(plan.joint[row], plan.velocity[row], leaving)
        reach = math.sqrt(finish**2 + 2.0 * plan.acceleration[row] * plan.length[row])
        leaving = min(reach, plan.velocity[row])
    speed = 0.0
    for row in range(count):
        length, rate = plan.length[row], plan.acceleration[row]
        if length <= 0.0:
            continue
        finish = min(plan.joint[row], math.sqrt(speed**2 + 2.0 * rate * length))
        peak = math.sqrt(rate * length + (speed**2 + finish**2) / 2.0)
        peak = max(min(peak, plan.velocity[row]), speed, finish)
        rise, fall = (peak - speed) / rate, (peak - finish) / rate
        ramps = (peak + speed) / 2.0 * rise + (peak + finish) / 2.0 * fall
        times[row] = rise + fall + max(length - ramps, 0.0) / peak
        speed = finish


@inline_kernel
def _overlap(row: int, after: int, tangents: _Tangents, plan: _Plan) -> float:
    """Return for how long a move and the next one run at the same time (s)."""
    reached = min(math.sqrt(plan.acceleration[row] * plan.length[row]), plan.velocity[row])
    following = min(math.sqrt(plan.acceleration[after] * plan.length[after]), plan.velocity[after])
    longest = max(reached / plan.acceleration[row], following / plan.acceleration[after])
    blend = min(plan.length[row] / reached, plan.length[after] / following, longest)
    speed = min(reached, blend * plan.acceleration[row])
    # The next move accelerates along its path, and on an arc also towards the centre.
    inward = 0.0
    if plan.radius[after] > 0.0:
        inward = (0.5 * plan.velocity[after]) ** 2 / plan.radius[after]
    cosine = 0.0
    for axis in range(3):
        cosine += tangents.finish[row, axis] * tangents.begin[after, axis]
    cosine *= plan.full[after] / math.hypot(plan.full[after], inward)
    beside = math.cos(math.acos(min(max(-cosine, -1.0), 1.0)) / 2.0)
    if beside > _ALONG:
        speed = min(speed, 2.0 * math.sqrt(plan.acceleration[row] * BLENDED / beside))
    return float(speed / plan.acceleration[row])
