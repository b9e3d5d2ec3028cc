"""shapes: lines and arcs that a plotter draws.

All arcs are circular and at most half a turn long.
"""

from __future__ import annotations

import math
from typing import Final, TypeAlias

from knifetip.drawing_builder.shape_paths import Shape

Point: TypeAlias = tuple[float, float]

#: Flag of an arc with increasing angles.
_RISING: Final = 2.0
#: Fraction of half a turn by which an arc may be longer and is not divided.
_ROUNDING: Final = 1e-9
#: Relative area of a triangle below which its corners lie on a line.
_FLAT: Final = 1e-12


class PlottedShape(Shape):
    """Lines, arcs and curves that a plotter draws, in the units of its coordinates."""

    __slots__ = ()

    def add_line(self, start: Point, end: Point) -> None:
        """Add a line between two points."""
        self.polylines.append([*start, *end])

    def add_arc(self, centre: Point, start: Point, degrees: float) -> Point:
        """Add an arc about a centre, and return the end of the arc.

        Parameters
        ----------
        centre, start
            Centre and start of the arc.
        degrees
            Angle of the arc, positive for a counter-clockwise arc; more than a turn draws a circle.
        """
        x, y = centre
        first = math.atan2(start[1] - y, start[0] - x)
        radius = math.dist(start, centre)
        if radius == 0.0 or degrees == 0.0:
            self.add_line(start, start)
            return start
        drawn = max(-360.0, min(360.0, degrees))
        parts = max(1, math.ceil(abs(drawn) / 180.0 - _ROUNDING))
        begin = start
        for part in range(1, parts + 1):
            end = _on_circle(centre, radius, first + math.radians(drawn * part / parts))
            if part == parts and abs(drawn) == 360.0:
                end = start
            flags = _RISING if drawn > 0.0 else 0.0
            self.arcs.append((*begin, *end, radius, radius, 0.0, flags))
            begin = end
        if abs(degrees) > 360.0:
            return _on_circle(centre, radius, first + math.radians(degrees % 360.0))
        return begin

    def add_arc_through(self, start: Point, inner: Point, end: Point) -> None:
        """Add the arc from a start through a point to an end; a circle if start and end are equal.

        A line is added if the three points lie on a line.
        """
        if start == end:
            if inner != start:
                centre = (start[0] + inner[0]) / 2.0, (start[1] + inner[1]) / 2.0
                self.add_arc(centre, start, 360.0)
            return
        ax, ay = inner[0] - start[0], inner[1] - start[1]
        bx, by = end[0] - start[0], end[1] - start[1]
        area = ax * by - ay * bx
        a, b = ax * ax + ay * ay, bx * bx + by * by
        if abs(area) <= _FLAT * (a + b):
            self.polylines.append([*start, *inner, *end])
            return
        centre = (
            start[0] + (by * a - ay * b) / (2.0 * area),
            start[1] + (ax * b - bx * a) / (2.0 * area),
        )
        first, last = (
            math.atan2(point[1] - centre[1], point[0] - centre[0]) for point in (start, end)
        )
        turn = math.degrees(last - first) % 360.0
        self.add_arc(centre, start, turn if area > 0.0 else turn - 360.0)
        # The exact end, so that the next line begins where this arc ends.
        self.arcs[-1] = (*self.arcs[-1][:2], *end, *self.arcs[-1][4:])

    def add_rectangle(self, corner: Point, opposite: Point) -> None:
        """Add the outline of a rectangle with sides along the axes, given by opposite corners."""
        (x, y), (u, v) = corner, opposite
        self.polylines.append([x, y, u, y, u, v, x, v, x, y])

    def add_wedge(self, centre: Point, radius: float, first: float, degrees: float) -> None:
        """Add the outline of a sector of a circle.

        Parameters
        ----------
        centre, radius
            Centre and radius of the circle; a negative radius turns the sector by half a turn.
        first
            Angle of the first radius (degrees).
        degrees
            Angle of the sector; with a full turn or more, the outline is a circle.
        """
        x, y = centre
        angle = math.radians(first)
        start = x + radius * math.cos(angle), y + radius * math.sin(angle)
        if abs(degrees) >= 360.0:
            self.add_arc(centre, start, 360.0)
            return
        end = self.add_arc(centre, start, degrees)
        self.add_line(centre, start)
        self.add_line(end, centre)


def _on_circle(centre: Point, radius: float, angle: float) -> Point:
    """Return the point of a circle at an angle (radians)."""
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)
