"""Outer: which cut edges bound the blanks, and which lie inside them.

Walk round every face of the net of cuts, always turning as sharply as one can.  The walk that goes
round a component from outside runs clockwise; an edge that it passes on one side only is outer,
unless the whole component lies inside another.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numba import njit

from knifetip.geometry import arc
from knifetip.geometry.chain import nodes, outward
from knifetip.geometry.columns import F64, I8, I64, Bool
from knifetip.geometry.sets import settle, unite
from knifetip.geometry.tolerance import JOIN
from knifetip.planning.near import near

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
    return faces(ends, bulge).side


@dataclass(frozen=True, eq=False, slots=True)
class Faces:
    """What lies on the two sides of n cuts."""

    side: I8  #: (n,) of the waste round a blank: +1 left, -1 right, 0 where it bounds none
    face: I64  #: (n,) the blank or the hole that the cut goes round, -1 for what closes nothing
    shared: Bool  #: (n,) a blank lies on either side, and not the same


def faces(ends: F64, bulge: F64) -> Faces:
    """Return what lies on the two sides of each cut.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Cut edges of any order and direction.
    """
    count = len(ends)
    if count == 0:
        return Faces(np.zeros(0, np.int8), np.zeros(0, np.int64), np.zeros(0, np.bool_))
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
    empty = (area < 1e-6)[face].reshape(-1, 2)
    face = face.reshape(-1, 2)
    closing: Bool = empty[:, 0] != empty[:, 1]
    rows = np.flatnonzero(closing)
    component = _components(node.reshape(-1, 2))
    within = np.zeros(count, np.bool_)
    name = np.unique(component[rows], return_inverse=True)[1]
    within[component[rows]] = _enclosed(ends[rows], bulge[rows], name)
    inside = within[component]
    return Faces(
        # The walk round a blank from outside has the waste on its left.
        np.where(closing & ~inside, np.where(empty[:, 0], 1, -1), 0).astype(np.int8),
        np.where(closing, np.where(empty[:, 0], face[:, 1], face[:, 0]), -1),
        ~empty.any(axis=1) & (face[:, 0] != face[:, 1]) & ~inside,
    )


def noded(ends: F64, bulge: F64) -> tuple[F64, F64, I64]:
    """Return cuts parted where others end on them, and the row of each part.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
    """
    points = ends.reshape(-1, 2)
    end, row = near(np.hstack([points, points]), arc.bounds(ends[:, 0], ends[:, 1], bulge), JOIN)
    whole = ends[row, 0], ends[row, 1], bulge[row]
    share = arc.nearest(*whole, points[end])
    on = np.hypot(*(arc.point_at(*whole, share) - points[end]).T) <= JOIN
    for side in range(2):
        on &= np.hypot(*(points[end] - ends[row, side]).T) > JOIN
    end, row, share = end[on], row[on], share[on]
    rows = np.concatenate([np.arange(len(ends)), row])
    low = np.concatenate([np.zeros(len(ends)), share])
    begin = np.concatenate([ends[:, 0], points[end]])
    order = np.lexsort((low, rows))
    rows, low, begin = rows[order], low[order], begin[order]
    last = np.append(rows[1:] != rows[:-1], True)
    high = np.where(last, 1.0, np.roll(low, -1))
    finish = np.where(last[:, None], ends[rows, 1], np.roll(begin, -1, axis=0))
    some = np.hypot(*(finish - begin).T) > JOIN
    # A whole edge stays as it is drawn, however short.
    some |= (low == 0.0) & (high == 1.0)
    bent = np.tan(np.arctan(bulge[rows]) * (high - low))
    return np.stack([begin, finish], axis=1)[some], bent[some], rows[some]


@njit(cache=True)
def _components(node: Any) -> Any:
    """Return for edges between nodes, (n, 2), the least edge that each hangs together with."""
    parent = np.arange(len(node))
    seen = np.full(2 * len(node), -1)
    for edge in range(len(node)):
        for end in range(2):
            other = seen[node[edge, end]]
            if other < 0:
                seen[node[edge, end]] = edge
                continue
            unite(parent, edge, other)
    settle(parent)
    return parent


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
