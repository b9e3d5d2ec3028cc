"""reattach: move ends that lay on a line onto the line into which it was merged.

Where two lines nearly coincide and one of them is merged into the other, the ends of third lines
that touched the merged line would stop before the other line or reach past it.  They follow it.
"""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.cleaning.deviation import distance_to_edge
from knifetip.geometry import arc
from knifetip.geometry.capacity import reserve_i64_2
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.spatial_index.box_tree import (
    build_tree,
    new_stack,
    next_overlap,
    start_query,
)
from knifetip.geometry.spatial_index.morton import order_boxes
from knifetip.geometry.tolerance import BULGE, GAP, JOIN, POINT
from knifetip.kernels import F64_2, kernel

#: Sine of the smallest angle at which an end is moved along its own line.
_SLANT: Final = 0.1
#: Largest number of merged lines that are examined for an end.
_LOOKS: Final = 32


class MergedLines(NamedTuple):
    """The m parts of lines that were merged into other lines."""

    start: F64  #: (m, 2) mm
    end: F64  #: (m, 2) mm
    bulge: F64  #: (m,)
    target: I64  #: (m,) edge into which each part was merged


def reattach(ends: F64, bulge: F64, place: I64, merged: MergedLines) -> F64:
    """Return the ends of k edges, (k, 2, 2) mm, with those moved that touched a merged line.

    An end that meets no other end is moved along its own line to the line into which the merged
    line went, or to the nearest point of that line if that is nearer.  Ends that meet are moved
    together, to the nearest point, unless an edge has both of its ends there.  No end is moved by
    more than ``GAP``, and no edge becomes as short as ``JOIN``.

    Parameters
    ----------
    ends, bulge : (k, 2, 2) mm and (k,)
        The edges after the merge.
    place : (2k,)
        Number of the point of each end; ends that meet have the same number.
    merged
        The lines as they were before the merge.
    """
    points = ends.reshape(-1, 2)
    boxes = arc.bounding_boxes(merged.start, merged.end, merged.bulge)
    order = order_boxes(boxes)
    lines = np.column_stack([merged.start, merged.end, merged.bulge])[order]
    touched = _touched_pairs(lines, boxes[order], np.ascontiguousarray(points), JOIN)
    row, end = order[touched[:, 0]], touched[:, 1]
    on = merged.target[row]
    foot = _nearest_point(ends[on, 0], ends[on, 1], bulge[on], points[end])
    gap = np.hypot(*(foot - points[end]).T)
    apart = np.flatnonzero((gap > JOIN) & (gap <= GAP + POINT))
    # The nearest of several lines, once per point.
    apart = apart[np.argsort(gap[apart], kind="stable")]
    once = np.unique(place[end[apart]], return_index=True)[1]
    by_place = np.argsort(place, kind="stable")
    first = np.searchsorted(place[by_place], np.arange(len(place) + 1))
    result = points.copy()
    for at in apart[once].tolist():
        number = place[end[at]]
        alike = by_place[first[number] : first[number + 1]]
        if (alike // 2 == on[at]).any() or np.isin(alike ^ 1, alike).any():
            continue
        goal = foot[at]
        if len(alike) == 1:
            goal = _along_own_line(points, bulge, int(alike[0]), on[at], goal)
        if (np.hypot(*(result[alike ^ 1] - goal).T) > JOIN).all():
            result[alike] = goal
    return result.reshape(-1, 2, 2)


@kernel
def _touched_pairs(lines: F64_2, boxes: F64_2, points: F64_2, distance: float) -> Any:
    """Return the pairs of a line or arc and a point within a distance of it, (k, 2).

    At most ``_LOOKS`` lines are examined for a point, so that the time is linear.

    ``lines`` (m, 5): lines and arcs: x0, y0, x1, y1 (mm), bulge; near ones follow one another.
    ``boxes`` (m, 4) mm: their bounding boxes.
    ``points`` (n, 2) mm: the points.
    ``distance`` mm: greatest distance of a point from a line that it touches.
    """
    found = np.empty((64, 2), np.int64)
    size = 0
    tree, stack = build_tree(boxes), new_stack()
    for i in range(len(points)):
        x, y = points[i, 0], points[i, 1]
        depth = start_query(tree, stack)
        for _ in range(_LOOKS):
            box = (x - distance, y - distance, x + distance, y + distance)
            at, depth = next_overlap(tree.boxes, tree.level, stack, depth, box, -1)
            if at < 0:
                break
            if distance_to_edge(lines[at], x, y) <= distance:
                found = reserve_i64_2(found, size + 1)
                found[size, 0], found[size, 1] = at, i
                size += 1
    return found[:size].copy()


def _nearest_point(start: F64, end: F64, bulge: F64, point: F64) -> F64:
    """Return the point nearest to each of n points on the line or arc given for it, (n, 2) mm."""
    return arc.point_at(start, end, bulge, arc.nearest_fraction(start, end, bulge, point))


def _along_own_line(points: F64, bulge: F64, end: int, target: int, foot: F64) -> F64:
    """Return where a line, continued or shortened at one of its ends, meets another line (mm).

    The result is ``foot`` if one of them is an arc, if they meet at a small angle, or if the end
    would be moved by more than ``GAP`` or past the end of the other line.

    ``points``, ``bulge`` (2k, 2) mm and (k,): the ends and bulges of all edges.
    ``target``: index of the other line.
    ``foot``: point of the other line that is nearest to the end (mm).
    """
    if max(abs(bulge[end // 2]), abs(bulge[target])) >= BULGE:
        return foot
    x, y = points[end]
    own = points[end] - points[end ^ 1]
    begin, along = points[2 * target], points[2 * target + 1] - points[2 * target]
    cross = own[0] * along[1] - own[1] * along[0]
    if abs(cross) <= _SLANT * np.hypot(*own) * np.hypot(*along):
        return foot
    off = begin - np.array([x, y])
    way = (off[0] * along[1] - off[1] * along[0]) / cross
    part = (off[0] * own[1] - off[1] * own[0]) / cross
    if abs(way) * np.hypot(*own) > GAP or not 0.0 <= part <= 1.0:
        return foot
    crossing: F64 = np.array([x, y]) + way * own
    return crossing
