"""Outer: which cut edges bound a blank or a part inside a hole, and which bound a hole.

A contour in no other is a blank's, one inside it bounds a hole, and one inside the hole another
part: what lies in an even number of contours is a part's outline.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.geometry.columns import F64, I8, I64, Bool
from knifetip.topology.subdivision import subdivide


def outer(ends: F64, bulge: F64) -> Bool:
    """Return which edges bound a part from outside, (n,).

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Cut edges of any order and direction.
    """
    bounding: Bool = outside(ends, bulge) != 0
    return bounding


def outside(ends: F64, bulge: F64) -> I8:
    """Return on which side of each edge the waste round a part lies, (n,).

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Cut edges of any order and direction.

    Returns
    -------
    (n,) +1 left of the way from start to end, -1 right, 0 where the edge bounds no part
    """
    return faces(ends, bulge).side


@dataclass(frozen=True, eq=False, slots=True)
class Faces:
    """What lies on the two sides of n cuts."""

    side: I8  #: (n,) of the waste round a part: +1 left, -1 right, 0 where it bounds none
    face: I64  #: (n,) the part or the hole that the cut goes round, -1 for what closes nothing
    shared: Bool  #: (n,) a part lies on either side, and not the same


def faces(ends: F64, bulge: F64) -> Faces:
    """Return what lies on the two sides of each cut.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Cut edges of any order and direction.
    """
    found = subdivide(ends, bulge)
    face = found.face
    # A tree of slits encloses nothing: on both its sides is what lies round it.
    empty = found.outer[face]
    closing: Bool = empty[:, 0] != empty[:, 1]
    part = found.depth[found.component] % 2 == 0
    return Faces(
        # The walk round a part from outside has the waste on its left.
        np.where(closing & part, np.where(empty[:, 0], 1, -1), 0).astype(np.int8),
        np.where(closing, np.where(empty[:, 0], face[:, 1], face[:, 0]), -1),
        ~empty.any(axis=1) & (face[:, 0] != face[:, 1]) & part,
    )
