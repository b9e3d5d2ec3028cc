"""knife: a tangential blade, still, oscillating or dragged."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from annotated_types import Ge, Lt

from knifetip.model.tool.base import Footprint, Positive, Reversal, TipCircle, Tool


@dataclass(frozen=True, slots=True)
class Knife(Tool):
    """A tangential knife, still or oscillating; with ``trail`` a drag knife."""

    #: slant of the leading edge from the vertical (degrees)
    blade_angle: Annotated[float, Ge(0), Lt(80)]
    blade_width: float  #: along the cut: a wrong heading widens the cut by it (mm)
    swivel: float  #: swivel angle: corners sharper than this are turned above the board (degrees)
    feed: Positive
    plunge: Positive
    oscillating: bool = False
    trail: float = 0.0  #: e, tip behind the head's axis (mm): 0 for a tangential knife
    lead_in: float = 0.0  #: arc by which it comes to an outer contour from the waste (mm)
    lead_out: float = 0.0  #: arc by which it leaves an outer contour into the waste (mm)

    @property
    def led(self) -> bool:
        """Whether outer contours have a lead-in or a lead-out in the waste."""
        return self.lead_in > 0.0 or self.lead_out > 0.0

    def lead(self, thickness: float) -> float:
        """Return the lead of the cut at the top over the bottom (mm) for a board thickness (mm)."""
        return thickness * math.tan(math.radians(self.blade_angle))

    def tip_circle(self, depth: float) -> TipCircle:
        """Return a circle as wide as the blade and its trail."""
        del depth  # the same at any depth
        return TipCircle(self.trail + self.blade_width, 0.0, 0.0)

    @property
    def reversal(self) -> tuple[Reversal, float]:
        """A slanted or trailing blade cuts differently in the other direction."""
        if self.blade_angle == 0.0 and self.trail == 0.0:
            return Reversal.EITHER, 180.0
        return Reversal.ONE, 0.0

    @property
    def spindle(self) -> int:
        """1 for an oscillating knife, although it has one speed: controllers treat M3 S0 as off."""
        return int(self.oscillating)

    @property
    def footprint(self) -> Footprint:
        """A line; the tip of a drag knife lies behind the head."""
        return Footprint(behind=self.trail)
