"""sequence: one way through all tracks.

    Toolpaths in working order, Machine -> Toolpath

Toolpaths keep their order, which is the order of trades; the tracks of each are put in a short one.
Between tracks the head goes through the air, turning as it goes, at the height to which the tool
lifted; where the tool changes, at the machine's travel height.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import F64, I32, U8
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import CreaseWheel
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.order import nearest_neighbour, unwound
from knifetip.sequencing.travel import check_travel


@dataclass(frozen=True, eq=False, slots=True)
class _Moves:
    """Columns of moves, each with the pose that it ends at."""

    pose: F64
    bulge: F64
    motion: U8
    feed: F64
    source: I32
    tool: U8
    track: I32


def sequence(toolpaths: Sequence[Toolpath], machine: Machine) -> Toolpath:
    """Return one toolpath that begins and ends parked, with the tip at travel height.

    Raises
    ------
    PlanError
        There is nothing to do.
    TravelExceeded
        A head would leave the machine's travel.
    """
    work = [toolpath for toolpath in toolpaths if len(toolpath)]
    if not work:
        raise PlanError(
            "Nothing in this drawing is to be worked: every edge is ignored.",
            "Give at least one edge a line type that the machine makes.",
        )
    tool = int(work[0].tool[0])
    home = _parked(machine.station(tool), machine)
    here, parts, count = home, [], 0
    for toolpath in work:
        station = machine.station(int(toolpath.tool[0]))
        if tool != station.number:
            here = _at(here, machine.travel_z)
            parts.append(_air(here, tool))
        moves = _ordered(toolpath, station, machine, here, count)
        if here[2] == machine.travel_z:
            parts.append(_air(_at(moves.pose[0], machine.travel_z), station.number))
        parts.append(moves)
        tool, here = station.number, moves.pose[-1]
        count = int(moves.track.max()) + 1
    parts.append(_air(_at(here, machine.travel_z), tool))
    parts.append(_air(_parked(machine.station(tool), machine), tool))
    columns = {
        field.name: np.concatenate([getattr(part, field.name) for part in parts])
        for field in fields(_Moves)
    }
    columns["pose"] = np.concatenate([home[None], columns["pose"]])
    result = Toolpath(**columns)
    check_travel(result, machine)
    return result


def _at(pose: F64, height: float) -> F64:
    """Return the pose with its tip at a height (mm)."""
    raised = pose.copy()
    raised[2] = height
    return raised


def _parked(station: Station, machine: Machine) -> F64:
    """Return the pose nearest to the table's corner that the station can reach."""
    return np.array(
        [
            min(max(0.0, machine.x.low - station.x), machine.x.high - station.x),
            min(max(0.0, machine.y.low - station.y), machine.y.high - station.y),
            machine.travel_z,
            0.0,
        ]
    )


def _air(pose: F64, tool: int) -> _Moves:
    """Return one move through the air."""
    return _Moves(
        pose=pose[None],
        bulge=np.zeros(1),
        motion=np.array([Motion.RAPID], np.uint8),
        feed=np.zeros(1),
        source=np.array([-1], np.int32),
        tool=np.array([tool], np.uint8),
        track=np.array([-1], np.int32),
    )


def _ordered(
    toolpath: Toolpath, station: Station, machine: Machine, here: F64, count: int
) -> _Moves:
    """Return the tracks of a toolpath in a short order, a link through the air before each.

    ``count`` is the number of the first track.
    """
    # A track is a run of rows with one number; rows between runs are jumps, which links replace.
    inner = np.flatnonzero(toolpath.track >= 0)
    breaks = np.flatnonzero(np.diff(toolpath.track[inner]) != 0) + 1
    first = inner[np.concatenate([[0], breaks])]
    last = inner[np.concatenate([breaks - 1, [len(inner) - 1]])]
    start, end = toolpath.pose[first], toolpath.pose[last + 1]
    order = nearest_neighbour(start[:, :2], end[:, :2], here[:2])
    first, last = first[order], last[order]
    # Row -1 of each track is its link: it ends where the track begins.
    size = last - first + 2
    begin = np.concatenate([[0], np.cumsum(size)])
    rows = np.arange(begin[-1]) + np.repeat(first - 1 - begin[:-1], size)
    link = np.zeros(len(rows), np.bool_)
    link[begin[:-1]] = True
    pose = toolpath.pose[rows + 1]
    motion = np.where(link, Motion.RAPID, toolpath.motion[rows]).astype(np.uint8)
    # In the air C may take any equivalent turn, so it is unwound at every rapid.
    runs = np.flatnonzero(motion == Motion.RAPID)
    shift = unwound(
        pose[runs, 3],
        pose[np.append(runs[1:], len(rows)) - 1, 3],
        np.minimum.reduceat(pose[:, 3], runs),
        np.maximum.reduceat(pose[:, 3], runs),
        float(here[3]),
        machine.c.low - station.c,
        machine.c.high - station.c,
        180.0 if isinstance(station.tool, CreaseWheel) else 360.0,
    )
    pose[:, 3] += np.repeat(shift, np.diff(np.append(runs, len(rows))))
    number = np.repeat(np.arange(count, count + len(order), dtype=np.int32), size)
    return _Moves(
        pose=pose,
        bulge=np.where(link, 0.0, toolpath.bulge[rows]),
        motion=motion,
        feed=np.where(link, 0.0, toolpath.feed[rows]),
        source=np.where(link, -1, toolpath.source[rows]).astype(np.int32),
        tool=np.full(len(rows), station.number, np.uint8),
        track=np.where(link, -1, number).astype(np.int32),
    )
