"""dashes: merge creases that are drawn as dashes, and remove repeated edges.

``merge_dashes`` returns edges without overlaps, with the gaps between dashes filled.
``distinct_edges`` returns the indices of the edges that do not repeat an earlier edge.

Three or more edges on one line are dashes if the gaps between them are regular, no gap is longer
than 12 mm, no gap is longer than 1.5 times the mean length of the edges, no cut touches an end of
an edge at a gap, and no cut passes through a gap.  Cuts that cross the edges on both sides of a gap
are the sides of a slot if less than half of the line between them is drawn.  A cut that ends in a
gap from one side, such as a slit, does not matter, as on a crease without gaps.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.points_on_segments import find_points_on_segments
from knifetip.geometry.tolerance import BULGE, COLLINEAR, GAP, JOIN
from knifetip.geometry.unique_rows import unique_rows
from knifetip.geometry.vertices import number_vertices
from knifetip.kernels import F64_1, I64_1, Bool_1, kernel
from knifetip.planning.cut_crossings import find_cut_crossings

#: Greatest gap between dashes: in mm, and as a multiple of the mean length of the dashes.
_GREATEST_GAP = 12.0
_GREATEST_RATIO = 1.5
#: Gaps are regular if the dash pitch differs by at most this fraction from the first one.
_REGULAR = 0.25


def merge_dashes(
    ends: F64, bulge: F64, cuts: tuple[F64, F64] | None = None
) -> tuple[F64, F64, I32]:
    """Return edges without overlaps that cover all given edges and the gaps between dashes.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the given edges.
    cuts : (m, 2, 2) mm and (m,)
        Start and end points, and bulges, of the cuts.  A gap with a cut in it is not filled.  If
        ``cuts`` is None, no gap is filled.

    Returns
    -------
    ends, bulge, row : (q, 2, 2) mm, (q,) and (q,)
        Start and end points, and bulges, of the new edges, and the index of the given edge from
        which each new edge comes.  A filled gap comes from the dash before the gap.
    """
    straight = np.abs(bulge) < BULGE
    bent = np.flatnonzero(~straight)
    bent = bent[distinct_edges(ends[bent], bulge[bent])]
    line, low, high = _group_by_line(ends, np.flatnonzero(straight))
    order = np.lexsort((-high, low, line))
    rows = np.flatnonzero(straight)[order]
    line, low, high = line[order], low[order], high[order]
    downward = ((ends[rows, 1] - ends[rows, 0]) * _upward_directions(ends[rows])).sum(axis=1) < 0.0
    near = np.where(downward[:, None], ends[rows, 1], ends[rows, 0])
    far = np.where(downward[:, None], ends[rows, 0], ends[rows, 1])
    barred = np.ones((2, len(rows)), np.bool_)
    if cuts is not None:
        cut_ends, cut_bulge = cuts
        barred = find_points_on_segments(
            np.concatenate([near, far]),
            np.full(2 * len(rows), -1, np.int32),
            cut_ends[:, 0],
            cut_ends[:, 1],
            cut_bulge,
            GAP,
        ).reshape(2, -1)
        # A gap before an edge that begins on a cut stays open in any case.
        width = low[1:] - high[:-1]
        is_gap = (line[1:] == line[:-1]) & (width > JOIN) & (width <= _GREATEST_GAP)
        after = np.flatnonzero(is_gap & ~barred[0, 1:]) + 1
        ends_of = np.stack([near, far], axis=1)
        barred[0, after] = _are_cut(ends_of[after - 1], ends_of[after], cut_ends, cut_bulge)
    begin, kept, first, last = _merge_along_lines(line, low, high, barred[0], barred[1])

    def on_line(piece: I64, along: F64) -> F64:
        """Return a point on the line of each of k edges, (k, 2) mm.

        ``piece`` are the indices of the edges, and ``along`` the distance of each point from the
        start of the edge's line, (k,) mm.  If an edge is a dash, its line runs from the start of
        the first dash to the end of the last dash of the dashed line.
        """
        span = (high[last[piece]] - low[first[piece]])[:, None]
        way = far[last[piece]] - near[first[piece]]
        point: F64 = near[first[piece]] + way * (along - low[first[piece]])[:, None] / span
        return point

    piece = np.flatnonzero(kept)
    dashed = first[piece] != last[piece]
    drawn = ~dashed & (begin[piece] == low[piece])
    stretch = np.stack([on_line(piece, begin[piece]), on_line(piece, high[piece])], axis=1)
    # A row of dashes has the direction of its first dash.
    back = downward[first[piece]][:, None, None]
    stretch = np.where(back, stretch[:, ::-1], stretch)
    stretch = np.where(drawn[:, None, None], ends[rows[piece]], stretch)
    before = np.flatnonzero(dashed[:-1] & (first[piece][1:] == first[piece][:-1]))
    one, two = piece[before], piece[before + 1]
    gap = np.stack([on_line(one, high[one]), on_line(two, begin[two])], axis=1)
    gap = np.where(back[before], gap[:, ::-1], gap)
    row = np.concatenate([bent, rows[piece], rows[one]])
    order = np.argsort(row, kind="stable")
    bends = np.concatenate([bulge[bent], np.zeros(len(piece) + len(one))])
    return (
        np.concatenate([ends[bent], stretch, gap])[order],
        bends[order],
        row[order].astype(np.int32),
    )


def _are_cut(before: F64, after: F64, cut_ends: F64, cut_bulge: F64) -> Bool:
    """Return the mask of the g gaps between two edges that cuts keep open, (g,).

    ``before``, ``after`` (g, 2, 2) mm: start and end points of the edges before and after the gaps.
    ``cut_ends``, ``cut_bulge``: those of ``merge_dashes``.
    """
    count = len(before)
    gaps = np.stack([before[:, 1], after[:, 0]], axis=1)
    # Both edges are followed away from the gap.
    lines = np.concatenate([gaps, before[:, ::-1], after])
    each = np.arange(len(lines) + 1, dtype=np.int32)
    paths = Paths(lines[:, 0], lines[:, 1], np.zeros(len(lines)), each)
    crossed, fraction = find_cut_crossings(paths, cut_ends, cut_bulge)
    size = np.hypot(*(lines[:, 1] - lines[:, 0]).T)
    drawn = np.full(len(lines), np.inf)
    np.minimum.at(drawn, crossed, fraction * size[crossed])
    through, one, other = drawn.reshape(3, count)
    result: Bool = np.isfinite(through) | (one + other < size[:count])
    return result


def _upward_directions(ends: F64) -> F64:
    """Return the unit direction of each line, reversed if it points downwards, (n, 2)."""
    ahead = unit_vectors(ends[:, 1] - ends[:, 0])
    # Directions very near due west become due east, so that one line has one direction.
    down = (ahead[:, 1] < -1e-4) | ((np.abs(ahead[:, 1]) <= 1e-4) & (ahead[:, 0] < 0.0))
    return np.where(down[:, None], -ahead, ahead)


def _group_by_line(ends: F64, rows: I64) -> tuple[I64, F64, F64]:
    """Number the lines on which straight edges lie, and return the line and the range of each edge.

    Edges on one line differ in direction by at most ``COLLINEAR`` degrees and in position by at
    most ``JOIN`` mm.  Edges near these limits may get different lines although they are collinear.

    ``rows`` (m,): indices of the straight edges in ``ends``.
    Returns ``line, low, high`` (m,), (m,) mm and (m,) mm: number of the line of each edge, and the
    edge's least and greatest position along that line.
    """
    ahead = _upward_directions(ends[rows])
    angle = np.degrees(np.arctan2(ahead[:, 1], ahead[:, 0]))
    bundle = _cluster(np.zeros(len(rows), np.int64), angle, COLLINEAR)
    size = np.bincount(bundle)
    mean = np.stack([np.bincount(bundle, part) for part in ahead.T], axis=1) / size[:, None]
    common = unit_vectors(mean)[bundle] if len(rows) else ahead
    middle = ends[rows].mean(axis=1)
    offset = common[:, 0] * middle[:, 1] - common[:, 1] * middle[:, 0]
    line = _cluster(bundle, offset, JOIN)
    positions = (ends[rows] * common[:, None]).sum(axis=2)
    return line, np.minimum(*positions.T), np.maximum(*positions.T)


def _cluster(group: I64, value: F64, gap: float) -> I64:
    """Return the number of the cluster of each value, counted from 0, (n,).

    A cluster contains values of one group; its greatest value exceeds its least value by at most
    ``gap``.  ``group`` is the number of the group of each value, (n,).
    """
    order = np.lexsort((value, group))
    number = np.empty(len(order), np.int64)
    number[order] = _number_clusters(group[order], value[order], gap)
    return number


@kernel
def _number_clusters(group: I64_1, value: F64_1, gap: float) -> Any:
    """Return the number of the cluster of each value, counted from 0, (n,).

    ``group`` is the number of the group of each value, (n,).  The values are sorted by group, then
    ascending.  A new cluster starts at a new group, and at a value that exceeds the least value of
    the current cluster by more than ``gap``.
    """
    number = np.zeros(len(value), np.int64)
    least = 0
    for i in range(1, len(value)):
        between = group[i] != group[least] or value[i] - value[least] > gap
        if between:
            least = i
        number[i] = number[i - 1] + (1 if between else 0)
    return number


def distinct_edges(ends: F64, bulge: F64) -> I32:
    """Return the indices of the edges that do not coincide with an earlier edge, ascending.

    ``ends`` are the start and end points of n edges, (n, 2, 2) mm, and ``bulge`` their bulges,
    (n,).
    """
    if len(ends) == 0:
        return np.zeros(0, np.int32)
    first, last = number_vertices(ends.reshape(-1, 2)).reshape(-1, 2).T
    bent = np.rint(1e6 * np.where(first > last, -bulge, bulge)).astype(np.int64)
    return unique_rows(np.minimum(first, last), np.maximum(first, last), bent)[0].astype(np.int32)


@kernel(checks_division=True)
def _merge_along_lines(
    line: I64_1, low: F64_1, high: F64_1, low_barred: Bool_1, high_barred: Bool_1
) -> Any:
    """Remove overlaps between edges along each line, and find rows of dashes.

    ``line``, ``low``, ``high`` (n,): line of each edge, and its start and end along that line (mm),
    sorted by line and start.
    ``low_barred``, ``high_barred`` (n,): whether the gap before, and the gap after, each edge must
    stay open because of a cut.
    Returns ``begin`` (n,) mm: position at which each edge starts after the overlap with earlier
    edges is removed; ``kept`` (n,): mask of the edges that earlier edges do not cover completely;
    ``first, last`` (n,) and (n,): index of the first and of the last dash of the row of dashes to
    which each edge belongs. Both are the index of the edge itself if it is no dash.
    """
    count = len(line)
    begin = low.copy()
    kept = np.zeros(count, np.bool_)
    first = np.arange(count)
    last = np.arange(count)
    run = np.empty(count, np.int64)
    size = 0
    reach = 0.0
    for i in range(count + 1):
        if i < count and i > 0 and line[i] == line[i - 1]:
            if low[i] < reach and high[i] <= reach + JOIN:
                continue
            begin[i] = max(low[i], reach)
        before = run[size - 1] if size else 0
        continues = (
            i < count
            and size > 0
            and line[i] == line[before]
            and not high_barred[before]
            and not low_barred[i]
            and JOIN < low[i] - high[before] <= _GREATEST_GAP
        )
        if continues and size > 1:
            pace = low[run[1]] - high[run[0]]
            continues = abs(low[i] - high[before] - pace) <= _REGULAR * pace + JOIN
        if not continues:
            if size >= 3:
                length = 0.0
                widest = 0.0
                for k in range(size):
                    length += high[run[k]] - begin[run[k]]
                    if k:
                        widest = max(widest, low[run[k]] - high[run[k - 1]])
                if widest <= _GREATEST_RATIO * length / size:
                    for k in range(size):
                        first[run[k]] = run[0]
                        last[run[k]] = run[size - 1]
            size = 0
        if i < count:
            kept[i] = True
            reach = high[i]
            run[size] = i
            size += 1
    return begin, kept, first, last
