"""travel: check that no axis of the machine leaves its limits.

The position of an axis is the programmed position plus the datum of the station, so each station
has its own limits.
"""

from __future__ import annotations

import numpy as np

from knifetip.errors import TravelExceeded
from knifetip.geometry import arc
from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Toolpath

#: Excess over a limit that is rounding (mm or degrees).
_ROUNDING = 1e-6


def check_travel(toolpath: Toolpath, machine: Machine) -> None:
    """Raise ``TravelExceeded`` if a toolpath takes an axis of the machine beyond its limits.

    The error names the first station that exceeds a limit, the axis with the greatest excess, and
    the edge at which that happens.
    """
    boxes = arc.bounding_boxes(toolpath.pose[:-1, :2], toolpath.pose[1:, :2], toolpath.bulge)
    low = np.minimum(toolpath.pose[:-1], toolpath.pose[1:])
    high = np.maximum(toolpath.pose[:-1], toolpath.pose[1:])
    low[:, :2], high[:, :2] = boxes[:, :2], boxes[:, 2:]
    axes = (machine.x, machine.y, machine.z, machine.c)
    limits = np.array([[axis.low, axis.high] for axis in axes])
    for station in machine.stations:
        datum = np.array([station.x, station.y, station.z, station.c])
        own = (toolpath.tool == station.number)[:, None]
        under = np.where(own, limits[:, 0] - (low + datum), -np.inf)
        over = np.where(own, high + datum - limits[:, 1], -np.inf)
        past = np.maximum(under, over)
        row, axis = np.unravel_index(np.argmax(past), past.shape)
        excess = past[row, axis]
        if excess > _ROUNDING or np.isnan(excess):
            edge = int(toolpath.source[row])
            raise TravelExceeded(
                "travel.below" if under[row, axis] > over[row, axis] else "travel.above",
                tool=station.name,
                station=station.number,
                excess=excess,
                unit="°" if axis == 3 else " mm",
                axis="XYZC"[int(axis)],
                low=limits[axis, 0],
                high=limits[axis, 1],
                place=Message("edge.place", edge=edge) if edge >= 0 else None,
                source=[str(edge)] if edge >= 0 else [],
            )
