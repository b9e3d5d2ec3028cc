"""solid: the panels as solids with the thickness of the board, bevelled at their folds.

A V-groove takes away what is beside its axis within half its opening angle.  At a crease, the board
gives way on the inside of the fold; the solid ends there at the bisector of the folded panels, so
that they meet without an overlap.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

import numpy as np
import shapely
from shapely import Polygon

from knifetip.folding.records import Fold, FoldTree, Panel
from knifetip.geometry.columns import F64, I64

#: Largest angle of one flank from the vertical that is shown (°).
_STEEPEST: Final = 75.0
#: Sine of the angle between two sides below which they count as one line.
_PARALLEL: Final = 0.05
#: Greatest movement of a corner, relative to that of its sides.
_MITRE: Final = 4.0


class Solid(NamedTuple):
    """The rings of a panel in the bottom and the top face of the board.

    The first ring is the outline, the others are holes.  The rings of both faces have the same
    numbers of corners, in the same order; the first corner is not repeated at the end.
    """

    bottom: tuple[F64, ...]  #: (k, 2) each (mm)
    top: tuple[F64, ...]  #: (k, 2) each (mm)


def panel_solids(tree: FoldTree) -> list[Solid]:
    """Return the solid of each panel of a tree."""
    insets = np.array([_insets(fold, tree.caliper) for fold in tree.folds]).reshape(-1, 2)
    return [_solid(panel, insets) for panel in tree.panels]


def triangulate(rings: tuple[F64, ...]) -> F64:
    """Return the triangles of the area within rings, (t, 3, 2), counter-clockwise (mm)."""
    area = Polygon(rings[0], rings[1:])
    parts = shapely.get_parts(shapely.constrained_delaunay_triangles(area))
    corners: F64 = shapely.get_coordinates(shapely.orient_polygons(parts)).reshape(-1, 4, 2)[:, :3]
    return corners


def _insets(fold: Fold, caliper: float) -> tuple[float, float]:
    """Return the distances by which a fold bevels the bottom and the top face (mm)."""
    if fold.opening is not None:
        return 0.0, caliper * math.tan(math.radians(min(fold.opening / 2.0, _STEEPEST)))
    half = min(abs(fold.angle) / 2.0, 45.0)
    inset = caliper / 2.0 * math.tan(math.radians(half))
    return (0.0, inset) if fold.angle > 0.0 else (inset, 0.0)


def _solid(panel: Panel, insets: F64) -> Solid:
    """Return the solid of a panel; ``insets`` (m, 2) are those of all folds."""
    rings = [
        shapely.get_coordinates(ring)[:-1]
        for ring in (panel.polygon.exterior, *panel.polygon.interiors)
    ]
    faces = []
    for face in range(2):
        moved = tuple(
            _moved(ring, _distances(hinges, insets[:, face]))
            for ring, hinges in zip(rings, panel.hinges, strict=True)
        )
        # A narrow panel would turn inside out.
        sound = Polygon(moved[0], moved[1:]).is_valid and shapely.LinearRing(moved[0]).is_ccw
        faces.append(moved if sound else tuple(rings))
    return Solid(faces[0], faces[1])


def _distances(hinges: I64, insets: F64) -> F64:
    """Return the distance by which each side of a ring moves, (k,), 0 for cut sides."""
    moved = np.zeros(len(hinges))
    moved[hinges >= 0] = insets[hinges[hinges >= 0]]
    return moved


def _moved(ring: F64, distance: F64) -> F64:
    """Return the corners of a ring, (k, 2), after each side has moved to its left."""
    along = np.roll(ring, -1, axis=0) - ring
    along /= np.maximum(np.hypot(*along.T), 1e-12)[:, None]
    before, d0, d1 = np.roll(along, 1, axis=0), np.roll(distance, 1), distance
    left0, left1 = (np.column_stack([-one[:, 1], one[:, 0]]) for one in (before, along))
    sine = before[:, 0] * along[:, 1] - before[:, 1] * along[:, 0]
    corner = np.abs(sine) > _PARALLEL
    # The corner x solves x · left0 = d0 and x · left1 = d1.
    safe = np.where(corner, sine, 1.0)[:, None]
    shift = (d0[:, None] * along - d1[:, None] * before) / safe
    largest = np.maximum(d0, d1)
    shift = np.where(corner[:, None], shift, largest[:, None] * (left0 + left1) / 2.0)
    size = np.hypot(*shift.T)
    limit = np.minimum(1.0, _MITRE * largest / np.maximum(size, 1e-12))
    result: F64 = ring + shift * limit[:, None]
    return result
