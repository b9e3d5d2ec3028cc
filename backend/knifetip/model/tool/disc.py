"""The base class of tools that remove a disc about their axis: cutters and lasers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.messages import Message
from knifetip.model.tool.base import Footprint, TipCircle, Tool
from knifetip.model.tool.cross_section import CrossSection


class DiscTool(Tool):
    """Base class of tools that remove a disc of board about their axis, with radius r.

    The path of the tool is offset from the edge by r.
    """

    __slots__ = ()

    # Declared for the type checker only: a dataclass would take a property for a field's default.
    if TYPE_CHECKING:

        @property
        def radius(self) -> float:
            """Radius r of the disc (mm)."""

        @property
        def lead(self) -> float:
            """Length of the straight lead-in in the machine file (mm); 0 for the default length.

            The property ``lead_in`` replaces 0 by the default length, 1.5 times ``radius``.
            """

        @property
        def approach(self) -> float:
            """Angle between lead-in and contour (degrees).

            At 0 the lead-in is in line with the contour.  At 90 the lead-in is perpendicular to the
            contour and comes from the side on which the tool travels; at −90 it is perpendicular
            and comes from the opposite side, round a corner of the contour.
            """

        @property
        def dwell(self) -> float:
            """Longest time for which the tool may stay at one corner before the board burns (s).

            0 means that there is no limit.
            """

    @property
    def lead_in(self) -> float:
        """Length of the straight lead-in (mm): ``lead``, or 1.5 ``radius`` if ``lead`` is 0."""
        return self.lead or 1.5 * self.radius

    @property
    def needs_heading(self) -> bool:
        """Whether an axis of the machine must turn the tool."""
        return False

    @property
    def fault(self) -> Message | None:
        """Error message if the lead-in is too short or too shallow for the disc, else None.

        A lead-in from the tool's side, whose angle is positive or 0, must begin farther from the
        contour than the radius; else the disc would enter the board beside the contour's start.
        """
        if 0.0 < self.lead <= self.radius:
            return Message("tool.short-lead", lead=self.lead, radius=self.radius)
        away = self.lead_in * math.sin(math.radians(self.approach))
        if self.approach >= 0.0 and away < self.radius:
            return Message(
                "tool.shallow-lead",
                lead=self.lead_in,
                angle=self.approach,
                radius=self.radius,
                least=math.degrees(math.asin(self.radius / self.lead_in)),
            )
        return None

    def passes(self, cut_depth: float) -> F64:
        """Return the depths of the k passes of a cut that is ``cut_depth`` mm deep, (k,) (mm).

        In the base class k is 1: the tool cuts in one pass.
        """
        return np.array([cut_depth])

    def tip_circle(self, depth: float) -> TipCircle:
        """Return the circle of the disc, which does not depend on ``depth``."""
        del depth  # the same at any depth
        return TipCircle(self.radius, 0.0, 0.0)

    def cross_section(self, depth: float) -> CrossSection:
        """Return the slot that the disc removes, which is as wide at every depth."""
        del depth
        return CrossSection(top_width=self.diameter)

    @property
    def diameter(self) -> float:
        """Diameter of the disc (mm)."""
        return 2.0 * self.radius

    @property
    def footprint(self) -> Footprint:
        """The mark that the tool leaves on the board: a disc."""
        return Footprint("disc", radius=self.radius)
