"""radius: offset the centre of a cutter by its radius, so that its disc touches the part.

The computation is the same for a router and for a laser, with the radius r = kerf / 2.  The tool
plunges and lifts in the waste.  On a straight lead-in, which is longer than r, the centre moves
from the waste to the offset path; on a lead-out it moves back into the waste.  Without room for
leads the tool plunges on the offset path.  The last pass of a hole cuts its waste loose, so the
tool lifts from there without a lead-out; where the lead-out is not on the lead-in, all passes of a
hole end so.  Contours are milled in several passes; a cut without a
side is milled on its centre line, forth and back.

Source: the paper "Tool radius compensation", eqs 1–5.  The offset is set up and cancelled as
controllers do: on a straight line to the start of the offset path (type A), or on a line and an arc
around the start of the contour (type B).  A closed contour that is set up with type B begins at a
corner that the cutter goes round, all others begin in the middle of a segment.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from knifetip.compensation.corner import (
    list_places,
    replaced_corner_notes,
    select_corner_types,
    turn_angles,
)
from knifetip.compensation.deflection import shift_centres
from knifetip.compensation.tracks import Strokes, at_height
from knifetip.errors import CompensationError, GeometryError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.path import Paths, insert_gaps, reverse_paths, start_at, start_in_middle
from knifetip.geometry.points_on_segments import find_points_on_segments
from knifetip.geometry.tolerance import JOIN, POINT
from knifetip.messages import Message
from knifetip.model.operation import Operation
from knifetip.model.tool import DiscTool
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.offset.offset_paths import OffsetPaths, offset_paths
from knifetip.offset.self_contact import find_self_contact

#: Number of points on a lead at which the distance to contours is checked.
_LEAD_CHECKS: Final = 8
#: Fractions of the full lead, tried from the longest.
_LEAD_FRACTIONS: Final = (1.0, 0.5, 0.0)
#: Largest distance by which a lead-in round a corner may come nearer to a contour than r (mm).
_CLEARANCE_ERROR: Final = 0.0005
#: Largest angle by which a corner may turn less than a lead-in round it (degrees).
_ANGLE_TOLERANCE: Final = 1e-6


@dataclass(frozen=True, eq=False, slots=True)
class CentrePaths:
    """Paths of the cutter's centre: q paths with n segments, from p paths of an operation."""

    paths: Paths  #: q paths
    segment: I32  #: (n,) segment of the operation that each segment belongs to
    unreached: (
        F64  #: (p,) area beside each path of the operation that the cutter cannot reach (mm²)
    )
    approach: F64  #: (q,) angle of the lead-in to each path (degrees), as in ``DiscTool``
    #: what the paths change as planned, such as corner types
    notes: tuple[Message, ...] = ()


def centre_paths(operation: Operation) -> CentrePaths:
    """Return the paths of the cutter's centre for an operation, with the unreachable areas.

    The unreachable areas lie beside the contours, where the cutter does not fit.  Closed centre
    paths keep the cutter out of all other closed paths of the operation.  Each closed centre path
    starts in the middle of its longest line, or of its longest arc if it has no line.  For a
    lead-in round a corner it starts behind a corner instead, if there is one with room for the
    lead-in.  A contour into which the cutter does not fit has no centre path; the verifier reports
    its edges as shortfalls.

    Raises
    ------
    CompensationError
        The operation refuses areas that the cutter cannot reach (``interference`` is "refuse"), and
        there are such areas.  Or the corner type, its parameter k or the deflection is invalid.
    """
    cutter = operation.tool
    assert isinstance(cutter, DiscTool)
    paths = operation.paths
    segment = np.arange(len(paths.bulge), dtype=np.int32)
    unreached = np.zeros(len(paths))
    inserted = np.zeros(len(segment), np.bool_)
    notes: tuple[Message, ...] = ()
    if operation.side != 0:
        paths, segment, inserted, unreached, notes = _offset_contours(operation, cutter)
    if operation.side == 0 or cutter.approach >= 0.0 or len(operation.bridges):
        # Paths with bridges have no leads.
        approach = np.full(len(paths), cutter.approach)
        paths, rows = start_in_middle(paths, paths.closed)
        return CentrePaths(paths, segment[rows], unreached, approach, notes)
    behind = _starts_behind_corners(operation, cutter, paths, segment, inserted)
    found = behind >= 0
    approach = np.where(found | ~paths.closed, cutter.approach, 90.0)
    notes += _replaced_lead_notes(paths.start[paths.first[:-1]][paths.closed & ~found], cutter)
    paths, turned = start_at(paths, np.where(found, behind, paths.first[:-1]))
    paths, rows = start_in_middle(paths, paths.closed & ~found)
    return CentrePaths(paths, segment[turned][rows], unreached, approach, notes)


def _offset_contours(
    operation: Operation, cutter: DiscTool
) -> tuple[Paths, I32, Bool, F64, tuple[Message, ...]]:
    """Return the offset of an operation's contours, with the cutter's deflection compensated.

    A deflection that is equal along X and Y acts like a smaller radius of the cutter, which the
    offset takes into account exactly where the cutter fits and where it does not.  So the mean of
    both deflections is subtracted from the radius, and ``shift_centres`` compensates the rest.  If
    the shifted path crosses itself, as in a neck between the smaller and the larger reach, the
    smaller deflection is subtracted instead of the mean: then the cutter does not enter the neck.

    Returns
    -------
    paths : Paths
        Centre paths with n segments.
    segment, inserted : (n,), (n,)
        Segment of the operation that each segment belongs to, and whether it belongs to the
        transition at a corner.
    unreached : (p,) mm²
        Area beside each path of the operation that the cutter cannot reach.
    notes
        What the offset changes as planned.

    Raises
    ------
    CompensationError
        A deflection is as large as the cutter's radius, or the contours have no offset.
    """
    x, y = operation.deflection
    if max(x, y) > 0.0 and max(x, y) >= cutter.radius:
        raise CompensationError(
            "deflection.exceeds-radius", radius=cutter.radius, deflection=max(x, y)
        )
    kind, k = select_corner_types(operation)
    mean, least = 0.5 * (x + y), min(x, y)
    offset = _offset(operation, cutter.radius - mean, kind, k)
    paths, rows = shift_centres(offset.paths, operation.side, x - mean, y - mean)
    if x != y and _crosses_itself(paths):
        other = _offset(operation, cutter.radius - least, kind, k)
        moved, kept = shift_centres(other.paths, operation.side, x - least, y - least)
        if not _crosses_itself(moved):
            offset, paths, rows = other, moved, kept
    notes = replaced_corner_notes(operation, kind, offset.replaced)
    return paths, offset.source[rows], offset.inserted[rows], offset.unreached, notes


def _offset(operation: Operation, distance: float, kind: U8, k: F64) -> OffsetPaths:
    """Return the contours of an operation, offset by a distance in mm.

    ``kind`` and ``k`` are the corner type at the start of each segment and its parameter.

    Raises
    ------
    CompensationError
        The contours have no offset; the message has the edges.
    """
    paths = operation.paths
    # Open paths are offset one by one: the side beyond their ends is undefined.
    group = np.where(paths.closed, 0, 1 + np.arange(len(paths)))
    try:
        return offset_paths(
            paths, distance, operation.side,
            corner=kind, k=k, interference=operation.interference, group=group,
        )  # fmt: skip
    except (CompensationError, GeometryError) as reason:
        edges = [str(operation.source[int(row)]) for row in reason.source]
        message = reason.message
        if message.code == "offset.interference":
            assert isinstance(operation.tool, DiscTool)
            message = Message(
                "cutter.interference",
                diameter=2.0 * operation.tool.radius,
                edge=edges[0],
                other=edges[1],
                depth=message.arguments["depth"],
            )
        elif edges:
            message = Message("error.at-edges", edges=edges, error=message)
        raise CompensationError(message, source=edges) from None


def _crosses_itself(paths: Paths) -> bool:
    """Return whether any of the paths touches or crosses itself, except between neighbours."""
    bounds = pairwise(paths.first.tolist())
    segments = paths.start, paths.end, paths.bulge
    return any(find_self_contact(*segments, low, high)[0] >= 0 for low, high in bounds)


def _starts_behind_corners(
    operation: Operation, cutter: DiscTool, paths: Paths, segment: I32, inserted: Bool
) -> I32:
    """Return for each closed centre path the segment at which it should start, (q,); -1 for none.

    The cutter has a lead-in round a corner (type B).  On it the cutter turns by the angle of the
    lead-in, so the contour must turn away from the cutter by at least this angle.  Of the corners
    with room for the lead-in, the one with the largest turn is returned; if the lead-in must be
    halved everywhere, one with room for the half.

    Parameters
    ----------
    paths
        Centre paths, q in number, with n segments.
    segment : (n,)
        Segment of the operation that each segment belongs to.
    inserted : (n,)
        Whether each segment belongs to the transition at a corner.
    """
    turn = np.degrees(turn_angles(operation.paths, operation.side))[segment]
    before = np.arange(-1, len(segment) - 1)
    before[paths.first[:-1]] = paths.first[1:] - 1
    suited = paths.closed[paths.path_of] & ~inserted & inserted[before]
    suited &= (segment[before] == segment) & (turn >= -cutter.approach - _ANGLE_TOLERANCE)
    rows = np.flatnonzero(suited).astype(np.int32)
    ahead, _ = arc.tangents(paths.start[rows], paths.end[rows], paths.bulge[rows])
    lead = _lead_in(
        operation, cutter, paths.start[rows], unit_vectors(ahead), operation.side,
        np.full(len(rows), cutter.approach),
    )  # fmt: skip
    owner = paths.path_of[rows]
    best = np.lexsort((rows, -turn[rows], -lead.fraction, owner))
    best = best[np.diff(owner[best], prepend=-1) > 0]
    best = best[lead.fraction[best] > 0.0]
    result: I32 = np.full(len(paths), -1, np.int32)
    result[owner[best]] = rows[best]
    return result


def _replaced_lead_notes(position: F64, cutter: DiscTool) -> tuple[Message, ...]:
    """Return a message about contours that the cutter cannot enter round a corner, if any.

    ``position`` (m, 2) is a point of each of these contours (mm).
    """
    if len(position) == 0:
        return ()
    return (
        Message(
            "lead.no-corner",
            count=len(position),
            angle=-cutter.approach,
            places=list_places(position),
        ),
    )


def set_up_offset(
    start: F64, ahead: F64, side: int, radius: float, lead: float, approach: ArrayLike
) -> tuple[F64, F64, F64]:
    """Return the moves that set up the offset on a straight lead-in before each of m contours.

    The centre of the cutter must arrive at the start S of the offset path.  S is the start of the
    contour, moved by the cutter's radius r to the tool's side, perpendicular to the contour.
    Type A: if the path turns from the lead-in towards the tool's side or not at all, the centre
    moves straight to S.  Type B: if the path turns away from the tool's side, the centre moves
    parallel to the lead-in, at the distance r from it, and then to S on an arc around the start of
    the contour.  To cancel the offset, set it up for the reversed contour and reverse the result.

    Parameters
    ----------
    start : (m, 2) mm
        Start points of the contours, where the lead-ins end.
    ahead : (m, 2)
        Unit tangents of the contours at these points.
    side
        σ, +1 if the cutter is left of travel, −1 if right.
    radius : mm
        Radius of the cutter.
    lead : mm
        Length of the lead-in.
    approach : (m,) degrees, or one for all
        Angle between lead-in and contour: 90 for a lead-in from the tool's side, 0 in line with the
        contour, −90 from the other side.

    Returns
    -------
    from, to : (m, 2) mm
        Position of the centre at the start and at the end of the straight move.
    bulge : (m,)
        Bulge of the arc from ``to`` to S; 0 for type A, in which ``to`` is S.
    """
    angle = np.radians(np.broadcast_to(np.asarray(approach, np.float64), len(start)))
    goes_round = angle < 0.0
    normal = side * left_normal(ahead)
    direction = np.cos(angle)[:, None] * ahead - np.sin(angle)[:, None] * normal
    begin = start - lead * direction
    # In type B a straight move to the perpendicular would cut the corner, so the lead-in is already
    # at distance r.
    beside = np.where(goes_round[:, None], radius * side * left_normal(direction), 0.0)
    arrived = start + np.where(goes_round[:, None], beside, radius * normal)
    bulge = np.where(goes_round, -side * np.tan(-angle / 4.0), 0.0)
    return begin + beside, arrived, bulge


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
    for number in range(passes):
        at = passes * paths.first[:-1][owner] + number * size[owner] + place
        # A lead-out beside the lead-in would be cut by the earlier passes only.
        stops = hole & ((number == passes - 1) | (centre.approach != 90.0))
        kept[at] = ~stops[owner] | (motion != Motion.LEAD_OUT)
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

    Raises
    ------
    CompensationError
        A bridge has no centre path beside it in which a gap could be made.
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
            source=[str(operation.source[segment[bad]]) for bad in lost[:10]],
        )
    size = arc.length(paths.start, paths.end, paths.bulge)
    begin = np.cumsum(size) - size
    path = paths.path_of[row[ranked]]
    along = begin[row[ranked]] + fraction[ranked] * size[row[ranked]]
    along -= begin[paths.first[:-1][path]]
    ordered = np.lexsort((along, path))
    gap = operation.bridge_width + 2.0 * cutter.radius
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

    Returns
    -------
    paths : Paths
        Paths with n segments, including leads.
    segment : (n,)
        For each returned segment, the segment of the operation beside which it runs; for a lead,
        the segment of the operation at which it starts or ends.
    motion : (n,)
        ``Motion`` of each segment: LEAD_IN, FEED or LEAD_OUT.
    notes
        A message about the contours without room for a lead, if there are any.
    """
    paths = centre.paths
    fed = np.full(len(paths.bulge), Motion.FEED, np.uint8)
    if operation.side == 0:
        return paths, centre.segment, fed, ()
    first, last = paths.first[:-1], paths.first[1:] - 1
    ahead, _ = arc.tangents(paths.start[first], paths.end[first], paths.bulge[first])
    _, arriving = arc.tangents(paths.start[last], paths.end[last], paths.bulge[last])
    side = operation.side
    lead_in = _lead_in(
        operation, cutter, paths.start[first], unit_vectors(ahead), side, centre.approach
    )
    # The lead-out is the lead-in of the reversed contour.  Behind a corner there is the contour
    # itself, so there the lead-out is perpendicular to the contour.
    lead_out = _lead_in(
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
    bare = (lead_in.fraction == 0.0) | ((lead_out.fraction == 0.0) & ~_is_hole(operation, paths))
    notes = _missing_lead_notes(paths.start[first[bare & ~bridged]])
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


@dataclass(frozen=True, eq=False, slots=True)
class _LeadIns:
    """The lead-ins to m centre paths: a straight move, and for type B an arc."""

    begin: F64  #: (m, 2) mm, start of the straight move; ``arrived`` if its length is 0
    arrived: F64  #: (m, 2) mm, end of the straight move
    bulge: F64  #: (m,) bulge of the arc from ``arrived`` to the start of the path; 0 for no arc
    fraction: F64  #: (m,) length of the straight move, as a fraction of the full lead-in


def _lead_in(
    operation: Operation, cutter: DiscTool, start: F64, ahead: F64, side: int, approach: F64
) -> _LeadIns:
    """Return lead-ins to centre paths, shortened near other contours.

    If the disc would enter a contour along a lead-in, the lead-in is halved.  If the disc would
    still enter a contour, the length of the lead-in becomes 0; then the tool plunges at the start
    of the centre path, where the tool touches the contour.

    Parameters
    ----------
    start : (m, 2) mm
        Start points of the centre paths.
    ahead : (m, 2)
        Unit tangents of the centre paths at their starts.
    side
        +1 if the cutter is left of travel, −1 if right.
    approach : (m,) degrees
        Angles between the lead-ins and the centre paths.
    """
    r = cutter.radius
    on_line = start - side * r * left_normal(ahead)
    begin, arrived, bulge = set_up_offset(on_line, ahead, side, r, cutter.lead_in, approach)
    goes_round = bulge != 0.0
    arrived = np.where(goes_round[:, None], arrived, start)
    away = begin - arrived
    # Between two checked points a contour may be nearer by the sagitta of the step.
    step = float(np.hypot(*away.T).max(initial=0.0)) / _LEAD_CHECKS
    near = float(np.hypot(r, step / 2.0))
    fraction = np.full(len(start), _LEAD_FRACTIONS[-1])
    direct, curved = np.flatnonzero(~goes_round), np.flatnonzero(goes_round)
    # A lead-in round a corner may run along the contour at the distance r, so it is checked at many
    # points instead.
    fine = int(np.ceil(cutter.lead_in / np.sqrt(8.0 * r * _CLEARANCE_ERROR))) if len(curved) else 0
    for tried in reversed(_LEAD_FRACTIONS[:-1]):
        checks = np.arange(1, _LEAD_CHECKS + 1) / _LEAD_CHECKS * tried
        clear = _is_clear(operation.paths, arrived[direct], away[direct], checks, near)
        fraction[direct] = np.where(clear, tried, fraction[direct])
        checks = np.linspace(0.0, tried, fine + 1)
        clear = _is_clear(
            operation.paths, arrived[curved], away[curved], checks, r - _CLEARANCE_ERROR
        )
        fraction[curved] = np.where(clear, tried, fraction[curved])
    round_corner = arc.points_along(arrived[curved], start[curved], bulge[curved], _LEAD_CHECKS)
    hit = find_points_on_segments(
        round_corner.reshape(-1, 2),
        np.full(round_corner.size // 2, -1, np.int32),
        operation.paths.start,
        operation.paths.end,
        operation.paths.bulge,
        r - _CLEARANCE_ERROR,
    )
    blocked = curved[hit.reshape(-1, _LEAD_CHECKS).any(axis=1)]
    fraction[blocked], bulge[blocked], arrived[blocked] = 0.0, 0.0, start[blocked]
    return _LeadIns(arrived + fraction[:, None] * away, arrived, bulge, fraction)


def _is_clear(contours: Paths, origin: F64, away: F64, checks: F64, near: float) -> Bool:
    """Return whether all checked points of straight moves keep away from contours, (m,).

    Parameters
    ----------
    origin, away : (m, 2) mm
        One end of each move, and the vector from there to the other end.
    checks : (c,)
        Positions of the checked points on each move, as fractions of ``away``.
    near : mm
        Distance from the contours that each point must keep.
    """
    points = (origin[:, None] + checks[None, :, None] * away[:, None]).reshape(-1, 2)
    hit = find_points_on_segments(
        points,
        np.full(len(points), -1, np.int32),
        contours.start,
        contours.end,
        contours.bulge,
        near,
    )
    clear: Bool = np.logical_not(hit.reshape(-1, len(checks)).any(axis=1))
    return clear
