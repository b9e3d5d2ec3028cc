"""parts: the shapes that are placed, each with its permitted turns."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np
import shapely
from shapely import Polygon

from knifetip.geometry import arc
from knifetip.geometry.chords import chord_counts
from knifetip.geometry.columns import F64
from knifetip.layout.blanks import chord_lines
from knifetip.layout.compose import placement_matrix
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import extents

#: Half of the distance by which a curved outline is enlarged at most, to need few corners (mm).
ENLARGED: Final = 0.1
#: Most corners of an outline that is used as it is.
_FEW: Final = 60
#: Distance by which edges may extend over the blanks of their drawing (mm).
_BEYOND: Final = 0.1


class Box(NamedTuple):
    """Bounding box of the edges of a turned drawing (mm)."""

    low: F64  #: (2,) lower left corner
    width: float
    height: float


@dataclass(frozen=True, eq=False, slots=True)
class Part:
    """A drawing that is to be placed: its board, its box at each turn, and its outline."""

    area: shapely.Geometry  #: board of its blanks, as drawn (mm)
    outline: Polygon  #: without holes; contains all edges, as drawn (mm)
    boxes: tuple[tuple[float, Box], ...]  #: permitted turns (°), each with its box
    mirror: bool
    quantity: int
    #: holes of the blanks in which no edges lie, as drawn (mm)
    holes: tuple[Polygon, ...] = ()

    def box(self, turn: float) -> Box:
        """Return the box at one of the permitted turns (°)."""
        return next(box for angle, box in self.boxes if angle == turn)


def make_part(
    dieline: Dieline,
    blanks: Sequence[Polygon],
    turns: Sequence[float],
    *,
    mirror: bool = False,
    quantity: int = 1,
) -> Part:
    """Return the part of a drawing.

    Parameters
    ----------
    dieline
        The edges of the drawing, before cleaning.
    blanks
        Its blanks, see ``layout.blanks.find_blanks``.  If there are none, the part is the convex
        hull of the edges.
    turns
        Permitted turns (°).
    mirror
        Whether all copies are mirrored.
    quantity
        Number of copies.
    """
    made = dieline.line_type != LineType.IGNORED
    ends, bulge = dieline.ends[made], dieline.bulge[made]
    points = _points(ends, bulge)
    hull = shapely.convex_hull(shapely.union_all([*blanks, shapely.multipoints(points)]))
    area = shapely.union_all(list(blanks)) if blanks else hull
    outline = _outline(area, points, hull)
    bow = -bulge if mirror else bulge
    boxes = []
    for turn in turns:
        box = extents(ends @ placement_matrix(turn, mirror=mirror), bow)
        boxes.append((turn, Box(box[:2], float(box[2] - box[0]), float(box[3] - box[1]))))
    holes = tuple(_holes(area, ends, bulge))
    return Part(area, outline, tuple(boxes), mirror, quantity, holes)


def _holes(area: shapely.Geometry, ends: F64, bulge: F64) -> Iterator[Polygon]:
    """Yield the holes of blanks that no edge crosses, and in which no other blank lies."""
    lines = chord_lines(ends, bulge)
    shapely.prepare(lines)
    for blank in shapely.get_parts(area):
        for ring in blank.interiors:
            hole = Polygon(ring)
            if not shapely.intersects(shapely.buffer(hole, -_BEYOND), lines).any():
                yield hole


def _points(ends: F64, bulge: F64) -> F64:
    """Return points on all edges, (k, 2), at most 0.02 mm from each point of an arc."""
    counts = chord_counts(ends[:, 0], ends[:, 1], bulge, 0.02)
    edge = np.repeat(np.arange(len(bulge)), counts + 1)
    first = np.cumsum(counts + 1) - (counts + 1)
    fraction = (np.arange(len(edge)) - first[edge]) / counts[edge]
    points: F64 = arc.point_at(ends[edge, 0], ends[edge, 1], bulge[edge], fraction)
    return points


def _outline(area: shapely.Geometry, points: F64, hull: shapely.Geometry) -> Polygon:
    """Return one outline without holes that contains all points, with few corners.

    Several blanks, and lines beside the blank, give the convex hull of all.
    """
    outer = hull if hull.geom_type == "Polygon" else shapely.buffer(hull, ENLARGED)
    if area.geom_type == "Polygon":
        filled = Polygon(area.exterior)
        if shapely.distance(filled, shapely.points(points)).max(initial=0.0) <= _BEYOND:
            outer = filled
    if len(outer.exterior.coords) <= _FEW:
        return outer
    # A simplified line deviates by at most ``ENLARGED``: the outline is still within.
    wide = Polygon(shapely.buffer(outer, ENLARGED, join_style="mitre").exterior)
    simple = shapely.simplify(wide, ENLARGED)
    return simple if simple.is_valid and simple.covers(outer) else wide
