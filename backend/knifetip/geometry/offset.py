"""offset: the equidistant, where the centre of a tool of radius r runs beside a contour.

    Paths, radius and side -> Paths of the centre, and what the tool cannot reach

First beside each path alone: every segment is moved by r, convex corners get their transition, at
concave ones the neighbours are shortened to where they meet.  Most contours are done with that.
Where a segment is too short, an arc too tight or a path meets itself or its neighbours, everything
is cut where it crosses, what comes nearer than r to a contour is thrown away, and the rest joined
again: nothing, one path or several.  Lines stay lines and arcs arcs.

Source: "Tool radius compensation", equations 3 to 5, P_e = P + σ r n with σ = +1 left of travel;
corners from ``transition``.  The global part is our own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numba import njit
from numpy.typing import ArrayLike

from knifetip.errors import CompensationError, GeometryError, ZeroLengthEdge
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.intersect import TOUCH, box, circle, crossing, point_on
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import BULGE, POINT
from knifetip.geometry.transition import Corner, check, reach, transition

#: A piece may come nearer to the contour than the radius by this (mm): rounding, no more.
NEARER: Final = 1e-9
#: Pieces shorter than this are crossings that rounding has pulled apart (mm).
SPECK: Final = 1e-7
#: Children of a node in the tree of boxes.
FAN: Final = 8
#: Up to this many segments every pair is looked at; beyond it a tree finds those that are near.
FEW: Final = 64

# What the kernel says of a path.
_FINE: Final = 0
_NOT_A_NUMBER: Final = 1
_NO_LENGTH: Final = 2
_NO_ROOM: Final = 3
_TORN: Final = 4

# Joints at the start of a segment.
_OPEN: Final = 0
_SMOOTH: Final = 1
_CONVEX: Final = 2
_CONCAVE: Final = 3

# Columns of the scratch table, one row a segment: tangents at both ends, chord, radius (0 a line),
# ends of the moved segment, and the shares of it between which it is kept.
_U1X, _U1Y, _U2X, _U2Y, _CHORD, _RADIUS, _SX, _SY, _EX, _EY, _LOW, _HIGH = range(12)


@dataclass(frozen=True, eq=False, slots=True)
class Equidistant:
    """Where the centre of the tool runs: n segments in q paths, made from p input paths."""

    paths: Paths  #: q result paths, in the direction of their input path
    source: I32  #: (n,) input segment of each; a transition has the segment after its corner
    inserted: Bool  #: (n,) whether it belongs to the transition at a corner
    owner: I32  #: (q,) input path of each result path, that of its first segment
    unreached: F64  #: (p,) mm² beside each input path that the tool cannot reach


def equidistant(
    paths: Paths,
    distance: ArrayLike,
    side: ArrayLike,
    *,
    corner: ArrayLike = Corner.B,
    k: ArrayLike = 0.5,
    interference: str = "trim",
    group: ArrayLike | None = None,
) -> Equidistant:
    """Return the path of a tool's centre beside each path.

    With n the left normal, σ the side and κ the signed curvature::

        P_e = P + σ r n                     lines are shifted, arcs get the radius R (1 - σ r κ)

    Parameters
    ----------
    paths : Paths
        p contours, closed or open, that do not cross themselves.
    distance : (p,) mm, or one for all
        The radius r; 0 gives the paths back.
    side : (p,) or one for all
        σ: +1 left of travel, -1 right.
    corner, k : (n,) or one for all
        ``Corner`` and knob of the transition at the *start* of each segment, where that is convex.
    interference : "trim" or "refuse"
        Whether what does not fit is left out, or is an error.
    group : (p,), optional
        Paths with the same number bound one region (an outline and its holes): the tool keeps
        clear of all of them.  They need one distance and one side.  Without it each is alone.

    Returns
    -------
    Equidistant
        A closed path gives closed paths: none where the tool does not fit at all, several where it
        cannot pass a neck.  No point of a result is nearer to its contours than r, except within
        ``NEARER``.  A result path does not run through the transition of another corner either.

    Raises
    ------
    ZeroLengthEdge
        A segment shorter than ``tolerance.POINT``.
    GeometryError
        Coordinates, radius, side or groups that make no sense.
    CompensationError
        ``interference`` is "refuse", and the tool would cut into a contour; ``source`` are the rows
        of the two segments, the message has the depth.

    Notes
    -----
    ``unreached`` is the area between the contour and what the disc sweeps: the offset curve moved
    back by r, with an arc of radius r about every corner that it turns towards the contour.
    The area of a group stands with its first path.  Of an open path that loses an end it is an
    estimate.

    Cost: n log n in the number of segments; the tree over the boxes of the segments lives on their
    order along the path.
    """
    count, rows = len(paths), len(paths.bulge)
    radius = _column(distance, count, np.float64)
    sides = _column(side, count, np.float64)
    if not (np.isfinite(radius) & (radius >= 0.0)).all():
        raise GeometryError(
            "The distance of an equidistant is not a number of 0 mm or more.", "Correct the tool."
        )
    if not (np.abs(sides) == 1.0).all():
        raise GeometryError("The side of a path is neither left nor right.", "Give +1 or -1.")
    if interference not in ("trim", "refuse"):
        raise GeometryError(
            f"Interference cannot be answered by {interference!r}.", "Give 'trim' or 'refuse'."
        )
    kinds = _column(corner, rows, np.uint8)
    share = _column(k, rows, np.float64)
    check(kinds, share)
    signed = radius * sides
    member, members = _grouped(group, signed)
    start, end, bulge, source, inserted, first, owner, unreached, failure = _all(
        paths.start,
        paths.end,
        paths.bulge,
        paths.first,
        member,
        members,
        signed,
        kinds,
        share,
        interference == "refuse",
    )
    if failure[0] != _FINE:
        raise _refusal(failure, radius, paths)
    for column in (start, end, bulge, first):
        column.flags.writeable = False
    return Equidistant(Paths(start, end, bulge, first), source, inserted, owner, unreached)


def _column(values: ArrayLike, count: int, dtype: Any) -> Any:
    given = np.asarray(values, dtype)
    return np.ascontiguousarray(np.broadcast_to(given, count))


def _grouped(group: ArrayLike | None, signed: F64) -> tuple[I32, I32]:
    """Return the paths in the order of their groups, and where each group begins."""
    count = len(signed)
    if group is None:
        return np.arange(count, dtype=np.int32), np.arange(count + 1, dtype=np.int32)
    number = _column(group, count, np.int64)
    member = np.argsort(number, kind="stable").astype(np.int32)
    begins = np.flatnonzero(np.diff(number[member], prepend=number[member[:1]] - 1))
    mixed = np.diff(signed[member]) != 0.0
    mixed[begins[1:] - 1] = False
    if mixed.any():
        path = int(member[np.flatnonzero(mixed)[0] + 1])
        raise GeometryError(
            f"Path {path} has another radius or side than the group that it belongs to.",
            "Reverse it, or give it a group of its own.",
            [str(path)],
        )
    return member, np.append(begins, count).astype(np.int32)


def _refusal(
    failure: tuple[int, int, int, float], radius: F64, paths: Paths
) -> GeometryError | CompensationError:
    code, row, other, depth = failure
    if code == _NO_LENGTH:
        return ZeroLengthEdge([row])
    if code == _NOT_A_NUMBER:
        return GeometryError(
            f"Segment {row} has a coordinate or a bulge that is not a number.",
            "Draw it again.",
            [str(row)],
        )
    path = int(np.searchsorted(paths.first, row, side="right")) - 1
    if code == _TORN:
        return CompensationError(
            f"The equidistant of path {path} at {radius[path]:g} mm cannot be joined again: "
            f"{depth:.4g} mm of it beside segment {row} lead nowhere.",
            "Draw the contour without overlaps, or change the radius a little.",
            [str(row)],
        )
    return CompensationError(
        f"A tool of radius {radius[path]:g} mm beside segment {row} would cut {depth:.4g} mm into "
        f"segment {other}.",
        "Take a smaller tool, or let it leave out what it cannot reach.",
        [str(row), str(other)],
    )


# ---------------------------------------------------------------------------------------------
# The tree of boxes.


@njit(cache=True, error_model="numpy")
def _tree_size(count: int) -> int:
    total = count
    while count > 1:
        count = (count + FAN - 1) // FAN
        total += count
    return total


@njit(cache=True, error_model="numpy")
def _tree(rows: Any, count: int, boxes: Any, level: Any) -> int:
    """Boxes of rows, and above them boxes of eight each; level[h] is where height h begins."""
    for i in range(count):
        box(rows, i, boxes, i)
    level[0] = 0
    height = 0
    begin = 0
    while count > 1:
        above = begin + count
        level[height + 1] = above
        height += 1
        full = (count + FAN - 1) // FAN
        for i in range(full):
            low = begin + i * FAN
            x0, y0, x1, y1 = boxes[low, 0], boxes[low, 1], boxes[low, 2], boxes[low, 3]
            for j in range(low + 1, min(low + FAN, above)):
                x0 = min(x0, boxes[j, 0])
                y0 = min(y0, boxes[j, 1])
                x1 = max(x1, boxes[j, 2])
                y1 = max(y1, boxes[j, 3])
            boxes[above + i, 0] = x0
            boxes[above + i, 1] = y0
            boxes[above + i, 2] = x1
            boxes[above + i, 3] = y1
        begin = above
        count = full
    level[height + 1] = begin + count
    return height


@njit(cache=True, error_model="numpy")
def _next_near(
    boxes: Any,
    level: Any,
    stack: Any,
    depth: int,
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    after: int,
) -> tuple[int, int]:
    """The next leaf beyond ``after`` whose box meets this one, and the depth of the stack; or -1.

    The stack has rows of (height, number at that height); start it with the root.
    """
    while depth > 0:
        depth -= 1
        height = stack[depth, 0]
        number = stack[depth, 1]
        at = level[height] + number
        if boxes[at, 0] > x1 or boxes[at, 2] < x0 or boxes[at, 1] > y1 or boxes[at, 3] < y0:
            continue
        if height == 0:
            if number > after:
                return number, depth
            continue
        below = level[height] - level[height - 1]
        width = 1
        for _ in range(height - 1):
            width *= FAN
        for child in range(min((number + 1) * FAN, below) - 1, number * FAN - 1, -1):
            if (child + 1) * width - 1 > after:
                stack[depth, 0] = height - 1
                stack[depth, 1] = child
                depth += 1
    return -1, 0


@njit(cache=True, error_model="numpy")
def _few_meet(rows: Any, count: int, step: int, closed: bool, found: Any) -> bool:
    """Look at every pair whose boxes meet, by blocks of four."""
    blocks = (count + 3) // 4
    boxes = np.empty((count + blocks, 4))
    for i in range(count):
        box(rows, i, boxes, i)
    for i in range(blocks):
        x0, y0 = boxes[4 * i, 0] - TOUCH, boxes[4 * i, 1] - TOUCH
        x1, y1 = boxes[4 * i, 2] + TOUCH, boxes[4 * i, 3] + TOUCH
        for j in range(4 * i + 1, min(4 * i + 4, count)):
            x0 = min(x0, boxes[j, 0] - TOUCH)
            y0 = min(y0, boxes[j, 1] - TOUCH)
            x1 = max(x1, boxes[j, 2] + TOUCH)
            y1 = max(y1, boxes[j, 3] + TOUCH)
        boxes[count + i, 0] = x0
        boxes[count + i, 1] = y0
        boxes[count + i, 2] = x1
        boxes[count + i, 3] = y1
    for a in range(blocks):
        for b in range(a, blocks):
            one = count + a
            two = count + b
            if (
                boxes[two, 0] > boxes[one, 2]
                or boxes[two, 2] < boxes[one, 0]
                or boxes[two, 1] > boxes[one, 3]
                or boxes[two, 3] < boxes[one, 1]
            ):
                continue
            for i in range(4 * a, min(4 * a + 4, count)):
                x0 = boxes[i, 0] - TOUCH
                y0 = boxes[i, 1] - TOUCH
                x1 = boxes[i, 2] + TOUCH
                y1 = boxes[i, 3] + TOUCH
                last = count - 1 if closed and i == 0 else count
                for j in range(max(i + step, 4 * b), min(4 * b + 4, last)):
                    if (
                        boxes[j, 0] <= x1
                        and boxes[j, 2] >= x0
                        and boxes[j, 1] <= y1
                        and boxes[j, 3] >= y0
                        and crossing(rows, i, rows, j, TOUCH, found) > 0
                    ):
                        return True
    return False


@njit(cache=True, error_model="numpy")
def _meets_itself(rows: Any, count: int, step: int, found: Any) -> bool:
    """Whether two segments have a point in common that are ``step`` rows apart, or more.

    With a step of 2 neighbours do not count, and the last row and the first are neighbours.
    """
    closed = step == 2
    if count <= FEW:
        return _few_meet(rows, count, step, closed, found)
    boxes = np.empty((_tree_size(count), 4))
    level = np.empty(24, np.int64)
    height = _tree(rows, count, boxes, level)
    stack = np.empty((FAN * (height + 1), 2), np.int64)
    for i in range(count - 1):
        stack[0, 0] = height
        stack[0, 1] = 0
        depth = 1
        while True:
            j, depth = _next_near(
                boxes,
                level,
                stack,
                depth,
                boxes[i, 0] - TOUCH,
                boxes[i, 1] - TOUCH,
                boxes[i, 2] + TOUCH,
                boxes[i, 3] + TOUCH,
                i + step - 1,
            )
            if j < 0:
                break
            if closed and i == 0 and j == count - 1:
                continue
            if crossing(rows, i, rows, j, TOUCH, found) > 0:
                return True
    return False


# ---------------------------------------------------------------------------------------------
# Beside one path.


@njit(cache=True, error_model="numpy")
def _measured(
    start: Any, end: Any, bulge: Any, low: int, high: int, table: Any, at: int
) -> tuple[int, int]:
    """Fill tangents, chord and radius of segments low … high - 1; return a failure and its row."""
    for i in range(low, high):
        dx = end[i, 0] - start[i, 0]
        dy = end[i, 1] - start[i, 1]
        b = bulge[i]
        length = math.sqrt(dx * dx + dy * dy)
        if (
            not math.isfinite(length)
            or not math.isfinite(b)
            or not math.isfinite(start[i, 0] + start[i, 1])
        ):
            return _NOT_A_NUMBER, i
        if length < POINT:
            return _NO_LENGTH, i
        ux = dx / length
        uy = dy / length
        row = table[at + i - low]
        row[_CHORD] = length
        if abs(b) < BULGE:
            row[_U1X] = ux
            row[_U1Y] = uy
            row[_U2X] = ux
            row[_U2Y] = uy
            row[_RADIUS] = 0.0
        else:
            # Half the sweep, 2 atan b, without its angle.
            whole = 1.0 + b * b
            cos = (1.0 - b * b) / whole
            sin = 2.0 * b / whole
            row[_U1X] = ux * cos + uy * sin
            row[_U1Y] = uy * cos - ux * sin
            row[_U2X] = ux * cos - uy * sin
            row[_U2Y] = uy * cos + ux * sin
            row[_RADIUS] = math.copysign(length * whole / (4.0 * abs(b)), b)
    return _FINE, low


@njit(cache=True, error_model="numpy")
def _moved(table: Any, at: int, start: Any, end: Any, i: int, signed: float) -> float:
    """Move a segment to its side; return its new signed radius: 0 a line, NaN no arc."""
    row = table[at]
    row[_SX] = start[i, 0] - signed * row[_U1Y]
    row[_SY] = start[i, 1] + signed * row[_U1X]
    row[_EX] = end[i, 0] - signed * row[_U2Y]
    row[_EY] = end[i, 1] + signed * row[_U2X]
    row[_LOW] = 0.0
    row[_HIGH] = 1.0
    radius = row[_RADIUS]
    if radius == 0.0:
        return 0.0
    size = abs(radius) - math.copysign(signed, signed * radius)
    if size < POINT:
        return math.nan
    return math.copysign(size, radius)


@njit(cache=True, error_model="numpy")
def _pair(table: Any, at: int, bulge: float, rows: Any, place: int) -> None:
    rows[place, 0] = table[at, _SX]
    rows[place, 1] = table[at, _SY]
    rows[place, 2] = table[at, _EX]
    rows[place, 3] = table[at, _EY]
    rows[place, 4] = bulge


@njit(cache=True, error_model="numpy")
def _cap_area(chord: float, b: float) -> float:
    """The area between a chord and its arc, positive for a left turn."""
    if abs(b) < BULGE:
        return 0.0
    whole = 1.0 + b * b
    radius = chord * whole / (4.0 * b)
    # Sine of the sweep, 4 atan b, by doubling twice.
    return 0.5 * radius * radius * (4.0 * math.atan(b) - 4.0 * b * (1.0 - b * b) / (whole * whole))


@njit(cache=True, error_model="numpy")
def _turn_area(
    x: float, y: float, ax: float, ay: float, bx: float, by: float, signed: float
) -> float:
    """Twice the signed area between the tool's arc about (x, y) from a to b and its chord."""
    ax -= x
    ay -= y
    bx -= x
    by -= y
    angle = math.atan2(ax * by - ay * bx, ax * bx + ay * by)
    if signed < 0.0:
        angle = -angle
    if angle < -1e-7:
        angle += 2.0 * math.pi
    return math.copysign(signed * signed * (angle - math.sin(angle)), signed)


@njit(cache=True, error_model="numpy")
def _beside(
    start: Any,
    end: Any,
    bulge: Any,
    low: int,
    high: int,
    closed: bool,
    signed: float,
    corner: Any,
    k: Any,
    trim: bool,
    table: Any,
    at: int,
    joint: Any,
    rows: Any,
    info: Any,
    put: int,
    path: int,
    pair: Any,
    found: Any,
) -> tuple[int, int, int, float]:
    """Write the moved segments and transitions of one path into rows and info from ``put`` on.

    info has rows of (input segment, whether inserted, whether the next row continues this one,
    path).  Where ``trim`` is set, concave corners are shortened, and it is a failure if that cannot
    be done; else everything that can be made is, as it is.  Returns the next free row, a failure,
    its segment, and the area lost at concave corners.
    """
    count = high - low
    size = abs(signed)
    lost = 0.0
    for i in range(count):
        radius = _moved(table, at + i, start, end, low + i, signed)
        if radius != radius:
            if trim:
                return put, _NO_ROOM, low + i, 0.0
            table[at + i, _HIGH] = -1.0
    for i in range(count):
        joint[at + i] = _OPEN
        if i == 0 and not closed:
            continue
        before = at + (i - 1 if i > 0 else count - 1)
        here = at + i
        u1x = table[before, _U2X]
        u1y = table[before, _U2Y]
        u2x = table[here, _U1X]
        u2y = table[here, _U1Y]
        cross = u1x * u2y - u1y * u2x
        dot = u1x * u2x + u1y * u2y
        last = low + (i - 1 if i > 0 else count - 1)
        x = start[low + i, 0]
        y = start[low + i, 1]
        if dot > 0.0 and size * abs(cross) < POINT:
            # A smooth joint, but for rounding: both meet in one point, exactly for lines.
            joint[here] = _SMOOTH
            share = signed / (1.0 + dot)
            gx = x - share * (u1y + u2y)
            gy = y + share * (u1x + u2x)
            _slid(table, before, bulge[last], signed, gx, gy, True)
            _slid(table, here, bulge[low + i], signed, gx, gy, False)
        elif cross * signed < 0.0 or dot < -1.0 + 1e-12:
            joint[here] = _CONVEX
            if trim and dot < -1.0 + 1e-12:
                return put, _NO_ROOM, low + i, 0.0
        else:
            joint[here] = _CONCAVE
            if not trim:
                continue
            if table[before, _RADIUS] == 0.0 and table[here, _RADIUS] == 0.0:
                if dot < -1.0 + 1e-9:
                    return put, _NO_ROOM, low + i, 0.0
                tangent = abs(cross) / (1.0 + dot)
                share = signed / (1.0 + dot)
                gx = x - share * (u1y + u2y)
                gy = y + share * (u1x + u2x)
                table[before, _HIGH] -= size * tangent / table[before, _CHORD]
                table[here, _LOW] = size * tangent / table[here, _CHORD]
                lost += size * size * (tangent - math.atan(tangent))
            else:
                _pair(table, before, bulge[last], pair, 0)
                _pair(table, here, bulge[low + i], pair, 1)
                # The ends of both may have been shortened already: here they are whole.
                pair[0, 0] = start[last, 0] - signed * table[before, _U1Y]
                pair[0, 1] = start[last, 1] + signed * table[before, _U1X]
                pair[1, 2] = end[low + i, 0] - signed * table[here, _U2Y]
                pair[1, 3] = end[low + i, 1] + signed * table[here, _U2X]
                if crossing(pair, 0, pair, 1, TOUCH, found) != 1:
                    return put, _NO_ROOM, low + i, 0.0
                gx = found[0, 0]
                gy = found[0, 1]
                table[before, _HIGH] = found[0, 2]
                table[here, _LOW] = found[0, 3]
                lost += _notch(x, y, gx, gy, table, before, here, signed)
            table[before, _EX] = gx
            table[before, _EY] = gy
            table[here, _SX] = gx
            table[here, _SY] = gy
    for i in range(count):
        here = at + i
        kept = table[here, _HIGH] - table[here, _LOW]
        if kept < 0.0 and not trim:
            # An arc that is none any more: what led to it ends.
            if put > 0 and info[put - 1, 3] == path:
                info[put - 1, 2] = 0
            if joint[here] == _CONVEX:
                put = _corner(
                    table, at, i, count, start, low, signed, corner, k, rows, info, put, path
                )
                info[put - 1, 2] = 0
            continue
        radius = table[here, _RADIUS]
        reach = table[here, _CHORD]
        if radius != 0.0:
            moved = abs(radius) - math.copysign(signed, signed * radius)
            reach = moved * math.pi if abs(bulge[low + i]) > 1.0 else reach * moved / abs(radius)
        if trim and kept * reach < POINT:
            return put, _NO_ROOM, low + i, 0.0
        if joint[here] == _CONVEX:
            put = _corner(table, at, i, count, start, low, signed, corner, k, rows, info, put, path)
        bent = bulge[low + i] if radius != 0.0 else 0.0
        if kept != 1.0 and radius != 0.0:
            bent = math.tan(math.atan(bent) * kept)
        _pair(table, here, bent, rows, put)
        info[put, 0] = low + i
        info[put, 1] = 0
        follows = at + i + 1
        if i == count - 1:
            follows = at
        info[put, 2] = (
            joint[follows] == _SMOOTH
            or joint[follows] == _CONVEX
            or (trim and joint[follows] == _CONCAVE)
        )
        info[put, 3] = path
        if i == count - 1 and not closed:
            info[put, 2] = 0
        put += 1
    return put, _FINE, low, lost


@njit(cache=True, error_model="numpy")
def _slid(table: Any, at: int, b: float, signed: float, gx: float, gy: float, last: bool) -> None:
    """Move an end of a moved segment along it by less than POINT."""
    row = table[at]
    radius = row[_RADIUS]
    if radius != 0.0:
        size = abs(radius) - math.copysign(signed, signed * radius)
        span = size * 4.0 * math.atan(abs(b))
        if span > 0.0:
            if last:
                row[_HIGH] += ((gx - row[_EX]) * row[_U2X] + (gy - row[_EY]) * row[_U2Y]) / span
            else:
                row[_LOW] += ((gx - row[_SX]) * row[_U1X] + (gy - row[_SY]) * row[_U1Y]) / span
    if last:
        row[_EX] = gx
        row[_EY] = gy
    else:
        row[_SX] = gx
        row[_SY] = gy


@njit(cache=True, error_model="numpy")
def _corner(
    table: Any,
    at: int,
    i: int,
    count: int,
    start: Any,
    low: int,
    signed: float,
    corner: Any,
    k: Any,
    rows: Any,
    info: Any,
    put: int,
    path: int,
) -> int:
    before = at + (i - 1 if i > 0 else count - 1)
    here = at + i
    begun = put
    put = transition(
        corner[low + i],
        start[low + i, 0],
        start[low + i, 1],
        table[before, _U2X],
        table[before, _U2Y],
        table[here, _U1X],
        table[here, _U1Y],
        signed,
        k[low + i],
        rows,
        put,
    )
    for j in range(begun, put):
        info[j, 0] = low + i
        info[j, 1] = 1
        info[j, 2] = 1
        info[j, 3] = path
    return put


@njit(cache=True, error_model="numpy")
def _notch(
    x: float,
    y: float,
    gx: float,
    gy: float,
    table: Any,
    before: int,
    here: int,
    signed: float,
) -> float:
    """The area that a disc about (gx, gy) leaves at a concave corner (x, y) with arcs."""
    # Feet of the disc on both segments: G - σ r n with n the normals at G.
    f1x, f1y = _foot(table, before, x, y, gx, gy, True)
    f2x, f2y = _foot(table, here, x, y, gx, gy, False)
    # Twice the area of the loop F1 → A → F2, closed by the arc about G backwards.
    twice = f1x * y - f1y * x + x * f2y - y * f2x + f2x * f1y - f2y * f1x
    twice += _sliver(x, y, f1x, f1y, table[before, _RADIUS])
    twice += _sliver(x, y, f2x, f2y, table[here, _RADIUS])
    twice -= _turn_area(gx, gy, f1x, f1y, f2x, f2y, signed)
    return 0.5 * math.copysign(twice, twice * signed)


@njit(cache=True, error_model="numpy")
def _sliver(x: float, y: float, fx: float, fy: float, radius: float) -> float:
    """Twice the area between two points' chord and the arc of less than half a turn over it."""
    if radius == 0.0:
        return 0.0
    half = min(0.5 * math.sqrt((x - fx) ** 2 + (y - fy) ** 2) / abs(radius), 1.0)
    area = 2.0 * (math.asin(half) - half * math.sqrt(1.0 - half * half))
    return math.copysign(radius * radius * area, radius)


@njit(cache=True, error_model="numpy")
def _foot(
    table: Any,
    at: int,
    x: float,
    y: float,
    gx: float,
    gy: float,
    last: bool,
) -> tuple[float, float]:
    """Where a disc about G touches the segment that ends (``last``) or starts in (x, y)."""
    radius = table[at, _RADIUS]
    ux = table[at, _U2X] if last else table[at, _U1X]
    uy = table[at, _U2Y] if last else table[at, _U1Y]
    if radius == 0.0:
        share = (gx - x) * ux + (gy - y) * uy
        return x + share * ux, y + share * uy
    cx = x - radius * uy
    cy = y + radius * ux
    dx = gx - cx
    dy = gy - cy
    scale = abs(radius) / math.sqrt(dx * dx + dy * dy)
    return cx + dx * scale, cy + dy * scale


# ---------------------------------------------------------------------------------------------
# What comes too near.


@njit(cache=True, error_model="numpy")
def _distance(rows: Any, i: int, x: float, y: float) -> float:
    """Distance from a point to row i (mm)."""
    x0 = rows[i, 0]
    y0 = rows[i, 1]
    dx = rows[i, 2] - x0
    dy = rows[i, 3] - y0
    b = rows[i, 4]
    px = x - x0
    py = y - y0
    if abs(b) < BULGE:
        share = (px * dx + py * dy) / (dx * dx + dy * dy)
        share = min(max(share, 0.0), 1.0)
        px -= share * dx
        py -= share * dy
        return math.sqrt(px * px + py * py)
    cx, cy, radius = circle(rows, i)
    qx = x - cx
    qy = y - cy
    away = math.sqrt(qx * qx + qy * qy)
    if away > 0.0:
        # Where the ray from the centre through the point meets the circle: on the arc or not?
        side = dx * (cy + qy * radius / away - y0) - dy * (cx + qx * radius / away - x0)
        if (side <= 0.0) == (b > 0.0):
            return abs(away - radius)
    qx = x - rows[i, 2]
    qy = y - rows[i, 3]
    return math.sqrt(min(px * px + py * py, qx * qx + qy * qy))


@njit(cache=True, error_model="numpy")
def _in_transition(
    kind: int, k: float, table: Any, before: int, here: int, vx: float, vy: float, signed: float
) -> bool:
    """Whether a point, seen from the vertex, lies inside a transition of type C or D."""
    u1x = table[before, _U2X]
    u1y = table[before, _U2Y]
    u2x = table[here, _U1X]
    u2y = table[here, _U1Y]
    size = abs(signed)
    turn = math.copysign(1.0, signed)
    n1 = turn * (vy * u1x - vx * u1y)
    n2 = turn * (vy * u2x - vx * u2y)
    if n1 >= size - NEARER or n2 >= size - NEARER:
        return False
    ahead = vx * u1x + vy * u1y
    back = -(vx * u2x + vy * u2y)
    if ahead <= 0.0 or back <= 0.0:
        return False
    cross = u1x * u2y - u1y * u2x
    dot = u1x * u2x + u1y * u2y
    straight, small = reach(kind, cross, dot, size, k)
    if straight < POINT:
        return False
    # The ends of both straight parts, seen from the vertex, and the chord between them.
    cx = straight * u1x - signed * u1y
    cy = straight * u1y + signed * u1x
    dx = -straight * u2x - signed * u2y
    dy = -straight * u2y + signed * u2x
    gap = math.hypot(dx - cx, dy - cy)
    if gap < POINT:
        return True
    beyond = turn * ((dx - cx) * (vy - cy) - (dy - cy) * (vx - cx)) / gap
    if beyond <= -NEARER:
        return True
    if kind == 1:
        return False
    ox = cx + math.copysign(small, signed) * u1y
    oy = cy - math.copysign(small, signed) * u1x
    return math.hypot(vx - ox, vy - oy) < small - NEARER


@njit(cache=True, error_model="numpy")
def _clear(
    x: float,
    y: float,
    origin: Any,
    boxes: Any,
    level: Any,
    height: int,
    stack: Any,
    signed: float,
    limit: float,
    table: Any,
    prior: Any,
    joint: Any,
    kinds: Any,
    k: Any,
    capped: bool,
) -> bool:
    """Whether a point is no nearer than ``limit`` to the contour, and in no transition."""
    size = abs(signed)
    around = size * 1.4142135623731 if capped else limit
    stack[0, 0] = height
    stack[0, 1] = 0
    depth = 1
    while True:
        i, depth = _next_near(
            boxes, level, stack, depth, x - around, y - around, x + around, y + around, -1
        )
        if i < 0:
            return True
        if _distance(origin, i, x, y) < limit:
            return False
        if (
            capped
            and joint[i] == _CONVEX
            and kinds[i] > 0
            and _in_transition(
                kinds[i], k[i], table, prior[i], i, x - origin[i, 0], y - origin[i, 1], signed
            )
        ):
            return False


@njit(cache=True, error_model="numpy")
def _nearest(x: float, y: float, origin: Any, count: int, skip: int) -> tuple[int, float]:
    """The segment other than ``skip`` that is nearest to a point, and how near."""
    best = math.inf
    which = skip
    for i in range(count):
        if i != skip:
            away = _distance(origin, i, x, y)
            if away < best:
                best = away
                which = i
    return which, best


# ---------------------------------------------------------------------------------------------
# Everything cut where it crosses, and joined again.


@njit(cache=True, error_model="numpy")
def _meet_at_ends(rows: Any, i: int, j: int) -> bool:
    dx = abs(rows[i, 2] - rows[j, 0])
    dy = abs(rows[i, 3] - rows[j, 1])
    return bool(dx <= TOUCH and dy <= TOUCH)


@njit(cache=True, error_model="numpy")
def _cut(
    rows: Any,
    follow: Any,
    count: int,
    real: int,
    boxes: Any,
    level: Any,
    height: int,
    stack: Any,
    found: Any,
) -> tuple[Any, Any, int]:
    """The places where rows cross: row numbers, and (share, x, y); and how many.

    Rows from ``real`` on only cut others.
    """
    room = 2 * count + 16
    which = np.empty(room, np.int64)
    place = np.empty((room, 3))
    done = 0
    for i in range(real):
        stack[0, 0] = height
        stack[0, 1] = 0
        depth = 1
        while True:
            j, depth = _next_near(
                boxes,
                level,
                stack,
                depth,
                boxes[i, 0] - TOUCH,
                boxes[i, 1] - TOUCH,
                boxes[i, 2] + TOUCH,
                boxes[i, 3] + TOUCH,
                i,
            )
            if j < 0:
                break
            if (follow[i] == j and _meet_at_ends(rows, i, j)) or (
                j < real and follow[j] == i and _meet_at_ends(rows, j, i)
            ):
                # Neighbours that run on into each other have no second point in common.
                continue
            hits = crossing(rows, i, rows, j, TOUCH, found)
            if done + 2 * hits > room:
                room *= 2
                more = np.empty(room, np.int64)
                more[:done] = which[:done]
                which = more
                further = np.empty((room, 3))
                further[:done] = place[:done]
                place = further
            for h in range(hits):
                for side in range(2 if j < real else 1):
                    which[done] = j if side else i
                    place[done, 0] = found[h, 2 + side]
                    place[done, 1] = found[h, 0]
                    place[done, 2] = found[h, 1]
                    done += 1
    return which, place, done


@njit(cache=True, error_model="numpy")
def _pieces(rows: Any, real: int, which: Any, place: Any, cuts: int) -> tuple[Any, Any, Any, int]:
    """The rows between their cuts: (x0, y0, x1, y1, low, high), their row, the first of each."""
    bound = np.zeros(real + 1, np.int64)
    for c in range(cuts):
        bound[which[c] + 1] += 1
    for i in range(real):
        bound[i + 1] += bound[i]
    order = np.empty(cuts, np.int64)
    filled = bound[:-1].copy()
    for c in range(cuts):
        i = which[c]
        at = filled[i]
        filled[i] += 1
        # Insertion keeps the few cuts of a row in order.
        while at > bound[i] and place[order[at - 1], 0] > place[c, 0]:
            order[at] = order[at - 1]
            at -= 1
        order[at] = c
    piece = np.empty((real + cuts, 6))
    owner = np.empty(real + cuts, np.int64)
    done = 0
    for i in range(real):
        dx = rows[i, 2] - rows[i, 0]
        dy = rows[i, 3] - rows[i, 1]
        b = abs(rows[i, 4])
        length = math.sqrt(dx * dx + dy * dy)
        if b >= BULGE:
            length = length * (1.0 + b * b) * math.atan(b) / b
        speck = SPECK / length
        bound_first = done
        x, y, share = rows[i, 0], rows[i, 1], 0.0
        for o in range(bound[i], bound[i + 1]):
            c = order[o]
            if place[c, 0] - share < speck or 1.0 - place[c, 0] < speck:
                continue
            piece[done, 0] = x
            piece[done, 1] = y
            x = place[c, 1]
            y = place[c, 2]
            piece[done, 2] = x
            piece[done, 3] = y
            piece[done, 4] = share
            share = place[c, 0]
            piece[done, 5] = share
            owner[done] = i
            done += 1
        piece[done, 0] = x
        piece[done, 1] = y
        piece[done, 2] = rows[i, 2]
        piece[done, 3] = rows[i, 3]
        piece[done, 4] = share
        piece[done, 5] = 1.0
        owner[done] = i
        done += 1
        filled[i] = bound_first
    return piece, owner, filled, done


@njit(cache=True, error_model="numpy")
def _joined(
    piece: Any, owner: Any, opening: Any, follow: Any, good: Any, count: int, after: Any, prior: Any
) -> None:
    """Which piece comes after which: the next one of the same line or arc, else the nearest."""
    near = 10.0 * SPECK
    for q in range(count):
        after[q] = -1
        prior[q] = -1
    for q in range(count):
        if not good[q]:
            continue
        if q + 1 < count and owner[q + 1] == owner[q]:
            n = q + 1
        elif follow[owner[q]] >= 0:
            n = opening[follow[owner[q]]]
        else:
            continue
        if (
            good[n]
            and abs(piece[n, 0] - piece[q, 2]) <= near
            and abs(piece[n, 1] - piece[q, 3]) <= near
        ):
            after[q] = n
            prior[n] = q
    loose = 0
    for q in range(count):
        if good[q] and prior[q] < 0:
            loose += 1
    if loose == 0:
        return
    begins = np.empty(loose, np.int64)
    at = np.empty(loose)
    loose = 0
    for q in range(count):
        if good[q] and prior[q] < 0:
            begins[loose] = q
            at[loose] = piece[q, 0]
            loose += 1
    order = np.argsort(at)
    at = at[order]
    for q in range(count):
        if not good[q] or after[q] >= 0:
            continue
        best = near
        chosen = -1
        place = np.searchsorted(at, piece[q, 2] - near)
        while place < loose and at[place] <= piece[q, 2] + near:
            n = begins[order[place]]
            if prior[n] < 0:
                away = math.hypot(piece[n, 0] - piece[q, 2], piece[n, 1] - piece[q, 3])
                if away <= best:
                    best = away
                    chosen = n
            place += 1
        if chosen >= 0:
            after[q] = chosen
            prior[chosen] = q


@njit(cache=True, error_model="numpy")
def _strung(
    rows: Any,
    info: Any,
    piece: Any,
    owner: Any,
    good: Any,
    after: Any,
    prior: Any,
    count: int,
    line: Any,
    tag: Any,
    first: Any,
    ring: Any,
) -> int:
    """Follow the pieces into chains: rows, tags, bounds, whether closed; return how many."""
    done = 0
    chains = 0
    used = np.zeros(count, np.bool_)
    for round_ in range(2):
        for begin in range(count):
            if not good[begin] or used[begin] or (round_ == 0 and prior[begin] >= 0):
                continue
            first[chains] = done
            q = begin
            last = -1
            while q >= 0 and not used[q]:
                used[q] = True
                i = owner[q]
                if last >= 0 and owner[last] == i and q == last + 1:
                    # A cut that was none: the piece goes on.
                    line[done - 1, 2] = piece[q, 2]
                    line[done - 1, 3] = piece[q, 3]
                    line[done - 1, 4] += piece[q, 5] - piece[q, 4]
                else:
                    for c in range(4):
                        line[done, c] = piece[q, c]
                    line[done, 4] = piece[q, 5] - piece[q, 4]
                    tag[done, 0] = info[i, 0]
                    tag[done, 1] = info[i, 1]
                    tag[done, 2] = info[i, 3]
                    tag[done, 3] = i
                    done += 1
                last = q
                q = after[q]
            closed = q == begin
            low = first[chains]
            if (
                closed
                and done - low > 1
                and tag[low, 3] == tag[done - 1, 3]
                and piece[begin, 4] > 0.0
                and begin == last + 1
            ):
                line[low, 0] = line[done - 1, 0]
                line[low, 1] = line[done - 1, 1]
                line[low, 4] += line[done - 1, 4]
                done -= 1
            done = _tidied(rows, line, tag, low, done, closed)
            if done > low:
                ring[chains] = closed
                chains += 1
    first[chains] = done
    return chains


@njit(cache=True, error_model="numpy")
def _tidied(rows: Any, line: Any, tag: Any, low: int, high: int, closed: bool) -> int:
    """Give the rows their bulges, leave out specks, and let each begin where the last one ends."""
    done = low
    for r in range(low, high):
        b = rows[tag[r, 3], 4]
        if line[r, 4] < 1.0 - 1e-15 and b != 0.0:
            b = math.tan(math.atan(b) * line[r, 4])
        if abs(b) < 1.0 and math.hypot(line[r, 2] - line[r, 0], line[r, 3] - line[r, 1]) < POINT:
            continue
        for c in range(4):
            line[done, c] = line[r, c]
            tag[done, c] = tag[r, c]
        line[done, 4] = b
        if done > low:
            line[done, 0] = line[done - 1, 2]
            line[done, 1] = line[done - 1, 3]
        done += 1
    if done > low and closed:
        if done - low == 1:
            return low
        line[low, 0] = line[done - 1, 2]
        line[low, 1] = line[done - 1, 3]
    return done


@njit(cache=True, error_model="numpy")
def _swept(
    line: Any,
    tag: Any,
    low: int,
    high: int,
    ring: bool,
    start: Any,
    signed: float,
    from_x: float,
    from_y: float,
    hops: Any,
    hop: int,
) -> tuple[float, float, float, int]:
    """Twice the area under the edge that a tool leaves beside a chain; where that edge ends.

    The edge of an open chain begins at (from_x, from_y).  Arcs of the edge about the chain's
    corners are written into hops from ``hop`` on.
    """
    twice = 0.0
    x, y = from_x, from_y
    size = abs(signed)
    begun = not ring
    for r in range(low, high + (1 if ring else 0)):
        again = r == high
        at = low if again else r
        x0, y0, x1, y1, b = line[at, 0], line[at, 1], line[at, 2], line[at, 3], line[at, 4]
        if tag[at, 1]:
            ax, ay = start[tag[at, 0], 0], start[tag[at, 0], 1]
            bx, by = ax, ay
            bent = 0.0
        else:
            dx = x1 - x0
            dy = y1 - y0
            scale = signed / math.sqrt(dx * dx + dy * dy)
            whole = 1.0 + b * b
            cos = (1.0 - b * b) / whole * scale
            sin = 2.0 * b / whole * scale
            ax = x0 + dy * cos - dx * sin
            ay = y0 - dx * cos - dy * sin
            bx = x1 + dy * cos + dx * sin
            by = y1 - dx * cos + dy * sin
            bent = b
        if begun:
            twice += x * ay - y * ax
            gap = math.hypot(ax - x, ay - y)
            if (
                gap > POINT
                and abs(math.hypot(x - x0, y - y0) - size) < 1e-6
                and abs(math.hypot(ax - x0, ay - y0) - size) < 1e-6
            ):
                twice += _turn_area(x0, y0, x, y, ax, ay, signed)
                half = min(gap / (2.0 * size), 1.0)
                hops[hop, 0] = x
                hops[hop, 1] = y
                hops[hop, 2] = ax
                hops[hop, 3] = ay
                hops[hop, 4] = math.copysign(half / (1.0 + math.sqrt(1.0 - half * half)), signed)
                hop += 1
        begun = True
        if again:
            break
        twice += ax * by - ay * bx
        if bent != 0.0:
            twice += 2.0 * math.copysign(_cap_area(math.hypot(bx - ax, by - ay), bent), bent)
        x, y = bx, by
    return twice, x, y, hop


@njit(cache=True, error_model="numpy")
def _under(start: Any, end: Any, bulge: Any, low: int, high: int) -> float:
    """Twice the area under a path, its closing chord left out."""
    twice = 0.0
    for i in range(low, high):
        twice += start[i, 0] * end[i, 1] - start[i, 1] * end[i, 0]
        if bulge[i] != 0.0:
            chord = math.hypot(end[i, 0] - start[i, 0], end[i, 1] - start[i, 1])
            twice += 2.0 * _cap_area(chord, bulge[i])
    return twice


@njit(cache=True, error_model="numpy")
def _fitting(
    start: Any,
    end: Any,
    bulge: Any,
    first: Any,
    member: Any,
    low: int,
    high: int,
    signed: float,
    corner: Any,
    k: Any,
    refuse: bool,
    found: Any,
) -> tuple[Any, Any, Any, Any, int, float, int, int, int, float]:
    """The equidistant of one region with all its contours, cut and joined.

    Returns rows, tags, bounds and closedness of the chains, how many, the area that is not reached,
    and a failure with two segments and a depth.
    """
    size = abs(signed)
    total = 0
    for m in range(low, high):
        total += first[member[m] + 1] - first[member[m]]
    table = np.empty((total, 12))
    joint = np.empty(total, np.int64)
    origin = np.empty((total, 5))
    source = np.empty(total, np.int64)
    before = np.empty(total, np.int64)
    kinds = np.empty(total, np.int64)
    share = np.empty(total)
    pair = np.empty((2, 5))
    room = 8 * total + 4 * (high - low) + 8
    rows = np.empty((room, 5))
    info = np.empty((room, 4), np.int64)
    follow = np.empty(room, np.int64)
    shut = np.empty(high - low, np.bool_)
    whole = np.empty(high - low, np.bool_)
    put = 0
    at = 0
    capped = False
    lost_row = -1
    under = 0.0
    for m in range(low, high):
        path = member[m]
        a = first[path]
        b = first[path + 1]
        if a == b:
            continue
        code, row = _measured(start, end, bulge, a, b, table, at)
        if code != _FINE:
            return rows, info, follow, shut, 0, 0.0, code, row, row, 0.0
        closed = _is_closed(start, end, a, b)
        shut[m - low] = closed
        for i in range(a, b):
            here = at + i - a
            origin[here, 0] = start[i, 0]
            origin[here, 1] = start[i, 1]
            origin[here, 2] = end[i, 0]
            origin[here, 3] = end[i, 1]
            origin[here, 4] = bulge[i] if abs(bulge[i]) >= BULGE else 0.0
            source[here] = i
            before[here] = here - 1 if i > a else at + b - a - 1
            kinds[here] = corner[i]
            share[here] = k[i]
            capped |= corner[i] > 0
        begun = put
        put, code, row, _ = _beside(
            start,
            end,
            bulge,
            a,
            b,
            closed,
            signed,
            corner,
            k,
            True,
            table,
            at,
            joint,
            rows,
            info,
            begun,
            path,
            pair,
            found,
        )
        whole[m - low] = code == _FINE
        if code != _FINE:
            put, code, row, _ = _beside(
                start,
                end,
                bulge,
                a,
                b,
                closed,
                signed,
                corner,
                k,
                False,
                table,
                at,
                joint,
                rows,
                info,
                begun,
                path,
                pair,
                found,
            )
            for here in range(at, at + b - a):
                if table[here, _HIGH] < 0.0:
                    lost_row = source[here]
        for e in range(begun, put):
            follow[e] = e + 1 if info[e, 2] else -1
        if put > begun and info[put - 1, 2]:
            follow[put - 1] = begun
        under += _under(start, end, bulge, a, b)
        at += b - a
    real = put
    for m in range(low, high):
        path = member[m]
        if first[path] < first[path + 1] and not shut[m - low]:
            put = _other_side(
                start,
                end,
                bulge,
                first[path],
                first[path + 1],
                signed,
                rows,
                info,
                put,
                pair,
                found,
            )
    boxes = np.empty((_tree_size(put), 4))
    level = np.empty(24, np.int64)
    height = _tree(rows, put, boxes, level)
    stack = np.empty((FAN * (height + 2) + FAN * 12, 2), np.int64)
    which, place, cuts = _cut(rows, follow, put, real, boxes, level, height, stack, found)
    piece, owner, opening, count = _pieces(rows, real, which, place, cuts)
    origin_boxes = np.empty((_tree_size(total), 4))
    origin_level = np.empty(24, np.int64)
    origin_height = _tree(origin, total, origin_boxes, origin_level)
    limit = size - NEARER
    good = np.empty(count, np.bool_)
    worst = 0.0
    worst_row = lost_row
    worst_other = lost_row
    if lost_row >= 0:
        worst = size - abs(_radius_of(start, end, bulge, lost_row))
    for q in range(count):
        i = owner[q]
        x, y = point_on(rows, i, 0.5 * (piece[q, 4] + piece[q, 5]))
        if high - low == 1 and not refuse:
            # What is lost is mostly lost to the next segments: ask them first.
            mine = info[i, 0] - first[member[low]]
            lost = False
            for near in range(max(mine - 2, 0), min(mine + 3, total)):
                lost |= _distance(origin, near, x, y) < limit
            if lost:
                good[q] = False
                continue
        good[q] = _clear(
            x,
            y,
            origin,
            origin_boxes,
            origin_level,
            origin_height,
            stack,
            signed,
            limit,
            table,
            before,
            joint,
            kinds,
            share,
            capped,
        )
        if refuse and not good[q]:
            own = info[i, 0]
            mine = 0
            while source[mine] != own:
                mine += 1
            other, away = _nearest(x, y, origin, total, mine)
            ordinary = (other == before[mine] or before[other] == mine) and (
                piece[q, 4] > 0.0 or piece[q, 5] < 1.0
            )
            if not ordinary and size - away > worst:
                worst = size - away
                worst_row = own
                worst_other = source[other]
    if refuse and worst_row >= 0:
        return rows, info, follow, shut, 0, 0.0, _NO_ROOM, worst_row, worst_other, worst
    after = np.empty(count, np.int64)
    prior = np.empty(count, np.int64)
    _joined(piece, owner, opening, follow, good, count, after, prior)
    line = np.empty((count + 1, 5))
    tag = np.empty((count + 1, 4), np.int64)
    bounds = np.empty(count + 1, np.int64)
    ring = np.empty(count + 1, np.bool_)
    chains = _strung(rows, info, piece, owner, good, after, prior, count, line, tag, bounds, ring)
    # What is not reached, and chains that should be closed and are not.
    last = np.empty((high - low, 2))
    for m in range(low, high):
        path = member[m]
        if first[path] < first[path + 1]:
            last[m - low, 0] = start[first[path], 0]
            last[m - low, 1] = start[first[path], 1]
    swept = 0.0
    hops = np.empty((bounds[chains] + chains, 5))
    hop = 0
    for c in range(chains):
        m = low
        while member[m] != tag[bounds[c], 2]:
            m += 1
        x, y = last[m - low, 0], last[m - low, 1]
        if not ring[c] and shut[m - low]:
            length = 0.0
            for r in range(bounds[c], bounds[c + 1]):
                length += math.hypot(line[r, 2] - line[r, 0], line[r, 3] - line[r, 1])
            return line, tag, bounds, ring, 0, 0.0, _TORN, tag[bounds[c], 0], 0, length
        area, x, y, hop = _swept(
            line, tag, bounds[c], bounds[c + 1], ring[c], start, signed, x, y, hops, hop
        )
        swept += area
        if not ring[c]:
            last[m - low, 0] = x
            last[m - low, 1] = y
    for m in range(low, high):
        path = member[m]
        if first[path] < first[path + 1] and not shut[m - low]:
            x = end[first[path + 1] - 1, 0]
            y = end[first[path + 1] - 1, 1]
            swept += last[m - low, 0] * y - last[m - low, 1] * x
    unreached = 0.5 * (under - swept)
    if signed < 0.0:
        unreached = -unreached
    # Where these arcs meet, some of the area has been swept twice.
    twice = 0
    if chains > 0 and ring[:chains].all() and hop > 1 and _meets_itself(hops, hop, 1, found):
        twice = 1
    return line, tag, bounds, ring, chains, unreached, _FINE, twice, 0, 0.0


@njit(cache=True, error_model="numpy")
def _radius_of(start: Any, end: Any, bulge: Any, i: int) -> float:
    b = abs(bulge[i])
    chord = math.hypot(end[i, 0] - start[i, 0], end[i, 1] - start[i, 1])
    size: float = chord * (1.0 + b * b) / (4.0 * b)
    return size


@njit(cache=True, error_model="numpy")
def _is_closed(start: Any, end: Any, low: int, high: int) -> bool:
    return math.hypot(start[low, 0] - end[high - 1, 0], start[low, 1] - end[high - 1, 1]) < POINT


@njit(cache=True, error_model="numpy")
def _other_side(
    start: Any,
    end: Any,
    bulge: Any,
    low: int,
    high: int,
    signed: float,
    rows: Any,
    info: Any,
    put: int,
    pair: Any,
    found: Any,
) -> int:
    """Write how far the other side of an open path and its two ends reach: no path, but it cuts."""
    count = high - low
    back_start = end[low:high][::-1].copy()
    back_end = start[low:high][::-1].copy()
    back_bulge = -bulge[low:high][::-1]
    table = np.empty((count, 12))
    joint = np.empty(count, np.int64)
    plain = np.zeros(count, np.uint8)
    half = np.zeros(count)
    _measured(back_start, back_end, back_bulge, 0, count, table, 0)
    put, _, _, _ = _beside(
        back_start,
        back_end,
        back_bulge,
        0,
        count,
        False,
        signed,
        plain,
        half,
        False,
        table,
        0,
        joint,
        rows,
        info,
        put,
        -1,
        pair,
        found,
    )
    for e in range(2):
        if e == 0:
            x, y, ux, uy = back_start[0, 0], back_start[0, 1], -table[0, _U1X], -table[0, _U1Y]
        else:
            last = count - 1
            x, y, ux, uy = (
                back_end[last, 0],
                back_end[last, 1],
                table[last, _U2X],
                table[last, _U2Y],
            )
        put = transition(0, x, y, ux, uy, -ux, -uy, signed, 0.0, rows, put)
    return put


# ---------------------------------------------------------------------------------------------
# All regions.


@njit(cache=True, error_model="numpy")
def _room(
    start: Any, end: Any, bulge: Any, source: Any, inserted: Any, used: int, wanted: int
) -> tuple[Any, Any, Any, Any, Any]:
    if wanted <= len(bulge):
        return start, end, bulge, source, inserted
    size = 2 * wanted
    s = np.empty((size, 2))
    e = np.empty((size, 2))
    b = np.empty(size)
    o = np.empty(size, np.int32)
    i = np.empty(size, np.bool_)
    s[:used] = start[:used]
    e[:used] = end[:used]
    b[:used] = bulge[:used]
    o[:used] = source[:used]
    i[:used] = inserted[:used]
    return s, e, b, o, i


@njit(cache=True, error_model="numpy")
def _all(
    start: Any,
    end: Any,
    bulge: Any,
    first: Any,
    member: Any,
    members: Any,
    signed: Any,
    corner: Any,
    k: Any,
    refuse: bool,
) -> Any:
    count = len(first) - 1
    most = 0
    for p in range(count):
        most = max(most, first[p + 1] - first[p])
    table = np.empty((most, 12))
    joint = np.empty(most, np.int64)
    rows = np.empty((4 * most, 5))
    info = np.empty((4 * most, 4), np.int64)
    pair = np.empty((2, 5))
    found = np.empty((4, 4))
    size = 2 * len(bulge) + 256
    out_start = np.empty((size, 2))
    out_end = np.empty((size, 2))
    out_bulge = np.empty(size)
    source = np.empty(size, np.int32)
    inserted = np.empty(size, np.bool_)
    out_first = np.empty(count + 16, np.int32)
    owner = np.empty(count + 16, np.int32)
    unreached = np.zeros(count)
    failure = (_FINE, 0, 0, 0.0)
    done = 0
    chains = 0
    for g in range(len(members) - 1):
        low = members[g]
        high = members[g + 1]
        path = member[low]
        a = first[path]
        b = first[path + 1]
        put = -1
        if signed[path] == 0.0:
            for m in range(low, high):
                path = member[m]
                a = first[path]
                b = first[path + 1]
                if a == b:
                    continue
                code, row = _measured(start, end, bulge, a, b, table, 0)
                if code != _FINE:
                    failure = (code, row, row, 0.0)
                    break
                out_start, out_end, out_bulge, source, inserted = _room(
                    out_start, out_end, out_bulge, source, inserted, done, done + b - a
                )
                if chains + 2 > len(owner):
                    out_first, owner = _longer(out_first), _longer(owner)
                out_first[chains] = done
                owner[chains] = path
                chains += 1
                for i in range(a, b):
                    out_start[done] = start[i]
                    out_end[done] = end[i]
                    out_bulge[done] = bulge[i]
                    source[done] = i
                    inserted[done] = False
                    done += 1
            if failure[0] != _FINE:
                break
            continue
        if high - low == 1 and a < b and _is_closed(start, end, a, b):
            code, row = _measured(start, end, bulge, a, b, table, 0)
            if code != _FINE:
                failure = (code, row, row, 0.0)
                break
            put, code, row, lost = _beside(
                start,
                end,
                bulge,
                a,
                b,
                True,
                signed[path],
                corner,
                k,
                True,
                table,
                0,
                joint,
                rows,
                info,
                0,
                path,
                pair,
                found,
            )
            if code != _FINE or _meets_itself(rows, put, 2, found):
                put = -1
        if put >= 0:
            out_start, out_end, out_bulge, source, inserted = _room(
                out_start, out_end, out_bulge, source, inserted, done, done + put
            )
            if chains + 2 > len(owner):
                out_first, owner = _longer(out_first), _longer(owner)
            out_first[chains] = done
            owner[chains] = path
            chains += 1
            unreached[path] = lost
            for r in range(put):
                out_start[done, 0] = rows[r, 0]
                out_start[done, 1] = rows[r, 1]
                out_end[done, 0] = rows[r, 2]
                out_end[done, 1] = rows[r, 3]
                out_bulge[done] = rows[r, 4]
                source[done] = info[r, 0]
                inserted[done] = info[r, 1] == 1
                done += 1
            continue
        line, tag, bounds, _, more, area, code, row, other, depth_ = _fitting(
            start, end, bulge, first, member, low, high, signed[path], corner, k, refuse, found
        )
        if code != _FINE:
            failure = (code, row, other, depth_)
            break
        if row == 1:
            area = _left_over(
                start,
                end,
                bulge,
                first,
                member,
                low,
                high,
                signed[path],
                line,
                bounds,
                more,
                area,
                found,
            )
        unreached[path] = max(area, 0.0)
        if more == 0:
            continue
        out_start, out_end, out_bulge, source, inserted = _room(
            out_start, out_end, out_bulge, source, inserted, done, done + bounds[more]
        )
        while chains + more + 1 > len(owner):
            out_first, owner = _longer(out_first), _longer(owner)
        for c in range(more):
            out_first[chains] = done
            owner[chains] = tag[bounds[c], 2]
            chains += 1
            for r in range(bounds[c], bounds[c + 1]):
                out_start[done, 0] = line[r, 0]
                out_start[done, 1] = line[r, 1]
                out_end[done, 0] = line[r, 2]
                out_end[done, 1] = line[r, 3]
                out_bulge[done] = line[r, 4]
                source[done] = tag[r, 0]
                inserted[done] = tag[r, 1] == 1
                done += 1
    out_first[chains] = done
    return (
        out_start[:done],
        out_end[:done],
        out_bulge[:done],
        source[:done],
        inserted[:done],
        out_first[: chains + 1],
        owner[:chains],
        unreached,
        failure,
    )


@njit(cache=True, error_model="numpy")
def _left_over(
    start: Any,
    end: Any,
    bulge: Any,
    first: Any,
    member: Any,
    low: int,
    high: int,
    signed: float,
    line: Any,
    bounds: Any,
    chains: int,
    estimate: float,
    found: Any,
) -> float:
    """The area that is not reached, by the equidistant of the equidistant, back at the contour."""
    rows = bounds[chains]
    back_start = line[:rows, :2].copy()
    back_end = line[:rows, 2:4].copy()
    back_bulge = line[:rows, 4].copy()
    edge, _, parts, _, count, _, code, _, _, _ = _fitting(
        back_start,
        back_end,
        back_bulge,
        bounds,
        np.arange(chains),
        0,
        chains,
        -signed,
        np.zeros(rows, np.uint8),
        np.zeros(rows),
        False,
        found,
    )
    if code != _FINE:
        return estimate
    under = 0.0
    for m in range(low, high):
        under += _under(start, end, bulge, first[member[m]], first[member[m] + 1])
    size = parts[count]
    under -= _under(edge[:size, :2].copy(), edge[:size, 2:4].copy(), edge[:size, 4].copy(), 0, size)
    return 0.5 * math.copysign(under, under * signed)


@njit(cache=True, error_model="numpy")
def _longer(column: Any) -> Any:
    result = np.empty(2 * len(column), column.dtype)
    result[: len(column)] = column
    return result
