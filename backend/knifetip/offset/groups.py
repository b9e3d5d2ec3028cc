"""groups: offset all groups of paths, one after the other, into columns.

    all paths, and the groups that bound a region together -> columns of the results

Closed paths are trimmed in one pass; groups that need more are passed to ``region``.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.geometry.boxes import Scratch
from knifetip.kernels import kernel
from knifetip.offset.raw_segments import COLUMNS, FINE, move_segments
from knifetip.offset.records import (
    Contours,
    CornerTypes,
    MovedSegments,
    OffsetChains,
    OffsetGroups,
    OffsetSegments,
    RegionOffset,
)
from knifetip.offset.region import offset_region, unreached_area
from knifetip.offset.transition import MOST
from knifetip.offset.trim import offset_simple


@kernel
def _grown_segments(out: OffsetSegments, used: int, wanted: int) -> OffsetSegments:
    """Return the segments with room for ``wanted`` rows, of which ``used`` are kept."""
    if wanted <= len(out.bulge):
        return OffsetSegments(out.start, out.end, out.bulge, out.source, out.inserted)
    size = 2 * wanted
    start = np.empty((size, 2))
    end = np.empty((size, 2))
    bulge = np.empty(size)
    source = np.empty(size, np.int32)
    inserted = np.empty(size, np.bool_)
    # Row by row: an assignment of slices takes seconds to compile.
    for i in range(used):
        start[i, 0], start[i, 1] = out.start[i, 0], out.start[i, 1]
        end[i, 0], end[i, 1] = out.end[i, 0], out.end[i, 1]
        bulge[i], source[i], inserted[i] = out.bulge[i], out.source[i], out.inserted[i]
    return OffsetSegments(start, end, bulge, source, inserted)


@kernel
def _grown_chains(chains: OffsetChains, wanted: int) -> OffsetChains:
    """Return the chains with room for ``wanted``."""
    size = len(chains.owner)
    if wanted <= size:
        return OffsetChains(chains.first, chains.owner, chains.unreached)
    while size < wanted:
        size *= 2
    first = np.empty(size, np.int32)
    owner = np.empty(size, np.int32)
    for i in range(len(chains.owner)):
        first[i], owner[i] = chains.first[i], chains.owner[i]
    return OffsetChains(first, owner, chains.unreached)


@kernel
def _copy_path(
    contours: Contours,
    path: int,
    out: OffsetSegments,
    done: int,
    chains: OffsetChains,
    count: int,
) -> int:
    """Copy a path unchanged, for a tool without radius; return the next free row."""
    chains.first[count] = done
    chains.owner[count] = path
    for i in range(contours.first[path], contours.first[path + 1]):
        out.start[done, 0], out.start[done, 1] = contours.start[i, 0], contours.start[i, 1]
        out.end[done, 0], out.end[done, 1] = contours.end[i, 0], contours.end[i, 1]
        out.bulge[done] = contours.bulge[i]
        out.source[done] = i
        out.inserted[done] = False
        done += 1
    return done


@kernel
def _copy_region(
    region: RegionOffset, out: OffsetSegments, done: int, chains: OffsetChains, count: int
) -> int:
    """Write the chains of a region in the order of their paths; return the next free row."""
    line, tag, bounds = region.line, region.tag, region.bounds
    for c in np.argsort(tag[bounds[: region.chains], 2], kind="mergesort"):
        chains.first[count] = done
        chains.owner[count] = tag[bounds[c], 2]
        count += 1
        for r in range(bounds[c], bounds[c + 1]):
            out.start[done, 0] = line[r, 0]
            out.start[done, 1] = line[r, 1]
            out.end[done, 0] = line[r, 2]
            out.end[done, 1] = line[r, 3]
            out.bulge[done] = line[r, 4]
            out.source[done] = tag[r, 0]
            out.inserted[done] = tag[r, 1] == 1
            done += 1
    return done


@kernel
def offset_groups(
    contours: Contours, groups: OffsetGroups, corners: CornerTypes, refuse: bool
) -> Any:
    """Return start, end, bulge, source, inserted, first, owner, unreached, and a failure.

    With ``refuse`` the first place where the tool does not fit is a failure; otherwise it is
    omitted.
    """
    first, member, members, signed = contours.first, groups.member, groups.bounds, groups.signed
    count = len(first) - 1
    most = 0
    for p in range(count):
        most = max(most, first[p + 1] - first[p])
    segments = MovedSegments(np.empty((most, COLUMNS)), np.empty(most, np.int64))
    boxes = np.empty((4, 2 * (MOST + 1) * most))
    scratch = Scratch(np.empty((4, 5)), np.empty((4, 4)))
    size = 2 * len(contours.bulge) + (MOST + 1) * most + 256
    out = OffsetSegments(
        np.empty((size, 2)),
        np.empty((size, 2)),
        np.empty(size),
        np.empty(size, np.int32),
        np.empty(size, np.bool_),
    )
    result = OffsetChains(
        np.empty(count + 16, np.int32), np.empty(count + 16, np.int32), np.zeros(count)
    )
    failure = (FINE, 0, 0, 0.0)
    done = 0
    chains = 0
    group = 0
    while True:
        result = _grown_chains(result, chains + len(members) - group)
        group, done, chains = offset_simple(
            contours, groups, group, corners, segments, boxes, scratch, out, done, result, chains
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
        if done + (MOST + 1) * rows > len(out.bulge):
            # The room may have been too small: try again.
            out = _grown_segments(out, done, done + (MOST + 1) * rows)
            if len(paths) == 1:
                group -= 1
                continue
        if signed[path] == 0.0:
            for path in paths:
                a, b = first[path], first[path + 1]
                if a == b:
                    continue
                code, row = move_segments(contours, a, b, 0.0, segments.table, 0)
                if code != FINE:
                    failure = (code, row, row, 0.0)
                    break
                result = _grown_chains(result, chains + 2)
                done = _copy_path(contours, path, out, done, result, chains)
                chains += 1
            if failure[0] != FINE:
                break
            continue
        region = offset_region(contours, paths, signed[path], corners, refuse, scratch)
        if region.code != FINE:
            failure = (region.code, region.row, region.other, region.depth)
            break
        area = region.unreached
        if region.overlaps:
            area = unreached_area(contours, paths, signed[path], region, scratch)
        result.unreached[path] = max(area, 0.0)
        if region.chains == 0:
            continue
        out = _grown_segments(out, done, done + region.bounds[region.chains])
        result = _grown_chains(result, chains + region.chains + 1)
        done = _copy_region(region, out, done, result, chains)
        chains += region.chains
    result.first[chains] = done
    return (
        out.start[:done],
        out.end[:done],
        out.bulge[:done],
        out.source[:done],
        out.inserted[:done],
        result.first[: chains + 1],
        result.owner[:chains],
        result.unreached,
        failure,
    )
