"""Check that just those stretches of an outline stay uncut where the user has placed bridges."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, NamedTuple

import numpy as np

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.verification.checks.common.bridges import Bridges
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.expectation.edge_paths import EdgePaths
from knifetip.verification.expectation.edges import TOUCH_DISTANCE, Edges

#: Greatest distance of a bridge from its edge by rounding (mm).
_BESIDE: Final = TOUCH_DISTANCE


class HandBridges(NamedTuple):
    """m bridges that the user has placed on paths of edges."""

    path: I64  #: (m,)
    middle: F64  #: (m,) mm along the path
    width: F64  #: (m,) mm in the top face
    edge: I64  #: (m,) index of the edge
    moved: F64  #: (m,) greatest distance of the cut from the edge as drawn (mm)

    def on_edges(self, mask: Bool) -> HandBridges:
        """Return the bridges on edges of a mask, (n,)."""
        kept = mask[self.edge]
        return HandBridges(
            self.path[kept], self.middle[kept], self.width[kept], self.edge[kept], self.moved[kept]
        )

    def paths(self, count: int) -> Bool:
        """Return the mask of the paths with bridges, (count,)."""
        result = np.zeros(count, np.bool_)
        result[self.path] = True
        return result


def find_hand_bridges(context: CheckContext, edges: Edges, paths: EdgePaths) -> HandBridges:
    """Return the places of the user's bridges on the paths that edges form."""
    found: list[tuple[int, float, float, int, float]] = []
    for bridge in context.bridges:
        near = edges.touched_by_points(bridge.point[None], _BESIDE + bridge.moved)
        own = np.flatnonzero(np.isin(edges.row[near.edge], bridge.rows))
        if len(own) == 0:
            continue
        nearest = own[near.distance[own].argmin()]
        edge, place = int(near.edge[nearest]), float(near.place[nearest].mean())
        size = float(edges.curve[edge, 5])
        middle = float(paths.begin[edge]) + (size - place if paths.flipped[edge] else place)
        found.append((int(paths.path[edge]), middle, bridge.width, edge, bridge.moved))
    columns = list(zip(*found, strict=True)) if found else [()] * 5
    path, middles, width, edge_of, moved = columns
    return HandBridges(
        np.array(path, np.int64),
        np.array(middles, np.float64),
        np.array(width, np.float64),
        np.array(edge_of, np.int64),
        np.array(moved, np.float64),
    )


def planned_widths(bridges: Bridges, hand: HandBridges, paths: EdgePaths, board: Board) -> F64:
    """Return the width that each of k bridges should have, (k,) mm: that of the nearest one that
    the user has placed on its path, or that of the board.
    """
    result = np.full(len(bridges.path), board.bridge_width)
    for k in np.flatnonzero(np.isin(bridges.path, hand.path)):
        own = np.flatnonzero(hand.path == bridges.path[k])
        away = _distance(hand.middle[own], bridges.middle[k], paths.length[bridges.path[k]])
        result[k] = hand.width[own[away.argmin()]]
    return result


def check_hand_bridges(
    bridges: Bridges, hand: HandBridges, paths: EdgePaths, edges: Edges, slack: float
) -> Iterator[tuple[str, int, Message, float]]:
    """Check the bridges on the paths for which the user has placed bridges; for each fault yield
    what ``check_bridges`` yields.

    ``slack`` is the greatest error of a width or a place (mm).
    """
    held = np.zeros(len(bridges.path), np.bool_)
    for m in range(len(hand.path)):
        own = np.flatnonzero(bridges.path == hand.path[m])
        away = _distance(bridges.middle[own], hand.middle[m], paths.length[hand.path[m]])
        limit = slack + hand.moved[m]
        near = own[away <= limit]
        if len(near) == 0:
            message = Message(
                "verify.bridge-missing", edge=int(edges.row[hand.edge[m]]), width=hand.width[m]
            )
            yield "overcut", int(hand.edge[m]), message, float(hand.width[m])
            continue
        held[near] = True
        wide = float(bridges.width[near[0]] - hand.width[m])
        if abs(wide) > limit:
            message = Message(
                "verify.bridge-width",
                place=bridges.middle[near[0]],
                width=bridges.width[near[0]],
                planned=hand.width[m],
            )
            yield "uncut" if wide > 0.0 else "overcut", int(hand.edge[m]), message, abs(wide)
    for k in np.flatnonzero(np.isin(bridges.path, hand.path) & ~held):
        edge = int(paths.locate(bridges.path[[k]], bridges.middle[[k]], edges.curve)[0][0])
        message = Message(
            "verify.bridge-not-chosen", edge=int(edges.row[edge]), width=bridges.width[k]
        )
        yield "uncut", edge, message, float(bridges.width[k])


def _distance(middle: F64 | float, other: F64 | float, length: float) -> F64:
    """Return the distance of positions on a closed path of a length, the shorter way (mm)."""
    apart = np.abs(np.asarray(middle) - other) % length
    result: F64 = np.minimum(apart, length - apart)
    return result
