"""Write blanks to a DXF file as drawing offices do: layers, colours, entities, and inaccuracies."""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from random import Random
from typing import Any, Final

import ezdxf
from ezdxf import units
from ezdxf.math import bulge_to_arc, fit_points_to_cad_cv

from tests.cartons.blank import Blank, Point, Stroke

KINDS: Final = ("cut", "crease", "perforation", "half-cut", "v-groove")

#: Layer name and colour of each kind of line, by the habit of a drawing office.
CONVENTIONS: Final[dict[str, tuple[tuple[str, int], ...]]] = {
    "english": (("CUT", 1), ("CREASE", 5), ("PERF", 6), ("HALFCUT", 4), ("V-GROOVE", 3)),
    "lower": (("cut", 7), ("fold", 3), ("perforation", 2), ("kiss cut", 4), ("v-cut", 30)),
    "german": (
        ("Stanzen", 1),
        ("Rillen", 5),
        ("Perforieren", 3),
        ("Ritzen", 4),
        ("V-Nut", 6),
    ),
    "french": (
        ("Découpe", 1),
        ("Rainage", 5),
        ("Perforation", 3),
        ("Mi-chair", 4),
        ("V-groove", 6),
    ),
    "numbered": (
        ("01_CUT_LINES", 1),
        ("02_CREASE_LINES", 3),
        ("03_PERF_LINES", 6),
        ("04_HALF_CUT", 4),
        ("05_VGROOVE", 5),
    ),
    "colours": (("0", 1), ("0", 5), ("0", 6), ("0", 4), ("0", 3)),
}


@dataclass(frozen=True)
class Habit:
    """How a drawing is made: style of its lines, and its inaccuracies (mm)."""

    convention: str
    dashed: bool  #: folds have a dashed linetype
    polylines: bool  #: paths are LWPOLYLINEs, not lines and arcs
    split: float  #: probability that a line is drawn in two pieces
    gap: float  #: greatest gap where a piece ends
    gaps: float  #: probability of a gap
    overshoot: float  #: greatest length of folds beyond or before their end
    doubled: float  #: probability that a line is drawn twice
    digits: int  #: decimal places of coordinates

    def style(self, kind: str) -> tuple[str, int]:
        """Return layer and colour of a kind of line."""
        return CONVENTIONS[self.convention][KINDS.index(kind)]


def habit(rng: Random) -> Habit:
    """Return the random habit of a drawing office."""
    return Habit(
        convention=rng.choice(sorted(CONVENTIONS)),
        dashed=rng.random() < 0.3,
        polylines=rng.random() < 0.5,
        split=rng.choice([0.0, 0.0, 0.15]),
        gap=rng.choice([0.0, 0.0, 0.01, 0.05, 0.3]),
        gaps=rng.choice([0.1, 0.5]),
        overshoot=rng.choice([0.0, 0.0, 0.0, 0.05, 0.45]),
        doubled=rng.choice([0.0, 0.0, 0.03]),
        digits=rng.choice([2, 3, 6, 12]),
    )


class Draft:
    """A DXF document that is being drawn."""

    def __init__(self, habits: Habit, rng: Random) -> None:
        self.habit, self._rng = habits, rng
        self.document = ezdxf.new(rng.choice(["R2000", "R2010", "R2018"]), setup=True)
        self.document.units = units.MM
        for kind in KINDS:
            layer, colour = habits.style(kind)
            if layer != "0":
                self.document.layers.add(layer, color=colour)
        self._space: Any = self.document.modelspace()

    def add(self, blank: Blank) -> None:
        """Draw a blank."""
        strokes = list(blank.strokes)
        if self._rng.random() < 0.5:
            self._rng.shuffle(strokes)
        for stroke in strokes:
            self._stroke(stroke)
            if self._rng.random() < self.habit.doubled:
                self._stroke(stroke)

    def add_copies(self, blank: Blank, places: Sequence[tuple[float, float, float]]) -> None:
        """Draw a blank once as a block, and insert it at places (turn in radians, x, y)."""
        block = self.document.blocks.new("BLANK")
        space, self._space = self._space, block
        self.add(blank)
        self._space = space
        for turn, x, y in places:
            space.add_blockref("BLANK", (x, y), dxfattribs={"rotation": math.degrees(turn)})

    def bytes(self) -> bytes:
        """Return the file."""
        stream = io.StringIO()
        self.document.write(stream)
        encoded: bytes = self.document.encode(stream.getvalue())
        return encoded

    def _attributes(self, kind: str) -> dict[str, object]:
        layer, colour = self.habit.style(kind)
        attributes: dict[str, object] = {"layer": layer}
        if layer == "0":
            attributes["color"] = colour
        if self.habit.dashed and kind == "crease":
            attributes["linetype"] = "DASHED"
        return attributes

    def _stroke(self, stroke: Stroke) -> None:
        attributes = self._attributes(stroke.kind)
        if stroke.form == "circle":
            centre, on = (self._rounded(one) for one in stroke.points)
            self._space.add_circle(centre, math.dist(centre, on), dxfattribs=attributes)
        elif stroke.form == "spline":
            points = [self._rounded(one) for one in stroke.points]
            self._space.add_spline(dxfattribs=attributes).apply_construction_tool(
                fit_points_to_cad_cv(points)
            )
        elif self.habit.polylines and len(stroke.bulges) > 1:
            self._polyline(stroke, attributes)
        else:
            for a, b, bulge in zip(stroke.points, stroke.points[1:], stroke.bulges, strict=False):
                self._side(a, b, bulge, attributes, fold=stroke.kind == "crease")

    def _polyline(self, stroke: Stroke, attributes: dict[str, object]) -> None:
        bulges = (*stroke.bulges, 0.0)
        rows = [
            (*self._rounded(point), bulge)
            for point, bulge in zip(stroke.points, bulges, strict=True)
        ]
        closed = stroke.points[0] == stroke.points[-1]
        self._space.add_lwpolyline(
            rows[:-1] if closed else rows, format="xyb", close=closed, dxfattribs=attributes
        )

    def _side(
        self, a: Point, b: Point, bulge: float, attributes: dict[str, object], *, fold: bool
    ) -> None:
        rng, long = self._rng, math.dist(a, b)
        if bulge:
            a, b = self._rounded(a), self._rounded(b)
            centre, start, end, radius = bulge_to_arc(a, b, bulge)
            self._space.add_arc(
                centre, radius, math.degrees(start), math.degrees(end), dxfattribs=attributes
            )
            return
        pieces = [0.0, 1.0]
        if rng.random() < self.habit.split and long > 8.0:
            pieces.insert(1, rng.uniform(0.3, 0.7))
        for first, last in pairwise(pieces):
            low, high = first * long, last * long
            reach = self.habit.overshoot if fold else 0.0
            low -= rng.uniform(-reach, reach) * (first == 0.0)
            high += rng.uniform(-reach, reach) * (last == 1.0)
            if rng.random() < self.habit.gaps and self.habit.gap < 0.1 * long:
                high -= rng.uniform(0.0, self.habit.gap)
            ends = [
                self._rounded((a[0] + (b[0] - a[0]) * s / long, a[1] + (b[1] - a[1]) * s / long))
                for s in (low, high)
            ]
            if rng.random() < 0.3:
                ends.reverse()
            self._space.add_line(*ends, dxfattribs=attributes)

    def _rounded(self, point: Point) -> Point:
        return round(point[0], self.habit.digits), round(point[1], self.habit.digits)
