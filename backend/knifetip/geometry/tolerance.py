"""tolerance: named constants for all geometric tolerances."""

from __future__ import annotations

from typing import Final

#: Points nearer than this are equal (mm); far below the precision of any machine.
POINT: Final = 1e-6
#: Directions nearer than this are equal (degrees), as at a smooth joint or a continued crease.
ANGLE: Final = 1.0
#: Ends of edges nearer than this are connected into one path unchanged (mm); well below the
#: tolerance of a program.
JOIN: Final = 0.002
#: Cleaning moves ends that are farther apart than this, and within ``GAP``, to one point (mm).  So
#: no distance between cleaned ends is near ``JOIN``, where rounding would decide whether they
#: connect.
MEET: Final = 0.0019
#: Ends of edges nearer than this are taken as meant to touch (mm).
GAP: Final = 0.05
#: A cut that ends nearer than this to another one is extended to it when contours are searched
#: (mm): a drawing error or a nick, too narrow to hold a part in place.  Two edges that each stop
#: 1.5 mm before a right-angled corner are 2.1 mm apart.  Only the order of work depends on it, so
#: it may be generous.
CONTOUR_GAP: Final = 2.2
#: Edges nearer than this over their whole length are duplicates (mm); equal to the tolerance of
#: the tip.
SAME: Final = 0.01
#: Lines nearer in direction than this are one line for a leaning blade (degrees): its tip moves by
#: less than 0.001 mm.
COLLINEAR: Final = 0.005
#: Largest distance of a fitted curve from the exact one (mm).
CURVE: Final = 0.0035
#: Largest distance of a curve from chords with rounded vertices (mm): vertices that are rounded to
#: 0.01 mm lie up to 0.0071 mm beside their curve.  A program may deviate from the drawing by
#: 0.01 mm, of which the controller's rounding of corners uses up to 0.0005 mm, and the chords, fits
#: and digits of the program up to 0.0015 mm.
FIT: Final = 0.008
#: A smaller bulge is a line; over a metre such an arc deviates from its chord by less than POINT.
BULGE: Final = 1e-9
