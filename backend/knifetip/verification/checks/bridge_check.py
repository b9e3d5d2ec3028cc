"""Bridges: the nicks that hold a part in its sheet, as the knife has left them in the top face.

    EdgePaths, stretches of work along them -> Bridges: where, how wide, how far apart

A blade slanted by α has cut the top face further than its tip has come, by its lead.  So where it
stops before a bridge the tip leaves a gap that is wider than the bridge by that; where it goes in
again, tip and top face begin in one place.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.intervals import SHORT, Overlaps, uncovered_edges
from knifetip.verification.expectation.edge_paths import EdgePaths
from knifetip.verification.expectation.edges import STRAIGHT_ANGLE, Edges, angle_between
from knifetip.verification.findings import MAX_FINDINGS

#: A bridge stays this far from a sharp corner (mm), and no part hangs by fewer.
CORNER_DISTANCE: Final = 5.0
MIN_BRIDGES: Final = 2


@dataclass(frozen=True, eq=False, slots=True)
class Bridges:
    """k gaps in closed paths, path by path and in order along each."""

    path: I64  #: (k,)
    middle: F64  #: (k,) mm along the path
    width: F64  #: (k,) mm in the top face
    bare: F64  #: (k,) mm that the tip has left
    need: F64  #: (k,) mm that must be clear of corners
    apart: F64  #: (k,) mm from its middle to that of the next one of its path
    gap_without: F64  #: (k,) mm from the one before it to the one after it


def find_bridges(
    rows: Overlaps, paths: EdgePaths, held: Bool, edges: Edges, lead: float
) -> Bridges:
    """Return the gaps that work has left in closed paths.

    Parameters
    ----------
    rows
        The work's stretches along the edges of the paths.
    held : (c,)
        The paths to look at.
    lead : mm
        How far the top face is cut ahead of the tip.
    """
    size = edges.curve[:, 5]
    some = rows.best & (np.diff(rows.along)[:, 0] > SHORT)
    some &= np.abs(np.diff(rows.place)[:, 0]) > SHORT
    edge = np.maximum(rows.edge, 0)
    some &= held[paths.path[edge]]
    edge, place = rows.edge[some], rows.place[some]
    flipped = paths.flipped[edge][:, None]
    at = paths.begin[edge][:, None] + np.where(flipped, size[edge][:, None] - place, place)
    path = paths.path[edge]
    forward = at[:, 1] > at[:, 0]
    low, high = at.min(axis=1), at.max(axis=1)
    which, begin, end = uncovered_edges(path, low, high, np.where(held, paths.length, 0.0))
    length = paths.length[which]
    # A gap over the place where the path begins is one.
    first, last = begin <= 1e-9, end >= length - 1e-9
    for k in np.flatnonzero(first & ~last):
        other = np.flatnonzero((which == which[k]) & last & ~first)
        if len(other):
            end[other[0]] += end[k]
            which[k] = -1
    # Between two ways that meet no bridge is left, however they are printed.
    kept = (which >= 0) & (end - begin > SHORT)
    which, begin, end, length = which[kept], begin[kept], end[kept], length[kept]

    ahead = _reached_from(path[forward], high[forward], which, begin, length)
    back = _reached_from(path[~forward], low[~forward], which, end, length)
    top_begin, top_end = begin + lead * ahead, end - lead * back
    middle = (top_begin + top_end) / 2.0 % np.where(length > 0.0, length, 1.0)
    width = top_end - top_begin
    return order_bridges(which, middle, width, end - begin, width, paths.length)


def order_bridges(path: I64, middle: F64, width: F64, bare: F64, need: F64, length: F64) -> Bridges:
    """Return bridges in order, from those in any order.

    Parameters
    ----------
    length : (c,) mm
        Of every path.
    """
    order = np.lexsort((middle, path))
    path, middle = path[order], middle[order]
    new = np.ones(len(path), np.bool_)
    new[1:] = path[1:] != path[:-1]
    start = np.flatnonzero(new)
    following = np.append(middle[1:], 0.0)[: len(path)]
    closing = np.append(start[1:], len(path))[: len(start)] - 1
    following[closing] = middle[start] + length[path[start]]
    away = following - middle
    before = np.roll(away, 1)
    before[start] = away[closing]
    return Bridges(path, middle, width[order], bare[order], need[order], away, away + before)


def _reached_from(path: I64, at: F64, which: I64, place: F64, length: F64) -> F64:
    """Return 1 where a stretch ends at a place of a path, going towards it, else 0."""
    result = np.zeros(len(which))
    for k in range(len(which)):
        off = np.abs(at[path == which[k]] - place[k]) % length[k]
        result[k] = bool((np.minimum(off, length[k] - off) < 1e-6).any())
    return result


def check_bridges(
    found: Bridges, paths: EdgePaths, edges: Edges, held: Bool, board: Board, slack: float
) -> Iterator[tuple[str, int, Message, float]]:
    """Yield what is wrong with bridges: kind of finding, edge, message, measure (mm).

    Parameters
    ----------
    edges
        Those on the paths.
    held : (c,)
        The paths that must hang by bridges.
    slack : mm
        Less is not wrong.
    """
    edge, short = _corner_shortfall(found, paths, edges)
    wide = found.width - board.bridge_width
    many = np.bincount(found.path, minlength=len(held))
    # Without a spare one the next two would still be near enough to each other.
    spare = many[found.path] > MIN_BRIDGES
    spare &= found.gap_without <= board.bridge_spacing - slack
    bad = (np.abs(wide) > slack) | (short > slack) | spare
    bad |= found.apart > board.bridge_spacing + slack
    for k in np.flatnonzero(bad)[:MAX_FINDINGS]:
        place, e = found.middle[k], int(edge[k])
        if abs(wide[k]) > slack:
            message = Message(
                "verify.bridge-width",
                place=place,
                width=found.width[k],
                planned=board.bridge_width,
            )
            yield "uncut" if wide[k] > 0.0 else "overcut", e, message, float(abs(wide[k]))
        if short[k] > slack:
            message = Message("verify.bridge-near-corner", place=place, distance=short[k])
            yield "deviation", e, message, float(short[k])
        past = float(found.apart[k] - board.bridge_spacing)
        if past > slack:
            message = Message(
                "verify.bridge-spacing",
                place=place,
                distance=found.apart[k],
                most=board.bridge_spacing,
            )
            yield "overcut", e, message, past
        if spare[k]:
            message = Message("verify.bridge-spare", place=place, distance=found.gap_without[k])
            yield "uncut", e, message, float(found.width[k])
    for path in np.flatnonzero(held & (many < MIN_BRIDGES))[:MAX_FINDINGS]:
        e = int(np.flatnonzero(paths.path == path)[0])
        message = Message("verify.too-few-bridges", bridges=many[path], fewest=MIN_BRIDGES)
        yield "overcut", e, message, 0.0


def _corner_shortfall(found: Bridges, paths: EdgePaths, edges: Edges) -> tuple[I64, F64]:
    """Return for bridges the edge that each is on, and how much too near a sharp corner (mm)."""
    size = edges.curve[:, 5]
    edge, place = paths.find(found.path, found.middle, edges.curve)
    least = np.minimum(CORNER_DISTANCE + found.need / 2.0, size[edge] / 2.0)
    sharp = _sharp_corners(paths, edges)
    short = np.zeros(len(edge))
    for side, away in ((0, place), (1, size[edge] - place)):
        short = np.maximum(short, np.where(sharp[2 * edge + side], least - away, 0.0))
    return edge, short


def _sharp_corners(paths: EdgePaths, edges: Edges) -> Bool:
    """Return for the ends of edges on closed paths, (2n,), whether a sharp corner is there."""
    order = np.lexsort((paths.begin, paths.path))
    path = paths.path[order]
    new = np.ones(len(order), np.bool_)
    new[1:] = path[1:] != path[:-1]
    start = np.flatnonzero(new)
    following = np.roll(order, -1)
    following[np.append(start[1:], len(order)) - 1] = order[start]
    leaves = 2 * order + np.where(paths.flipped[order], 0, 1)
    enters = 2 * following + np.where(paths.flipped[following], 1, 0)
    turn = angle_between(edges.outward[leaves], edges.outward[enters] + 180.0)
    result = np.zeros(2 * len(order), np.bool_)
    result[leaves[turn > STRAIGHT_ANGLE]] = True
    result[enters[turn > STRAIGHT_ANGLE]] = True
    return result
