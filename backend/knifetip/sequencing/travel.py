"""travel: check that no axis of the machine leaves its limits, and that carriages do not collide.

The position of an axis is the programmed position plus the datum of the station, so each station
has its own limits.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from knifetip.errors import TravelExceeded
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.kernels import F64_2, F64_3, I64_1, U8_1, kernel
from knifetip.messages import Message
from knifetip.model.axis_path import axis_path
from knifetip.model.machine import Machine, Station
from knifetip.model.toolpath import Toolpath

#: Excess over a limit that is rounding (mm or degrees).
_ROUNDING = 1e-6


def carriage_changes(toolpath: Toolpath, machine: Machine) -> I64:
    """Return the rows of a toolpath that are the first of another carriage than the row before.

    Such a row starts, in the toolpath, where the other carriage is parked.  Its own carriage has
    stood at its own parking position.
    """
    if len(machine.carriages) == 1:
        return np.zeros(0, np.int64)
    carriage = np.zeros(256, np.int64)
    for station in machine.stations:
        carriage[station.number] = station.carriage
    result: I64 = np.flatnonzero(np.diff(carriage[toolpath.tool])) + 1
    return result


def check_travel(toolpath: Toolpath, machine: Machine) -> None:
    """Raise ``TravelExceeded`` if a toolpath takes an axis of the machine beyond its limits.

    The error names the first station that exceeds a limit, the axis with the greatest excess, and
    the edge at which that happens.  ``TravelExceeded`` is also raised if a carriage would come too
    near to another one, which is parked.
    """
    toolpath = axis_path(toolpath, machine).path
    pose = np.ascontiguousarray(toolpath.pose)
    arcs = np.flatnonzero(toolpath.bulge)
    boxes = arc.bounding_boxes(pose[arcs, :2], pose[arcs + 1, :2], toolpath.bulge[arcs])
    changes = carriage_changes(toolpath, machine)
    row_of = np.full(256, -1, np.int64)
    row_of[[station.number for station in machine.stations]] = np.arange(len(machine.stations))
    stations = _Stations(
        row_of,
        np.array([(one.x, one.y, one.z, one.c) for one in machine.stations]),
        np.array(
            [
                [(axis.low, axis.high) for axis in machine.carriage_of(station).axes]
                for station in machine.stations
            ]
        ),
    )
    tool = np.ascontiguousarray(toolpath.tool)
    greatest = _greatest_excesses(pose, tool, arcs, boxes, changes, stations)
    for number, station in enumerate(machine.stations):
        carriage, limits = machine.carriage_of(station), stations.limits[number]
        row, axis, excess, under = (column[number] for column in greatest)
        if row >= 0 and (excess > _ROUNDING or math.isnan(excess)):
            edge = int(toolpath.source[row])
            raise TravelExceeded(
                "travel.below" if under else "travel.above",
                tool=station.name,
                station=station.number,
                excess=excess,
                unit="°" if axis == 3 else " mm",
                axis=carriage.letters[int(axis)],
                low=limits[axis, 0],
                high=limits[axis, 1],
                place=Message("edge.place", edge=edge) if edge >= 0 else None,
                at_edges=[edge] if edge >= 0 else [],
            )
        if machine.gantry:
            y = np.stack([pose[:-1, 1], pose[1:, 1]])
            y[:, arcs] = boxes[:, [1, 3]].T
            y[:, changes] = pose[changes + 1, 1]
            own = toolpath.tool == station.number
            _check_distance(toolpath, station, machine, own, y.min(axis=0), y.max(axis=0))


class _Stations(NamedTuple):
    """Datums and limits of the s stations of a machine."""

    row: I64_1  #: (256,) row in these columns of the station with each number, -1 for none
    datum: F64_2  #: (s, 4) shift of the programmed positions of each axis
    limits: F64_3  #: (s, 4, 2) least and greatest position of each axis


@kernel
def _greatest_excesses(
    pose: F64_2, tool: U8_1, arcs: I64_1, boxes: F64_2, changes: I64_1, stations: _Stations
) -> Any:
    """Return for each of s stations the greatest excess over a limit.

    Returns the row of the toolpath and the axis with the greatest excess, the excess, and whether
    it is below the lower limit, (s,) each.  The row is -1 if the station makes no row; an excess
    that is not a number counts as the greatest one.

    ``pose`` (n + 1, 4): poses before and after each row of the toolpath.
    ``tool`` (n,): number of the station that makes each row.
    ``arcs``, ``boxes`` (k,) and (k, 4) mm: the rows that are arcs, ascending, and their bounding
    boxes.
    ``changes``: the rows to whose start the carriage does not come, ascending.
    """
    count = len(stations.datum)
    rows, axes = np.full(count, -1, np.int64), np.zeros(count, np.int64)
    excesses, below = np.full(count, -math.inf), np.zeros(count, np.bool_)
    next_arc = next_change = 0
    for k in range(len(tool)):
        is_arc = next_arc < len(arcs) and arcs[next_arc] == k
        next_arc += is_arc
        begins_elsewhere = next_change < len(changes) and changes[next_change] == k
        next_change += begins_elsewhere
        one = stations.row[tool[k]]
        if one < 0 or math.isnan(excesses[one]):
            continue
        for axis in range(4):
            low, high = pose[k, axis], pose[k + 1, axis]
            if is_arc and axis < 2:
                low, high = boxes[next_arc - 1, axis], boxes[next_arc - 1, axis + 2]
            if begins_elsewhere:
                low = high = pose[k + 1, axis]
            if high < low:
                low, high = high, low
            under = stations.limits[one, axis, 0] - (low + stations.datum[one, axis])
            over = high + stations.datum[one, axis] - stations.limits[one, axis, 1]
            if math.isnan(under) or math.isnan(over):
                rows[one], axes[one], excesses[one], below[one] = k, axis, math.nan, False
                break
            excess = max(under, over)
            if excess > excesses[one] or rows[one] < 0:
                rows[one], axes[one], excesses[one], below[one] = k, axis, excess, under > over
    return rows, axes, excesses, below


def _check_distance(
    toolpath: Toolpath, station: Station, machine: Machine, own: Bool, low: F64, high: F64
) -> None:
    """Raise ``TravelExceeded`` if a station comes too near to another carriage, which is parked.

    ``own`` (n,): mask of the rows of the toolpath that the station makes.
    ``low``, ``high`` (n,) mm: least and greatest programmed Y in each row.
    """
    assert machine.gantry
    carriage = machine.carriage_of(station)
    for number, other in enumerate(machine.carriages, 1):
        if number == station.carriage:
            continue
        above = other.park > carriage.park
        near = other.park - (high + station.y) if above else low + station.y - other.park
        near = np.where(own, near, np.inf)
        row = int(np.argmin(near))
        if near[row] < machine.gantry.min_distance - _ROUNDING:
            edge = int(toolpath.source[row])
            raise TravelExceeded(
                "travel.heads-too-near",
                tool=station.name,
                station=station.number,
                distance=float(near[row]),
                other=number,
                least=machine.gantry.min_distance,
                place=Message("edge.place", edge=edge) if edge >= 0 else None,
                at_edges=[edge] if edge >= 0 else [],
            )
