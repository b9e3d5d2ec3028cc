"""noding: edges split where others end on them or cross them.

edges -> pieces that meet only at their ends, and the edge of each
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.intersect import crossings
from knifetip.geometry.tolerance import JOIN
from knifetip.planning.near import near

#: More pairs of cuts than this are no drawing of a sheet, but take all memory there is.
_MOST_PAIRS: Final = 5_000_000


def noded(ends: F64, bulge: F64) -> tuple[F64, F64, I64]:
    """Return edges split where others end on them, and the row of each piece.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
    """
    return _split(ends, bulge, *_junctions(ends, bulge))


def noded_throughout(ends: F64, bulge: F64) -> tuple[F64, F64, I64]:
    """Return edges split where others end on them or cross them, and the row of each piece.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)

    Raises
    ------
    PlanError
        The boxes of more than five million pairs of edges overlap.
    """
    junctions, crossed = _junctions(ends, bulge), _crossed(ends, bulge)
    return _split(
        ends,
        bulge,
        *(np.concatenate(both) for both in zip(junctions, crossed, strict=True)),
    )


def _junctions(ends: F64, bulge: F64) -> tuple[I64, F64, F64]:
    """Return where ends of others lie on edges: the edge, the share of its length, the point."""
    points = ends.reshape(-1, 2)
    end, row = near(np.hstack([points, points]), arc.bounds(ends[:, 0], ends[:, 1], bulge), JOIN)
    whole = ends[row, 0], ends[row, 1], bulge[row]
    share = arc.nearest(*whole, points[end])
    on = np.hypot(*(arc.point_at(*whole, share) - points[end]).T) <= JOIN
    for side in range(2):
        on &= np.hypot(*(points[end] - ends[row, side]).T) > JOIN
    return row[on], share[on], points[end[on]]


def _crossed(ends: F64, bulge: F64) -> tuple[I64, F64, F64]:
    """Return where edges cross, as ``_junctions``: each place once for either edge."""
    boxes = arc.bounds(ends[:, 0], ends[:, 1], bulge)
    one, other = near(boxes, boxes, 0.0)
    if len(one) > 2 * _MOST_PAIRS:
        raise PlanError("cut.too-many-crossings", limit=_MOST_PAIRS)
    once = one < other
    one, other = one[once], other[once]
    met = crossings(ends[one, 0], ends[one, 1], bulge[one],
                    ends[other, 0], ends[other, 1], bulge[other])  # fmt: skip
    pair, place = np.nonzero(np.arange(met.points.shape[1]) < met.count[:, None])
    point = met.points[pair, place]
    inner = np.ones(len(pair), np.bool_)
    for edge in (one, other):
        for side in range(2):
            inner &= np.hypot(*(point - ends[edge[pair], side]).T) > JOIN
    pair, place, point = pair[inner], place[inner], point[inner]
    return (
        np.concatenate([one[pair], other[pair]]),
        np.concatenate([met.first[pair, place], met.second[pair, place]]),
        np.concatenate([point, point]),
    )


def _split(ends: F64, bulge: F64, row: I64, share: F64, point: F64) -> tuple[F64, F64, I64]:
    """Return edges split at places, and the row of each piece."""
    rows = np.concatenate([np.arange(len(ends)), row])
    low = np.concatenate([np.zeros(len(ends)), share])
    begin = np.concatenate([ends[:, 0], point])
    order = np.lexsort((low, rows))
    rows, low, begin = rows[order], low[order], begin[order]
    last = np.append(rows[1:] != rows[:-1], True)[: len(rows)]
    high = np.where(last, 1.0, np.roll(low, -1))
    finish = np.where(last[:, None], ends[rows, 1], np.roll(begin, -1, axis=0))
    some = np.hypot(*(finish - begin).T) > JOIN
    # A whole edge stays as it is drawn, however short.
    some |= (low == 0.0) & (high == 1.0)
    bent = np.tan(np.arctan(bulge[rows]) * (high - low))
    return np.stack([begin, finish], axis=1)[some], bent[some], rows[some]
