"""Check that LinuxCNC's overlap of two moves does not displace or turn the tool in the board.

LinuxCNC starts a move before the move in front of it has ended.  G64 P limits the deviation that
this causes along X, Y and Z, but only as long as C turns alike in both moves.  If C turns by
another angle per millimetre in the second move, the tip follows a mixture of both moves while the
axes change their speeds, and leaves the path.  An exact stop (G4 P0) between the moves prevents it.

Source: measurements on LinuxCNC 2.9 (ADR 8).
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.verification.checks.motion.moves import move_lengths
from knifetip.verification.columns import F64
from knifetip.verification.findings import MAX_FINDINGS, Findings
from knifetip.verification.kinematics import TipPoses
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import ANGLE_TOLERANCE

#: A shorter move of the head is a turn in place (mm).
_STILL: Final = 1e-6


def check_overlaps(
    moves: Moves, tip: TipPoses, machine: Machine, tolerance: float, findings: Findings
) -> None:
    """Check each pair of moves that LinuxCNC overlaps, if one of them is in the board.

    Adds a finding for a turn in place that overlaps a move, and for two moves that overlap by so
    much that the tip leaves the path by more than ``tolerance`` (mm).

    Other controllers slow down wherever they cannot follow the path, and rapids are not overlapped
    with feed moves.
    """
    if not moves.uses_tool_table or len(moves.line) < 2:
        return
    is_feed = moves.code > 0
    pairs = is_feed[1:] & is_feed[:-1] & ~moves.rested[1:] & (tip.inside[1:] | tip.inside[:-1])
    length = move_lengths(moves)
    turn = moves.end[:, 3] - moves.start[:, 3]
    still = length < _STILL
    turns_in_place = still & (np.abs(turn) > ANGLE_TOLERANCE)
    mixed = pairs & (turns_in_place[1:] != turns_in_place[:-1]) & ~(still[1:] & still[:-1])
    for row in np.flatnonzero(mixed)[:MAX_FINDINGS]:
        degrees = abs(turn[row + 1] if turns_in_place[row + 1] else turn[row])
        message = Message("verify.turn-overlaps", degrees=degrees)
        findings.add("heading", message, degrees, line=moves.line[row + 1])
    distance = np.where(pairs & ~still[1:] & ~still[:-1], _deviation(moves, machine, length), 0.0)
    for row in np.flatnonzero(distance > tolerance)[:MAX_FINDINGS]:
        message = Message("verify.moves-overlap", distance=distance[row], tolerance=tolerance)
        findings.add("deviation", message, distance[row], line=moves.line[row + 1])


def _deviation(moves: Moves, machine: Machine, length: F64) -> F64:
    """Return by how much the overlap of each of the n moves with the next one displaces the tip,
    (n - 1,) mm.

    The overlap lasts until the slower of the axes has changed its speed: X and Y their full speed,
    C the difference of its speeds in the two moves.  In the overlap the head travels a distance s,
    over which the curvatures of the two moves, k and k', separate their paths by |k - k'| s² / 2.

    ``length`` are the lengths of the moves, (n,) mm.
    """
    carriages = [machine.carriage_of(station).axes for station in machine.stations]
    # Row -1, for moves without a station, is the last.
    carriages.append((machine.x, machine.y, machine.z, machine.c))
    thrust = np.array([min(x.acceleration, y.acceleration) for x, y, _, _ in carriages])
    twist = np.radians([c.acceleration for *_, c in carriages])
    fastest_turn = np.radians([c.velocity for *_, c in carriages])
    station = moves.station
    turn = np.radians(moves.end[:, 3] - moves.start[:, 3])
    seconds = np.where(moves.inverse, 60.0 / moves.feed, 60.0 * length / moves.feed)
    seconds = np.fmax(seconds, np.abs(turn) / fastest_turn[station])
    with np.errstate(divide="ignore", invalid="ignore"):
        curvature, speed = turn / length, length / seconds
        separation = np.abs(np.diff(curvature))
        faster = np.maximum(speed[1:], speed[:-1])
        slow_down = faster / thrust[station[1:]]
        turn_rate = separation * faster / twist[station[1:]]
        travelled = faster * np.maximum(slow_down, turn_rate)
        result: F64 = np.nan_to_num(separation * travelled**2 / 2.0, nan=0.0)
    return result
