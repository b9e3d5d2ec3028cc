"""radius: offset the centre of a cutter by its radius, so that its disc touches the part.

    Operation[DiscTool] -> Toolpath, one track along every offset path

The same for a router and for a beam with r = kerf / 2.  The offset is set up on a straight lead-in
longer than r and cancelled on a lead-out, so that the tool plunges and lifts in the waste; without
room for leads it plunges on the offset path.  The last pass of a hole cuts its waste loose, so
there the tool lifts where the contour closes.  Contours are milled in several passes; a cut without
a side is milled on the line, forth and back.

Source: radius paper, eqs 1–5 (in the offset engine); set-up and cancel to the perpendicular or
around the outside as in controllers (types A and B).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.compensation.corner import corners
from knifetip.compensation.deflection import shift_centres
from knifetip.compensation.tracks import Strokes, raised
from knifetip.errors import CompensationError, GeometryError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left, unit
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.grid import touching
from knifetip.geometry.path import Paths, begun_in_middle, interrupted, reversed_where
from knifetip.geometry.tolerance import JOIN, POINT
from knifetip.messages import Message
from knifetip.model.operation import Operation
from knifetip.model.tool import DiscTool
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.offset.offset_paths import offset_paths

#: Number of points on a lead that are checked for other contours.
_LOOKS: Final = 8
#: Fractions of the full lead that are tried.
_SHARES: Final = (1.0, 0.5, 0.0)


@dataclass(frozen=True, eq=False, slots=True)
class Centres:
    """Paths of the cutter's centre: n segments in q paths."""

    paths: Paths  #: q paths
    segment: I32  #: (n,) the operation's segment that each belongs to
    unreached: F64  #: (p,) area beside each of the operation's paths that remains uncut (mm²)


def centres(operation: Operation) -> Centres:
    """Return the paths of a cutter's centre, and the area of each contour that it cannot reach.

    Closed paths do not enter one another; each starts in the middle of its longest line.

    Raises
    ------
    CompensationError
        The cutter does not fit into a contour, or would cut into one and interference is refused,
        or corner policy, knob or deflection are invalid.
    """
    cutter = operation.tool
    assert isinstance(cutter, DiscTool)
    paths = operation.paths
    segment = np.arange(len(paths.bulge), dtype=np.int32)
    unreached = np.zeros(len(paths))
    if operation.side != 0:
        kind, k = corners(operation)
        # Open paths are offset one by one: the side beyond their ends is undefined.
        group = np.where(paths.closed, 0, 1 + np.arange(len(paths)))
        try:
            beside = offset_paths(
                paths, cutter.radius, operation.side,
                corner=kind, k=k, interference=operation.interference, group=group,
            )  # fmt: skip
        except (CompensationError, GeometryError) as reason:
            edges = [str(operation.source[int(row)]) for row in reason.source]
            message = reason.message
            if edges:
                message = Message("error.at-edges", edges=edges, error=message)
            raise CompensationError(message, source=edges) from None
        paths, segment, unreached = beside.paths, beside.source, beside.unreached
        _refuse_lost(operation, cutter, segment)
        paths, rows = shift_centres(paths, operation.side, *operation.deflection)
        segment = segment[rows]
    paths, rows = begun_in_middle(paths, paths.closed)
    return Centres(paths, segment[rows], unreached)


def _refuse_lost(operation: Operation, cutter: DiscTool, segment: I32) -> None:
    owner = operation.paths.path_of
    lost = np.setdiff1d(np.arange(len(operation.paths)), owner[segment])
    if len(lost):
        rows = operation.source[operation.paths.first[lost]]
        raise CompensationError(
            "cutter.does-not-fit",
            diameter=2.0 * cutter.radius,
            edge=rows[0],
            others=len(lost) - 1,
            source=[str(row) for row in rows[:10]],
        )


def set_up(
    start: F64, ahead: F64, side: int, radius: float, lead: float, approach: float
) -> tuple[F64, F64, F64]:
    """Return how the offset is set up on a straight lead-in of ``lead`` mm before a contour.

    The lead-in ends at the start of the contour, at an angle of ``approach`` degrees: 90 from the
    tool's side, 0 in line with the contour, −90 from the far side.  If the path turns towards the
    tool's side or not at all, the centre moves straight to the perpendicular at the contour's
    start (type A).  If it turns away, the centre moves parallel to the lead-in to the
    perpendicular at its end, then around the outside on an arc (type B).  Cancelling is the mirror
    image: set up the reversed contour and reverse the result.

    Parameters
    ----------
    start : (m, 2) mm
        Start points of the contours.
    ahead : (m, 2)
        Unit tangents there.
    side
        σ, +1 with the cutter left of travel, −1 right.

    Returns
    -------
    from, to : (m, 2) float64, mm
        Start of the lead-in, and position of the centre at its end.
    bulge : (m,)
        Of the arc from there to the perpendicular at the contour's start; 0 if there is none.
    """
    normal = side * left(ahead)
    cos, sin = np.cos(np.radians(approach)), np.sin(np.radians(approach))
    block = cos * ahead - sin * normal
    begin = start - lead * block
    if approach >= 0.0:
        return begin, start + radius * normal, np.zeros(len(start))
    # A straight move to the perpendicular would cut the corner: it is already at distance r.
    beside = radius * side * left(block)
    turn = np.full(len(start), -side * np.tan(np.radians(-approach) / 4.0))
    return begin + beside, start + beside, turn


def radius(operation: Operation) -> Toolpath:
    """Return the toolpath that mills every contour.

    Raises
    ------
    CompensationError
        As ``centres``; or the cutter's ``lead`` is not longer than r.
    """
    cutter = operation.tool
    assert isinstance(cutter, DiscTool)
    if operation.side != 0 and cutter.set_up <= cutter.radius:
        raise CompensationError("cutter.short-lead", lead=cutter.set_up, radius=cutter.radius)
    way, held = _with_bridges(operation, cutter, centres(operation))
    paths, rows, motion = _with_leads(operation, cutter, way, held)
    loose = paths.end[paths.first[1:] - 1] - paths.start[paths.first[:-1]]
    again = np.hypot(*loose.T) < POINT
    back, mirror = reversed_where(paths, ~again & (operation.side == 0))
    passes = operation.depth.shape[1]
    owner, size = paths.path_of, np.diff(paths.first)
    place = np.arange(len(owner)) - paths.first[:-1][owner]
    total = passes * len(owner)
    start, end = np.empty((total, 2)), np.empty((total, 2))
    bulge, z = np.empty(total), np.empty(total)
    source, kind = np.empty(total, np.int32), np.empty(total, np.uint8)
    down, up = np.zeros(total, np.bool_), np.zeros(total, np.bool_)
    # If a pass ends at the start of the next one, the tool only plunges deeper there.
    stays = again if operation.side != 0 else np.ones(len(paths), np.bool_)
    forward: I32 = np.arange(len(owner), dtype=np.int32)
    for number in range(passes):
        at = passes * paths.first[:-1][owner] + number * size[owner] + place
        ways, order = (back, mirror) if number % 2 else (paths, forward)
        start[at], end[at], bulge[at] = ways.start, ways.end, ways.bulge
        z[at] = operation.caliper - operation.depth[rows[order], number]
        source[at], kind[at] = operation.source[rows[order]], motion[order]
        down[at] = (place == 0) & ((number == 0) | ~stays[owner])
        up[at] = (place == size[owner] - 1) & ((number == passes - 1) | ~stays[owner])
    kept = np.ones(total, np.bool_)
    hole = way.paths.closed & (operation.side * way.paths.areas > 0.0)
    final = passes * paths.first[:-1][owner] + (passes - 1) * size[owner] + place
    kept[final] = ~hole[owner] | (motion != Motion.LEAD_OUT)
    # The tool lifts from the last segment of a track.
    up[:-1] |= kept[:-1] & ~kept[1:]
    upright = np.zeros(total)
    track: I32 = np.repeat(np.arange(len(paths), dtype=np.int32), passes * size)
    height = operation.caliper + operation.clearance
    start_pose = np.column_stack([start, z, upright])[kept]
    end_pose = np.column_stack([end, z, upright])[kept]
    return Strokes(
        start=start_pose,
        end=end_pose,
        bulge=bulge[kept],
        down=down[kept],
        up=up[kept],
        track=track[kept],
        source=source[kept],
        above_start=raised(start_pose, height),
        above_end=raised(end_pose, height),
        motion=kind[kept],
    ).to_toolpath(operation)


def _with_bridges(operation: Operation, cutter: DiscTool, way: Centres) -> tuple[Centres, Bool]:
    """Return the centre paths with gaps for bridges, and which of them have bridges.

    A gap is the bridge's width plus 2r, so that the bridge remains between the two discs.
    """
    if len(operation.bridges) == 0:
        return way, np.zeros(len(way.paths), np.bool_)
    paths, line = way.paths, operation.paths
    segment, at = operation.bridges[:, 0].astype(np.int32), operation.bridges[:, 1]
    whole = line.start[segment], line.end[segment], line.bulge[segment]
    place = arc.point_at(*whole, at / arc.length(*whole))
    # All pieces of the centre path beside the same segment; the nearest one has the bridge.
    order = np.argsort(way.segment, kind="stable")
    low = np.searchsorted(way.segment[order], segment)
    many = np.searchsorted(way.segment[order], segment, side="right") - low
    bridge = np.repeat(np.arange(len(segment)), many)
    step = np.arange(len(bridge)) - np.repeat(np.cumsum(many) - many, many)
    row = order[low[bridge] + step]
    piece = paths.start[row], paths.end[row], paths.bulge[row]
    share = arc.nearest(*piece, place[bridge])
    away = np.hypot(*(arc.point_at(*piece, share) - place[bridge]).T)
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
    along = begin[row[ranked]] + share[ranked] * size[row[ranked]]
    along -= begin[paths.first[:-1][path]]
    ordered = np.lexsort((along, path))
    gap = operation.bridge_width + 2.0 * cutter.radius
    pieces, owner, rows = interrupted(paths, path[ordered], along[ordered], gap)
    held = np.bincount(path, minlength=len(paths))[owner] > 0
    return Centres(pieces, way.segment[rows], way.unreached), held


def _with_leads(
    operation: Operation, cutter: DiscTool, way: Centres, held: Bool
) -> tuple[Paths, I32, U8]:
    """Return the centre paths with lead-ins and lead-outs, their segments, and the kind of each.

    At a bridge the tool plunges and lifts on its path: a lead-in would cut the bridge thinner.
    """
    paths = way.paths
    fed = np.full(len(paths.bulge), Motion.FEED, np.uint8)
    if operation.side == 0:
        return paths, way.segment, fed
    first, last = paths.first[:-1], paths.first[1:] - 1
    ahead, _ = arc.tangents(paths.start[first], paths.end[first], paths.bulge[first])
    _, arriving = arc.tangents(paths.start[last], paths.end[last], paths.bulge[last])
    side = operation.side
    come = _lead(operation, cutter, paths.start[first], unit(ahead), side)
    # The lead-out is the lead-in of the reversed contour.
    leave = _lead(operation, cutter, paths.end[last], -unit(arriving), -side)
    count: I32 = np.arange(len(paths), dtype=np.int32)
    straight: F64 = np.zeros(len(paths))
    own: I32 = np.arange(len(fed), dtype=np.int32)
    parts: list[tuple[F64, F64, F64, I32, I32, U8]] = [
        (come[0], come[1], straight, first, count, _all(Motion.LEAD_IN, count)),
        (come[1], paths.start[first], come[2], first, count, _all(Motion.LEAD_IN, count)),
        (paths.start, paths.end, paths.bulge, own, paths.path_of, fed),
        (paths.end[last], leave[1], -leave[2], last, count, _all(Motion.LEAD_OUT, count)),
        (leave[1], leave[0], straight, last, count, _all(Motion.LEAD_OUT, count)),
    ]
    start, end, bulge, rows, owner, motion = (
        np.concatenate(columns) for columns in zip(*parts, strict=True)
    )
    leads = ~held[owner] & (np.hypot(*(end - start).T) > POINT)
    some: Bool = (motion == Motion.FEED) | leads
    kept = np.flatnonzero(some)
    order = kept[np.argsort(owner[kept], kind="stable")]
    size = np.bincount(owner[order], minlength=len(paths))
    joined = Paths(start[order], end[order], bulge[order], np.concatenate([[0], np.cumsum(size)]))
    return joined, way.segment[rows[order]], motion[order]


def _all(motion: Motion, like: I32) -> U8:
    return np.full(len(like), motion, np.uint8)


def _lead(
    operation: Operation, cutter: DiscTool, place: F64, ahead: F64, side: int
) -> tuple[F64, F64, F64]:
    """Return ``set_up`` for centres that start at ``place``, shortened where contours are near.

    A lead-in whose disc would enter a contour is halved, then omitted: the tool plunges beside the
    contour and touches it there.
    """
    r, paths = cutter.radius, operation.paths
    on_line = place - side * r * left(ahead)
    begin, arrived, bulge = set_up(on_line, ahead, side, r, cutter.set_up, cutter.approach)
    arrived = np.where((bulge == 0.0)[:, None], place, arrived)
    away = begin - arrived
    # Between two checked points an obstacle may be nearer by the sagitta of the step.
    step = float(np.hypot(*away.T).max(initial=0.0)) / _LOOKS
    near = float(np.hypot(r, step / 2.0))
    share = np.full(len(place), _SHARES[-1])
    for tried in reversed(_SHARES[:-1]):
        looks = np.arange(1, _LOOKS + 1) / _LOOKS * tried
        points = (arrived[:, None] + looks[None, :, None] * away[:, None]).reshape(-1, 2)
        hit = touching(
            points, np.full(len(points), -1, np.int32), paths.start, paths.end, paths.bulge, near
        )
        share = np.where(hit.reshape(-1, _LOOKS).any(axis=1), share, tried)
    return arrived + share[:, None] * away, arrived, bulge
