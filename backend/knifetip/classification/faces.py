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

from knifetip.classification.cutting import WORTH
from knifetip.classification.grid import Grid
from knifetip.classification.net import Net
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.cores import each, runs
from knifetip.geometry.sets import settle, unite

_BULGE: Final = 1e-9
#: Directions are told apart to so many parts of a right angle.
_FINE: Final = 10_000_000


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
    lines = (net.place, net.start, net.end, net.bulge, net.same)
    around, begins = _around(*lines)
    left, right, area = _walked(*lines, around, begins)
    part, leftmost = _parts(net.place, net.start, net.end)
    outside, owner = _owned(len(leftmost), part, left, right, area)
    hit = np.full(len(leftmost), -1, np.int32)

    def looked(run: tuple[int, int]) -> None:
        _look_left(
            ends, bulge, net.grid, net.place, net.first, net.share, part, left, right,
            leftmost, touch, hit, *run,
        )  # fmt: skip

    each(looked, runs(len(leftmost), WORTH))
    return Faces(left, right, part, area, outside, _within(hit, outside, owner))


@njit(cache=True, error_model="numpy")
def _angle(x: float, y: float) -> int:
    """A number that grows with the angle of a direction, the same for all that are nearly one."""
    across = abs(x) + abs(y)
    along = y / across if across > 0.0 else 0.0
    quarters = 2.0 - along if x < 0.0 else along + 4.0 if y < 0.0 else along
    return int(quarters * _FINE + 0.5) % (4 * _FINE)


@njit(cache=True, error_model="numpy")
def _around(place: Any, start: Any, end: Any, bent: Any, same: Any) -> Any:
    """Return the halves of pieces round each place against the clock, and where each place's begin.

    Half 2 p of piece p leaves its beginning, half 2 p + 1 its end.
    """
    pieces, places = len(start), len(place)
    begins = np.zeros(places + 1, np.int32)
    angle = np.empty(2 * pieces, np.int64)
    curve = np.empty(2 * pieces)
    for p in range(pieces):
        if same[p] != p:
            continue
        a, b = start[p], end[p]
        begins[a + 1] += 1
        begins[b + 1] += 1
        dx, dy = place[b, 0] - place[a, 0], place[b, 1] - place[a, 1]
        # Along the tangents: the chord, turned by a quarter of the sweep twice.
        square = bent[p] * bent[p]
        c, s = (1.0 - square) / (1.0 + square), 2.0 * bent[p] / (1.0 + square)
        angle[2 * p] = _angle(c * dx + s * dy, c * dy - s * dx)
        angle[2 * p + 1] = _angle(s * dy - c * dx, -c * dy - s * dx)
        chord = max(math.sqrt(dx * dx + dy * dy), 1e-300)
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
    return around, begins


@njit(cache=True, error_model="numpy")
def _walked(
    place: Any, start: Any, end: Any, bent: Any, same: Any, around: Any, begins: Any
) -> Any:
    """Return the faces on the left and on the right of each piece, and the area of each face."""
    pieces = len(start)
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
                    whole = 1.0 + bend * bend
                    sine = 4.0 * bend * (1.0 - bend * bend) / (whole * whole)
                    chord = (bx - ax) * (bx - ax) + (by - ay) * (by - ay)
                    square = chord * whole * whole / (16.0 * bend * bend)
                    twice += square * (4.0 * math.atan(bend) - sine)
                k = rank[walked ^ 1]
                k = k - 1 if k > begins[b] else begins[b + 1] - 1
                walked = around[k]
            area[count] = 0.5 * twice
            count += 1
    left = np.empty(pieces, np.int32)
    right = np.empty(pieces, np.int32)
    for p in range(pieces):
        q = same[p]
        turned = start[p] != start[q] or (start[p] == end[p] and bent[p] != bent[q])
        left[p] = face[2 * q + 1] if turned else face[2 * q]
        right[p] = face[2 * q] if turned else face[2 * q + 1]
    return left, right, area[:count].copy()


@njit(cache=True, error_model="numpy")
def _parts(place: Any, start: Any, end: Any) -> Any:
    """Return the connected part of each piece, and the leftmost place of each part."""
    pieces, places = len(start), len(place)
    parent = np.arange(places)
    for p in range(pieces):
        unite(parent, start[p], end[p])
    settle(parent)
    number = np.full(places, -1, np.int32)
    part = np.empty(pieces, np.int32)
    parts = 0
    leftmost = np.empty(places, np.int32)
    for p in range(pieces):
        root = parent[start[p]]
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
    return part, leftmost[:parts].copy()


@njit(cache=True, error_model="numpy")
def _owned(parts: int, part: Any, left: Any, right: Any, area: Any) -> Any:
    """Return the face that is the outside of each part, and the part of each face."""
    outside = np.full(parts, -1, np.int32)
    owner = np.empty(len(area), np.int32)
    for p in range(len(part)):
        for f in (left[p], right[p]):
            owner[f] = part[p]
            known = outside[part[p]]
            if known < 0 or area[f] < area[known]:
                outside[part[p]] = f
    return outside, owner


@njit(cache=True, error_model="numpy", nogil=True)
def _look_left(
    ends: Any, bulge: Any, grid: Grid, place: Any, first_piece: Any, share: Any, part: Any,
    left: Any, right: Any, leftmost: Any, touch: float, hit: Any, begin: int, end: int,
) -> None:  # fmt: skip
    """Write which face is met first to the left of the leftmost place of some parts."""
    low, size, side, first, listed = grid
    for c in range(begin, end):
        x, y = place[leftmost[c], 0], place[leftmost[c], 1] + 0.317 * touch
        line = min(max(int((y - low[1]) / size[1]), 0), side - 1)
        column = min(max(int((x - low[0]) / size[0]), 0), side - 1)
        best, found = -np.inf, -1
        while column >= 0:
            cell = line * side + column
            for k in range(first[cell], first[cell + 1]):
                i = listed[k]
                for root in range(1 if abs(bulge[i]) <= _BULGE else 2):
                    at, upward = _met(ends, bulge, i, y, root)
                    if best < at < x:
                        if first_piece[i] == first_piece[i + 1] or part[first_piece[i]] == c:
                            continue
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


@njit(cache=True, error_model="numpy")
def _within(hit: Any, outside: Any, owner: Any) -> Any:
    """Return the face that holds each part: what is met, or what holds the part that is met."""
    parts = len(hit)
    within = np.full(parts, -1, np.int32)
    known = np.zeros(parts, np.bool_)
    asked = np.empty(parts, np.int32)
    for c in range(parts):
        waiting = 0
        on, f = c, -1
        while not known[on]:
            asked[waiting] = on
            waiting += 1
            known[on] = True
            f = hit[on]
            if f < 0 or f != outside[owner[f]]:
                break
            on = owner[f]
            f = within[on]
        for k in range(waiting):
            within[asked[k]] = f
    return within


@njit(cache=True, error_model="numpy")
def _met(ends: Any, bulge: Any, i: int, y: float, root: int) -> tuple[float, bool]:
    """Where a level line meets a segment, NaN for nowhere, and whether that goes upward there."""
    ax, ay = ends[i, 0, 0], ends[i, 0, 1]
    bx, by = ends[i, 1, 0], ends[i, 1, 1]
    b = bulge[i]
    if abs(b) <= _BULGE:
        if (ay > y) == (by > y):
            return np.nan, False
        return ax + (y - ay) * (bx - ax) / (by - ay), by > ay
    off = y - 0.5 * (ay + by)
    if 4.0 * off * off > 1.000001 * ((bx - ax) * (bx - ax) + (by - ay) * (by - ay)):
        return np.nan, False
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
