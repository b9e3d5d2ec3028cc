"""V-groove: keep the tip of the V-cutter on the line.

    Operation[VCutter] -> Toolpath, two passes along every straight path, for each depth

The blade leans, so its tip lies off the axis of the head.  Out and back, with the head turned half
a turn between, the two slanted cuts meet and lift a V out of the board.

Source: Yang, Du, Shu & Qian, "Study on tool compensation of NC carton samplemaker", sections 3, 4.
"""

from __future__ import annotations

import numpy as np

from knifetip.compensation.tracks import Strokes
from knifetip.errors import CurvedGroove, EdgeTooShort, GrooveTooDeep
from knifetip.geometry.azimuth import azimuth, right, unit
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.path import reversed_where
from knifetip.geometry.tolerance import BULGE
from knifetip.model.operation import Operation
from knifetip.model.tool import VCutter
from knifetip.model.toolpath import Toolpath


def head_offset(start: F64, end: F64, cutter: VCutter) -> F64:
    """Return where the head stands, seen from the tip, on the outward pass.

    With β the azimuth of start → end::

        Δx =  d sin β + r cos β
        Δy = -d cos β + r sin β                                   Yang et al., 4.2 a, b

    that is, d to the right of travel and r ahead.  On the way back it is -Δ, so points 1 to 4
    of their figure 3 are A + Δ, B + Δ, B - Δ, A - Δ.

    Parameters
    ----------
    start, end : (n, 2) float64, mm
        Ends of each edge, in the order of travel.
    cutter : VCutter
        Its ``back`` is d, its ``half_width`` r.

    Returns
    -------
    (n, 2) float64, mm
        Add it to either end for the programmed coordinates.

    Raises
    ------
    ZeroLengthEdge
        An edge shorter than ``tolerance.POINT`` has no azimuth.

    Notes
    -----
    The paper's text has r as half the width, its listing as the width (hence ``0.5*r``).
    Here r is half the width.

    Examples
    --------
    >>> head_offset(np.array([[0.0, 0.0]]), np.array([[100.0, 0.0]]), VCutter(4.0, 1.5, 45.0))
    array([[ 1.5, -4. ]])
    """
    ahead = unit(end - start)
    offset: F64 = cutter.back * right(ahead) + cutter.half_width * ahead
    return offset


def sideways(start: F64, end: F64, cutter: VCutter, rise: F64) -> F64:
    """Return how far the head goes sideways, (n, 2) mm, while the tip rises by (n,) mm.

    The tip stays on the blade's own line, so the head moves by Δz tan θ to the right of travel
    when it lifts, and back to the left when it plunges: Yang et al., section 3, the "oblique
    angle" of their three-axis interpolation.
    """
    offset: F64 = cutter.slope * rise[:, None] * right(unit(end - start))
    return offset


def vgroove(operation: Operation) -> Toolpath:
    """Return the toolpath that cuts V-grooves: out and back along every path, for every depth.

    Raises
    ------
    CurvedGroove
        A path has an arc, which a straight blade cannot follow.
    EdgeTooShort
        A path is shorter than the blade is wide.
    GrooveTooDeep
        A groove goes through the board, or the blade would run past its ends further than the
        board allows.
    """
    cutter = operation.tool
    assert isinstance(cutter, VCutter)
    _refuse(operation, cutter)
    there = operation.paths
    back, mirror = reversed_where(there, np.ones(len(there), np.bool_))
    passes = operation.depth.shape[1]
    # Segments in working order: path by path, depth by depth, out and then back.
    owner, size = there.path_of, np.diff(there.first)
    begin = there.first[:-1] * (2 * passes)
    place = np.arange(len(owner)) - there.first[:-1][owner]
    start = np.empty((2 * passes * len(owner), 2))
    end = np.empty_like(start)
    depth = np.empty(len(start))
    source = np.empty(len(start), np.int32)
    down = np.zeros(len(start), np.bool_)
    up = np.zeros(len(start), np.bool_)
    segment: I32 = np.arange(len(owner), dtype=np.int32)
    for stroke in range(2 * passes):
        at = begin[owner] + stroke * size[owner] + place
        paths, rows = (back, mirror) if stroke % 2 else (there, segment)
        start[at], end[at] = paths.start, paths.end
        depth[at] = operation.depth[rows, stroke // 2]
        source[at] = operation.source[rows]
        down[at] = place == 0
        up[at] = place == size[owner] - 1
    offset = head_offset(start, end, cutter)
    heading = azimuth(end - start)
    # Half a turn between out and back, always the same way, and back again: C never winds up.
    track = np.repeat(np.arange(len(there), dtype=np.int32), size * 2 * passes)
    outward_heading = heading[begin][track]
    returning = np.abs(heading - outward_heading) > 90.0
    heading = np.where(returning, outward_heading + 180.0, heading)
    aside = sideways(start, end, cutter, depth + operation.clearance)
    level = operation.caliper - depth
    above = np.full(len(start), operation.caliper + operation.clearance)
    return Strokes(
        start=_pose(start + offset, level, heading),
        end=_pose(end + offset, level, heading),
        bulge=np.zeros(len(start)),
        above_start=_pose(start + offset + aside, above, heading),
        above_end=_pose(end + offset + aside, above, heading),
        down=down,
        up=up,
        track=track,
        source=source,
        swing=np.zeros(len(start)),
    ).laid(operation)


def _pose(xy: F64, z: F64, c: F64) -> F64:
    return np.column_stack([xy, z, c])


def _refuse(operation: Operation, cutter: VCutter) -> None:
    paths = operation.paths
    curved = np.flatnonzero(np.abs(paths.bulge) >= BULGE)
    if len(curved):
        rows = operation.source[curved]
        raise CurvedGroove(
            f"{len(curved)} V-groove edges are arcs, the first of them edge {rows[0]}; "
            "a straight blade cannot follow an arc.",
            "Draw them as straight lines, or give them another line type.",
            [str(row) for row in rows[:10]],
        )
    blade = 2.0 * cutter.half_width
    length = paths.lengths
    short = np.flatnonzero(length < blade)
    if len(short):
        rows = operation.source[paths.first[short]]
        raise EdgeTooShort(
            f"The V-groove at edge {rows[0]} is {length[short[0]]:.2f} mm long, and the blade is "
            f"{blade:.2f} mm wide.",
            "Draw the groove longer, or take a narrower blade.",
            [str(row) for row in rows[:10]],
        )
    deep = np.flatnonzero((operation.depth >= operation.caliper).any(axis=1))
    if len(deep):
        rows = operation.source[deep]
        raise GrooveTooDeep(
            f"The V-groove at edge {rows[0]} is {operation.depth[deep[0]].max():.2f} mm deep, and "
            f"the board only {operation.caliper:.2f} mm.",
            "Take a shallower groove or a thicker board.",
            [str(row) for row in rows[:10]],
        )
    if blade > operation.overcut:
        raise GrooveTooDeep(
            f"The blade runs {blade:.2f} mm past each end of a V-groove, and the board allows "
            f"{operation.overcut:.2f} mm.",
            "Take a narrower blade, or allow a longer overcut for this board.",
            [str(row) for row in operation.source[:10]],
        )
