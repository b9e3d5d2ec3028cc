"""cut_sides: find the side of each cut on which the waste lies, and the face that each cut bounds.

A contour that lies inside an even number of other contours (0, 2, …) is the outline of a part.  A
contour that lies inside an odd number is a hole.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.geometry.columns import F64, I8, I64, Bool
from knifetip.topology.subdivision import Subdivision, subdivide


@dataclass(frozen=True, eq=False, slots=True)
class CutSides:
    """The side of the waste of each of n cuts, and the part or hole that each cut bounds."""

    waste: I8  #: (n,) side of the waste around a part: +1 left, -1 right, 0 if it bounds no part
    removed: I8  #: (n,) side without board, around a part or in a hole: +1 left, -1 right, 0 none
    face: I64  #: (n,) part or hole that the cut bounds, -1 for none
    shared: Bool  #: (n,) two different parts lie on the two sides
    subdivision: Subdivision  #: the faces into which the cuts divide the plane


def cut_sides(ends: F64, bulge: F64) -> CutSides:
    """Return the side of each cut on which the waste lies, the part or hole that the cut bounds,
    and whether the cut lies between two parts.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the cuts, in any order and direction.
    """
    subdivision = subdivide(ends, bulge)
    face = subdivision.face
    # A tree of slits encloses nothing: the outer face lies on both its sides.
    outer = subdivision.outer[face]
    closing = subdivision.closing
    part = subdivision.depth[subdivision.component] % 2 == 0
    return CutSides(
        np.where(closing & part, np.where(outer[:, 0], 1, -1), 0).astype(np.int8),
        np.where(closing, np.where(outer[:, 0] == part, 1, -1), 0).astype(np.int8),
        np.where(closing, np.where(outer[:, 0], face[:, 1], face[:, 0]), -1),
        ~outer.any(axis=1) & (face[:, 0] != face[:, 1]) & part,
        subdivision,
    )
