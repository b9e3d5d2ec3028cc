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

    #: bounding box; its minimum exceeds its maximum if the region is empty, and it is unbounded if
    #: a coordinate is not finite
    box: Box = field(init=False)
    is_rectangle: bool = field(init=False)  #: whether the region is its bounding box, or is empty

    def __post_init__(self) -> None:
        box: Box = math.inf, math.inf, -math.inf, -math.inf
        if len(self.edges):
            points = self.edges.reshape(-1, 2)
            low_x, low_y = points.min(axis=0).tolist()
            high_x, high_y = points.max(axis=0).tolist()
            box = low_x, low_y, high_x, high_y
            if not all(map(math.isfinite, box)):
                box = UNBOUNDED
        object.__setattr__(self, "box", box)
        object.__setattr__(self, "is_rectangle", not len(self.edges) or self._is_rectangle())

    def _is_rectangle(self) -> bool:
        if len(self.edges) != 4 or len(self.even_odd) != 1:
            return False
        side = np.abs(self.edges[:, 1] - self.edges[:, 0]).tolist()
        if not all(min(one) <= _PARALLEL * max(one) for one in side):
            return False
        first, second, third, fourth = (one[0] > one[1] for one in side)
        return bool(first == third != second == fourth)


def union(regions: Sequence[Region]) -> Region:
    """Return the union of regions; it is empty if there are none."""
    if len(regions) <= 1:
        return regions[0] if regions else Region()
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
        if region.is_rectangle or any(one is region for one in self.regions):
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
