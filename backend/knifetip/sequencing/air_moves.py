"""air_moves: moves of the head from the end of one track to the start of the next.

A track is a path that a tool follows without lifting.  In an air move the head travels straight
while C turns by the smaller angle.  The poses at both ends of the move are lifted along the tool's
axis, just far enough for the tool to clear the board.  If the whole move is beside the board,
beyond its outline, these poses are lifted only if the tip is in the mat on which the board lies.

Source: "A new method of turning processing in multi axis linkage NC machining", sections 1 to 3.
The limits of C, tilted blades and the test whether a turn stays outside the board are not from
this source; they were derived for knifetip.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.errors import CompensationError
from knifetip.geometry.columns import F64, Bool
from knifetip.geometry.path import Paths
from knifetip.kernels import F64_1, F64_2, Bool_1, kernel
from knifetip.model.machine import Machine
from knifetip.model.tool import TipCircle
from knifetip.model.toolpath import Motion, Toolpath

#: A tool that is tilted further cannot be lifted along its axis (degrees).
_FLATTEST: Final = 89.0


def tool_axis(c: F64, circle: TipCircle) -> F64:
    """Return the unit vector along the tool's axis, from its tip upwards, for each of n headings,
    (n, 3).

    ``c`` are the headings, (n,) degrees; ``circle`` contains the tilt of the tool.
    """
    tilt, heading = math.radians(circle.tilt), np.radians(c)
    sideways = math.sin(tilt)
    return np.column_stack(
        [
            sideways * np.sin(heading),
            -sideways * np.cos(heading),
            np.full(len(heading), math.cos(tilt)),
        ]
    )


def interpolate_turn(start: F64, end: F64, step_c: float, step: float) -> F64:
    """Return N + 1 poses along one turn of the head, (N + 1, 4), with equal steps of position and
    heading.

    N = max(⌈|ΔC| / δ_c⌉, ⌈|Δs| / δ_s⌉, 1), where ΔC is the turn of C and Δs the travel of the head
    (section 2 of the source in the module's docstring).  One rapid along X, Y, Z and C passes
    through all of these poses.

    Parameters
    ----------
    start, end : (4,) x y z in mm, c in degrees
        First and last pose.  C changes from the value in ``start`` to the value in ``end``.
    step_c, step : degrees, mm
        δ_c and δ_s, the largest permitted steps of heading and position.
    """
    turn = abs(end[3] - start[3])
    travel = math.dist(start[:3], end[:3])
    count = max(math.ceil(turn / step_c), math.ceil(travel / step), 1)
    poses: F64 = start + (end - start) * np.linspace(0.0, 1.0, count + 1)[:, None]
    return poses


def interference(pose: F64, circle: TipCircle, face: float, outline: Paths | None = None) -> F64:
    """Return the depth of the tool's lowest point below the board's top face at n poses, (n,) mm.

    The lowest point is that of the tip circle.  The depth is 0 if that point is above the top face,
    or if the entire circle is outside the board.

    Parameters
    ----------
    pose : (n, 4) x y z in mm, c in degrees
        Poses of the head.
    circle
        The circle that contains every point of the tool's tip, with the tool's tilt.
    face : mm
        Height of the board's top face.
    outline : closed Paths
        Outline of the board with its holes; None for an infinite board.
    """
    below: F64 = face - (pose[:, 2] - circle.radius * math.sin(math.radians(circle.tilt)))
    deep = np.maximum(below, 0.0)
    if outline is None:
        return deep
    heading = np.radians(pose[:, 3])
    centre = pose[:, :2] + circle.aside * np.column_stack([-np.sin(heading), np.cos(heading)])
    is_outside = (
        _distances_outside(centre, outline.start, outline.end, outline.bulge) > circle.radius
    )
    return np.where(is_outside, 0.0, deep)


def lift_clear(pose: F64, depth: F64, circle: TipCircle) -> F64:
    """Return the poses lifted along the tool's axis until they clear the board, (n, 4).

    ::

        d' = D / cos b        r' = r + d' a                        eqs 1, 2

    Here r is the position, a the unit vector from the tip into the tool, and b the tilt of the
    tool.  The equations are from the source in the module's docstring, where the sign in equation 2
    is missing.

    Parameters
    ----------
    pose : (n, 4) x y z in mm, c in degrees
        Poses of the head.
    depth : (n,) mm
        D, the depth of the tool in the board at each pose, from ``interference``.
    circle
        Contains the tilt of the tool.

    Raises
    ------
    CompensationError
        The tool is tilted by more than 89°, so that moving along its axis does not lift it.
    """
    if circle.tilt > _FLATTEST:
        raise CompensationError("tool.tilted", tilt=circle.tilt, limit=_FLATTEST)
    up = pose.copy()
    up[:, :3] += (
        tool_axis(pose[:, 3], circle) * (depth / math.cos(math.radians(circle.tilt)))[:, None]
    )
    return up


def turns_outside_board(start: F64, end: F64, circle: TipCircle, outline: Paths) -> Bool:
    """Return the mask of n turns on which the entire tip circle stays outside the board, (n,).

    Parameters
    ----------
    start, end : (n, 4) x y z in mm, c in degrees
        Poses at the start and the end of each turn.
    circle
        The circle that contains every point of the tool's tip.
    outline : closed Paths
        Outline of the board with its holes.

    Notes
    -----
    The test cannot miss a contact between two poses: the step to the next tested pose is never
    longer than the distance of the circle from the board.
    """
    result: Bool = _turns_outside(
        np.ascontiguousarray(start),
        np.ascontiguousarray(end),
        circle.radius,
        circle.aside,
        outline.start,
        outline.end,
        outline.bulge,
    )
    return result


def with_full_retracts(toolpath: Toolpath, machine: Machine) -> Toolpath:
    """Return the toolpath with each rapid that starts or ends below the travel height replaced by a
    lift, a rapid at the machine's travel height, and a descent.

    The lift is left out if the rapid starts at the travel height, and the descent if it ends there.
    The source in the module's docstring lifts the head in this way.  The result is only used to
    compare its duration with that of the given toolpath.
    """
    pose, rows = _expand_rapids(
        np.ascontiguousarray(toolpath.pose),
        toolpath.motion == Motion.RAPID,
        machine.travel_z,
    )
    return toolpath.with_moves(rows, pose)


@kernel
def _expand_rapids(pose: F64_2, rapid: Bool_1, height: float) -> Any:
    """Return the poses of n moves whose low rapids are lifted to a height (mm), and the move from
    which each of the m new moves comes, (m + 1, 4) and (m,).

    ``pose`` are the poses before and after each move, (n + 1, 4); ``rapid`` is the mask of the
    rapids, (n,).
    """
    count = len(rapid)
    for row in range(len(rapid)):
        if rapid[row]:
            count += (pose[row, 2] < height) + (pose[row + 1, 2] < height)
    expanded, rows = np.empty((count + 1, 4)), np.empty(count, np.int64)
    expanded[0] = pose[0]
    used = 0
    for row in range(len(rapid)):
        up = rapid[row] and pose[row, 2] < height
        down = rapid[row] and pose[row + 1, 2] < height
        if up:
            rows[used] = row
            used += 1
            for axis in range(4):
                expanded[used, axis] = pose[row, axis]
            expanded[used, 2] = height
        if down:
            rows[used] = row
            used += 1
            for axis in range(4):
                expanded[used, axis] = pose[row + 1, axis]
            expanded[used, 2] = height
        rows[used] = row
        used += 1
        for axis in range(4):
            expanded[used, axis] = pose[row + 1, axis]
        if up and not down:
            expanded[used, 2] = height
    return expanded, rows


@kernel(checks_division=True)
def unwind(
    start: F64_1,
    end: F64_1,
    smallest: F64_1,
    largest: F64_1,
    heading: float,
    low: float,
    high: float,
    period: float,
) -> Any:
    """Return the angle to add to all headings of each of t passes, (t,) degrees.

    Each angle is a multiple of ``period``, chosen so that C turns by the smaller angle from one
    pass to the next.  If C can turn by the same angle in both directions, the multiple is chosen
    that leaves C nearer to the middle of its limits.

    Parameters
    ----------
    start, end, smallest, largest : (t,) degrees
        First, last, smallest and largest heading of each pass.
    heading : degrees
        Heading before the first pass.
    low, high : degrees
        Limits of C.  A pass that cannot be within both limits stays below the upper limit.
    period : degrees
        Rotation after which the tool is the same: 360, or 180 if the tool is symmetric.
    """
    shift = np.empty(len(start))
    for number in range(len(start)):
        ideal = (heading - start[number]) / period
        turns = np.floor(ideal + 0.5)
        # Half a period, within the rounding of the compensation.
        if abs(ideal - np.floor(ideal) - 0.5) < 1e-9:
            below = np.floor(ideal)
            middle = (low + high) / 2.0 - (smallest[number] + largest[number]) / 2.0
            near = abs(below * period - middle) <= abs((below + 1.0) * period - middle)
            turns = below if near else below + 1.0
        turns = max(turns, np.ceil((low - smallest[number]) / period))
        turns = min(turns, np.floor((high - largest[number]) / period))
        shift[number] = turns * period
        heading = end[number] + shift[number]
    return shift


@kernel(checks_division=True)
def _distance_outside(x: float, y: float, start: F64_2, end: F64_2, bulge: F64_1) -> float:
    """Return the distance of the point (x, y) from closed chains of edges, in mm; it is negative
    inside.

    ``start``, ``end`` (mm) and ``bulge`` are the start points, end points and bulges of the lines
    and arcs of all chains.  Edges that meet have exactly equal end points, so that no ray passes
    between them.

    A point is inside if a ray from it crosses the chords an odd number of times.  For every arc,
    the area between the arc and its chord counts as one more crossing if the point is in it.  A
    point on a chord counts as a point to the right of it, or above a horizontal chord, in both.
    """
    nearest = np.inf
    inside = False
    for row in range(len(bulge)):
        ax, ay = start[row, 0], start[row, 1]
        bx, by = end[row, 0], end[row, 1]
        ux, uy = bx - ax, by - ay
        side = ux * (y - ay) - uy * (x - ax)
        on_left = side > 0.0 or (side == 0.0 and (uy < 0.0 or (uy == 0.0 and ux > 0.0)))
        if (ay > y) != (by > y) and on_left == (uy > 0.0):
            inside = not inside
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
        # An arc that turns left lies to the right of its chord, and vice versa.
        if away < radius and on_left == (b < 0.0):
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
def _distances_outside(point: F64_2, start: F64_2, end: F64_2, bulge: F64_1) -> Any:
    """Return the distances of n points from closed chains of edges, (n,) mm; they are negative
    inside.

    ``point`` are the n points (mm); ``start``, ``end`` (mm) and ``bulge`` are the start points, end
    points and bulges of the lines and arcs of all chains.
    """
    distance = np.empty(len(point))
    for row in range(len(point)):
        distance[row] = _distance_outside(point[row, 0], point[row, 1], start, end, bulge)
    return distance


@kernel(checks_division=True)
def _turns_outside(
    start: F64_2, end: F64_2, radius: float, aside: float, first: F64_2, last: F64_2, bulge: F64_1
) -> Any:
    """Return the mask of n turns that stay outside the board, (n,), by sphere tracing.

    ``start``, ``end`` (n, 4) x y z in mm, c in degrees: poses at the start and the end of each
    turn.
    ``radius``, ``aside`` mm: radius of the circle that contains every point of the tool's tip, and
    distance of its centre to the left of the head's axis.
    ``first``, ``last``, ``bulge`` (e, 2) mm, (e, 2) mm and (e,): start points, end points and
    bulges of the e edges of the board's outline.
    """
    clear = np.zeros(len(start), np.bool_)
    for row in range(len(start)):
        travel = end[row] - start[row]
        fastest = math.hypot(travel[0], travel[1]) + aside * abs(math.radians(travel[3]))
        travelled = 0.0
        while True:
            pose = start[row] + travel * travelled
            heading = math.radians(pose[3])
            x = pose[0] - aside * math.sin(heading)
            y = pose[1] + aside * math.cos(heading)
            gap = _distance_outside(x, y, first, last, bulge) - radius
            # Below 0.01 mm the steps would become too short.
            if not gap > 0.01:
                break
            if travelled >= 1.0 or gap >= fastest * (1.0 - travelled):
                clear[row] = True
                break
            travelled = min(1.0, travelled + gap / fastest)
    return clear
