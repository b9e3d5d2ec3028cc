"""The knife: a tangential blade, static, oscillating or trailing."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from annotated_types import Ge, Lt

from knifetip.geometry.columns import F64
from knifetip.messages import Message
from knifetip.model.tool.base import (
    Footprint,
    NotNegative,
    Positive,
    Reversal,
    TipCircle,
    Tool,
    pass_depths,
)
from knifetip.model.tool.cross_section import CrossSection


@dataclass(frozen=True, slots=True)
class Knife(Tool):
    """A tangential knife (static or oscillating) or a drag knife.

    It is a drag knife if ``trail``, the distance of the tip behind the head's axis, is greater
    than 0.  The machine turns it, unless it is ``free``: then it turns about its axis by itself,
    because the tip is dragged along, and keeps its heading in the air.
    """

    #: slant of the leading edge from the vertical (degrees)
    blade_angle: Annotated[float, Ge(0), Lt(80)]
    blade_width: float  #: width of the blade along the cut (mm)
    #: swivel angle: at corners sharper than this the knife is turned above the board, a free one at
    #: its swivel depth (degrees)
    swivel: float
    feed: Positive
    plunge: Positive
    oscillating: bool = False
    trail: float = 0.0  #: e, distance of the tip behind the head's axis (mm)
    lead_in: float = 0.0  #: length of the arc from the waste to an outer contour (mm)
    lead_out: float = 0.0  #: length of the arc from an outer contour to the waste (mm)

    least_radius: NotNegative = 0.0  #: smallest radius that the blade turns in (mm); 0: no limit
    free: bool = False  #: the blade trails its axis freely; no axis of the machine turns it
    #: depth of the tip in the board while a free blade is turned about it (mm); 0: the full depth
    swivel_depth: NotNegative = 0.0
    #: heading of a free blade at the start and at the end of each program (degrees)
    park_heading: float = 0.0
    step: NotNegative = 0.0  #: maximum depth of one pass (mm); 0: one pass
    #: radius of a curve below which the feed is lower in proportion to the radius (mm); 0: nowhere
    slow_radius: NotNegative = 0.0

    @property
    def fault(self) -> Message | None:
        """Error message if the dimensions are inconsistent, else None."""
        if self.free and self.trail <= 0.0:
            return Message("tool.free-without-trail")
        if not self.free and (self.swivel_depth or self.park_heading):
            return Message("tool.swivel-of-driven-knife")
        return None

    @property
    def drags(self) -> bool:
        """Whether only travel in the board turns the knife, and no axis of the machine."""
        return self.free

    @property
    def needs_heading(self) -> bool:
        """Whether an axis of the machine must turn the tool."""
        return not self.free

    @property
    def lift_angle(self) -> float:
        """Angle of a corner above which the knife is lifted to turn (degrees).

        A free blade cannot turn in the air, so it is never lifted for a corner.
        """
        return 360.0 if self.free else self.swivel

    @property
    def has_lead(self) -> bool:
        """Whether the knife has a lead-in or a lead-out in the waste at outer contours."""
        return self.lead_in > 0.0 or self.lead_out > 0.0

    def passes(self, cut_depth: float) -> F64:
        """Return the depths of the k passes of a cut that is ``cut_depth`` mm deep, (k,) (mm).

        See ``pass_depths``; the maximum depth of a pass is ``step``, a field of the knife.
        """
        return pass_depths(cut_depth, self.step)

    def lead(self, thickness: float) -> float:
        """Return how far the cut in the top face is ahead of the cut in the bottom face (mm).

        The distance is caused by the slant of the blade and measured in the direction of travel.

        Parameters
        ----------
        thickness
            Thickness of the board (mm).
        """
        return thickness * math.tan(math.radians(self.blade_angle))

    def cross_section(self, depth: float) -> CrossSection:
        """Return the cut of the blade, which has no width across its line."""
        return CrossSection(
            blade_width=self.blade_width,
            blade_angle=self.blade_angle,
            blade_lead=self.lead(depth),
        )

    def tip_circle(self, depth: float) -> TipCircle:
        """Return the circle about the axis of the head that contains the blade.

        Its radius is ``trail``, the distance of the tip behind the axis, plus the width of the
        blade.  It does not depend on ``depth``.
        """
        del depth  # the same at any depth
        return TipCircle(self.trail + self.blade_width, 0.0, 0.0)

    @property
    def reversal(self) -> tuple[Reversal, float]:
        """The ends of a track at which the knife may start, and an angle (degrees).

        A track is a path that the tool follows without a lift.  The angle is added to the C axis if
        the knife starts at the end of the track.  A slanted or trailing blade may start only at the
        start of a track, other blades at both ends.
        """
        if self.blade_angle == 0.0 and self.trail == 0.0:
            return Reversal.EITHER, 180.0
        return Reversal.ONE, 0.0

    @property
    def spindle(self) -> int:
        """S word of the program: 1 for an oscillating knife, otherwise 0.

        The number 1 is not a speed: it switches the oscillation on, because controllers treat M3 S0
        as off.
        """
        return int(self.oscillating)

    @property
    def footprint(self) -> Footprint:
        """The mark that the knife leaves on the board: a line.

        The result also contains the distance of the tip behind the axis of the head (``trail``).
        """
        return Footprint(behind=self.trail)
