"""Check that programs set all outputs before they move, and switch them only at a safe height.

After a cancelled job a station may be lowered, its tool in the board and the spindle on.  The state
of every output and of the spindle is therefore unknown until a program line sets it.  Until then
the program may only lift the head straight up, to a height at which every station clears the board.
It may switch outputs, spindle and station only while the head is at the travel height of the
station that moved last.  At most one station may be lowered at a time.  While no station is
selected, no head may go below the height at which every station clears the board.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.verification.columns import I64, Bool
from knifetip.verification.findings import MAX_FINDINGS, Findings
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import (
    carriage_columns,
    expected_tool,
    extra_outputs,
    has_beam,
    travel_heights,
)

#: Half of the last printed digit of a height (mm).
PRINT_ROUNDING: Final = 5e-5


def check_switching(moves: Moves, machine: Machine, board: Board, findings: Findings) -> None:
    """Check when and at which height the program switches outputs and the spindle; add findings.

    The program must set all outputs and the spindle before the first move, switch them at a safe
    height, and never have two stations lowered at the same time.
    """
    _check_stated(moves, machine, findings)
    _check_unselected(moves, machine, findings)
    if len(moves.switches.line):
        _check_heights(moves, machine, board, findings)
        _check_lowered_alone(moves, machine, findings)


def _check_stated(moves: Moves, machine: Machine, findings: Findings) -> None:
    """Check that the program sets each output and the spindle before it moves the head; add
    findings.

    Before that, only a straight lift to the height is permitted at which every station clears the
    board.
    """
    heights = _z_heights(machine)
    highest = max(heights.values())
    things = {
        index: Message("verify.output", output=station.output)
        for index, station in enumerate(machine.stations)
        if station.output >= 0
    }
    spindle = moves.stated.shape[1] - 1
    for index, output in enumerate(extra_outputs(machine), len(machine.stations)):
        things[index] = Message("verify.output", output=output)
    things[spindle] = Message("verify.spindle")
    burns = has_beam(machine)
    for index, thing in things.items():
        early = np.flatnonzero(~moves.stated[:, index])
        # A beam that was left on also burns during a lift.
        if not (burns and index == spindle):
            early = early[~_is_lift(moves, early, heights)]
        if len(early):
            line = int(moves.line[early[0]])
            if burns and index == spindle:
                message = Message("verify.moves-with-beam")
            else:
                message = Message("verify.moves-before-stated", thing=thing, height=highest)
            findings.add_faults([(line, message)])
        elif not moves.switches.at_end[index]:
            findings.add("program", Message("verify.never-stated", thing=thing), 0.0)


def _check_unselected(moves: Moves, machine: Machine, findings: Findings) -> None:
    """Add a finding for each head that goes low while no station is selected.

    Any of its stations may be lowered then, and none is known to be at work.
    """
    free = moves.station < 0
    for column, needed in _z_heights(machine).items():
        start, end = moves.axes_start[:, column], moves.axes_end[:, column]
        # Moves from an unknown height have a finding of their own (``_check_stated``).
        low = free & (end < needed - PRINT_ROUNDING) & (end < start)
        for row in np.flatnonzero(low)[:MAX_FINDINGS]:
            message = Message("verify.low-without-station", height=end[row], needed=needed)
            findings.add("program", message, needed - end[row], line=moves.line[row])


def _z_heights(machine: Machine) -> dict[int, float]:
    """Return the position of each Z axis at which all its stations clear the board (mm).

    The keys are the columns of the Z axes in ``Machine.axes``.
    """
    letters = list(machine.axes)
    return {letters.index(letter): height for letter, height in travel_heights(machine).items()}


def _is_lift(moves: Moves, rows: I64, heights: dict[int, float]) -> Bool:
    """Return the mask of those of k moves that are rapids straight up to given heights, (k,).

    ``rows``: indices of the moves, (k,).
    ``heights`` mm: least position of each Z axis after the move.  The keys are the columns of the Z
    axes in ``Machine.axes``.
    """
    start, end = moves.axes_start[rows], moves.axes_end[rows]
    same = (start == end) | (np.isnan(start) & np.isnan(end))
    lift: Bool = np.delete(same, list(heights), 1).all(axis=1) & (moves.code[rows] == 0)
    for column, height in heights.items():
        lift &= end[:, column] >= height - PRINT_ROUNDING
    return lift


def _check_heights(moves: Moves, machine: Machine, board: Board, findings: Findings) -> None:
    """Check the height of the head at each program line that switches an output or the spindle.

    Adds one finding for the first of several lines that switch too low after the same move.  As
    long as no station is selected, any station may be lowered: every head must clear the board with
    each of its stations.
    """
    switches = moves.switches
    datum = np.array([station.z for station in machine.stations])
    own_z, rows = carriage_columns(machine)[:, 2], np.arange(len(switches.line))
    # Before the first move the height is unknown, and no station has moved.
    position = np.vstack([moves.axes_end, np.full((1, len(machine.axes)), np.nan)])[switches.move]
    station = np.append(moves.station, -1)[switches.move]
    height = np.where(station >= 0, position[rows, own_z[station]], np.inf)
    needed = np.where(station >= 0, machine.travel_z + datum[station], -np.inf)
    for column, highest in _z_heights(machine).items():
        open_ = (station < 0) & ~(position[:, column] >= highest - PRINT_ROUNDING)
        height = np.where(open_, position[:, column], height)
        needed = np.where(open_, highest, needed)
    # The station that is lowered may extend lower than the previous one.
    lowers = switches.lowers >= 0
    longer = datum[switches.lowers] + board.caliper + machine.clearance
    same = own_z[station] == own_z[switches.lowers]
    needed = np.where(lowers & same, np.maximum(needed, longer), needed)
    lowered = position[rows, own_z[switches.lowers]]
    other = lowers & ~same & ~(lowered >= longer - PRINT_ROUNDING)
    height, needed = np.where(other, lowered, height), np.where(other, longer, needed)
    low = ~(height >= needed - PRINT_ROUNDING)
    # A beam does not touch the board, so it may be switched at any height.
    beams = np.array(
        [expected_tool(mounted.tool).beam is not None for mounted in machine.stations] + [False]
    )
    unused = (station < 0) & beams.any()
    low &= ~(switches.spindle & (beams[station] | unused))
    first = low.copy()
    first[1:] &= ~(low[:-1] & (switches.move[1:] == switches.move[:-1]))
    for row in np.flatnonzero(first)[:MAX_FINDINGS]:
        if np.isnan(height[row]):
            message = Message("verify.switches-at-unknown-height", needed=needed[row])
        else:
            message = Message("verify.switches-low", height=height[row], needed=needed[row])
        findings.add_faults([(int(switches.line[row]), message)])


def _check_lowered_alone(moves: Moves, machine: Machine, findings: Findings) -> None:
    """Add a finding for each line of the program that lowers a station while another is lowered."""
    switches = moves.switches
    output = np.array([station.output for station in machine.stations])
    beside = switches.beside & (output != output[switches.lowers][:, None])
    is_single = ~beside.any(axis=1)
    for row in np.flatnonzero((switches.lowers >= 0) & ~is_single)[:MAX_FINDINGS]:
        other = machine.stations[int(np.argmax(beside[row]))]
        number = machine.stations[switches.lowers[row]].number
        line = int(switches.line[row])
        message = Message(
            "verify.lowers-second", station=number, other=other.number, output=other.output
        )
        findings.add_faults([(line, message)])
