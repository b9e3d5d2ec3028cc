"""A blank: the strokes of one carton, and the panels in which there is room for more."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

Point = tuple[float, float]

#: tan(90° / 4): the bulge of a quarter circle.
QUARTER = math.tan(math.pi / 8.0)


@dataclass(frozen=True)
class Stroke:
    """A line of the drawing: a path of lines and arcs, a circle, or a spline through points."""

    kind: str  #: line type: "cut", "crease", "perforation", "half-cut" or "v-groove"
    points: tuple[Point, ...]  #: mm; of a circle: its centre, and a point on it
    bulges: tuple[float, ...] = ()  #: of each side of a path
    form: str = "path"  #: "path", "circle" or "spline"

    def moved(self, turn: float, x: float, y: float) -> Stroke:
        """Return the stroke, turned by an angle (radians) around the origin and then shifted."""
        c, s = math.cos(turn), math.sin(turn)
        points = tuple((c * a - s * b + x, s * a + c * b + y) for a, b in self.points)
        return replace(self, points=points)


@dataclass
class Blank:
    """Strokes of a carton, and the rectangles (x0, y0, x1, y1) inside panels that are empty."""

    strokes: list[Stroke] = field(default_factory=list)
    panels: list[tuple[float, float, float, float]] = field(default_factory=list)

    def path(self, kind: str, points: Sequence[tuple[float, ...]], *, closed: bool = False) -> None:
        """Add a path through points (x, y), or (x, y, bulge of the side that begins there)."""
        kept = [one for i, one in enumerate(points) if i == 0 or one[:2] != points[i - 1][:2]]
        if closed and kept[0][:2] != kept[-1][:2]:
            kept.append(kept[0])
        bulges = tuple(one[2] if len(one) > 2 else 0.0 for one in kept[:-1])
        self.strokes.append(Stroke(kind, tuple((p[0], p[1]) for p in kept), bulges))

    def line(self, kind: str, x0: float, y0: float, x1: float, y1: float) -> None:
        """Add a straight line."""
        self.path(kind, [(x0, y0), (x1, y1)])

    def rectangle(
        self, kind: str, x0: float, y0: float, x1: float, y1: float, radius: float = 0.0
    ) -> None:
        """Add a rectangle, with round corners if ``radius`` is not 0."""
        r = min(radius, 0.49 * (x1 - x0), 0.49 * (y1 - y0))
        if r <= 0.0:
            self.path(kind, [(x0, y0), (x1, y0), (x1, y1), (x0, y1)], closed=True)
            return
        self.path(
            kind,
            [
                (x0 + r, y0),
                (x1 - r, y0, QUARTER),
                (x1, y0 + r),
                (x1, y1 - r, QUARTER),
                (x1 - r, y1),
                (x0 + r, y1, QUARTER),
                (x0, y1 - r),
                (x0, y0 + r, QUARTER),
            ],
            closed=True,
        )

    def circle(self, kind: str, x: float, y: float, radius: float) -> None:
        """Add a circle."""
        self.strokes.append(Stroke(kind, ((x, y), (x + radius, y)), (), "circle"))

    def spline(self, kind: str, points: Sequence[Point]) -> None:
        """Add a smooth curve through points."""
        self.strokes.append(Stroke(kind, tuple(points), (), "spline"))

    def panel(self, x0: float, y0: float, x1: float, y1: float, margin: float = 4.0) -> None:
        """Remember an empty panel, without a margin."""
        if min(x1 - x0, y1 - y0) > 2.0 * margin + 4.0:
            self.panels.append((x0 + margin, y0 + margin, x1 - margin, y1 - margin))

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Bounding box of the points of all strokes, with the arcs between them (mm)."""
        x: list[float] = []
        y: list[float] = []
        for stroke in self.strokes:
            for (a, b), reach in zip(stroke.points, _reaches(stroke), strict=True):
                x += [a - reach, a + reach]
                y += [b - reach, b + reach]
        return min(x), min(y), max(x), max(y)

    def moved(self, turn: float, x: float, y: float) -> Blank:
        """Return the blank, turned by an angle (radians) and then shifted; without panels."""
        return Blank([stroke.moved(turn, x, y) for stroke in self.strokes])


def _reaches(stroke: Stroke) -> list[float]:
    """Return how far a stroke extends at most beyond each of its points (mm)."""
    if stroke.form == "circle":
        return [math.dist(*stroke.points), 0.0]
    if stroke.form == "spline":
        return [5.0] * len(stroke.points)
    sides = zip(stroke.points, stroke.points[1:], stroke.bulges, strict=False)
    return [*(0.5 * abs(bulge) * math.dist(a, b) for a, b, bulge in sides), 0.0]
