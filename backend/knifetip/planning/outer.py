"""Outer: which cut edges bound the blanks, and which lie inside them.

Walk round every face of the net of cuts, always turning as sharply as one can.  The walk that goes
round a component from outside runs clockwise; an edge that it passes on one side only is outer,
unless the whole component lies inside another.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numba import njit

from knifetip.geometry import arc
from knifetip.geometry.chain import nodes, outward
from knifetip.geometry.columns import F64, I8, I64, Bool

_CHORDS = 16


def outer(ends: F64, bulge: F64) -> Bool:
    """Return which edges bound a blank from outside, (n,).

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Cut edges of any order and direction.
    """
    bounding: Bool = outside(ends, bulge) != 0
    return bounding


def outside(ends: F64, bulge: F64) -> I8:
    """Return on which side of each edge the waste round a blank lies, (n,).

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Cut edges of any order and direction.

    Returns
    -------
    (n,) +1 left of the way from start to end, -1 right, 0 where the edge bounds no blank
    """
    count = len(ends)
    if count == 0:
        return np.zeros(0, np.int8)
    node = nodes(ends.reshape(-1, 2)).astype(np.int64)
    direction = outward(ends, bulge).reshape(-1, 2)
    # Arcs that leave a place in one direction are told apart by the side to which they bend.
    bend = np.stack([bulge, -bulge], axis=1).ravel()
    angle = np.round(np.arctan2(direction[:, 1], direction[:, 0]), 9)
    ordered = np.lexsort((bend, angle, node))
    sorted_node = node[ordered]
    low = np.searchsorted(sorted_node, sorted_node, side="left")
    high = np.searchsorted(sorted_node, sorted_node, side="right")
    rank = np.empty(2 * count, np.int64)
    rank[ordered] = np.arange(2 * count)
    # Half-edge h leaves from end h; it arrives at h ^ 1 and goes on with the next end clockwise.
    arrived = rank[np.arange(2 * count) ^ 1]
    onward = np.where(arrived > low[arrived], arrived - 1, high[arrived] - 1)
    face = _cycles(ordered[onward])
    start = ends.reshape(-1, 2)
    end = ends[:, ::-1].reshape(-1, 2)
    bent = np.stack([bulge, -bulge], axis=1).ravel()
    area = np.bincount(face, _area(start, end, bent), minlength=2 * count)
    # A tree of slits encloses nothing: its one face has no area.
    faces = (area < 1e-6)[face].reshape(-1, 2)
    bounding: Bool = faces[:, 0] != faces[:, 1]
    rows = np.flatnonzero(bounding)
    component = np.where(faces[rows, 0], face[2 * rows], face[2 * rows + 1])
    inside = _enclosed(ends[rows], bulge[rows], np.unique(component, return_inverse=True)[1])
    bounding[rows] = ~inside
    # The walk round a blank from outside has the waste on its left.
    return np.where(bounding, np.where(faces[:, 0], 1, -1), 0).astype(np.int8)


def _cycles(onward: I64) -> I64:
    """Name each cycle of a permutation by its least member."""
    label = np.arange(len(onward))
    jump = onward.copy()
    for _ in range(max(1, math.ceil(math.log2(len(onward) + 1)))):
        label = np.minimum(label, label[jump])
        jump = jump[jump]
    return label


def _area(start: F64, end: F64, bulge: F64) -> F64:
    """Twice the area that each half-edge sweeps about the origin, with the segment of its arc."""
    cross = start[:, 0] * end[:, 1] - start[:, 1] * end[:, 0]
    sweep = arc.sweep(bulge)
    radius = arc.radius(start, end, bulge)
    square = np.where(np.isfinite(radius), radius, 0.0) ** 2
    result: F64 = cross + square * (sweep - np.sin(sweep))
    return result


def _enclosed(ends: F64, bulge: F64, component: I64) -> Bool:
    """Return for each edge whether its component lies inside another one's boundary."""
    points = arc.points_along(ends[:, 0], ends[:, 1], bulge, _CHORDS + 1)
    size = component.max() + 1 if len(component) else 0
    probe = np.zeros((size, 2))
    probe[component[::-1]] = points[::-1, _CHORDS // 2]
    boxes = np.empty((size, 4))
    boxes[:, :2] = np.inf
    boxes[:, 2:] = -np.inf
    np.minimum.at(boxes[:, :2], component, points.min(axis=1))
    np.maximum.at(boxes[:, 2:], component, points.max(axis=1))
    order = np.argsort(component, kind="stable")
    first = np.searchsorted(component[order], np.arange(size + 1))
    inside = _inside(probe, boxes, points[order], first)
    result: Bool = inside[component]
    return result


@njit(cache=True)
def _inside(probe: Any, boxes: Any, points: Any, first: Any) -> Any:
    inside = np.zeros(len(probe), np.bool_)
    for i in range(len(probe)):
        x = probe[i, 0]
        y = probe[i, 1]
        for j in range(len(probe)):
            if i == j or x < boxes[j, 0] or y < boxes[j, 1] or x > boxes[j, 2] or y > boxes[j, 3]:
                continue
            odd = False
            for edge in range(first[j], first[j + 1]):
                for k in range(points.shape[1] - 1):
                    ay = points[edge, k, 1]
                    by = points[edge, k + 1, 1]
                    if (ay > y) != (by > y):
                        ax = points[edge, k, 0]
                        bx = points[edge, k + 1, 0]
                        if x < ax + (y - ay) * (bx - ax) / (by - ay):
                            odd = not odd
            if odd:
                inside[i] = True
                break
    return inside
