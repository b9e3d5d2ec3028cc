"""creases: split creases where cuts cross them, and replace creases by double creases.

Both parts of a split crease end at the board's end clearance from the cut.  The two lines of a
double crease end at the same positions as the drawn crease.
"""

from __future__ import annotations

from math import cos, hypot, radians, sin
from typing import Any

import numpy as np

from knifetip.errors import EdgeTooShort
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.chain import outward_directions
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.intersect import intersect_pairs
from knifetip.geometry.path import Paths, select_paths
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import ANGLE, BULGE, GAP, JOIN, POINT
from knifetip.kernels import F64_3, I64_1, kernel
from knifetip.planning.path_ends import end_directions, end_points

#: A cut at a smaller angle runs along a crease and does not cross it (sine of 1°).
_ACROSS = sin(radians(ANGLE))
#: Number of chords that approximate an arc.
_CHORDS_PER_ARC = 128


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
    segment, fraction = _all_crossings(paths, ends, bulge)
    inner = _is_inner(paths, segment, fraction)
    place, path, first, last = _cluster_crossings(paths, segment[inner], fraction[inner])
    size = arc.length(paths.start, paths.end, paths.bulge)
    along = place - _begin_of_segments(paths, size)[segment[inner]]
    # A cut at a joint, or too near to it for a segment between them, splits no segment.
    own = size[segment[inner]]
    divides = (along > 0.5 * JOIN) & (along < own - 0.5 * JOIN)
    row = np.concatenate([np.arange(len(size)), segment[inner][divides]])
    low = np.concatenate([np.zeros(len(size)), (along / own)[divides]])
    order = np.lexsort((low, row))
    row, low = row[order], low[order]
    high = np.where(np.append(row[1:] != row[:-1], True), 1.0, np.roll(low, -1))
    middle = _begin_of_segments(paths, size)[row] + 0.5 * (low + high) * size[row]
    owner = paths.path_of[row]
    passed, within = _locate_among_clusters(owner, middle, path, first, last)
    kept = ~within & ((high > low) | ((low == 0.0) & (high == 1.0)))
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
    """Return the q pieces of paths, with the last piece of each closed path before its first one,
    joined to it, unless a cut crosses the path where they meet.

    Parameters
    ----------
    row, crossed
        As returned by ``split_at_cuts``, (m,) and (q, 2).
    owner : (q,)
        Path of each piece, ascending.
    closed
        Mask of the closed paths, (p,).
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


def _begin_of_segments(paths: Paths, size: F64) -> F64:
    """Return the distance from the start of its path to the start of each segment, (n,) mm.

    ``size`` are the lengths of the n segments, (n,) mm.
    """
    before = np.append(0.0, np.cumsum(size))[:-1]
    result: F64 = before - before[paths.first[:-1]][paths.path_of]
    return result


def _cluster_crossings(paths: Paths, segment: I64, fraction: F64) -> tuple[F64, I64, F64, F64]:
    """Return the places of k crossings along their paths, and the c clusters of the crossings.

    Neighbours in one cluster are at most ``GAP`` mm apart.  ``segment`` and ``fraction`` are as
    returned by ``find_cut_crossings``.

    Returns
    -------
    place : (k,) mm
        Distance of each crossing from the start of its path.  A crossing within ``JOIN`` of a joint
        is moved to the joint.
    path, first, last : (c,), (c,) mm and (c,) mm
        Path of each cluster, and the least and greatest place of its crossings, sorted by path and
        place.
    """
    size = arc.length(paths.start, paths.end, paths.bulge)
    along = fraction * size[segment]
    along = np.where(along < JOIN, 0.0, along)
    along = np.where(size[segment] - along < JOIN, size[segment], along)
    place = _begin_of_segments(paths, size)[segment] + along
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

    Parameters
    ----------
    owner, place : (m,) and (m,) mm
        Path of each place, and its distance from the start of the path.
    path, first, last : (c,)
        Clusters as returned by ``_cluster_crossings``.
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

    Parameters
    ----------
    result
        The q paths.
    paths, segment, fraction
        The creases before they were split, and the crossings as ``find_cut_crossings`` returns
        them.
    """
    curves = paths.start[segment], paths.end[segment], paths.bulge[segment]
    points, ahead = arc.point_at(*curves, fraction), arc.tangent_at(*curves, fraction)
    stops, _ = end_points(result)
    stop, point = box_pairs(arc.point_boxes(stops), arc.point_boxes(points), 2.0 * GAP)
    near = np.hypot(*(stops[stop] - points[point]).T) <= GAP + POINT
    side = left_normal(unit_vectors(ahead[point])) * end_directions(result)[stop]
    near &= np.abs(side.sum(axis=1)) <= _ACROSS + 1e-12
    crossed = np.zeros(len(stops), np.bool_)
    crossed[stop[near]] = True
    return crossed.reshape(2, -1).T


def find_cut_crossings(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, F64]:
    """Return the k points at which cuts cross segments of paths.

    Returns the index of the segment of each point (k,), and the parameter of the point on the
    segment, 0 … 1 (k,).  A cut crosses a segment if their common point is an inner point
    of the path and of the cut.  Two cuts also cross a segment if they end at the same point of the
    segment, one on the left and one on the right of the segment.  A cut at no more than 1° to a
    segment does not cross it.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the cuts.
    """
    segment, fraction = _all_crossings(paths, ends, bulge)
    inner = _is_inner(paths, segment, fraction)
    return segment[inner], fraction[inner]


def _all_crossings(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, F64]:
    """Return the k points at which cuts cross paths, also those at the ends of the paths.

    The arguments and the result are those of ``find_cut_crossings``.
    """
    if len(paths) == 0 or len(bulge) == 0:
        return np.zeros(0, np.int64), np.zeros(0)
    segment, cut, fraction = _crossings_inside_cuts(paths, ends, bulge)
    across = ~_are_along(paths, ends, bulge, segment, cut)
    segment, fraction = segment[across], fraction[across]
    at_vertex, vertex_fraction = _crossings_at_cut_ends(paths, ends, bulge)
    return np.concatenate([segment, at_vertex]), np.concatenate([fraction, vertex_fraction])


def _are_along(paths: Paths, ends: F64, bulge: F64, segment: I64, cut: I64) -> Bool:
    """Return the mask of the k pairs of a straight segment and a straight cut along it, (k,).

    A cut along a crease, such as the end of a slot, crosses it only by rounding.  ``segment`` and
    ``cut`` are the indices of the two, (k,) each; ``ends`` and ``bulge`` are those of the cuts.
    """
    ahead = unit_vectors(paths.end[segment] - paths.start[segment])
    along = unit_vectors(ends[cut, 1] - ends[cut, 0])
    straight = (np.abs(paths.bulge[segment]) < BULGE) & (np.abs(bulge[cut]) < BULGE)
    result: Bool = straight & (np.abs((left_normal(ahead) * along).sum(axis=1)) <= _ACROSS)
    return result


def _is_inner(paths: Paths, segment: I64, fraction: F64) -> Bool:
    """Return the mask of the points of paths that are more than ``GAP`` from the path's ends, (k,).

    ``segment`` is the segment of each point, (k,), and ``fraction`` its parameter, 0 … 1, (k,).  A
    joint between two segments of one path is not an end.
    """
    points = arc.point_at(paths.start[segment], paths.end[segment], paths.bulge[segment], fraction)
    stops = np.stack([paths.start[paths.first[:-1]], paths.end[paths.first[1:] - 1]], axis=1)
    away = np.hypot(*(points[:, None] - stops[paths.path_of[segment]]).transpose(2, 0, 1))
    result: Bool = (away > GAP + POINT).all(axis=1)
    return result


def _crossings_at_cut_ends(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, F64]:
    """Return the k ends of cuts on segments, at points where cuts from both sides end.

    Returns the segment of each end (k,), and the parameter of the end's foot on it, 0 … 1 (k,).
    ``ends`` and ``bulge`` are the ends, (n, 2, 2) mm, and the bulges, (n,), of the cuts.  Ends of
    one point follow each other along the path at most ``GAP`` mm apart.
    """
    points = ends.reshape(-1, 2)
    boxes = arc.bounding_boxes(paths.start, paths.end, paths.bulge)
    end, row = box_pairs(arc.point_boxes(points), boxes, GAP + POINT)
    if len(end) == 0:
        return np.zeros(0, np.int64), np.zeros(0)
    segments = paths.start[row], paths.end[row], paths.bulge[row]
    fraction = arc.nearest_fraction(*segments, points[end])
    foot = arc.point_at(*segments, fraction)
    away = np.hypot(*(foot - points[end]).T)
    touches = away <= GAP + POINT
    touches[touches] = _are_nearest(paths, end[touches], row[touches], away[touches])
    end, row, fraction = end[touches], row[touches], fraction[touches]
    ahead = unit_vectors(
        arc.tangent_at(paths.start[row], paths.end[row], paths.bulge[row], fraction)
    )
    side = (left_normal(ahead) * outward_directions(ends, bulge).reshape(-1, 2)[end]).sum(axis=1)
    # A cut that leaves the crease by less than GAP was only drawn slightly too long.
    size = arc.length(ends[:, 0], ends[:, 1], bulge)[end // 2]
    leaves = (np.abs(side) > _ACROSS) & (np.abs(side) * size > GAP + POINT)
    row, fraction, side = row[leaves], fraction[leaves], side[leaves]
    length = arc.length(paths.start, paths.end, paths.bulge)
    along = _begin_of_segments(paths, length)[row] + fraction * length[row]
    path = paths.path_of[row]
    order = np.lexsort((along, path))
    row, fraction, side, along, path = (one[order] for one in (row, fraction, side, along, path))
    new = np.append(True, (path[1:] != path[:-1]) | (np.diff(along) > GAP + POINT))[: len(row)]
    group = np.cumsum(new) - 1
    both = np.zeros((int(new.sum()), 2), np.bool_)
    both[group, (side < 0.0).astype(np.int64)] = True
    crossed = both[group, 0] & both[group, 1]
    return row[crossed].astype(np.int64), fraction[crossed]


def _are_nearest(paths: Paths, point: I64, segment: I64, distance: F64) -> Bool:
    """Return the mask of the k touches to which no neighbour of the segment is nearer, (k,).

    Near a joint of two segments a point touches both, but it meets their path at one place only.

    Parameters
    ----------
    point, segment, distance : (k,), (k,) and (k,) mm
        Index of the point and of the segment of each touch, and their distance.
    """
    size = len(paths.bulge)
    before, after = np.arange(size) - 1, np.arange(size) + 1
    first, final = paths.first[:-1], paths.first[1:] - 1
    before[first] = np.where(paths.closed, final, -1)
    after[final] = np.where(paths.closed, first, -1)
    key = point * size + segment
    order = np.argsort(key)
    nearest = np.ones(len(key), np.bool_)
    for neighbour in (before[segment], after[segment]):
        wanted = point * size + neighbour
        found = order[np.minimum(np.searchsorted(key[order], wanted), len(key) - 1)]
        same = (neighbour >= 0) & (key[found] == wanted)
        nearest &= ~same | (distance <= distance[found] + POINT)
    return nearest


def inner_crossings(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, I64, F64]:
    """Return the k points at which segments of paths cross cuts away from the ends of both.

    A crossing within ``GAP`` (mm) of an end of the segment's path or of an end of the cut is left
    out.  A joint between two segments of one path is not an end.

    Parameters
    ----------
    paths
        Paths that consist of the segments.
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points of the n cuts, and their bulges.

    Returns
    -------
    segment, cut, fraction : (k,), (k,) and (k,)
        Index of the segment and index of the cut of each crossing, and the position of the crossing
        on the segment as a parameter from 0 at its start to 1 at its end.
    """
    segment, cut, fraction = _crossings_inside_cuts(paths, ends, bulge)
    inner = _is_inner(paths, segment, fraction)
    return segment[inner], cut[inner], fraction[inner]


def _crossings_inside_cuts(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, I64, F64]:
    """Return the k points at which segments of paths cross cuts more than ``GAP`` from the cut's
    ends.

    The arguments and the result are those of ``inner_crossings``.
    """
    chords, owner, low, size = _split_into_chords(paths.start, paths.end, paths.bulge)
    cuts, cut, _, _ = _split_into_chords(ends[:, 0], ends[:, 1], bulge)
    chord, other = box_pairs(_bounding_boxes(chords), _bounding_boxes(cuts), 0.0)
    stops = np.ascontiguousarray(ends[cut])
    hit, along, position = _cross_inside(chords, cuts, stops, chord, other)
    chord = chord[hit]
    segment, crossed, fraction = owner[chord], cut[other[hit]], low[chord] + along * size[chord]
    # A chord deviates from its arc, which would shift a crossing along the segment.
    bent = np.flatnonzero(
        (np.abs(paths.bulge[segment]) >= BULGE) | (np.abs(bulge[crossed]) >= BULGE)
    )
    row, cut_row = segment[bent], crossed[bent]
    exact = intersect_pairs(
        paths.start[row], paths.end[row], paths.bulge[row],
        ends[cut_row, 0], ends[cut_row, 1], bulge[cut_row],
    )  # fmt: skip
    away = ((exact.points - position[bent, None]) ** 2).sum(axis=2)
    nearest = np.where(np.isnan(away), np.inf, away).argmin(axis=1)
    found = exact.count > 0
    fraction[bent[found]] = exact.first[np.arange(len(bent)), nearest][found]
    ahead = arc.tangent_at(paths.start[row], paths.end[row], paths.bulge[row], fraction[bent])
    on_cut = exact.second[np.arange(len(bent)), nearest]
    along = arc.tangent_at(
        ends[cut_row, 0], ends[cut_row, 1], bulge[cut_row], np.where(found, on_cut, 0.5)
    )
    # The tangent of an arc, or an arc beside it, touches the arc only.
    sine = np.abs((left_normal(unit_vectors(ahead)) * unit_vectors(along)).sum(axis=1))
    crosses = np.ones(len(segment), np.bool_)
    crosses[bent[found & (sine <= _ACROSS)]] = False
    return segment[crosses], crossed[crosses], fraction[crosses]


@kernel
def _cross_inside(chords: F64_3, cuts: F64_3, stops: F64_3, one: I64_1, other: I64_1) -> Any:
    """Return the h pairs of chords that cross more than ``GAP`` mm from the ends of the cut.

    Parameters
    ----------
    chords, cuts : (k, 2, 2) and (c, 2, 2) mm
        Ends of chords of paths, and of chords of cuts.
    stops : (c, 2, 2) mm
        Ends of the cut of each chord in ``cuts``.
    one, other : (p,) and (p,)
        Index of the chord of the path, and index of the chord of the cut, of each pair.

    Returns
    -------
    pair, along, position : (h,), (h,) and (h, 2) mm
        Index of each pair, parameter of the crossing on the chord of the path (0 … 1), and position
        of the crossing.
    """
    pair, along = np.empty(len(one), np.int64), np.empty(len(one))
    position = np.empty((len(one), 2))
    found = 0
    for k in range(len(one)):
        i, j = one[k], other[k]
        px, py = chords[i, 0, 0], chords[i, 0, 1]
        rx, ry = chords[i, 1, 0] - px, chords[i, 1, 1] - py
        qx, qy = cuts[j, 0, 0], cuts[j, 0, 1]
        sx, sy = cuts[j, 1, 0] - qx, cuts[j, 1, 1] - qy
        turn = rx * sy - ry * sx
        if not abs(turn) > 1e-9 * hypot(rx, ry) * hypot(sx, sy):
            continue
        on_path = ((qx - px) * sy - (qy - py) * sx) / turn
        on_cut = ((qx - px) * ry - (qy - py) * rx) / turn
        if not (0.0 <= on_path < 1.0 and 0.0 <= on_cut < 1.0):
            continue
        x, y = px + rx * on_path, py + ry * on_path
        inside = True
        for end in range(2):
            inside = inside and hypot(x - stops[j, end, 0], y - stops[j, end, 1]) > GAP + POINT
        if inside:
            pair[found], along[found] = k, on_path
            position[found, 0], position[found, 1] = x, y
            found += 1
    return pair[:found].copy(), along[:found].copy(), position[:found].copy()


def _split_into_chords(start: F64, end: F64, bulge: F64) -> tuple[F64, I64, F64, F64]:
    """Split n lines and arcs into k chords; a line is one chord.

    Returns
    -------
    chords : (k, 2, 2) mm
        Ends of the chords.
    owner : (k,)
        Index of the line or arc that each chord replaces.
    low, size : (k,) and (k,)
        Parameter of the line or arc, 0 … 1, at which the chord starts, and the range of the
        parameter that the chord covers.
    """
    if not bulge.any():
        rows = np.arange(len(bulge))
        chords = np.stack([start, start + (end - start)], axis=1)
        return chords, rows, np.zeros(len(rows)), np.ones(len(rows))
    count = np.where(np.abs(bulge) < BULGE, 1, _CHORDS_PER_ARC)
    owner = np.repeat(np.arange(len(bulge)), count)
    low = (np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)) / count[owner]
    size = 1.0 / count[owner]
    curves = start[owner], end[owner], bulge[owner]
    points = np.stack([arc.point_at(*curves, low), arc.point_at(*curves, low + size)], axis=1)
    return points, owner, low, size


def _bounding_boxes(chords: F64) -> F64:
    """Return the bounding boxes of chords, (k, 4) mm: x min, y min, x max, y max."""
    return arc.bounding_boxes(chords[:, 0], chords[:, 1], np.zeros(len(chords)))


def double_creases(paths: Paths, distance: float, source: I32) -> tuple[Paths, I32, I32]:
    """Replace each path by two parallel paths.

    Parameters
    ----------
    distance : mm
        Distance between the two paths; the drawn path lies midway between them.
    source : (n,)
        Index in the dieline of the edge of each segment, for error messages.

    Returns
    -------
    The new paths, the index in ``paths`` of the path that each new path replaces, and the index of
    the segment of ``paths`` that each new segment replaces.

    Raises
    ------
    EdgeTooShort
        A crease has a bend with a radius of less than half of ``distance``.
    """
    half = distance / 2.0
    radius = arc.radius(paths.start, paths.end, paths.bulge)
    tight = np.flatnonzero(radius <= half * 1.001)
    if len(tight):
        raise EdgeTooShort(
            "crease.tight-bend",
            edge=source[tight[0]],
            radius=radius[tight[0]],
            offset=half,
            source=[str(source[row]) for row in tight[:10]],
        )
    old_path = np.repeat(np.arange(len(paths), dtype=np.int32), 2)
    pair, rows = select_paths(paths, old_path)
    owner = pair.path_of
    ahead, last = arc.tangents(pair.start, pair.end, pair.bulge)
    ahead, last = left_normal(unit_vectors(ahead)), left_normal(unit_vectors(last))
    # At a joint the parallel lines meet on the mitre of both normals.
    before = np.roll(last, 1, axis=0)
    after = np.roll(ahead, -1, axis=0)
    first, final = pair.first[:-1], pair.first[1:] - 1
    smooth = (last[final] * ahead[first]).sum(axis=1) >= cos(radians(ANGLE))
    closed = (pair.closed & smooth)[:, None]
    before[first] = np.where(closed, last[final], ahead[first])
    after[final] = np.where(closed, ahead[first], last[final])
    side = np.where(owner % 2 == 0, half, -half)[:, None]
    return (
        Paths(
            pair.start + side * _mitre_offset(before, ahead),
            pair.end + side * _mitre_offset(last, after),
            pair.bulge,
            pair.first,
        ),
        old_path,
        rows,
    )


def _mitre_offset(one: F64, other: F64) -> F64:
    """Return the offset from each of n joints of two lines to the joint of their parallels at
    distance 1, (n, 2).

    ``one`` and ``other`` are the unit normals of the two lines at each joint, (n, 2).  The
    parallels lie on the side to which the normals point.
    """
    both = one + other
    result: F64 = both / (1.0 + (one * other).sum(axis=1))[:, None]
    return result
