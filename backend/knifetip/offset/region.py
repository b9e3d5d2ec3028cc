"""region: offset one region with all its contours, if trimming its paths one by one is not enough.

Every path is offset as if it were alone.  All moved segments are split at their intersections,
pieces nearer to a contour than the radius are removed, and the remaining pieces are connected.  The
offset of a region consists of no path, one path or several paths.

Source: our derivation.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.geometry.intersect import point_at_parameter, write_box
from knifetip.geometry.spatial_index.box_tree import BoxTree, build_tree, new_stack
from knifetip.kernels import (
    F64_2,
    I32_1,
    kernel,
)
from knifetip.offset.clearance import DISTANCE_TOLERANCE, distance_to_row, is_clear, nearest_segment
from knifetip.offset.raw_region import (
    region_corners,
    region_paths,
    write_far_side,
    write_raw_region,
)
from knifetip.offset.raw_segments import (
    DOES_NOT_FIT,
    NO_FAILURE,
    NOT_CLOSED,
)
from knifetip.offset.records import (
    Contours,
    CornerTypes,
    JoinedPieces,
    RawRows,
    RegionCorners,
    RegionOffset,
    RegionPaths,
    ResultChains,
)
from knifetip.offset.self_contact import Scratch, any_segments_meet
from knifetip.offset.slices import drop_copies, find_cuts, follow_pieces, link_chains, split_rows
from knifetip.offset.swept_area import area_under_edge, area_under_path

#: Positions on a piece at which its distance from the contours is tested, as fractions of its
#: length.  Where two contours touch, a piece that lies beyond the other contour is at the radius
#: from it at one point, which is the middle in symmetric drawings.
_PROBES: Final = (0.5, 0.31, 0.77)
#: The same for the start of a piece.
_START: Final = (0.0, 0.0, 0.0)


@kernel
def _build_tree(rows: F64_2, count: int) -> BoxTree:
    """Return a tree of the bounding boxes of the first ``count`` segments in ``rows``.

    ``rows`` (n, 5) are segments: x0, y0, x1, y1, bulge.
    """
    boxes = np.empty((count, 4))
    for i in range(count):
        write_box(rows, i, boxes, i)
    return build_tree(boxes)


@kernel
def _failure(code: int, row: int, other_row: int, depth: float) -> RegionOffset:
    """Return the ``RegionOffset`` of a region that could not be offset.

    ``code``: failure code, a constant of ``raw_segments``.
    ``row``, ``other_row``: the two contour segments concerned.
    ``depth`` mm: depth by which the tool would cut into the contour.
    """
    line = np.empty((0, 5))
    tag = np.empty((0, 4), np.int64)
    return RegionOffset(
        line, tag, np.zeros(1, np.int64), 0, 0.0, False, code, row, other_row, depth
    )


@kernel
def _select_pieces(
    contours: Contours,
    paths: RegionPaths,
    raw: RawRows,
    pieces: JoinedPieces,
    corners: RegionCorners,
    signed: float,
    refuse: bool,
    lost: int,
) -> tuple[int, int, float]:
    """Write to ``pieces.good`` which pieces are valid: not nearer to a contour than the radius.

    ``contours``, ``paths``, ``corners``: input contours, the paths of the region, and the corners
    of the region.
    ``raw``: the rows of which the pieces are parts.
    ``signed`` mm: radius of the tool, positive left of travel.
    ``refuse``: whether to find the position at which the tool would cut deepest into a contour.
    ``lost``: a contour segment that has no offset, or -1.
    Returns row, other_row, depth: of use only if ``refuse`` is true: the contour segment along
    which the tool, at one position, would cut deepest into a contour; the contour segment into
    which it would cut there; and the depth of this cut (mm).  They are -1, -1 and 0 if the tool
    fits everywhere.
    """
    size = abs(signed)
    limit = size - DISTANCE_TOLERANCE
    origin, source = corners.origin, corners.source
    total = len(source)
    piece, owner, opening, touched, good, _, _ = pieces
    rows, info, follow = raw
    tree, stack = _build_tree(origin, total), new_stack()
    worst = 0.0
    worst_row = lost
    worst_other = lost
    if lost >= 0:
        worst = size - abs(_arc_radius(contours, lost))
    for q in range(len(good)):
        i = owner[q]
        runs_on = not refuse and q > 0 and q == opening[i] and follow[i - 1] == i
        if runs_on and not touched[i, 0] and not touched[i - 1, 1]:
            # Pieces change between valid and invalid only at intersections.
            good[q] = good[q - 1]
            continue
        m = info[i, 3]
        mine = paths.begin[m] + info[i, 0] - contours.first[paths.member[m]]
        places = _PROBES
        if corners.kind[mine] > 0 and info[i, 1] and (i == 0 or info[i - 1, 0] != info[i, 0]):
            # A transition of type C or D may leave the area that is too near to a contour on the
            # far side of the contour.  Its start is at the radius from the corner's vertex.  If
            # the start is clear, no contour lies between the two.
            places = _START
        good[q] = True
        x = y = 0.0
        for place in places:
            x, y = point_at_parameter(rows, i, piece[q, 4] + place * (piece[q, 5] - piece[q, 4]))
            # Most invalid pieces are too close to the next segments: test these first.
            for near in range(max(mine - 2, 0), min(mine + 3, total)):
                good[q] &= distance_to_row(origin, near, x, y) >= limit
            good[q] &= good[q] and is_clear(x, y, tree, stack, signed, limit, corners)
            if not good[q]:
                break
        if refuse and not good[q]:
            other_row, away = nearest_segment(x, y, origin, tree, stack, size, mine)
            ordinary = (
                other_row == corners.previous[mine] or corners.previous[other_row] == mine
            ) and (piece[q, 4] > 0.0 or piece[q, 5] < 1.0)
            if not ordinary and size - away > worst:
                worst = size - away
                worst_row = info[i, 0]
                worst_other = source[other_row]
    return worst_row, worst_other, worst


@kernel
def _replace_obstructed(raw: RawRows, pieces: JoinedPieces, corners: CornerTypes) -> bool:
    """Change type C or D to B at obstructed corners, and return whether any corner is changed.

    A corner is obstructed if its transition, the tool's path round the corner, has a common point
    with another segment of the offset, or is nearer to a contour than the tool's radius.  Without
    the change, parts of the transition or parts of other offset segments would be left out.

    ``raw``: the segments of the region, which the pieces are parts of.
    ``corners``: types of the transitions; changed in place.
    """
    touched, good = pieces.touched, pieces.good
    changed = False
    for q in range(len(good)):
        i = pieces.owner[q]
        corner = corners.step * raw.info[i, 0]
        if raw.info[i, 1] == 0 or corners.kind[corner] == 0:
            continue
        whole = pieces.piece[q, 4] == 0.0 and pieces.piece[q, 5] == 1.0
        if not (whole and good[q]) or touched[i, 0] or touched[i, 1]:
            corners.kind[corner] = 0
            changed = True
    return changed


@kernel
def _swept_area(
    contours: Contours,
    paths: RegionPaths,
    signed: float,
    out: ResultChains,
    chains: int,
    scratch: Scratch,
) -> tuple[float, bool, int, float]:
    """Return twice the area inside the edge that a tool leaves when its centre follows chains.

    A chain is torn if it is open although it comes from a closed path; then no area is computed.

    ``contours``, ``paths``: input contours, and the paths of the region.
    ``signed`` mm: radius of the tool, positive left of travel.
    ``out``, ``chains``: segments of the chains, which are paths of the tool's centre, and the
    number of chains.
    Returns ``swept`` mm²: twice the signed area, summed over all chains; 0 if a chain is torn;
    overlaps: whether a part of the area is counted twice; torn, length: index of the first torn
    chain, and its length (mm); -1 and 0 if no chain is torn.
    """
    line, tag, bounds, ring = out
    count = len(paths.member)
    last = np.empty((count, 2))
    for m in range(count):
        if paths.begin[m] < paths.begin[m + 1]:
            last[m, 0] = contours.start[contours.first[paths.member[m]], 0]
            last[m, 1] = contours.start[contours.first[paths.member[m]], 1]
    swept = 0.0
    corner_arcs = np.empty((bounds[chains] + chains, 5))
    arc_row = 0
    for c in range(chains):
        m = tag[bounds[c], 2]
        if not ring[c] and paths.closed[m]:
            length = 0.0
            for r in range(bounds[c], bounds[c + 1]):
                length += math.hypot(line[r, 2] - line[r, 0], line[r, 3] - line[r, 1])
            return 0.0, False, c, length
        begin = (last[m, 0], last[m, 1])
        area, x, y, arc_row = area_under_edge(
            out, c, contours.start, signed, begin, corner_arcs, arc_row
        )
        swept += area
        if not ring[c]:
            last[m, 0] = x
            last[m, 1] = y
    for m in range(count):
        if paths.begin[m] < paths.begin[m + 1] and not paths.closed[m]:
            x = contours.end[contours.first[paths.member[m] + 1] - 1, 0]
            y = contours.end[contours.first[paths.member[m] + 1] - 1, 1]
            swept += last[m, 0] * y - last[m, 1] * x
    # If these arcs meet, some area was counted twice.
    overlaps: bool = (
        chains > 0
        and bool(ring[:chains].all())
        and arc_row > 1
        and any_segments_meet(
            corner_arcs[:arc_row, :2].copy(),
            corner_arcs[:arc_row, 2:4].copy(),
            corner_arcs[:arc_row, 4].copy(),
            scratch,
        )
    )
    return swept, overlaps, -1, 0.0


@kernel
def offset_region(
    contours: Contours,
    members: I32_1,
    signed: float,
    corners: CornerTypes,
    refuse: bool,
    scratch: Scratch,
) -> RegionOffset:
    """Return the offset of one region with all its contours, or why it could not be offset.

    Parameters
    ----------
    contours
        All input contours.
    members
        Numbers of the contours that bound the region.
    signed : mm
        Radius of the tool, positive left of travel.
    corners
        Types of the transitions at the corners.  Type C or D becomes B, in place, at each corner
        whose transition meets another part of the offset or comes too near to a contour.
    refuse
        Whether a position where the tool does not fit is a failure; otherwise the parts of the
        offset where the tool does not fit are left out.
    scratch
        Scratch arrays.
    """
    paths = region_paths(contours, members)
    count = len(paths.member)
    total = paths.begin[count]
    room = 8 * total + 4 * count + 8
    raw = RawRows(np.empty((room, 5)), np.empty((room, 4), np.int64), np.empty(room, np.int64))
    path_area = 0.0
    for m in range(count):
        a, b = contours.first[paths.member[m]], contours.first[paths.member[m] + 1]
        path_area += area_under_path(contours.start, contours.end, contours.bulge, a, b)
    stack = new_stack()
    while True:
        region = region_corners(contours, paths, corners)
        real, lost, code, row = write_raw_region(
            contours, paths, signed, corners, region.segments, raw, scratch.pair
        )
        if code != NO_FAILURE:
            return _failure(code, row, row, 0.0)
        row_count = real
        for m in range(count):
            if paths.begin[m] < paths.begin[m + 1] and not paths.closed[m]:
                a, b = contours.first[paths.member[m]], contours.first[paths.member[m] + 1]
                row_count = write_far_side(contours, a, b, signed, raw, row_count)
        tree = _build_tree(raw.rows, row_count)
        cut_row, cut_point, cuts = find_cuts(raw, row_count, real, tree, stack, scratch.crossings)
        piece, owner, opening, touched, piece_count = split_rows(
            raw.rows, real, cut_row, cut_point, cuts
        )
        pieces = JoinedPieces(
            piece,
            owner,
            opening,
            touched,
            np.empty(piece_count, np.bool_),
            np.empty(piece_count, np.int64),
            np.empty(piece_count, np.int64),
        )
        row, other_row, depth = _select_pieces(
            contours, paths, raw, pieces, region, signed, refuse, lost
        )
        if not region.capped or not _replace_obstructed(raw, pieces, corners):
            break
    if refuse and row >= 0:
        return _failure(DOES_NOT_FIT, row, other_row, depth)
    follow_pieces(pieces, raw.follow)
    out = ResultChains(
        np.empty((piece_count + 1, 5)),
        np.empty((piece_count + 1, 4), np.int64),
        np.empty(piece_count + 1, np.int64),
        np.empty(piece_count + 1, np.bool_),
    )
    chains = link_chains(raw, pieces, out)
    swept, overlaps, torn, length = _swept_area(contours, paths, signed, out, chains, scratch)
    if torn >= 0 and drop_copies(raw.rows, pieces):
        follow_pieces(pieces, raw.follow)
        chains = link_chains(raw, pieces, out)
        swept, overlaps, torn, length = _swept_area(contours, paths, signed, out, chains, scratch)
    if torn >= 0:
        return _failure(NOT_CLOSED, out.tag[out.bounds[torn], 0], 0, length)
    unreached = 0.5 * (path_area - swept)
    if signed < 0.0:
        unreached = -unreached
    for r in range(out.bounds[chains]):
        out.tag[r, 2] = paths.member[out.tag[r, 2]]
    return RegionOffset(
        out.line, out.tag, out.bounds, chains, unreached, overlaps, NO_FAILURE, 0, 0, 0.0
    )


@kernel
def _arc_radius(contours: Contours, i: int) -> float:
    """Return the radius of the arc in contour segment i (mm)."""
    start, end = contours.start, contours.end
    b = abs(contours.bulge[i])
    chord = math.hypot(end[i, 0] - start[i, 0], end[i, 1] - start[i, 1])
    size: float = chord * (1.0 + b * b) / (4.0 * b)
    return size


@kernel
def unreached_area(
    contours: Contours, members: I32_1, signed: float, region: RegionOffset, scratch: Scratch
) -> float:
    """Return the area of a region that the tool cannot reach (mm²).

    The offset of the region is offset back by the radius; the area is between the contours and this
    second offset.  If the second offset fails, ``region.unreached`` is returned.

    Parameters
    ----------
    contours
        All input contours.
    members
        Numbers of the contours that bound the region.
    signed : mm
        Radius of the tool, positive left of travel.
    region
        The offset of the region.
    scratch
        Scratch arrays.
    """
    rows = region.bounds[region.chains]
    back = Contours(
        region.line[:rows, :2].copy(),
        region.line[:rows, 2:4].copy(),
        region.line[:rows, 4].copy(),
        region.bounds[: region.chains + 1].astype(np.int32),
    )
    corners = CornerTypes(np.zeros(1, np.uint8), np.zeros(1), 0)
    paths = np.arange(region.chains).astype(np.int32)
    edge = offset_region(back, paths, -signed, corners, False, scratch)
    if edge.code != NO_FAILURE:
        return region.unreached
    path_area = 0.0
    for path in members:
        path_area += area_under_path(
            contours.start,
            contours.end,
            contours.bulge,
            contours.first[path],
            contours.first[path + 1],
        )
    size = edge.bounds[edge.chains]
    path_area -= area_under_path(
        edge.line[:size, :2].copy(),
        edge.line[:size, 2:4].copy(),
        edge.line[:size, 4].copy(),
        0,
        size,
    )
    return 0.5 * math.copysign(path_area, path_area * signed)
