"""rest_path: the toolpath that makes some tracks of an existing toolpath, in their order.

The tracks keep their moves.  The air moves inside a chain of neighbouring tracks of one station are
kept, too; new air moves at travel height lead to the first track of each chain, between the chains,
and back to the parking position.
"""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import F64, I64
from knifetip.model.machine import Machine, Station
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.air_moves import interference, lift_clear
from knifetip.sequencing.head import Head, MoveColumns, join_moves, single_move
from knifetip.sequencing.keep_out import avoid_zones
from knifetip.sequencing.tracks import track_rows
from knifetip.sequencing.travel import check_travel


def keep_tracks(toolpath: Toolpath, kept: I64, machine: Machine, face: float) -> Toolpath:
    """Return the toolpath that makes only some tracks of another one.

    It starts and ends at a parking position, at travel height, and its tracks are numbered anew.

    Parameters
    ----------
    toolpath
        A sequenced toolpath with t tracks, which are numbered in their order.
    kept : (k,)
        Numbers of the tracks, ascending, 0 … t - 1.
    machine
        The machine that runs the toolpath.
    face : mm
        Height of the board's top face.

    Raises
    ------
    PlanError
        No track is kept, or the work touches a keep-out zone of the machine.
    TravelExceeded
        A move would leave the limits of an axis.
    """
    if len(kept) == 0:
        raise PlanError("rest.no-tracks")
    first, last = track_rows(toolpath)
    tool = toolpath.tool[first[kept]]
    breaks = (np.diff(kept) != 1) | (np.diff(tool) != 0)
    chains = np.split(kept, np.flatnonzero(breaks) + 1)
    head = Head(machine.station(int(tool[0])), machine)
    home, parts = head.pose, []
    for chain in chains:
        begin, end = int(first[chain[0]]), int(last[chain[-1]])
        station = machine.station(int(toolpath.tool[begin]))
        parts += head.change_station(station)
        parts += head.rise()
        poses = toolpath.pose[[begin, end + 1]]
        entry, leave = _raise_poses(poses, station, face, machine.clearance)
        parts += head.move_above(entry)
        parts.append(single_move(entry, station, Motion.RAPID))
        parts += _chain_moves(toolpath, begin, end, station, (entry, leave))
        head.pose = leave
    parts += head.park()
    result = join_moves(home, parts, toolpath.notes)
    number = np.full(len(first), -1, np.int32)
    number[kept] = np.arange(len(kept))
    result = replace(result, track=np.where(result.track < 0, -1, number[result.track]))
    result = avoid_zones(result, machine)
    check_travel(result, machine)
    return result


def _chain_moves(
    toolpath: Toolpath, begin: int, end: int, station: Station, above: tuple[F64, F64]
) -> list[MoveColumns]:
    """Return the moves of a chain of tracks between two poses above its start and its end.

    Where the chain starts or ends lower, because ``toolpath`` has a low turn there, a plunge or a
    lift is added.

    ``begin``, ``end``: row of the first and of the last move of the chain.
    ``above``: poses of the head before and after the chain, (4,) each.
    """
    # A rapid switches a beam off; any other move would cut.
    down, up = (Motion.RAPID,) * 2 if station.is_beam else (Motion.PLUNGE, Motion.LIFT)
    parts = []
    if (above[0] != toolpath.pose[begin]).any():
        track = int(toolpath.track[begin])
        parts.append(single_move(toolpath.pose[begin], station, down, track=track))
    rows = slice(begin, end + 1)
    columns = {field.name: getattr(toolpath, field.name)[rows] for field in fields(MoveColumns)[1:]}
    parts.append(MoveColumns(pose=toolpath.pose[begin + 1 : end + 2], **columns))
    if (above[1] != toolpath.pose[end + 1]).any():
        track = int(toolpath.track[end])
        parts.append(single_move(above[1], station, up, track=track))
    return parts


def _raise_poses(pose: F64, station: Station, face: float, clearance: float) -> F64:
    """Return n poses, (n, 4), lifted along the tool's axis at least to the height at which plunges
    begin.

    A tilted tool is lifted further, until its lowest point is not below the board's top face.

    ``face`` mm: height of the board's top face.
    ``clearance`` mm: height of the tip above the face at which plunges begin.
    """
    circle = station.tool.tip_circle(0.0)
    lifted = lift_clear(pose, np.maximum(face + clearance - pose[:, 2], 0.0), circle)
    return lift_clear(lifted, interference(lifted, circle, face), circle)
