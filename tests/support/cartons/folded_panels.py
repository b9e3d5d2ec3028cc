"""Fold the panels of a carton in space along its folds, with matrices of its own."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from knifetip.cartons.carton import Carton, Fold

Matrix = NDArray[np.float64]


@dataclass(frozen=True)
class Folded:
    """The faces of a carton by panel, and the matrix (4, 4) that moves each to its place."""

    faces: dict[str, shapely.Polygon]
    places: dict[str, Matrix]

    def at(self, panel: str, x: float, y: float) -> NDArray[np.float64]:
        """Return the place of a point of the blank that belongs to a panel, (3,) mm."""
        place: NDArray[np.float64] = (self.places[panel] @ (x, y, 0.0, 1.0))[:3]
        return place

    def corners(self, panel: str) -> NDArray[np.float64]:
        """Return the places of the corners of a panel, (n, 3) mm."""
        ring = shapely.get_coordinates(self.faces[panel].exterior)
        return np.array([self.at(panel, x, y) for x, y in ring])


def faces_of(carton: Carton) -> list[shapely.Polygon]:
    """Return the areas that cuts and folds enclose; arcs are replaced by their chords."""
    edges = carton.edges()
    lines = shapely.union_all(shapely.linestrings(edges.ends), grid_size=1e-6)
    return list(shapely.get_parts(shapely.polygonize([*shapely.get_parts(lines)])))


def fold(carton: Carton) -> Folded:
    """Fold a carton to its angles; the first panel stays in the plane of the blank."""
    faces = faces_of(carton)
    found = {}
    for panel in carton.panels:
        (face,) = (one for one in faces if one.contains(shapely.Point(panel.point)))
        found[panel.name] = face
    places = {carton.panels[0].name: np.eye(4)}
    folds = {one.panel: one for one in reversed(carton.folds)}
    for panel in carton.panels[1:]:
        turn = folds[panel.name]
        places[panel.name] = places[turn.base] @ _rotation(turn, panel.point)
    return Folded(found, places)


def _rotation(turn: Fold, inside: tuple[float, float]) -> Matrix:
    """Return the rotation around a fold that lifts the panel with the point ``inside``."""
    start, end = np.array(turn.start), np.array(turn.end)
    axis = (end - start) / math.dist(start, end)
    away = np.array(inside) - start
    sign = 1.0 if axis[0] * away[1] - axis[1] * away[0] > 0.0 else -1.0
    angle = math.radians(turn.angle) * sign
    k = np.array([[0.0, 0.0, axis[1]], [0.0, 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
    rotation = np.eye(3) + math.sin(angle) * k + (1.0 - math.cos(angle)) * (k @ k)
    origin = np.array([*start, 0.0])
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, origin - rotation @ origin
    return matrix
