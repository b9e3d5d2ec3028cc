"""trailing_blade: integrate the heading of a free blade from the path of its axis alone.

The tip is dragged at the distance e behind the axis, and a blade does not slip sideways: the tip
moves towards the axis or away from it.  With φ the angle from the direction in which the axis
travels to the direction from the tip to the axis, a line of length s changes φ by::

    dφ/ds = -sin φ / e        tan(φ/2) = tan(φ₀/2) exp(-s / e)

which is the tractrix.  Arcs of the axis are followed in chords.  An axis that moves on a circle of
radius e about the tip turns the blade and leaves the tip where it is.  In the air the blade keeps
its heading.  The program alone determines the result: nothing of the drawing or of the planned
headings is used.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import F64_1, F64_2, I32_1, OutF64_2, OutI64_1, inline_kernel, kernel
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.model.tool import Knife, Tool
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.findings import MAX_FINDINGS, Findings
from knifetip.verification.reading.moves import Moves

#: Greatest distance of the followed path from its chords (mm).
CHORD: Final = 1e-4
#: Greatest turn of the axis along one chord of an arc (radians).
_STEP: Final = 0.01
#: A blade turns in place on an arc of its axis whose centre is at most so far from its tip (mm).  A
#: tight bend of the tip has its centre at a distance of its radius.
_STILL_CENTRE: Final = 0.005
#: It turns in place on a line, such as a chord of such an arc, if its tip moves by less than this
#: share of the travel of its axis, and by less than this distance (mm).
_STILL_SHARE: Final = 0.2
_STILL: Final = 0.03
#: Greatest distance of the tip from where it was before, in consecutive moves that turn the blade
#: (mm).  A program in coarse units follows a tight bend in such moves.
_STILL_RUN: Final = 0.05
#: Greatest length by which a tip may be pushed in a move, besides rounding (mm).
MAX_PUSH: Final = 0.05
#: Greatest difference between the last heading of a program and the park heading (degrees).
PARK_TOLERANCE: Final = 2.0


@dataclass(frozen=True, eq=False, slots=True)
class TrailingBlade:
    """The headings of free blades in n moves, and k chords that their tips follow in them."""

    free: Bool  #: (n,) the selected tool is a free blade
    still: Bool  #: (n,) the blade turns in place
    pushed: F64  #: (n,) mm by which the tip moves away from its axis
    start: F64  #: (n,) heading at the start of each move, degrees
    end: F64  #: (n,) heading at its end
    move: I64  #: (k,) move of each chord, ascending
    tip: F64  #: (k, 4) x, y of the tip at the start and at the end of each chord, mm
    heading: F64  #: (k, 2) degrees, at the start and at the end of each chord

    def chords_of(self, moves: I64) -> tuple[I64, I64]:
        """Return the indices of the chords of m moves, and the index into ``moves`` of each."""
        first = np.searchsorted(self.move, moves)
        count = np.searchsorted(self.move, moves, side="right") - first
        owner = np.repeat(np.arange(len(moves)), count)
        ordinal = np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)
        return (first[owner] + ordinal).astype(np.int64), owner


def follow_blades(moves: Moves, machine: Machine, board: Board) -> TrailingBlade | None:
    """Return the headings that free blades have in a program; None without free blades.

    Before its first move in the board, a blade has the park heading of its tool.
    """
    blades = [_free_blade(station.tool) for station in machine.stations]
    trail = np.array([*(one.trail if one else 0.0 for one in blades), 0.0])
    free = (trail > 0.0)[moves.station]
    if not free.any():
        return None
    park = np.array([*(one.park_heading if one else 0.0 for one in blades), 0.0])
    datum = np.array([*((one.x, one.y, one.z) for one in machine.stations), (0.0, 0.0, 0.0)])
    offset = datum[moves.station]
    begin, finish = moves.start[:, :3] - offset, moves.end[:, :3] - offset
    centre = moves.centre - offset[:, :2]
    axis = _AxisMoves(begin, finish, centre, moves.sweep, moves.station)
    columns = (axis, trail, park, board.caliper)
    count, _, _, _ = _follow(*columns, np.zeros((0, 6)), np.zeros(0, np.int64))
    chords, owner = np.empty((count, 6)), np.empty(count, np.int64)
    _, headings, still, pushed = _follow(*columns, chords, owner)
    travels = (np.hypot(*(finish - begin)[:, :2].T) > 0.0) & ~still
    # The centre of an arc shows whether the blade turns in place.
    travels |= moves.sweep != 0.0
    still &= ~_passes_without_travel(begin, finish, free, travels, board.caliper)
    start, end = np.degrees(headings).T
    return TrailingBlade(
        free, still, pushed, start, end, owner, chords[:, :4], np.degrees(chords[:, 4:])
    )


def _passes_without_travel(
    begin: F64, finish: F64, free: Bool, travels: Bool, caliper: float
) -> Bool:
    """Return the mask of the moves of passes in which a free blade only turns in place, (n,).

    A blade is not lowered in order to turn only: such a pass is a contour that is hardly larger
    than the unit of the coordinates.  A pass is a chain of moves between two lifts.

    ``begin``, ``finish`` (n, 3) mm: position of the axis, and height of the tip, at the start and
    the end of each move.
    ``free``, ``travels`` (n,): whether the selected tool is a free blade, and whether the move is
    not one that hardly moves its tip.
    ``caliper`` mm: thickness of the board.
    """
    lowered = free & (np.fmin(begin[:, 2], finish[:, 2]) < caliper)
    number = np.cumsum(~(lowered & (begin[:, 2] < caliper)))
    result: Bool = lowered & (np.bincount(number, lowered & travels)[number] == 0.0)
    return result


def _free_blade(tool: Tool) -> Knife | None:
    """Return the tool if it is a free blade, else None."""
    return tool if isinstance(tool, Knife) and tool.free else None


@dataclass(frozen=True, eq=False, slots=True)
class Swivels:
    """The k places at which free blades turn about their tips in the board."""

    tip: F64  #: (k, 2) mm
    z: F64  #: (k,) height of the tip above the table (mm)
    turn: F64  #: (k,) degrees
    drift: F64  #: (k,) mm by which the tip moves meanwhile
    line: I32  #: (k,) 1-based line of the program

    @classmethod
    def none(cls) -> Swivels:
        """Return the record of a program without free blades."""
        nothing = np.zeros(0)
        return cls(np.zeros((0, 2)), nothing, nothing, nothing, np.zeros(0, np.int32))


def find_swivels(blade: TrailingBlade, start: F64, end: F64, line: I32) -> Swivels:
    """Return the swivels in n moves; consecutive moves that only turn the blade are one.

    Parameters
    ----------
    start, end : (n, 4)
        Poses of the tip at the start and the end of each move: x, y, z in mm, degrees.
    line : (n,)
        1-based line of the program of each move.
    """
    edges = np.diff(blade.still.astype(np.int8), prepend=0, append=0)
    first, last = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1) - 1
    return Swivels(
        start[first, :2],
        end[last, 2],
        np.abs(blade.end[last] - blade.start[first]),
        np.hypot(*(end[last, :2] - start[first, :2]).T),
        line[first],
    )


def with_headings(moves: Moves, blade: TrailingBlade, machine: Machine) -> Moves:
    """Return the moves of a program with the headings of its free blades instead of C."""
    mounting = np.array([*(station.c for station in machine.stations), 0.0])[moves.station]
    start, end = moves.start.copy(), moves.end.copy()
    start[blade.free, 3] = (blade.start + mounting)[blade.free]
    end[blade.free, 3] = (blade.end + mounting)[blade.free]
    return replace(moves, start=start, end=end)


def check_pushes(moves: Moves, blade: TrailingBlade, findings: Findings) -> None:
    """Add a finding for each move that pushes the tip of a free blade away from its axis.

    Such a blade tears the board, or turns round to either side.
    """
    rows = np.flatnonzero(blade.pushed > MAX_PUSH + moves.resolution)
    for row in rows[:MAX_FINDINGS]:
        message = Message("verify.blade-pushed", length=float(blade.pushed[row]))
        findings.add("heading", message, float(blade.pushed[row]), line=int(moves.line[row]))


def check_park_headings(
    moves: Moves, blade: TrailingBlade, machine: Machine, findings: Findings
) -> None:
    """Add a finding for each free blade whose heading at the end of the program is not its park
    heading.

    The rounding of coordinates, by ``moves.resolution``, turns the blade, too.
    """
    for index, station in enumerate(machine.stations):
        rows = np.flatnonzero(blade.free & (moves.station == index))
        tool = _free_blade(station.tool)
        if len(rows) == 0 or tool is None:
            continue
        last, park = int(rows[-1]), tool.park_heading
        error = abs((float(blade.end[last]) - park + 180.0) % 360.0 - 180.0)
        if error > PARK_TOLERANCE + math.degrees(moves.resolution / tool.trail):
            message = Message(
                "verify.blade-not-parked",
                station=station.number,
                heading=float(blade.end[last]) % 360.0,
                park=park,
            )
            findings.add("heading", message, error, line=int(moves.line[last]))


@inline_kernel
def _dragged_heading(heading: float, direction: float, length: float, trail: float) -> float:
    """Return the heading of a blade after its axis has moved along a line (radians)."""
    angle = heading - direction
    turn = math.floor((angle + math.pi) / math.tau) * math.tau
    angle -= turn
    if abs(angle) > math.pi - 1e-12:
        return heading
    left: float = 2.0 * math.atan(math.tan(0.5 * angle) * math.exp(-length / trail))
    return direction + turn + left


class _AxisMoves(NamedTuple):
    """n moves of the axis about which a blade turns."""

    begin: F64_2  #: (n, 3) mm, position of the axis, and height of the tip, at the start
    finish: F64_2  #: (n, 3) mm, the same at the end
    centre: F64_2  #: (n, 2) mm, centre of an arc
    sweep: F64_1  #: (n,) radians, sweep of an arc; 0 for a line
    station: I32_1  #: (n,) index of the selected station, -1 for none


@kernel
def _follow(
    moves: _AxisMoves,
    trail: F64_1,
    park: F64_1,
    caliper: float,
    chords: OutF64_2,
    owner: OutI64_1,
) -> Any:
    """Return the number of chords, and for each of n moves the headings, (n, 2) radians, whether
    the blade turns in place, (n,), and by how much its tip is pushed, (n,) mm.

    ``trail``, ``park`` (s + 1,): distance of the tip behind the axis (mm; 0: no free blade) and
    heading at the start of the program (degrees), for each station and for none.
    ``caliper`` mm: thickness of the board.
    ``chords``, ``owner`` (k, 6), (k,): get the chords of the tip (x, y at both ends, headings at
    both ends) and their moves.  With k = 0, they are only counted.
    """
    begin, finish, centre, sweep, station = moves
    headings = np.empty((len(station), 2))
    still = np.zeros(len(station), np.bool_)
    pushed = np.zeros(len(station))
    state = np.radians(park)
    # The first and last of consecutive moves in which the tip hardly moves, and its place before.
    run, last, run_x, run_y, is_still = 0, -2, 0.0, 0.0, True
    count = 0
    writes = len(owner) > 0
    for row in range(len(station)):
        own = station[row]
        e, heading = trail[own], state[own]
        headings[row, 0] = headings[row, 1] = heading
        below = min(begin[row, 2], finish[row, 2]) < caliper - 1e-6
        if e <= 0.0 or not below:
            continue
        x, y = begin[row, 0], begin[row, 1]
        radius, turned = 0.0, sweep[row]
        if turned != 0.0:
            radius = math.hypot(x - centre[row, 0], y - centre[row, 1])
            length = radius * abs(turned)
        else:
            length = math.hypot(finish[row, 0] - x, finish[row, 1] - y)
        if not length > 1e-9:  # also where a position is unknown
            continue
        steps = 1
        if turned != 0.0:
            by_chord = math.sqrt(8.0 * CHORD / radius)
            steps = math.ceil(abs(turned) / min(by_chord, _STEP))
        tip_x, tip_y = x - e * math.cos(heading), y - e * math.sin(heading)
        first_x, first_y = tip_x, tip_y
        angle = math.atan2(y - centre[row, 1], x - centre[row, 0]) if turned != 0.0 else 0.0
        for step in range(steps):
            share = (step + 1) / steps
            if turned != 0.0 and step < steps - 1:
                to_x = centre[row, 0] + radius * math.cos(angle + turned * share)
                to_y = centre[row, 1] + radius * math.sin(angle + turned * share)
            else:
                to_x, to_y = finish[row, 0], finish[row, 1]
            left = math.hypot(to_x - x, to_y - y)
            direction = math.atan2(to_y - y, to_x - x)
            while left > 1e-12:
                bend = abs(math.sin(heading - direction))
                piece = left
                if bend * e > 1e-7:
                    piece = min(left, math.sqrt(8.0 * CHORD * e / bend))
                x += piece * math.cos(direction)
                y += piece * math.sin(direction)
                left -= piece
                after = _dragged_heading(heading, direction, piece, e)
                to_tip_x, to_tip_y = x - e * math.cos(after), y - e * math.sin(after)
                if writes:
                    chords[count, 0], chords[count, 1] = tip_x, tip_y
                    chords[count, 2], chords[count, 3] = to_tip_x, to_tip_y
                    chords[count, 4], chords[count, 5] = heading, after
                    owner[count] = row
                count += 1
                middle = 0.5 * (heading + after)
                along = (to_tip_x - tip_x) * math.cos(middle) + (to_tip_y - tip_y) * math.sin(
                    middle
                )
                pushed[row] += max(-along, 0.0)
                tip_x, tip_y, heading = to_tip_x, to_tip_y, after
        state[own] = headings[row, 1] = heading
        moved = math.hypot(tip_x - first_x, tip_y - first_y)
        if turned != 0.0:
            rests = math.hypot(first_x - centre[row, 0], first_y - centre[row, 1]) <= _STILL_CENTRE
        else:
            rests = moved < _STILL and moved < _STILL_SHARE * length
        if rests:
            if last != row - 1:
                run, run_x, run_y, is_still = row, first_x, first_y, True
            last = row
            if is_still and math.hypot(tip_x - run_x, tip_y - run_y) > _STILL_RUN:
                is_still = False
                still[run:row] = False
            still[row] = is_still
    return count, headings, still, pushed
