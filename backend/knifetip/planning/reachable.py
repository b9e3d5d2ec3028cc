"""reachable: find the stretches of a contour's segments that the tool can reach.

A knife reaches every point of a contour.  A disc does not reach into inner corners, slots and necks
that are narrower than itself.  ``offset.offset_paths`` computes the path of the disc's centre; this
path leaves out the places into which the disc does not fit.  The disc reaches each point of the
contour whose distance from the path of the centre is the radius.
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
    """m stretches of segments that a tool can reach, ordered by segment and by position on it."""

    segment: I64  #: (m,)
    low: F64  #: (m,) mm from the segment's start
    high: F64  #: (m,) mm from the segment's start


def all_reachable(paths: Paths) -> ReachableStretches:
    """Return one stretch for each segment of the paths, over the entire length of the segment."""
    size = arc.length(paths.start, paths.end, paths.bulge)
    return ReachableStretches(np.arange(len(size)), np.zeros(len(size)), size)


def reachable_by_disc(paths: Paths, radius: float) -> ReachableStretches:
    """Return the stretches of paths that a disc on the left of the paths can touch.

    The closed paths bound one region.  If the paths cannot be offset, all segments are returned
    entirely, because compensation reports the error later.

    Parameters
    ----------
    radius : mm
        Radius of the disc.
    """
    group = np.where(paths.closed, 0, 1 + np.arange(len(paths)))
    try:
        offset = offset_paths(paths, radius, 1, group=group)
    except (CompensationError, GeometryError):
        return all_reachable(paths)
    row = np.flatnonzero(~offset.inserted)
    segment = offset.source[row].astype(np.int64)
    segments = paths.start[segment], paths.end[segment], paths.bulge[segment]
    size = arc.length(*segments)
    begin, end = (
        size * arc.nearest_fraction(*segments, points[row])
        for points in (offset.paths.start, offset.paths.end)
    )
    order = np.lexsort((begin, segment))
    return ReachableStretches(segment[order], begin[order], end[order])
