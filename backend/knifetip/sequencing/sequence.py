"""sequence: join the toolpaths of all operations into one toolpath.

Toolpaths keep their order, which is the working order of the operations.  The tracks of each
toolpath (paths that the tool follows without lifting) are put into a short order, or into the one
that the user has chosen; a track that encloses others comes after these.  If the tool
permits it, a track may be run from its other end.  In air moves between tracks the head turns while
it travels, at the least height that clears the board.  If the next track needs another tool, the
head travels at the machine's travel height.  If the next tool is on another carriage of the gantry,
the carriage that was in use is parked first, so that at most one carriage is away from its parking
position.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import F64, I64, Bool, hand_over
from knifetip.geometry.path import Paths
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import Reversal
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.air_moves import interference, lift_clear, turns_outside_board, unwind
from knifetip.sequencing.chosen_order import (
    ChosenOrder,
    check_moves,
    check_stages,
    choose_ends,
    in_chosen_order,
)
from knifetip.sequencing.enclosed_tracks import split_enclosed
from knifetip.sequencing.free_blades import turn_free_blades
from knifetip.sequencing.head import Head, MoveColumns, join_moves
from knifetip.sequencing.keep_out import avoid_zones
from knifetip.sequencing.order import short_order
from knifetip.sequencing.passes import (
    PassOrder,
    columns_of,
    find_passes,
    heading_ranges,
    order_passes,
    rows_that_move,
    turn_passes,
)
from knifetip.sequencing.rest_time import rest_times
from knifetip.sequencing.travel import check_travel


def sequence(
    toolpaths: Sequence[Toolpath],
    machine: Machine,
    outline: Paths | None = None,
    safety: float = 0.0,
    chosen: ChosenOrder | None = None,
) -> Toolpath:
    """Return one toolpath that starts and ends at the parking position, at travel height.

    Parameters
    ----------
    toolpaths
        Toolpaths in working order.  Each of their tracks ends at the machine's clearance above the
        board.
    machine
        The machine that runs the toolpaths.
    outline : closed Paths, holes included
        Outline of the whole board that lies on the table (a blank is only a part of it).  With an
        outline, a tool that is off the board by the machine's clearance turns without a lift; with
        None, every turn is lifted.
    safety : mm
        Least distance between the lowest point of the tool and the board's top face in turns
        between two cuts of the same tool.  Where a lift to this height is faster, it replaces the
        lift to the machine's clearance; 0 for the clearance everywhere.
    chosen
        Order of tracks that the user has chosen; None for a short one.

    Raises
    ------
    PlanError
        The toolpaths contain no moves, the work touches a keep-out zone of the machine, or the
        chosen order breaks a rule of the order.
    TravelExceeded
        A move would leave the limits of an axis.
    """
    work = [
        replace(part, one_way=toolpath.one_way)
        for toolpath in toolpaths
        if len(toolpath)
        for part in split_enclosed(toolpath, machine.station(int(toolpath.tool[0])).tool)
    ]
    if not work:
        raise PlanError("job.no-work")
    if chosen is not None:
        check_stages(chosen, work)
    head = Head(machine.station(int(work[0].tool[0])), machine)
    home, parts, count, stages = head.pose, [], 0, []
    for toolpath in work:
        stages.append(count)
        station = machine.station(int(toolpath.tool[0]))
        parts += head.change_station(station)
        moves = _order_tracks(toolpath, station, machine, head.pose, count, chosen)
        parts += head.move_above(moves.pose[0])
        parts.append(moves)
        head.pose = moves.pose[-1]
        count = int(moves.track.max()) + 1
    parts += head.park()
    notes = tuple(note for toolpath in work for note in toolpath.notes)
    joined = join_moves(home, parts, notes)
    if chosen is not None:
        check_moves(chosen, joined.source)
    result = _lower_turns(turn_free_blades(joined, machine), machine, outline, safety)
    result = avoid_zones(result, machine)
    check_travel(result, machine)
    return replace(result, stages=tuple(stages))


def _order_tracks(
    toolpath: Toolpath,
    station: Station,
    machine: Machine,
    current: F64,
    count: int,
    chosen: ChosenOrder | None,
) -> MoveColumns:
    """Return the moves of a toolpath with its tracks in a short order, or in the chosen one, and an
    air move before each track.

    ``toolpath``, ``station``, ``machine``: toolpath of one operation, and the station and machine
    that run it.
    ``current`` (4,): pose of the head before the first track.
    ``count``: number that the first of the returned tracks gets; the tracks are numbered in their
    order.
    """
    # Old rapids are dropped; new ones lead to the start of each pass.
    columns = columns_of(toolpath)
    passes = find_passes(columns.motion, columns.track)
    first, last, opens = passes.first, passes.last, passes.opens[:-1]
    pass_count, closes = np.diff(passes.opens), passes.opens[1:] - 1

    reversal, rotation = station.tool.reversal
    if toolpath.one_way:
        reversal = Reversal.ONE
    if reversal == Reversal.SIDES and (pass_count % 2).any():
        reversal = Reversal.ONE
    period = station.tool.period
    plane = [0, 1, 3]
    entry, leave = toolpath.pose[first[opens]], toolpath.pose[last[closes] + 1]
    if reversal == Reversal.SIDES:
        far, near = toolpath.pose[first[opens + 1]], toolpath.pose[last[closes - 1] + 1]
    else:
        rotate = np.array([0.0, 0.0, 0.0, rotation])
        far, near = leave + rotate, entry + rotate
    x, y, _, c = machine.carriage_of(station).axes
    axes = (x, y, c)
    entries, leaves = np.stack([entry, far])[..., plane], np.stack([leave, near])[..., plane]
    pace = np.array([[axis.velocity for axis in axes], [axis.acceleration for axis in axes]])
    order, flip = short_order(entries, leaves, current[plane], pace, period, reversal)
    if chosen is not None:
        rank = np.minimum.reduceat(chosen.ranks(columns.source), first[opens])
        order = in_chosen_order(order, rank, len(chosen.rows))
        if reversal != Reversal.ONE:
            flip = choose_ends(order, entries, leaves, current[plane], pace, period)
    ordered = order_passes(
        columns,
        passes,
        PassOrder(order, flip, reversal == Reversal.SIDES, reversal == Reversal.EITHER),
        float(rotation),
    )
    # In the air C may take any equivalent angle, so it is unwound at every rapid.
    start, end, smallest, largest = heading_ranges(ordered.pose, ordered.begin)
    shift = unwind(
        start,
        end,
        smallest,
        largest,
        float(current[3]),
        c.low - station.c,
        c.high - station.c,
        period,
    )
    turn_passes(ordered.pose, ordered.begin, shift)
    track = ordered.track
    if count:
        track[track >= 0] += count
    return MoveColumns(
        pose=ordered.pose,
        bulge=ordered.bulge,
        motion=ordered.motion,
        feed=ordered.feed,
        source=ordered.source,
        tool=np.full(len(track), station.number, np.uint8),
        track=track,
    )


def _lower_turns(
    toolpath: Toolpath, machine: Machine, outline: Paths | None, safety: float
) -> Toolpath:
    """Return the toolpath with every turn at the least height that clears the board.

    A turn is a rapid between a lift and a plunge; in ``toolpath`` it is above the board's top face
    by the machine's clearance.  A turn that is entirely outside ``outline``, the outline of the
    board, by the machine's clearance is lowered further, because the tool only has to clear the mat
    under the board.  If ``outline`` is None, all turns clear the board.

    With a ``safety`` (mm), other turns are lowered until the lowest point of the tool is above the
    top face by ``safety``, where that takes less time.
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
            below = interference(pose[end], circle, face)
            # The machine's clearance is mostly enough.
            rows, below = end[below > 0.0], below[below > 0.0]
            pose[rows] = lift_clear(pose[rows], below, circle)
        if safety > 0.0 and not station.is_beam:
            lowered = own[_has_own_lift(toolpath, own)]
            lows = [
                lift_clear(cut, interference(cut, circle, face) + safety, circle)
                for cut in (toolpath.pose[lowered - 1], toolpath.pose[lowered + 2])
            ]
            before = _turn_times(toolpath, lowered, pose[lowered], pose[lowered + 1], machine)
            quick = _turn_times(toolpath, lowered, lows[0], lows[1], machine) < before
            for rows, low in zip((lowered, lowered + 1), lows, strict=True):
                pose[rows[quick]] = low[quick]
        if outline is None:
            continue
        low, high = toolpath.pose[own - 1], toolpath.pose[own + 2]
        depth = face - float(min(low[:, 2].min(), high[:, 2].min()))
        circle = station.tool.tip_circle(depth)
        # A tilted tool below the top face is beside its tip circle by up to depth · tan(tilt).
        beside = depth * math.tan(math.radians(circle.tilt))
        wide = replace(circle, radius=math.hypot(circle.radius, beside) + machine.clearance)
        clear = _has_own_lift(toolpath, own) & turns_outside_board(low, high, wide, outline)
        for end, untouched in ((own[clear], low[clear]), (own[clear] + 1, high[clear])):
            over = np.minimum(pose[end, 2], machine.clearance)
            rise = np.where(untouched[:, 2] < 0.0, over - untouched[:, 2], 0.0)
            pose[end] = lift_clear(untouched, rise, circle)
    # Drop lifts and plunges that do not move.
    rows = rows_that_move(pose, turns)
    if len(rows) == len(toolpath):
        return replace(toolpath, pose=hand_over(pose))
    return toolpath.with_moves(rows, np.concatenate([pose[:1], pose[rows + 1]]))


def _turn_times(toolpath: Toolpath, turns: I64, start: F64, end: F64, machine: Machine) -> F64:
    """Return the times of t turns of one station, each with its lift and its plunge, (t,) s.

    ``turns``: rows of the turns in the toolpath.
    ``start``, ``end`` (t, 4): poses at the start and the end of each rapid.
    """
    station = machine.station(int(toolpath.tool[turns[0]])) if len(turns) else machine.stations[0]
    axes, plunge = machine.carriage_of(station).axes, station.tool.plunge
    lifts = np.stack([toolpath.pose[turns - 1], start], axis=1)
    plunges = np.stack([end, toolpath.pose[turns + 2]], axis=1)
    times: F64 = rest_times(np.stack([start, end], axis=1), axes)[:, 0]
    return times + rest_times(lifts, axes, plunge)[:, 0] + rest_times(plunges, axes, plunge)[:, 0]


def _has_own_lift(toolpath: Toolpath, turns: I64) -> Bool:
    """Return the mask of the turns whose lift and plunge only raise and lower the tool, (t,).

    That is the case if the moves before and after the turn use the same tool as the turn, and do
    not change C.  Such a lift and plunge can be shortened without a change of any other move.
    ``turns`` are the rows of the t turns in the toolpath, (t,).
    """
    c, tool = toolpath.pose[:, 3], toolpath.tool
    same: Bool = (tool[turns - 1] == tool[turns]) & (tool[turns + 1] == tool[turns])
    same &= (c[turns - 1] == c[turns]) & (c[turns + 1] == c[turns + 2])
    return same
