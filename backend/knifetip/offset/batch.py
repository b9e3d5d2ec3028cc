"""batch: offset large batches of paths on all cores.

Regions are independent, so each core offsets a contiguous run of regions, and the offset paths are
concatenated.  They equal the offset paths that one core computes, bit for bit.  If several regions
fail, the failure of the first region is returned.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I32, U8
from knifetip.geometry.parallel import core_count, parallel_map
from knifetip.geometry.path import Paths
from knifetip.offset.groups import offset_groups
from knifetip.offset.raw_segments import NO_FAILURE
from knifetip.offset.records import Contours, CornerTypes, OffsetGroups

#: Smallest number of segments worth handing to another core.
_MIN_SEGMENTS: Final = 10_000


def offset_on_all_cores(
    paths: Paths, member: I32, group_first: I32, signed: F64, corner: U8, k: F64, refuse: bool
) -> Any:
    """Return the offsets of all groups of paths as a tuple of columns, computed on all cores.

    The paths of a group bound one region, such as an outline with its holes.  The result equals
    that of ``groups.offset_groups``, which runs on one core.

    Parameters
    ----------
    paths : Paths
        p contours with n segments.
    member : (p,)
        Path numbers in the order of their groups.
    group_first : (g + 1,)
        Position in ``member`` at which each of g groups begins; the last entry is p.
    signed : (p,) mm
        Radius of the tool for each path, positive if the tool is left of travel.
    corner, k : (n,) each, or (1,) each if all corners are of type B
        Type of the transition at the start of each segment, and the parameter k of type D.  Type C
        or D becomes B, in place, at each corner whose transition meets another part of the offset
        or comes too near to a contour.
    refuse
        Whether a position where the tool does not fit is a failure.

    """
    runs = _split_groups(paths.first, member, group_first, core_count())

    contours = Contours(paths.start, paths.end, paths.bulge, paths.first)
    corners = CornerTypes(corner, k, 0 if len(corner) == 1 else 1)

    def offset_run(run: I32) -> Any:
        return offset_groups(contours, OffsetGroups(member, run, signed), corners, refuse)

    parts = parallel_map(offset_run, runs)
    if len(parts) == 1:
        return parts[0]
    columns = [np.concatenate(column) for column in zip(*(part[:5] for part in parts), strict=True)]
    first_rows = np.cumsum([0, *(len(part[2]) for part in parts)])
    first = np.concatenate(
        [[0], *(part[5][1:] + offset for part, offset in zip(parts, first_rows, strict=False))]
    ).astype(np.int32)
    owner = np.concatenate([part[6] for part in parts])
    unreached = np.sum([part[7] for part in parts], axis=0)
    failure = next((part[8] for part in parts if part[8][0] != NO_FAILURE), parts[0][8])
    return (*columns, first, owner, unreached, failure)


def _split_groups(first: I32, member: I32, group_first: I32, number: int) -> list[I32]:
    """Split the groups of paths into at most ``number`` runs with nearly equal numbers of segments.

    ``first`` (p + 1,): first segment of each path.
    ``member`` (p,): path numbers in the order of their groups.
    ``group_first`` (g + 1,): position in ``member`` at which each group begins; the last entry is
    p.
    Returns list of arrays: for each run, the positions in ``member`` at which its groups begin,
    then the end of its last group.
    """
    segments_before = np.append(0, np.cumsum(np.diff(first)[member]))[group_first]
    count = int(min(number, segments_before[-1] // _MIN_SEGMENTS, len(group_first) - 1))
    if count < 2:
        return [group_first]
    cuts = np.searchsorted(segments_before, segments_before[-1] * np.arange(1, count) / count)
    bounds = np.unique([0, *cuts.tolist(), len(group_first) - 1]).tolist()
    return [group_first[a : b + 1] for a, b in pairwise(bounds)]
