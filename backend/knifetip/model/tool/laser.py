"""laser: a beam that cuts without touching."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.messages import Message
from knifetip.model.tool.base import Footprint, NotNegative, Positive
from knifetip.model.tool.disc import DiscTool


@dataclass(frozen=True, slots=True)
class Laser(DiscTool):
    """A laser that cuts through the board in one pass, its focus at one height."""

    kerf: Positive  #: width of the cut (mm); half of it is the radius r
    feed: Positive
    power: Positive  #: S word of full power for this material, in the controller's units ($30)
    pierce: NotNegative  #: seconds that the beam stays where a cut begins until it is through
    focus: float = 0.0  #: height of the focus above the board's top face (mm)
    lead: NotNegative = 0.0  #: straight way from the pierced hole to the contour (mm); 0 for 1.5 r
    approach: float = 90.0  #: of that way to the contour (degrees): 0 in line, −90 round outside
    dwell: NotNegative = 0.0  #: longest touch of one corner before it burns (s); 0 for no limit
    air: int = -1  #: digital output of the air assist; -1 where it has none

    @property
    def radius(self) -> float:
        """Half the kerf, r (mm)."""
        return self.kerf / 2.0

    @property
    def plunge(self) -> float:
        """The feed: a laser does not plunge; the head stays at the height of the focus."""
        return self.feed

    @property
    def spindle(self) -> int:
        """The power."""
        return round(self.power)

    @property
    def spindle_missing(self) -> Message | None:
        """Why it cannot cut: controllers treat M3 S0 as off."""
        return None if self.spindle >= 1 else Message("tool.without-power")

    @property
    def pierce_time(self) -> float:
        """Dwell at the start of a cut (s)."""
        return self.pierce

    @property
    def outputs(self) -> tuple[int, ...]:
        """The air assist."""
        return () if self.air < 0 else (self.air,)

    @property
    def footprint(self) -> Footprint:
        """The kerf, at any height of the focus."""
        return Footprint("disc", radius=self.radius, any_height=True)

    def clearance(self, usual: float) -> float:
        """Return the height of the focus, at which the tip stays between cuts."""
        del usual
        return self.focus

    def passes(self, through: float) -> F64:
        """Return the depth of the focus, in one pass."""
        del through
        return np.array([-self.focus])
