"""Check the feeds, outputs, travel and turns of the moves, and compute the nominal machine time."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.verification.checks.motion_kernels import (
    feed_seconds,
    path_lengths,
    rapid_seconds,
    reached_positions,
    unknown_positions,
    within_limits,
)
from knifetip.verification.checks.sheet_check import stays_beside_sheet
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.expectation.sheet_area import SheetArea
from knifetip.verification.findings import MAX_FINDINGS, Findings
from knifetip.verification.kinematics import LEVEL, TipPoses, beam_moves
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import ANGLE_TOLERANCE, expected_tool, extra_outputs

#: Greatest relative error of a feed: programs print six significant digits.
FEED_TOLERANCE: Final = 1e-5
#: Greatest error of a time: relative, and by rounded coordinates of the move (mm).
TIME_TOLERANCE: Final = 1e-4
LENGTH_TOLERANCE: Final = 5e-4
#: Shorter times are not checked, because controllers round them up (minutes).
MIN_MINUTES: Final = 2e-6
#: Greatest excess over the travel of a joint; less than the last printed digit (mm, degrees).
TRAVEL_TOLERANCE: Final = 1e-6
#: A line may replace an arc with a sagitta up to this: controllers reject smaller arcs (mm).
MAX_BOW: Final = 1e-3
#: Part of the turn clearance that may be missing because heights are rounded (mm).
HEIGHT_TOLERANCE: Final = 1e-3


def move_lengths(moves: Moves) -> F64:
    """Return the length of each move along X, Y and Z, (n,) mm; NaN if a position is unknown."""
    result: F64 = path_lengths(moves.start, moves.end, moves.centre, moves.sweep)
    return result


def check_travel(moves: Moves, machine: Machine, findings: Findings) -> Bool:
    """Return the mask of the n moves that stay within the limits of the machine's axes, shape (n,).

    Adds a finding for each move that leaves these limits or continues outside them.
    """
    limits = np.array([[axis.low, axis.high] for axis in machine.axes.values()])
    good: Bool = within_limits(
        moves.axes_start, moves.axes_end, moves.centre, moves.sweep, limits, TRAVEL_TOLERANCE
    )
    outside = np.flatnonzero(~good)
    if len(outside):
        _report_travel(moves, outside, machine, findings)
    return good


def _report_travel(moves: Moves, rows: I64, machine: Machine, findings: Findings) -> None:
    """Add a finding for each of some moves that leaves the limits of an axis.

    A move that starts or stays outside the limits gets none.  ``rows`` are the indices of the
    moves, ascending.
    """
    rotary = {carriage.letters[3] for carriage in machine.carriages}
    axes_start, axes_end = moves.axes_start[rows], moves.axes_end[rows]
    sweep = moves.sweep[rows]
    low, high = reached_positions(axes_start, axes_end, moves.centre[rows], sweep)
    for column, (name, axis) in enumerate(machine.axes.items()):
        below = np.nan_to_num(axis.low - low[:, column])
        above = np.nan_to_num(high[:, column] - axis.high)
        past = np.maximum(below, above)
        goes = (sweep != 0.0) | (axes_start[:, column] != axes_end[:, column])
        for row in np.flatnonzero((past > TRAVEL_TOLERANCE) & goes)[:MAX_FINDINGS]:
            reached = low[row, column] if below[row] > above[row] else high[row, column]
            message = Message(
                "verify.beyond-rotation" if name in rotary else "verify.beyond-travel",
                joint=name,
                position=reached,
                low=axis.low,
                high=axis.high,
            )
            findings.add("travel", message, past[row], line=moves.line[rows[row]])


def axis_ranges(moves: Moves) -> tuple[F64, F64]:
    """Return the least and the greatest position of each axis after the start of each move, (n,
    axes) each; NaN if it is unknown.

    On a line they are the position at its end.  On an arc, X and Y (the first two columns) also
    reach the extremes of the arc.
    """
    low, high = reached_positions(moves.axes_start, moves.axes_end, moves.centre, moves.sweep)
    return low, high


def check_feeds(moves: Moves, tip: TipPoses, machine: Machine, findings: Findings) -> None:
    """Check the feed of each move; add findings.

    A move at constant height must have the tool's feed, and a move that changes the height must
    have the tool's plunge feed.  A turn of C alone may run at the greatest speed of C.  The
    duration of a timed move (G93) must be the time of its travel at the tool's feed or the time of
    its turn, whichever is longer.  The feed moves of a further carriage must be timed.
    """
    own = np.full(len(moves.line), np.nan)
    level = np.abs(moves.end[:, 2] - moves.start[:, 2]) <= LEVEL
    for index, station in enumerate(machine.stations):
        rows = moves.station == index
        own[rows] = np.where(level[rows], station.tool.feed, station.tool.plunge)
    length = move_lengths(moves)
    degrees = np.abs(moves.end[:, 3] - moves.start[:, 3])
    # If the tip rests while C turns, the move is a swivel, even if the head moves round the tip.
    swivel = level & (degrees > 0.0)
    turning = np.flatnonzero(swivel)
    swivel[turning] = _resting_tips(moves, tip, machine, turning)
    carriages = [machine.carriages[station.carriage - 1] for station in machine.stations]
    turning = np.array([*(one.axes[3].velocity for one in carriages), machine.c.velocity])
    turn_minutes = degrees / (60.0 * turning[moves.station])
    least = np.maximum(np.where(swivel, 0.0, length / own), turn_minutes)
    minutes = np.where(moves.inverse, 1.0 / moves.feed, length / moves.feed)
    feeding = (moves.code > 0) & ~np.isnan(own) & ~np.isnan(length) & ~np.isnan(moves.feed)
    is_wrong = np.abs(minutes - least) > TIME_TOLERANCE * least + np.where(
        swivel, 0.0, LENGTH_TOLERANCE / own
    )
    is_wrong &= ~((minutes <= MIN_MINUTES) & (minutes > least))
    # A move that is not timed has the feed of its F word.
    plain = ~moves.inverse
    is_wrong = np.where(plain, np.abs(moves.feed - own) > FEED_TOLERANCE * own, is_wrong)
    for row in np.flatnonzero(feeding & is_wrong)[:MAX_FINDINGS]:
        number = _number(moves, machine, row)
        if moves.inverse[row]:
            message = Message(
                "verify.wrong-time",
                station=number,
                seconds=60.0 * minutes[row],
                planned=60.0 * least[row],
            )
        else:
            message = Message(
                "verify.wrong-feed", station=number, feed=moves.feed[row], planned=own[row]
            )
        measure = abs(moves.feed[row] - own[row]) if plain[row] else minutes[row] * 60.0
        findings.add("feed", message, measure, line=moves.line[row])
    mixed = feeding & plain & (degrees > 0.0) & ((moves.sweep == 0.0) | (not moves.uses_tool_table))
    for row in np.flatnonzero(mixed)[:MAX_FINDINGS]:
        message = Message("verify.turn-at-feed", degrees=degrees[row])
        findings.add("feed", message, degrees[row], line=moves.line[row])
    # LinuxCNC applies F to the travel along X, Y and Z alone if one of them moves.
    further = np.array([*(not one.is_first for one in carriages), False])[moves.station]
    for row in np.flatnonzero(feeding & plain & further & (length > 0.0))[:MAX_FINDINGS]:
        message = Message("verify.feed-of-other-axis", station=_number(moves, machine, row))
        findings.add("feed", message, length[row], line=moves.line[row])


def _resting_tips(moves: Moves, tip: TipPoses, machine: Machine, rows: I64) -> Bool:
    """Return the mask of those of k moves during which the tip does not move along X and Y, (k,).

    The head of a drag knife may move round its resting tip in such a move.  ``rows`` are the
    indices of the moves, (k,).
    """
    circles = np.array([expected_tool(station.tool).circles_tip for station in machine.stations])
    distance = np.hypot(*(tip.end[rows, :2] - tip.start[rows, :2]).T)
    result: Bool = (distance < 1e-3) & ((moves.sweep[rows] == 0.0) | circles[moves.station[rows]])
    return result


def _number(moves: Moves, machine: Machine, row: int) -> int:
    return int(machine.stations[moves.station[row]].number)


def check_outputs(moves: Moves, tip: TipPoses, machine: Machine, findings: Findings) -> None:
    """Check the states of the outputs during each move in which a tool is in the board; add
    findings.

    The station of the tool must be lowered and all other stations raised.  The outputs that the
    tool needs must be on, and the spindle must be on if and only if the tool needs it.
    """
    wrong: list[tuple[Bool, Message]] = []
    extra = extra_outputs(machine)
    for index, station in enumerate(machine.stations):
        inside = tip.inside & (moves.station == index)
        if station.output >= 0:
            wrong.append(
                (
                    inside & ~moves.lowered[:, index],
                    Message("verify.output-off", station=station.number, output=station.output),
                )
            )
        for other, rival in enumerate(machine.stations):
            if other != index and rival.output >= 0:
                wrong.append(
                    (
                        inside & moves.lowered[:, other],
                        Message(
                            "verify.two-lowered",
                            station=station.number,
                            other=rival.number,
                            output=rival.output,
                        ),
                    )
                )
        tool = expected_tool(station.tool)
        for output in tool.outputs:
            is_on = moves.extra[:, extra.index(output)]
            message_off = Message("verify.output-off", station=station.number, output=output)
            wrong.append((inside & ~is_on, message_off))
        if tool.needs_spindle:
            wrong.append((inside & ~moves.oscillating, Message(tool.stopped_code)))
        else:
            running = Message("verify.oscillation-on", station=station.number)
            wrong.append((inside & moves.oscillating, running))
    unchosen = (moves.station < 0) & (moves.code > 0)
    wrong.append((unchosen, Message("verify.no-station")))
    for rows, message in wrong:
        # A state that lasts is one finding, where it begins.
        begins = rows & ~np.concatenate([[False], rows[:-1]])
        for row in np.flatnonzero(begins)[:MAX_FINDINGS]:
            findings.add("program", message, 0.0, line=moves.line[row])


def check_board_moves(
    moves: Moves,
    tip: TipPoses,
    machine: Machine,
    board: Board,
    tolerance: float,
    sheet: SheetArea | None,
    findings: Findings,
) -> None:
    """Check the moves of a tool in the board, and the height of rapids above it.

    Adds a finding for each rapid in the board or nearer to it than the turn clearance of the
    machine, each plunge or lift that is slanted, and each turn
    of C in the board that is too large.  A feed move from or to an unknown position gives a finding
    too.

    Parameters
    ----------
    tolerance : mm
        Greatest sideways deviation of the tip in a plunge or lift.
    sheet
        The sheet if it was cut to size; None if there may be board everywhere on the table.
    """
    lowest = np.fmin(tip.start[:, 2], tip.end[:, 2])
    beam = beam_moves(moves, machine)
    _check_beam(moves, tip, beam, findings)
    unknown, sideways = unknown_positions(moves.start, moves.end)
    rapid = ~beam & (moves.code == 0)
    goes = np.zeros(len(moves.line), np.bool_)
    for axis in (0, 1, 3):
        goes |= moves.end[:, axis] != moves.start[:, axis]
    needed = board.caliper + machine.turn_clearance
    low = rapid & goes & (moves.station >= 0) & (lowest < needed - HEIGHT_TOLERANCE)
    if sheet is not None:
        known = np.flatnonzero(rapid & (tip.inside | low) & ~unknown)
        beside = known[stays_beside_sheet(moves, known, machine, board, sheet)]
        rapid[beside] = False
    for row in np.flatnonzero(rapid & low & ~tip.inside)[:MAX_FINDINGS]:
        message = Message(
            "verify.rapid-too-low",
            station=_number(moves, machine, row),
            height=lowest[row] - board.caliper,
            needed=machine.turn_clearance,
        )
        findings.add("stray", message, needed - lowest[row], line=moves.line[row])
    for row in np.flatnonzero(rapid & tip.inside)[:MAX_FINDINGS]:
        depth = board.caliper - lowest[row]
        number = _number(moves, machine, row)
        code = "verify.rapid-in-board" if sheet is None else "verify.rapid-near-sheet"
        findings.add(
            "stray", Message(code, station=number, depth=depth), depth, line=moves.line[row]
        )
    for row in np.flatnonzero((unknown & (moves.code > 0)) | sideways)[:MAX_FINDINGS]:
        findings.add("program", Message("verify.unknown-position"), 0.0, line=moves.line[row])

    stay = tip.inside & (moves.code > 0) & ~unknown
    drop = tip.end[:, 2] - tip.start[:, 2]
    slanted = stay & ~beam & (np.abs(drop) > LEVEL)
    rows = np.flatnonzero(slanted)
    drop, begin, end = drop[rows], tip.start[rows], tip.end[rows]
    top = np.minimum(np.maximum(begin[:, 2], end[:, 2]), board.caliper)
    fraction = (top - lowest[rows]) / np.abs(drop)
    slope = np.array([expected_tool(station.tool).slope for station in machine.stations])
    aside = drop * slope[moves.station[rows]]
    heading = np.radians(end[:, 3])
    astray = fraction * np.hypot(
        end[:, 0] - begin[:, 0] - np.sin(heading) * aside,
        end[:, 1] - begin[:, 1] + np.cos(heading) * aside,
    )
    wrong = (astray > tolerance) | (moves.sweep[rows] != 0.0)
    for k in np.flatnonzero(wrong)[:MAX_FINDINGS]:
        number = _number(moves, machine, rows[k])
        message = Message("verify.slanted", station=number, distance=astray[k])
        findings.add("deviation", message, astray[k], line=moves.line[rows[k]])
    _check_turns(moves, tip, machine, stay, slanted, findings)


def _check_beam(moves: Moves, tip: TipPoses, beam: Bool, findings: Findings) -> None:
    """Check that a laser beam is off in rapids, and that the head keeps its height while the beam
    is on.

    Adds findings.  ``beam`` is the mask of the n moves whose station carries a laser, (n,).
    """
    beam_on = beam & tip.inside
    for row in np.flatnonzero(beam_on & (moves.code == 0))[:MAX_FINDINGS]:
        distance = float(np.hypot(*(tip.end[row, :2] - tip.start[row, :2])))
        message = Message("verify.beam-on-rapid", length=distance)
        findings.add("stray", message, distance, line=moves.line[row])
    drop = np.abs(tip.end[:, 2] - tip.start[:, 2])
    for row in np.flatnonzero(beam_on & (moves.code > 0) & (drop > LEVEL))[:MAX_FINDINGS]:
        message = Message("verify.beam-refocused", height=drop[row])
        findings.add("depth", message, drop[row], line=moves.line[row])


def _check_turns(
    moves: Moves, tip: TipPoses, machine: Machine, in_board: Bool, slanted: Bool, findings: Findings
) -> None:
    """Check that C turns by the same angle as the direction of travel in the board; add findings.

    On a line or an arc, C and the direction of travel turn at constant rates, so comparing their
    angles covers the entire move.  A comparison of the headings at the ends of the move would miss
    full turns.  A tool that turns in place, or while it plunges or lifts, has no direction of
    travel; only the size of its turn is limited.

    Parameters
    ----------
    in_board, slanted : (n,)
        Mask of the feed moves in the board, and mask of those feed moves that also change the
        height.
    """
    tools = [expected_tool(station.tool) for station in machine.stations]
    widest = np.array([tool.swivel for tool in tools])
    max_turn = np.array([tool.max_turn for tool in tools])
    follows = np.array([tool.follows_path for tool in tools])
    rows = np.flatnonzero(in_board)
    begin, end = tip.start[rows], tip.end[rows]
    station, sweep, steep = moves.station[rows], moves.sweep[rows], slanted[rows]
    turn = end[:, 3] - begin[:, 3]
    in_place = steep | _resting_tips(moves, tip, machine, rows)
    path = np.where(follows[station] & ~in_place, np.degrees(sweep), 0.0)
    error = np.abs(turn - path)
    limit = np.where(steep, ANGLE_TOLERANCE, widest[station])
    length = np.hypot(end[:, 0] - begin[:, 0], end[:, 1] - begin[:, 1])
    straight = ~in_place & (sweep == 0.0) & (length > 0.0)
    # The angle of an arc over this chord with a sagitta of MAX_BOW.
    limit[straight] += np.degrees(8.0 * MAX_BOW / length[straight])
    limit = np.minimum(limit, max_turn[station] + ANGLE_TOLERANCE)
    for k in np.flatnonzero(error > limit)[:MAX_FINDINGS]:
        if in_place[k]:
            message = Message("verify.turn-in-board", degrees=error[k], most=limit[k])
        else:
            message = Message("verify.turn-off-path", degrees=turn[k], path=path[k])
        findings.add("heading", message, error[k], line=moves.line[rows[k]])


def nominal_seconds(moves: Moves, machine: Machine) -> float:
    """Return the nominal duration of a program (s), without acceleration.

    It is the sum of the durations of feed moves (length / feed), of rapids at the axes' greatest
    velocities, and of dwells.
    """
    velocity = np.array([axis.velocity for axis in machine.axes.values()])
    rapids = rapid_seconds(moves.axes_start, moves.axes_end, moves.code == 0, velocity)
    feeds = feed_seconds(
        moves.start, moves.end, moves.centre, moves.sweep, moves.code > 0, moves.inverse, moves.feed
    )
    return float(rapids + feeds + moves.dwell)
