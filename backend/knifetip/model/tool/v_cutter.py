"""The V-cutter: a tilted blade for V-grooves."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from annotated_types import Gt, Lt

from knifetip.model.tool.base import Footprint, Positive, Reversal, TipCircle, Tool
from knifetip.model.tool.cross_section import CrossSection


@dataclass(frozen=True, slots=True)
class VCutter(Tool):
    """A tilted blade that cuts one flank of a V-groove in each of two passes.

    Seen in the direction of travel, the head's axis is to the right of the tip by the distance
    ``back``, and ahead of the tip by the distance ``half_width``.  The other end of the cutting
    edge is ahead of the tip by twice ``half_width``.
    """

    back: Positive  #: d, distance of tip and head axis across the cutting edge (mm)
    half_width: float  #: r, distance of tip and head axis along the cutting edge (mm)
    tilt: Annotated[float, Gt(0), Lt(90)]  #: θ, angle of the blade from the vertical (degrees)
    feed: Positive = 12000.0
    plunge: Positive = 3000.0

    @property
    def length(self) -> float:
        """Length of the blade (mm) from the head's axis to the tip: ``back`` / sin(``tilt``)."""
        return self.back / math.sin(math.radians(self.tilt))

    @property
    def slope(self) -> float:
        """Width of one side of the groove, seen from above, per mm of depth: tan(``tilt``)."""
        return math.tan(math.radians(self.tilt))

    def tip_circle(self, depth: float) -> TipCircle:
        """Return the circle with radius ``half_width`` about the tilted axis of the blade.

        The tip is on this circle.  The circle does not depend on ``depth``.
        """
        del depth  # the same at any depth
        return TipCircle(self.half_width, self.back, self.tilt)

    @property
    def reversal(self) -> tuple[Reversal, float]:
        """The ends of a track at which the V-cutter may start, and an angle (degrees).

        A track is a path that the tool follows without a lift.  The angle is added to the C axis if
        the V-cutter starts at the end of the track.  The V-cutter may start at both ends, because
        either flank of the groove can be cut first.
        """
        return Reversal.SIDES, 0.0

    @property
    def footprint(self) -> Footprint:
        """The mark that the V-cutter leaves on the board in one pass: one flank of the groove."""
        return Footprint(
            "groove",
            slope=self.slope,
            blade=2.0 * self.half_width,
            left=self.back,
            behind=self.half_width,
        )

    def cross_section(self, depth: float) -> CrossSection:
        """Return the groove ``depth`` mm deep that the blade cuts in two passes.

        The flanks enclose twice the tilt: the board folds by this angle until they meet.
        """
        return CrossSection(
            top_width=2.0 * depth * self.slope, flank_angle=self.tilt, fold_angle=2.0 * self.tilt
        )

    @property
    def derived(self) -> dict[str, float]:
        """A dictionary with the calculated dimension ``length``, the length of the blade (mm)."""
        return {"length": self.length}
