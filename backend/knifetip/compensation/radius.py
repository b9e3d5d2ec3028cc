"""radius: offset the centre of a cutter by its radius, so that its disc touches the part.

The computation is the same for a router and for a laser, with the radius r = kerf / 2.  The tool
plunges and lifts in the waste.  On a straight lead-in, which is longer than r, the centre moves
from the waste to the offset path; on a lead-out it moves back into the waste.  Without room for
leads the tool plunges on the offset path.  The last pass of a hole cuts its waste loose, so the
tool lifts from there without a lead-out.  Contours are milled in several passes; a cut without a
side is milled on its centre line, forth and back.

Source: the paper "Tool radius compensation", eqs 1–5.  The offset is set up and cancelled as
controllers do: on a straight line to the start of the offset path (type A), or on a line and an arc
around the start of the contour (type B).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from knifetip.compensation.corner import replaced_corner_notes, select_corner_types
from knifetip.compensation.deflection import shift_centres
from knifetip.compensation.tracks import Strokes, at_height
from knifetip.errors import CompensationError, GeometryError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.path import Paths, insert_gaps, reverse_paths, start_in_middle
from knifetip.geometry.points_on_segments import find_points_on_segments
from knifetip.geometry.tolerance import JOIN, POINT
from knifetip.messages import Message
from knifetip.model.operation import Operation
from knifetip.model.tool import DiscTool
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.offset.offset_paths import offset_paths

#: Number of points on a lead at which the distance to contours is checked.
_LEAD_CHECKS: Final = 8
#: Fractions of the full lead, tried from the longest.
_LEAD_FRACTIONS: Final = (1.0, 0.5, 0.0)


@dataclass(frozen=True, eq=False, slots=True)
class CentrePaths:
    """Paths of the cutter's centre: q paths with n segments, from p paths of an operation."""

    paths: Paths  #: q paths
    segment: I32  #: (n,) segment of the operation that each segment belongs to
    unreached: (
        F64  #: (p,) area beside each path of the operation that the cutter cannot reach (mm²)
    )
    #: one message for each corner type that type B replaces, with the positions of the corners
    notes: tuple[Message, ...] = ()


def centre_paths(operation: Operation) -> CentrePaths:
    """Return the paths of the cutter's centre for an operation, with the unreachable areas.

    The unreachable areas lie beside the contours, where the cutter does not fit.  Closed centre
    paths keep the cutter out of all other closed paths of the operation.  Each closed centre path
    starts in the middle of its longest line, or of its longest arc if it has no line.

    Raises
    ------
    CompensationError
        The cutter does not fit into a contour.  Or there are areas that it cannot reach without
        cutting into a contour, and the operation refuses them (``interference`` is "refuse").  Or
        the corner type, its parameter k or the deflection is invalid.
    """
    cutter = operation.tool
    assert isinstance(cutter, DiscTool)
    paths = operation.paths
    segment = np.arange(len(paths.bulge), dtype=np.int32)
    unreached = np.zeros(len(paths))
    notes: tuple[Message, ...] = ()
    if operation.side != 0:
        kind, k = select_corner_types(operation)
        common, rest = _split_deflection(operation, cutter)
        # Open paths are offset one by one: the side beyond their ends is undefined.
        group = np.where(paths.closed, 0, 1 + np.arange(len(paths)))
        try:
            offset = offset_paths(
                paths, cutter.radius - common, operation.side,
                corner=kind, k=k, interference=operation.interference, group=group,
            )  # fmt: skip
        except (CompensationError, GeometryError) as reason:
            edges = [str(operation.source[int(row)]) for row in reason.source]
            message = reason.message
            if edges:
                message = Message("error.at-edges", edges=edges, error=message)
            raise CompensationError(message, source=edges) from None
        notes = replaced_corner_notes(operation, kind, offset.replaced)
        paths, segment, unreached = offset.paths, offset.source, offset.unreached
        _check_every_path_fits(operation, cutter, segment)
        paths, rows = shift_centres(paths, operation.side, *rest)
        segment = segment[rows]
    paths, rows = start_in_middle(paths, paths.closed)
    return CentrePaths(paths, segment[rows], unreached, notes)


def _split_deflection(operation: Operation, cutter: DiscTool) -> tuple[float, tuple[float, float]]:
    """Return the mean of the deflections along X and Y, and what they differ from it (mm).

    A deflection that is equal along X and Y acts like a smaller radius of the cutter, which the
    offset takes into account exactly where the cutter fits and where it does not.  Only the
    differences from the mean are left for ``shift_centres``.

    Raises
    ------
    CompensationError
        A deflection is as large as the cutter's radius.
    """
    x, y = operation.deflection
    if max(x, y) > 0.0 and max(x, y) >= cutter.radius:
        raise CompensationError(
            "deflection.exceeds-radius", radius=cutter.radius, deflection=max(x, y)
        )
    mean = 0.5 * (x + y)
    return mean, (x - mean, y - mean)


def _check_every_path_fits(operation: Operation, cutter: DiscTool, segment: I32) -> None:
    """Raise ``CompensationError`` if the cutter does not fit into a path of the operation.

    Such a path has no offset.  ``segment`` contains, for each segment of the offset, the segment of
    the operation from which it comes.
    """
    owner = operation.paths.path_of
    missing = np.setdiff1d(np.arange(len(operation.paths)), owner[segment])
    if len(missing):
        rows = operation.source[operation.paths.first[missing]]
        raise CompensationError(
            "cutter.does-not-fit",
            diameter=2.0 * cutter.radius,
            edge=rows[0],
            others=len(missing) - 1,
            source=[str(row) for row in rows[:10]],
        )


def set_up_offset(
    start: F64, ahead: F64, side: int, radius: float, lead: float, approach: float
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
    approach : degrees
        Angle between lead-in and contour: 90 for a lead-in from the tool's side, 0 in line with the
        contour, −90 from the other side.

    Returns
    -------
    from, to : (m, 2) mm
        Position of the centre at the start and at the end of the straight move.
    bulge : (m,)
        Bulge of the arc from ``to`` to S; 0 for type A, in which ``to`` is S.
    """
    normal = side * left_normal(ahead)
    cos, sin = np.cos(np.radians(approach)), np.sin(np.radians(approach))
    direction = cos * ahead - sin * normal
    begin = start - lead * direction
    if approach >= 0.0:
        return begin, start + radius * normal, np.zeros(len(start))
    # A straight move to the perpendicular would cut the corner, so the lead-in is already at
    # distance r.
    beside = radius * side * left_normal(direction)
    turn = np.full(len(start), -side * np.tan(np.radians(-approach) / 4.0))
    return begin + beside, start + beside, turn


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
    paths, rows, motion = _add_leads(operation, cutter, centre, bridged)
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
    hole = centre.paths.closed & (operation.side * centre.paths.areas > 0.0)
    final = passes * paths.first[:-1][owner] + (passes - 1) * size[owner] + place
    kept[final] = ~hole[owner] | (motion != Motion.LEAD_OUT)
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
    return replace(strokes.to_toolpath(operation), notes=centre.notes)


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
    return replace(centre, paths=pieces, segment=centre.segment[rows]), bridged


def _add_leads(
    operation: Operation, cutter: DiscTool, centre: CentrePaths, bridged: Bool
) -> tuple[Paths, I32, U8]:
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
    """
    paths = centre.paths
    fed = np.full(len(paths.bulge), Motion.FEED, np.uint8)
    if operation.side == 0:
        return paths, centre.segment, fed
    first, last = paths.first[:-1], paths.first[1:] - 1
    ahead, _ = arc.tangents(paths.start[first], paths.end[first], paths.bulge[first])
    _, arriving = arc.tangents(paths.start[last], paths.end[last], paths.bulge[last])
    side = operation.side
    lead_in = _lead_in(operation, cutter, paths.start[first], unit_vectors(ahead), side)
    # The lead-out is the lead-in of the reversed contour.
    lead_out = _lead_in(operation, cutter, paths.end[last], -unit_vectors(arriving), -side)
    count: I32 = np.arange(len(paths), dtype=np.int32)
    straight: F64 = np.zeros(len(paths))
    own: I32 = np.arange(len(fed), dtype=np.int32)
    parts: list[tuple[F64, F64, F64, I32, I32, U8]] = [
        (
            lead_in[0],
            lead_in[1],
            straight,
            first,
            count,
            np.full_like(count, Motion.LEAD_IN, np.uint8),
        ),
        (
            lead_in[1],
            paths.start[first],
            lead_in[2],
            first,
            count,
            np.full_like(count, Motion.LEAD_IN, np.uint8),
        ),
        (paths.start, paths.end, paths.bulge, own, paths.path_of, fed),
        (
            paths.end[last],
            lead_out[1],
            -lead_out[2],
            last,
            count,
            np.full_like(count, Motion.LEAD_OUT, np.uint8),
        ),
        (
            lead_out[1],
            lead_out[0],
            straight,
            last,
            count,
            np.full_like(count, Motion.LEAD_OUT, np.uint8),
        ),
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
    return joined, centre.segment[rows[order]], motion[order]


def _lead_in(
    operation: Operation, cutter: DiscTool, start: F64, ahead: F64, side: int
) -> tuple[F64, F64, F64]:
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

    Returns
    -------
    from, to : (m, 2) mm
        Position of the centre at the start and at the end of the straight lead-in; equal if its
        length is 0.
    bulge : (m,)
        Bulge of the arc from ``to`` to the start of the centre path; 0 for no arc.
    """
    r, paths = cutter.radius, operation.paths
    on_line = start - side * r * left_normal(ahead)
    begin, arrived, bulge = set_up_offset(on_line, ahead, side, r, cutter.lead_in, cutter.approach)
    arrived = np.where((bulge == 0.0)[:, None], start, arrived)
    away = begin - arrived
    # Between two checked points a contour may be nearer by the sagitta of the step.
    step = float(np.hypot(*away.T).max(initial=0.0)) / _LEAD_CHECKS
    near = float(np.hypot(r, step / 2.0))
    fraction = np.full(len(start), _LEAD_FRACTIONS[-1])
    for tried in reversed(_LEAD_FRACTIONS[:-1]):
        checks = np.arange(1, _LEAD_CHECKS + 1) / _LEAD_CHECKS * tried
        points = (arrived[:, None] + checks[None, :, None] * away[:, None]).reshape(-1, 2)
        hit = find_points_on_segments(
            points, np.full(len(points), -1, np.int32), paths.start, paths.end, paths.bulge, near
        )
        fraction = np.where(hit.reshape(-1, _LEAD_CHECKS).any(axis=1), fraction, tried)
    return arrived + fraction[:, None] * away, arrived, bulge
