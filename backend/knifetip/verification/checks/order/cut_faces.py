"""Find the faces into which cuts divide the sheet, after small gaps in the contours are closed.

Cuts are split into pieces where they meet.  If an end of a cut is at most ``GAP_LENGTH`` from
another cut, a straight link from that end to the other cut closes the contour.  The results are the
pieces of cuts, the links, and the two faces beside each piece and each link.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_2, I64_1, Bool_1, kernel
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import line_curves, point_at
from knifetip.verification.curves.curve_grid import CurveGrid, list_curves
from knifetip.verification.expectation.edge_paths import edge_paths, joined_ends
from knifetip.verification.expectation.edge_pieces import split_edges
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    Edges,
    edges_from_curves,
    pairs_within,
    without_duplicates,
)
from knifetip.verification.expectation.outline import face_cycles, lowest_connected

#: An end of a cut within this of another cut closes a contour; an uncut rest up to this length does
#: not hold a part (mm).  A little less than the value for planning.
GAP_LENGTH: Final = 2.0


#: A gap is closed only if the chain of cuts between its ends is this many times as long.
_DETOUR_RATIO: Final = 3.0


#: A cycle that encloses less than this has no inside (mm²).
_MIN_AREA: Final = 1e-6


#: Upward offset of the rays that search to the left of a point (mm), because vertices often lie at
#: the same height.
_RAY_OFFSET: Final = 0.317 * JOIN_DISTANCE


#: Pieces this near to a cell are listed in it for the rays (mm).
_RAY_MARGIN: Final = 1e-6


@dataclass(frozen=True, eq=False, slots=True)
class CutFaces:
    """The f faces into which cuts and links divide the sheet; face 0 is outside all cuts.

    A link is a straight line that closes a small gap in a contour.  Cuts and links are split into p
    pieces where they meet.  In arrays with one row for each piece, the pieces of cuts come first,
    and then the pieces of links.
    """

    curve: F64  #: (p, 6)
    edge: I64  #: (p,) the cut; -1 - i for a piece of link i
    begin: F64  #: (p,) mm from the start of the cut
    face: I64  #: (p, 2) left and right face; of duplicates in any order
    count: int  #: number of faces, f
    pieces: Edges  #: the q pieces without duplicates
    unique: I64  #: (q,) index of each piece without duplicates among all pieces

    def locate(self, points: F64) -> I64:
        """Return the index of the face that contains each of m points, shape (m,).

        ``points`` is (m, 2) mm; the index is 0 for a point outside all cuts.
        """
        none = np.full(len(points), -1)
        met, rising = _first_piece_left(points, none, self.pieces, self.unique)
        side = self.face[self.unique[met], np.where(rising, 1, 0)]
        result: I64 = np.where(met < 0, 0, side)
        return result


def find_cut_faces(cuts: Edges) -> CutFaces:
    """Return the faces into which cuts divide the sheet, after small gaps between the cuts are
    closed.
    """
    return faces_between(cuts, gap_links(cuts, find_dangling_ends(cuts), GAP_LENGTH))


def faces_between(cuts: Edges, links: F64) -> CutFaces:
    """Return the faces into which cuts and links divide the sheet.

    ``cuts`` are edges of one line type in the order of their rows.  ``links`` are the straight
    lines that close gaps, as rows of six numbers (see ``curves.curve``), (k, 6).
    """
    drawn = cuts if len(links) == 0 else edges_from_curves(np.concatenate([cuts.curve, links]))
    piece, edge, begin = split_edges(drawn)
    edge = np.where(edge < len(cuts), edge, len(cuts) - 1 - edge)
    # Other checks have compared the ends of cuts that are not split, and found their outlines.
    is_split = not np.array_equal(piece, drawn.curve)
    pieces = edges_from_curves(piece) if is_split else drawn
    left, *duplicates = without_duplicates(pieces)
    unique, twin, first = (np.searchsorted(pieces.row, row) for row in (left.row, *duplicates))
    cycle, swept, component = face_cycles(left)
    face = np.empty((len(piece), 2), np.int64)
    face[unique], count = _assign_faces(left, cycle.reshape(-1, 2), swept < _MIN_AREA, component)
    face[twin] = face[first]
    return CutFaces(piece, edge, begin, face, count, left, unique)


def find_dangling_ends(cuts: Edges) -> I64:
    """Return the indices of the ends that touch no other cut, (t,); cut i has the ends 2i and
    2i + 1.
    """
    a, b = cuts.near_ends(JOIN_DISTANCE)
    end, edge, _ = cuts.touched_ends(JOIN_DISTANCE)
    loose = np.ones(len(cuts.ends), np.bool_)
    loose[a[a // 2 != b // 2]] = False
    loose[end[end // 2 != edge]] = False
    return np.flatnonzero(loose)


def gap_links(cuts: Edges, tips: I64, longest: float) -> F64:
    """Return k straight lines that close gaps of at most ``longest`` mm in the contours of the
    cuts, (k, 6).

    The lines, called links, are rows of six numbers (see ``curves.curve``).  Each link leads from
    one of the dangling ends ``tips``, (t,), to a nearby cut or to another of these ends.  Two
    dangling ends are not linked to each other if a third dangling end is nearer to each of the two
    than they are to each other.
    """
    size = cuts.curve[:, 5]
    points = cuts.ends[tips]
    near = cuts.touched_by_points(points, longest)
    others = np.flatnonzero(near.edge != tips[near.curve] // 2)
    tip, edge = near.curve[others].astype(np.int64), near.edge[others].astype(np.int64)
    place = near.place[others, 0]
    one, other = pairs_within(points, points, longest)
    kept = one != other
    one, other = one[kept], other[kept]
    if len(tip) + len(one) == 0:
        return line_curves(points[:0], points[:0])
    kept = np.argsort(one, kind="stable")
    one, other = one[kept], other[kept]
    kept = _neighbour_mask(one, other, points, np.searchsorted(one, np.arange(len(tips) + 1)))
    one, other = one[kept], other[kept]
    target = point_at(cuts.curve[edge], place)
    for side in range(2):
        there = np.hypot(*(target - cuts.ends[2 * edge + side]).T) <= JOIN_DISTANCE
        target[there] = cuts.ends[2 * edge[there] + side]
    target = np.concatenate([target, points[other]])
    ends_at = np.where(tips[other] % 2 == 0, 0.0, size[tips[other] // 2])
    tip = np.concatenate([tip, one])
    edge = np.concatenate([edge, tips[other] // 2])
    place = np.concatenate([place, ends_at])
    to_end = np.repeat([False, True], [len(others), len(one)])
    gap = np.hypot(*(target - points[tip]).T)
    # An end is always near to the chain that it ends; that is not a gap.
    strung = edge_paths(cuts, joined_ends(cuts))
    own = tips[tip] // 2
    inner = strung.begin[edge] + np.where(strung.flipped[edge], size[edge] - place, place)
    begins = strung.first[strung.path[own]] == tips[tip]
    along = np.where(begins, inner, strung.length[strung.path[own]] - inner)
    far_along = (strung.path[edge] != strung.path[own]) | (along >= _DETOUR_RATIO * gap)
    keep = np.flatnonzero((gap > JOIN_DISTANCE) & (gap <= longest) & far_along)
    keep = keep[np.lexsort((gap[keep], to_end[keep], tip[keep]))]
    new = np.append(True, np.diff(tip[keep]) != 0)[: len(keep)]
    keep = keep[to_end[keep] | new]
    both = np.concatenate([points[tip[keep]], target[keep]], axis=1)
    swap = (both[:, 0] > both[:, 2]) | ((both[:, 0] == both[:, 2]) & (both[:, 1] > both[:, 3]))
    both[swap] = both[swap][:, [2, 3, 0, 1]]
    both = np.unique(both, axis=0)
    return line_curves(both[:, :2], both[:, 2:])


@kernel
def _neighbour_mask(point_a: I64_1, point_b: I64_1, points: F64_2, first: I64_1) -> Any:
    """Return the mask of the pairs of points that are relative neighbours, (k,).

    Two points are relative neighbours if no third point is nearer to each of the two than they are
    to each other.  Only points that are paired with the pair's first point are tried as the third.

    ``point_a``, ``point_b`` (k,): first and second point of each pair, as indices into ``points``;
    the pairs are sorted by ``point_a``.
    ``points`` (n, 2) mm: the points.
    ``first`` (n + 1,): index of the first pair of each point, followed by the number of pairs.
    """
    kept = np.ones(len(point_a), np.bool_)
    for k in range(len(point_a)):
        ax, ay = points[point_a[k], 0], points[point_a[k], 1]
        bx, by = points[point_b[k], 0], points[point_b[k], 1]
        apart = (ax - bx) ** 2 + (ay - by) ** 2
        for place in range(first[point_a[k]], first[point_a[k] + 1]):
            x, y = points[point_b[place], 0], points[point_b[place], 1]
            if max((x - ax) ** 2 + (y - ay) ** 2, (x - bx) ** 2 + (y - by) ** 2) < apart:
                kept[k] = False
                break
    return kept


def _assign_faces(pieces: Edges, cycle: I64, outside: Bool, component: I64) -> tuple[I64, int]:
    """Return the indices of the faces on the left and right of p pieces, (p, 2), and the number of
    faces.

    ``pieces``: the p pieces of cuts.
    ``cycle`` (p, 2): index of the cycle of half-edges on the left and on the right of each piece.
    ``outside`` (w,): mask of the w cycles that run round the outside of a connected component of
    pieces.
    ``component`` (p,): index of the connected component of each piece.
    """
    count, curve = int(component.max()) + 1, pieces.curve
    # The leftmost point of each component, at the side of a circle or at an end.
    start, end = point_at(curve, np.zeros(len(curve))), point_at(curve, curve[:, 5])
    side = curve[:, 1:3] - np.stack([curve[:, 3], np.zeros(len(curve))], axis=1)
    turn = (math.pi - curve[:, 4]) * curve[:, 0] % (2.0 * math.pi)
    reaches = (curve[:, 0] != 0.0) & (turn * curve[:, 3] <= curve[:, 5])
    points = np.stack([start, end, np.where(reaches[:, None], side, start)], axis=1)
    leftmost = points[np.arange(len(curve)), points[:, :, 0].argmin(axis=1)]
    order = np.lexsort((leftmost[:, 0], component))
    probe = leftmost[order[np.searchsorted(component[order], np.arange(count))]]
    met, rising = _first_piece_left(probe, np.arange(count), pieces, component)
    beside = np.where(met < 0, -1, cycle[met, np.where(rising, 1, 0)])
    # The curve to the left belongs to a component farther left, whose face is already assigned.
    face_of = np.where(outside, 0, np.cumsum(~outside))
    component_of = np.zeros(len(outside), np.int64)
    component_of[cycle] = component[:, None]
    enclosing = _enclosing_faces(
        np.argsort(probe[:, 0], kind="stable"), beside, outside, component_of, face_of
    )
    face: I64 = np.where(outside, enclosing[component_of], face_of)[cycle]
    return face, int((~outside).sum()) + 1


@kernel
def _enclosing_faces(
    order: I64_1, beside: I64_1, outside: Bool_1, component_of: I64_1, face_of: I64_1
) -> Any:
    """Return the face that encloses each of c connected components of pieces, (c,); 0 if none does.

    ``order`` (c,): indices of the components, sorted by their leftmost points from left to right.
    ``beside`` (c,): index of a cycle of half-edges for each component: the cycle that borders the
    face between the component's leftmost point and the nearest curve to its left, -1 if there is no
    such curve.
    ``outside``, ``component_of``, ``face_of`` (w,): for each of w cycles: whether it runs round the
    outside of a component, the index of its component, and the index of its face.
    """
    enclosing = np.zeros(len(order), np.int64)
    for c in order:
        beside_cycle = beside[c]
        if beside_cycle >= 0:
            enclosing[c] = (
                enclosing[component_of[beside_cycle]]
                if outside[beside_cycle]
                else face_of[beside_cycle]
            )
    return enclosing


def _first_piece_left(points: F64, own: I64, pieces: Edges, owner: I64) -> tuple[I64, Bool]:
    """Return the first of n pieces to the left of each of m points, and whether it runs upwards.

    ``points`` (m, 2) mm: the points.
    ``own`` (m,): number of the group whose pieces are ignored in the search from each point, -1 for
    none.
    ``pieces``, ``owner``: the n pieces, and the number of the group of each, such as its connected
    component, (n,).
    Returns index of the piece, (m,), -1 for none; and the mask of the points whose piece runs
    upwards at the height of the point, (m,).
    """
    grid = pieces.compute_once(
        "cells of rays", lambda: list_curves(_joined_curves(pieces), 0.0, _RAY_MARGIN)
    )
    met, rising = _search_left(points + np.array([0.0, _RAY_OFFSET]), own, owner, grid)
    return met, rising


def _joined_curves(pieces: Edges) -> F64:
    """Return the curves of n pieces, (n, 6), whose joined ends are exactly equal as far as lines
    are joined.

    A ray could otherwise pass between two ends that are joined although they are not at the same
    height.  Arcs stay as they are, and lines end on them.
    """
    count = len(pieces)
    node = lowest_connected(*pieces.near_ends(JOIN_DISTANCE), 2 * count)
    position = pieces.ends.copy()
    ends_of_arcs = np.flatnonzero(np.repeat(pieces.curve[:, 0] != 0.0, 2))
    position[node[ends_of_arcs]] = pieces.ends[ends_of_arcs]
    start, end = position[node[::2]], position[node[1::2]]
    straight = (pieces.curve[:, 0] == 0.0) & (np.hypot(*(end - start).T) > 0.0)
    curve = pieces.curve.copy()
    curve[straight] = line_curves(start[straight], end[straight])
    return curve


@kernel(checks_division=True)
def _search_left(
    points: F64_2,
    own: I64_1,
    owner: I64_1,
    grid: CurveGrid,
) -> Any:
    curve, (corner, size, wide, tall), first, listed = grid
    met = np.full(len(points), -1, np.int64)
    rising = np.zeros(len(points), np.bool_)
    for p in range(len(points)):
        x, y = points[p, 0], points[p, 1]
        row = math.floor((y - corner[1]) / size)
        if row < 0 or row >= tall:
            continue
        column = min(math.floor((x - corner[0]) / size), wide - 1)
        best = -math.inf
        while column >= 0:
            cell = column * tall + row
            for k in range(first[cell + 1] - 1, first[cell] - 1, -1):
                i = listed[k]
                if owner[i] == own[p] and own[p] >= 0:
                    continue
                crossing_x, up = _crossing_left(curve, i, x, y)
                if crossing_x > best:
                    best, met[p], rising[p] = crossing_x, i, up
            if met[p] >= 0 and best >= corner[0] + column * size:
                break
            column -= 1
    return met, rising


@kernel(allocates=False, checks_division=True)
def _crossing_left(curves: F64_2, row: int, x: float, y: float) -> Any:
    """Find where a line or arc crosses the ray that runs from the point (x, y) to the left.

    Returns the x of the crossing nearest to the point (mm), and whether the line or arc runs
    upwards there; -inf and False if there is no crossing.  The line or arc is row ``row`` of
    ``curves``, as six numbers (see ``curves.curve``).
    """
    curve = curves[row]
    best, up = -math.inf, False
    if curve[0] == 0.0:
        y1 = curve[2] + curve[4] * curve[5]
        if (curve[2] > y) != (y1 > y):
            crossing_x = curve[1] + (y - curve[2]) / curve[4] * curve[3]
            if crossing_x < x:
                best, up = crossing_x, curve[4] > 0.0
        return best, up
    rise = curve[3] * curve[3] - (y - curve[2]) ** 2
    if rise <= 0.0:
        return best, up
    half = math.sqrt(rise)
    for sign in (-1.0, 1.0):
        crossing_x = curve[1] + sign * half
        turn = (math.atan2(y - curve[2], sign * half) - curve[4]) * curve[0] % (2.0 * math.pi)
        if best < crossing_x < x and turn * curve[3] <= curve[5]:
            # The right half of an anticlockwise circle runs upwards.
            best, up = crossing_x, sign * curve[0] > 0.0
    return best, up
