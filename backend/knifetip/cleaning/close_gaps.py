"""close_gaps: remove debris, and join ends of edges that should meet but leave a small gap.

``GAP`` is the largest gap that is closed, 0.05 mm, and ``SAME``, 0.01 mm, the distance within which
edges are the same.  Debris is an edge shorter than ``GAP`` that is isolated, or attached to other
edges at one end only.  An edge shorter than ``SAME`` is also debris if it lies between two edges
that are at least as long as ``GAP``: their ends can be joined without it.

Two ends of edges of the same line type are joined if they are at different points, at most ``GAP``
apart, and at least one of them is single: no other edge of this line type ends at its point.

If only one of the two ends is single, it is moved to the point of the other end.  If both are
single, and edges of other line types end at only one of the two points, that point is kept and the
other end is moved to it.  In all other cases both ends are moved to one point: to the intersection
of the edges if both are straight and it is within ``GAP`` of both ends, otherwise to the point
halfway between the ends.

T-junctions, where an end touches the inside of another edge, and edges that end side by side are
not changed.  An arc keeps its bulge.  No end moves by more than ``GAP``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.cleaning.end_points import CROWD, EndPoints
from knifetip.geometry.chain import outward_directions
from knifetip.geometry.columns import F64, U8, Bool
from knifetip.geometry.tolerance import ANGLE, GAP, JOIN, POINT, SAME
from knifetip.geometry.union_find import find, union
from knifetip.kernels import F64_1, F64_2, I64_1, I64_2, Bool_1, kernel

#: Largest distance by which an end is moved (mm).
_LARGEST_MOVE: Final = GAP + POINT
#: Cosine of the largest angle between two edges that end side by side; these are not joined.
_BESIDE: Final = math.cos(math.radians(10.0))
#: Cosine of the largest angle by which an edge may bend away from an edge that it continues.
_STRAIGHT: Final = math.cos(math.radians(ANGLE))
#: Sine of the smallest angle at which the intersection of two lines is used.
_SLANT: Final = 0.05


@dataclass(frozen=True, eq=False, slots=True)
class ClosedGaps:
    """The ends of k edges after gaps were closed, and how far they were moved."""

    ends: F64  #: (k, 2, 2) mm
    displacement: F64  #: (k,) larger displacement of the two ends (mm)


class _PlacedEnds(NamedTuple):
    """The points of the 2k ends of k edges; ends that meet have the same point."""

    place: I64_1  #: (2k,) index of the point of each end
    by_place: I64_1  #: (2k,) the ends ordered by their points
    first: I64_1  #: the ends at point i start at index first[i] of ``by_place``


def find_debris(ends: F64, length: F64, end_points: EndPoints) -> Bool:
    """Return the mask of the edges that are debris, shape (k,).

    Debris are edges shorter than the largest gap that is closed, ``GAP``, that are not needed to
    connect other edges.

    Parameters
    ----------
    ends : (k, 2, 2)
        Start and end points of k edges (mm).
    length : (k,)
        Lengths of the edges (mm).
    end_points
        Points that the ends of the edges share, and pairs of ends that are near each other.
    """
    found: Bool = _find_debris(ends.reshape(-1, 2), length, end_points.place, end_points.pairs)
    return found


def close_gaps(ends: F64, bulge: F64, kind: U8, settled: Bool, end_points: EndPoints) -> ClosedGaps:
    """Return the ends of k edges after gaps between ends were closed, and how far they moved.

    Parameters
    ----------
    ends : (k, 2, 2)
        Start and end points of the edges (mm).
    bulge, kind : (k,)
        Bulges and line types of the edges.
    settled : (k,)
        Mask of the edges whose ends are not moved.
    end_points
        Points that the ends of the edges share, and pairs of ends that are near each other.
    """
    points, place, near_pairs = ends.reshape(-1, 2), end_points.place, end_points.pairs
    if len(near_pairs) == 0 or settled[near_pairs // 2].all():
        return ClosedGaps(ends, np.zeros(len(bulge)))
    size = np.hypot(*(points[near_pairs[:, 0]] - points[near_pairs[:, 1]]).T)
    order = np.lexsort((near_pairs[:, 1], near_pairs[:, 0], np.round(size, 6)))
    moved = _close(
        points,
        bulge,
        kind.astype(np.int64),
        outward_directions(ends, bulge).reshape(-1, 2),
        place,
        near_pairs[order],
        settled,
    )
    off = np.hypot(*(moved - points).T).reshape(-1, 2)
    if not off.any():
        return ClosedGaps(ends, off[:, 0])
    return ClosedGaps(moved.reshape(-1, 2, 2), off.max(axis=1))


@kernel
def _find_debris(points: F64_2, length: F64_1, place: I64_1, near_pairs: I64_2) -> Any:
    count = len(length)
    many = np.zeros(len(place), np.int64)
    short = np.zeros(len(place), np.int64)
    group = np.arange(len(place))
    for end in range(len(place)):
        many[place[end]] += 1
        if length[end // 2] < GAP:
            short[place[end]] += 1
    # Groups of short edges that touch only each other.
    for edge in range(count):
        if length[edge] < GAP:
            union(group, place[2 * edge], place[2 * edge + 1])
    box = np.empty((len(place), 4))
    box[:, :2] = np.inf
    box[:, 2:] = -np.inf
    whole = np.ones(len(place), np.bool_)
    for end in range(len(place)):
        if length[end // 2] < GAP:
            g = find(group, place[end])
            box[g, 0] = min(box[g, 0], points[end, 0])
            box[g, 1] = min(box[g, 1], points[end, 1])
            box[g, 2] = max(box[g, 2], points[end, 0])
            box[g, 3] = max(box[g, 3], points[end, 1])
            if many[place[end]] != short[place[end]]:
                whole[g] = False
    spot = np.empty((len(place), 4))
    spot[:, :2] = np.inf
    spot[:, 2:] = -np.inf
    for end in range(len(place)):
        at = place[end]
        spot[at, 0] = min(spot[at, 0], points[end, 0])
        spot[at, 1] = min(spot[at, 1], points[end, 1])
        spot[at, 2] = max(spot[at, 2], points[end, 0])
        spot[at, 3] = max(spot[at, 3], points[end, 1])
    debris = np.zeros(count, np.bool_)
    linked = _connects_edges(points, length, place, near_pairs)
    for edge in range(count):
        if length[edge] >= GAP:
            continue
        a, b = place[2 * edge], place[2 * edge + 1]
        if a == b and math.hypot(spot[a, 2] - spot[a, 0], spot[a, 3] - spot[a, 1]) < SAME:
            # The whole group is smaller than the tolerance.
            debris[edge] = True
            continue
        g = find(group, a)
        if whole[g]:
            if math.hypot(box[g, 2] - box[g, 0], box[g, 3] - box[g, 1]) < GAP:
                debris[edge] = not linked[edge]
            continue
        if many[a] == 1 or many[b] == 1:
            debris[edge] = not linked[edge]
        elif length[edge] < SAME:
            debris[edge] = many[a] == 2 and many[b] == 2 and short[a] == 1 and short[b] == 1
    return debris


@kernel
def _connects_edges(points: F64_2, length: F64_1, place: I64_1, near_pairs: I64_2) -> Any:
    """Return the mask of short edges that connect other edges, shape (k,).

    An edge is in the mask if it is shorter than ``GAP``, if another edge ends at or near each of
    its two ends, and if these ends of other edges are more than ``GAP`` apart.

    ``points`` (2k, 2): ends of k edges (mm): the start and the end of each edge.
    ``length`` (k,): lengths of the edges (mm).
    ``place`` (2k,): index of the point of each end; ends that meet have the same point.
    ``near_pairs`` (q, 2): pairs of ends that are near each other.
    """
    count = len(length)
    linked = np.zeros(count, np.bool_)
    if len(near_pairs) == 0:
        return linked
    # Up to eight ends of other edges near each end.
    neighbours = np.full((2 * count, 8), -1, np.int64)
    many = np.zeros(2 * count, np.int64)
    for k in range(len(near_pairs)):
        for side in range(2):
            here, there = near_pairs[k, side], near_pairs[k, 1 - side]
            if many[here] < 8 and here // 2 != there // 2:
                neighbours[here, many[here]] = there
                many[here] += 1
    own = np.zeros(len(place), np.int64)
    for end in range(len(place)):
        own[place[end]] += 1
    for edge in range(count):
        if length[edge] >= GAP:
            continue
        for k in range(many[2 * edge] + 1):
            p = 2 * edge if k == many[2 * edge] else neighbours[2 * edge, k]
            if k == many[2 * edge] and own[place[2 * edge]] == 1:
                continue
            for q_ in range(many[2 * edge + 1] + 1):
                last = q_ == many[2 * edge + 1]
                q = 2 * edge + 1 if last else neighbours[2 * edge + 1, q_]
                if last and own[place[2 * edge + 1]] == 1:
                    continue
                apart = math.hypot(points[p, 0] - points[q, 0], points[p, 1] - points[q, 1])
                if apart > GAP:
                    linked[edge] = True
    return linked


@kernel
def _close(
    points: F64_2,
    bulge: F64_1,
    kind: I64_1,
    outward: F64_2,
    place: I64_1,
    near_pairs: I64_2,
    fixed: Bool_1,
) -> Any:
    """Return the ends of k edges after gaps were closed, (2k, 2) mm.

    ``points``, ``outward`` (2k, 2): ends (mm), and unit vectors that point out of the edge at each
    end.
    ``bulge``, ``kind``, ``fixed`` (k,): bulge and line type of each edge, and whether its ends must
    not be moved.
    ``place`` (2k,): index of the point of each end; ends that meet have the same point.
    ``near_pairs`` (q, 2): pairs of ends that are near each other, nearest pair first.
    """
    moved = points.copy()
    by_place = np.argsort(place, kind="mergesort")
    first = np.searchsorted(place[by_place], np.arange(len(place) + 1))
    placed = _PlacedEnds(place, by_place, first)
    settled = np.zeros(len(place), np.bool_)
    for end in range(len(place)):
        settled[place[end]] |= fixed[end // 2]
    for k in range(len(near_pairs)):
        a, b = place[near_pairs[k, 0]], place[near_pairs[k, 1]]
        if settled[a] and settled[b]:
            continue
        if max(first[a + 1] - first[a], first[b + 1] - first[b]) > CROWD:
            continue
        # Two ends of one line type that connect the two points.
        one, other = -1, -1
        one_many, other_many = 0, 0
        for p in range(first[a], first[a + 1]):
            i = by_place[p]
            alike_a, alike_b, partner = 0, 0, -1
            for q in range(first[a], first[a + 1]):
                alike_a += kind[by_place[q] // 2] == kind[i // 2]
            for q in range(first[b], first[b + 1]):
                if kind[by_place[q] // 2] == kind[i // 2]:
                    alike_b += 1
                    partner = by_place[q]
            if alike_b and (alike_a == 1 or alike_b == 1):
                one, other, one_many, other_many = i, partner, alike_a, alike_b
                break
        if one < 0 or _are_connected(a, b, placed):
            continue
        if one_many == 1 and other_many == 1:
            cosine = outward[one, 0] * outward[other, 0] + outward[one, 1] * outward[other, 1]
            if cosine > _BESIDE:
                continue
            if cosine > -_STRAIGHT and (
                _inside(points, bulge, one, other // 2) or _inside(points, bulge, other, one // 2)
            ):
                continue
        size_a = first[a + 1] - first[a]
        size_b = first[b + 1] - first[b]
        stay_a = settled[a] or (not settled[b] and (one_many > 1 or (size_a > 1 and size_b == 1)))
        stay_b = settled[b] or (not settled[a] and (other_many > 1 or (size_b > 1 and size_a == 1)))
        if stay_a and stay_b:
            continue
        if stay_a:
            x, y = moved[one, 0], moved[one, 1]
        elif stay_b:
            x, y = moved[other, 0], moved[other, 1]
        else:
            x, y = _meeting_point(points, bulge, outward, one, other)
        far_a = np.inf if stay_a else _LARGEST_MOVE
        far_b = np.inf if stay_b else _LARGEST_MOVE
        if not (
            _may_move(points, moved, placed, a, x, y, far_a)
            and _may_move(points, moved, placed, b, x, y, far_b)
        ):
            continue
        for point in (a, b):
            for p in range(first[point], first[point + 1]):
                moved[by_place[p], 0] = x
                moved[by_place[p], 1] = y
        settled[a] = True
        settled[b] = True
    return moved


@kernel
def _are_connected(point_a: int, point_b: int, placed: _PlacedEnds) -> bool:
    """Return whether an edge connects two points."""
    place, by_place, first = placed
    found = False
    for p in range(first[point_a], first[point_a + 1]):
        found |= place[by_place[p] ^ 1] == point_b
    return found


@kernel
def _may_move(
    points: F64_2, moved: F64_2, placed: _PlacedEnds, point: int, x: float, y: float, limit: float
) -> bool:
    """Return whether all ends at the point with index ``point`` may be moved to (x, y).

    An end may not move by more than ``limit`` mm, and the distance between the two ends of an edge
    must remain more than ``JOIN``.  An edge with both ends at the point prevents the move.

    ``points``, ``moved`` (2k, 2): ends of k edges (mm) before any move, and after the moves that
    were made so far.
    """
    place, by_place, first = placed
    for p in range(first[point], first[point + 1]):
        i = by_place[p]
        if place[i ^ 1] == point or math.hypot(points[i, 0] - x, points[i, 1] - y) > limit:
            return False
        if math.hypot(moved[i ^ 1, 0] - x, moved[i ^ 1, 1] - y) <= JOIN:
            return False
    return True


@kernel
def _inside(points: F64_2, bulge: F64_1, end: int, edge: int) -> bool:
    """Return whether the end with index ``end`` touches the inside of the edge ``edge``.

    The end touches the inside if it is within ``JOIN`` of the edge, but at least ``SAME``
    away from both ends of the edge.  ``points`` (2k, 2) mm and ``bulge`` (k,) are the ends and the
    bulges of k edges.
    """
    x0, y0 = points[2 * edge, 0], points[2 * edge, 1]
    x1, y1 = points[2 * edge + 1, 0], points[2 * edge + 1, 1]
    x, y = points[end, 0], points[end, 1]
    b = bulge[edge]
    dx, dy = x1 - x0, y1 - y0
    square = dx * dx + dy * dy
    along = ((x - x0) * dx + (y - y0) * dy) / square
    if along <= 0.0 or along >= 1.0:
        return False
    # Within the tolerance of an end it is that end.
    if math.hypot(x - x0, y - y0) < SAME or math.hypot(x - x1, y - y1) < SAME:
        return False
    if abs(b) < 1e-7:
        return bool(abs((x - x0) * dy - (y - y0) * dx) <= JOIN * math.sqrt(square))
    lean = (1.0 - b * b) / (4.0 * b)
    cx = 0.5 * (x0 + x1) - lean * dy
    cy = 0.5 * (y0 + y1) + lean * dx
    radius = math.sqrt(square) * (1.0 + b * b) / (4.0 * abs(b))
    return bool(abs(math.hypot(x - cx, y - cy) - radius) <= JOIN)


@kernel
def _meeting_point(
    points: F64_2, bulge: F64_1, outward: F64_2, end_a: int, end_b: int
) -> tuple[float, float]:
    """Return the point (x, y) to which two ends are moved to close the gap between them.

    If both edges are straight, the point is the intersection of their lines, unless it is more than
    ``_LARGEST_MOVE`` away from one of the ends or the sine of the angle between the lines is at
    most ``_SLANT``.  In all other cases it is the point halfway between the ends.

    ``points``, ``outward`` (2k, 2): ends of k edges (mm), and unit vectors that point out of the
    edge at each end.
    ``bulge`` (k,): bulges of the edges.
    ``end_a``, ``end_b``: indices of the two ends; 2i is the start of edge i, 2i + 1 its end.
    """
    x0, y0 = points[end_a, 0], points[end_a, 1]
    x1, y1 = points[end_b, 0], points[end_b, 1]
    sine = outward[end_a, 0] * outward[end_b, 1] - outward[end_a, 1] * outward[end_b, 0]
    if bulge[end_a // 2] == 0.0 and bulge[end_b // 2] == 0.0 and abs(sine) > _SLANT:
        way = ((x1 - x0) * outward[end_b, 1] - (y1 - y0) * outward[end_b, 0]) / sine
        x = x0 + way * outward[end_a, 0]
        y = y0 + way * outward[end_a, 1]
        if abs(way) <= _LARGEST_MOVE and math.hypot(x - x1, y - y1) <= _LARGEST_MOVE:
            return x, y
    return 0.5 * (x0 + x1), 0.5 * (y0 + y1)
