"""Operations of a router, without a plan."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.model.dieline import LineType
from knifetip.model.operation import End, Operation
from knifetip.model.tool import Cutter

ROUTER = Cutter(radius=3.0, feed=9000.0, plunge=1500.0, speed=18000.0)


def contour(
    *points: F64 | tuple[float, float],
    bulge: list[float] | None = None,
    side: int = -1,
    r: float = 3.0,
    **changes: Any,
) -> Operation:
    """Return an operation that mills one closed contour through some corners.

    Parameters
    ----------
    bulge
        Bulges of the edges, None for a polygon.
    side
        Side of the cutter: 1 for left of travel, -1 for right.
    r
        Radius of the cutter (mm).
    """
    xy = np.array(points, float)
    count = len(xy)
    bent = np.zeros(count) if bulge is None else np.asarray(bulge, float)
    plain = Operation(
        paths=Paths(xy, np.roll(xy, -1, axis=0), bent, np.array([0, count])),
        line_type=LineType.CUT, tool=replace(ROUTER, radius=r), station=4,
        depth=np.full((count, 1), 2.3), caliper=2.0, clearance=2.0, feed=9000.0, plunge=1500.0,
        swivel=0.0, end_clearance=0.0, overcut=0.0, short_crease="press",
        start=np.array([End.CLOSED], np.uint8), finish=np.array([End.CLOSED], np.uint8),
        source=np.arange(count, dtype=np.int32), side=side,
        acceleration=8000.0,
    )  # fmt: skip
    return replace(plain, **changes)
