"""sequence: one way through all tracks.

    Toolpaths in working order, Machine -> Toolpath

Toolpaths keep their order, which is the order of trades; the tracks of each are put in a short one,
and run from their far end where that is as good.  Between tracks the head goes through the air,
turning as it goes, at the least height that clears the board; where the tool changes, at the
machine's travel height.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.path import Paths
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import Reversal
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.order import shortest
from knifetip.sequencing.travel import check_travel
from knifetip.sequencing.turning import clear_ways, interference, lifted, unwound

#: What a motion is when it is run backwards.
_BACKWARDS: Final = np.arange(len(Motion), dtype=np.uint8)
_BACKWARDS[[Motion.LIFT, Motion.LEAD_IN, Motion.LEAD_OUT]] = (
    Motion.PLUNGE,
    Motion.LEAD_OUT,
    Motion.LEAD_IN,
)


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


def sequence(
    toolpaths: Sequence[Toolpath], machine: Machine, outline: Paths | None = None
) -> Toolpath:
    """Return one toolpath that begins and ends parked, with the tip at travel height.

    Parameters
    ----------
    toolpaths
        In working order; each lifts to the machine's clearance above the board at its tracks' ends.
    outline : closed Paths, holes included
        Of the board itself.  Given, a tool that has left the board turns without a lift.  A dieline
        is no such thing: around the blank lies the rest of the sheet.

    Raises
    ------
    PlanError
        There is nothing to do.
    TravelExceeded
        A head would leave the machine's travel.
    """
    work = [toolpath for toolpath in toolpaths if len(toolpath)]
    if not work:
        raise PlanError("job.no-work")
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
    result = _least_lift(Toolpath(**columns), machine, outline)
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
    # A stay is a run of rows from one rapid to the next, a track the stays with one number; rows
    # between tracks are jumps.  Rapids are laid anew, to where the next stay begins.
    inner = np.flatnonzero((toolpath.track >= 0) & (toolpath.motion != Motion.RAPID))
    number = toolpath.track[inner]
    breaks = np.flatnonzero((np.diff(inner) > 1) | (np.diff(number) != 0)) + 1
    first = inner[np.concatenate([[0], breaks])]
    last = inner[np.concatenate([breaks - 1, [len(inner) - 1]])]
    number = toolpath.track[first]
    opens = np.flatnonzero(np.concatenate([[True], number[1:] != number[:-1]]))
    stays = np.diff(np.append(opens, len(first)))
    closes = opens + stays - 1

    way, turned = station.tool.reversal
    if way == Reversal.SIDES and (stays % 2).any():
        way = Reversal.ONE
    period = station.tool.period
    columns = [0, 1, 3]
    entry, leave = toolpath.pose[first[opens]], toolpath.pose[last[closes] + 1]
    if way == Reversal.SIDES:
        far, near = toolpath.pose[first[opens + 1]], toolpath.pose[last[closes - 1] + 1]
    else:
        about = np.array([0.0, 0.0, 0.0, turned])
        far, near = leave + about, entry + about
    axes = (machine.x, machine.y, machine.c)
    order, flip = shortest(
        np.stack([entry, far])[..., columns],
        np.stack([leave, near])[..., columns],
        here[columns],
        np.array([[axis.velocity for axis in axes], [axis.acceleration for axis in axes]]),
        period,
        way,
    )
    # The stays in their new order: a track from its far end has them reversed, or swapped in pairs.
    owner = np.repeat(np.arange(len(order)), stays[order])
    place = np.arange(len(first)) - np.repeat(np.cumsum(stays[order]) - stays[order], stays[order])
    other = place ^ 1 if way == Reversal.SIDES else stays[order][owner] - 1 - place
    stay = opens[order][owner] + np.where(flip[owner], other, place)
    back = flip[owner] & (way == Reversal.EITHER)
    # Row 0 of each stay is the rapid to where it begins.
    size = last[stay] - first[stay] + 2
    run = np.repeat(np.arange(len(stay)), size)
    step = np.arange(len(run)) - np.repeat(np.cumsum(size) - size, size)
    head = step == 0
    reverse = back[run]
    ends = np.where(reverse, last[stay][run] + 1 - step, first[stay][run] + step)
    rows = np.where(reverse, ends, ends - 1)
    rows[head] = first[stay]
    motion = np.where(reverse, _BACKWARDS[toolpath.motion[rows]], toolpath.motion[rows])
    # Of a way back only the last plunge comes out of the board: others are steps on the way.
    up = reverse & (step == size[run] - 1) & (toolpath.motion[rows] == Motion.PLUNGE)
    motion = np.where(head, Motion.RAPID, np.where(up, Motion.LIFT, motion)).astype(np.uint8)
    pose = toolpath.pose[ends]
    pose[:, 3] += np.where(reverse, turned, 0.0)
    # In the air C may take any equivalent turn, so it is unwound at every rapid.
    begin = np.flatnonzero(head)
    shift = unwound(
        pose[begin, 3],
        pose[np.append(begin[1:], len(rows)) - 1, 3],
        np.minimum.reduceat(pose[:, 3], begin),
        np.maximum.reduceat(pose[:, 3], begin),
        float(here[3]),
        machine.c.low - station.c,
        machine.c.high - station.c,
        period,
    )
    pose[:, 3] += shift[run]
    link = head & (place == 0)[run]
    bulge = np.where(reverse, -toolpath.bulge[rows], toolpath.bulge[rows])
    return _Moves(
        pose=pose,
        bulge=np.where(head, 0.0, bulge),
        motion=motion,
        feed=np.where(head, 0.0, toolpath.feed[rows]),
        source=np.where(head, -1, toolpath.source[rows]).astype(np.int32),
        tool=np.full(len(rows), station.number, np.uint8),
        track=np.where(link, -1, count + owner[run]).astype(np.int32),
    )


def _least_lift(toolpath: Toolpath, machine: Machine, outline: Paths | None) -> Toolpath:
    """Return the toolpath with its turns lifted as far as they must be, and no further.

    A turn is a rapid between a lift and a plunge.  The board's face is the machine's clearance
    below where they meet it.  Outside the board only the mat is in the way.
    """
    rapid = np.flatnonzero(toolpath.motion[1:-1] == Motion.RAPID) + 1
    turns = rapid[
        (toolpath.motion[rapid - 1] == Motion.LIFT) & (toolpath.motion[rapid + 1] == Motion.PLUNGE)
    ]
    pose = toolpath.pose.copy()
    for station in machine.stations:
        own = turns[toolpath.tool[turns] == station.number]
        if len(own) == 0:
            continue
        face = float(pose[own, 2].min()) - machine.clearance
        circle = station.tool.tip_circle(0.0)
        for end in (own, own + 1):
            pose[end] = lifted(pose[end], interference(pose[end], circle, face), circle)
        if outline is None:
            continue
        low, high = toolpath.pose[own - 1], toolpath.pose[own + 2]
        depth = face - float(min(low[:, 2].min(), high[:, 2].min()))
        circle = station.tool.tip_circle(depth)
        clear = _unbroken(toolpath, own) & clear_ways(low, high, circle, outline)
        for end, stand in ((own[clear], low[clear]), (own[clear] + 1, high[clear])):
            over = np.minimum(pose[end, 2], machine.clearance)
            rise = np.where(stand[:, 2] < 0.0, over - stand[:, 2], 0.0)
            pose[end] = lifted(stand, rise, circle)
    # A lift that goes nowhere is none.
    still = np.zeros(len(toolpath), np.bool_)
    ends = np.concatenate([turns - 1, turns + 1])
    still[ends] = (pose[ends + 1] == pose[ends]).all(axis=1)
    kept = np.flatnonzero(~still)
    return Toolpath(
        pose=np.concatenate([pose[:1], pose[kept + 1]]),
        bulge=toolpath.bulge[kept],
        motion=toolpath.motion[kept],
        feed=toolpath.feed[kept],
        source=toolpath.source[kept],
        tool=toolpath.tool[kept],
        track=toolpath.track[kept],
    )


def _unbroken(toolpath: Toolpath, turns: I64) -> Bool:
    """Return which turns have their lift and their plunge with the same tool, C standing still."""
    c, tool = toolpath.pose[:, 3], toolpath.tool
    same: Bool = (tool[turns - 1] == tool[turns]) & (tool[turns + 1] == tool[turns])
    same &= (c[turns - 1] == c[turns]) & (c[turns + 1] == c[turns + 2])
    return same
