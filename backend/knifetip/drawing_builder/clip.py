"""Clip regions: the visible areas to which clip paths and masks of SVG and PDF files limit objects.

A ``Clip`` is the intersection of one rectangle with sides along the axes and of several regions.  A
``Region`` is the union of filled paths, whose curves are replaced by chords.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Final, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I64, Bool

#: min x, min y, max x, max y (file units).
Box = tuple[float, float, float, float]
UNBOUNDED: Final[Box] = (-math.inf, -math.inf, math.inf, math.inf)

#: Largest number of regions of a clip; the cost of clipping grows with it.
_MAX_REGIONS: Final = 16
#: Sides count as parallel to an axis if they deviate by less than this fraction of their length.
_PARALLEL: Final = 1e-9


@dataclass(frozen=True, eq=False, slots=True)
class Region:
    """The union of filled paths: m edges of their outlines, in file units."""

    edges: F64 = field(default_factory=lambda: np.zeros((0, 2, 2)))  #: (m, 2, 2)
    part: I64 = field(default_factory=lambda: np.zeros(0, np.int64))  #: (m,) path, ascending
    #: (parts,) whether a path is filled by the even-odd rule, not by the nonzero rule
    even_odd: Bool = field(default_factory=lambda: np.zeros(0, np.bool_))

    @property
    def box(self) -> Box:
        """The bounding box of the region; its minimum exceeds its maximum if the region is empty.

        The box is unbounded if a coordinate is not finite.
        """
        if not len(self.edges):
            return math.inf, math.inf, -math.inf, -math.inf
        if not np.isfinite(self.edges).all():
            return UNBOUNDED
        x, y = self.edges[:, :, 0], self.edges[:, :, 1]
        return float(x.min()), float(y.min()), float(x.max()), float(y.max())

    def is_rectangle(self) -> bool:
        """Return whether the region is one rectangle with sides along the axes, or is empty."""
        if len(self.edges) != 4 or len(self.even_odd) != 1:
            return not len(self.edges)
        side = np.abs(self.edges[:, 1] - self.edges[:, 0])
        narrow = side.min(axis=1) <= _PARALLEL * side.max(axis=1)
        turned = np.argmax(side, axis=1)
        return bool(narrow.all() and turned[0] == turned[2] != turned[1] == turned[3])


def union(regions: Sequence[Region]) -> Region:
    """Return the union of regions; it is empty if there are none."""
    if not regions:
        return Region()
    first = np.cumsum([0, *(len(one.even_odd) for one in regions)])
    return Region(
        np.concatenate([one.edges for one in regions]),
        np.concatenate([one.part + start for one, start in zip(regions, first, strict=False)]),
        np.concatenate([one.even_odd for one in regions]),
    )


class Clip(NamedTuple):
    """The visible area of an object: the intersection of a rectangle and of regions."""

    box: Box = UNBOUNDED
    regions: tuple[Region, ...] = ()
    #: whether the file clips the object in a way that is not supported
    incomplete: bool = False

    def intersect_box(self, box: Box) -> Clip:
        """Return the part of the clip that lies in a rectangle with sides along the axes."""
        return self._replace(box=intersect(self.box, box))

    def intersect(self, region: Region) -> Clip:
        """Return the part of the clip that lies in a region.

        Of too many regions only the bounding box is used, and the result is incomplete.
        """
        inside = self.intersect_box(region.box)
        if region.is_rectangle() or any(one is region for one in self.regions):
            return inside
        if len(self.regions) == _MAX_REGIONS or region.box == UNBOUNDED:
            return inside._replace(incomplete=True)
        return inside._replace(regions=(*self.regions, region))


UNCLIPPED: Final = Clip()


def intersect(first: Box, second: Box) -> Box:
    """Return the intersection of two boxes: min x, min y, max x and max y.

    If the intersection is empty, a minimum of the returned box is greater than its maximum.
    """
    return (
        max(first[0], second[0]),
        max(first[1], second[1]),
        min(first[2], second[2]),
        min(first[3], second[3]),
    )
