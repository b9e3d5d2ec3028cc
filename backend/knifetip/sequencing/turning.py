"""turning: from the end of one track to the start of the next.

    poses of the head, its tool, the board's face and outline -> the lift that a turn needs

The head goes straight, C turns by the shorter way meanwhile, and the tool is lifted along its own
axis by just what would else cut the board: not at all where the turn runs outside the board.

Source: "A new method of turning processing in multi axis linkage NC machining", sections 1 to 3.
What concerns C's travel, leaning blades and the proof of an empty way is our derivation.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, Final

import numpy as np

from knifetip.errors import CompensationError
from knifetip.geometry.columns import F64, Bool
from knifetip.geometry.path import Paths
from knifetip.kernels import F64_1, F64_2, kernel
from knifetip.model.machine import Machine
from knifetip.model.tool import TipCircle
from knifetip.model.toolpath import Motion, Toolpath

#: A tool that leans further is not lifted by moving along its axis (degrees).
_FLATTEST: Final = 89.0


def axis(c: F64, circle: TipCircle) -> F64:
    """Return a, the unit vectors from the tip into the tool, (n, 3), at headings c (degrees)."""
    tilt, heading = math.radians(circle.tilt), np.radians(c)
    sideways = math.sin(tilt)
    return np.column_stack(
        [
            sideways * np.sin(heading),
            -sideways * np.cos(heading),
            np.full(len(heading), math.cos(tilt)),
        ]
    )


def interpolated(start: F64, end: F64, step_c: float, step: float) -> F64:
    """Return the poses of a turn, (N + 1, 4): place and heading in the same number of steps.

    N = max(⌈|ΔC| / δ_c⌉, ⌈|Δc| / δ_s⌉), section 2.  One G0 with X Y Z C passes through all of them.

    Parameters
    ----------
    start, end : (4,) x y z in mm, c in degrees; C already by the shorter way
    step_c, step : degrees, mm
        δ_c and δ_s, the most between two poses.
    """
    turn = abs(end[3] - start[3])
    way = math.dist(start[:3], end[:3])
    count = max(math.ceil(turn / step_c), math.ceil(way / step), 1)
    poses: F64 = start + (end - start) * np.linspace(0.0, 1.0, count + 1)[:, None]
    return poses


def interference(pose: F64, circle: TipCircle, face: float, outline: Paths | None = None) -> F64:
    """Return D, how deep the lowest point of the tip circle stands below the face, (n,) mm.

    0 where it is above, or where the circle is wholly outside the board; a circle that is partly
    outside counts as inside.

    Parameters
    ----------
    pose : (n, 4) x y z in mm, c in degrees
    face : mm
        Height of the board's top face.
    outline : closed Paths
        Of the board, holes included; None for a board without end.
    """
    below: F64 = face - (pose[:, 2] - circle.radius * math.sin(math.radians(circle.tilt)))
    deep = np.maximum(below, 0.0)
    if outline is None:
        return deep
    heading = np.radians(pose[:, 3])
    centre = pose[:, :2] + circle.aside * np.column_stack([-np.sin(heading), np.cos(heading)])
    off = _outside(centre, outline.start, outline.end, outline.bulge) > circle.radius
    return np.where(off, 0.0, deep)


def lifted(pose: F64, depth: F64, circle: TipCircle) -> F64:
    """Return the poses lifted along the tool's axis until the interference is gone, (n, 4).

    ::

        d' = D / cos b        r' = r + d' a                        eqs 1, 2

    Equation 2 is printed without its sign; a points from the tip into the tool.

    Parameters
    ----------
    pose : (n, 4)
    depth : (n,) mm
        D, from ``interference``.

    Raises
    ------
    CompensationError
        A tool that lies nearly flat is not lifted by moving along its axis.
    """
    if circle.tilt > _FLATTEST:
        raise CompensationError("tool.tilted", tilt=circle.tilt, limit=_FLATTEST)
    up = pose.copy()
    up[:, :3] += axis(pose[:, 3], circle) * (depth / math.cos(math.radians(circle.tilt)))[:, None]
    return up


def clear_ways(start: F64, end: F64, circle: TipCircle, outline: Paths) -> Bool:
    """Return which turns keep the whole tip circle outside the board all the way, (n,).

    Parameters
    ----------
    start, end : (n, 4) poses
    outline : closed Paths

    Notes
    -----
    A proof, not a sample: from a place where the circle is off the board by g, the head may go on
    until its centre could have come nearer by g.
    """
    result: Bool = _clear_ways(
        np.ascontiguousarray(start),
        np.ascontiguousarray(end),
        circle.radius,
        circle.aside,
        outline.start,
        outline.end,
        outline.bulge,
    )
    return result


def retracted(toolpath: Toolpath, machine: Machine) -> Toolpath:
    """Return the toolpath with a full retract at every turn, as the paper's rivals do it.

    Every rapid below the machine's travel height goes up to it first, and comes down after.
    """
    rapid = toolpath.motion == Motion.RAPID
    height = machine.travel_z
    up = rapid & (toolpath.pose[:-1, 2] < height)
    down = rapid & (toolpath.pose[1:, 2] < height)
    size = 1 + up.astype(np.int64) + down
    rows = np.repeat(np.arange(len(toolpath)), size)
    place = np.arange(len(rows)) - np.repeat(np.cumsum(size) - size, size)
    pose = toolpath.pose[rows + 1].copy()
    first = up[rows] & (place == 0)
    pose[first, :] = toolpath.pose[rows[first]]
    pose[(up[rows] | down[rows]) & (place < size[rows] - down[rows]), 2] = height
    return replace(
        toolpath,
        pose=np.concatenate([toolpath.pose[:1], pose]),
        bulge=toolpath.bulge[rows],
        motion=toolpath.motion[rows],
        feed=toolpath.feed[rows],
        source=toolpath.source[rows],
        tool=toolpath.tool[rows],
        track=toolpath.track[rows],
    )


@kernel(checks_division=True)
def unwound(
    start: F64_1,
    end: F64_1,
    least: F64_1,
    most: F64_1,
    here: float,
    low: float,
    high: float,
    period: float,
) -> Any:
    """Return what to add to the headings of each run of moves, in order, so that C turns little.

    C goes by the smaller angle; where both ways are half a period the one that leaves it nearer to
    the middle of its travel is taken.

    Parameters
    ----------
    start, end, least, most : (t,) degrees
        Headings where each run begins and ends, and its extremes.
    here : degrees
        Heading before the first run.
    low, high : degrees
        Travel of C; a run that cannot stay within it is left where it is nearest.
    period : degrees
        After which the tool is the same again: 360, or 180 for one that is symmetric.
    """
    shift = np.empty(len(start))
    for run in range(len(start)):
        wanted = (here - start[run]) / period
        turns = np.floor(wanted + 0.5)
        # Half a period, to the rounding of what engines compute.
        if abs(wanted - np.floor(wanted) - 0.5) < 1e-9:
            below = np.floor(wanted)
            middle = (low + high) / 2.0 - (least[run] + most[run]) / 2.0
            near = abs(below * period - middle) <= abs((below + 1.0) * period - middle)
            turns = below if near else below + 1.0
        turns = max(turns, np.ceil((low - least[run]) / period))
        turns = min(turns, np.floor((high - most[run]) / period))
        shift[run] = turns * period
        here = end[run] + shift[run]
    return shift


@kernel(checks_division=True)
def _off(x: float, y: float, start: F64_2, end: F64_2, bulge: F64_1) -> float:
    """Return how far a point is outside closed chains of lines and arcs (mm), negative inside.

    Inside is what an odd number of crossings parts from far away: of the chords, and then once
    more for every arc between whose chord and bow the point lies.
    """
    nearest = np.inf
    inside = False
    for row in range(len(bulge)):
        ax, ay = start[row, 0], start[row, 1]
        bx, by = end[row, 0], end[row, 1]
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            inside = not inside
        ux, uy = bx - ax, by - ay
        square = ux * ux + uy * uy
        if square == 0.0:
            continue
        b = bulge[row]
        if abs(b) < 1e-9:
            along = min(max(((x - ax) * ux + (y - ay) * uy) / square, 0.0), 1.0)
            nearest = min(nearest, math.hypot(ax + along * ux - x, ay + along * uy - y))
            continue
        rise = (1.0 - b * b) / (4.0 * b)
        cx, cy = (ax + bx) / 2.0 - uy * rise, (ay + by) / 2.0 + ux * rise
        radius = math.hypot(ax - cx, ay - cy)
        away = math.hypot(x - cx, y - cy)
        # The bow lies to the right of its chord for an arc to the left, and the other way round.
        beside = ux * (y - ay) - uy * (x - ax)
        if away < radius and (beside < 0.0) == (b > 0.0) and beside != 0.0:
            inside = not inside
        sweep = 4.0 * math.atan(b)
        turned = math.atan2(y - cy, x - cx) - math.atan2(ay - cy, ax - cx)
        turned = (turned if b > 0.0 else -turned) % (2.0 * math.pi)
        if turned <= abs(sweep):
            nearest = min(nearest, abs(away - radius))
        else:
            nearest = min(nearest, math.hypot(ax - x, ay - y), math.hypot(bx - x, by - y))
    return -nearest if inside else nearest


@kernel
def _outside(point: F64_2, start: F64_2, end: F64_2, bulge: F64_1) -> Any:
    """Return how far points are outside, (n,) mm, negative inside."""
    off = np.empty(len(point))
    for row in range(len(point)):
        off[row] = _off(point[row, 0], point[row, 1], start, end, bulge)
    return off


@kernel(checks_division=True)
def _clear_ways(
    start: F64_2, end: F64_2, radius: float, aside: float, first: F64_2, last: F64_2, bulge: F64_1
) -> Any:
    """Return which ways stay off the board: each goes on by what it is off."""
    clear = np.zeros(len(start), np.bool_)
    for row in range(len(start)):
        way = end[row] - start[row]
        fastest = math.hypot(way[0], way[1]) + aside * abs(math.radians(way[3]))
        done = 0.0
        while True:
            pose = start[row] + way * done
            heading = math.radians(pose[3])
            x = pose[0] - aside * math.sin(heading)
            y = pose[1] + aside * math.cos(heading)
            gap = _off(x, y, first, last, bulge) - radius
            # Nearer than a hundredth of a millimetre is no proof that ends in time.
            if not gap > 0.01:
                break
            if done >= 1.0 or gap >= fastest * (1.0 - done):
                clear[row] = True
                break
            done = min(1.0, done + gap / fastest)
    return clear
