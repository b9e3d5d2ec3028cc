"""segments: encode a toolpath as the table of segments that an MCX314 executes.

The chip counts pulses from the start of each segment.  Positions are rounded, not distances, so
that rounding errors do not add up.  An arc along which C turns is cut into chords, because the chip
interpolates at most three axes, and arcs only of two.

A segment joins the one before it if the chip need not stop between them.  It is then written while
that one is executed, which must therefore take as long as the writing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from knifetip.errors import ProgramError
from knifetip.gateway.mcx314 import figures
from knifetip.gateway.motion import Limits
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.model.toolpath import Motion, Toolpath

#: Motions in the board that may join; all others begin and end at rest.
_JOINING = frozenset({Motion.LEAD_IN, Motion.FEED, Motion.LEAD_OUT})
#: Length of the straight and diagonal steps along an octant of a circle, divided by its own: the
#: chip keeps the speed along the steps constant.
_STAIRS = 8.0 / math.pi * (math.sqrt(2.0) - 1.0)
#: Straight steps with less bulge are lines.
_STRAIGHT = 1e-9


@dataclass(frozen=True, slots=True)
class Wiring:
    """How the axes X, Y, Z and C of a machine are connected to a chip, and how fast it is fed."""

    pulses: tuple[float, float, float, float]  #: per mm, and per degree of C
    multiple: int  #: pulses/s for each unit of the drive speed
    refill: float  #: longest time that the writing of a segment takes (s)
    corner: float  #: largest change of direction without a stop (degrees)


@dataclass(frozen=True, slots=True)
class Segment:
    """One command of the chip with its data; distances are in pulses from the start."""

    command: int
    axes: tuple[int, ...]  #: 2 or 3 axes: 0 to 3 for X, Y, Z and C
    finish: tuple[int, ...]  #: end point along these axes
    centre: tuple[int, int] | None  #: of an arc
    speed: int  #: drive speed, to be multiplied
    joined: bool  #: begins without a stop after the segment before
    row: int  #: row of the toolpath


@dataclass(frozen=True, slots=True)
class _Step:
    """A line or an arc to a target, before it is a segment."""

    target: F64  #: (4,) mm and degrees
    bulge: float
    seconds: float
    joined: bool
    row: int


def encode(
    toolpath: Toolpath, wiring: Wiring, limits: Limits, *, tolerance: float
) -> list[Segment]:
    """Return the segments of a toolpath.

    Parameters
    ----------
    toolpath
        The toolpath, in axis positions.
    wiring
        Connection of the axes to the chip.
    limits
        Limits of the axes, from which the durations of rapids are computed.
    tolerance
        Greatest deviation of chords and merged segments from the path (mm).

    Raises
    ------
    ProgramError
        A move needs four axes at once, more pulses or another speed than the chip has, or is too
        short to be followed without a stop.
    """
    steps = _steps(toolpath, wiring, limits, tolerance)
    steps = _merge(toolpath.pose[0], steps, wiring, tolerance)
    scale = np.array(wiring.pulses)
    at = np.rint(toolpath.pose[0] * scale).astype(np.int64)
    before = toolpath.pose[0]
    segments: list[Segment] = []
    rests = True
    for step in steps:
        target = np.rint(step.target * scale).astype(np.int64)
        if step.bulge:
            segment = _arc_segment(before, step, at, target, wiring)
        else:
            segment = _line_segment(step, target - at, wiring)
        if segment is None:  # less than a pulse: the next segment makes it
            rests = rests or not step.joined
            continue
        segments.append(replace(segment, joined=segment.joined and not rests))
        at, before, rests = target, step.target, False
    return segments


def _steps(toolpath: Toolpath, wiring: Wiring, limits: Limits, tolerance: float) -> list[_Step]:
    """Return the lines and arcs of a toolpath, with arcs along which C or Z move as chords."""
    steps: list[_Step] = []
    turns = _turns(toolpath)
    most = figures.FASTEST * wiring.multiple / np.array(wiring.pulses)
    fastest = np.minimum(np.array(limits.velocity), most)
    for row in range(len(toolpath)):
        start, end = toolpath.pose[row], toolpath.pose[row + 1]
        bulge, motion = float(toolpath.bulge[row]), Motion(toolpath.motion[row])
        joined = (
            row > 0
            and motion in _JOINING
            and Motion(toolpath.motion[row - 1]) in _JOINING
            and toolpath.tool[row] == toolpath.tool[row - 1]
            and turns[row] <= wiring.corner
        )
        if motion == Motion.RAPID:
            steps.extend(_rapid_steps(start, end, fastest, row))
            continue
        seconds = _seconds(toolpath, row)
        turning = bool(np.abs(end[2:] - start[2:]).max() > _STRAIGHT)
        same_scale = wiring.pulses[0] == wiring.pulses[1]
        if abs(bulge) <= _STRAIGHT or (not turning and same_scale):
            bulge = bulge if abs(bulge) > _STRAIGHT else 0.0
            steps.append(_Step(end, bulge, seconds, joined, row))
            continue
        chord = math.dist(start[:2], end[:2])
        count = max(math.ceil(math.sqrt(abs(bulge) * chord / 2.0 / tolerance)), 1)
        fraction = np.arange(1, count + 1) / count
        points = start + (end - start) * fraction[:, None]
        ends = np.tile(np.stack([start[:2], end[:2]])[:, None], (1, count, 1))
        points[:, :2] = arc.point_at(ends[0], ends[1], np.full(count, bulge), fraction)
        for number, point in enumerate(points):
            steps.append(_Step(point, 0.0, seconds / count, joined or number > 0, row))
    return steps


def _turns(toolpath: Toolpath) -> F64:
    """Return the change of direction in XY at the start of each of n rows, (n,) degrees."""
    start, end = toolpath.pose[:-1, :2], toolpath.pose[1:, :2]
    leaving, arriving = arc.tangents(start, end, toolpath.bulge)
    turns = np.zeros(len(toolpath))
    cross = arriving[:-1, 0] * leaving[1:, 1] - arriving[:-1, 1] * leaving[1:, 0]
    turns[1:] = np.degrees(np.abs(np.arctan2(cross, (arriving[:-1] * leaving[1:]).sum(axis=1))))
    return turns


def _rapid_steps(start: F64, end: F64, fastest: F64, row: int) -> list[_Step]:
    """Return the lines of a rapid: Z by itself, first if it rises and last if it falls.

    ``fastest`` (4,) is the greatest velocity of each axis (mm/s, degrees/s).
    """
    across, upright = start.copy(), start.copy()
    across[[0, 1, 3]], upright[2] = end[[0, 1, 3]], end[2]
    targets = [upright, end] if end[2] > start[2] else [across, end]
    steps, before = [], start
    for target in targets:
        seconds = float((np.abs(target - before) / fastest).max())
        if seconds > 0.0:
            steps.append(_Step(target, 0.0, seconds, False, row))
        before = target
    return steps


def _seconds(toolpath: Toolpath, row: int) -> float:
    """Return the duration of a row at its feed (s)."""
    start, end = toolpath.pose[row], toolpath.pose[row + 1]
    if toolpath.motion[row] == Motion.SWIVEL:
        length = abs(float(end[3] - start[3]))
    else:
        flat = arc.length(start[None, :2], end[None, :2], toolpath.bulge[row : row + 1])
        length = math.hypot(float(flat[0]), float(end[2] - start[2]))
    return length / float(toolpath.feed[row]) * 60.0


def _merge(start: F64, steps: list[_Step], wiring: Wiring, tolerance: float) -> list[_Step]:
    """Return steps that last long enough to write the joined step after them.

    A line that is too short is merged with joined lines after it, if the line that replaces them
    deviates from their ends by at most the tolerance (mm, degrees).

    Raises
    ------
    ProgramError
        A step is too short and cannot be merged.
    """
    result: list[_Step] = []
    before, row = start, 0
    while row < len(steps):
        step, passed, after = steps[row], [], row + 1
        while step.seconds < wiring.refill and after < len(steps) and steps[after].joined:
            following = steps[after]
            passed.append(step.target)
            short = step.bulge or following.bulge
            if short or _deviation(before, following.target, passed) > tolerance:
                raise ProgramError(
                    "mcx314.too-short",
                    row=step.row,
                    milliseconds=step.seconds * 1e3,
                    refill=wiring.refill * 1e3,
                )
            step = replace(following, seconds=step.seconds + following.seconds, joined=step.joined)
            after += 1
        result.append(step)
        before, row = step.target, after
    return result


def _deviation(start: F64, end: F64, points: list[F64]) -> float:
    """Return the greatest distance of points from a line, in all four axes."""
    way = end - start
    square = float(way @ way)
    column = np.array(points) - start
    along = np.clip(column @ way / square, 0.0, 1.0) if square else np.zeros(len(points))
    return float(np.linalg.norm(column - along[:, None] * way, axis=1).max())


def _line_segment(step: _Step, way: F64, wiring: Wiring) -> Segment | None:
    """Return the segment of a line; None if it has no pulses."""
    moving = [axis for axis in range(figures.AXES) if way[axis]]
    if not moving:
        return None
    if len(moving) > 3:
        raise ProgramError("mcx314.four-axes", row=step.row)
    if len(moving) == 1:
        moving.append(next(axis for axis in range(figures.AXES) if axis not in moving))
    finish = tuple(int(way[axis]) for axis in moving)
    _check_range(finish, step.row)
    speed = _speed(max(map(abs, finish)) / step.seconds, step.row, wiring)
    command = figures.LINE_2 if len(moving) == 2 else figures.LINE_3
    return Segment(command, tuple(moving), finish, None, speed, step.joined, step.row)


def _arc_segment(before: F64, step: _Step, at: F64, target: F64, wiring: Wiring) -> Segment | None:
    """Return the segment of an arc in XY; its line if it has only a few pulses."""
    way = target - at
    start, end = before[None, :2], step.target[None, :2]
    bulge = np.array([step.bulge])
    middle = np.rint(arc.centre(start, end, bulge)[0] * wiring.pulses[0]).astype(np.int64)
    centre = middle - at[:2]
    radius, other = math.hypot(*centre), math.hypot(*(way[:2] - centre))
    if radius < 1.0 or abs(radius - other) > 1.0 or abs(way[:2]).max() <= 1:
        return _line_segment(step, way, wiring)
    _check_range((*way[:2], *centre), step.row)
    length = float(arc.length(start, end, bulge)[0]) * wiring.pulses[0] * _STAIRS
    speed = _speed(length / step.seconds, step.row, wiring)
    command = figures.COUNTER_CLOCKWISE if step.bulge > 0 else figures.CLOCKWISE
    finish, middle_of = (int(way[0]), int(way[1])), (int(centre[0]), int(centre[1]))
    return Segment(command, (0, 1), finish, middle_of, speed, step.joined, step.row)


def _check_range(values: tuple[int, ...], row: int) -> None:
    """Raise ``ProgramError`` if a distance has more pulses than the chip can count."""
    most = max(map(abs, values))
    if most > figures.LARGEST:
        raise ProgramError("mcx314.too-far", row=row, pulses=int(most), limit=figures.LARGEST)


def _speed(rate: float, row: int, wiring: Wiring) -> int:
    """Return the drive speed for a rate of pulses (1/s)."""
    speed = round(rate / wiring.multiple)
    if not 1 <= speed <= figures.FASTEST:
        raise ProgramError(
            "mcx314.speed",
            row=row,
            rate=rate,
            slowest=wiring.multiple,
            fastest=wiring.multiple * figures.FASTEST,
        )
    return speed
