"""The laser, which cuts without contact."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.messages import Message
from knifetip.model.tool.base import Footprint, NotNegative, Positive
from knifetip.model.tool.disc import DiscTool


@dataclass(frozen=True, slots=True)
class Laser(DiscTool):
    """A laser that cuts through the board in one pass with its focus at one height."""

    kerf: Positive  #: width of the cut (mm); half of it is the radius r
    feed: Positive
    power: Positive  #: S word of full power, in units of the controller ($30)
    pierce: NotNegative  #: dwell at the start of a cut until the board is pierced (s)
    focus: float = 0.0  #: height of the focus above the board's top face (mm)
    lead: NotNegative = 0.0  #: length of the lead-in from the pierced hole (mm); 0: 1.5 r
    approach: float = 90.0  #: angle of the lead-in to the contour (degrees); 0: in line
    dwell: NotNegative = 0.0  #: maximum time at a corner before the board burns (s); 0: no limit
    air: int = -1  #: digital output of the air assist; -1 for none

    @property
    def radius(self) -> float:
        """Radius of the disc of board that the laser removes (mm): half the kerf."""
        return self.kerf / 2.0

    @property
    def plunge(self) -> float:
        """Feed of the laser while its height changes (mm/min); it equals the feed in cuts."""
        return self.feed

    @property
    def spindle(self) -> int:
        """S word of the program while the laser is on: the power of the laser."""
        return round(self.power)

    @property
    def spindle_missing(self) -> Message | None:
        """Error message if the power is 0, which controllers treat as off, otherwise None."""
        return None if self.spindle >= 1 else Message("tool.without-power")

    @property
    def pierce_time(self) -> float:
        """Dwell of the laser at the start of a cut (s)."""
        return self.pierce

    @property
    def outputs(self) -> tuple[int, ...]:
        """Number of the digital output of the air assist; empty without air assist."""
        return () if self.air < 0 else (self.air,)

    @property
    def footprint(self) -> Footprint:
        """The mark that the laser leaves on the board: a disc as wide as the kerf."""
        return Footprint("disc", radius=self.radius, any_height=True)

    def clearance(self, machine_height: float) -> float:
        """Return the height of the focus above the board between cuts (mm).

        It is the same as in cuts; ``machine_height``, the height in the file of the machine, is not
        used.
        """
        del machine_height
        return self.focus

    def passes(self, cut_depth: float) -> F64:
        """Return the depth of the focus in the one pass of a cut, as an array of shape (1,) (mm).

        The depth is negative if the focus is above the board; ``cut_depth`` is not used.
        """
        del cut_depth
        return np.array([-self.focus])
