"""cut_crossings: find where cuts cross the segments of paths, such as creases."""

from __future__ import annotations

from math import hypot, radians, sin
from typing import Any, Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.chain import outward_directions
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.intersect import intersect_pairs
from knifetip.geometry.path import Paths
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import ANGLE, BULGE, GAP, POINT
from knifetip.kernels import F64_3, I64_1, kernel

#: A cut at a smaller angle runs along a crease and does not cross it (sine of 1°).
ACROSS: Final = sin(radians(ANGLE))
#: Number of chords that approximate an arc.
_CHORDS_PER_ARC: Final = 128


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
    segment, fraction = all_crossings(paths, ends, bulge)
    inner = are_inner(paths, segment, fraction)
    return segment[inner], fraction[inner]


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
    inner = are_inner(paths, segment, fraction)
    return segment[inner], cut[inner], fraction[inner]


def all_crossings(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, F64]:
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


def are_inner(paths: Paths, segment: I64, fraction: F64) -> Bool:
    """Return the mask of the points of paths that are more than ``GAP`` from the path's ends, (k,).

    ``segment`` is the segment of each point, (k,), and ``fraction`` its parameter, 0 … 1, (k,).  A
    joint between two segments of one path is not an end.
    """
    points = arc.point_at(paths.start[segment], paths.end[segment], paths.bulge[segment], fraction)
    stops = np.stack([paths.start[paths.first[:-1]], paths.end[paths.first[1:] - 1]], axis=1)
    away = np.hypot(*(points[:, None] - stops[paths.path_of[segment]]).transpose(2, 0, 1))
    result: Bool = (away > GAP + POINT).all(axis=1)
    return result


def begin_of_segments(paths: Paths, size: F64) -> F64:
    """Return the distance from the start of its path to the start of each segment, (n,) mm.

    ``size`` are the lengths of the n segments, (n,) mm.
    """
    before = np.append(0.0, np.cumsum(size))[:-1]
    result: F64 = before - before[paths.first[:-1]][paths.path_of]
    return result


def _are_along(paths: Paths, ends: F64, bulge: F64, segment: I64, cut: I64) -> Bool:
    """Return the mask of the k pairs of a straight segment and a straight cut along it, (k,).

    A cut along a crease, such as the end of a slot, crosses it only by rounding.  ``segment`` and
    ``cut`` are the indices of the two, (k,) each; ``ends`` and ``bulge`` are those of the cuts.
    """
    ahead = unit_vectors(paths.end[segment] - paths.start[segment])
    along = unit_vectors(ends[cut, 1] - ends[cut, 0])
    straight = (np.abs(paths.bulge[segment]) < BULGE) & (np.abs(bulge[cut]) < BULGE)
    result: Bool = straight & (np.abs((left_normal(ahead) * along).sum(axis=1)) <= ACROSS)
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
    leaves = (np.abs(side) > ACROSS) & (np.abs(side) * size > GAP + POINT)
    row, fraction, side = row[leaves], fraction[leaves], side[leaves]
    length = arc.length(paths.start, paths.end, paths.bulge)
    along = begin_of_segments(paths, length)[row] + fraction * length[row]
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

    ``point``, ``segment``, ``distance`` (k,), (k,) and (k,) mm: index of the point and of the
    segment of each touch, and their distance.
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
    crosses[bent[found & (sine <= ACROSS)]] = False
    return segment[crosses], crossed[crosses], fraction[crosses]


@kernel
def _cross_inside(chords: F64_3, cuts: F64_3, stops: F64_3, chord_a: I64_1, chord_b: I64_1) -> Any:
    """Return the h pairs of chords that cross more than ``GAP`` mm from the ends of the cut.

    ``chords``, ``cuts`` (k, 2, 2) and (c, 2, 2) mm: ends of chords of paths, and of chords of cuts.
    ``stops`` (c, 2, 2) mm: ends of the cut of each chord in ``cuts``.
    ``chord_a``, ``chord_b`` (p,) and (p,): index of the chord of the path, and index of the chord
    of the cut, of each pair.
    Returns ``pair, along, position`` (h,), (h,) and (h, 2) mm: index of each pair, parameter of the
    crossing on the chord of the path (0 … 1), and position of the crossing.
    """
    pair, along = np.empty(len(chord_a), np.int64), np.empty(len(chord_a))
    position = np.empty((len(chord_a), 2))
    found = 0
    for k in range(len(chord_a)):
        i, j = chord_a[k], chord_b[k]
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

    Returns ``chords`` (k, 2, 2) mm: ends of the chords; ``owner`` (k,): index of the line or arc
    that each chord replaces; ``low, size`` (k,) and (k,): parameter of the line or arc, 0 … 1, at
    which the chord starts, and the range of the parameter that the chord covers.
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
