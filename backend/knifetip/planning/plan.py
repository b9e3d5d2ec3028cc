"""plan: which tool works which edges, how deep and how fast, and in what order of trades.

    Dieline (in sheet coordinates), Machine, Board -> Operations

The list is in working order: creases and V-grooves while the board is whole and lies firmly, then
what is cut part of the way, then the cuts, layer by layer from the innermost: what lies inside a
contour is cut before the contour is.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Final

import numpy as np

from knifetip.errors import NoToolForLineType, PlanError
from knifetip.geometry.azimuth import azimuth
from knifetip.geometry.chain import chain, outward, run_on
from knifetip.geometry.columns import F64, I8, I32, I64, U8, Bool
from knifetip.geometry.grid import touching
from knifetip.geometry.path import (
    Paths,
    begun_in_middle,
    interrupted,
    reversed_where,
    taken,
    trimmed,
)
from knifetip.geometry.tolerance import ANGLE, COLLINEAR, GAP
from knifetip.model.board import Board
from knifetip.model.corners import Corners
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine, Station
from knifetip.model.operation import End, Operation
from knifetip.model.tool import Knife, Planner, VCutter
from knifetip.planning.boundary import Outline, run_out
from knifetip.planning.bridges import ends_of_others, places
from knifetip.planning.chords import chorded
from knifetip.planning.corners import check
from knifetip.planning.creases import doubled, split_at_cuts
from knifetip.planning.dashes import distinct, once
from knifetip.planning.flank import check_flanks
from knifetip.planning.layers import cut_layers
from knifetip.planning.milling import chosen_at, milled
from knifetip.planning.outer import Faces, faces
from knifetip.planning.reached import everywhere

#: Line types that are worked as others, each with a tool that makes that.
_STEPS: Final[Mapping[LineType, tuple[LineType, ...]]] = {
    LineType.UNCLASSIFIED: (),
    LineType.IGNORED: (),
    LineType.COMBI: (LineType.CREASE, LineType.PERFORATION),
}


def missing(line_type: LineType, machine: Machine) -> bool:
    """Return whether the machine lacks a tool that this line type needs."""
    return any(machine.station_for(step) is None for step in _STEPS.get(line_type, (line_type,)))


def check_corners(corners: Corners, machine: Machine) -> None:
    """Refuse choices for corners that make no sense, or for a machine that does not mill.

    Raises
    ------
    PlanError
        As it says.
    """
    if not machine.offset_cuts:
        raise PlanError("corner.no-cutter", machine=machine.title)
    check(corners)


def plan(
    dieline: Dieline, machine: Machine, board: Board, corners: Corners | None = None
) -> list[Operation]:
    """Return the operations that make a dieline, in working order.

    Parameters
    ----------
    dieline
        Edges in sheet coordinates.  Ignored and unclassified ones are left alone: whoever calls
        has asked about the latter.
    corners
        How a cutter goes round corners; as the machine is fastest where nobody chose.

    Raises
    ------
    PlanError
        A corner was chosen where there is none, or there is no cutter.
    NoToolForLineType
        No station of the machine makes one of the line types.
    FlankOutside
        A V-groove runs so close beside a cut, or along the board's edge, that its flank would
        leave the board.
    NoRoomForBridges
        A contour has no places for the bridges that the board asks for.
    """
    if corners is not None:
        check_corners(corners, machine)
    line_type = dieline.line_type
    cuts = np.flatnonzero(line_type == LineType.CUT).astype(np.int32)
    cuts = cuts[distinct(dieline.ends[cuts], dieline.bulge[cuts])]
    lies = faces(dieline.ends[cuts], dieline.bulge[cuts])
    side = lies.side
    outline = Outline.of(dieline.ends[cuts], dieline.bulge[cuts], side)

    def rows(*types: LineType) -> I32:
        return np.flatnonzero(np.isin(line_type, types)).astype(np.int32)

    work = (
        (LineType.CREASE, rows(LineType.CREASE, LineType.COMBI)),
        (LineType.V_GROOVE, rows(LineType.V_GROOVE)),
        (LineType.HALF_CUT, rows(LineType.HALF_CUT)),
        (LineType.PERFORATION, rows(LineType.PERFORATION, LineType.COMBI)),
        (LineType.CUT, cuts),
    )
    planners: Mapping[Planner, Callable[..., Operation | list[Operation]]] = {
        Planner.CREASES: _creases,
        Planner.GROOVES: partial(_grooves, outline),
        Planner.HALF_CUTS: _half_cuts,
        Planner.PERFORATIONS: _perforations,
        Planner.BLADE_CUTS: partial(_cuts, lies),
        Planner.OFFSET_CUTS: partial(milled, corners or Corners()),
    }
    operations: list[Operation] = []
    for kind, listed in work:
        if len(listed):
            station = machine.station_for(kind, board.caliper)
            if station is None:
                raise NoToolForLineType(
                    "tool.missing",
                    count=len(listed),
                    type=kind.word,
                    machine=machine.title,
                    source=[str(row) for row in listed[:10]],
                )
            made = planners[station.planner(kind)](dieline, listed, machine, board, station)
            operations += made if isinstance(made, list) else [made]
    return operations if corners is None else chosen_at(operations, corners)


def _operation(
    kind: LineType,
    paths: Paths,
    source: I32,
    depth: F64,
    ends: tuple[U8, U8],
    machine: Machine,
    board: Board,
    station: Station,
    *,
    out: F64 | None = None,
    side: int = 0,
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
        run_out=np.zeros((len(paths), 2)) if out is None else out,
        side=side,
    )


def _joined(
    dieline: Dieline, rows: I32, kink: float, group: I64 | None = None
) -> tuple[Paths, I32]:
    chains = chain(dieline.ends[rows], dieline.bulge[rows], kink, group=group)
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
    paths, source, ends = _folds(dieline, rows)
    if board.double_crease > 0.0:
        paths, which, row = doubled(paths, board.double_crease, source)
        source, ends = source[row], (ends[0][which], ends[1][which])
    chord = azimuth(paths.end - paths.start) - board.grain
    depth = board.crease_along + (board.crease_across - board.crease_along) * (
        np.sin(np.radians(chord)) ** 2
    )
    return _operation(LineType.CREASE, paths, source, depth[:, None], ends, machine, board, station)


def _folds(dieline: Dieline, rows: I32) -> tuple[Paths, I32, tuple[U8, U8]]:
    """Return creases as they are rolled, the edge of each segment, and the kinds of their ends."""
    cut = dieline.line_type == LineType.CUT
    cut_ends, cut_bulge = dieline.ends[cut], dieline.bulge[cut]
    alone = dieline.line_type[rows] == LineType.CREASE
    ends, bulge, row = once(
        dieline.ends[rows[alone]], dieline.bulge[rows[alone]], (cut_ends, cut_bulge)
    )
    # A combi line is perforated too, so its dashes stay as they are drawn.
    row = np.concatenate([rows[alone][row], rows[~alone]])
    order = np.argsort(row, kind="stable")
    ends = np.concatenate([ends, dieline.ends[rows[~alone]]])[order]
    bulge = np.concatenate([bulge, dieline.bulge[rows[~alone]]])[order]
    chains = chain(ends, bulge, ANGLE)
    paths, source = chains.paths(ends, bulge), row[order][chains.order]
    start, finish = _ends(paths, _continued(paths), End.CONTINUED)
    whole = paths.path_of
    paths, piece, split = split_at_cuts(paths, cut_ends, cut_bulge)
    owner = whole[piece[paths.first[:-1]]]
    kinds = np.where(split, End.FREE, np.stack([start, finish], axis=1)[owner]).astype(np.uint8)
    return paths, source[piece], (kinds[:, 0], kinds[:, 1])


def _continued(paths: Paths) -> Bool:
    """Return for the ends of the paths, (2p,), whether another path goes on in their direction.

    Chaining has joined all that is plain; what is left are places where several go on.
    """
    return run_on(*_departures(paths))


def _departures(paths: Paths) -> tuple[F64, F64]:
    """Return where the paths begin and end, (2p, 2), and the directions in which they set out."""
    points, own = _end_points(paths)
    side = np.repeat([0, 1], len(paths))
    segments = np.stack([paths.start, paths.end], axis=1)
    return points, outward(segments, paths.bulge)[own, side]


def _grooves(
    outline: Outline,
    dieline: Dieline,
    rows: I32,
    machine: Machine,
    board: Board,
    station: Station,
) -> Operation:
    cutter = station.tool
    assert isinstance(cutter, VCutter)
    ends, bulge, joint = dieline.ends[rows], dieline.bulge[rows], 0.0
    if board.groove_curve > 0.0:
        ends, bulge, rows, joint = chorded(ends, bulge, rows, cutter, board.groove_curve)
    chains = chain(ends, bulge, COLLINEAR)
    paths, source = chains.paths(ends, bulge), rows[chains.order]
    passes = 1
    if board.groove_pass > 0.0:
        passes = max(1, math.ceil(board.groove_depth / board.groove_pass - 1e-9))
    depth = np.tile(board.groove_depth * np.arange(1, passes + 1) / passes, (len(source), 1))
    reach = board.groove_depth * cutter.slope
    points, inward = _departures(paths)
    own = source[_end_points(paths)[1]]
    out, on_edge = run_out(points, -inward, 2.0 * reach, outline, own)
    out = out.reshape(2, -1).T
    check_flanks(paths, source, reach, out, dieline)
    # From chord to chord the blade runs over into its own groove.
    joined = run_on(points, inward, joint + COLLINEAR) if joint else np.zeros(len(own), np.bool_)
    kinds = np.where(on_edge, End.MEETS, np.where(joined, End.CONTINUED, End.FREE))
    start, finish = np.split(kinds.astype(np.uint8), 2)
    return _operation(
        LineType.V_GROOVE, paths, source, depth, (start, finish), machine, board, station, out=out
    )


def _cuts(
    lies: Faces, dieline: Dieline, rows: I32, machine: Machine, board: Board, station: Station
) -> list[Operation]:
    """Return the cuts layer by layer, in each those that bound no part first.

    ``lies`` is what ``outer.faces`` returns for the rows.
    """
    side = lies.side
    layer = cut_layers(dieline.ends[rows], dieline.bulge[rows], lies.face)
    through = board.caliper + machine.into_mat
    place = (layer.max(initial=0) - layer) * 2 + (side != 0)
    operations = []
    for bounds in (False, True):
        some = np.flatnonzero((side != 0) == bounds)
        if len(some):
            made = _knifed(
                LineType.CUT, dieline, rows[some], through, machine, board, station,
                side[some] if bounds else None, layer[some],
            )  # fmt: skip
            operations += _by_place(made, rows, place)
    operations.sort(key=lambda made: made[0])
    return [operation for _, operation in operations]


def _by_place(operation: Operation, rows: I32, place: I64) -> list[tuple[int, Operation]]:
    """Return an operation in several, the paths of each of whose edges are of one place."""
    of_row = np.zeros(int(rows.max()) + 1, np.int64)
    of_row[rows] = place
    paths = operation.paths
    own = of_row[operation.source[paths.first[:-1]]]
    parts = []
    for number in np.unique(own):
        which = np.flatnonzero(own == number).astype(np.int32)
        some, segment = taken(paths, which)
        part = replace(
            operation,
            paths=some,
            depth=operation.depth[segment],
            start=operation.start[which],
            finish=operation.finish[which],
            source=operation.source[segment],
            run_out=operation.run_out[which],
            k_at=operation.k_at[segment],
            corner_at=operation.corner_at[segment],
        )
        parts.append((int(number), part))
    return parts


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
    waste: I8 | None = None,
    group: I64 | None = None,
) -> Operation:
    """Cuts by a knife; those round a part, where ``waste`` says on which side of each edge.

    Edges of different groups are not joined.
    """
    paths, source = _joined(dieline, rows, 180.0, group)
    held = np.zeros(len(paths), np.bool_)
    side = 0
    if waste is not None and board.bridge_width > 0.0 and board.bridge_spacing > 0.0:
        round_ = paths.closed
        avoid = ends_of_others(dieline, rows)
        at = places(
            paths, round_, board.bridge_width, board.bridge_spacing, source, avoid,
            everywhere(paths),
        )  # fmt: skip
        paths, owner, order = interrupted(paths, *at, board.bridge_width)
        held, source = round_[owner], source[order]
    elif waste is not None and isinstance(station.tool, Knife) and station.tool.led:
        paths, source = _waste_on_left(paths, source, dieline, rows, waste)
        side = 1
    paths, order = begun_in_middle(paths, paths.closed)
    source = source[order]
    start, finish = np.split(_meeting(paths, source, dieline), 2)
    # A blade enters exactly at its tip and runs out ahead of it: begin at the end that is free.
    paths, order = reversed_where(paths, start & ~finish & ~paths.closed & ~held)
    source = source[order]
    ends = _ends(paths, _meeting(paths, source, dieline), End.MEETS)
    for kinds in ends:
        kinds[held] = End.BRIDGE
    deep = np.full((len(source), 1), depth)
    return _operation(kind, paths, source, deep, ends, machine, board, station, side=side)


def _waste_on_left(
    paths: Paths, source: I32, dieline: Dieline, rows: I32, waste: I8
) -> tuple[Paths, I32]:
    """Return the paths, the closed ones travelled with the waste on their left."""
    side = np.zeros(len(dieline), np.int8)
    side[rows] = waste
    first = paths.first[:-1]
    as_drawn = (paths.start[first] == dieline.ends[source[first], 0]).all(axis=1)
    on_right = side[source[first]] == np.where(as_drawn, -1, 1)
    paths, order = reversed_where(paths, paths.closed & on_right)
    return paths, source[order]


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
