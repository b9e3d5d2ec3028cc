"""draft: collects the outline, cuts, folds and panels of a carton while it is drawn."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final

import numpy as np

from knifetip.cartons.carton import Box, Carton, Fold, Panel, Point
from knifetip.geometry.path import Paths, path_through
from knifetip.geometry.rounded_contour import closed_contour
from knifetip.model.dieline import LineType

#: Decimals of all coordinates (mm), as files have them.
_DECIMALS: Final = 6


class Draft:
    """A carton that is being drawn.

    Parameters
    ----------
    first
        Name of the panel that stays in place.
    box
        Bounding box of that panel.
    """

    def __init__(self, first: str, box: Box) -> None:
        self._panels = [Panel(first, _rounded_box(box), _middle(box))]
        self._folds: list[Fold] = []
        self._cuts: list[Paths] = []

    def panel(
        self,
        name: str,
        box: Box,
        base: str,
        *lines: tuple[Point, Point],
        angle: float = 90.0,
        kind: LineType = LineType.CREASE,
        point: Point | None = None,
    ) -> None:
        """Add a panel that turns around folds at ``lines`` of the panel ``base``.

        Parameters
        ----------
        name, box
            Name of the panel, and its bounding box (mm).
        base
            Name of a panel that was added before.
        *lines
            Start and end of each fold (mm).
        angle
            Angle by which the panel is turned when the carton is closed (degrees), down if < 0.
        kind
            Line type of the folds.
        point
            A point in the panel (mm); None for the middle of its box.
        """
        x0, y0, x1, y1 = box
        box = (min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1))
        self._panels.append(Panel(name, _rounded_box(box), point or _middle(box)))
        for start, end in lines:
            fold = Fold(_rounded(start), _rounded(end), angle, base, name, kind)
            self._folds.append(fold)

    def slit(self, *points: Point) -> None:
        """Add an open cut through points (mm)."""
        xy = np.array(points).round(_DECIMALS) + 0.0
        self._cuts.append(path_through(xy, np.zeros(len(points) - 1)))

    def hole(self, box: Box) -> None:
        """Add a rectangular hole."""
        x0, y0, x1, y1 = box
        corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]
        self.slit(*corners)

    def finish(self, corners: Iterable[Sequence[float]]) -> Carton:
        """Return the carton.

        Parameters
        ----------
        corners
            Corners of the outline, counter-clockwise: x, y (mm), and the radius of the fillet at
            the corner if it has one.
        """
        rows = [(*corner[:2], *corner[2:3], *(0.0,) * (4 - len(corner[:3]))) for corner in corners]
        outline = closed_contour(np.array(rows, np.float64))
        rounded = Paths(
            outline.start.round(_DECIMALS) + 0.0,
            outline.end.round(_DECIMALS) + 0.0,
            outline.bulge.round(12),
            outline.first,
        )
        return Carton(rounded, tuple(self._cuts), tuple(self._folds), tuple(self._panels))


def _middle(box: Box) -> Point:
    return 0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])


def _rounded(point: Point) -> Point:
    return (round(point[0], _DECIMALS) + 0.0, round(point[1], _DECIMALS) + 0.0)


def _rounded_box(box: Box) -> Box:
    return (*_rounded(box[:2]), *_rounded(box[2:]))
