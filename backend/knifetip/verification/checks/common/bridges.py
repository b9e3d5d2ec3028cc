"""Check the bridges that hold a part in the sheet.

A bridge is a gap that the paths of the blade's tip leave in a closed path of edges.  Its width is
measured in the top face of the board.  A slanted blade cuts the top face ahead of its tip, by a
length called the lead.  If the tip stops before a bridge, the gap in the tip's path is therefore
wider than the bridge by the lead.  If the tip enters the board after a bridge, the cut in the top
face and the cut in the bottom face begin at the same point.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.intervals import SHORT, Overlaps, uncovered_edges
from knifetip.verification.expectation.edge_paths import EdgePaths
from knifetip.verification.expectation.edges import STRAIGHT_ANGLE, Edges, angle_between
from knifetip.verification.findings import MAX_FINDINGS

#: Smallest distance of a bridge from a sharp corner (mm), and fewest bridges of a part.
CORNER_DISTANCE: Final = 5.0
MIN_BRIDGES: Final = 2


@dataclass(frozen=True, eq=False, slots=True)
class Bridges:
    """k bridges (uncut gaps) in closed paths of edges, sorted by path and by position along the
    path.
    """

    path: I64  #: (k,)
    middle: F64  #: (k,) mm along the path
    width: F64  #: (k,) mm in the top face
    bare: F64  #: (k,) mm, length of the gap in the path of the tip
    need: F64  #: (k,) mm, length that must be clear of corners
    spacing: F64  #: (k,) mm between the middles of this bridge and the next bridge of the path
    gap_without: F64  #: (k,) mm between the middles of the bridges before and after this bridge

    def on_paths(self, mask: Bool) -> Bridges:
        """Return the bridges on the paths of a mask, (c,)."""
        kept = mask[self.path]
        return Bridges(**{one.name: getattr(self, one.name)[kept] for one in fields(Bridges)})


def find_bridges(
    overlaps: Overlaps, paths: EdgePaths, searched: Bool, edges: Edges, lead: float
) -> Bridges:
    """Return the bridges of closed paths: the gaps between the stretches that the knife has cut.

    Parameters
    ----------
    overlaps
        Overlaps of the paths of the knife's tip with the edges.
    paths
        The c paths that the edges form.
    searched : (c,)
        Mask of the closed paths that are searched for bridges.
    edges
        The edges.
    lead : mm
        Length by which the blade cuts the top face ahead of its tip.
    """
    size = edges.curve[:, 5]
    counted = overlaps.best & (np.diff(overlaps.along)[:, 0] > SHORT)
    counted &= np.abs(np.diff(overlaps.place)[:, 0]) > SHORT
    edge = np.maximum(overlaps.edge, 0)
    counted &= searched[paths.path[edge]]
    edge, place = overlaps.edge[counted], overlaps.place[counted]
    flipped = paths.flipped[edge][:, None]
    position = paths.begin[edge][:, None] + np.where(flipped, size[edge][:, None] - place, place)
    path = paths.path[edge]
    forward = position[:, 1] > position[:, 0]
    low, high = position.min(axis=1), position.max(axis=1)
    gap_path, begin, end = uncovered_edges(path, low, high, np.where(searched, paths.length, 0.0))
    length = paths.length[gap_path]
    # Join the two parts of a gap across the start of the path.
    first, last = begin <= 1e-9, end >= length - 1e-9
    for k in np.flatnonzero(first & ~last):
        other = np.flatnonzero((gap_path == gap_path[k]) & last & ~first)
        if len(other):
            end[other[0]] += end[k]
            gap_path[k] = -1
    # A gap between two paths that meet is rounding, not a bridge.
    is_bridge = (gap_path >= 0) & (end - begin > SHORT)
    gap_path, begin, end, length = (
        gap_path[is_bridge],
        begin[is_bridge],
        end[is_bridge],
        length[is_bridge],
    )

    ahead = _are_cut_ends(path[forward], high[forward], gap_path, begin, length)
    back = _are_cut_ends(path[~forward], low[~forward], gap_path, end, length)
    top_begin, top_end = begin + lead * ahead, end - lead * back
    middle = (top_begin + top_end) / 2.0 % np.where(length > 0.0, length, 1.0)
    width = top_end - top_begin
    return order_bridges(gap_path, middle, width, end - begin, width, paths.length)


def order_bridges(path: I64, middle: F64, width: F64, bare: F64, need: F64, length: F64) -> Bridges:
    """Return k bridges sorted by path and by position on it, with the spacings between them.

    The arguments contain the bridges in any order.

    Parameters
    ----------
    path, middle : (k,)
        Index of the path of each bridge, and the position of its middle along that path (mm).
    width, bare : (k,) mm
        Width of each bridge in the top face, and length of the gap in the path of the tip.
    need : (k,) mm
        Length of the stretch, centred on each bridge, that must keep its distance from corners.
    length : (c,) mm
        Length of each of the c paths.
    """
    order = np.lexsort((middle, path))
    path, middle = path[order], middle[order]
    new = np.ones(len(path), np.bool_)
    new[1:] = path[1:] != path[:-1]
    start = np.flatnonzero(new)
    following = np.append(middle[1:], 0.0)[: len(path)]
    closing = np.append(start[1:], len(path))[: len(start)] - 1
    following[closing] = middle[start] + length[path[start]]
    spacing = following - middle
    before = np.roll(spacing, 1)
    before[start] = spacing[closing]
    return Bridges(path, middle, width[order], bare[order], need[order], spacing, spacing + before)


def _are_cut_ends(
    path: I64, end_position: F64, test_path: I64, test_position: F64, length: F64
) -> F64:
    """Return, for each of k positions on closed paths, 1.0 if a cut stretch ends there, else 0.0.

    The result is (k,).  If a cut stretch ends at a position, the tip stops there before a bridge,
    and the blade has cut the top face ahead of the tip by its lead.

    ``path``, ``end_position`` (n,): path of each of n cut stretches, and the position of its end
    along that path (mm).
    ``test_path``, ``test_position`` (k,): path of each position to test, and the position along
    that path (mm).
    ``length`` (k,) mm: length of the path of each position to test.
    """
    result = np.zeros(len(test_path))
    for k in range(len(test_path)):
        difference = np.abs(end_position[path == test_path[k]] - test_position[k]) % length[k]
        result[k] = bool((np.minimum(difference, length[k] - difference) < 1e-6).any())
    return result


def check_bridges(
    bridges: Bridges, paths: EdgePaths, edges: Edges, required: Bool, board: Board, slack: float
) -> Iterator[tuple[str, int, Message, float]]:
    """Check all bridges; for each fault yield the kind of finding, the index of an edge, the
    message, and the size of the fault.

    The edge is the one that the bridge lies on, or the first edge of a path with too few bridges.
    The size is the length (mm) by which a bridge is wrong, the width of a superfluous bridge, or
    0 for too few bridges.

    Parameters
    ----------
    bridges
        All bridges.
    paths, edges
        The c paths that the edges form, and the edges.
    required : (c,)
        Mask of the paths that must have bridges.
    board
        Board whose record states the required width and spacing of bridges.
    slack : mm
        A width, distance or spacing that is wrong by at most this length is no fault.
    """
    edge, short = _corner_shortfall(bridges, paths, edges)
    wide = bridges.width - board.bridge_width
    many = np.bincount(bridges.path, minlength=len(required))
    # A bridge is superfluous if its two neighbours are within the spacing without it.
    spare = many[bridges.path] > MIN_BRIDGES
    spare &= bridges.gap_without <= board.bridge_spacing - slack
    bad = (np.abs(wide) > slack) | (short > slack) | spare
    bad |= bridges.spacing > board.bridge_spacing + slack
    for k in np.flatnonzero(bad)[:MAX_FINDINGS]:
        place, e = bridges.middle[k], int(edge[k])
        if abs(wide[k]) > slack:
            message = Message(
                "verify.bridge-width",
                place=place,
                width=bridges.width[k],
                planned=board.bridge_width,
            )
            yield "uncut" if wide[k] > 0.0 else "overcut", e, message, float(abs(wide[k]))
        if short[k] > slack:
            message = Message("verify.bridge-near-corner", place=place, distance=short[k])
            yield "deviation", e, message, float(short[k])
        past = float(bridges.spacing[k] - board.bridge_spacing)
        if past > slack:
            message = Message(
                "verify.bridge-spacing",
                place=place,
                distance=bridges.spacing[k],
                most=board.bridge_spacing,
            )
            yield "overcut", e, message, past
        if spare[k]:
            message = Message("verify.bridge-spare", place=place, distance=bridges.gap_without[k])
            yield "uncut", e, message, float(bridges.width[k])
    for path in np.flatnonzero(required & (many < MIN_BRIDGES))[:MAX_FINDINGS]:
        e = int(np.flatnonzero(paths.path == path)[0])
        message = Message("verify.too-few-bridges", bridges=many[path], fewest=MIN_BRIDGES)
        yield "overcut", e, message, 0.0


def _corner_shortfall(bridges: Bridges, paths: EdgePaths, edges: Edges) -> tuple[I64, F64]:
    """Return the index of the edge that each of k bridges lies on, (k,), and the missing distance
    from a sharp corner, (k,) mm.

    The missing distance is the length by which the bridge is too near to a sharp corner at an end
    of that edge, and 0 if the bridge is far enough from both ends.
    """
    size = edges.curve[:, 5]
    edge, place = paths.locate(bridges.path, bridges.middle, edges.curve)
    least = np.minimum(CORNER_DISTANCE + bridges.need / 2.0, size[edge] / 2.0)
    sharp = _sharp_corners(paths, edges)
    short = np.zeros(len(edge))
    for side, distance in ((0, place), (1, size[edge] - place)):
        short = np.maximum(short, np.where(sharp[2 * edge + side], least - distance, 0.0))
    return edge, short


def _sharp_corners(paths: EdgePaths, edges: Edges) -> Bool:
    """Return the mask of the ends of n edges at which their path has a sharp corner, (2n,).

    The edges form closed paths.  At a sharp corner the path turns by more than ``STRAIGHT_ANGLE``
    degrees.  End 2i is the start of edge i, and end 2i + 1 is its end.
    """
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
