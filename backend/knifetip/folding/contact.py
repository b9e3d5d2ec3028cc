"""contact: how two flat panels lie in space to each other: crossing, touching or on each other.

The panels are compared by their middle faces.  For two panels in planes that cross, each is moved
to coordinates (τ, s): τ runs along the line in which the planes cross, and s is the distance from
that line within the panel.  Both panels have the same τ, so that what they share is an interval.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np
import shapely
from shapely import Polygon

from knifetip.geometry.columns import F64

#: Largest angle between panels that lie on each other (°), and its cosine.
FLAT: Final = 5.0
_PARALLEL: Final = math.cos(math.radians(FLAT))
#: Sine of the least angle at which panels cross (0.5°).
_CROSSING: Final = math.sin(math.radians(0.5))
#: Cosine of the angle between the directions of two flaps that point to each other (120°).
_FACING: Final = -0.5


@dataclass(frozen=True, eq=False, slots=True)
class Plate:
    """The middle face of a folded panel."""

    outline: Polygon  #: in the drawing (mm)
    #: outline without the surroundings of its slits and holes, through which others may reach
    closed: shapely.Geometry
    placed: F64  #: (4, 4) transform of the flat board
    height: float  #: z of the middle face in the flat board (mm)
    #: (2, 2) middle of the fold of a flap and unit vector away from it; None for other panels
    flap: F64 | None

    @property
    def normal(self) -> F64:
        """Unit vector from the bottom face to the top face, (3,)."""
        return self.placed[:3, 2]

    @property
    def origin(self) -> F64:
        """Place of the point of the middle face at x = y = 0, (3,)."""
        return self.placed[:3, 2] * self.height + self.placed[:3, 3]


class Crossing(NamedTuple):
    """Two panels that touch or cross: how far each reaches to both sides of the other (mm)."""

    reach: tuple[tuple[float, float], tuple[float, float]]  #: s of each panel, lowest and highest
    hinge: tuple[float | None, float | None]  #: s of the fold of each panel that is a flap
    places: tuple[tuple[float, float], tuple[float, float]]  #: on each panel, in the drawing (mm)
    angle: float  #: between the planes of the panels, 0 … 90°

    @property
    def through(self) -> tuple[float, float]:
        """How far each panel reaches to both sides of the other, the lesser of both (mm)."""
        (low, high), (other_low, other_high) = self.reach
        return min(-low, high), min(-other_low, other_high)


def crossings(one: Plate, other: Plate, margin: float) -> list[Crossing]:
    """Return where two panels touch or cross over more than a margin (mm); none if parallel."""
    across = np.cross(one.normal, other.normal)
    sine = float(np.linalg.norm(across))
    if sine < _CROSSING:
        return []
    angle = math.degrees(math.atan2(sine, abs(float(one.normal @ other.normal))))
    frames = [
        _frame(mine, theirs, across / sine, sine) for mine, theirs in ((one, other), (other, one))
    ]
    moved = [
        shapely.transform(plate.closed, lambda points, frame=frame: points @ frame[:2].T + frame[2])
        for plate, frame in zip((one, other), frames, strict=True)
    ]
    found = []
    for low, high in _shared_intervals(moved[0], moved[1], margin):
        reach = [_reach(area, low, high) for area in moved]
        hinge = [
            None if plate.flap is None else float((frame[:2] @ plate.flap[0] + frame[2])[1])
            for plate, frame in zip((one, other), frames, strict=True)
        ]
        middle = np.array([(low + high) / 2.0, 0.0])
        places = [tuple((frame[:2].T @ (middle - frame[2])).tolist()) for frame in frames]
        found.append(
            Crossing((reach[0], reach[1]), (hinge[0], hinge[1]), (places[0], places[1]), angle)
        )
    return found


def facing_overlap(one: Plate, other: Plate, distance: float) -> float:
    """Return how far two flaps that point to each other lie on each other (mm), 0 if they do not.

    ``distance`` (mm) is the greatest distance of their middle faces.
    """
    if one.flap is None or other.flap is None:
        return 0.0
    if abs(float(one.normal @ other.normal)) < _PARALLEL:
        return 0.0
    if abs(float(one.normal @ (other.origin - one.origin))) > distance:
        return 0.0
    directions = [plate.placed[:3, :2] @ plate.flap[1] for plate in (one, other)]  # type: ignore[index]  # both have flaps
    if float(directions[0] @ directions[1]) > _FACING:
        return 0.0
    # The other flap in the plane of the first, with its direction as the first coordinate.
    basis = np.column_stack([directions[0], np.cross(one.normal, directions[0])])
    shared = shapely.intersection(*(_projected(plate, basis) for plate in (one, other)))
    low_x, low_y, high_x, high_y = shared.bounds if not shared.is_empty else (0.0,) * 4
    return float(min(high_x - low_x, high_y - low_y))


def _projected(plate: Plate, basis: F64) -> shapely.Geometry:
    matrix, origin = plate.placed[:3, :2].T @ basis, plate.origin @ basis
    return shapely.transform(plate.outline, lambda points: points @ matrix + origin)


def _frame(mine: Plate, theirs: Plate, along: F64, sine: float) -> F64:
    """Return the map to (τ, s) of a panel: rows of its matrix, then the shift, (3, 2)."""
    rows = np.stack([along, theirs.normal / sine])
    shift = np.array([along @ mine.origin, theirs.normal @ (mine.origin - theirs.origin) / sine])
    frame: F64 = np.concatenate([rows @ mine.placed[:3, :2], shift[None]])
    return frame


def _shared_intervals(
    one: shapely.Geometry, other: shapely.Geometry, margin: float
) -> list[tuple[float, float]]:
    """Return the intervals of τ, longer than a margin, in which both panels are near the line."""
    intervals = []
    for area in (one, other):
        low, _, high, _ = area.bounds
        near = shapely.clip_by_rect(area, low, -margin, high, margin)
        parts = [part.bounds for part in shapely.get_parts(near) if not part.is_empty]
        intervals.append([(part[0], part[2]) for part in parts])
    shared = [(max(a, c), min(b, d)) for a, b in intervals[0] for c, d in intervals[1]]
    return [(low, high) for low, high in shared if high - low > margin]


def _reach(area: shapely.Geometry, low: float, high: float) -> tuple[float, float]:
    """Return the lowest and the highest s of a panel in an interval of τ."""
    _, bottom, _, top = area.bounds
    part = shapely.clip_by_rect(area, low, bottom, high, top)
    return float(part.bounds[1]), float(part.bounds[3])
