"""creases: split creases where cuts cross them, and replace creases by double creases.

Both parts of a split crease end at the board's end clearance from the cut.  The two lines of a
double crease end at the same positions as the drawn crease.
"""

from __future__ import annotations

from math import cos, hypot, radians, sin
from typing import Any, NamedTuple

import numpy as np

from knifetip.errors import EdgeTooShort
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.chain import outward_directions
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.intersect import intersect_pairs
from knifetip.geometry.path import Paths, select_paths
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import ANGLE, BULGE, GAP
from knifetip.kernels import F64_3, I64_1, kernel

#: A cut at a smaller angle runs along a crease and does not cross it (sine of 1°).
_ACROSS = sin(radians(ANGLE))
#: Number of chords that approximate an arc.
_CHORDS_PER_ARC = 128


def split_at_cuts(paths: Paths, ends: F64, bulge: F64) -> tuple[Paths, I32, Bool]:
    """Return the paths, split where cuts cross them.

    A path is not split by a cut that only touches it from one side, nor by a cut on which the path
    ends.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the cuts.

    Returns
    -------
    Paths
        The q new paths with m segments, in the order of ``paths``.
    row : (m,)
        Segment of ``paths`` from which each new segment comes.
    split : (q, 2)
        Whether the start, and whether the end, of each new path is at a split.
    """
    segment, fraction = find_cut_crossings(paths, ends, bulge)
    count = len(paths.bulge)
    row = np.concatenate([np.arange(count), segment])
    low = np.concatenate([np.zeros(count), fraction])
    added = np.arange(len(row)) >= count
    order = np.lexsort((added, low, row))
    row, low, added = row[order], low[order], added[order]
    high = np.where(np.append(row[1:] != row[:-1], True), 1.0, np.roll(low, -1))
    # Drop stretches between two cuts at one point, and before a cut through a joint.
    size = arc.length(paths.start, paths.end, paths.bulge)[row] * (high - low)
    long_enough = (size > GAP) | ((low == 0.0) & (high == 1.0))
    row, low, high, added = (
        row[long_enough],
        low[long_enough],
        high[long_enough],
        added[long_enough],
    )
    near_end, far_end, bent = arc.sub_arc(
        paths.start[row], paths.end[row], paths.bulge[row], low, high
    )
    owner = paths.path_of[row]
    starts = np.flatnonzero(added | np.append(True, owner[1:] != owner[:-1]))
    result = Paths(
        np.where((low == 0.0)[:, None], paths.start[row], near_end),
        np.where((high == 1.0)[:, None], paths.end[row], far_end),
        np.where((low == 0.0) & (high == 1.0), paths.bulge[row], bent),
        np.append(starts, len(row)),
    )
    split_start = added[starts]
    # A path ends at a split if the next path starts at one.
    split = np.stack([split_start, np.append(split_start[1:], False)], axis=1)
    return result, row.astype(np.int32), split


def find_cut_crossings(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, F64]:
    """Return the k points at which cuts cross segments of paths.

    Returns the index of the segment of each point (k,), and the parameter of the point on the
    segment, 0 … 1 (k,).  A cut crosses a segment if their common point is an inner point
    of the path and of the cut.  Two cuts also cross a segment if they end at the same point of the
    segment, one on the left and one on the right of the segment.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the cuts.
    """
    if len(paths) == 0 or len(bulge) == 0:
        return np.zeros(0, np.int64), np.zeros(0)
    segment, _, fraction = inner_crossings(paths, ends, bulge)
    at_vertex, vertex_fraction = _crossings_at_cut_ends(paths, ends, bulge)
    return np.concatenate([segment, at_vertex]), np.concatenate([fraction, vertex_fraction])


def _crossings_at_cut_ends(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, F64]:
    """Return the k points of segments at which cuts from both sides of the segment end.

    Returns the segment of each point (k,), and the parameter of the point on it, 0 … 1 (k,).
    ``ends`` and ``bulge`` are the ends, (n, 2, 2) mm, and the bulges, (n,), of the cuts.
    """
    points = ends.reshape(-1, 2)
    boxes = arc.bounding_boxes(paths.start, paths.end, paths.bulge)
    end, row = box_pairs(np.hstack([points, points]), boxes, GAP)
    if len(end) == 0:
        return np.zeros(0, np.int64), np.zeros(0)
    segments = paths.start[row], paths.end[row], paths.bulge[row]
    fraction = arc.nearest_fraction(*segments, points[end])
    foot = arc.point_at(*segments, fraction)
    stops = np.stack([paths.start[paths.first[:-1]], paths.end[paths.first[1:] - 1]], axis=1)
    path = paths.path_of[row]
    touches = np.hypot(*(foot - points[end]).T) <= GAP
    for stop in (stops[path, 0], stops[path, 1]):
        touches &= np.hypot(*(foot - stop).T) > GAP
    # A point on a joint counts for the segment after it.
    touches &= fraction < 1.0 - 1e-9
    end, row, fraction = end[touches], row[touches], fraction[touches]
    ahead = unit_vectors(
        arc.tangent_at(paths.start[row], paths.end[row], paths.bulge[row], fraction)
    )
    side = (left_normal(ahead) * outward_directions(ends, bulge).reshape(-1, 2)[end]).sum(axis=1)
    # A cut that leaves the crease by less than GAP was only drawn slightly too long.
    size = arc.length(ends[:, 0], ends[:, 1], bulge)[end // 2]
    side[np.abs(side) * size <= GAP] = 0.0
    order = np.lexsort((fraction, row))
    row, fraction, side = row[order], fraction[order], side[order]
    along = fraction * arc.length(paths.start, paths.end, paths.bulge)[row]
    new = np.append(True, (row[1:] != row[:-1]) | (np.diff(along) > GAP))[: len(row)]
    group = np.cumsum(new) - 1
    both = np.zeros((int(new.sum()), 2), np.bool_)
    both[group[side > _ACROSS], 0] = True
    both[group[side < -_ACROSS], 1] = True
    crossed = np.flatnonzero(new)[both.all(axis=1)]
    return row[crossed], fraction[crossed]


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
    chords, owner, low, size = _split_into_chords(paths.start, paths.end, paths.bulge)
    cuts, cut, _, _ = _split_into_chords(ends[:, 0], ends[:, 1], bulge)
    chord, other = box_pairs(_bounding_boxes(chords), _bounding_boxes(cuts), 0.0)
    stops = np.stack([paths.start[paths.first[:-1]], paths.end[paths.first[1:] - 1]], axis=1)
    hit, along, position = _cross_inside(
        _Chords(chords, stops[paths.path_of[owner]]),
        _Chords(cuts, np.ascontiguousarray(ends[cut])),
        chord,
        other,
    )
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
    return segment, crossed, fraction


class _Chords(NamedTuple):
    """k chords of the segments of paths, or of cuts."""

    ends: F64_3  #: (k, 2, 2) mm
    stops: F64_3  #: (k, 2, 2) mm, ends of the path or the cut of each chord


@kernel
def _cross_inside(chords: _Chords, cuts: _Chords, one: I64_1, other: I64_1) -> Any:
    """Return the h pairs of chords that cross away from the ends of their path and their cut.

    A crossing is away from an end if it is more than ``GAP`` mm from the end.

    Parameters
    ----------
    chords, cuts
        Chords of paths, and chords of cuts.
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
        px, py = chords.ends[i, 0, 0], chords.ends[i, 0, 1]
        rx, ry = chords.ends[i, 1, 0] - px, chords.ends[i, 1, 1] - py
        qx, qy = cuts.ends[j, 0, 0], cuts.ends[j, 0, 1]
        sx, sy = cuts.ends[j, 1, 0] - qx, cuts.ends[j, 1, 1] - qy
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
            for stops in (chords.stops[i, end], cuts.stops[j, end]):
                inside = inside and hypot(x - stops[0], y - stops[1]) > GAP
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
