"""groups: offset groups of paths one after the other, and append the offsets to common columns.

A group of one closed path is offset by trimming neighbouring segments.  If trimming is not enough,
and for all other groups, ``region`` computes the offset, which keeps the tool out of all contours
of the group.  For a tool without radius, the paths are copied.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.kernels import I32_1, kernel
from knifetip.offset.raw_segments import COLUMNS, NO_FAILURE, move_segments
from knifetip.offset.records import (
    Contours,
    CornerTypes,
    MovedSegments,
    OffsetChains,
    OffsetGroups,
    OffsetProgress,
    OffsetSegments,
    RegionOffset,
    empty_segments,
)
from knifetip.offset.region import offset_region, unreached_area
from knifetip.offset.self_contact import Scratch
from knifetip.offset.transition import MAX_SEGMENTS
from knifetip.offset.trim import offset_simple


@kernel
def _reserve_segments(out: OffsetSegments, row_count: int, capacity: int) -> OffsetSegments:
    """Return ``out``, or a larger copy of it, with space for ``capacity`` rows.

    The first ``row_count`` rows are kept.
    """
    if capacity <= len(out.bulge):
        return OffsetSegments(out.start, out.end, out.bulge, out.source, out.inserted)
    larger = empty_segments(2 * capacity)
    # Copied row by row, since an assignment of slices takes seconds to compile.
    for i in range(row_count):
        larger.start[i, 0], larger.start[i, 1] = out.start[i, 0], out.start[i, 1]
        larger.end[i, 0], larger.end[i, 1] = out.end[i, 0], out.end[i, 1]
        larger.bulge[i] = out.bulge[i]
        larger.source[i] = out.source[i]
        larger.inserted[i] = out.inserted[i]
    return larger


@kernel
def _reserve_chains(chains: OffsetChains, capacity: int) -> OffsetChains:
    """Return ``chains``, or a larger copy of it, with space for ``capacity`` chains.

    All rows of ``chains`` are kept.
    """
    size = len(chains.owner)
    if capacity <= size:
        return OffsetChains(chains.first, chains.owner, chains.unreached)
    while size < capacity:
        size *= 2
    first = np.empty(size, np.int32)
    owner = np.empty(size, np.int32)
    for i in range(len(chains.owner)):
        first[i], owner[i] = chains.first[i], chains.owner[i]
    return OffsetChains(first, owner, chains.unreached)


@kernel(allocates=False)
def _copy_paths(
    contours: Contours,
    paths: I32_1,
    segments: MovedSegments,
    out: OffsetSegments,
    segment_count: int,
    chains: OffsetChains,
    chain_count: int,
) -> tuple[int, int, int, int]:
    """Append paths unchanged to the output columns, for a tool without radius.

    Stops at the first path that has a segment without length or with a coordinate that is not a
    number.  Paths without segments are omitted.

    ``contours``, ``paths``: input contours, and the indices in them of the paths to append.
    ``segments``: scratch rows for the moved segments of one path.
    ``out``, ``segment_count``: columns for the segments of all offsets, and the number of segments
    written before.
    ``chains``, ``chain_count``: columns for the chains of all offsets, and the number of chains
    written before.
    Returns segment_count, chain_count: number of segments and number of chains written so far,
    including those before the call; code, segment: ``NO_FAILURE`` or another failure code of
    ``raw_segments``, and the contour segment that failed.
    """
    for path in paths:
        low, high = contours.first[path], contours.first[path + 1]
        if low == high:
            continue
        code, row = move_segments(contours, low, high, 0.0, segments.table, 0)
        if code != NO_FAILURE:
            return segment_count, chain_count, code, row
        chains.first[chain_count] = segment_count
        chains.owner[chain_count] = path
        chain_count += 1
        for i in range(low, high):
            out.start[segment_count, 0], out.start[segment_count, 1] = (
                contours.start[i, 0],
                contours.start[i, 1],
            )
            out.end[segment_count, 0], out.end[segment_count, 1] = (
                contours.end[i, 0],
                contours.end[i, 1],
            )
            out.bulge[segment_count] = contours.bulge[i]
            out.source[segment_count] = i
            out.inserted[segment_count] = False
            segment_count += 1
    return segment_count, chain_count, NO_FAILURE, 0


@kernel
def _copy_region(
    region: RegionOffset,
    out: OffsetSegments,
    segment_count: int,
    chains: OffsetChains,
    chain_count: int,
) -> int:
    """Append the offset of a region to the output columns; return the next free row of ``out``.

    The chains of the region are appended in the order of their paths.

    ``region``: offset of one region, as connected chains of segments.
    ``out``, ``segment_count``: columns for the segments of all offsets, and the number of segments
    written before.
    ``chains``, ``chain_count``: columns for the chains of all offsets, and the number of chains
    written before.
    """
    line, tag, bounds = region.line, region.tag, region.bounds
    for c in np.argsort(tag[bounds[: region.chains], 2], kind="mergesort"):
        chains.first[chain_count] = segment_count
        chains.owner[chain_count] = tag[bounds[c], 2]
        chain_count += 1
        for r in range(bounds[c], bounds[c + 1]):
            out.start[segment_count, 0] = line[r, 0]
            out.start[segment_count, 1] = line[r, 1]
            out.end[segment_count, 0] = line[r, 2]
            out.end[segment_count, 1] = line[r, 3]
            out.bulge[segment_count] = line[r, 4]
            out.source[segment_count] = tag[r, 0]
            out.inserted[segment_count] = tag[r, 1] == 1
            segment_count += 1
    return segment_count


@kernel
def offset_groups(
    contours: Contours, groups: OffsetGroups, corners: CornerTypes, refuse: bool
) -> Any:
    """Return the offsets of all groups of contours as columns, and the first failure.

    The contours of a group bound one region, such as an outline with its holes.

    Parameters
    ----------
    contours
        The p input paths.
    groups
        The paths ordered by group, and the signed radius of the tool for each path.
    corners
        Types of the transitions at the corners of the paths.  Type C or D becomes B, in place, at
        each corner whose transition meets another part of the offset or comes too near to a
        contour.
    refuse
        True if a position where the tool does not fit is a failure; otherwise parts of the offset
        where the tool does not fit are left out.

    Returns
    -------
    start, end, bulge, source, inserted : (n, 2), (n, 2) mm, (n,) each
        Segments of the offsets, as in ``OffsetPaths``.
    first, owner : (q + 1,), (q,)
        First segment of each of q offset paths, and its input path.
    unreached : (p,) mm²
        Area beside each input path that the tool cannot reach.
    failure
        Failure code, the two contour segments concerned, and the depth by which the tool would cut
        into the contour (mm).  The code is a constant of ``raw_segments``, ``NO_FAILURE`` if all
        groups were offset.
    """
    first, member, members, signed = contours.first, groups.member, groups.bounds, groups.signed
    path_count = len(first) - 1
    longest = 0
    for p in range(path_count):
        longest = max(longest, first[p + 1] - first[p])
    segments = MovedSegments(np.empty((longest, COLUMNS)), np.empty(longest, np.int64))
    boxes = np.empty((4, 2 * (MAX_SEGMENTS + 1) * longest))
    scratch = Scratch(np.empty((4, 5)), np.empty((4, 4)), boxes)
    size = 2 * len(contours.bulge) + (MAX_SEGMENTS + 1) * longest + 256
    out = empty_segments(size)
    result = OffsetChains(
        np.empty(path_count + 16, np.int32),
        np.empty(path_count + 16, np.int32),
        np.zeros(path_count),
    )
    failure = (NO_FAILURE, 0, 0, 0.0)
    segment_count = 0
    chain_count = 0
    group = 0
    while True:
        result = _reserve_chains(result, chain_count + len(members) - group)
        progress = OffsetProgress(group, segment_count, chain_count)
        group, segment_count, chain_count = offset_simple(
            contours, groups, corners, segments, scratch, out, result, progress
        )
        if group == len(members) - 1:
            break
        paths = member[members[group] : members[group + 1]]
        group += 1
        rows = 0
        for path in paths:
            rows += first[path + 1] - first[path]
        if rows == 0:
            continue
        path = paths[0]
        if segment_count + (MAX_SEGMENTS + 1) * rows > len(out.bulge):
            # ``offset_simple`` may have stopped for lack of rows: try the group again with more.
            out = _reserve_segments(out, segment_count, segment_count + (MAX_SEGMENTS + 1) * rows)
            if len(paths) == 1:
                group -= 1
                continue
        if signed[path] == 0.0:
            result = _reserve_chains(result, chain_count + len(paths) + 1)
            segment_count, chain_count, code, row = _copy_paths(
                contours, paths, segments, out, segment_count, result, chain_count
            )
            if code != NO_FAILURE:
                failure = (code, row, row, 0.0)
                break
            continue
        region = offset_region(contours, paths, signed[path], corners, refuse, scratch)
        if region.code != NO_FAILURE:
            failure = (region.code, region.row, region.other_row, region.depth)
            break
        area = region.unreached
        if region.overlaps:
            area = unreached_area(contours, paths, signed[path], region, scratch)
        result.unreached[path] = max(area, 0.0)
        if region.chains == 0:
            continue
        out = _reserve_segments(out, segment_count, segment_count + region.bounds[region.chains])
        result = _reserve_chains(result, chain_count + region.chains + 1)
        segment_count = _copy_region(region, out, segment_count, result, chain_count)
        chain_count += region.chains
    result.first[chain_count] = segment_count
    return (
        out.start[:segment_count],
        out.end[:segment_count],
        out.bulge[:segment_count],
        out.source[:segment_count],
        out.inserted[:segment_count],
        result.first[: chain_count + 1],
        result.owner[:chain_count],
        result.unreached,
        failure,
    )
