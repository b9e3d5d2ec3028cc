"""Creases: a crease that a cut crosses is two, and some boards fold over two lines.

    Paths of creases -> Paths, split where cuts run through them, or doubled

Either side of the cut keeps its own clearance; the lines of a double crease are equally long.
"""

from __future__ import annotations

from math import radians, sin

import numpy as np

from knifetip.errors import EdgeTooShort
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left, unit
from knifetip.geometry.chain import outward
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.path import Paths, taken
from knifetip.geometry.tolerance import ANGLE, BULGE, GAP
from knifetip.planning.near import near

#: A cut that leaves a crease at less than this runs along it (sine of 1°).
_ACROSS = sin(radians(ANGLE))
#: Chords by which an arc is looked at.
_CHORDS = 128


def split_at_cuts(paths: Paths, ends: F64, bulge: F64) -> tuple[Paths, I32, Bool]:
    """Return the paths split where cuts run through them.

    A cut that only touches a path from one side, or that a path ends on, splits nothing.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        The cuts.

    Returns
    -------
    Paths
        In the order of the old ones.
    row : (m,)
        The old segment of each new one.
    split : (q, 2)
        Whether each new path begins, and ends, where it was split.
    """
    segment, share = run_through(paths, ends, bulge)
    count = len(paths.bulge)
    row = np.concatenate([np.arange(count), segment])
    low = np.concatenate([np.zeros(count), share])
    fresh = np.arange(len(row)) >= count
    order = np.lexsort((fresh, low, row))
    row, low, fresh = row[order], low[order], fresh[order]
    high = np.where(np.append(row[1:] != row[:-1], True), 1.0, np.roll(low, -1))
    # Between two cuts in one place, and before a cut through a joint, nothing is left.
    size = arc.length(paths.start, paths.end, paths.bulge)[row] * (high - low)
    some = (size > GAP) | ((low == 0.0) & (high == 1.0))
    row, low, high, fresh = row[some], low[some], high[some], fresh[some]
    near_end, far_end, bent = arc.part(
        paths.start[row], paths.end[row], paths.bulge[row], low, high
    )
    owner = paths.path_of[row]
    starts = np.flatnonzero(fresh | np.append(True, owner[1:] != owner[:-1]))
    result = Paths(
        np.where((low == 0.0)[:, None], paths.start[row], near_end),
        np.where((high == 1.0)[:, None], paths.end[row], far_end),
        np.where((low == 0.0) & (high == 1.0), paths.bulge[row], bent),
        np.append(starts, len(row)),
    )
    begun = fresh[starts]
    # A path was split at its end where the next one of its owner begins so.
    split = np.stack([begun, np.append(begun[1:], False)], axis=1)
    return result, row.astype(np.int32), split


def run_through(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, F64]:
    """Return the segments that cuts run through, and where, as a share of their length.

    A cut runs through in its own middle, or goes on as another where it ends on the segment.
    """
    if len(paths) == 0 or len(bulge) == 0:
        return np.zeros(0, np.int64), np.zeros(0)
    segment, _, share = crossings(paths, ends, bulge)
    at_vertex, on = _vertices(paths, ends, bulge)
    return np.concatenate([segment, at_vertex]), np.concatenate([share, on])


def _vertices(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, F64]:
    """Return the segments on which cuts end that leave on both sides, and where."""
    points = ends.reshape(-1, 2)
    boxes = arc.bounds(paths.start, paths.end, paths.bulge)
    end, row = near(np.hstack([points, points]), boxes, GAP)
    if len(end) == 0:
        return np.zeros(0, np.int64), np.zeros(0)
    whole = paths.start[row], paths.end[row], paths.bulge[row]
    share = arc.nearest(*whole, points[end])
    place = arc.point_at(*whole, share)
    stops = np.stack([paths.start[paths.first[:-1]], paths.end[paths.first[1:] - 1]], axis=1)
    path = paths.path_of[row]
    on = np.hypot(*(place - points[end]).T) <= GAP
    for stop in (stops[path, 0], stops[path, 1]):
        on &= np.hypot(*(place - stop).T) > GAP
    # Of a joint the segment after it.
    on &= share < 1.0 - 1e-9
    end, row, share = end[on], row[on], share[on]
    ahead = unit(arc.tangent_at(paths.start[row], paths.end[row], paths.bulge[row], share))
    side = (left(ahead) * outward(ends, bulge).reshape(-1, 2)[end]).sum(axis=1)
    # What hardly leaves the crease before it ends has only been drawn a little too long.
    size = arc.length(ends[:, 0], ends[:, 1], bulge)[end // 2]
    side[np.abs(side) * size <= GAP] = 0.0
    order = np.lexsort((share, row))
    row, share, side = row[order], share[order], side[order]
    along = share * arc.length(paths.start, paths.end, paths.bulge)[row]
    new = np.append(True, (row[1:] != row[:-1]) | (np.diff(along) > GAP))[: len(row)]
    group = np.cumsum(new) - 1
    both = np.zeros((int(new.sum()), 2), np.bool_)
    both[group[side > _ACROSS], 0] = True
    both[group[side < -_ACROSS], 1] = True
    met = np.flatnonzero(new)[both.all(axis=1)]
    return row[met], share[met]


def crossings(paths: Paths, ends: F64, bulge: F64) -> tuple[I64, I64, F64]:
    """Return the segments that cuts run through, which cuts, and where, as a share of length."""
    mine, owner, low, size = _chords(paths.start, paths.end, paths.bulge)
    cuts, cut, _, _ = _chords(ends[:, 0], ends[:, 1], bulge)
    i, j = near(_boxes(mine), _boxes(cuts), 0.0)
    p, r = mine[i, 0], mine[i, 1] - mine[i, 0]
    q, s = cuts[j, 0], cuts[j, 1] - cuts[j, 0]
    turn = r[:, 0] * s[:, 1] - r[:, 1] * s[:, 0]
    crossing = np.abs(turn) > 1e-9 * np.hypot(*r.T) * np.hypot(*s.T)
    safe = np.where(crossing, turn, 1.0)
    off = q - p
    along = (off[:, 0] * s[:, 1] - off[:, 1] * s[:, 0]) / safe
    across = (off[:, 0] * r[:, 1] - off[:, 1] * r[:, 0]) / safe
    crossing &= (along >= 0.0) & (along < 1.0) & (across >= 0.0) & (across < 1.0)
    place = p + r * along[:, None]
    path = paths.path_of[owner[i]]
    stops = np.stack([paths.start[paths.first[:-1]], paths.end[paths.first[1:] - 1]], axis=1)
    for touched in (stops[path, 0], stops[path, 1], ends[cut[j], 0], ends[cut[j], 1]):
        crossing &= np.hypot(*(place - touched).T) > GAP
    hit = np.flatnonzero(crossing)
    at = i[hit]
    return owner[at], cut[j[hit]], low[at] + along[hit] * size[at]


def _chords(start: F64, end: F64, bulge: F64) -> tuple[F64, I64, F64, F64]:
    """Return chords (k, 2, 2), whose they are, where each begins on it and its share of it."""
    count = np.where(np.abs(bulge) < BULGE, 1, _CHORDS)
    owner = np.repeat(np.arange(len(bulge)), count)
    low = (np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)) / count[owner]
    size = 1.0 / count[owner]
    whole = start[owner], end[owner], bulge[owner]
    points = np.stack([arc.point_at(*whole, low), arc.point_at(*whole, low + size)], axis=1)
    return points, owner, low, size


def _boxes(chords: F64) -> F64:
    return np.hstack([chords.min(axis=1), chords.max(axis=1)])


def doubled(paths: Paths, apart: float, source: I32) -> tuple[Paths, I32, I32]:
    """Return each path as two beside it, and the old path and the old segment of each new one.

    Parameters
    ----------
    apart : mm
        From one line of a pair to the other; each stands half of it off the drawn one.
    source : (n,)
        The edge of each segment, for the error.

    Raises
    ------
    EdgeTooShort
        A crease bends more tightly than half of that.
    """
    half = apart / 2.0
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
    which = np.repeat(np.arange(len(paths), dtype=np.int32), 2)
    pair, rows = taken(paths, which)
    owner = pair.path_of
    ahead, last = arc.tangents(pair.start, pair.end, pair.bulge)
    ahead, last = left(unit(ahead)), left(unit(last))
    # At a joint the lines meet on the mitre of both normals.
    before = np.roll(last, 1, axis=0)
    after = np.roll(ahead, -1, axis=0)
    first, final = pair.first[:-1], pair.first[1:] - 1
    closed = pair.closed[:, None]
    before[first] = np.where(closed, last[final], ahead[first])
    after[final] = np.where(closed, ahead[first], last[final])
    side = np.where(owner % 2 == 0, half, -half)[:, None]
    return (
        Paths(
            pair.start + side * _mitre(before, ahead),
            pair.end + side * _mitre(last, after),
            pair.bulge,
            pair.first,
        ),
        which,
        rows,
    )


def _mitre(one: F64, other: F64) -> F64:
    """Return what stands 1 off both of two lines with these unit normals."""
    both = one + other
    result: F64 = both / (1.0 + (one * other).sum(axis=1))[:, None]
    return result
