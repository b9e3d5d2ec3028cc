"""travel: check that no axis of the machine leaves its limits, and that carriages do not collide.

The position of an axis is the programmed position plus the datum of the station, so each station
has its own limits.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from knifetip.errors import TravelExceeded
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.kernels import F64_1, F64_2, Bool_1, kernel
from knifetip.messages import Message
from knifetip.model.machine import Machine, Station
from knifetip.model.toolpath import Toolpath

#: Excess over a limit that is rounding (mm or degrees).
_ROUNDING = 1e-6


def carriage_changes(toolpath: Toolpath, machine: Machine) -> I64:
    """Return the rows of a toolpath that are the first of another carriage than the row before.

    Such a row starts, in the toolpath, where the other carriage is parked.  Its own carriage has
    stood at its own parking position.
    """
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
    low = np.minimum(toolpath.pose[:-1], toolpath.pose[1:])
    high = np.maximum(toolpath.pose[:-1], toolpath.pose[1:])
    arcs = np.flatnonzero(toolpath.bulge)
    boxes = arc.bounding_boxes(
        toolpath.pose[arcs, :2], toolpath.pose[arcs + 1, :2], toolpath.bulge[arcs]
    )
    low[arcs, :2], high[arcs, :2] = boxes[:, :2], boxes[:, 2:]
    changes = carriage_changes(toolpath, machine)
    low[changes] = high[changes] = toolpath.pose[1:][changes]
    for station in machine.stations:
        carriage = machine.carriage_of(station)
        limits = np.array([[axis.low, axis.high] for axis in carriage.axes])
        datum = np.array([station.x, station.y, station.z, station.c])
        own = toolpath.tool == station.number
        row, axis, excess, under = _greatest_excess(low, high, own, datum, limits)
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
                source=[str(edge)] if edge >= 0 else [],
            )
        if machine.gantry:
            _check_distance(toolpath, station, machine, own, low[:, 1], high[:, 1])


@kernel
def _greatest_excess(low: F64_2, high: F64_2, own: Bool_1, datum: F64_1, limits: F64_2) -> Any:
    """Return the row and the axis with the greatest excess over a limit, the excess, and whether
    it is below the lower limit.

    The row is -1 if no row is marked; an excess that is not a number counts as the greatest one.

    Parameters
    ----------
    low, high : (n, 4)
        Least and greatest programmed position of each axis in each row of a toolpath.
    own
        Mask of the rows that are compared, (n,).
    datum : (4,)
        Shift of the programmed positions of each axis.
    limits : (4, 2)
        Limits of each axis.
    """
    row, column, greatest, below = -1, 0, -math.inf, False
    for k in range(len(own)):
        if own[k]:
            for axis in range(4):
                under = limits[axis, 0] - (low[k, axis] + datum[axis])
                over = high[k, axis] + datum[axis] - limits[axis, 1]
                excess = max(under, over)
                if math.isnan(under) or math.isnan(over):
                    return k, axis, math.nan, under > over
                if excess > greatest or row < 0:
                    row, column, greatest, below = k, axis, excess, under > over
    return row, column, greatest, below


def _check_distance(
    toolpath: Toolpath, station: Station, machine: Machine, own: Bool, low: F64, high: F64
) -> None:
    """Raise ``TravelExceeded`` if a station comes too near to another carriage, which is parked.

    Parameters
    ----------
    own : (n,)
        Mask of the rows of the toolpath that the station makes.
    low, high : (n,) mm
        Least and greatest programmed Y in each row.
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
                source=[str(edge)] if edge >= 0 else [],
            )
