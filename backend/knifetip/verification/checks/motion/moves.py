"""Check the feeds, outputs and travel of the moves, and compute the nominal machine time."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.verification.checks.motion.feed_kernels import (
    TURNS_AT_FEED,
    UNTIMED_CARRIAGE,
    WRONG_FEED,
    feed_faults,
    feed_figures,
)
from knifetip.verification.checks.motion.kernels import (
    feed_seconds,
    path_lengths,
    rapid_seconds,
    reached_positions,
    within_limits,
)
from knifetip.verification.checks.motion.move_columns import move_columns, tool_columns
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.findings import MAX_FINDINGS, Findings
from knifetip.verification.kinematics import TipPoses
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import expected_spindle, expected_tool, extra_outputs

#: Greatest excess over the travel of a joint; less than the last printed digit (mm, degrees).
TRAVEL_TOLERANCE: Final = 1e-6


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
    rotary = {letter for carriage in machine.carriages for letter in carriage.letters[3:]}
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
    its turn, whichever is longer; a short move may last as long as the controller needs to be given
    the next one.  The feed moves of a further carriage must be timed.
    """
    columns = move_columns(moves, tip)
    tools = tool_columns(machine, moves.resolution)
    faults = feed_faults(
        columns, tools, moves.uses_tool_table, moves.shortest / 60.0, moves.resolution
    )
    if not faults.any():
        return
    rows = np.flatnonzero(faults & WRONG_FEED)[:MAX_FINDINGS]
    for row, (minutes, least, own, _) in zip(rows, feed_figures(columns, tools, rows), strict=True):
        number = station_number(moves, machine, row)
        if moves.inverse[row]:
            message = Message(
                "verify.wrong-time",
                station=number,
                seconds=60.0 * minutes,
                planned=60.0 * least,
            )
            measure = minutes * 60.0
        else:
            message = Message(
                "verify.wrong-feed", station=number, feed=moves.feed[row], planned=own
            )
            measure = abs(moves.feed[row] - own)
        findings.add("feed", message, measure, line=moves.line[row])
    for row in np.flatnonzero(faults & TURNS_AT_FEED)[:MAX_FINDINGS]:
        degrees = abs(moves.end[row, 3] - moves.start[row, 3])
        message = Message("verify.turn-at-feed", degrees=degrees)
        findings.add("feed", message, degrees, line=moves.line[row])
    # LinuxCNC applies F to the travel along X, Y and Z alone if one of them moves.
    rows = np.flatnonzero(faults & UNTIMED_CARRIAGE)[:MAX_FINDINGS]
    for row, length in zip(rows, feed_figures(columns, tools, rows)[:, 3], strict=True):
        message = Message("verify.feed-of-other-axis", station=station_number(moves, machine, row))
        findings.add("feed", message, length, line=moves.line[row])


def station_number(moves: Moves, machine: Machine, row: int) -> int:
    """Return the number of the selected station of a move."""
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
        if expected_spindle(station).needed:
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
