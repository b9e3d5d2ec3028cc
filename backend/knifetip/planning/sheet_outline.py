"""sheet_outline: the outline of a sheet that was cut to size, and the run-out of grooves past it.

No board lies outside the outline of such a sheet, so a V-cutter that has left it can turn without a
lift.  For this its blade must be entirely off the sheet before it turns, and after the turn, when
the blade points back towards the sheet.  Let r be half the length of the cutting edge, h the width
of one flank of the groove, R² = r² + h², g the machine's clearance, u the direction of the groove
and m the outward normal of the sheet's edge.  The middle of the cutting edge is r before or behind
the tip, and the part of the blade that is below the top face of the board lies within R of it.  The
tip must therefore continue past the edge by::

    r + (R + g) / (u · m)

Source: "A new method of turning processing in multi axis linkage NC machining", section 1: the tool
leaves the surface before it turns.  The length was derived for knifetip.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.similarity import Similarity
from knifetip.geometry.tolerance import GAP
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import extents
from knifetip.model.machine import Machine
from knifetip.model.sheet import Sheet
from knifetip.planning.boundary import BoardOutline, find_contacts
from knifetip.planning.cut_crossings import inner_crossings
from knifetip.topology.subdivision import subdivide

#: A groove that meets the sheet's edge at a smaller angle is not extended (sine).
_LEAST_SINE: Final = 0.5
#: Distance from the sheet in addition to the clearance (mm), so that rounding does not matter.
_SPARE: Final = 0.05


def sheet_outline(
    sheet: Sheet, dieline: Dieline, machine: Machine, turn: float = 0.0
) -> BoardOutline:
    """Return the outline of a sheet on the machine's table.

    Parameters
    ----------
    sheet
        The sheet.
    dieline
        Edges of the drawing in sheet coordinates, at their position on the table.
    machine
        The machine on whose table the sheet lies.
    turn : °
        Angle by which the sheet is turned on the table, counter-clockwise.

    Raises
    ------
    PlanError
        The drawing does not fit on the sheet, the sheet does not fit on the table, or the cuts form
        no closed outline around all other lines.
    """
    if sheet.size is None:
        return _drawn_outline(dieline)
    width, height = sheet.size
    has_work = ~np.isin(dieline.line_type, (LineType.IGNORED, LineType.UNCLASSIFIED))
    back = Similarity(math.cos(math.radians(turn)), -math.sin(math.radians(turn)), 0.0, 0.0)
    along = dieline.ends[has_work] if turn == 0.0 else back.apply(dieline.ends[has_work])
    low_x, low_y, high_x, high_y = extents(along, dieline.bulge[has_work])
    left, below = sheet.margins
    x, y = float(low_x) - left, float(low_y) - below
    if high_x > x + width + GAP or high_y > y + height + GAP:
        raise PlanError(
            "sheet.smaller-than-drawing",
            width=width,
            height=height,
            margin=sheet.margin,
            needed_x=high_x - x,
            needed_y=high_y - y,
        )
    # Clockwise, so that the outside is on the left.
    corner = np.array([(x, y), (x, y + height), (x + width, y + height), (x + width, y)])
    corner = corner if turn == 0.0 else back.inverse.apply(corner)
    (x, y), (right, top) = corner.min(axis=0).tolist(), corner.max(axis=0).tolist()
    if min(x, y) < -GAP or right > machine.width + GAP or top > machine.height + GAP:
        raise PlanError(
            "sheet.off-table",
            machine=machine.title,
            x=x,
            y=y,
            right=right,
            top=top,
            width=machine.width,
            height=machine.height,
        )
    return BoardOutline(corner, np.roll(corner, -1, axis=0), np.zeros(4))


def _drawn_outline(dieline: Dieline) -> BoardOutline:
    """Return the outer contours of the cuts; raise ``PlanError`` if there are none, or if some
    line lies outside them and is not connected with them.

    Such a line shows that the outline of its blank is not closed, or does not belong to a blank.
    """
    cuts = np.flatnonzero(dieline.line_type == LineType.CUT)
    ends, bulge = dieline.ends[cuts], dieline.bulge[cuts]
    division = subdivide(ends, bulge)
    outside = division.outer[division.face]
    side = np.where(outside[:, 0], 1, -1).astype(np.int8)
    # Contours inside another one bound holes and the parts in them, not the sheet.
    inner = division.depth[division.component] > 0
    side[inner | (outside[:, 0] == outside[:, 1])] = 0
    closed = np.zeros(len(division.depth), np.bool_)
    closed[division.component[side != 0]] = True
    apart = ~inner & ~closed[division.component]
    ignored = (LineType.CUT, LineType.IGNORED, LineType.UNCLASSIFIED)
    others = np.flatnonzero(~np.isin(dieline.line_type, ignored))
    begin, stop = dieline.ends[others, 0], dieline.ends[others, 1]
    # Not the middle of each line: contours are counted along the vertical through the point, which
    # for a line of symmetry passes where round blanks touch and may overlap by rounding.
    probe = arc.point_at(begin, stop, dieline.bulge[others], np.full(len(others), 0.37))
    if not side.any() or apart.any() or (division.count_enclosing(probe) == 0).any():
        raise PlanError("sheet.without-outline")
    # Ends that meet are exactly equal in the division, so the outline has no gaps.
    return BoardOutline.from_cuts(
        np.stack([division.start, division.end], axis=1), division.bulge, side
    )


def sheet_run_outs(
    points: F64, ahead: F64, blade: tuple[float, float], clearance: float, sheet: BoardOutline
) -> F64:
    """Return how far the tip of a V-cutter must continue past n ends of grooves to leave the sheet,
    (n,) mm.

    The length is 0 at an end that is not on a straight edge of the sheet, that meets the edge at
    less than 30°, or behind which other board of the sheet lies.

    Parameters
    ----------
    points, ahead : (n, 2) mm and (n, 2)
        Ends of grooves, and at each end the unit vector that points out of the groove.
    blade : mm
        Half the length of the cutting edge, and the width of one flank of the groove.
    clearance : mm
        Least distance of the blade from the sheet while it turns.
    sheet
        Outline of the sheet.
    """
    half, flank = blade
    length = np.zeros(len(points))
    contacts = find_contacts(points, sheet)
    sine = (ahead[contacts.end] * contacts.normal).sum(axis=1)
    single = np.bincount(contacts.end, minlength=len(points))[contacts.end] == 1
    some = np.flatnonzero(single & (sine > _LEAST_SINE) & np.isinf(contacts.radius))
    end, cut = contacts.end[some], contacts.cut[some]
    radius = float(np.hypot(half, flank))
    needed = half + (radius + clearance + _SPARE) / sine[some]
    extent = radius + clearance
    free = _is_free(points[end], ahead[end], needed + half + extent, extent, sheet, cut)
    length[end[free]] = needed[free]
    return length


def _is_free(
    points: F64, ahead: F64, length: F64, extent: float, sheet: BoardOutline, cut: I64
) -> Bool:
    """Return the mask of k run-outs beside which no board of the sheet lies, (k,).

    ``points``, ``ahead``, ``length`` (k, 2) mm, (k, 2), (k,) mm: start, direction and length of
    each run-out.
    ``extent`` mm: width of board-free space on each side of the run-out.
    ``sheet``, ``cut``: outline of the sheet, and the edge of it on which each run-out starts, (k,).
    """
    count = len(points)
    aside = extent * left_normal(ahead)
    # The strip around the run-out: its two sides, its middle, and its far end.
    near, far = points, points + length[:, None] * ahead
    start = np.concatenate([near, near + aside, near - aside, far + aside])
    stop = np.concatenate([far, far + aside, far - aside, far - aside])
    rows = np.arange(4 * count + 1, dtype=np.int32)
    strips = Paths(start, stop, np.zeros(4 * count), rows)
    strip, crossed, _ = inner_crossings(
        strips, np.stack([sheet.start, sheet.end], axis=1), sheet.bulge
    )
    other = crossed != cut[strip % count]
    free = np.ones(count, np.bool_)
    free[strip[other] % count] = False
    return free
