"""crease_wheels: choose the crease wheel of each path, by its bends.

A wheel of radius R pressed in by δ touches the board along a straight line of length 2s,
s² = δ(2R − δ).  On an arc of radius r the ends of this contact lie √(r² + s²) − r beside the arc.
The board states how much of that is permitted (``crease_tolerance``).
"""

from __future__ import annotations

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.model.board import Board
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import CreaseWheel


def crease_stations(machine: Machine, first: Station) -> tuple[Station, ...]:
    """Return the stations with a crease wheel, in the machine's order after ``first``."""
    others = (
        station
        for station in machine.stations
        if isinstance(station.tool, CreaseWheel) and station.number != first.number
    )
    return (first, *others)


def choose_wheels(
    paths: Paths, source: I32, depth: F64, stations: tuple[Station, ...], board: Board
) -> I64:
    """Return the index in ``stations`` of the wheel for each of p paths, (p,).

    The first wheel, which has the best rim for the board, makes every path that it can follow.  A
    path that bends too tightly for it gets the wheel with the best rim of those that can follow the
    path; if none can, the wheel that presses least beside it.  Paths with parts of the same edge
    get the same wheel.

    Parameters
    ----------
    paths
        The paths of the creases, with n segments.
    source : (n,)
        Index in the dieline of the edge of each segment.
    depth : (n,) mm
        Depth of each segment.
    stations
        The stations with a crease wheel; the first one is that for straight creases.
    """
    count = len(paths)
    if len(stations) == 1 or count == 0 or not paths.bulge.any():
        return np.zeros(count, np.int64)
    beside = np.stack([_distance_beside(paths, depth, station) for station in stations])
    beside = _same_for_edges(beside, paths, source)
    serves = beside <= board.crease_tolerance
    return np.where(
        serves[0],
        0,
        np.where(serves.any(axis=0), _best_rims(serves, stations, board), beside.argmin(axis=0)),
    )


def with_chosen_wheels(wheel: I64, chosen: I64, stations: tuple[Station, ...]) -> I64:
    """Return the index in ``stations`` of the wheel for each of p paths, (p,): that which the user
    has chosen, else the given one.

    Parameters
    ----------
    wheel : (p,)
        The wheels from ``choose_wheels``.
    chosen : (p,)
        Number of the station that is chosen for each path; 0 for none.
    stations
        The stations with a crease wheel.
    """
    numbers = np.array([station.number for station in stations])
    found = (chosen[:, None] == numbers).argmax(axis=1)
    result: I64 = np.where(chosen > 0, found, wheel)
    return result


def _distance_beside(paths: Paths, depth: F64, station: Station) -> F64:
    """Return the greatest distance at which a wheel presses beside each of p paths, (p,) mm."""
    wheel = station.tool
    assert isinstance(wheel, CreaseWheel)
    contact = np.sqrt(np.maximum(depth * (2.0 * wheel.radius - depth), 0.0))
    radius = arc.radius(paths.start, paths.end, paths.bulge)
    bent = np.isfinite(radius)
    beside = np.zeros(len(radius))
    beside[bent] = np.hypot(radius[bent], contact[bent]) - radius[bent]
    result = np.zeros(len(paths))
    np.maximum.at(result, paths.path_of, beside)
    return result


def _same_for_edges(beside: F64, paths: Paths, source: I32) -> F64:
    """Return the distances beside the paths for each wheel, (w, p) mm, the greatest of them for
    paths that share an edge.
    """
    owner = paths.path_of
    edge = np.unique(source, return_inverse=True)[1]
    while True:
        at_edge = np.zeros((len(beside), int(edge.max()) + 1))
        at_path = np.zeros_like(beside)
        for row in range(len(beside)):
            np.maximum.at(at_edge[row], edge, beside[row, owner])
            np.maximum.at(at_path[row], owner, at_edge[row, edge])
        if np.array_equal(at_path, beside):
            return at_path
        beside = at_path


def _best_rims(serves: Bool, stations: tuple[Station, ...], board: Board) -> I64:
    """Return for each of p paths the wheel with the best rim of those that can follow it, (p,).

    ``serves`` is the mask of the wheels that can follow each path, (w, p).
    """
    left = list(range(len(stations)))
    result = np.zeros(serves.shape[1], np.int64)
    unset = np.ones(serves.shape[1], np.bool_)
    while left:
        best = left.pop(
            CreaseWheel.best_for([stations[index].tool for index in left], board.caliper)
        )
        chosen = unset & serves[best]
        result[chosen], unset = best, unset & ~chosen
    return result
