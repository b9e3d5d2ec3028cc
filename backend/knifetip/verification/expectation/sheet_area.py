"""The area of a sheet that was cut to size, as chords in sheet coordinates.

A rectangular sheet has its lower left corner at the lower left corner of the drawing, moved to the
left and down by the sheet's margin.  Otherwise the sheet is bounded by the outer contours of the
cuts.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.model.dieline import LineType
from knifetip.model.sheet import Sheet
from knifetip.verification.columns import F64, Bool
from knifetip.verification.curves.curve import point_at
from knifetip.verification.expectation.edges import TOUCH_DISTANCE, Edges
from knifetip.verification.expectation.outline import (
    CutOutlines,
    count_enclosing,
    find_outlines,
)

#: Greatest distance between an arc and the chords that replace it (mm).
_SAGITTA: Final = 1e-3
#: Place on an edge, as a fraction of its length, at which it must be on the sheet.
_PROBE: Final = 0.37
#: Greatest number of distances that are computed at once.
_BATCH: Final = 500_000


@dataclass(frozen=True, eq=False, slots=True)
class SheetArea:
    """The sheet on the table, bounded by m chords; the order of the chords does not matter."""

    start: F64  #: (m, 2) mm
    end: F64  #: (m, 2) mm

    def distances(self, polygon: F64) -> F64:
        """Return the distance of each of k polygons from the edge of the sheet, (k,) mm.

        ``polygon`` are the corners of the polygons, (k, p, 2) mm; a polygon of one or two corners
        is a point or a line.  A polygon without a corner on the sheet is beside the sheet if its
        distance is greater than 0, because the sheet is larger than a tool.
        """
        count, corners = polygon.shape[:2]
        step = max(1, _BATCH // (corners * len(self.start)))
        result = np.empty(count)
        for first in range(0, count, step):
            part = polygon[first : first + step]
            ahead = np.roll(part, -1, axis=1)
            own = _point_distances(part[:, :, None], self.start, self.end)
            other = _point_distances(self.start, part[:, :, None], ahead[:, :, None])
            result[first : first + step] = np.minimum(own, other).min(axis=(1, 2))
        return result

    def contains(self, point: F64) -> Bool:
        """Return the mask of the points that lie on the sheet, (k,); ``point`` is (k, 2) mm."""
        inside = np.zeros(len(point), np.bool_)
        for (x0, y0), (x1, y1) in zip(self.start, self.end, strict=True):
            rows = np.flatnonzero((y0 > point[:, 1]) != (y1 > point[:, 1]))
            crossing = x0 + (point[rows, 1] - y0) / (y1 - y0) * (x1 - x0)
            inside[rows] ^= point[rows, 0] < crossing
        return inside

    def touches(self, point: F64) -> Bool:
        """Return the mask of the points that lie on the edge of the sheet, (k,); ``point`` is (k,
        2) mm.
        """
        result: Bool = self.distances(point[:, None]) <= TOUCH_DISTANCE
        return result


def place_sheet(sheet: Sheet, edges: Edges, turn: complex = 1.0) -> SheetArea:
    """Return the area of a sheet on which the edges of a drawing are made.

    ``edges`` are all edges of the drawing in sheet coordinates.  The area has no chords if the
    sheet was cut to the outline of the drawing, and its edges do not show where that is: the cuts
    form no outline, or an edge lies outside every outline and is not connected with any.

    ``turn`` is exp(i · angle) of the angle by which a rectangular sheet is turned on the table.
    """
    has_work = ~np.isin(edges.line_type, (LineType.IGNORED, LineType.UNCLASSIFIED))
    if sheet.size is None:
        bounds = find_outlines(edges.with_types(LineType.CUT))
        others = edges.curve[has_work & (edges.line_type != LineType.CUT)]
        sheet_edge = bounds.outer & (bounds.depth == 0)
        area = SheetArea(*_chords(bounds.edges.curve[sheet_edge]))
        probes = point_at(others, _PROBE * others[:, 5])
        if _has_cuts_apart(bounds, area) or (count_enclosing(probes, bounds) == 0).any():
            return SheetArea(area.start[:0], area.end[:0])
        return area
    points = np.concatenate(_chords(edges.curve[has_work]))
    if len(points) == 0:
        return SheetArea(points, points)
    # Along the sides of the sheet, which lie along the axes of the drawing.
    low = _turned(points, turn.conjugate()).min(axis=0) - np.array(sheet.margins)
    corners = low + np.array(sheet.size) * np.array(
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    )
    corners = _turned(corners, turn)
    return SheetArea(corners, np.roll(corners, -1, axis=0))


def _turned(points: F64, turn: complex) -> F64:
    """Return points, (n, 2) mm, turned about the origin by the angle of a number of modulus 1."""
    if turn == 1.0:
        return points
    place = (points[:, 0] + 1j * points[:, 1]) * turn
    return np.stack([place.real, place.imag], axis=1)


def _has_cuts_apart(bounds: CutOutlines, area: SheetArea) -> bool:
    """Return whether some connected cuts lie outside the area and do not end on it.

    ``bounds`` are the outlines that the cuts form, and ``area`` is what they enclose.
    """
    outside = np.flatnonzero((bounds.depth == 0) & ~bounds.closing)
    outside = outside[~np.isin(bounds.component[outside], bounds.component[bounds.closing])]
    if len(outside) == 0 or len(area.start) == 0:
        return len(outside) > 0
    curve = bounds.edges.curve[outside]
    ends = np.concatenate([point_at(curve, np.zeros(len(curve))), point_at(curve, curve[:, 5])])
    held = (count_enclosing(ends, bounds) > 0) | area.touches(ends)
    component = np.tile(bounds.component[outside], 2)
    return not np.isin(component, component[held]).all()


def _chords(curve: F64) -> tuple[F64, F64]:
    """Return the start and end points of the chords that replace lines and arcs, (m, 2) mm each.

    ``curve`` are the lines and arcs as rows of six numbers (see ``curves.curve``), (n, 6).
    """
    straight = curve[:, 0] == 0.0
    radius = np.where(straight, 1.0, curve[:, 3])
    sweep = np.where(straight, 0.0, curve[:, 5] / radius)
    pieces = np.maximum(np.ceil(sweep * np.sqrt(radius / (8.0 * _SAGITTA))), 1).astype(np.int64)
    owner = np.repeat(np.arange(len(curve)), pieces)
    place = np.arange(pieces.sum()) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    size = curve[owner, 5] / pieces[owner]
    return point_at(curve[owner], place * size), point_at(curve[owner], (place + 1) * size)


def _point_distances(point: F64, start: F64, end: F64) -> F64:
    """Return the distances of points from the lines between ``start`` and ``end`` (mm).

    The arrays are broadcast; their last axis contains x and y.
    """
    along, to = end - start, point - start
    square = (along**2).sum(axis=-1)
    fraction = (to * along).sum(axis=-1) / np.where(square > 0.0, square, 1.0)
    foot = np.clip(fraction, 0.0, 1.0)[..., None] * along
    result: F64 = np.sqrt(((to - foot) ** 2).sum(axis=-1))
    return result
