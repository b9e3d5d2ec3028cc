"""clearance: test whether a position of the tool's centre is clear of the contours.

A position is clear if it meets two conditions.  No segment of a contour is nearer than the tool's
radius.  And the position is not between a convex corner and the path on which the tool goes round
this corner, if this path consists of lines (type C) or of a line, an arc and a line (type D).  A
tree of bounding boxes of the segments finds the near segments.
"""

from __future__ import annotations

import math
from typing import Final

from knifetip.geometry.intersect import circle_of_arc
from knifetip.geometry.spatial_index.box_tree import BoxTree, next_overlap, start_query
from knifetip.geometry.tolerance import BULGE, POINT
from knifetip.kernels import F64_2, OutI64_2, kernel
from knifetip.offset.raw_segments import CONVEX, U1X, U1Y, U2X, U2Y
from knifetip.offset.records import RegionCorners
from knifetip.offset.transition import straight_and_radius

#: Rounding error that is allowed in the distance between an offset and its contour (mm).
DISTANCE_TOLERANCE: Final = 1e-9


@kernel
def distance_to_row(rows: F64_2, i: int, x: float, y: float) -> float:
    """Return the distance of a point (x, y) from the segment in row ``i`` of ``rows`` (mm).

    ``rows`` (n, 5) are segments: x0, y0, x1, y1, bulge.
    """
    x0 = rows[i, 0]
    y0 = rows[i, 1]
    dx = rows[i, 2] - x0
    dy = rows[i, 3] - y0
    b = rows[i, 4]
    px = x - x0
    py = y - y0
    if abs(b) < BULGE:
        fraction = (px * dx + py * dy) / (dx * dx + dy * dy)
        fraction = min(max(fraction, 0.0), 1.0)
        px -= fraction * dx
        py -= fraction * dy
        return math.sqrt(px * px + py * py)
    cx, cy, radius = circle_of_arc(rows, i)
    qx = x - cx
    qy = y - cy
    away = math.sqrt(qx * qx + qy * qy)
    if away > 0.0:
        # Test whether the ray from the centre through the point meets the arc.
        side = dx * (cy + qy * radius / away - y0) - dy * (cx + qx * radius / away - x0)
        if (side <= 0.0) == (b > 0.0):
            return abs(away - radius)
    qx = x - rows[i, 2]
    qy = y - rows[i, 3]
    return math.sqrt(min(px * px + py * py, qx * qx + qy * qy))


@kernel
def _in_transition(
    kind: int,
    k: float,
    table: F64_2,
    row_before: int,
    row_after: int,
    vx: float,
    vy: float,
    signed: float,
) -> bool:
    """Return whether a point is between a corner and the transition round this corner.

    A transition is the path of the tool's centre round a corner.  It consists of two or three lines
    (corner type C), or of a line, an arc and a line (corner type D).

    ``kind``, ``k``: corner type, and the parameter k of type D: from 0 (one arc) to 1 (lines only).
    ``table``, ``row_before``, ``row_after``: table of the segments that were moved by the tool
    radius, and its rows for the segments before and after the corner.
    ``vx``, ``vy`` mm: position of the point relative to the corner's vertex.
    ``signed`` mm: radius of the tool, positive left of travel.
    """
    u1x = table[row_before, U2X]
    u1y = table[row_before, U2Y]
    u2x = table[row_after, U1X]
    u2y = table[row_after, U1Y]
    size = abs(signed)
    turn = math.copysign(1.0, signed)
    n1 = turn * (vy * u1x - vx * u1y)
    n2 = turn * (vy * u2x - vx * u2y)
    if n1 >= size - DISTANCE_TOLERANCE or n2 >= size - DISTANCE_TOLERANCE:
        return False
    ahead = vx * u1x + vy * u1y
    back = -(vx * u2x + vy * u2y)
    if ahead <= 0.0 or back <= 0.0:
        return False
    cross = u1x * u2y - u1y * u2x
    dot = u1x * u2x + u1y * u2y
    straight, small = straight_and_radius(kind, cross, dot, size, k)
    if straight < POINT:
        return False
    # The ends of both straight parts, relative to the vertex, and the chord between them.
    cx = straight * u1x - signed * u1y
    cy = straight * u1y + signed * u1x
    dx = -straight * u2x - signed * u2y
    dy = -straight * u2y + signed * u2x
    gap = math.hypot(dx - cx, dy - cy)
    if gap < POINT:
        return True
    overlap = turn * ((dx - cx) * (vy - cy) - (dy - cy) * (vx - cx)) / gap
    if overlap <= -DISTANCE_TOLERANCE:
        return True
    if kind == 1:
        return False
    ox = cx + math.copysign(small, signed) * u1y
    oy = cy - math.copysign(small, signed) * u1x
    return math.hypot(vx - ox, vy - oy) < small - DISTANCE_TOLERANCE


@kernel
def is_clear(
    x: float,
    y: float,
    tree: BoxTree,
    stack: OutI64_2,
    signed: float,
    limit: float,
    corners: RegionCorners,
) -> bool:
    """Return whether a position of the tool's centre is clear of the contours.

    The position is clear if it meets two conditions.  No contour is nearer than ``limit`` mm.  And
    the position is not between a convex corner and the path of the tool's centre round this corner,
    if this path contains lines (types C and D).

    Parameters
    ----------
    x, y : mm
        The position.
    tree, stack
        Tree of the bounding boxes of the contour segments, and a scratch array for its search.
    signed : mm
        Radius of the tool, positive left of travel.
    limit : mm
        The radius, less a tolerance for rounding errors.
    corners
        Corners at the starts of the segments.
    """
    origin = corners.origin
    size = abs(signed)
    reach = size * 1.4142135623731 if corners.capped else limit
    depth = start_query(tree, stack)
    while True:
        box = (x - reach, y - reach, x + reach, y + reach)
        i, depth = next_overlap(tree.boxes, tree.level, stack, depth, box, -1)
        if i < 0:
            return True
        if distance_to_row(origin, i, x, y) < limit:
            return False
        if (
            corners.capped
            and corners.segments.joint[i] == CONVEX
            and corners.kind[i] > 0
            and _in_transition(
                corners.kind[i],
                corners.k[i],
                corners.segments.table,
                corners.previous[i],
                i,
                x - origin[i, 0],
                y - origin[i, 1],
                signed,
            )
        ):
            return False


@kernel
def nearest_segment(
    x: float,
    y: float,
    origin: F64_2,
    tree: BoxTree,
    stack: OutI64_2,
    reach: float,
    skip: int,
) -> tuple[int, float]:
    """Return the index of the contour segment nearest to the point (x, y), and its distance (mm).

    Only segments nearer than ``reach`` mm are found.  If there is none, returns ``skip`` and
    ``reach``.

    Parameters
    ----------
    origin : (n, 5)
        Segments of the contours: x0, y0, x1, y1, bulge.
    tree, stack
        Tree of the bounding boxes of these segments, and a scratch array for its search.
    reach : mm
        Search distance.
    skip
        Index of a segment that is left out.
    """
    best = reach
    nearest = skip
    depth = start_query(tree, stack)
    while True:
        box = (x - best, y - best, x + best, y + best)
        i, depth = next_overlap(tree.boxes, tree.level, stack, depth, box, -1)
        if i < 0:
            return nearest, best
        if i != skip:
            away = distance_to_row(origin, i, x, y)
            if away < best:
                best = away
                nearest = i
