"""polygon: the polygon of HP-GL/2, which is collected between the instructions PM0 and PM2.

Source: PCL 5 Printer Language Technical Reference Manual (HP 5961-0509), chapter 21, PM.
"""

from __future__ import annotations

from knifetip.hpgl.shapes import PlottedShape, Point


class Polygon:
    """Edges of a polygon, which consists of one or more closed parts."""

    def __init__(self) -> None:
        self.shape = PlottedShape()
        self.is_open = False  #: whether the plotter is in polygon mode
        self.is_lost = False  #: whether its position depends on the plotter
        self.starts = False  #: whether the next point begins a part
        self._first: Point = (0.0, 0.0)

    def open_at(self, point: Point, *, is_lost: bool) -> None:
        """Begin polygon mode.

        Parameters
        ----------
        point
            First point of the first part.
        is_lost
            Whether this point depends on the plotter.
        """
        self.is_open = True
        self.is_lost = is_lost
        self.begin(point)

    def begin(self, point: Point) -> None:
        """Begin a part of the polygon at a point."""
        self.starts = False
        self._first = point

    def close_part(self, last: Point) -> Point:
        """Close the open part, whose last point is ``last``, and return its first point."""
        if self.starts:
            return last
        if last != self._first:
            self.shape.add_line(last, self._first)
        return self._first
