"""drawn_twice: find cuts that lie so near beside others that the same line may be drawn twice.

Exports often contain a circle and a polygon in it, or an outline twice, a little apart.  A cutter
with a diameter cannot make both: the contours cross, or the strip between them is narrower than the
cutter.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.points_on_segments import find_points_on_segments
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import GAP, JOIN

#: Places along an edge at which it must lie beside another one; its ends may lie at corners.
_FRACTIONS: Final = (0.25, 0.5, 0.75)
#: Cosine of the greatest angle between two lines beside each other (30°: a polygon of 6 corners).
_PARALLEL: Final = 0.866


class Copies(NamedTuple):
    """k edges that lie beside others, of which they may be copies."""

    row: I64  #: (k,) index of each edge
    beside: I64  #: (k,) index of the edge beside it
    distance: F64  #: (k,) greatest distance from the edges beside it (mm)


def find_copies(ends: F64, bulge: F64, within: float) -> Copies:
    """Return the edges that lie beside longer ones, or beside earlier ones of equal length.

    An edge lies beside another one if its points are nearer to it than ``within`` and nearly
    parallel to it there.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the edges.
    within : mm
        Greatest distance of an edge from the one beside it.
    """
    length = arc.length(ends[:, 0], ends[:, 1], bulge)
    boxes = arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge)
    one, other = box_pairs(boxes, boxes, within)
    shorter = length[one] < length[other] - 1e-6
    shorter |= (np.abs(length[one] - length[other]) <= 1e-6) & (one > other)
    one, other = one[shorter].astype(np.int64), other[shorter].astype(np.int64)
    row = np.arange(len(ends))
    worst = np.zeros(len(ends))
    beside = np.full(len(ends), -1, np.int64)
    for fraction in _FRACTIONS:
        away, nearest = _nearest_parallel(ends, bulge, one, other, fraction)
        worst = np.maximum(worst, away)
        beside = np.where(nearest >= 0, nearest, beside)
    found = worst < within
    return Copies(row[found], beside[found], worst[found])


def _nearest_parallel(
    ends: F64, bulge: F64, edge_a: I64, edge_b: I64, fraction: float
) -> tuple[F64, I64]:
    """Return for a point of each edge the distance to the nearest edge beside it, and that edge.

    The distance is infinite, and the edge is -1, if there is none.

    ``ends``, ``bulge`` (n, 2, 2) mm and (n,): the edges.
    ``edge_a``, ``edge_b`` (k,): pairs of an edge and one that may lie beside it.
    ``fraction``: position of the point along each edge.
    """
    own = ends[edge_a, 0], ends[edge_a, 1], bulge[edge_a]
    place = np.full(len(edge_a), fraction)
    point = arc.point_at(*own, place)
    facing = ends[edge_b, 0], ends[edge_b, 1], bulge[edge_b]
    foot = arc.nearest_fraction(*facing, point)
    away = np.hypot(*(arc.point_at(*facing, foot) - point).T)
    ahead = unit_vectors(arc.tangent_at(*own, place))
    cosine = np.abs((ahead * unit_vectors(arc.tangent_at(*facing, foot))).sum(axis=1))
    away[cosine < _PARALLEL] = np.inf
    distance, nearest = np.full(len(ends), np.inf), np.full(len(ends), -1, np.int64)
    order = np.argsort(-away, kind="stable")
    # The last assignment to an edge is that of the least distance.
    distance[edge_a[order]], nearest[edge_a[order]] = away[order], edge_b[order]
    nearest[~np.isfinite(distance)] = -1
    return distance, nearest


def explain_copies(
    error: PlanError, ends: F64, bulge: F64, source: I32, caliper: float
) -> PlanError:
    """Return the error about lines drawn twice if they prevent milling, else ``error``.

    If parts share an edge, lines without which another cut would end at no cut are not copies:
    without them a part is no longer closed, so the edge is only seemingly not shared.

    Parameters
    ----------
    error
        Why the cuts cannot be milled; its edges are rows of the dieline.
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of all cuts.
    source : (n,)
        Row in the dieline of each cut.
    caliper : mm
        Thickness of the board, which cannot hold a narrower strip between two cuts.
    """
    copies = find_copies(ends, bulge, caliper)
    concerned = np.isin(source, error.edges)
    named = concerned[copies.row] | concerned[copies.beside]
    if not named.any():
        return error
    chosen: Bool = np.isin(copies.row, _connected_edges(ends, copies.row, copies.row[named]))
    shared = error.message.code == "milling.shared-edge"
    if shared and _leave_open_ends(ends, bulge, copies.row[chosen]):
        return error
    rows = source[copies.row[chosen]]
    return PlanError(
        "milling.drawn-twice",
        edge=rows[0],
        other=source[copies.beside[chosen][0]],
        count=len(rows),
        distance=copies.distance[chosen].max(),
        at_edges=rows,
    )


def _leave_open_ends(ends: F64, bulge: F64, left_out: I64) -> bool:
    """Return whether other cuts that meet the ones to be left out would end at no cut.

    ``ends``, ``bulge`` (n, 2, 2) mm and (n,): all cuts.
    ``left_out`` (k,): indices of the cuts to be left out.
    """
    kept = np.ones(len(ends), np.bool_)
    kept[left_out] = False
    rows = np.flatnonzero(kept).astype(np.int32)
    points = ends[rows].reshape(-1, 2)
    owner = np.repeat(np.arange(len(rows), dtype=np.int32), 2)
    removed, none = ends[left_out], np.full(len(points), -1, np.int32)
    met = find_points_on_segments(points, none, removed[:, 0], removed[:, 1], bulge[left_out], JOIN)
    still = find_points_on_segments(
        points[met], owner[met], ends[rows, 0], ends[rows, 1], bulge[rows], GAP
    )
    return not bool(still.all())


def _connected_edges(ends: F64, rows: I64, first: I64) -> I64:
    """Return those of some edges that are connected with given ones, over edges among them.

    ``ends`` (n, 2, 2) mm: start and end points of all edges.
    ``rows``, ``first`` (k,) and (m,): indices of some edges, and of those among them to begin with.
    """
    points = np.round(ends[rows].reshape(-1, 2), 3)
    vertex = np.unique(points, axis=0, return_inverse=True)[1].reshape(-1, 2)
    inside = np.isin(rows, first)
    while True:
        reached: Bool = np.asarray(np.isin(vertex, vertex[inside]).any(axis=1))
        if np.array_equal(reached, inside):
            result: I64 = rows[inside]
            return result
        inside = reached
