"""micro_loops: contract loops of short edges at the corners of an outline to points.

Some generators move each line outwards by half the width of a laser beam and connect the moved
lines with curls of a tenth of a millimetre, which cross themselves.  Such a curl belongs to the
outline, but its vertices are nearer to each other than the tolerance of the planar graph, so that
the outline would not close.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import GAP
from knifetip.geometry.union_find import flatten, union
from knifetip.kernels import I32_1, I64_1, OutI64_1, kernel
from knifetip.topology.vertices import merge_ends

#: Edges shorter than this may belong to a loop (mm).
_SHORT: Final = 0.25
#: Greatest diagonal of a loop (mm).
_LOOP: Final = 0.3


class ContractedEdges(NamedTuple):
    """The edges of a drawing without its micro loops."""

    ends: F64  #: (k, 2, 2) ends of the remaining edges, moved to the point of their loop
    rows: I64  #: (k,) index of each remaining edge among all edges
    loop: I64  #: (l,) edges that belong to loops
    host: I64  #: (l,) longest remaining edge that ends at the loop of each of them


def contract_micro_loops(ends: F64, bulge: F64, unit: float) -> ContractedEdges | None:
    """Return the edges without micro loops; None if there are none.

    A micro loop consists of connected short edges that enclose something, and has a diagonal of at
    most 0.3 mm.  Loops to which no longer edge leads remain.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) and (n,)
        Ends and bulges of the edges.
    unit
        Number of drawing units in a millimetre.
    """
    length = arc.length(ends[:, 0], ends[:, 1], bulge)
    short = length < _SHORT * unit
    if not short.any() or short.all():
        return None
    vertices, end_vertex = merge_ends(ends, GAP * unit)
    cluster = np.arange(vertices.vertex_count)
    edges = np.flatnonzero(short)
    _join(end_vertex, edges, cluster)
    of_end = cluster[end_vertex]
    of_edge = of_end[2 * edges]
    count = len(cluster)
    number_of_vertices = np.bincount(cluster, minlength=count)
    encloses = np.bincount(of_edge, minlength=count) >= number_of_vertices
    low, high = np.full((count, 2), np.inf), np.full((count, 2), -np.inf)
    points = ends.reshape(-1, 2)
    in_short = short.repeat(2)
    np.minimum.at(low, of_end[in_short], points[in_short])
    np.maximum.at(high, of_end[in_short], points[in_short])
    diagonal = np.hypot(*(high - low).T)
    host = _longest_edges(of_end, length, short, count)
    loops = encloses & (diagonal <= _LOOP * unit) & (host >= 0)
    in_loop = short.copy()
    in_loop[edges] = loops[of_edge]
    if not in_loop.any():
        return None
    rows = np.flatnonzero(~in_loop)
    moved = points.copy()
    to_loop = loops[of_end]
    moved[to_loop] = 0.5 * (low[of_end[to_loop]] + high[of_end[to_loop]])
    loop = np.flatnonzero(in_loop)
    return ContractedEdges(moved.reshape(-1, 2, 2)[rows], rows, loop, host[of_end[2 * loop]])


def _longest_edges(of_end: I64, length: F64, short: Bool, count: int) -> I64:
    """Return the longest edge that is not short and ends at each cluster of vertices, -1 for none.

    ``of_end`` (2n,): cluster of the vertex of each end.
    ``length``, ``short`` (n,): length of each edge, and whether it is short.
    """
    long = np.flatnonzero(~short)
    ordered = long[np.argsort(length[long], kind="stable")]
    host = np.full(count, -1, np.int64)
    # The longest edge is written last.
    host[of_end[2 * ordered]] = ordered
    last = of_end[2 * ordered + 1]
    other = host[last]
    longer = (other < 0) | (length[other] < length[ordered])
    host[last[longer]] = ordered[longer]
    return host


@kernel(allocates=False)
def _join(end_vertex: I32_1, edges: I64_1, cluster: OutI64_1) -> None:
    """Join the vertices that some edges connect; write the root of each vertex to ``cluster``.

    ``end_vertex`` (2n,): vertex of each end; edge i has the ends 2 i and 2 i + 1.
    ``edges`` (k,): indices of the edges.
    ``cluster`` (v,): on entry, entry i must be i.
    """
    for edge in edges:
        union(cluster, end_vertex[2 * edge], end_vertex[2 * edge + 1])
    flatten(cluster)
