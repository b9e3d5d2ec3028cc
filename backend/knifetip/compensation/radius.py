"""radius: offset the centre of a cutter by its radius, so that its disc touches the part.

The computation is the same for a router and for a laser, with the radius r = kerf / 2.  The tool
plunges and lifts in the waste.  On a straight lead-in, which is longer than r, the centre moves
from the waste to the offset path; on a lead-out it moves back into the waste.  Without room for
leads the tool plunges on the offset path.  The last pass of a hole cuts its waste loose, so the
tool lifts from there without a lead-out; where the lead-out is not on the lead-in, all passes of a
hole end so.  Contours are milled in several passes; a cut without a side is milled on its centre
line, forth and back.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from knifetip.compensation.centre_paths import CentrePaths, centre_paths
from knifetip.compensation.corner import list_places
from knifetip.compensation.leads import fit_lead_ins
from knifetip.compensation.tracks import Strokes, at_height
from knifetip.errors import CompensationError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.path import Paths, insert_gaps, reverse_paths
from knifetip.geometry.tolerance import JOIN, POINT
from knifetip.messages import Message
from knifetip.model.operation import Operation
from knifetip.model.tool import DiscTool
from knifetip.model.toolpath import Motion, Toolpath


def radius_toolpath(operation: Operation) -> Toolpath:
    """Return the toolpath of a cutter along every contour of an operation, in all passes.

    Raises
    ------
    CompensationError
        A contour cannot be offset (see ``centre_paths``), no path runs beside a bridge, or the
        lead-in of the cutter is not longer than its radius.
    """
    cutter = operation.tool
    assert isinstance(cutter, DiscTool)
    if operation.side != 0 and cutter.lead_in <= cutter.radius:
        raise CompensationError("cutter.short-lead", lead=cutter.lead_in, radius=cutter.radius)
    centre, bridged = _add_bridge_gaps(operation, cutter, centre_paths(operation))
    paths, rows, motion, notes = _add_leads(operation, cutter, centre, bridged)
    gap = paths.end[paths.first[1:] - 1] - paths.start[paths.first[:-1]]
    closed = np.hypot(*gap.T) < POINT
    back, mirror = reverse_paths(paths, ~closed & (operation.side == 0))
    passes = operation.depth.shape[1]
    owner, size = paths.path_of, np.diff(paths.first)
    place = np.arange(len(owner)) - paths.first[:-1][owner]
    total = passes * len(owner)
    start, end = np.empty((total, 2)), np.empty((total, 2))
    bulge, z = np.empty(total), np.empty(total)
    source, kind = np.empty(total, np.int32), np.empty(total, np.uint8)
    down, up = np.zeros(total, np.bool_), np.zeros(total, np.bool_)
    # If a pass ends at the start of the next one, the tool only plunges deeper there.
    stays_down = closed if operation.side != 0 else np.ones(len(paths), np.bool_)
    forward: I32 = np.arange(len(owner), dtype=np.int32)
    for number in range(passes):
        at = passes * paths.first[:-1][owner] + number * size[owner] + place
        ways, order = (back, mirror) if number % 2 else (paths, forward)
        start[at], end[at], bulge[at] = ways.start, ways.end, ways.bulge
        z[at] = operation.caliper - operation.depth[rows[order], number]
        source[at], kind[at] = operation.source[rows[order]], motion[order]
        down[at] = (place == 0) & ((number == 0) | ~stays_down[owner])
        up[at] = (place == size[owner] - 1) & ((number == passes - 1) | ~stays_down[owner])
    kept = np.ones(total, np.bool_)
    hole = _is_hole(operation, centre.paths)
    made = np.isfinite(operation.depth[rows[paths.first[:-1]]]).sum(axis=1)
    for number in range(passes):
        at = passes * paths.first[:-1][owner] + number * size[owner] + place
        # A lead-out beside the lead-in would be cut by the earlier passes only.
        stops = hole & ((number == made - 1) | (centre.approach != 90.0))
        kept[at] = ~stops[owner] | (motion != Motion.LEAD_OUT)
    kept &= np.isfinite(z)
    # The tool lifts from the last segment of a track.
    up[:-1] |= kept[:-1] & ~kept[1:]
    upright = np.zeros(total)
    track: I32 = np.repeat(np.arange(len(paths), dtype=np.int32), passes * size)
    height = operation.caliper + operation.clearance
    start_pose = np.column_stack([start, z, upright])[kept]
    end_pose = np.column_stack([end, z, upright])[kept]
    strokes = Strokes(
        start=start_pose,
        end=end_pose,
        bulge=bulge[kept],
        down=down[kept],
        up=up[kept],
        track=track[kept],
        source=source[kept],
        above_start=at_height(start_pose, height),
        above_end=at_height(end_pose, height),
        motion=kind[kept],
    )
    return replace(strokes.to_toolpath(operation), notes=(*centre.notes, *notes))


def _add_bridge_gaps(
    operation: Operation, cutter: DiscTool, centre: CentrePaths
) -> tuple[CentrePaths, Bool]:
    """Return the centre paths with gaps at bridges, and the mask of returned paths at bridges.

    The gaps divide a centre path into several paths; the mask marks each of them.  A gap is longer
    than the width of its bridge by the diameter of the cutter, so that the bridge remains between
    two positions of the disc.

    Raises ``CompensationError``: a bridge has no centre path beside it in which a gap could be
    made.
    """
    if len(operation.bridges) == 0:
        return centre, np.zeros(len(centre.paths), np.bool_)
    paths, line = centre.paths, operation.paths
    segment, at = operation.bridges[:, 0].astype(np.int32), operation.bridges[:, 1]
    whole = line.start[segment], line.end[segment], line.bulge[segment]
    place = arc.point_at(*whole, at / arc.length(*whole))
    # A segment may have several pieces of the centre path beside it; the nearest has the bridge.
    order = np.argsort(centre.segment, kind="stable")
    low = np.searchsorted(centre.segment[order], segment)
    many = np.searchsorted(centre.segment[order], segment, side="right") - low
    bridge = np.repeat(np.arange(len(segment)), many)
    step = np.arange(len(bridge)) - np.repeat(np.cumsum(many) - many, many)
    row = order[low[bridge] + step]
    piece = paths.start[row], paths.end[row], paths.bulge[row]
    fraction = arc.nearest_fraction(*piece, place[bridge])
    away = np.hypot(*(arc.point_at(*piece, fraction) - place[bridge]).T)
    ranked = np.lexsort((away, bridge))
    ranked = ranked[np.append(True, np.diff(bridge[ranked]) > 0)[: len(ranked)]]
    ranked = ranked[away[ranked] <= cutter.radius + JOIN]
    lost = np.setdiff1d(np.arange(len(segment)), bridge[ranked])
    if len(lost):
        edge = operation.source[segment[lost[0]]]
        raise CompensationError(
            "cutter.misses-bridge",
            edge=edge,
            distance=at[lost[0]],
            at_edges=operation.source[segment[lost]],
        )
    size = arc.length(paths.start, paths.end, paths.bulge)
    begin = np.cumsum(size) - size
    path = paths.path_of[row[ranked]]
    along = begin[row[ranked]] + fraction[ranked] * size[row[ranked]]
    along -= begin[paths.first[:-1][path]]
    ordered = np.lexsort((along, path))
    gap = operation.bridges[bridge[ranked[ordered]], 2] + 2.0 * cutter.radius
    pieces, owner, rows = insert_gaps(paths, path[ordered], along[ordered], gap)
    bridged = np.bincount(path, minlength=len(paths))[owner] > 0
    return (
        replace(
            centre, paths=pieces, segment=centre.segment[rows], approach=centre.approach[owner]
        ),
        bridged,
    )


def _add_leads(
    operation: Operation, cutter: DiscTool, centre: CentrePaths, bridged: Bool
) -> tuple[Paths, I32, U8, tuple[Message, ...]]:
    """Return the centre paths with lead-ins and lead-outs.

    Paths with bridges, marked by ``bridged``, get no leads, since a lead-in would make the bridge
    narrower.  Nothing is added to an operation without a side, which is milled on its centre line.

    Returns ``paths`` Paths: paths with n segments, including leads; ``segment`` (n,): for each
    returned segment, the segment of the operation beside which it runs; for a lead, the segment of
    the operation at which it starts or ends; ``motion`` (n,): ``Motion`` of each segment: LEAD_IN,
    FEED or LEAD_OUT; notes: a message about the contours without room for a lead, if there are any.
    """
    paths = centre.paths
    fed = np.full(len(paths.bulge), Motion.FEED, np.uint8)
    if operation.side == 0:
        return paths, centre.segment, fed, ()
    first, last = paths.first[:-1], paths.first[1:] - 1
    ahead, _ = arc.tangents(paths.start[first], paths.end[first], paths.bulge[first])
    _, arriving = arc.tangents(paths.start[last], paths.end[last], paths.bulge[last])
    side = operation.side
    lead_in = fit_lead_ins(
        operation, cutter, paths.start[first], unit_vectors(ahead), side, centre.approach
    )
    # The lead-out is the lead-in of the reversed contour.  Behind a corner there is the contour
    # itself, so there the lead-out is perpendicular to the contour.
    lead_out = fit_lead_ins(
        operation, cutter, paths.end[last], -unit_vectors(arriving), -side,
        np.where(paths.closed & (centre.approach < 0.0), 90.0, centre.approach),
    )  # fmt: skip
    count: I32 = np.arange(len(paths), dtype=np.int32)
    straight: F64 = np.zeros(len(paths))
    own: I32 = np.arange(len(fed), dtype=np.int32)
    come, leave = (
        np.full(len(paths), kind, np.uint8) for kind in (Motion.LEAD_IN, Motion.LEAD_OUT)
    )
    parts: list[tuple[F64, F64, F64, I32, I32, U8]] = [
        (lead_in.begin, lead_in.arrived, straight, first, count, come),
        (lead_in.arrived, paths.start[first], lead_in.bulge, first, count, come),
        (paths.start, paths.end, paths.bulge, own, paths.path_of, fed),
        (paths.end[last], lead_out.arrived, -lead_out.bulge, last, count, leave),
        (lead_out.arrived, lead_out.begin, straight, last, count, leave),
    ]
    start, end, bulge, rows, owner, motion = (
        np.concatenate(columns) for columns in zip(*parts, strict=True)
    )
    leads = ~bridged[owner] & (np.hypot(*(end - start).T) > POINT)
    some: Bool = (motion == Motion.FEED) | leads
    kept = np.flatnonzero(some)
    order = kept[np.argsort(owner[kept], kind="stable")]
    size = np.bincount(owner[order], minlength=len(paths))
    joined = Paths(start[order], end[order], bulge[order], np.concatenate([[0], np.cumsum(size)]))
    # The last pass of a hole has no lead-out.
    has_out = ~_is_hole(operation, paths)
    bare = (lead_in.fraction == 0.0) | ((lead_out.fraction == 0.0) & has_out)
    short = (lead_in.fraction < 1.0) | ((lead_out.fraction < 1.0) & has_out)
    notes = (
        *_missing_lead_notes(paths.start[first[bare & ~bridged]]),
        *_shortened_lead_notes(paths.start[first[short & ~bare & ~bridged]], cutter),
    )
    return joined, centre.segment[rows[order]], motion[order], notes


def _is_hole(operation: Operation, paths: Paths) -> Bool:
    """Return whether each of p centre paths runs inside a hole, (p,)."""
    inside: Bool = paths.closed & (operation.side * paths.areas > 0.0)
    return inside


def _missing_lead_notes(position: F64) -> tuple[Message, ...]:
    """Return a message about contours without room for a lead-in or lead-out, if any.

    ``position`` (m, 2) is the start of each of their centre paths (mm).
    """
    if len(position) == 0:
        return ()
    return (Message("lead.no-room", count=len(position), places=list_places(position)),)


def _shortened_lead_notes(position: F64, cutter: DiscTool) -> tuple[Message, ...]:
    """Return a message about contours with room for half of a lead-in or lead-out only, if any.

    ``position`` (m, 2) is the start of each of their centre paths (mm).
    """
    if len(position) == 0:
        return ()
    return (
        Message(
            "lead.shortened",
            count=len(position),
            length=cutter.lead_in,
            places=list_places(position),
        ),
    )
