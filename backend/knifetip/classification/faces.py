"""faces: what lies on the two sides of each piece of a net, and which part lies inside which.

    Net -> Faces

Walk from each piece always as sharply to the right as one can: the face on the left is walked round
against the clock, the outside of a connected part with it.  A part lies inside the face that is met
first on the way left from its leftmost place.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numba import njit

from knifetip.classification.net import Net
from knifetip.geometry.columns import F64, I32

_BULGE: Final = 1e-9


@dataclass(frozen=True, eq=False, slots=True)
class Faces:
    """p pieces, f faces, c connected parts."""

    left: I32  #: (p,) the face on the left of each piece
    right: I32  #: (p,)
    part: I32  #: (p,) the connected part that it belongs to
    area: F64  #: (f,) > 0, or ≤ 0 for the outside of a part
    outside: I32  #: (c,) the face that is the outside of each part
    within: I32  #: (c,) the face that holds it, -1 for none


def faces(net: Net, ends: F64, bulge: F64, touch: float) -> Faces:
    """Return the faces of a net of n edges, (n, 2, 2) and (n,)."""
    grid = net.grid
    return Faces(
        *_faces(
            net.place, net.start, net.end, net.bulge, net.share, net.first, net.same,
            ends, bulge, touch, grid.low, grid.size, grid.side, grid.first, grid.listed,
        )
    )  # fmt: skip


@njit(cache=True, error_model="numpy")
def _root(parent: Any, i: int) -> int:
    while parent[i] != i:
        parent[i] = parent[parent[i]]
        i = parent[i]
    return i


@njit(cache=True, error_model="numpy")
def _faces(
    place: Any, start: Any, end: Any, bent: Any, share: Any, first_piece: Any, same: Any,
    ends: Any, bulge: Any, touch: float, low: Any, size: Any, side: int, first: Any, listed: Any,
) -> Any:  # fmt: skip
    pieces, places = len(start), len(place)
    begins = np.zeros(places + 1, np.int32)
    angle = np.empty(2 * pieces)
    curve = np.empty(2 * pieces)
    for p in range(pieces):
        if same[p] != p:
            continue
        a, b = start[p], end[p]
        begins[a + 1] += 1
        begins[b + 1] += 1
        dx, dy = place[b, 0] - place[a, 0], place[b, 1] - place[a, 1]
        turn = 2.0 * math.atan(bent[p])
        forth, back = math.atan2(dy, dx) - turn, math.atan2(-dy, -dx) + turn
        angle[2 * p] = round(forth % (2.0 * math.pi), 7)
        angle[2 * p + 1] = round(back % (2.0 * math.pi), 7)
        chord = max(math.hypot(dx, dy), 1e-300)
        curve[2 * p] = bent[p] / chord
        curve[2 * p + 1] = -bent[p] / chord
    begins = np.cumsum(begins).astype(np.int32)
    around = np.empty(begins[-1], np.int32)
    put = begins[:-1].copy()
    for p in range(pieces):
        if same[p] != p:
            continue
        for half in range(2 * p, 2 * p + 2):
            at = start[p] if half % 2 == 0 else end[p]
            k = put[at]
            put[at] += 1
            while k > begins[at]:
                other = around[k - 1]
                if angle[other] < angle[half] or (
                    angle[other] == angle[half] and curve[other] <= curve[half]
                ):
                    break
                around[k] = other
                k -= 1
            around[k] = half
    rank = np.empty(2 * pieces, np.int32)
    for k in range(len(around)):
        rank[around[k]] = k
    face = np.full(2 * pieces, -1, np.int32)
    area = np.empty(2 * pieces)
    count = 0
    for p in range(pieces):
        if same[p] != p:
            continue
        for half in range(2 * p, 2 * p + 2):
            if face[half] >= 0:
                continue
            walked = half
            twice = 0.0
            x0, y0 = place[start[p], 0], place[start[p], 1]
            while face[walked] < 0:
                face[walked] = count
                q = walked // 2
                a, b = start[q], end[q]
                bend = bent[q]
                if walked % 2 == 1:
                    a, b, bend = b, a, -bend
                ax, ay = place[a, 0] - x0, place[a, 1] - y0
                bx, by = place[b, 0] - x0, place[b, 1] - y0
                twice += ax * by - ay * bx
                if abs(bend) > _BULGE:
                    sweep = 4.0 * math.atan(bend)
                    radius = math.hypot(bx - ax, by - ay) / (2.0 * math.sin(0.5 * sweep))
                    twice += radius * radius * (sweep - math.sin(sweep))
                k = rank[walked ^ 1]
                k = k - 1 if k > begins[b] else begins[b + 1] - 1
                walked = around[k]
            area[count] = 0.5 * twice
            count += 1
    # Connected parts.
    parent = np.arange(places)
    for p in range(pieces):
        a, b = _root(parent, start[p]), _root(parent, end[p])
        parent[max(a, b)] = min(a, b)
    number = np.full(places, -1, np.int32)
    part = np.empty(pieces, np.int32)
    parts = 0
    leftmost = np.empty(places, np.int32)
    for p in range(pieces):
        root = _root(parent, start[p])
        if number[root] < 0:
            number[root] = parts
            leftmost[parts] = start[p]
            parts += 1
        own = number[root]
        part[p] = own
        if place[start[p], 0] < place[leftmost[own], 0]:
            leftmost[own] = start[p]
        if place[end[p], 0] < place[leftmost[own], 0]:
            leftmost[own] = end[p]
    left = np.empty(pieces, np.int32)
    right = np.empty(pieces, np.int32)
    outside = np.full(parts, -1, np.int32)
    owner = np.empty(count, np.int32)
    for p in range(pieces):
        q = same[p]
        turned = start[p] != start[q] or (start[p] == end[p] and bent[p] != bent[q])
        left[p] = face[2 * q + 1] if turned else face[2 * q]
        right[p] = face[2 * q] if turned else face[2 * q + 1]
        for f in (left[p], right[p]):
            owner[f] = part[p]
            known = outside[part[p]]
            if known < 0 or area[f] < area[known]:
                outside[part[p]] = f
    # Which face holds each part: the first edge of another part to the left of its leftmost place.
    hit = np.full(parts, -1, np.int32)
    for c in range(parts):
        x, y = place[leftmost[c], 0], place[leftmost[c], 1] + 0.317 * touch
        line = min(max(int((y - low[1]) / size[1]), 0), side - 1)
        column = min(max(int((x - low[0]) / size[0]), 0), side - 1)
        best, found = -np.inf, -1
        while column >= 0:
            cell = line * side + column
            for k in range(first[cell], first[cell + 1]):
                i = listed[k]
                if first_piece[i] == first_piece[i + 1] or part[first_piece[i]] == c:
                    continue
                for root in range(2):
                    at, upward = _met(ends, bulge, i, y, root)
                    if at == at and best < at < x:
                        best = at
                        p = first_piece[i]
                        where = _share(ends, bulge, i, at, y)
                        while p + 1 < first_piece[i + 1] and share[p + 1] <= where:
                            p += 1
                        found = right[p] if upward else left[p]
            if found >= 0 and best >= low[0] + column * size[0]:
                break
            column -= 1
        hit[c] = found
    within = np.full(parts, -1, np.int32)
    for c in range(parts):
        f = hit[c]
        for _ in range(parts):
            if f < 0 or f != outside[owner[f]]:
                break
            f = hit[owner[f]]
        within[c] = f if f >= 0 and f != outside[owner[f]] else -1
    return left, right, part, area[:count].copy(), outside, within


@njit(cache=True, error_model="numpy")
def _met(ends: Any, bulge: Any, i: int, y: float, root: int) -> tuple[float, bool]:
    """Where a level line meets a segment, NaN for nowhere, and whether that goes upward there."""
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    bx, by = ends[i, 1, 0], ends[i, 1, 1]
    b = bulge[i]
    if abs(b) <= _BULGE:
        if root == 1 or (ay > y) == (by > y):
            return np.nan, False
        return ax + (y - ay) * (bx - ax) / (by - ay), by > ay
    up = (1.0 - b * b) / (4.0 * b)
    cx = 0.5 * (ax + bx) - up * (by - ay)
    cy = 0.5 * (ay + by) + up * (bx - ax)
    square = (ax - cx) ** 2 + (ay - cy) ** 2 - (y - cy) ** 2
    if square <= 0.0:
        return np.nan, False
    half = math.sqrt(square) if root == 1 else -math.sqrt(square)
    turn = math.atan2(y - cy, half) - math.atan2(ay - cy, ax - cx)
    if b < 0.0:
        turn = -turn
    if turn % (2.0 * math.pi) > 4.0 * abs(math.atan(b)):
        return np.nan, False
    return cx + half, (half > 0.0) == (b > 0.0)


@njit(cache=True, error_model="numpy")
def _share(ends: Any, bulge: Any, i: int, x: float, y: float) -> float:
    """At which share of a segment a point on it lies."""
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    dx, dy = ends[i, 1, 0] - ax, ends[i, 1, 1] - ay
    b = bulge[i]
    if abs(b) <= _BULGE:
        along: float = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)
        return along
    up = (1.0 - b * b) / (4.0 * b)
    cx = ax + 0.5 * dx - up * dy
    cy = ay + 0.5 * dy + up * dx
    turn = math.atan2(y - cy, x - cx) - math.atan2(ay - cy, ax - cx)
    if b < 0.0:
        turn = -turn
    return (turn % (2.0 * math.pi)) / (4.0 * abs(math.atan(b)))
