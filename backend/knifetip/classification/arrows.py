"""arrows: lines with arrowheads, which say something of a carton and are never made.

    PlanarGraph -> which edges are arrowheads, the lines between them, and what those begin at

An arrowhead is two short lines of one length that end together on a third and fold back along it,
alike on both sides, with their other ends loose or joined to each other.  The notch at the end of
a crease opens the other way, and its ends go on in the outline.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

import numpy as np

from knifetip.geometry.columns import Bool
from knifetip.geometry.cores import each, runs
from knifetip.kernels import F64_1, F64_2, I32_1, Bool_1, OutBool_1, kernel
from knifetip.topology.intersections import MIN_CHUNK
from knifetip.topology.planar_graph import PlanarGraph

#: An arrowhead is no longer than this (mm), and than this share of the line that it ends.
_LONG: Final = 12.0
_SHARE: Final = 0.75
#: The angle between it and its line (radians): 5° … 50°, the same on both sides to 4°.
_LEAST: Final = math.radians(5.0)
_MOST: Final = math.radians(50.0)
_ALIKE: Final = math.radians(4.0)
#: A line that an arrow begins at stands over it by no more than this (mm).
_OVER: Final = 8.0
_FULL: Final = 24


class _Lines(NamedTuple):
    """Columns of a ``PlanarGraph``."""

    place: F64_2
    start: I32_1
    end: I32_1
    edge: I32_1
    first: I32_1


class _Around(NamedTuple):
    """The pieces that meet at each of q places."""

    first: I32_1  #: (q + 1,) those of each place are first … first + 1 - 1
    piece: I32_1


def arrows(graph: PlanarGraph, count: int, unit: float) -> Bool:
    """Return which of n edges belong to arrows, (n,).

    Parameters
    ----------
    unit
        How many units of the ends a millimetre has.
    """
    found, tip = np.zeros(count, np.bool_), np.zeros(len(graph.vertex), np.bool_)
    lines = _Lines(graph.vertex, graph.start, graph.end, graph.edge, graph.first)
    around = _around(lines, graph.same)

    def looked(run: tuple[int, int]) -> None:
        _heads(lines, graph.bulge, around, unit, found, tip, *run)

    each(looked, runs(len(tip), MIN_CHUNK))
    _rest(lines, graph.same, around, unit, found, tip)
    return found


@kernel
def _around(lines: _Lines, same: I32_1) -> _Around:
    """Return the pieces at each place."""
    place, start, end, edge, _ = lines
    places, count = len(place), len(start)
    first = np.zeros(places + 1, np.int32)
    for p in range(count):
        if same[p] == p and edge[p] >= 0:
            first[start[p] + 1] += 1
            first[end[p] + 1] += 1
    for k in range(places):
        first[k + 1] += first[k]
    put = first[:-1].copy()
    meeting = np.empty(first[-1], np.int32)
    for p in range(count):
        if same[p] == p and edge[p] >= 0:
            meeting[put[start[p]]] = p
            put[start[p]] += 1
            meeting[put[end[p]]] = p
            put[end[p]] += 1
    return _Around(first, meeting)


@kernel
def _heads(
    lines: _Lines, bulge: F64_1, around: _Around, unit: float, found: OutBool_1, tip: OutBool_1,
    begin: int, stop: int,
) -> None:  # fmt: skip
    """Mark the arrowheads at some places, and the lines that they end."""
    place, start, end, edge, pieces = lines
    first, meeting = around
    long = _LONG * unit
    head = np.empty(_FULL, np.int32)
    tail = np.empty(_FULL, np.int32)
    way = np.empty(_FULL)
    size = np.empty(_FULL)
    for at in range(begin, stop):
        many = first[at + 1] - first[at]
        if many < 3 or many > _FULL:
            continue
        heads = 0
        for k in range(first[at], first[at + 1]):
            p = meeting[k]
            i = edge[p]
            if i < 0 or bulge[p] != 0.0:
                continue
            # The whole edge, though other lines may cross it.
            far = _other(start, end, pieces, i, at)
            if far < 0:
                continue
            dx, dy = place[far, 0] - place[at, 0], place[far, 1] - place[at, 1]
            chord = math.hypot(dx, dy)
            # Loose, or the corner of a closed head.
            if not 0.0 < chord <= long or first[far + 1] - first[far] > 2:
                continue
            head[heads], tail[heads] = i, far
            way[heads], size[heads] = math.atan2(dy, dx), chord
            heads += 1
        if heads < 2:
            continue
        for a in range(heads):
            for b in range(a + 1, heads):
                if abs(size[a] - size[b]) > 0.05 * size[a]:
                    continue
                one, two = tail[a], tail[b]
                loose = first[one + 1] - first[one] == 1 and first[two + 1] - first[two] == 1
                if not loose and not _joined(start, end, pieces, edge, first, meeting, one, two):
                    continue
                for k in range(first[at], first[at + 1]):
                    shaft = meeting[k]
                    i = edge[shaft]
                    if i < 0 or i in (head[a], head[b]) or bulge[shaft] != 0.0:
                        continue
                    on = end[shaft] if start[shaft] == at else start[shaft]
                    dx, dy = place[on, 0] - place[at, 0], place[on, 1] - place[at, 1]
                    if _length(place, start, end, pieces, i) * _SHARE < size[a]:
                        continue
                    along = math.atan2(dy, dx)
                    left, right = _turn(along, way[a]), _turn(along, way[b])
                    if left * right >= 0.0 or abs(abs(left) - abs(right)) > _ALIKE:
                        continue
                    if not _LEAST <= abs(left) <= _MOST:
                        continue
                    tip[at] = True
                    found[head[a]] = found[head[b]] = found[i] = True
                    # Drawn twice, and not quite alike.
                    for c in range(heads):
                        near = min(abs(_turn(way[c], way[a])), abs(_turn(way[c], way[b])))
                        if near <= _ALIKE and abs(size[c] - size[a]) <= 0.05 * size[a]:
                            found[head[c]] = True
                    if not loose:
                        for m in range(first[one], first[one + 1]):
                            if edge[meeting[m]] >= 0:
                                found[edge[meeting[m]]] = True


@kernel(allocates=False)
def _rest(
    lines: _Lines, same: I32_1, around: _Around, unit: float, found: OutBool_1, tip: Bool_1
) -> None:
    """Mark what an arrow begins at, and what lies on arrows."""
    place, start, end, edge, pieces = lines
    first, meeting = around
    # It stands over it a little.
    for at in range(len(place)):
        if not tip[at]:
            continue
        for k in range(first[at], first[at + 1]):
            p = meeting[k]
            if edge[p] < 0 or found[edge[p]]:
                continue
            i = edge[p]
            for side in range(2):
                last = pieces[i] if side == 0 else pieces[i + 1] - 1
                rim = start[last] if side == 0 else end[last]
                if first[rim + 1] - first[rim] == 1:
                    dx = place[rim, 0] - place[at, 0]
                    dy = place[rim, 1] - place[at, 1]
                    over = math.hypot(dx, dy)
                    whole = _length(place, start, end, pieces, i)
                    ends_here = start[p] == at or end[p] == at
                    if over <= _OVER * unit or (ends_here and over >= whole):
                        found[i] = True

    if not tip.any():
        return
    # What lies wholly on all this.
    for i in range(len(found)):
        if found[i] or pieces[i] == pieces[i + 1]:
            continue
        on = True
        for p in range(pieces[i], pieces[i + 1]):
            lead = edge[same[p]]
            on = on and lead >= 0 and found[lead]
        found[i] = on


@kernel(allocates=False)
def _other(start: I32_1, end: I32_1, pieces: I32_1, i: int, at: int) -> int:
    """The place where an edge ends that begins at a place, -1 where it does not."""
    one, two = start[pieces[i]], end[pieces[i + 1] - 1]
    if one == at:
        far: int = two
        return far
    if two == at:
        near: int = one
        return near
    return -1


@kernel(allocates=False)
def _joined(
    start: I32_1,
    end: I32_1,
    pieces: I32_1,
    edge: I32_1,
    first: I32_1,
    meeting: I32_1,
    one: int,
    two: int,
) -> bool:
    """Whether an edge runs between two places."""
    for k in range(first[one], first[one + 1]):
        i = edge[meeting[k]]
        if i >= 0 and _other(start, end, pieces, i, one) == two:
            return True
    return False


@kernel(allocates=False)
def _length(place: F64_2, start: I32_1, end: I32_1, pieces: I32_1, i: int) -> float:
    a, b = start[pieces[i]], end[pieces[i + 1] - 1]
    return math.hypot(place[b, 0] - place[a, 0], place[b, 1] - place[a, 1])


@kernel(allocates=False)
def _turn(one: float, other: float) -> float:
    """The angle from one direction to another, -π … π."""
    turn = (other - one) % (2.0 * math.pi)
    return turn - 2.0 * math.pi if turn > math.pi else turn
