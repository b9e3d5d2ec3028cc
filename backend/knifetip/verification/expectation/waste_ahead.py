"""Find the ends of cuts ahead of which waste lies, so that a blade may run past them."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.verification.columns import F64, I32, Bool
from knifetip.verification.curves.curve import azimuth_at
from knifetip.verification.curves.group_order import order_in_groups
from knifetip.verification.expectation.edges import TOUCH_DISTANCE, Edges, angle_between
from knifetip.verification.expectation.outline import find_outlines

#: A cut that makes a smaller angle with an outline runs along it (degrees).
_ALONG_OUTLINE: Final = 5.0


def waste_ahead(ahead: F64, end: I32, cut: I32, place: F64, cuts: Edges) -> Bool:
    """Return the mask of the ends of lines ahead of which waste lies, (e,).

    At an end on an outline, the outline's curves leave the end in two or more directions.  Between
    neighbouring directions lies either board or waste; the side of the direction that is next
    clockwise decides.  Waste is the surroundings of the parts and the inside of holes.  No waste
    lies ahead of an end that touches no outline, or of a line that runs along one.

    Parameters
    ----------
    ahead : (e,) degrees
        Direction out of the line at each end.
    end, cut, place : (k,), (k,) and (k,) mm
        The k pairs of an end and a cut that touches it: the indices of both, and the position along
        the cut at which they touch.
    cuts
        All cuts.
    """
    outlined = find_outlines(cuts)
    keep = np.flatnonzero(outlined.closing[cut])
    end, cut, place = end[keep], cut[keep], place[keep]
    forward = azimuth_at(cuts.curve[cut], place)
    onward = cuts.curve[cut, 5] - place > TOUCH_DISTANCE
    back = place > TOUCH_DISTANCE
    left = outlined.board_left[cut]
    at = np.concatenate([end[onward], end[back]])
    direction = np.concatenate([forward[onward], forward[back] + 180.0])
    board_left = np.concatenate([left[onward], ~left[back]])
    turn = (ahead[at] - direction) % 360.0
    # The last row of each end is the direction that is next clockwise.
    order = order_in_groups(at, -turn, turn)
    result = np.zeros(len(ahead), np.bool_)
    result[at[order]] = ~board_left[order]
    along = angle_between(ahead[at], direction) <= _ALONG_OUTLINE
    result[at[along]] = False
    return result
