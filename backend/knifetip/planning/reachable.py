"""reachable: the stretches of each segment of a contour that the tool can reach.

    Paths, radius of a cutter on their left -> ReachableStretches, at most one per raw offset piece

A knife reaches everything.  A disc does not reach into inner corners, slots and necks that are
narrower than itself: it reaches a segment where ``offset.offset_paths`` keeps the offset of it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from knifetip.errors import CompensationError, GeometryError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.path import Paths
from knifetip.offset.offset_paths import offset_paths


class ReachableStretches(NamedTuple):
    """m stretches of segments, ordered by segment and position."""

    segment: I64  #: (m,)
    low: F64  #: (m,) mm from the segment's start
    high: F64  #: (m,) mm from the segment's start


def all_reachable(paths: Paths) -> ReachableStretches:
    """Return one stretch for each segment, over its whole length."""
    size = arc.length(paths.start, paths.end, paths.bulge)
    return ReachableStretches(np.arange(len(size)), np.zeros(len(size)), size)


def reachable_by_disc(paths: Paths, radius: float) -> ReachableStretches:
    """Return the stretches that a disc reaches from the left of paths which bound one region.

    Parameters
    ----------
    radius : mm
        Of the disc.

    Returns
    -------
    Of paths that have no offset, everything: compensation reports what is wrong with them.
    """
    group = np.where(paths.closed, 0, 1 + np.arange(len(paths)))
    try:
        offset = offset_paths(paths, radius, 1, group=group)
    except (CompensationError, GeometryError):
        return all_reachable(paths)
    row = np.flatnonzero(~offset.inserted)
    segment = offset.source[row].astype(np.int64)
    whole = paths.start[segment], paths.end[segment], paths.bulge[segment]
    size = arc.length(*whole)
    begin, end = (
        size * arc.nearest_fraction(*whole, points[row])
        for points in (offset.paths.start, offset.paths.end)
    )
    order = np.lexsort((begin, segment))
    return ReachableStretches(segment[order], begin[order], end[order])
