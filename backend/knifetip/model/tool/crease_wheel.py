"""crease_wheel: a wheel that is pressed into the board."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from knifetip.geometry.tolerance import POINT
from knifetip.model.tool.base import Footprint, Positive, Reversal, TipCircle, Tool


@dataclass(frozen=True, slots=True)
class CreaseWheel(Tool):
    """A wheel pressed into the board; the same from both sides."""

    period: ClassVar[float] = 180.0

    radius: Positive  #: R (mm)
    width: Positive  #: of its rim (mm)
    feed: Positive
    plunge: Positive

    def contact(self, depth: float) -> float:
        """Return s, half the length of its contact with the board at a depth (mm).

        Our derivation: s² = δ(2R − δ).
        """
        return math.sqrt(max(depth * (2.0 * self.radius - depth), 0.0))

    def tip_circle(self, depth: float) -> TipCircle:
        """Return a circle as wide as the wheel's contact with the board."""
        return TipCircle(math.hypot(self.contact(max(depth, 0.0)), self.width / 2.0), 0.0, 0.0)

    @property
    def reversal(self) -> tuple[Reversal, float]:
        """A wheel rolls both ways."""
        return Reversal.EITHER, 0.0

    @property
    def diameter(self) -> float:
        """Of the wheel (mm)."""
        return 2.0 * self.radius

    @property
    def footprint(self) -> Footprint:
        """The rim, over its contact with the board."""
        return Footprint("wheel", radius=self.radius, width=self.width)

    @classmethod
    def best_for(cls, held: Sequence[Tool], caliper: float) -> int:
        """Return the wheel that suits a board.

        The trade's rule: the narrowest rim that is at least as wide as the board is thick, so that
        the inside of the fold has room for the board; the widest rim if none is wide enough.
        """
        rims = [wheel.width for wheel in held if isinstance(wheel, CreaseWheel)]
        enough = [rim for rim in rims if rim >= caliper - POINT]
        return rims.index(min(enough, default=max(rims)))
