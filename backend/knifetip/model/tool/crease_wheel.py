"""The crease wheel: a wheel that is pressed into the board."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from knifetip.geometry.tolerance import POINT
from knifetip.model.tool.base import Footprint, Positive, Reversal, TipCircle, Tool
from knifetip.model.tool.cross_section import CrossSection


@dataclass(frozen=True, slots=True)
class CreaseWheel(Tool):
    """A crease wheel; rotated by 180° about the C axis, it makes the same crease."""

    period: ClassVar[float] = 180.0

    radius: Positive  #: R, radius of the wheel (mm)
    width: Positive  #: width of the rim (mm)
    feed: Positive
    plunge: Positive

    def contact(self, depth: float) -> float:
        """Return half the length of the contact between wheel and board (mm).

        Own derivation: s² = δ (2R − δ) for half length s, depth δ and radius R of the wheel.

        Parameters
        ----------
        depth
            Depth δ to which the wheel is pressed into the board (mm).
        """
        return math.sqrt(max(depth * (2.0 * self.radius - depth), 0.0))

    def tip_circle(self, depth: float) -> TipCircle:
        """Return the circle about the tool's axis that contains the contact of wheel and board.

        The contact is a rectangle.  Its length is 2 ``contact(depth)``, and its width is the width
        of the rim.

        Parameters
        ----------
        depth
            Depth to which the wheel is pressed into the board (mm).
        """
        return TipCircle(math.hypot(self.contact(max(depth, 0.0)), self.width / 2.0), 0.0, 0.0)

    @property
    def reach(self) -> float:
        """Radius about the head's axis within which the wheel lies at any heading (mm)."""
        return math.hypot(self.radius, self.width / 2.0)

    @property
    def reversal(self) -> tuple[Reversal, float]:
        """The ends of a track at which the wheel may start, and an angle (degrees).

        A track is a path that the tool follows without a lift.  The angle is added to the C axis if
        the wheel starts at the end of the track.  The wheel may start at both ends, because it
        rolls in both directions.
        """
        return Reversal.EITHER, 0.0

    @property
    def diameter(self) -> float:
        """Diameter of the wheel (mm)."""
        return 2.0 * self.radius

    @property
    def footprint(self) -> Footprint:
        """The mark that the wheel leaves on the board, with radius and rim width of the wheel."""
        return Footprint("wheel", radius=self.radius, width=self.width)

    def cross_section(self, depth: float) -> CrossSection:
        """Return the crease that the rim presses ``depth`` mm deep."""
        return CrossSection(
            top_width=self.width,
            rim_width=self.width,
            wheel_radius=self.radius,
            contact_length=2.0 * self.contact(depth),
        )

    @classmethod
    def best_for(cls, tools: Sequence[Tool], caliper: float) -> int:
        """Return the index of the wheel in ``tools`` that is best for a board ``caliper`` mm thick.

        The best wheel has the narrowest rim with a width of at least ``caliper``, so that the
        inside of the fold has room for the board.  If no rim is wide enough, the best wheel is the
        one with the widest rim.
        """
        rims = [wheel.width for wheel in tools if isinstance(wheel, CreaseWheel)]
        enough = [rim for rim in rims if rim >= caliper - POINT]
        return rims.index(min(enough, default=max(rims)))
