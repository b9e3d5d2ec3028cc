"""The blanks of a drawing as JSON data: their areas and outlines."""

from __future__ import annotations

from typing import Any

import shapely
from shapely import Polygon
from shapely.geometry.polygon import LinearRing

#: Decimals of lengths (mm) and areas (mm²).
_DECIMALS = 3


def blanks_as_json(blanks: list[Polygon]) -> dict[str, Any]:
    """Return blanks as JSON data (mm and mm²).

    Each outline is a list of points (x, y), counter-clockwise; each hole runs clockwise.  The first
    point is not repeated at the end.
    """
    rows = [_as_json(shapely.orient_polygons(blank)) for blank in blanks]
    return {
        "area": round(sum(blank.area for blank in blanks), _DECIMALS),
        "blanks": rows,
    }


def _as_json(blank: Polygon) -> dict[str, Any]:
    low_x, low_y, high_x, high_y = blank.bounds
    return {
        "area": round(blank.area, _DECIMALS),
        "bounds": [round(value, _DECIMALS) for value in (low_x, low_y, high_x, high_y)],
        "outline": _points(blank.exterior),
        "holes": [_points(hole) for hole in blank.interiors],
    }


def _points(ring: LinearRing) -> list[list[float]]:
    points: list[list[float]] = shapely.get_coordinates(ring)[:-1].round(_DECIMALS).tolist()
    return points
