"""inner_fit: find where a shape lies in an area, as low as possible and then as far left."""

from __future__ import annotations

from typing import Final

import numpy as np
import shapely
from shapely import Polygon

from knifetip.geometry.columns import F64

#: Distance by which a shape may extend over the area, since its corners are rounded (mm).
_ROUNDING: Final = 1e-6
#: Most positions that are tried.
_MOST: Final = 500
#: Most corners of an outline or an area that is used as it is.
_FEW: Final = 16
#: Half of the distance by which those with more corners are made simpler (mm).
_SIMPLER: Final = 0.2


def simpler_inside(area: shapely.Geometry) -> shapely.Geometry:
    """Return an area with few corners within an area, at most 0.4 mm from its sides."""
    if shapely.get_num_coordinates(area) <= _FEW:
        return area
    simple = shapely.simplify(shapely.buffer(area, -_SIMPLER, join_style="mitre"), _SIMPLER)
    return simple if simple.is_valid and area.covers(simple) else area


def simpler_around(outline: Polygon) -> Polygon:
    """Return a polygon without holes with few corners that contains an outline, at most 0.4 mm from
    its sides; corners may be farther away.
    """
    if shapely.get_num_coordinates(outline) <= _FEW:
        return outline
    wide = Polygon(shapely.buffer(outline, _SIMPLER, join_style="mitre").exterior)
    simple = shapely.simplify(wide, _SIMPLER)
    return simple if simple.is_valid and simple.covers(outline) else outline


def lowest_position(area: shapely.Geometry, corners: F64) -> F64 | None:
    """Return the shift that moves a shape into an area, (2,) mm; None if none is found.

    Of the shifts that are found it is the one with the least y, and of these with the least x.

    Parameters
    ----------
    area
        Polygon or polygons, with or without holes (mm).
    corners : (k, 2) mm
        Corners of the outline of the shape, a polygon without holes.

    Notes
    -----
    A shift moves all corners of the convex hull into the area if it lies in the intersection of the
    area moved by the negative of each corner.  For convex shapes in convex areas all such shifts
    are good; in general, the corners of the intersection are tried.
    """
    low, high = corners.min(axis=0), corners.max(axis=0)
    left, below, right, above = area.bounds
    if high[0] - low[0] > right - left or high[1] - low[1] > above - below:
        return None
    hull = shapely.get_coordinates(shapely.convex_hull(shapely.multipoints(corners)))[:-1]
    shifts = area
    for corner in hull:
        moved = shapely.transform(area, lambda points, corner=corner: points - corner)
        shifts = shapely.intersection(shifts, moved) if shifts is not area else moved
        if shifts.is_empty:
            return None
    tried = np.unique(shapely.get_coordinates(shifts)[:, ::-1], axis=0)[:_MOST, ::-1]
    wide = shapely.buffer(area, _ROUNDING, join_style="mitre")
    shapely.prepare(wide)
    good = np.flatnonzero(shapely.covers(wide, shapely.polygons(corners + tried[:, None])))
    return tried[good[0]] if len(good) else None
