"""Every epsilon has its name here."""

from __future__ import annotations

from typing import Final

#: Two points nearer than this are one point (mm).  Far below what any machine can place.
POINT: Final = 1e-6
#: Two directions nearer than this are one direction (degrees): a smooth joint, a continued crease.
ANGLE: Final = 1.0
#: Ends of edges nearer than this are joined into one path as they stand (mm): well below what a
#: program may deviate.
JOIN: Final = 0.002
#: Ends of edges nearer than this were meant to touch (mm).
GAP: Final = 0.05
#: A cut that ends so near to another one goes on to it when contours are looked for (mm): a gap
#: left in drawing or a nick, too narrow to hold a part in place.  Two edges that each stop 1.5 mm
#: short of their square corner are 2.1 mm apart.  Only the order of work depends on this, never
#: what is cut, so it may be generous.
CONTOUR_GAP: Final = 2.2
#: Edges nearer than this to each other all along are one edge drawn twice (mm): no farther than
#: the tip may be from its line.
SAME: Final = 0.01
#: Lines nearer in direction than this are one line to a leaning blade (degrees): its tip moves by
#: less than a thousandth of a millimetre.
COLLINEAR: Final = 0.005
#: A fitted curve stays within this of the true one (mm).
CURVE: Final = 0.01
#: A bulge below this is a straight line: its arc stands off less than POINT on a metre.
BULGE: Final = 1e-9
