"""split_at_cuts: split creases where cuts cross them.

Both parts of a split crease end at the board's end clearance from the cut.
"""

from __future__ import annotations

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.path import Paths, select_paths
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import GAP, JOIN, POINT
from knifetip.planning.cut_crossings import ACROSS, all_crossings, are_inner, begin_of_segments
from knifetip.planning.path_ends import end_directions, end_points


def split_at_cuts(paths: Paths, ends: F64, bulge: F64, closed: Bool) -> tuple[Paths, I32, Bool]:
    """Return the paths, split where cuts cross them.

    A closed path that is split has no end where it began: its last piece continues in its first.

    A path is not split by a cut that only touches it from one side, nor by a cut on which the path
    ends.  Cuts that cross a path at most ``GAP`` apart (mm) cross it at one place: the path stops
    before the first of them, and starts again behind the last one.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the cuts.
    closed : (p,)
        Mask of the paths whose last segment continues in the first one.

    Returns
    -------
    Paths
        The q new paths with m segments, in the order of ``paths``.
    row : (m,)
        Segment of ``paths`` from which each new segment comes.
    crossed : (q, 2)
        Whether a cut crosses a path at the start, and at the end, of each new path.
    """
    segment, fraction = all_crossings(paths, ends, bulge)
    inner = are_inner(paths, segment, fraction)
    place, path, first, last = _cluster_crossings(paths, segment[inner], fraction[inner])
    size = arc.length(paths.start, paths.end, paths.bulge)
    along = place - begin_of_segments(paths, size)[segment[inner]]
    # A cut at a joint, or too near to it for a segment between them, splits no segment.
    own = size[segment[inner]]
    divides = (along > 0.5 * JOIN) & (along < own - 0.5 * JOIN)
    row = np.concatenate([np.arange(len(size)), segment[inner][divides]])
    low = np.concatenate([np.zeros(len(size)), (along / own)[divides]])
    order = np.lexsort((low, row))
    row, low = row[order], low[order]
    high = np.where(np.append(row[1:] != row[:-1], True), 1.0, np.roll(low, -1))
    middle = begin_of_segments(paths, size)[row] + 0.5 * (low + high) * size[row]
    owner = paths.path_of[row]
    passed, within = _locate_among_clusters(owner, middle, path, first, last)
    # Two cuts that cross at one place leave no piece of the segment between them.
    kept = ~within & (((high - low) * size[row] > POINT) | ((low == 0.0) & (high == 1.0)))
    row, low, high, owner, passed = (one[kept] for one in (row, low, high, owner, passed))
    near_end, far_end, bent = arc.sub_arc(
        paths.start[row], paths.end[row], paths.bulge[row], low, high
    )
    begins_path = np.append(True, (owner[1:] != owner[:-1]) | (passed[1:] != passed[:-1]))
    starts = np.flatnonzero(begins_path[: len(row)])
    result = Paths(
        np.where((low == 0.0)[:, None], paths.start[row], near_end),
        np.where((high == 1.0)[:, None], paths.end[row], far_end),
        np.where((low == 0.0) & (high == 1.0), paths.bulge[row], bent),
        np.append(starts, len(row)),
    )
    owner = owner[starts]
    again = np.append(False, owner[1:] == owner[:-1])[: len(owner)]
    crossed = _end_at_crossings(result, paths, segment, fraction)
    crossed |= np.stack([again, np.append(again[1:], False)[: len(again)]], axis=1)
    return _join_closed(result, row.astype(np.int32), crossed, owner, closed)


def _join_closed(
    pieces: Paths, row: I32, crossed: Bool, owner: I64, closed: Bool
) -> tuple[Paths, I32, Bool]:
    """Return the pieces of paths, (q,), with the first and the last piece of each closed path
    joined.  They stay apart if a cut crosses the path where they meet.

    ``row``, ``crossed``: as returned by ``split_at_cuts``, (m,) and (q, 2).
    ``owner`` (q,): path of each piece, ascending.
    ``closed``: mask of the closed paths, (p,).
    """
    path, first = np.unique(owner, return_index=True)
    last = np.append(first[1:], len(owner))[: len(first)] - 1
    joined = closed[path] & (last > first) & ~crossed[first, 0] & ~crossed[last, 1]
    first, last = first[joined], last[joined]
    if len(first) == 0:
        return pieces, row, crossed
    key = np.arange(len(owner), dtype=np.float64)
    key[last] = first - 0.5
    order = np.argsort(key)
    moved, segment = select_paths(pieces, order.astype(np.int32))
    crossed = crossed.copy()
    crossed[first, 0] = crossed[last, 0]
    begins = np.ones(len(order), np.bool_)
    begins[np.argsort(order)[first]] = False
    starts = np.append(moved.first[:-1][begins], len(moved.bulge))
    merged = Paths(moved.start, moved.end, moved.bulge, starts)
    kept = np.setdiff1d(np.arange(len(owner)), last)
    return merged, row[segment], crossed[kept]


def _cluster_crossings(paths: Paths, segment: I64, fraction: F64) -> tuple[F64, I64, F64, F64]:
    """Return the places of k crossings along their paths, and the c clusters of the crossings.

    Neighbours in one cluster are at most ``GAP`` mm apart.  ``segment`` and ``fraction`` are as
    returned by ``find_cut_crossings``.

    Returns ``place`` (k,) mm: distance of each crossing from the start of its path.  A crossing
    within ``JOIN`` of a joint is moved to the joint; ``path, first, last`` (c,), (c,) mm and (c,)
    mm: path of each cluster, and the least and greatest place of its crossings, sorted by path and
    place.
    """
    size = arc.length(paths.start, paths.end, paths.bulge)
    along = fraction * size[segment]
    along = np.where(along < JOIN, 0.0, along)
    along = np.where(size[segment] - along < JOIN, size[segment], along)
    place = begin_of_segments(paths, size)[segment] + along
    path = paths.path_of[segment].astype(np.int64)
    order = np.lexsort((place, path))
    ordered, owner = place[order], path[order]
    apart = (owner[1:] != owner[:-1]) | (np.diff(ordered) > GAP + POINT)
    begin = np.flatnonzero(np.append(True, apart)[: len(ordered)])
    end = np.append(begin[1:], len(ordered))[: len(begin)] - 1
    return place, owner[begin], ordered[begin], ordered[end]


def _locate_among_clusters(
    owner: I64 | I32, place: F64, path: I64, first: F64, last: F64
) -> tuple[I64, Bool]:
    """Return the number of clusters that begin before each of m places, and whether the place is
    inside a cluster.

    The number counts the clusters of all paths up to the path of the place.

    ``owner``, ``place`` (m,) and (m,) mm: path of each place, and its distance from the start of
    the path.
    ``path``, ``first``, ``last`` (c,): clusters as returned by ``_cluster_crossings``.
    """
    widest = 1.0 + float(max(place.max(initial=0.0), last.max(initial=0.0)))
    passed = np.searchsorted(path * widest + first, owner * widest + place, side="right")
    before = np.maximum(passed - 1, 0)
    if len(path) == 0:
        return passed, np.zeros(len(place), np.bool_)
    return passed, (passed > 0) & (path[before] == owner) & (place < last[before])


def _end_at_crossings(result: Paths, paths: Paths, segment: I64, fraction: F64) -> Bool:
    """Return whether a crease is crossed at the start, and at the end, of each of q paths, (q, 2).

    The crossing is within ``GAP`` of the path's end, and the crease that is crossed there has the
    direction of the path.  Creases that only end at the same point are not crossed.

    ``result``: the q paths.
    ``paths``, ``segment``, ``fraction``: the creases before they were split, and the crossings as
    ``find_cut_crossings`` returns them.
    """
    curves = paths.start[segment], paths.end[segment], paths.bulge[segment]
    points, ahead = arc.point_at(*curves, fraction), arc.tangent_at(*curves, fraction)
    stops, _ = end_points(result)
    stop, point = box_pairs(arc.point_boxes(stops), arc.point_boxes(points), 2.0 * GAP)
    near = np.hypot(*(stops[stop] - points[point]).T) <= GAP + POINT
    side = left_normal(unit_vectors(ahead[point])) * end_directions(result)[stop]
    near &= np.abs(side.sum(axis=1)) <= ACROSS + 1e-12
    crossed = np.zeros(len(stops), np.bool_)
    crossed[stop[near]] = True
    return crossed.reshape(2, -1).T
