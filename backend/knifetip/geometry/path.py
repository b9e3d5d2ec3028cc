"""path: many paths of lines and arcs in one set of columns.

Path p has the segments ``first[p] … first[p + 1] - 1``.  Each segment stores both ends, so that
paths need no separators: two segments are connected if the end of one is the start of the next.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.azimuth import azimuth, turn_angle
from knifetip.geometry.columns import F64, I32, Bool, freeze
from knifetip.geometry.tolerance import BULGE, POINT

#: Greatest error of an angle between two segments by rounding (degrees).
_KINK_ERROR: Final = 1e-6


@dataclass(frozen=True, eq=False, slots=True)
class Paths:
    """Paths of lines and arcs: p paths with n segments in total."""

    start: F64  #: (n, 2) mm, start of each segment
    end: F64  #: (n, 2) mm, end of each segment
    bulge: F64  #: (n,) tan(sweep / 4): 0 a line, > 0 an arc to the left
    first: I32  #: (p + 1,) first segment of each path; the last entry is n

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "start", freeze(self.start, np.float64, -1, 2))
        put(self, "end", freeze(self.end, np.float64, len(self.start), 2))
        put(self, "bulge", freeze(self.bulge, np.float64, len(self.start)))
        put(self, "first", freeze(self.first, np.int32, -1))
        if len(self.first) == 0 or self.first[-1] != len(self.start):
            raise ValueError("first must end with the number of segments")

    def __len__(self) -> int:
        return len(self.first) - 1

    @property
    def path_of(self) -> I32:
        """Number of the path that each of the n segments belongs to, (n,)."""
        return np.repeat(np.arange(len(self), dtype=np.int32), np.diff(self.first))

    @property
    def lengths(self) -> F64:
        """Length of each of the p paths, (p,) mm."""
        along = arc.length(self.start, self.end, self.bulge)
        return np.bincount(self.path_of, along, minlength=len(self)).astype(np.float64)

    @property
    def areas(self) -> F64:
        """Signed area enclosed by each of the p paths, (p,) mm², > 0 if counter-clockwise.

        An open path is closed by a straight line from its end to its start.
        """
        # Relative to the first point of each path, so that no digits are lost far from the origin.
        origin = self.start[self.first[:-1]][self.path_of]
        a, b = self.start - origin, self.end - origin
        swept = arc.sweep(self.bulge)
        radius = arc.radius(self.start, self.end, self.bulge)
        segment = np.where(np.isfinite(radius), radius, 0.0) ** 2 * (swept - np.sin(swept))
        twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] + segment
        area: F64 = np.bincount(self.path_of, twice, minlength=len(self)) / 2.0
        return area

    @property
    def closed(self) -> Bool:
        """Whether each of the p paths ends at its start, (p,)."""
        gap = self.start[self.first[:-1]] - self.end[self.first[1:] - 1]
        result: Bool = np.hypot(gap[:, 0], gap[:, 1]) < POINT
        return result


def path_through(xy: F64, bulge: F64) -> Paths:
    """Return one path through n + 1 points, ``xy`` (n + 1, 2) mm.

    ``bulge`` (n,) is the bulge of the line or arc from each point to the next one.
    """
    return Paths(xy[:-1], xy[1:], bulge, np.array([0, len(bulge)]))


def trim_ends(paths: Paths, at_start: F64, at_end: F64) -> tuple[Paths, I32]:
    """Return the paths shortened at their starts and ends, and the origin of each segment.

    The origin is the input segment that a returned segment comes from.  A path that is not longer
    than the removed lengths has no segments.

    Parameters
    ----------
    at_start, at_end : (p,) mm, not negative
        Lengths to remove at the start and at the end of each path.
    """
    along = arc.length(paths.start, paths.end, paths.bulge)
    if not (at_start.any() or at_end.any()) and (POINT / along < 1.0).all():
        return paths, np.arange(len(along), dtype=np.int32)
    owner = paths.path_of
    reached = np.cumsum(along)
    before = np.concatenate([[0.0], reached])[paths.first[:-1]]
    begin = reached - along - before[owner]
    low = (at_start[owner] - begin) / along
    high = (paths.lengths[owner] - at_end[owner] - begin) / along
    # Segments that are not shortened must remain equal, bit for bit.
    low = np.where(low > POINT / along, low, 0.0)
    high = np.where(high < 1.0 - POINT / along, high, 1.0)
    kept = high - low > POINT / along
    rows: I32 = np.flatnonzero(kept).astype(np.int32)
    start, end = paths.start[rows], paths.end[rows]
    bulge, low, high = paths.bulge[rows], low[rows], high[rows]
    near, far, bent = arc.sub_arc(start, end, bulge, low, high)
    near = np.where((low == 0.0)[:, None], start, near)
    far = np.where((high == 1.0)[:, None], end, far)
    whole = (low == 0.0) & (high == 1.0)
    first = np.concatenate([[0], np.cumsum(np.bincount(owner[rows], minlength=len(paths)))])
    return Paths(near, far, np.where(whole, bulge, bent), first), rows


def select_paths(paths: Paths, numbers: I32) -> tuple[Paths, I32]:
    """Return some of the paths, and the input segment that each returned segment comes from.

    Parameters
    ----------
    numbers : (q,)
        Numbers of the paths to return, in the order of the result; numbers may repeat.
    """
    count = np.diff(paths.first)[numbers]
    first = np.concatenate([[0], np.cumsum(count)])
    rows = np.arange(first[-1]) + np.repeat(paths.first[:-1][numbers] - first[:-1], count)
    return Paths(paths.start[rows], paths.end[rows], paths.bulge[rows], first), rows.astype(
        np.int32
    )


def insert_gaps(paths: Paths, path: I32, middle: F64, gap: float | F64) -> tuple[Paths, I32, I32]:
    """Cut gaps into closed paths, and return all paths.

    A closed path with n gaps becomes n open paths; a path without gaps is returned unchanged.

    Parameters
    ----------
    path, middle : (k,) and (k,) mm
        Path of each gap, and the distance of the gap's middle from the start along the path.  Gaps
        are sorted by path.
    gap : mm
        Length of the gaps, one for all or (k,).

    Returns
    -------
    paths : Paths
        q paths with m segments.
    owner : (q,)
        Input path that each returned path comes from.
    rows : (m,)
        Input segment that each returned segment comes from.
    """
    many = np.bincount(path, minlength=len(paths))
    owner = np.repeat(np.arange(len(paths), dtype=np.int32), np.maximum(many, 1))
    gapped = many[owner] > 0
    length = paths.lengths
    begin, end = np.zeros(len(owner)), length[owner]
    first = np.append(True, path[1:] != path[:-1])[: len(path)]
    following = np.append(middle[1:], 0.0)[: len(path)]
    # The last piece continues past the start of the path.
    last = np.flatnonzero(np.roll(first, -1))
    following[last] = middle[first] + length[path[last]]
    half = np.broadcast_to(gap, middle.shape) / 2.0
    next_half = np.append(half[1:], 0.0)[: len(path)]
    next_half[last] = half[first]
    begin[gapped], end[gapped] = middle + half, following - next_half
    twice, rows = _traverse_twice(paths, many > 0)
    repeated, again = select_paths(twice, owner)
    pieces, order = trim_ends(repeated, begin, np.maximum(repeated.lengths - end, 0.0))
    return pieces, owner, rows[again[order]]


def _traverse_twice(paths: Paths, mask: Bool) -> tuple[Paths, I32]:
    """Return all paths, some of them repeated, and the input segment of each returned segment.

    A repeated path runs through all its segments twice.  ``mask`` (p,) is the mask of the paths to
    repeat.
    """
    count = np.diff(paths.first)
    times = np.where(mask, 2, 1)
    first = np.concatenate([[0], np.cumsum(count * times)])
    owner = np.repeat(np.arange(len(paths)), count * times)
    rows = paths.first[owner] + (np.arange(first[-1]) - first[owner]) % count[owner]
    return Paths(paths.start[rows], paths.end[rows], paths.bulge[rows], first), rows.astype(
        np.int32
    )


def point_along(paths: Paths, distance: F64) -> tuple[F64, F64, I32]:
    """Return a point of each of p paths, the direction of the path there, and the point's segment.

    Parameters
    ----------
    distance : (p,) mm
        Distance of the point from the start of the path, measured along the path.

    Returns
    -------
    xy : (p, 2) mm
        The points.
    azimuth : (p,) degrees
        Direction of the path at each point.
    segment : (p,)
        Segment on which each point is.
    """
    along = arc.length(paths.start, paths.end, paths.bulge)
    reached = np.cumsum(along)
    before = np.concatenate([[0.0], reached])
    wanted = before[paths.first[:-1]] + distance
    rows = np.clip(np.searchsorted(reached, wanted), paths.first[:-1], paths.first[1:] - 1)
    fraction = np.clip((wanted - before[rows]) / along[rows], 0.0, 1.0)
    start, end, bulge = paths.start[rows], paths.end[rows], paths.bulge[rows]
    ahead = azimuth(arc.tangents(start, end, bulge)[0])
    heading: F64 = ahead + np.degrees(arc.sweep(bulge)) * fraction
    return arc.point_at(start, end, bulge, fraction), heading, rows.astype(np.int32)


def lengths_behind_corners(paths: Paths, kink: float) -> F64:
    """Return the length of each of p paths from its last corner to its end, (p,) mm.

    A corner is a joint of two segments at which the path turns by more than ``kink`` degrees.  The
    length is infinite for a path without a corner.  The start of a closed path is no corner.
    """
    result = np.full(len(paths), np.inf)
    if len(paths.bulge) == len(paths):
        return result
    ahead, arriving = arc.tangents(paths.start, paths.end, paths.bulge)
    turn = np.zeros(len(paths.bulge))
    turn[1:] = np.abs(turn_angle(azimuth(arriving)[:-1], azimuth(ahead)[1:]))
    turn[paths.first[:-1]] = 0.0
    # Exactly this angle, as it may be drawn, is no corner, however it is rounded.
    corner = np.flatnonzero(turn > kink + _KINK_ERROR)
    if not len(corner):
        return result
    reached = np.concatenate([[0.0], np.cumsum(arc.length(paths.start, paths.end, paths.bulge))])
    owner = paths.path_of[corner]
    # The last assignment to a path is that of its last corner.
    result[owner] = reached[paths.first[1:][owner]] - reached[corner]
    return result


def reverse_paths(paths: Paths, mask: Bool) -> tuple[Paths, I32]:
    """Return all paths, some of them reversed, and the input segment of each returned segment.

    Parameters
    ----------
    mask : (p,)
        Mask of the paths to reverse.
    """
    owner = paths.path_of
    rows = np.arange(len(paths.bulge))
    mirror = paths.first[:-1][owner] + paths.first[1:][owner] - 1 - rows
    turn = mask[owner]
    rows = np.where(turn, mirror, rows)
    start, end, bulge = paths.start[rows], paths.end[rows], paths.bulge[rows]
    back = turn[:, None]
    return (
        Paths(
            np.where(back, end, start),
            np.where(back, start, end),
            np.where(turn, -bulge, bulge),
            paths.first,
        ),
        rows.astype(np.int32),
    )


def start_at(paths: Paths, row: I32) -> tuple[Paths, I32]:
    """Return all paths, each starting with a given segment.

    Parameters
    ----------
    row : (p,)
        Segment with which each path starts.  It is the first segment of a path that is not closed.

    Returns
    -------
    paths : Paths
        The p paths with their n segments.
    rows : (n,)
        Input segment of each returned segment.
    """
    count = np.diff(paths.first)
    first = np.repeat(paths.first[:-1], count)
    place = np.arange(len(first)) - first + np.repeat(row - paths.first[:-1], count)
    rows: I32 = (first + place % np.repeat(count, count)).astype(np.int32)
    return Paths(paths.start[rows], paths.end[rows], paths.bulge[rows], paths.first), rows


def segments_before(paths: Paths) -> I32:
    """Return the segment before each of n segments, (n,); before the first of a path is the last
    one.
    """
    before: I32 = np.arange(-1, len(paths.bulge) - 1, dtype=np.int32)
    before[paths.first[:-1]] = paths.first[1:] - 1
    return before


def longest_segments(paths: Paths, *preferred: Bool) -> I32:
    """Return the longest line of each path, or its longest arc if the path has no line, (p,).

    The first one is returned if several are equally long.

    Parameters
    ----------
    preferred : (n,)
        Masks of the n segments of which one is returned, for paths that have such segments.  A
        later mask counts only among the segments that the masks before it leave.
    """
    if len(paths) == 0:
        return np.zeros(0, np.int32)
    owner, first = paths.path_of, paths.first[:-1]
    along = arc.length(paths.start, paths.end, paths.bulge)
    eligible = np.ones(len(owner), np.bool_)
    for better in (*preferred, np.abs(paths.bulge) < BULGE):
        both = eligible & better
        eligible &= both | ~np.logical_or.reduceat(both, first)[owner]
    size = np.where(eligible, along, -1.0)
    longest = np.flatnonzero(size == np.maximum.reduceat(size, first)[owner])
    result: I32 = longest[np.searchsorted(longest, first)].astype(np.int32)
    return result


def start_in_middle(paths: Paths, mask: Bool, segment: I32) -> tuple[Paths, I32]:
    """Return all paths, some of them with their start moved to the middle of a segment.

    The segment is split in two halves, which become the first and the last segment of the path.

    Parameters
    ----------
    mask : (p,)
        Mask of the paths whose start is moved; they must be closed.
    segment : (p,)
        Segment of each path in which the path starts; not used for the other paths.

    Returns
    -------
    paths : Paths
        All p paths, with m segments.
    rows : (m,)
        Input segment that each returned segment comes from.
    """
    count = np.diff(paths.first) + mask
    first = np.concatenate([[0], np.cumsum(count)])
    place = np.arange(first[-1]) - np.repeat(first[:-1], count)
    size = np.repeat(np.diff(paths.first), count)
    turned = np.repeat(mask, count)
    shift = np.where(turned, np.repeat(segment - paths.first[:-1], count), 0)
    rows = np.repeat(paths.first[:-1], count) + (place + shift) % size
    low = np.where(turned & (place == 0), 0.5, 0.0)
    high = np.where(turned & (place == size), 0.5, 1.0)
    start, end, bulge = paths.start[rows], paths.end[rows], paths.bulge[rows]
    half = (low > 0.0) | (high < 1.0)
    near, far, bent = arc.sub_arc(start, end, bulge, low, high)
    return (
        Paths(
            np.where((low > 0.0)[:, None], near, start),
            np.where((high < 1.0)[:, None], far, end),
            np.where(half, bent, bulge),
            first,
        ),
        rows.astype(np.int32),
    )
