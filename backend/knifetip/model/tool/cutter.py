"""cutter: a rotating cutter, as a router holds it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Final

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.messages import Message
from knifetip.model.tool.base import NotNegative, Positive
from knifetip.model.tool.disc import DiscTool

#: Greatest number of passes; more are an error in the tool's ``step``.
_MOST: Final = 200


@dataclass(frozen=True, slots=True)
class Cutter(DiscTool):
    """A rotating cutter (router)."""

    yields: ClassVar[bool] = True

    radius: Positive  #: r (mm)
    feed: Positive
    plunge: Positive
    speed: NotNegative = 0.0  #: of the spindle (rpm)
    spin_up: NotNegative = 0.0  #: seconds from the spindle's start to its full speed
    lead: NotNegative = 0.0  #: straight way on which the offset is set up (mm); 0 for 1.5 r
    approach: float = 90.0  #: of that way to the contour (degrees): 0 in line, −90 round outside
    step: NotNegative = 0.0  #: deepest cut in one pass (mm); 0 for all at once
    dwell: NotNegative = 0.0  #: longest touch of one corner before it burns (s); 0 for no limit

    @property
    def spindle(self) -> int:
        """Speed of the spindle (rpm)."""
        return round(self.speed)

    @property
    def spindle_missing(self) -> Message | None:
        """Why it cannot cut: its speed is 0."""
        return None if self.spindle >= 1 else Message("tool.without-speed")

    def settle(self, usual: float) -> float:
        """Return the time until the spindle has its full speed, if that is longer."""
        return max(usual, self.spin_up)

    def passes(self, through: float) -> F64:
        """Return the depths of equal passes (mm), each at most ``step`` deeper than the last."""
        count = 1 if self.step == 0.0 else min(_MOST, int(np.ceil(through / self.step - 1e-9)))
        depths: F64 = through * np.arange(1, count + 1) / count
        return depths
