"""faces: what lies on the two sides of each piece of a net.

    Net -> Faces

Walk from each piece always as sharply to the right as one can: the face on the left is walked round
against the clock, the outside of a connected part with it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.classification.nesting import held, looked_left
from knifetip.classification.net import Net
from knifetip.classification.segment import BULGE
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.cores import both
from knifetip.kernels import F64_1, F64_2, I32_1, kernel

#: Directions are told apart to so many parts of a right angle.
_FINE: Final = 10_000_000


@dataclass(frozen=True, eq=False, slots=True)
class Faces:
    """p pieces, f faces, c connected parts."""

    left: I32  #: (p,) the face on the left of each piece
    right: I32  #: (p,)
    area: F64  #: (f,) > 0, or ≤ 0 for the outside of a part
    owner: I32  #: (f,) the part that it is of
    outside: I32  #: (c,) the face that is the outside of each part
    within: I32  #: (c,) the face that holds it, -1 for none


def faces(net: Net, ends: F64, bulge: F64, touch: float) -> Faces:
    """Return the faces of a net of n edges, (n, 2, 2) and (n,)."""
    lines = (net.place, net.start, net.end, net.bulge, net.same)
    beside, (left, right, area) = both(
        lambda: looked_left(net, ends, bulge, touch), lambda: _walked(*lines, *_around(*lines))
    )
    outside, owner = _owned(len(net.leftmost), net.part, left, right, area)
    within = held(beside, left, right, outside, owner)
    return Faces(left, right, area, owner, outside, within)


@kernel(allocates=False)
def _angle(x: float, y: float) -> int:
    """A number that grows with the angle of a direction, the same for all that are nearly one."""
    across = abs(x) + abs(y)
    along = y / across if across > 0.0 else 0.0
    quarters = 2.0 - along if x < 0.0 else along + 4.0 if y < 0.0 else along
    return int(quarters * _FINE + 0.5) % (4 * _FINE)


@kernel
def _around(place: F64_2, start: I32_1, end: I32_1, bent: F64_1, same: I32_1) -> Any:
    """Return the halves of pieces round each place against the clock, and where each place's begin.

    Half 2 p of piece p leaves its beginning, half 2 p + 1 its end.
    """
    pieces, places = len(start), len(place)
    begins = np.zeros(places + 1, np.int32)
    for p in range(pieces):
        if same[p] == p:
            begins[start[p] + 1] += 1
            begins[end[p] + 1] += 1
    begins = np.cumsum(begins).astype(np.int32)
    angle = np.empty(2 * pieces, np.int64)
    around = np.empty(begins[-1], np.int32)
    put = begins[:-1].copy()
    for p in range(pieces):
        if same[p] != p:
            continue
        for half in range(2 * p, 2 * p + 2):
            at = start[p] if half % 2 == 0 else end[p]
            k = put[at]
            put[at] += 1
            # One and two have no order.
            if begins[at + 1] - begins[at] > 2:
                angle[half] = _leaves(place, start, end, bent, half)
                while k > begins[at]:
                    other = around[k - 1]
                    if angle[other] < angle[half] or (
                        angle[other] == angle[half]
                        and _curve(place, start, end, bent, other)
                        <= _curve(place, start, end, bent, half)
                    ):
                        break
                    around[k] = other
                    k -= 1
            around[k] = half
    return around, begins


@kernel(allocates=False)
def _leaves(place: F64_2, start: I32_1, end: I32_1, bent: F64_1, half: int) -> int:
    """The direction in which half a piece leaves its place, by its tangent, as ``_angle``."""
    p = half // 2
    a, b, bend = start[p], end[p], bent[p]
    dx, dy = place[b, 0] - place[a, 0], place[b, 1] - place[a, 1]
    if bend == 0.0:
        return _angle(dx, dy) if half % 2 == 0 else _angle(-dx, -dy)
    # The chord, turned by a quarter of the sweep twice.
    square = bend * bend
    c, s = (1.0 - square) / (1.0 + square), 2.0 * bend / (1.0 + square)
    if half % 2 == 0:
        return _angle(c * dx + s * dy, c * dy - s * dx)
    return _angle(s * dy - c * dx, -c * dy - s * dx)


@kernel(allocates=False)
def _curve(place: F64_2, start: I32_1, end: I32_1, bent: F64_1, half: int) -> float:
    """How far half a piece bends to the left of where it leaves."""
    p = half // 2
    a, b = start[p], end[p]
    dx, dy = place[b, 0] - place[a, 0], place[b, 1] - place[a, 1]
    curve: float = bent[p] / max(math.sqrt(dx * dx + dy * dy), 1e-300)
    return curve if half % 2 == 0 else -curve


@kernel
def _walked(
    place: F64_2, start: I32_1, end: I32_1, bent: F64_1, same: I32_1, around: I32_1, begins: I32_1
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
                if abs(bend) > BULGE:
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
    return left, right, area[:count]


@kernel
def _owned(parts: int, part: I32_1, left: I32_1, right: I32_1, area: F64_1) -> Any:
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
