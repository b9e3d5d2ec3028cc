"""A layout as JSON data: where its copies lie, which overlap, and how much board they use."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import shapely

from knifetip.layout.collisions import OffSheet, Overlap
from knifetip.layout.compose import Copy
from knifetip.model.layout import Layout

#: Decimals of lengths (mm) and areas (mm²).
_DECIMALS: Final = 3


def layout_json(
    layout: Layout,
    copies: Sequence[Copy],
    areas: Sequence[shapely.Geometry],
    overlaps: Sequence[Overlap],
    off_sheet: Sequence[OffSheet],
) -> dict[str, Any]:
    """Return the result of composing a layout as JSON data (mm, mm²); copies count from 1."""
    area = float(sum(one.area for one in areas))
    whole = layout.sheet.width * layout.sheet.height
    return {
        "copies": [
            {
                "placed": copy.placed,
                "box": [round(float(value), _DECIMALS) for value in copy.box],
                "turn": copy.position.turn,
                "mirror": copy.position.mirror,
            }
            for copy in copies
        ],
        "overlaps": [
            {
                "copies": [pair.copy + 1, pair.other + 1],
                "area": round(pair.area, _DECIMALS),
            }
            for pair in overlaps
        ],
        "off_sheet": [
            {"number": one.copy + 1, "distance": round(one.distance, _DECIMALS)}
            for one in off_sheet
        ],
        "area": round(area, _DECIMALS),
        "use": round(100.0 * area / whole, 2),
    }
