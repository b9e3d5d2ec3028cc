"""The carton builder: strokes and texts of a drawing, each with the part of the carton it belongs
to.

Parts that are machined: ``outer`` and ``inner`` are cuts; ``crease``, ``perforation``, ``half-cut``
and ``v-groove`` are the line types of these names.  Parts that are not machined: ``dimension``,
``text``, ``frame``, ``bleed``, ``glue``, ``mark``, ``legend``, ``grain`` and ``safety``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from knifetip.geometry.columns import F64, U8
from knifetip.model.dieline import LineType
from knifetip.model.drawing import extents

_LINE_TYPES = {
    "outer": LineType.CUT,
    "inner": LineType.CUT,
    "crease": LineType.CREASE,
    "perforation": LineType.PERFORATION,
    "half-cut": LineType.HALF_CUT,
    "v-groove": LineType.V_GROOVE,
}


@dataclass(frozen=True)
class Stroke:
    """One line or arc of at most half a turn (mm), with the name of its part."""

    x0: float
    y0: float
    x1: float
    y1: float
    part: str
    bulge: float = 0.0
    sample: str = ""  #: only for legends: the part whose style the stroke has

    @property
    def truth(self) -> LineType:
        """The correct line type of the stroke."""
        return _LINE_TYPES.get(self.part, LineType.IGNORED)


@dataclass
class Plan:
    """The strokes of one or more cartons, and texts as (text, x, y, height, part) in mm."""

    strokes: list[Stroke] = field(default_factory=list)
    texts: list[tuple[str, float, float, float, str]] = field(default_factory=list)

    def line(
        self, x0: float, y0: float, x1: float, y1: float, part: str, bulge: float = 0.0
    ) -> None:
        """Add one line or arc from (x0, y0) to (x1, y1)."""
        self.strokes.append(Stroke(x0, y0, x1, y1, part, bulge))

    def polyline(
        self, points: Sequence[tuple[float, ...]], part: str, *, closed: bool = True
    ) -> None:
        """Add a polyline through points (x, y) or (x, y, bulge of the side that starts there)."""
        after = [*points[1:], *(points[:1] if closed else ())]
        for one, two in zip(points, after, strict=False):
            self.line(one[0], one[1], two[0], two[1], part, one[2] if len(one) > 2 else 0.0)

    def rectangle(self, x0: float, y0: float, x1: float, y1: float, part: str) -> None:
        """Add the four sides of a rectangle with two opposite corners (x0, y0) and (x1, y1)."""
        self.polyline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], part)

    def circle(self, x: float, y: float, radius: float, part: str) -> None:
        """Add a circle as two half circles."""
        self.line(x - radius, y, x + radius, y, part, 1.0)
        self.line(x + radius, y, x - radius, y, part, 1.0)

    def text(self, text: str, x: float, y: float, height: float = 4.0, part: str = "text") -> None:
        """Add a text at (x, y)."""
        self.texts.append((text, x, y, height, part))

    @property
    def ends(self) -> F64:
        """Start and end points of all n strokes, (n, 2, 2) mm."""
        return np.array([((s.x0, s.y0), (s.x1, s.y1)) for s in self.strokes])

    @property
    def bulge(self) -> F64:
        """Bulges of all n strokes, (n,)."""
        return np.array([s.bulge for s in self.strokes])

    @property
    def truth(self) -> U8:
        """Correct LineType of all n strokes, (n,)."""
        return np.array([s.truth for s in self.strokes], np.uint8)

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Bounding box of all strokes: x min, y min, x max, y max (mm)."""
        box = extents(self.ends, self.bulge).tolist()
        return box[0], box[1], box[2], box[3]

    def moved(self, x: float, y: float) -> list[Stroke]:
        """Return copies of all strokes, displaced by (x, y)."""
        return [
            Stroke(s.x0 + x, s.y0 + y, s.x1 + x, s.y1 + y, s.part, s.bulge, s.sample)
            for s in self.strokes
        ]
