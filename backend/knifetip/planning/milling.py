"""Milling: what a cutter (router or beam) needs to know that a knife does not.

    Dieline, rows of cuts -> Operations[DiscTool], layer by layer, open cuts first

A cutter removes a disc, so its centre runs beside the line, in the waste: outside a blank or a part
in a hole, inside a hole.  It stands left of travel (a part is travelled clockwise, a hole
counter-clockwise): with a spindle that turns clockwise that is climb cutting.  A slit, with one
blank on both its sides, is cut on the line, and each side loses r.  An edge that two blanks share
is refused: there is no place for the disc that spares both, and none that is as good as another.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.chain import chain
from knifetip.geometry.columns import F64, I8, I32, I64, Bool
from knifetip.geometry.path import Paths, reversed_where, taken
from knifetip.geometry.tolerance import JOIN
from knifetip.model.board import Board
from knifetip.model.corners import Corners
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine, Station
from knifetip.model.operation import End, Operation
from knifetip.model.tool import DiscTool
from knifetip.planning.bridges import ends_of_others, places
from knifetip.planning.corners import bends, chosen, found
from knifetip.planning.layers import cut_layers
from knifetip.planning.noding import noded
from knifetip.planning.outer import faces
from knifetip.planning.reached import by_disc


def milled(
    corners: Corners,
    dieline: Dieline,
    rows: I32,
    machine: Machine,
    board: Board,
    station: Station,
) -> list[Operation]:
    """Return the operations that mill some cuts, layer by layer from the innermost.

    Every contour is chained by itself, so that two may touch in one point.

    Parameters
    ----------
    corners
        For all corners alike; ``chosen_at`` gives single ones their own.
    rows : (m,)
        Rows of the cuts in the dieline.

    Raises
    ------
    PlanError
        Two blanks share an edge, or a contour has no places for the bridges that the board wants.
    """
    cutter = station.tool
    assert isinstance(cutter, DiscTool)
    ends, bulge = dieline.ends[rows], dieline.bulge[rows]
    sides, face, shared = _beside(dieline)
    _refuse_shared(rows[shared[rows]], cutter)
    layer = cut_layers(ends, bulge, face[rows])
    chains = chain(ends, bulge, group=layer * (int(face.max()) + 2) + face[rows])
    paths = _snapped(chains.paths(ends, bulge))
    source = rows[chains.order]
    number = layer[chains.order][chains.first[:-1]]
    avoid = ends_of_others(dieline, rows[sides[rows] != 0])
    waste = (np.where(chains.flipped, -1, 1) * sides[source])[paths.first[:-1]]
    inside = paths.closed & (waste == 0)
    side = np.where(inside, np.where(paths.areas > 0.0, 1, -1), waste)
    # Left of travel, all of them.
    paths, order = reversed_where(paths, side < 0)
    source = source[order]
    depth = cutter.passes(board.caliper + machine.into_mat)
    operations = []
    turn = 2 * (number.max(initial=0) - number) + np.abs(side)
    for place in np.unique(turn):
        which = np.flatnonzero(turn == place).astype(np.int32)
        some, kept = taken(paths, which)
        end = np.where(some.closed, End.CLOSED, End.FREE).astype(np.uint8)
        held = some.closed & (waste[which] != 0)
        bridges = _bridges(some, held, board, cutter, source[kept], avoid)
        operations.append(
            Operation(
                paths=some,
                line_type=LineType.CUT,
                tool=cutter,
                station=station.number,
                depth=np.tile(depth, (len(kept), 1)),
                caliper=board.caliper,
                clearance=cutter.clearance(machine.clearance),
                feed=cutter.feed,
                plunge=cutter.plunge,
                swivel=machine.c.velocity * 60.0,
                end_clearance=board.end_clearance,
                overcut=board.groove_overcut,
                short_crease=board.short_crease,
                start=end,
                finish=end,
                source=source[kept],
                side=int(place % 2),
                bridges=bridges,
                bridge_width=board.bridge_width,
                corner=corners.type,
                k=corners.k,
                interference=corners.interference,
                acceleration=min(machine.x.acceleration, machine.y.acceleration),
                deflection=next(
                    ((d.x, d.y) for d in board.deflection if d.tool == station.name), (0.0, 0.0)
                ),
            )
        )
    return operations


def _bridges(
    paths: Paths,
    held: Bool,
    board: Board,
    cutter: DiscTool,
    source: I32,
    avoid: F64,
) -> F64:
    """Return the segment of each bridge, and how far along it its middle is (mm), (k, 2).

    The disc reaches r past where its centre stops, on either side of a bridge.
    """
    if board.bridge_width <= 0.0 or board.bridge_spacing <= 0.0:
        return np.zeros((0, 2))
    gap = board.bridge_width + 2.0 * cutter.radius
    # A slot that two discs do not fit into side by side is cleared by the way along its other side.
    room = by_disc(paths, 2.0 * cutter.radius)
    path, place = places(paths, held, gap, board.bridge_spacing, source, avoid, room)
    reached = np.cumsum(arc.length(paths.start, paths.end, paths.bulge))
    before = np.concatenate([[0.0], reached])
    at = before[paths.first[:-1][path]] + place
    segment = np.clip(np.searchsorted(reached, at), paths.first[path], paths.first[path + 1] - 1)
    return np.column_stack([segment, at - before[segment]])


def chosen_at(operations: list[Operation], corners: Corners) -> list[Operation]:
    """Return the operations with the choices for single corners in those that mill.

    Raises
    ------
    PlanError
        A choice names no corner of theirs, or makes no sense.
    """
    milling = [isinstance(one.tool, DiscTool) and one.side != 0 for one in operations]
    contours = [
        bends(one.paths, one.side) for one, mills in zip(operations, milling, strict=True) if mills
    ]
    nearest = found(corners, contours)
    if len(nearest) == 0:
        return operations
    result, bend = [], iter(contours)
    for one, mills in zip(operations, milling, strict=True):
        if mills:
            kind, k = chosen(corners, nearest, next(bend))
            one = replace(one, corner_at=kind, k_at=k)
        result.append(one)
    return result


def _beside(dieline: Dieline) -> tuple[I8, I64, Bool]:
    """Return for every edge what ``outer.faces`` says of it, if it is a cut."""
    cuts = np.flatnonzero(dieline.line_type == LineType.CUT)
    # A line from edge to edge parts a blank, also where those have no corner.
    ends, bulge, row = noded(dieline.ends[cuts], dieline.bulge[cuts])
    lies = faces(ends, bulge)
    count = len(dieline.bulge)
    side, face = np.zeros(count, np.int8), np.full(count, -1, np.int64)
    shared = np.zeros(count, np.bool_)
    side[cuts[row]], face[cuts[row]] = lies.side, lies.face
    shared[cuts[row[lies.shared]]] = True
    return side, face, shared


def _refuse_shared(rows: I32, cutter: DiscTool) -> None:
    if len(rows):
        raise PlanError(
            "milling.shared-edge",
            edge=rows[0],
            diameter=2.0 * cutter.radius,
            source=[str(row) for row in rows[:10]],
        )


def _snapped(paths: Paths) -> Paths:
    """Return the paths with neighbours joined to the bit, and closed where they nearly are."""
    end = paths.end.copy()
    first, last = paths.first[:-1], paths.first[1:] - 1
    inner: Bool = np.ones(len(end), np.bool_)
    inner[last] = False
    rows = np.flatnonzero(inner)
    end[rows] = paths.start[rows + 1]
    # A line there and back along itself ends where it began, and is no contour.
    gap = np.hypot(*(paths.start[first] - paths.end[last]).T)
    near = (gap < JOIN) & ((last > first + 1) | (np.abs(paths.bulge[first]) > 0.0))
    end[last[near]] = paths.start[first[near]]
    return Paths(paths.start, end, paths.bulge, paths.first)
