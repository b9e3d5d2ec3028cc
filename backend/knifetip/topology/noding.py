"""noding: split edges where other edges end on them or cross them.

The functions return the pieces of all edges, and for each piece the index of the edge from which it
comes.  The pieces meet only at their ends.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.intersect import MAX_POINTS, intersect_rows
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import JOIN
from knifetip.kernels import F64_2, F64_3, I64_1, kernel

#: Limit for the pairs of cuts whose boxes overlap, to bound the memory.
_MOST_PAIRS: Final = 5_000_000


def split_at_ends(ends: F64, bulge: F64) -> tuple[F64, F64, I64]:
    """Split edges at the points at which ends of other edges lie on them; return the m pieces.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the edges.

    Returns
    -------
    Ends (m, 2, 2) mm and bulges (m,) of the pieces, and the index of the edge of each piece (m,).
    """
    return _split_at(ends, bulge, *_end_contacts(ends, bulge))


def split_at_crossings(ends: F64, bulge: F64) -> tuple[F64, F64, I64]:
    """Split edges at the points at which other edges end on them or cross them; return the m
    pieces.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the edges.

    Returns
    -------
    Ends (m, 2, 2) mm and bulges (m,) of the pieces, and the index of the edge of each piece (m,).

    Raises
    ------
    PlanError
        The bounding boxes of more than five million pairs of edges overlap.
    """
    junctions, crossed = _end_contacts(ends, bulge), _crossings(ends, bulge)
    return _split_at(
        ends,
        bulge,
        *(np.concatenate(both) for both in zip(junctions, crossed, strict=True)),
    )


def _end_contacts(ends: F64, bulge: F64) -> tuple[I64, F64, F64]:
    """Return the k points of edges at which ends of other edges lie.

    Returns ``edge, fraction, point`` (k,), (k,) and (k, 2) mm: index of the edge, parameter of the
    point on it (0 … 1), and the position of the other edge's end.
    """
    points = ends.reshape(-1, 2)
    end, row = box_pairs(
        arc.point_boxes(points), arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge), JOIN
    )
    # Most ends only meet the ends of other edges.
    inner = _are_inside(np.ascontiguousarray(ends), end, row)
    end, row = end[inner], row[inner]
    segments = ends[row, 0], ends[row, 1], bulge[row]
    fraction = arc.nearest_fraction(*segments, points[end])
    touches = np.hypot(*(arc.point_at(*segments, fraction) - points[end]).T) <= JOIN
    return row[touches], fraction[touches], points[end[touches]]


def _crossings(ends: F64, bulge: F64) -> tuple[I64, F64, F64]:
    """Return the points at which two edges cross; each point is returned once for each of the two
    edges.

    Returns ``edge, fraction, point`` (k,), (k,) and (k, 2) mm: index of the edge, parameter of the
    point on it (0 … 1), and the position of the point.
    """
    boxes = arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge)
    one, other = box_pairs(boxes, boxes, JOIN)
    if len(one) > 2 * _MOST_PAIRS:
        raise PlanError("cut.too-many-crossings", limit=_MOST_PAIRS)
    edges = np.column_stack([ends.reshape(-1, 4), bulge])
    edge, fraction, point = _inner_crossings(edges, one, other)
    return edge.T.ravel(), fraction.T.ravel(), np.concatenate([point, point])


@kernel
def _are_inside(ends: F64_3, end: I64_1, row: I64_1) -> Any:
    """Return the mask of the pairs whose first end is more than ``JOIN`` mm from both ends of the
    edge, (p,).

    ``ends`` (n, 2, 2) mm: start and end points of the edges; edge i has the ends 2i and 2i + 1.
    ``end``, ``row`` (p,) and (p,): index of the end, and index of the edge, of each pair.
    """
    inside = np.ones(len(end), np.bool_)
    for k in range(len(end)):
        x, y = ends[end[k] // 2, end[k] % 2, 0], ends[end[k] // 2, end[k] % 2, 1]
        for side in range(2):
            away = math.hypot(x - ends[row[k], side, 0], y - ends[row[k], side, 1])
            inside[k] = inside[k] and away > JOIN
    return inside


@kernel
def _inner_crossings(edges: F64_2, edge_a: I64_1, edge_b: I64_1) -> Any:
    """Return the c points at which two edges cross more than ``JOIN`` mm from the ends of both.

    ``edges`` (n, 5): edges: x0, y0, x1, y1, bulge.
    ``edge_a``, ``edge_b`` (p,) and (p,): indices of the edges of each pair; pairs with ``edge_a`` ≥
    ``edge_b`` are left out.
    Returns ``edge, fraction, point`` (c, 2), (c, 2) and (c, 2) mm: the two edges, the parameter of
    the point on each of them (0 … 1), and the point.
    """
    edge, fraction = np.empty((16, 2), np.int64), np.empty((16, 2))
    point, common = np.empty((16, 2)), np.empty((MAX_POINTS, 4))
    found = 0
    for k in range(len(edge_a)):
        if edge_a[k] >= edge_b[k]:
            continue
        for at in range(intersect_rows(edges, edge_a[k], edges, edge_b[k], JOIN, common)):
            x, y = common[at, 0], common[at, 1]
            inner = True
            for row in (edge_a[k], edge_b[k]):
                for side in range(2):
                    away = math.hypot(x - edges[row, 2 * side], y - edges[row, 2 * side + 1])
                    inner = inner and away > JOIN
            if not inner:
                continue
            if found == len(point):
                edge = np.concatenate((edge, np.empty_like(edge)))
                fraction = np.concatenate((fraction, np.empty_like(fraction)))
                point = np.concatenate((point, np.empty_like(point)))
            edge[found, 0], edge[found, 1] = edge_a[k], edge_b[k]
            fraction[found, 0], fraction[found, 1] = common[at, 2], common[at, 3]
            point[found, 0], point[found, 1] = x, y
            found += 1
    return edge[:found].copy(), fraction[:found].copy(), point[:found].copy()


def _split_at(ends: F64, bulge: F64, row: I64, fraction: F64, point: F64) -> tuple[F64, F64, I64]:
    """Split edges at points on them; return the m pieces.

    ``ends``, ``bulge`` (n, 2, 2) mm and (n,): start and end points, and bulges, of the edges.
    ``row``, ``fraction``, ``point`` (k,), (k,) and (k, 2) mm: index of the edge of each point,
    parameter of the point on it (0 … 1), and position of the point.
    Returns ends (m, 2, 2) mm and bulges (m,) of the pieces, and the index of the edge of each piece
    (m,).
    """
    if len(row) == 0:
        return ends, bulge, np.arange(len(ends))
    rows = np.concatenate([np.arange(len(ends)), row])
    low = np.concatenate([np.zeros(len(ends)), fraction])
    begin = np.concatenate([ends[:, 0], point])
    order = np.lexsort((low, rows))
    rows, low, begin = rows[order], low[order], begin[order]
    last = np.append(rows[1:] != rows[:-1], True)[: len(rows)]
    high = np.where(last, 1.0, np.roll(low, -1))
    finish = np.where(last[:, None], ends[rows, 1], np.roll(begin, -1, axis=0))
    long_enough = np.hypot(*(finish - begin).T) > JOIN
    # An edge that is not split is kept, however short.
    whole = (low == 0.0) & (high == 1.0)
    long_enough |= whole
    bent = np.where(whole, bulge[rows], np.tan(np.arctan(bulge[rows]) * (high - low)))
    return np.stack([begin, finish], axis=1)[long_enough], bent[long_enough], rows[long_enough]
