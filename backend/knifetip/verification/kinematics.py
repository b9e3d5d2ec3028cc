"""Compute the poses of the tool tip at the ends of moves, and the paths of the tip in the board.

The formulas are derived from the tools' drawings, independently of the compensation engines.  With
the direction of travel u = (cos C, sin C) and the direction to its right v = (sin C, -cos C), the
tip is at

    knife, wheel    head - trail u
    V-cutter        head - back v - half_width u

``trail`` is the distance of the tip behind the head's axis, 0 for a wheel and a tangential knife.
``back`` and ``half_width`` are the distances of the tip from the head's axis, to the left and to
the rear.

The tip of a V-cutter with tilt θ moves along its tilted blade: when it rises by Δz, it also moves
by Δz tan θ to the right.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import F64_1, F64_2, I32_1, U8_1, Bool_1, inline_kernel, kernel
from knifetip.model.board import Board
from knifetip.model.machine import Machine, Station
from knifetip.verification.columns import F64, I32, I64, U8, Bool
from knifetip.verification.curves.curve import arc_curves, line_curves, point_at, write_line
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import expected_tool
from knifetip.verification.trailing_blade import TrailingBlade

#: Heights that differ by less are equal (mm).
LEVEL: Final = 1e-6


#: Greatest distance between a curved path of the tip and its chords (mm).
CHORD: Final = 1e-4


#: Greatest height above the table of a tip that cuts through the board (mm).
_THROUGH: Final = 2e-4


_MAX_CHORDS: Final = 10_000

#: Shapes of the path of the tip in one move: a line, the end of a plunge, an arc, and a path that
#: is neither a line nor an arc.
_LINE, _POINT, _ARC, _BENT = range(4)


@dataclass(frozen=True, eq=False, slots=True)
class TipPoses:
    """Poses of the tip of the selected station's tool at the start and end of each of n moves.

    A coordinate is NaN if it is unknown.
    """

    start: F64  #: (n, 4) x y z in mm on the sheet, heading in degrees
    end: F64  #: (n, 4)
    line: I32  #: (n,) 1-based line of the program
    station: I32  #: (n,) index into ``machine.stations``, -1 for none
    inside: Bool  #: (n,) part of the move is below the board's top face, or the beam is on

    def joined(self, move: I64) -> TipPoses:
        """Return the poses at the starts and ends of moves of which these ones are parts.

        ``move`` (n,) is the move of each part, ascending, from 0 without gaps.
        """
        if len(move) == 0 or move[-1] == len(move) - 1:
            return self
        first = np.flatnonzero(np.diff(move, prepend=-1))
        last = np.append(first[1:], len(move)) - 1
        inside: Bool = np.logical_or.reduceat(self.inside, first)
        return TipPoses(
            self.start[first], self.end[last], self.line[first], self.station[first], inside
        )


@dataclass(frozen=True, eq=False, slots=True)
class TipPaths:
    """n paths of the tip in the board: lines and arcs at constant depth, and the points at which
    plunges end.
    """

    curve: F64  #: (n, 6) rows as in ``curves.curve``
    z: F64  #: (n,) height of the tip above the table, mm
    heading: F64  #: (n, 2) degrees, at start and end
    operation: U8  #: (n,) ``OperationKind``
    station: I32  #: (n,) index into ``machine.stations``
    track: I32  #: (n,) number of the track; paths that no lift separates have one number
    line: I32  #: (n,) 1-based line of the program
    blend: F64  #: (n,) mm, by which the controller may round corners

    def select(self, keep: Bool) -> TipPaths:
        """Return the paths for which the mask ``keep``, (n,), is True."""
        return TipPaths(**{one.name: getattr(self, one.name)[keep] for one in fields(TipPaths)})

    def ends(self) -> tuple[F64, F64]:
        """Return the start points and the end points of the paths, (n, 2) mm each."""
        return point_at(self.curve, np.zeros(len(self.z))), point_at(self.curve, self.curve[:, 5])


def tip_offset(heading: F64, station: Station) -> F64:
    """Return the vector from the head's axis to the tip of a station's tool, one per heading, (n,
    2) mm.

    ``heading`` are the n headings of the tool, (n,) degrees.
    """
    cos, sin = np.cos(np.radians(heading)), np.sin(np.radians(heading))
    tool = expected_tool(station.tool)
    ahead, right = tool.ahead, tool.right
    return np.stack([ahead * cos + right * sin, ahead * sin - right * cos], axis=1)


def tip_poses(moves: Moves, machine: Machine, board: Board) -> TipPoses:
    """Return the poses of the tip of the selected station's tool at the start and end of each of
    the n moves.
    """
    tools = [expected_tool(station.tool) for station in machine.stations]
    datum = np.array([(one.x, one.y, one.z, one.c) for one in machine.stations])
    tips = np.array([(tool.ahead, tool.right) for tool in tools])
    start = _tips_at(moves.start, moves.station, datum.reshape(-1, 4), tips.reshape(-1, 2))
    end = _tips_at(moves.end, moves.station, datum.reshape(-1, 4), tips.reshape(-1, 2))
    lowest = np.fmin(start[:, 2], end[:, 2])
    inside = (moves.station >= 0) & (lowest < board.caliper - LEVEL)
    beam = beam_moves(moves, machine)
    # A beam cuts wherever it is on, at any height.
    inside[beam] = moves.oscillating[beam]
    return TipPoses(start, end, moves.line, moves.station, inside)


@kernel
def _tips_at(joints: F64_2, station: I32_1, datum: F64_2, tips: F64_2) -> Any:
    """Return the pose of the tip of the selected tool at each of n positions of the joints, (n, 4).

    ``joints`` (n, 4): positions of X, Y, Z (mm) and C (degrees).
    ``station`` (n,): index of the selected station, -1 for none.
    ``datum`` (s, 4): position of the joints at which each station's tool is at the origin of the
    sheet.
    ``tips`` (s, 2) mm: distance of each tool's tip ahead of the head's axis, and to the right of
    it.
    """
    poses = joints.copy()
    heading, cos, sin = math.nan, 1.0, 0.0
    for row in range(len(joints)):
        own = station[row]
        if own < 0:
            continue
        for axis in range(4):
            poses[row, axis] -= datum[own, axis]
        if poses[row, 3] != heading:
            heading = poses[row, 3]
            cos, sin = math.cos(math.radians(heading)), math.sin(math.radians(heading))
        ahead, right = tips[own, 0], tips[own, 1]
        poses[row, 0] += ahead * cos + right * sin
        poses[row, 1] += ahead * sin - right * cos
    return poses


def beam_moves(moves: Moves, machine: Machine) -> Bool:
    """Return the mask of the n moves whose selected station carries a laser, shape (n,)."""
    is_beam = [expected_tool(station.tool).beam is not None for station in machine.stations]
    result: Bool = np.array([*is_beam, False])[moves.station]
    return result


def tip_paths(
    moves: Moves,
    tip: TipPoses,
    usable: Bool,
    machine: Machine,
    board: Board,
    blade: TrailingBlade | None = None,
    *,
    split_at_caliper: bool = False,
) -> TipPaths:
    """Return the paths of the tip in the board, in the order of the program.

    A plunge gives a path of length 0 at its lower end, unless a move at constant height follows it.
    A move from or to an unknown position gives no path.

    Parameters
    ----------
    moves, tip
        The n moves of the program, and the poses of the tip at their starts and ends.
    usable : (n,)
        Mask of the moves that give paths.  The other moves have findings from other checks.
    machine, board
        Machine and board of the program.
    blade
        Paths of the tips of free blades, if the machine has any.
    split_at_caliper
        Whether every path of a knife that does not go through the board is a half-cut, because
        depths are chosen; else it is a cut or a half-cut, whichever depth is nearer.
    """
    tools = [expected_tool(station.tool) for station in machine.stations]
    rests = blade.still if blade else np.zeros(len(moves.code), np.bool_)
    columns = _PathMoves(moves.code, moves.sweep, moves.station, tip.start, tip.end, tip.inside)
    beams = np.array([*(tool.beam is not None for tool in tools), False])
    reach = np.array([*(math.hypot(tool.ahead, tool.right) for tool in tools), 0.0])
    rows, track, shape, curve = _select_paths(
        columns, usable, rests, beams, reach, board.caliper - LEVEL
    )
    turn = tip.end[rows, 3] - tip.start[rows, 3]
    heading = np.column_stack([tip.start[rows, 3], tip.start[rows, 3] + turn])
    arcs = np.flatnonzero(shape == _ARC)
    if len(arcs):
        own = rows[arcs]
        datum = np.array([(station.x, station.y) for station in machine.stations])
        centre = moves.centre[own] - datum[tip.station[own]]
        curve[arcs] = arc_curves(centre, tip.start[own, :2], moves.sweep[own])
    bent = np.flatnonzero(shape == _BENT)
    if len(bent):
        plain = np.flatnonzero(shape != _BENT)
        trailed = bent[blade.free[rows[bent]]] if blade else bent[:0]
        driven = np.setdiff1d(bent, trailed, assume_unique=True)
        chord_rows, chords, shares = _flatten_paths(
            moves, tip, rows, driven, reach[tip.station[rows]], machine
        )
        parts = [(plain, curve[plain], heading[plain])]
        turned = heading[chord_rows, :1] + turn[chord_rows, None] * shares
        parts.append((chord_rows, chords, turned))
        if blade and len(trailed):
            parts.append(_trailed_paths(blade, rows, trailed))
        picked = np.concatenate([part[0] for part in parts])
        order = np.argsort(picked, kind="stable")
        rows, track = rows[picked[order]], track[picked[order]]
        curve = np.concatenate([part[1] for part in parts])[order]
        heading = np.concatenate([part[2] for part in parts])[order]
    z = tip.end[rows, 2]
    return TipPaths(
        curve=curve,
        z=z,
        heading=heading,
        operation=_operations(z, tip.station[rows], machine, board, split_at_caliper),
        station=tip.station[rows],
        track=track,
        line=moves.line[rows],
        blend=moves.blend[rows],
    )


def _trailed_paths(blade: TrailingBlade, rows: I64, trailed: I64) -> tuple[I64, F64, F64]:
    """Return the k chords of the tip of a free blade in selected moves.

    ``trailed``: indices into ``rows`` of the selected moves.
    Returns index into ``rows`` of the move of each chord (k,); the chords as rows of six numbers,
    (k, 6); and the headings at the start and the end of each, (k, 2) degrees.
    """
    chord, owner = blade.chords_of(rows[trailed])
    curve = line_curves(blade.tip[chord, :2], blade.tip[chord, 2:])
    # The tip of a blade that is turned across its path starts without a length.
    kept = curve[:, 5] > 1e-6
    return trailed[owner[kept]], curve[kept], blade.heading[chord[kept]]


class _PathMoves(NamedTuple):
    """Columns of n moves that determine the paths of the tip; see ``Moves`` and ``TipPoses``."""

    code: U8_1
    sweep: F64_1
    station: I32_1
    start: F64_2  #: (n, 4), poses of the tip
    end: F64_2  #: (n, 4)
    inside: Bool_1


@inline_kernel
def _enters(moves: _PathMoves, beams: Bool_1, top: float, row: int) -> bool:
    """Return whether the tip of a tool other than a laser is not below the height ``top`` at the
    start of a move.
    """
    return not moves.start[row, 2] < top and not beams[moves.station[row]]


@inline_kernel
def _travels(moves: _PathMoves, row: int) -> bool:
    """Return whether the tip travels at constant height in a move."""
    if not abs(moves.end[row, 2] - moves.start[row, 2]) <= LEVEL:
        return False
    x, y = moves.end[row, 0] - moves.start[row, 0], moves.end[row, 1] - moves.start[row, 1]
    return math.hypot(x, y) > 1e-9 or moves.sweep[row] != 0.0


@inline_kernel
def is_known(start: F64_2, end: F64_2, row: int) -> bool:
    """Return whether all four coordinates at the start and the end of a move are known."""
    for axis in range(4):
        if math.isnan(start[row, axis]) or math.isnan(end[row, axis]):
            return False
    return True


@kernel
def _select_paths(
    moves: _PathMoves,
    usable: Bool_1,
    rests: Bool_1,
    beams: Bool_1,
    reach: F64_1,
    top: float,
) -> Any:
    """Return the k moves that give paths of the tip in the board, and those paths that are lines
    and points.

    ``usable`` (n,): mask of the moves that may give paths.
    ``rests`` (n,): mask of the moves that only turn a free blade about its tip.
    ``beams``, ``reach`` (s + 1,): whether the tool of each station is a laser, and the distance of
    its tip from the head's axis (mm); the last row is for no station.
    ``top`` mm: height below which a tip is in the board.
    Returns index of each move, (k,); number of its track, (k,); ``_LINE``, ``_POINT``, ``_ARC`` or
    ``_BENT``, (k,); and the lines and points as rows of six numbers (see ``curves.curve``), (k, 6).
    The rows of arcs and bent paths are unset.
    """
    count = len(moves.code)
    rows, track = np.empty(count, np.int64), np.empty(count, np.int32)
    shape = np.empty(count, np.uint8)
    used, tracks, stayed = 0, -1, False
    # Whether the last path is the end of a plunge that the next path continues.
    opens = False
    for row in range(count):
        stays = usable[row] and moves.inside[row] and moves.code[row] > 0
        if not (stays and is_known(moves.start, moves.end, row)):
            stayed = False
            continue
        # A track continues while each move begins in the board.
        broken = (
            not stayed
            or _enters(moves, beams, top, row)
            or moves.station[row] != moves.station[row - 1]
        )
        if broken:
            tracks += 1
            opens = False
        stayed = True
        if rests[row]:
            continue
        if _travels(moves, row):
            used -= opens
            opens = False
            # If the tip is off the axis and C turns, its path is neither a line nor an arc.
            turns = moves.end[row, 3] != moves.start[row, 3] or moves.sweep[row] != 0.0
            if reach[moves.station[row]] > 0.0 and turns:
                shape[used] = _BENT
            else:
                shape[used] = _LINE if moves.sweep[row] == 0.0 else _ARC
        elif moves.end[row, 2] - moves.start[row, 2] < -LEVEL:
            used -= opens and rests[row - 1]
            shape[used] = _POINT
            opens = True
        else:
            opens = False
            continue
        rows[used], track[used] = row, tracks
        used += 1
    curve = np.empty((used, 6))
    for k in range(used):
        x, y = moves.end[rows[k], 0], moves.end[rows[k], 1]
        if shape[k] == _LINE:
            write_line(curve, k, moves.start[rows[k], 0], moves.start[rows[k], 1], x, y)
        elif shape[k] == _POINT:
            write_line(curve, k, x, y, x, y)
    return rows[:used].copy(), track[:used].copy(), shape[:used].copy(), curve


def _flatten_paths(
    moves: Moves, tip: TipPoses, rows: I64, bent: I64, offset: F64, machine: Machine
) -> tuple[I64, F64, F64]:
    """Return k chords that replace tip paths which are neither lines nor arcs.

    ``moves``, ``tip``: all moves of the program, and the poses of the tip at their starts and ends.
    ``rows``: indices of the selected moves in ``moves``.
    ``bent``: indices into ``rows`` of the moves whose tip paths are replaced.
    ``offset``: distance of the tip from the head's axis, one for each of ``rows``, mm.
    Returns index into ``rows`` of the move of each chord (k,); the chords as rows of six numbers
    (see ``curves.curve``), (k, 6); and the start and end of each chord as fractions of the move (k,
    2).
    """
    own = rows[bent]
    turn = np.radians(tip.end[own, 3] - tip.start[own, 3])
    radial = moves.start[own, :2] - moves.centre[own]
    radius = np.where(moves.sweep[own] != 0.0, np.hypot(*radial.T), 0.0)
    bow = radius * moves.sweep[own] ** 2 + offset[bent] * turn**2
    pieces = np.clip(np.ceil(np.sqrt(bow / (8.0 * CHORD))), 1, _MAX_CHORDS).astype(np.int64)
    place = np.arange(pieces.sum()) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    owner = np.repeat(np.arange(len(bent)), pieces)
    fraction = np.stack([place, place + 1], axis=1) / pieces[owner][:, None]
    sides = []
    for side in range(2):
        position = fraction[:, side]
        move = own[owner]
        joints = moves.start[move] + (moves.end[move] - moves.start[move]) * position[:, None]
        angle = np.arctan2(radial[owner, 1], radial[owner, 0]) + moves.sweep[move] * position
        round_ = moves.sweep[move] != 0.0
        swept = moves.centre[move] + radius[owner][:, None] * np.stack(
            [np.cos(angle), np.sin(angle)], axis=1
        )
        joints[round_, :2] = swept[round_]
        xy = np.zeros((len(move), 2))
        for index, station in enumerate(machine.stations):
            station_rows = moves.station[move] == index
            heading = joints[station_rows, 3] - station.c
            xy[station_rows] = (
                joints[station_rows, :2] - (station.x, station.y) + tip_offset(heading, station)
            )
        sides.append(xy)
    # Consecutive chords share their points exactly.
    return bent[owner], line_curves(sides[0], sides[1]), fraction


def _operations(z: F64, station: I32, machine: Machine, board: Board, split_at_caliper: bool) -> U8:
    """Return the ``OperationKind`` of each tip path, from its height (mm) and its station."""
    tools = [expected_tool(station.tool) for station in machine.stations]
    kinds = np.array([(tool.through_kind, tool.partial_kind) for tool in tools], np.uint8).reshape(
        -1, 2
    )
    # A knife has two depths; choose the operation with the nearer one.
    half = np.abs(z - (board.caliper - board.half_cut_depth)) < np.abs(z + machine.into_mat)
    if split_at_caliper:
        half = z > _THROUGH
    result: U8 = kinds[station, half.astype(np.int64)]
    return result
