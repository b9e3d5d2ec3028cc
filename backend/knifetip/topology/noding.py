"""noding: split edges where other edges end on them or cross them.

The functions return the pieces of all edges, and for each piece the index of the edge from which it
comes.  The pieces meet only at their ends.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.intersect import intersect_pairs
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import JOIN

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

    Returns
    -------
    edge, fraction, point : (k,), (k,) and (k, 2) mm
        Index of the edge, parameter of the point on it (0 … 1), and the position of the other
        edge's end.
    """
    points = ends.reshape(-1, 2)
    end, row = box_pairs(
        np.hstack([points, points]), arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge), JOIN
    )
    # Most ends only meet the ends of other edges.
    for side in range(2):
        inner = np.hypot(*(points[end] - ends[row, side]).T) > JOIN
        end, row = end[inner], row[inner]
    segments = ends[row, 0], ends[row, 1], bulge[row]
    fraction = arc.nearest_fraction(*segments, points[end])
    touches = np.hypot(*(arc.point_at(*segments, fraction) - points[end]).T) <= JOIN
    return row[touches], fraction[touches], points[end[touches]]


def _crossings(ends: F64, bulge: F64) -> tuple[I64, F64, F64]:
    """Return the points at which two edges cross; each point is returned once for each of the two
    edges.

    Returns
    -------
    edge, fraction, point : (k,), (k,) and (k, 2) mm
        Index of the edge, parameter of the point on it (0 … 1), and the position of the point.
    """
    boxes = arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge)
    one, other = box_pairs(boxes, boxes, 0.0)
    if len(one) > 2 * _MOST_PAIRS:
        raise PlanError("cut.too-many-crossings", limit=_MOST_PAIRS)
    once = one < other
    one, other = one[once], other[once]
    crossings = intersect_pairs(ends[one, 0], ends[one, 1], bulge[one],
                    ends[other, 0], ends[other, 1], bulge[other])  # fmt: skip
    pair, column = np.nonzero(np.arange(crossings.points.shape[1]) < crossings.count[:, None])
    point = crossings.points[pair, column]
    inner = np.ones(len(pair), np.bool_)
    for edge in (one, other):
        for side in range(2):
            inner &= np.hypot(*(point - ends[edge[pair], side]).T) > JOIN
    pair, column, point = pair[inner], column[inner], point[inner]
    return (
        np.concatenate([one[pair], other[pair]]),
        np.concatenate([crossings.first[pair, column], crossings.second[pair, column]]),
        np.concatenate([point, point]),
    )


def _split_at(ends: F64, bulge: F64, row: I64, fraction: F64, point: F64) -> tuple[F64, F64, I64]:
    """Split edges at points on them; return the m pieces.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the edges.
    row, fraction, point : (k,), (k,) and (k, 2) mm
        Index of the edge of each point, parameter of the point on it (0 … 1), and position of the
        point.

    Returns
    -------
    Ends (m, 2, 2) mm and bulges (m,) of the pieces, and the index of the edge of each piece (m,).
    """
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
    long_enough |= (low == 0.0) & (high == 1.0)
    bent = np.tan(np.arctan(bulge[rows]) * (high - low))
    return np.stack([begin, finish], axis=1)[long_enough], bent[long_enough], rows[long_enough]
