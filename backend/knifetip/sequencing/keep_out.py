"""keep_out: lead rapids around or over the keep-out zones of a machine, and refuse work in them.

A keep-out zone is a box on the table, such as a clamp or a stop.  Tool and holder of a station are
taken as a vertical cylinder about the station's axis, with the radius ``Station.reach``, from the
tip upwards.  A move touches a zone if the tip is below the zone's top anywhere on the move, and the
axis comes nearer to the zone than the radius.

A rapid that would touch a zone rises over it, or moves around it at the same height, whichever
takes less time.  The time is that of moves from rest to rest with trapezoidal speed.  The stations
that are not in use are raised, and are not checked.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.messages import Message
from knifetip.model.machine import Machine, Station, Zone
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.rest_time import rest_times
from knifetip.sequencing.travel import carriage_changes

#: Distance in addition to the radius of the tool (mm), so that rounding does not matter.
_SPARE: Final = 0.05
#: Number of chords that replace an arc.
_CHORDS: Final = 64


def avoid_zones(toolpath: Toolpath, machine: Machine) -> Toolpath:
    """Return the toolpath with rapids that touch no keep-out zone of the machine.

    Raises
    ------
    PlanError
        The work on an edge would touch a keep-out zone.
    """
    detours: dict[int, F64] = {}
    travels = np.ones(len(toolpath), np.bool_)
    # Such a row leads from one parked carriage to another, and neither moves along the gantry.
    travels[carriage_changes(toolpath, machine)] = False
    for station in machine.stations if machine.zones else ():
        rows = np.flatnonzero((toolpath.tool == station.number) & travels)
        if len(rows) == 0:
            continue
        touched = np.stack([_touches(toolpath, rows, station, zone) for zone in machine.zones])
        work = touched & (toolpath.motion[rows] != Motion.RAPID)
        if work.any():
            first = int(np.argmax(work.any(axis=0)))
            number = int(np.argmax(work[:, first]))
            raise _work_in_zone(toolpath, rows[work[number]], station, machine.zones[number])
        for column in np.flatnonzero(touched.any(axis=0)):
            row = int(rows[column])
            met = [zone for zone, hit in zip(machine.zones, touched[:, column], strict=True) if hit]
            detours[row] = _detour(
                toolpath.pose[row], toolpath.pose[row + 1], met, station, machine
            )
    return _with_detours(toolpath, detours) if detours else toolpath


def _touches(toolpath: Toolpath, rows: I64, station: Station, zone: Zone) -> Bool:
    """Return the mask of the rows of a toolpath that touch a zone, (k,).

    ``rows`` are k rows of the toolpath, which ``station`` makes.
    """
    start, end = toolpath.pose[rows], toolpath.pose[rows + 1]
    bulge, reach = toolpath.bulge[rows], station.reach + _SPARE
    low = np.minimum(start[:, 2], end[:, 2]) < zone.top
    box = arc.bounding_boxes(start[:, :2], end[:, :2], bulge)
    near = (box[:, 0] < zone.x + zone.width + reach) & (box[:, 2] > zone.x - reach)
    near &= (box[:, 1] < zone.y + zone.height + reach) & (box[:, 3] > zone.y - reach)
    touched = np.zeros(len(rows), np.bool_)
    for k in np.flatnonzero(low & near):
        if bulge[k] == 0.0:
            points = np.stack([start[k, :2], end[k, :2]])
            rise = 0.0
        else:
            one = slice(k, k + 1)
            points = arc.points_along(start[one, :2], end[one, :2], bulge[one], _CHORDS + 1)[0]
            radius = float(arc.radius(start[one, :2], end[one, :2], bulge[one])[0])
            rise = radius * (1.0 - math.cos(2.0 * math.atan(abs(bulge[k])) / _CHORDS))
        touched[k] = _distances(points[:-1], points[1:], zone).min() < reach + rise
    return touched


def _distances(start: F64, end: F64, zone: Zone) -> F64:
    """Return the distances of n straight lines from a zone, seen from above, (n,) mm.

    ``start`` and ``end`` are the ends of the lines, (n, 2) mm.
    """
    low = np.array([zone.x, zone.y])
    high = low + np.array([zone.width, zone.height])
    along = end - start
    with np.errstate(divide="ignore", invalid="ignore"):
        one, other = (low - start) / along, (high - start) / along
    inside = (start >= low) & (start <= high)
    still = along == 0.0
    enter = np.where(still, np.where(inside, -np.inf, np.inf), np.minimum(one, other))
    leave = np.where(still, np.where(inside, np.inf, -np.inf), np.maximum(one, other))
    first, last = enter.max(axis=1), leave.min(axis=1)
    crosses = (first <= last) & (last >= 0.0) & (first <= 1.0)
    result = np.full(len(start), np.inf)
    for point in (start, end):
        gap = np.maximum(np.maximum(low - point, point - high), 0.0)
        result = np.minimum(result, np.hypot(gap[:, 0], gap[:, 1]))
    square = np.maximum((along**2).sum(axis=1), 1e-18)
    for corner in _corners(zone, 0.0):
        fraction = np.clip(((corner - start) * along).sum(axis=1) / square, 0.0, 1.0)
        foot = start + fraction[:, None] * along
        result = np.minimum(result, np.hypot(*(corner - foot).T))
    return np.where(crosses, 0.0, result)


def _corners(zone: Zone, grown: float) -> F64:
    """Return the corners of a zone that is grown by a distance (mm) on all sides, (4, 2) mm."""
    x0, y0 = zone.x - grown, zone.y - grown
    x1, y1 = zone.x + zone.width + grown, zone.y + zone.height + grown
    return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def _work_in_zone(toolpath: Toolpath, rows: I64, station: Station, zone: Zone) -> PlanError:
    """Return the error that rows of a toolpath work in a zone; it gives a place in the first."""
    row = int(rows[0])
    start, end = toolpath.pose[row : row + 1, :2], toolpath.pose[row + 1 : row + 2, :2]
    bulge = toolpath.bulge[row : row + 1]
    middle = np.array([[zone.x + zone.width / 2.0, zone.y + zone.height / 2.0]])
    x, y = start[0]
    if (start != end).any():
        nearest = arc.nearest_fraction(start, end, bulge, middle)
        x, y = arc.point_at(start, end, bulge, nearest)[0]
    edge = int(toolpath.source[row])
    return PlanError(
        "zone.work",
        tool=station.name,
        station=station.number,
        zone=zone.name,
        x=x,
        y=y,
        reach=station.reach,
        place=Message("edge.place", edge=edge) if edge >= 0 else None,
        at_edges=[one for one in toolpath.source[rows].tolist() if one >= 0],
    )


def _detour(start: F64, end: F64, met: Sequence[Zone], station: Station, machine: Machine) -> F64:
    """Return the poses that replace the end of a rapid, so that it touches no zone, (k, 4).

    ``start``, ``end`` (4,): poses of the head at the start and the end of the rapid.
    """
    height = max(zone.top for zone in met) + machine.clearance
    up, across = start.copy(), end.copy()
    up[2] = across[2] = max(height, start[2], end[2])
    over = np.stack([up, across, end])
    if start[2] != end[2]:
        return over
    around = _poses_around_zones(start, end, station, machine)
    if around is None:
        return over
    axes = machine.carriage_of(station).axes
    times = [
        rest_times(np.concatenate([start[None], poses]), axes).sum() for poses in (over, around)
    ]
    return around if times[1] < times[0] else over


def _poses_around_zones(start: F64, end: F64, station: Station, machine: Machine) -> F64 | None:
    """Return the poses on the shortest way around the zones at constant height, (k, 4).

    The way leads over corners of the zones, grown by the reach of the station.  None if there is no
    such way within the travel of the axes.  C turns evenly along the way.
    """
    zones = [zone for zone in machine.zones if zone.top > start[2]]
    reach = station.reach + _SPARE
    corners = np.concatenate([_corners(zone, reach + _SPARE) for zone in zones])
    x, y = machine.carriage_of(station).axes[:2]
    position = np.column_stack(machine.to_axes(*corners.T)) + np.array([station.x, station.y])
    reachable = (position >= (x.low, y.low)) & (position <= (x.high, y.high))
    nodes = np.concatenate([start[None, :2], end[None, :2], corners[reachable.all(axis=1)]])
    count = len(nodes)
    one, other = np.divmod(np.arange(count * count), count)
    free = np.ones(count * count, np.bool_)
    for zone in zones:
        free &= _distances(nodes[one], nodes[other], zone) >= reach
    length = np.where(free, np.hypot(*(nodes[one] - nodes[other]).T), np.inf).reshape(count, count)
    # Dijkstra's algorithm from the start (node 0) to the end (node 1).
    best, before = length[0].copy(), np.zeros(count, np.int64)
    visited = np.zeros(count, np.bool_)
    visited[0] = True
    while not visited[1]:
        node = int(np.argmin(np.where(visited, np.inf, best)))
        if visited[node] or not np.isfinite(best[node]):
            return None
        visited[node] = True
        shorter = best[node] + length[node] < best
        best[shorter] = (best[node] + length[node])[shorter]
        before[shorter] = node
    way = [1]
    while way[-1] != 0:
        way.append(int(before[way[-1]]))
    way.reverse()
    poses = np.tile(end, (len(way) - 1, 1))
    poses[:, :2] = nodes[way[1:]]
    poses[:, 3] = start[3] + (end[3] - start[3]) * best[way[1:]] / best[1]
    return poses


def _with_detours(toolpath: Toolpath, detours: dict[int, F64]) -> Toolpath:
    """Return the toolpath with the ends of rapids replaced by several poses.

    ``detours`` maps the row of a rapid to the poses through which it leads, (k, 4).
    """
    size = np.ones(len(toolpath), np.int64)
    for row, poses in detours.items():
        size[row] = len(poses)
    rows = np.repeat(np.arange(len(toolpath)), size)
    pose = toolpath.pose[1:][rows]
    first = np.cumsum(size) - size
    for row, poses in detours.items():
        pose[first[row] : first[row] + len(poses)] = poses
    return toolpath.with_moves(rows, np.concatenate([toolpath.pose[:1], pose]))
