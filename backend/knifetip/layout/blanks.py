"""blanks: the areas of board that the cuts of a drawing separate from the waste.

The areas are polygons of shapely.  They serve layout and board use, where a deviation of 0.02 mm
does not matter; planning and verification compute with the arcs of the drawing.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from knifetip.geometry import arc
from knifetip.geometry.chords import chord_counts
from knifetip.geometry.columns import F64, Bool
from knifetip.model.dieline import Dieline, LineType
from knifetip.planning.cut_sides import cut_sides
from knifetip.planning.dashes import distinct_edges
from knifetip.topology.noding import split_at_crossings

#: Greatest distance of a side of a polygon from its arc (mm).
_DEVIATION: Final = 0.02
#: Area of crumbs between lines that lie close to each other, which are no blanks (mm²).
_CRUMB: Final = 1.0
#: Grid of the corners of polygons (mm): ends that meet within tolerance meet exactly on it.
_GRID: Final = 0.001


def find_blanks(dieline: Dieline) -> list[Polygon]:
    """Return the blanks of a cleaned dieline with their holes (mm), largest first.

    A blank is board that a closed cut separates from the waste around it.  A slit does not divide
    a blank; a cut between two blanks, which serves both, divides them.  If the cuts enclose
    nothing, the list is empty.
    """
    cuts = np.flatnonzero(dieline.line_type == LineType.CUT)
    ends, bulge = dieline.ends[cuts], dieline.bulge[cuts]
    single = distinct_edges(ends, bulge)
    ends, bulge, _ = split_at_crossings(ends[single], bulge[single])
    sides = cut_sides(ends, bulge)
    borders = sides.removed != 0
    board = shapely.build_area(_lines(ends, bulge, borders))
    faces = shapely.get_parts(
        shapely.polygonize([*shapely.get_parts(_lines(ends, bulge, borders | sides.shared))])
    )
    shapely.prepare(board)
    faces = faces[shapely.area(faces) > _CRUMB]
    blanks = faces[shapely.contains_properly(board, shapely.point_on_surface(faces))]
    return list(blanks[np.argsort(-shapely.area(blanks), kind="stable")])


def _lines(ends: F64, bulge: F64, wanted: Bool) -> shapely.Geometry:
    """Return n edges, with chords for arcs, as lines that meet at their ends only."""
    return shapely.union_all(chord_lines(ends[wanted], bulge[wanted]), grid_size=_GRID)


def chord_lines(ends: F64, bulge: F64) -> NDArray[np.object_]:
    """Return n edges as lines of shapely, (n,), with chords within 0.02 mm for arcs.

    ``ends`` are the start and end points of the edges, (n, 2, 2) mm, and ``bulge`` their bulges,
    (n,).
    """
    chords = chord_counts(ends[:, 0], ends[:, 1], bulge, _DEVIATION)
    edge = np.repeat(np.arange(len(bulge)), chords + 1)
    first = np.cumsum(chords + 1) - (chords + 1)
    fraction = (np.arange(len(edge)) - first[edge]) / chords[edge]
    points = arc.point_at(ends[edge, 0], ends[edge, 1], bulge[edge], fraction)
    lines: NDArray[np.object_] = shapely.linestrings(points, indices=edge)
    return lines
