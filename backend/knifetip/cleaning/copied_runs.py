"""copied_runs: merge curves that were drawn twice as chords with other vertices.

A run is a sequence of edges of one line type between two points at which not exactly two of them
meet, or a closed contour.  Two runs are copies if each lies along its whole length within ``GAP``
of the other one, and has nearly the same direction there.  Then one of the runs remains, whole: the
longer one, of nearly equal ones that with the fewest edges, and then the first.  Runs whose edges
correspond to each other are left to ``remove_overlaps``.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.cleaning.remove_overlaps import Pieces
from knifetip.geometry import arc
from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.columns import F64, I64, U8, Bool
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import ANGLE, GAP, POINT, SAME
from knifetip.geometry.union_find import flatten, union
from knifetip.kernels import F64_1, F64_2, I64_1, kernel

#: Positions at which an edge must lie beside the other run.
_FRACTIONS: Final = (0.0, 0.25, 0.5, 0.75, 1.0)
#: Cosine of the greatest angle between two edges beside each other (30°).
_PARALLEL: Final = 0.866
#: Runs whose lengths differ by less than about this fraction are alike.
_ALIKE: Final = 0.01
#: Runs must be longer than this (mm): everything near a shorter one lies beside it.
_LEAST: Final = 4.0 * GAP
#: Greatest number of pairs of runs that are compared, which bounds the time.
_MOST_PAIRS: Final = 1000
#: Greatest number of candidates for a corner of the box of a run.
_CROWD: Final = 16


class _Runs(NamedTuple):
    """r runs of k edges."""

    order: I64  #: (k,) the edges, run by run
    first: I64  #: (r + 1,) place in ``order`` at which each run begins
    box: F64  #: (r, 4) mm: x min, y min, x max, y max
    length: F64  #: (r,) mm
    kind: I64  #: (r,) line type

    def edges(self, run: int) -> I64:
        """Return the edges of a run."""
        return self.order[self.first[run] : self.first[run + 1]]

    @property
    def sizes(self) -> I64:
        """Number of edges of each run, (r,)."""
        return np.diff(self.first)


class _Match(NamedTuple):
    """How q stretches of a run lie beside edges of its copy."""

    edge: I64  #: (q,) edge of each stretch
    begin: F64  #: (q,) start of each stretch, 0 … 1 of the length of its edge
    end: F64  #: (q,)
    beside: I64  #: (q,) edge of the copy beside it


def merge_copied_runs(ends: F64, bulge: F64, kind: U8, place: I64, is_fixed: Bool) -> Pieces | None:
    """Return the k edges without the runs that are copies of others; None if there is none.

    Parameters
    ----------
    ends, bulge, kind : (k, 2, 2) mm, (k,) and (k,)
        Start and end points, bulges and line types of the edges.
    place : (2k,)
        Point of each end, as in ``EndPoints``.
    is_fixed : (k,)
        Mask of the edges whose runs remain.
    """
    if len(bulge) < 3:
        return None
    runs = _find_runs(ends, bulge, kind, place)
    one, other = _candidates(runs, ends)
    if len(one) == 0:
        return None
    scale = np.round(np.log(np.maximum(runs.length, POINT)) / _ALIKE)
    count = runs.sizes
    rank = np.empty(len(count), np.int64)
    rank[np.lexsort((runs.order[runs.first[:-1]], count, -scale))] = np.arange(len(count))
    one, other = np.where(rank[one] < rank[other], [one, other], [other, one])
    is_removed = np.zeros(len(count), np.bool_)
    matches = []
    for keeps, goes in sorted(
        zip(one.tolist(), other.tolist(), strict=True), key=lambda pair: rank[list(pair)].tolist()
    ):
        if is_removed[keeps] or is_removed[goes] or is_fixed[runs.edges(goes)].any():
            continue
        match = _match(ends, bulge, runs.edges(goes), runs.edges(keeps))
        if match is not None:
            is_removed[goes] = True
            matches.append(match)
    if not matches:
        return None
    return _pieces(ends, bulge, matches)


def _find_runs(ends: F64, bulge: F64, kind: U8, place: I64) -> _Runs:
    """Return the runs of the edges; the parameters are those of ``merge_copied_runs``."""
    run_of = _connect(place, kind.astype(np.int64))
    order = np.argsort(run_of, kind="stable")
    first = np.flatnonzero(np.append(True, np.diff(run_of[order]) > 0))
    boxes = arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge)
    length = arc.length(ends[:, 0], ends[:, 1], bulge)
    first = np.append(first, len(order))
    box, size = _unite(boxes, length, order, first)
    return _Runs(order, first, box, size, kind[order[first[:-1]]].astype(np.int64))


@kernel
def _unite(boxes: F64_2, length: F64_1, order: I64_1, first: I64_1) -> Any:
    """Return the bounding box (mm) and the length (mm) of each of r runs, (r, 4) and (r,).

    ``boxes`` (k, 4), ``length`` (k,): bounding boxes and lengths of the edges (mm).
    ``order`` (k,), ``first`` (r + 1,): the edges of the runs, as in ``_Runs``.
    """
    count = len(first) - 1
    box, size = np.empty((count, 4)), np.zeros(count)
    for run in range(count):
        box[run] = boxes[order[first[run]]]
        for at in range(first[run], first[run + 1]):
            edge = order[at]
            size[run] += length[edge]
            for side in range(2):
                box[run, side] = min(box[run, side], boxes[edge, side])
                box[run, 2 + side] = max(box[run, 2 + side], boxes[edge, 2 + side])
    return box, size


@kernel
def _connect(place: I64_1, kind: I64_1) -> Any:
    """Return the lowest edge of the run of each of k edges, (k,).

    ``place`` (2k,): point of each end.  ``kind`` (k,): line types.  Two edges of one line type are
    in one run if they meet at a point at which no other edge of this line type ends.
    """
    count = np.zeros((place.max() + 1, kind.max() + 1), np.int32)
    other = np.full(count.shape, -1, np.int64)
    for end in range(len(place)):
        count[place[end], kind[end // 2]] += 1
    parent = np.arange(len(kind))
    for end in range(len(place)):
        at, edge = place[end], end // 2
        if count[at, kind[edge]] == 2:
            if other[at, kind[edge]] < 0:
                other[at, kind[edge]] = edge
            else:
                union(parent, other[at, kind[edge]], edge)
    flatten(parent)
    return parent


def _candidates(runs: _Runs, ends: F64) -> tuple[I64, I64]:
    """Return the pairs of runs with nearly the same box that may be copies, (p,) and (p,).

    ``ends`` (k, 2, 2) mm are the ends of the edges.
    """
    none = np.zeros(0, np.int64)
    count = runs.sizes
    if (count == 1).all():
        return none, none
    x, y = (np.floor((low - low.min()) / (2.0 * GAP)) for low in runs.box[:, :2].T)
    _, cell_of, crowd = np.unique(x * 2.0**26 + y, return_inverse=True, return_counts=True)
    usual = np.flatnonzero((crowd[cell_of.ravel()] <= _CROWD) & (runs.length > _LEAST))
    corner = np.hstack([runs.box[usual, :2], runs.box[usual, :2]])
    one, other = box_pairs(corner, corner, GAP)
    is_pair = one < other
    one, other = usual[one[is_pair]], usual[other[is_pair]]
    keep = runs.kind[one] == runs.kind[other]
    keep &= (np.abs(runs.box[one] - runs.box[other]) <= GAP).all(axis=1)
    # Single edges, and equal runs, are left to ``remove_overlaps``.
    keep &= (count[one] > 1) | (count[other] > 1)
    one, other = one[keep], other[keep]
    if len(one) == 0:
        return none, none
    sums = _vertex_sums(runs, ends)
    keep = np.abs(sums[one] - sums[other]) > POINT
    one, other = one[keep].astype(np.int64), other[keep].astype(np.int64)
    return (none, none) if len(one) > _MOST_PAIRS else (one, other)


def _vertex_sums(runs: _Runs, ends: F64) -> F64:
    """Return a number for each run, (r,), that is equal for runs with equal vertices."""
    # Not symmetrical, as curves are.
    points = ends @ np.array([371.0, 913.0])
    points = (np.sin(points) + np.cos(1.7 * points)).sum(axis=1)
    result: F64 = np.add.reduceat(points[runs.order], runs.first[:-1])
    return result


def _match(ends: F64, bulge: F64, goes: I64, keeps: I64) -> _Match | None:
    """Return how the run ``goes`` lies beside the run ``keeps``; None if they are no copies."""
    if len(goes) == len(keeps) and _correspond(ends, bulge, goes, keeps):
        return None
    one, other = box_pairs(_boxes(ends, bulge, goes), _boxes(ends, bulge, keeps), GAP)
    row, beside = goes[one], keeps[other]
    # Both runs at all fractions at once: calls with short columns take time.
    sides, places = 2 * len(one), len(_FRACTIONS)
    away = _distances(
        ends,
        bulge,
        np.tile(np.concatenate([row, beside]), places),
        np.tile(np.concatenate([beside, row]), places),
        np.repeat(np.array(_FRACTIONS), sides),
    ).reshape(places, sides)
    is_near = np.zeros((places, len(goes) + len(keeps)), np.bool_)
    place, pair = np.nonzero(away < GAP - POINT)
    is_near[place, np.concatenate([one, len(goes) + other])[pair]] = True
    if not is_near.all():
        return None
    # The stretches change at the points nearest to vertices of the run that remains.
    edge, cut = [np.repeat(goes, 2)], [np.tile([0.0, 1.0], len(goes))]
    for side in (0, 1):
        vertex = ends[beside, side]
        at = arc.nearest_fraction(ends[row, 0], ends[row, 1], bulge[row], vertex)
        point = arc.point_at(ends[row, 0], ends[row, 1], bulge[row], at)
        size = arc.length(ends[row, 0], ends[row, 1], bulge[row])
        inside = (np.minimum(at, 1.0 - at) * size > POINT) & (
            np.hypot(*(point - vertex).T) <= 2.0 * GAP
        )
        edge.append(row[inside])
        cut.append(at[inside])
    edges, cuts = np.concatenate(edge), np.concatenate(cut)
    order = np.lexsort((cuts, edges))
    edges, cuts = edges[order], cuts[order]
    some = (edges[1:] == edges[:-1]) & (np.diff(cuts) > 0.0)
    edges, begin, end = edges[:-1][some], cuts[:-1][some], cuts[1:][some]
    # The edge beside the middle of each stretch.
    order = np.argsort(row, kind="stable")
    row, beside = row[order], beside[order]
    first = np.searchsorted(row, edges)
    many = np.searchsorted(row, edges, side="right") - first
    stretch = np.repeat(np.arange(len(edges)), many)
    pair = first[stretch] + np.arange(len(stretch)) - np.repeat(np.cumsum(many) - many, many)
    middle = 0.5 * (begin + end)
    away = _distances(ends, bulge, row[pair], beside[pair], middle[stretch])
    order = np.lexsort((away, stretch))
    nearest = order[np.searchsorted(stretch[order], np.arange(len(edges)))]
    if (away[nearest] > GAP).any():
        return None
    return _Match(edges, begin, end, beside[pair[nearest]])


def _correspond(ends: F64, bulge: F64, one: I64, other: I64) -> bool:
    """Return whether each edge of a run lies beside one edge of another run, so that
    ``remove_overlaps`` merges them: ends within ``SAME``, or nearly and in the same direction.
    """
    row, beside = box_pairs(_boxes(ends, bulge, one), _boxes(ends, bulge, other), 2.0 * GAP)
    row, beside = one[row], other[beside]
    gap = ends[row][:, :, None] - ends[beside][:, None]
    apart = np.hypot(gap[..., 0], gap[..., 1])
    # The greater distance of two ends, in either direction of the edge beside.
    forward = np.maximum(apart[:, 0, 0], apart[:, 1, 1])
    apart = np.minimum(forward, np.maximum(apart[:, 0, 1], apart[:, 1, 0]))
    ahead, along = (unit_vectors(ends[rows, 1] - ends[rows, 0]) for rows in (row, beside))
    cosine = np.abs((ahead * along).sum(axis=1))
    limit = np.where(cosine > math.cos(math.radians(ANGLE)), 2.0 * GAP, SAME)
    return bool(np.isin(one, row[apart <= limit]).all())


def _boxes(ends: F64, bulge: F64, rows: I64) -> F64:
    """Return the bounding boxes of some of the edges, (m, 4) mm."""
    return arc.bounding_boxes(ends[rows, 0], ends[rows, 1], bulge[rows])


def _distances(ends: F64, bulge: F64, own: I64, others: I64, place: F64) -> F64:
    """Return the distances of points of edges from other edges with nearly the same direction, (m,)
    mm; infinite if the direction differs.

    ``own``, ``others`` (m,): the m pairs of edges.
    ``place`` (m,): position of the point on the first edge, 0 … 1.
    """
    edge = ends[own, 0], ends[own, 1], bulge[own]
    facing = ends[others, 0], ends[others, 1], bulge[others]
    point = arc.point_at(*edge, place)
    foot = arc.nearest_fraction(*facing, point)
    away: F64 = np.hypot(*(arc.point_at(*facing, foot) - point).T)
    ahead = unit_vectors(arc.tangent_at(*edge, place))
    cosine = np.abs((ahead * unit_vectors(arc.tangent_at(*facing, foot))).sum(axis=1))
    return np.where(cosine < _PARALLEL, np.inf, away)


def _pieces(ends: F64, bulge: F64, matches: list[_Match]) -> Pieces:
    """Return the edges without those of the runs in ``matches``, as pieces."""
    edge, begin, end, beside = (
        np.concatenate([match[column] for match in matches]) for column in range(4)
    )
    stays = np.ones(len(bulge), np.bool_)
    stays[edge] = False
    owner = np.flatnonzero(stays)
    number = np.full(len(bulge), -1, np.int64)
    number[owner] = np.arange(len(owner))
    whole = np.zeros(len(owner)), np.ones(len(owner))
    return Pieces(
        ends[owner],
        bulge[owner],
        owner.astype(np.int32),
        np.concatenate([owner, edge]).astype(np.int32),
        np.concatenate([whole[0], begin]),
        np.concatenate([whole[1], end]),
        np.concatenate([number[owner], number[beside]]).astype(np.int32),
        np.concatenate([np.zeros(len(owner), np.bool_), np.ones(len(edge), np.bool_)]),
        np.zeros(len(owner)),
    )
