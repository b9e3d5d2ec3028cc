"""Dashes: creases drawn as dashes, or drawn twice, are rolled as one and once.

    creases -> edges that cover each stretch once, the gaps between dashes filled
    edges -> those that repeat no other one

Three or more pieces on one line are dashes where the gaps between them are regular, none longer
than 12 mm or than one and a half times the mean piece, and no cut begins, ends or crosses in one.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.geometry.azimuth import unit
from knifetip.geometry.chain import nodes
from knifetip.geometry.columns import F64, I32, I64
from knifetip.geometry.grid import touching
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import BULGE, COLLINEAR, GAP, JOIN
from knifetip.kernels import F64_1, I64_1, Bool_1, kernel
from knifetip.planning.creases import run_through

#: Dashes are no farther apart than this (mm), nor than so many of their mean lengths.
_GAP = 12.0
_SHARE = 1.5
#: Gaps that differ by no more than this share of the first one are regular.
_REGULAR = 0.25


def once(ends: F64, bulge: F64, cuts: tuple[F64, F64] | None = None) -> tuple[F64, F64, I32]:
    """Return edges that cover each stretch of these once.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
    cuts : (m, 2, 2) mm and (m,)
        Ends and bulges of the cuts, by which no gap is filled; None fills no gap at all.

    Returns
    -------
    ends, bulge, row
        New edges, and for each the old one that it is a part of; a gap counts to the dash before.
    """
    straight = np.abs(bulge) < BULGE
    bent = np.flatnonzero(~straight)
    bent = bent[distinct(ends[bent], bulge[bent])]
    line, low, high = _on_lines(ends, np.flatnonzero(straight))
    order = np.lexsort((-high, low, line))
    rows = np.flatnonzero(straight)[order]
    line, low, high = line[order], low[order], high[order]
    downward = ((ends[rows, 1] - ends[rows, 0]) * _folded(ends[rows])).sum(axis=1) < 0.0
    near = np.where(downward[:, None], ends[rows, 1], ends[rows, 0])
    far = np.where(downward[:, None], ends[rows, 0], ends[rows, 1])
    barred = np.ones((2, len(rows)), np.bool_)
    if cuts is not None:
        cut_ends, cut_bulge = cuts
        barred = touching(
            np.concatenate([near, far]),
            np.full(2 * len(rows), -1, np.int32),
            cut_ends[:, 0],
            cut_ends[:, 1],
            cut_bulge,
            GAP,
        ).reshape(2, -1)
        apart = np.flatnonzero((line[1:] == line[:-1]) & (low[1:] > high[:-1] + JOIN))
        each = np.arange(len(apart) + 1, dtype=np.int32)
        gaps = Paths(far[apart], near[apart + 1], np.zeros(len(apart)), each)
        barred[0, apart[run_through(gaps, cut_ends, cut_bulge)[0]] + 1] = True
    begin, kept, first, last = _swept(line, low, high, barred[0], barred[1])

    def on_line(piece: I64, along: F64) -> F64:
        """The place on the line from a run's first dash to its last, or of a piece by itself."""
        span = (high[last[piece]] - low[first[piece]])[:, None]
        way = far[last[piece]] - near[first[piece]]
        place: F64 = near[first[piece]] + way * (along - low[first[piece]])[:, None] / span
        return place

    piece = np.flatnonzero(kept)
    dashed = first[piece] != last[piece]
    drawn = ~dashed & (begin[piece] == low[piece])
    stretch = np.stack([on_line(piece, begin[piece]), on_line(piece, high[piece])], axis=1)
    # Dashes are followed the way the first of them is drawn.
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


def _folded(ends: F64) -> F64:
    """Return the unit directions of lines, each the one of the two in the upper half plane."""
    ahead = unit(ends[:, 1] - ends[:, 0])
    # Within a hair of due west is due east, so that one line has one direction.
    down = (ahead[:, 1] < -1e-4) | ((np.abs(ahead[:, 1]) <= 1e-4) & (ahead[:, 0] < 0.0))
    return np.where(down[:, None], -ahead, ahead)


def _on_lines(ends: F64, rows: I64) -> tuple[I64, F64, F64]:
    """Return for straight edges the number of their line, and from where to where they lie on it.

    Directions are gathered by twice ``COLLINEAR`` and lines by ``JOIN``: of pieces that hardly
    belong together some are told apart, and none that do not are taken for one.
    """
    ahead = _folded(ends[rows])
    angle = np.degrees(np.arctan2(ahead[:, 1], ahead[:, 0]))
    bundle = _gathered(np.zeros(len(rows), np.int64), angle, COLLINEAR)
    size = np.bincount(bundle)
    mean = np.stack([np.bincount(bundle, part) for part in ahead.T], axis=1) / size[:, None]
    common = unit(mean)[bundle] if len(rows) else ahead
    middle = ends[rows].mean(axis=1)
    offset = common[:, 0] * middle[:, 1] - common[:, 1] * middle[:, 0]
    line = _gathered(bundle, offset, JOIN)
    places = (ends[rows] * common[:, None]).sum(axis=2)
    return line, places.min(axis=1), places.max(axis=1)


def _gathered(group: I64, value: F64, gap: float) -> I64:
    """Number values of one group that lie within ``gap`` of the least of their number."""
    order = np.lexsort((value, group))
    number = np.empty(len(order), np.int64)
    number[order] = _numbered(group[order], value[order], gap)
    return number


@kernel
def _numbered(group: I64_1, value: F64_1, gap: float) -> Any:
    number = np.zeros(len(value), np.int64)
    least = 0
    for i in range(1, len(value)):
        apart = group[i] != group[least] or value[i] - value[least] > gap
        if apart:
            least = i
        number[i] = number[i - 1] + (1 if apart else 0)
    return number


def distinct(ends: F64, bulge: F64) -> I32:
    """Return the rows of edges, (n, 2, 2) mm and (n,), without those that repeat another one."""
    if len(ends) == 0:
        return np.zeros(0, np.int32)
    node = nodes(ends.reshape(-1, 2)).reshape(-1, 2)
    bent = np.round(np.where(node[:, 0] > node[:, 1], -bulge, bulge), 6)
    order = np.lexsort((bent, node.max(axis=1), node.min(axis=1)))
    key = np.column_stack([node.min(axis=1), node.max(axis=1), bent])[order]
    new = np.append(True, (key[1:] != key[:-1]).any(axis=1))
    # lexsort is stable: of those that are alike the first one drawn stays.
    return np.sort(order[new]).astype(np.int32)


@kernel(checks_division=True)
def _swept(line: I64_1, low: F64_1, high: F64_1, low_barred: Bool_1, high_barred: Bool_1) -> Any:
    """Walk along each line: where each piece begins anew, and of which run of dashes it is."""
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
        goes_on = (
            i < count
            and size > 0
            and line[i] == line[before]
            and not high_barred[before]
            and not low_barred[i]
            and JOIN < low[i] - high[before] <= _GAP
        )
        if goes_on and size > 1:
            pace = low[run[1]] - high[run[0]]
            goes_on = abs(low[i] - high[before] - pace) <= _REGULAR * pace + JOIN
        if not goes_on:
            if size >= 3:
                length = 0.0
                widest = 0.0
                for k in range(size):
                    length += high[run[k]] - begin[run[k]]
                    if k:
                        widest = max(widest, low[run[k]] - high[run[k - 1]])
                if widest <= _SHARE * length / size:
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
