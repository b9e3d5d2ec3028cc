"""Tools: dimensions as the makers print them.

All tools: ``feed`` and ``plunge`` are mm/min.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias


@dataclass(frozen=True, slots=True)
class Knife:
    """A tangential knife, still or oscillating; with ``trail`` a drag knife."""

    blade_angle: float  #: slant of the leading edge from the vertical (degrees)
    blade_width: float  #: of the blade along the cut: a wrong heading widens the cut by it (mm)
    swivel: float  #: a corner sharper than this is turned in the air (degrees)
    feed: float
    plunge: float
    oscillating: bool = False
    trail: float = 0.0  #: e, tip behind the head's axis (mm): 0 for a tangential knife
    lead_in: float = 0.0  #: arc by which it comes to an outer contour from the waste (mm)
    lead_out: float = 0.0  #: arc by which it leaves an outer contour into the waste (mm)

    @property
    def led(self) -> bool:
        """Whether it begins or ends outer contours in the waste."""
        return self.lead_in > 0.0 or self.lead_out > 0.0

    def lead(self, thickness: float) -> float:
        """Return how far the top of the cut runs ahead of its bottom (mm) over a thickness (mm)."""
        return thickness * math.tan(math.radians(self.blade_angle))


@dataclass(frozen=True, slots=True)
class CreaseWheel:
    """A wheel pressed into the board; the same from both sides."""

    radius: float  #: R (mm)
    width: float  #: of its rim (mm)
    feed: float
    plunge: float

    def contact(self, depth: float) -> float:
        """Return s, half the length over which it touches the board at a depth (mm).

        Our derivation: s² = δ(2R − δ).
        """
        return math.sqrt(max(depth * (2.0 * self.radius - depth), 0.0))


@dataclass(frozen=True, slots=True)
class VCutter:
    """A leaning blade that cuts one flank of a V-groove on each of two passes.

    Seen from its tip the head's axis stands ``back`` to the right of travel and ``half_width``
    ahead; the other end of the blade's edge is 2 ``half_width`` ahead of the tip.
    """

    back: float  #: d, tip to head axis, square to the edge (mm)
    half_width: float  #: r, tip to head axis, along the edge (mm)
    tilt: float  #: θ, of the blade from the vertical (degrees)
    feed: float = 12000.0
    plunge: float = 3000.0

    @property
    def length(self) -> float:
        """L, pivot to tip along the blade (mm): d = L sin θ."""
        return self.back / math.sin(math.radians(self.tilt))

    @property
    def slope(self) -> float:
        """tan θ: sideways travel per mm of depth."""
        return math.tan(math.radians(self.tilt))


@dataclass(frozen=True, slots=True)
class Cutter:
    """A rotating cutter (router) or a beam: anything that removes a disc."""

    radius: float  #: r (mm); of a beam half its kerf
    feed: float
    plunge: float
    speed: float = 0.0  #: of the spindle (rpm); 0 for a beam, which has none
    spin_up: float = 0.0  #: seconds from the spindle's start to its full speed
    lead: float = 0.0  #: straight way on which the offset is set up (mm); 0 for 1.5 r
    approach: float = 90.0  #: of that way to the contour (degrees): 0 in line, −90 round outside
    step: float = 0.0  #: deepest cut in one pass (mm); 0 for all at once
    dwell: float = 0.0  #: longest touch of one corner before it burns (s); 0 for no limit

    @property
    def set_up(self) -> float:
        """Length of the straight way on which the offset is set up (mm), longer than r."""
        return self.lead or 1.5 * self.radius


Tool: TypeAlias = Knife | CreaseWheel | VCutter | Cutter
