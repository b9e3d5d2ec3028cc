"""Milling: what a cutter (router or beam) needs to know that a knife does not.

    Dieline, rows of cuts of one trade -> Operations[Cutter], open cuts first

A cutter removes a disc, so its centre runs beside the line, in the waste: outside a blank, inside a
hole.  It stands left of travel (a blank is travelled clockwise, a hole counter-clockwise): with a
spindle that turns clockwise that is climb cutting.  A cut with no waste on either side, such as
a slit, or an edge that two blanks share, is cut on the line, and each side loses r.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.chain import chain
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.path import Paths, reversed_where, taken
from knifetip.geometry.tolerance import JOIN
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine, Station
from knifetip.model.operation import End, Operation
from knifetip.model.tool import Cutter
from knifetip.planning.outer import outside

#: More passes than this are a mistake in the tool's ``step``.
_MOST: Final = 200


def milled(
    dieline: Dieline, rows: I32, machine: Machine, board: Board, station: Station
) -> list[Operation]:
    """Return the operations that mill some cuts, all inner ones or all that bound a blank.

    Contours of three or more edges at one place are left open by chaining; which side of them is
    waste is known all the same, if they bound a blank.

    Parameters
    ----------
    rows : (m,)
        Rows of the cuts in the dieline.

    Raises
    ------
    PlanError
        Two blanks touch in one point.
    """
    cutter = station.tool
    assert isinstance(cutter, Cutter)
    ends, bulge = dieline.ends[rows], dieline.bulge[rows]
    chains = chain(ends, bulge)
    paths = _snapped(chains.paths(ends, bulge))
    source = rows[chains.order]
    waste = np.where(chains.flipped, -1, 1) * _waste(dieline)[source]
    first = paths.first[:-1]
    mixed = np.flatnonzero(waste != waste[first][paths.path_of])
    if len(mixed):
        place = paths.start[mixed[0]]
        raise PlanError(
            f"Two blanks touch near ({place[0]:.2f}, {place[1]:.2f}) in one point, and a cutter "
            "cannot go between them.",
            "Move them apart by the cutter's diameter.",
            [str(row) for row in source[mixed[:10]]],
        )
    inside = paths.closed & (waste[first] == 0)
    side = np.where(inside, np.where(_area(paths) > 0.0, 1, -1), waste[first])
    # Left of travel, all of them.
    paths, order = reversed_where(paths, side < 0)
    source = source[order]
    through = board.caliper + machine.into_mat
    passes = 1 if cutter.step == 0.0 else min(_MOST, int(np.ceil(through / cutter.step - 1e-9)))
    depth = through * np.arange(1, passes + 1) / passes
    operations = []
    for stands in (0, 1):
        which = np.flatnonzero(np.abs(side) == stands).astype(np.int32)
        if len(which) == 0:
            continue
        some, kept = taken(paths, which)
        end = np.where(some.closed, End.CLOSED, End.FREE).astype(np.uint8)
        operations.append(
            Operation(
                paths=some,
                line_type=LineType.CUT,
                tool=cutter,
                station=station.number,
                depth=np.tile(depth, (len(kept), 1)),
                caliper=board.caliper,
                clearance=machine.clearance,
                feed=cutter.feed,
                plunge=cutter.plunge,
                swivel=machine.c.velocity * 60.0,
                end_clearance=board.end_clearance,
                overcut=board.groove_overcut,
                short_crease=board.short_crease,
                start=end,
                finish=end,
                source=source[kept],
                side=stands,
                corner="auto",
                acceleration=min(machine.x.acceleration, machine.y.acceleration),
                deflection=next(
                    ((d.x, d.y) for d in board.deflection if d.tool == station.name), (0.0, 0.0)
                ),
            )
        )
    return operations


def _waste(dieline: Dieline) -> I32:
    """Return on which side of each edge the waste round a blank is: +1 left, -1 right, 0 none."""
    cuts = np.flatnonzero(dieline.line_type == LineType.CUT)
    side = np.zeros(len(dieline.bulge), np.int32)
    side[cuts] = outside(dieline.ends[cuts], dieline.bulge[cuts])
    return side


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


def _area(paths: Paths) -> F64:
    """Return the signed area that each path goes round (mm²), > 0 counter-clockwise."""
    # From a point of the path itself, so that far from the origin no digits are lost.
    origin = paths.start[paths.first[:-1]][paths.path_of]
    a, b = paths.start - origin, paths.end - origin
    swept = arc.sweep(paths.bulge)
    radius = arc.radius(paths.start, paths.end, paths.bulge)
    segment = np.where(np.isfinite(radius), radius, 0.0) ** 2 * (swept - np.sin(swept))
    twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] + segment
    area: F64 = np.bincount(paths.path_of, twice, minlength=len(paths)) / 2.0
    return area
