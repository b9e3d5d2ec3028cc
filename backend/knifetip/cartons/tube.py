"""tube: the four panels of a carton with a glued joint, and the outline through its flaps.

From left to right: the glue flap, the back, the left, the front and the right panel.  A flap is a
list of corners (u, v, radius) in the direction of +x, where v is the distance from the crease line
at the top or at the bottom.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

from knifetip.cartons import allowances
from knifetip.cartons.carton import Box, Point
from knifetip.cartons.draft import Draft

#: Names of the panels, from left to right.
PANELS: Final = ("back", "left", "front", "right")

Corner: TypeAlias = tuple[float, ...]
Flap: TypeAlias = Sequence[Corner]


@dataclass(frozen=True, slots=True)
class Tube:
    """Positions of the creases of a tube: four panels beside each other, and a glue flap."""

    x: tuple[float, float, float, float, float]  #: left sides of the panels, and the right end (mm)
    bottom: float  #: y of the crease line at the bottom (mm)
    top: float  #: y of the crease line at the top (mm)
    caliper: float  #: thickness of the board (mm)

    @classmethod
    def from_size(cls, length: float, width: float, height: float, joint: float, t: float) -> Tube:
        """Return the tube for inner dimensions.

        Parameters
        ----------
        length, width : mm
            Inner dimensions.
        height : mm
            Distance of the crease lines.
        joint : mm
            Width of the glue flap, which begins at x = 0.
        t : mm
            Caliper of the board.
        """
        more = allowances.between_folds(t)
        x = [joint]
        for size in (length, width, length, width - allowances.last_panel(t)):
            x.append(x[-1] + size + more)
        return cls((x[0], x[1], x[2], x[3], x[4]), 0.0, height, t)

    def span(self, panel: int) -> tuple[float, float]:
        """Return the left and the right side of a panel, 0 … 3 (mm)."""
        return self.x[panel], self.x[panel + 1]

    def draft(self) -> Draft:
        """Return the draft of the panels and the glue flap, without flaps."""
        boxes = [(a, self.bottom, b, self.top) for a, b in map(self.span, range(4))]
        draft = Draft(PANELS[0], boxes[0])
        for number in range(1, 4):
            at = self.x[number]
            line = (at, self.bottom), (at, self.top)
            draft.panel(PANELS[number], boxes[number], PANELS[number - 1], line)
        flap: Box = (0.0, self.bottom, self.x[0], self.top)
        draft.panel("glue-flap", flap, PANELS[0], ((self.x[0], self.bottom), (self.x[0], self.top)))
        return draft

    def point(self, corner: Corner, *, top: bool) -> Point:
        """Return the place of a corner (u, v) of a flap at the top or at the bottom."""
        return corner[0], (self.top + corner[1] if top else self.bottom - corner[1])

    def outline(self, top: Sequence[Flap], bottom: Sequence[Flap]) -> list[Corner]:
        """Return the corners of the outline, counter-clockwise.

        Parameters
        ----------
        top, bottom
            A flap for each panel, from left to right; two corners for a panel without one.
        """
        below = [(*self.point(one, top=False), *one[2:]) for flap in bottom for one in flap]
        above = [(*self.point(one, top=True), *one[2:]) for flap in top for one in flap]
        x, height = self.x[0], self.top - self.bottom
        # The glue flap must not be caught by flaps that fold beside it.
        taper = min(0.4 * x, 0.2 * height)
        flap = [
            (x, self.top),
            (0.0, self.top - taper),
            (0.0, self.bottom + taper),
            (x, self.bottom),
        ]
        right = [(self.x[4], self.bottom), (self.x[4], self.top)]
        return [*below, *right, *reversed(above), *flap]

    def no_flap(self, panel: int) -> Flap:
        """Return the free edge of a panel."""
        a, b = self.span(panel)
        return [(a, 0.0), (b, 0.0)]
