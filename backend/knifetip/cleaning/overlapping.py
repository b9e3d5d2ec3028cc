"""overlapping: find pairs of edges that overlap along some length.

Two lines overlap if both ends of the shorter line are within ``SAME``, which is 0.01 mm, of the
longer line; two arcs overlap if the ends and the midpoint of the shorter arc are within ``SAME`` of
the circle of the longer arc.  The common length must be greater than ``SAME``.  Where two ends are
less than ``SAME`` apart in the direction of the edges, one end replaces the other, so the whole
distance between them must be at most ``SAME`` too.

Edges that are farther apart, but nearly coincide, are found by the same rule with ``GAP`` in place
of ``SAME``, except that an end need not be near an end of the other edge.  A line and an arc nearly
coincide if the line is a chord of the arc, within ``GAP`` (module ``chords_on_arcs``).

The directions of two lines differ by at most ``ANGLE`` (1°).  Where a curve is drawn twice with
other vertices, the directions of its chords may differ more: those of two lines longer than ``GAP``
and shorter than ``_SHORT`` by as much as the ends of the shorter one can be apart across it, which
is 2 ``SAME``, but at most 20°.

Bounding boxes are searched for pairs of edges that may overlap.  The bounding box of a line is
computed in a frame that is rotated nearly to the direction of the line, so that the box is thin.
Short lines are searched for in a second tree of boxes that are not rotated.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.cleaning.chords_on_arcs import find_chords
from knifetip.cleaning.edge_parameter import circle_of, middle_of, range_of, size_of
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
from knifetip.geometry.tolerance import ANGLE, BULGE, GAP, POINT, SAME
from knifetip.kernels import F64_1, F64_2, I64_1, OutF64_2, inline_kernel, kernel

#: Angle between neighbouring frames (degrees).
_FAN: Final = 2.0
_ARCS: Final = 90
#: Lines shorter than this may differ in direction by more than ``ANGLE`` (mm).
_SHORT: Final = 2.0 * SAME / math.sin(math.radians(ANGLE))
#: Sine of the largest difference in direction (20°).
_SLOPE: Final = math.sin(math.radians(20.0))
#: Largest number of partners found for an edge in one round of cleaning.
_CROWD: Final = 64
#: Largest number of candidates examined for an edge: it bounds the time where thousands of edges
#: cross at angles of a degree or two.
_LOOKS: Final = 2048


class OverlappingPairs(NamedTuple):
    """The p pairs of edges that overlap, and whether further edges nearly coincide."""

    first: I64  #: (p,) first edge of each pair
    second: I64  #: (p,) second edge of each pair
    has_near: bool  #: whether two edges are farther apart than ``SAME``, and within ``GAP``


def find_overlapping(ends: F64, bulge: F64, *, is_near: bool = False) -> OverlappingPairs:
    """Return the pairs of edges that overlap.

    Each pair is returned once.  To bound the time, the search for the partners of an edge ends
    after ``_CROWD`` partners or ``_LOOKS`` examined edges, so that pairs may be missing if very
    many edges overlap.

    Parameters
    ----------
    ends, bulge : (k, 2, 2) mm and (k,)
        Start and end points, and bulges, of the k edges.
    is_near
        Whether edges that nearly coincide, within ``GAP``, are pairs.
    """
    none = np.zeros(0, np.int64)
    if len(bulge) < 2:
        return OverlappingPairs(none, none, False)
    low = np.array([ends[:, :, 0].min(), ends[:, :, 1].min()])
    moved = ends - low
    reach = 4.0 * (float(np.abs(moved).max()) + 1.0)
    rows = np.column_stack([moved.reshape(-1, 4), bulge])
    boxes, bucket, angle, width = _frame_boxes(rows, np.radians(_FAN), np.radians(ANGLE), GAP)
    shelf = np.floor(boxes[:, 1] / np.where(bucket == _ARCS, reach / 64.0, GAP))
    order = np.lexsort((boxes[:, 0], shelf, bucket))
    frames = _Frames(boxes, bucket, angle, width)
    found, has_near = _overlapping_pairs(
        rows, frames, order, reach, math.radians(_FAN), SAME, GAP - POINT, is_near
    )
    one, two = order[found[:, 0]], order[found[:, 1]]
    short = np.zeros(0, np.int64) if is_near else np.flatnonzero(_are_short(rows))
    if len(short) > 1:
        start, end = rows[short, :2], rows[short, 2:4]
        short = short[order_boxes(arc.bounding_boxes(start, end, bulge[short]))]
        found = _overlapping_short(rows[short], SAME)
        one, two = np.append(one, short[found[:, 0]]), np.append(two, short[found[:, 1]])
    if is_near or not has_near:
        line, on = find_chords(rows, GAP - POINT)
        has_near |= len(line) > 0
        if is_near:
            one, two = np.concatenate([one, line]), np.concatenate([two, on])
    # Sorting is faster here than numpy's ``unique``, which hashes: there may be millions.
    pair = np.sort(np.minimum(one, two) * len(bulge) + np.maximum(one, two))
    pair = pair[np.append(True, pair[1:] != pair[:-1])] if len(pair) else pair
    return OverlappingPairs(pair // len(bulge), pair % len(bulge), bool(has_near))


@kernel
def _frame_boxes(rows: F64_2, fan: float, max_angle: float, same: float) -> Any:
    """Return a thin bounding box for each of k edges, and the frame in which it is computed.

    There is a fixed number of frames, each rotated by ``fan`` radians against the next.  The box of
    a line is computed in the frame that is nearest to its direction.  All arcs share one more
    frame, which is not rotated.

    ``rows`` (k, 5): edges: x0, y0, x1, y1, bulge.
    ``fan``: angle between the directions of neighbouring frames (radians).
    ``max_angle``: largest angle between two lines that can overlap (radians).
    ``same``: length by which the boxes are enlarged (mm).
    Returns ``boxes`` (k, 4): x min, y min, x max, y max of the bounding box of each edge, in its
    frame (mm); ``bucket`` (k,): number of the frame of each edge; ``angle, width`` (k,): direction
    of each line, 0 … π, and the angle by which the direction of a line that overlaps it may differ
    (radians).  Both are 0 for arcs.
    """
    count = len(rows)
    boxes = np.empty((count, 4))
    bucket = np.empty(count, np.int64)
    angle = np.empty(count)
    width = np.empty(count)
    for i in range(count):
        x0, y0, x1, y1, b = rows[i, 0], rows[i, 1], rows[i, 2], rows[i, 3], rows[i, 4]
        if abs(b) >= BULGE:
            bucket[i] = _ARCS
            angle[i] = 0.0
            width[i] = 0.0
            rise_x = 0.5 * b * (y1 - y0)
            rise_y = 0.5 * b * (x0 - x1)
            boxes[i, 0] = min(x0, x1) + min(rise_x, 0.0) - same
            boxes[i, 1] = min(y0, y1) + min(rise_y, 0.0) - same
            boxes[i, 2] = max(x0, x1) + max(rise_x, 0.0) + same
            boxes[i, 3] = max(y0, y1) + max(rise_y, 0.0) + same
            continue
        theta = math.atan2(y1 - y0, x1 - x0) % math.pi
        number = round(theta / fan)
        bucket[i] = number % _ARCS
        angle[i] = theta
        length = math.hypot(x1 - x0, y1 - y0)
        width[i] = max_angle if length < 2.0 * same else min(max_angle, 2.2 * same / length)
        _box(rows, i, bucket[i] * fan, same, boxes, i)
    return boxes, bucket, angle, width


@kernel
def _box(rows: F64_2, i: int, turn: float, same: float, boxes: OutF64_2, box_row: int) -> None:
    """Write the bounding box of the line in row ``i`` of ``rows`` into ``boxes[box_row]``.

    The box is computed in a frame rotated by ``turn`` radians, and enlarged by ``same`` mm on both
    sides of the line.
    """
    c, s = math.cos(turn), math.sin(turn)
    u0 = c * rows[i, 0] + s * rows[i, 1]
    u1 = c * rows[i, 2] + s * rows[i, 3]
    v0 = c * rows[i, 1] - s * rows[i, 0]
    v1 = c * rows[i, 3] - s * rows[i, 2]
    boxes[box_row, 0] = min(u0, u1)
    boxes[box_row, 1] = min(v0, v1) - same
    boxes[box_row, 2] = max(u0, u1)
    boxes[box_row, 3] = max(v0, v1) + same


class _Frames(NamedTuple):
    """The bounding boxes of k edges, each in a frame; see ``_frame_boxes``."""

    boxes: F64_2  #: (k, 4) bounding box of each edge in its frame (mm)
    bucket: I64_1  #: (k,) number of the frame of each edge
    angle: F64_1  #: (k,) direction of each line (radians)
    width: F64_1  #: (k,) greatest difference to the direction of a line that overlaps (radians)


@kernel
def _overlapping_pairs(
    edges: F64_2,
    frames: _Frames,
    order: I64_1,
    reach: float,
    fan: float,
    same: float,
    gap: float,
    is_near: bool,
) -> Any:
    """Return the pairs of edges that overlap, (p, 2), as indices in ``order``, and whether further
    edges nearly coincide.

    ``edges`` (k, 5): edges: x0, y0, x1, y1, bulge.
    ``order`` (k,): the edges, sorted by frame so that near ones follow one another.
    ``reach`` mm: distance by which the boxes of successive frames are moved apart.
    ``fan`` radians: angle between the directions of neighbouring frames.
    ``same``, ``gap`` mm: largest distance of two edges that overlap, and of two edges that nearly
    coincide.
    ``is_near``: whether edges that nearly coincide are pairs.
    """
    has_near = False
    count = len(order)
    rows, boxes = np.empty((count, 5)), np.empty((count, 4))
    bucket = np.empty(count, np.int64)
    angle, width = np.empty(count), np.empty(count)
    for i in range(count):
        at = order[i]
        bucket[i], angle[i], width[i] = frames.bucket[at], frames.angle[at], frames.width[at]
        for column in range(5):
            rows[i, column] = edges[at, column]
        for column in range(4):
            boxes[i, column] = frames.boxes[at, column]
        boxes[i, 1] += bucket[i] * reach
        boxes[i, 3] += bucket[i] * reach
    circle = np.empty((count, 3))
    for i in range(count):
        if bucket[i] == _ARCS:
            circle[i, 0], circle[i, 1], circle[i, 2], _ = circle_of(rows, i)
    tree, stack = build_tree(boxes), new_stack()
    other = np.empty((1, 4))
    found = np.empty((64, 2), np.int64)
    size = 0
    slope = math.sin(math.radians(ANGLE))
    for i in range(count):
        # Search the own frame, and a neighbouring one if the angle is near it.
        for look in range(-1, 2):
            after = i
            box = boxes[i]
            if look != 0:
                if bucket[i] == _ARCS:
                    continue
                off = (angle[i] - bucket[i] * fan + math.pi / 2.0) % math.pi - math.pi / 2.0
                if look * off < fan / 2.0 - width[i]:
                    continue
                shelf = (bucket[i] + look) % _ARCS
                _box(rows, i, shelf * fan, gap, other, 0)
                other[0, 1] += shelf * reach
                other[0, 3] += shelf * reach
                box = other[0]
                after = -1
            depth = start_query(tree, stack)
            partners = 0
            looks = 0
            while partners < _CROWD and looks < _LOOKS:
                looks += 1
                wanted = (box[0], box[1], box[2], box[3])
                j, depth = next_overlap(tree.boxes, tree.level, stack, depth, wanted, after)
                if j < 0:
                    break
                if i == j:
                    continue
                if bucket[i] == _ARCS and _are_apart(rows, circle, i, j, gap):
                    continue
                if is_near:
                    overlap = _do_overlap(rows, i, j, gap, True, slope)
                else:
                    overlap = _do_overlap(rows, i, j, same, False, slope)
                    if not overlap and not has_near:
                        has_near = _do_overlap(rows, i, j, gap, True, slope)
                if overlap:
                    found = reserve_i64_2(found, size + 1)
                    found[size, 0], found[size, 1] = i, j
                    size += 1
                    partners += 1
    return found[:size].copy(), has_near


@kernel
def _are_short(rows: F64_2) -> Any:
    """Return the mask of the lines longer than ``GAP`` and shorter than ``_SHORT``, (k,), among the
    edges ``rows``.
    """
    result = np.zeros(len(rows), np.bool_)
    for i in range(len(rows)):
        dx, dy = rows[i, 2] - rows[i, 0], rows[i, 3] - rows[i, 1]
        is_short = GAP * GAP < dx * dx + dy * dy < _SHORT * _SHORT
        result[i] = is_short and abs(rows[i, 4]) < BULGE
    return result


@kernel
def _overlapping_short(rows: F64_2, same: float) -> Any:
    """Return the pairs of short lines that overlap, (p, 2).

    ``rows`` (k, 5) are the lines, of which near ones follow one another, and ``same`` is the
    largest distance of two lines that overlap (mm).
    """
    boxes = np.empty((len(rows), 4))
    for i in range(len(rows)):
        boxes[i, 0] = min(rows[i, 0], rows[i, 2]) - same
        boxes[i, 1] = min(rows[i, 1], rows[i, 3]) - same
        boxes[i, 2] = max(rows[i, 0], rows[i, 2])
        boxes[i, 3] = max(rows[i, 1], rows[i, 3])
    tree, stack = build_tree(boxes), new_stack()
    found = np.empty((64, 2), np.int64)
    size = 0
    for i in range(len(rows)):
        depth = start_query(tree, stack)
        partners = 0
        looks = 0
        while partners < _CROWD and looks < _LOOKS:
            looks += 1
            box = (boxes[i, 0], boxes[i, 1], boxes[i, 2], boxes[i, 3])
            j, depth = next_overlap(tree.boxes, tree.level, stack, depth, box, i)
            if j < 0:
                break
            shorter = min(size_of(rows, i), size_of(rows, j))
            slope = max(min(2.0 * same / shorter, _SLOPE), math.sin(math.radians(ANGLE)))
            if _do_overlap(rows, i, j, same, False, slope):
                found = reserve_i64_2(found, size + 1)
                found[size, 0], found[size, 1] = i, j
                size += 1
                partners += 1
    return found[:size].copy()


@inline_kernel
def _are_apart(rows: F64_2, circle: F64_2, i: int, j: int, gap: float) -> bool:
    """Return whether each of two arcs starts more than ``gap`` mm off the circle of the other.

    ``circle`` (k, 3) is centre and radius of each arc in ``rows`` (mm).
    """
    one = math.hypot(rows[j, 0] - circle[i, 0], rows[j, 1] - circle[i, 1]) - circle[i, 2]
    other = math.hypot(rows[i, 0] - circle[j, 0], rows[i, 1] - circle[j, 1]) - circle[j, 2]
    return bool(min(abs(one), abs(other)) > gap)


@kernel
def _do_overlap(rows: F64_2, i: int, j: int, same: float, is_near: bool, slope: float) -> bool:
    """Return whether the edges ``rows[i]`` and ``rows[j]`` overlap along more than ``same`` mm.

    ``rows`` (k, 5) are edges: x0, y0, x1, y1, bulge.  With ``is_near``, the ends of the edges may
    be farther apart than ``same`` if the edges are not.  ``slope`` is the sine of the greatest
    difference between the directions of two lines.
    """
    if (abs(rows[i, 4]) >= BULGE) != (abs(rows[j, 4]) >= BULGE):
        return False
    if size_of(rows, i) < size_of(rows, j):
        i, j = j, i
    length = size_of(rows, i)
    if abs(rows[i, 4]) < BULGE:
        dx = (rows[i, 2] - rows[i, 0]) / length
        dy = (rows[i, 3] - rows[i, 1]) / length
        wide = (rows[j, 3] - rows[j, 1]) * dx - (rows[j, 2] - rows[j, 0]) * dy
        if abs(wide) > size_of(rows, j) * slope:
            return False
        for end in range(2):
            x = rows[j, 2 * end] - rows[i, 0]
            y = rows[j, 2 * end + 1] - rows[i, 1]
            if abs(y * dx - x * dy) > same:
                return False
            if not is_near and _is_end_moved_too_far(
                rows, i, rows[j, 2 * end : 2 * end + 2], y * dx - x * dy, same
            ):
                return False
    else:
        cx, cy, radius, _ = circle_of(rows, i)
        mx, my = middle_of(rows, j)
        for x, y in ((rows[j, 0], rows[j, 1]), (rows[j, 2], rows[j, 3]), (mx, my)):
            if abs(math.hypot(x - cx, y - cy) - radius) > same:
                return False
        for end in range(2):
            point = rows[j, 2 * end : 2 * end + 2]
            across = math.hypot(point[0] - cx, point[1] - cy) - radius
            if not is_near and _is_end_moved_too_far(rows, i, point, across, same):
                return False
    low, high = range_of(rows, i, rows[j])
    return (min(high, 1.0) - max(low, 0.0)) * length > same


@kernel
def _is_end_moved_too_far(rows: F64_2, i: int, point: F64_1, across: float, same: float) -> bool:
    """Return whether the end of an edge is more than ``same`` mm away from an end of ``rows[i]``
    that would replace it.

    ``rows`` (k, 5): edges: x0, y0, x1, y1, bulge.
    ``point``: end of an edge that overlaps ``rows[i]`` (mm).
    ``across``: distance of the point from the line or the circle of ``rows[i]``, with any sign
    (mm).
    ``same``: two ends are one end if they are less than this apart along the edges (mm).
    """
    for end in range(2):
        x, y = point[0] - rows[i, 2 * end], point[1] - rows[i, 2 * end + 1]
        square = x * x + y * y
        if square > same * same and square - across * across < same * same:
            return True
    return False
