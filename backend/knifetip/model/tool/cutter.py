"""The rotating cutter of a router."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from knifetip.geometry.columns import F64
from knifetip.messages import Message
from knifetip.model.tool.base import NotNegative, Positive, pass_depths
from knifetip.model.tool.disc import DiscTool


@dataclass(frozen=True, slots=True)
class Cutter(DiscTool):
    """A rotating cutter, as used in routers."""

    yields: ClassVar[bool] = True

    radius: Positive  #: r, radius of the cutter (mm)
    feed: Positive
    plunge: Positive
    speed: NotNegative = 0.0  #: speed of the spindle (rpm)
    spin_up: NotNegative = 0.0  #: time until the spindle has its full speed (s)
    lead: NotNegative = 0.0  #: length of the straight lead-in (mm); 0: 1.5 r
    approach: float = 90.0  #: angle of the lead-in to the contour (degrees); 0: in line
    step: NotNegative = 0.0  #: maximum depth of one pass (mm); 0: one pass
    dwell: NotNegative = 0.0  #: maximum time at a corner before the board burns (s); 0: no limit

    @property
    def spindle(self) -> int:
        """S word of the program while the spindle is on: the speed of the spindle (rpm)."""
        return round(self.speed)

    @property
    def spindle_missing(self) -> Message | None:
        """Error message if the speed of the spindle is 0, otherwise None."""
        return None if self.spindle >= 1 else Message("tool.without-speed")

    def settle(self, machine_dwell: float) -> float:
        """Return the dwell after the spindle is switched on (s).

        It is the longer of ``machine_dwell``, the dwell in the file of the machine (s), and the
        time until the spindle has its full speed.
        """
        return max(machine_dwell, self.spin_up)

    def passes(self, cut_depth: float) -> F64:
        """Return the depths of the k passes of a cut that is ``cut_depth`` mm deep, (k,) (mm).

        See ``pass_depths``; the maximum depth of a pass is ``step``, a field of the cutter.
        """
        return pass_depths(cut_depth, self.step)
