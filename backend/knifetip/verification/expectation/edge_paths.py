"""Paths that edges form by following each other end to end.

Ends of edges are linked if a path continues there from one edge to the next.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_1, I64_1, kernel
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import point_at
from knifetip.verification.curves.near_points import pair_distances
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    STRAIGHT_ANGLE,
    TOUCH_DISTANCE,
    Edges,
    angle_between,
)

#: Distance from a common end at which edges are compared for coincidence (mm).
_COINCIDENT_PROBE: Final = 2.0


def link_ends(edges: Edges, kink: float, ring: Bool | None = None) -> tuple[I64, Bool]:
    """Link the ends of n edges at which a path continues from one edge to the next.

    Two ends that meet no third end are linked if the path turns by at most ``kink`` degrees there.
    If more ends meet, two collinear ends are linked, unless one of them could also be linked to a
    third end.  Where exactly two edges of closed contours meet, they are linked at any angle.

    Parameters
    ----------
    edges
        The n edges.  End 2i is the start of edge i, and end 2i + 1 is its end.
    kink : degrees
        Greatest angle by which a path turns at linked ends.
    ring : (n,)
        Mask of the edges of closed contours; None for no edge.

    Returns
    -------
    Index of the end that each end is linked to, (2n,), -1 for none; and the mask of the ends at
    which another edge continues straight, whether or not the two are linked, (2n,).
    """
    count = len(edges.ends)
    a, b, turn, goes_on = edges.compute_once("joined ends", lambda: _joined_pairs(edges))
    if ring is not None:
        both = ring[a // 2] & ring[b // 2]
        rung = np.bincount(a[both], minlength=count) == 1
        both &= rung[a] & rung[b]
        taken = np.zeros(count, np.bool_)
        taken[a[both]] = True
        keep = both | ~(taken[a] | taken[b])
        a, b, turn = a[keep], b[keep], np.where(both, 0.0, turn)[keep]
    crowd = np.bincount(a, minlength=count)
    fits = np.where((crowd[a] == 1) & (crowd[b] == 1), turn <= kink + 1e-9, turn <= STRAIGHT_ANGLE)
    a, b = a[fits], b[fits]
    single = np.bincount(a, minlength=count) == 1
    link = np.full(count, -1, np.int64)
    mutual = single[a] & single[b]
    link[a[mutual]] = b[mutual]
    return link, goes_on.copy()


def _joined_pairs(edges: Edges) -> tuple[I64, I64, F64, Bool]:
    """Return the k pairs of ends of different edges that lie at one point, and where edges continue
    straight.

    Returns the two ends of each pair, (k,) each; the angle by which a path turns there, (k,)
    degrees; and the mask of the 2n ends at which another edge continues straight.
    """
    a, b = edges.near_ends(TOUCH_DISTANCE)
    keep = a // 2 != b // 2
    a, b = a[keep], b[keep]
    turn = angle_between(edges.outward[a], edges.outward[b] + 180.0)
    goes_on = np.zeros(len(edges.ends), np.bool_)
    goes_on[a[turn <= STRAIGHT_ANGLE]] = True
    joined = pair_distances(edges.ends, a, edges.ends, b) <= JOIN_DISTANCE
    # Coincident edges are not linked back along each other.
    back = np.flatnonzero(joined & (turn >= 180.0 - STRAIGHT_ANGLE))
    joined[back] = ~_are_coincident(edges, a[back], b[back])
    return a[joined], b[joined], turn[joined], goes_on


def _are_coincident(edges: Edges, end_a: I64, end_b: I64) -> Bool:
    """Return the mask of the pairs of edge ends whose two edges coincide near these ends, (k,).

    ``end_a`` and ``end_b`` are the indices of the two ends of each of k pairs.  The two ends of a
    pair lie at one point.
    """
    size = np.minimum(edges.curve[end_a // 2, 5], edges.curve[end_b // 2, 5])
    inward = np.minimum(size, _COINCIDENT_PROBE)
    points = [
        point_at(curve, np.where(end % 2 == 0, inward, curve[:, 5] - inward))
        for end, curve in ((end_a, edges.curve[end_a // 2]), (end_b, edges.curve[end_b // 2]))
    ]
    result: Bool = np.hypot(*(points[0] - points[1]).T) <= JOIN_DISTANCE
    return result


@dataclass(frozen=True, eq=False, slots=True)
class EdgePaths:
    """c paths, each a sequence of edges that follow each other end to end; n edges in total."""

    path: I64  #: (n,) the path of each edge
    begin: F64  #: (n,) mm from the start of the path to the edge
    flipped: Bool  #: (n,) the path runs from the edge's end to its start
    length: F64  #: (c,) length of each path, mm
    first: I64  #: (c,) end at which the path begins, -1 if it is closed
    last: I64  #: (c,) end at which the path stops

    def intervals(self, low: F64, high: F64, curve: F64) -> tuple[F64, F64]:
        """Convert one interval of each of the c paths to intervals of the n edges of the paths.

        Parameters
        ----------
        low, high : (c,) mm
            Start and end of the interval of each path, measured from the start of the path.
        curve : (n, 6)
            The edges: lines and arcs as rows of six numbers (see ``curves.curve``).

        Returns
        -------
        Two arrays, (n,) mm each: start and end of the interval along each edge; end < start if the
        edge is outside the interval of its path.
        """
        size = curve[:, 5]
        near = np.clip(low[self.path] - self.begin, 0.0, None)
        far = np.minimum(high[self.path] - self.begin, size)
        own_low = np.where(self.flipped, size - far, near)
        own_high = np.where(self.flipped, size - near, far)
        return own_low, own_high

    def locate(self, path: I64, position: F64, curve: F64) -> tuple[I64, F64]:
        """Return the edge at each of k positions on paths, and the position along that edge.

        Parameters
        ----------
        path, position : (k,)
            Index of the path of each position, and its distance from the start of that path (mm).
        curve : (n, 6)
            The edges of the paths: lines and arcs as rows of six numbers (see ``curves.curve``).

        Returns
        -------
        Index of the edge, (k,), and position along the edge, (k,) mm.
        """
        order = np.lexsort((self.begin, self.path))
        widest = float(self.length.max(initial=0.0)) + 1.0
        key = self.path[order] * widest + self.begin[order]
        rows = order[np.searchsorted(key, path * widest + position, side="right") - 1]
        along = np.clip(position - self.begin[rows], 0.0, curve[rows, 5])
        return rows, np.where(self.flipped[rows], curve[rows, 5] - along, along)


def joined_ends(edges: Edges) -> I64:
    """Return the index of the end to which each of the 2n ends of n edges is linked, (2n,).

    Two ends that meet no third end are linked, at any angle.  If more ends meet, two collinear ends
    are linked, unless one of them could also be linked to a third end.  The index is -1 for an end
    without a link.  End 2i is the start of edge i, and end 2i + 1 is its end.
    """
    return link_ends(edges, 180.0)[0]


def count_joined_ends(edges: Edges) -> I64:
    """Return how many other ends meet each of the 2n ends of n edges, (2n,).

    End 2i is the start of edge i, and end 2i + 1 is its end.  Ends of coincident edges do not meet.
    """
    joined = edges.compute_once("joined ends", lambda: _joined_pairs(edges))[0]
    return np.bincount(joined, minlength=len(edges.ends))


def turns_at_ends(edges: Edges) -> F64:
    """Return the angle by which a path turns at each of the 2n ends of n edges, (2n,) degrees.

    It is 0 where not exactly two edges meet.
    """
    joined, _, turn, _ = edges.compute_once("joined ends", lambda: _joined_pairs(edges))
    result: F64 = np.bincount(joined, turn, minlength=len(edges.ends)).astype(np.float64)
    result[np.bincount(joined, minlength=len(edges.ends)) != 1] = 0.0
    return result


def continues_straight(edges: Edges) -> Bool:
    """Return the mask of the 2n ends of n edges at which another edge continues straight, (2n,).

    End 2i is the start of edge i, and end 2i + 1 is its end.
    """
    return link_ends(edges, STRAIGHT_ANGLE)[1]


def edge_paths(edges: Edges, link: I64) -> EdgePaths:
    """Return the paths that n edges with linked ends form.

    Parameters
    ----------
    edges
        The n edges.  End 2i is the start of edge i, and end 2i + 1 is its end.
    link : (2n,)
        Index of the end that each end is linked to, -1 for none.
    """
    path, begin, flipped, length, first, last, count = _trace_paths(link, edges.curve[:, 5].copy())
    return EdgePaths(path, begin, flipped, length[:count], first[:count], last[:count])


@kernel
def _trace_paths(link: I64_1, size: F64_1) -> Any:
    count = len(size)
    path = np.full(count, -1, np.int64)
    begin = np.zeros(count)
    flipped = np.zeros(count, np.bool_)
    length = np.zeros(count)
    first = np.full(count, -1, np.int64)
    last = np.full(count, -1, np.int64)
    paths = 0
    for edge in range(count):
        if path[edge] >= 0:
            continue
        tail = 2 * edge
        closed = False
        while link[tail] >= 0:
            tail = link[tail] ^ 1
            if tail == 2 * edge:
                closed = True
                break
        if not closed:
            first[paths] = tail
        position = 0.0
        while tail >= 0 and path[tail // 2] < 0:
            path[tail // 2] = paths
            begin[tail // 2] = position
            flipped[tail // 2] = tail % 2 == 1
            position += size[tail // 2]
            if not closed:
                last[paths] = tail ^ 1
            tail = link[tail ^ 1]
        length[paths] = position
        paths += 1
    return path, begin, flipped, length, first, last, paths
