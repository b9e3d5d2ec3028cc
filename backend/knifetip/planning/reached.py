"""Reached: how much of each segment of a contour the tool comes to.

    Paths, radius of a cutter that stands left of them -> Reached, at most one row to a piece

A knife comes everywhere.  A disc stays out of inner corners, slots and necks that are narrower than
it is; where its centre runs beside a segment is what ``geometry.offset`` says.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from knifetip.errors import CompensationError, GeometryError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.offset import equidistant
from knifetip.geometry.path import Paths


class Reached(NamedTuple):
    """Stretches of segments, by segment and place."""

    segment: I64  #: (m,)
    low: F64  #: (m,) mm from the segment's start
    high: F64  #: (m,)


def everywhere(paths: Paths) -> Reached:
    """Return all segments, whole."""
    size = arc.length(paths.start, paths.end, paths.bulge)
    return Reached(np.arange(len(size)), np.zeros(len(size)), size)


def by_disc(paths: Paths, radius: float) -> Reached:
    """Return what a disc of ``radius`` mm comes to, left of paths that bound one region.

    Of contours that make no sense it is all: whoever compensates them says what is wrong.
    """
    group = np.where(paths.closed, 0, 1 + np.arange(len(paths)))
    try:
        beside = equidistant(paths, radius, 1, group=group)
    except (CompensationError, GeometryError):
        return everywhere(paths)
    row = np.flatnonzero(~beside.inserted)
    segment = beside.source[row].astype(np.int64)
    whole = paths.start[segment], paths.end[segment], paths.bulge[segment]
    ways = beside.paths
    size = arc.length(*whole)
    begin, end = (size * arc.nearest(*whole, place) for place in (ways.start[row], ways.end[row]))
    order = np.lexsort((begin, segment))
    return Reached(segment[order], begin[order], end[order])
