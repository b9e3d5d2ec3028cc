"""Switching: outputs and the spindle are stated before work, and switched where the head is clear.

Moves, Machine, Board -> findings

A job that was cancelled may have left a station lowered, its tool in the board and the spindle on.
So an output is unknown until a line switches it, and so is the spindle.  Until all of them are
stated a program may only lift straight up, to a height at which every station clears the board.
Outputs, spindle and station are switched only while the head is at the travel height of the
station that moved last, and at most one station is lowered at a time.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.verification.columns import F64, Bool
from knifetip.verification.findings import MAX_FINDINGS, Findings
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import expected_tool, extra_outputs, has_beam

#: A height may be less than asked by this, half of the last printed digit (mm).
PRINT_ROUNDING: Final = 5e-5


def check_switching(moves: Moves, machine: Machine, board: Board, found: Findings) -> None:
    """Note moves before everything is stated, and what is switched too low or beside another."""
    datum = np.array([station.z for station in machine.stations])
    # Any station may be lowered while none is stated: the joint must be high enough for each.
    highest = min(machine.travel_z + float(datum.max()), machine.z.high)
    _check_stated(moves, machine, highest, found)
    if len(moves.switches.line):
        _check_heights(moves, machine, board, highest, datum, found)
        _check_lowered_alone(moves, machine, found)


def _check_stated(moves: Moves, machine: Machine, highest: float, found: Findings) -> None:
    """Note the first move before each output and the spindle is stated, other than a lift."""
    lift = _is_upright(moves) & (moves.code == 0) & (moves.end[:, 2] >= highest - PRINT_ROUNDING)
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
        early = ~moves.stated[:, index]
        # A beam that was left on burns along a lift too.
        if not (burns and index == spindle):
            early &= ~lift
        if early.any():
            line = int(moves.line[np.argmax(early)])
            if burns and index == spindle:
                message = Message("verify.moves-with-beam")
            else:
                message = Message("verify.moves-before-stated", thing=thing, height=highest)
            found.program([(line, message)])
        elif not moves.switches.at_end[index]:
            found.add("program", Message("verify.never-stated", thing=thing), 0.0)


def _is_upright(moves: Moves) -> Bool:
    """Return which moves leave X, Y and C as they are, known or not."""
    start, end = moves.start[:, [0, 1, 3]], moves.end[:, [0, 1, 3]]
    same = (start == end) | (np.isnan(start) & np.isnan(end))
    result: Bool = same.all(axis=1)
    return result


def _check_heights(
    moves: Moves, machine: Machine, board: Board, highest: float, datum: F64, found: Findings
) -> None:
    """Note the first line after each move that switches something while the head is too low."""
    switches = moves.switches
    # Before the first move the height is unknown, and no station has moved.
    height = np.append(moves.end[:, 2], np.nan)[switches.move]
    station = np.append(moves.station, -1)[switches.move]
    needed = np.where(station >= 0, machine.travel_z + datum[station], highest)
    # The station that comes down may be longer than the one that has been lifted.
    longer = datum[switches.lowers] + board.caliper + machine.clearance
    needed = np.where(switches.lowers >= 0, np.maximum(needed, longer), needed)
    low = ~(height >= needed - PRINT_ROUNDING)
    # A beam works without touching: only where it is on is looked at, by its work.
    beams = np.array(
        [expected_tool(held.tool).beam is not None for held in machine.stations] + [False]
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
        found.program([(int(switches.line[row]), message)])


def _check_lowered_alone(moves: Moves, machine: Machine, found: Findings) -> None:
    """Note stations that are lowered while another one is, or may be."""
    switches = moves.switches
    output = np.array([station.output for station in machine.stations])
    beside = switches.beside & (output != output[switches.lowers][:, None])
    alone = ~beside.any(axis=1)
    for row in np.flatnonzero((switches.lowers >= 0) & ~alone)[:MAX_FINDINGS]:
        other = machine.stations[int(np.argmax(beside[row]))]
        number = machine.stations[switches.lowers[row]].number
        line = int(switches.line[row])
        message = Message(
            "verify.lowers-second", station=number, other=other.number, output=other.output
        )
        found.program([(line, message)])
