"""chain: connect edges into paths.

If two ends of edges meet at a point, the two edges are connected.  If three or more ends meet, two
of them are connected only if one edge continues the other straight, and no third edge continues
either of these two straight.  In doubtful cases the edges stay unconnected, because a missing
connection does less harm than a wrong one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import ANGLE, GAP, JOIN
from knifetip.geometry.unique_rows import unique_rows
from knifetip.geometry.vertices import number_vertices, sort_by_vertex
from knifetip.kernels import F64_2, I64_1, kernel


@dataclass(frozen=True, eq=False, slots=True)
class Chains:
    """The p paths into which n edges are connected.

    The record contains the order and direction of the edges, and the first edge of each path.
    """

    order: I32  #: (n,) rows of the edges, path by path
    flipped: Bool  #: (n,) whether each edge in ``order`` is traversed backwards
    first: I32  #: (p + 1,) start of each path in ``order``; the last entry is n
    closed: Bool  #: (p,) whether the last edge of each path is connected to its first edge

    def paths(self, ends: F64, bulge: F64) -> Paths:
        """Return the chained edges as a record of paths with coordinates.

        Parameters
        ----------
        ends : (n, 2, 2) mm
            Start and end points of the edges from which the chains were made.
        bulge : (n,)
            Bulges of these edges.
        """
        ordered = ends[self.order]
        turned = np.where(self.flipped[:, None, None], ordered[:, ::-1], ordered)
        bent = np.where(self.flipped, -bulge[self.order], bulge[self.order])
        return Paths(turned[:, 0], turned[:, 1], bent, self.first)


def outward_directions(ends: F64, bulge: F64) -> F64:
    """Return the unit directions in which each edge leaves its start and its end, (n, 2, 2).

    Both directions point into the edge: from its start towards its end along the edge, and from its
    end backwards along the edge.

    Parameters
    ----------
    ends : (n, 2, 2) mm
        Start and end points of the edges.
    bulge : (n,)
        Bulges of the edges.

    Raises
    ------
    ZeroLengthEdge
        An edge without length has no direction.
    """
    ahead, last = arc.tangents(ends[:, 0], ends[:, 1], bulge)
    return np.stack([unit_vectors(ahead), -unit_vectors(last)], axis=1)


def chain(
    ends: F64, bulge: F64, max_turn: float = 180.0, gap: float = JOIN, group: I64 | None = None
) -> Chains:
    """Return the paths that n edges form if edges whose ends meet are connected.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points and bulges of the edges.
    max_turn : degrees
        Largest change of direction from one edge to the next edge of a path.  With 180 all edges
        that meet can be connected, with ``tolerance.ANGLE`` only edges that continue straight.
    gap : mm
        Ends nearer to each other than this meet.
    group : (n,)
        Number of the group of each edge; edges of different groups are not connected.  None if all
        edges are in one group.

    Returns
    -------
    Chains
        Paths in the order of their first edge; a closed path begins at its first edge.

    Raises
    ------
    ZeroLengthEdge
        An edge without length has no direction.
    """
    count = len(ends)
    if count == 0:
        none = np.zeros(0, np.bool_)
        return Chains(np.zeros(0, np.int32), none, np.zeros(1, np.int32), none)
    node = number_vertices(ends.reshape(-1, 2), gap)
    # Vertices are numbered as their first ends, so that one group would change no number.
    if group is not None and (group != group[0]).any():
        node = unique_rows(node, np.repeat(group, 2))[1].astype(np.int32)
    by_node, bounds = sort_by_vertex(node)
    link = _link_ends(
        outward_directions(ends, bulge).reshape(-1, 2),
        by_node,
        bounds,
        np.cos(np.radians(max_turn)) - 1e-12,
        np.cos(np.radians(min(max_turn, ANGLE))) - 1e-12,
    )
    return Chains(*follow_links(link))


def continues_straight(
    points: F64, directions: F64, angle: float = ANGLE, gap: float = GAP
) -> Bool:
    """Return the mask of path ends at which another path continues in a straight line, (m,).

    Parameters
    ----------
    points : (m, 2) mm
        The start and end points of all paths.
    directions : (m, 2)
        Unit directions from each of these points into its path.
    angle : degrees
        Largest turn that counts as straight.
    gap : mm
        Largest distance of two ends that count as one point.
    """
    if len(points) == 0:
        return np.zeros(0, np.bool_)
    node = number_vertices(points, gap)
    by_node, bounds = sort_by_vertex(node)
    result: Bool = _continues_straight(
        directions, by_node, bounds, np.cos(np.radians(angle)) - 1e-12
    )
    return result


@kernel
def _link_ends(
    outward: F64_2, by_node: I64_1, bounds: I64_1, any_turn: float, straight: float
) -> Any:
    """Return for each end of n edges the end to which it is connected, (2n,), -1 for none.

    The turn between two ends is measured by its cosine, which is minus the scalar product of their
    directions.

    ``outward`` (2n, 2): unit directions from the vertices into the edges, one per end; end 2i is
    the start of edge i.
    ``by_node`` (2n,): the ends, sorted by vertex.
    ``bounds`` (v + 1,): position in ``by_node`` of the first end of each of v vertices; the last
    entry is 2n.
    ``any_turn``: least cosine of the turn at which two ends are connected if no third end meets
    them.
    ``straight``: least cosine of the turn at which two ends are connected if three or more ends
    meet.
    """
    link = np.full(len(outward), -1, np.int64)
    for node in range(len(bounds) - 1):
        low = bounds[node]
        high = bounds[node + 1]
        if high - low == 2:
            a = by_node[low]
            b = by_node[low + 1]
            cosine = -(outward[a, 0] * outward[b, 0] + outward[a, 1] * outward[b, 1])
            if a // 2 != b // 2 and cosine >= any_turn:
                link[a] = b
                link[b] = a
        elif high - low > 2:
            for p in range(low, high):
                a = by_node[p]
                partner = -1
                rivals = 0
                for q in range(low, high):
                    b = by_node[q]
                    cosine = -(outward[a, 0] * outward[b, 0] + outward[a, 1] * outward[b, 1])
                    if q != p and a // 2 != b // 2 and cosine >= straight:
                        partner = b
                        rivals += 1
                if rivals == 1:
                    link[a] = partner
            for p in range(low, high):
                a = by_node[p]
                if link[a] >= 0 and link[link[a]] != a:
                    link[a] = -1
    return link


@kernel
def _continues_straight(outward: F64_2, by_node: I64_1, bounds: I64_1, straight: float) -> Any:
    """Return the mask of ends of n edges beyond which another edge continues straight, (2n,).

    The other edge has an end at the same vertex.  The path from one edge to the other turns there
    by an angle whose cosine is at least ``straight``.

    ``outward`` (2n, 2): unit directions from the ends into the edges; end 2i is the start of edge
    i, end 2i + 1 its end.
    ``by_node`` (2n,): the ends, sorted by vertex.
    ``bounds`` (v + 1,): position in ``by_node`` of the first end of each of v vertices; the last
    entry is 2n.
    ``straight``: least cosine of a turn that counts as straight.
    """
    straight_on = np.zeros(len(outward), np.bool_)
    for node in range(len(bounds) - 1):
        for p in range(bounds[node], bounds[node + 1]):
            a = by_node[p]
            for q in range(bounds[node], bounds[node + 1]):
                b = by_node[q]
                if (
                    p != q
                    and -(outward[a, 0] * outward[b, 0] + outward[a, 1] * outward[b, 1]) >= straight
                ):
                    straight_on[a] = True
    return straight_on


@kernel
def follow_links(link: I64_1) -> Any:
    """Return series of edges that are linked end to end.

    Parameters
    ----------
    link : (2k,)
        The end connected to each end, or -1; end 2i is the start of edge i, end 2i + 1 its end.

    Returns
    -------
    order : (k,)
        The edges, series after series; the series are in the order of their first edges.
    flipped : (k,)
        Whether each edge in ``order`` is traversed backwards.
    first : (r + 1,)
        Position in ``order`` at which each of the r series starts; the last entry is k.
    closed : (r,)
        Whether the last edge of each series is linked to its first edge.
    """
    count = len(link) // 2
    order = np.empty(count, np.int32)
    flipped = np.empty(count, np.bool_)
    first = np.empty(count + 1, np.int32)
    closed = np.zeros(count, np.bool_)
    visited = np.zeros(count, np.bool_)
    done = 0
    runs = 0
    for edge in range(count):
        if visited[edge]:
            continue
        # Go back to the open end, or once around a closed run.
        tail = 2 * edge
        while link[tail] >= 0:
            tail = link[tail] ^ 1
            if tail == 2 * edge:
                closed[runs] = True
                break
        first[runs] = done
        runs += 1
        while True:
            order[done] = tail // 2
            flipped[done] = tail % 2 == 1
            visited[tail // 2] = True
            done += 1
            tail = link[tail ^ 1]
            if tail < 0 or visited[tail // 2]:
                break
    first[runs] = done
    return order, flipped, first[: runs + 1].copy(), closed[:runs].copy()
