"""Leaving: how far a tool must go on until its whole width is past an edge of the board.

    directions, outward normals, widths -> how much further

Source: the turning paper, section 1 (run-out and back-up).
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.errors import CompensationError
from knifetip.geometry.azimuth import left
from knifetip.geometry.columns import F64

#: A track that meets the edge more nearly along it never leaves (degrees from square).
_FLATTEST: Final = 89.0


def run_out(travel: F64, outward: F64, width: float | F64, short: float | F64 = 0.0) -> F64:
    """Return how much further a track goes until either corner of its tool is off the board.

    With u the direction of travel, n its left normal and m the outward normal of the edge, the
    corners P1, P2 stand at c ± (W/2) n, and are past a straight edge after::

        ∓ (W/2) (n · m) / (u · m)                                 section 1

    so that the later of them leaves after (W/2) |n · m| / (u · m).

    Parameters
    ----------
    travel, outward : (n, 2) unit vectors
        u and m; for a start, give -u.
    width : (n,) mm
        W, across the travel.
    short : (n,) mm
        How far the track ends before the edge, square to it.

    Returns
    -------
    (n, 2) mm
        Of the left corner and of the right one; negative for one that is past the edge already.

    Raises
    ------
    CompensationError
        A track that runs along the edge, or inwards, never leaves the board.
    """
    leaves = np.sum(travel * outward, axis=1)
    never = np.flatnonzero(~(leaves > math.cos(math.radians(_FLATTEST))))
    if len(never):
        angle = math.degrees(math.acos(min(max(float(leaves[never[0]]), -1.0), 1.0)))
        raise CompensationError("track.too-flat", track=never[0], angle=angle, limit=_FLATTEST)
    beside = width / 2.0 * np.sum(left(travel) * outward, axis=1)
    further: F64 = np.column_stack([short - beside, short + beside]) / leaves[:, None]
    return further
