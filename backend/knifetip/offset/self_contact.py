"""self_contact: find segments of an offset path that have a common point.

Segments are compared only if their bounding boxes overlap.  In a short path, each box is compared
with the box two rows later, then with the box three rows later, and so on; each of these steps
compares whole columns, which takes few instructions.  In a long path, a tree of the boxes finds the
overlaps.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.geometry.intersect import TOUCH, intersect_rows
from knifetip.geometry.spatial_index.box_tree import (
    build_tree,
    new_stack,
    next_overlap,
    start_query,
)
from knifetip.kernels import (
    F64_1,
    F64_2,
    Bool_1,
    OutF64_2,
    kernel,
)
from knifetip.offset.records import Segment

#: Largest number of rows for which all pairs of boxes are compared; above it a tree is used.
MAX_PAIRWISE: Final = 256
#: Number of rows of a block, if all pairs are compared.
BLOCK_ROWS: Final = 4


class CheckedSegments(NamedTuple):
    """Columns of m segments that are searched for two segments with a common point."""

    start: F64_2  #: (m, 2) mm
    end: F64_2  #: (m, 2) mm
    bulge: F64_1  #: (m,)
    inserted: Bool_1  #: (m,) whether each segment belongs to a transition


class Scratch(NamedTuple):
    """Scratch arrays for one path: two of its segments, a transition, and bounding boxes."""

    pair: OutF64_2  #: (4, 5) rows of segments: x0, y0, x1, y1, bulge
    crossings: OutF64_2  #: (4, 4) common points: x, y and the parameters on both segments
    boxes: OutF64_2  #: (4, m) x0, y0, x1 and y1 of boxes; m ≥ 1.5 times the segments of a path


@kernel(allocates=False)
def _count_overlaps(x0: F64_1, y0: F64_1, x1: F64_1, y1: F64_1, count: int, step: int) -> int:
    """Return how many of the first ``count`` boxes overlap the box that is ``step`` rows later.

    ``x0``, ``y0``, ``x1`` and ``y1`` are the least and the greatest coordinates of the boxes, which
    are the bounding boxes of segments.
    """
    ahead_x0 = x0[step : step + count]
    ahead_y0 = y0[step : step + count]
    ahead_x1 = x1[step : step + count]
    ahead_y1 = y1[step : step + count]
    hits = 0
    for i in range(count):
        hits += (
            (ahead_x0[i] <= x1[i])
            & (x0[i] <= ahead_x1[i])
            & (ahead_y0[i] <= y1[i])
            & (y0[i] <= ahead_y1[i])
        )
    return hits


@kernel(allocates=False)
def _separated_across_chord(segment_a: Segment, segment_b: Segment) -> bool:
    """Return whether two segments are separated by a line parallel to the chord of the first.

    Both bulges are at most 1: an arc of up to half a turn is replaced by the rectangle of its chord
    and its height.
    """
    x0, y0, x1, y1, b = segment_a
    ox, oy, ex, ey, other_bulge = segment_b
    dx = x1 - x0
    dy = y1 - y0
    rise = -0.5 * b * (dx * dx + dy * dy)
    fx = ex - ox
    fy = ey - oy
    near = dx * (oy - y0) - dy * (ox - x0)
    far = dx * (ey - y0) - dy * (ex - x0)
    lift = -0.5 * other_bulge * (dx * fx + dy * fy)
    low = min(near, far) + min(lift, 0.0)
    high = max(near, far) + max(lift, 0.0)
    slack = TOUCH * (abs(dx) + abs(dy))
    return low > max(rise, 0.0) + slack or high < min(rise, 0.0) - slack


@kernel(allocates=False)
def cannot_meet(segment_a: Segment, segment_b: Segment) -> bool:
    """Return whether the rectangles around two segments prove that they have no common point."""
    if abs(segment_a.bulge) > 1.0 or abs(segment_b.bulge) > 1.0:
        return False
    return _separated_across_chord(segment_a, segment_b) or _separated_across_chord(
        segment_b, segment_a
    )


@kernel(allocates=False)
def _segments_meet(
    segments: CheckedSegments, i: int, j: int, round_corner: bool, scratch: Scratch
) -> bool:
    """Return whether segments i and j, whose bounding boxes overlap, have a common point.

    ``round_corner`` states whether exactly one segment is between i and j, and this segment is a
    transition at a convex corner.  Then two lines cannot meet.  ``scratch`` are scratch arrays.
    """
    start, end, bulge, pair = segments.start, segments.end, segments.bulge, scratch.pair
    if round_corner and bulge[i] == 0.0 and bulge[j] == 0.0:
        # Two lines at a convex corner diverge.
        return False
    one = Segment(start[i, 0], start[i, 1], end[i, 0], end[i, 1], bulge[i])
    other = Segment(start[j, 0], start[j, 1], end[j, 0], end[j, 1], bulge[j])
    if cannot_meet(one, other):
        return False
    pair[0, 0], pair[0, 1], pair[0, 2], pair[0, 3], pair[0, 4] = one
    pair[1, 0], pair[1, 1], pair[1, 2], pair[1, 3], pair[1, 4] = other
    return bool(intersect_rows(pair, 0, pair, 1, TOUCH, scratch.crossings) > 0)


@kernel(allocates=False)
def write_box_columns(segments: CheckedSegments, low: int, high: int, boxes: OutF64_2) -> None:
    """Write x0, y0, x1 and y1 of the bounding boxes of the segments low … high - 1 to ``boxes``.

    Each box is enlarged by ``TOUCH`` (mm) on all sides.
    """
    start, end, bulge, _ = segments
    x0, y0, x1, y1 = boxes[0], boxes[1], boxes[2], boxes[3]
    for i in range(low, high):
        sx, sy, ex, ey, b = start[i, 0], start[i, 1], end[i, 0], end[i, 1], bulge[i]
        column = i - low
        if abs(b) <= 1.0:
            # An arc of up to half a turn lies in the rectangle of its chord and its height.
            rise_x = 0.5 * b * (ey - sy)
            rise_y = 0.5 * b * (sx - ex)
            x0[column] = min(sx, ex) + min(rise_x, 0.0) - TOUCH
            y0[column] = min(sy, ey) + min(rise_y, 0.0) - TOUCH
            x1[column] = max(sx, ex) + max(rise_x, 0.0) + TOUCH
            y1[column] = max(sy, ey) + max(rise_y, 0.0) + TOUCH
        else:
            lean = (1.0 - b * b) / (4.0 * b)
            cx = 0.5 * (sx + ex) - lean * (ey - sy)
            cy = 0.5 * (sy + ey) + lean * (ex - sx)
            radius = np.hypot(sx - cx, sy - cy) * (1.0 + 1e-12) + TOUCH
            x0[column] = cx - radius
            y0[column] = cy - radius
            x1[column] = cx + radius
            y1[column] = cy + radius


@kernel(allocates=False)
def path_meets_itself(segments: CheckedSegments, low: int, high: int, scratch: Scratch) -> bool:
    """Return whether two segments of a closed path that are not neighbours have a common point.

    The path has the segments low … high - 1.
    """
    inserted, boxes = segments.inserted, scratch.boxes
    count = high - low
    x0, y0, x1, y1 = boxes[0], boxes[1], boxes[2], boxes[3]
    if count < 4:
        return False
    write_box_columns(segments, low, high, boxes)
    if count > MAX_PAIRWISE:
        first, _ = _find_contact(segments, low, high, 2, boxes, scratch)
        return bool(first >= 0)
    half = count // 2
    near = min(half, 2 * BLOCK_ROWS - 1)
    for i in range(near):
        x0[count + i] = x0[i]
        y0[count + i] = y0[i]
        x1[count + i] = x1[i]
        y1[count + i] = y1[i]
    for step in range(2, near + 1):
        if _count_overlaps(x0, y0, x1, y1, count, step) == 0:
            continue
        for i in range(count):
            at = i + step
            if x0[at] <= x1[i] and x0[i] <= x1[at] and y0[at] <= y1[i] and y0[i] <= y1[at]:
                j = at if at < count else at - count
                middle = low + (i + 1 if i + 1 < count else 0)
                round_corner = step == 2 and inserted[middle]
                if _segments_meet(segments, low + i, low + j, round_corner, scratch):
                    return True
    if near == half:
        return False
    # Rows farther apart are compared by blocks, whose boxes follow those of the rows.
    blocks = (count + BLOCK_ROWS - 1) // BLOCK_ROWS
    for a in range(blocks):
        at = count + a
        begin = a * BLOCK_ROWS
        x0[at], y0[at], x1[at], y1[at] = x0[begin], y0[begin], x1[begin], y1[begin]
        for i in range(begin + 1, min(begin + BLOCK_ROWS, count)):
            x0[at] = min(x0[at], x0[i])
            y0[at] = min(y0[at], y0[i])
            x1[at] = max(x1[at], x1[i])
            y1[at] = max(y1[at], y1[i])
    for a in range(count, count + blocks - 2):
        for c in range(a + 2, count + blocks - (a == count)):
            if x0[c] > x1[a] or x0[a] > x1[c] or y0[c] > y1[a] or y0[a] > y1[c]:
                continue
            one = (a - count) * BLOCK_ROWS
            two = (c - count) * BLOCK_ROWS
            for i in range(one, one + BLOCK_ROWS):
                for j in range(two, min(two + BLOCK_ROWS, count)):
                    if x0[j] > x1[i] or x0[i] > x1[j] or y0[j] > y1[i] or y0[i] > y1[j]:
                        continue
                    if _segments_meet(segments, low + i, low + j, False, scratch):
                        return True
    return False


@kernel
def any_segments_meet(start: F64_2, end: F64_2, bulge: F64_1, scratch: Scratch) -> bool:
    """Return whether any two of n segments have a common point.

    ``start``, ``end`` (n, 2) mm and ``bulge`` (n,) are the segments; ``scratch`` are scratch
    arrays.
    """
    count = len(bulge)
    boxes = np.empty((4, count))
    segments = CheckedSegments(start, end, bulge, np.zeros(count, np.bool_))
    write_box_columns(segments, 0, count, boxes)
    first, _ = _find_contact(segments, 0, count, 1, boxes, scratch)
    return bool(first >= 0)


@kernel
def find_self_contact(
    start: F64_2, end: F64_2, bulge: F64_1, low: int, high: int
) -> tuple[int, int, float, float]:
    """Return two segments of a closed path that are not neighbours but have a common point.

    Parameters
    ----------
    start, end, bulge : (n, 2), (n, 2) mm and (n,)
        Segments of all paths.
    low, high
        The path has the segments low … high - 1.

    Returns
    -------
    one, two
        Indices of the two segments; ``one`` is -1 if there is no such pair.
    x, y : mm
        The common point.
    """
    boxes = np.empty((4, high - low))
    segments = CheckedSegments(start, end, bulge, np.zeros(high, np.bool_))
    write_box_columns(segments, low, high, boxes)
    found = np.empty((4, 4))
    scratch = Scratch(np.empty((2, 5)), found, boxes)
    one, two = _find_contact(segments, low, high, 2, boxes, scratch)
    return low + one if one >= 0 else -1, low + two, found[0, 0], found[0, 1]


@kernel
def _find_contact(
    segments: CheckedSegments, low: int, high: int, step: int, columns: F64_2, scratch: Scratch
) -> tuple[int, int]:
    """Return two of the segments low … high - 1 that have a common point, or -1 and -1.

    The returned indices are counted from ``low``; they differ by at least ``step``.  With ``step``
    2 the segments are a closed path, whose first and last segment are neighbours.  ``columns``
    (4, m) has the bounding boxes of the segments.
    """
    count = high - low
    boxes = np.empty((count, 4))
    for i in range(count):
        for side in range(4):
            boxes[i, side] = columns[side, i]
    tree, stack = build_tree(boxes), new_stack()
    for i in range(count - step):
        depth = start_query(tree, stack)
        while True:
            box = (boxes[i, 0], boxes[i, 1], boxes[i, 2], boxes[i, 3])
            j, depth = next_overlap(tree.boxes, tree.level, stack, depth, box, i + step - 1)
            if j < 0:
                break
            if step == 2 and i == 0 and j == count - 1:
                continue
            round_corner = step == 2 and j == i + 2 and segments.inserted[low + i + 1]
            if _segments_meet(segments, low + i, low + j, round_corner, scratch):
                return i, j
    return -1, -1
