"""plan: which tool works which edges, how deep and how fast, and in what order of trades.

    Dieline (in sheet coordinates), Machine, Board -> Operations

The list is in working order: creases and V-grooves while the board is whole and lies firmly, then
what is cut part of the way, then inner cuts, and last the outer contours that set the blank free.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from knifetip.errors import NoToolForLineType
from knifetip.geometry.azimuth import azimuth
from knifetip.geometry.chain import chain, outward, run_on
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.grid import touching
from knifetip.geometry.path import Paths, begun_in_middle, reversed_where, taken, trimmed
from knifetip.geometry.tolerance import ANGLE, COLLINEAR, GAP
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine, Station
from knifetip.model.operation import End, Operation
from knifetip.model.tool import CreaseWheel, Knife, Tool, VCutter
from knifetip.planning.flank import check_flanks
from knifetip.planning.outer import outer

#: The tools that each line type needs.
NEEDS: dict[LineType, tuple[type[Tool], ...]] = {
    LineType.CUT: (Knife,),
    LineType.CREASE: (CreaseWheel,),
    LineType.V_GROOVE: (VCutter,),
    LineType.PERFORATION: (Knife,),
    LineType.HALF_CUT: (Knife,),
    LineType.COMBI: (CreaseWheel, Knife),
}


def missing(line_type: LineType, machine: Machine) -> bool:
    """Return whether the machine lacks a tool that this line type needs."""
    return any(_station(machine, kind) is None for kind in NEEDS.get(line_type, ()))


def plan(dieline: Dieline, machine: Machine, board: Board) -> list[Operation]:
    """Return the operations that make a dieline, in working order.

    Parameters
    ----------
    dieline
        Edges in sheet coordinates.  Ignored and unclassified ones are left alone: whoever calls
        has asked about the latter.

    Raises
    ------
    NoToolForLineType
        No station of the machine makes one of the line types.
    FlankOutside
        A V-groove runs so close beside a cut that its flank would leave the board.
    """
    line_type = dieline.line_type
    cuts = np.flatnonzero(line_type == LineType.CUT)
    bounding = outer(dieline.ends[cuts], dieline.bulge[cuts])

    def rows(*types: LineType) -> I32:
        return np.flatnonzero(np.isin(line_type, types)).astype(np.int32)

    work: list[tuple[LineType, I32, Callable[..., Operation]]] = [
        (LineType.CREASE, rows(LineType.CREASE, LineType.COMBI), _creases),
        (LineType.V_GROOVE, rows(LineType.V_GROOVE), _grooves),
        (LineType.HALF_CUT, rows(LineType.HALF_CUT), _half_cuts),
        (LineType.PERFORATION, rows(LineType.PERFORATION, LineType.COMBI), _perforations),
        (LineType.CUT, cuts[~bounding].astype(np.int32), _cuts),
        (LineType.CUT, cuts[bounding].astype(np.int32), _cuts),
    ]
    operations = []
    for kind, listed, make in work:
        if len(listed):
            station = _station(machine, NEEDS[kind][0])
            if station is None:
                raise NoToolForLineType(
                    f"{len(listed)} edges are {kind.word}, and no station of {machine.title} "
                    "makes that.",
                    "Give them another line type, or choose another machine.",
                    [str(row) for row in listed[:10]],
                )
            operations.append(make(dieline, listed, machine, board, station))
    return operations


def _station(machine: Machine, kind: type[Tool]) -> Station | None:
    return next((station for station in machine.stations if type(station.tool) is kind), None)


def _operation(
    kind: LineType,
    paths: Paths,
    source: I32,
    depth: F64,
    ends: tuple[U8, U8],
    machine: Machine,
    board: Board,
    station: Station,
) -> Operation:
    return Operation(
        paths=paths,
        line_type=kind,
        tool=station.tool,
        station=station.number,
        depth=depth,
        caliper=board.caliper,
        clearance=machine.clearance,
        feed=station.tool.feed,
        plunge=station.tool.plunge,
        swivel=machine.c.velocity * 60.0,
        end_clearance=board.end_clearance,
        overcut=board.groove_overcut,
        short_crease=board.short_crease,
        start=ends[0],
        finish=ends[1],
        source=source,
    )


def _joined(dieline: Dieline, rows: I32, kink: float) -> tuple[Paths, I32]:
    chains = chain(dieline.ends[rows], dieline.bulge[rows], kink)
    return chains.paths(dieline.ends[rows], dieline.bulge[rows]), rows[chains.order]


def _end_points(paths: Paths) -> tuple[F64, I32]:
    """Return where the paths begin and end, (2p, 2), and the segments there, (2p,)."""
    begin, finish = paths.first[:-1], paths.first[1:] - 1
    points = np.concatenate([paths.start[begin], paths.end[finish]])
    return points, np.concatenate([begin, finish]).astype(np.int32)


def _ends(paths: Paths, met: Bool, word: End) -> tuple[U8, U8]:
    """Return the kind of each path's start and finish; ``met`` (2p,) starts first."""
    kinds = np.where(met, word, End.FREE)
    start, finish = np.split(np.where(np.tile(paths.closed, 2), End.CLOSED, kinds), 2)
    return start.astype(np.uint8), finish.astype(np.uint8)


def _creases(
    dieline: Dieline, rows: I32, machine: Machine, board: Board, station: Station
) -> Operation:
    paths, source = _joined(dieline, rows, ANGLE)
    chord = azimuth(paths.end - paths.start) - board.grain
    depth = board.crease_along + (board.crease_across - board.crease_along) * (
        np.sin(np.radians(chord)) ** 2
    )
    ends = _ends(paths, _continued(paths), End.CONTINUED)
    return _operation(LineType.CREASE, paths, source, depth[:, None], ends, machine, board, station)


def _continued(paths: Paths) -> Bool:
    """Return for the ends of the paths, (2p,), whether another path goes on in their direction.

    Chaining has joined all that is plain; what is left are places where several go on.
    """
    points, own = _end_points(paths)
    side = np.repeat([0, 1], len(paths))
    segments = np.stack([paths.start, paths.end], axis=1)
    return run_on(points, outward(segments, paths.bulge)[own, side])


def _grooves(
    dieline: Dieline, rows: I32, machine: Machine, board: Board, station: Station
) -> Operation:
    paths, source = _joined(dieline, rows, COLLINEAR)
    depth = np.full((len(source), 1), board.groove_depth)
    if isinstance(station.tool, VCutter):
        check_flanks(paths, source, board.groove_depth * station.tool.slope, dieline)
    free = np.zeros(2 * len(paths), np.bool_)
    ends = _ends(paths, free, End.FREE)
    return _operation(LineType.V_GROOVE, paths, source, depth, ends, machine, board, station)


def _cuts(
    dieline: Dieline, rows: I32, machine: Machine, board: Board, station: Station
) -> Operation:
    through = board.caliper + machine.into_mat
    return _knifed(LineType.CUT, dieline, rows, through, machine, board, station)


def _half_cuts(
    dieline: Dieline, rows: I32, machine: Machine, board: Board, station: Station
) -> Operation:
    return _knifed(LineType.HALF_CUT, dieline, rows, board.half_cut_depth, machine, board, station)


def _knifed(
    kind: LineType,
    dieline: Dieline,
    rows: I32,
    depth: float,
    machine: Machine,
    board: Board,
    station: Station,
) -> Operation:
    paths, source = _joined(dieline, rows, 180.0)
    paths, order = begun_in_middle(paths, paths.closed)
    source = source[order]
    start, finish = np.split(_meeting(paths, source, dieline), 2)
    # A blade enters exactly at its tip and runs out ahead of it: begin at the end that is free.
    paths, order = reversed_where(paths, start & ~finish & ~paths.closed)
    source = source[order]
    ends = _ends(paths, _meeting(paths, source, dieline), End.MEETS)
    deep = np.full((len(source), 1), depth)
    return _operation(kind, paths, source, deep, ends, machine, board, station)


def _meeting(paths: Paths, source: I32, dieline: Dieline) -> Bool:
    """Return for the ends of the paths, (2p,), whether they lie on another through cut."""
    points, own = _end_points(paths)
    cut = np.flatnonzero(dieline.line_type == LineType.CUT)
    ends, bulge = dieline.ends[cut], dieline.bulge[cut]
    place = np.full(len(dieline), -1, np.int32)
    place[cut] = np.arange(len(cut))
    return touching(points, place[source[own]], ends[:, 0], ends[:, 1], bulge, GAP)


def _perforations(
    dieline: Dieline, rows: I32, machine: Machine, board: Board, station: Station
) -> Operation:
    paths, source = _joined(dieline, rows, ANGLE)
    pieces, order = _dashed(paths, *board.perforation)
    source = source[order]
    deep = np.full((len(source), 1), board.caliper + machine.into_mat)
    free = np.zeros(2 * len(pieces), np.bool_)
    ends = _ends(pieces, free, End.FREE)
    return _operation(LineType.PERFORATION, pieces, source, deep, ends, machine, board, station)


def _dashed(paths: Paths, cut: float, gap: float) -> tuple[Paths, I32]:
    """Return the cuts of perforated paths, each as a path, and the segment of each of theirs.

    Every path begins and ends with a cut, so that it tears from its ends; the gaps between are
    equal and at most ``gap`` mm.
    """
    length = paths.lengths
    count = np.maximum(1, np.ceil((length + gap) / (cut + gap) - 1e-9)).astype(np.int64)
    count = np.where(count * cut >= length, 1, count)
    spacing = (length - cut) / np.maximum(count - 1, 1)
    owner = np.repeat(np.arange(len(paths)), count)
    place = np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)
    begin = place * spacing[owner]
    size = np.where(count == 1, length, cut)[owner]
    repeated, rows = taken(paths, owner.astype(np.int32))
    left = np.maximum(length[owner] - begin - size, 0.0)
    pieces, order = trimmed(repeated, begin, left)
    return pieces, rows[order].astype(np.int32)
