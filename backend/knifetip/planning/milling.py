"""milling: plan the operations of a router bit or a laser beam, which removes a disc of material.

Each layer of cuts gives up to two operations: first open cuts, then contours.  Beside a contour the
centre of the cutter runs in the waste: outside a part, inside a hole.  The waste is on the left of
travel, so the cutter runs clockwise round a part and counter-clockwise round a hole.  With a
spindle that turns clockwise this is climb cutting.  A slit, with one part on both its sides, is cut
on its line, and each side loses the cutter's radius.  So is an edge between two parts, unless the
disc would cut into one of them beyond the edge (``PlanError``).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from knifetip.errors import NoRoomForBridges, PlanError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.chain import chain
from knifetip.geometry.columns import F64, I8, I32, I64, Bool
from knifetip.geometry.path import Paths, reverse_paths, select_paths
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import JOIN
from knifetip.model.corners import AS_OTHERS, Corners
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import CutDepth
from knifetip.model.operation import End, Operation
from knifetip.model.tool import DiscTool
from knifetip.model.tool.base import equal_passes
from knifetip.planning.bridges import FEWEST, Spacing, ends_of_others, place_bridges
from knifetip.planning.chosen_bridges import bridges_on_paths
from knifetip.planning.contour_crossings import check_contour_crossings
from knifetip.planning.corners import distances_to_corners, find_bends, match_choices_to_bends
from knifetip.planning.cut_sides import cut_sides
from knifetip.planning.divided_contours import join_contours
from knifetip.planning.drawn_twice import explain_copies
from knifetip.planning.edge_corners import with_edge_corners
from knifetip.planning.facing_contours import merge_facing_layers, slit_layers
from knifetip.planning.last_cuts import releasing_cuts, track_levels
from knifetip.planning.layers import cut_layers
from knifetip.planning.milling_tools import check_facing_tools, cutter_radii, milling_tools
from knifetip.planning.path_ends import close_joints
from knifetip.planning.reachable import reachable_by_disc
from knifetip.planning.setup import Setup
from knifetip.topology.noding import split_at_ends

#: Cosine of the least angle between an edge that two parts share and an outline at its end (45°).
_SHALLOW: Final = 0.7072
#: Number of places at which such an edge is compared with the lines beside it.
_PLACES: Final = 17


def plan_milling(
    corners: Corners,
    dieline: Dieline,
    rows: I32,
    setup: Setup,
) -> list[Operation]:
    """Return the operations that mill cuts of a dieline, layer by layer from the innermost layer.

    Contours that touch at a point stay separate paths.

    Parameters
    ----------
    corners
        Corner type for all corners of the contours; ``apply_choices`` sets the types of single
        corners later.
    rows : (m,)
        Indices of the cuts in the dieline.
    setup
        Machine, board and station of the cutter.

    Raises
    ------
    PlanError
        The disc on an edge between two parts would cut into them elsewhere, or contours cross, or
        this is so because lines seem to be drawn twice.
    NoRoomForBridges
        A contour has no room for the bridges that the board requires, or a part of a blank that
        cuts divide would have too few of them.
    """
    board, radii = setup.board, cutter_radii(setup, rows)
    widest = float(radii.max())
    pieces = _divide_by_sides(dieline.ends[rows], dieline.bulge[rows])
    cuts = dieline.ends[rows], dieline.bulge[rows], rows
    try:
        _check_shared(pieces, rows, radii[pieces.row])
        check_contour_crossings(pieces.ends, pieces.bulge, pieces.removed, rows[pieces.row])
    except PlanError as error:
        raise explain_copies(error, *cuts, board.caliper) from None
    ends, bulge = pieces.ends, pieces.bulge
    layers = cut_layers(ends, bulge, pieces.face, contours_whole=True)
    sides = pieces.waste, pieces.removed
    face, layer = join_contours(ends, bulge, *sides, pieces.face, layers.number, widest)
    tools = milling_tools(setup, rows[pieces.row], face)
    tool = tools.of_piece
    group = layer * (int(face.max()) + 2) + face
    chains = chain(ends, bulge, group=group * len(tools.setups) + tool)
    paths = close_joints(chains.paths(ends, bulge))
    source, part = rows[pieces.row[chains.order]], pieces.face[chains.order]
    number = layer[chains.order][chains.first[:-1]]
    path_tool = tool[chains.order][chains.first[:-1]]
    avoid = ends_of_others(dieline, rows[np.unique(pieces.row[pieces.waste != 0])])
    flip = np.where(chains.flipped, -1, 1)
    waste = (flip * pieces.waste[chains.order])[paths.first[:-1]]
    # On a closed path with a part on either side, one of the parts would lose its whole edge.
    bounds = (pieces.removed[chains.order] != 0)[paths.first[:-1]]
    inside = paths.closed & (waste == 0) & bounds
    ring = paths.closed & (waste == 0) & ~bounds
    if ring.any():
        shared = _shared_error(source[ring[paths.path_of]], widest)
        raise explain_copies(shared, *cuts, board.caliper)
    side = np.where(inside, np.where(paths.areas > 0.0, 1, -1), waste)
    # All contours have the cutter on the left of travel.
    paths, order = reverse_paths(paths, side < 0)
    source, part = source[order], part[order]
    milled = paths.closed & (side != 0)
    check_facing_tools(tools, paths, path_tool, milled, source)
    number = merge_facing_layers(paths, number, milled, 2.0 * widest)
    number = slit_layers(paths, number, milled, side == 0, widest)
    operations = []
    track = np.empty(len(layer), np.int64)
    track[chains.order] = np.repeat(np.arange(len(paths)), np.diff(paths.first))
    level = track_levels(layer, layers.stretches, track, paths.lengths)
    # Contours of one layer have one offset, which keeps the cutter out of all of them.
    level[milled] = 0
    # Levels are less than the number of cuts.
    path_rank = (2 * (number.max(initial=0) - number) + np.abs(side)) * len(layer) + level
    # The tracks of lower ranks are made first.
    releasing = releasing_cuts(-path_rank[track], layers.stretches)[chains.order][order]
    endable = releasing | ~np.logical_or.reduceat(releasing, paths.first[:-1])[paths.path_of]
    for rank, which in np.unique(np.column_stack([path_rank, path_tool]), axis=0).tolist():
        own_setup = tools.setups[which]
        cutter = own_setup.station.tool
        assert isinstance(cutter, DiscTool)
        path_rows = np.flatnonzero((path_rank == rank) & (path_tool == which)).astype(np.int32)
        subset, segment_rows = select_paths(paths, path_rows)
        end = np.where(subset.closed, End.CLOSED, End.FREE).astype(np.uint8)
        # The contours that face these ones are one layer higher or lower, or have another cutter.
        apart = np.abs(number - number[path_rows[0]])
        facing = milled & ((apart == 1) | ((apart == 0) & (path_tool != which)))
        obstacles, _ = select_paths(paths, np.flatnonzero(facing).astype(np.int32))
        held = subset.closed & (waste[path_rows] != 0)
        own_source = source[segment_rows]
        bridges = _bridge_positions(subset, held, own_setup, cutter, own_source, avoid)
        if len(bridges) and not setup.bridges:
            _check_divided(bridges, subset, part[segment_rows], own_source)
        depths = _depths_of_paths(subset, own_source, cutter, own_setup)
        operation = own_setup.operation(
            LineType.CUT, subset, own_source, depths[subset.path_of], (end, end)
        )
        x, y = setup.machine.carriage_of(own_setup.station).axes[:2]
        operation = replace(
            operation,
            clearance=cutter.clearance(setup.machine.clearance),
            side=int(rank // len(layer) % 2),
            bridges=bridges,
            endable=endable[segment_rows],
            obstacles=obstacles,
            corner=corners.type,
            k=corners.k,
            interference=corners.interference,
            acceleration=min(x.acceleration, y.acceleration),
            deflection=next(
                ((d.x, d.y) for d in board.deflection if d.tool == own_setup.station.name),
                (0.0, 0.0),
            ),
        )
        operations.append(with_edge_corners(operation, setup.chosen))
    return operations


def _depths_of_paths(paths: Paths, source: I32, cutter: DiscTool, setup: Setup) -> F64:
    """Return the depth of each pass of p paths of n segments, (p, k) mm.

    A path with fewer than k passes has NaN after its last one.  ``source`` (n,) is the index in the
    dieline of the edge of each segment.

    Raises ``PlanError``: different passes are chosen for the edges of a path.
    """
    usual = cutter.passes(setup.through_depth)
    if CutDepth not in setup.chosen:
        return np.tile(usual, (len(paths), 1))
    chosen = setup.chosen[CutDepth].numbers("passes", 0.0).astype(np.int64)[source]
    passes = chosen[paths.first[:-1]]
    for row in np.flatnonzero(chosen != passes[paths.path_of])[:1]:
        other = source[paths.first[paths.path_of[row]]]
        raise PlanError(
            "depth.several", edge=other, other=source[row], at_edges=[other, source[row]]
        )
    count = np.where(passes > 0, passes, len(usual))
    result = np.full((len(paths), int(count.max(initial=1))), np.nan)
    for number in np.unique(passes):
        own = usual if number == 0 else equal_passes(setup.through_depth, int(number))
        result[passes == number, : len(own)] = own
    return result


def _bridge_positions(
    paths: Paths,
    selected: Bool,
    setup: Setup,
    cutter: DiscTool,
    source: I32,
    avoid: F64,
) -> F64:
    """Return the index of the segment on which each of k bridges lies, the position of the bridge
    on that segment, and its width, (k, 3).

    The position is the distance from the start of the segment to the middle of the bridge (mm).
    At both ends of a bridge, the disc cuts one radius farther than the centre of the disc travels.
    Therefore the gaps in the path of the centre are longer than the bridges by two radii.

    ``selected`` (p,): mask of the paths that get bridges.
    ``source`` (n,): index in the dieline of the edge of each segment, for error messages.
    ``avoid`` (m, 2) mm: positions from which bridges keep away, if possible.
    """
    board = setup.board
    closed = np.flatnonzero(selected)
    placed = bridges_on_paths(setup.bridges, paths, source, cutter.radius, closed)
    if board.bridge_width > 0.0 and board.bridge_spacing > 0.0:
        gap = board.bridge_width + 2.0 * cutter.radius
        # A slot narrower than two discs is cleared completely from its other side.
        room = reachable_by_disc(paths, 2.0 * cutter.radius)
        automatic = selected & ~np.isin(np.arange(len(paths)), placed.path)
        path, distance = place_bridges(
            paths, automatic, Spacing(gap, board.bridge_spacing), source, avoid, room
        )
        placed = placed.merged_with(path, distance, board.bridge_width)
    reached = np.cumsum(arc.length(paths.start, paths.end, paths.bulge))
    before = np.concatenate([[0.0], reached])
    position = before[paths.first[:-1][placed.path]] + placed.along
    segment = np.clip(
        np.searchsorted(reached, position),
        paths.first[placed.path],
        paths.first[placed.path + 1] - 1,
    )
    return np.column_stack([segment, position - before[segment], placed.width])


def _check_divided(bridges: F64, paths: Paths, part: I64, source: I32) -> None:
    """Raise ``NoRoomForBridges`` if a part of a blank that cuts divide has too few bridges.

    ``bridges`` (k, 3): as returned by ``_bridge_positions``.
    ``paths``: the contours, with n segments.
    ``part``, ``source`` (n,) and (n,): the part beside each segment, and the index in the dieline
    of its edge.
    """
    owner = paths.path_of
    count = np.bincount(part[bridges[:, 0].astype(np.int64)], minlength=int(part.max()) + 1)
    is_bridged = np.isin(owner, owner[bridges[:, 0].astype(np.int64)])
    for segment in np.flatnonzero(is_bridged & (count[part] < FEWEST))[:1].tolist():
        raise NoRoomForBridges(
            "bridges.divided-blank",
            edge=source[segment],
            count=count[part[segment]],
            fewest=FEWEST,
            at_edges=np.unique(source[is_bridged & (part == part[segment])]),
        )


def apply_choices(
    operations: list[Operation], corners: Corners, placement: tuple[float, float]
) -> list[Operation]:
    """Return all operations, with the corner types that the user chose for single corners.

    ``corners`` contains the choices, in coordinates of the drawing, whose origin lies at
    ``placement`` (mm) on the sheet.  Only operations that mill contours are changed.

    Raises
    ------
    PlanError
        A choice is invalid or is near no corner.
    """
    milling = [
        isinstance(operation.tool, DiscTool) and operation.side != 0 for operation in operations
    ]
    contours = [
        find_bends(operation.paths, operation.side)
        for operation, is_milling in zip(operations, milling, strict=True)
        if is_milling
    ]
    nearest = distances_to_corners(corners, placement, contours)
    if len(nearest) == 0:
        return operations
    result, bend = [], iter(contours)
    for operation, is_milling in zip(operations, milling, strict=True):
        if is_milling:
            kind, k = match_choices_to_bends(corners, placement, nearest, next(bend))
            of_edges = kind == AS_OTHERS
            operation = replace(
                operation,
                corner_at=np.where(of_edges, operation.corner_at, kind),
                k_at=np.where(of_edges, operation.k_at, k),
            )
        result.append(operation)
    return result


@dataclass(frozen=True, eq=False, slots=True)
class _Pieces:
    """q pieces of cuts, each with the same sides along its whole length."""

    row: I64  #: (q,) index of the cut of each piece
    ends: F64  #: (q, 2, 2) mm
    bulge: F64  #: (q,)
    waste: I8  #: (q,) side of the waste: +1 left, -1 right, 0 none
    removed: I8  #: (q,) side without board, as in ``CutSides``
    face: I64  #: (q,) number of the part or hole that the piece bounds, -1 for none
    shared: Bool  #: (q,) the piece lies between two parts


def _divide_by_sides(ends: F64, bulge: F64) -> _Pieces:
    """Return the pieces of n cuts between which the sides of the cuts change.

    One part of a cut may be the outline, and another part a slit between two flaps.

    ``ends``, ``bulge`` (n, 2, 2) mm and (n,): start and end points, and bulges, of the cuts.
    """
    piece_ends, piece_bulge, row = split_at_ends(ends, bulge)
    sides = cut_sides(piece_ends, piece_bulge)
    new = np.ones(len(row), np.bool_)
    new[1:] = np.diff(row) > 0
    for column in (sides.waste, sides.removed, sides.face, sides.shared):
        new[1:] |= column[1:] != column[:-1]
    first = np.flatnonzero(new)
    last = np.append(first[1:], len(row))[: len(first)] - 1
    turn = np.add.reduceat(np.arctan(piece_bulge), first) if len(first) else np.zeros(0)
    kept = row[first]
    whole = np.bincount(kept, minlength=len(bulge))[kept] == 1
    joined = np.stack([piece_ends[first, 0], piece_ends[last, 1]], axis=1)
    return _Pieces(
        kept,
        np.where(whole[:, None, None], ends[kept], joined),
        np.where(whole, bulge[kept], np.tan(turn)),
        sides.waste[first],
        sides.removed[first],
        sides.face[first],
        sides.shared[first],
    )


def _check_shared(pieces: _Pieces, rows: I32, radius: F64) -> None:
    """Raise ``PlanError`` if the disc on an edge between two parts would cut into a part elsewhere.

    It may if only a part of the edge is shared, if an outline continues the edge or leaves its end
    at less than 45°, or if an outline that does not end there is nearer to the edge than the radius
    of the disc.

    ``rows``: indices in the dieline of the cuts.
    ``radius`` (q,) mm: radius of the cutter of each piece.
    """
    shared = np.flatnonzero(pieces.shared)
    if len(shared) == 0:
        return
    # Where lines of several outlines lie on each other, only a part of an edge is shared.
    partly = np.isin(pieces.row[shared], pieces.row[~pieces.shared])
    if partly.any():
        raise _shared_error(rows[pieces.row[shared[partly]]], radius[shared[partly]].max())
    ends, bulge = pieces.ends, pieces.bulge
    boxes = arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge)
    one, other = box_pairs(boxes[shared], boxes, float(radius.max()))
    one = shared[one]
    keep = one != other
    one, other = one[keep], other[keep]
    ahead, last = arc.tangents(ends[:, 0], ends[:, 1], bulge)
    # The directions in which the pieces leave their two ends.
    leaving = np.stack([unit_vectors(ahead), -unit_vectors(last)], axis=1)
    gap = ends[one][:, :, None] - ends[other][:, None]
    meet = np.hypot(gap[..., 0], gap[..., 1]) <= JOIN
    cosine = np.einsum("kia,kja->kij", leaving[one], leaving[other])
    is_bound = (pieces.removed[other] != 0)[:, None, None]
    bad = (meet & (np.abs(cosine) > _SHALLOW) & (is_bound | (cosine > 0.0))).any(axis=(1, 2))
    apart = np.flatnonzero(~meet.any(axis=(1, 2)) & is_bound[:, 0, 0])
    for share in np.linspace(0.0, 1.0, _PLACES):
        start, end = ends[one[apart], 0], ends[one[apart], 1]
        point = arc.point_at(start, end, bulge[one[apart]], np.full(len(apart), share))
        facing = ends[other[apart], 0], ends[other[apart], 1], bulge[other[apart]]
        nearest = arc.point_at(*facing, arc.nearest_fraction(*facing, point))
        bad[apart] |= np.hypot(*(nearest - point).T) < radius[one[apart]]
    if bad.any():
        raise _shared_error(rows[pieces.row[one[bad]]], radius[one[bad]].max())


def _shared_error(rows: I32, radius: float) -> PlanError:
    """Return the error for edges between two parts, whose indices in the dieline are ``rows``.

    ``radius`` mm: radius of the cutter.
    """
    edges = np.unique(rows)
    return PlanError(
        "milling.shared-edge",
        edge=edges[0],
        diameter=2.0 * float(radius),
        at_edges=edges,
    )
