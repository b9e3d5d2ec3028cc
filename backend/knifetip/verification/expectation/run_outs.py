"""The distances by which V-grooves that end on the board's edge must run out past that edge.

In the top face a groove of width W has two sides, parallel to its line at a distance of W/2.  Both
sides must run out past the board's edge.  Let u be the groove's direction, n its normal, and m the
outward normal of the board's edge.  The groove's line ends on the board's edge.  One of the sides
crosses the edge only (W/2) |n·m| / (u·m) farther along u, which is the required run-out.

An end at most ``TOUCH_DISTANCE`` from the board's edge counts as on the edge.  If it lies at the
distance D before the edge, measured along m, the required run-out is longer by D / (u·m).

Source: "A new method of turning processing in multi axis linkage NC machining", section 1 (run-out
on a flat board).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, line_curves, point_at
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import (
    TOUCH_DISTANCE,
    Edges,
)
from knifetip.verification.expectation.outline import CutOutlines, find_divided_outlines

#: Sine of 5°; a groove at a smaller angle to the board's edge does not leave the board.
_MIN_SINE: Final = math.sin(math.radians(5.0))


@dataclass(frozen=True, eq=False, slots=True)
class RunOuts:
    """Required run-outs past the board's edge, one for each of the 2n ends of n grooves."""

    boundary: Bool  #: (2n,) the groove leaves the board at this end
    least: F64  #: (2n,) mm that the tip must go past the end


def run_outs(grooves: Edges, cuts: Edges, half: float) -> RunOuts:
    """Return the required run-outs of grooves that end on the board's edge.

    Parameters
    ----------
    grooves
        V-grooves.  Grooves that are arcs get no run-out.
    cuts
        Cuts, whose outer contours are the board's edge.
    half : mm
        Half of the grooves' width in the top face.
    """
    count = len(grooves.ends)
    boundary, least = np.zeros(count, np.bool_), np.zeros(count)
    bounds = find_divided_outlines(cuts)
    outer = np.flatnonzero(bounds.outer)
    if len(outer) == 0 or count == 0:
        return RunOuts(boundary, least)
    curve = bounds.edges.curve[outer]
    overlaps = find_overlaps(
        line_curves(grooves.ends, grooves.ends),
        curve,
        np.zeros(len(outer)),
        curve[:, 5],
        TOUCH_DISTANCE,
    )
    end, edge = overlaps.curve.astype(np.int64), overlaps.edge.astype(np.int64)
    straight = grooves.curve[end // 2, 0] == 0.0
    end, edge, place = end[straight], edge[straight], overlaps.place[straight, 0]
    ahead = np.radians(grooves.outward[end])
    u = np.stack([np.cos(ahead), np.sin(ahead)], axis=1)
    along = np.radians(azimuth_at(curve[edge], place))
    left = np.stack([-np.sin(along), np.cos(along)], axis=1)
    m = np.where(bounds.board_left[outer[edge]][:, None], -left, left)
    leaving = (u * m).sum(axis=1)
    leaves = leaving > _MIN_SINE
    # A groove that touches the edge may end up to TOUCH_DISTANCE before it.
    to_edge = point_at(curve[edge], place) - grooves.ends[end]
    before = np.maximum((to_edge * m).sum(axis=1), 0.0)
    # Distance from the end of the line until each side of the groove is past an edge.
    need = np.full((count, 2), np.inf)
    farthest = np.full((count, 2), -np.inf)
    n = np.stack([-u[:, 1], u[:, 0]], axis=1)
    for side, sign in enumerate((1.0, -1.0)):
        across = before - sign * half * (n * m).sum(axis=1)
        go = np.where(leaves, across / np.where(leaves, leaving, 1.0), 0.0)
        go = np.where(
            leaves, _distance_to_circle(curve[edge], grooves.ends[end], u, sign * half * n, go), go
        )
        np.minimum.at(need[:, side], end[leaves], go[leaves])
        np.maximum.at(farthest[:, side], end[leaves], go[leaves])
    # At a convex corner being past one edge is enough; in a notch both edges must be passed.
    outward = _convex_corners(bounds, outer, end, edge, count)
    many = np.bincount(end, minlength=count)
    out_by = np.bincount(end[leaves], minlength=count)
    boundary[:] = (many > 0) & (out_by >= np.where(outward, 1, many))
    reach = np.where(outward[:, None], need, farthest)
    least[boundary] = np.maximum(reach[boundary].max(axis=1), 0.0)
    return RunOuts(boundary, least)


def _distance_to_circle(curve: F64, end: F64, u: F64, aside: F64, straight: F64) -> F64:
    """Return how far each of n grooves must go past its end until one of its sides has passed the
    board's edge, (n,) mm.

    If the board's edge is a line, this is ``straight``.  If it is an arc, this is the distance to
    the circle of the arc or ``straight``, whichever is less.

    ``curve`` (n, 6): part of the board's edge that each groove must pass: lines and arcs as rows of
    six numbers (see ``curves.curve``).
    ``end``, ``u`` (n, 2): end of each groove (mm) and the groove's unit direction there.
    ``aside`` (n, 2) mm: vector from the groove's line to the side.
    ``straight`` (n,) mm: distance to the tangent of the board's edge.
    """
    bent = curve[:, 0] != 0.0
    to = end + aside - curve[:, 1:3]
    b = (to * u).sum(axis=1)
    inner = b**2 - (to**2).sum(axis=1) + np.where(bent, curve[:, 3], 0.0) ** 2
    root = np.sqrt(np.maximum(inner, 0.0))
    near = np.where(np.abs(-b - root) < np.abs(-b + root), -b - root, -b + root)
    result: F64 = np.where(bent & (inner >= 0.0), np.minimum(near, straight), straight)
    return result


def _convex_corners(bounds: CutOutlines, outer: I64, end: I64, edge: I64, count: int) -> Bool:
    """Return the mask of the ends of grooves that lie on a convex corner of the outline.

    The mask has ``count`` entries, one for each end of a groove.

    ``bounds``, ``outer``: outlines of the cuts, and the indices of the cuts on outer contours.
    ``end``, ``edge`` (k,): k pairs of an end of a groove and a cut that this end touches: the index
    of the end, and the index of the cut in ``outer``.
    """
    outward = np.zeros(count, np.bool_)
    order = np.argsort(end, kind="stable")
    end, edge = end[order], edge[order]
    pair = np.flatnonzero(end[1:] == end[:-1])
    for first, second in ((pair, pair + 1), (pair + 1, pair)):
        a, b = outer[edge[first]], outer[edge[second]]
        heading = []
        for row, arrives in ((a, True), (b, False)):
            # With the board on the left, arrive along the first edge and leave along the second.
            ahead = bounds.board_left[row]
            at_end = ahead if arrives else ~ahead
            curve = bounds.edges.curve[row]
            angle = azimuth_at(curve, np.where(at_end, curve[:, 5], 0.0))
            heading.append(np.radians(np.where(ahead, angle, angle + 180.0)))
            place = point_at(curve, np.where(at_end, curve[:, 5], 0.0))
            heading.append(place)
        meets = np.hypot(*(heading[1] - heading[3]).T) <= TOUCH_DISTANCE
        turn = np.sin(heading[2] - heading[0])
        outward[end[first[meets & (turn > 1e-6)]]] = True
    return outward
