"""collisions: find the blanks on a sheet that overlap or extend over its edge.

The blanks are polygons of shapely, which deviate from arcs by at most 0.02 mm.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import shapely
from shapely import Polygon

from knifetip.layout.compose import Copy, placement_matrix
from knifetip.model.layout import LayoutSheet

#: Least area in which two blanks overlap (mm²): cuts that two blanks share are no overlap.
_LEAST: Final = 1.0
#: Distance by which a blank may extend over the edge of the sheet (mm).
_SLACK: Final = 0.05
#: Distance by which a gap between two blanks may be too narrow (mm).
_NARROWER: Final = 0.005


@dataclass(frozen=True, slots=True)
class Overlap:
    """Two copies on a sheet that overlap."""

    copy: int  #: index of one copy
    other: int  #: index of the other copy, which is greater
    area: float  #: mm²


@dataclass(frozen=True, slots=True)
class OffSheet:
    """A copy that extends over the edge of the sheet."""

    copy: int  #: index of the copy
    distance: float  #: mm


def place_blanks(
    copies: Sequence[Copy], blanks: Sequence[Sequence[Polygon]]
) -> list[shapely.Geometry]:
    """Return the area of each copy on the sheet (mm).

    Parameters
    ----------
    copies
        The copies.
    blanks
        The blanks of each source, see ``find_blanks``.
    """
    joined = [shapely.union_all(one) for one in blanks]
    return [_placed_area(joined[copy.source], copy) for copy in copies]


def _placed_area(area: shapely.Geometry, copy: Copy) -> shapely.Geometry:
    """Return the area of a drawing at the position of a copy."""
    matrix = placement_matrix(copy.position.turn, mirror=copy.position.mirror)
    return shapely.transform(area, lambda points: points @ matrix + copy.shift)


def find_overlaps(areas: Sequence[shapely.Geometry]) -> list[Overlap]:
    """Return the pairs of copies that overlap, in the order of the copies."""
    tree = shapely.STRtree(areas)
    one, other = tree.query(list(areas), predicate="intersects")
    ahead = one < other
    one, other = one[ahead], other[ahead]
    shared = shapely.area(
        shapely.intersection(np.array(areas, object)[one], np.array(areas, object)[other])
    )
    found = [
        Overlap(a, b, area)
        for a, b, area in zip(one.tolist(), other.tolist(), shared.tolist(), strict=True)
        if area > _LEAST
    ]
    return sorted(found, key=lambda pair: (pair.copy, pair.other))


def find_narrow_gaps(areas: Sequence[shapely.Geometry], gap: float) -> list[tuple[int, int]]:
    """Return the pairs of copies whose distance is less than a gap, in the order of the copies.

    Parameters
    ----------
    areas
        The area of each copy.
    gap
        Least distance (mm); 0 for none.
    """
    least = gap - _NARROWER
    if least <= 0.0:
        return []
    one, other = shapely.STRtree(areas).query(list(areas), predicate="dwithin", distance=least)
    ahead = one < other
    return sorted(zip(one[ahead].tolist(), other[ahead].tolist(), strict=True))


def find_off_sheet(copies: Sequence[Copy], sheet: LayoutSheet) -> list[OffSheet]:
    """Return the copies that extend over the edge of the sheet."""
    return find_off_window(copies, (0.0, 0.0, sheet.width, sheet.height))


def find_off_window(
    copies: Sequence[Copy], window: tuple[float, float, float, float]
) -> list[OffSheet]:
    """Return the copies that extend over the edge of a window of the sheet.

    Parameters
    ----------
    copies
        The copies.
    window : mm
        x min, y min, x max, y max.
    """
    low_x, low_y, high_x, high_y = np.array([copy.box for copy in copies]).T
    left, below, right, above = window
    over = np.maximum.reduce([left - low_x, below - low_y, high_x - right, high_y - above])
    return [OffSheet(copy, float(over[copy])) for copy in np.flatnonzero(over > _SLACK).tolist()]
