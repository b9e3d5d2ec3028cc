"""knife: keep a knife's blade on the cut, and adjust the ends of cuts to the slant of the blade.

The leading edge of the blade slants by α, so the cut in the top face of the board is ahead of the
cut in the bottom face, where the tip is, by T tan α for a thickness T.  Therefore
the tip runs past the start of a closed path by this length before it is lifted, unless the path
starts at a corner at which the knife is lifted anyway.  Likewise it runs past
an end that meets another cut with waste behind it.  If a panel lies behind that cut, the tip stops
on the cut, and both faces are cut up to there (see ``docs/contacts.md``).  At an end inside a
panel or at a bridge it stops earlier by this length, so that the cut in the *top* face does not
pass the end.  Around a blank the knife may come
from the waste along a quarter circle, and return to the waste along another quarter circle.  At
sharp corners the knife is lifted and turned above the board.

A drag knife trails the head's axis by e: the head is at tip + e u, with u the direction of travel,
and swings around the tip at corners.  Along an arc of radius r the head follows an arc of radius
√(r² + e²) about the same centre.  A free knife is not lifted at corners, because only travel in the
board turns it; how it gets the heading in which a path starts is in ``sequencing.free_blades``.

Source: our derivation; Yang, Du, Shu & Qian, "Study on tool compensation of NC carton
samplemaker", section 5, suggest the same for other tools.
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.compensation.bends import bend_corners
from knifetip.compensation.contour_starts import lifting_corners
from knifetip.compensation.tracks import Strokes, at_height, empty_toolpath, headings
from knifetip.compensation.unwinding import TurnLimits, lifts_to_unwind
from knifetip.errors import EdgeTooShort
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.path import (
    Paths,
    lengths_behind_corners,
    longest_segments,
    point_along,
    select_paths,
    start_at,
    start_in_middle,
    trim_ends,
)
from knifetip.model.dieline import LineType
from knifetip.model.operation import End, Operation
from knifetip.model.tool import Knife
from knifetip.model.toolpath import Motion, Toolpath

#: Bulge of a quarter circle to the left: tan(90° / 4).
_QUARTER_BULGE = math.tan(math.pi / 8.0)


def knife_toolpath(operation: Operation) -> Toolpath:
    """Return the toolpath of a knife along every path of an operation.

    At corners sharper than the knife's ``swivel`` angle (degrees) the blade is lifted and turned
    above the board; at other corners it turns in the board.  It is lifted, too, at the corners of
    bends (see ``bends``), and where C would leave its limits (see ``unwinding``).  A free knife
    turns in the board at all corners; where another knife would be lifted, it is lifted to its
    swivel depth.

    A cut that ends inside a panel is left out if it is not longer than the length by which the
    slanted blade cuts the top face ahead of its tip; the verifier reports it as a shortfall.  So is
    the last part of a cut that ends inside a panel, from a corner sharper than the swivel angle.

    Raises
    ------
    EdgeTooShort
        A dash, or a cut that ends at a bridge, is not longer than this length.
    """
    blade = operation.tool
    assert isinstance(blade, Knife)
    operation = _without_short_cuts(operation, blade)
    if len(operation.paths) == 0:
        return empty_toolpath()
    paths, rows, motion = _adjust_ends(operation, blade, *_begin_contours(operation, blade))
    source = operation.source[rows]
    c_start, c_end = headings(paths)
    z = operation.caliper - operation.depth[rows, 0]
    begins = np.zeros(len(rows), np.bool_)
    begins[paths.first[:-1]] = True
    turned = c_start - np.roll(c_end, 1)
    sharp = (np.abs(turned) > blade.swivel) | bend_corners(paths, c_start, c_end, blade)
    swivel_z = np.full(len(rows), -math.inf)
    if blade.free:
        down = begins
        if blade.swivel_depth > 0.0:
            swivel_z[sharp] = operation.caliper - blade.swivel_depth
    else:
        down = begins | sharp
        length = arc.length(paths.start, paths.end, paths.bulge)
        limits = TurnLimits(*operation.turn_limits, blade.period)
        down = lifts_to_unwind(c_start, c_end, length, down, limits)
    height = operation.caliper + operation.clearance
    start_pose = np.column_stack([_head_positions(paths.start, c_start, blade), z, c_start])
    end_pose = np.column_stack([_head_positions(paths.end, c_end, blade), z, c_end])
    return Strokes(
        start=start_pose,
        end=end_pose,
        bulge=paths.bulge,
        down=down,
        up=np.roll(down, -1),
        track=paths.path_of,
        source=source,
        above_start=at_height(start_pose, height),
        above_end=at_height(end_pose, height),
        # The head of a drag knife swings around its tip; without a trail it only turns.
        swing=np.where(down, 0.0, np.tan(np.radians(turned) / 4.0)) * (blade.trail > 0.0),
        motion=motion,
        slowing=_feed_fractions(start_pose, end_pose, paths.bulge, blade),
        drags=blade.free,
        swivel_z=swivel_z,
    ).to_toolpath(operation)


def _feed_fractions(start: F64, end: F64, bulge: F64, blade: Knife) -> F64:
    """Return the fraction of the feed at which the head moves along each of n segments, (n,).

    Below ``slow_radius`` it falls in proportion to the radius, so that a blade which the machine
    turns does not turn faster.

    ``start``, ``end`` (n, 4): poses of the head at the ends of each segment.
    ``bulge`` (n,): bulge of the path of the head along each segment.
    """
    if blade.slow_radius == 0.0 or blade.free:
        return np.ones(len(bulge))
    radius = arc.radius(start[:, :2], end[:, :2], bulge)
    result: F64 = np.minimum(1.0, radius / blade.slow_radius)
    return result


def _without_short_cuts(operation: Operation, blade: Knife) -> Operation:
    """Return an operation without the cuts and half-cuts that end inside a panel and are not longer
    than the lead of the blade.
    """
    if operation.line_type not in (LineType.CUT, LineType.HALF_CUT):
        return operation
    paths = operation.paths
    lead = blade.lead(1.0) * operation.depth[paths.first[1:] - 1, -1]
    short = (operation.finish == End.FREE) & (paths.lengths <= lead)
    if not short.any():
        return operation
    return operation.with_paths(np.flatnonzero(~short).astype(np.int32))


def _head_positions(tip: F64, c: F64, blade: Knife) -> F64:
    """Return the positions of the head, (n, 2) mm, from n positions of the tip and n headings.

    The head of a drag knife is ahead of the tip by the blade's ``trail``; otherwise it is at the
    position of the tip.  ``tip`` are the positions of the tip, (n, 2) mm; ``c`` are the headings of
    the blade, (n,) degrees.
    """
    if blade.trail == 0.0:
        return tip
    ahead = np.column_stack([np.cos(np.radians(c)), np.sin(np.radians(c))])
    head: F64 = tip + blade.trail * ahead
    return head


def _begin_contours(operation: Operation, blade: Knife) -> tuple[Paths, I32, Bool]:
    """Return the paths of an operation, with the closed ones started at suitable points.

    A closed path starts with the segment that the operation states: at the start of this segment if
    the knife is lifted at this corner anyway or the user has chosen this start, else in its middle.
    Without a statement it is the first such corner, or the longest line of a path that has no such
    corner or is cut with leads.

    Returns ``paths`` Paths: the p paths, with n segments; ``rows`` (n,): segment of the operation
    from which each returned segment comes; ``smooth`` (p,): true for each closed path that does not
    start at a corner at which the knife is lifted.
    """
    paths, closed = operation.paths, operation.finish == End.CLOSED
    begin: I32 = np.asarray(paths.first[:-1])
    if not closed.any():
        return paths, np.arange(len(paths.bulge), dtype=np.int32), closed
    corner = lifting_corners(operation, blade) & (operation.side == 0)
    if len(operation.begin):
        begin = operation.begin
    else:
        corners = np.flatnonzero(corner)
        after = np.append(corners, len(corner))[np.searchsorted(corners, paths.first[:-1])]
        begin = np.where(closed, longest_segments(paths), begin)
        begin = np.where(after < paths.first[1:], after, begin)
    chosen = operation.starts >= 0
    begin = np.where(chosen, operation.starts, begin)
    turned, rows = start_at(paths, begin)
    smooth = closed & ~corner[begin]
    in_middle = smooth & ~chosen
    if not in_middle.any():
        return turned, rows, smooth
    halved, segment = start_in_middle(turned, in_middle, turned.first[:-1])
    return halved, rows[segment], smooth


def _adjust_ends(
    operation: Operation, blade: Knife, paths: Paths, origin: I32, smooth: Bool
) -> tuple[Paths, I32, U8]:
    """Return paths with adjusted ends, and with lead-ins and lead-outs.

    The ends are shortened or extended, because the slanted blade cuts the top face ahead of its
    tip.

    ``paths``, ``origin``, ``smooth``: paths of the operation as ``_begin_contours`` returns them: p
    paths with m segments, the segment of the operation from which each segment comes, (m,), and the
    mask of the closed paths that do not start at a corner at which the knife is lifted, (p,).
    Returns ``paths`` Paths: paths with n segments, including lead-ins and lead-outs; ``rows`` (n,):
    for each returned segment, the segment of the operation from which it comes; for an extension, a
    lead-in or a lead-out, the segment of the operation that it adjoins; ``motion`` (n,): ``Motion``
    of each segment: LEAD_IN, FEED or LEAD_OUT.
    Raises ``EdgeTooShort``: a dash, or a path that ends at a bridge, is not longer than the length
    by which it would be shortened.
    """
    finish = operation.finish
    last = origin[paths.first[1:] - 1]
    # All passes have the path of the last one, in which the blade reaches farthest.
    depth = operation.depth[last, -1]
    lead = blade.lead(1.0) * depth
    overrun = blade.lead(1.0) * np.minimum(depth, operation.caliper)
    length = paths.lengths
    free = (finish == End.FREE) | (finish == End.BRIDGE)
    short = np.flatnonzero(free & (length <= lead))
    if len(short):
        listed = operation.source[last[short]]
        raise EdgeTooShort(
            "cut.too-short",
            edge=listed[0],
            length=length[short[0]],
            lead=lead[short[0]],
            at_edges=listed,
        )
    removed = np.where(free, lead, 0.0)
    if operation.line_type in (LineType.CUT, LineType.HALF_CUT):
        # The tip cannot stop before the end on such a stub, so it stops at the corner.
        stub = lengths_behind_corners(paths, blade.swivel)
        is_left_out = (finish == End.FREE) & (stub <= lead)
        removed = np.where(is_left_out, stub, removed)
    cut, rows = trim_ends(paths, np.zeros(len(paths)), removed)
    again, more = _repeated_starts(paths, np.where(smooth, overrun, 0.0))
    beyond, far = _extensions(paths, np.where(finish == End.MEETS, overrun, 0.0))
    led = smooth & (operation.side != 0)
    leads = _quarter_circles(
        paths, np.where(led, blade.lead_in, 0.0), overrun, operation.side, True
    )
    exits = _quarter_circles(
        paths, np.where(led, blade.lead_out, 0.0), overrun, operation.side, False
    )
    if not any(len(added) for added in (leads[1], more, far, exits[1])):
        return cut, origin[rows], np.full(len(rows), Motion.FEED, np.uint8)
    parts = [
        (*leads, Motion.LEAD_IN),
        (cut, rows, Motion.FEED),
        (again, more, Motion.FEED),
        (beyond, far, Motion.FEED),
        (*exits, Motion.LEAD_OUT),
    ]
    owner = np.concatenate([part.path_of for part, _, _ in parts])
    order = np.argsort(owner, kind="stable")
    count = np.bincount(owner, minlength=len(paths))
    joined = Paths(
        np.concatenate([part.start for part, _, _ in parts])[order],
        np.concatenate([part.end for part, _, _ in parts])[order],
        np.concatenate([part.bulge for part, _, _ in parts])[order],
        np.concatenate([[0], np.cumsum(count)]),
    )
    motion = np.repeat(
        np.array([kind for _, _, kind in parts], np.uint8), [len(part[1]) for part in parts]
    )
    rows = origin[np.concatenate([part[1] for part in parts])[order]]
    return joined, rows, motion[order]


def _repeated_starts(paths: Paths, size: F64) -> tuple[Paths, I32]:
    """Return the first part of each of p paths, which the knife cuts once more at the end.

    In this way the knife runs past the start of a closed path.  ``size`` (p,) is the
    length of the part for each path (mm), 0 for none.  Also returns, for each returned segment, the
    segment of ``paths`` of which it is a part.
    """
    if not size.any():
        return _empty_paths(len(paths)), np.zeros(0, np.int32)
    return trim_ends(paths, np.zeros(len(paths)), np.maximum(paths.lengths - size, 0.0))


def _empty_paths(count: int) -> Paths:
    """Return ``count`` paths without segments."""
    return Paths(np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0), np.zeros(count + 1, np.int32))


def _extensions(paths: Paths, size: F64) -> tuple[Paths, I32]:
    """Return straight extensions of p paths beyond the ends at which the paths finish.

    ``size`` (p,) is the length of the extension of each path (mm), 0 for no extension.  Also
    returns, for each extension, the segment of ``paths`` that it continues.
    """
    last = (paths.first[1:] - 1)[size > 0.0]
    _, ahead = arc.tangents(paths.start[last], paths.end[last], paths.bulge[last])
    ahead /= np.hypot(*ahead.T)[:, None]
    end = paths.end[last] + ahead * size[size > 0.0, None]
    first = np.concatenate([[0], np.cumsum(size > 0.0)])
    return Paths(paths.end[last], end, np.zeros(len(last)), first), last.astype(np.int32)


def _quarter_circles(
    paths: Paths, size: F64, overrun: F64, side: int, entering: bool
) -> tuple[Paths, I32]:
    """Return quarter circles by which the knife enters or leaves p closed paths.

    Returns p paths of one quarter circle each; a path is empty if its ``size`` is 0.  Also returns,
    for each quarter circle, the index of the segment of ``paths`` that it touches.

    ``size`` (p,) mm: length of each quarter circle; 0 for none.
    ``overrun`` (p,) mm: length by which the knife runs past the start of each path before it leaves
    the path.
    ``side``: side of the waste: +1 left of travel, -1 right.
    ``entering``: true for quarter circles that end at the start of a path, False for quarter
    circles by which the knife leaves it.
    """
    which = np.flatnonzero(size > 0.0).astype(np.int32)
    some, kept = select_paths(paths, which)
    if len(which) == 0:
        return _empty_paths(len(paths)), kept
    first = np.concatenate([[0], np.cumsum(size > 0.0)])
    at = np.zeros(len(which)) if entering else overrun[which]
    place, heading, row = point_along(some, at)
    ahead = np.column_stack([np.cos(np.radians(heading)), np.sin(np.radians(heading))])
    radius = (size[which] * 2.0 / np.pi)[:, None]
    far = place + radius * (
        side * left_normal(ahead) - ahead if entering else side * left_normal(ahead) + ahead
    )
    start, end = (far, place) if entering else (place, far)
    return Paths(start, end, np.full(len(which), side * _QUARTER_BULGE), first), kept[row]
