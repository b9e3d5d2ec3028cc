"""blade_operations: plan the operations of a knife: cuts, half-cuts and perforations."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from knifetip.geometry.columns import I8, I32, I64, U8, Bool
from knifetip.geometry.path import (
    Paths,
    insert_gaps,
    lengths_behind_corners,
    reverse_paths,
    select_paths,
    trim_ends,
)
from knifetip.geometry.points_on_segments import find_points_on_segments
from knifetip.geometry.tolerance import ANGLE, GAP
from knifetip.languages.registry import find_language
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.operation import End, Operation
from knifetip.model.tool import Knife
from knifetip.model.tool.base import equal_passes
from knifetip.planning.boundary import BoardOutline, ends_at_waste
from knifetip.planning.bridges import Spacing, ends_of_others, place_bridges
from knifetip.planning.chosen_bridges import NO_BRIDGES, bridges_on_paths
from knifetip.planning.cut_sides import CutSides
from knifetip.planning.last_cuts import track_levels
from knifetip.planning.layers import CutLayers, cut_layers
from knifetip.planning.path_ends import chain_edges, end_directions, end_kinds, end_points
from knifetip.planning.reachable import all_reachable
from knifetip.planning.setup import Setup

#: For each ``End``: a path is cut towards the one of its ends that has the higher number.
_FINISH_RANK: Final = np.zeros(len(End), np.uint8)
_FINISH_RANK[[End.JUNCTION, End.MEETS]] = 1, 2


@dataclass(frozen=True, eq=False, slots=True)
class _Cuts:
    """m cuts of one line type and one depth."""

    line_type: LineType
    rows: I32  #: (m,) rows of the dieline
    depth: float  #: mm
    waste: I8 | None = None  #: (m,) side of the waste: +1 left, -1 right; None: bounds no part
    group: I64 | None = None  #: (m,) cuts of different groups are not chained
    passes: int = 0  #: number of passes; 0 for as many as the knife needs


def plan_blade_cuts(sides: CutSides, dieline: Dieline, rows: I32, setup: Setup) -> list[Operation]:
    """Return the operations that cut edges of a dieline with a knife, innermost layer first.

    A layer is a set of cuts that may be made in any order (see the module ``layers``).  Each layer
    gives one or two operations: first the cuts that are no outline of a part, such as holes and
    slits, then the outlines of parts.

    Parameters
    ----------
    sides
        For each of the m edges: the side of the waste, and the part or hole that the edge bounds.
    rows : (m,)
        Indices of the edges in the dieline.
    setup
        Machine, board and station of the knife.
    """
    side = sides.waste
    ends, bulge = dieline.ends[rows], dieline.bulge[rows]
    layers = cut_layers(ends, bulge, sides.face, uncrossed=sides.subdivision)
    if layers.stretches.ends is ends:
        outline = BoardOutline.from_cuts(ends, bulge, sides.removed)
    else:
        _, outline = BoardOutline.from_contours(ends, bulge, sides)
    layer = layers.number
    rank = (layer.max(initial=0) - layer) * 2 + (side != 0)
    index = np.full(len(dieline), -1, np.int64)
    index[rows] = np.arange(len(rows))
    operations = []
    for bounds in (False, True):
        part_rows = np.flatnonzero((side != 0) == bounds)
        for subset, depth, passes, own_setup in _groups(part_rows, rows, setup):
            waste = side[subset] if bounds else None
            cuts = _Cuts(LineType.CUT, rows[subset], depth, waste, layer[subset], passes)
            operation = _cut(outline, dieline, cuts, own_setup)
            level = _levels(operation, index, layers)
            path_rank = rank[index[operation.source[operation.paths.first[:-1]]]]
            # Levels are less than the number of cuts.
            for number, part in _split_by_rank(operation, path_rank * len(rows) + level):
                operations += [(number, one) for one in _in_passes(part, cuts, own_setup)]
    operations.sort(key=lambda rank_and_operation: rank_and_operation[0])
    return [operation for _, operation in operations]


def _groups(subset: I64, rows: I32, setup: Setup) -> Iterator[tuple[I64, float, int, Setup]]:
    """Yield cuts in groups of equal tool, passes and depth.

    Each group is its indices in ``rows``, its depth (mm), its number of passes, 0 for as many as
    the knife needs, and the setup of its knife.

    ``subset``: indices in ``rows`` of the cuts.
    ``rows`` (m,): indices in the dieline of all cuts.
    """
    for of_tool, own_setup in setup.tool_groups(rows[subset]):
        cuts = subset[of_tool]
        for own, depth, passes in own_setup.depth_groups(rows[cuts], setup.through_depth):
            if len(own):
                yield cuts[own], depth, passes, own_setup


def _levels(operation: Operation, index: I64, layers: CutLayers) -> I64:
    """Return the level of each path of an operation, (p,); see ``track_levels``.

    Paths between bridges release no piece, so their level is 0.

    ``index``: index in ``layers`` of each edge of the dieline, -1 for an edge that is no cut.
    """
    paths = operation.paths
    path = np.repeat(np.arange(len(paths)), np.diff(paths.first))
    releases = (operation.start != End.BRIDGE)[path]
    track = np.full(len(layers.number), -1, np.int64)
    track[index[operation.source[releases]]] = path[releases]
    return track_levels(layers.number, layers.stretches, track, paths.lengths)


def _split_by_rank(operation: Operation, rank: I64) -> list[tuple[int, Operation]]:
    """Split an operation into one operation for each rank; return pairs (rank, operation), lowest
    rank first.

    The rank of each of p paths is a number by which the paths are put in working order, (p,).
    """
    parts = []
    for number in np.unique(rank):
        path_rows = np.flatnonzero(rank == number).astype(np.int32)
        subset, segment = select_paths(operation.paths, path_rows)
        part = replace(
            operation,
            paths=subset,
            depth=operation.depth[segment],
            start=operation.start[path_rows],
            finish=operation.finish[path_rows],
            source=operation.source[segment],
            run_out=operation.run_out[path_rows],
            k_at=operation.k_at[segment],
            endable=operation.endable[segment],
            corner_at=operation.corner_at[segment],
        )
        parts.append((int(number), part))
    return parts


def _in_passes(operation: Operation, cuts: _Cuts, setup: Setup) -> list[Operation]:
    """Return an operation of a knife once for each pass, in working order.

    The knife makes the first of the passes in ``Operation.depth``; the others, of which the last
    one has the depth of ``cuts``, determine its ends.  Where programs do not set depth and heading,
    the knife makes one pass at one feed.
    """
    knife = setup.station.tool
    assert isinstance(knife, Knife)
    if not find_language(setup.machine.dialect).sets_pose:
        return [replace(operation, tool=replace(knife, slow_radius=0.0))]
    depths = knife.passes(cuts.depth)
    if cuts.passes:
        depths = equal_passes(cuts.depth, cuts.passes)
        # All passes of a cut have the same direction.
        operation = replace(operation, one_way=cuts.passes > 1)
    count = len(operation.source)
    return [
        replace(operation, depth=np.tile(depths[first:], (count, 1)))
        for first in range(len(depths))
    ]


def plan_half_cuts(
    outline: BoardOutline, dieline: Dieline, rows: I32, setup: Setup
) -> list[Operation]:
    """Return the operations that half-cut edges of a dieline with a knife, to the board's half-cut
    depth unless another depth is chosen.

    Parameters
    ----------
    outline
        Outlines of the board and of its holes.
    rows : (m,)
        Indices of the edges in the dieline.
    setup
        Machine, board and station of the knife.
    """
    operations = []
    for own, depth, passes in setup.depth_groups(rows, setup.board.half_cut_depth):
        cuts = _Cuts(LineType.HALF_CUT, rows[own], depth, passes=passes)
        operations += _in_passes(_cut(outline, dieline, cuts, setup), cuts, setup)
    return operations


def _cut(outline: BoardOutline, dieline: Dieline, cuts: _Cuts, setup: Setup) -> Operation:
    """Return one operation that makes ``cuts``, cuts of one line type and one depth, with a knife.

    The operation leaves bridges in the outlines of parts if the board requires bridges.  If it
    requires none, and the knife has a lead-in or a lead-out, the outlines of parts are cut with the
    waste on the left.  ``outline`` contains the outlines of the board and of its holes; ``setup``
    contains the machine, the board and the station of the knife.
    """
    board, tool = setup.board, setup.station.tool
    paths, source = chain_edges(dieline, cuts.rows, 180.0, cuts.group)
    has_bridges = np.zeros(len(paths), np.bool_)
    side = 0
    placed = NO_BRIDGES
    if cuts.waste is not None:
        placed = bridges_on_paths(setup.bridges, paths, source, 0.0)
    by_board = board.bridge_width > 0.0 and board.bridge_spacing > 0.0
    if cuts.waste is not None and (by_board or len(placed.path)):
        held = np.isin(np.arange(len(paths)), placed.path)
        if by_board:
            automatic = paths.closed & ~held
            spacing = Spacing(board.bridge_width, board.bridge_spacing)
            avoid = ends_of_others(dieline, cuts.rows)
            path, along = place_bridges(
                paths, automatic, spacing, source, avoid, all_reachable(paths)
            )
            held |= automatic
            placed = placed.merged_with(path, along, board.bridge_width)
        paths, old_path, segment = insert_gaps(paths, placed.path, placed.along, placed.width)
        has_bridges, source = held[old_path], source[segment]
    elif cuts.waste is not None and isinstance(tool, Knife) and tool.has_lead:
        paths, source = _keep_waste_left(paths, source, dieline, cuts.rows, cuts.waste)
        side = 1
    start, finish = _kinds_of_ends(paths, source, dieline, outline)
    # A blade enters exactly at its tip and runs out ahead of it: finish at the end where a cut
    # beyond it harms least.
    backwards = _FINISH_RANK[start] > _FINISH_RANK[finish]
    if isinstance(tool, Knife):
        backwards |= _end_in_stubs(paths, start, finish, tool, tool.lead(1.0) * cuts.depth)
    backwards &= ~has_bridges
    paths, segment = reverse_paths(paths, backwards)
    source = source[segment]
    ends = np.where(backwards, finish, start), np.where(backwards, start, finish)
    for path_kinds in ends:
        path_kinds[has_bridges] = End.BRIDGE
    depth = np.full((len(source), 1), cuts.depth)
    return replace(setup.operation(cuts.line_type, paths, source, depth, ends), side=side)


def _end_in_stubs(paths: Paths, start: U8, finish: U8, knife: Knife, lead: float) -> Bool:
    """Return the mask of the p paths with two free ends of which only the finish is a stub, (p,).

    A stub is not longer than the ``lead`` of the blade (mm) and begins at a corner sharper than the
    swivel angle of the knife.  The blade can make it at the start of a path, but not at its finish.

    ``start``, ``finish`` (p,): kinds of the ends of the paths.
    """
    mask: Bool = (start == End.FREE) & (finish == End.FREE)
    if lead == 0.0 or not mask.any():
        return np.zeros(len(paths), np.bool_)
    mask &= lengths_behind_corners(paths, knife.swivel) <= lead
    if mask.any():
        other, _ = reverse_paths(paths, np.ones(len(paths), np.bool_))
        mask &= lengths_behind_corners(other, knife.swivel) > lead
    return mask


def _keep_waste_left(
    paths: Paths, source: I32, dieline: Dieline, rows: I32, waste: I8
) -> tuple[Paths, I32]:
    """Reverse the closed paths that have the waste on their right.

    ``source`` (n,): row in the dieline of each segment of the paths.
    ``rows``, ``waste`` (m,) and (m,): rows of cuts in the dieline, and the side of the waste of
    each cut: +1 left, -1 right, 0 none.
    Returns all paths, reversed or unchanged, and the row in the dieline of each segment of these
    paths.
    """
    side = np.zeros(len(dieline), np.int8)
    side[rows] = waste
    first = paths.first[:-1]
    # Closing a joint may have moved the start of a segment a little.
    away = np.hypot(*(paths.start[first][:, None] - dieline.ends[source[first]]).transpose(2, 0, 1))
    as_drawn = away[:, 0] <= away[:, 1]
    on_right = side[source[first]] == np.where(as_drawn, -1, 1)
    paths, segment = reverse_paths(paths, paths.closed & on_right)
    return paths, source[segment]


def _kinds_of_ends(
    paths: Paths, source: I32, dieline: Dieline, outline: BoardOutline
) -> tuple[U8, U8]:
    """Return the kinds of the starts and of the finishes of p paths, (p,) and (p,).

    ``source``: row in the dieline of each segment of the paths.
    ``outline``: outlines of the board and of its holes.
    """
    on_cut = _ends_on_cuts(paths, source, dieline)
    start, finish = end_kinds(paths, on_cut, End.JUNCTION)
    waste = np.zeros(2 * len(paths), np.bool_)
    rows = np.flatnonzero(on_cut)
    if len(rows):
        points, ahead = end_points(paths)[0][rows], -end_directions(paths)[rows]
        waste[rows] = ends_at_waste(points, ahead, outline)
    for kinds, at_waste in zip((start, finish), np.split(waste, 2), strict=True):
        kinds[at_waste & (kinds == End.JUNCTION)] = End.MEETS
    return start, finish


def _ends_on_cuts(paths: Paths, source: I32, dieline: Dieline) -> Bool:
    """Return the mask of the ends of p paths that lie on a through cut, (2p,).

    The path's own edge at this end is not counted, even if it is a through cut.  A closed path has
    no ends, so that its entries are False.  The mask has the
    starts of all paths first, then the finishes.  ``source`` is the row in the dieline of each
    segment of the paths.
    """
    points, segment = end_points(paths)
    on_cut = np.zeros(len(points), np.bool_)
    rows = np.flatnonzero(~np.tile(paths.closed, 2))
    if len(rows) == 0:
        return on_cut
    cut = np.flatnonzero(dieline.line_type == LineType.CUT)
    ends, bulge = dieline.ends[cut], dieline.bulge[cut]
    index = np.full(len(dieline), -1, np.int32)
    index[cut] = np.arange(len(cut))
    on_cut[rows] = find_points_on_segments(
        points[rows], index[source[segment[rows]]], ends[:, 0], ends[:, 1], bulge, GAP
    )
    return on_cut


def plan_perforations(dieline: Dieline, rows: I32, setup: Setup) -> list[Operation]:
    """Return the operations that cut edges of a dieline as perforations, with the board's dash
    length.

    Parameters
    ----------
    rows : (m,)
        Indices of the edges in the dieline.
    setup
        Machine, board and station of the knife.
    """
    paths, source = chain_edges(dieline, rows, ANGLE)
    dashes, segment = _split_into_dashes(paths, *setup.board.perforation)
    depth = np.full((len(segment), 1), setup.through_depth)
    ends = end_kinds(dashes, np.zeros(2 * len(dashes), np.bool_), End.FREE)
    operation = setup.operation(LineType.PERFORATION, dashes, source[segment], depth, ends)
    cuts = _Cuts(LineType.PERFORATION, rows, setup.through_depth)
    return _in_passes(operation, cuts, setup)


def _split_into_dashes(paths: Paths, cut: float, gap: float) -> tuple[Paths, I32]:
    """Split p perforated paths into dashes.

    Every perforated path starts and ends with a dash, so that the board tears from the path's ends.
    The dashes are ``cut`` mm long; the gaps between them are equal, and at most ``gap`` mm.

    Returns one path for each dash, and for each segment of these new paths the index of the segment
    in ``paths`` from which it comes.
    """
    length = paths.lengths
    count = np.maximum(1, np.ceil((length + gap) / (cut + gap) - 1e-9)).astype(np.int64)
    count = np.where(count * cut >= length, 1, count)
    spacing = (length - cut) / np.maximum(count - 1, 1)
    owner = np.repeat(np.arange(len(paths)), count)
    ordinal = np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)
    begin = ordinal * spacing[owner]
    size = np.where(count == 1, length, cut)[owner]
    repeated, rows = select_paths(paths, owner.astype(np.int32))
    left = np.maximum(length[owner] - begin - size, 0.0)
    dashes, segment = trim_ends(repeated, begin, left)
    return dashes, rows[segment].astype(np.int32)
