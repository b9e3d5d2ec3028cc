"""v_cutter: a leaning blade for V-grooves."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from annotated_types import Gt, Lt

from knifetip.model.tool.base import Footprint, Positive, Reversal, TipCircle, Tool


@dataclass(frozen=True, slots=True)
class VCutter(Tool):
    """A leaning blade that cuts one flank of a V-groove on each of two passes.

    From its tip, the head's axis lies ``back`` to the right of travel and ``half_width`` ahead.
    The other end of the blade's edge is 2 ``half_width`` ahead of the tip.
    """

    back: Positive  #: d, tip to head axis, square to the edge (mm)
    half_width: float  #: r, tip to head axis, along the edge (mm)
    tilt: Annotated[float, Gt(0), Lt(90)]  #: θ, of the blade from the vertical (degrees)
    feed: Positive = 12000.0
    plunge: Positive = 3000.0

    @property
    def length(self) -> float:
        """L, pivot to tip along the blade (mm): d = L sin θ."""
        return self.back / math.sin(math.radians(self.tilt))

    @property
    def slope(self) -> float:
        """tan θ: sideways travel per mm of depth."""
        return math.tan(math.radians(self.tilt))

    def tip_circle(self, depth: float) -> TipCircle:
        """Return the circle about the leaning axis."""
        del depth  # the same at any depth
        return TipCircle(self.half_width, self.back, self.tilt)

    @property
    def reversal(self) -> tuple[Reversal, float]:
        """The two flanks may be cut in either order, starting at either end of the groove."""
        return Reversal.SIDES, 0.0

    @property
    def footprint(self) -> Footprint:
        """One flank of the groove."""
        return Footprint(
            "groove",
            slope=self.slope,
            blade=2.0 * self.half_width,
            left=self.back,
            behind=self.half_width,
        )

    @property
    def derived(self) -> dict[str, float]:
        """The blade's length."""
        return {"length": self.length}
