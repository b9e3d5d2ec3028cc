"""chords_on_arcs: find lines that are chords of arcs in the same place.

Many files contain a circle twice: once as a circle, and once as a polygon.  A line is a chord of an
arc if both of its ends and its midpoint are within a distance of the arc's circle, and the line has
nearly the direction of the arc there.  A line of at most 0.02 mm may have any direction: that of
coordinates with two decimals.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.cleaning.edge_parameter import circle_of, range_of, size_of
from knifetip.geometry.capacity import reserve_i64_2
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.spatial_index.box_tree import (
    build_tree,
    new_stack,
    next_overlap,
    start_query,
)
from knifetip.geometry.spatial_index.morton import order_boxes
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_2, I64_1, kernel

#: An arc is searched in parts of about this length (mm), but at most so many.
_PART: Final = 10.0
_MOST_PARTS: Final = 32
#: Largest number of parts of arcs that are examined for a line.
_LOOKS: Final = 256
#: A shorter line may have any direction (mm), beside an arc of at least this length (mm): a shorter
#: arc may be one of the same curve.
_ROUNDED: Final = 0.0201
_LONG: Final = 0.5
#: Sine of the largest angle between a chord and the arc.
_SLOPE: Final = math.sin(math.radians(20.0))


def find_chords(rows: F64, gap: float) -> tuple[I64, I64]:
    """Return the pairs of a line and an arc of which it is a chord, (p,) and (p,).

    A pair may be returned more than once.

    Parameters
    ----------
    rows : (k, 5)
        Edges: x0, y0, x1, y1 (mm), bulge.
    gap
        Largest distance of a chord from the arc (mm).
    """
    none = np.zeros(0, np.int64)
    bent = np.abs(rows[:, 4]) >= BULGE
    arcs, lines = np.flatnonzero(bent), np.flatnonzero(~bent)
    if len(arcs) == 0 or len(lines) == 0:
        return none, none
    boxes, arc = _part_boxes(rows, arcs, gap)
    order = order_boxes(boxes)
    found = _find(rows, lines, boxes[order], arc[order], gap)
    return found[:, 0].copy(), found[:, 1].copy()


@kernel
def _part_boxes(rows: F64_2, arcs: I64_1, gap: float) -> Any:
    """Return the bounding boxes of parts of arcs, enlarged by ``gap`` mm, (m, 4), and the arc of
    each part, (m,).
    """
    count = 0
    for arc in arcs:
        count += min(int(size_of(rows, arc) / _PART) + 1, _MOST_PARTS)
    boxes, owner = np.empty((count, 4)), np.empty(count, np.int64)
    at = 0
    for arc in arcs:
        parts = min(int(size_of(rows, arc) / _PART) + 1, _MOST_PARTS)
        cx, cy, radius, sweep = circle_of(rows, arc)
        first = math.atan2(rows[arc, 1] - cy, rows[arc, 0] - cx)
        step = sweep / parts
        margin = gap + radius * (1.0 - math.cos(0.25 * step))
        for part in range(parts):
            boxes[at, 0], boxes[at, 1], boxes[at, 2], boxes[at, 3] = (
                np.inf,
                np.inf,
                -np.inf,
                -np.inf,
            )
            for half in range(3):
                angle = first + (part + 0.5 * half) * step
                x, y = cx + radius * math.cos(angle), cy + radius * math.sin(angle)
                boxes[at, 0], boxes[at, 1] = min(boxes[at, 0], x), min(boxes[at, 1], y)
                boxes[at, 2], boxes[at, 3] = max(boxes[at, 2], x), max(boxes[at, 3], y)
            boxes[at, 0] -= margin
            boxes[at, 1] -= margin
            boxes[at, 2] += margin
            boxes[at, 3] += margin
            owner[at] = arc
            at += 1
    return boxes, owner


@kernel
def _find(rows: F64_2, lines: I64_1, boxes: F64_2, arc: I64_1, gap: float) -> Any:
    """Return the pairs of a line and an arc, (p, 2); see ``find_chords``.

    ``boxes`` (m, 4) are bounding boxes of parts of arcs, and ``arc`` (m,) the arc of each.
    """
    found = np.empty((64, 2), np.int64)
    size = 0
    tree, stack = build_tree(boxes), new_stack()
    for line in lines:
        x0, y0, x1, y1 = rows[line, 0], rows[line, 1], rows[line, 2], rows[line, 3]
        depth = start_query(tree, stack)
        last = -1
        for _ in range(_LOOKS):
            # A chord lies in the boxes in which its midpoint is.
            x, y = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
            at, depth = next_overlap(tree.boxes, tree.level, stack, depth, (x, y, x, y), -1)
            if at < 0:
                break
            on = arc[at]
            if on != last and is_chord(rows, on, line, gap):
                found = reserve_i64_2(found, size + 1)
                found[size, 0], found[size, 1] = line, on
                size += 1
                last = on
    return found[:size].copy()


@kernel
def is_chord(rows: F64_2, arc: int, line: int, gap: float) -> bool:
    """Return whether the line ``rows[line]`` is a chord of ``rows[arc]``, within ``gap`` mm."""
    cx, cy, radius, _ = circle_of(rows, arc)
    x0, y0, x1, y1 = rows[line, 0], rows[line, 1], rows[line, 2], rows[line, 3]
    first, last = math.hypot(x0 - cx, y0 - cy), math.hypot(x1 - cx, y1 - cy)
    middle = math.hypot(0.5 * (x0 + x1) - cx, 0.5 * (y0 + y1) - cy)
    if max(abs(first - radius), abs(last - radius), abs(middle - radius)) > gap:
        return False
    # A line through the middle of a small circle is near it, too.
    if middle < 0.5 * radius:
        return False
    length = size_of(rows, line)
    low, high = range_of(rows, arc, rows[line])
    if length < _ROUNDED and size_of(rows, arc) >= _LONG and low >= 0.0 and high <= 1.0:
        return True
    if abs(last - first) > _SLOPE * length:
        return False
    return (min(high, 1.0) - max(low, 0.0)) * size_of(rows, arc) > min(gap, 0.5 * length)
