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

    radius: float  #: r (mm)
    feed: float
    plunge: float


Tool: TypeAlias = Knife | CreaseWheel | VCutter | Cutter
