"""run_out: length by which a track is extended until the whole width of its tool is off the board.

Source: "A new method of turning processing in multi axis linkage NC machining", section 1 (run-out
and back-up).
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.errors import CompensationError
from knifetip.geometry.azimuth import left_normal
from knifetip.geometry.columns import F64

#: Largest angle between a track and the normal of the edge (degrees); beyond it the tool does not
#: leave the board.
_MAX_ANGLE: Final = 89.0


def corner_run_outs(
    travel: F64, outward: F64, width: float | F64, distance: float | F64 = 0.0
) -> F64:
    """Return the length by which to extend a track until each corner of its tool is off the board.

    The two corners are the left and the right end of the tool's width.  With u the direction of
    travel, n its left normal, m the outward normal of the edge of the board, c the position of the
    tip and W the width of the tool, the corners are at c ± (W/2) n.  For a track that ends at the
    distance D before a straight edge of the board, measured along m, the lengths are::

        (D ∓ (W/2) (n · m)) / (u · m)

    Source: "A new method of turning processing in multi axis linkage NC machining", section 1.

    Parameters
    ----------
    travel, outward : (n, 2) unit vectors
        u and m of n ends of tracks; for the start of a track, give -u.
    width : (n,) mm
        W, the width of the tool across the travel.
    distance : (n,) mm
        D, the distance between the end of the track and the edge of the board.

    Returns
    -------
    (n, 2) mm
        Length for the left corner and for the right corner; negative for a corner that is past the
        edge already.

    Raises
    ------
    CompensationError
        A track that runs along the edge, or inwards, never leaves the board.
    """
    leaves = np.sum(travel * outward, axis=1)
    never = np.flatnonzero(~(leaves > math.cos(math.radians(_MAX_ANGLE))))
    if len(never):
        angle = math.degrees(math.acos(min(max(float(leaves[never[0]]), -1.0), 1.0)))
        raise CompensationError("track.too-flat", track=never[0], angle=angle, limit=_MAX_ANGLE)
    beside = width / 2.0 * np.sum(left_normal(travel) * outward, axis=1)
    further: F64 = np.column_stack([distance - beside, distance + beside]) / leaves[:, None]
    return further
