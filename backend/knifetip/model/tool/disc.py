"""disc: tools that remove a disc about their axis: routers and beams."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.tool.base import Footprint, TipCircle, Tool


class DiscTool(Tool):
    """A tool that removes a disc of radius r; its path is offset by r, on the waste side."""

    __slots__ = ()

    # Declared for the type checker only: a dataclass would take a property for a field's default.
    if TYPE_CHECKING:

        @property
        def radius(self) -> float:
            """r (mm)."""

        @property
        def lead(self) -> float:
            """Length of the straight lead-in (mm); 0 for 1.5 r."""

        @property
        def approach(self) -> float:
            """Angle of the lead-in to the contour (degrees): 0 in line, −90 round outside."""

        @property
        def dwell(self) -> float:
            """Longest contact with one corner before it burns (s); 0 for no limit."""

    @property
    def set_up(self) -> float:
        """Length of the straight lead-in on which the offset starts (mm), greater than r."""
        return self.lead or 1.5 * self.radius

    @property
    def fault(self) -> str:
        """A lead-in no longer than r has no room for the disc."""
        if 0.0 < self.lead <= self.radius:
            return f"has a lead of {self.lead}, which must be more than the radius, or 0"
        return ""

    def passes(self, through: float) -> F64:
        """Return the depth of each pass (mm); ``through`` is the depth of a through cut."""
        return np.array([through])

    def tip_circle(self, depth: float) -> TipCircle:
        """Return the disc."""
        del depth  # the same at any depth
        return TipCircle(self.radius, 0.0, 0.0)

    @property
    def diameter(self) -> float:
        """Of the disc (mm)."""
        return 2.0 * self.radius

    @property
    def footprint(self) -> Footprint:
        """The disc."""
        return Footprint("disc", radius=self.radius)
